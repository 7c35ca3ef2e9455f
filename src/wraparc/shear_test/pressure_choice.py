"""Which form the pressure dependence has: the simplest that the data do not refuse.

Two judges: Akaike's criterion for few data, and the error with which each pressure, left
out in turn, is predicted by the law of the others. The first chooses; the second can veto.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from wraparc.arrays import Array, Flags
from wraparc.shear_test.pressure_fit import (
    CurvePoints,
    PressureFit,
    at_least,
    down_weighted,
    fit_form,
    scatter_between,
    scatter_within,
    transition_bounds,
)
from wraparc.shear_test.pressure_form import LawForm, Variables

_ONE = (("constant",), ("linear",), ("exponential",), ("logarithmic",), ("power",))
_TWO = (
    ("linear", "linear"),
    ("exponential", "linear"),
    ("logarithmic", "linear"),
    ("power", "linear"),
    ("exponential", "exponential"),
    ("power", "power"),
)
_VETO = 1.5
_LEVELS_FOR_TWO = 5
_UNKNOWN_SCATTER = 0.02
_NO_WEIGHT = 0.01


@dataclass(frozen=True, kw_only=True)
class Candidate:
    """A form that was tried.

    Parameters
    ----------
    form
        The form.
    parameters
        How many it has.
    criterion
        AICc, less is better.
    left_out_error
        Root mean square error in ln mu of the left-out pressures inside the tested range,
        over slips up to the tested one; NaN if there are too few pressures.
    """

    form: LawForm
    parameters: int
    criterion: float
    left_out_error: float


@dataclass(frozen=True, kw_only=True, eq=False)
class PressureChoice:
    """The chosen form, fitted, and how it was chosen.

    Parameters
    ----------
    fit
        The fit, scatter between samples estimated with it.
    candidates
        All forms tried, the best criterion first.
    two_pieces
        The best form with a transition, whether or not it is the chosen one; None if there
        are too few pressures for one.
    notes
        Sentences on the choice.
    """

    fit: PressureFit
    candidates: tuple[Candidate, ...]
    two_pieces: PressureFit | None
    notes: tuple[str, ...]


@dataclass(frozen=True, kw_only=True)
class PressureOptions:
    """What the user asks of the pressure dependence.

    Parameters
    ----------
    variables
        ``"peak"`` for pieces of x_pk and mu_pk, ``"coefficients"`` for pieces of A and b.
    transition_pressure
        Given transition pressure [Pa]; None to estimate it.
    pieces
        1 or 2 to prescribe how many; None to choose.
    """

    variables: Variables = "peak"
    transition_pressure: float | None = None
    pieces: int | None = None


def choose_form(
    points: CurvePoints, options: PressureOptions, flagged: Flags | None = None
) -> PressureChoice:
    """Choose and fit the form of the pressure dependence.

    Parameters
    ----------
    points
        The curves; at least two pressures.
    options
        What is prescribed.
    flagged
        Curves that disagree with their repeats, shape (n,).
    """
    levels = len(np.unique(points.level))
    given = options.transition_pressure
    notes: list[str] = []
    flagged = np.zeros(len(points.level), dtype=bool) if flagged is None else flagged
    scatter = scatter_within(points.only(~flagged))
    if scatter is None:
        scatter = _scatter_without_repeats(points, options)
        notes.append(
            "too few repeated tests to separate the scatter between samples from the form of the "
            "pressure dependence: it was taken from the distance of the curves from the law"
        )
    caution: Array = np.where(flagged, 0.1, 1.0)
    fits = _tried(points, scatter, options, levels, caution)
    if levels > 2 and options.pieces is None:
        fits.append(_through_points(points, scatter, caution))
    fits.sort(key=lambda fit: fit.criterion)
    near = [fit for fit in fits if fit.criterion <= fits[0].criterion + 10.0][:4]
    errors = {id(fit): _left_out_error(fit, points) for fit in near}
    least = min((e for e in errors.values() if np.isfinite(e)), default=np.inf)
    chosen = next((fit for fit in near if not errors[id(fit)] > _VETO * least), near[0])
    chosen = replace(chosen, alternatives=_alternatives(chosen, fits))
    final = settled(chosen, points, flagged, given)
    pieces = [fit for fit in fits if fit.form.has_transition]
    two = final if final.form.has_transition else None
    if two is None and pieces:
        two = settled(pieces[0], points, flagged, given)
    return PressureChoice(
        fit=final,
        two_pieces=two,
        candidates=tuple(
            Candidate(
                form=fit.form,
                parameters=fit.form.size,
                criterion=fit.criterion,
                left_out_error=errors.get(id(fit), np.nan),
            )
            for fit in fits
        ),
        notes=tuple(notes),
    )


def settled(
    chosen: PressureFit, points: CurvePoints, flagged: Flags, given: float | None
) -> PressureFit:
    """Fit with the scatter and the weights of the curves that go with the form itself.

    Curves that are flagged do not count for the scatter, and are weighted by their distance.
    """
    fit = chosen
    transition = given if fit.form.has_transition else None
    for _ in range(2):
        scatter = scatter_between(
            fit.form, points.only(~flagged), fit.scatter, transition=transition, ends=fit.ends,
            start=fit.theta,
        )  # fmt: skip
        weights = down_weighted(fit)
        fit = fit_form(
            fit.form, points, scatter, transition=transition, weights=weights, start=fit.theta
        )
    return replace(fit, alternatives=chosen.alternatives)


def _alternatives(
    chosen: PressureFit, fits: Sequence[PressureFit]
) -> tuple[tuple[float, PressureFit], ...]:
    """Forms near the best, with their Akaike weights."""
    least = min(fit.criterion for fit in fits)
    weights = {id(fit): np.exp(-0.5 * (fit.criterion - least)) for fit in fits}
    total = sum(weights.values())
    return tuple(
        (float(weights[id(fit)] / total), fit)
        for fit in fits
        if fit is not chosen and weights[id(fit)] > _NO_WEIGHT * total
    )


def _scatter_without_repeats(points: CurvePoints, options: PressureOptions) -> Array:
    start = at_least(np.eye(2) * _UNKNOWN_SCATTER**2)
    levels = len(np.unique(points.level))
    if levels < 4:
        return start
    trends = ("exponential",) if levels < _LEVELS_FOR_TWO + 1 else ("exponential", "exponential")
    form = LawForm(trends, trends, "peak")
    return scatter_between(form, points, start, transition=options.transition_pressure)


def _tried(
    points: CurvePoints, scatter: Array, options: PressureOptions, levels: int, weights: Array
) -> list[PressureFit]:
    """Fit each trend to both quantities, then the best trend of each together."""
    given, variables = options.transition_pressure, options.variables
    two_possible = levels >= _LEVELS_FOR_TWO or (given is not None and levels >= 3)
    groups: list[Sequence[tuple[str, ...]]] = []
    if options.pieces != 2 or not two_possible:
        # Through two pressures there is a straight line, and nothing to choose it by.
        groups.append(_ONE if levels > 2 else [("linear",)])
    if options.pieces != 1 and two_possible:
        groups.append(_TWO)
    fits: list[PressureFit] = []
    best: list[tuple[tuple[str, ...], tuple[str, ...]]] = []
    for group in groups:
        tried = [
            fit_form(LawForm(t, t, variables), points, scatter, transition=given, weights=weights)
            for t in group
        ]
        fits.extend(tried)
        own = [_own_chi(fit, points) for fit in tried]
        one, two = (min(range(len(own)), key=lambda k: own[k][q]) for q in (0, 1))
        best.append((group[one], group[two]))
    pairs = {(a[0], b[1]) for a in best for b in best} | set(best)
    for first, second in sorted(pairs):
        if first != second:
            form = LawForm(first, second, variables)
            fits.append(fit_form(form, points, scatter, transition=given, weights=weights))
    return fits


def _through_points(
    points: CurvePoints, scatter: Array, weights: Array | None = None
) -> PressureFit:
    """The law with a value of its own at every pressure: for where no trend line will do."""
    nodes = tuple(points.level_pressures.tolist())
    return fit_form(LawForm(nodes=nodes), points, scatter, weights=weights)


def _own_chi(fit: PressureFit, points: CurvePoints) -> Array:
    """Squared distances of the two quantities, each by itself, complexity included."""
    off = points.value - fit.peaks(points.pressure)
    variance = np.einsum("nii->ni", points.covariance + fit.scatter)
    return np.asarray((off**2 / variance).sum(0) + fit.form.size)


def leave_out(fit: PressureFit, points: CurvePoints, level: int) -> PressureFit | None:
    """Return the same form fitted without one pressure; None if what is left cannot tell it."""
    rest = points.only(points.level != level)
    count = len(np.unique(rest.level))
    if fit.form.nodes:
        return _through_points(rest, fit.scatter) if count > 1 else None
    free = fit.form.has_transition and not fit.transition_given
    if count < 2 or (free and count < 4):
        return None
    given = fit.transition_pressure if fit.transition_given else None
    start = fit.theta if not free else _inside(fit, rest)
    return fit_form(
        fit.form, rest, fit.scatter, transition=given, ends=fit.ends, start=start,
        weights=fit.weights[points.level != level],
    )  # fmt: skip


def _inside(fit: PressureFit, points: CurvePoints) -> Array:
    theta = fit.theta.copy()
    low, high = np.log(transition_bounds(points))
    theta[-1] = np.clip(theta[-1], low + 1e-3 * (high - low), high - 1e-3 * (high - low))
    return theta


def _left_out_error(fit: PressureFit, points: CurvePoints) -> float:
    """Root mean square of the predicted (ln x_pk, ln mu_pk) as friction, inner pressures."""
    levels = np.unique(points.level)
    squares = []
    for level in levels[1:-1]:
        rest = leave_out(fit, points, int(level))
        if rest is None:
            return float("nan")
        inside = points.level == level
        off = rest.peaks(points.pressure[inside]).mean(0) - points.value[inside].mean(0)
        squares.append(_friction_difference(off) ** 2)
    return float(np.sqrt(np.mean(squares))) if squares else float("nan")


def _friction_difference(off: Array) -> float:
    """Difference of ln mu over the rising branch for errors of (ln x_pk, ln mu_pk)."""
    r = np.linspace(0.1, 0.8, 8)
    by_slip = np.log(r) / (1.0 - np.log(r))
    return float(np.sqrt(np.mean((off[1] + by_slip * off[0]) ** 2)))
