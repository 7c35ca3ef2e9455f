"""The strips by collocation against the strips marched along the arc by SciPy.

From the entry that the solver found, the equations of the page on the width are marched with small
steps of high order; slip is bisected from the public friction of the law. What the march ends with
is what the solver found there, and closes the path. Slow, and nothing of the room is in it.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from across.test_exact import LAWS
from across.twin import stress
from across.wides import CORD, FABRIC, RUBBER, braking, crown, mode, wide
from wraparc.across import AcrossSolver, WideArc
from wraparc.across.collocation import System, newton, started
from wraparc.across.elements import Elements, graded
from wraparc.arrays import Array

STRIPS = 4


def marched(wide: WideArc, entry: Array, drum: float) -> Array:
    """Tension [N/m] and creep [m] at the exit, shape (2, n), from tensions at the entry."""
    arc, n, m = wide.arc, wide.strips, wide.belt_modulus
    k = np.arange(1, n)[:, None]
    cosine = np.sqrt(2.0 / n) * np.cos(np.pi * k * (np.arange(n) + 0.5) / n)
    give = wide.thickness / (arc.radius**2 * wide.compression_modulus)
    overrun = np.full(n, arc.overrun if arc.overrun is not None else 0.0)
    if arc.overrun is None:
        overrun = 1.25 * (give * arc.radius * entry) ** 1.5 / np.sqrt(arc.radius)
    lag1 = (cosine @ wide.entry_misfit) + wide.length_before / m * (
        cosine @ (wide.entry_profile - entry)
    )
    bend = wide.shear_stiffness * (np.arange(1, n) * np.pi / arc.width) ** 2
    shear = arc.thickness / arc.shear_modulus

    def rates(_: float, y: Array) -> Array:
        t, u = y[:n], y[n:]
        tau = stress(arc.law, shear, u, t / arc.radius)
        lag = lag1 + cosine @ (u - overrun)
        given = give * (t if arc.recovery else entry)
        rate = drum + wide.radius_deviation / arc.radius - t / m - given
        return np.concatenate([-tau - cosine.T @ (bend * lag), rate])

    start, unit = np.concatenate([entry, overrun]), np.repeat([1e-3, 1e-11], n)
    found = solve_ivp(rates, (0.0, arc.length), start, "DOP853", rtol=1e-9, atol=unit)
    return np.asarray(found.y[:, -1].reshape(2, n))


def test_where_newton_fails_at_once_it_is_led_there() -> None:
    """Source: SciPy's march, for constant friction that holds back under a crown of 8 mm."""
    arc = replace(braking(FABRIC), law=LAWS["constant"])
    given = wide(arc, 8, 1e5, radius_deviation=crown(8e-3, 8))
    system = System(given, Elements(graded(arc.length, 12)))
    found = AcrossSolver().solve(given)
    assert not newton(system, started(system, found.even)).solved
    assert found.status.solved
    assert found.error_estimate < 1e-6
    t2, u2 = marched(given, found.entry_tension, found.drum_number)
    assert found.exit_tension == pytest.approx(t2, abs=2e-6 * float(np.max(t2)))
    assert found.exit_creep == pytest.approx(u2, abs=1e-5 * float(np.max(np.abs(u2))))


@pytest.mark.parametrize(
    ("arc", "miss"),
    [
        (replace(CORD, overrun=None, recovery=False), 1e-6),
        (replace(braking(FABRIC), law=LAWS["softening"]), 1e-6),
        (replace(FABRIC, law=LAWS["table"]), 1e-6),
        (replace(FABRIC, law=LAWS["constant"]), 2e-6),
        (replace(FABRIC, exit_tension=149.9e3, law=RUBBER), 1e-6),
    ],
    ids=["cord with an overrun", "softening, braking", "table", "constant", "idling"],
)
def test_strips_marched_from_their_entry_end_as_found(arc: object, miss: float) -> None:
    """Source: SciPy's march of order 8; and the conditions at the ends, of the page on it."""
    given = wide(
        arc,  # type: ignore[arg-type]
        STRIPS, 6e4, radius_deviation=crown(0.6e-3, STRIPS), entry_misfit=1e-4 * mode(1, STRIPS),
        entry_profile=2e3 * mode(2, STRIPS),
    )  # fmt: skip
    found = AcrossSolver().solve(given)
    assert found.status.solved
    assert found.error_estimate < 1e-6
    t2, u2 = marched(given, found.entry_tension, found.drum_number)
    width, m = given.arc.width, given.belt_modulus
    assert found.exit_tension == pytest.approx(t2, abs=miss * float(np.max(t2)))
    assert found.exit_creep == pytest.approx(u2, abs=miss * float(np.max(np.abs(u2))))
    assert np.mean(found.entry_tension) == pytest.approx(given.arc.entry_tension / width, rel=1e-9)
    assert np.mean(t2) == pytest.approx(given.arc.exit_tension / width, rel=1e-6)
    for k in (1, 2, 3):
        shape = mode(k, STRIPS)
        free = given.length_before[k - 1] * (given.entry_profile - found.entry_tension)
        path = given.entry_misfit + u2 - found.fields.creep[0]
        closing = shape @ (path + (free - given.length_after[k - 1] * t2) / m)
        size = float(np.max(np.abs(u2)) + given.length_after[k - 1] * np.max(t2) / m)
        assert closing == pytest.approx(0.0, abs=miss * size)
