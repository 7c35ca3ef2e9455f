"""The arc in time: closed forms, limits and orders of section "exact checks" of its theory.

Where nothing else is said the expected value is a closed form that the docstring states.
"""

import math
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from numpy.typing import NDArray

from motion.alone import alone, driven, roll, settle, wraps_of
from wraparc import (
    ArcResult,
    Constant,
    Distributed,
    ElasticPlastic,
    FrictionLaw,
    InputError,
    IntegralLog,
    MeasuredTable,
    PressureKnots,
    WrapArc,
    load_train,
    solve_train,
)
from wraparc.motion.arc import MovingArc

FREE = IntegralLog(
    coefficients=PressureKnots(pressure=(2e5,), peak_friction=(0.8,), peak_slip=(20e-3,))
)
RIGID = WrapArc(
    law=FREE,
    entry_tension=1e5,
    exit_tension=1e5,
    diameter=0.8,
    wrap_angle=math.pi,
    width=1.2,
    axial_stiffness=1e17,
    overrun=0.0,
    recovery=False,
)


@cache
def steady(file: str, i: int) -> ArcResult:
    train = load_train(f"examples/{file}.toml")
    return solve_train(train, method=Distributed(capacities=False)).cases[0].members[i].arc


@pytest.mark.parametrize("file", ["tandem-fabric", "tandem-steel-cord"])
@pytest.mark.parametrize("i", [0, 1])
def test_the_steady_limit_is_that_of_solve(file: str, i: int) -> None:
    """Other code: `solve`, to 1e-4 with 100 pieces, order 1.9 or better."""
    expected, errors = steady(file, i), []
    for points in (50, 100):
        arc = alone(expected.arc, points)
        settle(arc, expected.entry_tension, expected.exit_tension, 6.0)
        assert arc.entry == pytest.approx(expected.entry_tension, rel=1e-9)
        errors.append(abs(arc.creep()[-1] / expected.exit_creep - 1.0))
    assert errors[1] < 1e-4
    assert math.log2(errors[0] / errors[1]) >= 1.9 or errors[1] < 1e-6


def phi(x: float) -> float:
    """Integral of mu dx up to the peak."""
    r = x / 20e-3
    return 0.8 * 20e-3 * (0.75 * r * r - 0.5 * r * r * math.log(r))


def log_ratio(points: int) -> list[float]:
    """Errors of ln(T1/T2) at three times of a start from rest at a slip speed w."""
    arc = alone(RIGID, points)
    length, speed, w, errors = arc.shape.length, 2.0, 12e-3, []
    h = arc.spacing / speed
    for j in range(1, int(1.5 * points) + 1):
        driven(arc, speed * h, w * h, 1e5)
        t = j * h
        if j in (points // 4, points // 2, points - 1, int(1.5 * points)):
            gone = min(t, length / speed)
            mu = float(FREE.friction(w * gone, 1e5))
            full = speed / w * phi(w * gone) + mu * (length - speed * gone)
            errors.append(math.log(arc.entry / 1e5) / (full / 0.4) - 1.0)
    return errors


def test_a_start_from_rest_of_a_rigid_belt() -> None:
    """ln(T1/T2) = [(V/w) Phi(w t) + mu(w t)(L - V t)]/R, then (V/w) Phi(w L/V)/R.

    4e-5 asks for 144 pieces (7.5e-5 with 100): the slope of the law is infinite at the nip, so that
    the trapezium rule is of second order there but for a logarithm.
    """
    coarse, fine = log_ratio(72), log_ratio(144)
    assert max(map(abs, fine)) < 4e-5
    for a, b in zip(coarse, fine, strict=True):
        assert abs(b) < 1e-8 or math.log2(abs(a / b)) > 1.8


def test_a_rigid_belt_slips_everywhere_as_fast_as_the_drum_runs_ahead() -> None:
    """Identity: slip m - n grows by dm in every step, and is the largest where it began."""
    arc = alone(RIGID, 40)
    for j in range(1, 31):
        driven(arc, arc.spacing, 1e-4, 1e5)  # a step of 1 s
        assert arc.felt.slip_speed == pytest.approx(1e-4, rel=1e-9)
        assert arc.felt.most_slip == pytest.approx(j * 1e-4, rel=1e-9)


def shear_only(points: int) -> MovingArc:
    law = ElasticPlastic(stiffness=1e16, friction_coefficient=50.0)
    return alone(replace(RIGID, law=law, thickness=12e-3, shear_modulus=2.3e6), points)


def test_a_start_from_rest_with_shear_only() -> None:
    """T1 - T2 = (B/c) w (t L - V t^2/2), then (B/c) w L^2/(2 V)."""
    arc = shear_only(80)
    length, speed, w, c = arc.shape.length, 2.0, 2e-3, 12e-3 / 2.3e6
    h = arc.spacing / speed
    for j in range(1, 141):
        driven(arc, speed * h, w * h, 1e5)
        t = min(j * h, length / speed)
        expected = 1.2 / c * w * (t * length - 0.5 * speed * t * t)
        assert arc.entry - 1e5 == pytest.approx(expected, rel=1e-6)


def test_deviations_of_held_tensions_die_as_they_must() -> None:
    """e^(z V t/L) with z = 1 - e^(-z): the slowest is z = -2.0888 +- 7.4615 i."""
    arc, z = shear_only(100), complex(-2.0888, 7.4615)
    for _ in range(20):
        z -= (z - 1.0 + np.exp(-z)) / (1.0 - np.exp(-z))
    assert z == pytest.approx(complex(-2.0888, 7.4615), abs=1e-4)
    for _ in range(700):
        roll(arc, arc.spacing, 1.2e5, 1e5)
    rate = arc.slope  # of the steady state
    # lay what the pieces keep as that mode would have it, and see it go on
    pieces = arc.wraps.pieces(arc)
    s = arc.travel - pieces.travel
    size = 1e-5
    pieces.kept[:] += size * np.real(np.exp(-z * s / arc.shape.length))
    arc.m += size
    m0, found, expected = arc.m, [], []
    for j in range(1, 101):
        roll(arc, arc.spacing, 1.2e5, 1e5)
        found.append(arc.m - m0 + size - rate * j * arc.spacing)
        expected.append(size * np.real(np.exp(z * j / 100)))
    assert np.array(found) == pytest.approx(np.array(expected), abs=0.02 * size)


def test_a_pull_cycled_at_rest_runs_through_masing_loops() -> None:
    """ln(T1/T2) = phi mu(x) with the loops of the law: area 2 mu_pk x_a^2/x_pk."""
    arc, top = alone(RIGID, 160), 8e-3
    angles = np.linspace(0.0, 2.5 * math.pi, 1001)
    x, mu = [], []
    for a in angles:
        driven(arc, 0.0, top * math.sin(a) - arc.m, 1e5)
        x.append(arc.m)
        mu.append(math.log(arc.entry / 1e5) / math.pi)
    slips = np.array(x)

    def law(slip: NDArray[np.float64]) -> NDArray[np.float64]:
        return np.sign(slip) * FREE.friction(np.abs(slip), 1e5)

    back = law(np.array(top)) - 2.0 * law(0.5 * (top - slips))
    forth = -law(np.array(top)) + 2.0 * law(0.5 * (top + slips))
    expected = np.where(angles <= 0.5 * math.pi, law(slips), back)
    expected = np.where(angles > 1.5 * math.pi, forth, expected)
    assert np.array(mu) == pytest.approx(expected, abs=1e-5)
    area = np.trapezoid(mu[200:], x[200:])  # the trapezia themselves miss 1e-5 of it
    assert area == pytest.approx(2.0 * 0.8 * top**2 / 20e-3, rel=2e-5)


def test_strength_lost_past_the_peak_stays_lost() -> None:
    """Loaded to 1.5 peak slips, eased and loaded again: A at the largest slip, elements as before.

    A = mu_pk + m (x_a - x_pk) = 0.8 - 10 0.01 = 0.7; eased by d: A (1 - 2 F(d/(2 x_pk))).
    """
    softening = IntegralLog(
        coefficients=PressureKnots(
            pressure=(2e5,), peak_friction=(0.8,), peak_slip=(20e-3,),
            post_peak_slope=(-10.0,), residual_friction=(0.3,),
        )
    )  # fmt: skip
    arc, peak, left = alone(replace(RIGID, law=softening), 160), 20e-3, 0.7
    for x in np.linspace(0.0, 1.5 * peak, 61)[1:]:
        driven(arc, 0.0, x - arc.m, 1e5)
    assert math.log(arc.entry / 1e5) / math.pi == pytest.approx(left, abs=1e-4)

    def elements(r: float) -> float:
        return r * (1.0 - math.log(r)) if r > 0.0 else 0.0

    eased = np.linspace(0.0, 0.6 * peak, 25)[1:]
    for d in eased:
        driven(arc, 0.0, 1.5 * peak - d - arc.m, 1e5)
        expected = left * (1.0 - 2.0 * elements(d / (2.0 * peak)))
        assert math.log(arc.entry / 1e5) / math.pi == pytest.approx(expected, abs=1e-4)
    low = left * (1.0 - 2.0 * elements(0.3))
    for d in 0.6 * peak - eased[:12]:  # loaded again, not yet to the turning point
        driven(arc, 0.0, 1.5 * peak - d - arc.m, 1e5)
        back = low + 2.0 * left * elements((0.6 * peak - d) / (2.0 * peak))
        assert math.log(arc.entry / 1e5) / math.pi == pytest.approx(back, abs=1e-4)


def test_held_tensions_depend_on_travel_alone() -> None:
    """Identity: a wait on the way, at any speed, changes nothing."""
    result = steady("tandem-fabric", 0)
    a, b = alone(result.arc, 40), alone(result.arc, 40)
    for j in range(60):
        roll(a, a.spacing, 1.2e5, result.exit_tension)
        roll(b, b.spacing, 1.2e5, result.exit_tension)
        if j % 7 == 0:
            roll(b, 0.0, 1.2e5, result.exit_tension)
    assert b.creep()[-1] == pytest.approx(a.creep()[-1], rel=1e-9)
    assert b.m == pytest.approx(a.m, rel=1e-9)


@pytest.mark.parametrize("file", ["tandem-fabric", "tandem-steel-cord"])
def test_a_pull_put_on_at_rest_and_taken_off(file: str) -> None:
    """Pinned (sizes of the theory), a belt that rests at its mean tension: 0.47 of the steady creep
    at once, 1.35 after exactly one wrap, within 4 % after 1.5 and 0.2 % after 2.5; taken off at
    rest much of it stays, and stress of either sign is locked in."""
    result = steady(file, 0)
    arc, entry, exit_ = alone(result.arc, 80), result.entry_tension, result.exit_tension
    mean = 0.5 * (entry + exit_)

    def pull(part: float) -> None:
        roll(arc, 0.0, mean + (entry - mean) * part, mean + (exit_ - mean) * part)

    wraps_of(arc).lay_at_rest(arc, mean)
    for j in range(1, 21):
        pull(j / 20)
    creeps = [arc.creep()[-1]]
    for _ in range(240):
        roll(arc, arc.spacing, entry, exit_)
        creeps.append(arc.creep()[-1])
    ratio = np.array(creeps) / result.exit_creep
    assert ratio[0] == pytest.approx(0.47, abs=0.01)
    assert ratio.max() == pytest.approx(1.36, abs=0.04)
    assert abs(int(np.argmax(ratio)) - 80) <= 1
    assert abs(ratio[120] - 1.0) < 0.04
    assert abs(ratio[200] - 1.0) < 2e-3
    for j in range(19, -1, -1):
        pull(j / 20)
    assert arc.creep()[-1] / result.exit_creep == pytest.approx(0.58, abs=0.05)
    stress = arc.stress()
    assert stress.min() < -0.3 * np.max(np.abs(stress))
    assert stress.max() > 0.3 * np.max(np.abs(stress))


def work_miss(points: int) -> float:
    """Error of the energy balance of a start over its friction work."""
    result = steady("tandem-fabric", 0)
    arc = alone(replace(result.arc, overrun=0.0), points)
    a, b, c = arc.give, arc.shape.width, arc.shape.shear
    entry, exit_ = result.entry_tension, result.exit_tension

    def stored() -> float:
        s, t, tau = arc.place(), arc.tension(), arc.stress()
        return float(np.trapezoid(0.5 * a * t * t + 0.5 * b * c * tau * tau, s))

    wraps_of(arc).lay_at_rest(arc, exit_)
    start, brought, out, ds = stored(), 0.0, 0.0, arc.spacing
    for j in range(2 * points):
        goal = exit_ + (entry - exit_) * min((j + 1) / points, 1.0)
        before, m, wrapped, tau = arc.entry, arc.m, arc.wrapped, arc.stress()[-1]
        roll(arc, ds, goal, exit_)
        mid = 0.5 * (before + arc.entry)
        # belt without stretch in and out; the stretch of what is laid on goes with the surface
        came = ds - (arc.m - m)
        went = came + arc.wrapped - wrapped
        brought += (mid - exit_) * ds - mid * came + exit_ * went
        brought -= 0.5 * a * (mid**2 - exit_**2) * ds
        out += 0.5 * b * c * (0.5 * (tau + arc.stress()[-1])) ** 2 * ds
    return (brought - arc.work - (stored() - start) - out) / arc.work


def test_work_of_a_start_goes_where_it_must() -> None:
    """Identity: drum work = belt work + friction work + change of shear energy and of int a T2/2
    ds + shear energy carried out at the exit; to second order in the pieces."""
    coarse, fine = work_miss(80), work_miss(160)
    assert abs(coarse) < 2e-4
    assert abs(fine) < 6e-5
    assert math.log2(abs(coarse / fine)) > 1.9


def test_an_overrun_towards_travel_has_no_motion() -> None:
    sentence = 'overrun: must be rearward for an event in time, .* Write overrun = "0 mm"'
    with pytest.raises(InputError, match=sentence):
        MovingArc(replace(RIGID, overrun=-5e-5), 20)


@pytest.mark.parametrize(
    ("law", "sentence"),
    [
        (Constant(friction_coefficient=0.4), "creep in time is not unique on a rigid lagging"),
        (
            MeasuredTable(slip=(0.0, 1e-3, 2e-3), pressure=(1e5,), values=((0.0, 0.1, 0.5),)),
            "the measured table must be concave from 0",
        ),
    ],
)
def test_laws_that_have_no_motion_are_refused(law: FrictionLaw, sentence: str) -> None:
    with pytest.raises(InputError, match=sentence):
        MovingArc(replace(RIGID, law=law), 20)
