"""The 95 % interval of an arc's creep that the uncertainty of its fitted law leaves."""

from __future__ import annotations

import math
from bisect import bisect

import numpy as np

from wraparc.arc.answer import operating_point
from wraparc.arc.quantities import SOLVED
from wraparc.arc.wrap_arc import WrapArc
from wraparc.arrays import Array
from wraparc.drive import Fit, knots_of, with_peaks
from wraparc.friction import FrictionLaw, PressureKnots

nan = math.nan
#: Step of a slope, in standard deviations of the parameter.
_STEP = 0.5


def creep_interval(arc: WrapArc) -> tuple[float, float]:
    """Return the 95 % interval of the creep at the exit [m], the tensions as they are.

    The slopes of the creep over the logarithms of the law's peaks, with their covariance, tell in
    which direction the law is most and least favourable. There the arc is solved again, with the
    laws that lie the coverage factor of the fit times the standard deviation away. An end that the
    friction does not carry is infinite.

    Parameters
    ----------
    arc
        A solved arc.

    Returns
    -------
    low, high
        The ends; nan where the law has no statistics of its knots, or breaks away itself.
    """
    laws = laws_at_ends(arc)
    if laws is None:
        return nan, nan
    ends = [_creep_under(arc, law) for law in (arc.law, *laws)]
    return min(ends), max(ends)


def _creep_under(arc: WrapArc, law: FrictionLaw) -> float:
    """Return the creep at the exit under a law [m], infinite where it does not carry the load."""
    load = arc.load()
    found = operating_point(law.compact(), arc.geometry(), load.entry_tension, load.exit_tension)
    if found.outcome != SOLVED:
        return math.copysign(math.inf, arc.side)
    return found.met.course.creep[-1]


def laws_at_ends(arc: WrapArc) -> tuple[FrictionLaw, ...] | None:
    """Return the laws at the ends of the interval, see `creep_interval`; none if it has no width.

    None where the law has no statistics of its knots, or breaks away itself.
    """
    fit, law, knots = arc.fit, arc.law, knots_of(arc.law)
    if fit is None or knots is None or not fit.knots:
        return None
    if not all(0 <= place < len(knots.pressure) for place, _ in fit.knots):
        return None
    peaks = np.array([getattr(knots, quantity)[place] for place, quantity in fit.knots])

    def moved(logs: Array) -> FrictionLaw:
        return with_peaks(law, dict(zip(fit.knots, (peaks * np.exp(logs)).tolist(), strict=True)))

    creep = _creep_under(arc, law)
    if math.isinf(creep):
        return None
    covariance, slopes = fit.log_covariance, np.zeros(len(peaks))
    first, last = felt_knots(arc, knots)
    for i, (place, _) in enumerate(fit.knots):
        step = np.zeros(len(peaks))
        step[i] = step_of(fit, i)
        if not first <= place <= last or step[i] == 0.0:
            continue
        slopes[i] = (_creep_under(arc, moved(step)) - creep) / step[i]
    deviation = math.sqrt(max(float(slopes @ covariance @ slopes), 0.0))
    if deviation == 0.0:
        return ()
    way = fit.coverage_factor / deviation * (covariance @ slopes)
    return moved(-way), moved(way)


def step_of(fit: Fit, i: int) -> float:
    """Return the step of a slope over the logarithm of a fitted peak [-]; 0 where it is exact.

    To more friction, or earlier friction: such an arc is solved where this one is.
    """
    spread = math.sqrt(max(float(fit.log_covariance[i, i]), 0.0))
    return _STEP * spread * (1.0 if fit.knots[i][1] == "peak_friction" else -1.0)


def felt_knots(arc: WrapArc, knots: PressureKnots) -> tuple[int, int]:
    """Return the first and the last knot that the pressures along an arc can feel.

    A monotone cubic between two knots takes its slopes from the knots beside them.
    """
    slack, tight = sorted((arc.entry_tension, arc.exit_tension))
    first = bisect(knots.pressure, arc.wrap_pressure(slack)) - 2
    return first, bisect(knots.pressure, arc.wrap_pressure(tight)) + 1
