"""One check as data: what was compared, where, how it ends, and its one sentence."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from typing import Literal, NamedTuple

from wraparc.arrays import Number
from wraparc.checks.numbers import kept, kind_of, margin_of, order_of, used_of
from wraparc.units import Cell, Dimension, format_limit, quantity
from wraparc.units.cell import Form
from wraparc.units.digits import exponent_of, scientific

#: Checks of the solution itself: what keeps its limit is rounding, and no number that is known.
NUMERICAL = ("balance", "train_balance", "across_balance")
#: What is said of the drive and compares nothing: no row of a table of checks, and not counted.
INFO_CHECKS = ("data", "sense")

#: How a value stands to its limit.
Relation = Literal["exceeds", "below", "within", "none"]


class Level(StrEnum):
    """How good news is; the value is the word that says it without colour."""

    NOT_CHECKED = "NOT CHECKED"
    OK = "OK"
    ATTENTION = "ATTENTION"
    FAILS = "FAILS"
    FAULT = "INTERNAL ERROR"

    #: Place in the order from good to bad; what was not checked decides nothing.
    rank: int

    def __init__(self, _: str) -> None:
        self.rank = len(type(self).__members__)


def escaped(text: str) -> str:
    """Return a text that stands for itself in `Check.headline`."""
    return text.replace("{", "{{").replace("}", "}}")


def keeps(value: float, limit: float, *, at_most: bool = True) -> bool:
    """Return whether a value keeps its limit, compared in four digits."""
    return kept(value, limit, at_most)


def margin_to(value: Number, limit: Number, *, at_most: bool) -> Number:
    """How far a value is from its limit, over the limit: positive on the safe side [-]."""
    return (1.0 if at_most else -1.0) * (1.0 - value / limit)


class Place(NamedTuple):
    """Where a check is made; empty where it is the whole drive.

    Attributes
    ----------
    pulley, load_case, event
        Names.
    spot
        Where on the pulley: ``entry``, ``worst face strip``.
    condition
        Of the friction, where several are solved. A load case that is solved in each of them is
        named with it: ``start, wet``.
    time
        When [s]; None where it is at rest.
    """

    pulley: str = ""
    load_case: str = ""
    event: str = ""
    spot: str = ""
    condition: str = ""
    time: float | None = None

    def __str__(self) -> str:
        case, more = self.load_case, f", {self.condition}"
        if self.condition and case.endswith(more):
            case = case[: len(case) - len(more)]
        names = (self.pulley, self.spot, case, self.event, self.condition)
        parts = [f'"{name}"' if "," in name else name for name in names if name]
        if self.time is not None:
            parts.append(quantity(self.time, "time"))
        return ", ".join(parts)

    @property
    def bracket(self) -> str:
        """The place as it ends a sentence, with a blank before it; empty for the whole drive."""
        names = str(self)
        return f" ({names})" if names else ""


NOWHERE = Place()


class Amount(NamedTuple):
    """A quantity in the texts of a check.

    Attributes
    ----------
    value, dimension
        The quantity [SI] and what it measures.
    form
        ``up`` or ``down`` where it holds rounded to that side; else it is told apart from others.
    """

    value: float
    dimension: Dimension
    form: Form = ""


@dataclass(frozen=True, kw_only=True)
class Check:
    """What is compared with one limit, at one place.

    Attributes
    ----------
    name, title
        Key of the check, the same in every door, and its words as a row.
    level
        How it ends.
    place
        Where.
    is_placed
        Whether the sentence ends with the place; not where the headline names it.
    quantity, noun
        What is compared: its key, and its name within a sentence.
    value, limit
        What was calculated and what is allowed [SI]; nan where there is none.
    dimension
        What they measure.
    is_percent
        Whether they are shares that are shown in percent.
    at_most
        Whether the limit is a maximum.
    headline
        What is wrong, ``{value}``, ``{limit}`` and the names of `more` standing for quantities,
        without place and full stop; empty where the check passes.
    action
        What to do where it needs no solving, with the same places: one sentence.
    full
        Reasons, allowances and assumptions, with the same places: sentences.
    label
        The answer in a few words, for a table.
    source
        Where the limit came from.
    missing, why
        Of a check that is not made: the key that is missing, or the reason.
    more
        Further quantities by name.
    binding
        Whether a design must pass it; of these the minimum slack-side tension keeps what a tension
        helps against.
    weak
        Of the data line: class, key and word of every input that is weak.
    """

    name: str
    title: str
    level: Level
    place: Place = NOWHERE
    is_placed: bool = True
    quantity: str = ""
    noun: str = ""
    value: float = math.nan
    limit: float = math.nan
    dimension: Dimension = "number"
    is_percent: bool = False
    at_most: bool = True
    headline: str = ""
    action: str = ""
    full: str = ""
    label: str = ""
    source: str = ""
    missing: str = ""
    why: str = ""
    more: Mapping[str, Amount] = field(default_factory=dict, hash=False)
    binding: bool = True
    weak: tuple[tuple[str, str, str], ...] = ()

    @property
    def margin(self) -> float:
        """How far from the limit, over the limit: positive on the safe side [-].

        1 where the value is below its own accuracy.
        """
        return 1.0 if self.below else margin_of(self.value, self.limit, self.at_most)

    @property
    def used(self) -> float:
        """How much of the limit is used: value over a maximum, a minimum over the value [-].

        Nan where there is none, and where the value is below its own accuracy.
        """
        return math.nan if self.below else used_of(self.value, self.limit, self.at_most)

    @property
    def relation(self) -> Relation:
        """How the value stands to its limit."""
        if math.isnan(self.limit) or math.isnan(self.value):
            return "none"
        if not self.missed:
            return "within"
        return "exceeds" if self.at_most else "below"

    @property
    def numerical(self) -> bool:
        """Whether it is of the solution and not of the drive."""
        return self.name in NUMERICAL

    @property
    def compares(self) -> bool:
        """Whether it is a row of the table of checks, and counted."""
        return self.name not in INFO_CHECKS and self.level is not Level.NOT_CHECKED

    @property
    def floor(self) -> float:
        """Accuracy of the value [SI]; 0 where all its digits are known."""
        return self.limit if self.numerical else 0.0

    @property
    def below(self) -> bool:
        """Whether the value is below its accuracy: it is shown so, and not as a number."""
        return self.numerical and self.level is Level.OK

    @property
    def share(self) -> float:
        """The value over the limit, as a bar shows it; nan where there is none [-]."""
        silent = self.level is Level.NOT_CHECKED or self.numerical or not self.limit
        share = math.nan if silent else self.value / self.limit
        return share if math.isfinite(share) else math.nan

    @property
    def missed(self) -> bool:
        """Whether it asks for attention or worse."""
        return self.level.rank >= Level.ATTENTION.rank

    @property
    def order(self) -> tuple[float, float]:
        """The key that sorts checks: the worst level, the governing kind, the most used first.

        What could not be checked at one place stands before what passes at another.
        """
        unknown = self.level is Level.NOT_CHECKED
        place = order_of(self.used, self.missed, kind_of(self.name, self.level is Level.FAILS))
        return -(Level.OK.rank + 0.5 if unknown else self.level.rank), place

    def texts(self) -> tuple[str, str]:
        """Return value and limit with their units, in as many digits as tell them apart."""
        if self.below:
            power = exponent_of(scientific(self.limit, 0))
            return f"< 1e{power}", f"1e{power}"
        value, limit, more = self.value, self.limit, ""
        if self.is_percent:
            value, limit, more = 100.0 * value, 100.0 * limit, " %"
        if not self.missed:
            shown = quantity_text(value, self.dimension)
            other = "" if math.isnan(limit) else self._limit(limit, math.nan)
        else:
            form: Form = "exceeds" if self.at_most else "below"
            shown = quantity_text(value, self.dimension, limit, form)
            other = "" if math.isnan(limit) else self._limit(limit, value)
        return (f"{shown}{more}" if shown else ""), (f"{other}{more}" if other else "")

    def _limit(self, limit: float, missed_by: float) -> str:
        sense: Literal["maximum", "minimum"] = "maximum" if self.at_most else "minimum"
        return format_limit(limit, self.dimension, sense, missed_by)

    def bound(self) -> str:
        """Return the limit with its sense, ``max 6.350 mm``; empty without one."""
        if math.isnan(self.limit):
            return ""
        return f"{'max' if self.at_most else 'min'} {self.texts()[1]}"

    @property
    def measured(self) -> str:
        """Value and limit of a check that passes: ``150 of 210 kN``, ``1.5 m, minimum 1 m``."""
        value, limit = self.texts()
        if not value or not limit:
            return value
        if not self.at_most:
            return f"{value}, minimum {limit}"
        if self.below or not (math.isfinite(self.value) and math.isfinite(self.limit)):
            return f"{value} of {limit}"
        if self.is_percent:
            return f"{Cell(100.0 * self.limit, 'number', form='of', other=100.0 * self.value)} %"
        return Cell(self.limit, self.dimension, form="of", other=self.value)

    @property
    def text(self) -> str:
        """The one sentence of the check; its quantities are cells."""
        if self.level is Level.NOT_CHECKED:
            reason = f"{self.missing} missing" if self.missing else self.why
            return f"{self.title} not checked: {reason}."
        if not self.headline:
            measured = self.measured
            return f"{self.title}{f': {measured}' if measured else ''}{self.place.bracket}."
        where = self.place.bracket if self.is_placed else ""
        return f"{self._filled(self.headline)}{where}."

    @property
    def action_text(self) -> str:
        """What to do where it needs no solving; its quantities are cells."""
        return self._filled(self.action)

    @property
    def full_text(self) -> str:
        """Reasons, allowances and assumptions; the quantities in it are cells."""
        return self._filled(self.full)

    def _filled(self, template: str) -> str:
        """Return a template with its quantities."""
        value, limit = self.texts()
        words = {name: self._amount(name) for name in self.more}
        words |= {"value": value, "limit": limit}
        return template.format(**words)

    def _amount(self, name: str) -> str:
        """Return a quantity of `more`, told apart from the nearest other one of its kind."""
        of = self.more[name]
        if of.form and math.isfinite(of.value):
            return Cell(of.value, of.dimension, form=of.form)
        others = [
            o.value for n, o in self.more.items() if n != name and o.dimension == of.dimension
        ]
        nearest = min(others, key=lambda other: abs(other - of.value), default=math.nan)
        return quantity_text(of.value, of.dimension, nearest)


def quantity_text(
    value: float, dimension: Dimension, against: float = math.nan, form: Form = "slip apart"
) -> str:
    """Return the cell of a value [SI]; empty for nan, words for infinity.

    It is shown in as many digits as tell it from another number, if one is given.
    """
    if math.isnan(value):
        return ""
    if math.isinf(value):
        return quantity(value, dimension)
    shown: Form = "slip" if math.isnan(against) else form
    return Cell(value, dimension, form=shown, other=against)
