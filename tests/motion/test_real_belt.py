"""Drives in time with a belt of some thickness, a cover and a mass.

Expected values: `solve` and `solve_train` for the steady state, small vibrations against the march,
an integration of the equations in fixed coordinates, and times that follow from angles alone.
"""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from motion import test_twin as twin
from motion.alone import alone, driven, roll, settle
from motion.stations import INERTIA, TRAINS
from wraparc import Distributed, Train, WrapArc, solve_train
from wraparc.drive.belt import SIDES
from wraparc.motion.control import Control, Droop, ExactSpeed
from wraparc.motion.event import Event, OnBelt, OnDrum, Start
from wraparc.motion.follow import simulate
from wraparc.motion.linear import Linear
from wraparc.motion.march import March
from wraparc.motion.result import Outcome
from wraparc.motion.station import Drum, Station

MASS = 900.0  # [kg/m]
OFFSETS = 12e-3, 16e-3  # pulley cover, carry cover, and half of the carcass


@cache
def train(name: str) -> Train:
    """A tandem with a thick and very heavy belt, its second drum on the carry side.

    The friction of its laggings is without the shear of a cover.
    """
    base = TRAINS[name]
    belt = replace(base.belt, pulley_cover=8e-3, carry_cover=12e-3, carcass=8e-3, mass=MASS)
    first, second = (
        replace(
            p,
            side=side,
            lagging=replace(p.lagging, law=replace(p.lagging.law, slip_includes=())),
        )
        for p, side in zip(base.pulleys, SIDES, strict=True)
    )
    return replace(base, belt=belt, pulleys=(first, second))


def station(name: str, control: Control, **more: float) -> Station:
    drums = tuple(Drum(inertia=INERTIA[name], control=control) for _ in OFFSETS)
    return Station(train=train(name), drums=drums, **more)  # type: ignore[arg-type]


def lift_of(name: str) -> float:
    """M v^2 [N]."""
    return MASS * (train(name).belt.speed or math.nan) ** 2


@pytest.mark.parametrize("name", INERTIA)
def test_an_arc_settles_to_the_answer_of_solve(name: str) -> None:
    """1e-4 with 100 pieces, the accuracy of the method."""
    members = solve_train(train(name), method=Distributed(capacities=False)).cases[0].members
    for member, e in zip(members, OFFSETS, strict=True):
        expected = member.arc
        assert expected.arc.pitch_offset == pytest.approx(e)
        assert expected.arc.cover_compliance > 0.0
        assert expected.arc.centrifugal == pytest.approx(lift_of(name))
        arc = alone(expected.arc, 100)
        settle(arc, expected.entry_tension, expected.exit_tension, 6.0)
        assert arc.creep()[-1] == pytest.approx(expected.exit_creep, rel=1e-4)


@pytest.mark.parametrize("name", INERTIA)
def test_a_run_without_an_event_stays_where_the_train_is(name: str) -> None:
    """Other code: shares, speeds of `solve_train` to 1e-4, over 5 s; the torque of the belt is its
    moment but for the part that only the balance of energy sees, 1 + (T1 - T2) kappa/2."""
    s = station(name, Droop(), conveyor_mass=100e3)
    members = solve_train(s.train, method=Distributed(capacities=False)).cases[0].members
    march = March(s, Event(duration=5.0))
    for d, m in zip(march.drums, members, strict=True):
        kappa = m.arc.arc.recovery_compliance
        exact = m.drum_torque * (1.0 + 0.5 * kappa * m.arc.effective_tension)
        assert d.moment == pytest.approx(exact, rel=1e-12)
        assert m.drum_torque * m.rotation_speed == pytest.approx(m.drum_power, rel=1e-12)
    run = simulate(s, Event(duration=5.0))
    for told, m in zip(run, members, strict=True):
        assert told.share == pytest.approx(m.share, abs=1e-4)
        assert told.speed == pytest.approx(m.rotation_speed, rel=5e-6)  # its droop of such a share


def test_a_piece_of_lagging_goes_from_nip_to_nip_in_the_angle_of_wrap() -> None:
    """By the angle alone: L per phi/omega, less the compression of the lagging, delta/(R + e)."""
    s = station("fabric", ExactSpeed())
    march = March(s, Event(duration=1.0), points=40)
    before = [d.arc.travel for d in march.drums]
    march.step(0.1)
    for d, was in zip(march.drums, before, strict=True):
        arc = replace(d.arc.arc, entry_tension=d.arc.entry)
        turned = d.omega * 0.1 / arc.wrap_angle
        short = 1.0 - arc.compression / (arc.radius + arc.offset)
        assert d.arc.travel - was == pytest.approx(turned * arc.length * short, rel=1e-8)


def test_a_patch_on_the_belt_passes_at_the_speed_of_the_belt() -> None:
    """5 m of belt are at the nip of every drum for 5 m of the tension member, not of lagging."""
    patch = OnBelt(at=0.0, length=5.0, friction=0.7)
    march = March(station("fabric", Droop(), conveyor_mass=1e5), Event(happenings=(patch,)))
    for d, e in zip(march.drums, OFFSETS, strict=True):
        front, share = d.riders[0][1], d.arc.arc.radius / (d.arc.arc.radius + e)
        edge = 2.0 * d.arc.spacing  # over which it begins and ends
        dry = [d.at_nip((front + x) * share, 0.0, 0.0)[2] for x in (-edge, 2.5, 5.0 + edge)]
        assert dry == pytest.approx([1.0, 0.7, 1.0], rel=1e-12)
        gone = d.past_exit(d.arc.shape.length + (front + 2.0) * share, 5.0, front)
        assert gone == pytest.approx(2.0, rel=1e-12)
    first, second = march.drums
    fronts = [d.riders[0][1] - d.arc.travel / d.share for d in march.drums]
    wrapped = first.arc.arc.wrap_angle * (first.arc.arc.radius + OFFSETS[0])
    assert fronts[1] - fronts[0] == pytest.approx(wrapped + second.run, rel=1e-12)


@pytest.mark.parametrize("name", INERTIA)
def test_the_slow_limit_is_the_static_train(name: str) -> None:
    """Other code: the sensitivity of `solve_train`, 2e-5 as without thickness."""
    s = station(name, ExactSpeed())
    static = solve_train(s.train).cases[0].sensitivity[1][1]
    assert Linear.of(s).share_by_speed(1) == pytest.approx(static, rel=2e-5)


@pytest.mark.parametrize(("name", "control"), [("fabric", ExactSpeed()), ("steel-cord", Droop())])
def test_small_vibrations_are_those_of_the_march(name: str, control: Control) -> None:
    """Other code, 2.5e-4 as without thickness; with transit times 2 % short it misses by more."""
    s = station(name, control)
    march = March(s, Event(happenings=(OnDrum(pulley="second", run_out=1e-4),)), points=100)
    rows = []
    while march.t < 7.0:
        march.step()
        if march.t > 4.0:
            rows.append((march.drums[1].angle, march.T[1]))
    a, tension = np.array(rows).T
    basis = np.stack([np.cos(a), np.sin(a), np.ones_like(a)], axis=1)
    c = np.linalg.lstsq(basis, tension, rcond=None)[0]
    linear = Linear.of(s)
    turn = np.array([1j * linear.duties[1].speed])
    expected = complex(linear.forced(turn, "run-out", 1)["tension"][0, 1])
    assert abs(complex(c[0], -c[1]) / 1e-4 / expected - 1.0) < 6e-4


def test_a_start_reaches_the_steady_train() -> None:
    """Other code: `solve_train`; at rest m v^2 is nothing."""
    s = station("fabric", Droop(), conveyor_mass=100e3)
    event = Event(duration=16.0, happenings=(Start(time=6.0),))
    march = March(s, event, points=24)
    assert [d.arc.lift for d in march.drums] == [0.0, 0.0]
    run = simulate(s, event, points=50, every=0.05)
    assert run.outcome is Outcome.WHOLE
    late = run.time > 8.5  # the conveyor swings on its belt: means over some of its swings
    for d, m in zip(run, march.steady.members, strict=True):
        assert np.mean(d.exit_creep[late]) == pytest.approx(m.arc.exit_creep, rel=0.03)
        assert np.mean(d.share[late]) == pytest.approx(m.share, abs=0.01)


THICK = replace(
    twin.SOFT, pitch_offset=16e-3, cover_compliance=6e-3 / 1e6, centrifugal=15e3, belt_speed=3.0
)
SHARE = 0.4 / 0.416  # R/(R + e)


class ThickTwin(twin.Twin):
    """The same in surface coordinates: p = (T - m v^2)/(B R), dT/ds = -B tau R/(R + e)."""

    def lift(self, t: float) -> float:
        """M v^2 with the speed that shakes."""
        return THICK.centrifugal * (self.speed(t) / twin.SPEED) ** 2

    def solved(self, t: float, n: twin.Array, m: float) -> twin.Array:
        tension, eye, width = self.tension, np.eye(twin.NODES), 1.2 * SHARE
        for _ in range(40):
            creep = m - n - self.a * (self.sum @ tension)
            tau, by_u, by_t = twin.friction(creep, tension - self.lift(t), THICK.shear_compliance)
            miss = self.d @ tension + width * tau
            jac = self.d + width * (np.diag(by_t) - self.a * by_u[:, None] * self.sum)
            miss[-1], jac[-1] = tension[-1] - self.out(t), eye[-1]
            change = np.linalg.solve(jac, miss)
            tension = tension - change
            if np.max(np.abs(change)) < 1e-7 * THICK.exit_tension:
                break
        self.tension = tension
        return tension


@pytest.mark.parametrize("seed", range(3))
def test_a_thick_heavy_belt_moves_as_a_twin_of_its_own(seed: int) -> None:
    """Independent, 3e-4 of the pull with 60 pieces as without thickness."""
    rng = np.random.default_rng(seed)
    steady = Distributed(capacities=False).solve(THICK)
    other = ThickTwin(steady.entry_creep_ratio, [twin.waves(rng) for _ in range(3)])
    arc = alone(THICK, 60)
    settle(arc, THICK.entry_tension, THICK.exit_tension, 4.0)
    h = 0.8 * arc.spacing / twin.SPEED
    times = np.asarray(h * np.arange(1, int(0.6 / h)), dtype=float)
    found = []
    for t in times:
        ahead, dm = (
            h / 6.0 * (f(t - h) + 4.0 * f(t - 0.5 * h) + f(t)) for f in (other.speed, other.rate)
        )
        arc.lift = other.lift(float(t))
        driven(arc, float(ahead), float(dm), other.out(float(t)))
        found.append(arc.entry)
    expected = other.entry(times)
    pull = THICK.entry_tension - THICK.exit_tension
    assert np.ptp(expected) > 0.02 * pull
    assert np.max(np.abs(np.array(found) - expected)) < 3e-4 * pull


def test_friction_works_on_the_whole_width() -> None:
    """Loss of a settled arc: omega (R + e)(T1 - T2)[g + (T1 - T2)/(2 EA')] less the shear energy
    that leaves, B (h/2G)(tau2^2 - tau1^2) times the surface that passes; without compression."""
    arc: WrapArc = THICK
    result = Distributed(capacities=False).solve(arc)
    moving = alone(arc, 160)
    settle(moving, arc.entry_tension, arc.exit_tension, 6.0)
    before = moving.travel
    for _ in range(40):
        roll(moving, moving.spacing, arc.entry_tension, arc.exit_tension)
    passed, pull = moving.travel - before, result.effective_tension
    loss = passed / SHARE * pull * (result.entry_creep_ratio + 0.5 * pull * arc.compliance)
    energy = result.energy
    sliding = loss * energy.sliding_power / energy.power_loss
    assert moving.work == pytest.approx(sliding, rel=2e-4)
