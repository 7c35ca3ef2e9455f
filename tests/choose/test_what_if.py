"""What-if pairs: the numbers are those of `solve`, the reasons those of the change."""

import math
import re
from dataclasses import replace
from pathlib import Path

import pytest

from cli.running import DRIVE, drive_file, wraparc
from judgement.rows import BARE, BASE
from wraparc import Belt, InputError, load_drive, load_lagging, solve
from wraparc.catalogue import belt as catalogue_belt
from wraparc.choose.what_if import Change, what_if
from wraparc.drive import changes as study
from wraparc.provenance import Kind, Provenance

pytestmark = pytest.mark.usefixtures("solved_once")


def test_before_and_after_are_what_solve_gives(tmp_path: Path) -> None:
    drive = load_drive(drive_file(tmp_path))
    cord = study.with_belt(drive, catalogue_belt("Flexsteel ST1250"))
    thick = study.with_thickness(drive, "head", 20e-3)
    found = what_if(drive, "head", "design", [Change("cord", cord), Change("thick", thick)])
    for result, one in zip((found.before, *found.after), (drive, cord, thick), strict=True):
        assert result.scalars() == pytest.approx(
            solve(one).arc("head", "design").scalars(), nan_ok=True
        )
    steel = found.after[0]
    # shrinkage is R int (T1 - T)/EA: it falls with the modulus, 90,000 over 12,960 kN/m
    ratio = found.before.creep_shrinkage / steel.creep_shrinkage
    assert ratio == pytest.approx(90 / 12.96, rel=0.15)
    assert cord.belt.width == drive.belt.width
    assert cord.belt.speed == drive.belt.speed


def test_another_belt_keeps_where_width_and_speed_came_from(tmp_path: Path) -> None:
    """Only what the catalogue publishes is called published."""
    drive = load_drive(drive_file(tmp_path))
    measured = Provenance(Kind.MEASURED, "site survey")
    sources = {"width": Provenance(), "speed": measured}
    given = replace(drive, belt=replace(drive.belt, sources=sources))
    row = catalogue_belt("Flexsteel ST1250")
    belt = study.with_belt(given, row).belt
    assert belt.source_of("width") == Provenance()
    assert belt.source_of("speed") == measured
    assert belt.source_of("modulus") == row.provenance


def test_worn_lagging_makes_the_pulley_smaller(tmp_path: Path) -> None:
    drive = load_drive(drive_file(tmp_path))
    worn = study.worn_to(drive, "head", 6e-3).pulley("head")
    assert worn.diameter == pytest.approx(0.8 - 2 * 6e-3)
    assert worn.lagging.thickness == 6e-3
    assert worn.lagging.law == drive.pulley("head").lagging.law


def test_a_bare_pulley_by_its_design_value_is_euler_eytelwein(tmp_path: Path) -> None:
    """CEMA 0.25 carries exp(0.25 pi) = 2.193, less than 2.5; DIN's 0.35 carries it."""
    drive = load_drive(drive_file(tmp_path))
    results = [
        what_if(drive, "head", "design", [Change("bare", study.bare(drive, "head", name)[0])])
        for name in ("CEMA", "DIN 22101")
    ]
    assert not results[0].after[0].status.solved
    ratio = results[0].after[0].capacities.gross_slip_capacity
    assert ratio == pytest.approx(math.exp(0.25 * math.pi), rel=1e-6)
    assert results[1].after[0].status.solved
    with pytest.raises(InputError, match="no design value of a bare pulley"):
        study.bare(drive, "head", "ISO 5048")


def test_the_other_carcass_has_the_nearest_rating(tmp_path: Path) -> None:
    """175 kN/m: ST1250 with 187 is nearer, as a ratio, than ST1000 with 150."""
    drive = load_drive(drive_file(tmp_path))
    assert study.other_carcass(drive.belt).name == "Flexsteel ST1250"
    back = study.other_carcass(study.with_belt(drive, catalogue_belt("Flexsteel ST1250")).belt)
    assert back.kind == "fabric"
    nameless = Belt(name="x", width=1.0, modulus=1e7)
    with pytest.raises(InputError, match="needs rating and kind to find the other carcass"):
        study.other_carcass(nameless)


def test_the_command_tells_the_reasons(tmp_path: Path) -> None:
    file = drive_file(tmp_path)
    ran = wraparc(
        "what-if", file, "--other-carcass", "--thickness", "20 mm", "--wet", "0.8",
        "--lagging", "full-ceramic", "--change", "pulley.head.wrap_angle=210 deg", "--full",
    )  # fmt: skip
    assert ran.code == 0, ran.err
    assert "Flexsteel ST1250: belt shrinkage goes from 2.71 mm to" in ran.words
    assert "the belt is 6.94 times as stiff." in ran.words
    assert "h 20 mm: of the creep the lagging shears 0.538 mm before" in ran.words
    assert "wet: global creep goes from" in ran.words
    assert "has 20 % less friction" in ran.words
    assert "full-ceramic: illustrative" in ran.words
    ran = wraparc("what-if", file, "--bare", "CEMA", "--json", "-")
    before, after = ran.json["results"]
    assert (before["status"], after["status"]) == ("solved", "breakaway")
    assert after["exit_creep"] is None
    assert after["reasons"][0].startswith("gross slip: no creep transmits its Te.")


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        ([], "nothing is to be changed"),
        (["--belt", "ST1"], "the catalogue has no belt of this name"),
        (["--worn", "6"], "no unit, where a length is needed"),
        (
            ["--worn", "0 mm"],
            '--worn: leaves no lagging, got "0 mm". Ask',
        ),
        (["--thickness", "1 km"], '--thickness: must be between 0 mm and 1000 mm, got "1 km".'),
        (["--wet", "ISO"], 'no design values dry and "wet" of surface "rubber"'),
        (["--wet", "80"], '--wet: must be more than 0 and at most 2, got "80".'),
        (["--wet", "1e99"], '--wet: must be more than 0 and at most 2, got "1e99".'),
        (["--wet", "1.3"], "more friction wet than dry"),
        (["--load-case", "x", "--worn", "6 mm"], "the drive has no such load case"),
        (["--pulley", "x", "--worn", "6 mm"], "no such pulley"),
    ],
)
def test_bad_input_is_told(tmp_path: Path, arguments: list[str], sentence: str) -> None:
    ran = wraparc("what-if", drive_file(tmp_path), *arguments)
    assert ran.code == 2
    assert sentence in ran.err
    assert "Traceback" not in ran.err


def test_wear_and_wet_keep_the_direction_of_the_model(tmp_path: Path) -> None:
    """Less friction, more creep; thinner, less creep (section on qualitative truths)."""
    drive = load_drive(drive_file(tmp_path, DRIVE))
    wet = replace(load_lagging("diamond-rubber"), law=load_lagging("medium-ceramic").law)
    found = what_if(
        drive, "head", "design",
        [
            Change("better", study.with_lagging(drive, "head", wet)),
            Change("worn", study.worn_to(drive, "head", 6e-3)),
        ],
    )  # fmt: skip
    assert found.after[0].exit_creep < found.before.exit_creep
    assert found.after[1].exit_creep < found.before.exit_creep


def test_a_new_take_up_tension_says_what_pull_it_implies(tmp_path: Path) -> None:
    """The file holds T1 = 150 kN and T2 = 60 kN: T2 = 30 kN alone means a pull of 120 kN."""
    change = "pulley.head.exit_tension=30 kN"
    ran = wraparc("what-if", drive_file(tmp_path), "--change", change, "--full")
    assert (
        "pulley.head.exit_tension 30 kN: with T2 from 60 kN to 30 kN at constant T1, Te goes from "
        "90 kN to 120 kN; a take-up alone leaves Te unchanged" in ran.words
    )
    assert "the pulley works at a larger tension ratio." in ran.words
    assert "less of the slip that the friction needs" not in ran.words
    assert "Effective tension Te 90 kN 120 kN" in " ".join(ran.words.split())


def test_a_worn_lagging_is_not_ok(tmp_path: Path) -> None:
    """It creeps less, being thinner; what wear takes off its friction nobody knows."""
    path = drive_file(tmp_path)
    text = path.read_text("utf-8").replace("diamond-rubber", "full-ceramic")
    path.write_text(text, "utf-8")
    ran = wraparc("what-if", path, "--worn", "3 mm", "--json", "-")
    assert ran.code == 0
    verdicts = [result["verdict"] for result in ran.json["results"]]
    assert verdicts == ["OK", "ATTENTION"]
    words = wraparc("what-if", path, "--worn", "3 mm").words
    assert "OK All 10 checks pass. Closest: wet creep (estimated) 4.82 of 6.35 mm" in words
    assert "Change worn to 3 mm: creep 3.76 mm, ATTENTION not tested worn." in words
    full = wraparc("what-if", path, "--worn", "3 mm", "--full").words
    assert "ATTENTION: full-ceramic not tested worn: unworn friction used (head, design)." in full


def test_a_column_that_fails_is_no_verdict_on_the_drive(tmp_path: Path) -> None:
    """A bare pulley cannot carry this load; the drive as it is creeps too far, no more."""
    ran = wraparc("what-if", drive_file(tmp_path), "--bare", "CEMA")
    assert ran.code == 0
    assert "ATTENTION Creep 7.49 mm exceeds the 6.35 mm limit (head, design)." in ran.words
    assert "Change bare, CEMA: FAILS gross slip." in ran.words
    assert not re.search("^FAILS", ran.out, re.MULTILINE)


def test_a_belt_too_stiff_for_the_drum_warns(tmp_path: Path) -> None:
    """Its maker's least drive pulley is 1000 mm, the drum has 800 mm."""
    ran = wraparc("what-if", drive_file(tmp_path), "--belt", "Flexsteel ST2000", "--full")
    assert "Change Flexsteel ST2000: creep 6.15 mm, FAILS pulley diameter." in ran.words
    assert (
        "Flexsteel ST2000: FAILS: Pulley diameter 800 mm is below the belt minimum 1000 mm (head)."
        in ran.words
    )


def test_what_else_than_creep_the_drive_misses_comes_first(tmp_path: Path) -> None:
    ran = wraparc(
        "what-if", drive_file(tmp_path), "--worn", "8 mm", "--change", "belt.rating=90 kN/m"
    )
    assert ran.code == 0
    path = tmp_path / "over.toml"
    text = drive_file(tmp_path).read_text("utf-8")
    path.write_text(text.replace("[belt]", '[belt]\nrating = "90 kN/m"', 1), "utf-8")
    ran = wraparc("what-if", path, "--worn", "8 mm")
    assert ran.code == 1
    assert (
        "FAILS Belt tension 150 kN exceeds the 108 kN rating (head, design). "
        "Action Use lagging full-ceramic and a belt rated 125 kN/m (now 90 kN/m). "
        "Change worn to 8 mm: creep 7.20 mm, FAILS belt tension. "
        "Also ATTENTION: Creep 7.49 mm exceeds the 6.35 mm limit (head, design)." in ran.words
    )


def test_a_lagging_does_not_wear_thicker(tmp_path: Path) -> None:
    drive = load_drive(drive_file(tmp_path))
    sentence = (
        "worn: must be at most the lagging thickness 12 mm, got 20 mm. Give the thickness left"
    )
    with pytest.raises(InputError, match=sentence):
        study.worn_to(drive, "head", 20e-3)


@pytest.mark.parametrize("slack", ["75 kN", "100 kN", "120 kN"])
def test_a_bare_pulley_is_lagged(slack: str, tmp_path: Path) -> None:
    # nothing is compressed before: no ratio of compressions is told, and none is needed
    text = BASE.replace('"diamond-rubber"', '"bare"').replace("75 kN", slack) + BARE
    (tmp_path / "drive.toml").write_text(text, "utf-8")
    ran = wraparc("what-if", tmp_path / "drive.toml", "--lagging", "full-ceramic")
    assert ran.code in (0, 1), ran.err
    assert "full-ceramic" in ran.words
