"""Reserves: closed forms, the nearest of 1,001 points, and random drives from both sides."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from reserve.follow import faults, level_of, random_results
from wraparc import load_drive, solve
from wraparc.batch import Setting
from wraparc.checks import judge
from wraparc.reserve import Flip, Input, Reserve, find_reserve
from wraparc.reserve.brackets import first_brackets, nears_zero
from wraparc.reserve.confirm import confirm
from wraparc.reserve.divide import divide
from wraparc.reserve.inputs import inputs_of
from wraparc.reserve.levels import level_rows
from wraparc.reserve.uncertainty import uncertainty_of
from wraparc.train.file import drive_or_train_from_document
from wraparc.train.whole import Whole, by_pulley, solved

EXAMPLES = Path(__file__).parents[2] / "examples"
#: How much nearer than it is stated a change may be, of the input [-].
WIDEST = 1.01e-3
WIDTH, SLACK, PULL, FRICTION, WRAP = 1.0, 40e3, 60e3, 0.5, math.pi


def euler(stiffness: str = "20 MPa/mm", **more: Any) -> dict[str, Any]:
    """Return a drive whose friction is constant from a little slip on; nothing shears."""
    pulley = {
        "name": "head",
        "diameter": "1 m",
        "wrap_angle": "180 deg",
        "lagging": "own",
        "exit_tension": f"{SLACK} N",
        "effective_tension": f"{PULL} N",
        "creep_limit": "60 mm",
    }
    belt = {"width": f"{WIDTH} m", "modulus": "20 MN/m", "rating": "160 kN/m"}
    law = {"kind": "elastic-plastic", "friction": FRICTION, "stiffness": stiffness}
    lagging = {"thickness": "0 mm", "law": law}
    standard = {"name": "none"}
    return {
        "format": 1,
        "belt": belt,
        "pulley": [pulley],
        "lagging": {"own": lagging},
        "design_standard": standard,
        "safety_factor": {"running": 1.4},
        "covered": True,
        **more,
    }


def result_of(document: dict[str, Any]) -> Whole:
    return solved(drive_or_train_from_document(document))


def flip_of(reserve: Reserve, name: str, side: float, label: str = "") -> Flip | None:
    """Return the change of an input to one side."""
    found = [f for f in reserve.flips if (f.input.name, f.input.label) == (name, label)]
    return next((f for f in found if f.change * side > 0.0), None)


def change(reserve: Reserve, name: str, side: float, level: str) -> float:
    flip = flip_of(reserve, name, side)
    assert flip is not None
    assert flip.level == level
    return flip.change


def test_the_rating_of_the_belt_is_met_where_the_tension_says() -> None:
    reserve = find_reserve(result_of(euler()))
    assert reserve.level == "OK"
    most = 160.05e3 * WIDTH  # T1 fails where its four digits are above the rating
    assert (most - SLACK - PULL) / SLACK > 1.0  # out of range
    assert flip_of(reserve, "slack_tension", 1.0) is None
    strong = euler(belt={"width": "1 m", "modulus": "20 MN/m", "rating": "125 kN/m"})
    reserve, most = find_reserve(result_of(strong)), 125.05e3 * WIDTH
    found = change(reserve, "slack_tension", 1.0, "FAILS")
    assert found == pytest.approx((most - SLACK - PULL) / SLACK, abs=1e-3)
    assert found >= (most - SLACK - PULL) / SLACK  # the level has changed there


def test_gross_slip_is_met_where_euler_says() -> None:
    reserve = find_reserve(result_of(euler()))
    ratio = 1.0 + 1.3995 * PULL / SLACK  # the safety is missed where its digits are below 1.4
    needed = math.log(ratio) / (FRICTION * WRAP)
    for name in ("friction", "wrap_angle"):
        assert change(reserve, name, -1.0, "ATTENTION") == pytest.approx(needed - 1.0, abs=1e-3)
    most = SLACK * (math.exp(FRICTION * WRAP) - 1.0) / 1.3995
    by_pull = change(reserve, "effective_tension", 1.0, "ATTENTION")
    assert by_pull == pytest.approx(most / PULL - 1.0, abs=1e-3)
    least = 1.3995 * PULL / (math.exp(FRICTION * WRAP) - 1.0)
    by_slack = change(reserve, "slack_tension", -1.0, "ATTENTION")
    assert by_slack == pytest.approx(least / SLACK - 1.0, abs=1e-3)


def test_a_failing_drive_states_both_sides() -> None:
    slips = euler(safety_factor={"running": 3.0})  # it is 2.54: attention
    reserve = find_reserve(result_of(slips))
    assert reserve.level == "ATTENTION"
    passes = math.log(1.0 + 2.9995 * PULL / SLACK) / (FRICTION * WRAP)
    assert change(reserve, "friction", 1.0, "OK") == pytest.approx(passes - 1.0, abs=1e-3)
    fails = math.log(1.0 + PULL / SLACK) / (FRICTION * WRAP)
    assert change(reserve, "friction", -1.0, "FAILS") == pytest.approx(fails - 1.0, abs=1e-3)


def nearest_of(result: Whole, of: Input, points: int = 1001) -> dict[float, tuple[float, str]]:
    """Return the nearest of many points to either side at which the level is another, and that."""
    now, found = judge(result).level, dict[float, tuple[float, str]]()
    for change in sorted(np.linspace(-0.5, 1.0, points).tolist(), key=abs):
        side = math.copysign(1.0, change)
        if side not in found:
            level = level_of(result, of, change)
            if level != now:
                found[side] = change, level
    return found


def window(stiffness: str = "1 MPa/mm") -> Whole:
    """Return a drive that more T2 makes OK, and much more fails by the rating of the belt."""
    belt = {"width": "1 m", "modulus": "20 MN/m", "rating": "125 kN/m"}
    return result_of(euler(stiffness, belt=belt, safety_factor={"running": 3.0}))


def wrapped() -> Whole:
    """Return a drive of which no wrap but those near to its own is OK: of less it slips."""
    pulley = {**euler()["pulley"][0], "wrap_angle": "200 deg"}
    return result_of(euler("1 MPa/mm", pulley=[pulley]))


def rubber() -> Whole:
    """Return a drive that creeps too much, less with more T2 until the tests of its lagging end."""
    pulley = {
        "name": "head",
        "diameter": "0.8 m",
        "wrap_angle": "200 deg",
        "lagging": "diamond-rubber",
        "exit_tension": "40 kN",
        "effective_tension": "75 kN",
    }
    belt = {"width": "1 m", "modulus": "15 MN/m", "rating": "160 kN/m"}
    return result_of(euler(pulley=[pulley], lagging={}, belt=belt))


def slips() -> Whole:
    """Return a drive whose grip is OK with a little more wrap; much more is not plausible."""
    return result_of(euler("1 MPa/mm", safety_factor={"running": 3.0}))


def narrow() -> Whole:
    """Return a drive of which no pressure is tested at its T2, and too high ones with much more."""
    law = {
        "kind": "elastic-plastic", "friction": FRICTION, "stiffness": "1 MPa/mm",
        "tested_pressure": ["130 kPa", "260 kPa"], "tested_slip": "10 mm",
    }  # fmt: skip
    return result_of(euler(lagging={"own": {"thickness": "0 mm", "law": law}}))


#: Drives whose level changes with an input, and back or to a third one.
TURNING = [(window, "slack_tension"), (slips, "wrap_angle"), (narrow, "slack_tension")]


@pytest.mark.parametrize(("drive", "name"), TURNING)
def test_the_way_of_a_level_turns(drive: Callable[[], Whole], name: str) -> None:
    """What a search by halving alone, or by a slope, may miss: better and then worse again."""
    result = drive()
    (of,) = [of for of in inputs_of(by_pulley(result).drive) if of.name == name]
    factors = np.linspace(1.0, 2.0, 41)
    levels = level_rows(result, (of,))
    rank = levels(np.zeros(41, dtype=np.int64), factors, Setting.ENGINEERING).rank
    steps = np.diff(rank)
    assert (steps < 0).any()
    assert (steps > 0).any()


@pytest.mark.parametrize(
    ("drive", "name"), [*TURNING, (wrapped, "wrap_angle"), (rubber, "slack_tension")]
)
def test_the_change_is_the_nearest_of_1001_points(drive: Callable[[], Whole], name: str) -> None:
    result = drive()
    reserve = find_reserve(result)
    (of,) = [of for of in reserve.inputs if of.name == name]
    found, step = nearest_of(result, of), 1.5e-3
    flips = {math.copysign(1.0, f.change): f for f in reserve.flips if f.input == of}
    assert found.keys() == flips.keys() != set()
    for side, (change, level) in found.items():
        assert flips[side].level == level
        assert -WIDEST < abs(change) - abs(flips[side].change) < step + 1e-6


def test_a_window_of_t2_is_found_though_the_end_of_the_range_fails() -> None:
    reserve = find_reserve(window("20 MPa/mm"))
    assert reserve.level == "ATTENTION"
    least = 2.9995 * PULL / (math.exp(FRICTION * WRAP) - 1.0)
    assert change(reserve, "slack_tension", 1.0, "OK") == pytest.approx(least / SLACK - 1, abs=1e-3)


def test_what_rows_do_not_know_is_said() -> None:
    """Not silently wrong: no reserve, and why."""
    constant = {"thickness": "0 mm", "law": {"kind": "constant", "friction": FRICTION}}
    reserve = find_reserve(result_of(euler(lagging={"own": constant})))
    assert (reserve.flips, reserve.reason) == ((), "friction without slip or shear")
    worn = {**euler()["pulley"][0], "across": {"misalignment": "0.6 mm/m"}}
    reserve = find_reserve(result_of(euler(pulley=[worn])))
    assert (reserve.flips, reserve.reason) == ((), "pulley uneven across its width")


def test_random_reserves_hold_from_both_sides() -> None:
    followed = 0
    for number, result in random_results(9, seed=54):
        reserve = find_reserve(result)
        flips = reserve.flips[:: max(1, len(reserve.flips) // 4)]
        followed += len(flips)
        assert [f"drive {number}: {text}" for text in faults(result, reserve, flips)] == []
    assert followed > 15


@pytest.mark.parametrize("name", ["head-drive-fabric", "tandem-fabric", "steel-cord-drive"])
def test_the_solver_of_one_arc_finds_every_change_of_the_line(name: str) -> None:
    """At the change that is stated the level is the stated one, 0.1 % of the input before not yet.

    Expected: the drive with that change, solved arc by arc and judged as every door does.
    """
    result = solve(load_drive(EXAMPLES / f"{name}.toml"))
    reserve = find_reserve(result, every=False)
    assert reserve.flips
    for flip in reserve.flips:
        before = flip.change - math.copysign(min(WIDEST, 0.5 * abs(flip.change)), flip.change)
        assert level_of(result, flip.input, flip.change) == flip.level
        assert level_of(result, flip.input, before) == reserve.level


def test_a_slip_speed_holds_on_a_train_that_divides_its_load() -> None:
    """A law with kinks, beside which the slip is steepest; tensions between pulleys are in no row.

    A steepest slip that was looked for at points of a mesh stated friction 3 % of the change off.
    """
    ((_, result),) = random_results(1, first=151)
    reserve = find_reserve(result)
    assert "friction" in {flip.input.name for flip in reserve.flips}
    assert [*faults(result, reserve, reserve.flips)] == []


def test_a_margin_that_turns_between_points_is_seen() -> None:
    """A parabola that is below 0 between two points only, and one that stays above."""
    factors = 1.0 + np.array([[0.0, 0.1, 0.2, 0.3]])
    lowest = 0.14
    for least, expected in ((-0.001, True), (0.01, False)):
        margins = (factors - 1.0 - lowest) ** 2 + least
        assert (margins > 0.0).all() or not expected
        assert bool(nears_zero(factors, margins).any()) is expected


def test_the_solver_of_one_arc_corrects_what_rows_have_wrong() -> None:
    """Rows moved by 2 %: the change is found anew, at the closed form."""
    result = result_of(euler())
    (friction,) = (of for of in inputs_of(by_pulley(result).drive) if of.name == "friction")
    levels, now = level_rows(result, (friction,)), judge(result).level.rank
    brackets = first_brackets(levels, now)
    assert brackets is not None
    right = divide(levels, brackets, now)
    needed = math.log(1.0 + 1.3995 * PULL / SLACK) / (FRICTION * WRAP)
    for by in (0.02, -0.02):
        none = right.at_far._replace(margins=np.zeros_like(right.at_far.margins))
        near = right.at_near._replace(margins=none.margins)
        wrong = right._replace(near=right.near + by, far=right.far + by, at_near=near, at_far=none)
        found = confirm(levels, wrong, np.array([0]), now)
        assert found.far[0] == pytest.approx(needed, abs=1e-3)
        assert 0.0 < found.near[0] - found.far[0] < 1e-3 + 1e-9


def test_a_belt_by_a_standard_name_may_have_any_modulus_published_of_such_belts() -> None:
    """EP belts: 5 to 12 times their strength of 1000 kN/m about the usual 7.5 (their sheets)."""
    drive = euler(belt={"name": "EP 1000/4", "width": f"{WIDTH} m"})
    found = uncertainty_of(by_pulley(result_of(drive)).drive, Input("belt_modulus"))
    assert (found.lower, found.value) == pytest.approx((1.0 - 5.0 / 7.5, 12.0 / 7.5 - 1.0))
    assert "published 5 to 12" in found.source
    own = euler(belt={"name": "EP 1000/4", "width": f"{WIDTH} m", "modulus": "7500 kN/m"})
    known = uncertainty_of(by_pulley(result_of(own)).drive, Input("belt_modulus"))
    assert known.value == 0.2
