"""What follows the peak, over pressure: the slope and the residual level of each pressure."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from wraparc.arrays import Array
from wraparc.shear_test.curve_fit import CurveFit
from wraparc.shear_test.curve_model import friction_and_slope


@dataclass(frozen=True, kw_only=True, eq=False)
class Tails:
    """Post-peak line at each tested pressure.

    Parameters
    ----------
    pressure
        Ascending [Pa], shape (n,).
    slope
        <= 0; 0 where no test showed a fall [1/m], shape (n,).
    residual
        Residual friction over peak friction, 1 where no test showed a fall, shape (n,).
    reached
        Whether the residual level was seen, or only bounds the lowest friction seen.
    """

    pressure: Array
    slope: Array
    residual: Array
    reached: tuple[bool, ...]

    def at(self, pressure: Array) -> tuple[Array, Array]:
        """Slope [1/m] and residual ratio at pressures [Pa], straight lines between the tested."""
        return (
            np.interp(pressure, self.pressure, self.slope),
            np.interp(pressure, self.pressure, self.residual),
        )


def level_tails(levels: Sequence[tuple[float, Sequence[CurveFit]]]) -> Tails:
    """Average the tails of the curves at each pressure.

    A pressure falls past its peak if most of its curves do; the others count with slope 0.

    Parameters
    ----------
    levels
        Pressure [Pa] and curves of each, pressures ascending.
    """
    slopes, ratios, reached = [], [], []
    for _, fits in levels:
        falling = [fit for fit in fits if "post_peak_slope" in fit.free and fit.peak_inside]
        if 2 * len(falling) <= len(fits):
            slopes.append(0.0)
            ratios.append(1.0)
            reached.append(True)
            continue
        slopes.append(float(np.mean([fit.parameters.post_peak_slope for fit in falling])))
        ratios.append(float(np.mean([_ratio(fit) for fit in falling])))
        reached.append(all("residual_friction" in fit.free for fit in falling))
    return Tails(
        pressure=np.array([pressure for pressure, _ in levels]),
        slope=np.array(slopes),
        residual=np.array(ratios),
        reached=tuple(reached),
    )


def _ratio(fit: CurveFit) -> float:
    """Residual over peak friction; where the level was not reached, the lowest seen."""
    q = fit.parameters
    if "residual_friction" in fit.free:
        return min(q.residual_friction / q.peak_friction, 1.0)
    last, _ = friction_and_slope(np.array([fit.slip_max]), q)
    return float(np.clip(last[0] / q.peak_friction, 0.05, 1.0))
