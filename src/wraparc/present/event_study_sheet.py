"""A study over an event as a table, and as rows for a file."""

import math
from collections.abc import Sequence

from wraparc.checks import Level
from wraparc.present.sheet import NONE, Row, Sheet, Table, percent, quantity
from wraparc.study.event_study import EventRow, EventStudy
from wraparc.units import System, display

#: Heads of the file; SI.
COLUMNS = (
    "peak creep [m]", "peak tension [N]", "least tension [N]", "swing of the last pull [-]",
    "friction work [J]", "pulsates at [Hz]", "worst check", "said",
)  # fmt: skip


def event_study_sheet(study: EventStudy, rows: Sequence[EventRow], system: System = "si") -> Sheet:
    """Return the table of a study over an event."""
    heads = ("creep", "largest T", "least T", "swing of pull", "friction work", "pulsates", "worst")
    lines = [_line(study, row, system) for row in rows]
    refused = [f"{_named(study, r)}: {r.said}" for r in rows if r.level == "REFUSED"]
    note = (
        "Swing: half of the last drum's pull from least to most over its mean, in the last quarter "
        "of the run. Pulsates: frequency of a vibration that grows by itself."
    )
    return Sheet(
        title=study.title or f"Event {study.event}",
        subtitle=f"event {study.event}, {len(rows)} designs",
        verdict=None,
        tables=(Table("Designs", tuple(lines), heads=heads, note=note),),
        remarks=tuple(refused),
        sources=(),
    )


def _named(study: EventStudy, row: EventRow) -> str:
    pairs = zip(study.fields, row.values, strict=True)
    return ", ".join(f"{field.rpartition('.')[2]} {value}" for field, value in pairs)


def _line(study: EventStudy, row: EventRow, system: System) -> Row:
    if row.level == "REFUSED":
        return Row(_named(study, row), (*[NONE] * 6, "refused"))
    values = (
        quantity(row.peak_creep, "length", system),
        quantity(row.peak_tension, "force", system),
        quantity(row.least_tension, "force", system),
        NONE if math.isnan(row.swing) else percent(row.swing, 2),
        f"{display(row.friction_energy / 1e3, 'number', digits=3)} kJ",
        f"{row.pulsates:.3g} Hz" if row.pulsates else "no",
        row.level,
    )
    return Row(_named(study, row), values, level=Level(row.level))


def event_study_rows(study: EventStudy, rows: Sequence[EventRow]) -> list[list[str]]:
    """Return heads and rows for a CSV file, SI."""
    found = [[*study.fields, *COLUMNS]]
    for row in rows:
        numbers = (
            row.peak_creep, row.peak_tension, row.least_tension, row.swing, row.friction_energy,
            row.pulsates,
        )  # fmt: skip
        texts = ["" if math.isnan(v) else f"{v:.7g}" for v in numbers]
        found.append([*row.values, *texts, row.level, row.said])
    return found
