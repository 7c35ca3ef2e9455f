"""The conditions that a drive was solved in, dry and wet for example, side by side."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from wraparc.answer.least_tension import at_least, least_name
from wraparc.answer.sheet import NONE, Row, Table, named
from wraparc.arc import DriveResult
from wraparc.checks import Check, Level, Verdict, judge
from wraparc.checks.least_tension import least_of
from wraparc.units import distinct, in_units

if TYPE_CHECKING:
    from wraparc.train.whole import Whole

_NOTE = "Each check at its governing place in that condition."


def by_condition(result: DriveResult) -> dict[str, DriveResult]:
    """Return a solved drive condition by condition; load cases that name none are left out."""
    found = {}
    for condition in result.drive.conditions:
        cases = tuple(c for c in result.drive.load_cases if c.condition == condition)
        names = {case.name for case in cases}
        arcs = tuple(arc for arc in result if arc.arc.load_case in names)
        found[condition] = DriveResult(replace(result.drive, load_cases=cases), arcs)
    return found


def _judged(part: DriveResult, whole: Whole) -> Verdict:
    """Return what is judged of a whole drive in the load cases of one condition."""
    cases = {"", *(case.name for case in part.drive.load_cases)}
    return Verdict(tuple(c for c in judge(whole).checks if c.place.load_case in cases))


def conditions_table(result: DriveResult, whole: Whole) -> Table:
    """Return verdict, checks and least slack-side tension with one column for each condition.

    `whole` is what the pulleys are of, a drive or a train: it is judged.
    """
    parts = by_condition(result)
    judged = {name: _judged(part, whole) for name, part in parts.items()}
    names: dict[str, None] = {}
    for verdict in judged.values():
        names |= dict.fromkeys(c.name for c in verdict.listed if _told(c))
    words = tuple(verdict.label for verdict in judged.values())
    rows = [Row("Verdict", words, name="verdict")]
    rows += [_row(name, tuple(judged.values())) for name in names]
    rows.append(
        Row(
            "Equivalent friction at the creep limit",
            tuple(map(_friction, parts.values())),
            name="equivalent_friction",
        )
    )
    rows.append(
        Row(
            f"Minimum {least_name(result)}",
            tuple(_least(p, result) for p in parts.values()),
            name="minimum_tension",
        )
    )
    return Table("Conditions side by side", tuple(rows), tuple(parts), _NOTE, "conditions")


def conditions_data(result: DriveResult, whole: Whole) -> list[dict[str, Any]]:
    """Return the verdict and the least slack-side tension of each condition as plain data [SI]."""
    told = []
    for name, part in by_condition(result).items():
        verdict, least = _judged(part, whole), least_of(part, result.drive)
        told.append(
            {
                "condition": name,
                "level": verdict.level.value,
                "label": verdict.label,
                "text": in_units(verdict.text),
                "load_cases": [case.name for case in part.drive.load_cases],
                "checks": {c.name: c.value for c in verdict.listed if _told(c)},
                "least_tension": None if least is None else least.tension,
            }
        )
    return told


def _told(check: Check) -> bool:
    """Whether a check is one that may differ with the condition."""
    return check.level is not Level.NOT_CHECKED and check.name not in _SAME


#: Checks that no condition changes.
_SAME = (
    "data", "belt_mass", "sense", "usual_sizes", "balance", "condition", "fit", "belt_tension",
    "momentary_tension", "belt_safety", "face_pressure", "pulley_diameter", "sag",
    "tested_pressure_max", "tested_pressure_min", "train_balance", "case_kind",
)  # fmt: skip


def _row(name: str, verdicts: tuple[Verdict, ...]) -> Row:
    found = [next((c for c in v.listed if c.name == name), None) for v in verdicts]
    there = [check for check in found if check is not None]
    texts = tuple(NONE if check is None else _text(check) for check in found)
    limits = distinct(c.bound() for c in there)
    worst = max((c.level for c in there), key=lambda level: level.rank)
    note = limits[0] if len(limits) == 1 else ""
    return Row(there[0].title, texts, note=note, name=name, level=worst)


def _text(check: Check) -> str:
    value = check.texts()[0] or NONE
    limit = "" if not check.missed else f" ({check.level})"
    return f"{value}{limit}"


def _friction(result: DriveResult) -> str:
    """Return the least constant friction that stands for an arc at its creep limit."""
    found = [a.capacities.equivalent_friction for a in result]
    known = [friction for friction in found if not math.isnan(friction)]
    return named("equivalent_friction", min(known)) if known else NONE


def _least(part: DriveResult, result: DriveResult) -> str:
    found = least_of(part, result.drive)
    if found is None:
        return NONE
    return "none" if math.isinf(found.tension) else at_least(found.tension)
