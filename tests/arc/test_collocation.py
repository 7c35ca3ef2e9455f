"""The two-point formulation of one arc against the marches, and its own equations.

Expected values: `Distributed`, which solves the arc by marches and keeps 1e-5; the closed form of
friction without limit (shear alone), g = (T1 - T2)/(EA' (cosh(L/l) - 1)); SciPy's LSODA from the
exit back to the entry.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

from arc.drives import ARC, LAWS
from arc.wide import NAMES, wide_arc
from wraparc.arc import Distributed, Status, WrapArc
from wraparc.arc.collocation import Course, compliance_of, operating_course
from wraparc.arc.traction import traction
from wraparc.errors import InputError
from wraparc.friction import ElasticPlastic

QUICK = Distributed(capacities=False, points=60)
DRIVES = 4
REST = 1e-12  # creep of a belt that rests but for rounding of its tensions [m]


def course_of(arc: WrapArc) -> tuple[bool, Course]:
    law, geometry = arc.law.compact(), arc.geometry()
    return operating_course(law, geometry, arc.entry_tension, arc.exit_tension)


@pytest.mark.parametrize("name", NAMES)
def test_random_drives_have_the_creep_of_the_marches(name: str) -> None:
    """Long arcs, soft belts, stiff coatings, driving, braking, idling; breakaways end so."""
    place, solved = NAMES.index(name), 0
    for k in range(DRIVES):
        try:
            arc = wide_arc(name, np.random.default_rng([33, place, k]))
        except InputError:
            continue
        expected = QUICK.solve(arc)
        done, found = course_of(arc)
        assert done == (expected.status is Status.SOLVED), (name, k)
        if done:
            size = max(map(abs, found.creep))
            assert found.creep[-1] == pytest.approx(expected.exit_creep, abs=1e-5 * size + REST)
            solved += 1
    assert solved


def test_shear_alone_has_its_closed_form() -> None:
    law = ElasticPlastic(stiffness=1e15, friction_coefficient=1e4)
    arc = WrapArc(**{**vars(ARC), "law": law, "overrun": 0.0})
    done, found = course_of(arc)
    assert done
    stiff = 1.0 / arc.compliance
    lag = math.sqrt(stiff * arc.shear_compliance / arc.width)
    g = arc.effective_tension / (stiff * (math.cosh(arc.length / lag) - 1.0))
    ratio = found.ratio - compliance_of(arc.geometry()) * arc.entry_tension
    assert ratio == pytest.approx(g, rel=1e-6)


@pytest.mark.parametrize("name", ["rubber", "softening", "table", "constant"])
def test_it_meets_its_own_equations(name: str) -> None:
    """Back from the exit, where both states are known, by an integrator with a step of its own."""
    arc = WrapArc(**{**vars(ARC), "law": LAWS[name], "overrun": 0.0})
    law, shear, area = arc.law.compact(), arc.shear_compliance, arc.width * arc.radius
    done, found = course_of(arc)
    assert done

    def rates(_: float, state: NDArray[np.float64]) -> NDArray[np.float64]:
        u, tension = (float(value) for value in state)
        stress = traction(law, shear, tension / area, u).stress
        return np.array([found.ratio - arc.compliance * tension, -arc.width * stress])

    back = solve_ivp(
        rates, (arc.length, 0.0), (found.creep[-1], found.tension[-1]), "LSODA",
        rtol=1e-10, atol=1e-12,
    )  # fmt: skip
    assert back.y[1, -1] == pytest.approx(arc.entry_tension, rel=1e-6)
    assert back.y[0, -1] == pytest.approx(0.0, abs=1e-6 * found.creep[-1])
