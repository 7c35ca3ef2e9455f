"""The overrun at the entry nip: its formula, and one towards travel.

Expected values: by hand, and tests/arc/twin.py, SciPy's DOP853 on creep and tension.
"""

import math
from dataclasses import replace

import numpy as np
import pytest

from arc.drives import ARC, LAWS, random_arc
from arc.finer import energy_miss
from arc.test_twin import misses
from arc.twin import Twin
from batch.batches import columns_of, lagging
from wraparc.arc import Distributed, Status, WrapArc
from wraparc.arc.summary import overrun_coefficient
from wraparc.batch import solve_arcs
from wraparc.batch.arcs import Arcs
from wraparc.batch.laws import LawBank
from wraparc.errors import InputError
from wraparc.friction import IntegralLog, PressureKnots

SIZE = 1e-4


def test_the_formula() -> None:
    """delta = (h/E_c) p1 = 12 mm/9 MPa x 400 kPa = 0.5333 mm; 1.25 delta sqrt(delta/0.4 m)."""
    delta = 0.012 / 9e6 * 400e3
    found = overrun_coefficient(0.012 / 9e6, 0.4) * 400e3**1.5
    assert found == pytest.approx(1.25 * delta * math.sqrt(delta / 0.4), rel=1e-14)


def test_one_arc_and_a_batch_have_it_from_the_same_function() -> None:
    arc = replace(ARC, overrun=None, compression_modulus=9e6)
    columns = {
        "entry_tension": arc.entry_tension, "exit_tension": arc.exit_tension,
        "diameter": arc.diameter, "wrap_angle": arc.wrap_angle, "belt_width": arc.width,
        "belt_modulus": arc.axial_stiffness / arc.width, "lagging_thickness": arc.thickness,
        "shear_modulus": arc.shear_modulus, "compression_modulus": arc.compression_modulus,
    }  # fmt: skip
    batch = Arcs(
        laws=LawBank.of([arc.law]),
        law=np.zeros(1, dtype=np.int64),
        **{name: np.array([value]) for name, value in columns.items()},
        **dict.fromkeys(("overrun", "belt_speed", "wear_coefficient"), np.array([math.nan])),
        recovery=np.ones(1),
        creep_limit=np.array([arc.creep_limit]),
        **dict.fromkeys(("pitch_offset", "cover_compliance", "centrifugal_force"), np.zeros(1)),
    )
    assert arc.geometry().overrun_coefficient in batch.inputs()[0]
    pressure = arc.entry_pressure
    assert arc.entry_overrun == pytest.approx(
        arc.geometry().overrun_coefficient * pressure**1.5, rel=1e-14
    )


QUICK = Distributed(capacities=False)
BRAKING = replace(ARC, entry_tension=ARC.exit_tension, exit_tension=ARC.entry_tension)


@pytest.mark.parametrize("name", LAWS)
def test_towards_travel_it_is_the_independent_integration(name: str) -> None:
    """Random drives and brakes: creep, slip and peak stress within 1e-5, and the exact loss."""
    rng = np.random.default_rng([5, sorted(LAWS).index(name)])
    for _ in range(6):
        arc = random_arc(LAWS[name], rng)
        held = 0.3e-6 if name in ("constant", "power", "jump table") else 1e-4
        arc = replace(arc, overrun=-min(arc.entry_overrun, held) or -held)
        result = QUICK.solve(arc)
        assert result.status is Status.SOLVED
        _, twin = Twin(arc).solve_near(result.entry_creep_ratio)
        assert max(misses(result, twin).values()) <= 1.0, arc
        assert energy_miss(result) <= 3e-7, arc
        assert result.profile.creep[0] == pytest.approx(arc.overrun, rel=1e-12)


def test_a_rigid_belt_has_it_in_closed_form() -> None:
    """ln(T1/T2) = [Phi(g L - x) - Phi(x)]/(g R) with u = g s - x, Phi = int mu dx."""
    law = IntegralLog(
        coefficients=PressureKnots(pressure=(2e5,), peak_friction=(0.8,), peak_slip=(20e-3,))
    )

    def work(x: float) -> float:
        r = x / 20e-3
        return 0.8 * 20e-3 * (0.75 * r * r - 0.5 * r * r * math.log(r))

    g, size, length = 5e-3, 2e-4, 0.4 * math.pi
    log_ratio = (work(g * length - size) - work(size)) / (g * 0.4)
    arc = replace(
        ARC, law=law, diameter=0.8, wrap_angle=math.pi, axial_stiffness=math.inf, thickness=0.0,
        overrun=-size, entry_tension=100e3, exit_tension=100e3 * math.exp(-log_ratio),
    )  # fmt: skip
    result = QUICK.solve(arc)
    assert result.entry_creep_ratio == pytest.approx(g, rel=1e-6)
    assert result.exit_creep == pytest.approx(g * length - size, rel=1e-6)


def test_towards_travel_it_adds_the_creep_that_one_rearward_saves() -> None:
    rearward, none, forward = (
        QUICK.solve(replace(ARC, overrun=x)).exit_creep for x in (SIZE, 0.0, -SIZE)
    )
    assert rearward < none < forward
    assert forward - none == pytest.approx(none - rearward, rel=0.1)


@pytest.mark.parametrize("arc", [ARC, BRAKING], ids=lambda arc: arc.duty)
def test_the_least_tension_with_it_creeps_to_the_limit(arc: WrapArc) -> None:
    arc = replace(arc, overrun=-SIZE)
    slack = Distributed().solve(arc).capacities.least_exit_tension
    tight = slack + abs(arc.effective_tension)
    pair = (tight, slack) if arc.side > 0.0 else (slack, tight)
    result = QUICK.solve(replace(arc, entry_tension=pair[0], exit_tension=pair[1]))
    assert abs(result.exit_creep) == pytest.approx(arc.creep_limit, rel=1e-6)


def test_what_a_law_that_holds_the_belt_cannot_hold_is_refused() -> None:
    with pytest.raises(InputError, match=r"of 0, where this law starts to slip, got -0.01 m"):
        replace(ARC, law=LAWS["constant"], overrun=-0.01)


def test_a_batch_follows_it() -> None:
    """To the accuracy of its setting, slip that passes zero or not."""
    arcs = [replace(ARC, overrun=-SIZE), replace(ARC, overrun=SIZE)]
    found = solve_arcs(columns_of(arcs, [lagging("one", ARC.law)]), capacities=False)["exit_creep"]
    expected = [QUICK.solve(arc).exit_creep for arc in arcs]
    assert found == pytest.approx(expected, rel=1e-4)
