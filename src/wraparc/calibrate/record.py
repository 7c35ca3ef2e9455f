"""Records of instrumented pulleys, read from text tables."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from wraparc.arrays import Array
from wraparc.calibrate.virtual_pulley import PulleyRecord
from wraparc.errors import InputError, Problem, input_error, shown
from wraparc.machine_tables import (
    NamedColumn,
    RawTable,
    find_column,
    find_tables,
    plain_name,
    read_bytes,
)
from wraparc.machine_tables.log_names import are_of_drive
from wraparc.units import Dimension, dimension_of, unit_factor

_EXPORT = "Export rows of rotation angle, belt displacement and shear angle."
#: what a record may hold: column, dimension, words that name it
ROLES: dict[str, tuple[Dimension, tuple[str, ...]]] = {
    "angle": ("angle", ("rotation", "theta", "pulley", "encoder", "drehwinkel", "position")),
    "displacement": ("length", ("creep", "displacement", "travel", "belt", "schlupf", "weg")),
    "shear_angle": ("angle", ("shear", "gamma", "lagging", "scher", "gleitung")),
}


@dataclass(frozen=True, kw_only=True)
class RecordChoices:
    """What the user says of a record; what is left out is found in the file, or asked for.

    Attributes
    ----------
    columns
        Column by role (``angle``, ``displacement``, ``shear_angle``): name or number from 1.
    units
        Unit by role, where the file has none.
    signs
        ``+1`` or ``-1`` by role: the sign that the measured values have on a driving pulley.
    delimiter
        ``tab``, ``comma`` ... where it cannot be found.
    """

    columns: Mapping[str, str | int] = field(default_factory=dict)
    units: Mapping[str, str] = field(default_factory=dict)
    signs: Mapping[str, int] = field(default_factory=dict)
    delimiter: str | None = None


def read_record(path: str | os.PathLike[str], choices: RecordChoices | None = None) -> PulleyRecord:
    """Read the record of an instrumented pulley from a text table.

    Any delimiter and decimal sign. A unit is never inferred from the size of numbers: where the
    file has none, it must be given. Values keep the sign they have in the file.

    Raises
    ------
    InputError
        With everything that cannot be told, and what to write to tell it.
    """
    chosen, file = choices or RecordChoices(), os.fspath(path)
    table = _table(file, chosen)
    columns, complaint = table.named(lambda name: any(_is_named(name, role) for role in ROLES))
    problems: list[Problem] = []
    if complaint and not chosen.columns:
        problems.append(Problem(file=file, message=complaint, remedy="Choose columns by number."))
    found = {}
    for role in ROLES:
        place = _place(role, columns, chosen, file, problems)
        if place is not None:
            factor = _factor(role, columns[place], chosen, file, problems)
            found[role] = (place, factor)
    if "angle" not in found and not problems:
        problems.append(_missing("angle", columns, file))
    if not problems and len(found) < 2:
        problems.append(_missing("displacement or shear_angle", columns, file))
    if problems:
        refuse_log([column.name for column in columns], file)
        raise InputError(problems)
    style = table.found_style(file)
    values = {role: table.numbers(k, style) * factor for role, (k, factor) in found.items()}
    good = np.all([np.isfinite(v) for v in values.values()], axis=0)
    values = {role: v[good] for role, v in values.items()}
    return PulleyRecord(
        unwrapped(values["angle"]), values.get("displacement"), values.get("shear_angle")
    )


def refuse_log(names: Sequence[str], file: str) -> None:
    """Refuse columns that are those of the log of a drive, with the command that reads one."""
    if are_of_drive(names):
        raise input_error(file=file, message="this is a log: wraparc learn FILE DRIVE")


def _table(file: str, chosen: RecordChoices) -> RawTable:
    tables = find_tables(read_bytes(file, _EXPORT), file, delimiter=chosen.delimiter).tables
    if not tables:
        raise input_error(file=file, message="contains no table of numbers", remedy=_EXPORT)
    return max(tables, key=lambda table: table.rows)


def _is_named(name: str, role: str) -> bool:
    plain = plain_name(name)
    return any(word in plain.split() or plain.startswith(word) for word in ROLES[role][1])


def _place(
    role: str,
    columns: list[NamedColumn],
    chosen: RecordChoices,
    file: str,
    problems: list[Problem],
) -> int | None:
    """Return the place of the column of a role, None if there is none."""
    asked = chosen.columns.get(role)
    if asked is not None:
        column = find_column(columns, asked)
        if column is not None:
            return column.index
        there = ", ".join(shown(c.label) for c in columns)
        problem = Problem(
            file=file, key=role, value=shown(asked), message="no such column",
            remedy=f"The columns are {there}.",
        )  # fmt: skip
        problems.append(problem)
        return None
    dimension = ROLES[role][0]
    taken = set(chosen.columns.values())
    fits = [
        c.index
        for c in columns
        if c.label not in taken
        and c.index + 1 not in taken
        and _is_named(c.name, role)
        and (dimension_of(c.unit) in (dimension, None) if c.unit else True)
    ]
    if role == "angle" and not fits:  # a lone column of angles that is not the shear angle
        shear = ROLES["shear_angle"][1]
        fits = [
            c.index
            for c in columns
            if dimension_of(c.unit) == "angle" and not any(w in plain_name(c.name) for w in shear)
        ]
    if len(fits) > 1:
        names_ = ", ".join(shown(columns[k].label) for k in fits)
        message = f"several columns could be the {role.replace('_', ' ')}: {names_}"
        remedy = f"Write columns.{role} = the name or number of one."
        problems.append(Problem(file=file, key=role, message=message, remedy=remedy))
        return None
    return fits[0] if fits else None


def _factor(
    role: str, column: NamedColumn, chosen: RecordChoices, file: str, problems: list[Problem]
) -> float:
    dimension = ROLES[role][0]
    unit = chosen.units.get(role) or column.unit
    if not unit:
        problems.append(
            Problem(
                file=file,
                key=f"units.{role}",
                message=f"column {shown(column.label)} has no unit",
                remedy=f'Write units.{role} = "?" with its unit.',
            )
        )
        return 1.0
    try:
        return unit_factor(unit, dimension)
    except InputError as error:
        first = error.problems[0]
        problem = Problem(
            file=file, key=f"units.{role}", value=shown(unit), message=first.message,
            remedy=first.remedy,
        )  # fmt: skip
        problems.append(problem)
        return 1.0


def _missing(role: str, columns: list[NamedColumn], file: str) -> Problem:
    there = ", ".join(shown(c.label) for c in columns)
    return Problem(
        file=file,
        key="columns",
        message=f"no column is recognised as {role.replace('_', ' ')}",
        remedy=f"Write columns.NAME = one of {there}.",
    )


def unwrapped(angle: Array) -> Array:
    """Return a rotation angle that runs on instead of falling back each turn [rad].

    Falls or rises of more than half a turn from one sample to the next are the wrap of an
    encoder; the direction is that of most samples.
    """
    steps = np.diff(angle)
    jumps = np.abs(steps) > np.pi
    if not jumps.any():
        return angle
    turns = np.concatenate([[0.0], np.cumsum(np.where(jumps, -np.sign(steps), 0.0))])
    return np.asarray(angle + 2.0 * np.pi * turns)
