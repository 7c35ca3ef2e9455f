"""Field numbers against the solver, the energy balance, and sums done by hand."""

import math
from dataclasses import replace
from pathlib import Path

import pytest

from cli.running import DRIVE, drive_file, wraparc
from files.samples import example
from wraparc import ArcResult, Distributed, WrapArc, load_drive
from wraparc.answer.field_sheet import field_sheet
from wraparc.answer.sheet import shown as told_in
from wraparc.answer.words import format_verdict
from wraparc.calibrate.field_numbers import (
    TRIP_RULES,
    FieldNumbers,
    at_creep_limit,
    field_numbers,
    wear_coefficient,
)
from wraparc.checks import Level
from wraparc.checks import Verdict as Judgement
from wraparc.drive.pitch import turns_an_hour

pytestmark = pytest.mark.usefixtures("solved_once")

#: Verdict on a drive of which nothing was checked.
NO_DRIVE = format_verdict(Judgement(()))


@pytest.fixture(scope="module")
def results(tmp_path_factory: pytest.TempPathFactory) -> dict[str, ArcResult]:
    drive = load_drive(drive_file(tmp_path_factory.mktemp("field")))
    return {
        c.name: Distributed().solve(WrapArc.of(drive, drive.pulleys[0], c))
        for c in drive.load_cases
    }


def test_the_healthy_difference_is_creep_and_strain(results: dict[str, ArcResult]) -> None:
    """Belt speed rises with tension: it differs by (T1 - T2)/EA, first order."""
    found = field_numbers(results, {}, {}, coefficient=None, depth=6e-3)
    entry, leaving = found.healthy["design"]
    arc = results["design"].arc
    assert entry == results["design"].entry_creep_ratio
    assert leaving - entry == pytest.approx(90e3 / arc.axial_stiffness, rel=0.015)
    assert found.alarm == pytest.approx(1.25 * leaving)
    assert math.isnan(found.wear_per_year)


def test_the_alarm_is_at_the_creep_limit(results: dict[str, ArcResult]) -> None:
    """The empty belt creeps little: its limit is beyond its healthy ratio."""
    empty = {"empty": results["empty"]}
    at = at_creep_limit(results["empty"])
    assert at is not None
    assert at.exit_creep == pytest.approx(6.35e-3, rel=1e-6)
    found = field_numbers(empty, {"empty": at}, {}, coefficient=None, depth=6e-3)
    arc = at.arc
    strain = (1.0 + arc.exit_tension / 15552e3) / (1.0 + arc.entry_tension / 15552e3)
    assert found.at_limit == pytest.approx(1.0 - (1.0 - at.entry_creep_ratio) * strain, rel=1e-12)
    assert found.alarm == found.at_limit
    assert found.trip <= 2.0 * found.alarm


def test_wear_is_energy_times_its_coefficient(results: dict[str, ArcResult]) -> None:
    """3 m/s on 0.8 m is 3 x 3600/(0.8 pi) = 4297 turns an hour; wear = k e n."""
    assert turns_an_hour(3.0, 0.4) == pytest.approx(4297.18, rel=1e-5)
    k = 0.5e-9 / 1e3
    found = field_numbers(results, {}, {"design": 6000.0}, coefficient=k, depth=6e-3)
    energy = results["design"].energy.frictional_energy * 4297.18 * 6000
    assert found.energy_per_year == pytest.approx(energy, rel=1e-5)
    assert found.wear_per_year == pytest.approx(k * energy, rel=1e-5)
    assert found.life_years == pytest.approx(6e-3 / (k * energy), rel=1e-5)
    assert wear_coefficient(found.wear_per_year, found.energy_per_year) == pytest.approx(k)


def test_the_energy_of_wear_is_the_heat_of_sliding(results: dict[str, ArcResult]) -> None:
    """Independent: sliding power v_s B e over the lagged area that passes in a second, v_s B."""
    r = results["design"]
    turns = turns_an_hour(3.0, 0.4)
    area = math.pi * 0.8 * 1.2
    joules = r.energy.frictional_energy * turns * area
    surface_over_belt = 1.0 / (1.0 - r.entry_creep_ratio)
    assert joules * surface_over_belt == pytest.approx(r.energy.sliding_power * 3600.0, rel=1e-9)


def test_the_rules_say_where_they_come_from() -> None:
    for rule in TRIP_RULES:
        assert rule.source.source or "no source" in rule.source.note


def test_the_command(tmp_path: Path) -> None:
    file = drive_file(tmp_path)
    ran = wraparc(
        "field", file, "--hours", "design=6000", "--measured-wear", "4 mm",
        "--wear-hours", "design=12000", "--depth", "6 mm", "--full",
    )  # fmt: skip
    assert ran.code == 0, ran.err
    # half the hours of the measured wear: half of it, and three years for 6 mm
    assert "Wear in a year 2 mm calibrated to the wear measured" in ran.words
    assert "Life of the depth allowed 3 years" in ran.words
    assert "A switch at 80 % of full speed trips at a difference of 20 %" in ran.words
    assert "customary in practice" in ran.words
    ran = wraparc("field", file, "--json", "-")
    # T1 = 150 and T2 = 60 kN, EA = 15552 kN: the entry creep ratio is 0.3578 % (gauges.py)
    behind = 1.0 - (1.0 - 3.578e-3) * (1.0 + 60.0 / 15552.0) / (1.0 + 150.0 / 15552.0)
    assert ran.json["healthy"]["design"]["exit"] == pytest.approx(behind, rel=1e-3)
    assert ran.json["life_years"] is None


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (["--hours", "6000"], "no load case with hours"),
        (["--hours", "full=6000"], "the drive has no such load case"),
        (["--hours", "design=9000"], "must be between 0 and 8784"),
        (["--hours", "design=6000", "--hours", "empty=3000"], "must sum to at most 8784"),
        (["--measured-wear", "4 mm"], "missing: the hours of a measured wear"),
        (["--measured-wear", "4", "--wear-hours", "design=1"], "no unit"),
        (["--depth", "30 mm"], "must be at most the lagging thickness 12 mm"),
        (
            ["--measured-wear", "13 mm", "--wear-hours", "design=1"],
            "must be at most the lagging thickness 12 mm",
        ),
        (["--depth", "-1 mm"], "must be more than 0"),
        (["--pulley", "tail"], "the drive has no such pulley"),
    ],
)
def test_bad_input_is_told(tmp_path: Path, arguments: list[str], sentence: str) -> None:
    ran = wraparc("field", drive_file(tmp_path, DRIVE), *arguments)
    assert ran.code == 2
    assert sentence in " ".join(ran.err.split()), ran.err
    assert "Traceback" not in ran.err


def test_a_belt_that_slips_shows_nothing_to_measure(tmp_path: Path) -> None:
    """The verdict is that of `wraparc solve`, and so is the exit code."""
    changed = ["--set", "pulley.head.entry_tension=9000 kN"]
    ran = wraparc("field", drive_file(tmp_path, DRIVE), *changed)
    assert (ran.code, ran.code) == (wraparc("solve", drive_file(tmp_path, DRIVE), *changed).code, 1)
    assert "Pulley head: nothing to measure, as the belt slips on it." in ran.words
    assert "FAILS Gross slip: safety 0.0177 is below 1 (head, design)." in ran.words
    assert "more (wraparc solve)." in ran.words


def test_wear_shows_as_a_difference_of_speed() -> None:
    """By hand: 8 mm off a drum of 0.8 m takes 2 % of its surface speed, and the belt 1 % more."""
    found = FieldNumbers(
        healthy={"design": (0.004, 0.010)}, at_limit=None, at_breakaway=None, alarm=0.0125,
        trip=0.025, wear_per_year=math.nan, life_years=math.nan, energy_per_year=0.0,
        passes_per_year=0.0, diameter=0.8, depth=8e-3,
    )  # fmt: skip
    assert found.seen(0.0, 8e-3) == pytest.approx(0.02)
    assert found.seen(0.01, 8e-3) == pytest.approx(1.0 - 0.99 * 0.98)
    assert found.seen(0.01, found.wear_to_alarm) == pytest.approx(found.alarm)
    told = told_in(field_sheet(found, NO_DRIVE, "Drive", "head"), "si").verdict
    assert told is not None
    text = " ".join(told.sentences)
    assert "need the pulley speed from a measured circumference" in text
    assert "1 mm moves every difference by 0.25 %, and 8 mm by 2 %" in text


def test_levels_are_what_a_tachometer_pair_shows(tmp_path: Path) -> None:
    """By hand: v = omega (R - delta + e)(1 - g), with e = 4 mm + 8.6 mm/2 and R = 400 mm.

    The belt weighs 1.2 m (10 kg/m2 + 1200 kg/m3 12 mm) = 29.28 kg/m, and runs at 3 m/s.
    """
    covers = ["--set", 'belt.pulley_cover="4 mm"', "--set", 'belt.carry_cover="8 mm"']
    example = Path(__file__).parents[2] / "examples" / "head-drive-fabric.toml"
    ran = wraparc("field", example, *covers, "--json", "-", "--pulley", "head", "--depth", "6 mm")
    drive = load_drive(example)
    e_c = drive.pulleys[0].lagging.compression_modulus

    def shown(ratio: float, entry: float) -> float:
        delta = 12e-3 / e_c * (entry - 29.28 * 3.0**2) / (1.2 * 0.4)
        return 1.0 - (0.4 - delta + 8.3e-3) / 0.4 * (1.0 - ratio)

    for name, entry in (("design", 150e3), ("empty", 82e3), ("start", 186e3)):
        ratios, seen = ran.json["healthy"][name], ran.json["shown"]["healthy"][name]
        assert seen["entry"] == pytest.approx(shown(ratios["entry"], entry), rel=1e-9)
        assert seen["exit"] == pytest.approx(shown(ratios["exit"], entry), rel=1e-9)
        strain = (1.0 + 60e3 / 15552e3) / (1.0 + entry / 15552e3)  # 1200 mm of 12960 kN/m
        behind = 1.0 - (1.0 - ratios["entry"]) * strain
        assert ratios["exit"] == pytest.approx(behind, rel=1e-9)
    # by the gauges of the slow twin (tests/arc/gauges.py) on this drive, G 2.3 MPa on 85 % of it
    assert ran.json["shown"]["healthy"]["start"]["exit"] == pytest.approx(-0.54531e-2, abs=1e-7)
    # the alarm is the difference at the creep limit of one of the load cases, its T1 held
    alarm = ran.json["shown"]["alarm"]
    assert any(
        alarm == pytest.approx(shown(ran.json["alarm"], entry), rel=1e-9)
        for entry in (150e3, 82e3, 186e3)
    )
    # a millimetre of wear: the belt runs 1 mm farther in, 1/400 of (1 - g)
    worn = ran.json["alarm_when_worn"] - alarm
    assert worn == pytest.approx(6.0 / 400.0 * (1.0 - ran.json["alarm"]), rel=1e-9)
    assert ran.json["drift"] == pytest.approx(1.0 / 0.4)
    text = wraparc("field", example, *covers, "--full").words
    assert "Speed difference -0.545 % exceeds the -1.30 % alarm level (head, start)." in text
    assert "shaft to belt: 1 - v/(omega R), what a tachometer pair shows" in text
    assert "Pulley speeds are those at the lagging surface" not in text


def test_without_the_thickness_no_level_is_a_bare_ok(tmp_path: Path) -> None:
    text = wraparc("field", drive_file(tmp_path), "--full").words
    assert (
        "Pulley speeds are those at the lagging surface: 10 mm of belt on a pulley of 800 mm"
        in text
    )
    found = FieldNumbers(
        healthy={"design": (0.004, 0.010)}, at_limit=None, at_breakaway=None, alarm=0.0125,
        trip=0.025, wear_per_year=math.nan, life_years=math.nan, energy_per_year=0.0,
        passes_per_year=0.0, diameter=0.8, depth=8e-3,
    )  # fmt: skip
    bare = told_in(field_sheet(found, NO_DRIVE, "Drive", "head"), "si").verdict
    known = replace(found, pitch=1.02, shown={"design": (-0.016, -0.010)})
    told = told_in(field_sheet(known, NO_DRIVE, "Drive", "head"), "si").verdict
    assert bare is not None
    assert told is not None
    assert (bare.level, told.level) == (Level.ATTENTION, Level.OK)
    assert told.text == ("Normal speed difference up to -1 %; alarm -0.725 %, trip 0.55 % (head).")
    # by hand: 10 mm of belt raise the radius of 400 mm by 5 mm, 1.25 %
    assert bare.action is not None
    assert "10 mm of belt shifts all by 1.25 points." in bare.action.text
    assert told.action is None


def test_levels_of_a_braking_pulley_are_below() -> None:
    """A belt ahead of its drum by 1 %, its alarm at 1.25 %, on a drum of 0.8 m with e = 8 mm."""
    found = FieldNumbers(
        healthy={"design": (-0.004, -0.010)}, at_limit=0.0125, at_breakaway=None, alarm=0.0125,
        trip=0.025, wear_per_year=math.nan, life_years=math.nan, energy_per_year=0.0,
        passes_per_year=0.0, diameter=0.8, depth=8e-3, pitch=1.02,
        shown={"design": (1 - 1.02 * 1.004, 1 - 1.02 * 1.010)},
    )  # fmt: skip
    assert found.worst_seen == pytest.approx(1 - 1.02 * 1.010)
    assert found.seen(found.alarm, 0.0) == pytest.approx(1 - 1.02 * 1.0125)
    headline = told_in(field_sheet(found, NO_DRIVE, "Drive", "head"), "si").verdict.text  # type: ignore[union-attr]
    assert headline.startswith("Normal speed difference down to -3.02 %; alarm -3.275 %, ")


def test_a_drum_is_not_measured_again_for_wear_that_no_tape_tells() -> None:
    # expected: read to 1 mm of circumference, a tape tells 0.16 mm of depth; the alarm of the
    # fabric drive leaves none, that of the tandem 0.98 mm, in four steps
    head = wraparc("field", str(example("head-drive-fabric")), "--full")[1]
    said = " ".join(head.split())
    assert "any wear since it was measured raises the alarm by itself" in said
    assert "Measure the pulley's surface instead of its shaft." in said
    tandem = " ".join(wraparc("field", str(example("tandem-fabric")), "--full")[1].split())
    assert "again for every 0.246 mm worn off" in tandem


COVERS = ("--set", "belt.pulley_cover=4 mm", "--set", "belt.carcass=6 mm")


def test_an_alarm_below_what_a_load_case_shows_is_no_ok() -> None:
    """Compression moves what a pair shows: the empty belt's limit is below the healthy start.

    The start presses the lagging more, so the belt runs nearer the shaft and the pair shows more.
    """
    asked = ("field", example("uphill-conveyor"), *COVERS, "--set", "creep_limit=6.2 mm")
    ran, seen = wraparc(*asked, "--full"), wraparc(*asked, "--json", "-").json["shown"]
    assert seen["healthy"]["start"]["exit"] > seen["alarm"] > seen["healthy"]["full"]["exit"]
    assert "ATTENTION Speed difference -0.845 % exceeds the -0.857 % alarm level" in ran.words
    assert "Action Set each load case's own alarm level (--table levels)." in ran.words
    assert "set each load case's own level, that of its creep limit" in ran.words
    assert "At the creep limit, empty -0.857 %" in ran.words
    assert "At the creep limit, start -0.727 %" in ran.words


@pytest.mark.parametrize("covers", [(), COVERS])
def test_a_brake_is_told_by_the_load_cases_that_brake(covers: tuple[str, ...]) -> None:
    """Its empty belt drives: that limit is no alarm of a brake. Wear raises ratios, away from it.

    By hand: wear w takes 2 w/D (1 + 0.581 %) off a drum of 1.07 m, -0.581 % -> 0.833 % at 7.5 mm.
    """
    ran = wraparc("field", example("downhill-braking"), *covers, "--full")
    told = wraparc("field", example("downhill-braking"), *covers, "--json", "-").json
    healthy = told["healthy"]["emergency stop"]["exit"]
    assert 0.005 < -healthy < told["alarm"] < told["trip"]
    assert told["wear_to_alarm"] is None
    assert "wear since it was measured hides the slip of a brake" in ran.words
    assert "alarms at once" not in ran.words
    assert "own level" not in ran.words
    if not covers:
        levels = "alarm -0.710 %, trip -1.42 % (tail)."
        assert f"ATTENTION Normal speed difference down to -0.581 %; {levels}" in ran.words
        assert "Healthy, at most -0.581 % 0.833 %" in ran.words


def test_levels_say_what_a_cover_that_may_be_in_the_slip_would_show(tmp_path: Path) -> None:
    """Expected: the drive solved again with a law that has no shear of a cover in its slip."""
    text = example("uphill-conveyor").read_text("utf-8")
    (tmp_path / "unsaid.toml").write_text(text, "utf-8")
    ran = wraparc("field", tmp_path / "unsaid.toml", *COVERS, "--full")
    assert "Unknown whether the tested slip includes the shear of the belt cover" in ran.words
    told = wraparc("field", tmp_path / "unsaid.toml", *COVERS, "--json", "-").json
    drive = load_drive(tmp_path / "unsaid.toml")
    belt = replace(drive.belt, pulley_cover=4e-3, carcass=6e-3)
    ends = []
    for case in drive.load_cases:
        arc = WrapArc.of(replace(drive, belt=belt), drive.pulleys[0], case)
        arc = replace(arc, cover_compliance=4e-3 / 1e6, cover_left_out=0.0)
        g = Distributed(capacities=False).solve(arc).entry_creep_ratio
        ea = arc.axial_stiffness
        strain = (1.0 + arc.exit_tension / ea) / (1.0 + arc.entry_tension / ea)
        ends.append(1.0 - arc.pitch_radius / arc.radius * (1.0 - g) * strain)
    assert told["with_cover_in_series"] == pytest.approx(max(ends), rel=1e-9)
    assert max(ends) > told["shown"]["healthy"]["start"]["exit"]
