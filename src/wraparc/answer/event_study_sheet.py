"""A study over an event as a table, and as plain data."""

import math
from collections import Counter
from collections.abc import Sequence
from typing import Any

from wraparc.answer.document import DOCUMENT_FORMAT
from wraparc.answer.motion_sheet import work
from wraparc.answer.sheet import NONE, Row, Sheet, Table, Verdict, percent, quantity
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
        "status",
    )
    lines = [_line(study, row) for row in rows]
    refused = [f"{_named(study, r)}: {r.text}" for r in rows if r.refused]
    note = (
        "Te ripple: half of the last pulley's Te from minimum to maximum over its mean, in the "
        "last quarter of the run. Oscillates: frequency of a self-excited oscillation."
    )
    return Sheet(
        title=study.title or f"Event {study.event}",
        subtitle=f"event {study.event}, {len(rows)} designs",
        verdict=_verdict(rows),
        tables=(Table("Designs", tuple(lines), heads, note, "designs"),),
        remarks=tuple(refused),
        sources=(),
    )


def _verdict(rows: Sequence[EventRow]) -> Verdict:
    """Return how many designs pass, need attention, fail and were refused."""
    total, refused = len(rows), sum(row.refused for row in rows)
    found = Counter(Level(row.level) for row in rows if not row.refused)
    if found[Level.OK] == total:
        worst = max(rows, key=lambda row: 0.0 if math.isnan(row.used) else row.used, default=None)
        closest = f" Closest: {worst.closest}." if worst and worst.closest else ""
        return Verdict(Level.OK, f"All {total:,} designs pass.{closest}", name="study")
    if found[Level.FAILS] == total:
        return Verdict(Level.FAILS, f"All {total:,} designs fail.", name="study")
    counts = [
        f"{found[level]:,} {verb if found[level] > 1 else one}"
        for level, verb, one in _ENDS
        if found[level]
    ]
    counts += [f"{refused:,} refused"] if refused else []
    text = f"{', '.join(counts)} of {total:,} designs."
    return Verdict(Level.ATTENTION, text, name="study")


#: How designs end, the worst first: of several, of one.
_ENDS = (
    (Level.FAULT, "without an answer", "without an answer"),
    (Level.FAILS, "fail", "fails"),
    (Level.ATTENTION, "need attention", "needs attention"),
    (Level.OK, "pass", "passes"),
)


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
        quantity(row.oscillation_frequency, "frequency") if row.oscillation_frequency else "no",
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
