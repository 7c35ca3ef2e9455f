"""How far a long command is: lines in a log, and the time that a study takes before it begins.

Expected: by hand, of clocks that the tests turn.
"""

import io
from typing import Any

import pytest

from wraparc.cli import bar as room
from wraparc.study import run as study_run


class Clock:
    """A clock that is turned."""

    def __init__(self) -> None:
        self.now = 1000.0

    def __call__(self) -> float:
        return self.now


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> Clock:
    found = Clock()
    monkeypatch.setattr("wraparc.cli.bar.time.monotonic", found)
    return found


def test_a_log_has_rows_and_minutes(clock: Clock, monkeypatch: pytest.MonkeyPatch) -> None:
    log = io.StringIO()
    monkeypatch.setattr("sys.stderr", log)
    with room.bar(10_000, "Solving", 3) as tell:
        tell(4_000, 10_000)  # of an earlier run
        for done in (5_000, 6_000, 7_000, 10_000):
            clock.now += 24.0
            tell(done, 10_000)
    # 48 s for 2,000 designs: 96 s for the 4,000 that are left
    assert log.getvalue() == "Solving: 18,000 of 30,000 rows, about 1.6 minutes left.\n"


def test_what_is_soon_done_writes_nothing(clock: Clock, monkeypatch: pytest.MonkeyPatch) -> None:
    log = io.StringIO()
    monkeypatch.setattr("sys.stderr", log)
    with room.bar(8, "Following", unit="designs") as tell:
        for done in range(9):
            tell(done, 8)
            clock.now += 3.0
    assert log.getvalue() == ""


class Timed:
    """A study that takes 0.3 s for every part, and so long for every design of it."""

    def __init__(self, clock: Clock, designs: int, each: float) -> None:
        self.plan, self._clock, self._each = range(designs), clock, each
        self.asked: list[tuple[int, int]] = []

    def solve(self, start: int, stop: int) -> None:
        self.asked.append((start, stop))
        self._clock.now += 0.3 + self._each * (stop - start)


@pytest.mark.parametrize(
    ("designs", "each", "expected", "solved"),
    [
        # what each part costs besides counts once
        (100_000, 1e-3, 0.3 + 100.0, 4 * (8 + 136)),
        # a slow one has the smallest sample, and all it takes is counted
        (10_000, 0.5, 10_000 * (0.3 / 8 + 0.5), 4 * 8),
        # fewer than a sample: all of them
        (20, 1e-3, 4 * 0.3 + 20e-3, 4 * 5),
        (1, 1e-3, 0.301, 1),
    ],
)
def test_time_of_a_study_is_that_of_a_sample(
    designs: int, each: float, expected: float, solved: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    clock = Clock()
    monkeypatch.setattr(study_run, "process_time", clock)
    study: Any = Timed(clock, designs, each)
    assert study_run.expected_time(study) == pytest.approx(expected)
    assert sum(stop - start for start, stop in study.asked) == solved
    assert {start for start, _ in study.asked} == {
        k * designs // 4 for k in range(4)
    } or designs < 4
