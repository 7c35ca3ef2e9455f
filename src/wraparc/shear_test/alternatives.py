"""Other laws for the same curves, side by side, with Akaike's criterion.

Every law is fitted to the same bins of every curve, with the same weights, a lash of its own and
normal noise whose size is its own. Slip is the travel less lash, less what the sample and the rig
bend at the measured friction, for all laws alike. The laws differ in what friction follows slip:
nothing is taken from the fit of one law into that of another but where to begin.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from wraparc.arrays import Array
from wraparc.shear_test.analysis import ConditionResult, TestResult
from wraparc.shear_test.curve_fit import bins_alike
from wraparc.shear_test.robust import minimise

# Slips of the table, and lashes tried, for one curve.
_NODES = 10
_LASHES = 25


@dataclass(frozen=True, kw_only=True)
class AlternativeLaw:
    """One law over all curves of a condition.

    Parameters
    ----------
    name
        What it is called.
    parameters
        Of each curve, lash included.
    remainder
        Root mean square of measured less fitted friction over bins of equal travel [-].
    criterion
        AICc, summed over the curves; less is better.
    best_of
        Curves for which it has the least criterion of all laws.
    """

    name: str
    parameters: int
    remainder: float
    criterion: float
    best_of: int


@dataclass(frozen=True, eq=False)
class _Curve:
    """One curve: u, travel less bending [mm]; friction; weights; independent readings."""

    travel: Array
    friction: Array
    weights: Array
    independent: float
    lash: float
    peak_slip: float
    peak_friction: float


@lru_cache(maxsize=4)
def alternative_laws(condition: ConditionResult) -> tuple[AlternativeLaw, ...]:
    """Return the laws, the one with the least criterion first.

    Parameters
    ----------
    condition
        Its curves are fitted anew, each by itself.
    """
    curves = [_curve_of(test) for test in condition.tests]
    fitted = {name: [law(curve) for curve in curves] for name, law in _LAWS.items()}
    scores = np.array(
        [
            [_criterion(rows, count, c) for (rows, count), c in zip(found, curves, strict=True)]
            for found in fitted.values()
        ]
    )
    best = np.argmin(scores, axis=0)
    laws = [
        AlternativeLaw(
            name=name,
            parameters=found[0][1],
            remainder=_remainder(curves, [rows for rows, _ in found]),
            criterion=float(scores[k].sum()),
            best_of=int((best == k).sum()),
        )
        for k, (name, found) in enumerate(fitted.items())
    ]
    return tuple(sorted(laws, key=lambda law: law.criterion))


def _curve_of(test: TestResult) -> _Curve:
    fit, q = test.fit, test.fit.parameters
    bent = test.curve.binned_travel - fit.bending * fit.friction
    independent = len(fit.friction) / bins_alike(test.curve, fit)
    return _Curve(
        bent * 1e3, fit.friction, fit.weights, independent, q.lash * 1e3,
        q.peak_slip * 1e3, q.peak_friction,
    )  # fmt: skip


def _criterion(rows: Array, parameters: int, curve: _Curve) -> float:
    """AICc of normal noise of unknown size, which counts as a parameter."""
    n, k = curve.independent, parameters + 1
    spare = max(n - k - 1.0, 1.0)
    return float(n * np.log(np.mean(rows**2)) + 2.0 * k + 2.0 * k * (k + 1.0) / spare)


def _remainder(curves: Sequence[_Curve], rows: Sequence[Array]) -> float:
    squares = [np.mean((r / c.weights) ** 2) for c, r in zip(curves, rows, strict=True)]
    return float(np.sqrt(np.mean(squares)))


_Fitted = tuple[Array, int]


def _least_squares(
    curve: _Curve, start: Array, law: Callable[[Array, Array], Array], bounds: tuple[Array, Array]
) -> _Fitted:
    """Residuals of the best lash and parameters (in that order), and how many they are."""

    def rows(vector: Array) -> Array:
        slip = curve.travel - vector[0]
        model = np.where(slip > 0.0, law(np.maximum(slip, 1e-9), vector[1:]), 0.0)
        return curve.weights * (model - curve.friction)

    def residual(vector: Array) -> tuple[Array, Array]:
        at = rows(vector)
        steps = 1e-6 * np.maximum(np.abs(vector), 1e-3)
        moved = zip(steps, np.diag(steps), strict=True)
        return at, np.stack([(rows(vector + by) - at) / step for step, by in moved], axis=-1)

    best = minimise(residual, np.clip(start, *bounds), bounds)
    return rows(best), len(start)


def _bounds(curve: _Curve, *others: tuple[float, float]) -> tuple[Array, Array]:
    reach = float(curve.travel[-1])
    low, high = zip((-reach, 0.6 * reach), *others, strict=True)
    return np.array(low), np.array(high)


def _integral_log(curve: _Curve) -> _Fitted:
    def law(slip: Array, p: Array) -> Array:
        r = np.minimum(slip / np.exp(p[0]), 1.0)
        return np.asarray(np.exp(p[1]) * r * (1.0 - np.log(r)))

    start = np.array([curve.lash, np.log(curve.peak_slip), np.log(curve.peak_friction)])
    return _least_squares(curve, start, law, _bounds(curve, (-7.0, 7.0), (-7.0, 3.0)))


def _with_line(curve: _Curve) -> _Fitted:
    def law(slip: Array, p: Array) -> Array:
        peak = np.exp(p[0])
        r = np.minimum(slip / peak, 1.0)
        return np.asarray(
            np.exp(p[1]) * r * (1.0 - np.log(r)) + p[2] * np.maximum(slip - peak, 0.0)
        )

    top = float(np.log(curve.friction.max()))
    ends = _bounds(curve, (-7.0, 7.0), (-7.0, 3.0), (-10.0, 0.0))
    starts = (
        [curve.lash, np.log(curve.peak_slip), np.log(curve.peak_friction), -1e-4],
        [curve.lash, np.log(0.3 * float(curve.travel[-1])), top, -1e-3],
    )
    found = [_least_squares(curve, np.array(start), law, ends) for start in starts]
    return min(found, key=lambda fitted: float((fitted[0] ** 2).sum()))


def _power(curve: _Curve) -> _Fitted:
    def law(slip: Array, p: Array) -> Array:
        return np.asarray(np.exp(p[0] + p[1] * np.log(slip)))

    start = np.array([curve.lash, np.log(curve.friction.max()) - 1.0, 0.4])
    return _least_squares(curve, start, law, _bounds(curve, (-12.0, 5.0), (0.0, 3.0)))


def _on_lashes(curve: _Curve, design: Callable[[Array], Array]) -> _Fitted:
    """Laws that are linear but for the lash: the best of a row of lashes."""
    reach = float(curve.travel[-1])
    near = curve.lash + _bin(curve) * np.linspace(-3.0, 3.0, _LASHES)
    lashes = np.unique(np.maximum([*np.linspace(0.0, 0.3 * reach, _LASHES), *near], 0.0))
    best: Array | None = None
    columns = 0
    for lash in lashes:
        slip = curve.travel - lash
        matrix = np.where((slip > 0.0)[:, None], design(np.maximum(slip, 0.0)), 0.0)
        matrix = matrix * curve.weights[:, None]
        target = curve.weights * curve.friction
        rows = matrix @ np.linalg.lstsq(matrix, target, rcond=None)[0] - target
        if best is None or (rows**2).sum() < (best**2).sum():
            best, columns = rows, matrix.shape[1]
    assert best is not None  # noqa: S101 - there are lashes
    return best, columns + 1


def _bin(curve: _Curve) -> float:
    """Width of the narrow bins where the friction starts to rise [mm]."""
    steps = np.diff(curve.travel)
    return float(np.quantile(steps[steps > 0.0], 0.1))


def _constant(curve: _Curve) -> _Fitted:
    """One friction; of the bin in which it begins, a part."""
    return _on_lashes(curve, lambda slip: np.minimum(slip / _bin(curve), 1.0)[:, None])


def _table(curve: _Curve) -> _Fitted:
    """Straight lines through 10 slips, closer where the friction rises; 0 at no slip."""

    def hats(slip: Array) -> Array:
        nodes = float(slip.max()) * np.linspace(0.0, 1.0, _NODES + 1) ** 2
        return np.stack([np.interp(slip, nodes, row) for row in np.eye(_NODES + 1)[1:]], axis=-1)

    return _on_lashes(curve, hats)


# Law by name: residuals of its best fit to a curve, and how many parameters that took.
_LAWS: dict[str, Callable[[_Curve], _Fitted]] = {
    "integral-log": _integral_log,
    "integral-log, then a line": _with_line,
    "constant": _constant,
    "power of slip": _power,
    f"table of {_NODES} slips": _table,
}
