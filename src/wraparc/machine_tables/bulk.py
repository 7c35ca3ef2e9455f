"""The quick way through rows of a table: their bytes at once, odd cells one by one.

A piece goes this way only if every line has as many cells as the table; what is in a cell that is
no plain number is read by the careful rules. Anything else is left to the careful way, which
gives the same numbers cell by cell.
"""

import re
import warnings
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from wraparc.arrays import Array, Flags, Integers
from wraparc.machine_tables.numerals import NumeralStyle, contradicts, looks_numeric, number_of

_END, _BLANK, _TAB = 10, 32, 9
# What a comma between thousands cannot look like, where the point is the decimal sign.
_BAD_GROUP = re.compile(
    r",(?:(?!\d{3}(?!\d))|(?<!\d,)|(?<=\d{4},)|(?<=\.\d,)|(?<=\.\d{2},)|(?<=\.\d{3},)"
    r"|(?<=\D0,)|(?<=\D0\d,)|(?<=\D0\d\d,))"
)
# Bytes of text without white space that ends a cell between blanks, but is no blank.
_KNOWN = np.zeros(256, dtype=bool)
_KNOWN[[_TAB, _END, *range(_BLANK, 127)]] = True


class OtherSignError(ValueError):
    """Cells prove another decimal sign than the table was found to have."""


def read_bulk(
    lines: Sequence[str], delimiter: str, width: int, style: NumeralStyle
) -> Array | None:
    """Return the numbers of rows, NaN where there is none; None where the careful way is needed.

    Parameters
    ----------
    lines
        Rows of a table, none of them empty.
    delimiter
        What stands between the cells; a blank stands for any run of blanks.
    width
        Number of cells of a row.
    style
        Decimal sign.

    Returns
    -------
    Shape (rows, width).

    Raises
    ------
    OtherSignError
        If a cell proves that the decimal sign is the other one.
    """
    plain = "\n".join(lines).replace("\u2212", "-")
    block, sign = _unquoted(plain, delimiter, width, len(lines))
    if style.decimal == "." and sign != "," and "," in block and not _BAD_GROUP.search(block):
        block = block.replace(",", "")
    data = block.encode() + b"\n"
    codes = np.frombuffer(data, dtype=np.uint8)
    if sign == " " and not _KNOWN[codes].all():
        return None
    starts, ends, tokens = _cells(codes, sign, width, len(lines))
    if starts is None or ends is None or tokens is None:
        return None
    odd = tokens != 1
    bad = ~_plain_bytes(sign, style)[codes]
    if bad.any():
        odd |= np.add.reduceat(bad, starts, dtype=np.int32) > 0
    values = _parsed(codes, starts, ends, odd, sign, style)
    if values is None:
        return None
    numeric = ~odd
    if not _read_odd(data, starts, ends, odd, values, numeric, style):
        return None
    if np.any(numeric.reshape(-1, width).sum(axis=1) < 2):
        return None
    return np.where(np.isfinite(values), values, np.nan).reshape(-1, width)


def _cells(
    codes: NDArray[np.uint8], sign: str, width: int, rows: int
) -> tuple[Integers | None, Integers | None, NDArray[np.int32] | None]:
    """First byte of each cell, the byte behind it, and the words in it; None if rows differ."""
    stop = codes == _END if sign == " " else (codes == _END) | (codes == ord(sign))
    blank = codes == _BLANK if sign == "\t" else (codes == _BLANK) | (codes == _TAB)
    if not blank.any():
        ends = np.flatnonzero(stop)
        starts = np.concatenate([[0], ends[:-1] + 1])
        if sign == " " or not _same_rows(codes, ends, width, rows):
            return None, None, None
        return starts, ends, (ends > starts).astype(np.int32)
    inside = ~(blank | stop)
    first = inside.copy()
    first[1:] &= ~inside[:-1]
    if sign == " ":
        starts = np.flatnonzero(first)
        last = inside.copy()
        last[:-1] &= ~inside[1:]
        ends = np.flatnonzero(last) + 1
        line_ends = np.flatnonzero(codes == _END)
        if len(starts) != width * rows or np.any(
            np.searchsorted(starts, line_ends) != width * np.arange(1, rows + 1)
        ):
            return None, None, None
        return starts, ends, np.ones(len(starts), dtype=np.int32)
    ends = np.flatnonzero(stop)
    if not _same_rows(codes, ends, width, rows):
        return None, None, None
    starts = np.concatenate([[0], ends[:-1] + 1])
    return starts, ends, np.add.reduceat(first, starts, dtype=np.int32)


def _same_rows(codes: NDArray[np.uint8], ends: Integers, width: int, rows: int) -> bool:
    """Whether every row has `width` cells: the line ends are as many as rows, one each."""
    return len(ends) == width * rows and bool(np.all(codes[ends[width - 1 :: width]] == _END))


def _plain_bytes(sign: str, style: NumeralStyle) -> Flags:
    """Bytes of plain numbers, and what stands between them."""
    good = np.zeros(256, dtype=bool)
    good[list(b"0123456789+-eE \n" + style.decimal.encode() + sign.encode())] = True
    if sign != "\t":
        good[_TAB] = True
    return good


def _parsed(
    codes: NDArray[np.uint8],
    starts: Integers,
    ends: Integers,
    odd: Flags,
    sign: str,
    style: NumeralStyle,
) -> Array | None:
    """Numbers of all cells that are not odd; None if one of them is none."""
    values = np.full(len(starts), np.nan)
    plain = ~odd
    if not plain.any():
        return values
    between = np.arange(256, dtype=np.uint8)
    between[ord(sign)] = _BLANK
    if style.decimal == ",":
        between[ord(",")] = ord(".")
    text = between[codes]
    filled = np.flatnonzero(odd & (ends > starts))
    if len(filled):
        # +1 where such a cell starts, -1 where it ends
        marks = np.zeros(len(codes) + 1, dtype=np.int8)
        marks[starts[filled]] += 1
        marks[ends[filled]] -= 1
        text[np.cumsum(marks[:-1], dtype=np.int8).astype(bool)] = _BLANK
    with warnings.catch_warnings():
        warnings.simplefilter("error", DeprecationWarning)
        try:
            found = np.fromstring(text.tobytes(), sep=" ")
        except (DeprecationWarning, ValueError):
            return None
    # each plain cell gives one number at least: as many as cells is one each
    if len(found) != np.count_nonzero(plain):
        return None
    values[plain] = found
    return values


def _read_odd(
    data: bytes,
    starts: Integers,
    ends: Integers,
    odd: Flags,
    values: Array,
    numeric: Flags,
    style: NumeralStyle,
) -> bool:
    """Fill in cells that are no plain numbers; False if their quotes need the careful way."""
    known: dict[bytes, tuple[float, bool]] = {}
    for k in np.flatnonzero(odd & (ends > starts)).tolist():
        raw = data[starts[k] : ends[k]]
        if raw not in known:
            cell = raw.decode().strip()
            if '"' in cell:
                if len(cell) < 2 or cell.count('"') != 2 or cell[0] != '"' or cell[-1] != '"':
                    return False
                cell = cell[1:-1].strip()
            known[raw] = number_of(cell, style), looks_numeric(cell)
            if known[raw][1] and contradicts([[cell]], style):
                raise OtherSignError
        values[k], numeric[k] = known[raw]
    return True


def _unquoted(block: str, delimiter: str, width: int, rows: int) -> tuple[str, str]:
    """Take the quotes off where every cell stands in them; a tab then stands between cells."""
    if delimiter == " " or block.count('"') != 2 * width * rows or "\t" in block:
        return block, delimiter
    joined = block.replace(f'"{delimiter}"', "\t").replace('"\n"', "\n")
    if joined[0] != '"' or joined[-1] != '"' or '"' in joined[1:-1]:
        return block, delimiter
    return joined[1:-1], "\t"
