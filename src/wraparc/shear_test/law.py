"""A fitted pressure dependence as a friction law, and its covariance at the law's knots."""

import numpy as np

from wraparc.drive import Fit
from wraparc.friction import IntegralLog, PressureKnots, TestedRange
from wraparc.friction.interpolation import evaluate, pchip
from wraparc.shear_test.pressure_fit import PressureFit
from wraparc.shear_test.record import Array
from wraparc.shear_test.tails import Tails

_MOST_KNOTS = 24
_CLOSE = 1e-3


def knot_pressures(fit: PressureFit, tails: Tails) -> Array:
    """Pressures [Pa] at which the law is written down.

    Knots are added where the monotone cubics through them are farthest from the fit, until
    they follow it within 0.1 %, its corner at a transition included.
    """
    low, high = fit.ends
    if fit.form.nodes:
        return np.array(fit.form.nodes)
    at = fit.transition_pressure
    places = {low, high, *tails.pressure[_changing(tails)].tolist()}
    if at is not None and low * 1.01 < at < high / 1.01:
        places = {p for p in places if p in (low, high) or abs(p / at - 1.0) > 0.02} | {at}
    places = {min(max(p, low), high) for p in places}
    fine = np.geomspace(low, high, 601)
    wanted = np.exp(fit.peaks(fine))
    while len(places) < _MOST_KNOTS:
        knots = np.array(sorted(places))
        values = np.exp(fit.peaks(knots))
        cubics = [pchip(knots, values[:, k]) for k in (0, 1)]
        off = [np.abs(evaluate(knots, c, fine) / wanted[:, k] - 1) for k, c in enumerate(cubics)]
        worst = np.maximum(*off)
        if worst.max() < _CLOSE:
            break
        # Halving the gap of the worst place beats a knot at the place, beside another.
        gap = int(np.searchsorted(knots, fine[int(np.argmax(worst))])) or 1
        places.add(float(np.sqrt(knots[gap - 1] * knots[gap])))
    return np.array(sorted(places))


def _changing(tails: Tails) -> Array:
    falls = tails.slope < 0.0
    beside = falls.copy()
    beside[1:] |= falls[:-1]
    return np.asarray(beside)


def law_through(pressure: Array, peaks: Array, tails: Tails, slip_max: float) -> IntegralLog:
    """Return the law with knots at pressures.

    Parameters
    ----------
    pressure
        Knots [Pa], shape (n,).
    peaks
        (ln x_pk, ln mu_pk) there, shape (n, 2).
    tails
        What follows the peak.
    slip_max
        Largest tested slip [m].
    """
    slip, friction = np.exp(peaks).T
    slope, ratio = tails.at(pressure)
    falls = bool(np.any(slope < 0.0))
    return IntegralLog(
        coefficients=PressureKnots(
            pressure=tuple(map(float, pressure)),
            peak_friction=tuple(map(float, friction)),
            peak_slip=tuple(map(float, slip)),
            post_peak_slope=tuple(map(float, slope)) if falls else (),
            residual_friction=tuple(map(float, ratio * friction)) if falls else (),
        ),
        tested=TestedRange(
            pressure_min=float(pressure[0]), pressure_max=float(pressure[-1]), slip_max=slip_max
        ),
    )


def knot_statistics(
    law: IntegralLog,
    covariance: Array,
    *,
    noise: float,
    date: str,
    method: str,
    misfit: tuple[str, ...],
) -> Fit:
    """Statistics of the law's knots: names, values and covariance in SI units.

    Parameters
    ----------
    law
        The law.
    covariance
        Of (ln x_pk, ln mu_pk) at its knots, shape (n, n, 2, 2).
    noise, date, method, misfit
        As in `wraparc.drive.Fit`.
    """
    knots = law.coefficients
    count = len(knots.pressure)
    assert isinstance(knots, PressureKnots)  # noqa: S101 - as made above
    values = np.concatenate([knots.peak_slip, knots.peak_friction])
    names = [
        f"knots[{k + 1}].{quantity}" for quantity in ("peak_slip", "peak_friction")
        for k in range(count)
    ]  # fmt: skip
    logs = covariance.transpose(2, 0, 3, 1).reshape(2 * count, 2 * count)
    matrix = values[:, None] * 0.5 * (logs + logs.T) * values
    return Fit(
        parameters=tuple(names),
        values=tuple(values.tolist()),
        covariance=tuple(tuple(row) for row in matrix.tolist()),
        residual_noise=noise,
        date=date,
        method=method,
        misfit=misfit,
    )
