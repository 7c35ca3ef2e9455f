"""The largest, the least, the order of numbers: those alike to rounding keep their own order.

Which of two equal drums or of two symmetric edges has the larger number is else decided by the last
bit of another machine.
"""

from collections.abc import Callable, Iterable, Sequence
from math import inf, isclose
from typing import Any, TypeVar

_Item = TypeVar("_Item")

#: Part of a number that is rounding [-].
ALIKE = 1e-9


def largest(items: Iterable[_Item], key: Callable[[_Item], float]) -> _Item:
    """Return the item of the largest number; the first of those alike within `ALIKE`.

    Raises
    ------
    ValueError
        If there is no item.
    """
    every = [(key(item), item) for item in items]
    if not every:
        raise ValueError("nothing to choose from")
    most, found = every[0]
    for number, item in every[1:]:
        if number > most and not isclose(number, most, rel_tol=ALIKE):
            most, found = number, item
    return found


def least(items: Iterable[_Item], key: Callable[[_Item], float]) -> _Item:
    """Return the item of the least number, as `largest`."""
    return largest(items, lambda item: -key(item))


def alike(values: Sequence[float]) -> bool:
    """Return whether numbers differ by rounding alone."""
    return all(isclose(value, values[0], rel_tol=ALIKE) for value in values)


def place_of_largest(values: Any) -> int:
    """Return the place of the largest of an array, in one row; the first of those alike."""
    return int((values >= values.max() - ALIKE * abs(values).max()).argmax())


def falling(items: Iterable[_Item], key: Callable[[_Item], float]) -> list[_Item]:
    """Return items from the largest number down; those alike, of the largest, in their order."""
    every = list(items)
    numbers = [key(item) for item in every]
    step = ALIKE * max((abs(n) for n in numbers if abs(n) < inf), default=0.0)
    rounded = [round(n / step) if step and abs(n) < inf else n for n in numbers]
    return [every[i] for i in sorted(range(len(every)), key=lambda i: -rounded[i])]
