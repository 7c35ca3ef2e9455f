"""How much more pull until gross slip: by what the take-up holds."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property

from wraparc.arc import ArcResult, DriveResult, WrapArc
from wraparc.arc.kernel.gross_slip import largest_ratio, plateau_capacity

nan, inf = math.nan, math.inf
_STEPS = 24
#: Shares of the rise of pull that the tight end gives up when the take-up holds each.
SLACK_HELD, BOTH_HELD, TIGHT_HELD = 0.0, 0.5, 1.0
_TOLERANCE = 1e-10
_ROUNDS = 200


class Grip:
    """Largest ln(tight/slack) that the friction of an arc can carry, by tension of the tight side.

    A law flat past its peak has it in closed form. Where friction falls past its peak the largest
    ratio is sought at one tension, and taken from there to others as the plateau changes.

    Parameters
    ----------
    arc
        The arc; its tensions say where to seek.
    ratio
        Its gross-slip capacity where that is known already [-].
    """

    def __init__(self, arc: WrapArc, ratio: float = nan) -> None:
        self._law, self._arc = arc.law.compact(), arc
        #: Whether friction falls past its peak, so that the offset holds near one tension only.
        self.softens = arc.law.steepest_fall() < 0.0
        self._area = arc.width * arc.radius
        self._known = math.log(ratio) if ratio > 0.0 else nan
        self._at = max(arc.entry_tension, arc.exit_tension)

    @cached_property
    def _offset(self) -> float:
        if not self.softens:
            return 0.0
        known = self._known
        if math.isnan(known):
            geometry = self._arc.geometry()
            known = largest_ratio(self._law, geometry, self._at, True, _STEPS)[0]
        return known - self._plateau(self._at)

    def _plateau(self, tight: float) -> float:
        return plateau_capacity(self._law, tight / self._area, self._arc.wrap_angle)

    def __call__(self, tight: float) -> float:
        """Return ln(tight/slack) at gross slip for a tension of the tight side [N]."""
        return max(self._plateau(tight) + self._offset, 0.0)

    def tight_for(self, pull: float) -> float:
        """Return the tension of the tight side that just carries a pull at gross slip [N].

        The root of T (1 - exp(-q(T))) = pull; inf if no tension carries it.
        """
        if pull <= 0.0:
            return 0.0
        return _root(lambda t: t * -math.expm1(-self(t)) - pull, pull, 1e4 * pull)


@dataclass(frozen=True)
class Rise:
    """How the tensions of an arc grow with the pull of the whole drive, the take-up holding.

    Attributes
    ----------
    tight, slack
        Growth of the tight and the slack side per growth of the pull [N].
    """

    tight: float
    slack: float


def rises(arcs: Sequence[ArcResult], index: int, held: float = SLACK_HELD) -> Rise:
    """Return how the tensions of one of the arcs of a load case grow with the whole pull.

    Every pulley keeps its share; the take-up is on the slack side of the whole drive.

    Parameters
    ----------
    arcs
        All arcs of the load case, in belt order.
    index
        Which.
    held
        Part of the growth that the tight end gives up: `SLACK_HELD`, `BOTH_HELD` or `TIGHT_HELD`.
    """
    pulls = [r.arc.effective_tension for r in arcs]
    total = math.fsum(pulls)
    if total >= 0.0:
        entry, leaving = math.fsum(pulls[index:]), math.fsum(pulls[index + 1 :])
    else:
        entry, leaving = -math.fsum(pulls[:index]), -math.fsum(pulls[: index + 1])
    entry, leaving = entry - held * abs(total), leaving - held * abs(total)
    if arcs[index].arc.side > 0.0:
        return Rise(entry, leaving)
    return Rise(leaving, entry)


def pull_factor(arc: WrapArc, grip: Grip, rise: Rise) -> float:
    """Pull at gross slip over the pull of the load case, the whole drive growing alike [-].

    The root k of ln(T_tight(k)/T_slack(k)) = q(T_tight(k)); inf if it never slips.
    """
    tight = max(arc.entry_tension, arc.exit_tension)
    slack = min(arc.entry_tension, arc.exit_tension)
    if tight == slack:
        return inf

    def miss(k: float) -> float:
        t, s = tight + (k - 1.0) * rise.tight, slack + (k - 1.0) * rise.slack
        if s <= 0.0 or t <= 0.0:
            return 50.0
        return math.log(t / s) - grip(t)

    return _root(miss, 0.0, 1e4)


def _root(miss: Callable[[float], float], low: float, high: float) -> float:
    """Smallest root that bracketing from below finds; inf if there is none up to `high`."""
    a, f_a = low, miss(low) if low else -1.0
    step = max(low, 1.0)
    b = a + step
    f_b = miss(b)
    while f_b < 0.0:
        a, f_a = b, f_b
        step *= 1.6
        b += step
        if b > high:
            return inf
        f_b = miss(b)
    side = 0
    for _ in range(_ROUNDS):  # false position (Illinois)
        if b - a <= _TOLERANCE * b:
            break
        c = (a * f_b - b * f_a) / (f_b - f_a)
        if not a < c < b:
            c = 0.5 * (a + b)
        f = miss(c)
        if abs(f) < 1e-14:
            return c
        if f < 0.0:
            a, f_a = c, f
            f_b = 0.5 * f_b if side < 0 else f_b
            side = -1
        else:
            b, f_b = c, f
            f_a = 0.5 * f_a if side > 0 else f_a
            side = 1
    return 0.5 * (a + b)


@dataclass(frozen=True)
class Margins:
    """Pull at gross slip over the pull, by what the take-up holds [-].

    Attributes
    ----------
    slack_held
        Gravity take-up or winch: the slack side keeps its tension.
    both_held
        Fixed take-up: the sum of both keeps.
    tight_held
        The tight side keeps its tension.
    """

    slack_held: float
    both_held: float
    tight_held: float

    def of(self, *, fixed: bool) -> float:
        """Return the margin of a take-up."""
        return self.both_held if fixed else self.slack_held


def margins(arcs: Sequence[ArcResult], index: int, grip: Grip) -> Margins:
    """Return the margins of one of the arcs of a load case to gross slip."""
    arc = arcs[index].arc
    found = (pull_factor(arc, grip, rises(arcs, index, h)) for h in (0.0, 0.5, 1.0))
    return Margins(*found)


def grip_of(result: ArcResult) -> Grip:
    """Return what the friction of a solved arc can carry."""
    return Grip(result.arc, result.capacities.gross_slip_capacity)


def margins_of(result: DriveResult, arc: ArcResult) -> Margins:
    """Return the margins to gross slip of an arc among the others of its load case."""
    arcs = [a for a in result if a.arc.load_case == arc.arc.load_case]
    return margins(arcs, arcs.index(arc), grip_of(arc))
