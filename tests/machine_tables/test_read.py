"""Tables out of machine files: signs, quotes, encodings, sheets, as the reader of shear tests asks.

Expected values: the small hand-written files carry their numbers in the test.
"""

import io
from collections.abc import Sequence

import numpy as np
import pytest
import xlsxwriter

from machine_tables.asked import problems
from wraparc.shear_test import (
    Choices,
    read_machine_bytes,
)


def test_an_ambiguous_comma_is_asked_about() -> None:
    table = "\n".join(f"1,{k:03d};2,{k:03d}" for k in range(100, 112))
    data = f"Weg [mm];Kraft [N]\n{table}\n".encode()
    assert "2,100 may be 2.100 or 2100" in problems(data) or "1,100 may be" in problems(data)
    one = read_machine_bytes(data, "x", Choices(decimal=","))
    other = read_machine_bytes(data, "x", Choices(decimal="."))
    assert one.travel[0] == pytest.approx(1.1e-3)
    assert other.travel[0] == pytest.approx(1.1)


def test_decimal_commas_between_delimiting_commas_are_refused() -> None:
    table = "\n".join(f"0,{k},1,{k}" for k in range(1, 20))
    text = problems(f"Extension (mm),Load (N)\n{table}\n".encode())
    assert "its 4 columns of whole numbers look split at decimal commas" in text
    # where they are not, it is told that the names do not fit
    table = "\n".join(f"0.5,{k},-1.5,{k}" for k in range(1, 20))
    text = problems(f"Extension (mm),Load (N)\n{table}\n".encode())
    assert "2 names stand above 4 columns" in text


def test_thousands_in_quotes() -> None:
    table = "\n".join(f'"{0.5 * k:.2f}","{1234.5 * k:,.2f}"' for k in range(12))
    record = read_machine_bytes(f"Extension,Load\n(mm),(N)\n{table}\n".encode(), "x")
    np.testing.assert_allclose(record.force, 1234.5 * np.arange(12))


def test_lines_wholly_in_quotes_and_doubled_quotes() -> None:
    table = "\n".join(f'"{0.5 * k:.2f};{k:.1f}"' for k in range(12))
    record = read_machine_bytes(f'"Weg [mm];Kraft [N]"\n{table}\n'.encode(), "x")
    np.testing.assert_allclose(record.force, np.arange(12.0))


def test_several_tables_say_which_was_read() -> None:
    head = "Extension (mm),Load (N)\n"
    short = "\n".join(f"{k},{k}" for k in range(3))
    long = "\n".join(f"{k},{2 * k}" for k in range(30))
    data = f"{head}{short}\n\nSecond part\n{head}{long}\n".encode()
    record = read_machine_bytes(data, "x")
    assert len(record.travel) == 30
    assert "number 2, lines 8 to 37, was read" in record.notes[0]
    assert len(read_machine_bytes(data, "x", Choices(table=1)).travel) == 3
    assert "table: has 2 tables, got 3. Write a number from 1 to 2." in problems(
        data, Choices(table=3)
    )


def test_marks_of_the_machine_are_dropped_with_their_line() -> None:
    table = "\n".join(f"{k / 10},{k}" for k in range(1, 31))
    data = f"Extension (mm),Load (N)\n{table}\n0,0\n".encode()
    record = read_machine_bytes(data, "x")
    assert len(record.travel) == 30
    assert (record.dropped[0].count, record.dropped[0].line) == (1, 32)
    data = f"Extension (mm),Load (N)\n{table}\n-9999,-9999\n".encode()
    assert len(read_machine_bytes(data, "x").travel) == 30


@pytest.mark.parametrize("word", ["NaN", "inf", "1e999", "1_0", "0x1F", "#DIV/0!", "--", ""])
def test_what_is_no_number_is_dropped_and_counted(word: str) -> None:
    lines = [f"{k / 10},{k},1" for k in range(1, 31)]
    lines[9] = f"1.0,{word},1"
    record = read_machine_bytes(
        ("Extension (mm),Load (N),Time (s)\n" + "\n".join(lines) + "\n").encode(), "x"
    )
    assert len(record.travel) == 29
    assert sum(item.count for item in record.dropped) == 1
    assert record.dropped[0].line == 11


@pytest.mark.parametrize(
    "encoding", ["utf-8", "utf-8-sig", "utf-16", "utf-16-le", "utf-16-be", "cp1252", "latin-1"]
)
@pytest.mark.parametrize("end", ["\n", "\r\n", "\r", "\r\r\n"])
def test_encodings_and_line_ends(encoding: str, end: str) -> None:
    lines = [
        "Prüfung;groß",
        "Verlängerung [mm];Prüfkraft [N]",
        *(f"{k};{2 * k}" for k in range(20)),
    ]
    record = read_machine_bytes(end.join([*lines, ""]).encode(encoding), "x")
    np.testing.assert_array_equal(record.force, 2.0 * np.arange(20))
    assert [column.name for column in record.columns] == ["Verlängerung", "Prüfkraft"]


def test_central_european_letters() -> None:
    lines = ["Przemieszczenie [mm];Siła [N];Prędkość", *(f"{k};{2 * k};3" for k in range(20))]
    record = read_machine_bytes("\n".join(lines).encode("cp1250"), "x")
    assert [column.name for column in record.columns][1:] == ["Siła", "Prędkość"]


def workbook(rows: Sequence[Sequence[object]]) -> bytes:
    stream = io.BytesIO()
    with xlsxwriter.Workbook(stream, {"in_memory": True}) as book:
        book.add_worksheet("Cover").write(0, 0, "nothing here")
        sheet = book.add_worksheet("Raw")
        for k, row in enumerate(rows):
            sheet.write_row(k, 1, row)
    return stream.getvalue()


def test_a_workbook_with_the_data_on_another_sheet() -> None:
    head: list[Sequence[object]] = [["Operator", "A"], [], ["Travel (mm)", "Load (kN)"]]
    data = workbook(head + [(0.5 * k, 2.0 * k) for k in range(20)])
    record = read_machine_bytes(data, "book.xlsx")
    np.testing.assert_allclose(record.force, 2000.0 * np.arange(20))
    assert "'Raw'" in record.place
    assert 'sheet: no such sheet, got "raw". Did you mean "Raw"?' in problems(
        data, Choices(sheet="raw")
    )


def test_a_long_file_goes_the_quick_way_to_the_same_numbers() -> None:
    # The careful way, forced by one cell that only it reads, is the independent computation.
    lines = [f"{0.01 * k:.2f};{0.003 * k:.3f};{1.5 * k - 3:.1f}" for k in range(1000)]
    head = "Time (s);Extension (mm);Load (N)\n"
    quick = read_machine_bytes((head + "\n".join(lines) + "\n").encode(), "x")
    lines[500] = lines[500].replace(";", "; ", 1).replace("5.00", "+5.00")
    careful = read_machine_bytes((head + "\n".join(lines) + "\n").encode(), "x")
    np.testing.assert_array_equal(quick.travel, careful.travel)
    np.testing.assert_array_equal(quick.force, careful.force)


@pytest.mark.parametrize(
    ("header", "choices"),
    [
        ("1;2;3", Choices(travel=1, force=2, units={"1": "mm", "2": "N"})),
        ("0;1;2", Choices(travel="0", force="1", units={"0": "mm", "1": "N"})),
        ("1;2;3\nmm;N;s", Choices(travel=1, force=2)),
        ("Travel [mm];Force [N];100;200", Choices()),
        ("Travel [mm];100;Force [N];200", Choices()),
    ],
)
def test_names_that_are_numbers_are_names(header: str, choices: Choices) -> None:
    """They were read as the first reading, and the names were lost."""
    width = header.split("\n", maxsplit=1)[0].count(";") + 1
    force = 2 if "100;Force" in header else 1
    rows = []
    for k in range(20):
        cells = ["7.5"] * width
        cells[0], cells[force] = f"{0.25 * k:.2f}", f"{10.5 * k:.1f}"
        rows.append(";".join(cells))
    record = read_machine_bytes((header + "\n" + "\n".join(rows) + "\n").encode(), "x", choices)
    np.testing.assert_allclose(record.travel, 0.25e-3 * np.arange(20))
    np.testing.assert_allclose(record.force, 10.5 * np.arange(20))
    assert record.dropped == ()


def test_a_first_reading_with_a_gap_is_no_header() -> None:
    rows = "\n".join(f"{0.25 * k:.2f};{10.5 * k:.1f};7.5" for k in range(1, 20))
    record = read_machine_bytes(f"Weg [mm];Kraft [N];T\n0;0;OVL\n{rows}\n".encode(), "x")
    assert len(record.travel) == 20


@pytest.mark.parametrize("count", [40, 12_000])
def test_a_header_that_is_repeated_in_the_file_is_counted(count: int) -> None:
    """Pages of a logger; what follows was lost as a table of its own."""
    rows = [f"{0.1 * k:.1f};{0.25 * k:.2f};{10.5 * k:.1f}" for k in range(count)]
    head = ["Time;Extension;Load", "s;mm;N"]
    half = count // 2 + 3
    text = "\n".join([*head, *rows[:half], *head, *rows[half:], ""])
    record = read_machine_bytes(text.encode(), "x")
    np.testing.assert_allclose(record.force, 10.5 * np.arange(count))
    assert [(d.reason, d.line) for d in record.dropped] == [
        ("the header again", half + 3),
        ("the header again", half + 4),
    ]


def test_tests_under_each_other_are_not_made_one() -> None:
    rows = [f"{0.1 * k:.1f};{0.25 * k:.2f};{10.5 * k:.1f}" for k in range(40)]
    one = ["Time;Extension;Load", "s;mm;N", *rows]
    record = read_machine_bytes("\n".join([*one, *one, ""]).encode(), "x")
    assert len(record.travel) == 40
    assert "the file has 2 tables" in record.notes[0]


def test_settings_are_no_readings() -> None:
    settings = "\n".join(f"Channel {name};{k};{2 * k}" for k, name in enumerate("abcdefghijklmnop"))
    head = "Name;Load [N];Displacement [mm]\n"
    said = problems((head + settings + "\n").encode())
    assert "contains settings or results in lines 2 to 17, no readings" in said
    assert len(read_machine_bytes((head + settings).encode(), "x", Choices(table=1)).force) == 16
    rows = "\n".join(f"{0.1 * k:.1f};{0.25 * k:.2f}" for k in range(12))
    both = f"{head}{settings}\n\nWeg [mm];Kraft [N]\n{rows}\n"
    assert len(read_machine_bytes(both.encode(), "x").travel) == 12
