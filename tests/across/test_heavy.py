"""Mass of the belt across the width.

Expected values: the same belt without mass at tensions less m v^2, the arc of `solve`, and small
deviations against the whole solver.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from across.wides import CORD, FABRIC, RUBBER, braking, mode, wide
from wraparc.across.modes import mode_response
from wraparc.across.result import AcrossStatus
from wraparc.across.solver import AcrossSolver
from wraparc.arc import WrapArc

LIFT = 30e3  # [N]
THICK = replace(FABRIC, pitch_offset=12e-3, cover_compliance=6e-9)


def heavier(arc: WrapArc) -> WrapArc:
    """The same belt with a mass and as much more tension."""
    return replace(
        arc,
        entry_tension=arc.entry_tension + LIFT,
        exit_tension=arc.exit_tension + LIFT,
        centrifugal=LIFT,
    )


@pytest.mark.parametrize("recovery", [True, False])
@pytest.mark.parametrize("arc", [CORD, THICK, braking(THICK)], ids=["cord", "thick", "braking"])
def test_tensions_raised_by_the_centrifugal_force(arc: WrapArc, recovery: bool) -> None:
    """Creep, stress and energy as without mass at the lower tensions; its strain goes to Gamma."""
    arc, n = replace(arc, overrun=None, recovery=recovery), 8
    more: dict[str, Any] = {
        "radius_deviation": 1e-3 * mode(1, n),
        "thickness": arc.thickness * (1.0 + 0.1 * mode(2, n)),
        "entry_profile": 3e3 * mode(2, n),
    }
    light, heavy = (AcrossSolver().solve(wide(a, n, **more)) for a in (arc, heavier(arc)))
    a, b = light.fields, heavy.fields
    assert np.allclose(a.tension + LIFT / arc.width, b.tension, rtol=1e-9)
    for column in ("wrap_pressure", "creep", "slip", "shear_stress", "frictional_energy"):
        one, other = getattr(a, column), getattr(b, column)
        assert np.allclose(one, other, rtol=1e-7, atol=1e-8 * float(np.max(np.abs(one))))
    strain = LIFT / arc.axial_stiffness
    assert heavy.drum_number == pytest.approx(light.drum_number + strain, rel=1e-8)
    assert heavy.entry_creep_ratio == pytest.approx(light.entry_creep_ratio, rel=1e-6)
    assert heavy.identity_error < 1e-6
    wider = heavy.static_tension, heavy.span_tension
    for one, other in zip((light.static_tension, light.span_tension), wider, strict=True):
        assert one + LIFT / arc.width == pytest.approx(other, rel=1e-8)


def test_an_even_belt_is_that_of_the_arc() -> None:
    arc = heavier(replace(THICK, overrun=None))
    found = AcrossSolver().solve(wide(arc, 4))
    assert found.entry_creep_ratio == pytest.approx(found.even.entry_creep_ratio, rel=5e-6)
    assert found.exit_creep == pytest.approx(found.even.exit_creep, rel=5e-6)


@pytest.mark.parametrize("recovery", [True, False])
def test_small_deviations_are_those_of_the_modes(recovery: bool) -> None:
    """0.01 mm of radius and of lagging, 1e-4: what a worn lagging does is squeezed by t - m v^2."""
    arc, n = heavier(replace(THICK, overrun=None, recovery=recovery)), 8
    for cause, shape in (("radius", 1e-5), ("lagging", 1e-5)):
        deviation = shape * mode(1, n)
        more: dict[str, Any] = {"radius_deviation": deviation}
        if cause == "lagging":
            more["thickness"] = arc.thickness + deviation
        given = wide(arc, n, **more)
        found = AcrossSolver(accuracy=1e-9).solve(given)
        column = 0 if cause == "radius" else 1
        response = mode_response(given, 2)
        amplitude = 1e-5 * np.sqrt(n / 2.0)
        for told, mine in (
            (found.entry_tension, response.entry_tension),
            (found.exit_tension, response.exit_tension),
            (found.fields.frictional_energy[-1], response.energy),
        ):
            own = float((found.wide.modes[1] @ told) / amplitude)
            assert own == pytest.approx(float(mine[0, column]), rel=1e-3)


def test_a_strip_that_is_flung_off_is_slack() -> None:
    """Where less than m v^2/B is left; without mass the same unevenness leaves tension there."""
    n, deviation = 8, 12e-3 * mode(1, 8)
    arc = replace(FABRIC, law=RUBBER)
    assert AcrossSolver().solve(wide(arc, n, radius_deviation=deviation)).status.solved
    flying = AcrossSolver().solve(
        wide(replace(arc, centrifugal=50e3), n, radius_deviation=deviation)
    )
    assert flying.status is AcrossStatus.SLACK
