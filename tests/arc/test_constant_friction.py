"""Constant friction: published wrap factors, closed forms, the catalogue's design values."""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from wraparc import Constant, Lagging, WrapArc
from wraparc.arc import capstan_ratio, classical_drives, slipping_arc, wrap_factor


@pytest.mark.parametrize(
    ("wrap", "bare", "lagged"),
    [(180, 0.84, 0.50), (200, 0.72, 0.42), (220, 0.62, 0.35), (240, 0.54, 0.30)],
)
def test_wrap_factors_are_those_of_cema(wrap: float, bare: float, lagged: float) -> None:
    """CEMA, Belt Conveyors for Bulk Materials, table of wrap factors with automatic take-up."""
    assert round(wrap_factor(0.25, math.radians(wrap)), 2) == bare
    assert round(wrap_factor(0.35, math.radians(wrap)), 2) == lagged


def test_the_capstan_ratio_solves_its_differential_equation() -> None:
    """dT/dtheta = -mu T, integrated numerically."""
    solved = solve_ivp(lambda _, t: -0.4 * t, (0.0, 3.5), [1.0], rtol=1e-12, atol=1e-14)
    assert capstan_ratio(0.4, 3.5) == pytest.approx(1.0 / solved.y[0, -1], rel=1e-10)


def test_identities() -> None:
    for mu, phi in np.random.default_rng(1).uniform((0.05, 0.5), (1.2, 7.0), (50, 2)).tolist():
        ratio = capstan_ratio(mu, phi)
        assert slipping_arc(mu, ratio) == pytest.approx(phi, rel=1e-12)
        assert slipping_arc(mu, 1.0 / ratio) == pytest.approx(phi, rel=1e-12)
        assert wrap_factor(mu, phi) == pytest.approx(1.0 / (ratio - 1.0), rel=1e-9)


def arc(entry: float, leaving: float) -> WrapArc:
    return WrapArc(
        law=Constant(friction_coefficient=0.5), entry_tension=entry, exit_tension=leaving,
        diameter=0.8, wrap_angle=math.pi, width=1.2, axial_stiffness=1.5e7,
    )  # fmt: skip


def lagging(surface: str, condition: str = "dry") -> Lagging:
    return Lagging(
        name="x", law=Constant(friction_coefficient=0.5), surface=surface, condition=condition
    )


def test_design_values_of_a_rubber_lagging() -> None:
    """CEMA 0.35: Cw = 0.499 at 180 deg, so that 90 kN of pull need 44.9 kN."""
    cema, din, *_ = classical_drives(arc(150e3, 60e3), lagging("rubber"))
    assert (cema.design.standard, cema.design.friction) == ("CEMA", (0.35, 0.35))
    assert cema.safe_slack_tension == pytest.approx(44.94e3, rel=1e-3)
    assert (din.design.standard, din.design.condition) == ("DIN 22101", "dry")
    assert din.slack_tension[0] > din.slack_tension[1]
    assert din.ratio == (math.exp(0.40 * math.pi), math.exp(0.45 * math.pi))


def test_the_condition_of_the_lagging_comes_first() -> None:
    known = classical_drives(arc(150e3, 60e3), lagging("ceramic", "wet"))
    assert [c.design.condition for c in known][:3] == ["", "wet", "wet"]
    assert {c.design.surface for c in known} == {"ceramic"}


def test_braking_asks_for_as_much_as_driving() -> None:
    driving, braking = (
        classical_drives(a, lagging("rubber")) for a in (arc(150e3, 60e3), arc(60e3, 150e3))
    )
    for one, other in zip(driving, braking, strict=True):
        assert one.slack_tension == other.slack_tension
        assert one.slipping_arc == pytest.approx(other.slipping_arc)


def test_a_lagging_without_a_surface_has_no_design_values() -> None:
    assert classical_drives(arc(150e3, 60e3), lagging("")) == ()
