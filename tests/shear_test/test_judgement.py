"""No false OK and no false ATTENTION: known laws and known faults behind virtual laboratories."""

from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
import pytest

from shear_test.virtual import PRESSURES, fitted, laboratory
from wraparc.checks import Level
from wraparc.friction import IntegralLog, PressureKnots
from wraparc.report.shear_test_tables import verdict
from wraparc.shear_test import MachineRecord, PlanResult, TestPlan

SCATTERED = {"points": 250, "scatter_friction": 0.02, "scatter_slip": 0.03}
SMALL = PRESSURES[[0, 2, 4, 6]]


def smooth() -> IntegralLog:
    """Powers of pressure, without any corner."""
    p = np.round(np.geomspace(PRESSURES[0], PRESSURES[-1], 60), 3)
    return IntegralLog(
        coefficients=PressureKnots(
            pressure=tuple(p.tolist()),
            peak_friction=tuple((1.25 * (p / p[0]) ** -0.3).tolist()),
            peak_slip=tuple((0.010 * (p / p[0]) ** 0.15).tolist()),
        )
    )


def scattered(**options: Any) -> tuple[TestPlan, dict[str, MachineRecord]]:
    return laboratory(**(SCATTERED | options))


@cache
def sound(seed: int, repeats: int) -> PlanResult:
    return fitted(
        *scattered(seed=seed, repeats=repeats, pressures=PRESSURES if repeats == 1 else SMALL)
    )


@pytest.mark.parametrize(("seed", "repeats"), [(1, 1), (2, 1), (3, 1), (4, 2), (6, 2)])
def test_a_sound_laboratory_is_not_accused(seed: int, repeats: int) -> None:
    """A limit of two noise levels for left-out pressures accused every one of these."""
    assert verdict(sound(seed, repeats)).level is Level.OK


def test_a_pressure_that_the_others_miss_is_named() -> None:
    """Expected: the shift of 35 % at one pressure of eight, both repeats, is far over chance."""
    plan, records = scattered(seed=1, repeats=2)
    for name in ("p3r0", "p3r1"):
        records[name] = replace(records[name], force=1.35 * records[name].force)
    found = fitted(plan, records)
    missed = [
        round(item.pressure, -3) for item in found.conditions[0].found.left_out if item.missed
    ]
    assert 138e3 in missed
    assert verdict(found).level is Level.ATTENTION
    assert "standard deviations where chance reaches" in " ".join(found.conditions[0].misfit)


def test_three_pressures_cannot_tell_the_error_of_their_predictions() -> None:
    found = fitted(*scattered(seed=1, repeats=2, pressures=SMALL[:3])).conditions[0].found
    assert all(np.isnan(item.distance) and not item.missed for item in found.left_out)


@pytest.mark.parametrize("seed", [1, 2])
def test_a_smooth_law_shows_no_transition(seed: int) -> None:
    found: Any = fitted(*scattered(seed=seed, repeats=2, law=smooth())).conditions[0]
    assert found.found.choice.two_pieces is not None
    assert found.found.transition is None
    assert any(
        r.startswith("no transition is shown: a smooth law does as well") for r in found.remarks
    )
