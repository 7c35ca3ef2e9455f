"""What follows from the posterior: change, reserve, when it is used up, the alarm line."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from wraparc.arrays import Array
from wraparc.learn.curves import FRICTION
from wraparc.learn.episodes import PROMISE, YEAR, Episodes
from wraparc.learn.fit import LearnFit
from wraparc.learn.grid import STEP
from wraparc.learn.levels import FrictionDraws, evenly
from wraparc.learn.windows import WINDOW, Windows

#: Half an interval of 95 % over the standard deviation.
Z95 = 1.959964
#: Parts of the reserve lost at which alarm and trip stand, and spreads above normal at least.
ALARM, TRIP = (0.5, 6.0), (0.8, 10.0)
#: A date is told up to so many times the length of the log.
FARTHEST = 3.0
_TAIL = 30
#: Load points of the alarm line over rated torque [-].
LOADS = np.arange(0.1, 1.21, 0.1)


@dataclass(frozen=True)
class Interval:
    """A value with its interval of 95 %."""

    value: float
    low: float
    high: float

    @property
    def excludes_zero(self) -> bool:
        """Whether 0 is outside."""
        return self.low > 0.0 or self.high < 0.0


@dataclass(frozen=True, eq=False)
class AlarmLine:
    """Speed differences that alarm and trip, by torque over the rated one [-].

    Attributes
    ----------
    torque
        Load points.
    normal, alarm, trip
        Differences there.
    false_alarms
        How many a running year are expected, and at most by what the promise missed in trials.
    """

    torque: Array
    normal: Array
    alarm: Array
    trip: Array
    false_alarms: tuple[float, float]

    def at(self, torque: float, which: str = "alarm") -> float:
        """Return a level at a torque [-]."""
        return float(np.interp(torque, self.torque, getattr(self, which)))


@dataclass(frozen=True, eq=False)
class UsedUp:
    """When the friction reserve is used up at the present rate.

    Attributes
    ----------
    rate
        Change of ln friction a day.
    earliest, expected
        Days after the end of the log; inf where it does not fall, nan where it cannot be told.
    is_told
        Whether the fall is certain: its interval excludes 0.
    horizon
        Days up to which a date is told.
    """

    rate: Interval
    earliest: float
    expected: float
    is_told: bool
    horizon: float


def interval_of(fit: LearnFit, rows: Array, more: float = 0.0) -> Interval:
    """Return a sum of unknowns with its interval; `more` is a further standard deviation."""
    value = float((rows @ fit.unknowns)[0])
    sd = math.hypot(float(fit.spread(rows)[0]), more)
    return Interval(value, value - Z95 * sd, value + Z95 * sd)


def as_factor(of: Interval) -> Interval:
    """Return an interval of a logarithm as that of the factor."""
    return Interval(math.exp(of.value), math.exp(of.low), math.exp(of.high))


def draws_interval(of: Array, more: float = 0.0) -> Interval:
    """Return the interval of draws, shape (n,); `more` is a further standard deviation."""
    low, middle, high = np.quantile(of + more * evenly(len(of)), [0.025, 0.5, 0.975])
    return Interval(float(middle), float(low), float(high))


@dataclass(frozen=True, eq=False)
class FrictionReserve:
    """ln friction less that at which the belt slides through, at the end of the log.

    Attributes
    ----------
    interval
        By the draws, None where no friction that is tabled lets it slide.
    best
        At the maximum of the posterior, nan where none.
    """

    interval: Interval | None
    best: float


def reserve_of(
    fit: LearnFit, draws: FrictionDraws, pulley: int, torque: Array, stop: float, shape: float
) -> FrictionReserve:
    """Return how far friction may fall until the belt slides through.

    Parameters
    ----------
    fit, draws
        The posterior, at its maximum and in draws.
    pulley
        Place of the pulley.
    torque
        Highest torque seen of each pulley [-], shape (k,).
    stop
        End of the log [days].
    shape
        Standard deviation of what the law misses between two slips [-], of the logarithm of the
        reserve: nothing at gross slip, the more the farther the slip of now is from it.
    """
    name, model = fit.model.names[pulley], fit.model
    row = fit.weights("friction", name, np.array([stop]))

    def reserve(x: Array) -> float:
        nuisance = fit.nuisance(x)
        pull, behind = model.tensions(torque[:, None], nuisance, 0.0)
        slips = model.tables[pulley].friction_at_slip(
            float(pull[pulley, 0]), float(behind[pulley, 0]), nuisance
        )
        friction = float(np.clip((row @ x)[0], FRICTION[0], FRICTION[-1]))
        return friction - slips

    best = reserve(fit.unknowns)
    found = np.array([reserve(x) for x in draws.unknowns])
    found = found[np.isfinite(found)]
    if not math.isfinite(best) or len(found) < len(draws.unknowns) // 2:
        return FrictionReserve(None, math.nan)
    return FrictionReserve(draws_interval(found, shape * abs(float(np.median(found)))), best)


def used_up(
    fit: LearnFit,
    draws: FrictionDraws,
    pulley: int,
    reserve: Interval | None,
    start: float,
    stop: float,
) -> UsedUp:
    """Return when the reserve is used up, by a line through friction since `start` [days]."""
    name = fit.model.names[pulley]
    days = np.linspace(start, stop - 1e-9, 25)
    centred = days - days.mean()
    weights = (centred / float(centred @ centred))[None, :] @ fit.weights("friction", name, days)
    rate = draws_interval(draws.of(weights)[:, 0])
    horizon = FARTHEST * (stop - start)
    if reserve is None:
        return UsedUp(rate, math.nan, math.nan, False, horizon)
    earliest = reserve.low / -rate.low if rate.low < 0.0 else math.inf
    expected = reserve.value / -rate.value if rate.value < 0.0 else math.inf
    return UsedUp(rate, max(earliest, 0.0), max(expected, 0.0), rate.high < 0.0, horizon)


def alarm_line(
    fit: LearnFit,
    pulley: int,
    windows: Windows,
    episodes: Episodes,
    reserve: float,
    stop: float,
) -> AlarmLine:
    """Return the line at which to alarm by torque, over the zero at the end of the log [days].

    `reserve` is that at the maximum of the posterior, whose curve is what the log shows; nan where
    none is told.
    """
    mean = windows.torque.mean(axis=1)
    torque = np.array([LOADS * m / mean[pulley] for m in mean])  # others at the share they had
    days = np.full(len(LOADS), stop - 1e-9)
    zero = fit.course("zero", days)[pulley]
    normal = zero + fit.curve(torque, days, 0.0)[pulley]
    spread = float(episodes.spread[pulley])

    def level(lost: float, over: float) -> Array:
        least = normal + over * spread
        if not reserve > 0.0:
            return np.asarray(least)
        worn = zero + fit.curve(torque, days, 0.0, -lost * reserve)[pulley]
        return np.asarray(np.maximum(worn, least))

    alarm = level(*ALARM)
    trip = np.maximum(level(*TRIP), alarm)
    room = np.interp(windows.torque[pulley], LOADS, alarm - normal)
    return AlarmLine(LOADS, normal, alarm, trip, _false_alarms(windows, episodes, pulley, room))


def _false_alarms(
    windows: Windows, episodes: Episodes, pulley: int, room: Array
) -> tuple[float, float]:
    """Return how often noise passes the line a running year: by the tail of its mirror image."""
    years = len(windows.time) * WINDOW * STEP / YEAR
    noise = np.sort((-episodes.residual[pulley] / room)[~episodes.low])[::-1]
    count = min(_TAIL, len(noise) - 1)
    if count < 9 or years <= 0.0:
        return 0.0, math.inf
    rate = count / float(np.sum(noise[:count] - noise[count]))
    expected = count / years * math.exp(min(0.0, -rate * (1.0 - float(noise[count]))))
    return expected, PROMISE * expected
