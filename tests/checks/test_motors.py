"""Motors are held against their rating, and in a start against what IEC 60034-1 lets them bear.

Expected torques by hand: T F_U R (stiff lagging, no creep at constant friction: R - delta = R).
"""

from dataclasses import replace

import pytest

from worded import check_words
from wraparc.checks import Level, judge
from wraparc.checks.check import Place
from wraparc.checks.of_train import motor_load, of_case
from wraparc.train import TrainStatus, solve_train
from wraparc.train.file import train_from_text
from wraparc.units import Cell, in_units, quantity

#: One drum of 0.8 m on one motor of 200 kW at 1480 rpm, i = 20.67: 26.67 kN m at the drum.
DRIVE = """
format = 1
[belt]
preset = "Plylon Plus 1000/4"
width = "1200 mm"
[[pulley]]
name = "head"
diameter = "800 mm"
wrap_angle = "200 deg"
lagging = "rigid"
[train]
exit_tension = "60 kN"
effective_tension = "{pull} kN"
[train.motor.head]
kind = "induction"
rated_power = "200 kW"
synchronous_speed = "1500 rpm"
rated_speed = "1480 rpm"
gear_ratio = 20.67
breakdown_ratio = {breakdown}
[[load_case]]
name = "case"
kind = "{kind}"
train.exit_tension = "60 kN"
[lagging.rigid]
law = {{ kind = "constant", friction = 0.8 }}
"""
RATED = 200e3 / (1480.0 * 3.141592653589793 / 30.0) * 20.67


@pytest.mark.parametrize(
    ("kind", "pull", "breakdown", "level", "name", "limit"),
    [
        ("running", 60, 2.5, Level.OK, "motor_load", 1.0),
        ("running", 70, 2.5, Level.ATTENTION, "motor_load", 1.0),  # 105 %
        ("running", 95, 2.5, Level.FAILS, "motor_load", 1.0),  # 142 %
        ("starting", 95, 2.5, Level.OK, "momentary_load", 1.6),
        ("starting", 95, 1.7, Level.ATTENTION, "momentary_load", 0.81 * 1.7),
        ("braking", -110, 2.5, Level.ATTENTION, "momentary_load", 1.6),  # 165 %, held back
    ],
)
def test_torque_of_motors_is_judged(
    kind: str, pull: float, breakdown: float, level: Level, name: str, limit: float
) -> None:
    text = DRIVE.format(kind=kind, pull=pull, breakdown=breakdown)
    if pull < 0:
        text = text.replace('"60 kN"', '"180 kN"')
    found = judge(solve_train(train_from_text(text)))
    check = next(c for c in found.checks if c.name == name and c.place.load_case == "case")
    assert check.level is level
    assert check.value == pytest.approx(abs(pull) * 1e3 * 0.4 / RATED, rel=1e-9)
    assert check.limit == pytest.approx(limit)
    said = check_words(check)
    assert level is Level.OK or f"Motor torque {check.value * 100:.0f} % exceeds the" in said


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("200 kW", "200 W", "Rated motor power 0.2 kW is outside the usual"),
        ("20.67", "2.067", "Pulley speed 30.0 m/s does not match belt speed 3 m/s (head)."),
    ],
)
def test_slip_of_unit_of_a_motor_is_asked_about(old: str, new: str, said: str) -> None:
    # 1480 rpm over 2.067 turns a drum of 0.8 m at 30 m/s under a belt of 3 m/s
    text = DRIVE.format(kind="running", pull=60, breakdown=2.5).replace(old, new)
    text = text.replace('width = "1200 mm"', 'width = "1200 mm"\nspeed = "3 m/s"')
    found = judge(solve_train(train_from_text(text), raise_on_failure=False)).checks
    odd = [check_words(c) for c in found if c.name == "usual_sizes" and c.missed]
    assert any(said in sentence for sentence in odd)


def test_drive_that_follows_another_is_not_judged_and_says_so() -> None:
    text = DRIVE.format(kind="running", pull=60, breakdown=2.5)
    pulley = text.partition("[[pulley]]")[2].partition("[train]")[0]
    text = text.replace("[train]", "[[pulley]]" + pulley.replace("head", "tail") + "[train]", 1)
    text = text.replace(
        "[[load_case]]", '[train.motor.tail]\nkind = "follower"\nmaster = "head"\n[[load_case]]'
    )
    found = judge(solve_train(train_from_text(text))).checks
    (check,) = (c for c in found if c.name == "motor_load" and c.place == Place("tail", "design"))
    assert check.level is Level.NOT_CHECKED
    assert check.why == "a follower has no motor rating"


def test_overloaded_motor_leads_the_verdict() -> None:
    text = DRIVE.format(kind="running", pull=95, breakdown=2.5)
    found = in_units(judge(solve_train(train_from_text(text))).text)
    assert found == "Motor torque 142 % exceeds the 100 % rating (head, design)."


def test_a_load_just_over_is_told_apart_from_what_is_allowed() -> None:
    """1.0012 times the rated torque: 100.1 % of it, which in three digits is 100 %."""
    check = motor_load(1.0012, 1.0, False, Place("one", "design"), False, 110e3)
    assert in_units(check.text) == "Motor torque 100.1 % exceeds the 100.0 % rating (one, design)."
    assert in_units(check.action_text) == "Use motors of 111 kW or more (now 110 kW)."


def test_numbers_that_are_alike_are_told_in_few_digits() -> None:
    """No digit tells 8.2 rad/s from what differs in its fifteenth: 78.30 rpm of both."""
    alike = Cell(8.2, "rotation_speed", form="apart", other=8.2 + 1e-14)
    assert in_units(alike) == in_units(quantity(8.2, "rotation_speed"))


def test_only_a_train_that_ends_at_a_motor_says_so() -> None:
    """150 % of torque on a curve that ends at 120 %; what ends otherwise keeps its own words."""
    train = train_from_text(DRIVE.format(kind="running", pull=100, breakdown=1.2))
    case = solve_train(train, raise_on_failure=False).cases[-1]
    for status, begins in (
        (TrainStatus.BEYOND_MOTOR, "Motor torque 150 % exceeds 120 %, the end of its curve (head"),
        (TrainStatus.UNSOLVED, "No solution"),
    ):
        found = of_case(train, replace(case, status=status))
        check = next(c for c in found if c.name == "operating_point")
        assert in_units(check.text).startswith(begins)
        assert check.level is (Level.FAULT if begins == "No solution" else Level.FAILS)
