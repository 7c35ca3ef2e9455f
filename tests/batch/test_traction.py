"""Traction of rows against the scalar source, and that against the laws.

Expected values: `FrictionLaw.friction`, written for arrays of slip and pressure on its own; slopes
by differences; the scalar source for the rows.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest
from numpy.typing import NDArray

from arc.drives import LAWS
from arc.wide import any_table
from batch.mixed import knotted
from wraparc.arc import traction as one
from wraparc.batch.traction import Laws, laws_of
from wraparc.friction import FrictionLaw, IntegralLog, PressureKnots
from wraparc.friction.compact import residual_at, segment_of

Array = NDArray[np.float64]

TABLES = [any_table(np.random.default_rng([31, k])) for k in range(8)]
UNLIKE = [knotted(np.random.default_rng([32, k]), softens=k % 3 == 0) for k in range(12)]
#: more knots than a byte counts, beside two
LONG = IntegralLog(
    coefficients=PressureKnots(
        pressure=tuple(np.linspace(3e4, 9e5, 300).tolist()),
        peak_friction=tuple(np.linspace(1.2, 0.4, 300).tolist()),
        peak_slip=tuple(np.linspace(5e-3, 25e-3, 300).tolist()),
    )
)
SHORT = IntegralLog(
    coefficients=PressureKnots(
        pressure=(5e4, 4e5), peak_friction=(1.1, 0.6), peak_slip=(8e-3, 20e-3)
    )
)
LAW_SETS: dict[str, Sequence[FrictionLaw]] = {
    **{name: [law] for name, law in LAWS.items()},
    "many by knots": [LAWS["rubber"], LAWS["softening"]],
    "unlike numbers of knots": UNLIKE,
    "very unlike numbers of knots": [SHORT, LONG],
    "many with a limit": [LAWS["constant"], LAWS["power"], LAWS["elastic-plastic"]],
    "many tables": TABLES,
}


def asked(
    laws: Sequence[FrictionLaw], n: int = 400
) -> tuple[Laws, NDArray[np.int64], Array, Array, Array]:
    """Rows of laws; their places, shear, pressures and creeps, within what shear keeps unique."""
    rng = np.random.default_rng(30)
    row = rng.integers(0, len(laws), n)
    pressure = np.exp(rng.uniform(np.log(5e3), np.log(2e6), n))
    creep = np.exp(rng.uniform(np.log(1e-9), np.log(0.3), n)) * rng.choice([-1.0, 1.0], n)
    fall = np.array([law.steepest_fall() for law in laws])[row]
    shear = np.exp(rng.uniform(np.log(1e-11), np.log(1e-8), n))
    unique = np.where(fall < 0.0, -0.9 / np.where(fall < 0.0, fall * pressure, -1.0), np.inf)
    shear = np.where(rng.random(n) < 0.2, 0.0, np.minimum(shear, unique))
    return laws_of([law.compact() for law in laws], row), row, shear, pressure, creep


@pytest.mark.parametrize("name", LAW_SETS)
def test_slip_and_shear_add_up_to_the_creep_under_the_law(name: str) -> None:
    laws = LAW_SETS[name]
    rows, row, shear, pressure, creep = asked(laws)
    found = rows.stress(shear, pressure, creep)
    np.testing.assert_allclose(found.slip + shear * found.stress, creep, rtol=1e-9, atol=1e-15)
    for i in np.flatnonzero(found.slip != 0.0):
        mu = float(laws[row[i]].friction(found.slip[i], pressure[i]))
        assert found.stress[i] == pytest.approx(mu * pressure[i], rel=1e-9, abs=1e-9)
    # a belt that is held shears by no more than what the law holds
    held = found.slip == 0.0
    assert np.all(np.abs(found.stress[held]) <= (rows.jump(pressure) * pressure)[held] * (1 + 1e-9))


@pytest.mark.parametrize("name", LAW_SETS)
def test_rows_are_the_scalar_source(name: str) -> None:
    laws = LAW_SETS[name]
    rows, row, shear, pressure, creep = asked(laws)
    found = rows.stress(shear, pressure, creep)
    for i in range(len(row)):
        law = laws[row[i]].compact()
        expected = one.traction(law, shear[i], pressure[i], creep[i])
        got = [float(column[i]) for column in found]
        assert got == pytest.approx(expected, rel=1e-9, abs=1e-12), (name, i)
        plateau = one.plateau_stress(law, pressure[i])
        assert rows.plateau(pressure)[i] * pressure[i] == pytest.approx(plateau, rel=1e-12)
        residual = residual_at(law, segment_of(law, pressure[i]), pressure[i]) * pressure[i]
        assert rows.residual(pressure)[i] * pressure[i] == pytest.approx(residual, rel=1e-12)


@pytest.mark.parametrize("name", LAWS)
def test_slopes_are_differences(name: str) -> None:
    """Where no kink of the law lies between: of nine tenths of random places."""
    rows, _, shear, pressure, creep = asked([LAWS[name]])
    found = rows.stress(shear, pressure, creep)
    step = 1e-6
    further = rows.stress(shear, pressure, creep * (1.0 + step))
    tighter = rows.stress(shear, pressure * (1.0 + step), creep)
    by_creep = (further.stress - found.stress) / (step * creep)
    by_pressure = (tighter.stress - found.stress) / (step * pressure)
    size = np.abs(found.stress / creep) + found.by_creep
    assert np.quantile(np.abs(by_creep - found.by_creep) / size, 0.9) < 1e-4
    size = np.abs(found.stress / pressure) + np.abs(found.by_pressure) + 1e-9
    assert np.quantile(np.abs(by_pressure - found.by_pressure) / size, 0.9) < 1e-4


@pytest.mark.parametrize("name", LAW_SETS)
def test_excess_is_the_integral_of_friction_over_its_residual(name: str) -> None:
    laws = LAW_SETS[name]
    rows, row, _, pressure, _ = asked(laws, 12)
    found = rows.excess(pressure)
    slip = np.concatenate([[0.0], np.exp(np.linspace(np.log(1e-9), np.log(2.0), 200_001))])
    for i in range(len(row)):
        mu = laws[row[i]].friction(slip, pressure[i])
        mu[0] = mu[1]
        over = mu - mu[-1]
        integral = float(np.sum(0.5 * (over[1:] + over[:-1]) * np.diff(slip)))
        # elastic-plastic laws are taken as ones that do not rise: nothing falls there
        if name != "elastic-plastic" and "limit" not in name:
            assert found[i] == pytest.approx(integral, rel=1e-4, abs=1e-7)
