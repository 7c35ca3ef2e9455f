"""What is tried against each check, and what is said where data are missing."""

from __future__ import annotations

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
from wraparc.units import Cell

GRIP = (RAISE, WRAP, LAGGING)
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


def test_phrase(check: Check, lagging: str) -> tuple[str, str] | None:
    """Return verb and rest of what is to be tested; None where tests do not answer a check."""
    value = Cell(check.value, check.dimension, form="up")
    least = Cell(check.value, check.dimension, form="down")
    rests = {
        "tested_slip": f"the lagging to {value} slip",
        "tested_slip_speed": f"the lagging at {value}",
        "tested_pressure_max": f"the lagging at {value}",
        "uneven_pressure": f"the lagging at {value}",
        "tested_pressure_min": f"the lagging at {least}",
        "wet_creep": f"{lagging} wet",
    }
    rest = rests.get(check.name)
    return None if rest is None else ("test", rest)
