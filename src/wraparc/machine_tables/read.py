"""Files of machines to raw tables: text with any delimiter and encoding, Excel workbooks."""

import stat
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from wraparc.errors import shown
from wraparc.machine_tables.limits import LARGEST_FILE, refused
from wraparc.machine_tables.lines import DELIMITER_NAMES, split_all, splitter, unwrapped
from wraparc.machine_tables.sniff import decode, is_workbook
from wraparc.machine_tables.tables import RawTable, refuse_units_in_cells
from wraparc.machine_tables.text import tables_in_text
from wraparc.machine_tables.workbook import tables_in_workbook


@dataclass(frozen=True, eq=False)
class TableFile:
    """The tables of a file, and how it is written.

    Parameters
    ----------
    tables
        In the order of the file.
    encoding
        Python's name of it, ``"workbook"`` for Excel.
    notes
        What had to be passed over, as sentences.
    """

    tables: list[RawTable]
    encoding: str
    notes: tuple[str, ...] = ()


def read_bytes(path: str | Path, remedy: str = "") -> bytes:
    """Return what a plain file of at most 200 MB holds.

    Raises
    ------
    InputError
        If there is none, or it is something else; `remedy` says what to give instead.
    """
    name, place = str(path), Path(path)
    try:
        status = place.stat()
        if stat.S_ISREG(status.st_mode) and status.st_size <= LARGEST_FILE:
            return place.read_bytes()
    except FileNotFoundError:
        raise refused(name, "file not found", "") from None
    except (OSError, ValueError) as error:
        said = getattr(error, "strerror", None) or "its name cannot be used"
        raise refused(name, f"cannot be read: {said}", "Check the path.") from None
    if stat.S_ISDIR(status.st_mode):
        raise refused(name, "is a folder", "Name a file in it.")
    large = stat.S_ISREG(status.st_mode)
    message = "is larger than 200 MB" if large else "is not a plain file"
    raise refused(name, message, remedy)


def find_tables(
    data: bytes,
    file: str,
    *,
    encoding: str | None = None,
    delimiter: str | None = None,
    sheet: str | None = None,
) -> TableFile:
    """Find every table in the bytes of a file.

    Parameters
    ----------
    data, file
        The file, and its name for errors.
    encoding, delimiter, sheet
        What the user says of it: Python's name of the encoding, a delimiter by its name or as it
        is, the sheet of a workbook. Found by content if left out.

    Raises
    ------
    InputError
        If the file cannot be understood, or what is said of it is unknown.
    """
    if is_workbook(data):
        return TableFile(tables_in_workbook(data, file, sheet), "workbook")
    decoded = decode(data, file, encoding)
    sign = None if delimiter is None else _delimiter(delimiter, file)
    tables = tables_in_text(decoded.text, delimiter=sign, ended=decoded.ended, file=file)
    if not tables:
        lines = decoded.text.splitlines()[:200]
        signs = [sign] if sign else [s for s in DELIMITER_NAMES if s != " "]
        for each in signs:
            refuse_units_in_cells(split_all(lines, each), file)
    return TableFile(tables, decoded.encoding, decoded.notes)


def column_words(data: bytes, table: RawTable, place: int, encoding: str) -> list[str]:
    """Return the cells of a column as text, also of a long table, which keeps its numbers only.

    Parameters
    ----------
    data, encoding
        The file, and Python's name of its encoding.
    table, place
        One of its tables, and the column, counted from 0.
    """
    cells = table.columns[place]
    if not isinstance(cells, np.ndarray):
        return ["" if cell is None else str(cell) for cell in cells]
    lines = unwrapped(decode(data, "", encoding).text.split("\n"))
    split = splitter(table.delimiter)
    rows = [split(lines[line - 1]) for line in table.lines.tolist()]
    return [row[place] if place < len(row) else "" for row in rows]


def _delimiter(given: str, file: str) -> str:
    named = {name: sign for sign, name in DELIMITER_NAMES.items()}
    sign = named.get(given, given)
    if sign in DELIMITER_NAMES:
        return sign
    raise refused(
        file,
        "no such delimiter",
        f"Write one of {', '.join(named)}.",
        key="delimiter",
        value=shown(given),
    )
