"""What a drive is held against: read, written, refused with everything that is wrong."""

import pytest

from wraparc import InputError
from wraparc.drive import Criteria, DesignStandard, SafetyFactors, Sag, TakeUp
from wraparc.files.drive_file import drive_from_text
from wraparc.files.write import drive_text
from wraparc.train.file import train_from_text

TEXT = """
format = 1
[take_up]
kind = "fixed"
sheave_ratio = 1
[design_standard]
name = "own"
friction = 0.3
start_factor = 1.4
binding = true
[safety_factor]
running = 1.5
source = "works standard 7"
[sag]
idler_spacing = "3 m"
line_mass = "22 kg/m"
[belt]
width = "1200 mm"
modulus = "12960 kN/m"
rating = "250 kN/m"
momentary_factor = 1.4
largest_wrap_pressure = "700 kPa"
[[pulley]]
name = "head"
diameter = "800 mm"
wrap_angle = "180 deg"
lagging = { preset = "diamond-rubber", bond_strength = "1 MPa", fatigue_limit = "0.4 MPa" }
TENSIONS
[[load_case]]
name = "start"
kind = "starting"
CASE
"""
DRIVE = TEXT.replace("TENSIONS", 'entry_tension = "150 kN"\nexit_tension = "60 kN"').replace(
    "CASE", 'pulley.head.entry_tension = "180 kN"'
)
TRAIN = TEXT.replace("TENSIONS", "").replace("CASE", 'train.entry_tension = "180 kN"') + (
    '[train]\nentry_tension = "150 kN"\nexit_tension = "60 kN"\n'
)
CRITERIA = Criteria(
    take_up=TakeUp(kind="fixed", sheave_ratio=1.0),
    standard=DesignStandard(name="own", friction=0.3, start_factor=1.4, binding=True),
    safety=SafetyFactors(running=1.5, source="works standard 7"),
    sag=Sag(spacing=3.0, line_mass=22.0),
)


def test_a_drive_file_says_all_of_it_and_is_written_back() -> None:
    drive = drive_from_text(DRIVE)
    assert drive.criteria == CRITERIA
    assert [case.kind for case in drive.load_cases] == ["running", "starting"]
    assert drive.belt.momentary_factor == 1.4
    assert drive.belt.largest_wrap_pressure == 7e5
    assert drive.pulleys[0].lagging.bond_strength == 1e6
    assert drive.pulleys[0].lagging.fatigue_limit == 4e5
    assert drive_from_text(drive_text(drive)) == drive


def test_a_train_takes_the_same() -> None:
    train = train_from_text(TRAIN)
    assert train.criteria == CRITERIA
    assert [case.kind for case in train.cases] == ["running", "starting"]


def test_the_counterweight_hangs_on_its_strands() -> None:
    # 2 strands of 50 kN hold a weight of 100 kN: 10.197 t
    assert TakeUp().counterweight(50e3) == pytest.approx(100e3 / 9.80665)
    assert TakeUp(sheave_ratio=0.5).counterweight(50e3) == pytest.approx(25e3 / 9.80665)


@pytest.mark.parametrize(
    ("make", "said"),
    [
        (lambda: TakeUp(kind="rope"), "must be one of gravity, winch, fixed"),
        (lambda: DesignStandard(name="own"), "missing for a standard of your own"),
        (lambda: DesignStandard(friction=0.3), "only a standard of your own has one"),
        (lambda: DesignStandard(name="none", binding=True), "no standard was chosen"),
        (lambda: SafetyFactors(running=0.9), "must be between 1"),
    ],
)
def test_what_makes_no_sense_is_refused(make: object, said: str) -> None:
    assert callable(make)
    with pytest.raises(InputError) as caught:
        make()
    assert said in str(caught.value)


def test_everything_wrong_is_said_at_once() -> None:
    bad = DRIVE.replace('"own"', '"CEMA"').replace('"fixed"', '"rope"').replace("1.5", "0.5")
    with pytest.raises(InputError) as caught:
        drive_from_text(bad)
    keys = {problem.key for problem in caught.value.problems}
    assert keys == {"take_up.kind", "design_standard.friction", "safety_factor.running"}
