"""What is tried against each check, and what is said where data are missing."""

from __future__ import annotations

from wraparc.actions.texts import Phrase
from wraparc.actions.variant import (
    DIAMETER,
    LAGGING,
    LOWER,
    RAISE,
    RATING,
    SPACING,
    STRENGTH,
    WRAP,
)
from wraparc.checks.check import Check
from wraparc.drive import Belt
from wraparc.units import Cell

GRIP = (RAISE, WRAP, LAGGING)
#: Digits of what is to be tested: fewer than the missed value beside it has.
_TEST_DIGITS = 2
#: Changes by name of the check, in the order in which they are tried.
KINDS: dict[str, tuple[str, ...]] = {
    "gross_slip": GRIP, "operating_point": (RAISE,), "design_standard": (RAISE,),
    "creep": GRIP, "wet_creep": GRIP, "cover_creep": (RAISE,), "creep_interval": (RAISE,),
    "uneven_creep": GRIP, "tested_slip": (RAISE,), "tested_pressure_min": (RAISE,),
    "tested_pressure_max": (LOWER, DIAMETER), "face_pressure": (LOWER, DIAMETER),
    "uneven_pressure": (LOWER, DIAMETER), "uneven_face_pressure": (LOWER, DIAMETER),
    "belt_tension": (LOWER, RATING), "momentary_tension": (LOWER, RATING),
    "belt_safety": (LOWER, STRENGTH), "edge_tension": (LOWER,), "static_edge_tension": (LOWER,),
    "pulley_diameter": (DIAMETER,), "sag": (RAISE, SPACING),
}  # fmt: skip


def kinds_of(check: Check) -> tuple[str, ...]:
    """Return what is tried against a missed check, the first first."""
    if check.name == "design_standard" and check.value != check.value:
        return ()  # it cannot be applied
    return KINDS.get(check.name, ())


def first_phrase(check: Check) -> Phrase | None:
    """Return what is to be given before anything is changed: what is missing decides a check."""
    if check.name == "cover_creep":
        return Phrase("state", "the cover of the tested belt ([test_belt])")
    return None


def last_phrase(check: Check, lagging: str, belt: Belt) -> Phrase | None:
    """Return what is to be tested or given where changes are not enough; None where nothing is."""
    value = Cell(check.value, check.dimension, _TEST_DIGITS, "up")
    least = Cell(check.value, check.dimension, _TEST_DIGITS, "down")
    if check.name == "momentary_tension" and belt.momentary_factor is None:
        factor = Cell(check.value / check.limit, "number", form="up")
        return Phrase("give", f"momentary_factor {factor} if its maker allows it")
    if check.name == "creep_interval":
        return Phrase("try", "testing more samples")
    rests = {
        "tested_slip": f"the lagging to {value} slip",
        "tested_pressure_max": f"the lagging at {value}",
        "uneven_pressure": f"the lagging at {value}",
        "tested_pressure_min": f"the lagging at {least}",
        "wet_creep": f"{lagging} wet",
    }
    rest = rests.get(check.name)
    return None if rest is None else Phrase("test", rest)
