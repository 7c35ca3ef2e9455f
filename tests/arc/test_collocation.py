"""The two-point solver against its own equations, integrated back from the exit.

Expected values: SciPy's LSODA from the exit, where creep and tension are known, back to the entry,
with a step of its own; the closed form of friction without limit (shear alone),
g = (T1 - T2)/(EA' (cosh(L/l) - 1)); the balance of energy, B int tau du = (T1 - T2) (g +
(T1 - T2)/(2 EA')), which holds whatever the law.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

from arc.drives import ARC, LAWS
from arc.finer import energy_miss, finer
from arc.wide import NAMES, wide_arc
from wraparc.arc import Distributed, Status, WrapArc
from wraparc.arc.answer import operating_point
from wraparc.arc.collocation import Course, compliance_of
from wraparc.arc.quantities import SOLVED
from wraparc.arc.traction import traction
from wraparc.errors import InputError
from wraparc.friction import ElasticPlastic

QUICK = Distributed(capacities=False, points=60)
LOOKED_AT = Distributed(capacities=False, points=1000)
DRIVES = 4
REST = 1e-12  # creep of a belt that rests but for rounding of its tensions [m]
BRAKING = replace(ARC, entry_tension=ARC.exit_tension, exit_tension=ARC.entry_tension)


def course_of(arc: WrapArc) -> Course:
    found = operating_point(arc.law.compact(), arc.geometry(), arc.entry_tension, arc.exit_tension)
    assert found.outcome == SOLVED
    assert found.met.rest == 0.0
    return found.met.course


def back_from_the_exit(arc: WrapArc, found: Course) -> tuple[float, float]:
    """Creep [m] and tension [N] at the entry of the arc that ends as a course does."""
    law, shear, area = arc.law.compact(), arc.shear_compliance, arc.width * arc.radius
    c = compliance_of(arc.geometry())

    def rates(_: float, state: NDArray[np.float64]) -> NDArray[np.float64]:
        u, tension = (float(value) for value in state)
        stress = traction(law, shear, tension / area, u).stress
        return np.array([found.ratio - c * tension, -arc.width * stress])

    size = max(map(abs, found.creep))
    back = solve_ivp(
        rates, (arc.length, 0.0), (found.creep[-1], found.tension[-1]), "LSODA",
        rtol=1e-11, atol=(1e-11 * size, 1e-11 * arc.entry_tension), max_step=arc.length / 500.0,
    )  # fmt: skip
    assert back.success
    return float(back.y[0, -1]), float(back.y[1, -1])


@pytest.mark.parametrize("name", LAWS)
@pytest.mark.parametrize("overrun", [0.0, 2e-5, -2e-5])
@pytest.mark.parametrize("of", [ARC, BRAKING], ids=["driving", "braking"])
def test_it_meets_its_own_equations(name: str, overrun: float, of: WrapArc) -> None:
    arc = replace(of, law=LAWS[name], overrun=overrun)
    found = course_of(arc)
    creep, tension = back_from_the_exit(arc, found)
    assert tension == pytest.approx(arc.entry_tension, rel=1e-6)
    assert creep == pytest.approx(overrun, abs=1e-6 * abs(found.creep[-1]))


@pytest.mark.parametrize(
    ("name", "seed"),
    [("jump table", 24), ("jump table", 35), ("jump table", 131), ("any table", 146)],
)
def test_a_braking_belt_that_sticks_behind_its_overrun(name: str, seed: int) -> None:
    """The overrun shears the lagging one way, braking the other: creep turns where it is held."""
    arc = wide_arc(name, np.random.default_rng([7, seed]))
    assert arc.side < 0.0
    assert arc.entry_overrun > 0.0
    result, found = QUICK.solve(arc), course_of(arc)
    assert result.stuck_arc > 0.0
    creep, tension = back_from_the_exit(arc, found)
    assert tension == pytest.approx(arc.entry_tension, rel=1e-8)
    assert creep == pytest.approx(arc.entry_overrun, abs=1e-7 * max(map(abs, found.creep)))


def test_shear_alone_has_its_closed_form() -> None:
    law = ElasticPlastic(stiffness=1e15, friction_coefficient=1e4)
    arc = replace(ARC, law=law, overrun=0.0)
    found = course_of(arc)
    stiff = 1.0 / arc.compliance
    lag = math.sqrt(stiff * arc.shear_compliance / arc.width)
    g = arc.effective_tension / (stiff * (math.cosh(arc.length / lag) - 1.0))
    ratio = found.ratio - compliance_of(arc.geometry()) * arc.entry_tension
    assert ratio == pytest.approx(g, rel=1e-6)


@pytest.mark.parametrize("name", NAMES)
def test_random_drives_balance_energy_and_stay_on_a_finer_mesh(name: str) -> None:
    """Long arcs, soft belts, stiff coatings, driving, braking, idling; breakaways end so.

    The loss is summed along the course at places of its own and meets the balance to 3e-7 of the
    work done without sign: an overrun gives some of it back.
    """
    solved = 0
    for k in range(3 * DRIVES):
        try:
            arc = wide_arc(name, np.random.default_rng([33, NAMES.index(name), k]))
        except InputError:
            continue
        result = LOOKED_AT.solve(arc)
        assert result.status in (Status.SOLVED, Status.BREAKAWAY)
        if result.status is not Status.SOLVED:
            continue
        solved += 1
        fine = finer(arc)
        size = max(abs(result.exit_creep), abs(arc.entry_overrun))
        assert fine.done
        assert result.exit_creep == pytest.approx(fine.course.creep[-1], abs=1e-6 * size + REST)
        assert energy_miss(result) <= 3e-7, (name, k)
    assert solved
