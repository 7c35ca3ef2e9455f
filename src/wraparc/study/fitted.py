"""Laws drawn from the statistics of a fitted lagging."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from wraparc.drive import Fit
from wraparc.errors import InputError, Problem, shown
from wraparc.friction import FrictionLaw, IntegralLog, PressureKnots
from wraparc.study.distributions import normal_quantile
from wraparc.study.plan import Drawn
from wraparc.units import Dimension

Array = NDArray[np.float64]

_PARAMETER = re.compile(r"knots\[([0-9]{1,4})\]\.(peak_slip|peak_friction)")
_DIMENSIONS: dict[str, Dimension] = {"peak_slip": "length", "peak_friction": "number"}


@dataclass(frozen=True, kw_only=True)
class DrawnFit(Drawn):
    """Peaks of a fitted law, drawn together with their covariance.

    The logarithms are drawn, as they were fitted: ln v is normal about ln of the estimate with the
    covariance of v over the product of the estimates, so that no friction or slip is negative.

    Attributes
    ----------
    field
        Key path of the lagging; the columns are named below it.
    fit
        Statistics of its fit.
    """

    field: str
    fit: Fit

    def __post_init__(self) -> None:
        bad = [name for name in self.fit.parameters if not _PARAMETER.fullmatch(name)]
        if bad or min(self.fit.values) <= 0.0:
            raise InputError(
                Problem(
                    key=self.field,
                    value=shown(bad[:3] or min(self.fit.values)),
                    message="only peaks of the knots of an integral-log law can be drawn, all > 0",
                    remedy="Fit the lagging with `wraparc fit`.",
                )
            )

    @property
    def columns(self) -> dict[str, Dimension]:
        """The parameters."""
        return {
            f"{self.field}.{name}": _DIMENSIONS[name.rpartition(".")[2]]
            for name in self.fit.parameters
        }

    @property
    def dimensions(self) -> int:
        """One number for each parameter."""
        return len(self.fit.parameters)

    def draw(self, points: Array) -> dict[str, Array]:
        """Parameters from points of the unit cube."""
        values = np.array(self.fit.values)
        logs = np.array(self.fit.covariance) / np.outer(values, values)
        sizes, directions = np.linalg.eigh(0.5 * (logs + logs.T))
        root = directions * np.sqrt(np.maximum(sizes, 0.0))
        z = normal_quantile(points)
        # a sum in a fixed order: a matrix product depends on the number of rows in its last bits
        moves = sum(z[:, k, None] * root[:, k] for k in range(len(values)))
        drawn = values * np.exp(moves)
        return {name: drawn[:, k] for k, name in enumerate(self.columns)}


def with_peaks(law: FrictionLaw, parameters: Mapping[str, float]) -> FrictionLaw:
    """Return a law with other peaks at its knots, ``knots[2].peak_slip`` and so on [SI].

    Raises
    ------
    InputError
        If the law has no such knots.
    """
    coefficients = law.coefficients if isinstance(law, IntegralLog) else None
    if not isinstance(law, IntegralLog) or not isinstance(coefficients, PressureKnots):
        raise InputError(Problem(message="only an integral-log law with knots can be drawn"))
    columns = {key: list(getattr(coefficients, key)) for key in _DIMENSIONS}
    for name, value in parameters.items():
        match = _PARAMETER.fullmatch(name)
        place = int(match[1]) - 1 if match else -1
        if match is None or not 0 <= place < len(coefficients.pressure):
            raise InputError(Problem(value=shown(name), message="the law has no such knot"))
        columns[match[2]][place] = float(value)
    changed = {key: tuple(column) for key, column in columns.items()}
    return replace(law, coefficients=replace(coefficients, **changed))
