"""Excel workbooks to raw tables, by python-calamine in a process of its own."""

import importlib.util
import io
import json
import re
import struct
import subprocess
import sys
import zipfile
import zlib
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from wraparc.errors import InputError, MissingExtraError, name_remedy, shown
from wraparc.machine_tables.limits import (
    MOST_CELLS,
    MOST_RATIO,
    MOST_SHEET_COLUMNS,
    MOST_UNPACKED,
    SMALL_UNPACKED,
    beyond,
    refused,
)
from wraparc.machine_tables.tables import RawTable, tables_in_rows

_CHUNK, _OVERLAP, _SECONDS = 1 << 20, 40, 60
_REMEDY = "Save it anew as .xlsx, or export it as CSV."
_CSV = "Export the sheet as CSV."
_SHEETS = re.compile(r"worksheets/[^/]*\.xml$", re.IGNORECASE)
_PLACE = re.compile(rb'\sr\s*=\s*["\']([A-Z]{0,3})(\d{1,7})["\']')


def tables_in_workbook(data: bytes, file: str, sheet: str | None = None) -> list[RawTable]:
    """Find every table on every sheet (or on the one named `sheet`).

    Raises
    ------
    InputError
        If the workbook cannot be opened (damaged, encrypted, another kind of archive), has no
        such sheet, or is more than a test can need.
    MissingExtraError
        If python-calamine is not installed.
    """
    found = importlib.util.find_spec("python_calamine")
    if found is None or found.origin is None:
        raise MissingExtraError("python-calamine", "fit")
    _check_archive(data, file)
    told = _read(data, file, str(Path(found.origin).parents[1]), sheet)
    if "error" in told:
        raise _unreadable(file, str(told["error"]))
    if "large" in told:
        raise beyond(_too_many(f"sheet {shown(told['large'])} has"), file, remedy=_CSV)
    if "sheets" not in told:
        raise refused(
            file,
            "no such sheet",
            name_remedy(sheet, told["names"]),
            key="sheet",
            value=shown(sheet),
        )
    return [
        table
        for name, rows in told["sheets"]
        for table in tables_in_rows(_squared(rows), name, file)
    ]


def _read(data: bytes, file: str, folder: str, sheet: str | None) -> dict[str, Any]:
    """Let another process read the workbook, for the library can end the one it works in."""
    script = str(Path(__file__).with_name("workbook_process.py"))
    named = [] if sheet is None else [sheet]
    try:
        done = subprocess.run(  # noqa: S603 - our own script
            [sys.executable, "-I", script, folder, str(MOST_CELLS), *named],
            input=data,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            timeout=_SECONDS,
            check=False,
            creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0),
        )
        told = json.loads(done.stdout)
    except subprocess.TimeoutExpired:
        raise _unreadable(file, f"reading it takes more than {_SECONDS} s") from None
    except (OSError, ValueError):  # a name with a zero byte; no answer
        raise _unreadable(file, "damaged, or larger than a test can need") from None
    return told if isinstance(told, dict) else {}


def _check_archive(data: bytes, file: str) -> None:
    """Unpack an archive piece by piece without keeping it: what it says of its size may be a lie.

    Raises
    ------
    InputError
        If it unpacks to too much, or a sheet has a cell too far away.
    """
    if not data.startswith(b"PK"):
        return
    size = 0
    most = min(MOST_UNPACKED, max(SMALL_UNPACKED, MOST_RATIO * len(data)))
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            for part in archive.infolist():
                extent = _Extent(part.filename) if _SHEETS.search(part.filename) else None
                for piece in _unpacked(data, part):
                    size += len(piece)
                    if size > most:
                        raise beyond(_unpacks(len(data)), file, remedy=_CSV)
                    if extent is not None and extent.is_beyond(piece):
                        raise beyond(_too_many(str(extent)), file, remedy=_CSV)
    except (zipfile.BadZipFile, zlib.error, struct.error, NotImplementedError, ValueError) as error:
        if isinstance(error, InputError):
            raise
        raise _unreadable(file, str(error)) from None


def _unpacked(data: bytes, part: zipfile.ZipInfo) -> Iterator[bytes]:
    """Yield a part of an archive in pieces of at most a megabyte."""
    # name and extra field have their lengths in the header before the data
    name, extra = struct.unpack_from("<HH", data, part.header_offset + 26)
    begin = part.header_offset + 30 + name + extra
    packed = data[begin : begin + part.compress_size]
    if not part.compress_type:
        yield from (packed[k : k + _CHUNK] for k in range(0, len(packed), _CHUNK))
        return
    stream = zlib.decompressobj(-zlib.MAX_WBITS)
    while packed and not stream.eof:
        yield stream.decompress(packed, _CHUNK)
        packed = stream.unconsumed_tail


class _Extent:
    """How far the cells of a sheet reach, as its text names them."""

    def __init__(self, name: str) -> None:
        self._name = name
        self._columns, self._rows, self._tail = 1, 1, b""

    def is_beyond(self, piece: bytes) -> bool:
        """Whether the cells named so far fill more than a sheet may have."""
        text = self._tail + piece
        self._tail = text[-_OVERLAP:]
        for letters, digits in set(_PLACE.findall(text)):
            self._columns = max(self._columns, _column(letters))
            self._rows = max(self._rows, int(digits))
        return self._columns > MOST_SHEET_COLUMNS or self._columns * self._rows > MOST_CELLS

    def __str__(self) -> str:
        """Which sheet, and how far it reaches."""
        return f"{shown(self._name)} reaches row {self._rows}, column {self._columns}:"


def _column(letters: bytes) -> int:
    number = 0
    for letter in letters:
        number = 26 * number + letter - 64
    return number


def _unpacks(size: int) -> str:
    return (
        f"unpacks to more than {MOST_RATIO:g} times its {size / 1e6:.3g} MB,"
        f" or than {MOST_UNPACKED / 1e6:g} MB"
    )


def _too_many(what: str) -> str:
    return f"{what} more than {MOST_CELLS / 1e6:g} million cells or {MOST_SHEET_COLUMNS} columns"


def _squared(rows: Sequence[Sequence[object]]) -> list[list[object]]:
    width = max(map(len, rows), default=0)
    return [[*row, *[""] * (width - len(row))] for row in rows]


def _unreadable(file: str, said: str) -> InputError:
    first = said.splitlines()[0][:80] if said else "damaged"
    return refused(file, f"cannot be opened as workbook: {first}", _REMEDY)
