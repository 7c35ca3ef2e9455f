"""Workbooks that unpack to more than a test can need are refused before they are read."""

import io
import struct
import tracemalloc
import zipfile

import pytest

from wraparc.errors import InputError
from wraparc.machine_tables import workbook
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
    with pytest.raises(InputError, match="unpacks to too much"):
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


def test_a_sheet_with_a_cell_far_away_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    import xlsxwriter

    monkeypatch.setattr(workbook, "MOST_CELLS", 1_000)
    out = io.BytesIO()
    book = xlsxwriter.Workbook(out)
    book.add_worksheet().write(500, 500, "here")
    book.close()
    with pytest.raises(InputError, match="more cells"):
        tables_in_workbook(out.getvalue(), "far.xlsx")
