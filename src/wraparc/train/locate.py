"""Find the tensions of a train from its speeds: all of them, and which one is stable."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import isnan

from wraparc.train.member import COARSE, FINE, SHARP, Passage
from wraparc.train.newton import Settled, settle
from wraparc.train.result import TrainStatus
from wraparc.train.system import Search, System


@dataclass(frozen=True, eq=False)
class Located:
    """The tensions of a train.

    Attributes
    ----------
    status, reason
        How the search ended.
    passages
        One for each pulley.
    level
        ln(V/v0) [-].
    settled
        The solution with its slopes, if there is one.
    other_splits
        Shares of the unstable solutions.
    """

    status: TrainStatus
    reason: str
    passages: tuple[Passage, ...]
    level: float
    settled: Settled | None = None
    other_splits: tuple[tuple[float, ...], ...] = ()


def locate(system: System, names: Sequence[str], softening: bool) -> Located:
    """Return the stable state of a train whose drums turn as given.

    Parameters
    ----------
    system
        The equations.
    names
        Of the pulleys, for the reason of a failure.
    softening
        Whether friction falls anywhere with slip, so that there may be several states.
    """
    for steps in (COARSE, SHARP):
        search = Search(system, steps)
        levels, states, failed = _states(system, search, softening)
        if not failed:
            break
    if not levels:
        level = search.level(search.strongest())
        return _broken(system, names, tuple(search.follow(level)), level)
    if not states:
        return _broken(system, names, failed[0], search.level(levels[0]))
    return _chosen(system, names, states)


def _states(
    system: System, search: Search, softening: bool
) -> tuple[list[float], list[Settled], list[tuple[Passage, ...]]]:
    """Return the levels found by a search, the states there, and starts that led to none."""
    if softening:
        levels = search.all_solutions()
    else:
        w, miss = search.solution()
        levels = [w] if abs(miss) < 1e-3 else []
    states: list[Settled] = []
    failed: list[tuple[Passage, ...]] = []
    for w in levels:
        start = tuple(search.follow(search.level(w)))
        found = settle(system, start, search.level(w))
        if found is None:
            failed.append(start)
        elif not any(_same(found, other) for other in states):
            states.append(found)
    return levels, states, failed


def _chosen(system: System, names: Sequence[str], states: list[Settled]) -> Located:
    """Return the stable one of several states; there is none where a drive is past its peak."""
    states = sorted(states, key=lambda s: max(abs(p.creep) for p in s.passages))
    state = next((s for s in states if s.stable), states[0])
    others = tuple(_shares(system, s) for s in states if s is not state)
    sliding = [
        name
        for name, member, p, rising in zip(
            names, system.members, state.passages, state.rising, strict=True
        )
        if not rising or (member.holds and not p.held)
    ]
    status, reason = TrainStatus.SOLVED, ""
    if sliding:
        status = TrainStatus.BREAKAWAY
        reason = (
            f"At these speeds {_listed(sliding)} away: the only balance there is has "
            f"{'it' if len(sliding) == 1 else 'them'} sliding, past the peak of friction."
        )
    return Located(status, reason, state.passages, state.level, state, others)


def _broken(
    system: System, names: Sequence[str], passages: tuple[Passage, ...], level: float
) -> Located:
    """Return the failure of a train, with the drives that break away."""
    fallen, exact = [], []
    for name, member, p in zip(names, system.members, passages, strict=True):
        known: Passage | None = p
        if isnan(p.effort):
            known = member.between(p.entry, p.exit)
            if known is None:
                fallen.append(name)
        elif member.slopes(p, FINE).exit_by_effort >= 0.0:
            fallen.append(name)
        exact.append(known or p)
    if fallen:
        reason = f"{_listed(fallen)} away: no creep makes enough friction."
        return Located(TrainStatus.BREAKAWAY, reason, tuple(exact), level)
    reached = passages[-1].exit
    if abs(reached / system.exit - 1.0) > 1e-3:
        reason = f"The friction of {' and '.join(names)} together cannot carry the load."
        return Located(TrainStatus.BREAKAWAY, reason, tuple(exact), level)
    return Located(TrainStatus.UNSOLVED, "", tuple(exact), level)


def _listed(names: Sequence[str]) -> str:
    """Return "a breaks" or "a and b break"."""
    return f"{' and '.join(names)} break{'s' if len(names) == 1 else ''}"


def _same(a: Settled, b: Settled) -> bool:
    pairs = zip(a.passages, b.passages, strict=True)
    return all(abs(x.exit / y.exit - 1.0) < 1e-6 for x, y in pairs)


def _shares(system: System, state: Settled) -> tuple[float, ...]:
    return tuple((p.entry - p.exit) / system.pull for p in state.passages)
