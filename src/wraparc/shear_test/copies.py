"""Records that are made of others: scaled, resampled, shifted, drawn between two.

Noise of a reading is its own. Where that of two tests goes together, one was made of the other,
whatever was done to its force, its travel or its grid.
"""

from collections.abc import Sequence
from itertools import combinations

import numpy as np

from wraparc.arrays import Array
from wraparc.shear_test.analysis import TestResult
from wraparc.shear_test.misfit import Misfit

# Readings of the sliding part that tell it, and rows by which one record may start later. Ours.
_LEAST, _LAGS = 40, 30
# Correlation of the noise of two records that is no chance, of itself and over its error: of the
# largest of some thousands the error is 4.5. Ours.
_ALIKE, _NO_CHANCE = 0.45, 5.5
# Memory of a noise that is periodic (hum, a screw): it goes together without a copy. Ours.
_PERIODIC = 0.45


def copy_sentences(tests: Sequence[TestResult]) -> list[str]:
    """Say which tests share their noise.

    Parameters
    ----------
    tests
        Of one condition.
    """
    noises = [_noises(test) for test in tests]
    pairs = [
        (a, b)
        for a, b in combinations(range(len(tests)), 2)
        if any(
            one is not None and other is not None and _go_together(one, other)
            for one, other in zip(noises[a], noises[b], strict=True)
        )
    ]
    if not pairs:
        return []
    first, second = (tests[k].test.file for k in pairs[0])
    more = f", and {len(pairs) - 1} further pairs" if len(pairs) > 1 else ""
    text = (
        f"the noise of {first} and {second} goes together{more}, which no two tests have: one "
        "was copied, scaled, resampled or interpolated from the other, and is no repeat; the "
        "scatter between samples is not known by it"
    )
    head = f"{second} is made of {first}{f' ({len(pairs)} such pairs)' if more else ''}"
    return [Misfit(text, head, "Use each test once, as the machine wrote it.")]


class _Noise:
    """Noise of a sliding part: second differences, and the travel of each."""

    def __init__(self, travel: Array, friction: Array) -> None:
        self.travel, self.friction = travel, friction
        self.off = _second(friction)

    @property
    def is_of_readings(self) -> bool:
        """Whether it is that of single readings: not of a smooth curve, and not periodic."""
        off = self.off - self.off.mean()
        power = float(off @ off)
        if power <= 0.0:
            return False
        memory = [float(off[k:] @ off[:-k]) / power for k in range(1, min(40, len(off) // 3))]
        return memory[0] < 0.3 and max(map(abs, memory[4:]), default=0.0) < _PERIODIC


def _noises(test: TestResult) -> tuple[_Noise | None, _Noise | None]:
    """Noise of friction, and of the force where a normal force was measured.

    A normal force has its own noise, in which that of a copied force may hide.
    """
    curve, record = test.curve, test.record
    # Ties of the travel are one reading, so that it can be read between them.
    travel, place = np.unique(curve.travel, return_index=True)
    friction = curve.friction[place]
    slides = friction > 0.5 * curve.top
    if int(slides.sum()) < _LEAST or curve.swing is not None:
        return None, None
    begin = int(np.argmax(slides))
    own = _of_readings(travel[begin:], friction[begin:])
    if record.normal_force is None:
        return own, own
    way = np.abs(record.travel - record.travel[0])
    order = np.argsort(way, kind="stable")
    load = np.interp(travel, way[order], record.normal_force[order])
    return own, _of_readings(travel[begin:], (friction * load)[begin:])


def _of_readings(travel: Array, values: Array) -> _Noise | None:
    found = _Noise(travel, values)
    return found if len(found.off) >= _LEAST and found.is_of_readings else None


def _second(values: Array) -> Array:
    """Second differences, less what a smooth curve has of them, spikes cut."""
    off = np.diff(values, 2)
    spread = 1.4826 * float(np.median(np.abs(off - np.median(off))))
    return np.clip(off - np.median(off), -4.0 * spread, 4.0 * spread)


def _go_together(first: _Noise, second: _Noise) -> bool:
    """Whether the noise of two tests is one, row by row, over travel or over its share."""
    found = _largest(first.off, second.off)
    for scale in (1.0, float(second.travel[-1] / first.travel[-1])):
        at = first.travel * scale
        inside = (at >= second.travel[0]) & (at <= second.travel[-1])
        if int(inside.sum()) < _LEAST:
            continue
        there = np.interp(at[inside], second.travel, second.friction)
        found = max(found, _correlation(_second(first.friction[inside]), _second(there)))
    count = min(len(first.off), len(second.off))
    return found > max(_ALIKE, _NO_CHANCE / float(np.sqrt(count)))


def _largest(first: Array, second: Array) -> float:
    """Largest correlation row by row, either of them later."""
    best = 0.0
    for lag in range(-_LAGS, _LAGS + 1):
        # from the ends, which both records have, and from the starts
        for a, b in (
            (first[max(lag, 0) :], second[max(-lag, 0) :]),
            (first[: len(first) - max(lag, 0)][::-1], second[: len(second) - max(-lag, 0)][::-1]),
        ):
            count = min(len(a), len(b))
            if count >= _LEAST:
                best = max(best, _correlation(a[:count], b[:count]))
    return best


def _correlation(first: Array, second: Array) -> float:
    a, b = first - first.mean(), second - second.mean()
    size = float(np.sqrt((a @ a) * (b @ b)))
    return float(a @ b) / size if size > 0.0 else 0.0
