"""The steepest slip along an arc, which its speed follows from: against an integration of its own.

Elastic-plastic friction has a kink where the belt begins to slide; the slip is steepest just behind
it, at no point of a mesh.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from arc.drives import PIECEWISE, RUBBER, SOFTENING
from wraparc.arc import Distributed, WrapArc
from wraparc.batch import Setting, solve_batch
from wraparc.checks.of_arc import slip_speed
from wraparc.drive import Lagging
from wraparc.friction import ElasticPlastic, FrictionLaw, TestedRange

FRICTION, STIFFNESS, SPEED = 0.55, 66.7e6, 3.85
WIDE = TestedRange(pressure_min=1e3, pressure_max=5e6, slip_max=0.5, slip_speed=6e-3)
YIELDS = ElasticPlastic(friction_coefficient=FRICTION, stiffness=STIFFNESS, tested=WIDE)
#: Entry and exit tensions [N], diameter [m], wrap angle [rad]; the belt begins to slide on the way.
ARCS = [
    (107e3, 69e3, 1.2044, 3.05),
    (140e3, 107e3, 1.257, 3.04),
    (150e3, 50e3, 0.8, math.pi),
    (60e3, 150e3, 1.0, 3.4),
]


def arc_of(law: FrictionLaw, at: tuple[float, float, float, float]) -> WrapArc:
    entry, leaving, diameter, wrap = at
    return WrapArc(
        law=law, entry_tension=entry, exit_tension=leaving, diameter=diameter, wrap_angle=wrap,
        width=1.28, axial_stiffness=1.28 * 13.6e6, thickness=7.4e-3, shear_modulus=1.6e6,
        compression_modulus=8.1e6, overrun=0.0, belt_speed=SPEED,
    )  # fmt: skip


def steepest_of(arc: WrapArc) -> float:
    """Steepest slip of a driving or braking arc [-]: dT/ds = -B tau, du/ds = g + (T1 - T) C.

    The belt shears lagging and friction in series up to mu p, u = tau (h/G + 1/k), and slides then,
    x = u - h/G mu p. The integration ends where it begins to slide, and goes on from there.
    """
    area, c = arc.width * arc.radius, arc.thickness / arc.shear_modulus
    compliance = arc.compliance
    soft, side, length = c + 1.0 / STIFFNESS, arc.side, arc.radius * arc.wrap_angle

    def growth(g: float, tension: Any) -> Any:
        return g + (arc.entry_tension - tension) * compliance

    def rates(slides: bool, g: float) -> Any:
        def of(_: float, y: Any) -> list[float]:
            stress = side * FRICTION * y[0] / area if slides else y[1] / soft
            return [-arc.width * stress, growth(g, y[0])]

        return of

    def begins(_: float, y: Any) -> float:
        return float(abs(y[1]) / soft - FRICTION * y[0] / area)

    begins.terminal = True  # type: ignore[attr-defined]
    options: dict[str, Any] = {"method": "DOP853", "rtol": 1e-12, "atol": 1e-14}

    def course(g: float) -> tuple[float, float]:
        start = [arc.entry_tension, 0.0]
        part = solve_ivp(rates(False, g), (0.0, length), start, events=begins, **options)
        most = float(np.abs(growth(g, part.y[0])).max()) / (STIFFNESS * soft)
        if part.status == 1:
            start = [float(v) for v in part.y[:, -1]]
            part = solve_ivp(
                rates(True, g), (float(part.t[-1]), length), start,
                t_eval=np.linspace(float(part.t[-1]), length, 4001), **options,
            )  # fmt: skip
            rise = growth(g, part.y[0]) + c * FRICTION**2 * part.y[0] / area / arc.radius
            most = max(most, float(np.abs(rise).max()))
        return float(part.y[0, -1]), most

    solved = Distributed(capacities=False).solve(arc).entry_creep_ratio  # where to look alone
    ends = solved - 0.2 * abs(solved), solved + 0.2 * abs(solved)
    g = brentq(lambda at: course(at)[0] - arc.exit_tension, *ends, xtol=1e-16, rtol=1e-14)
    return course(g)[1]


@pytest.mark.parametrize("at", ARCS)
def test_the_steepest_slip_is_that_of_an_integration_split_at_the_kink(
    at: tuple[float, float, float, float],
) -> None:
    arc = arc_of(YIELDS, at)
    result, expected = Distributed(capacities=False).solve(arc), SPEED * steepest_of(arc)
    assert slip_speed(result) == pytest.approx(expected, rel=1e-6)
    assert rows_of(YIELDS, [at])[0] == pytest.approx(expected, rel=1e-6)


def rows_of(law: FrictionLaw, ats: list[tuple[float, float, float, float]]) -> Any:
    """Return the slip speeds of rows [m/s]."""
    lagging = Lagging(
        name="l", law=law, thickness=7.4e-3, shear_modulus=1.6e6, compression_modulus=8.1e6
    )
    names = "entry_tension", "exit_tension", "diameter", "wrap_angle"
    table = dict(zip(names, np.array(ats).T, strict=True)) | {
        "belt_width": 1.28, "belt_modulus": 13.6e6, "overrun": 0.0, "belt_speed": SPEED,
    }  # fmt: skip
    return solve_batch(table, lagging, setting=Setting.PRECISE, capacities=False).slip_speed


@pytest.mark.parametrize("law", [RUBBER, SOFTENING, PIECEWISE, YIELDS])
def test_rows_have_the_slip_speed_of_single_arcs(law: FrictionLaw) -> None:
    """Twins of each other, for laws with kinks in slip and pressure."""
    tested = replace(law.tested or WIDE, slip_speed=6e-3)
    law = replace(law, tested=tested)  # type: ignore[call-arg]
    rng = np.random.default_rng(7)
    ats = []
    for _ in range(40):
        slack = float(np.exp(rng.uniform(math.log(25e3), math.log(120e3))))
        tight = slack * float(np.exp(rng.uniform(0.2, 1.2)))
        ends = (tight, slack) if rng.random() < 0.8 else (slack, tight)
        ats.append((*ends, float(rng.uniform(0.6, 1.4)), float(rng.uniform(2.8, 4.0))))
    solver = Distributed(capacities=False)
    single = [slip_speed(solver.solve(arc_of(law, at))) for at in ats]
    rows = rows_of(law, ats)
    both = np.isfinite(single) & np.isfinite(rows)
    assert both.sum() > 15
    np.testing.assert_allclose(rows[both], np.array(single)[both], rtol=1e-6)
