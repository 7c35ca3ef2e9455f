"""The order of convergence, and what the usual mesh is good for.

Expected values: the order of the method (collocation at Gauss's three points has six at the ends
of elements, U. Ascher, R. Mattheij, R. Russell, chapter 5); the solver itself with a 300th of the
misfit let stand; the twin. Friction that begins like the logarithm of slip spoils the order where
slip begins, which the graded mesh spreads but does not remove.
"""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from arc.drives import ARC, LAWS, integral_log
from arc.finer import finer
from arc.twin import Twin
from wraparc.arc import Distributed, WrapArc, collocation
from wraparc.arc.collocation import NEWTON, between_tensions, converged, first_course, kinks
from wraparc.arc.meet import interface
from wraparc.friction import IntegralLog, PressureKnots, TestedRange

SMOOTH = replace(ARC, law=integral_log(0.8, 30e-3))
STEEL = 144e6 * 1.2
QUICK = Distributed(capacities=False, points=18)


def exit_creep(arc: WrapArc, elements: int, patch: pytest.MonkeyPatch) -> float:
    """Exit creep on a mesh s = L (i/n)^2 that stays."""
    patch.setattr(collocation, "FIRST_ELEMENTS", elements)
    geometry, face = arc.geometry(), interface(arc.law.compact(), arc.geometry())
    guess = (arc.entry_tension, arc.exit_tension, QUICK.solve(arc).exit_creep)
    start = first_course(geometry, arc.length, *guess)
    ends = between_tensions(arc.entry_tension, arc.exit_tension)
    done, found, _ = converged(face, geometry, ends, start, 20, NEWTON)
    assert done
    assert len(found.creep) == elements + 1
    return found.creep[-1]


@pytest.mark.parametrize("braking", [False, True])
def test_sixth_order_where_nothing_is_singular(
    braking: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    arc = replace(SMOOTH, overrun=1e-4)  # slip does not pass through zero
    if braking:
        arc = replace(SMOOTH, entry_tension=60e3, exit_tension=150e3, overrun=-1e-4)
    limit = exit_creep(arc, 128, monkeypatch)
    coarse, fine = (abs(exit_creep(arc, n, monkeypatch) - limit) for n in (8, 16))
    assert math.log2(coarse / fine) == pytest.approx(6.0, abs=0.3)


@pytest.mark.parametrize("name", LAWS)
@pytest.mark.parametrize("overrun", [0.0, 2e-5, -2e-5])
@pytest.mark.parametrize("tensions", [(150e3, 70e3), (70e3, 150e3), (150e3, 145e3)])
@pytest.mark.parametrize("stiffness", [12.96e6 * 1.2, STEEL])
def test_the_usual_mesh_leaves_3e_7(
    name: str, overrun: float, tensions: tuple[float, float], stiffness: float
) -> None:
    """Of the largest creep on the way, and of slip."""
    arc = replace(
        ARC, law=LAWS[name], overrun=overrun, axial_stiffness=stiffness,
        entry_tension=tensions[0], exit_tension=tensions[1],
    )  # fmt: skip
    usual, fine = QUICK.solve(arc), finer(arc)
    assert fine.done
    scale = max(abs(usual.exit_creep), abs(overrun))
    assert usual.exit_creep == pytest.approx(fine.course.creep[-1], abs=3e-7 * scale)


def test_elements_end_at_the_peak_of_a_flat_law() -> None:
    """Only the curvature of friction jumps there: an element across the peak leaves 2e-4."""
    arc = replace(ARC, law=integral_log(0.6, 3e-4), overrun=1e-4)
    found = finer(arc, collocation.MESH)
    assert QUICK.solve(arc).exit_slip > 3e-4
    places = found.course.place
    peaks = [where for where, _ in kinks(found.face, arc.geometry(), found.course)]
    assert peaks
    for where in peaks:
        assert min(abs(where - s) for s in places) <= 1e-6 * arc.length
    fine = finer(arc).course
    assert found.course.creep[-1] == pytest.approx(fine.creep[-1], rel=1e-7)


@pytest.mark.parametrize("residual", [0.3, 0.75])
def test_above_the_tested_pressures_the_slopes_are_those_of_the_law(residual: float) -> None:
    """On the line past the peak and on the residual friction, whose slopes by pressure end there.

    Expected: the twin at the same entry creep ratio.
    """
    law = IntegralLog(
        coefficients=PressureKnots(
            pressure=(1e5, 2e5),
            peak_friction=(0.8, 0.8),
            peak_slip=(3e-3, 3e-3),
            post_peak_slope=(-30.0, -10.0),
            residual_friction=(residual - 0.2, residual),
        ),
        tested=TestedRange(pressure_min=1e5, pressure_max=2e5, slip_max=1e-2),
    )
    arc = replace(
        ARC, law=law, entry_tension=8e5 * 0.5 * ARC.diameter * ARC.width, exit_tension=1e5,
        wrap_angle=0.6,
    )  # fmt: skip
    there = Twin(arc).integrate(0.03)
    arc = replace(arc, exit_tension=arc.entry_tension * math.exp(there.log_tension))
    found = QUICK.solve(arc)
    assert found.entry_creep_ratio == pytest.approx(0.03, rel=1e-6)
    assert found.exit_slip == pytest.approx(there.slip, rel=1e-6)
