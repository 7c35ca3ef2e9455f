"""Laws drawn from the statistics of a fitted lagging."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from wraparc.arrays import Array
from wraparc.drive import Fit
from wraparc.errors import input_error, shown
from wraparc.study.distributions import normal_quantile
from wraparc.study.plan import Drawn
from wraparc.units import Dimension

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
        if not self.fit.knots:
            raise input_error(
                key=self.field,
                value=shown(self.fit.parameters[:3]),
                message="needs knots of an integral-log law",
                remedy="Fit the lagging: wraparc fit.",
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
        sizes, directions = np.linalg.eigh(self.fit.log_covariance)
        root = directions * np.sqrt(np.maximum(sizes, 0.0))
        z = normal_quantile(points)
        # a sum in a fixed order: a matrix product depends on the number of rows in its last bits
        moves = sum(z[:, k, None] * root[:, k] for k in range(len(values)))
        drawn = values * np.exp(moves)
        return {name: drawn[:, k] for k, name in enumerate(self.columns)}
