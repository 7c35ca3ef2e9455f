"""The statistics of a fitted friction law, and laws drawn from them."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from wraparc.arrays import Array
from wraparc.errors import Problem, input_error
from wraparc.friction import FrictionLaw, IntegralLog, PressureKnots
from wraparc.schema.limits import Limit, limit_problems, raise_all

#: Standard deviations to either side of a 95 % interval of the normal distribution [-].
NORMAL_95 = 1.96


def half_interval(sd: float) -> float:
    """Return half of the 95 % interval of a standard deviation, 100 % at most [-]."""
    return min(round(NORMAL_95 * sd, 4), 1.0)


#: What of a knot is fitted.
PEAKS = ("peak_slip", "peak_friction")
_PARAMETER = re.compile(rf"knots\[([0-9]{{1,4}})\]\.({'|'.join(PEAKS)})")
_LIMITS = {"residual_noise": Limit("number"), "coverage_factor": Limit("number", least=1.0)}


@dataclass(frozen=True, kw_only=True)
class Fit:
    """The statistics of a fitted friction law, enough to draw other laws from it.

    Parameters
    ----------
    parameters
        What was fitted, each by its place in the law, ``knots[2].peak_slip``.
    values
        Best estimates, shape (n,) [SI].
    covariance
        Their covariance, shape (n, n) [SI products].
    residual_noise
        Robust standard deviation of the measured friction about the law [-], or None.
    date
        When it was fitted.
    method
        How, in words.
    misfit
        Where the law does not describe the data, in words.
    misfit_accepted
        Why the law was written nevertheless.
    coverage_factor
        Standard deviations to either side of a 95 % interval: Student's t for the tests there
        were, 1.96 for many [-].
    """

    parameters: tuple[str, ...]
    values: tuple[float, ...]
    covariance: tuple[tuple[float, ...], ...]
    residual_noise: float | None = None
    date: str = ""
    method: str = ""
    misfit: tuple[str, ...] = ()
    misfit_accepted: str = ""
    coverage_factor: float = NORMAL_95

    def __post_init__(self) -> None:
        n = len(self.parameters)
        problems = limit_problems(self, _LIMITS)
        if len(set(self.parameters)) < n or not n:
            message = "must name each fitted parameter once"
            problems.append(Problem(key="parameters", value=str(n), message=message))
        if len(self.values) != n or not all(map(math.isfinite, self.values)):
            message = f"must be {n} finite numbers, one for each parameter"
            problems.append(Problem(key="values", value=str(len(self.values)), message=message))
        problems += self._covariance_problems(n)
        raise_all(problems)

    def _covariance_problems(self, n: int) -> list[Problem]:
        rows = [len(row) for row in self.covariance]
        if rows != [n] * n:
            given = f"{len(rows)} rows of {sorted(set(rows))} numbers"
            message = f"must be {n} rows of {n} numbers, one for each parameter"
            return [Problem(key="covariance", value=given, message=message)]
        matrix, message = self.covariance, ""
        numbers = [v for row in matrix for v in row]
        apart = [abs(matrix[i][j] - matrix[j][i]) for i in range(n) for j in range(i)]
        if not all(map(math.isfinite, numbers)):
            message = "must be finite"
        elif max(apart, default=0.0) > 1e-9 * max(map(abs, numbers), default=0.0):
            message = "must be symmetric"
        elif not _has_no_negative(matrix, 1e-8 * n):
            message = "must have no negative eigenvalue: no variance is negative"
        return [Problem(key="covariance", message=message)] if message else []

    @cached_property
    def knots(self) -> tuple[tuple[int, str], ...]:
        """Knot of each parameter, from 0, and which peak of it; empty if some are none of these.

        `wraparc fit` writes no others, all > 0.
        """
        found = [_PARAMETER.fullmatch(name) for name in self.parameters]
        if min(self.values) <= 0.0:
            return ()
        named = tuple((int(match[1]) - 1, match[2]) for match in found if match)
        return named if len(named) == len(found) else ()

    @cached_property
    def log_covariance(self) -> Array:
        """Covariance of the logarithms of the parameters, symmetric, shape (n, n) [-]."""
        values = np.array(self.values)
        logs = np.array(self.covariance) / np.outer(values, values)
        return np.asarray(0.5 * (logs + logs.T))


def _has_no_negative(covariance: Sequence[Sequence[float]], rounding: float) -> bool:
    """Whether no eigenvalue of the matrix scaled to unit diagonal is less than -rounding [-].

    With so much on its diagonal it then has a Cholesky factor.
    """
    scale = [math.sqrt(abs(row[i])) or 1.0 for i, row in enumerate(covariance)]
    lower: list[list[float]] = []
    for i, given in enumerate(covariance):
        row: list[float] = []
        for j in range(i + 1):
            before = lower[j] if j < i else row
            rest = given[j] / (scale[i] * scale[j]) + (rounding if i == j else 0.0)
            rest -= math.fsum(a * b for a, b in zip(row, before[:j], strict=True))
            if i == j and rest <= 0.0:
                return False
            row.append(math.sqrt(rest) if i == j else rest / lower[j][j])
        lower.append(row)
    return True


def with_peaks(law: FrictionLaw, peaks: Mapping[tuple[int, str], float]) -> FrictionLaw:
    """Return a law with other peaks at its knots.

    Parameters
    ----------
    law
        An integral-log law with knots.
    peaks
        Values by knot, from 0, and ``peak_slip`` [m] or ``peak_friction`` [-].

    Raises
    ------
    InputError
        If the law has no such knots.
    """
    knots = knots_of(law)
    if knots is None or not isinstance(law, IntegralLog):
        raise input_error(message="only an integral-log law with knots can be drawn")
    columns = {key: list(getattr(knots, key)) for key in PEAKS}
    for (place, quantity), value in peaks.items():
        if not 0 <= place < len(knots.pressure):
            message = f"the law has {len(knots.pressure)} knots, and none {place + 1}"
            raise input_error(message=message)
        columns[quantity][place] = float(value)
    changed = {key: tuple(column) for key, column in columns.items()}
    return replace(law, coefficients=replace(knots, **changed))


def knots_of(law: FrictionLaw) -> PressureKnots | None:
    """Return the knots of an integral-log law; None for a law without."""
    coefficients = law.coefficients if isinstance(law, IntegralLog) else None
    return coefficients if isinstance(coefficients, PressureKnots) else None
