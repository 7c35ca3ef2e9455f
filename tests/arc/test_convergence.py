"""The order of convergence, and what the default mesh is good for.

Expected values: the method's own order (sixth, J. C. Butcher 1964), its limit being the twin's
answer. A march that starts at no slip meets the logarithm of the law there, which the graded mesh
spreads but does not remove.
"""

from __future__ import annotations

import math
from dataclasses import replace

import pytest
from wraparc.arc.kernel.search import refine
from wraparc.arc.kernel.tension_march import march
from wraparc.arc.kernel.tension_table import open_table, table_size

from arc.drives import ARC, LAWS, PIECEWISE, RUBBER, SOFTENING, TABLE, integral_log
from arc.twin import Twin
from wraparc.arc import Distributed, WrapArc
from wraparc.arc.kernel.effort import TENSION, Aim, first_guess, mesh_steps
from wraparc.arc.kernel.march import sweep
from wraparc.arc.kernel.quantities import SOLVED, parameters_at, zeros
from wraparc.friction import FrictionLaw, IntegralLog, PressureKnots, TestedRange

SMOOTH = replace(ARC, law=integral_log(0.8, 30e-3))
KICKED = replace(SMOOTH, overrun=3e-5)
STEEL = 144e6 * 1.2


def exit_slip(arc: WrapArc, g: float, steps: int) -> float:
    """Slip at the exit of a march in position at an entry creep ratio."""
    par = parameters_at(arc.entry_tension, arc.geometry())
    return sweep(arc.law.compact(), par, g, steps, 0, [])[0].slip


def orders(arc: WrapArc, g: float, steps: tuple[int, ...]) -> list[float]:
    """Order of the error of the exit slip from each number of steps to the next."""
    limit = exit_slip(arc, g, 1024)
    assert limit == pytest.approx(Twin(arc).integrate(g).slip, rel=2e-9)
    errors = [abs(exit_slip(arc, g, n) / limit - 1) for n in steps]
    pairs = zip(steps, steps[1:], errors, errors[1:], strict=False)
    return [math.log(e / f) / math.log(m / n) for n, m, e, f in pairs]


@pytest.mark.parametrize("g", [3e-4, 1e-3, 2e-3])
def test_sixth_order_where_nothing_is_singular(g: float) -> None:
    assert orders(KICKED, g, (24, 48, 96)) == pytest.approx([6.0, 6.0], abs=0.3)


@pytest.mark.parametrize(
    ("arc", "g"),
    [
        (SMOOTH, 1e-3),
        (replace(SMOOTH, entry_tension=60e3, exit_tension=150e3), -2e-3),
        (replace(SMOOTH, axial_stiffness=STEEL), 4e-3),
    ],
)
def test_at_least_fourth_order_from_the_logarithm_at_the_start(arc: WrapArc, g: float) -> None:
    assert orders(arc, g, (8, 64))[0] > 4.0


@pytest.mark.parametrize("law", [RUBBER, SOFTENING, PIECEWISE, TABLE])
@pytest.mark.parametrize("kick", [0.0, 3e-5])
def test_kinks_of_the_law_do_not_lower_the_order(law: FrictionLaw, kick: float) -> None:
    # in cells of a table a coarser mesh is made finer, and has no order
    coarse = 24 if law is TABLE else 16
    assert orders(replace(ARC, law=law, overrun=kick), 1e-3, (coarse, 64))[0] > 4.0


@pytest.mark.parametrize("name", LAWS)
@pytest.mark.parametrize("kick", [0.0, 2e-5])
@pytest.mark.parametrize("tensions", [(150e3, 70e3), (70e3, 150e3), (150e3, 145e3)])
@pytest.mark.parametrize("stiffness", [12.96e6 * 1.2, STEEL])
def test_the_default_mesh_leaves_1e_6(
    name: str, kick: float, tensions: tuple[float, float], stiffness: float
) -> None:
    # whole solves: of the largest creep on the way
    arc = replace(
        ARC,
        law=LAWS[name],
        overrun=kick,
        entry_tension=tensions[0],
        exit_tension=tensions[1],
        axial_stiffness=stiffness,
    )
    coarse, fine = (Distributed(steps=n, points=18, capacities=False).solve(arc) for n in (24, 96))
    scale = max(abs(fine.exit_creep), kick)
    assert coarse.exit_creep == pytest.approx(fine.exit_creep, abs=1e-6 * scale)
    assert coarse.exit_slip == pytest.approx(fine.exit_slip, abs=1e-6 * scale)


def test_a_step_ends_at_the_peak_of_a_flat_law() -> None:
    """Only the curvature of friction jumps there; expected: the same march on a mesh 32 times as
    fine. A step across the peak leaves 2e-4.
    """
    arc = replace(ARC, law=integral_log(0.6, 3e-4), overrun=1e-4)
    law, par = arc.law.compact(), parameters_at(arc.entry_tension, arc.geometry())
    aim = Aim(TENSION, 1.6 * math.log(arc.entry_tension / arc.exit_tension))
    coarse, fine = (
        refine(law, par, aim, first_guess(law, par, aim), steps)[2] for steps in (24, 768)
    )
    assert coarse.slip > 3e-4
    assert coarse.creep == pytest.approx(fine.creep, rel=1e-6)


@pytest.mark.parametrize("residual", [0.3, 0.75])
def test_above_the_tested_pressures_both_marches_meet(residual: float) -> None:
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
    par, compact, g = parameters_at(arc.entry_tension, arc.geometry()), law.compact(), 0.03
    steps = mesh_steps(compact, par, 48)
    table = zeros(table_size(8.0, steps))
    open_table(compact, par, 8.0, steps, table)
    status, q, _, slip, _, _ = march(compact, par, g, True, table, 0, zeros(0))
    there = Twin(arc).integrate(g)
    assert status == SOLVED
    assert slip == pytest.approx(there.slip, rel=1e-6)
    assert -q == pytest.approx(there.log_tension, rel=1e-6)
    assert exit_slip(arc, g, 96) == pytest.approx(there.slip, rel=1e-6)
