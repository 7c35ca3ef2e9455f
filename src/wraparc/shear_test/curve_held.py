"""Parameters of a curve that the plan gives instead of letting them be fitted."""

from dataclasses import dataclass

import numpy as np

from wraparc.arrays import Array

# Half the width left to a pinned logarithm, and the variance it is said to have.
_PIN, _VARIANCE = 1e-9, 1e-12
# Where the two stand in the vector of a curve's parameters.
_LOGARITHMS = (("ln_peak_slip", 0, "peak_slip"), ("ln_peak_friction", 1, "peak_friction"))


@dataclass(frozen=True, kw_only=True)
class Held:
    """What is given, the same for all tests of a plan; None is fitted.

    Parameters
    ----------
    peak_slip
        [m].
    peak_friction
        [-].
    lash
        [m].
    """

    peak_slip: float | None = None
    peak_friction: float | None = None
    lash: float | None = None

    def pinned(self, low: Array, high: Array) -> tuple[Array, Array]:
        """Return the bounds of a curve's parameters, those of what is held closed upon it."""
        for _, place, name in _LOGARITHMS:
            value = getattr(self, name)
            if value is not None:
                low[place], high[place] = np.log(value) - _PIN, np.log(value) + _PIN
        return low, high

    def known(self, covariance: Array, free: tuple[str, ...]) -> Array:
        """Return the covariance of the others where what is held is known: the conditional one."""
        for name, _, own in _LOGARITHMS:
            if getattr(self, own) is None:
                continue
            k = free.index(name)
            column = covariance[:, k].copy()
            covariance = covariance - np.outer(column, column) / column[k]
            covariance[k, :] = covariance[:, k] = 0.0
            covariance[k, k] = _VARIANCE
        return covariance


#: Nothing is held.
FREE = Held()
