"""Inputs that are no factor on an arc: take-up place, start factor, carcass of a belt."""

from __future__ import annotations

import math
from typing import Any

import pytest

from reserve.follow import changed_drive, faults
from reserve.test_find import FRICTION, WRAP, change, euler, flip_of, result_of
from reserve.test_stated_of_cases import level
from wraparc.answer.reserve_check import judge_uncertain
from wraparc.checks import Level
from wraparc.drive import Drive
from wraparc.files import drive_from_document
from wraparc.reserve import Input, find_probability, find_reserve, uncertainty_of
from wraparc.reserve.inputs import CARCASS, START, TAKE_UP_PLACE, inputs_of
from wraparc.reserve.keys import ReserveKeys
from wraparc.reserve.uncertainty import PUBLISHED, STATED
from wraparc.train.whole import by_pulley
from wraparc.units import in_units

#: Te = C f g L 156 kg/m of the level conveyor, and what its return strand takes a metre.
G = 9.80665
PULL = 1.12 * 0.022 * G * 800.0 * (20.0 + 18.0 + 20.0 + 8.0 + 90.0)
RETURN = 0.022 * G * (20.0 + 8.0)
#: m v^2, and T2 above it with a safety of 1.4 on gross slip, missed where four digits are less
#: (Euler).
FLYING = 20.0 * 3.0**2
LEAST = 1.3995 * PULL / math.expm1(FRICTION * WRAP)


def conveyed(**conveyor: Any) -> dict[str, Any]:
    given = level()
    del given["conveyor"]["uncertainty"]
    given["conveyor"] |= {"return_share": 0.0, **conveyor}
    return given


def names(drive: Drive) -> set[str]:
    return {of.name for of in inputs_of(drive)}


def test_the_take_up_place_is_met_where_the_return_strand_says() -> None:
    """T2 at the head is that of the take-up less what the strand between them takes."""
    away = 300.0
    held = FLYING + LEAST + RETURN * away * 1.25
    given = conveyed(take_up_tension=f"{held} N", take_up_distance=f"{away} m")
    result = result_of(given)
    reserve = find_reserve(result)
    assert reserve.level == "OK"
    assert change(reserve, TAKE_UP_PLACE, 1.0, "ATTENTION") == pytest.approx(0.25, abs=1e-3)
    flips = tuple(flip for flip in reserve.flips if flip.input.name == TAKE_UP_PLACE)
    assert [*faults(result, reserve, flips)] == []
    (key,) = ReserveKeys.of(result).changes(Input(TAKE_UP_PLACE), 1.2)
    assert (key.key, key.unit) == ("conveyor.take_up_distance", "m")
    assert key.after == pytest.approx(1.2 * away)
    assert names(drive_from_document(conveyed(take_up_tension="40 kN"))) & {TAKE_UP_PLACE} == set()


def test_the_start_factor_is_met_where_the_pull_of_the_start_says() -> None:
    given = conveyed(take_up_tension=f"{FLYING + 1.5 * LEAST} N", start_factor=1.25)
    given["safety_factor"]["starting"] = 1.4
    result = result_of(given)
    reserve = find_reserve(result)
    found = change(reserve, START, 1.0, "ATTENTION")
    assert found == pytest.approx(1.5 / 1.25 - 1.0, abs=1e-3)
    flip = flip_of(reserve, START, 1.0)
    assert flip is not None
    assert flip.load_case == "start"
    assert [*faults(result, reserve, (flip,))] == []
    given["conveyor"]["uncertainty"] = {"start_factor": "25 %"}
    stated = uncertainty_of(by_pulley(result_of(given)).drive, Input(START))
    assert (stated.value, stated.kind) == (0.25, STATED)


def named(**belt: Any) -> dict[str, Any]:
    return euler("2 MPa/mm", belt={"name": "EP 1000/4 6+3", "width": "1 m", **belt})


def test_a_carcass_by_a_standard_name_may_have_any_thickness_published() -> None:
    """Plies of EP: 0.8 to 1.4 times the thickness by their strength (makers' sheets)."""
    drive = drive_from_document(named())
    found = uncertainty_of(drive, Input(CARCASS))
    assert found.kind == PUBLISHED
    assert (found.lower, found.value) == pytest.approx((0.2, 0.4))
    assert "published 0.8 to 1.4" in found.source
    assert CARCASS in names(drive)
    for own in ({"carcass": "5 mm"}, {"thickness": "14 mm"}):
        assert CARCASS not in names(drive_from_document(named(**own)))
    cords = drive_from_document(euler(belt={"name": "ST 1600 6+6", "width": "1 m"}))
    found = uncertainty_of(cords, Input(CARCASS))
    assert (found.lower, found.value) == pytest.approx((0.08, 0.08))


def test_the_change_of_a_carcass_holds_from_both_sides() -> None:
    """More belt between lagging and cords, more torque arm: the speed ratio and the arc change."""
    result = result_of(named())
    drive = by_pulley(result).drive
    thick = changed_drive(drive, Input(CARCASS), 0.4)
    assert thick.belt.carcass == pytest.approx(1.4 * (drive.belt.carcass or 0.0))
    reserve = find_reserve(result)
    (key,) = ReserveKeys.of(result).changes(Input(CARCASS), 1.4)
    assert (key.key, key.after) == ("belt.carcass", thick.belt.carcass)
    flips = tuple(flip for flip in reserve.flips if flip.input.name == CARCASS)
    assert [*faults(result, reserve, flips)] == []


@pytest.mark.parametrize(("limit", "expected"), [(0.9, Level.ATTENTION), (1.1, Level.OK)])
def test_the_published_band_of_a_standard_belt_counts_in_the_level(
    limit: float, expected: Level
) -> None:
    """The creep limit is about that at the least modulus published, 5 of 7.5 times the strength."""
    given = named()
    drive = by_pulley(result_of(given)).drive
    weak = changed_drive(drive, Input("belt_modulus"), 5.0 / 7.5 - 1.0)
    creep = abs(find_creep(weak))
    least = abs(find_creep(drive))
    given["pulley"][0]["creep_limit"] = f"{1e3 * (least + limit * (creep - least))} mm"
    result = result_of(given)
    verdict = judge_uncertain(result)
    (check,) = (check for check in verdict.checks if check.name == "reserve")
    assert check.level is expected
    assert verdict.level is expected
    if expected is Level.ATTENTION:
        assert in_units(check.headline).startswith("Belt modulus -30 % changes the verdict")
        assert "published 5 to 12" in check.source
    own = named(modulus="7.5 MN/m")
    own["pulley"][0]["creep_limit"] = given["pulley"][0]["creep_limit"]
    assert judge_uncertain(result_of(own)).level is Level.OK


def find_creep(drive: Drive) -> float:
    from wraparc import solve

    return float(solve(drive).governing.exit_creep)


def test_draws_leave_out_what_is_no_factor() -> None:
    """Of a conveyor and a standard belt: said in the documentation."""
    given = conveyed(take_up_tension="40 kN", take_up_distance="300 m", start_factor=1.3)
    given["belt"] = {"name": "EP 1000/4 6+3", "width": "1 m", "speed": "3 m/s", "mass": "20 kg/m"}
    found = find_probability(result_of(given))
    assert {of.name for of, _ in found.inputs} & {CARCASS, START, TAKE_UP_PLACE} == set()
