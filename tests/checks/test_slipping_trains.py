"""Trains that a drum of slips: one verdict in every door, and no number where there is no state.

Expected: sliding by friction's own limit (`arc.sliding`, held to definitions elsewhere), and the
same verdict as `wraparc solve` from every other door.
"""

from functools import cache
from pathlib import Path

import pytest

from cli.running import wraparc
from wraparc import Train, load_train, solve_train
from wraparc.checks import Level, Place, judge, least_tension
from wraparc.train import TrainResult, TrainStatus
from wraparc.units import in_units

pytestmark = pytest.mark.usefixtures("solved_once")

TANDEM = Path(__file__).parents[2] / "examples" / "tandem-fabric.toml"
SHARES = 'share = ["50 %", "50 %"]'


def tandem(tmp_path: Path, **changed: str) -> Path:
    """A file of the tandem: T2, pull and division as given."""
    text = TANDEM.read_text("utf-8").partition("# The drives in time")[0]
    text = text.replace('"45 kN"', f'"{changed.get("exit", "45 kN")}"')
    text = text.replace('"105 kN"', f'"{changed.get("pull", "105 kN")}"')
    text = text.replace(SHARES, changed.get("by", SHARES))
    path = tmp_path / "tandem.toml"
    path.write_text(text, "utf-8")
    return path


@pytest.fixture
def slipping(tmp_path: Path) -> Path:
    """The second drum slips in load case design; load case empty is carried."""
    return tandem(tmp_path, exit="0.65 kN")


def solved(path: Path) -> TrainResult:
    train: Train = load_train(path)
    return of_train(train)


@cache
def of_train(train: Train) -> TrainResult:
    return solve_train(train, raise_on_failure=False)


def test_what_slips_is_not_checked_and_no_other_case_hides_it(slipping: Path) -> None:
    result = solved(slipping)
    told = {c.name: c for c in judge(result).listed}
    assert told["gross_slip"].level is Level.FAILS
    for name in ("opposing_drives", "train_balance"):
        assert told[name].level is Level.NOT_CHECKED
        assert told[name].place.load_case == "design"
    # the creep of the other load case is beyond its limit: that is worse than not known
    assert told["creep"].level is Level.ATTENTION
    assert told["creep"].place.load_case == "empty"
    own = {c.name: c for c in judge(result).at("second", "design").listed}
    assert own["creep"].level is Level.NOT_CHECKED
    assert own["creep"].why == "gross slip"


def test_a_kept_creep_does_not_hide_one_that_has_no_number(slipping: Path) -> None:
    text = slipping.read_text("utf-8").replace('"40 kN"', '"4 kN"')
    slipping.write_text(text, "utf-8")
    result = solved(slipping)
    assert judge(result).at("second", "empty").listed
    told = {c.name: c for c in judge(result).listed}
    assert told["creep"].level is Level.NOT_CHECKED
    assert told["creep"].place == Place("second", "design")


def test_what_slips_has_no_share_torque_or_speed(slipping: Path) -> None:
    slips = solved(slipping)["design"]["second"]
    assert slips.arc.effective_tension == pytest.approx(52.5e3)  # as asked for
    for value in (slips.share, slips.drum_torque, slips.speed_ratio, slips.speed_trim):
        assert value != value
    ran = wraparc("solve", slipping)
    assert ran.code == 1
    assert "FAILS Gross slip: safety 0.312 is below 1 (second, design)." in ran.words
    full = wraparc("solve", slipping, "--full").words
    assert "Load case design: Gross slip on second: no creep gives enough friction." in full
    assert "second carries 50 %" not in full.partition("Load case empty")[0]


def test_held_speeds_that_friction_cannot_hold_fail(tmp_path: Path) -> None:
    """Both drums slip: ln(500.65/0.65) = 6.6 is more than their friction carries together."""
    path = tandem(tmp_path, exit="0.65 kN", pull="500 kN", by='speeds = "equal"')
    result = solved(path)
    case = result["design"]
    assert case.status is TrainStatus.BREAKAWAY
    assert case.adrift
    assert judge(result).level is Level.FAILS
    # the ends are those of the file, and nothing else is known
    first, second = case.members
    assert first.arc.entry_tension == 500.65e3
    assert second.arc.exit_tension == 650.0
    assert not first.arc.status.solved
    assert not second.arc.status.solved
    told = {c.name: c for c in judge(result).listed}
    assert told["operating_point"].level is Level.FAILS
    assert told["gross_slip"].level is Level.NOT_CHECKED
    assert least_tension(result) is None
    ran = wraparc("solve", path)
    assert ran.code == 1
    assert "Gross slip: one drive cannot transmit its share (design)." in ran.words


@pytest.mark.parametrize(("by", "pulley"), [(SHARES, "second"), ('speeds = "equal"', "first")])
def test_every_door_gives_the_verdict_of_the_whole_file(
    tmp_path: Path, by: str, pulley: str
) -> None:
    """A drum slips in load case design, whichever pulley is asked about."""
    path = tandem(tmp_path, exit="0.65 kN", pull="105 kN" if by == SHARES else "500 kN", by=by)
    asked = ["--pulley", pulley]
    text = in_units(judge(solved(path)).text)
    for ran in (
        wraparc("what-if", path, *asked, "--thickness", "20 mm"),
        wraparc("what-if", path, *asked, "--load-case", "empty", "--worn", "6 mm"),
        wraparc("field", path, *asked),
    ):
        assert ran.code == 1, ran.err
        assert "FAILS" in ran.out.splitlines()[3]
        assert text in ran.words
        assert "OK, on" not in ran.out


def test_trim_says_why_there_is_nothing_to_trim(slipping: Path) -> None:
    ran = wraparc("trim", slipping)
    assert ran.code == 1
    assert in_units(judge(solved(slipping)).text) in ran.words
    assert "every speed must be positive" not in ran.words + ran.err


def test_trim_gives_the_verdict_of_solve(tmp_path: Path) -> None:
    """T2 = 16 kN presses with 2 T2/(B D) = 33.3 kPa, less than the 34 kPa of the tests."""
    path = tandem(tmp_path, exit="16 kN")
    ran = wraparc("trim", path, "--points", "3")
    assert ran.out.splitlines()[2].startswith("ATTENTION")
    assert f"Also {in_units(judge(solved(path)).text)}" in ran.words


@pytest.mark.parametrize("by", [SHARES, 'speeds = "equal"'])
def test_check_tells_of_the_tensions_of_a_train(tmp_path: Path, by: str) -> None:
    """By hand: 2 T2/(B D) = 2 x 650 N/(1.2 m x 0.8 m) = 1.354 kPa, tested from 34 kPa."""
    ran = wraparc("check", tandem(tmp_path, exit="0.65 kN", by=by))
    assert ran.code == 0
    assert "Drive file valid: 2 pulleys, 2 load cases." in ran.words
    assert "Wrap pressure 1.35 kPa is below the tested 34 kPa (second, design)." in ran.words
    assert "ATTENTION" in ran.out
    assert "OK Drive file valid" in wraparc("check", tandem(tmp_path, by=by)).words


def test_a_least_tension_of_held_speeds_says_that_the_load_divides_anew(tmp_path: Path) -> None:
    said = "at the load shares of now"
    table = ("--table", "least")
    assert said in wraparc("solve", tandem(tmp_path, by='speeds = "equal"'), *table).words
    assert said not in wraparc("solve", tandem(tmp_path), *table).words
