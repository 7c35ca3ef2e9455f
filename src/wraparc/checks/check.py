"""One check, its level, and the verdict that follows from a list of them."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from enum import StrEnum
from functools import cached_property
from typing import NamedTuple

import numpy as np

from wraparc.arrays import Number
from wraparc.checks.numbers import AHEAD, BEHIND, beyond, kept, margin_of, order_of, times_of
from wraparc.units import Cell, Dimension, System, in_units, quantity
from wraparc.units.cell import Form

#: Checks that advise where they are missed, as a design standard does that does not bind.
ADVICE = ("cover_creep", "creep_interval", "tested_slip_speed", "wet_creep")
#: Checks of the solution itself: what keeps its limit is rounding, and no number that is known.
NUMERICAL = ("balance", "train_balance", "across_balance")
#: What is said of the drive and compares nothing: no row of a table of checks, and not counted.
SAID = ("data", "belt_mass", "sense")
#: Checks whose failure stands before every other one: the load is not carried at all, or what fails
#: besides is the pull of drives against each other.
LEADING = ("gross_slip", "operating_point", "fight")


class Level(StrEnum):
    """How good news is; the value is the word that says it without colour."""

    NOT_CHECKED = "NOT CHECKED"
    OK = "OK"
    ATTENTION = "ATTENTION"
    FAILS = "FAILS"
    FAULT = "FAULT OF THE PROGRAM"

    #: Place in the order from good to bad; what was not checked decides nothing.
    rank: int

    def __init__(self, _: str) -> None:
        self.rank = len(type(self).__members__)


def escaped(text: str) -> str:
    """Return a text that stands for itself in `Check.says`."""
    return text.replace("{", "{{").replace("}", "}}")


def keeps(value: float, limit: float, *, at_most: bool = True) -> bool:
    """Whether a value keeps its limit, compared in four digits."""
    return kept(value, limit, at_most)


def margin_to(value: Number, limit: Number, *, at_most: bool) -> Number:
    """How far a value is from its limit, over the limit: positive on the safe side [-]."""
    return (1.0 if at_most else -1.0) * (1.0 - value / limit)


class Place(NamedTuple):
    """Where a check holds; empty names where it is the whole drive.

    Attributes
    ----------
    pulley, load_case, event
        Names.
    """

    pulley: str = ""
    load_case: str = ""
    event: str = ""

    def __str__(self) -> str:
        parts = [f"pulley {self.pulley}"] if self.pulley else []
        parts += [f"load case {self.load_case}"] if self.load_case else []
        parts += [f"event {self.event}"] if self.event else []
        return ", ".join(parts)


NOWHERE = Place()


class Miss(NamedTuple):
    """What a check says where it is not kept; see `Check`.

    A value [SI] on the far side of `fails_beyond` fails, as `because` says; one of at most
    `tolerates` may be allowed, as `allows` says.
    """

    level: Level
    short: str
    says: str
    remedy: str
    fails_beyond: float = math.nan
    because: str = ""
    tolerates: float = math.nan
    allows: str = ""
    otherwise: str = ""

    def at(self, value: float, at_most: bool) -> tuple[Level, str]:
        """Return level and words for a value that misses its limit."""
        if beyond(value, self.fails_beyond, at_most):
            return Level.FAILS, f"{self.says} {self.because}".rstrip()
        says = f"{self.says} {self.allows}" if value <= self.tolerates else self.says
        return self.level, says.rstrip()


@dataclass(frozen=True, kw_only=True)
class Check:
    """What is held against one limit, at one place.

    Attributes
    ----------
    name, title
        Key of the check, the same in every door, and its words.
    level
        How it ends.
    place
        Pulley and load case.
    value, limit
        What was found and what is allowed [SI]; nan where there is none.
    dimension
        What they measure.
    at_most
        Whether the limit is an upper one.
    source
        Where the limit came from.
    short
        The answer in a few words, for a table.
    says
        What is wrong, ``{value}`` and ``{limit}`` and the names of `more` standing for quantities;
        empty where the check is kept and its title says enough.
    remedy, otherwise
        What to do, with the same places; and what where no other tension helps, empty where the
        remedy asks for none.
    more
        Further quantities by name: value [SI] and dimension.
    binding
        Whether a design must keep it; of these the least slack-side tension keeps what a tension
        helps against.
    miss
        What it says where a value misses its limit; None where nothing is compared.
    """

    name: str
    title: str
    level: Level
    place: Place = NOWHERE
    value: float = math.nan
    limit: float = math.nan
    dimension: Dimension = "number"
    at_most: bool = True
    source: str = ""
    short: str = ""
    says: str = ""
    remedy: str = ""
    otherwise: str = ""
    more: Mapping[str, tuple[float, Dimension]] = field(default_factory=dict, hash=False)
    binding: bool = True
    miss: Miss | None = None

    @property
    def margin(self) -> float:
        """How far from the limit, over the limit: positive on the safe side [-].

        1 where the value is below its own accuracy.
        """
        return 1.0 if self.below else margin_of(self.value, self.limit, self.at_most)

    @property
    def numerical(self) -> bool:
        """Whether it is of the solution and not of the drive."""
        return self.name in NUMERICAL

    @property
    def compares(self) -> bool:
        """Whether it is a row of the table of checks, and counted."""
        return self.name not in SAID and self.level is not Level.NOT_CHECKED

    @property
    def floor(self) -> float:
        """Accuracy of the value [SI]; 0 where all its digits are known."""
        return self.limit if self.numerical else 0.0

    @property
    def below(self) -> bool:
        """Whether the value is below its accuracy: it is told so, and not as a number."""
        return self.numerical and self.level is Level.OK

    @property
    def share(self) -> float:
        """The value over the limit, as a bar shows it; nan where there is none [-]."""
        silent = self.level is Level.NOT_CHECKED or self.numerical or not self.limit
        share = math.nan if silent else self.value / self.limit
        return share if math.isfinite(share) else math.nan

    @property
    def reason(self) -> str:
        """What it says that is not kept, without what to do about it."""
        return replace(self, remedy="").said if self.missed else ""

    @property
    def times(self) -> float:
        """How many times its limit it is, where it is far from it; nan where it is not [-]."""
        return times_of(self.value, self.limit)

    @property
    def advises(self) -> bool:
        """Whether it tells of what is not known or was not asked for, not of a limit."""
        return self.name in ADVICE or (self.name == "design_standard" and not self.binding)

    @property
    def leads(self) -> bool:
        """Whether it is told before all others that fail: nothing else counts in gross slip."""
        return self.level is Level.FAILS and self.name in LEADING

    @property
    def missed(self) -> bool:
        """Whether it asks for attention or worse."""
        return self.level.rank >= Level.ATTENTION.rank

    def texts(self) -> tuple[str, str]:
        """Return value and limit with their units, in as many digits as tell them apart."""
        if self.below:
            limit = quantity_text(self.limit, self.dimension)
            return f"below {limit}", limit
        if not self.missed:
            return (
                quantity_text(self.value, self.dimension),
                quantity_text(self.limit, self.dimension),
            )
        return (
            quantity_text(self.value, self.dimension, self.limit),
            quantity_text(self.limit, self.dimension, self.value),
        )

    def bound(self) -> str:
        """Return the limit with its sense, ``at most 6.350 mm``; empty without one."""
        if math.isnan(self.limit):
            return ""
        return f"{'at most' if self.at_most else 'at least'} {self.texts()[1]}"

    def _beside(self, name: str) -> float:
        """Return the quantity of `more` that one of it is told from: the nearest of its kind."""
        value, dimension = self.more[name]
        others = [v for n, (v, d) in self.more.items() if n != name and d == dimension]
        return min(others, key=lambda other: abs(other - value), default=math.nan)

    def sentence(self, system: System = "si") -> str:
        """Return what there is to say, with the remedy, as text in a system of units."""
        return in_units(self.said, system)

    @property
    def said(self) -> str:
        """What there is to say, with the remedy; its quantities are cells."""
        value, limit = self.texts()
        if not self.says:
            bound = f", {self.bound()}" if limit else ""
            return f"{self.title}: {value}{bound}." if value else f"{self.title}."
        words = {n: quantity_text(v, d, self._beside(n)) for n, (v, d) in self.more.items()}
        words |= {"value": value, "limit": limit}
        return " ".join(part.format(**words) for part in (self.says, self.remedy) if part)


def quantity_text(value: float, dimension: Dimension, against: float = math.nan) -> str:
    """Return the cell of a value [SI]; empty for nan, words for infinity.

    It is shown in as many digits as tell it from another number, if one is given.
    """
    if math.isnan(value):
        return ""
    if math.isinf(value):
        return quantity(value, dimension)
    form: Form = "slip" if math.isnan(against) else "slip apart"
    return Cell(value, dimension, form=form, other=against)


@dataclass(frozen=True)
class Verdict:
    """What a list of checks comes to: its worst.

    Attributes
    ----------
    checks
        Every check at every place, in the order they are told.
    """

    checks: tuple[Check, ...]

    @cached_property
    def governing(self) -> Check | None:
        """The worst check, limits before advice, the least margin first.

        Of what is kept, the nearest to its limit.
        """
        judged = [c for c in self.checks if c.level is not Level.NOT_CHECKED]
        return min(judged, key=_badness, default=None)

    @cached_property
    def odd(self) -> Check | None:
        """The size that is asked about, where another check governs: it may be why."""
        worst = self.governing
        if worst is None or worst.name == "usual_sizes":
            return None
        return next((c for c in self.listed if c.name == "usual_sizes" and c.missed), None)

    @property
    def level(self) -> Level:
        """Level of the worst check; OK where there is none."""
        return Level.OK if self.governing is None else self.governing.level

    @cached_property
    def qualifier(self) -> str:
        """What limits an OK: ``on illustrative data``; empty where nothing does."""
        found = {c.short for c in self.checks if c.name == "data"}
        return next((word for word in DATA_WORDS if word in found), "")

    @property
    def word(self) -> str:
        """Word of the verdict; an OK says what it is limited to, and what data it stands on."""
        if self.level is not Level.OK:
            return str(self.level)
        return f"{self.ok_word}, {self.qualifier}" if self.qualifier else self.ok_word

    @property
    def ok_word(self) -> str:
        """Word of an OK, which says where nothing is known of the drive when wet."""
        dry = self.wet is not None and self.wet.level is Level.NOT_CHECKED
        return f"{Level.OK} (dry)" if dry else str(Level.OK)

    @property
    def wet(self) -> Check | None:
        """The estimated creep when wet, where it is largest; None where none is estimated."""
        return next((c for c in self.listed if c.name == "wet_creep"), None)

    @cached_property
    def listed(self) -> tuple[Check, ...]:
        """Each check once, at the place where it comes off worst, in the order they are told."""
        worst: dict[str, Check] = {}
        for check in self.checks:
            held = worst.get(check.name, check)
            worst[check.name] = min(held, check, key=_badness)
        return tuple(worst.values())

    @cached_property
    def missed(self) -> tuple[Check, ...]:
        """The checks of `listed` that are not kept, the worst first."""
        return tuple(sorted((c for c in self.listed if c.missed), key=_badness))

    def nearness(self, check: Check) -> tuple[float, float]:
        """Return the key that sorts checks: the worst, then the nearest to its limit, first."""
        return _badness(check)

    @property
    def data(self) -> tuple[str, ...]:
        """On what data the answer stands: what is illustrative, estimated, without tests."""
        told = (c.said for c in self.checks if c.name in ("data", "belt_mass") and c.says)
        return tuple(dict.fromkeys(told))

    def at(self, pulley: str, load_case: str) -> Verdict:
        """Return the verdict on one pulley in one load case."""
        known = self._at.setdefault(load_case, {})
        if pulley not in known:
            places = dict.fromkeys(("", load_case))
            there = sorted(n for place in places for n in self._places.get(place, ()))
            mine = [self.checks[number] for number in there]
            own = tuple(check for check in mine if check.place.pulley in ("", pulley))
            known[pulley] = self if len(own) == len(self.checks) else Verdict(own)
        return known[pulley]

    def within(self, load_case: str) -> Verdict:
        """Return the verdict on all pulleys in one load case."""
        own = tuple(c for c in self.checks if c.place.load_case in ("", load_case))
        return self if len(own) == len(self.checks) else Verdict(own)

    @cached_property
    def _at(self) -> dict[str, dict[str, Verdict]]:
        return {}

    @cached_property
    def _places(self) -> dict[str, list[int]]:
        found: dict[str, list[int]] = {}
        for number, check in enumerate(self.checks):
            found.setdefault(check.place.load_case, []).append(number)
        return found

    def headline(self, system: System = "si") -> str:
        """Return the answer in one sentence or two, as text in a system of units."""
        return in_units(self.lead, system)

    @property
    def lead(self) -> str:
        """The answer in one sentence or two; its quantities are cells."""
        worst = self.governing
        if worst is None:
            return "Nothing could be checked."
        if self.odd is not None:
            said, odd = (replace(check, remedy="") for check in (worst, self.odd))
            return f"{placed(said)}{self._sense()} {odd.said} {self.action}".rstrip()
        if worst.missed:
            return f"{placed(worst)}{self._sense()}"
        text = f"All {sum(c.compares for c in self.listed)} checks are kept"
        if math.isnan(worst.margin) or math.isinf(worst.margin):
            return f"{text}.{self._sense()}"
        value, _ = worst.texts()
        where = f" ({worst.place})" if str(worst.place) else ""
        return (
            f"{text}; nearest to its limit is {_small(worst.title)}, {value}, "
            f"{worst.bound()}{where}.{self._sense()}"
        )

    @property
    def action(self) -> str:
        """What the headline says is to be done: an odd size is looked at first."""
        told = (
            check.said.removeprefix(replace(check, remedy="").said).strip()
            for check in (self.odd, self.governing)
            if check is not None and check.missed and check.says
        )
        return " ".join(filter(None, told))

    def _sense(self) -> str:
        """Say which pulleys brake, or that none pulls, and in how many load cases if not in all."""
        every = {c.place.load_case for c in self.checks} - {""}
        braking = [c for c in self.checks if c.name == "sense"]
        told = ""
        for title in dict.fromkeys(c.title for c in braking):
            here = {c.place.load_case for c in braking if c.title == title}
            some = f" in {len(here)} of {len(every)} load cases" if len(here) < len(every) else ""
            told += f" {title}{some}."
        return told

    def _when_wet(self) -> list[str]:
        """Say of an OK what the estimate when wet comes to, or that there is none."""
        if self.wet is None or self.level is not Level.OK:
            return []
        if self.wet.level is Level.NOT_CHECKED:
            return [f"Wet: not checked, {self.wet.short}."]
        return [f"Wet: creep {self.wet.texts()[0]} (estimated) passes."]

    def sentences(self, system: System = "si") -> tuple[str, ...]:
        """Return what is missed besides the headline, as texts in a system of units."""
        return tuple(in_units(sentence, system) for sentence in self.others)

    @property
    def others(self) -> tuple[str, ...]:
        """What is missed besides the headline, a sentence each; their quantities are cells."""
        first = {c.name for c in (self.governing, self.odd) if c is not None}
        others = (check for check in self.missed if check.name not in first)
        told = [f"{check.level}: {placed(check)}" for check in others]
        told += self._when_wet()
        if self.level.rank > Level.OK.rank and self.qualifier:
            told.append(f"All of this stands {self.qualifier}.")
        return tuple(told)


#: What the data of a drive may be said to be, the weakest ground first.
DATA_WORDS = (
    "on illustrative data",
    "on friction without tests",
    "on estimated data",
    "on calibrated data",
)


def _badness(check: Check) -> tuple[float, float]:
    """Sort key: worst level first, then the least margin; what binds no design comes last.

    What could not be checked at one place stands before what is kept at another.
    """
    order = order_of(check.margin, check.missed, check.binding, check.advises, check.leads)
    unknown = check.level is Level.NOT_CHECKED
    return -(Level.OK.rank + 0.5 if unknown else check.level.rank), order


def behind(margin: Number) -> Number:
    """Return a margin that sorts behind every other: advice leads where nothing else is missed."""
    found: Number = np.maximum(margin, -BEHIND) + 2.0 * BEHIND
    return found


def ahead(margin: Number) -> Number:
    """Return a margin that sorts before every other: gross slip leads whatever else fails."""
    found: Number = np.minimum(margin, BEHIND) - AHEAD
    return found


def placed(check: Check) -> str:
    """Return the sentence of a check with its place, once."""
    where, said = _capital(str(check.place)), check.said
    return said if not where or said.startswith(where) else f"{where}: {said}"


def _capital(text: str) -> str:
    return text[:1].upper() + text[1:]


def _small(text: str) -> str:
    return text[:1].lower() + text[1:]
