"""The quick way through a long, clean table: NumPy's own text reader, behind a guard.

A block goes this way only if every character of it is of a number, a delimiter or a line
end, its decimal sign is proven, and every row has the same number of cells. Anything else
is left to the careful way, which gives the same numbers cell by cell.
"""

import io
import re
from dataclasses import dataclass

import numpy as np

from wraparc.errors import InputError
from wraparc.machine_tables.numerals import Array, NumeralStyle, style_of

_SAMPLE = 2000
_NUMERIC = b"0123456789+-.eE\n"
# What a comma between thousands cannot look like, where the point is the decimal sign.
_BAD_GROUP = re.compile(
    r",(?:(?!\d{3}(?!\d))|(?<!\d,)|(?<=\d{4},)|(?<=\.\d,)|(?<=\.\d{2},)|(?<=\.\d{3},)"
    r"|(?<=\D0,)|(?<=\D0\d,)|(?<=\D0\d\d,))"
)


@dataclass(frozen=True, eq=False)
class Bulk:
    """Numbers of a block, and the decimal sign they were written with."""

    values: Array
    style: NumeralStyle


def read_bulk(block: str, delimiter: str, width: int) -> Bulk | None:
    """Convert a block of lines at once, or return None where the careful way is needed.

    Parameters
    ----------
    block
        Lines of a table without its header, a line end between them.
    delimiter
        What stands between the cells; a blank stands for any run of blanks.
    width
        Number of cells of a row.
    """
    block, front, back = _numeric_part(block, delimiter)
    width -= front + back
    plain, sign = _unquoted(block, delimiter, width)
    if plain is None or not plain.isascii():
        return None
    style = _style(plain[: _sample_end(plain)], sign)
    if style is None:
        return None
    if style.decimal == ",":
        if "." in plain or sign == ",":
            return None
        plain = plain.replace(",", ".")
    elif sign != "," and "," in plain:
        if _BAD_GROUP.search("\n" + plain):
            return None
        plain = plain.replace(",", "")
    if plain.encode().translate(None, _NUMERIC + sign.encode()):
        return None
    try:
        values = np.loadtxt(
            io.StringIO(plain),
            delimiter=None if sign == " " else sign,
            comments=None,
            ndmin=2,
        )
    except ValueError:
        return None
    if values.shape != (plain.count("\n") + 1, width):
        return None
    values = np.pad(values, ((0, 0), (front, back)), constant_values=np.nan)
    return Bulk(np.where(np.isfinite(values), values, np.nan), style)


def _numeric_part(block: str, delimiter: str) -> tuple[str, int, int]:
    """Take off an empty first column, and a last one of the same text in every row.

    Returns
    -------
    block
        Without them.
    front, back
        How many columns were taken off, 0 or 1 each.
    """
    if delimiter == " ":
        return block, 0, 0
    gaps, front, back = block.count("\n"), 0, 0
    if block.startswith(delimiter) and block.count(f"\n{delimiter}") == gaps:
        block, front = block[1:].replace(f"\n{delimiter}", "\n"), 1
    line = block[: block.find("\n")] if gaps else block
    end = line[line.rfind(delimiter) :]
    text = any(c.isalpha() and c not in "eE" for c in end)
    if text and block.endswith(end) and block.count(f"{end}\n") == gaps:
        block, back = block.removesuffix(end).replace(f"{end}\n", "\n"), 1
    return block, front, back


def _unquoted(block: str, delimiter: str, width: int) -> tuple[str | None, str]:
    if '"' not in block:
        return block, delimiter
    rows = block.count("\n") + 1
    if delimiter == " " or block.count('"') != 2 * width * rows or "\t" in block:
        return None, delimiter
    joined = block.replace(f'"{delimiter}"', "\t").replace('"\n"', "\n")
    if joined[0] != '"' or joined[-1] != '"' or '"' in joined[1:-1]:
        return None, delimiter
    return joined[1:-1], "\t"


def _sample_end(plain: str) -> int:
    end = -1
    for _ in range(_SAMPLE):
        following = plain.find("\n", end + 1)
        if following < 0:
            return len(plain)
        end = following
    return end


def _style(sample: str, sign: str) -> NumeralStyle | None:
    split = str.split if sign == " " else (lambda line: line.split(sign))
    rows = [split(line) for line in sample.split("\n")]
    if len(set(map(len, rows))) != 1:
        return None
    try:
        return style_of(list(zip(*rows, strict=True)), "")
    except InputError:
        return None
