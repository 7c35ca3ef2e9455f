"""The explicit sixth-order method of both marches, written once.

J. C. Butcher, J. Austral. Math. Soc. 4 (1964) 179-194, 7 stages. The second stage is at 1/3 of a
step, the third at 2/3, the fourth at 1/3 again, the fifth and sixth at 1/2, the last at its end:
five places only, which lets a march tabulate what depends on the place alone. k1 ... are rates
times the step; each function says how far the state of a stage is from the start of the step.
They take numbers, or arrays of many states at once.
"""

from __future__ import annotations

from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

F = TypeVar("F", float, NDArray[np.float64])


def to_second(k1: F) -> F:
    """Increment to the second stage, at 1/3."""
    return k1 / 3.0


def to_third(k2: F) -> F:
    """Increment to the third stage, at 2/3."""
    return k2 * 2.0 / 3.0


def to_fourth(k1: F, k2: F, k3: F) -> F:
    """Increment to the fourth stage, at 1/3."""
    return (k1 + 4.0 * k2 - k3) / 12.0


def to_fifth(k1: F, k2: F, k3: F, k4: F) -> F:
    """Increment to the fifth stage, at 1/2."""
    return (18.0 * k2 - k1 - 3.0 * k3 - 6.0 * k4) / 16.0


def to_sixth(k2: F, k3: F, k4: F, k5: F) -> F:
    """Increment to the sixth stage, at 1/2."""
    return (9.0 * k2 - 3.0 * k3 - 6.0 * k4 + 4.0 * k5) / 8.0


def to_last(k1: F, k2: F, k3: F, k4: F, k6: F) -> F:
    """Increment to the seventh stage, at the end."""
    return (9.0 * k1 - 36.0 * k2 + 63.0 * k3 + 72.0 * k4 - 64.0 * k6) / 44.0


def to_end(k1: F, k3: F, k4: F, k5: F, k6: F, k7: F) -> F:
    """Increment over the whole step."""
    return (11.0 * (k1 + k7) + 81.0 * (k3 + k4) - 32.0 * (k5 + k6)) / 120.0
