"""A run that was broken off goes on bit for bit, and a long one needs no more memory."""

import gc
import tracemalloc
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest

from cli.running import wraparc
from motion.stations import moving
from wraparc import InputError
from wraparc.motion import (
    CoupledMotor,
    Droop,
    Event,
    Follower,
    OnDrum,
    RunResult,
    SpeedLoop,
    Start,
    Station,
    Stop,
    simulate,
)
from wraparc.motion.checkpoint import Checkpoint
from wraparc.motion.result import Outcome

START = Event(duration=4.0, happenings=(Start(time=2.0), Stop(at=2.5, time=1.0)))
WAVE = Event(duration=3.0, happenings=(OnDrum(pulley="first", run_out=1e-3),))
FOLLOWER = Follower(master="first", damping=0.05, dead_time=0.2)
COUPLED = CoupledMotor(pump_inertia=900.0)
FILE = "examples/tandem-fabric.toml"


class KilledError(Exception):
    """A process that dies."""


def same(a: RunResult, b: RunResult) -> bool:
    pairs = [(a.time, b.time), (a.belt_speed, b.belt_speed), (a.picture_time, b.picture_time)]
    for d, e in zip(a, b, strict=True):
        pairs += [
            (getattr(d, key), getattr(e, key))
            for key in ("entry_tension", "exit_tension", "torque", "exit_creep", "creep", "shear")
        ]
        assert (d.friction_energy, d.drum_work) == (e.friction_energy, e.drum_work)
    return all(np.array_equal(x, y, equal_nan=True) for x, y in pairs) and a.steps == b.steps


@pytest.mark.parametrize(
    ("station", "event"),
    [
        (moving("fabric", Droop(lag=0.02), FOLLOWER), START),
        (moving("steel-cord", SpeedLoop(bandwidth=2.0, reset=1.0), COUPLED), WAVE),
    ],
    ids=["start and stop", "run-out"],
)  # fmt: skip
def test_a_killed_run_goes_on_bit_for_bit(tmp_path: Path, station: Station, event: Event) -> None:
    path = tmp_path / "run.npz"
    whole: list[Sequence[float]] = []
    expected = simulate(station, event, points=20, every=0.1, sink=whole.append)
    rows: list[Sequence[float]] = []

    def dies(row: Sequence[float]) -> None:
        rows.append(row)
        if len(rows) == 22:
            raise KilledError

    with pytest.raises(KilledError):
        simulate(
            station, event, points=20, every=0.1, sink=dies,
            checkpoint=Checkpoint(path, seldom=0.0),
        )  # fmt: skip
    assert path.exists()

    def resumed(before: int) -> None:
        assert 1 < before < 22
        del rows[before:]

    result = simulate(
        station, event, points=20, every=0.1, sink=rows.append,
        checkpoint=Checkpoint(path, resumed, seldom=0.0),
    )  # fmt: skip
    assert same(result, expected)
    assert rows == whole
    assert not path.exists()


def test_a_state_of_another_run_is_refused(tmp_path: Path) -> None:
    path, station = tmp_path / "run.npz", moving("fabric", Droop(), Droop())
    cancelled = simulate(
        station, Event(duration=5.0), points=20, progress=lambda part: True,
        checkpoint=Checkpoint(path),
    )  # fmt: skip
    assert cancelled.outcome is Outcome.CANCELLED
    with pytest.raises(InputError, match="the state of another run"):
        simulate(station, Event(duration=6.0), points=20, checkpoint=Checkpoint(path))
    path.write_bytes(b"no")
    with pytest.raises(InputError, match="no saved state of a run"):
        simulate(station, Event(duration=5.0), points=20, checkpoint=Checkpoint(path))


def test_memory_does_not_grow_with_the_event() -> None:
    """Ten times as long: the same memory, once as many rows are kept as ever are."""
    station, most = moving("fabric", Droop(), Droop()), []
    simulate(station, Event(duration=1.0), points=10)  # loads what is loaded once
    for duration in (2.0, 20.0):  # with as many rows and pictures each
        event = Event(duration=duration)
        gc.collect()
        tracemalloc.start()
        simulate(station, event, points=10, step=0.05, every=duration / 20, sink=lambda row: None)
        most.append(tracemalloc.get_traced_memory()[1])
        tracemalloc.stop()
    # when what is not used any more is collected moves it by some per cent; one array of ten
    # numbers kept by each of the 360 more steps would be a quarter
    assert most[1] < 1.2 * most[0]


def test_the_command_goes_on_where_it_was(tmp_path: Path) -> None:
    state, table = tmp_path / "run.npz", tmp_path / "rows.csv"
    command = ["run", FILE, "--quiet", "--points", "10", "--every", "0.1 s", "--csv", str(table),
               "--checkpoint", str(state), "--set", "motion.event.start.duration=2 s"]  # fmt: skip
    done = wraparc(*command)
    assert done.code == 0, done.err
    first = table.read_text("utf-8")
    assert not state.exists()
    assert sorted(p.name for p in tmp_path.iterdir()) == ["rows.csv"]
    bad = wraparc("run", FILE, "--quiet", "--parquet", str(tmp_path / "a.parquet"),
                  "--checkpoint", str(state))  # fmt: skip
    assert bad.code == 2
    assert "--checkpoint: a run resumed later writes its rows to a CSV file" in bad.err
    assert bad.err.endswith("Give --csv FILE.\n")
    assert len(first.splitlines()) == pytest.approx(22, abs=1)
