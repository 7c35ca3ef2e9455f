"""What can be said of a drive before it is solved."""

from dataclasses import replace

from answer.drives import BELT, drive
from worded import verdict_words
from wraparc.checks import Level, before


def test_a_usual_drive_misses_nothing() -> None:
    assert before(drive()).level is Level.OK


def test_everything_that_needs_no_solving_is_said() -> None:
    odd = drive(4e6, 15e3, belt=replace(BELT, width=6.0, least_pulley_diameter=1.0))
    told = before(odd)
    assert told.level is Level.FAILS
    assert {c.name for c in told.missed} == {
        "usual_sizes", "pulley_diameter", "belt_tension", "tested_pressure_max",
        "tested_pressure_min", "belt_safety",
    }  # fmt: skip
    text = verdict_words(told)
    for said in (
        "Belt width 6000 mm is outside the usual 200 to 4000 mm. Check the unit of belt width: 600 "
        "mm or 6 ft?",
        "Pulley diameter 800 mm is below the belt minimum 1000 mm (head).",
        "Belt tension 4000 kN exceeds the 1050 kN rating (head, full).",
        "Wrap pressure 1670 kPa exceeds the tested 690 kPa (head, full).",
        "Wrap pressure 6.25 kPa is below the tested 34 kPa (head, full).",
    ):
        assert said in text
