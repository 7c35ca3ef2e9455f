"""Arcs much longer than their shear-lag length under laws that hold the belt.

The layers of the lagging at both ends of a rest arc do not feel one another there, and the solver
leaves what lies between them out. Expected values: the closed form of constant friction; the same
arc as one course without a rest arc, by elements of its whole length; the balance of energy.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from arc.drives import ARC, LAWS
from arc.finer import finer
from wraparc.arc import Distributed, Status, WrapArc, meet
from wraparc.friction import Constant

JUMPS = ("constant", "power", "jump table")
QUICK = Distributed(capacities=False, points=60)
MU = 0.4
LONG = replace(ARC, thickness=0.2e-3, shear_modulus=5e6, axial_stiffness=ARC.axial_stiffness)
SIDES = {"driving": (150e3, 90e3), "braking": (90e3, 150e3)}


def lag_of(arc: WrapArc) -> float:
    return math.sqrt(arc.shear_compliance / (arc.width * arc.compliance))


@pytest.mark.parametrize("side", SIDES)
def test_constant_friction_behind_a_rest_arc(side: str) -> None:
    """The belt is let go at u_r = (h/G) mu p, where T_r = T1/(1 + side mu l/R); it slides the rest.

    From there u' = u_r/l + (T_r - T)/EA' with T = T_r exp(-side mu s/R).
    """
    entry, leaving = SIDES[side]
    arc = replace(LONG, law=Constant(friction_coefficient=MU), entry_tension=entry,
                  exit_tension=leaving)  # fmt: skip
    lag, radius = lag_of(arc), arc.radius
    assert arc.length > 40.0 * lag
    way = arc.side
    begin = entry / (1.0 + way * MU * lag / radius)
    slide = radius / MU * abs(math.log(begin / leaving))
    let_go = way * arc.shear_compliance * MU * begin / (arc.width * radius)
    given = begin * (slide - way * radius / MU * -math.expm1(-way * MU * slide / radius))
    creep = let_go * (1.0 + slide / lag) + arc.compliance * given
    result = QUICK.solve(arc)
    assert result.stuck_arc == pytest.approx((arc.length - slide) / radius, rel=1e-8)
    assert result.exit_creep == pytest.approx(creep, rel=1e-8)
    assert result.energy.identity_error <= 1e-8


@pytest.mark.parametrize("side", SIDES)
@pytest.mark.parametrize("name", JUMPS)
@pytest.mark.parametrize("overrun", [0.0, 1e-7, -1e-7])
def test_one_course_along_the_whole_arc_has_the_same_answer(
    name: str, side: str, overrun: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    arc = replace(
        LONG, law=LAWS[name], entry_tension=SIDES[side][0], exit_tension=SIDES[side][1],
        overrun=overrun,
    )  # fmt: skip
    behind = finer(arc)
    assert behind.rest > 20.0 * lag_of(arc)
    told = QUICK.solve(arc)
    monkeypatch.setattr(meet, "STIFF", math.inf)
    whole, said = finer(arc), QUICK.solve(arc)
    assert whole.done
    assert whole.rest == 0.0
    assert behind.course.creep[-1] == pytest.approx(whole.course.creep[-1], rel=1e-7)
    assert told.exit_slip == pytest.approx(said.exit_slip, rel=1e-6)
    assert told.peak_shear_stress == pytest.approx(said.peak_shear_stress, rel=1e-6)
    assert told.stuck_arc == pytest.approx(said.stuck_arc, rel=1e-5)
    assert told.active_arc == pytest.approx(said.active_arc, rel=1e-5)
    assert told.energy.frictional_energy == pytest.approx(said.energy.frictional_energy, rel=1e-6)
    along = np.interp(told.profile.position, said.profile.position, said.profile.tension)
    assert told.profile.tension == pytest.approx(along, rel=1e-3)


def test_an_overrun_by_formula_in_front_of_a_rest_arc_balances_energy() -> None:
    """It grows with the tension at the entry, which is higher than that behind it."""
    arc = replace(
        LONG, law=Constant(friction_coefficient=MU), overrun=None, compression_modulus=4e6,
        entry_tension=150e3, exit_tension=90e3,
    )  # fmt: skip
    result = QUICK.solve(arc)
    assert result.status is Status.SOLVED
    assert result.stuck_arc > 0.0
    assert result.profile.creep[0] == pytest.approx(arc.entry_overrun, rel=1e-9)
    drop = arc.width * lag_of(arc) / arc.shear_compliance * arc.entry_overrun
    assert drop > 0.0
    assert result.energy.identity_error <= 1e-8


@pytest.mark.parametrize("name", JUMPS)
@pytest.mark.parametrize("entry", [150e3, 149.9e3])
def test_a_belt_that_is_held_all_along(name: str, entry: float) -> None:
    """Shear alone behind the tension: u = u_r e^((s - L)/l), T1 - T2 = B l/(h/G) u_r."""
    arc = replace(LONG, law=LAWS[name], entry_tension=entry, exit_tension=entry - 20.0)
    lag = lag_of(arc)
    creep = 20.0 * arc.shear_compliance / (arc.width * lag)
    result = QUICK.solve(arc)
    assert result.exit_slip == 0.0
    assert result.exit_creep == pytest.approx(creep, rel=1e-9)
    assert result.stuck_arc == pytest.approx(arc.wrap_angle, rel=1e-12)
    s = result.profile.position * arc.radius
    expected = creep * np.exp((s - arc.length) / lag)
    assert result.profile.creep == pytest.approx(expected, abs=1e-9 * creep)


@pytest.mark.parametrize("name", JUMPS)
@pytest.mark.parametrize("surface", [math.inf, 2.3e6])
def test_a_belt_that_nothing_drives_rests_without_stress(name: str, surface: float) -> None:
    arc = replace(ARC, law=LAWS[name], shear_modulus=surface, exit_tension=ARC.entry_tension)
    result = QUICK.solve(arc)
    assert result.status is Status.SOLVED
    assert result.peak_shear_stress == 0.0
    assert result.exit_creep == 0.0
    assert result.stuck_arc == pytest.approx(arc.wrap_angle, rel=1e-12)
    assert not result.profile.shear_stress.any()


@pytest.mark.parametrize("side", [1.0, -1.0])
@pytest.mark.parametrize("pull", [1e-6, 1e-5, 1e-4, 1e-3, 1e-2])
def test_next_to_no_pull_slides_as_far_as_it_takes(pull: float, side: float) -> None:
    """Of a rigid surface: tau = mu p over (R/mu) ln(T1/T2) in front of the exit, rest before it.

    The belt shrinks there by C B mu p s^2/2, next to constant pressure.
    """
    tension = 100e3
    arc = replace(
        ARC, law=Constant(friction_coefficient=MU), shear_modulus=math.inf,
        entry_tension=tension + side * pull, exit_tension=tension,
    )  # fmt: skip
    result = QUICK.solve(arc)
    assert result.status is Status.SOLVED
    # tensions of 1e5 N are known to 1.5e-11 N
    exact = (arc.entry_tension - arc.exit_tension) * side
    slide = exact / (MU * tension)
    within = 1e-6 + 3e-11 / pull
    assert result.active_arc == pytest.approx(0.99 * slide, rel=10.0 * within)
    assert arc.wrap_angle - result.stuck_arc == pytest.approx(slide, abs=slide * within + 2e-15)
    creep = 0.5 * side * arc.compliance * exact * arc.radius * slide
    assert result.exit_creep == pytest.approx(creep, rel=3.0 * within)
    stress = MU * tension / (arc.width * arc.radius)
    assert result.peak_shear_stress == pytest.approx(stress, rel=1e-6)
