"""What was read, test by test: rows, circumstances, and what must be known of single tests."""

from collections.abc import Iterator, Sequence
from dataclasses import replace

from wraparc.answer.sheet import NONE, Row, Table, bare, headed, percent, quantity
from wraparc.shear_test.analysis import ConditionResult, PlanResult, TestResult
from wraparc.shear_test.speeds import per_minute
from wraparc.units import GIVEN_DIGITS, count

#: More tests than this, of which the same is to be said, are counted instead of named.
_FEW = 3


def left_out_table(result: PlanResult) -> Table:
    """Tests that could not be used, and why."""
    return Table(
        "Tests left out", tuple(Row(str(p), ()) for p in result.left_out), heads=(), name="left-out"
    )


def unused_table(result: PlanResult) -> Table:
    """Tests that the plan says not to use, and why."""
    rows = (Row(f"{t.place} ({t.file}): {t.reason}", ()) for t in result.plan.unused_tests)
    return Table("Tests not used, as the plan says", tuple(rows), heads=(), name="unused")


def files_table(condition: ConditionResult, name: str) -> Table:
    """One line a file: what was read of it and under what circumstances it was tested."""
    rows = []
    for test in condition.tests:
        planned, record = test.test, test.record
        warm = planned.temperature
        rows.append(
            Row(
                title=planned.label,
                values=(
                    count(record.rows),
                    count(len(record.travel)),
                    count(len(test.curve.travel)),
                    "measured" if record.normal_force is not None else "as set",
                    bare(test.fit.slip_max, "length"),
                    NONE if warm is None else quantity(warm, "temperature", GIVEN_DIGITS),
                    NONE if planned.speed is None else per_minute(planned.speed),
                    NONE if planned.humidity is None else percent(planned.humidity),
                    planned.date or NONE,
                    NONE if planned.order is None else count(planned.order),
                    planned.sample or NONE,
                    planned.lot or NONE,
                    planned.operator or NONE,
                ),
            )
        )
    heads = (
        "rows",
        "used",
        "of the stroke",
        "normal force",
        headed("slip", "length"),
        "temperature",
        "speed",
        "humidity",
        "date",
        "order",
        "sample",
        "lot",
        "operator",
    )
    note = (
        "Rows of numbers in the file, those used, and those of the stroke that were fitted; "
        "maximum slip."
    )
    return without_empty(Table(f"Files{name}", tuple(rows), heads, note, "files"))


def without_empty(table: Table) -> Table:
    """Return the table without the columns that say nothing in any row."""
    told = [k for k in range(len(table.heads)) if any(row.values[k] != NONE for row in table.rows)]
    rows = (replace(row, values=tuple(row.values[k] for k in told)) for row in table.rows)
    return replace(table, rows=tuple(rows), heads=tuple(table.heads[k] for k in told))


def remarks_table(condition: ConditionResult, name: str) -> Table | None:
    """What was chosen, left out or noticed in single tests; None if there is nothing to say."""
    about: dict[str, list[str]] = {}
    for test in condition.tests:
        for text in _remarks(test):
            about.setdefault(text, []).append(test.test.label)
    if not about:
        return None
    lines = tuple(Row(f"{_listed(files)}: {text}.", ()) for text, files in about.items())
    return Table(f"Remarks on single tests{name}", lines, heads=(), name="remarks")


def _remarks(test: TestResult) -> Iterator[str]:
    for item in test.record.dropped:
        rows = "1 row" if item.count == 1 else f"{item.count} rows"
        yield f"{rows} left out, {item.reason}"
    yield from test.record.notes
    yield from test.curve.notes
    yield from test.judged.remarks


def _listed(files: Sequence[str]) -> str:
    if len(files) > _FEW:
        return f"{len(files)} tests, as {files[0]}"
    return ", ".join(files)
