"""How little of an input changes the verdict: a line, a table and plain data."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import ceil, copysign, floor, log10
from typing import Any

from wraparc.answer.sheet import Row, Table, Verdict
from wraparc.arc import DriveResult
from wraparc.checks import Level
from wraparc.drive import Drive
from wraparc.reserve import (
    Flip,
    Input,
    Reserve,
    Uncertainty,
    find_reserve,
    nearest_flips,
    stated_count,
)
from wraparc.reserve.levels import FACTORS
from wraparc.train import TrainResult
from wraparc.train.whole import by_pulley
from wraparc.units import fixed, percent

#: What inputs are called.
NAMES = {
    "friction": "friction", "slip": "slip scale", "belt_modulus": "belt modulus",
    "shear_modulus": "G", "compression_modulus": "E_c", "lagging_thickness": "lagging thickness",
    "diameter": "diameter", "wrap_angle": "wrap", "effective_tension": "Te",
    "slack_tension": "T2", "carcass": "carcass thickness", "take_up_distance": "take-up place",
    "start_factor": "start factor",
}  # fmt: skip
_LEAST_PERCENT = 0.1


def with_reserve(own: Verdict, result: DriveResult | TrainResult, *, every: bool) -> Verdict:
    """Return the verdict on a drive with what little change of an input changes it.

    `every` is whether the data have the change of every input, and not of the nearest alone.
    """
    reserve = find_reserve(result, every=every)
    text = nearest_text(reserve, by_pulley(result).drive)
    return replace(own, reserve=(text,), flips=reserve.flips)


def nearest_text(reserve: Reserve, drive: Drive) -> str:
    """Return one sentence on those changes that are nearest."""
    flips = nearest_flips(reserve.flips, reserve.level, stated_count(reserve.level))
    return reserve_text(replace(reserve, flips=flips), drive)


def reserve_text(reserve: Reserve, drive: Drive) -> str:
    """Return one sentence on the nearest changes, those of a level together."""
    low, high = (round(100.0 * (factor - 1.0)) for factor in FACTORS)
    if reserve.reason:
        return f"Not calculated: {reserve.reason}."
    if not reserve.flips:
        count = len(reserve.inputs)
        return f"None of {count} inputs changes the verdict within {low} to +{high} %."
    by_level: dict[Level, list[Flip]] = {}
    for flip in reserve.flips:
        by_level.setdefault(flip.level, []).append(flip)
    texts = (f"{level} at {_flips_text(some, drive)}" for level, some in by_level.items())
    return f"{'; '.join(texts)}."


def _flips_text(flips: Sequence[Flip], drive: Drive) -> str:
    """Return changes to one level, those within the uncertainty of their input first."""
    within = [change_text(flip, drive) for flip in flips if flip.is_within]
    others = [change_text(flip, drive) for flip in flips if not flip.is_within]
    if len(within) > 1 and not others:
        return f"{_listed(within)}, within their uncertainties"
    if within:
        which = "its uncertainty" if len(within) == 1 else "their uncertainties"
        within[-1] += f" (within {which})"
    return _listed([*within, *others])


def change_text(flip: Flip, drive: Drive) -> str:
    """Return what is changed, and by how much."""
    return f"{input_name(flip.input, drive)} {percent_text(flip.change)}"


def input_name(of: Input, drive: Drive) -> str:
    """Return what an input is called, with its pulley or lagging where it is not of all."""
    name = NAMES[of.name]
    if of.name == "slack_tension":
        case = drive.load_case()
        at = case.tensions[drive.pulleys[0].name], case.tensions[drive.pulleys[-1].name]
        name = "slack-side tension" if at[0].entry < at[1].exit else name
        name = "take-up tension" if drive.take_up_place else name
    if of.name == "carcass" and drive.belt.kind == "steel cord":
        name = "cord diameter"
    return f"{name} of {of.label}" if of.label else name


def percent_text(change: float) -> str:
    """Return the cell of a change as it is rounded by `rounded_change`."""
    digits = 1 if _percent_step(change) < 1.0 else 0
    return fixed(rounded_change(change), digits, "percent signed")


def rounded_change(change: float) -> float:
    """Return a change in two digits, away from none: there the level has changed [-]."""
    step = _percent_step(change)
    return copysign(ceil(100.0 * abs(change) / step - 1e-9) * step / 100.0, change)


def _percent_step(change: float) -> float:
    return max(10.0 ** (floor(log10(100.0 * abs(change))) - 1), _LEAST_PERCENT)


def _listed(texts: Sequence[str]) -> str:
    *first, last = texts
    return f"{', '.join(first)} or {last}" if first else last


def reserve_table(result: DriveResult | TrainResult) -> Table:
    """Return the smallest change of every input that changes the verdict, the nearest first."""
    reserve, drive = find_reserve(result), by_pulley(result).drive
    rows = [
        Row(
            input_name(flip.input, drive),
            (
                percent_text(flip.change),
                str(flip.level),
                flip.load_case if flip.level.rank > Level.OK.rank else "",
                percent(flip.uncertainty.towards(flip.change), 2),
            ),
            note=source_text(flip.uncertainty),
        )
        for flip in reserve.flips
    ]
    note = "One input changed alone; the nearest in units of its uncertainty first."
    note += " Load shares are fixed." if reserve.fixed else ""
    if not rows:
        rows, note = [Row("none", ("", "", "", ""))], reserve_text(reserve, drive)
    heads = ("change", "verdict", "load case", "uncertainty")
    return Table("Reserve of the verdict", tuple(rows), heads, note, "reserve")


def flips_by_input(result: DriveResult | TrainResult) -> dict[str, tuple[Flip, ...]]:
    """Return the changes of every input to either side by its name, the nearest first."""
    drive, found = by_pulley(result).drive, dict[str, tuple[Flip, ...]]()
    for flip in find_reserve(result).flips:
        name = input_name(flip.input, drive)
        found[name] = (*found.get(name, ()), flip)
    return found


def source_text(of: Uncertainty) -> str:
    """Return of which kind an uncertainty is, and where it is from."""
    return ": ".join(part for part in (of.kind, of.source) if part)


def flip_data(flip: Flip) -> dict[str, Any]:
    """Return a change as plain data."""
    alone = flip.input.label and len(flip.input.pulleys) == 1
    return {
        "input": flip.input.name,
        "pulley": flip.input.pulleys[0] if alone else None,
        "lagging": flip.input.label if flip.input.label and not alone else None,
        "load_case": flip.load_case if flip.level.rank > Level.OK.rank else None,
        "change": flip.change,
        "level": flip.level.value,
        "uncertainty": flip.uncertainty.towards(flip.change),
        "uncertainty_kind": flip.uncertainty.kind,
        "source": flip.uncertainty.source or None,
    }
