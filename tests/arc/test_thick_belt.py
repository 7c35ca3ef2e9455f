"""Thickness, covers and mass of the belt on one arc.

Expected values: `thick_twin`, an integration written from moments about the drum; closed forms of
constant friction; two descriptions of the same thing (a cover, or as much more lagging; tensions
above m v^2, or a belt without mass).
"""

from __future__ import annotations

import math
from dataclasses import fields, replace

import numpy as np
import pytest

from arc.drives import LAWS, random_arc
from arc.thick_twin import ThickTwin
from wraparc.arc import ArcResult, Distributed, Status, WrapArc
from wraparc.checks.of_arc import slip_speed
from wraparc.drive.pitch import turns_an_hour
from wraparc.friction import Constant

QUICK = Distributed(capacities=False)
SMOOTH = tuple(name for name in LAWS if name != "table")
ACCURACY = 1e-7
EACH = -(-300 // len(SMOOTH))  # 300 drives in all


def thick(arc: WrapArc, rng: np.random.Generator) -> WrapArc:
    """An arc with a belt of some thickness, a cover and a mass."""
    least = min(arc.entry_tension, arc.exit_tension)
    return replace(
        arc,
        pitch_offset=float(rng.uniform(2e-3, 15e-3)),
        cover_compliance=float(rng.uniform(1.5e-3, 10e-3) / rng.uniform(0.8e6, 1.5e6)),
        centrifugal=float(rng.uniform(0.0, 0.4)) * least,
        belt_speed=3.0,
    )


def solved(name: str, count: int, seed: int) -> list[ArcResult]:
    """Random thick belts that the law can carry."""
    rng = np.random.default_rng([seed, sorted(LAWS).index(name)])
    found: list[ArcResult] = []
    while len(found) < count:
        result = QUICK.solve(thick(random_arc(LAWS[name], rng), rng))
        if result.status is Status.SOLVED:
            found.append(result)
    return found


def misses(result: ArcResult) -> dict[str, float]:
    """Relative differences from the twin, of the largest creep and slip on the way."""
    arc, twin = result.arc, ThickTwin(result.arc).solve(result.entry_creep_ratio)
    creep, slip = (float(np.max(np.abs(v))) for v in (result.profile.creep, result.profile.slip))
    return {
        "creep": abs(twin.creep - result.exit_creep) / creep,
        "slip": abs(twin.slip - result.exit_slip) / max(slip, 1e-3 * creep),
        "ratio": abs(twin.entry_ratio - result.entry_creep_ratio) * arc.length / creep,
    }


@pytest.mark.parametrize("name", SMOOTH)
def test_random_belts(name: str) -> None:
    for result in solved(name, EACH, 34):
        found = misses(result)
        assert max(found.values()) <= ACCURACY, (found, result.arc)


@pytest.mark.parametrize("name", SMOOTH)
def test_loss_is_sliding_and_shear_energy_by_quadrature(name: str) -> None:
    """v_s (T1 - T2)[g + (T1 - T2)/(2 EA')] = B v_s R/(R + e) int tau du, by the twin's work."""
    found = []
    for result in solved(name, 5, 35):
        arc, twin = result.arc, ThickTwin(result.arc).solve(result.entry_creep_ratio)
        pull, g = result.effective_tension, twin.entry_ratio
        surface = 3.0 / (1.0 - g)
        width = arc.width * arc.radius / (arc.radius + (arc.pitch_offset or 0.0))
        exact = surface * pull * (g + 0.5 * pull * arc.compliance)
        size = abs(exact) + 1e-3 * surface * abs(pull * g)
        found.append(abs(surface * width * twin.work - exact) / size)
        energy = result.energy
        loss = result.entry_creep_ratio + 0.5 * pull * arc.compliance
        told = 3.0 / (1.0 - result.entry_creep_ratio) * pull * loss
        assert energy.power_loss == pytest.approx(told, rel=1e-12)
        assert energy.sliding_power + energy.shear_loss == pytest.approx(
            energy.power_loss, rel=1e-12
        )
    # what is left is the twin's: 1e-12 a step, more where steps cross the kinks of a law
    assert (min(found) <= 1e-12, max(found) <= 1e-9) == (True, True), found


@pytest.mark.parametrize("name", LAWS)
def test_nothing_given_is_nothing_changed(name: str) -> None:
    rng = np.random.default_rng([36, sorted(LAWS).index(name)])
    for _ in range(3):
        arc = random_arc(LAWS[name], rng)
        one, other = (
            Distributed().solve(a) for a in (arc, replace(arc, pitch_offset=0.0, centrifugal=0.0))
        )
        assert [repr(v) for v in one.scalars().values()] == [
            repr(v) for v in other.scalars().values()
        ]
        assert all(
            np.array_equal(getattr(one.profile, f.name), getattr(other.profile, f.name))
            for f in fields(one.profile)
        )


def test_gross_slip_of_constant_friction() -> None:
    """T1*/T2* = exp(mu phi R/(R + e)) with R = 400 mm, e = 6 mm, mu = 0.3, phi = pi."""
    arc = WrapArc(
        law=Constant(friction_coefficient=0.3), entry_tension=50e3, exit_tension=30e3, diameter=0.8,
        wrap_angle=math.pi, width=1.2, axial_stiffness=15e6, thickness=0.01, shear_modulus=1e6,
        overrun=0.0, pitch_offset=6e-3, centrifugal=4e3, belt_speed=3.0,
    )  # fmt: skip
    ratio = math.exp(0.3 * math.pi * 0.4 / 0.406)
    slack = (50e3 - 4e3) / ratio + 4e3
    found = Distributed().solve(arc).capacities.gross_slip_capacity
    assert found == pytest.approx(50e3 / slack, rel=1e-12)


def test_a_cover_is_so_much_more_lagging() -> None:
    """Of equal h/G the same creep, slip and tensions as a lagging of twice the thickness."""
    rng = np.random.default_rng(37)
    for name in SMOOTH:
        arc = replace(random_arc(LAWS[name], rng), compression_modulus=math.inf, overrun=1e-5)
        covered = replace(arc, cover_compliance=arc.thickness / arc.shear_modulus)
        double = replace(arc, thickness=2.0 * arc.thickness)
        one, other = QUICK.solve(covered), QUICK.solve(double)
        assert one.status is other.status
        for column in ("creep", "slip", "tension", "shear_angle"):
            a, b = getattr(one.profile, column), getattr(other.profile, column)
            assert np.allclose(a, b, rtol=1e-9, atol=1e-9 * np.max(np.abs(b), initial=0.0))


def test_tensions_raised_by_the_centrifugal_force() -> None:
    """Creep, slip and stress of a heavy belt are those of a light one at T - m v^2."""
    rng = np.random.default_rng(38)
    for name in SMOOTH:
        arc = random_arc(LAWS[name], rng)
        lift = 0.3 * min(arc.entry_tension, arc.exit_tension)
        heavy = replace(
            arc,
            entry_tension=arc.entry_tension + lift,
            exit_tension=arc.exit_tension + lift,
            centrifugal=lift,
        )
        one, other = Distributed().solve(heavy), Distributed().solve(arc)
        assert one.status is other.status
        assert one.exit_creep == pytest.approx(other.exit_creep, rel=1e-9, nan_ok=True)
        least, light = (r.capacities.least_exit_tension for r in (one, other))
        assert least == pytest.approx(light + lift, rel=1e-9, nan_ok=True)
        assert np.allclose(one.profile.tension - lift, other.profile.tension, rtol=1e-9)


def test_the_torque_pulls_at_the_tension_member() -> None:
    """R - delta + e, delta = (h/E_c) p1 with p1 of the tension above m v^2."""
    arc = WrapArc(
        law=Constant(friction_coefficient=0.4), entry_tension=100e3, exit_tension=60e3,
        diameter=0.8, wrap_angle=math.pi, width=1.2, axial_stiffness=15e6, thickness=0.012,
        shear_modulus=1e6, compression_modulus=9e6, pitch_offset=7e-3, centrifugal=10e3,
    )  # fmt: skip
    delta = 0.012 / 9e6 * 90e3 / (1.2 * 0.4)
    assert arc.pitch_radius == pytest.approx(0.4 - delta + 7e-3, rel=1e-15)


def test_what_wears_a_turn_is_the_sliding_power() -> None:
    """Energy a pass, on 2 pi R B, in the turns of an hour: the sliding power but for the creep that
    turns leave out, 1 - g; the largest slip speed is that of the shell under it, by its angle."""
    for result in solved("rubber", 3, 39):
        arc, energy = result.arc, result.energy
        turns = turns_an_hour(3.0, arc.radius + arc.offset)
        area = 2.0 * math.pi * arc.radius * arc.width
        worked = turns * area * energy.frictional_energy / 3600.0
        exact = energy.sliding_power * (1.0 - result.entry_creep_ratio)
        assert worked == pytest.approx(exact, rel=1e-12)
        fine = Distributed(points=4000, capacities=False).solve(arc).profile
        at, slip = fine.position, fine.slip
        step = np.diff(at) > 1e-9
        steepest = np.max(np.abs(np.diff(slip)[step] / np.diff(at)[step]))
        omega = 3.0 / (arc.radius + arc.offset)
        # a step of the profile has the mean of its slope: the same to its curvature, and no more
        assert omega * steepest <= slip_speed(result) * (1.0 + 1e-9)
        assert slip_speed(result) == pytest.approx(omega * steepest, rel=1e-3)
