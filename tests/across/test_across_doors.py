"""`[pulley.across]` in drive files, and what the doors say of it."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from cli.running import wraparc
from worded import check_words
from wraparc import InputError, SlackBeltError, load_drive, solve, solve_across
from wraparc.across import across_of, in_plane_stiffness, screen
from wraparc.checks import Level, Verdict, judge
from wraparc.checks.of_across import least_transition
from wraparc.drive import Across, Belt, Drive, GrippingPulley, Transition, WidthProfile
from wraparc.files import drive_from_text
from wraparc.files.write import drive_text
from wraparc.units import display, in_units

pytestmark = pytest.mark.usefixtures("solved_once")

EXAMPLES = Path(__file__).parents[2] / "examples"
FABRIC = EXAMPLES / "worn-head-drive-fabric.toml"
CORD = EXAMPLES / "worn-head-drive-steel-cord.toml"
FEW = ("pulley.head.across.strips=6",)

WHOLE = """
format = 1
[belt]
preset = "Plylon Plus 1000/4"
width = "48 in"
[[pulley]]
name = "head"
diameter = "800 mm"
wrap_angle = "180 deg"
lagging = "diamond-rubber"
entry_tension = "150 kN"
exit_tension = "60 kN"
[pulley.across]
shell_profile = { crown = "2 mm", on = "diameter" }
worn_depth = { rows = [["-20 in", "0.02 in"], ["20 in", "0.1 in"]], uncertainty = "0.2 mm" }
build_up = []
misalignment = "2 mm/m"
deflection = "0.3 mm"
entry_profile = [["-500 mm", "-2 kN/m"], ["500 mm", "2 kN/m"]]
before = { kind = "transition", length = "2.9 m", trough_angle = "35 deg", centre_roll = "465 mm", depth = "half" }
after = { kind = "pulley", distance = "1.5 m" }
strips = 24
"""  # noqa: E501


def test_a_whole_table_is_read_and_written() -> None:
    """Source: the numbers as they stand in the file, on radius and in metres."""
    drive = drive_from_text(WHOLE)
    assert drive.pulleys[0].across == Across(
        shell_profile=WidthProfile(crown=1e-3),
        worn_depth=WidthProfile(
            position=(-0.508, 0.508), value=(0.000508, 0.00254), uncertainty=0.2e-3
        ),
        misalignment=2e-3,
        deflection=0.3e-3,
        entry_profile=WidthProfile(position=(-0.5, 0.5), value=(-2e3, 2e3)),
        before=Transition(
            length=2.9, trough_angle=np.radians(35.0), centre_roll=0.465, depth="half"
        ),
        after=GrippingPulley(distance=1.5),
        strips=24,
    )
    assert drive_from_text(drive_text(drive)) == drive


def test_diameters_become_deviations_of_the_radius() -> None:
    text = WHOLE.replace(
        '{ crown = "2 mm", on = "diameter" }',
        '{ rows = [["-500 mm", "798 mm"], ["500 mm", "802 mm"]], on = "diameter" }',
    )
    shell = drive_from_text(text).pulleys[0].across
    assert shell is not None
    assert shell.shell_profile is not None
    assert shell.shell_profile.value == pytest.approx((-1e-3, 1e-3))


FAULTS = [
    (
        '"2 mm", on = "diameter"',
        '"400 mm"',
        "must be a deviation of radius up to 100 mm",
    ),
    ('["-20 in"', '["-30 in"', "must be between -609.6 mm and 609.6 mm, the edges"),
    ('["-20 in"', '["21 in"', "the positions must ascend"),
    ('"0.1 in"', '"0.6 in"', "must be less than the lagging thickness 12 mm"),
    ('"2 mm/m"', '"20 deg"', "an angle, where a plain number is needed"),
    ("strips = 24", "strips = 2", "must be a whole number from 4 to 128"),
    ('depth = "half"', 'depth = "deep"', 'must be one of "full", "half"'),
    ('"465 mm"', '"4650 mm"', "must be less than the belt width"),
    ("deflection", "deflexion", 'Did you mean "deflection"?'),
]


@pytest.mark.parametrize(("old", "new", "says"), FAULTS)
def test_a_fault_is_said(old: str, new: str, says: str) -> None:
    assert old in WHOLE
    with pytest.raises(InputError, match=r"pulley\.head\.across") as error:
        drive_from_text(WHOLE.replace(old, new))
    assert says in str(error.value)


def test_all_faults_are_said_at_once() -> None:
    text = WHOLE
    for old, new, _ in (FAULTS[0], FAULTS[2], FAULTS[4], FAULTS[5], FAULTS[8]):
        text = text.replace(old, new)
    with pytest.raises(InputError) as error:
        drive_from_text(text)
    assert len(error.value.problems) == 5


def _with(drive: Drive, **more: object) -> Drive:
    across = replace(drive.pulleys[0].across or Across(), strips=6, **more)  # type: ignore[arg-type]
    return replace(drive, pulleys=(replace(drive.pulleys[0], across=across),))


def _verdict(drive: Drive) -> Verdict:
    return judge(solve(drive, raise_on_failure=False))


@pytest.fixture(scope="module")
def fabric() -> Drive:
    return _with(load_drive(EXAMPLES / "head-drive-fabric.toml", overrides={"load_case": None}))


def test_slack_is_said_with_strip_and_amount(fabric: Drive) -> None:
    """A build-up of 30 mm on a quarter: stopped, not clipped."""
    heap = WidthProfile(position=(0.2, 0.21, 0.6), value=(0.0, 0.03, 0.03))
    drive = _with(fabric, build_up=heap)
    with pytest.raises(SlackBeltError) as error:
        solve_across(drive)
    slack = solve_across(drive, raise_on_failure=False).slack
    assert slack is not None
    # the strip beside the heap, by name, and what the linear belt would lack there
    says = (
        f"The strip at {display(slack.position, 'length', digits=3)} from the middle of the belt "
        f"goes slack: it lacks {display(-slack.tension, 'force_per_width', digits=3)}"
    )
    assert says in str(error.value)
    assert slack.position == pytest.approx(0.1)  # centre of the fourth of six strips
    assert slack.tension < 0.0
    assert "of the input unevenness on" in str(error.value)
    verdict = _verdict(drive)
    assert verdict.level is Level.FAILS
    assert in_units(verdict.text) == "Strip at 100 mm goes slack (head, design)."
    assert any("the strip lacks" in in_units(text) for text in verdict.full)


def test_other_blocks_are_another_belt_across_its_width() -> None:
    """What is kept of a solve is that of the same blocks: they say how worn lagging compresses."""
    drive = load_drive(EXAMPLES / "worn-head-drive-fabric.toml")
    drive = _with(drive, before=None)
    pulley = drive.pulleys[0]
    block = pulley.lagging.block
    assert block is not None
    wide = replace(pulley.lagging, block=replace(block, width=4.0 * block.width))
    other = replace(drive, pulleys=(replace(pulley, lagging=wide),))
    for one in (drive, other):
        kept = across_of(solve(one, raise_on_failure=False))[0]
        alone = solve_across(one, load_case=kept.wide.arc.load_case)
        assert kept.entry_tension == pytest.approx(alone.entry_tension, rel=1e-12)


def test_edges_over_the_rating_fail_and_govern() -> None:
    """Source: 115 % of the rating of the belt."""
    drive = load_drive(CORD, overrides=["pulley.head.across.strips=8"])
    verdict = _verdict(drive)
    assert verdict.level is Level.FAILS
    worst = verdict.governing
    assert worst is not None
    assert worst.name == "edge_tension"
    assert worst.limit == pytest.approx(1.15 * (drive.belt.rating or 0.0))
    assert "exceeds the 345 kN/m limit (head, design)." in in_units(verdict.text)
    missed = {c.name for c in verdict.missed}
    assert "crown" in missed  # none for steel cord
    # at a start the belt may bear what its rating allows for a moment
    starting = replace(drive.load_cases[0], kind="starting")
    belt = replace(drive.belt, momentary_factor=1.4)
    checks = _verdict(replace(drive, belt=belt, load_cases=(starting,))).checks
    limit = next(c.limit for c in checks if c.name == "edge_tension")
    assert limit == pytest.approx(1.4 * 1.15 * (belt.rating or 0.0))


def test_wear_that_grows_is_said(fabric: Drive) -> None:
    case = fabric.load_cases[0]
    tensions = case.tensions["head"]
    turned = replace(tensions, entry=tensions.exit, exit=tensions.entry)
    braking = replace(fabric, load_cases=(replace(case, tensions={"head": turned}),))
    check = next(c for c in _verdict(braking).checks if c.name == "uneven_wear")
    assert check.level is Level.ATTENTION
    assert in_units(check.text).startswith("Uneven wear grows ")
    driving = next(c for c in _verdict(fabric).checks if c.name == "uneven_wear")
    assert driving.level is Level.OK


def test_bond_and_pressure_at_the_worst_place(fabric: Drive) -> None:
    lagging = replace(fabric.pulleys[0].lagging, bond_strength=1.0e5, fatigue_limit=0.9e5)
    crown = WidthProfile(crown=3e-3)
    pulley = replace(fabric.pulleys[0], lagging=lagging, across=Across(shell_profile=crown))
    belt = replace(fabric.belt, largest_wrap_pressure=3.2e5)
    drive = _with(replace(fabric, pulleys=(pulley,), belt=belt))
    found = {c.name: c for c in _verdict(drive).checks}
    even, uneven = found["bond_stress"], found["uneven_bond_stress"]
    assert even.level is Level.OK
    assert uneven.level is Level.ATTENTION
    assert uneven.value > even.value
    assert found["uneven_face_pressure"].level is Level.ATTENTION
    assert found["face_pressure"].level is Level.OK


@pytest.mark.parametrize(
    ("kind", "angle", "depth", "share", "widths"),
    [
        ("fabric", 35.0, "full", 0.95, 3.2),
        ("fabric", 20.0, "full", 0.7, 1.6),
        ("fabric", 45.0, "half", 0.5, 1.2),
        ("steel cord", 35.0, "full", 0.95, 6.8),
        ("steel cord", 27.5, "full", 0.7, 4.2),
    ],
)
def test_customary_transition(
    kind: str, angle: float, depth: str, share: float, widths: float
) -> None:
    """Source: Useful Conveyor Design Data, lengths over belt width; between angles linear."""
    belt = Belt(name="b", kind=kind, width=1.2, modulus=1e7)
    span = Transition(
        length=1.0,
        trough_angle=np.radians(angle),
        centre_roll=0.4,
        depth=depth,  # type: ignore[arg-type]
    )
    assert least_transition(belt, span, share) == pytest.approx(widths * 1.2)


def test_a_short_transition_is_said_at_standstill_and_running(fabric: Drive) -> None:
    span = Transition(length=1.0, trough_angle=np.radians(35.0), centre_roll=0.465)
    found = {c.name: c for c in _verdict(_with(fabric, before=span)).checks}
    assert found["transition_length"].level is Level.ATTENTION
    assert found["static_edge_tension"].level is Level.FAILS
    assert found["static_edge_tension"].value > found["edge_tension"].value
    words = check_words(found["transition_length"])
    # 2.4 widths for 35 deg in full at 60 to 90 % of the rating: 150 kN on 1.2 m of 175 kN/m
    assert "Transition 1000 mm is below the usual minimum 2880 mm (head, design)." in words
    assert "For fabric at 71.4 % of the rating." in words


def test_missing_stiffness_is_estimated_and_said() -> None:
    drive = load_drive(CORD)
    found = in_plane_stiffness(drive.belt)
    assert found.estimated
    assert (found.low, found.value, found.high) == (10e3, 40e3, 160e3)
    verdict = judge(solve(_with(drive), raise_on_failure=False))
    assert any("in-plane shear stiffness" in words for words in verdict.remarks)
    told = wraparc("solve", CORD, "--full").words
    low, high = screen(drive, drive.pulleys[0], drive.load_cases[0]).band
    assert "estimated for steel cord, between 10 and 160 kN/m" in told
    assert f"then {low:.3f} to {high:.3f} times its mean at most" in told
    assert low < high
    given = replace(drive.belt, in_plane_shear_stiffness=5e4)
    assert not in_plane_stiffness(given).estimated


def test_an_even_drive_is_not_asked_about_its_width() -> None:
    """What says nothing of its width is judged and shown as before."""
    result = solve(load_drive(EXAMPLES / "head-drive-fabric.toml"))
    assert across_of(result) == ()
    assert not any("edge" in c.name or "uneven" in c.name for c in judge(result).checks)


def test_the_command_line_tells_and_draws(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "140")  # names of rows on one line
    told, data, picture = tmp_path / "told", tmp_path / "out.json", tmp_path / "map.svg"
    ran = wraparc("solve", FABRIC, "--set", *FEW, "--json", data, "--map", picture, "--full")
    assert ran.code == 0
    for words in (
        "Across the width: pulley head, load case design",
        "Maximum tension at standstill",
        "Levelling depth, modes 1 to 4",
        "Share of each defect",
        "Worn lagging",
        "Trough transition",
    ):
        assert words in ran.words
    (across,) = json.loads(data.read_text("utf-8"))["across"]
    strips = solve_across(load_drive(FABRIC, overrides=FEW))
    assert across["across"]["entry_tension"] == pytest.approx(strips.entry_tension.tolist())
    assert across["energy_unevenness"] == pytest.approx(strips.energy_unevenness)
    assert "<svg" in picture.read_text("utf-8")
    assert not told.exists()


def test_no_map_of_an_even_drive(tmp_path: Path) -> None:
    ran = wraparc("solve", EXAMPLES / "head-drive-fabric.toml", "--map", tmp_path / "map.svg")
    assert ran.code == 2
    assert "no pulley of this drive is uneven across its width" in ran.err


def test_what_if_compares_across_the_width() -> None:
    ran = wraparc(
        *("what-if", CORD, "--change", "pulley.head.across.build_up=[]"),
        *("--thickness", "20 mm", "--json", "-"),
    )
    before, thick, clean = (r["across"] for r in ran.json["results"])
    assert clean["entry_unevenness"] < thick["entry_unevenness"] < before["entry_unevenness"]
    assert clean["largest_running_tension"] < before["largest_running_tension"]


def test_the_note_has_a_section(tmp_path: Path) -> None:
    path = tmp_path / "note.md"
    ran = wraparc("report", FABRIC, "--set", *FEW, "--output", path)
    assert ran.code == 0, ran.err
    text = path.read_text("utf-8")
    assert "Across the width" in text
    assert "Share of each defect" in text
    assert "cut into strips" in text
