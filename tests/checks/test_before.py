"""What can be said of a drive before it is solved."""

from dataclasses import replace

from answer.drives import BELT, drive
from wraparc.checks import Level, before


def test_a_usual_drive_misses_nothing() -> None:
    assert before(drive()).level is Level.OK


def test_everything_that_needs_no_solving_is_said() -> None:
    odd = drive(4e6, 15e3, belt=replace(BELT, width=12.0, least_pulley_diameter=1.0))
    told = before(odd)
    assert told.level is Level.FAILS
    assert {c.name for c in told.missed} == {
        "usual_sizes", "pulley_diameter", "belt_tension", "tested_pressure_max",
        "tested_pressure_min", "belt_safety",
    }  # fmt: skip
    text = " ".join((told.headline(), *told.sentences()))
    for said in (
        "Unusual width of the belt, 12 m; 200 mm to 4000 mm is usual. Check the unit: "
        "12 in or 12 ft?",
        "Pulley head, 800 mm, is smaller than the least for its belt, 1000 mm.",
        "The belt tension 4000 kN is more than its rating allows, ",
        "The wrap pressure 833 kPa is above the 690 kPa",
        "The wrap pressure 3.125 kPa is below the 34 kPa",
    ):
        assert said in text
