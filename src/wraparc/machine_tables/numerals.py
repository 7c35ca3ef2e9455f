"""Numbers as machines write them, and the proof of what a comma or a point means.

``1,234`` is 1.234 in one country and 1234 in another. A file usually proves which it is
(``0,512`` cannot be thousands, ``1,234.5`` must be); where it does not, the caller asks.
"""

import math
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cache

import numpy as np

from wraparc.arrays import Array
from wraparc.errors import InputError, Problem

# Blanks (also the no-break and the narrow ones) and apostrophes group digits in threes.
_GROUP = "'’ \u00a0\u2009\u202f"
_SIGN = r"[+\-\u2212]?"
_EXPONENT = r"(?:[eE][+\-]?\d{1,3})?"
_NUMBER_LIKE = re.compile(
    rf"{_SIGN}(?:\d{{1,3}}(?:[.,{_GROUP}]\d{{3}})+(?:[.,]\d*)?|\d+(?:[.,]\d*)?|[.,]\d+){_EXPONENT}",
    re.ASCII,
)
_PLAIN_CHARACTERS = frozenset("0123456789+-.eE \n")
_LARGEST = 1e300


@dataclass(frozen=True)
class NumeralStyle:
    """How numbers are written.

    Parameters
    ----------
    decimal
        ``"."`` or ``","``.
    proof
        The cell that shows it, as found in the file; empty if nothing had to be shown.
    """

    decimal: str = "."
    proof: str = ""


def looks_numeric(cell: str) -> bool:
    """Whether `cell` reads as a number in one style or the other."""
    return _NUMBER_LIKE.fullmatch(cell.strip()) is not None


def _decimal_proof(sign: str) -> re.Pattern[str]:
    s, other = re.escape(sign), re.escape("," if sign == "." else ".")
    return re.compile(
        rf"^[ \t]*{_SIGN}(?:"
        rf"0*{s}\d+|"  # 0,5 or ,5: thousands have no leading zero
        rf"\d{{4,}}{s}\d+|"  # 1234,5
        rf"\d+{s}(?:\d{{1,2}}|\d{{4,}})|"  # not three digits behind it
        rf"\d+{s}\d+[eE][+\-]?\d+|"
        rf"\d{{1,3}}(?:[{_GROUP}{other}]\d{{3}})+{s}\d*"  # behind groups of three
        rf"){_EXPONENT}[ \t]*$",
        re.MULTILINE | re.ASCII,
    )


def _thousands_proof(sign: str) -> re.Pattern[str]:
    s, other = re.escape(sign), re.escape("," if sign == "." else ".")
    return re.compile(
        rf"^[ \t]*{_SIGN}[1-9]\d{{0,2}}"
        rf"(?:(?:{s}\d{{3}}){{2,}}(?:{other}\d*)?|{s}\d{{3}}{other}\d*)[ \t]*$",
        re.MULTILINE | re.ASCII,
    )


_DECIMAL = {sign: _decimal_proof(sign) for sign in ".,"}
_THOUSANDS = {sign: _thousands_proof(sign) for sign in ".,"}


def style_of(columns: Iterable[Sequence[str]], file: str, remedy: str = "") -> NumeralStyle:
    """Find the decimal sign that the cells of some columns prove.

    Parameters
    ----------
    columns
        Cells as written, column by column.
    file, remedy
        For the error: where the cells stand, and how to name the sign.

    Raises
    ------
    InputError
        If the cells contradict each other or allow both readings: the decimal sign must
        then be named.
    """
    texts = ["\n".join(column) for column in columns]
    present = [sign for sign in ".," if any(sign in text for text in texts)]
    decimal = {sign: _found(_DECIMAL[sign], texts) for sign in present}
    proven = [sign for sign in present if decimal[sign]]
    if not present:
        return NumeralStyle()
    if len(proven) == 1:
        return NumeralStyle(proven[0], decimal[proven[0]])
    if not proven:
        # Groups such as 1.234.567 tell what the sign is not.
        grouped = {sign: _found(_THOUSANDS[sign], texts) for sign in present}
        for sign in present:
            if grouped[sign] and not any(grouped[s] for s in present if s != sign):
                return NumeralStyle("," if sign == "." else ".", grouped[sign])
    raise InputError(_undecided(present, decimal, texts, file, remedy))


def _found(pattern: re.Pattern[str], texts: Sequence[str]) -> str:
    for text in texts:
        match = pattern.search(text)
        if match:
            return match.group().strip()
    return ""


def contradicts(columns: Iterable[Sequence[str]], style: NumeralStyle) -> bool:
    """Whether cells prove the other decimal sign."""
    other = _DECIMAL["," if style.decimal == "." else "."]
    return any(other.search("\n".join(column)) for column in columns)


def _undecided(
    present: Sequence[str], decimal: dict[str, str], texts: Sequence[str], file: str, remedy: str
) -> Problem:
    if len(present) == 2 and all(decimal.values()):
        said = f"both {decimal['.']} and {decimal[',']} occur"
    else:
        sign = present[-1]
        cell = next(c for text in texts for c in text.split("\n") if sign in c).strip()
        said = f"{cell} may be {cell.replace(sign, '.')} or {cell.replace(sign, '')}"
    return Problem(
        message=f"decimal sign unclear: {said}",
        remedy=remedy or "Export it with decimal points.",
        file=file,
    )


def numbers(cells: Sequence[object] | Array, style: NumeralStyle) -> Array:
    """Convert one column; what is no finite number in `style` becomes NaN.

    Parameters
    ----------
    cells
        Text as written, or the numbers of a workbook.
    style
        The decimal sign. Groups of three by the other sign, blanks or apostrophes are read.
    """
    if isinstance(cells, np.ndarray):
        return cells
    texts = [cell for cell in cells if isinstance(cell, str)]
    if not texts and all(type(cell) is float for cell in cells):
        values = np.array(cells, dtype=float)
        return np.where(np.abs(values) < _LARGEST, values, np.nan)
    if len(texts) < len(cells):
        return np.array([_cell_number(cell, style) for cell in cells], dtype=float)
    plain = "\n".join(texts).replace("\u2212", "-")
    if style.decimal == "," and "." not in plain:
        plain = plain.replace(",", ".")
    elif style.decimal == ",":
        return np.array([number_of(cell, style) for cell in texts], dtype=float)
    parts = plain.split("\n")
    if set(plain) <= _PLAIN_CHARACTERS and len(parts) == len(texts):
        try:
            values = np.array(list(map(float, parts)))
        except ValueError:
            pass
        else:
            return np.where(np.isfinite(values), values, np.nan)
    return np.array([number_of(cell, style) for cell in texts], dtype=float)


def _cell_number(cell: object, style: NumeralStyle) -> float:
    if isinstance(cell, str):
        return number_of(cell, style)
    if isinstance(cell, bool) or not isinstance(cell, int | float):
        return math.nan
    return float(cell) if abs(cell) < _LARGEST else math.nan


@cache
def _grammar(decimal: str) -> re.Pattern[str]:
    d, other = re.escape(decimal), re.escape("," if decimal == "." else ".")
    groups = "|".join(rf"[1-9]\d{{0,2}}(?:{g}\d{{3}})+" for g in (*_GROUP, other))
    return re.compile(rf"({_SIGN})((?:{groups}|\d+)(?:{d}\d*)?|{d}\d+)({_EXPONENT})", re.ASCII)


def number_of(cell: str, style: NumeralStyle) -> float:
    """Return the number of one cell as text, NaN if it is none."""
    match = _grammar(style.decimal).fullmatch(cell.strip())
    if match is None:
        return math.nan
    sign, digits, exponent = match.groups()
    digits = "".join(c for c in digits if c.isdigit() or c == style.decimal)
    value = float(digits.replace(",", ".") + exponent)
    return math.nan if value > _LARGEST else -value if sign in {"-", "\u2212"} else value
