"""Doors of columns: rows of one table that has them all, and a study of one row."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import tomli_w

from doors.record import Case, Record
from wraparc.arc import WrapArc
from wraparc.arrays import Array
from wraparc.batch import Setting, solve_batch
from wraparc.checks import Verdict, judge
from wraparc.checks.of_rows import LEVELS, NAMES
from wraparc.study.file import load_study
from wraparc.train import TrainResult

#: Relative accuracy of precise rows: two solutions, each to 1e-6 of its creep.
OF_ROWS = 1e-5
#: What an arc calls the columns of a table.
COLUMNS = {
    "entry_tension": "entry_tension",
    "exit_tension": "exit_tension",
    "diameter": "diameter",
    "wrap_angle": "wrap_angle",
    "belt_width": "width",
    "lagging_thickness": "thickness",
    "shear_modulus": "shear_modulus",
    "compression_modulus": "compression_modulus",
    "wear_coefficient": "wear_coefficient",
    "overrun": "overrun",
    "recovery": "recovery",
    "creep_limit": "creep_limit",
    "belt_speed": "belt_speed",
    "pitch_offset": "pitch_offset",
    "cover_compliance": "cover_compliance",
    "centrifugal_force": "centrifugal",
}


def rows(cases: Sequence[Case], folder: Path) -> list[Record | None]:
    """Solve the arcs of all drives in one table: laws, lengths and missing values side by side."""
    arcs, laggings, owners = [], [], []
    for number, case in enumerate(cases):
        if case.refusal:
            continue
        drive = case.arcs.drive
        for result in case.arcs:
            if not is_divided(case, result.arc.load_case):
                continue
            load = drive.load_case(result.arc.load_case)
            arcs.append(result.arc)
            laggings.append(drive.pulley(result.arc.pulley).lagging_in(load.condition))
            owners.append(number)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)  # sizes that no drive has
        found = solve_batch(table_of(arcs), laggings, setting=Setting.PRECISE, threads=1)
    found = found.growing(*rises(arcs).T)
    made: list[dict[tuple[str, str, str], float]] = [{} for _ in cases]
    columns = {name: found[name] for name in found}
    for row, (arc, owner) in enumerate(zip(arcs, owners, strict=True)):
        for name, column in columns.items():
            place = arc.load_case, arc.pulley, name
            if place in cases[owner].record.numbers:
                made[owner][place] = float(column[row])
    return [Record(numbers=numbers, near=OF_ROWS) if numbers else None for numbers in made]


def rises(arcs: Sequence[WrapArc]) -> Array:
    """Return how tight and slack side grow with the pull, which no column of a table says [N]."""
    return np.array(
        [(a.growth.tight * abs(a.effective_tension), a.growth.slack * abs(a.effective_tension))
         for a in arcs]
    )  # fmt: skip


def table_of(arcs: Sequence[WrapArc]) -> dict[str, Any]:
    """Return arcs as columns; what an arc does not know is no value."""
    table: dict[str, Any] = {
        column: [getattr(arc, name) for arc in arcs] for column, name in COLUMNS.items()
    }
    table["belt_modulus"] = [arc.axial_stiffness / arc.width for arc in arcs]
    table["pitch_offset"] = [arc.offset for arc in arcs]
    return table | {"lagging": list(range(len(arcs)))}


def is_divided(case: Case, load_case: str) -> bool:
    """Return whether drives share their load: else the tensions are those of no solution."""
    whole = case.result
    return not isinstance(whole, TrainResult) or whole[load_case].status.solved


def study(case: Case, folder: Path) -> Record | None:
    """Solve a study of one row: the first pulley in every load case, judged in columns."""
    if case.refusal or case.arcs.drive.conditions:
        return None
    loads = [load.name for load in case.arcs.drive.load_cases]
    if not case.divided:
        return None  # a study is refused that begins with such drives
    pulley = case.document["pulley"][case.number % len(case.document["pulley"])]["name"]
    axis = {"field": "belt.width", "values": [case.document["belt"]["width"]]}
    document = {
        "format": 1,
        "drive": str(case.path),
        "pulley": pulley,
        "load_cases": loads,
        "setting": "precise",
        "axis": [axis],
    }
    file = folder / "study.toml"
    file.write_text(tomli_w.dumps(document), "utf-8")
    columns = load_study(str(file)).study.solve(0, 1)
    numbers, spots = {}, {}
    for row, load in enumerate(loads):
        level, name = LEVELS[columns["verdict"][row]], NAMES[columns["governing"][row]]
        told = str(level), name
        alike = told == known_to_rows(case, load, pulley)
        spots[load, pulley] = case.record.spots[load, pulley] if alike else told
        for output, column in columns.items():
            place = load, pulley, output
            if place in case.record.numbers:
                numbers[place] = float(column[row])
    return Record(spots=spots, numbers=numbers, near=OF_ROWS)


def known_to_rows(case: Case, load: str, pulley: str) -> tuple[str, str]:
    """Return level and check of a pulley by what rows check: not what is of all drives together."""
    own = case.verdict.at(pulley, load).checks
    sizes = [c for c in judge(case.arcs).at(pulley, load).checks if c.name == "usual_sizes"]
    known = [c for c in own if c.name in NAMES and c.name != "usual_sizes"]
    worst = Verdict((*known, *sizes))
    return str(worst.level), "" if worst.governing is None else worst.governing.name
