"""Axes and conditions of a study file to what they vary."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import MISSING, fields
from typing import Any

import numpy as np

from wraparc.drive import Drive
from wraparc.errors import InputError
from wraparc.provenance import Provenance
from wraparc.schema.kinds import Choice, Flag, Kind, Name, Quantity, Text
from wraparc.schema.origins import own_provenance
from wraparc.schema.overrides import parse_path
from wraparc.schema.problems import NOTHING, Place, Report
from wraparc.schema.source import Document
from wraparc.schema.tables import Record
from wraparc.study.distributions import Distribution
from wraparc.study.fields import FACTOR, canonical, kind_of
from wraparc.study.fitted import DrawnFit
from wraparc.study.keys import DISTRIBUTIONS, NUMBERS
from wraparc.study.parameter_study import Condition
from wraparc.study.plan import DrawnField, Levels
from wraparc.study.source import Field

#: Names that the code has for the numbers of the distributions, by key.
_NAMES = {entry.key: entry.attribute for entry in NUMBERS}
Axis = Levels | DrawnField | DrawnFit


def read_axis(
    record: Record, document: Document, drive: Drive, report: Report
) -> tuple[Axis, Place] | None:
    """Return an axis and the canonical place of its field, or None after reporting."""
    if not record.sound() or "field" not in record:
        return None
    name: str = record["field"]
    field_place = (*record.place, "field")
    try:
        steps = canonical(parse_path(name), document)
        kind = kind_of(steps)
    except InputError as error:
        report.take(error, field_place, name)
        return None
    if record.get("distribution") == "fit":
        made = _fit(record, name, steps, drive, report)
        return (made, steps) if made else None
    if "distribution" in record:
        drawn = _drawn(record, name, kind, report)
        return (drawn, steps) if drawn else None
    levels = _levels(record, name, kind, report)
    return (levels, steps) if levels else None


def _fit(record: Record, name: str, steps: Place, drive: Drive, report: Report) -> DrawnFit | None:
    place = (*record.place, "field")
    if len(steps) != 3 or steps[0] != "pulley" or steps[2] != "lagging":
        message = "must be the lagging of a pulley"
        report.add(place, message, 'Write field = "pulley.NAME.lagging".', name)
        return None
    pulley = report.tried(lambda: drive.pulley(str(steps[1])), place)
    if pulley is None:
        return None
    if pulley.lagging.fit is None:
        message = f"lagging {pulley.lagging.name} has no fit to draw from"
        report.add(place, message, "Fit it: wraparc fit.", name)
        return None
    fit = pulley.lagging.fit
    return report.tried(lambda: DrawnFit(field=name, fit=fit), record.place)


def _levels(record: Record, name: str, kind: Kind, report: Report) -> Levels | None:
    spare = [key for key in _NAMES if key in record and key not in ("from", "to")]
    if spare:
        message = "belongs to a distribution"
        report.add((*record.place, spare[0]), message, 'Write distribution = "normal" too.')
        return None
    grid = [key for key in ("from", "to", "count") if key in record]
    if ("values" in record) == bool(grid) or (grid and len(grid) < 3):
        message = "needs values, from/to/count or a distribution"
        report.add(record.place, message, "Write for example values = [...].", name)
        return None
    if "values" in record:
        place = (*record.place, "values")
        raw = record["values"]
        values = [read_value(kind, v, (*place, i), report) for i, v in enumerate(raw, start=1)]
        if any(v is NOTHING for v in values):
            return None
        return _unlike(name, values, kind, place, report)
    if not isinstance(kind, Quantity):
        report.add((*record.place, "from"), "is no number", "Write values = [...].", name)
        return None
    ends = [read_value(kind, record[k], (*record.place, k), report) for k in ("from", "to")]
    if any(v is NOTHING for v in ends):
        return None
    return _grid(record, name, kind, ends, report)


def _grid(
    record: Record, name: str, kind: Quantity, ends: Sequence[float], report: Report
) -> Levels | None:
    low, high = ends
    logarithmic = record.get("spacing") == "logarithmic"
    if low == high or (logarithmic and min(low, high) <= 0.0):
        message = "must differ from the first" + (", and both be more than 0" * logarithmic)
        report.add((*record.place, "to"), message, value=record["to"])
        return None
    spread = np.geomspace if logarithmic else np.linspace
    values = tuple(spread(low, high, record["count"]).tolist())
    return Levels(field=name, values=values, dimension=kind.dimension)


def _unlike(
    name: str, values: list[Any], kind: Kind, place: Place, report: Report
) -> Levels | None:
    if len(set(values)) < len(values):
        report.add(place, "contains a value twice", "Remove one of them.")
        return None
    dimension = kind.dimension if isinstance(kind, Quantity) else None
    return Levels(field=name, values=tuple(values), dimension=dimension)


def read_value(kind: Kind, raw: object, place: Place, report: Report) -> Any:
    """Return a value of a field, or NOTHING after reporting."""
    if not isinstance(kind, Quantity | Text | Name | Choice | Flag):
        report.add(place, "the field is a table, not a value", "Name a key in it.")
        return NOTHING
    return kind.read(raw, place, report)


def _drawn(record: Record, name: str, kind: Kind, report: Report) -> DrawnField | None:
    for key in ("values", "count", "spacing"):
        if key in record:
            message = "does not go with a distribution"
            report.add((*record.place, key), message, "Remove one of them.")
            return None
    if not isinstance(kind, Quantity):
        place = (*record.place, "distribution")
        report.add(place, "the field is no number", "Write values = [...].", name)
        return None
    distribution = read_distribution(record, kind, report)
    if distribution is None:
        return None
    return DrawnField(field=name, distribution=distribution, dimension=kind.dimension)


def read_distribution(record: Record, kind: Quantity, report: Report) -> Distribution | None:
    """Return the distribution of a table, cut to what the quantity can be."""
    word: str = record["distribution"]
    make = DISTRIBUTIONS[word]
    wanted = {f.name for f in fields(make) if f.default is MISSING}
    needed = [key for key, name in _NAMES.items() if name in wanted]
    missing = [key for key in needed if key not in record]
    spare = [k for k in _NAMES if k in record and k not in (*needed, "least", "most")]
    for key in missing:
        report.add((*record.place, key), f"missing, and a {word} distribution needs it")
    for key in spare:
        report.add((*record.place, key), f"is no number of a {word} distribution")
    plain = Quantity(kind.dimension)
    numbers: dict[str, Any] = {}
    for key in (k for k in _NAMES if k in record and k not in spare):
        number = key == "geometric_standard_deviation"
        value = record[key] if number else plain.read(record[key], (*record.place, key), report)
        numbers[_NAMES[key]] = value
    if missing or spare or any(v is NOTHING for v in numbers.values()):
        return None
    back = {name: key for key, name in _NAMES.items()}
    return report.tried(lambda: make(**_cut(numbers, kind)), record.place, record.raw, back)


def _cut(numbers: Mapping[str, float], kind: Quantity) -> dict[str, float]:
    """Return the numbers with the limits of the quantity as ends of the distribution."""
    cut = dict(numbers)
    if kind.limit is not None:
        cut["least"] = max(cut.get("least", -np.inf), kind.limit.least)
        cut["most"] = min(cut.get("most", np.inf), kind.limit.most)
    return cut


def read_condition(record: Record, report: Report) -> Condition | None:
    """Return a condition, or None after reporting."""
    if not record.sound():
        return None
    factor = record.get("friction_factor", 1.0)
    if isinstance(factor, Record):
        factor = read_distribution(factor, FACTOR, report)
        if factor is None:
            return None
    return Condition(
        name=record["name"],
        friction_factor=factor,
        share=record.get("share"),
        provenance=own_provenance(record, report) or Provenance(),
    )


def field_of(axis: Axis, place: Place) -> Field | None:
    """Return the field that an axis varies; None for a law, which has many."""
    if isinstance(axis, Levels):
        return Field.of(axis, place)
    if isinstance(axis, DrawnField):
        return Field(axis.field, place, axis.dimension)
    return None
