"""Signals of logs: expected are the readings, gaps and faults that were put in."""

from pathlib import Path

import numpy as np
import pytest

from learn.plant import DAY, LEARN, RATED_TORQUE, Made, readings, wide, written
from wraparc.learn.file import load_plan
from wraparc.learn.grid import on_grid
from wraparc.learn.tags import Log, read_signals

VALUES = readings(Made(days=4.0))


def signals(folder: Path, values: dict[str, np.ndarray], text: str = LEARN) -> Log:
    return read_signals(load_plan([str(written(folder, values, text))]))


def test_files_in_any_order_are_one_log(tmp_path: Path) -> None:
    whole = signals(tmp_path, VALUES)
    third = len(VALUES["time"]) // 3
    parts = [{k: v[a : a + third] for k, v in VALUES.items()} for a in (2 * third, 0, third)]
    for n, part in enumerate(parts):
        (tmp_path / f"part{n}.csv").write_text(wide(part), "utf-8")
    names = ", ".join(f'"part{n}.csv"' for n in range(3))
    (tmp_path / "learn.toml").write_text(LEARN.replace('"trend.csv"', names), "utf-8")
    again = read_signals(load_plan([str(tmp_path / "learn.toml")]))
    for role, signal in whole.signals.items():
        assert np.array_equal(signal.times, again.signals[role].times)
        assert np.array_equal(signal.values, again.signals[role].values)


def test_newest_first_is_read_backwards(tmp_path: Path) -> None:
    whole = signals(tmp_path, VALUES)
    back = signals(tmp_path, {k: v[::-1] for k, v in VALUES.items()})
    assert np.array_equal(whole.signals["belt_speed"].values, back.signals["belt_speed"].values)


@pytest.mark.parametrize(
    ("head", "values", "more"),
    [
        # expected: P = T omega, T = torque share times the rated one, I by the curve
        ("M1 power [kW]", VALUES["torque"] * RATED_TORQUE * VALUES["speed"] * np.pi / 3e6, ""),
        ("M1 torque [N m]", VALUES["torque"] / 100 * RATED_TORQUE, ""),
        (
            "M1 current [A]", 100 + VALUES["torque"],
            f'current = [100, 200]\ncurrent_torque = ["0 N m", "{RATED_TORQUE:g} N m"]\n',
        ),
    ],
)  # fmt: skip
def test_torque_by_power_and_by_current(
    head: str, values: np.ndarray, more: str, tmp_path: Path
) -> None:
    path = written(tmp_path, VALUES | {"torque": values}, LEARN.replace("gear_", more + "gear_"))
    text = (tmp_path / "trend.csv").read_text("utf-8").replace("M1 torque [%]", head, 1)
    (tmp_path / "trend.csv").write_text(text, "utf-8")
    found = read_signals(load_plan([str(path)])).signals["torque.head"].values
    assert found == pytest.approx(VALUES["torque"] / 100, abs=2e-3)


def test_an_hour_lived_twice_is_left_out(tmp_path: Path) -> None:
    # the clock goes back by an hour after two days
    t = VALUES["time"]
    log = signals(tmp_path, VALUES | {"time": np.where(t >= 2.0 * DAY, t - 3600.0, t)})
    (span,) = log.signals["belt_speed"].put_back
    start = np.datetime64("2026-03-01").astype("datetime64[s]").astype(float)
    assert span == (start + 2.0 * DAY - 3600.0, start + 2.0 * DAY - 30.0)
    grid = on_grid(log, "")
    there = np.isfinite(grid.values["belt_speed"])
    hours = grid.time / 3600.0
    assert not there[(hours >= 47.0) & (hours < 48.0)].any()
    assert there[hours < 46.9].all()
    assert there[(hours > 48.1) & (hours < 94.0)].all()
    assert {s.why for s in grid.left_out} == {"clock put back"}


def test_gaps_and_frozen_values_are_left_out(tmp_path: Path) -> None:
    hours = VALUES["time"] / 3600.0
    belt = np.where((hours >= 20.0) & (hours < 22.0), 3.0, VALUES["belt"])
    kept = ~((hours >= 30.0) & (hours < 31.0))
    grid = on_grid(
        signals(tmp_path, {k: v[kept] for k, v in (VALUES | {"belt": belt}).items()}), ""
    )
    at = grid.time / 3600.0
    assert np.isnan(grid.values["belt_speed"][(at > 20.1) & (at < 21.9)]).all()
    assert np.isfinite(grid.values["torque.head"][(at > 20.1) & (at < 21.9)]).all()
    assert np.isnan(grid.values["torque.head"][(at > 30.1) & (at < 30.9)]).all()
    assert {s.why for s in grid.left_out} == {"gap", "frozen"}
    assert grid.share_left_out == pytest.approx(3.0 / 96.0, abs=0.003)


def test_a_reading_of_nothing_holds_until_the_next(tmp_path: Path) -> None:
    text = wide(VALUES).splitlines()
    text[1001] = ",".join([*text[1001].split(",")[:2], "Bad", text[1001].split(",")[3]])
    path = written(tmp_path, VALUES)
    (tmp_path / "trend.csv").write_text("\n".join(text), "utf-8")
    grid = on_grid(read_signals(load_plan([str(path)])), "")
    gone = np.flatnonzero(np.isnan(grid.values["torque.head"]))
    assert gone.tolist() == [3000, 3001, 3002]  # the thousandth reading, 30 s of it


def test_what_is_stored_by_exception_holds(tmp_path: Path) -> None:
    """A dead band of 0.1 % of the belt speed and 1 % of torque, a row a reading."""
    rows = ["Tag,Time,Value,Unit"]
    from learn.plant import clock

    stamps = clock(VALUES["time"])
    for name, key, unit, band in (
        ("M1 speed", "speed", "rpm", 0.5), ("M1 torque", "torque", "%", 1.0),
        ("Belt speed", "belt", "m/s", 0.003),
    ):  # fmt: skip
        last = np.inf
        for stamp, value in zip(stamps, VALUES[key].tolist(), strict=True):
            if abs(value - last) >= band:
                rows.append(f"{name},{stamp},{value},{unit}")
                last = value
    path = written(tmp_path, VALUES)
    (tmp_path / "trend.csv").write_text("\n".join(rows), "utf-8")
    grid = on_grid(read_signals(load_plan([str(path)])), "")
    held = np.interp(grid.time, VALUES["time"], VALUES["belt"])
    there = np.isfinite(grid.values["belt_speed"])
    assert there.mean() > 0.97
    assert np.abs(grid.values["belt_speed"] - held)[there].max() < 0.02
