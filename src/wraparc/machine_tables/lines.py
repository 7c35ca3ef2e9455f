"""Lines of text to cells: quotes, and the delimiter that makes a table of them."""

import csv
import re
from collections import Counter
from collections.abc import Callable, Sequence

from wraparc.machine_tables.numerals import looks_numeric

_DELIMITERS = ("\t", ";", "|", ",", " ")
DELIMITER_NAMES = {"\t": "tab", ";": "semicolon", "|": "bar", ",": "comma", " ": "blanks"}
_SAMPLE, _LONG, _TABS = 200, 5000, 0.6
_WHOLE_LINE_QUOTED = re.compile(r'"(?:[^"]|"")*"')


def unwrapped(lines: list[str]) -> list[str]:
    """Take off the quotes of lines that stand in quotes as a whole."""
    sample = [line.strip() for line in lines[:: max(1, len(lines) // _SAMPLE)] if line.strip()]
    whole = sum(_is_wrapped(line) for line in sample)
    if not sample or whole < 0.6 * len(sample):
        return lines
    return [
        line.strip()[1:-1].replace('""', '"') if _is_wrapped(line.strip()) else line
        for line in lines
    ]


def _is_wrapped(line: str) -> bool:
    inner = line[1:-1]
    return (
        _WHOLE_LINE_QUOTED.fullmatch(line) is not None
        and any(d in inner for d in _DELIMITERS)
        and not looks_numeric(inner)
    )


def splitter(delimiter: str) -> Callable[[str], list[str]]:
    """Return what cuts a line at a delimiter."""
    if delimiter == " ":
        return str.split

    def split(line: str) -> list[str]:
        if '"' not in line:
            return line.split(delimiter)
        # A lone quote is a sign for inch or a mistake: such a line is taken literally.
        if line.count('"') % 2:
            return line.split(delimiter)
        try:
            return next(csv.reader([line], delimiter=delimiter, skipinitialspace=True))
        except (csv.Error, StopIteration):
            return line.split(delimiter)

    return split


def split_all(lines: Sequence[str], delimiter: str) -> list[list[str]]:
    """Return the cells of every line."""
    if delimiter != " " and any('"' in line for line in lines[:: max(1, len(lines) // 50)]):
        balanced = [line if line.count('"') % 2 == 0 else line.replace('"', "") for line in lines]
        try:
            rows = list(csv.reader(balanced, delimiter=delimiter, skipinitialspace=True))
        except csv.Error:
            rows = []
        # The reader passes over nothing and joins nothing where quotes are balanced.
        if len(rows) == len(lines):
            return rows
    return list(map(splitter(delimiter), lines))


def delimiter_of(lines: Sequence[str]) -> str | None:
    """Return the delimiter that cuts most lines into as many cells, or None."""
    later = lines[len(lines) // 4 :] if len(lines) > 40 else lines
    thinned = later[:: max(1, len(later) // _SAMPLE)]
    sample = [line[:_LONG] for line in thinned if any(c.isdigit() for c in line[:_LONG])]
    fits = {sign: _fit_of(sample, sign) for sign in _DELIMITERS}
    if fits["\t"] > _TABS * fits[" "]:
        fits[" "] = 0.0  # a tab is a blank too; blanks in the cells group digits there
    best = max(fits, key=lambda sign: fits[sign])
    return best if fits[best] > 0.0 else None


def _fit_of(sample: Sequence[str], delimiter: str) -> float:
    """Share of the lines that are rows of one width, times the share of numbers in them."""
    split = splitter(delimiter)
    widths: Counter[int] = Counter()
    shares: dict[int, float] = {}
    for line in sample:
        cells = [cell for cell in split(line) if cell.strip()]
        numeric = sum(map(looks_numeric, cells))
        if numeric >= 2:
            widths[len(cells)] += 1
            shares[len(cells)] = shares.get(len(cells), 0.0) + numeric / len(cells)
    if not widths:
        return 0.0
    width = max(widths, key=lambda w: shares[w])
    return shares[width] / len(sample)
