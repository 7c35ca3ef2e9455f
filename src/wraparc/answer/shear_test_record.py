"""What was understood of a machine file, as a sheet."""

import math

from wraparc.answer.sheet import NONE, Also, Row, Sheet, Table, Verdict, started
from wraparc.checks import Level
from wraparc.checks.action import Action
from wraparc.errors import format_names
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
        f"; test {record.block} of {record.blocks} in its table (block = {record.block}"
        f"{', ' + record.part if record.part else ''})"
        if record.blocks > 1
        else ""
    )
    return Sheet(
        title=record.file,
        subtitle=f"{record.place}{beside}; {', '.join(written)}",
        verdict=_verdict(record, strokes),
        tables=(
            Table("Columns", columns, ("unit", "lowest", "highest")),
            Table("Rows", tuple(rows)),
        ),
        remarks=tuple(started(note) + "." for note in (*record.notes, *_stated(record))),
    )


def _stated(record: MachineRecord) -> list[str]:
    """What the file says of the test beside its readings."""
    return [f"{item.place} says {item.of} {item.text}" for item in record.stated]


def _verdict(record: MachineRecord, strokes: int) -> Verdict:
    """Return how many rows, strokes and tables are used, and of which columns."""
    used = len(record.travel)
    others = format_names(record.passed_over, 3)
    also = (Also(Level.OK, f"Columns not used: {others}."),) if record.passed_over else ()
    if record.unread:
        tables = "1 further table" if record.unread == 1 else f"{record.unread} further tables"
        text = f"{tables} of the file not read, {used:,} rows used."
        return Verdict(Level.ATTENTION, text, action=_NAME_TABLE, also=also, name="read")
    if used < record.rows:
        text = f"{used:,} of {record.rows:,} rows used."
        return Verdict(Level.ATTENTION, text, action=_SEE, also=also, name="read")
    if strokes > 1:
        text = f"{strokes} strokes in {used:,} rows: the first is used."
        return Verdict(Level.ATTENTION, text, action=_NAME_STROKE, also=also, name="read")
    test = f"Test {record.block} of {record.blocks}" if record.blocks > 1 else "1 test"
    columns = {column.role: column for column in record.columns}
    named = [f"{role} {_column(columns[role])}" for role in ("travel", "force") if role in columns]
    text = f"{test}, {used:,} rows: {', '.join(named)}."
    return Verdict(Level.OK, text, also=also, name="read")


_SEE = Action("Check the rows not used, below.")
_NAME_TABLE = Action("Give each table a [[test]] of its own: table = 1, table = 2.")
_NAME_STROKE = Action('Write stroke = "last", "mean" or "all" in the plan if these are meant.')


def _column(column: ColumnInfo) -> str:
    return f"{column.name} ({column.unit})" if column.unit else column.name


def _span(value: float) -> str:
    return NONE if math.isnan(value) else f"{value:.6g}"
