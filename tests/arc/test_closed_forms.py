"""The solver against everything that can be solved by hand.

Expected values: closed forms, derived from the equations of the page on the model; the tolerance
stated with each is that of the form itself where it is an approximation, else that of the solver.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

from arc.drives import ARC, LAWS, RUBBER, SOFTENING, integral_log, random_arc
from wraparc.arc import ArcResult, Distributed, Status, WrapArc
from wraparc.friction import (
    Constant,
    FrictionLaw,
    IntegralLog,
    MeasuredTable,
    PressureKnots,
    PressurePower,
    TestedRange,
)

EXACT = 1e-6  # relative; the solver itself is better by up to five digits, see test_convergence

LAG = math.sqrt(ARC.shear_compliance / (ARC.width * ARC.compliance))  # shear-lag length l


def solve(arc: WrapArc, capacities: bool = False) -> ArcResult:
    result = Distributed(capacities=capacities).solve(arc)
    assert result.status is Status.SOLVED
    return result


def friction_integral(
    u: NDArray[np.float64], peak: float, slip: float, slope: float, residual: float
) -> NDArray[np.float64]:
    """Phi = int mu dx from 0 of that law: even in slip."""
    u = np.abs(u)
    r = np.where(u > 0.0, np.minimum(u, slip) / slip, 1e-300)
    rise = peak * slip * (0.75 * r**2 - 0.5 * r**2 * np.log(r))
    end = (min(residual, peak) - peak) / slope if slope < 0.0 else math.inf
    d = np.clip(u - slip, 0.0, end)
    beyond = np.maximum(u - slip - end, 0.0)
    return rise + peak * d + 0.5 * slope * d**2 + min(residual, peak) * beyond


# --- constant friction -------------------------------------------------------------------------


@pytest.mark.parametrize("braking", [False, True])
def test_constant_friction_without_shear(braking: bool) -> None:
    # rest arc at the entry with T = T1, slip arc ln(T1/T2)/mu at the exit
    arc = replace(ARC, thickness=0.0)
    if braking:
        arc = replace(arc, entry_tension=60e3, exit_tension=150e3)
    result = solve(arc)
    t1, t2, mu = arc.entry_tension, arc.exit_tension, 0.4
    slipping = abs(math.log(t1 / t2)) / mu
    creep = arc.radius * arc.compliance * (slipping * t1 - (t1 - t2) / (mu * arc.side))
    assert result.stuck_arc == pytest.approx(math.pi - slipping, rel=EXACT)
    assert result.exit_creep == pytest.approx(creep, rel=EXACT)
    assert result.exit_slip == pytest.approx(creep, rel=EXACT)
    assert abs(result.entry_creep_ratio) < 1e-12
    # stress sets in at once where the belt begins to slip, at the entry tension if it drives
    peak = mu * max(t1, t2) / (arc.radius * arc.width)
    assert result.peak_shear_stress == pytest.approx(peak, rel=1e-12)
    begins = math.pi if braking else math.pi - slipping
    assert result.peak_shear_position == pytest.approx(begins, rel=EXACT)
    rest = result.profile.position < result.stuck_arc * (1 - 1e-9)
    assert np.all(result.profile.tension[rest] == t1)
    assert np.all(result.profile.sliding[rest] == 0.0)


def test_constant_friction_with_shear() -> None:
    # exact but for e^(-s/l) at the end of the stuck zone: of a thin lagging
    arc = replace(ARC, thickness=0.2e-3, recovery=False, exit_tension=100e3)
    t1, t2, mu = arc.entry_tension, arc.exit_tension, 0.4
    lag = math.sqrt(arc.shear_compliance * arc.axial_stiffness / arc.width)
    junction = t1 / (1 + mu * lag / arc.radius)
    slipping = math.log(junction / t2) / mu
    assert math.exp(-(math.pi - slipping) * arc.radius / lag) < 1e-8
    stress = mu * arc.wrap_pressure(junction)
    creep = arc.shear_compliance * stress
    creep += arc.radius / arc.axial_stiffness * (slipping * t1 - (junction - t2) / mu)
    result = solve(arc)
    assert result.stuck_arc == pytest.approx(math.pi - slipping, rel=EXACT)
    assert result.exit_creep == pytest.approx(creep, rel=EXACT)
    assert result.peak_shear_stress == pytest.approx(stress, rel=EXACT)
    assert result.peak_shear_position == pytest.approx(math.pi - slipping, rel=EXACT)


def test_published_flat_belt_drive() -> None:
    """Two pulleys and a flat belt: a published transient finite-element simulation.

    Its steady state: slip arc 2.470 rad, exit creep 9.05 mm. By hand with the closed form above
    2.474 rad and 8.913 mm: the simulation keeps the strain of 8 % that the equations take as small.
    """
    arc = WrapArc(
        law=Constant(friction_coefficient=0.5),
        entry_tension=656.17,
        exit_tension=186.27,
        diameter=0.2,
        wrap_angle=math.pi,
        width=0.08,
        axial_stiffness=8000.0,
        thickness=1e-3,
        shear_modulus=5e6,  # G/h = 5e9 N/m3
        overrun=0.0,
    )
    result = solve(arc)
    slipping = math.pi - result.stuck_arc
    lag = math.sqrt(8000 / (0.08 * 5e9))
    junction = 656.17 / (1 + 0.5 * lag / 0.1)
    assert slipping == pytest.approx(math.log(junction / 186.27) / 0.5, rel=EXACT)
    assert slipping == pytest.approx(2.474, abs=5e-4)
    assert slipping == pytest.approx(2.470, rel=2e-3)
    assert result.exit_creep == pytest.approx(8.913e-3, abs=5e-7)
    assert result.exit_creep == pytest.approx(9.05e-3, rel=0.016)


@pytest.mark.parametrize("overrun", [0.0, 2e-5])
@pytest.mark.parametrize("exit_tension", [60e3, 149e3, 150e3, 300e3])
def test_shear_only(exit_tension: float, overrun: float) -> None:
    # friction without limit: u = x_c cosh(s/l) + g l sinh(s/l),
    # T1 - T = (EA'/l)(x_c sinh(s/l) + g l (cosh(s/l) - 1))
    law = Constant(friction_coefficient=1e6)
    arc = replace(ARC, law=law, exit_tension=exit_tension, overrun=overrun)
    stretch = arc.length / LAG
    pull = arc.effective_tension * arc.compliance
    g = (pull - overrun / LAG * math.sinh(stretch)) / (math.cosh(stretch) - 1)
    result = solve(arc)
    # g is what two parts leave, and no better than either
    assert result.entry_creep_ratio == pytest.approx(g, rel=EXACT, abs=0.1 * EXACT * overrun / LAG)
    s = result.profile.position * arc.radius
    creep = overrun * np.cosh(s / LAG) + g * LAG * np.sinh(s / LAG)
    scale = float(np.max(np.abs(creep))) + 1e-12
    assert result.profile.creep == pytest.approx(creep, abs=EXACT * scale)
    assert result.profile.slip == pytest.approx(0.0, abs=1e-9 * scale)
    drop = overrun / LAG * np.sinh(s / LAG) + g * (np.cosh(s / LAG) - 1)
    tension = arc.entry_tension - drop / arc.compliance
    assert result.profile.tension == pytest.approx(tension, rel=EXACT)
    if overrun == 0.0:
        stress = arc.effective_tension / (arc.width * LAG) / math.tanh(stretch / 2)
        assert result.profile.shear_stress[-1] == pytest.approx(stress, rel=EXACT)


# --- friction free of pressure -----------------------------------------------------------------

FREE_LAWS = {
    "rising": (0.8, 30e-3, 0.0, 9.0),
    "past the peak": (0.7, 3e-3, 0.0, 9.0),
    "softening": (0.7, 3e-3, -25.0, 0.6),
}


@pytest.mark.parametrize("numbers", FREE_LAWS.values(), ids=FREE_LAWS.keys())
@pytest.mark.parametrize("overrun", [0.0, 3e-5])
@pytest.mark.parametrize("tensions", [(150e3, 60e3), (80e3, 200e3), (150e3, 149.9e3)])
def test_first_integral_at_every_point(
    numbers: tuple[float, float, float, float], overrun: float, tensions: tuple[float, float]
) -> None:
    # (g + e) q - e (exp(q) - 1) = -(Phi(u) - Phi(x_c))/R, e = T1/EA', q = ln(T/T1), h/G = 0
    entry, exit_ = tensions
    arc = replace(
        ARC,
        law=integral_log(*numbers),
        entry_tension=entry,
        exit_tension=exit_,
        overrun=overrun,
        shear_modulus=math.inf,
    )
    result = Distributed(capacities=False).solve(arc)
    assert result.status is Status.SOLVED
    g, e = result.entry_creep_ratio, arc.entry_tension * arc.compliance
    q = np.log(result.profile.tension / arc.entry_tension)
    left = (g + e) * q - e * np.expm1(q)
    start = friction_integral(np.array([overrun]), *numbers)
    right = -(friction_integral(result.profile.creep, *numbers) - start) / arc.radius
    scale = float(np.max(np.abs(right)))
    assert left == pytest.approx(right, abs=EXACT * scale)
    assert result.profile.slip == pytest.approx(result.profile.creep, abs=1e-15)


@pytest.mark.parametrize("numbers", FREE_LAWS.values(), ids=FREE_LAWS.keys())
@pytest.mark.parametrize("braking", [False, True])
def test_rigid_belt(numbers: tuple[float, float, float, float], braking: bool) -> None:
    # T1/T2 = exp(int mu(g R theta) d theta) = exp(Phi(g L)/(g R)); creep g R theta
    tensions = (60e3, 130e3) if braking else (130e3, 60e3)
    arc = replace(
        ARC,
        law=integral_log(*numbers),
        entry_tension=tensions[0],
        exit_tension=tensions[1],
        axial_stiffness=math.inf,
        thickness=0.0,
    )
    result = solve(arc)
    g = abs(result.entry_creep_ratio)
    creep = result.profile.creep * arc.side
    assert creep == pytest.approx(g * arc.radius * result.profile.position, rel=EXACT)
    exponent = friction_integral(np.array([g * arc.length]), *numbers)[0] / (g * arc.radius)
    assert exponent == pytest.approx(math.log(130 / 60), rel=EXACT)


# --- capacity at gross slip --------------------------------------------------------------------

RANGE = TestedRange(pressure_min=50e3, pressure_max=500e3, slip_max=0.01)
LOW, HIGH = 0.6, 0.3  # friction at the ends of that range: mu = m0 + m1 p between
M1 = (HIGH - LOW) / (500e3 - 50e3)
M0 = LOW - M1 * 50e3


def gross(law: FrictionLaw, entry: float, exit_: float) -> float:
    arc = replace(ARC, law=law, entry_tension=entry, exit_tension=exit_)
    return solve(arc, capacities=True).capacities.gross_slip_capacity


@pytest.mark.parametrize(("entry", "exit_"), [(150e3, 100e3), (100e3, 150e3)])
def test_gross_slip_of_constant_friction(entry: float, exit_: float) -> None:
    law = Constant(friction_coefficient=0.4)
    assert gross(law, entry, exit_) == pytest.approx(math.exp(0.4 * math.pi), rel=1e-12)
    # with held traction above the tested pressures: T falls by mu p_e B R per radian there
    held = replace(law, tested=replace(RANGE, pressure_max=200e3))
    edge = 200e3 * 1.2 * 0.4
    angle = (150e3 - edge) / (0.4 * edge)
    wanted = 150e3 / (edge * math.exp(-0.4 * (math.pi - angle)))
    assert gross(held, entry, exit_) == pytest.approx(wanted, rel=1e-9)


@pytest.mark.parametrize(("entry", "exit_"), [(150e3, 100e3), (100e3, 150e3)])
@pytest.mark.parametrize("exponent", [0.1, 0.5])
def test_gross_slip_of_a_power_of_pressure(entry: float, exit_: float, exponent: float) -> None:
    # T1^n - T2^n = n phi mu_0 (p_0 B D/2)^n
    law = PressurePower(friction_coefficient=0.3, reference_pressure=2e5, exponent=exponent)
    area = ARC.width * ARC.radius
    slack = 150e3**exponent - exponent * math.pi * 0.3 * (2e5 * area) ** exponent
    assert gross(law, entry, exit_) == pytest.approx(150e3 / slack ** (1 / exponent), rel=1e-9)


BERNOULLI = {
    "table": MeasuredTable(
        slip=(0.0, 1e-3), pressure=(50e3, 500e3), values=((0.0, LOW), (0.0, HIGH))
    ),
    "table with a jump": MeasuredTable(
        slip=(0.0, 1e-3), pressure=(50e3, 500e3), values=((LOW, LOW), (HIGH, HIGH))
    ),
    "two knots": IntegralLog(
        coefficients=PressureKnots(
            pressure=(50e3, 500e3), peak_friction=(LOW, HIGH), peak_slip=(5e-3, 15e-3)
        ),
        tested=RANGE,
    ),
}


@pytest.mark.parametrize("law", BERNOULLI.values(), ids=BERNOULLI.keys())
@pytest.mark.parametrize(("entry", "exit_"), [(200e3, 100e3), (100e3, 200e3)])
def test_gross_slip_of_friction_linear_in_pressure(
    law: FrictionLaw, entry: float, exit_: float
) -> None:
    # T1 = T2 e^(m0 phi)/(1 - (c T2/m0)(e^(m0 phi) - 1)), c = 2 m1/(B D)
    ratio = gross(law, entry, exit_)
    slack, c = 200e3 / ratio, 2 * M1 / (ARC.width * ARC.diameter)
    growth = math.exp(M0 * math.pi)
    tight = slack * growth / (1 - c * slack / M0 * (growth - 1))
    assert ARC.wrap_pressure(slack) > 50e3  # inside the range of the law
    assert tight == pytest.approx(200e3, rel=1e-9)


# --- every case --------------------------------------------------------------------------------


@pytest.mark.parametrize("name", LAWS)
def test_tension_is_the_sum_of_traction(name: str) -> None:
    # T1 - T2 = int tau B ds: trapezia on 2,000 parts, of the tension that the belt turns over
    rng = np.random.default_rng(5)
    for _ in range(5):
        arc = replace(random_arc(LAWS[name], rng), overrun=0.0)
        result = Distributed(points=2000, capacities=False).solve(arc)
        p = result.profile
        s = arc.radius * p.position
        parts = 0.5 * (p.shear_stress[1:] + p.shear_stress[:-1]) * np.diff(s) * arc.width
        scale = float(np.sum(np.abs(parts)))
        drop = p.tension[0] - np.concatenate([[0.0], np.cumsum(parts)])
        assert p.tension == pytest.approx(drop, abs=2e-5 * scale)


@pytest.mark.parametrize("name", LAWS)
@pytest.mark.parametrize("factor", [1e-3, 7.0])
def test_scaling_width_and_tensions_changes_nothing(name: str, factor: float) -> None:
    # EA scales with the width (the modulus stays), kappa falls with it
    arc = random_arc(LAWS[name], np.random.default_rng(int(factor)))
    wide = replace(
        arc,
        entry_tension=factor * arc.entry_tension,
        exit_tension=factor * arc.exit_tension,
        width=factor * arc.width,
        axial_stiffness=factor * arc.axial_stiffness,
    )
    one, other = (Distributed().solve(a) for a in (arc, wide))
    force = {"entry_tension", "exit_tension", "effective_tension", "least_exit_tension"}
    force |= {"largest_effective_tension", "k_factor"}
    power = {"transmitted_power", "sliding_power", "shear_loss", "power_loss"}
    for key, value in one.scalars().items():
        if key == "identity_error":
            continue
        wanted = value * (factor if key in force | power else 1.0)
        size = max(abs(one.exit_creep), arc.entry_overrun) if "creep" in key else 0.0
        assert other.scalars()[key] == pytest.approx(
            wanted, rel=1e-7, abs=1e-7 * size, nan_ok=True
        ), key


@pytest.mark.parametrize(
    "law",
    [Constant(friction_coefficient=1e-6), integral_log(peak=1e-6), integral_log(1e-6, 1e-3)],
)
def test_no_friction_carries_nothing(law: FrictionLaw) -> None:
    result = Distributed().solve(replace(ARC, law=law))
    assert result.status is Status.BREAKAWAY
    assert result.capacities.gross_slip_capacity - 1 == pytest.approx(1e-6 * math.pi, rel=1e-5)
    assert result.capacities.creep_limit_capacity - 1 <= 1e-6 * math.pi * (1 + 2e-6)


@pytest.mark.parametrize("law", [RUBBER, SOFTENING])
def test_no_tension_difference_and_no_kick_is_rest(law: FrictionLaw) -> None:
    result = solve(replace(ARC, law=law, exit_tension=150e3), capacities=True)
    assert (result.exit_creep, result.exit_slip, result.entry_creep_ratio) == (0.0, 0.0, 0.0)
    assert result.profile.tension == pytest.approx(150e3, rel=1e-15)
    assert np.all(result.profile.shear_stress == 0.0)
    assert result.capacities.creep_limit_margin == result.capacities.creep_limit_capacity > 1.0
