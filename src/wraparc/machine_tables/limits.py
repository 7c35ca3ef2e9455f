"""What a file of a test may need at most; beyond it a file is refused before it is read.

Far beyond any test, and near enough that no file, whatever is in it, takes a computer down. Ours.
"""

from wraparc.errors import InputError, input_error

#: Of a file [bytes], of a line [characters], and of the cells in one.
LARGEST_FILE, LONGEST_LINE, MOST_COLUMNS = 200_000_000, 100_000, 1000
#: Tables of a file, and cells that can only be read one by one.
MOST_TABLES, MOST_LOOSE_CELLS = 1000, 3_000_000
#: What a workbook may unpack to [bytes], how often its own size, and how large for any ratio.
MOST_UNPACKED, MOST_RATIO, SMALL_UNPACKED = 250_000_000, 100.0, 10_000_000
#: Cells of the rectangle that a sheet fills, and columns of it.
MOST_CELLS, MOST_SHEET_COLUMNS = 4_000_000, 1000

_REMEDY = "Export one row a reading."


def refused(
    file: str, message: str, remedy: str, *, key: str = "", value: str = "", line: int | None = None
) -> InputError:
    """Return the error of a file: what is wrong with it, and what to do."""
    return input_error(message=message, remedy=remedy, file=file, key=key, value=value, line=line)


def beyond(message: str, file: str, line: int | None = None, remedy: str = _REMEDY) -> InputError:
    """Return the error of a file that is more than a test can need."""
    return refused(file, message, remedy, line=line)
