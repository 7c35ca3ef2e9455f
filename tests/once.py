"""What many tests ask for, found once in a session: arcs, trains, and what is said of them.

For tests of doors and words, which differ by what they make of a result. Where a solver, an action
or a reserve is itself the subject, nothing is remembered.
"""

import os
import pickle
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import lru_cache
from typing import Any

import pytest

from wraparc.actions import find as actions
from wraparc.arc import Distributed, WrapArc
from wraparc.catalogue.own import VARIABLE
from wraparc.checks.least_tension import LeastTension
from wraparc.reserve import find as reserve
from wraparc.reserve import probability
from wraparc.train import TrainResult
from wraparc.train import solve as train_solve
from wraparc.train.whole import Whole, by_pulley

_ARCS, _TRAINS, _SAID = 2000, 500, 500
#: What is found of a solved drive or train, by where it stands.
_OF_RESULTS = (
    (actions, "_find"),
    (reserve, "_find"),
    (probability, "_find"),
    (sys.modules[LeastTension.__module__], "least_of"),
)


def _stated(result: Whole) -> bytes:
    """Return all that was solved, texts, conveyor and document too, and among what catalogue."""
    described = result.train if isinstance(result, TrainResult) else result.drive
    return pickle.dumps((described, os.environ.get(VARIABLE)))


class _Asked:
    """A result, compared by what was solved and by its arcs, of which each is there once."""

    def __init__(self, result: Whole) -> None:
        self.result = result  # its arcs stay, and so do the numbers that they have
        self._key = (_stated(result), tuple(id(arc) for arc in by_pulley(result)))
        self._hash = hash(self._key)

    def __hash__(self) -> int:
        return self._hash

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Asked) and self._key == other._key


def _of_result(function: Callable[..., Any]) -> Callable[..., Any]:
    """Return a function of a result that is found once for all results of the same drive."""
    found = lru_cache(_SAID)(lambda asked, *more, **how: function(asked.result, *more, **how))
    return lambda result, *more, **how: found(_Asked(result), *more, **how)


solve = lru_cache(_ARCS)(Distributed.solve)
_locate = lru_cache(_TRAINS)(vars(train_solve)["locate"])
_said = {(room, name): _of_result(getattr(room, name)) for room, name in _OF_RESULTS}


@contextmanager
def solved_once(solving: Callable[[Distributed, WrapArc], Any] = solve) -> Iterator[None]:
    """Find what is asked for once.

    Parameters
    ----------
    solving
        What solves an arc.
    """
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Distributed, "solve", solving)
        patch.setattr(train_solve, "locate", lambda s, names, soft: _locate(s, tuple(names), soft))
        for (room, name), found in _said.items():
            patch.setattr(room, name, found)
        _forget_answered()
        yield
    _forget_answered()


def _forget_answered() -> None:
    """Forget what a server in this process has solved, perhaps with arcs moved by rounding."""
    if room := sys.modules.get("wraparc.web.answers.solved"):
        room._kept.clear()
