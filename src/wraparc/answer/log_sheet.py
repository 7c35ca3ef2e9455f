"""The log of a control system, as it was understood: its tags, and how they are stored."""

import datetime as dt

import numpy as np

from wraparc.answer.sheet import NONE, Row, Sheet, Table, Verdict
from wraparc.checks import Level
from wraparc.machine_tables import LogFile, LogTag
from wraparc.units import count

#: Part of readings that repeat the one before, below which a tag is stored by exception [-].
_REPEATS = 0.005


def log_sheet(log: LogFile, file: str) -> Sheet:
    """Return the tags of a log with units, span, range and storage."""
    layout = "a row a reading" if log.is_long else "a column a tag"
    clock = "UTC" if log.is_zoned else "local clock"
    text = f"Log of {len(log.tags)} tags, {log.rows:,} rows: wraparc learn FILE DRIVE."
    return Sheet(
        title=file,
        subtitle=f"{layout}; {clock}",
        verdict=Verdict(Level.OK, text, name="read"),
        tables=(
            Table(
                "Tags",
                tuple(map(_row, log.tags)),
                ("unit", "readings", "from", "to", "lowest", "highest", "stored"),
            ),
        ),
        remarks=(f"{log.skipped} rows are no readings.",) if log.skipped else (),
    )


def _row(tag: LogTag) -> Row:
    known = tag.values[np.isfinite(tag.values)]
    low, high = (f"{f(known):.6g}" if len(known) else NONE for f in (np.min, np.max))
    first, last = (_moment(f(tag.times)) if len(tag.times) else NONE for f in (np.min, np.max))
    cells = (tag.unit or NONE, count(len(known)), first, last, low, high, _storage(tag))
    return Row(tag.name, cells)


def _storage(tag: LogTag) -> str:
    """Return how often a tag is stored, or that a row is a change."""
    gaps = np.abs(np.diff(tag.times))
    if len(gaps) < 2:
        return NONE
    usual = float(np.median(gaps))
    if np.mean(np.abs(gaps - usual) <= 0.5 * usual) > 0.9:
        return f"every {usual:g} s"
    repeats = float(np.mean(np.diff(tag.values) == 0.0))
    return "on change" if repeats < _REPEATS else "irregularly"


def _moment(seconds: float) -> str:
    moment = dt.datetime.fromtimestamp(round(float(seconds)), dt.UTC)
    return f"{moment:%Y-%m-%d %H:%M:%S}"
