"""Clock times as control systems write them, many at once.

``2026-03-01 06:00:00.5``, ``28.11.2026 06:00``, ``3/1/2026 6:00:00 AM``, ``01-Mar-26 06:00:00``,
each with or without an offset from UTC. Whether the day or the month comes first is proven by the
dates themselves, or asked for.
"""

import re
from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from wraparc.arrays import Array, Flags, Integers
from wraparc.errors import shown
from wraparc.machine_tables.limits import refused

DAY = 86400.0
_MONTHS = {
    name: number
    for number, names in enumerate(
        (
            "jan", "feb", "mar mär mrz", "apr", "may mai", "jun", "jul", "aug", "sep", "oct okt",
            "nov", "dec dez",
        ),
        start=1,
    )
    for name in names.split()
}  # fmt: skip
_CLOCK = re.compile(
    r"\s*(?:(?P<y>\d{4})[-/.](?P<m>\d{1,2})[-/.](?P<d>\d{1,2})"
    r"|(?P<a>\d{1,2})(?P<sep>[-/.])(?P<b>\d{1,2})[-/.](?P<z>\d{4}|\d{2})"
    r"|(?P<e>\d{1,2})[- ](?P<name>[^\W\d_]{3})[a-z]*\.?[- ](?P<w>\d{4}|\d{2}))"
    r"(?:(?:T|,?\s+)(?P<H>\d{1,2}):(?P<M>\d{2})(?::(?P<S>\d{2})(?:[.,](?P<f>\d{1,9}))?)?"
    r"\s*(?P<half>[AaPp]\.?[Mm]\.?)?\s*(?P<off>Z|UTC|(?P<os>[+-])(?P<oh>\d{2}):?(?P<om>\d{2})?)?)?\s*"
)
_LONGEST, _MOST_FORMS = 40, 400
_DIGIT = np.zeros(256, dtype=bool)
_DIGIT[ord("0") : ord("9") + 1] = True


def looks_like_clock(cell: str) -> bool:
    """Whether a cell reads as a date, with its time of the day or without."""
    return len(cell) <= _LONGEST and _CLOCK.fullmatch(cell) is not None


def has_offset(cell: str) -> bool:
    """Whether a clock time states its offset from UTC."""
    match = _CLOCK.fullmatch(cell)
    return bool(match and match["off"])


def read_clocks(cells: Sequence[str], file: str, order: str = "") -> Array:
    """Return clock times in seconds since 1970, nan where a cell is none [s].

    Times without an offset are taken as they stand; with one they are UTC.

    Parameters
    ----------
    cells
        As written.
    file
        For the error.
    order
        ``day first`` or ``month first``, where the dates do not prove it.

    Raises
    ------
    InputError
        If nothing shows whether day or month comes first.
    """
    texts = np.array([cell.strip()[:_LONGEST] for cell in cells])
    codes = np.ascontiguousarray(np.char.encode(texts, "latin-1", "replace"))
    if codes.size == 0:
        return np.empty(0)
    width = max(1, codes.dtype.itemsize)
    table = codes.view(np.uint8).reshape(len(codes), width)
    parts = np.full((5, len(codes)), np.nan)  # year, first, second, seconds of the day, kind
    left = np.ones(len(codes), dtype=bool)
    for _ in range(_MOST_FORMS):
        rest = np.flatnonzero(left)
        if not len(rest):
            break
        first = str(texts[rest[0]])
        match = _CLOCK.fullmatch(first)
        if match is None:
            left[rest[0]] = False
            left &= ~_alike(table, table[rest[0]], left)
            continue
        same = _alike(table, table[rest[0]], left)
        _read_form(parts, match, table, same)
        left &= ~same
    return _seconds(parts, file, order)


def _alike(table: NDArray[np.uint8], form: NDArray[np.uint8], left: Flags) -> Flags:
    """Rows that differ from one of them in its digits alone."""
    digits = _DIGIT[form]
    alike = left.copy()
    places = np.flatnonzero(left)
    rows = table[places]
    alike[places] = np.all(np.where(digits, _DIGIT[rows], rows == form), axis=1)
    return alike


def _read_form(parts: Array, match: re.Match[str], table: NDArray[np.uint8], rows: Flags) -> None:
    """Read the rows of one form into year, month or first, day or second, seconds, kind, half."""
    block = table[rows].astype(np.int64) - ord("0")

    def number(group: str) -> Integers:
        found = np.zeros(len(block), dtype=np.int64)
        start, stop = match.span(group)
        for place in range(start, stop):
            found = 10 * found + block[:, place]
        return found

    if match["y"]:
        year, first, second, kind = number("y"), number("m"), number("d"), 0
    elif match["name"]:
        month = _MONTHS.get(match["name"].casefold(), 0)
        year, second, kind = number("w"), number("e"), 0
        first = np.full(len(block), month)
    else:
        kind = 1 if match["sep"] == "." else 3 if match["half"] else 2
        year, first, second = number("z"), number("a"), number("b")
    year = np.where(year < 100, 2000 + year, year)
    of_day = _seconds_of_day(match, number) if match["H"] else np.zeros(len(block))
    parts[0, rows], parts[1, rows], parts[2, rows] = year, first, second
    parts[3, rows], parts[4, rows] = of_day, kind


def _seconds_of_day(match: re.Match[str], number: Callable[[str], Integers]) -> Array:
    """Return the seconds of the day, less the offset from UTC where one is stated."""
    hour = number("H")
    if match["half"]:
        hour = hour % 12 + (12 if match["half"][0] in "pP" else 0)
    seconds = 3600.0 * hour + 60.0 * number("M")
    if match["S"]:
        seconds = seconds + number("S")
    if match["f"]:
        seconds = seconds + number("f") / 10.0 ** len(match["f"])
    if match["oh"]:
        shift = 3600.0 * number("oh") + (60.0 * number("om") if match["om"] else 0.0)
        seconds = seconds + shift if match["os"] == "-" else seconds - shift
    return np.asarray(seconds, dtype=float)


def _seconds(parts: Array, file: str, order: str) -> Array:
    """Return the seconds since 1970 of years, months, days, as the dates prove their order."""
    year, first, second, seconds, kind = parts[:5]
    open_ = np.nan_to_num(kind) > 0
    month, day = first.copy(), second.copy()
    if open_.any():
        day_first = _day_first(parts, open_, file, order)
        month[open_], day[open_] = (
            (second[open_], first[open_]) if day_first else (first[open_], second[open_])
        )
    with np.errstate(invalid="ignore"):
        good = (month >= 1) & (month <= 12) & (day >= 1) & (day <= 31)
    found = np.full(len(year), np.nan)
    found[good] = DAY * _days(year[good], month[good], day[good]) + seconds[good]
    return found


def _day_first(parts: Array, open_: Flags, file: str, order: str) -> bool:
    if order:
        return order == "day first"
    year, a, b, _, kind = (part[open_] for part in parts[:5])
    if a.max() > 12 or b.max() > 12:
        return bool(a.max() > 12)
    if kind.max() == 1:  # with points the day comes first everywhere
        return True
    spans = [np.ptp(_days(year, m, d)) for m, d in ((b, a), (a, b))]
    if min(spans) * 5 < max(spans):  # one reading has rows months apart
        return bool(spans[0] < spans[1])
    sample = f"{a[0]:02.0f}/{b[0]:02.0f}/{year[0]:.0f}"
    raise refused(
        file, "day and month are unclear", 'Write dates = "day first" or "month first".',
        key="time", value=shown(sample),
    )  # fmt: skip


def _days(year: Array, month: Array, day: Array) -> Array:
    """Days from 1970-01-01 in the Gregorian calendar (years from March on)."""
    y = year - (month <= 2)
    era = np.floor(y / 400.0)
    of_era = y - 400.0 * era
    of_year = np.floor((153.0 * (month + np.where(month > 2, -3.0, 9.0)) + 2.0) / 5.0) + day - 1.0
    days = 365.0 * of_era + np.floor(of_era / 4.0) - np.floor(of_era / 100.0) + of_year
    return np.asarray(146097.0 * era + days - 719468.0)
