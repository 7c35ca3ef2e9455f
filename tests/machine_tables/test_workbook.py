"""Workbooks that unpack to more than a test can need are refused before they are read."""

import io
import struct
import tracemalloc
import zipfile
from pathlib import Path

import numpy as np
import pytest

from wraparc.errors import InputError
from wraparc.machine_tables import NumeralStyle, workbook
from wraparc.machine_tables.workbook import tables_in_workbook


def archive(content: bytes) -> bytes:
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as made:
        made.writestr("xl/worksheets/sheet1.xml", content)
    return out.getvalue()


@pytest.mark.parametrize("lies", [False, True], ids=["honest", "lying"])
def test_what_unpacks_to_too_much_is_refused_without_unpacking_it(
    monkeypatch: pytest.MonkeyPatch, *, lies: bool
) -> None:
    monkeypatch.setattr(workbook, "MOST_UNPACKED", 20_000_000)
    packed = archive(b" " * 60_000_000)
    assert len(packed) < 100_000
    if lies:  # says in both places that it is small
        at = packed.index(b"PK\x01\x02")
        packed = packed[: at + 24] + struct.pack("<I", 100) + packed[at + 28 :]
        packed = packed[:22] + struct.pack("<I", 100) + packed[26:]
    tracemalloc.start()
    with pytest.raises(InputError, match="unpacks to more than 100 times its"):
        tables_in_workbook(packed, "bomb.xlsx")
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 10_000_000


def test_a_workbook_of_ordinary_size_is_read() -> None:
    import xlsxwriter

    out = io.BytesIO()
    book = xlsxwriter.Workbook(out)
    sheet = book.add_worksheet()
    sheet.write_row(0, 0, ["travel [mm]", "force [N]"])
    for row in range(1, 200):
        sheet.write_row(row, 0, [0.1 * row, 10.0 * row])
    book.close()
    assert tables_in_workbook(out.getvalue(), "test.xlsx")


def far(*cells: str) -> bytes:
    import xlsxwriter

    out = io.BytesIO()
    book = xlsxwriter.Workbook(out)
    sheet = book.add_worksheet()
    for cell in cells:
        sheet.write(cell, 1.0)
    book.close()
    return out.getvalue()


@pytest.mark.parametrize(
    ("cells", "reach"),
    [
        (("A1", "XFD1048576"), "row 1048576, column 16384"),
        (("A1048576", "S1"), "row 1048576, column 19"),
        (("ALM1",), "row 1, column 1001"),
    ],
)
def test_a_sheet_with_a_cell_far_away_is_refused_before_it_is_read(
    cells: tuple[str, ...], reach: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The first of these ended the process; the second took 1.4 GB."""
    monkeypatch.setattr(workbook, "_read", None)
    with pytest.raises(InputError, match=f"reaches {reach}: more than 4 million cells"):
        tables_in_workbook(far(*cells), "far.xlsx")


def test_what_the_library_does_to_its_process_stays_there(monkeypatch: pytest.MonkeyPatch) -> None:
    """Without the look before, the library aborts: 1.7e10 cells are to be stored."""
    monkeypatch.setattr(workbook, "_check_archive", lambda *_: None)
    with pytest.raises(
        InputError, match="cannot be opened as workbook: damaged, or larger than a test"
    ):
        tables_in_workbook(far("A1", "XFD1048576"), "far.xlsx")


def test_a_ratio_that_no_sheet_has_is_refused() -> None:
    packed = archive(b" " * 12_000_000)
    with pytest.raises(InputError, match="more than 100 times its"):
        tables_in_workbook(packed, "bomb.xlsx")


def test_cells_of_every_kind_come_through_as_they_are() -> None:
    import datetime as dt

    import xlsxwriter

    out = io.BytesIO()
    book = xlsxwriter.Workbook(out)
    sheet = book.add_worksheet("Größe")
    dated = book.add_format({"num_format": "yyyy-mm-dd"})
    sheet.write_row(0, 1, ["Weg [mm]", "Kraft [N]", "Tag", "gut"])
    for k in range(1, 12):
        sheet.write_row(k, 1, [0.1 * k, 1e300 if k == 5 else 10.0 * k])
        sheet.write_datetime(k, 3, dt.datetime(2026, 1, k), dated)  # noqa: DTZ001 - a workbook has none
        sheet.write_boolean(k, 4, True)
    book.close()
    (table,) = tables_in_workbook(out.getvalue(), "kinds.xlsx", "Größe")
    assert table.header == (("", "Weg [mm]", "Kraft [N]", "Tag", "gut"),)
    assert table.columns[1][:2] == (0.1, 0.2)
    assert str(table.columns[3][0]).startswith("2026-01-01")
    assert table.columns[4][0] is True
    assert np.isnan(table.numbers(4, NumeralStyle())).all()
    assert np.isnan(table.numbers(2, NumeralStyle())[4])


def test_an_entity_of_a_workbook_reads_no_file(tmp_path: Path) -> None:
    # a sheet whose text is an external entity (XXE): the file that it names is in no cell, no word
    secret = tmp_path / "secret.txt"
    secret.write_text("9876543", "utf-8")
    out = io.BytesIO()
    entity = f'<!DOCTYPE x [<!ENTITY e SYSTEM "{secret.as_uri()}">]>'
    with zipfile.ZipFile(io.BytesIO(far("A1", "B2"))) as old, zipfile.ZipFile(out, "w") as new:
        for name in old.namelist():
            text = old.read(name).decode("utf-8")
            if name.endswith("sheet1.xml"):
                assert "<v>1</v>" in text
                head, _, rest = text.partition("?>")
                text = f"{head}?>{entity}{rest.replace('<v>1</v>', '<v>&e;</v>')}"
            new.writestr(name, text)
    try:
        told = repr(tables_in_workbook(out.getvalue(), "entity.xlsx"))
    except InputError as error:
        told = str(error)
    assert "9876543" not in told
