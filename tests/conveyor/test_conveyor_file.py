"""The ``[conveyor]`` table and the belt path of a drive file, from reading to what is shown."""

import json
import math
from dataclasses import replace
from pathlib import Path

import pytest

from wraparc import InputError, load_train, solve
from wraparc.answer.document import json_text, result_document
from wraparc.answer.drive_sheet import drive_sheet, input_sheet
from wraparc.answer.sheet import shown as told_in
from wraparc.arc import DriveResult
from wraparc.checks import judge
from wraparc.drive import Drive, Tensions
from wraparc.files import drive_document, drive_from_text, drive_text, load_drive

EXAMPLE = Path(__file__).parents[2] / "examples" / "uphill-conveyor.toml"
DRIVE = EXAMPLE.read_text("utf-8")


@pytest.fixture(scope="module")
def drive() -> Drive:
    return load_drive(EXAMPLE)


@pytest.fixture(scope="module")
def result(drive: Drive) -> DriveResult:
    return solve(drive)


def problems(*swaps: tuple[str, str]) -> list[str]:
    text = DRIVE
    for old, new in swaps:
        assert text.count(old) == 1, old
        text = text.replace(old, new)
    with pytest.raises(InputError) as caught:
        drive_from_text(text, file="in.toml")
    return [str(problem).removeprefix("in.toml: ") for problem in caught.value.problems]


def test_the_table_makes_the_load_cases(drive: Drive) -> None:
    """f L g and the rest by hand: 600 m, 20 m of lift, 1000 t/h at 3 m/s, C = 1.17, f = 0.022."""
    material = 1000.0 / 3.6 / 3.0
    cosine = math.sqrt(1.0 - (20.0 / 600.0) ** 2)
    main = 0.022 * 600.0 * 9.80665 * (16.0 + 6.0 + (2 * 22.0 + material) * cosine)
    pull = 1.17 * main + 20.0 * 9.80665 * material + 1.5e3
    cases = {case.name: case for case in drive.load_cases}
    assert {name: case.kind for name, case in cases.items()} == {
        "full": "running", "empty": "running", "start": "starting", "stop": "braking",
    }  # fmt: skip
    full = cases["full"].tensions["head"]
    assert full.effective == pytest.approx(pull, rel=1e-12)
    returning = 0.022 * 600.0 * 9.80665 * (6.0 + 22.0 * cosine) - 20.0 * 9.80665 * 22.0
    # 8 t on two strands of the take-up, 20 m along the return strand
    assert full.exit == pytest.approx(4000.0 * 9.80665 - returning / 30.0, rel=1e-12)
    assert cases["start"].tensions["head"].effective == pytest.approx(1.3 * pull, rel=1e-12)


def test_the_checks_know_the_kinds_of_the_load_cases(result: DriveResult) -> None:
    """A starting load case needs a factor of 1.1 against gross slip, a running one 1.25."""
    limits = {
        check.place.load_case: check.limit
        for check in judge(result).checks
        if check.name == "gross_slip"
    }
    assert limits == {"full": 1.25, "empty": 1.25, "start": 1.1, "stop": 1.1}


def test_the_belt_path_gives_the_wrap_angle(drive: Drive) -> None:
    """See test_belt_path for the geometry of this head and snub pulley."""
    expected = math.pi + math.asin(0.75 / math.hypot(1.2, 0.6)) - math.atan2(0.6, 1.2)
    assert drive.pulleys[0].wrap_angle == pytest.approx(expected, rel=1e-12)
    assert "coordinates" in drive.pulleys[0].sources["wrap_angle"].note


def test_a_belt_path_serves_a_drive_with_tensions_too() -> None:
    start, end = DRIVE.index("[conveyor]"), DRIVE.index("[[pulley]]")
    given = 'entry_tension = "82 kN"\nexit_tension = "39 kN"\n'
    text = DRIVE[:start] + DRIVE[end:].replace("[pulley.belt_path]", given + "[pulley.belt_path]")
    read = drive_from_text(text)
    assert read.conveyor is None
    assert read.pulleys[0].wrap_angle > math.pi


def test_everything_wrong_is_told_at_once() -> None:
    told = problems(
        ('length = "600 m" ', 'length = "-600 m" '),
        ('belt_mass = "22 kg/m"\n', ""),
        ('counterweight = "8 t" ', 'counterweight = "8 t"\ntake_up_tension = "39 kN" '),
        ('speed = "3 m/s" ', ""),
        ('lagging = "diamond-rubber" ', 'lagging = "diamond-rubber"\nentry_tension = "9 kN" '),
        ("[pulley.belt_path]", 'wrap_angle = "190 deg"\n[pulley.belt_path]'),
        ("[[pulley]]", '[take_up]\nkind = "fixed"\n[[load_case]]\nname = "x"\n[[pulley]]'),
    )
    assert sorted(sentence.partition(". ")[0].rstrip(".") for sentence in told) == sorted([
        'conveyor.length: must be more than 0 mm and at most 100000 m, got "-600 m"',
        "conveyor.belt_mass: missing",
        'conveyor.counterweight: means the same as take_up_tension, got "8 t"',
        'conveyor.capacity: needs the belt speed, got "1000 t/h"',
        'conveyor.stop_time: needs the belt speed, got "15 s"',
        'pulley.head.entry_tension: the [conveyor] table gives the tensions already, got "9 kN"',
        "pulley.head.wrap_angle: belt_path gives it already",
        'take_up.kind: a fixed take-up does not go with [conveyor], got "fixed"',
        "load_case: the [conveyor] table gives the load cases already",
    ])  # fmt: skip


def test_a_slack_belt_is_refused_where_the_take_up_stands() -> None:
    (told,) = problems(('counterweight = "8 t" ', 'take_up_tension = "2 kN" '))
    assert told.startswith("conveyor.take_up_tension: leaves -1.917 kN at the far end")
    assert 'in load case stop, got "2 kN".' in told


def test_pulleys_that_overlap_are_told_with_their_place() -> None:
    (told,) = problems(('x = "-1.2 m"', 'x = "-0.1 m"'))
    assert told.startswith("pulley.head.belt_path.after: overlaps the pulley: ")


def test_a_wrap_angle_or_a_belt_path_is_needed() -> None:
    start = DRIVE.index("# Seen with")
    with pytest.raises(InputError, match=r"pulley\.head\.wrap_angle: missing"):
        drive_from_text(DRIVE[:start])


def test_several_drives_of_a_conveyor_need_their_shares(tmp_path: Path) -> None:
    second = '\n[[pulley]]\nname = "b"\ndiameter = "1 m"\nwrap = "180 deg"\n'
    second += 'lagging = "diamond-rubber"\n'
    with pytest.raises(
        InputError, match=r"conveyor: has 2 drive pulleys and no \[train\] with their shares"
    ):
        drive_from_text(DRIVE + second)
    file = tmp_path / "train.toml"
    shared = DRIVE.replace('counterweight = "8 t"', 'counterweight = "20 t"') + second
    file.write_text(f'{shared}[train]\nshare = ["60 %", "40 %"]\n', "utf-8")
    full = load_train(file).cases[0]
    one = drive_from_text(DRIVE.replace('"8 t"', '"20 t"')).load_cases[0].tensions["head"]
    assert (full.entry_tension, full.exit_tension) == pytest.approx((one.entry, one.exit))
    file.write_text(f'{shared}[train]\nentry_tension = "9 kN"\nshare = ["60 %", "40 %"]\n', "utf-8")
    with pytest.raises(InputError, match=r"train.entry_tension: the \[conveyor\] table gives"):
        load_train(file)


def test_it_is_written_as_it_was_read(drive: Drive) -> None:
    again = drive_from_text(drive_text(drive))
    assert again == drive
    assert again.conveyor == drive.conveyor


def test_tensions_that_no_longer_follow_from_it_are_written_and_it_is_not(drive: Drive) -> None:
    case = drive.load_cases[0]
    other = replace(case, tensions={"head": Tensions(entry=90e3, exit=30e3)})
    changed = replace(drive, load_cases=(other, *drive.load_cases[1:]))
    document = drive_document(changed)
    assert "conveyor" not in document
    assert drive_from_text(drive_text(changed)) == changed
    (table,) = (
        t for t in told_in(input_sheet(changed), "si").tables if t.title.startswith("Conveyor")
    )
    assert [head.partition(" ")[0] for head in table.heads] == ["empty", "start", "stop"]


def test_the_sheet_shows_each_resistance_with_its_source(result: DriveResult) -> None:
    sheet = told_in(drive_sheet([result]), "si")
    (table,) = (t for t in sheet.tables if t.title.startswith("Conveyor"))
    rows = {row.title: row for row in table.rows}
    # 1.17 f L g (...) of test_the_table_makes_the_load_cases, in kN, to three digits
    assert rows["Main resistance"].values[0] == "20.5"
    assert rows["Effective tension"].values[0] == "43.7"
    for title, words in (("Main resistance", "f = 0.022"), ("Secondary resistances", "C = 1.17")):
        number = int(rows[title].note.strip("[]"))
        assert words in sheet.sources[number - 1]
        assert "DIN 22101" in sheet.sources[number - 1]


def test_json_has_the_resistances(result: DriveResult) -> None:
    document = json.loads(json_text(result_document([result])))["conveyor"]
    full = document["load_cases"][0]
    assert document["length_coefficient"] == 1.17
    assert full["effective_tension"] == pytest.approx(
        sum(r["carrying"] + r["return"] for r in full["resistances"].values()), rel=1e-12
    )
