"""Speeds of the tests: those of different speeds are no repeats of each other."""

from collections.abc import Sequence

import numpy as np

from wraparc.arrays import Integers
from wraparc.shear_test.analysis import TestResult
from wraparc.shear_test.misfit import Misfit
from wraparc.shear_test.pressure_fit import CurvePoints
from wraparc.shear_test.record import MachineRecord
from wraparc.units import in_each

# Speeds that differ by a larger factor are different ones. Ours.
_APART = 1.5
_BLOCKS = 20
# Differences of friction below this, or below twice their standard error, are none. Ours.
_LEAST = 0.02
_OWN = "Give each speed a condition of its own."


def measured_speed(record: MachineRecord) -> float | None:
    """Speed of the crosshead from time and travel [m/s]: the median of 20 stretches."""
    if record.time is None or len(record.time) <= _BLOCKS:
        return None
    ends = np.linspace(0, len(record.time) - 1, _BLOCKS + 1).astype(int)
    way, time = np.abs(np.diff(record.travel[ends])), np.diff(record.time[ends])
    good = np.isfinite(way) & np.isfinite(time) & (time > 0.0)
    speed = float(np.median(way[good] / time[good])) if good.any() else 0.0
    return speed if speed > 0.0 else None


def speed_groups(tests: Sequence[TestResult]) -> tuple[Integers, list[float]]:
    """Number of the speed of each test, slowest first, and the speeds [m/s].

    Taken from the plan, else from time and travel; tests of unknown speed are one group.
    """
    said = [test.test.speed or measured_speed(test.record) for test in tests]
    groups = np.zeros(len(tests), dtype=np.int64)
    speeds: list[float] = []
    for k in sorted((k for k, v in enumerate(said) if v is not None), key=lambda k: said[k] or 0.0):
        speed = said[k] or 0.0
        if not speeds or speed > _APART * speeds[-1]:
            speeds.append(speed)
        groups[k] = len(speeds) - 1
    return groups, speeds


def by_speed(points: CurvePoints, groups: Integers) -> CurvePoints:
    """Points whose repeats are those of one pressure and one speed."""
    both = points.level * (int(groups.max()) + 1) + groups
    _, level = np.unique(both, return_inverse=True)
    return CurvePoints(points.pressure, points.value, points.covariance, level.astype(np.int64))


def speed_sentences(
    tests: Sequence[TestResult], points: CurvePoints, *, told: bool = False
) -> tuple[list[str], list[str]]:
    """Sentences on speeds against the law, and remarks on them.

    Parameters
    ----------
    tests, points
        Tests of one condition, and their curves as points.
    told
        Whether what speed does was taken off the curves, and said.
    """
    misfit: list[str] = [
        Misfit(
            f"{test.name}: the plan says {per_minute(test.test.speed)}, time and travel of the "
            f"file say {per_minute(measured)}",
            f"the plan says {per_minute(test.test.speed)}, the files {per_minute(measured)}",
            "Correct the speed in the plan, or the unit of the time.",
        )
        for test in tests
        if test.test.speed and (measured := measured_speed(test.record))
        if not 1.0 / _APART < measured / test.test.speed < _APART
    ]
    groups, speeds = speed_groups(tests)
    if len(speeds) < 2 or told:
        return misfit, []
    text = f"tests at {', '.join(per_minute(speed) for speed in speeds)} share one law"
    slow, fast = groups == 0, groups == groups.max()
    differences = []
    for level in np.unique(points.level):
        here = points.level == level
        if (here & slow).any() and (here & fast).any():
            ends = [points.value[here & group, 1].mean() for group in (fast, slow)]
            differences.append(ends[0] - ends[1])
    advice = "give each speed a condition of its own"
    if not differences:
        text += (
            f", and no pressure was tested at both ends, so what speed does is not known: {advice}"
        )
        head = f"tests at {len(speeds)} speeds share one law"
        return [*misfit, Misfit(text, head, _OWN)], []
    mean = float(np.mean(differences))
    error = float(np.std(differences)) / np.sqrt(max(len(differences) - 1, 1))
    text += (
        f": at {per_minute(speeds[-1])} friction differs by {100 * np.expm1(mean):+.0f} % from "
        f"that at {per_minute(speeds[0])}; they were not taken as repeats of each other"
    )
    if abs(mean) > max(_LEAST, 2.0 * error):
        head = f"friction differs by {100 * np.expm1(mean):+.0f} % between the speeds of the tests"
        return [*misfit, Misfit(f"{text}; {advice}", head, _OWN)], []
    return misfit, [text]


def per_minute(speed: float | None) -> str:
    """A speed [m/s] in words."""
    return in_each(speed or 0.0, "speed", "mm/min", "in/min")
