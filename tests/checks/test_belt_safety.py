"""The safety factor of the belt: strength over its largest tension, against what is asked of it.

Expected by hand: ST2000 of 1.2 m breaks at 2400 kN; a rating of 300 kN/m leaves it 2000/300 = 6.67.
"""

from dataclasses import replace

import pytest

from checks.test_least_tension import random_drives
from checks.test_of_rows import of_rows, one_by_one
from wraparc import Drive, solve
from wraparc.checks import Check, Level, judge
from wraparc.drive import CaseKind, Tensions


def of_belt(tight: float, state: CaseKind = "running", **belt: object) -> Drive:
    """A drive of ST2000 steel cord, 1.2 m wide, at a tight side [N]."""
    (of,) = random_drives(1, seed=11)
    (head,), (case,) = of.pulleys, of.load_cases
    given = {"name": "ST2000", "kind": "steel cord", "rating": 300e3, "momentary_factor": 1.5,
             "width": 1.2, "modulus": 144e6, "least_pulley_diameter": None,
             "thickness": None, "carcass": None, "mass": None, "pulley_cover": None,
             "carry_cover": None} | belt  # fmt: skip
    tensions = {head.name: Tensions(entry=tight, exit=0.6 * tight)}
    return replace(
        of,
        belt=replace(of.belt, **given),  # type: ignore[arg-type]
        pulleys=(replace(head, diameter=1.6, wrap_angle=3.4),),
        load_cases=(replace(case, kind=state, tensions=tensions),),
    )


def checked(of: Drive, name: str = "belt_safety") -> Check:
    """Its check, as the one list has it."""
    return next(c for c in judge(solve(of, raise_on_failure=False)).checks if c.name == name)


@pytest.mark.parametrize(
    ("kind", "tight", "safety", "asked", "level"),
    [
        ("running", 350e3, 2400 / 350, 20 / 3, Level.OK),
        ("running", 370e3, 2400 / 370, 20 / 3, Level.FAILS),
        ("starting", 370e3, 2400 / 370, 40 / 9, Level.OK),  # 450 kN/m while starting
        ("braking", 560e3, 2400 / 560, 40 / 9, Level.FAILS),
    ],
)
def test_the_strength_over_the_tension_is_held_against_that_over_the_rating(
    kind: CaseKind, tight: float, safety: float, asked: float, level: Level
) -> None:
    check = checked(of_belt(tight, kind))
    assert check.value == pytest.approx(safety, rel=1e-12)
    assert check.limit == pytest.approx(asked, rel=1e-12)
    assert check.level is level
    assert ("momentary_factor, 1.5" in check.source) is (kind != "running")


@pytest.mark.parametrize("over", [0.99, 0.99996, 1.0, 1.00004, 1.0007, 1.01])
def test_it_is_missed_where_the_rating_is(over: float) -> None:
    """Also in the last digits: 360.014 kN is 360 kN in four digits, 6.6664 is not 6.6667."""
    of = of_belt(over * 360e3)
    assert checked(of).level is checked(of, "belt_tension").level


@pytest.mark.parametrize(
    ("carcass", "tight", "asked", "level"),
    [
        ("steel cord", 359e3, 20 / 3, Level.OK),  # 15 % of the strength
        ("steel cord", 370e3, 20 / 3, Level.ATTENTION),
        ("steel cord", 810e3, 20 / 3, Level.FAILS),  # 2.96: less than 3
        ("fabric", 290e3, 8.0, Level.OK),
        ("fabric", 310e3, 8.0, Level.ATTENTION),
        ("", 310e3, float("nan"), Level.NOT_CHECKED),
    ],
)
def test_without_a_rating_what_is_customary_is_asked(
    carcass: str, tight: float, asked: float, level: Level
) -> None:
    of = of_belt(tight, rating=None, kind=carcass)
    check = checked(of)
    assert check.level is level
    assert check.limit == pytest.approx(asked, nan_ok=True)
    assert checked(of, "belt_tension").level is Level.NOT_CHECKED
    assert not check.binding or level is Level.NOT_CHECKED
    assert of_rows(of) == one_by_one(of)


def test_without_a_strength_it_is_not_checked() -> None:
    check = checked(of_belt(300e3, name="EP belt"))
    assert check.level is Level.NOT_CHECKED
    assert check.missing == "belt.strength"


@pytest.mark.parametrize("over", [0.9, 0.99996, 1.00004, 1.2])
def test_rows_of_a_study_end_as_the_drive(over: float) -> None:
    of = of_belt(over * 360e3)
    assert of_rows(of) == one_by_one(of)


@pytest.mark.parametrize(
    ("name", "rating", "strength"),
    [
        ("EP 630/4", None, 630e3),  # DIN 22102: N/mm before the plies
        ("PN 440/4 PIW", None, None),  # a rated tension, not the strength
        ("ACME ep1000/4", 100e3, 1000e3),
        ("NN-500/3 X", None, 500e3),
        ("630/4", 63e3, 630e3),
        ("1000/4", 175e3, None),  # of lbf/in, a rating: 1000 lbf/in = 175.1 kN/m
        ("Plylon Plus 1000/4", 175e3, None),
        ("EP200", None, None),  # of a ply
        ("Flexsteel ST1000", None, 1000e3),
        ("Cover 8/4", None, None),
    ],
)
def test_a_name_tells_the_strength(name: str, rating: float | None, strength: float | None) -> None:
    assert of_belt(300e3, name=name, rating=rating).belt.breaking_strength == strength


@pytest.mark.parametrize("over", [0.4, 0.9, 1.2, 2.5])
@pytest.mark.parametrize("kind", ["fabric", ""])
def test_a_rating_that_leaves_hardly_a_safety_is_none_to_rely_on(over: float, kind: str) -> None:
    """2000/600 = 3.33: what is customary is asked, 8 of fabric, 4 of any (`LEAST_RATED`)."""
    of = of_belt(over * 360e3, rating=600e3, kind=kind)
    check = checked(of)
    assert check.limit == (8.0 if kind else 4.0)
    assert check.level is (
        Level.FAILS if check.value < 3.0 else Level.ATTENTION if check.value < check.limit
        else Level.OK
    )  # fmt: skip
    assert of_rows(of) == one_by_one(of)


def test_a_strength_below_the_tension_is_never_kept() -> None:
    """6.67 over a momentary factor of ten is 0.67; 2400 kN over 2667 kN is 0.9."""
    assert checked(of_belt(2667e3, "starting", momentary_factor=10.0)).level is Level.FAILS
