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
from wraparc.checks.check import Check, Level, Miss, Place, escaped, keeps
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
class Words:
    """What a check says at a spot; see `Check` and `Miss` for what is not told here.

    Attributes
    ----------
    missing
        Why nothing is compared; empty where it is.
    told
        Whether the value is told then nevertheless.
    """

    title: str
    source: str = ""
    short: str = ""
    says: str = ""
    because: str = ""
    allows: str = ""
    remedy: str = ""
    otherwise: str = ""
    more: Mapping[str, tuple[float, Dimension]] = field(default_factory=dict)
    missing: str = ""
    told: bool = False


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
    tolerates
        Value up to which practice may allow a miss [SI]; nan for none.
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
    words
        What it says; None where it is not asked at a spot.
    asked
        Yields its checks at a spot, in the place of value, limit and words.
    """

    name: str
    what: str
    _: KW_ONLY
    missed: Level = Level.ATTENTION
    fails_beyond: float = math.nan
    tolerates: float = math.nan
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
    words: Callable[[Spot], Words | None] | None = None
    asked: Callable[[Spot], Iterator[Check]] | None = None

    def checks(self, of: Spot) -> Iterator[Check]:
        """Yield what it finds at a spot."""
        if self.asked is not None:
            yield from self.asked(of)
            return
        words = self.words(of) if self.words else None
        found = self.result in of.state.found
        if words is None or (self.result and not found and not of.unknown):
            return  # nothing is solved here, or an event does not tell it
        value = math.nan if self.result and not found else self.compared(of.state)
        missing = words.missing or (of.unknown if self.result else "")
        missing = missing or ("its value is not known" if math.isnan(value) else "")
        if missing:
            check = not_checked(self.name, words.title, missing, of.place)
            told = replace(check, value=value, dimension=self.dimension)
            yield told if words.told else check
            return
        limit = self.limit_at(of)
        if self.rounded is not None:
            value = self.rounded(value, limit, of.state)
        yield self.held(of.drive).judged(value, limit, of.place, words)

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

    def held(self, drive: Drive) -> Rule:
        """Return the rule as a drive is held to it."""
        if self.firm is None:
            return self
        firm = self.firm(drive)
        return replace(self, missed=Level.FAILS if firm else self.missed, binding=firm)

    def judged(self, value: float, limit: float, place: Place, words: Words) -> Check:
        """Return the check of a value against its limit: OK, or what is said where it misses."""
        kept = not math.isnan(value) and keeps(value, limit, at_most=self.at_most)
        miss = Miss(
            self.missed,
            words.short,
            words.says,
            words.remedy,
            self.fails_beyond,
            words.because,
            self.tolerates,
            words.allows,
            words.otherwise,
        )
        level, says = miss.at(value, self.at_most)
        return Check(
            name=self.name,
            title=words.title,
            level=Level.OK if kept else level,
            miss=miss,
            value=value,
            limit=limit,
            dimension=self.dimension,
            at_most=self.at_most,
            says="" if kept else says,
            remedy="" if kept else words.remedy,
            otherwise="" if kept else words.otherwise,
            short="" if kept else words.short,
            place=place,
            source=words.source,
            binding=self.binding,
            more=words.more,
        )


def not_checked(name: str, title: str, why: str, place: Place) -> Check:
    """Return a check that could not be made, with the reason."""
    return Check(
        name=name,
        title=title,
        level=Level.NOT_CHECKED,
        place=place,
        says=escaped(f"{title}: not checked, {why}."),
        short=why,
    )


def origin(provenance: Provenance) -> str:
    """Return where a limit came from, in words."""
    return str(provenance)


def idle(arc: WrapArc) -> bool:
    """Whether an arc hands nothing over: its pulley is not driven."""
    return idles(arc.entry_tension, arc.exit_tension)
