"""Quantities in texts of which no system of units is chosen yet, and the choice at the very end.

A cell is a text: the slot that a number leaves open in a sentence, so that sentences are written as
any other, ``f"Creep {creep} exceeds {limit}"``. `in_units` fills the slots in; nothing else does.
"""

import math
import re
from collections.abc import Callable, Iterable, Iterator
from functools import lru_cache
from typing import Literal, Self, get_args

from wraparc.units.digits import (
    NOTHING,
    RESULT_DIGITS,
    as_typed,
    decimals,
    every_digit,
    every_limit_digit,
    grouped,
    rounded_limit,
    with_error,
)
from wraparc.units.display import System, display, display_unit, joined, parts, unit_row
from wraparc.units.parse import unit_factor
from wraparc.units.table import DIMENSIONS, Dimension

#: What stands where there is no number.
NONE = "-"
_UNBOUNDED = "infinite"
#: How a cell is shown: with its unit; without, as under a head that has it; the unit alone; as a
#: share [%]; rounded to the safe side, upwards or down; as a speed of slip; in as many digits as
#: tell it from another number; a limit, a maximum rounded down and a minimum up, and a value that
#: misses it, both in as many digits as tell them apart; from another number to it,
#: ``0 to 22.5 deg`` or ``0-22.5 deg``, that rounded up or down, or as a maximum, ``150 of 210 kN``;
#: under a head with its unit, half its interval behind it, ``1.29 ± 0.01``; with so many digits
#: behind the point, plain or as a share, its sign always told or not; a count or money in
#: thousands, ``12,843``; a given number with all digits that it was typed with.
Form = Literal[
    "", "bare", "unit", "percent", "up", "bare up", "down", "slip", "apart", "slip apart",
    "maximum", "minimum", "exceeds", "below", "to", "-", "to up", "to down", "of",
    "bare error", "fixed", "signed", "percent fixed", "percent signed", "grouped", "typed",
]  # fmt: skip
#: Forms of two numbers, which a range begins and ends with.
RANGES: tuple[Form, ...] = ("to", "-", "to up", "to down", "of")
#: Digits of numbers that differ: no more are needed to tell them apart.
MOST_DIGITS = 9
_FORMS = frozenset(get_args(Form))
#: A text for each system of units, of which the one that is shown is taken.
_EITHER = re.compile("\x04([^\x04-\x06]*)\x05([^\x04-\x06]*)\x06")
#: No digits at all only where they are counted behind the point.
_DIGITS = "[1-9][0-9]?|0(?=[|](?:percent )?(?:fixed|signed)[|])"
_SLOT = re.compile(
    f"\x02([a-z_]+)[|]({_DIGITS})[|]([a-z -]*)[|]([^|\x03]+)[|]([^|\x03]+)[|]([a-z0-9_]*)\x03"
)


class Cell(str):
    """A number [SI] with what it measures: the slot that stands for it in a text.

    Attributes
    ----------
    value
        The number [SI].
    dimension
        What it measures.
    digits
        Significant digits; digits behind the point where the form has these.
    form
        How it is shown, see `Form`.
    other
        Number [SI] that it is told from, that a range begins at, or half its interval; nan without
        one.
    name
        Name in the glossary, or empty.
    """

    __slots__ = ("digits", "dimension", "form", "name", "other", "value")
    value: float
    dimension: Dimension
    digits: int
    form: Form
    other: float
    name: str

    def __new__(
        cls,
        value: float,
        dimension: Dimension,
        digits: int = RESULT_DIGITS,
        form: Form = "",
        other: float = math.nan,
        name: str = "",
    ) -> Self:
        """Return the cell of a number."""
        value, other = float(value), float(other)  # those of NumPy are written otherwise
        slot = f"\x02{dimension}|{digits}|{form}|{value!r}|{other!r}|{name}\x03"
        cell = super().__new__(cls, slot)
        cell.value, cell.dimension, cell.digits = value, dimension, digits
        cell.form, cell.other, cell.name = form, other, name
        return cell

    def text(self, system: System) -> str:
        """Return the number as people of a system of units write it."""
        of = self.value, self.dimension, self.digits, self.form, self.other
        return cell_text(*of, system)


#: Speeds below that are of slip [m/s].
_SLOW = 0.1


def cell_text(
    value: float, dimension: Dimension, digits: int, form: Form, other: float, system: System
) -> str:
    """Return what a cell of such a value shows, see `Cell`."""
    row = unit_row(dimension, system)
    if form == "unit":
        return row.unit
    if form in ("percent", "percent fixed", "percent signed"):
        return _share(value, digits, form) + " %"
    if form in ("bare", "bare up", "bare error", "fixed", "signed", "grouped"):
        return _bare(value / row.factor, digits, form, other / row.factor)
    if form in ("apart", "slip apart"):
        return _apart(value, dimension, digits, other, system, form == "slip apart")
    if form in ("exceeds", "below", "maximum", "minimum"):
        return _missed(value, dimension, digits, form, other, system)
    if form in ("to", "-", "to up", "to down", "of"):
        return _range(value, dimension, digits, form, other, system)
    if form == "typed":
        return joined(_typed(value, dimension, system, digits))
    if form in ("up", "down"):
        return joined(_limit(value, dimension, system, digits, form == "up"))
    return joined(_told(value, dimension, system, digits, form == "slip"))


def _share(value: float, digits: int, form: Form) -> str:
    """Return a share in hundredths."""
    if form == "percent":
        return display(100.0 * value, "number", "si", digits)
    return decimals(100.0 * value, digits, form == "percent signed")


def _bare(number: float, digits: int, form: Form, other: float) -> str:
    """Return a number without a unit."""
    if form == "bare error":
        return with_error(number, other)
    if form == "bare up":
        return rounded_limit(number, digits, True)
    if form in ("fixed", "signed"):
        return decimals(number, digits, form == "signed")
    if form == "grouped" and math.isfinite(number):
        return grouped(decimals(number, 0, False))
    return display(number, "number", "si", digits)


def _told(
    number: float, dimension: Dimension, system: System, digits: int, slow: bool
) -> tuple[str, str]:
    """Return number and unit; a slow speed, where it may be one of slip, in mm/s."""
    if not math.isfinite(number):
        return NONE if math.isnan(number) else _UNBOUNDED, ""
    if slow and dimension == "speed" and abs(number) < _SLOW:
        unit, size = _slow_unit(system)
        return display(number / size, "number", system, digits), unit
    return parts(number, dimension, system, digits)


def _typed(number: float, dimension: Dimension, system: System, digits: int) -> tuple[str, str]:
    """Return a given number as typed, and its unit; rounded where its unit is another."""
    text, unit = _told(number, dimension, system, digits, False)
    return as_typed(_in_unit(number, dimension, system, unit), text), unit


def _slow_unit(system: System) -> tuple[str, float]:
    return ("mm/s", 1e-3) if system == "si" else ("in/s", 0.0254)


def _limit(
    number: float, dimension: Dimension, system: System, digits: int, up: bool
) -> tuple[str, str]:
    """Return number and unit of a limit, rounded up or down."""
    text, unit = _told(number, dimension, system, digits, True)
    if not math.isfinite(number) or abs(number) < NOTHING:
        return text, unit
    return rounded_limit(_in_unit(number, dimension, system, unit), digits, up), unit


def _in_unit(number: float, dimension: Dimension, system: System, unit: str) -> float:
    """Return a number in the unit that `_told` shows it with."""
    row = unit_row(dimension, system)
    slow, size = _slow_unit(system)
    if dimension == "speed" and unit == slow:
        return number / size
    for _, other, factor, zero in row.larger:
        if unit == other:
            return (number - zero) / factor
    return number / row.factor


def _missed(
    value: float, dimension: Dimension, digits: int, form: Form, other: float, system: System
) -> str:
    """Return a limit, or a value that misses it, in as many digits as tell both apart."""
    is_limit, up = form in ("maximum", "minimum"), form in ("minimum", "below")
    limit, compared = (value, other) if is_limit else (other, value)
    plain = _limit(limit, dimension, system, digits, up)
    if math.isnan(other) or not (math.isfinite(value) and math.isfinite(other)):
        return joined(plain if is_limit else _told(value, dimension, system, digits, True))
    told = _told(compared, dimension, system, digits, True)
    if joined(plain) != joined(told):
        return joined(plain if is_limit else told)
    for more in range(digits + 1, MOST_DIGITS + 1):
        first = every_limit_digit(_in_unit(limit, dimension, system, told[1]), more, up)
        second = every_digit(_in_unit(compared, dimension, system, told[1]), more)
        if first != second:
            return joined((first if is_limit else second, told[1]))
    return joined(plain if is_limit else told)  # alike in all of them: no digit tells


def _apart(
    value: float, dimension: Dimension, digits: int, other: float, system: System, slow: bool
) -> str:
    """Return a value in as many digits as tell it from another."""
    for more in range(digits, MOST_DIGITS + 1):
        text = joined(_told(value, dimension, system, more, slow))
        if text != joined(_told(other, dimension, system, more, slow)):
            return text
    return joined(_told(value, dimension, system, digits, slow))


def _range(
    value: float, dimension: Dimension, digits: int, form: Form, other: float, system: System
) -> str:
    """Return two numbers, with one unit where both have the same."""
    first = _told(other, dimension, system, digits, False)
    if form in ("to up", "to down"):  # from what was given
        first = _typed(other, dimension, system, digits)
    if form in ("to", "-"):
        last = _told(value, dimension, system, digits, False)
        if joined(first) == joined(last):
            return joined(last)
    else:
        last = _limit(value, dimension, system, digits, form == "to up")
    begin = first[0] if first[1] == last[1] else joined(first)
    between = " of " if form == "of" else " to "
    return begin + ("-" if form == "-" else between) + joined(last)


def quantity(
    value: float, dimension: Dimension, digits: int = RESULT_DIGITS, name: str = ""
) -> str:
    """Return the cell of a value [SI]; `NONE` for nan and words for infinity."""
    if math.isnan(value):
        return NONE
    if math.isinf(value):
        return _UNBOUNDED
    return Cell(value, dimension, digits, name=name)


def format_limit(
    value: float,
    dimension: Dimension,
    sense: Literal["maximum", "minimum"],
    missed_by: float = math.nan,
    name: str = "",
) -> str:
    """Return the cell of a limit [SI], with which it holds as it is shown.

    A maximum is rounded down, a minimum up; what was given in four digits or less is not rounded.

    Parameters
    ----------
    value, dimension
        The limit [SI] and what it measures.
    sense
        Which of both it is.
    missed_by
        Value that misses it [SI], from which it is told apart by more digits; nan for none.
    name
        Name in the glossary, or empty.
    """
    if not math.isfinite(value):
        return quantity(value, dimension)
    return Cell(value, dimension, form=sense, other=missed_by, name=name)


def bare(value: float, dimension: Dimension, digits: int = RESULT_DIGITS, name: str = "") -> str:
    """Return the same without a unit, as it stands under `unit_of` its dimension."""
    if not math.isfinite(value):
        return quantity(value, dimension)
    return Cell(value, dimension, digits, "bare", name=name)


def unit_of(dimension: Dimension) -> str:
    """Return the unit of a table column of a dimension."""
    return Cell(0.0, dimension, form="unit")


def percent(share: float, digits: int = RESULT_DIGITS) -> str:
    """Return a share as percent, `NONE` for nan."""
    return NONE if math.isnan(share) else Cell(share, "number", digits, "percent")


def fixed(
    value: float, digits: int, form: Form = "fixed", dimension: Dimension = "number", name: str = ""
) -> str:
    """Return a value with so many digits behind the point, `NONE` for nan.

    `form` is ``fixed``, ``signed``, ``percent fixed`` or ``percent signed``.
    """
    if not math.isfinite(value):
        return quantity(value, dimension)
    return Cell(value, dimension, digits, form, name=name)


def count(number: float) -> str:
    """Return a count or an amount of money, grouped by thousands."""
    return (
        quantity(number, "number")
        if not math.isfinite(number)
        else Cell(number, "number", form="grouped")
    )


def plus_minus(value: float, error: float, dimension: Dimension = "number", name: str = "") -> str:
    """Return a value under the head with its unit, with half its interval.

    The value alone where there is no interval (an error of 0, or not finite).
    """
    if not (math.isfinite(value) and math.isfinite(error) and error > 0.0):
        return bare(value, dimension, name=name)
    return Cell(value, dimension, RESULT_DIGITS, "bare error", error, name)


def either(si: str, us: str) -> str:
    """Return what is said otherwise in each system of units, as steps that are round in one."""
    return si if si == us else f"\x04{si}\x05{us}\x06"


def in_unit(dimension: Dimension, told: Callable[[float], str]) -> str:
    """Return what is told of the SI value of the unit of a table column: of what is no cell.

    As ``in_unit("length", lambda mm: f"{peak / mm:.3g} (held)")``.
    """
    return either(*(told(display_unit(dimension, system)[1]) for system in get_args(System)))


def in_each(value: float, dimension: Dimension, si: str, us: str) -> str:
    """Return a value in the units that people of a trade write, where no table column has them.

    As ``in_each(speed, "speed", "mm/min", "in/min")``.
    """
    return either(*(f"{value / unit_factor(unit, dimension):.4g} {unit}" for unit in (si, us)))


def per_stress(compliance: float) -> str:
    """Return a compliance h/G [m/Pa] as it is read in each system of units."""
    inch, ksi = display_unit("length", "us")[1], 1e3 * display_unit("pressure", "us")[1]
    return either(f"{1e9 * compliance:.3g} mm/MPa", f"{compliance * ksi / inch:.3g} in/ksi")


def distinct(texts: Iterable[str]) -> tuple[str, ...]:
    """Return texts, each once of those that read the same in every system of units."""
    found: dict[tuple[str, ...], str] = {}
    for text in texts:
        found.setdefault(tuple(in_units(text, system) for system in get_args(System)), text)
    return tuple(found.values())


def cells_in(text: str) -> Iterator[Cell]:
    """Yield the cells of a text, in their order."""
    found = map(cell_of, (slot[0] for slot in _SLOT.finditer(text)))
    return (cell for cell in found if cell is not None)


def in_units(text: str, system: System = "si") -> str:
    """Return a text with its cells shown in a system of units."""
    if "\x04" in text:
        text = _EITHER.sub(lambda found: found[1 if system == "si" else 2], text)
    if "\x02" not in text:
        return text
    return _SLOT.sub(lambda found: _filled(found[0], system), text)


def placed(text: str) -> tuple[str, list[tuple[tuple[int, int], Cell]]]:
    """Return a text in metric units, and its cells with the places where they stand in it."""
    text = _EITHER.sub(r"\1", text)
    found: list[tuple[tuple[int, int], Cell]] = []
    told, end = "", 0
    for slot in _SLOT.finditer(text):
        told += text[end : slot.start()]
        begin, end = len(told), slot.end()
        told += _filled(slot[0], "si")
        cell = cell_of(slot[0])
        if cell is not None:
            found.append(((begin, len(told)), cell))
    return told + text[end:], found


@lru_cache(maxsize=4096)  # a table is shown in several ways
def _filled(slot: str, system: System) -> str:
    cell = cell_of(slot)
    return slot.replace("\x02", "").replace("\x03", "") if cell is None else cell.text(system)


def cell_of(text: str) -> Cell | None:
    """Return the cell that a text is; None if it is more, or only looks like one."""
    found = _SLOT.fullmatch(text)
    if found is None or found[1] not in DIMENSIONS or found[3] not in _FORMS:
        return None
    try:
        value, other = float(found[4]), float(found[5])
    except ValueError:
        return None
    return Cell(value, found[1], int(found[2]), found[3], other, found[6])  # type: ignore[arg-type]
