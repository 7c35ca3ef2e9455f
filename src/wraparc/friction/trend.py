"""Trend lines over pressure, in the forms a spreadsheet fits."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import exp, inf, isfinite, log
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from wraparc.arrays import Array
from wraparc.friction.base import check

Form = Literal["polynomial", "logarithmic", "power", "exponential"]
#: Of e, whose power is a float.
_LARGEST_POWER = 709.0
#: form -> (v = ln p, y = exp), see friction.compact._trend
_FORM_CODES: dict[str, tuple[bool, bool]] = {
    "polynomial": (False, False),
    "logarithmic": (True, False),
    "power": (True, True),
    "exponential": (False, True),
}


@dataclass(frozen=True, kw_only=True)
class Trend:
    """A trend line over pressure, in the forms a spreadsheet fits.

    Attributes
    ----------
    form
        polynomial: c0 + c1 p + c2 p^2 + c3 p^3; logarithmic: c0 + c1 ln p (+ c2 ln^2 p ...);
        power: sign exp(c0 + c1 ln p); exponential: sign exp(c0 + c1 p). p is in pascal.
    coefficients
        c0 .. c3, one to four numbers.
    sign
        Sign of a power or exponential form, +1 or -1.
    """

    form: Form = "polynomial"
    coefficients: tuple[float, ...]
    sign: int = 1

    def __post_init__(self) -> None:
        n = len(self.coefficients)
        check(
            (
                self.form in _FORM_CODES,
                "form",
                self.form,
                f"the form must be one of {', '.join(_FORM_CODES)}",
            ),
            (1 <= n <= 4, "coefficients", str(n), "one to four coefficients are needed"),
            (
                all(map(isfinite, self.coefficients)),
                "coefficients",
                str(self.coefficients),
                "must be finite",
            ),
            (self.sign in (1, -1), "sign", str(self.sign), "the sign must be 1 or -1"),
        )

    def at(self, pressure: float) -> float:
        """Value at one pressure [Pa]."""
        logarithmic, exponential = _FORM_CODES[self.form]
        v, y = log(pressure) if logarithmic else pressure, 0.0
        for c in reversed(self.coefficients):
            y = c + y * v
        return self.sign * _exp(y) if exponential else y

    def __call__(self, pressure: ArrayLike) -> Array:
        """Value at a pressure [Pa]."""
        p = np.asarray(pressure, dtype=float)
        logarithmic, exponential = _FORM_CODES[self.form]
        y = np.polynomial.polynomial.polyval(np.log(p) if logarithmic else p, self.coefficients)
        return np.asarray(self.sign * np.exp(y) if exponential else y)

    def times(self, factor: float) -> Trend:
        """Return the trend line of its values times a factor > 0."""
        c = self.coefficients
        if self.form in ("power", "exponential"):
            return replace(self, coefficients=(c[0] + log(factor), *c[1:]))
        return replace(self, coefficients=tuple(v * factor for v in c))

    def row(self) -> tuple[float, ...]:
        """Return c0 .. c3 and the two form codes that the solvers read."""
        logarithmic, exponential = _FORM_CODES[self.form]
        c = self.coefficients + (0.0,) * (4 - len(self.coefficients))
        return (*c, float(logarithmic), float(self.sign) if exponential else 0.0)


def _exp(power: float) -> float:
    """Return e to a power, infinity where no float holds it."""
    return exp(power) if power < _LARGEST_POWER else inf
