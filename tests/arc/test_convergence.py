"""The order of convergence, and what the usual mesh is good for.

Expected values: the order of the method (collocation at Gauss's three points has six at the ends
of elements, U. Ascher, R. Mattheij, R. Russell, chapter 5); the solver itself with a 300th of the
misfit let stand; the twin. Friction that begins like the logarithm of slip spoils the order where
slip begins, which the graded mesh spreads but does not remove.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import pytest

from arc.drives import ARC, LAWS, integral_log
from arc.finer import finer
from arc.twin import Twin
from wraparc import load_lagging
from wraparc.arc import Distributed, WrapArc, collocation
from wraparc.arc.collocation import NEWTON, between_tensions, converged, first_course, kinks
from wraparc.arc.meet import interface
from wraparc.batch import Setting, solve_batch
from wraparc.friction import IntegralLog, PressureKnots, TestedRange

SMOOTH = replace(ARC, law=integral_log(0.8, 30e-3))
STEEL = 144e6 * 1.2
QUICK = Distributed(capacities=False, points=18)
#: Sizes of arcs on which more creep hardly brings more friction.
ON_A_PLATEAU: dict[str, Any] = {
    "entry_tension": 21328.5, "diameter": 1.0744, "wrap_angle": 3.133, "width": 0.7249,
    "axial_stiffness": 2.6096e8, "thickness": 15e-3, "shear_modulus": 1.725e6,
    "compression_modulus": 10.626e6,
}  # fmt: skip
BRAKING_HARD: dict[str, Any] = {
    "entry_tension": 921.0, "diameter": 1.0707, "wrap_angle": 4.0963, "width": 0.937,
    "axial_stiffness": 7.812e7, "thickness": 5.0907e-3, "shear_modulus": 1.84e6,
    "compression_modulus": 5.7104e6, "overrun": None,
}  # fmt: skip


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


@pytest.mark.parametrize(
    ("lagging", "g", "sizes"),
    [
        ("medium-ceramic", 0.0105, ON_A_PLATEAU),
        ("full-ceramic", -0.012, BRAKING_HARD),
        ("full-ceramic", -0.0128, BRAKING_HARD),
    ],
)
def test_creep_is_as_accurate_where_tension_hardly_answers_to_it(
    lagging: str, g: float, sizes: dict[str, Any]
) -> None:
    """Of 43 and 230 times the tension at one end: 2.7e-5 on meshes that misfit alone chooses.

    Expected: the twin at this entry creep ratio, for one arc and for rows.
    """
    cover = load_lagging(lagging)
    arc = replace(ARC, law=cover.law, exit_tension=1000.0, **sizes)
    there = Twin(arc).integrate(g)
    arc = replace(arc, exit_tension=arc.entry_tension * math.exp(there.log_tension))
    assert QUICK.solve(arc).exit_creep == pytest.approx(there.creep, rel=1.5e-6)
    table: dict[str, Any] = {
        "belt_width": arc.width,
        "belt_modulus": arc.axial_stiffness / arc.width,
        "lagging_thickness": arc.thickness,
        "entry_tension": [arc.entry_tension],
        "exit_tension": [arc.exit_tension],
    }
    names = ("diameter", "wrap_angle", "shear_modulus", "compression_modulus", "overrun")
    table |= {name: getattr(arc, name) for name in names}
    rows = solve_batch(table, cover, setting=Setting.PRECISE, threads=1)
    assert rows["exit_creep"][0] == pytest.approx(there.creep, rel=1.5e-6)
