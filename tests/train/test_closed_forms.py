"""Trains against closed forms.

Expected values: formulas of the documentation ("Several drives on one belt"), written out here.
"""

from __future__ import annotations

import math

import pytest
from scipy.optimize import brentq

from arc.drives import LAWS, integral_log
from train.trains import (
    FABRIC,
    QUICK,
    RIGID,
    STEEL,
    case,
    held,
    lagging,
    pulleys,
    solved,
    train,
    tried,
)
from wraparc.arc import Distributed, solve
from wraparc.drive import Drive, LoadCase, Tensions
from wraparc.friction import Constant
from wraparc.train import Shares, Speeds, Train, TrainStatus, solve_train

MU = 0.4
COULOMB = lagging(Constant(friction_coefficient=MU), thickness=0.0)
EQUAL = Shares((0.5, 0.5))


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("tensions", [(150e3, 60e3), (60e3, 110e3)])
def test_a_train_of_one_is_the_single_pulley(law: str, tensions: tuple[float, float]) -> None:
    of = pulleys(1, law, overrun=0.0)
    entry, exit_ = tensions
    drive = Drive(
        belt=FABRIC,
        pulleys=of,
        load_cases=(LoadCase(name="c", tensions={"p1": Tensions(entry=entry, exit=exit_)}),),
    )
    alone = solve(drive, method=Distributed()).arcs[0]
    for division in (Shares((1.0,)), Speeds((1.0,)), Speeds((7.0,), absolute=True)):
        result = solved(train(of, case(division, entry, exit_)), Distributed())
        arc = result.members[0].arc
        ours, theirs = arc.scalars(), alone.scalars()
        by_speed = {"transmitted_power", "sliding_power", "shear_loss", "power_loss"}
        for name in ours.keys() - (
            by_speed if division == Speeds((7.0,), absolute=True) else set()
        ):
            assert ours[name] == theirs[name] or math.isnan(theirs[name]), name
        assert result.members[0].share == 1.0
        assert result.members[0].speed_trim == 1.0
        assert arc.arc.law is alone.arc.law


def test_coulomb_friction_on_an_elastic_belt() -> None:
    """Both have a rest arc: v2/v1 = (1 + T2/EA)/(1 + T1/EA), to first order 1 - (T1 - T2)/EA."""
    of = pulleys(2, COULOMB)
    stiffness = FABRIC.axial_stiffness
    result = solved(train(of, case(EQUAL)))
    second = result["p2"]
    assert all(m.arc.stuck_arc > 0.0 for m in result)
    assert second.speed_ratio == pytest.approx(
        (1.0 + 100e3 / stiffness) / (1.0 + 150e3 / stiffness), rel=1e-14
    )
    assert second.first_order_speed_ratio == pytest.approx(1.0 - 50e3 / stiffness, rel=1e-14)
    assert second.creep_term == 0.0


@pytest.mark.parametrize("trim", [0.9955, 0.9968, 0.9978])
def test_coulomb_friction_the_other_way_round(trim: float) -> None:
    """At rest arcs speeds alone fix the tension between the drums: T2 = (EA + T1) v2/v1 - EA."""
    of = pulleys(2, COULOMB)
    stiffness = FABRIC.axial_stiffness
    result = solved(train(of, case(Speeds((1.0, trim)))))
    between = (stiffness + 150e3) * trim - stiffness
    assert result["p1"].arc.exit_tension == pytest.approx(between, rel=1e-12)
    assert result["p2"].share == pytest.approx((between - 50e3) / 100e3, rel=1e-11)
    # d share/d ln(speed) = (EA + T2)/(T1 - T3) while both rest
    assert result.sensitivity[1][1] == pytest.approx((stiffness + between) / 100e3, rel=1e-6)


@pytest.mark.parametrize("wraps", [(3.2, 3.2), (2.0, 3.9), (3.9, 2.0)])
def test_capacity_of_constant_friction(wraps: tuple[float, float]) -> None:
    """At capacity T1/T3 = exp(mu (phi1 + phi2)), whatever the split of the wrap."""
    of = tuple(pulleys(2, COULOMB, wrap_angle=wrap)[i] for i, wrap in enumerate(wraps))
    capacity = math.exp(MU * sum(wraps))
    below = case(EQUAL, 150e3, 150e3 / capacity * (1.0 + 1e-9))
    # both at capacity: the tension between them follows from either
    between = 150e3 * math.exp(-MU * wraps[0] * (1.0 - 5e-10))
    share = (150e3 - between) / below.effective_tension
    carried = train(of, case(Shares((share, 1.0 - share)), 150e3, below.exit_tension))
    result = solved(carried)
    assert all(m.arc.stuck_arc < 1e-6 for m in result)
    # any speeds: nothing carries more
    above = 150e3 / capacity * (1.0 - 1e-6)
    for speeds in ((1.0, 1.0), (1.0, 0.99), (1.0, 1.01)):
        failed = tried(train(of, case(Speeds(speeds), 150e3, above)))
        assert failed.status is TrainStatus.BREAKAWAY
        assert failed.reason == "Gross slip on p1 and p2: no creep gives enough friction."


PEAK, SLIP = 0.8, 9e-3
FREE = lagging(integral_log(PEAK, SLIP), 0.0, math.inf, math.inf)


def creep_ratio(tension_ratio: float, wrap: float = math.pi, radius: float = 0.4) -> float:
    """g from ln(T1/T2) = Phi(g R phi)/(g R), Phi = mu_pk x_pk (3 r^2/4 - r^2 ln(r)/2)."""

    def miss(g: float) -> float:
        r = g * radius * wrap / SLIP
        phi = PEAK * SLIP * (0.75 * r * r - 0.5 * r * r * math.log(r))
        return phi / (g * radius) - math.log(tension_ratio)

    return float(brentq(miss, 1e-12, SLIP / (radius * wrap), xtol=1e-18, rtol=1e-14))


@pytest.mark.parametrize("between", [120e3, 100e3, math.sqrt(150e3 * 50e3), 75e3])
def test_rigid_belt_and_stiff_lagging(between: float) -> None:
    """v2/v1 = (1 - g1)/(1 - g2), no contraction, no compression."""
    share = (150e3 - between) / 100e3
    result = solved(train(pulleys(2, FREE), case(Shares((share, 1.0 - share))), belt=RIGID))
    g1, g2 = creep_ratio(150e3 / between), creep_ratio(between / 50e3)
    second = result["p2"]
    assert result["p1"].arc.entry_creep_ratio == pytest.approx(g1, rel=1e-6)
    assert second.speed_ratio - 1.0 == pytest.approx((1.0 - g1) / (1.0 - g2) - 1.0, abs=2e-9)
    assert second.contraction_term == 0.0 == second.compression_term
    assert second.drum_ratio == pytest.approx(second.speed_ratio, rel=1e-15)
    assert second.drum_ratio == second.speed_trim


@pytest.mark.parametrize("count", [2, 3, 5, 10])
def test_identical_drives_on_a_rigid_belt_at_one_speed(count: int) -> None:
    """Friction free of pressure depends on tension ratios only: all of them are equal."""
    of = pulleys(count, FREE)
    result = solved(train(of, case(Speeds((1.0,) * count), 150e3, 40e3), belt=RIGID))
    ratio = (150e3 / 40e3) ** (1.0 / count)
    for m in result:
        assert m.arc.tension_ratio == pytest.approx(ratio, rel=1e-9)
        assert m.arc.entry_creep_ratio == pytest.approx(creep_ratio(ratio), rel=1e-6)


def test_shafts_of_idle_drums_differ_by_compression_alone() -> None:
    """A drum without load and overrun has the speed of the belt: omega = v/(R - delta)."""
    of = pulleys(2, "rubber", overrun=0.0)
    result = solved(train(of, case(Shares((0.0, 1.0)))))
    first = result["p1"]
    delta = 12e-3 / 10e6 * 2.0 * 150e3 / (1.2 * 0.8)
    assert first.surface_speed == pytest.approx(3.0, rel=1e-12)
    assert first.rotation_speed == pytest.approx(3.0 / (0.4 - delta), rel=1e-12)
    assert first.drum_torque == 0.0


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("belt", [FABRIC, STEEL])
def test_exact_and_first_order_speeds(law: str, belt: object) -> None:
    """Exact ratio of the speeds, the two terms of the first order, and the term of the shafts."""
    assert belt in (FABRIC, STEEL)
    of = pulleys(3, law, diameter=1.0, overrun=0.0)
    result = solved(
        Train(
            belt=FABRIC if belt is FABRIC else STEEL, pulleys=of, cases=(case(THIRDS, 260e3, 90e3),)
        )
    )
    stiffness = result.members[0].arc.arc.axial_stiffness
    first = result.members[0].arc
    for m in result:
        arc = m.arc
        exact = (1.0 + arc.entry_tension / stiffness) * (1.0 - first.entry_creep_ratio)
        exact /= (1.0 + first.entry_tension / stiffness) * (1.0 - arc.entry_creep_ratio)
        assert m.speed_ratio == pytest.approx(exact, rel=1e-14)
        terms = m.contraction_term + m.creep_term
        assert terms == pytest.approx(
            arc.entry_creep_ratio
            - first.entry_creep_ratio
            - (first.entry_tension - arc.entry_tension) / stiffness
        )
        # what the first order leaves out is as small beside its terms as strains are beside 1
        sizes = abs(m.contraction_term) + abs(m.creep_term) + abs(m.compression_term)
        assert abs(m.speed_ratio - 1.0 - terms) <= 0.03 * sizes
        # shafts: (g2 - g1) - (T1 - T2)/EA' to first order
        shafts = (
            arc.entry_creep_ratio
            - first.entry_creep_ratio
            - (first.entry_tension - arc.entry_tension) * first.arc.compliance
        )
        assert abs(m.drum_ratio - 1.0 - shafts) <= 0.03 * sizes
        assert m.speed_trim == pytest.approx(m.drum_ratio, rel=1e-14)
        power = m.drum_torque * m.rotation_speed
        assert m.drum_power == pytest.approx(power, rel=1e-12)
        assert m.drum_power == pytest.approx(m.arc.energy.transmitted_power, rel=1e-9)


THIRDS = Shares((0.3, 0.3, 0.4))


@pytest.mark.parametrize("law", LAWS)
def test_speeds_to_shares_is_the_inverse_of_shares_to_speeds(law: str) -> None:
    of = train(pulleys(3, law, diameter=1.0, overrun=0.0), case(THIRDS, 260e3, 90e3))
    asked = solved(of)
    back = solved(held(of, asked))
    assert back.shares == pytest.approx(asked.shares, abs=1e-9)
    assert back.tension_error < 1e-10
    assert back.speed_error < 1e-9
    assert [m.speed_trim for m in back] == pytest.approx([m.speed_trim for m in asked], abs=1e-9)


def test_the_loss_ratio_needs_no_speed() -> None:
    of = train(pulleys(2), case(EQUAL))
    result = solved(of)
    power = sum(m.drum_power for m in result)
    assert result.loss_ratio == pytest.approx(result.power_loss / power, rel=1e-5)
    still = Train(
        belt=type(FABRIC)(name="b", width=1.2, modulus=12.96e6), pulleys=of.pulleys, cases=of.cases
    )
    unknown = solve_train(still, method=QUICK).cases[0]
    assert unknown.loss_ratio == pytest.approx(result.loss_ratio, rel=1e-12)
    assert math.isnan(unknown.power_loss)
    assert math.isnan(unknown.members[0].rotation_speed)
    assert unknown["p2"].speed_trim == result["p2"].speed_trim
