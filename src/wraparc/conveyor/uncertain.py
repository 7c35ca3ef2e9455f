"""How far the tensions of a conveyor may be off, by what is stated of its numbers."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import sqrt
from typing import Any

from wraparc.conveyor.conveyor import Conveyor
from wraparc.conveyor.state import State
from wraparc.errors import InputError

#: Step of a slope, of the number [-].
_STEP = 1e-3
_TAKE_UP = ("take_up_tension", "counterweight")


def uncertain_tensions(conveyor: Conveyor, states: Sequence[State]) -> list[dict[str, float]]:
    """Return the uncertainties of the tensions in each load case, by key [-].

    That of the effective tension is the root of the sum of squares of what each number makes of it,
    by its slope; that of the take-up tension moves the slack side by as much. 100 % at most.

    Parameters
    ----------
    conveyor
        The conveyor.
    states
        Its load cases.
    """
    squares, lift = [0.0 for _ in states], 0.0
    stated = [key for key in conveyor.uncertainty if key not in _TAKE_UP]
    for key in conveyor.uncertainty:
        value = conveyor.uncertainty[key]
        if key in _TAKE_UP:
            lift = value * conveyor.take_up
            continue
        moved, step = _moved(conveyor, key)
        for i in range(len(moved)):
            slope = (_pull(moved[i]) - _pull(states[i])) / step
            squares[i] += (slope * value) ** 2
    found: list[dict[str, float]] = []
    for i in range(len(states)):
        state, of = states[i], dict[str, float]()
        pull = abs(_pull(state))
        if stated and pull > 0.0:
            of["effective_tension"] = min(sqrt(squares[i]) / pull, 1.0)
        if len(stated) < len(conveyor.uncertainty):
            end = "exit_tension" if state.entry > state.exit else "entry_tension"
            of[end] = min(lift / min(state.entry, state.exit), 1.0)
        found.append(of)
    return found


def _pull(state: State) -> float:
    return state.entry - state.exit


def _moved(conveyor: Conveyor, key: str) -> tuple[Sequence[State], float]:
    """Return the load cases with a number a little larger, or smaller where it is at its limit."""
    for step in (_STEP, -_STEP):
        more: dict[str, Any] = {key: getattr(conveyor, key) * (1.0 + step)}
        try:
            return replace(conveyor, **more).states(), step
        except InputError:
            continue
    return conveyor.states(), 1.0
