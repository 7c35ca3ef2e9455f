"""Excel workbooks to raw tables, by python-calamine."""

import io
from collections.abc import Sequence

from wraparc.errors import InputError, MissingExtraError, Problem
from wraparc.machine_tables.tables import RawTable, tables_in_rows

_REMEDY = "Save it again from the spreadsheet program as .xlsx, or export the sheet as CSV."


def tables_in_workbook(data: bytes, file: str, sheet: str | None = None) -> list[RawTable]:
    """Find every table on every sheet (or on the one named `sheet`).

    Raises
    ------
    InputError
        If the workbook cannot be opened (damaged, encrypted, another kind of archive), or
        has no such sheet.
    MissingExtraError
        If python-calamine is not installed.
    """
    try:
        import python_calamine
    except ImportError:
        raise MissingExtraError("python-calamine", "fit") from None
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
            rows = book.get_sheet_by_name(name).to_python(skip_empty_area=False)
        except (python_calamine.CalamineError, OSError, ValueError) as error:
            raise _unreadable(file, error) from None
        found.extend(tables_in_rows(_squared(rows), name))
    return found


def _squared(rows: Sequence[Sequence[object]]) -> list[list[object]]:
    width = max(map(len, rows), default=0)
    return [[*row, *[""] * (width - len(row))] for row in rows]


def _unreadable(file: str, error: Exception) -> InputError:
    said = str(error).splitlines()[0][:80] if str(error) else type(error).__name__
    return InputError(
        Problem(message=f"the workbook cannot be opened ({said})", remedy=_REMEDY, file=file)
    )
