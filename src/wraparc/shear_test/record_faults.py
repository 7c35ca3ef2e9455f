"""What a record shows of its own recording: ends of sensors, lost or repeated rows, stick-slip.

Such a record reads like a sound one, and a law follows it well; only its numbers tell.
"""

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from wraparc.arrays import Array, Integers
from wraparc.shear_test.noise import noise_level
from wraparc.shear_test.record import MachineRecord
from wraparc.shear_test.strokes import Stroke
from wraparc.units import Cell

#: How stick-slip is fitted: the middle of its swings, or their upper or lower ends.
STICK_SLIP = ("mean", "upper", "lower")
#: Swings of friction, largest to smallest as a share of it, that are told as stick-slip. Ours.
LEAST_SWING = 0.05
# Equal readings that are no chance, and their share of all. Ours.
_EQUAL, _SHARE, _TAIL_SHARE = 6, 0.01, 0.03
# Resolution of a force beyond which equal readings tell nothing; rise before the first of them, as
# a share of the mean rise, that no peak has.
_COARSE, _KINK = 0.005, 0.2
# Noise, as a share of the largest reading, below which it is the curve that bends.
_NOISE = 2e-4
# A step of travel that is a gap: share of the travel, and multiple of the steps around it.
_GAP, _LONGER = 0.03, 8.0
_BLOCK, _DIFFERENT = 8, 5
# Stretches of travel in which a rise is looked at, and what it may go on by after a stall, of the
# largest friction. Ours.
_STRETCHES, _STALL, _CLEAR = 60, 0.06, 5.0
# Largest over smallest force of strokes that are tests of their own: where the way back was not
# written, and where it was; rows between strokes without one. Ours.
_UNLIKE_JUMPS, _UNLIKE, _JUMP_ROWS = 1.3, 2.0, 2
_PERIODS, _LEAST_MEMORY = 5, 0.15
# Skewness of the steps times the root of their number, and excess kurtosis, below which swings are
# no noise of a rig: one of 100 records of such noise is beyond (of AR(2), 125 and 1,000 readings).
_FALLS, _ONE_SIZE = -6.0, -1.2
# Standard deviations of such a memory by chance; less where the plan says that it is stick-slip.
_NO_CHANCE, _NO_CHANCE_IF_SAID = 3.5, 2.5


class Fault(NamedTuple):
    """What is wrong with a record, in the fields of `misfit.Sentence`."""

    about: str
    text: str
    headline: str = ""
    action: str = ""


class Swing(NamedTuple):
    """Stick-slip: largest less smallest friction as a share of it [-], travel of a period [m]."""

    size: float
    period: float
    readings: int


def without_repeats(record: MachineRecord) -> tuple[MachineRecord, list[Fault]]:
    """Return the record without rows that follow as an exact copy of those before them.

    A copy begins with a jump back of the travel; a machine that turns back has none.
    """
    rows = np.stack([record.travel, record.force], axis=-1)
    last: dict[bytes, int] = {}
    lags = np.zeros(len(rows), dtype=np.int64)
    for k, row in enumerate(rows):
        key = row.tobytes()
        lags[k] = k - last.get(key, k)
        last[key] = k
    step = float(np.median(np.abs(np.diff(record.travel)))) if len(rows) > 1 else 0.0
    again = np.zeros(len(rows), dtype=bool)
    k = 1
    while k < len(rows):
        end = k
        while end < len(rows) and lags[end] == lags[k] > 0:
            end += 1
        jump = abs(float(record.travel[k] - record.travel[k - 1]))
        copies = end - k >= _BLOCK and jump > 3.0 * step
        if copies and len(np.unique(record.force[k:end])) >= _DIFFERENT:
            again[k:end] = True
        k = max(end, k + 1)
    if not again.any():
        return record, []
    text = (
        f"{int(again.sum())} rows repeat those before them to the last digit, from line "
        f"{int(record.lines[int(np.argmax(again))])} on: they were counted once; see whether what "
        "they replaced is missing"
    )
    keep = ~again
    one = replace(
        record,
        travel=record.travel[keep],
        force=record.force[keep],
        lines=record.lines[keep],
        normal_force=None if record.normal_force is None else record.normal_force[keep],
        time=None if record.time is None else record.time[keep],
    )
    head = "rows of its file stand there twice"
    return one, [Fault("repeated rows", text, head, "Use the file as the machine wrote it.")]


def saturated(values: Array, travel: Array) -> int:
    """Readings that equal the largest, where a sensor at its end makes them; else 0.

    Noise wider than the resolution gives equal readings only there. Without such noise it is the
    kink before them: friction comes to its peak without one.

    Parameters
    ----------
    values
        Readings of a sensor in the order of travel, positive, shape (n,).
    travel
        From 0 [m], shape (n,).
    """
    top = float(values.max())
    at = values == top
    count, first = int(at.sum()), int(np.argmax(at))
    if count < max(_EQUAL, _SHARE * len(values)) or count == len(values) or top <= 0.0:
        return 0
    resolution = float(np.diff(np.unique(values)).min())
    noise = noise_level(values[:first]) if first >= 2 * _EQUAL else noise_level(values[~at])
    if noise > max(2.0 * resolution, _NOISE * top):
        return count
    end = float(travel[first])
    before = float(np.interp(0.9 * end, travel[: first + 1], values[: first + 1]))
    flat = float(at[first:].mean()) > 0.9
    kink = (1.0 - before / top) / 0.1 > _KINK
    fine = resolution < _COARSE * top and noise < _COARSE * top
    return count if fine and flat and kink and end > 0.0 else 0


def travel_faults(record: MachineRecord, rows: Integers, direction: int) -> list[Fault]:
    """What the travel of a pull shows: at an end of its sensor, standing still, or with a gap.

    Parameters
    ----------
    record
        The record.
    rows
        Rows of the pull.
    direction
        +1 or -1, the sign of its travel.
    """
    travel = record.travel[rows] * direction
    load = np.abs(record.force)
    least = max(_EQUAL, int(_TAIL_SHARE * len(record.travel)))
    found = []
    # The pull ends at the first of the largest readings of the travel; what follows it stands.
    after = np.arange(int(rows[np.argmax(travel)]), len(record.travel))
    stands = record.travel[after] * direction == travel.max()
    held = after[: int(np.argmin(stands)) if not stands.all() else len(after)]
    if len(held) >= least:
        half = max(len(held) // 4, 1)
        begin, end = (float(np.median(load[part])) for part in (held[:half], held[-half:]))
        early = float(np.median(load[held[half : 2 * half]]))
        relaxes = begin - early > 0.5 * (begin - end) > 0.005 * begin
        if end > 0.99 * begin or (not relaxes and end > 0.5 * begin):
            found.append(
                f"the travel is constant at its maximum in {len(held)} readings, to the digit, "
                "and the force does not relax: the travel was at the end of its sensor, and the "
                "slip after it is not known"
            )
    count = int(np.argmax(travel != travel[0]))
    top = float(load[rows].max())
    rises = count >= least and float(load[rows[count - 1]] - load[rows[0]]) > 0.1 * top
    if rises:
        found.append(
            f"the travel is constant at its first value in {count} readings, to the digit, while "
            "the "
            "force rises: the slip under it is not known"
        )
    head, action = "travel is constant over many readings", "Check the range of the travel sensor."
    faults = [Fault("travel at its end", text, head, action) for text in found]
    return faults + _gap(travel, record.lines[rows])


def unlike_strokes(record: MachineRecord, found: Sequence[Stroke]) -> list[Fault]:
    """What several strokes show: loads so unlike that they are tests of their own.

    Run-in changes friction, and not to twice as much; where the way back was not written, the
    strokes may be tests that somebody has put under each other, of whatever loads.
    """
    tops = [float(np.quantile(np.abs(record.force[s.rows]), 0.95)) for s in found]
    ends = [(int(a.rows[-1]) + a.released, int(b.rows[0])) for a, b in pairwise(found)]
    jumps = all(b - a <= _JUMP_ROWS for a, b in ends)
    if max(tops) < (_UNLIKE_JUMPS if jumps else _UNLIKE) * min(tops):
        return []
    place = int(record.lines[ends[0][1]])
    text = (
        f"its {len(found)} strokes reach {tops[0]:.4g} to {max(tops):.4g} N, the next from line "
        f"{place} on: tests of their own under each other? Divide the file, or name the test of "
        "each row in a column"
    )
    head = f"{len(found)} strokes of unlike force, maybe several tests"
    return [Fault("unlike strokes", text, head, "Divide the file, one test each.")]


def _gap(travel: Array, lines: Integers) -> list[Fault]:
    steps = np.diff(travel)
    span = float(np.ptp(travel))
    if len(steps) < 2 * _BLOCK or span <= 0.0:
        return []
    wide = np.flatnonzero(steps > _GAP * span)
    sizes = [[np.abs(steps[max(0, k - 10) : k]), np.abs(steps[k + 1 : k + 11])] for k in wide]
    usual = np.array(
        [max((float(np.median(s)) for s in two if len(s)), default=0) for two in sizes]
    )
    wide = wide[steps[wide] > _LONGER * usual]
    if not len(wide):
        return []
    k = int(wide[np.argmax(steps[wide])])
    share = 100.0 * float(steps[wide].sum()) / span
    where = "at 1 place" if len(wide) == 1 else f"at {len(wide)} places"
    text = (
        f"readings are missing {where}, the most behind line {int(lines[k])}: {share:.0f} % of the "
        "travel has none, and the law there is drawn between its neighbours"
    )
    head = f"readings are missing over {share:.0f} % of the travel"
    return [Fault("missing readings", text, head, "Use the whole record, or repeat the test.")]


def swing(travel: Array, friction: Array, top: float, *, said: bool = False) -> Swing | None:
    """Find stick-slip in the sliding part: swings that come again, five times or more.

    Parameters
    ----------
    travel, friction
        Of the pull, travel ascending, shape (n,).
    top
        Largest friction [-].
    said
        Whether the plan says that there is stick-slip.
    """
    start = int(np.argmax(friction > 0.6 * top))
    x, y = travel[start:], friction[start:]
    count = len(x)
    if count < 8 * _PERIODS or x[-1] <= x[0]:
        return None
    design = np.vander((x - x[0]) / (x[-1] - x[0]), 8)
    off = y - design @ np.linalg.lstsq(design, y, rcond=None)[0]
    low, high = np.quantile(off, [0.05, 0.95])
    size = float(high - low) / 0.9 / max(float(np.mean(y)), 1e-12)
    if size < LEAST_SWING:
        return None
    width = 2 ** int(np.ceil(np.log2(2 * count)))
    memory = np.fft.irfft(np.abs(np.fft.rfft(off, width)) ** 2, width)[: count // _PERIODS]
    memory = memory / memory[0]
    falls = int(np.argmax(memory < 0.0))
    if memory[falls] >= 0.0:
        return None
    tops = np.flatnonzero((memory[1:-1] >= memory[:-2]) & (memory[1:-1] > memory[2:])) + 1
    tops = tops[tops > falls]
    # Noise of some memory has a memory by chance (Bartlett, 1946).
    by_chance = np.sqrt((1.0 + 2.0 * float(np.sum(memory[1:falls] ** 2))) / count)
    least = max(_LEAST_MEMORY, (_NO_CHANCE_IF_SAID if said else _NO_CHANCE) * by_chance)
    if not len(tops) or memory[tops].max() < least:
        return None
    if not said and not _is_stick_slip(off):
        return None
    # Of swings that are not all alike the second return may be the better one.
    period = int(tops[memory[tops] > 0.6 * memory[tops].max()][0])
    return Swing(size, period * float(x[-1] - x[0]) / (count - 1), period)


def _is_stick_slip(off: Array) -> bool:
    """Whether swings fall faster than they rise, or are of one size, as noise of a rig is not.

    Noise that a wheel or a filter makes periodic rises as fast as it falls, and comes and goes:
    its readings are normal.

    Parameters
    ----------
    off
        Friction less its trend, shape (n,).
    """
    step = np.diff(off)
    step = step - step.mean()
    skewness = float((step**3).mean()) / float((step**2).mean()) ** 1.5
    return skewness * np.sqrt(len(off)) < _FALLS or excess_kurtosis(off) < _ONE_SIZE


def excess_kurtosis(values: Array) -> float:
    """Return the excess kurtosis of readings: 0 of normal ones, -1.5 of a sine, -1.2 of teeth."""
    off = values - values.mean()
    return float((off**4).mean()) / float((off**2).mean()) ** 2 - 3.0


def stall(travel: Array, friction: Array, top: float, onset: float) -> list[Fault]:
    """What the rise of friction shows: it stands still and goes on, as slack taken up again does.

    Friction of a rubber rises ever less steeply; between a fifth of the largest and its top, a rise
    over a stretch that is followed by a larger one over as long a stretch is another thing.

    Parameters
    ----------
    travel, friction
        Of the pull, travel ascending, shape (n,).
    top
        Largest friction [-].
    onset
        Travel where friction starts to rise [m].
    """
    edges = np.linspace(onset, float(travel[-1]), _STRETCHES + 1)
    place = np.searchsorted(edges, travel, side="right") - 1
    inside = (place >= 0) & (place < _STRETCHES)
    counts = np.bincount(place[inside], minlength=_STRETCHES)
    if not np.all(counts):
        return []
    mean = np.bincount(place[inside], friction[inside], minlength=_STRETCHES) / counts
    begin, end = int(np.argmax(mean > 0.2 * top)), int(np.argmax(mean > 0.92 * top))
    most, found = _STALL * top, None
    for width in range(2, (end - begin) // 2 + 1):
        rise = mean[begin + width :] - mean[begin:-width]
        bend = rise[width:] - rise[:-width]
        # Noise of whatever memory bends all of the curve by as much.
        usual = 1.4826 * float(np.median(np.abs(bend - np.median(bend))))
        k = int(np.argmax(bend[: end - begin + 1 - 2 * width]))
        if bend[k] > max(most, _CLEAR * usual):
            most, found = float(bend[k]), (begin + k, begin + k + width)
    if found is None:
        return []
    a, b = (float(0.5 * (edges[k] + edges[k + 1])) for k in found)
    where = Cell(b, "length", 2, "to", a)
    text = (
        f"friction rises less from {where} of travel than over as much "
        f"after it, by {100 * most / top:.0f} % of its maximum: slack was taken up again, "
        "or the stroke stopped"
    )
    head = f"friction stops rising at {where} of travel"
    return [Fault("stall", text, head, "Check clamps and drive of the rig, and repeat the test.")]


def envelope(friction: Array, readings: int, which: str) -> Integers:
    """Rows of the upper or lower ends of the swings: one in each period, shape (m,)."""
    sign = 1.0 if which == "upper" else -1.0
    parts = np.split(np.arange(len(friction)), np.arange(readings, len(friction), readings))
    return np.array([int(part[np.argmax(sign * friction[part])]) for part in parts])
