"""How far numbers of a table may be off: its key `uncertainty`.

It stands beside the numbers, as `sources` does, so that these stay texts with a unit.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from wraparc.errors import Problem, format_list
from wraparc.schema.kinds import ByName, Percent
from wraparc.schema.problems import NOTHING, Report
from wraparc.schema.tables import Entry, Record, unknown_key_remedy

#: Key of such a table, and its entry.
UNCERTAINTY = "uncertainty"
#: Other names of numbers of which the uncertainty is the same.
_SAME_AS = {"wrap": "wrap_angle", "torque": "effective_tension", "power": "effective_tension"}
_NONE = "has no uncertainty"


def uncertainty_entry(names: Sequence[str]) -> Entry:
    """Return the entry of a table, some of whose numbers have an uncertainty."""
    meaning = f"How far single numbers may be off either way (95 %), by key: {format_list(names)}."
    return Entry(UNCERTAINTY, meaning, ByName(Percent()))


def read_uncertainty(record: Record, names: Sequence[str], report: Report) -> dict[str, float]:
    """Return the uncertainties of a table by key, reporting those of no such number [-]."""
    found: dict[str, float] = {}
    given: dict[str, str] = {}
    for key, value in record.get(UNCERTAINTY, {}).items():
        name, place = _SAME_AS.get(key, key), (*record.place, UNCERTAINTY, key)
        if name not in names:
            report.add(place, _NONE, _remedy(key, names))
        elif name in given:
            message = f"contradicts that of {given[name]}"
            report.add(place, message, "Remove one of them.", record.raw[UNCERTAINTY][key])  # type: ignore[index]
        elif value is not NOTHING:
            found[name] = value
        given.setdefault(name, key)
    return found


def _remedy(key: str, names: Sequence[str]) -> str:
    return unknown_key_remedy(key, names) if len(names) > 1 else f"Write {names[0]}."


def uncertainty_problems(values: Mapping[str, float], names: Sequence[str]) -> list[Problem]:
    """Return what is wrong with uncertainties that are not from a file."""
    problems = []
    for key, value in values.items():
        place = f"{UNCERTAINTY}.{key}"
        if key not in names:
            problems.append(Problem(key=place, message=_NONE, remedy=_remedy(key, names)))
        elif not 0.0 <= value <= 1.0:
            message = "must be a percentage from 0 % to 100 %"
            problems.append(Problem(key=place, value=f"{100.0 * value:g} %", message=message))
    return problems
