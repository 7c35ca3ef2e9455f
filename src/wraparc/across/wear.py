"""Wear that follows the frictional energy, and changes what it follows."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from wraparc.across.modes import mode_response
from wraparc.across.result import AcrossResult
from wraparc.across.solver import AcrossSolver
from wraparc.across.wide_arc import Array, WideArc

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
        per_pass = math.nan if speed is None else math.pi * self.wide.arc.diameter / speed
        return np.asarray(self.passes * per_pass / 3600.0)

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
    depth: float,
    *,
    coefficient: Array | None = None,
    least_thickness: float = 0.0,
    solver: AcrossSolver | None = None,
) -> WearHistory:
    """Wear a lagging down to a mean depth, each strip in proportion to its frictional energy.

    d h/d w = -k e / mean(k e), with the wear coefficient k by strip; midpoint rule in steps of a
    tenth of the levelling depth.

    Parameters
    ----------
    wide
        The arc to begin with.
    depth
        Depth to wear off, mean over the width, > 0 [m].
    coefficient
        Worn volume per energy by strip, shape (n,) [m3/J], where it is not everywhere that of the
        lagging: grit in a zone. Frictional energy alone tells nothing of it.
    least_thickness
        Thickness of the thinnest strip at which to stop [m].
    solver
        How each state is solved.

    Returns
    -------
    WearHistory
        Ends early, saying why, where a strip wears through or the belt is no longer carried.
    """
    solver = solver or AcrossSolver()
    level = np.min(np.abs(mode_response(wide, 4).levelling_depth))
    steps = int(min(max(math.ceil(depth / (level / _PER_DEPTH)), 2), _MOST_STEPS))
    step = depth / steps
    relative = np.ones(wide.strips) if coefficient is None else coefficient / np.mean(coefficient)
    at = solver.solve(wide)
    worn, results, ended = [0.0], [at], "" if at.status.solved else str(at.status)
    for _ in range(steps):
        if ended:
            break
        half = _thinner(at, 0.5 * step, relative, at)
        middle = solver.solve(half, start=at) if half is not None else None
        new = _thinner(at, step, relative, middle) if middle is not None else None
        if new is None or float(np.min(new.thickness)) < least_thickness:
            ended = "The thinnest strip is down to the least thickness."
            break
        if middle is None or not middle.status.solved:
            ended = "" if middle is None else str(middle.status)
            break
        at = solver.solve(new, start=middle)
        if not at.status.solved:
            ended = str(at.status)
            break
        worn.append(worn[-1] + step)
        results.append(at)
    return _history(wide, worn, results, coefficient, ended)


def _thinner(
    at: AcrossResult, depth: float, relative: Array, by: AcrossResult | None
) -> WideArc | None:
    """The arc with a mean depth more worn off; None where a strip would be worn through."""
    if by is None:
        return None
    rate = relative * by.frictional_energy
    off = depth * rate / np.mean(rate)
    return at.wide.worn(off) if np.all(at.wide.thickness - off > 0.0) else None


def _history(
    wide: WideArc,
    worn: list[float],
    results: list[AcrossResult],
    coefficient: Array | None,
    ended: str,
) -> WearHistory:
    depth = np.array(worn)
    energy = np.array([r.frictional_energy for r in results])
    k: Array | float | None = wide.arc.wear_coefficient if coefficient is None else coefficient
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
