"""What was understood of a machine file, as a sheet."""

import math

from wraparc.answer.sheet import NONE, Row, Sheet, Table, Verdict, started
from wraparc.checks import Level
from wraparc.checks.action import Action
from wraparc.shear_test.record import ColumnInfo, MachineRecord
from wraparc.shear_test.strokes import find_strokes


def record_sheet(record: MachineRecord) -> Sheet:
    """Return columns, units, ranges, rows used and dropped, and every choice made."""
    written = [record.encoding]
    if record.delimiter:
        written += [f"delimiter {record.delimiter}", f"decimal sign {record.decimal}"]
    columns = tuple(
        Row(
            title=column.name,
            values=(column.unit or NONE, _span(column.low), _span(column.high)),
            note=f"used as {column.role.replace('_', ' ')}" if column.role else "",
        )
        for column in record.columns
    )
    rows = [Row("Rows of numbers", (str(record.rows),)), Row("Used", (str(len(record.travel)),))]
    rows += [
        Row("Not used", (str(item.count),), note=f"{item.reason}, from line {item.line}")
        for item in record.dropped
    ]
    strokes = len(find_strokes(record.travel, record.force))
    note = "the first is used where a plan does not say another" if strokes > 1 else ""
    rows.append(Row("Strokes", (str(strokes),), note=note))
    beside = (
        f"; test {record.block} of {record.blocks} side by side (block = {record.block})"
        if record.blocks > 1
        else ""
    )
    return Sheet(
        title=record.file,
        subtitle=f"{record.place}{beside}; {', '.join(written)}",
        verdict=_verdict(record),
        tables=(
            Table("Columns", columns, ("unit", "lowest", "highest")),
            Table("Rows", tuple(rows)),
        ),
        remarks=tuple(started(note) + "." for note in record.notes),
    )


def _verdict(record: MachineRecord) -> Verdict:
    """Return how many rows are used, and of which columns."""
    used = len(record.travel)
    if used < record.rows:
        reasons = tuple(f"{item.count} rows: {item.reason}." for item in record.dropped)
        text = f"{used:,} of {record.rows:,} rows used."
        return Verdict(Level.ATTENTION, text, reasons, action=_SEE, name="read")
    test = f"Test {record.block} of {record.blocks}" if record.blocks > 1 else "1 test"
    columns = {column.role: column for column in record.columns}
    named = [f"{role} {_column(columns[role])}" for role in ("travel", "force") if role in columns]
    return Verdict(Level.OK, f"{test}, {used:,} rows: {', '.join(named)}.", name="read")


_SEE = Action("Check the rows not used, below.")


def _column(column: ColumnInfo) -> str:
    return f"{column.name} ({column.unit})" if column.unit else column.name


def _span(value: float) -> str:
    return NONE if math.isnan(value) else f"{value:.6g}"
