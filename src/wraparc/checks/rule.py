"""What a check is made of: a `Rule`, the numbers that it compares, and the words for them.

The numbers are functions of one drive and of columns of many alike.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import KW_ONLY, dataclass, field, replace
from typing import Generic, Literal, Protocol

from wraparc.arc import ArcResult, WrapArc
from wraparc.arrays import Number
from wraparc.checks.check import Amount, Check, Level, Place, keeps
from wraparc.checks.numbers import beyond
from wraparc.drive import Drive, LoadCase, Pulley
from wraparc.drive.pull import idles
from wraparc.provenance import Provenance
from wraparc.units import Dimension


@dataclass(frozen=True, eq=False, kw_only=True)
class State(Generic[Number]):
    """What checks compare of a pulley in a load case: numbers, or columns of many, nan if unknown.

    Attributes
    ----------
    tight, slack
        The larger and the smaller tension [N].
    slack_end
        Tension of the slack end of the whole drive where the belt leaves it here [N].
    width, diameter
        Of the belt, and of the pulley over the lagging [m].
    strength
        Of the belt [N/m].
    centrifugal
        m v^2 [N].
    creep_limit
        Creep that is accepted [m].
    motor
        Torque of the motors over the rated one [-].
    found
        Magnitudes that the solver finds of the arc, by name [SI]; none where it is not solved.
    """

    tight: Number
    slack: Number
    slack_end: Number
    width: Number
    diameter: Number
    strength: Number
    centrifugal: Number
    creep_limit: Number
    motor: Number
    found: Mapping[str, Number]

    def raised(self, by: Number) -> State[Number]:
        """Return the state with all tensions raised [N]."""
        tight, slack, end = self.tight + by, self.slack + by, self.slack_end + by
        return replace(self, tight=tight, slack=slack, slack_end=end)


class OfState(Protocol):
    """A number of a state, or a column of one of columns."""

    def __call__(self, state: State[Number], /) -> Number:
        """Return it."""


class LimitOf(Protocol):
    """A limit in a state, of what a description allows."""

    def __call__(self, allowed: Number, state: State[Number], /) -> Number:
        """Return it."""


@dataclass(frozen=True, eq=False, kw_only=True)
class At:
    """One pulley in one load case, or in an event, as it is described.

    Attributes
    ----------
    drive, case, pulley
        The laggings are in the condition of the load case.
    """

    drive: Drive
    case: LoadCase
    pulley: Pulley


@dataclass(frozen=True, eq=False, kw_only=True)
class Spot(At):
    """The same with what its checks compare.

    Attributes
    ----------
    place
        How it is called.
    state
        What is compared.
    result
        The arc, where one was solved.
    unknown
        Why nothing is known of what the arc does; empty where it is.
    """

    place: Place
    state: State[float]
    result: ArcResult | None = None
    unknown: str = ""


@dataclass(frozen=True, kw_only=True)
class CheckText:
    """The texts of a check at a spot; see `Check` for what is not described here.

    Attributes
    ----------
    headline
        What is wrong where the limit is missed.
    fails
        The same where the value is on the far side of `Rule.fails_beyond`; `headline` unless given.
    missing, why
        Key that is missing, or reason for which nothing is compared; empty where it is.
    show_value
        Whether the value is shown then nevertheless.
    """

    title: str
    noun: str = ""
    headline: str = ""
    fails: str = ""
    action: str = ""
    full: str = ""
    label: str = ""
    source: str = ""
    more: Mapping[str, Amount] = field(default_factory=dict)
    missing: str = ""
    why: str = ""
    show_value: bool = False


@dataclass(frozen=True, eq=False)
class Rule:
    """One check.

    Attributes
    ----------
    name
        Its key, the same in every door.
    what
        What sets the limit, in words.
    missed
        Level where it is not kept.
    fails_beyond
        Value beyond which a miss fails [SI]; nan for none.
    is_percent
        Whether value and limit are shares that are shown in percent.
    at_most
        Whether the limit is an upper one.
    dimension
        What is compared.
    tension
        Whether another tension of the slack side helps where it is missed, and which.
    binding
        Whether a design must keep it.
    firm
        Where given, whether it binds a drive, and fails where it is missed.
    result
        Name of what it compares, where the solver finds it: of `ArcResult` and `BatchResult`.
    value
        What it compares of a `State` else; None where it compares no number.
    allowed
        What is allowed by what is described; None where nothing is. Without it the limit is all.
    limit
        The limit by that; without it what is allowed is the limit.
    rounded
        The value at a limit, where that is missed by rounding alone.
    pulls
        Whether it is asked of pulleys that pull alone.
    of_rows, of_runs
        Whether it is asked of many arcs at once, and of an event in time by what that comes to at
        its worst, where it is known.
    text
        Its texts; None where it is not made at a spot.
    find_checks
        Yields its checks at a spot, in the place of value, limit and texts.
    """

    name: str
    what: str
    _: KW_ONLY
    missed: Level = Level.ATTENTION
    fails_beyond: float = math.nan
    is_percent: bool = False
    at_most: bool = True
    dimension: Dimension = "number"
    tension: Literal["", "raise", "lower"] = ""
    binding: bool = True
    firm: Callable[[Drive], bool] | None = None
    result: str = ""
    value: OfState | None = None
    allowed: Callable[[At], float | None] | None = None
    limit: LimitOf | None = None
    rounded: Callable[[float, float, State[float]], float] | None = None
    pulls: bool = False
    of_rows: bool = True
    of_runs: bool = True
    text: Callable[[Spot], CheckText | None] | None = None
    find_checks: Callable[[Spot], Iterator[Check]] | None = None

    def checks(self, of: Spot) -> Iterator[Check]:
        """Yield what it finds at a spot."""
        if self.find_checks is not None:
            yield from self.find_checks(of)
            return
        text = self.text(of) if self.text else None
        found = self.result in of.state.found
        if text is None or (self.result and not found and not of.unknown):
            return  # nothing is solved here, or an event does not tell it
        value = math.nan if self.result and not found else self.compared(of.state)
        why = text.why or (of.unknown if self.result else "")
        if not (text.missing or why) and math.isnan(value):
            why = "value unknown"
        if text.missing or why:
            title, noun = text.title, text.noun
            check = not_checked(self.name, title, noun, of.place, missing=text.missing, why=why)
            shown = replace(check, value=value, dimension=self.dimension)
            yield shown if text.show_value else check
            return
        limit = self.limit_at(of)
        if self.rounded is not None:
            value = self.rounded(value, limit, of.state)
        yield self.for_drive(of.drive).compare(value, limit, of.place, text)

    def compared(self, state: State[Number]) -> Number:
        """Return what is compared."""
        return self.value(state) if self.value else state.found[self.result]

    def limited(self, allowed: Number, state: State[Number]) -> Number:
        """Return the limit in a state, of what is allowed."""
        return allowed if self.limit is None else self.limit(allowed, state)

    def rise_to(self, state: State[Number], limit: Number) -> Number:
        """Return by how much all tensions rise until what is compared meets a limit [N].

        What is compared, a tension or a pressure of it, must grow evenly with them.
        """
        more = state.width * 1e3
        now = self.compared(state)
        per_tension = (self.compared(state.raised(more)) - now) / more
        return (limit - now) / per_tension

    def limit_at(self, of: Spot) -> float:
        """Return the limit at a spot, nan where nothing is allowed."""
        allowed = self.allowed(of) if self.allowed else None
        return self.limited(math.nan if allowed is None else allowed, of.state)

    def for_drive(self, drive: Drive) -> Rule:
        """Return the rule with the level and the force that it has for a drive."""
        if self.firm is None:
            return self
        firm = self.firm(drive)
        return replace(self, missed=Level.FAILS if firm else self.missed, binding=firm)

    def compare(self, value: float, limit: float, place: Place, text: CheckText) -> Check:
        """Return the check of a value against its limit."""
        passes = not math.isnan(value) and keeps(value, limit, at_most=self.at_most)
        fails = beyond(value, self.fails_beyond, self.at_most)
        headline = text.fails if fails and text.fails else text.headline
        level = Level.FAILS if fails else self.missed
        return Check(
            name=self.name,
            title=text.title,
            level=Level.OK if passes else level,
            place=place,
            quantity=self.result or self.name,
            noun=text.noun,
            value=value,
            limit=limit,
            dimension=self.dimension,
            is_percent=self.is_percent,
            at_most=self.at_most,
            headline="" if passes else headline,
            action="" if passes else text.action,
            full="" if passes else text.full,
            label="" if passes else text.label,
            source=text.source,
            more=text.more,
            binding=self.binding,
        )


def not_checked(
    name: str, title: str, noun: str, place: Place, *, missing: str = "", why: str = ""
) -> Check:
    """Return a check that could not be made, with the key that is missing or the reason."""
    return Check(
        name=name,
        title=title,
        level=Level.NOT_CHECKED,
        place=place,
        noun=noun,
        missing=missing,
        why=why,
    )


def origin(provenance: Provenance) -> str:
    """Return where a limit came from, in words."""
    return str(provenance)


def idle(arc: WrapArc) -> bool:
    """Whether an arc hands nothing over: its pulley is not driven."""
    return idles(arc.entry_tension, arc.exit_tension)
