"""What reads a workbook, in a process of its own: the library may end its process.

Started as a script with the folder of python-calamine, most cells of a sheet and a sheet's name
(or nothing); takes the workbook from standard input and writes JSON: sheets and rows, or an error.
It imports nothing of the project, so that it starts at once.
"""

import io
import json
import sys
from contextlib import suppress
from typing import Any

#: Most memory of the process [bytes] and time that it may work [s], where the system can limit.
_MEMORY, _SECONDS = 1_500_000_000, 60


def _limit() -> None:
    try:
        import resource
    except ImportError:  # Windows
        return
    for kind, most in ((resource.RLIMIT_AS, _MEMORY), (resource.RLIMIT_CPU, _SECONDS)):
        soft, hard = resource.getrlimit(kind)
        if soft == resource.RLIM_INFINITY or soft > most:
            with suppress(OSError, ValueError):  # macOS limits no memory
                resource.setrlimit(kind, (most, hard))


def read_sheets(data: bytes, most: int, sheet: str | None) -> dict[str, Any]:
    """Return names and rows of the sheets, or of the one named; hidden ones only if named."""
    from python_calamine import CalamineWorkbook, SheetVisibleEnum

    book = CalamineWorkbook.from_filelike(io.BytesIO(data))
    names = list(book.sheet_names)
    hidden = {s.name for s in book.sheets_metadata if s.visible != SheetVisibleEnum.Visible}
    if sheet is not None and sheet not in names:
        return {"names": names}
    sheets = []
    seen = [name for name in names if name not in hidden] or names
    for name in seen if sheet is None else [sheet]:
        content = book.get_sheet_by_name(name)
        if content.total_height * content.total_width > most:
            return {"large": name}
        sheets.append((name, content.to_python(skip_empty_area=False)))
    return {"names": names, "sheets": sheets}


def main() -> None:
    """Read one workbook."""
    folder, most, *sheet = sys.argv[1:]
    _limit()
    sys.path.append(folder)
    try:
        found = read_sheets(sys.stdin.buffer.read(), int(most), sheet[0] if sheet else None)
        told = json.dumps(found, default=str)
    except Exception as error:  # noqa: BLE001 - whatever it is, it is told and the process ends
        told = json.dumps({"error": str(error) or type(error).__name__})
    sys.stdout.write(told)


if __name__ == "__main__":
    main()
