"""What is learned of a plant whose truth is known: expected is what the plant was made from."""

import json
import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from cli.running import wraparc
from learn.plant import DAY, DRIVE, GEAR, LEARN, RATED_TORQUE, Made, readings, wide, written
from render.reading import metadata, structure
from wraparc import InputError, load_drive
from wraparc.answer.learn_sheet import learn_sheet
from wraparc.checks import Level
from wraparc.learn.errors import LogErrors
from wraparc.learn.file import load_plan
from wraparc.learn.learn import Learned, learn
from wraparc.learn.write import learned_levels, learned_text
from wraparc.schema.overrides import read_document
from wraparc.units import in_units

WET = (6.3 * DAY, 6.6 * DAY)


def rained(t: np.ndarray) -> np.ndarray:
    """Friction that falls by 1.2 % a day, and by a third in a shower."""
    wet = (t > WET[0]) & (t < WET[1])
    return np.exp(-0.012 * t / DAY) * np.where(wet, 0.67, 1.0)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("plant")
    written(folder, readings(Made(days=14.0, friction=rained)))
    return folder


@pytest.fixture(scope="module")
def learned(folder: Path) -> Learned:
    return learn(load_plan([str(folder / "learn.toml")]))


def test_zero_and_friction_are_those_of_the_plant(learned: Learned) -> None:
    (pulley,) = learned.pulleys
    assert pulley.zero.low < 0.01 < pulley.zero.high
    assert pulley.zero.high - pulley.zero.low < 0.003
    assert pulley.friction is not None
    assert pulley.friction.low < math.exp(-0.012 * 14) < pulley.friction.high
    assert pulley.friction_change is not None
    assert pulley.friction_change.low < math.exp(-0.012 * 14) < pulley.friction_change.high
    assert pulley.friction_change.high < 1.0
    assert learned.cuts == ()
    assert learned.moved == {}


def test_the_shower_is_found_and_nothing_else(learned: Learned) -> None:
    (episode,) = learned.episodes.found
    assert WET[0] - 900.0 <= episode.start <= WET[0] + 3600.0
    assert WET[1] - 3600.0 <= episode.stop <= WET[1] + 900.0
    assert WET[0] < episode.alarmed < WET[0] + 2.0 * 3600.0
    assert episode.change == pytest.approx(-0.33, abs=0.08)


def test_the_alarm_line_is_between_normal_and_slipping_through(learned: Learned) -> None:
    (pulley,) = learned.pulleys
    line = pulley.line
    assert np.all(line.normal < line.alarm)
    assert np.all(line.alarm <= line.trip)
    assert line.at(0.8) < 0.20  # the usual switch trips later
    # by the mirror image of the noise, which is Gaussian here: none in a year
    assert line.false_alarms[1] < 1.0


def test_the_reserve_is_that_of_the_solver(learned: Learned) -> None:
    """Expected: of the plant's own friction, at which the solver lets the belt run 5 % ahead."""
    from learn.plant import _creep

    (pulley,) = learned.pulleys
    assert pulley.reserve is not None
    top = 70e3 * 1.02
    at_slip = next(
        f
        for f in np.arange(0.0, -2.5, -0.01).tolist()
        if np.interp(top, *_creep(round(f, 2))) > 0.05
    )
    truth = math.exp(-0.012 * 14 - at_slip)
    assert pulley.reserve.low < truth < pulley.reserve.high


def test_first_screen_json_and_learned_drive(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(folder)
    ran = wraparc(
        "learn", "learn.toml", "-o", "learned.toml", "--json", "a.json", "--plot", "a.svg",
        "--report", "a.pdf",
    )  # fmt: skip
    assert ran.code == 0, ran.err
    assert ran.out.startswith("Overland CV-07, 14 days, ")
    assert "\nATTENTION  Friction fell 1" in ran.out
    assert "\nAction     Plan relagging; set the alarm line (--table alarm).\n" in ran.out
    assert "Wet or dirty: friction down to -3" in wraparc("learn", "learn.toml", "--full").words
    answer = json.loads(Path("a.json").read_text("utf-8"))
    assert answer["period"] == ["2026-03-01T00:00:00", "2026-03-14T23:59:30"]
    assert answer["columns"]["torque.head"] == "M1 torque"
    assert set(answer["errors"]) == {"stated", "assumed", "moved"}
    assert answer["pulleys"][0]["zero"][0]["value"] == pytest.approx(0.01, abs=0.001)
    before, after = load_drive(DRIVE), load_drive("learned.toml")
    share = after.pulleys[0].lagging.law.friction([5e-3], [2e5])[0]
    share /= before.pulleys[0].lagging.law.friction([5e-3], [2e5])[0]
    assert share == pytest.approx(answer["pulleys"][0]["friction"]["value"], abs=1e-4)
    factor = after.pulleys[0].lagging.condition_factors["wet"]
    assert factor.factor == pytest.approx(0.67, abs=0.08)
    (levels,) = learned_levels(read_document("learned.toml"))
    shown = wraparc("field", "learned.toml")
    assert shown.code == 0
    assert f"Levels learned from logs to {levels.until}, by torque, head" in shown.out
    assert Path("a.svg").stat().st_size > 10_000
    made = Path("a.pdf").read_bytes()
    assert "Overland CV-07, 14 days" in metadata(made)
    assert len(structure(made, "Figure")) == 2


def test_a_learned_drive_states_how_uncertain_it_is(learned: Learned, tmp_path: Path) -> None:
    """Friction by its interval; 1.96 of each standard deviation that the learn file states."""
    (own,) = learned.pulleys
    assert own.friction is not None
    off = max(own.friction.high / own.friction.value, own.friction.value / own.friction.low) - 1.0
    stated = {"belt_modulus": 0.08, "exit_tension": 0.03, "peak_slip": 0.1, "torque_gain": 0.02}
    path, drive = tmp_path / "learned.toml", learned.plan.drive
    for errors in ({}, stated):
        plan = replace(learned.plan, errors=LogErrors(errors))
        path.write_text(learned_text(replace(learned, plan=plan)), "utf-8")
        made = load_drive(path)
        (pulley,) = made.pulleys
        assert pulley.lagging.uncertainty["friction"] == pytest.approx(off, rel=0.2)
        assert made.states_uncertainty
        assert pulley.lagging.uncertainty.get("slip") == (0.196 if errors else None)
        assert made.belt.uncertainty == ({"modulus": 0.157} if errors else {})
        assert pulley.uncertainty == ({"exit_tension": 0.0588} if errors else {})
    assert replace(made.belt, uncertainty={}) == drive.belt


def test_a_log_and_a_drive_file_alone(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(folder)
    asked = wraparc("learn", "trend.csv", DRIVE)
    assert asked.code == 2
    assert (
        "gear_ratio: missing. Write gear_ratio = ? of its name plate; speeds suggest 20"
        in asked.err
    )
    assert 'rated_torque: missing: "M1 torque" is in per cent of it.' in asked.err
    ran = wraparc(
        "learn", "trend.csv", DRIVE, "--set", f"pulley.head.gear_ratio={GEAR:g}",
        "--set", f'pulley.head.rated_torque="{RATED_TORQUE:g} N m"',
    )  # fmt: skip
    assert ran.code == 0, ran.err
    assert ran.out.startswith("Head drive, slips in the wet season, 14 days, ")


def test_relagging_is_a_cut(tmp_path: Path) -> None:
    def grown(t: np.ndarray) -> np.ndarray:
        return np.where(t < 7.0 * DAY, 0.01, 0.0)  # 4 mm of radius more

    found = learn(load_plan([str(written(tmp_path, readings(Made(days=14.0, zero=grown))))]))
    assert [abs(cut - 7) <= 1 for cut in found.cuts] == [True]
    (pulley,) = found.pulleys
    assert pulley.zero.low < 0.0 < pulley.zero.high


def test_of_one_load_only_the_zero_is_known(tmp_path: Path) -> None:
    path = written(tmp_path, readings(Made(days=8.0, loads=(0.6, 0.65))))
    found = learn(load_plan([str(path)]))
    (pulley,) = found.pulleys
    assert (pulley.friction, pulley.friction_change, pulley.reserve) == (None, None, None)
    assert found.episodes.found == ()
    ran = wraparc("learn", path)
    assert "Torque range is below 25 % of rating: only the zero is known." in ran.words


def test_a_speed_that_no_drive_shows_is_told(tmp_path: Path) -> None:
    """A belt speed that rises with torque by 1.5 %, which no belt and no friction does."""
    values = readings(Made(days=8.0))
    values["belt"] = np.round(values["belt"] * (1.0 + 0.015 * values["torque"] / 100.0), 4)
    ran = wraparc("learn", written(tmp_path, values))
    assert ran.code == 0, ran.err
    assert "Speed scatter exceeds 5 times the usual: friction not identified" in ran.words
    assert "Friction of its law" not in ran.out


def test_an_error_of_the_log_beyond_its_statement_is_told(tmp_path: Path) -> None:
    """A belt speed that falls by 0.7 % at rated torque, where 0.04 % is assumed of an encoder.

    All that could pass for it is stated to be known well: T2, modulus, lagging, friction.
    """
    known = {
        "belt_modulus": 2, "torque_gain": 1, "peak_slip": 3, "lagging_shear": 5,
        "friction_level": 10, "exit_tension": 2,
    }  # fmt: skip
    stated = LEARN + "[errors]\n" + "".join(f'{k} = "{v} %"\n' for k, v in known.items())
    values = readings(Made(days=10.0))
    values["belt"] = np.round(values["belt"] * (1.0 - 0.007 * values["torque"] / 100.0), 4)
    path = written(tmp_path, values, stated)
    assert learn(load_plan([str(path)])).moved["speed_by_torque.head"] > 3.0
    ran = wraparc("learn", path)
    assert ran.code == 0
    assert "standard deviations off: friction not identified." in ran.words
    assert "Check motor speed, rated torque, T2, belt and lagging of the drive file." in ran.words
    assert "Friction of its law" not in ran.out


def test_another_lagging_than_in_the_file_is_what_it_cannot_know(tmp_path: Path) -> None:
    """Ceramic on the pulley, rubber in the file: the change is right, the lagging is not known."""
    fall = 0.008
    made = Made(days=14.0, lagging="full-ceramic", friction=lambda t: np.exp(-fall * t / DAY))
    path = written(tmp_path, readings(made))
    found = learn(load_plan([str(path)]))
    (pulley,) = found.pulleys
    assert found.unlike == ()  # the fit is as good
    assert "which lagging is on the pulley" in found.cannot
    assert pulley.friction_change is not None
    assert pulley.friction_change.low < math.exp(-fall * 14) < pulley.friction_change.high
    assert "Not known: which lagging is on the pulley" in wraparc("learn", path).words


def test_an_error_beyond_what_is_stated_of_it_is_told(learned: Learned) -> None:
    """The same fit, its torque gain moved by four of its standard deviations."""
    moved = replace(learned, moved={"torque_gain.head": -4.0})
    verdict = learn_sheet(moved).verdict
    assert verdict is not None
    said = in_units(verdict.text, "si")
    assert said == "Torque, gain (head) is 4.0 standard deviations off: friction not identified."
    assert verdict.level is Level.ATTENTION


def halting(v: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    """Running for two hours a day alone: steady for less than 30 h."""
    runs = v["time"] % DAY < 7200.0
    return {k: x if k == "time" else np.where(runs, x, 0.0) for k, x in v.items()}


REFUSED = {
    "computed": (
        lambda v: v | {"belt": np.round(v["speed"] * 2 * math.pi / 60 / GEAR * 0.4 * 0.99, 7)},
        "is computed from the motor speed", "Log the wheel or tachometer of the belt.",
    ),
    "gear": (
        lambda v: v | {"speed": v["speed"] * 1.3}, "more than wear or dirt",
        "Check gear ratio (",
    ),
    "zero": (
        lambda v: v | {"belt": v["belt"] * 0.93}, "more than wear or dirt", "units and diameter.",
    ),
    "steps": (
        lambda v: v | {"belt": np.round(v["belt"] / 0.02) * 0.02}, "is stored in steps",
        "Lower its dead band, or log more decimals.",
    ),
    "lines": (
        lambda v: (
            v | {"torque": np.round(np.interp(v["time"], v["time"][::40], v["torque"][::40]), 2)}
        ),
        "has straight lines between readings", "Export stored values, without interpolation.",
    ),
    "short": (
        lambda v: {key: x[:3000] for key, x in v.items()}, "log too short, got 25 h",
        "Export at least 3 days with 30 h of steady running.",
    ),
    "halting": (
        halting, "log too short, got", "Export at least 3 days with 30 h of steady running.",
    ),
}  # fmt: skip


@pytest.mark.parametrize("case", REFUSED)
def test_what_is_no_record_is_refused(case: str, tmp_path: Path) -> None:
    change, words, remedy = REFUSED[case]
    path = written(tmp_path, change(readings(Made(days=5.0))))  # type: ignore[no-untyped-call]
    with pytest.raises(InputError, match=words) as caught:
        learn(load_plan([str(path)]))
    assert remedy in caught.value.problems[0].remedy
    ran = wraparc("learn", path)
    assert (ran.code, ran.out) == (2, "")
    assert len(ran.err.removeprefix("Error: ").split()) <= 24  # 20 and the path of the file


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("M1 speed [rpm]", "M1 speed [Hz]", "is the frequency of a converter, without slip"),
        ("M1 speed [rpm]", "M1 speed", '"M1 speed" has no unit. Write speed_unit = "?"'),
        ("M1 torque [%]", "M1 current [A]", "no tag is named as the torque"),
        ("Belt speed [m/s]", "Tacho [m/s]", "no tag is named as the belt speed"),
    ],
)
def test_what_is_not_known_is_asked_for(old: str, new: str, words: str, tmp_path: Path) -> None:
    text = wide(readings(Made(days=0.1))).replace(old, new, 1)
    path = written(tmp_path, readings(Made(days=0.1)))
    (tmp_path / "trend.csv").write_text(text, "utf-8")
    ran = wraparc("learn", path)
    assert ran.code == 2
    assert words in ran.err
