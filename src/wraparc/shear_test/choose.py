"""Which column is the travel, the force, the normal force, the time, and in what unit."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from wraparc.arrays import Array
from wraparc.errors import InputError, Problem, format_list, name_remedy, shown
from wraparc.machine_tables import ColumnUnit, NamedColumn, find_column, read_unit
from wraparc.shear_test.record import Choices
from wraparc.shear_test.roles import (
    ROLE_DIMENSION,
    Role,
    is_across,
    is_coefficient,
    is_demand,
    is_known,
    is_other,
    is_stress,
    suitability,
)
from wraparc.units import DIMENSION_TEXT

_NEEDED = (Role.TRAVEL, Role.FORCE)
# Names as good as each other; a name that leaves no doubt; courses that are one, of their range.
_NEAR, _SURE, _COURSE = 1.5, 4.5, 0.05


@dataclass(frozen=True)
class Chosen:
    """The columns in use with their units, and what to say about the choice."""

    columns: dict[Role, tuple[NamedColumn, ColumnUnit]]
    notes: tuple[str, ...]
    passed_over: tuple[str, ...] = ()


def choose_columns(
    named: Sequence[NamedColumn],
    data: Mapping[int, Array],
    choices: Choices,
    file: str,
    above: Sequence[str] = (),
) -> Chosen:
    """Choose the columns of a table.

    What the user names is taken; else the column whose name and unit fit best. A column
    whose numbers never change, or that is mostly no number, is not chosen by itself. One whose
    name says nothing is chosen by its unit only where it is the only one of its kind, and no
    demand stands in the file: `above` holds the texts above the table.

    Raises
    ------
    InputError
        With one problem for each column or unit that must be named.
    """
    problems: list[Problem] = []
    given = _given_units(named, choices, file, problems)
    columns: dict[Role, tuple[NamedColumn, ColumnUnit]] = {}
    notes: list[str] = []
    passed: list[str] = []
    demanded = any(is_demand(text) for text in (*above, *(column.name for column in named)))
    for role in Role:
        wanted = getattr(choices, role.value)
        if wanted is not None:
            column = find_column(named, wanted)
            if column is None:
                problems.append(_unknown_column(named, role.value, wanted, file))
        else:
            candidates = _candidates(named, data, role, given, columns, guess=not demanded)
            if not candidates and role is Role.FORCE and choices.stress_area is not None:
                candidates = [(column, 0.0) for column in stresses(named, given)]
            column = _best(named, data, role, given, candidates, problems, notes, file, choices)
            if role in _NEEDED:
                passed += [other.label for other, _ in candidates[1:]]
        if column is None:
            continue
        unit = _unit_of(column, role, given, file, problems, choices)
        if unit is not None:
            columns[role] = (column, unit)
            notes.extend(filter(None, [unit.note]))
    if choices.normal_force is None and _is_the_pull(columns, data):
        del columns[Role.NORMAL_FORCE]
    if problems:
        raise InputError(problems)
    return Chosen(columns, tuple(notes), tuple(dict.fromkeys(passed)))


def _best(
    named: Sequence[NamedColumn],
    data: Mapping[int, Array],
    role: Role,
    given: Mapping[int, str],
    candidates: Sequence[tuple[NamedColumn, float]],
    problems: list[Problem],
    notes: list[str],
    file: str,
    choices: Choices,
) -> NamedColumn | None:
    """The best candidate, if there is one and no other may as well be meant."""
    if not candidates:
        if role in _NEEDED:
            problems.append(_no_column(named, role, file, choices))
        return None
    best = candidates[0][0]
    rivals = _rivals(named, data, role, given, candidates)
    if rivals:
        problems.append(_no_column(named, role, file, choices, [best, *rivals]))
        return None
    if len(candidates) > 1:
        notes.append(_choice_note(role, [column for column, _ in candidates]))
    return best


def _is_the_pull(
    columns: Mapping[Role, tuple[NamedColumn, ColumnUnit]], data: Mapping[int, Array]
) -> bool:
    """Whether the normal force holds the readings of the pull, as compression and tension do."""
    pull, press = (columns.get(role) for role in (Role.FORCE, Role.NORMAL_FORCE))
    if pull is None or press is None:
        return False
    return _same(*(data[c.index] * unit.factor for c, unit in (pull, press)))


def _given_units(
    named: Sequence[NamedColumn], choices: Choices, file: str, problems: list[Problem]
) -> dict[int, str]:
    given: dict[int, str] = {}
    for name, unit in choices.units.items():
        column = find_column(named, name)
        if column is None:
            problems.append(_unknown_column(named, "units", name, file))
            continue
        said, stated = read_unit(unit), read_unit(column.unit)
        if said is None:
            problems.append(_wrong_unit(column, unit, "no such unit", file))
        elif stated is not None and stated.dimension != said.dimension:
            message = f"contradicts {shown(column.unit)} in the file"
            problems.append(_wrong_unit(column, unit, message, file))
        else:
            given[column.index] = unit
    return given


def _wrong_unit(column: NamedColumn, unit: str, message: str, file: str) -> Problem:
    return Problem(
        message=message,
        remedy="Leave the unit out, or correct it.",
        file=file,
        key=f"units[{column.label!r}]",
        value=shown(unit),
    )


def _candidates(
    named: Sequence[NamedColumn],
    data: Mapping[int, Array],
    role: Role,
    given: Mapping[int, str],
    taken: Mapping[Role, tuple[NamedColumn, ColumnUnit]],
    *,
    guess: bool,
) -> list[tuple[NamedColumn, float]]:
    """Columns that may be meant with how well each does, the best first."""
    kinds = [read_unit(given.get(c.index, c.unit), ROLE_DIMENSION[role]) for c in named]
    alone = sum(k is not None and k.dimension == ROLE_DIMENSION[role] for k in kinds) == 1
    guess = guess and alone and role in _NEEDED
    used = {column.index for column, _ in taken.values()}
    scored: list[tuple[float, int, NamedColumn]] = []
    for column in named:
        values = data[column.index]
        if column.index in used or not _holds_data(values, constant=role is Role.NORMAL_FORCE):
            continue
        unit = read_unit(given.get(column.index, column.unit), ROLE_DIMENSION[role])
        stated = given.get(column.index, column.unit).strip()
        if unit is not None and unit.dimension != ROLE_DIMENSION[role]:
            continue
        if unit is None and stated:
            continue
        score = suitability(column.name, role)
        unknown = guess and unit is not None and not _says_something(column.name)
        if score == 0.0 and unknown and not is_across(column.name):
            score = 0.5
        if score > 0.0:
            scored.append((-(score + (unit is not None)), column.index, column))
    return [(column, -bad) for bad, _, column in sorted(scored, key=lambda item: item[:2])]


def _rivals(
    named: Sequence[NamedColumn],
    data: Mapping[int, Array],
    role: Role,
    given: Mapping[int, str],
    candidates: Sequence[tuple[NamedColumn, float]],
) -> list[NamedColumn]:
    """Columns that may as well be meant as the best one, and hold other numbers.

    Names as good as its own; for a force that is not named as one along the sliding, also
    columns of a force whose names say nothing, and coefficients of friction where no normal force
    is named: that load may be one.
    """
    if role is Role.TIME:
        return []
    (best, score), *others = candidates
    rivals = [column for column, own in others if own > score - _NEAR]
    if role is Role.FORCE and score < _SURE:
        rivals += [
            c
            for c in named
            if (unit := read_unit(given.get(c.index, c.unit), "force")) is not None
            and unit.dimension == "force"
            and not _says_something(c.name)
            and _holds_data(data[c.index], constant=False)
        ]
        if not any(suitability(c.name, Role.NORMAL_FORCE) for c in named):
            rivals += [c for c in named if is_coefficient(c.name)]

    def numbers(column: NamedColumn) -> Array:
        unit = read_unit(given.get(column.index, column.unit), ROLE_DIMENSION[role])
        return data[column.index] * (unit.factor if unit else 1.0)

    zero = role is Role.TRAVEL
    return [c for c in rivals if not _same(numbers(best), numbers(c), any_zero=zero)]


def _same(first: Array, second: Array, *, any_zero: bool = False) -> bool:
    """Whether two columns hold the same readings, of whatever sign and perhaps zero."""
    known = np.isfinite(first) & np.isfinite(second)
    first, second = first[known], second[known]
    if not len(first):
        return False
    size = np.ptp if any_zero else lambda off: np.abs(off).max()
    apart = [float(size(off)) for off in (first - second, first + second)]
    return min(apart) < _COURSE * float(np.ptp(first))


def _says_something(name: str) -> bool:
    """Whether a name says what its column is, or that it is none of those looked for."""
    return is_known(name) or is_other(name)


def _holds_data(values: Array, *, constant: bool) -> bool:
    """Whether a column is mostly numbers, and not the same one throughout unless it may be."""
    finite = values[np.isfinite(values)]
    if 2 * len(finite) <= len(values):
        return False
    return bool(np.any(finite != 0.0)) if constant else float(np.ptp(finite)) > 0.0


def _unit_of(
    column: NamedColumn,
    role: Role,
    given: Mapping[int, str],
    file: str,
    problems: list[Problem],
    choices: Choices,
) -> ColumnUnit | None:
    dimension = ROLE_DIMENSION[role]
    text = given.get(column.index, column.unit)
    stress = read_unit(text) if role is Role.FORCE else None
    if stress is not None and stress.dimension == "pressure":
        if choices.stress_area is None:
            problems.append(_no_area(column, text, file, choices))
            return None
        note = f"the force is {column.label!r} [{text}] times {choices.stress_area * 1e4:.6g} cm2"
        return ColumnUnit(text, "force", stress.factor * choices.stress_area, note)
    unit = read_unit(text, dimension)
    stated = read_unit(column.unit, dimension)
    if unit is not None and unit.dimension == dimension:
        if stated is not None and not np.isclose(stated.factor, unit.factor, rtol=1e-9):
            message = f"contradicts {shown(column.unit)} in the file"
            problems.append(_wrong_unit(column, text, message, file))
            return None
        return unit
    if role is Role.TIME and column.index not in given:
        return None
    kind = DIMENSION_TEXT[dimension].name
    said = f"has unit {text}, which is not {kind}" if text else "has no unit"
    problems.append(
        Problem(
            message=f"column {column.label} {said}",
            remedy=f'Add units = {{ {shown(column.label)} = "?" }}.'
            if choices.in_plan
            else f"Add --unit '{column.label}=?'.",
            file=file,
            code="" if text else "unit",
            meant="" if text else column.label,
        )
    )
    return None


def stresses(named: Sequence[NamedColumn], given: Mapping[int, str]) -> list[NamedColumn]:
    """Columns that hold a stress by name and unit."""
    units = {c.index: read_unit(given.get(c.index, c.unit)) for c in named}
    return [
        c
        for c in named
        if (unit := units[c.index]) is not None
        and unit.dimension == "pressure"
        and is_stress(c.name)
    ]


def _no_area(column: NamedColumn, text: str, file: str, choices: Choices) -> Problem:
    return Problem(
        message=f"column {column.label} holds a stress [{text}], not a force",
        remedy=f"Add {_option('stress_area', choices)}, or export the force.",
        file=file,
    )


def _option(key: str, choices: Choices) -> str:
    """Return what states a choice: a key of the plan, or an option of the command line."""
    return key if choices.in_plan else f"--{key.replace('_', '-')}"


def _choice_note(role: Role, candidates: Sequence[NamedColumn]) -> str:
    name = role.value.replace("_", " ")
    others = ", ".join(repr(c.label) for c in candidates[1:])
    return (
        f"the {name} is {candidates[0].label!r}; the file also has {others} "
        f"(choose with {role.value} = ...)"
    )


def _unknown_column(
    named: Sequence[NamedColumn], key: str, wanted: str | int, file: str
) -> Problem:
    return Problem(
        message="no such column",
        remedy=name_remedy(wanted, [c.label for c in named]),
        file=file,
        key=key,
        value=shown(wanted),
    )


def _no_column(
    named: Sequence[NamedColumn],
    role: Role,
    file: str,
    choices: Choices,
    rivals: Sequence[NamedColumn] = (),
) -> Problem:
    stress = [c for c in named if role is Role.FORCE and is_stress(c.name)]
    option = _option(role.value, choices)
    names = [f"{shown(c.label)} [{c.unit}]" if c.unit else shown(c.label) for c in rivals or named]
    remedy = f"Add {option} with one of {format_list(names, 4)}."
    if stress:
        remedy = f"Add {option}, or {_option('stress_area', choices)} for {shown(stress[0].label)}."
    return Problem(
        message=f"{role.value.replace('_', ' ')} column unclear", remedy=remedy, file=file
    )
