"""Find the tensions of a train from its speeds: all of them, and which one is stable."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import isnan, log, sqrt

from wraparc.train.member import COARSE, FINE, SHARP, Passage
from wraparc.train.newton import Settled, settle
from wraparc.train.result import TrainStatus
from wraparc.train.system import Search, System, guessed

#: Change of the logarithms of tensions, from one mesh to the next, that is left alone; rounds.
_SAME, _ROUNDS = 1e-7, 5
#: Give of eased speeds, ln(speed) for the whole load, and where it may be left out [-].
_GIVE, _LEAST_GIVE = 1e-2, 1e-6
_LESS, _MOST = 0.2, 0.97  # factors of the give from step to step


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
    fallen
        The drives that break away, by index.
    """

    status: TrainStatus
    reason: str
    passages: tuple[Passage, ...]
    level: float
    settled: Settled | None = None
    other_splits: tuple[tuple[float, ...], ...] = ()
    fallen: tuple[int, ...] = ()


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
    fine = FINE if softening else SHARP
    passages, level = guessed(system)
    state = None if softening else settle(system, passages, level, fine)
    if state is not None:
        return _as_told(system, _chosen(system, names, [state]))
    eased = _eased(system, _GIVE)
    for tol in (COARSE, SHARP):  # close to breakaway a coarse mesh misses the solution
        search = Search(eased, tol)
        levels, states, failed = _states(eased, search, softening, fine)
        if len(levels) > 0 and len(failed) == 0:
            break
    if eased is not system:
        stiff = [_stiffened(system, state) for state in states]
        states = [s for s in stiff if s is not None]
    if len(levels) == 0:
        level = search.level(search.strongest())
        return _broken(system, names, tuple(search.follow(level).passages), level)
    if len(states) == 0:
        level = search.level(levels[0])
        start = failed[0] if len(failed) > 0 else tuple(search.follow(level).passages)
        return _broken(system, names, start, level)
    return _as_told(system, _chosen(system, names, states))


def _as_told(system: System, located: Located) -> Located:
    """Return the tensions at which the arcs, solved for their tensions, meet the speeds.

    On the meshes of those: what is told of a train are its arcs alone.
    """
    for _ in range(_ROUNDS):
        state = located.settled
        if state is None or located.status is not TrainStatus.SOLVED:
            break
        solved = []
        for member, p in zip(system.members, state.passages, strict=True):
            at = member.between(p.entry, p.exit)
            if at is None:
                return located
            solved.append(at)
        better = settle(system, solved, state.level, COARSE)
        if better is None:
            break
        located = replace(located, settled=better, passages=better.passages, level=better.level)
        pairs = zip(better.passages, state.passages, strict=True)
        if max(abs(log(a.exit / b.exit)) for a, b in pairs) < _SAME:
            break
    return located


def _eased(system: System, give: float) -> System:
    """Return the train with a little give in its held speeds, where laws hold the belt.

    A belt that rests on a drum tells nothing of the load by its speed: each step of the search
    would have no answer. With some give it has one.
    """
    if not any(
        m.holds and line.motor is None for m, line in zip(system.members, system.lines, strict=True)
    ):
        return system
    lines = tuple(
        replace(line, give=give / system.torque_scale) if line.motor is None else line
        for line in system.lines
    )
    return replace(system, lines=lines)


def _stiffened(system: System, state: Settled) -> Settled | None:
    """Return what becomes of a state of the eased train as the give goes."""
    give, factor, now = _GIVE, _LESS, state
    while give > 0.0:
        less = factor * give if give > _LEAST_GIVE else 0.0
        found = settle(_eased(system, less), now.passages, now.level)
        if found is not None:
            give, now = less, found
            factor = max(factor * factor, _LESS)
        elif less > 0.0 and factor < _MOST:
            factor = sqrt(factor)
        else:
            return None
    return now


def _states(
    system: System, search: Search, softening: bool, tol: float
) -> tuple[list[float], list[Settled], list[tuple[Passage, ...]]]:
    """Return the levels found by a search, the states there, and starts that led to none."""
    if softening:
        levels = search.all_solutions()
    else:
        w, miss = search.solution(1e-4)
        levels = [w] if abs(miss) < 1e-3 else []
    states: list[Settled] = []
    failed: list[tuple[Passage, ...]] = []
    for w in levels:
        start = tuple(search.follow(search.level(w)).passages)
        found = settle(system, start, search.level(w), tol)
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
    past = zip(system.members, state.passages, state.rising, strict=True)
    fallen = tuple(
        i for i, (m, p, rising) in enumerate(past) if not rising or (m.holds and not p.held)
    )
    status, reason = TrainStatus.SOLVED, ""
    if len(fallen) > 0:
        status = TrainStatus.BREAKAWAY
        reason = (
            f"At these speeds gross slip on {_listed(names, fallen)}: the only balance has "
            f"{'it' if len(fallen) == 1 else 'them'} sliding, past the peak of friction."
        )
    return Located(status, reason, state.passages, state.level, state, others, fallen)


def _broken(
    system: System, names: Sequence[str], passages: tuple[Passage, ...], level: float
) -> Located:
    """Return the failure of a train, with the drives that break away."""
    fallen, exact = [], []
    for i, (member, p) in enumerate(zip(system.members, passages, strict=True)):
        known: Passage | None = p
        if isnan(p.place):
            known = member.between(p.entry, p.exit)
            if known is None:
                fallen.append(i)
        elif not member.rises(p):
            fallen.append(i)
        exact.append(p if known is None else known)
    status = TrainStatus.BREAKAWAY
    reason = ""
    if len(fallen) > 0:
        reason = away(names, fallen)
    elif abs(passages[-1].exit / system.exit - 1.0) > 1e-3:
        fallen = list(range(len(names)))
        reason = f"The friction of {' and '.join(names)} together cannot transmit the load."
    else:
        status = TrainStatus.UNSOLVED
    return Located(status, reason, tuple(exact), level, fallen=tuple(fallen))


def away(names: Sequence[str], indices: Sequence[int]) -> str:
    """Return which drives slip."""
    return f"Gross slip on {_listed(names, indices)}: no creep gives enough friction."


def _listed(names: Sequence[str], indices: Sequence[int]) -> str:
    """Return the names of drives, "a and b"."""
    return " and ".join(names[i] for i in indices)


def _same(a: Settled, b: Settled) -> bool:
    pairs = zip(a.passages, b.passages, strict=True)
    return all(abs(x.exit / y.exit - 1.0) < 1e-6 for x, y in pairs)


def _shares(system: System, state: Settled) -> tuple[float, ...]:
    return tuple((p.entry - p.exit) / system.pull for p in state.passages)
