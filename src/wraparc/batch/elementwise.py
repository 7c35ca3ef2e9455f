"""Arithmetic without branches, for one number or for an array of them.

The lane kernel is written in these and in + - * /. In the interpreter its numbers are arrays, and
the functions below are NumPy's; compiled they are single numbers, and
:mod:`wraparc.batch.underlay` puts the versions under them that LLVM turns into vector
instructions.
"""

from __future__ import annotations

from typing import Any

import numpy as np

LANES = 32  # of a block, compiled

#: a number of a lane: a float where compiled, an array in the interpreter
Number = Any
#: numbers that are looked up by an index
Table = Any


class Lanes:
    """Numbers by slot and lane: x[slot, lane]. In the interpreter there is one lane of arrays."""

    def __init__(self, slots: int) -> None:
        self.slots: list[Number] = [0.0] * slots

    def __getitem__(self, place: tuple[Number, int]) -> Number:
        slot = place[0]
        if isinstance(slot, np.ndarray):  # of each lane another one
            lane = range(len(slot))
            return np.array([self.slots[k][i] for k, i in zip(slot, lane, strict=True)])
        return self.slots[slot]

    def __setitem__(self, place: tuple[int, int], value: Number) -> None:
        self.slots[place[0]] = value


def lower(a: Number, b: Number) -> Number:
    """The lesser of two numbers."""
    return np.minimum(a, b)


def upper(a: Number, b: Number) -> Number:
    """The greater of two numbers."""
    return np.maximum(a, b)


def select(condition: Number, a: Number, b: Number) -> Number:
    """`a` where the condition holds, else `b`."""
    return np.where(condition, a, b)


def anywhere(condition: Number) -> bool:
    """Whether a condition holds; of an array, whether it holds anywhere."""
    return bool(np.any(condition))


def index(a: Number) -> Number:
    """The integer nearest to a number, to index with."""
    return np.rint(a).astype(np.int64)


def root(a: Number) -> Number:
    """Square root."""
    return np.sqrt(a)


def ln(a: Number) -> Number:
    """Natural logarithm of a positive number; compiled to within 5e-9."""
    return np.log(a)


def ex(a: Number) -> Number:
    """Exponential of a number between -700 and 700; compiled to within 2e-12."""
    return np.exp(a)


def full_ln(a: Number) -> Number:
    """Natural logarithm of a positive number, to rounding."""
    return np.log(a)


def full_ex(a: Number) -> Number:
    """Exponential of a number between -700 and 700, to rounding."""
    return np.exp(a)


def memory(array: Any, kind: str) -> Any:
    """Return an array as a buffer for a kernel; buffers of different kinds never overlap."""
    return array


def lanes() -> int:
    """Lanes of a block: one, which holds whole arrays; compiled 32."""
    return 1
