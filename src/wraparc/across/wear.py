"""Wear that follows the frictional energy, and changes what it follows."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from wraparc.across.modes import mode_response
from wraparc.across.result import AcrossResult
from wraparc.across.solver import AcrossSolver
from wraparc.across.wide_arc import WideArc
from wraparc.arrays import Array
from wraparc.drive.pitch import turns_an_hour
from wraparc.errors import InputError, Problem
from wraparc.units import display

#: steps of wear over a levelling depth, second order; 10 leave 0.2 % of what is levelled over one
_PER_DEPTH = 10
_MOST_STEPS = 60


@dataclass(frozen=True, eq=False, kw_only=True)
class WearHistory:
    """A lagging as it wears.

    Attributes
    ----------
    wide
        The arc at the beginning.
    mean_depth
        Depth worn off since then, mean over the width, shape (k,) [m].
    thickness
        Thickness of the lagging, shape (k, n) [m].
    entry_tension
        t1, shape (k, n) [N/m].
    energy
        Frictional energy per area and pass, shape (k, n) [J/m2].
    passes
        Passes of the belt, one a turn of the pulley, shape (k,); nan without a wear coefficient.
    ended
        Why it ended before it was asked to, as a sentence; empty if it did not.
    """

    wide: WideArc
    mean_depth: Array
    thickness: Array
    entry_tension: Array
    energy: Array
    passes: Array
    ended: str = ""

    @property
    def unevenness(self) -> Array:
        """Largest less least thickness, shape (k,) [m]."""
        return np.asarray(np.ptp(self.thickness, axis=1))

    @property
    def heals(self) -> bool:
        """Whether the lagging ends more even than it began."""
        return bool(self.unevenness[-1] < self.unevenness[0])

    @property
    def hours(self) -> Array:
        """Running time [h], shape (k,); nan without a wear coefficient or a belt speed."""
        speed = self.wide.arc.belt_speed
        hourly = math.nan if speed is None else turns_an_hour(speed, self.wide.pitch)
        return np.asarray(self.passes / hourly)

    def hours_to(self, thickness: float) -> float:
        """Running time until the thinnest strip is down to a thickness [m], inside the march [h].

        nan where it does not get there.
        """
        least = np.min(self.thickness, axis=1)
        if not least[-1] <= thickness <= least[0]:
            return math.nan
        return float(np.interp(-thickness, -least, self.hours))


def march_wear(
    wide: WideArc,
    depth: float | None = None,
    *,
    passes: float | None = None,
    coefficient: Array | float | None = None,
    least_thickness: float = 0.0,
    per_depth: int = _PER_DEPTH,
    solver: AcrossSolver | None = None,
) -> WearHistory:
    """Wear a lagging to a mean depth or a number of passes, each strip by its frictional energy.

    d h/d w = -k e / mean(k e), with the wear coefficient k by strip, to a depth w, or
    d h/d n = -k e to a number of passes n; midpoint rule in steps of a tenth of the levelling
    depth.

    Parameters
    ----------
    wide
        The arc to begin with.
    depth
        Depth to wear off, mean over the width, > 0 [m]; one of this and `passes`.
    passes
        Passes of the belt, one a turn of the pulley, > 0 [-].
    coefficient
        Worn volume per energy [m3/J] where it is not that of the lagging; by strip, shape (n,),
        where it is not everywhere the same: grit in a zone. Frictional energy alone tells nothing
        of it.
    least_thickness
        Thickness of the thinnest strip at which to stop [m].
    per_depth
        Steps over a levelling depth; 10 leave 0.2 % of what is levelled over one, 5 leave 0.7 %.
    solver
        How each state is solved.

    Returns
    -------
    WearHistory
        Ends early, saying why, where a strip wears through or the belt is no longer carried.

    Raises
    ------
    InputError
        If neither depth nor passes are given or both, or one is not positive, or passes are counted
        without a wear coefficient.
    """
    solver = solver or AcrossSolver()
    k = wide.arc.wear_coefficient if coefficient is None else coefficient
    rates = _rates(wide, depth, passes, k)
    at = solver.solve(wide)
    to = _extent(depth, passes, rates, at)
    level = np.min(np.abs(mode_response(wide, 4, even=at.even).levelling_depth))
    steps = int(min(max(math.ceil(to.depth * per_depth / level), 2), _MOST_STEPS))
    worn, results, ended = [0.0], [at], "" if at.status.solved else str(at.status)
    for _ in range(steps):
        if ended:
            break
        half = _thinner(at, 0.5 / steps, to, at)
        middle = solver.solve(half, start=at) if half is not None else None
        new = _thinner(at, 1.0 / steps, to, middle) if middle is not None else None
        if new is None or float(np.min(new.thickness)) < least_thickness:
            ended = "The thinnest strip is down to the minimum thickness."
            break
        if middle is None or not middle.status.solved:
            ended = "" if middle is None else str(middle.status)
            break
        worn.append(worn[-1] + float(np.mean(at.wide.thickness - new.thickness)))
        at = solver.solve(new, start=middle)
        if not at.status.solved:
            ended = str(at.status)
            worn.pop()
            break
        results.append(at)
    return _history(wide, worn, results, k, ended)


@dataclass(frozen=True)
class _Extent:
    """How far to wear: to a mean depth [m], or over a number of passes if there is one."""

    rates: Array
    depth: float
    passes: float | None

    def off(self, share: float, energy: Array) -> Array:
        """Depth worn off by strip over a share of the whole at an energy by strip [m]."""
        if self.passes is not None:
            return np.asarray(share * self.passes * self.rates * energy)
        return np.asarray(share * self.depth * self.rates * energy / np.mean(self.rates * energy))


def _rates(
    wide: WideArc, depth: float | None, passes: float | None, k: Array | float | None
) -> Array:
    """Return the wear coefficient by strip, 1 where only its shape matters."""
    problems = []
    if (depth is None) == (passes is None):
        message = "wear needs a mean depth or a number of passes"
        problems.append(Problem(key="depth", message=message, remedy="Give one of the two."))
    if depth is not None and not 0.0 < depth < math.inf:
        value = display(depth, "length")
        problems.append(Problem(key="depth", value=value, message="must be more than 0"))
    if passes is not None and not 0.0 < passes < math.inf:
        problems.append(Problem(key="passes", value=f"{passes:g}", message="must be more than 0"))
    if passes is not None and k is None:
        message = "the lagging has no wear coefficient"
        remedy = "Give the coefficient, or wear to a mean depth."
        problems.append(Problem(key="passes", message=message, remedy=remedy))
    if problems:
        raise InputError(problems)
    return np.ones(wide.strips) * (1.0 if k is None else k)


def _extent(depth: float | None, passes: float | None, rates: Array, at: AcrossResult) -> _Extent:
    if depth is not None:
        return _Extent(rates, depth, None)
    count = passes or 0.0
    return _Extent(rates, count * float(np.mean(rates * at.frictional_energy)), count)


def _thinner(
    at: AcrossResult, share: float, to: _Extent, by: AcrossResult | None
) -> WideArc | None:
    """The arc with a share more worn off; None where a strip would be worn through."""
    if by is None:
        return None
    off = to.off(share, by.frictional_energy)
    return at.wide.worn(off) if np.all(at.wide.thickness - off > 0.0) else None


def _history(
    wide: WideArc,
    worn: list[float],
    results: list[AcrossResult],
    k: Array | float | None,
    ended: str,
) -> WearHistory:
    depth = np.array(worn)
    energy = np.array([r.frictional_energy for r in results])
    passes = np.full(len(worn), math.nan)
    if k is not None:
        per_pass = np.mean(k * energy, axis=1)
        slow = 0.5 * (1.0 / per_pass[1:] + 1.0 / per_pass[:-1])
        passes = np.concatenate([[0.0], np.cumsum(np.diff(depth) * slow)])
    return WearHistory(
        wide=wide,
        mean_depth=depth,
        thickness=np.array([r.wide.thickness for r in results]),
        entry_tension=np.array([r.entry_tension for r in results]),
        energy=energy,
        passes=passes,
        ended=ended,
    )


def measured_coefficient(result: AcrossResult, depth: float, hours: float) -> float:
    """Wear coefficient that has worn a lagging by a mean depth in a running time [m3/J].

    k = depth / (passes mean(e)), with the energy as it is now.

    Parameters
    ----------
    result
        The pulley as it is now; its drive knows the speed of the belt.
    depth
        Depth worn off since the lagging was new, mean over the width, > 0 [m].
    hours
        Running time since then, > 0 [h].

    Raises
    ------
    InputError
        If one is not positive, or the speed of the belt is not known.
    """
    arc = result.wide.arc
    problems = []
    if not 0.0 < depth < math.inf:
        message = "nothing is worn off yet"
        remedy = "Give the worn depth, or leave the hours out."
        problems.append(Problem(key="hours", message=message, remedy=remedy))
    if not 0.0 < hours < math.inf:
        message = "must be more than 0"
        problems.append(Problem(key="hours", value=f"{hours:g} h", message=message))
    if not arc.belt_speed:
        remedy = "Give the belt speed."
        problems.append(Problem(key="belt.speed", message="missing", remedy=remedy))
    if problems or not arc.belt_speed:
        raise InputError(problems)
    passes = hours * turns_an_hour(arc.belt_speed, result.wide.pitch)
    return depth / (passes * float(np.mean(result.frictional_energy)))
