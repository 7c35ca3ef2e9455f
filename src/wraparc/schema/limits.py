"""What a number may be: one statement for the descriptions, the files and the forms."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TypeGuard

import numpy as np

from wraparc.errors import InputError, Problem, shown
from wraparc.units import DIMENSION_TEXT, Dimension, display

_NUMBERS = (int, float, np.integer, np.floating)


@dataclass(frozen=True)
class Limit:
    """The values a quantity may have.

    Parameters
    ----------
    dimension
        What it measures.
    least, most
        Ends of the allowed interval [SI unit of the dimension], both allowed.
    open
        Whether `least` itself is refused.
    rigid
        Whether infinity is allowed (a body that does not deform).
    """

    dimension: Dimension
    least: float = 0.0
    most: float = math.inf
    open: bool = False
    rigid: bool = False

    def __str__(self) -> str:
        """Return the end of the sentence "must be ..."."""
        least = self._shown(self.least)
        if self.most == math.inf:
            return f"more than {least}" if self.open else f"at least {least}"
        if self.least == -math.inf:
            return f"at most {self._shown(self.most)}"
        if self.open:
            return f"more than {least} and at most {self._shown(self.most)}"
        return f"between {least} and {self._shown(self.most)}"

    def _shown(self, bound: float) -> str:
        return display(bound, self.dimension, digits=3)

    def refusal(self, value: object) -> str:
        """Return what is wrong with a value [SI], or an empty text."""
        if not is_number(value):
            unit = DIMENSION_TEXT[self.dimension].si_unit
            return f"must be a number [{unit}]" if unit else "must be a number"
        if math.isnan(value) or (math.isinf(value) and not (self.rigid and value > 0)):
            return "must be finite"
        if not self.least <= value <= self.most or (self.open and value == self.least):
            return f"must be {self}"
        return ""


def is_number(value: object) -> TypeGuard[float]:
    """Whether a value is a real number; numpy's are, truth values are not."""
    return isinstance(value, _NUMBERS) and not isinstance(value, bool)


def limit_problems(thing: object, limits: Mapping[str, Limit]) -> list[Problem]:
    """Return a problem for every field of `thing` outside its limit; None passes."""
    problems = []
    for key, limit in limits.items():
        value = getattr(thing, key)
        message = "" if value is None else limit.refusal(value)
        if message:
            given = display(float(value), limit.dimension) if is_number(value) else shown(value)
            problems.append(Problem(key=key, value=given, message=message))
    return problems


def name_problems(key: str, name: object) -> list[Problem]:
    """Return a problem if `name` is not a short printable text."""
    if isinstance(name, str) and name.strip() and len(name) <= 60 and name.isprintable():
        return []
    message = "must be a printable text of 1 to 60 characters"
    return [Problem(key=key, value=shown(name), message=message)]


def raise_all(problems: list[Problem]) -> None:
    """Raise one `InputError` with all the problems, if there are any."""
    if problems:
        raise InputError(problems)
