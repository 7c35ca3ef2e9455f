"""Friction as test reports state it: static, kinetic, and at standard slips, by pressure.

After ISO 8295 and ASTM D1894 the static coefficient is that of the first peak, the kinetic one
the mean while sliding goes on, each with mean and standard deviation over the specimens. Here
the peak comes after millimetres of creep, not at the start; kinetic is the mean over the slip
behind the peak, which is stated. Everything is read off the measured curves; only what no
test has reached is taken from the law, and marked.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from wraparc.arrays import Array
from wraparc.shear_test.analysis import ConditionResult, TestResult
from wraparc.shear_test.lash import is_s_shaped, lash_errors, lash_in_friction

#: Slips that design values of friction are compared at [m]; 6.35 mm is a quarter inch.
STANDARD_SLIPS = (1e-3, 2e-3, 4e-3, 6.35e-3, 10e-3)
# Share of a slip on either side that is averaged over: within it the curves are straight.
_BESIDE = 0.05
# Kinetic friction: from this many peak slips on, over at least this part of one.
_PAST_PEAK, _LEAST_SPAN = 1.25, 0.25


@dataclass(frozen=True, kw_only=True)
class Statistic:
    """Values of several tests.

    Parameters
    ----------
    mean
        NaN if there is none.
    deviation
        Standard deviation between tests, n - 1 in its denominator; NaN of fewer than two.
    count
        How many tests.
    """

    mean: float
    deviation: float
    count: int

    @classmethod
    def of(cls, values: Iterable[float]) -> "Statistic":
        """Return the statistic of the values that are numbers."""
        known = [value for value in values if np.isfinite(value)]
        return cls(
            mean=float(np.mean(known)) if known else np.nan,
            deviation=float(np.std(known, ddof=1)) if len(known) > 1 else np.nan,
            count=len(known),
        )


@dataclass(frozen=True, kw_only=True)
class StandardValues:
    """Friction at one pressure.

    Parameters
    ----------
    pressure
        Mean of the tests [Pa].
    tests
        How many.
    static
        Largest friction of each test.
    rising
        Tests whose friction still rose at their end: their static friction is more.
    kinetic
        Mean friction behind the peak.
    kinetic_slip
        Slips that the kinetic friction was averaged between [m], least and most over the tests;
        NaN where no test goes far enough past its peak.
    at_slip
        Friction at each of `STANDARD_SLIPS`, of the tests that reached it.
    beyond
        The law there, for slips that no test has reached; NaN elsewhere.
    """

    pressure: float
    tests: int
    static: Statistic
    rising: int
    kinetic: Statistic
    kinetic_slip: tuple[float, float]
    at_slip: tuple[Statistic, ...]
    beyond: tuple[float, ...]


def standard_values(condition: ConditionResult) -> tuple[StandardValues, ...]:
    """Return static, kinetic friction and that at standard slips, for each pressure.

    Every test that was used counts, those too that disagree with their repeats.
    """
    found = condition.found
    groups = [
        [test for test, own in zip(found.tests, found.levels, strict=True) if own == level]
        for level in np.unique(found.levels)
    ]
    return tuple(_of_pressure(condition, group) for group in groups)


def _of_pressure(condition: ConditionResult, tests: Sequence[TestResult]) -> StandardValues:
    pressure = float(np.mean([test.curve.pressure for test in tests]))
    spans = [span for test in tests if (span := kinetic_span(test)) is not None]
    at_slip = tuple(
        Statistic.of(friction_at(test, slip) for test in tests) for slip in STANDARD_SLIPS
    )
    law = condition.tested_law
    return StandardValues(
        pressure=pressure,
        tests=len(tests),
        static=Statistic.of(static_friction(test) for test in tests),
        rising=sum(not test.fit.peak_inside for test in tests),
        kinetic=Statistic.of(kinetic_friction(test) for test in tests),
        kinetic_slip=(min(s[0] for s in spans), max(s[1] for s in spans))
        if spans
        else (np.nan, np.nan),
        at_slip=at_slip,
        beyond=tuple(
            np.nan if known.count else float(law.friction(slip, pressure))
            for slip, known in zip(STANDARD_SLIPS, at_slip, strict=True)
        ),
    )


def law_at_slips(condition: ConditionResult) -> tuple[Array, Array]:
    """Return the law at the standard slips, and its expanded uncertainty.

    Up to the peak ln mu = ln mu_pk + ln r + ln(1 - ln r) with r = x/x_pk, so that
    d ln mu = d ln mu_pk + ln r/(1 - ln r) d ln x_pk; past it the uncertainty is that of the peak.
    What the lash of the tests is uncertain by is added, as a slip.

    Returns
    -------
    friction, expanded
        Of every pressure and slip, shape (n, 5) each [-]; the uncertainty is nan for a law of one
        pressure.
    """
    pressure, slips = condition.found.level_pressures(), np.array(STANDARD_SLIPS)
    friction = condition.tested_law.friction(slips[None, :], pressure[:, None])
    if condition.fit is None:
        return friction, np.full(friction.shape, np.nan)
    ln_r = np.minimum(np.log(slips) - condition.fit.peaks(pressure)[:, :1], 0.0)
    by_peak = np.stack([ln_r / (1.0 - ln_r), np.ones_like(ln_r)], axis=-1)
    covariance = condition.fit.own_covariance(pressure)
    variance = np.einsum("nsi,nij,nsj->ns", by_peak, covariance, by_peak)
    found = condition.found
    by_lash, s_shaped = [], is_s_shaped(found.tests)
    for level, peak in zip(np.unique(found.levels), condition.fit.peaks(pressure), strict=True):
        tests = [t for t, own in zip(found.tests, found.levels, strict=True) if own == level]
        slip, top = (float(value) for value in np.exp(peak))
        by_lash.append(lash_in_friction(slips, slip, top, lash_errors(tests, s_shaped=s_shaped)))
    spread = np.hypot(np.sqrt(variance) * friction, by_lash)
    return friction, condition.fit.coverage_factor * spread


def friction_at(test: TestResult, slip: float) -> float:
    """Measured friction at a slip [m]: mean over 5 % of it to either side; NaN beyond the test.

    Parameters
    ----------
    test
        The test; lash, bending and the force's zero are taken off as its fit found them.
    slip
        [m].
    """
    if slip > test.fit.slip_max:
        return float("nan")
    low, high = slip * (1.0 - _BESIDE), min(slip * (1.0 + _BESIDE), test.fit.slip_max)
    inside = (test.fit.slip >= low) & (test.fit.slip <= high)
    if inside.sum() < 2:
        order = np.argsort(test.fit.slip)
        return float(np.interp(slip, test.fit.slip[order], test.fit.friction[order]))
    return _mean(test, inside)


def static_friction(test: TestResult) -> float:
    """Largest measured friction, as the mean over 5 % of the slip around the highest bin."""
    order = np.argsort(test.fit.slip)
    slip, friction = test.fit.slip[order], test.fit.friction[order]
    width = max(1, len(slip) // 50)
    smooth = np.convolve(friction, np.ones(width) / width, mode="same")
    edge = width // 2
    top = edge + int(np.argmax(smooth[edge : len(smooth) - edge]))
    return friction_at(test, float(slip[top]))


def kinetic_span(test: TestResult) -> tuple[float, float] | None:
    """Slips between which friction counts as kinetic [m]; None if the test ends before."""
    peak, end = test.fit.parameters.peak_slip, test.fit.slip_max
    first = _PAST_PEAK * peak
    return (first, end) if end - first >= _LEAST_SPAN * peak else None


def kinetic_friction(test: TestResult) -> float:
    """Mean measured friction behind the peak, by slip; NaN where the test ends before."""
    span = kinetic_span(test)
    if span is None:
        return float("nan")
    inside = (test.fit.slip >= span[0]) & (test.fit.slip <= span[1])
    return _mean(test, inside) if inside.any() else float("nan")


def _mean(test: TestResult, inside: "np.ndarray[tuple[int], np.dtype[np.bool_]]") -> float:
    """Mean by slip, not by bin: bins are narrow where the friction starts to rise."""
    order = np.argsort(test.fit.slip[inside])
    slip: Array = test.fit.slip[inside][order]
    friction: Array = test.fit.friction[inside][order]
    span = float(slip[-1] - slip[0])
    if span <= 0.0:
        return float(friction.mean())
    return float(np.trapezoid(friction, slip)) / span
