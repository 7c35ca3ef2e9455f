"""An arc by its entry tension and exit creep: every side, every law, with its slopes.

Expected values: the operating point between two tensions, met by another end condition; the twin at
the entry creep ratio found; closed forms of belts that rest; central differences for the slopes.
"""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import pairwise

import pytest

from arc.drives import ARC, LAWS
from arc.twin import Twin
from wraparc.arc import WrapArc
from wraparc.arc.answer import operating_point
from wraparc.arc.collocation import MESH
from wraparc.arc.passage import NO_MESH, Passed, passed, slide_slope
from wraparc.arc.profile import entry_ratio
from wraparc.arc.quantities import SOLVED
from wraparc.friction import Constant

PULLS = {"driving": (150e3, 70e3), "braking": (70e3, 150e3), "light": (150e3, 149e3)}
COULOMB = Constant(friction_coefficient=0.4)
HOLDING = {"constant", "power", "elastic-plastic", "jump table"}


def through(arc: WrapArc, entry: float, creep: float, near: Passed | None = None) -> Passed:
    geometry = arc.geometry()._replace(side=math.copysign(1.0, creep))
    return passed(arc.law.compact(), geometry, entry, creep, near.met if near else None, MESH)


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("pull", PULLS)
@pytest.mark.parametrize("overrun", [0.0, 2e-5, -2e-5])
def test_it_is_the_operating_point_of_its_tensions(law: str, pull: str, overrun: float) -> None:
    entry, leaving = PULLS[pull]
    if law in HOLDING:
        overrun = 0.0
    arc = replace(ARC, law=LAWS[law], entry_tension=entry, exit_tension=leaving, overrun=overrun)
    geometry = arc.geometry()
    outcome, met = operating_point(arc.law.compact(), geometry, entry, leaving)
    assert outcome == SOLVED
    found = through(arc, entry, met.course.creep[-1])
    assert found.met.done
    assert found.leaving == pytest.approx(leaving, rel=1e-7)
    assert found.ratio == pytest.approx(entry_ratio(geometry, met), abs=2e-9)


@pytest.mark.parametrize("law", ["rubber", "softening", "pieces", "table"])
@pytest.mark.parametrize("creep", [-4e-3, -1e-4, 2e-4, 6e-3, 30e-3])
def test_it_is_the_march_of_the_twin(law: str, creep: float) -> None:
    """From the entry at the creep ratio found, to past the peak of friction."""
    arc = replace(ARC, law=LAWS[law], overrun=0.0)
    if creep < 0.0:
        arc = replace(arc, entry_tension=70e3, exit_tension=150e3)
    found = through(arc, arc.entry_tension, creep)
    there = Twin(arc).integrate(found.ratio)
    assert math.log(found.leaving / arc.entry_tension) == pytest.approx(
        there.log_tension, rel=1e-6, abs=1e-9
    )


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("creep", [-3e-3, -2e-5, 3e-5, 5e-3])
def test_slopes_are_those_of_differences(law: str, creep: float) -> None:
    arc = replace(ARC, law=LAWS[law], overrun=None if law not in HOLDING else 0.0)
    entry = 100e3
    here = through(arc, entry, creep)
    assert here.met.done
    # differences on one mesh: a mesh that adapts would show in them
    law_of, du, da = arc.law.compact(), 1e-4 * abs(creep), 1e-4 * entry
    geometry = arc.geometry()._replace(side=math.copysign(1.0, creep))

    def at(a: float, u: float) -> Passed:
        first = passed(law_of, geometry, a, u, here.met, NO_MESH)
        return passed(law_of, geometry, a, u, first.met, NO_MESH)

    more, less = at(entry, creep + du), at(entry, creep - du)
    tight, slack = at(entry + da, creep), at(entry - da, creep)
    size = max(abs(here.leaving - entry), 1.0)
    assert here.leaving_by_creep * du == pytest.approx(
        0.5 * (more.leaving - less.leaving), rel=2e-3, abs=1e-7 * size
    )
    assert here.ratio_by_creep * du == pytest.approx(0.5 * (more.ratio - less.ratio), rel=2e-3)
    assert here.leaving_by_entry == pytest.approx(
        0.5 * (tight.leaving - slack.leaving) / da, rel=2e-3
    )
    scale = abs(arc.geometry().compliance)
    assert here.ratio_by_entry == pytest.approx(
        0.5 * (tight.ratio - slack.ratio) / da, rel=2e-3, abs=2e-3 * scale
    )


@pytest.mark.parametrize("law", LAWS)
def test_the_ratio_rises_and_the_tension_falls_with_creep(law: str) -> None:
    """From braking to driving without a step, where friction does not fall."""
    arc = replace(ARC, law=LAWS[law], overrun=0.0)
    creeps = [s * 10.0**e for s in (-1.0, 1.0) for e in (-6.0, -5.0, -4.0, -3.0, -2.5, -2.0)]
    found = [through(arc, 100e3, creep) for creep in sorted(creeps)]
    assert all(b.ratio > a.ratio for a, b in pairwise(found))
    if law not in ("softening", "pieces", "table"):
        assert all(b.leaving < a.leaving for a, b in pairwise(found))


def test_a_slide_behind_a_rest_arc_is_a_parabola() -> None:
    """Nothing shears: u(L) = C (T(0) - T(L))^2/(2 B tau) where the slide is short."""
    arc = replace(ARC, law=COULOMB, shear_modulus=math.inf, overrun=0.0)
    geometry, law = arc.geometry(), arc.law.compact()
    entry = 100e3
    stress = 0.4 * entry / (arc.width * arc.radius)
    slope = slide_slope(law, geometry, entry)
    assert slope == pytest.approx(math.sqrt(2.0 * arc.width * stress / geometry.compliance))
    creep = (1e-4 * entry / slope) ** 2
    found = through(arc, entry, creep)
    assert found.met.rest > 0.9 * arc.length
    assert found.ratio == 0.0
    assert (entry - found.leaving) / entry == pytest.approx(1e-4, rel=2e-4)
    assert found.leaving_by_creep == pytest.approx(-0.5 * slope / math.sqrt(creep), rel=2e-4)


@pytest.mark.parametrize("creep", [1e-3, 5e-3])
def test_a_slide_of_constant_friction(creep: float) -> None:
    """Nothing shears: T = T1 e^(-mu s/R) behind the rest arc, u(L) = C (T1 s - T1 R (1 - e)/mu)."""
    arc = replace(ARC, law=COULOMB, shear_modulus=math.inf, overrun=0.0)
    found = through(arc, 150e3, creep)
    compliance, radius = arc.geometry().compliance, arc.radius
    slide = arc.length - found.met.rest
    left = math.exp(-0.4 * slide / radius)
    assert found.leaving == pytest.approx(150e3 * left, rel=1e-9)
    expected = compliance * 150e3 * (slide - radius / 0.4 * (1.0 - left))
    assert creep == pytest.approx(expected, rel=1e-9)


def test_a_thin_coating_holds_the_belt() -> None:
    """Much longer than l: T1 - T2 = B u_2 l/c while shear alone takes the creep up."""
    arc = replace(ARC, law=COULOMB, thickness=1e-5, shear_modulus=1e7, overrun=0.0)
    geometry = arc.geometry()
    lag = math.sqrt(geometry.shear / (arc.width * geometry.compliance))
    assert arc.length > 100.0 * lag
    held = geometry.shear * 0.4 * 150e3 / (arc.width * arc.radius)
    found = through(arc, 150e3, 0.5 * held)
    taken = arc.width * lag / geometry.shear
    assert found.leaving == pytest.approx(150e3 - taken * 0.5 * held, rel=1e-12)
    assert found.leaving_by_creep == pytest.approx(-taken, rel=1e-12)
    assert found.ratio == 0.0
    # a little more creep than shear takes up: the belt slides behind its rest arc
    sliding = through(arc, 150e3, 1.5 * held)
    assert 0.0 < sliding.met.rest < arc.length
    assert sliding.leaving < found.leaving
    step = 1e-4 * held
    up, down = (through(arc, 150e3, 1.5 * held + s, sliding) for s in (step, -step))
    assert sliding.leaving_by_creep == pytest.approx(
        0.5 * (up.leaving - down.leaving) / step, rel=1e-3
    )
    tight, slack = (through(arc, 150e3 + s, 1.5 * held, sliding) for s in (15.0, -15.0))
    assert sliding.leaving_by_entry == pytest.approx(
        (tight.leaving - slack.leaving) / 30.0, rel=1e-5
    )
