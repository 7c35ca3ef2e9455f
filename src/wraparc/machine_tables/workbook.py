"""Excel workbooks to raw tables, by python-calamine."""

import io
import struct
import zipfile
import zlib
from collections.abc import Sequence

from wraparc.errors import InputError, MissingExtraError, Problem
from wraparc.machine_tables.tables import RawTable, tables_in_rows

#: Most bytes that a workbook may unpack to, and most cells of a sheet: far beyond any test.
MOST_UNPACKED, MOST_CELLS = 250_000_000, 20_000_000
_CHUNK = 1 << 20
_REMEDY = "Save it again from the spreadsheet program as .xlsx, or export the sheet as CSV."


def tables_in_workbook(data: bytes, file: str, sheet: str | None = None) -> list[RawTable]:
    """Find every table on every sheet (or on the one named `sheet`).

    Raises
    ------
    InputError
        If the workbook cannot be opened (damaged, encrypted, another kind of archive), has no
        such sheet, or unpacks to more than a test can need.
    MissingExtraError
        If python-calamine is not installed.
    """
    try:
        import python_calamine
    except ImportError:
        raise MissingExtraError("python-calamine", "fit") from None
    _check_unpacked(data, file)
    try:
        book = python_calamine.CalamineWorkbook.from_filelike(io.BytesIO(data))
        names = list(book.sheet_names)
    except (python_calamine.CalamineError, OSError, ValueError) as error:
        raise _unreadable(file, error) from None
    if sheet is not None and sheet not in names:
        listed = ", ".join(repr(name) for name in names)
        raise InputError(
            Problem(
                message=f"there is no such sheet; the workbook has {listed}",
                remedy="Name one of these.",
                file=file,
                key="sheet",
                value=repr(sheet),
            )
        )
    found: list[RawTable] = []
    for name in [sheet] if sheet is not None else names:
        try:
            content = book.get_sheet_by_name(name)
            if content.total_height * content.total_width > MOST_CELLS:
                raise InputError(_too_large(file, f"sheet {name!r} has more cells than a test"))
            rows = content.to_python(skip_empty_area=False)
        except (python_calamine.CalamineError, OSError, ValueError) as error:
            raise _unreadable(file, error) from None
        found.extend(tables_in_rows(_squared(rows), name))
    return found


def _check_unpacked(data: bytes, file: str) -> None:
    """Unpack an archive piece by piece without keeping it: what it says of its size may be a lie.

    Raises
    ------
    InputError
        If it unpacks to more than `MOST_UNPACKED`.
    """
    if not data.startswith(b"PK"):
        return
    left = MOST_UNPACKED
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            for part in archive.infolist():
                # name and extra field have their lengths in the header before the data
                name, extra = struct.unpack_from("<HH", data, part.header_offset + 26)
                begin = part.header_offset + 30 + name + extra
                packed = data[begin : begin + part.compress_size]
                left -= _unpacked_size(packed, left) if part.compress_type else len(packed)
                if left < 0:
                    raise InputError(_too_large(file, "the workbook unpacks to too much"))
    except (zipfile.BadZipFile, zlib.error, struct.error, NotImplementedError, ValueError) as error:
        if isinstance(error, InputError):
            raise
        raise _unreadable(file, error) from None


def _unpacked_size(packed: bytes, most: int) -> int:
    """Return how large a deflated part is [bytes], or a size beyond `most`."""
    stream, size = zlib.decompressobj(-zlib.MAX_WBITS), 0
    while packed and size <= most and not stream.eof:
        size += len(stream.decompress(packed, _CHUNK))
        packed = stream.unconsumed_tail
    return size


def _too_large(file: str, message: str) -> Problem:
    limit = f"at most {MOST_UNPACKED / 1e6:g} MB and {MOST_CELLS / 1e6:g} million cells are read"
    remedy = "Export the sheet with the test as CSV."
    return Problem(message=f"{message}; {limit}", remedy=remedy, file=file)


def _squared(rows: Sequence[Sequence[object]]) -> list[list[object]]:
    width = max(map(len, rows), default=0)
    return [[*row, *[""] * (width - len(row))] for row in rows]


def _unreadable(file: str, error: Exception) -> InputError:
    said = str(error).splitlines()[0][:80] if str(error) else type(error).__name__
    return InputError(
        Problem(message=f"the workbook cannot be opened ({said})", remedy=_REMEDY, file=file)
    )
