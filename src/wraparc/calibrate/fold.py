"""Records of instrumented pulleys cut into revolutions and laid on the contact arc."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from wraparc.arrays import Array, Flags, Integers
from wraparc.calibrate.record import RecordChoices
from wraparc.calibrate.virtual_pulley import PulleyRecord
from wraparc.drive import Drive
from wraparc.errors import InputError, Problem, input_error

_MOST_BINS = 720
_POINTS = 90  # on the wrap
_ACTIVE = 0.02
_MOSTLY_ONE_SIGN = 0.5


@dataclass(frozen=True, eq=False, kw_only=True)
class Folded:
    """A record laid on the contact arc, revolutions averaged.

    Attributes
    ----------
    position
        theta from the entry nip, shape (n,) [rad].
    displacement, shear_angle
        Means at these positions, shape (n,) [m] and [rad], or None; sign as in the model.
    revolutions
        Full contact arcs found.
    entry, leaving
        Rotation angle at the entry and exit nip, in [0, 2 pi) [rad].
    seen
        Arc over which the signals are seen to differ from their level off the belt [rad].
    notes
        What was decided on the way, in sentences.
    """

    position: Array
    displacement: Array | None
    shear_angle: Array | None
    revolutions: int
    entry: float
    leaving: float
    seen: float
    notes: tuple[str, ...] = ()


def fold(
    record: PulleyRecord,
    drive: Drive,
    pulley: str,
    load_case: str,
    *,
    choices: RecordChoices | None = None,
) -> Folded:
    """Cut a record into revolutions, find the contact arc, and average over the revolutions.

    The exit nip is where the signals fall back to their level off the belt; the entry nip lies
    the wrap angle before it, since both signals begin there with next to nothing.

    Raises
    ------
    InputError
        If there is no full contact arc in the record, or a sign cannot be told.
    """
    signs = (choices or RecordChoices()).signs
    wrap = drive.pulley(pulley).wrap_angle
    case = drive.load_case(load_case)
    side = 1.0 if case.tensions[pulley].effective >= 0.0 else -1.0
    angle = record.angle if record.angle[-1] >= record.angle[0] else -record.angle
    signals = {
        name: value
        for name, value in (
            ("displacement", record.displacement),
            ("shear_angle", record.shear_angle),
        )
        if value is not None
    }
    _check_span(angle, wrap)
    bins = _bins(angle)
    levels, leaving, seen = _contact(angle, signals, wrap, bins)
    along = np.mod(angle - (leaving - wrap), 2.0 * np.pi)
    turn = np.floor((angle - (leaving - wrap)) / (2.0 * np.pi)).astype(np.int64)
    turn -= turn.min()
    whole = _whole_turns(turn, along, wrap)
    if not whole.any():
        raise InputError(_no_full_arc("no contact arc is recorded from its entry to its exit"))
    guard = 2.0 * np.pi / bins  # the nips are known to a bin: keep off them
    use = whole[turn] & (along >= guard) & (along <= wrap - guard)
    place = np.minimum((along[use] / wrap * _POINTS).astype(np.int64), _POINTS - 1)
    off = (along > wrap + 2.0 * guard) & (along < 2.0 * np.pi - 2.0 * guard)
    if np.count_nonzero(off) > 20:  # the mean of all off the belt is surer than a cluster
        levels = {name: float(value[off].mean()) for name, value in signals.items()}
    notes = [] if angle is record.angle else ["the rotation angle falls with time: turned round"]
    means = {}
    for name, value in signals.items():
        mean = _binned(value[use] - levels[name], place, _POINTS)
        sign = _sign(name, mean, side, signs.get(name))
        if sign < 0.0:
            notes.append(f"the sign of {name.replace('_', ' ')} was turned round")
        means[name] = sign * mean
    filled = np.bincount(place, minlength=_POINTS) > 0
    middle = _binned(along[use], place, _POINTS)  # where its samples lie, not its middle
    return Folded(
        position=middle[filled],
        displacement=means["displacement"][filled] if "displacement" in means else None,
        shear_angle=means["shear_angle"][filled] if "shear_angle" in means else None,
        revolutions=int(whole.sum()),
        entry=float(np.mod(leaving - wrap, 2.0 * np.pi)),
        leaving=float(np.mod(leaving, 2.0 * np.pi)),
        seen=seen,
        notes=tuple(notes),
    )


def _check_span(angle: Array, wrap: float) -> None:
    span = float(angle.max() - angle.min())
    if span < wrap:
        raise InputError(
            _no_full_arc(
                f"rotation {math.degrees(span):.0f} deg is below wrap {math.degrees(wrap):.0f} deg"
            )
        )


def _no_full_arc(why: str) -> Problem:
    return Problem(
        message=f"no full contact arc: {why}",
        remedy="Record one turn or more; check the unit of angle.",
    )


def _bins(angle: Array) -> int:
    """How many equal parts of a turn have at least two samples each."""
    step = float(np.median(np.abs(np.diff(angle))))
    return int(np.clip(np.pi / max(step, 1e-9), 60, _MOST_BINS))


def _contact(
    angle: Array, signals: Mapping[str, Array], wrap: float, n: int
) -> tuple[dict[str, float], float, float]:
    """Levels of the signals off the belt, angle of the exit nip, and the arc where they differ."""
    bins = np.minimum((np.mod(angle, 2.0 * np.pi) / (2.0 * np.pi) * n).astype(int), n - 1)
    count = np.bincount(bins, minlength=n)
    sampled = count > 0
    levels, active = {}, np.zeros(n, dtype=bool)
    total = np.zeros(n)
    for name, value in signals.items():
        mean = np.bincount(bins, weights=value, minlength=n) / np.maximum(count, 1)
        level, noise = _off_belt(mean[sampled], wrap)
        height = np.abs(mean - level)
        top = float(height[sampled].max())
        if top <= 6.0 * noise:
            message = f"the {name.replace('_', ' ')} does not stand out of its noise"
            raise InputError(_no_full_arc(message))
        levels[name] = level
        total += np.where(sampled, height / top, 0.0)
        active |= sampled & (height > max(_ACTIVE * top, 5.0 * noise))
    start, length = _longest_run(active)
    seen = length / n * 2.0 * np.pi
    end = (start + length) % n
    if not sampled[end]:
        raise InputError(_no_full_arc("the exit of the belt is not in it"))
    if seen > 1.1 * wrap + 0.1:
        message = (
            f"contact over {math.degrees(seen):.0f} deg exceeds the wrap angle "
            f"{math.degrees(wrap):.0f} deg"
        )
        remedy = "Check wrap angle and columns."
        raise input_error(message=message, remedy=remedy)
    # the exit nip cuts the last bin of the run: its mean tells where
    last, before = total[(end - 1) % n], total[(end - 2) % n]
    share = min(last / before, 1.0) if before > 0.0 and length > 2 else 1.0
    return levels, (end - 1 + share) / n * 2.0 * np.pi, seen


def _off_belt(means: Array, wrap: float) -> tuple[float, float]:
    """Level and noise of bin means off the belt: the narrowest cluster of as many as lie there."""
    ordered = np.sort(means)
    share = max(0.1, 0.8 * (1.0 - wrap / (2.0 * np.pi)))
    k = max(2, int(share * len(ordered)))
    widths = ordered[k - 1 :] - ordered[: len(ordered) - k + 1]
    first = int(np.argmin(widths))
    cluster = ordered[first : first + k]
    level = float(np.median(cluster))
    steps = np.abs(np.diff(means))  # a narrow cluster is narrower than the noise
    noise = 1.4826 * max(np.median(np.abs(cluster - level)), np.median(steps) / math.sqrt(2.0))
    return level, float(noise)


def _longest_run(active: Flags) -> tuple[int, int]:
    """Start and length of the longest run round the circle, gaps of three bins closed."""
    ring = active.copy()
    for shift in (1, 2, 3):
        ring |= np.roll(active, shift) & np.roll(active, shift - 4)
    if ring.all():
        return 0, len(ring)
    first = int(np.flatnonzero(~ring)[0])
    turned = np.roll(ring, -first).astype(np.int8)
    edges = np.flatnonzero(np.diff(np.concatenate([[0], turned, [0]])))
    starts, ends = edges[::2], edges[1::2]
    longest = int(np.argmax(ends - starts))
    return int((starts[longest] + first) % len(ring)), int(ends[longest] - starts[longest])


def _whole_turns(turn: Integers, along: Array, wrap: float) -> Flags:
    """Which turns have samples near both ends of the contact arc."""
    n = int(turn.max()) + 1
    near = 0.05 * wrap
    begins = np.bincount(turn[along < near], minlength=n) > 0
    ends = np.bincount(turn[(along > wrap - near) & (along < wrap + near)], minlength=n) > 0
    return np.asarray(begins & ends)


def _binned(value: Array, place: Integers, points: int) -> Array:
    """Mean of each bin."""
    count = np.maximum(np.bincount(place, minlength=points), 1)
    return np.bincount(place, weights=value, minlength=points) / count


def _sign(name: str, mean: Array, side: float, given: int | None) -> float:
    """What to multiply by to have the sign of the model, +1 or -1."""
    if given is not None:
        return float(given)
    share = float(mean.sum() / np.abs(mean).sum())
    if abs(share) < _MOSTLY_ONE_SIGN:
        raise input_error(
            key=f"signs.{name}",
            message=f"the {name.replace('_', ' ')} changes its sign under the belt",
            remedy="Write 1 if positive on a driving pulley, else -1.",
        )
    return 1.0 if share * side > 0.0 else -1.0
