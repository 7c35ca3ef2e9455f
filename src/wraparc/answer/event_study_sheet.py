"""A study over an event as a table, and as plain data."""

import math
from collections import Counter
from collections.abc import Sequence
from typing import Any

from wraparc.answer.document import DOCUMENT_FORMAT
from wraparc.answer.motion_sheet import work
from wraparc.answer.sheet import NONE, Row, Sheet, Table, percent, quantity
from wraparc.checks import Level
from wraparc.study.event_rows import NAMES, UNITS
from wraparc.study.event_study import EventRow, EventStudy
from wraparc.version import __version__


def event_study_sheet(study: EventStudy, rows: Sequence[EventRow]) -> Sheet:
    """Return the table of a study over an event."""
    heads = (
        "creep",
        "maximum T",
        "minimum T",
        "Te ripple",
        "friction work",
        "oscillates",
        "verdict",
    )
    lines = [_line(study, row) for row in rows]
    refused = [f"{_named(study, r)}: {r.text}" for r in rows if r.refused]
    note = (
        "Te ripple: half of the last pulley's Te from minimum to maximum over its mean, in the "
        "last quarter of the run. Oscillates: frequency of a self-excited oscillation."
    )
    return Sheet(
        title=study.title or f"Event {study.event}",
        subtitle=f"event {study.event}, {len(rows)} designs: {_counted(rows)}",
        verdict=None,
        tables=(Table("Designs", tuple(lines), heads, note, "designs"),),
        remarks=tuple(refused),
        sources=(),
    )


def _counted(rows: Sequence[EventRow]) -> str:
    """How many designs come to which verdict, the best first."""
    ranks = {str(level): level.rank for level in Level}
    found = Counter((ranks.get(row.level, len(ranks)), row.label) for row in rows)
    return "; ".join(f"{count} {word}" for (_, word), count in sorted(found.items()))


def _named(study: EventStudy, row: EventRow) -> str:
    pairs = zip(study.fields, row.values, strict=True)
    return ", ".join(f"{field.rpartition('.')[2]} {value}" for field, value in pairs)


def _line(study: EventStudy, row: EventRow) -> Row:
    if row.refused:
        return Row(_named(study, row), (*[NONE] * 6, row.label))
    values = (
        quantity(row.peak_creep, "length"),
        quantity(row.peak_tension, "force"),
        quantity(row.least_tension, "force"),
        NONE if math.isnan(row.swing) else percent(row.swing, 2),
        work(row.friction_energy),
        quantity(row.pulsates, "frequency") if row.pulsates else "no",
        row.label,
    )
    return Row(_named(study, row), values, level=Level(row.level))


def event_study_document(study: EventStudy, rows: Sequence[EventRow]) -> dict[str, Any]:
    """Return a study over an event as plain data: SI, nan where there is no number."""
    return {
        "format": DOCUMENT_FORMAT,
        "program": {"name": "wraparc", "version": __version__},
        "title": study.title,
        "event": study.event,
        "points": study.points,
        "settings": list(study.settings),
        "units": {name: unit for name, unit in zip(NAMES, UNITS, strict=True) if unit},
        "designs": [_row_data(study, row) for row in rows],
    }


def _row_data(study: EventStudy, row: EventRow) -> dict[str, Any]:
    told = {name: getattr(row, name) for name in NAMES}
    return {"values": dict(zip(study.fields, row.values, strict=True)), **told}
