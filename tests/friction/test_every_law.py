"""What every friction law must be, over one law of every kind.

Expected values: the definitions of FrictionLaw (odd, held at the edges of its tested pressures,
slip never clamped), and the vectorised form against the scalar one that the solvers read, which
share no code.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from friction.laws import LAWS, edges, kinks, smooth_points, starts_with_a_jump
from wraparc.friction import FrictionLaw, IntegralLog
from wraparc.friction.compact import (
    branch_of,
    friction_at,
    plateau_at,
    segment_of,
)

SLIPS = np.concatenate([np.geomspace(1e-9, 1e-3, 15), np.linspace(1.1e-3, 60e-3, 60)])
PRESSURES = np.concatenate([np.geomspace(5e3, 2e6, 30), [40e3, 90e3, 170e3, 600e3, 690e3]])

every_law = pytest.mark.parametrize("law", LAWS.values(), ids=LAWS.keys())


def scalar(law: FrictionLaw, slip: float, pressure: float) -> tuple[float, float, float]:
    """mu, mu_x and mu_p of a positive slip in the form that the solvers read."""
    c = law.compact()
    segment = segment_of(c, pressure)
    branch = branch_of(c, segment, slip, pressure)
    mu, mu_x, mu_p = friction_at(c, segment, branch, slip, pressure)
    if c.onset_compliance > 0.0 and slip < c.onset_compliance * mu * pressure:
        # the elastic part of this law is a spring in series, not friction, to the solvers
        mu = slip / (c.onset_compliance * pressure)
        return mu, mu / slip, -mu / pressure
    return mu, mu_x, mu_p


@every_law
def test_odd_and_zero_at_zero(law: FrictionLaw) -> None:
    forward = law.friction(SLIPS[:, None], PRESSURES)
    assert np.array_equal(law.friction(-SLIPS[:, None], PRESSURES), -forward)
    assert np.all(forward > 0.0)
    assert np.all(law.friction(0.0, PRESSURES) == 0.0)
    assert np.all(law.friction(-0.0, PRESSURES) == 0.0)


@every_law
def test_shapes_are_broadcast(law: FrictionLaw) -> None:
    assert law.friction(1e-3, 2e5).shape == ()
    assert law.friction([1e-3, 2e-3], 2e5).shape == (2,)
    assert law.friction(np.ones((3, 1)) * 1e-3, [1e5, 2e5]).shape == (3, 2)
    assert law.friction(1, 200_000).dtype == float  # whole numbers are numbers too
    one_by_one = [[float(law.friction(x, p)) for p in PRESSURES[::9]] for x in SLIPS[::9]]
    assert np.array_equal(law.friction(SLIPS[::9, None], PRESSURES[::9]), one_by_one)


@every_law
def test_continuous_in_slip(law: FrictionLaw) -> None:
    for p in PRESSURES[::7]:
        for x in kinks(law, float(p)):
            below, above = law.friction([x * (1 - 1e-9), x * (1 + 1e-9)], p)
            assert above == pytest.approx(below, rel=1e-7)
    first = law.friction(1e-12, PRESSURES)
    assert starts_with_a_jump(law) or np.all(first < 1e-6)


@every_law
def test_continuous_in_pressure(law: FrictionLaw) -> None:
    for p in edges(law):
        below, above = (law.friction(SLIPS, p * (1 + e)) for e in (-1e-9, 1e-9))
        assert above == pytest.approx(below, rel=1e-7)


@every_law
def test_held_beyond_the_tested_pressures(law: FrictionLaw) -> None:
    if not edges(law):
        pytest.fail("no edges") if law.tested else None
        return
    low, high = edges(law)[0], edges(law)[-1]
    below, above = np.array([0.01, 0.5, 0.999]) * low, np.array([1.001, 2.0, 50.0]) * high
    x = SLIPS[:, None]
    at_low, at_high = law.friction(x, low), law.friction(x, high)
    if law.compact().onset_compliance == 0.0:
        assert np.array_equal(law.friction(x, below), at_low.repeat(3, axis=1))
        assert law.friction(x, above) * above == pytest.approx(
            (at_high * high).repeat(3, axis=1), rel=1e-14
        )
    else:
        # its stiffness is a shear stress per slip, whatever the pressure; the limit is held
        assert np.max(law.friction(x, below), axis=0) == pytest.approx(np.max(at_low), rel=1e-15)
        assert np.max(law.friction(x, above) * above, axis=0) == pytest.approx(
            np.max(at_high * high), rel=1e-14
        )


@every_law
def test_tested_slip_does_not_clamp(law: FrictionLaw) -> None:
    if not isinstance(law, IntegralLog) or law.tested is None:
        return
    short = replace(law, tested=replace(law.tested, slip_max=1e-3))
    assert np.array_equal(short.friction(SLIPS, 150e3), law.friction(SLIPS, 150e3))


@every_law
def test_scalar_form_has_the_same_values(law: FrictionLaw) -> None:
    pressures = PRESSURES[::2]
    wanted = law.friction(SLIPS[:, None], pressures)
    got = [[scalar(law, x, p)[0] for p in pressures.tolist()] for x in SLIPS.tolist()]
    assert np.array(got) == pytest.approx(wanted, rel=1e-12)


@every_law
def test_scalar_form_has_the_right_derivatives(law: FrictionLaw) -> None:
    # five-point differences of the vectorised form, as far apart as the next kink allows
    nodes, weights = np.array([-2, -1, 1, 2]), np.array([1, -8, 8, -1]) / 12
    for x, p in smooth_points(law):
        h, k = 1e-4 * x, 1e-4 * p
        by_slip = weights @ law.friction(x + h * nodes, p) / h
        by_pressure = weights @ law.friction(x, p + k * nodes) / k
        mu, mu_x, mu_p = scalar(law, x, p)
        assert mu_x == pytest.approx(by_slip, rel=1e-8, abs=1e-9 * mu / x)
        assert mu_p == pytest.approx(by_pressure, rel=1e-8, abs=1e-9 * mu / p)


@every_law
def test_branches_end_where_the_formula_changes(law: FrictionLaw) -> None:
    c = law.compact()
    for p in PRESSURES.tolist()[::5]:
        segment = segment_of(c, p)
        for branch, x in enumerate(kinks(law, p) if c.onset_compliance == 0.0 else []):
            before, after = x * (1 - 1e-9), x * (1 + 1e-9)
            if branch_of(c, segment, before, p) != branch:
                continue  # a branch of no length
            assert branch_of(c, segment, after, p) > branch


@every_law
def test_steepest_fall_is_the_steepest(law: FrictionLaw) -> None:
    fine = np.linspace(0.0, 60e-3, 3001)[1:]
    falls = [np.diff(law.friction(fine, p)).min() / 2e-5 for p in PRESSURES]
    steepest = law.steepest_fall()
    assert steepest <= 0.0
    assert steepest <= min(falls) * (1 - 1e-6) + 1e-9
    assert steepest >= 1.1 * min(falls) - 1e-9  # attained, but for the coarse pressures here


@every_law
def test_plateau_is_the_largest_friction(law: FrictionLaw) -> None:
    c = law.compact()
    for p in PRESSURES.tolist():
        slips = np.concatenate([SLIPS, kinks(law, p)])
        plateau = plateau_at(c, segment_of(c, p), p)
        assert plateau == pytest.approx(float(law.friction(slips, p).max()), rel=1e-12)


@every_law
def test_segments_are_the_intervals_of_pressure(law: FrictionLaw) -> None:
    ends = law.compact().edges
    assert ends == edges(law)
    for p in (1e-3, 1e9, *(e * f for e in ends for f in (1 - 1e-12, 1.0, 1 + 1e-12))):
        segment = segment_of(law.compact(), p)
        assert -1 <= segment < max(len(ends), 1)
        assert segment < 0 or ends[segment] <= p
        assert segment >= len(ends) - 1 or p < ends[segment + 1]


@every_law
def test_equal_numbers_make_equal_laws(law: FrictionLaw) -> None:
    same = replace(law)
    assert same == law
    assert hash(same) == hash(law)
    assert same.compact() == law.compact()
    numbers = law.compact().coefficients
    assert all(type(v) is float and math.isfinite(v) for v in numbers)
