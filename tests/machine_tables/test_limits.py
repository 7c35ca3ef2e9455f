"""Files that are more than a test can need are refused with a sentence, and at once.

Each of these took 20 s and more, or half a gigabyte, before there were limits; that they are not
read is what is tested, for a test must not look at the clock.
"""

import random

import pytest

from machine_tables.asked import problems
from wraparc.machine_tables import limits, lines, tables, text
from wraparc.shear_test import read_machine_bytes


@pytest.mark.parametrize(
    ("data", "sentence"),
    [
        (b"1,1,1\n" + b"1," * 32_000, "line 2: has 32001 cells, more than 1000"),
        (b"1.5," * 1_000_000, "line 1: has 4000000 characters, more than 100000"),
        (b"1 " * 1_001, "line 1: has 1001 cells"),
        (b"1" * 200_000 + b",2\n", "line 1: has 200002 characters"),
    ],
    ids=["cells", "characters", "blanks", "digits"],
)
def test_lines_beyond_a_test(data: bytes, sentence: str, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: object, **__: object) -> None:
        raise AssertionError("it was read")

    monkeypatch.setattr(text, "careful_tables", refuse)
    assert sentence in problems(data)


def test_a_line_as_long_as_allowed_is_read() -> None:
    rows = "\n".join(";".join([f"{0.1 * k:.1f}", f"{2 * k}", *["1"] * 998]) for k in range(12))
    data = f"Weg [mm];Kraft [N]{';x' * 998}\n{rows}\n".encode()
    assert len(read_machine_bytes(data, "x").travel) == 12


def test_rows_of_changing_width() -> None:
    pick = random.Random(1)  # noqa: S311 - a table, not a secret
    rows = [",".join(["1"] * pick.randrange(2, 12)) for _ in range(40_000)]
    said = problems("\n".join(rows).encode())
    assert "its rows change their number of cells more than 1000 times" in said


def test_what_can_only_be_read_cell_by_cell_is_limited(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(text, "MOST_LOOSE_CELLS", 5_000)
    rows = [f"{0.1 * k:.2f};{2 * k:.1f}" for k in range(3000)]
    assert len(read_machine_bytes(f"mm;N\n{chr(10).join(rows)}\n".encode(), "x").travel) == 3000
    rows[2000] = "0,15;2,5"
    assert "contains 6000 cells in no plain table, more than 5000." in problems(
        "\n".join(rows).encode()
    )


def test_the_work_on_a_line_is_limited_where_the_delimiter_is_looked_for() -> None:
    long = "1," * 50_000
    assert lines.delimiter_of([long, long]) == ","
    assert tables.careful_tables(["a(" * 40_000, "1 2", "1 2"], " ")[0].rows == 2
    assert limits.LONGEST_LINE >= 100 * limits.MOST_COLUMNS
