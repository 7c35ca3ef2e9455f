"""Travel taken as lash: how much, what rises within it, and what it makes uncertain.

The law rises most steeply where the slip starts. A curve that starts like an S rises before: the
fit takes its slow part as lash of the rig, and friction at small slips comes out too high.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from wraparc.arrays import Array
from wraparc.shear_test.analysis import TestResult
from wraparc.shear_test.curve_fit import CurveFit
from wraparc.shear_test.misfit import Misfit
from wraparc.shear_test.reduce import FrictionCurve
from wraparc.units import Cell, quantity

# Readings in each third of the lash that tell a rise; rise over the largest friction, and over
# its standard error, that no flat start has; of all tests together, and of one. Ours.
_READINGS, _RISE, _CLEAR = 3, 0.024, 5.0
_CLEAR_ALONE = 8.0
# Range of the lash of the tests of one rig beyond which it is asked about [m]. Ours.
_RANGE = 1e-3
#: Lash below which nothing is said of it [m]. Ours.
LEAST_LASH = 0.02e-3


class Rise(NamedTuple):
    """Rise of friction within the lash, and its standard error, over the largest friction [-]."""

    share: float
    error: float


def rise_in_lash(curve: FrictionCurve, fit: CurveFit) -> Rise | None:
    """Return how much friction rises within the travel that was taken as lash.

    Mean of its last third less that of its first, of which the law has none.

    Parameters
    ----------
    curve, fit
        A curve and its fit.

    Returns
    -------
    None where too few readings stand there.
    """
    lash = fit.parameters.lash
    if "lash" not in fit.free or lash < LEAST_LASH:
        return None
    inside = curve.travel < lash
    first, last = inside & (curve.travel < lash / 3.0), inside & (curve.travel > lash / 1.5)
    counts = int(first.sum()), int(last.sum())
    if min(counts) < _READINGS:
        return None
    rise = float(curve.friction[last].mean() - curve.friction[first].mean())
    error = curve.noise * float(np.sqrt(1.0 / counts[0] + 1.0 / counts[1]))
    return Rise(rise / curve.top, max(error / curve.top, 1e-4))


def is_s_shaped(tests: Sequence[TestResult]) -> bool:
    """Return whether friction rises within the lash of the tests, as an S does.

    Parameters
    ----------
    tests
        Of one condition.
    """
    rises = [r for t in tests if (r := rise_in_lash(t.curve, t.fit)) is not None]
    if not rises:
        return False
    share = float(np.mean([r.share for r in rises]))
    error = float(np.sqrt(np.sum([r.error**2 for r in rises]))) / len(rises)
    clear = _CLEAR if len(rises) > 1 else _CLEAR_ALONE
    return share > _RISE and share > clear * error


def lash_sentences(tests: Sequence[TestResult]) -> list[str]:
    """Say where the start of the curves is no lash, or not that of one rig.

    Parameters
    ----------
    tests
        Of one condition.
    """
    found: list[str] = []
    low, high = lash_range(tests)
    if is_s_shaped(tests):
        shares = [r.share for t in tests if (r := rise_in_lash(t.curve, t.fit)) is not None]
        text = (
            f"friction rises by {100 * float(np.mean(shares)):.1f} % of its maximum within the "
            f"{Cell(high, 'length', 3, 'to', low)} that were taken as lash: the curves start like "
            "an S, which the law does not, and friction at small slips may be that much of travel "
            "off; the sample or a clamp seats itself, or the lagging starts to slip so"
        )
        head = f"the force rises within the {quantity(high, 'length', 2)} taken as lash"
        found.append(
            Misfit(text, head, "Measure the slip at the sample, or preload the clamp further.")
        )
    elif high - low > _RANGE:
        text = (
            f"the lash taken off differs from test to test of one rig, "
            f"{Cell(high, 'length', 3, 'to', low)}: see whether a clamp slips, or the record of a "
            "test starts late"
        )
        head = f"lash differs between tests by {quantity(high - low, 'length', 2)}"
        found.append(Misfit(text, head, "Check the clamps, and where each record starts."))
    return found


def lash_range(tests: Sequence[TestResult]) -> tuple[float, float]:
    """Return the least and the largest lash that was taken off [m]; 0 where none was fitted."""
    lashes = [t.fit.parameters.lash for t in tests if "lash" in t.fit.free]
    lashes = [max(lash, 0.0) for lash in lashes] or [0.0]
    return min(lashes), max(lashes)


def lash_errors(tests: Sequence[TestResult], *, s_shaped: bool) -> tuple[float, float]:
    """Return what the lash of the tests is uncertain by [m].

    Parameters
    ----------
    tests
        Of one pressure.
    s_shaped
        Whether the curves of all pressures together start like an S: a few of them tell it less.

    Returns
    -------
    statistical
        Standard error of its mean.
    bound
        Travel that may be slip where the curves start like an S: all that was taken as lash.
    """
    errors = [t.fit.error("lash") for t in tests]
    statistical = float(np.sqrt(np.sum(np.square(errors)))) / len(errors)
    return statistical, lash_range(tests)[1] if s_shaped else 0.0


def lash_in_friction(
    slips: Array, slip: float, friction: float, errors: tuple[float, float]
) -> Array:
    """Return the standard uncertainty of friction at slips that the lash makes [-].

    Parameters
    ----------
    slips
        [m], shape (n,).
    slip, friction
        Of the peak [m, -].
    errors
        From `lash_errors`.
    """

    def law(at: Array) -> Array:
        r = np.clip(at / slip, 1e-9, 1.0)
        return np.asarray(friction * r * (1.0 - np.log(r)))

    statistical, bound = errors
    by_error = 0.5 * (law(slips + statistical) - law(np.maximum(slips - statistical, 0.0)))
    by_bound = (law(slips) - law(np.maximum(slips - bound, 0.0))) / np.sqrt(3.0)
    return np.asarray(np.hypot(by_error, by_bound))
