"""A conveyor of flights in a drive file: drives, trains, tables, JSON, the picture, refusals."""

import json
from pathlib import Path

import numpy as np
import pytest

from wraparc import InputError, load_train, solve_train
from wraparc.answer.conveyor_table import conveyor_data, conveyor_tables
from wraparc.answer.sheet import shown
from wraparc.answer.sources import Sources
from wraparc.cli import run
from wraparc.files import drive_from_text, drive_text
from wraparc.plot import plot_conveyor
from wraparc.train.file import train_from_text

EXAMPLE = Path(__file__).parents[2] / "examples" / "overland-head-tail.toml"
TEXT = EXAMPLE.read_text("utf-8")
ONE = """
format = 1
[belt]
preset = "Plylon Plus 1000/4"
width = "1200 mm"
speed = "3 m/s"
[conveyor]
capacity = "800 t/h"
belt_mass = "22 kg/m"
carry_idler_mass = "16 kg/m"
return_idler_mass = "6 kg/m"
take_up_tension = "50 kN"
start_time = "25 s"
[[conveyor.flight]]
name = "level"
length = "400 m"
[[conveyor.flight]]
name = "ramp"
length = "200 m"
slope = "8 %"
[[conveyor.load_case]]
name = "start on the ramp"
loaded = ["ramp"]
kind = "starting"
[[pulley]]
name = "head"
diameter = "1000 mm"
wrap_angle = "200 deg"
lagging = "full-ceramic"
"""


def test_one_drive_of_flights_has_their_load_cases() -> None:
    drive = drive_from_text(ONE)
    kinds = {case.name: case.kind for case in drive.load_cases}
    assert kinds == {
        "full": "running", "empty": "running", "start": "starting",
        "start on the ramp": "starting",
    }  # fmt: skip
    assert drive.conveyor is not None
    assert drive.conveyor.lift == pytest.approx(200.0 * 0.08 / (1 + 0.08**2) ** 0.5)


def test_it_is_written_as_it_was_read() -> None:
    drive = drive_from_text(ONE)
    again = drive_from_text(drive_text(drive))
    assert again == drive
    assert again.conveyor == drive.conveyor


def test_the_train_has_the_tensions_of_the_states() -> None:
    train = train_from_text(TEXT)
    assert train.conveyor is not None
    result = solve_train(train)
    for state, case in zip(train.conveyor.states(), result, strict=True):
        assert state.name == case.case.name
        for drive, member in zip(state.drives, case.members, strict=True):
            assert member.arc.entry_tension == pytest.approx(drive.entry, rel=1e-9)
            assert member.arc.exit_tension == pytest.approx(drive.exit, rel=1e-9)
    assert train.criteria.take_up.after == "head"
    stop = result["stop"]
    assert [round(m.share, 9) for m in stop.members] == [0.0, 1.0]


def test_speeds_divide_it_where_the_take_up_is_outside_of_the_drives() -> None:
    """As the drives were found to share, to what bending of the belt makes of other tensions.

    The runs of a train are those of equal shares; bending and bearings are 1 % of them.
    """
    speeds = TEXT.replace('share = ["75 %", "25 %"]', 'speeds = "equal"').replace(
        "brake_share", "# brake_share"
    )
    with pytest.raises(InputError, match="is between the drives, behind head"):
        train_from_text(speeds)
    outside = speeds.replace('take_up_tension = "70 kN"', 'take_up_tension = "75 kN"').replace(
        "[train]", '[take_up]\nafter = "tail"\n[train]'
    )
    train = train_from_text(outside)
    result = solve_train(train, raise_on_failure=False)
    data = conveyor_data(train, result)
    assert data is not None
    full = data["load_cases"][0]
    assert [d["share"] for d in full["drives"]] == pytest.approx(result["full"].shares)
    for drive, member in zip(full["drives"], result["full"].members, strict=True):
        assert drive["entry_tension"] == pytest.approx(member.arc.entry_tension, rel=1e-3)


def test_the_tables_are_those_of_the_states() -> None:
    train = load_train(EXAMPLE)
    assert train.conveyor is not None
    tables = {table.name: shown(table, "si") for table in conveyor_tables(train, Sources())}
    assert list(tables) == [
        "conveyor", "tensions", "flights", "sag", "curves", "take-up", "standstill",
    ]  # fmt: skip
    full = train.conveyor.states()[0]
    row = next(r for r in tables["conveyor"].rows if r.title == "Effective tension")
    assert float(row.values[0]) == pytest.approx(full.pull / 1e3, rel=5e-3)
    short = tables["conveyor"].short
    assert short is not None
    assert short.note == "Take-up tension 70 kN, counterweight 14280 kg."
    assert [r.title for r in short.rows] == [s.name for s in train.conveyor.states()]


def test_the_json_has_every_point(tmp_path: Path) -> None:
    (tmp_path / "c.toml").write_text(TEXT, "utf-8")
    path = tmp_path / "out.json"
    assert run(["solve", str(tmp_path / "c.toml"), "--no-reserve", "--json", str(path)]) == 0
    data = json.loads(path.read_text("utf-8"))["conveyor"]
    train = train_from_text(TEXT)
    assert train.conveyor is not None
    for case, state in zip(data["load_cases"], train.conveyor.states(), strict=True):
        assert [p["tension_after"] for p in case["points"]] == pytest.approx(
            [p.after for p in state.points]
        )
    assert data["take_up_travel"]["splice"] == 3.0


def test_the_picture_has_both_strands() -> None:
    train = load_train(EXAMPLE)
    assert train.conveyor is not None
    full = train.conveyor.states()[0]
    tension = plot_conveyor(train).figure.axes[1]
    drawn = [line for line in tension.get_lines() if line.get_color() == "#0072b2"]
    both = [float(np.max(np.asarray(line.get_ydata(), float))) for line in drawn[:2]]
    ends = [(min(p.before, p.after), max(p.before, p.after)) for p in full.points]
    most = 1e3 * max(both)
    assert most == pytest.approx(max(high for _, high in ends))
    with pytest.raises(InputError, match=r"no \[conveyor\] that gives its tensions"):
        plot_conveyor(load_train(EXAMPLE.with_name("tandem-fabric.toml")))


def test_a_file_is_refused_with_everything_at_once() -> None:
    swaps = (
        ('slope = "-3 %"', 'slope = "-3 %"\nlift = "5 m"'),
        ('factor.ramp = "125 %"', "loaded = []"),
        ('[[conveyor.flight]]             # from', 'length = "2000 m"\n[[conveyor.flight]]  #'),
        ('pulley = "tail"\nat = "tail"', 'pulley = "tail"\nat = "carry"\nposition = "9 km"'),
        ("[train]\n", '[take_up]\nafter = "head"\n[train]\n'),
        ('take_up_tension = "70 kN"', 'take_up_tension = "70 kN"\ntake_up_distance = "30 m"'),
    )  # fmt: skip
    text = TEXT
    for old, new in swaps:
        assert text.count(old) == 1, old
        text = text.replace(old, new)
    with pytest.raises(InputError) as caught:
        train_from_text(text, file="c.toml")
    found = [str(problem).removeprefix("c.toml: conveyor.") for problem in caught.value.problems]
    for start in (
        "length: the flights make 2200 m, got",
        "flight[2].slope: contradicts lift 5000 mm, it makes -17.99 m",
        "load_case[1].loaded: loads no flight",
        "drive[2].position: is on no flight",
        "take_up_distance: is a second take-up",
    ):
        assert [s for s in found if s.startswith(start)], "\n".join((start, *found))
