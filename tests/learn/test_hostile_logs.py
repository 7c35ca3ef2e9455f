"""Logs as exports make them go wrong: expected are the readings, or what is refused and why.

Where a log is read, its signals must be those of the log without the fault.
"""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from cli.running import wraparc
from learn.plant import DAY, LEARN, RATED_TORQUE, Array, Made, clock, readings, wide, written
from wraparc import InputError
from wraparc.learn.file import load_plan
from wraparc.learn.grid import Grid, on_grid
from wraparc.learn.learn import learn
from wraparc.learn.tags import Log, read_signals

VALUES = readings(Made(days=5.0))
T, HALF = VALUES["time"], 2.5 * DAY
ROLES = {"speed.head": "speed", "torque.head": "torque", "belt_speed": "belt"}


def part(which: Array, **other: Array) -> dict[str, Array]:
    return {key: x[which] for key, x in (VALUES | other).items()}


def put(folder: Path, files: dict[str, str], text: str = LEARN, names: str = "") -> Path:
    for name, content in files.items():
        (folder / name).write_text(content, "utf-8")
    listed = names or ", ".join(f'"{name}"' for name in files)
    (folder / "learn.toml").write_text(text.replace('"trend.csv"', listed), "utf-8")
    return folder / "learn.toml"


def log_of(path: Path) -> Log:
    return read_signals(load_plan([str(path)]))


def whole(folder: Path) -> Log:
    (folder / "whole").mkdir()
    return log_of(written(folder / "whole", VALUES))


def same(a: Log, b: Log, digits: float = 1e-9) -> bool:
    """Whether two logs have the same readings, and none as lived twice."""
    return all(
        np.array_equal(a.signals[role].times, b.signals[role].times)
        and np.allclose(a.signals[role].values, b.signals[role].values, rtol=digits)
        and not b.signals[role].put_back
        for role in ROLES
    )


def test_files_that_overlap_have_what_both_say_once(tmp_path: Path) -> None:
    files = {"a.csv": wide(part(T < 1.2 * HALF)), "b.csv": wide(part(T >= 0.8 * HALF))}
    assert same(whole(tmp_path), log_of(put(tmp_path, files)))


def test_a_file_that_is_named_twice_is_one(tmp_path: Path) -> None:
    path = put(tmp_path, {"a.csv": wide(VALUES)}, names='"a.csv", "a.csv"')
    assert same(whole(tmp_path), log_of(path))


def test_readings_between_those_of_another_file_are_joined(tmp_path: Path) -> None:
    even = np.arange(len(T)) % 2 == 0
    path = put(tmp_path, {"a.csv": wide(part(even)), "b.csv": wide(part(~even))})
    assert same(whole(tmp_path), log_of(path))


def test_files_that_contradict_each_other_are_refused(tmp_path: Path) -> None:
    other = part(T >= 0.5 * HALF, belt=np.round(VALUES["belt"] * 1.02, 4))
    ran = wraparc("learn", put(tmp_path, {"a.csv": wide(part(T < HALF)), "b.csv": wide(other)}))
    assert ran.code == 2
    assert "b.csv: Belt speed: differs from" in ran.err
    at = int(np.flatnonzero(T >= 0.5 * HALF)[0])
    was, now = VALUES["belt"][at], np.round(VALUES["belt"][at] * 1.02, 4)
    assert f"at the same times, got {was:.5g} and {now:.5g} at {clock(T)[at][:16]}." in ran.err
    assert "Leave one of the two files out." in ran.err


def test_a_tag_in_feet_a_minute_in_one_file_is_the_same(tmp_path: Path) -> None:
    feet = part(T >= HALF, belt=np.round(VALUES["belt"] / 0.00508, 3))
    files = {
        "a.csv": wide(part(T < HALF)),
        "b.csv": wide(feet).replace("[m/s]", "[ft/min]", 1),
    }
    assert same(whole(tmp_path), log_of(put(tmp_path, files)), 1e-5)


def test_a_tag_in_two_units_in_one_long_file_is_the_same(tmp_path: Path) -> None:
    rows = ["Tag,Time,Value,Unit"]
    stamps = clock(T)
    for k in range(len(T)):
        is_late, belt = T[k] >= HALF, VALUES["belt"][k]
        value, unit = (60.0 * belt, "m/min") if is_late else (belt, "m/s")
        rows.append(f"Belt speed,{stamps[k]},{value:.6g},{unit}")
        rows.append(f"M1 speed,{stamps[k]},{VALUES['speed'][k]},rpm")
        rows.append(f"M1 torque,{stamps[k]},{VALUES['torque'][k]},%")
    path = put(tmp_path, {"a.csv": "\n".join(rows)})
    assert same(whole(tmp_path), log_of(path), 1e-5)


def test_per_cent_in_one_file_and_newton_metres_in_another_are_refused(tmp_path: Path) -> None:
    other = part(T >= HALF, torque=np.round(VALUES["torque"] / 1e5 * RATED_TORQUE, 5))
    text = wide(other).replace("[%]", "[kN m]", 1)
    ran = wraparc("learn", put(tmp_path, {"a.csv": wide(part(T < HALF)), "b.csv": text}))
    assert ran.code == 2
    assert 'b.csv: M1 torque: another file has it in "%", got "kN m".' in ran.err
    assert "Export it in one unit." in ran.err


def test_a_daily_file_a_tag_is_one_log(tmp_path: Path) -> None:
    """Heads say `Value`: the tag is named by the file, whose date is none of the name."""
    files = {}
    for tag, key in (("M1_speed", "speed"), ("M1 torque", "torque"), ("Belt speed", "belt")):
        for day in range(5):
            own = np.floor(T / DAY) == day
            rows = zip(clock(T[own]), VALUES[key][own], strict=True)
            text = "Time;Value\n" + "".join(f"{t};{v}\n".replace(".", ",") for t, v in rows)
            files[f"{tag}_2026-03-0{day + 1}.csv"] = text
    text = LEARN.replace('name = "head"', 'name = "head"\nspeed_unit = "rpm"\ntorque_unit = "%"')
    text = text.replace('at = "tail"', 'unit = "m/s"\nat = "tail"')
    names = '"M1*.csv", "Belt speed_2026-03-??.csv"'
    assert same(whole(tmp_path), log_of(put(tmp_path, files, text, names)))


@pytest.mark.parametrize("years", [-56, 10])
def test_a_reading_of_a_wrong_year_is_none(years: int, tmp_path: Path) -> None:
    """The clock of one row is years away; the signals are those without it."""
    there = np.arange(len(T)) != 5000
    expected = log_of(written(tmp_path, part(there)))
    wrong = np.where(there, T, 365.0 * DAY * years)
    assert same(expected, log_of(written(tmp_path, VALUES | {"time": wrong})))


def test_a_clock_put_forward_is_a_gap(tmp_path: Path) -> None:
    grid = grid_of(tmp_path, VALUES | {"time": np.where(T >= HALF, T + 3.0 * 3600.0, T)})
    hours = grid.time / 3600.0
    inside = (hours > 60.1) & (hours < 62.9)
    assert np.isnan(grid.values["belt_speed"][inside]).all()
    assert np.isfinite(grid.values["belt_speed"][(hours < 60.0) | (hours > 63.0)]).all()
    assert {span.why for span in grid.left_out} == {"gap"}


def grid_of(folder: Path, values: dict[str, Array]) -> Grid:
    return on_grid(log_of(written(folder, values)), "")


@pytest.mark.parametrize("value", [-9999.0, 99.0])
def test_a_mark_of_no_value_is_no_belt_speed(value: float, tmp_path: Path) -> None:
    """Every hundredth reading is a mark: windows with it are not steady, the others are used."""
    marked = np.where(np.arange(len(T)) % 100 == 50, value, VALUES["belt"])
    found = learn(load_plan([str(written(tmp_path, VALUES | {"belt": marked}))]))
    (pulley,) = found.pulleys
    assert pulley.zero.low < 0.01 < pulley.zero.high
    assert found.windows.difference.min() > -0.05
    assert found.windows.difference.max() < 0.05


REFUSED: dict[str, tuple[Callable[[dict[str, Array]], dict[str, Array]], str, str]] = {
    **{
        f"constant {key}": (
            lambda v, key=key: v | {key: np.full(len(T), v[key][9])},  # type: ignore[misc]
            f"{tag}: never changes.", "Export what is measured, with its decimals.",
        )
        for key, tag in (("speed", "M1 speed"), ("torque", "M1 torque"), ("belt", "Belt speed"))
    },
    "nothing": (
        lambda v: v | {"torque": np.zeros(len(T))},
        "M1 torque: never changes.", "Export what is measured, with its decimals.",
    ),
    "negative torque": (
        lambda v: v | {"torque": -v["torque"]},
        "M1 torque: is negative while the drive runs.",
        "Export it positive for the driving direction.",
    ),
    "parts of one": (
        lambda v: v | {"torque": np.round(v["torque"] / 100.0, 4)},
        "M1 torque: its highest readings are those of no drive, got 0.9",
        "Check its unit and rated_torque.",
    ),
    "a reading an hour": (
        lambda v: {key: x[::120] for key, x in v.items()},
        "frozen or missing for too long, got 100 % of running.",
        "Log it every minute, with its decimals.",
    ),
    "eleven years": (
        lambda v: v | {"time": np.where(T >= HALF, T + 4000.0 * DAY, T)},
        "files: log too long, got 4005 days.", "Export at most 1500 days.",
    ),
}  # fmt: skip


@pytest.mark.parametrize("case", REFUSED)
def test_what_says_nothing_is_refused_by_its_tag(case: str, tmp_path: Path) -> None:
    change, words, remedy = REFUSED[case]
    path = written(tmp_path, change(VALUES))
    with pytest.raises(InputError) as caught:
        learn(load_plan([str(path)]))
    assert remedy in caught.value.problems[0].remedy
    ran = wraparc("learn", path)
    assert (ran.code, ran.out) == (2, "")
    assert words in ran.err
    assert len(ran.err.removeprefix("Error: ").split()) <= 24  # 20 and the path of the file
