"""The stroke of a record: where the machine pulls, where it turns back, where it lets go."""

import itertools
from dataclasses import dataclass

import numpy as np

from wraparc.arrays import Array, Integers
from wraparc.shear_test.noise import noise_level

# A turn back counts as one if it is longer than this part of the whole travel.
_TURN = 0.02
_DROP = 0.6
# Share of the largest load below which a part of a record is none, whatever it rises from. Ours.
_LIGHT = 0.02


@dataclass(frozen=True, eq=False)
class Stroke:
    """Rows of the pull, in order.

    Parameters
    ----------
    rows
        Indices into the record.
    direction
        +1 or -1: sign of the travel while it pulls.
    released
        Rows at the end after the force has collapsed.
    """

    rows: Integers
    direction: int
    released: int


def find_strokes(travel: Array, force: Array) -> list[Stroke]:
    """Find the pulls in a record, in order; none if the travel does not advance.

    The travel is cut where it turns back by more than 2 % of its range. Of the parts, those of
    at least 80 % of the largest advance, and of 20 % of the largest load or of a load that rises
    from nothing, in the direction of the first of them, are pulls; an approach without load and
    the ways back are none.
    """
    span = float(np.ptp(travel))
    if len(travel) < 2 or span <= 0.0:
        return []
    parts = list(itertools.pairwise(_turning_points(travel, _TURN * span)))
    found: list[Stroke] = []
    for start, stop in _pulls(parts, travel, np.abs(force)):
        advance = float(travel[stop] - travel[start])
        direction = 1 if advance > 0 else -1
        rows = np.arange(start, stop + 1)
        # Up and down in turn, a record of no direction: no part of it is a pull.
        if abs(advance) < 0.3 * span or len(rows) < 3:
            continue
        if found and direction != found[0].direction:
            continue
        kept = _before_release(np.abs(force[rows]), np.abs(travel[rows] - travel[start]))
        found.append(Stroke(rows[:kept], direction, len(rows) - kept))
    return found


def _pulls(parts: list[tuple[int, int]], travel: Array, load: Array) -> list[tuple[int, int]]:
    """The long parts that are not run without load, as an approach is; else the longest."""
    advances = [abs(float(travel[b] - travel[a])) for a, b in parts]
    loads = [float(np.median(load[a : b + 1])) for a, b in parts]
    return [
        part
        for part, advance, mean in zip(parts, advances, loads, strict=True)
        if advance >= 0.8 * max(advances)
        and (mean >= 0.2 * max(loads) or _rises(load[part[0] : part[1] + 1], max(loads)))
    ] or [parts[advances.index(max(advances))]]


def _rises(load: Array, largest: float) -> bool:
    """Whether a light load comes from nothing, as that of a pull does, and is more than noise."""
    begin = float(np.median(load[: max(3, len(load) // 50)]))
    end = load[len(load) // 2 :]
    level = float(np.median(end))
    return level > max(_LIGHT * largest, 3.0 * begin, 5.0 * noise_level(end))


def _turning_points(travel: Array, tolerance: float) -> list[int]:
    """Indices of the start, of each turn larger than `tolerance`, and of the end."""
    turns = [0]
    place, direction = 0, 0
    blocks = max(1, len(travel) // 4000)
    # Turns are few: look for them in thinned rows, then place them exactly.
    picked = np.unique(np.append(np.arange(0, len(travel), blocks), len(travel) - 1))
    for k in picked.tolist():
        step = travel[k] - travel[place]
        if direction == 0:
            if abs(step) > tolerance:
                direction = 1 if step > 0 else -1
                place = k
        elif step * direction > 0:
            place = k
        elif abs(step) > tolerance:
            turns.append(_exact(travel, place, blocks, direction))
            direction, place = -direction, k
    end = _exact(travel, place, blocks, direction or 1)
    if end > turns[-1]:
        turns.append(end)
    if turns[-1] != len(travel) - 1 and len(turns) == 1:
        turns.append(len(travel) - 1)
    return turns


def _exact(travel: Array, place: int, reach: int, direction: int) -> int:
    first = max(0, place - reach)
    window = travel[first : place + reach + 1] * direction
    return first + int(np.argmax(window))


def _before_release(force: Array, travel: Array) -> int:
    """Number of rows before a collapse of the force near the end of the pull."""
    count = len(force)
    tail = int(np.searchsorted(travel, 0.9 * travel[-1])) if travel[-1] > 0 else count
    tail = min(tail, count - 3)
    if tail < 10:
        return count
    level = float(np.median(force[max(0, tail - count // 10) : tail]))
    low = np.flatnonzero(force[tail:] < _DROP * level)
    if len(low) == 0:
        return count
    first = tail + int(low[0])
    # A spike comes back; a release does not.
    if np.median(force[first:]) > 0.8 * level:
        return count
    while first > tail and force[first - 1] < 0.97 * level:
        first -= 1
    return first
