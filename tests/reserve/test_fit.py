"""The reserve under fitted laws: their interval as a check, and as the uncertainty of friction."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from reserve.follow import changed_drive, faults
from reserve.test_find import euler, flip_of
from wraparc import solve
from wraparc.answer.reserve_check import judge_uncertain
from wraparc.batch.interval import Fitted, farthest_creeps
from wraparc.checks import Level, judge
from wraparc.checks.variant_rows import VariantRows
from wraparc.drive import Drive
from wraparc.files import drive_from_document
from wraparc.reserve import find_probability, find_reserve, uncertainty_of
from wraparc.reserve.inputs import inputs_of
from wraparc.reserve.uncertainty import FIT
from wraparc.train.whole import by_pulley

#: Standard deviations of the logarithms of peak friction and peak slip, and Student's factor.
SPREAD, SLIPS, FACTOR = 0.03, 0.05, 2.1
QUANTITIES = ("peak_friction", "peak_slip")
PRESSURES = (100.0, 250.0, 500.0)


def fitted(pull: str = "60 kN", factor: float = FACTOR) -> Drive:
    """Return a drive under a law of three knots, every peak with an uncertainty of its own."""
    knots = [
        {"pressure": f"{p:g} kPa", "peak_friction": f, "peak_slip": f"{x:g} mm"}
        for p, f, x in zip(PRESSURES, (0.9, 0.75, 0.6), (12.0, 14.0, 16.0), strict=True)
    ]
    values = [0.9, 0.75, 0.6, 0.012, 0.014, 0.016]
    spreads = [SPREAD] * 3 + [SLIPS] * 3
    covariance = np.diag([(s * v) ** 2 for s, v in zip(spreads, values, strict=True)])
    law: dict[str, Any] = {"kind": "integral-log", "knots": knots}
    law["fit"] = {
        "parameters": [f"knots[{k}].{q}" for q in QUANTITIES for k in (1, 2, 3)],
        "values": values, "covariance": covariance.tolist(), "coverage_factor": factor,
    }  # fmt: skip
    given = euler(lagging={"own": {"thickness": "10 mm", "shear_modulus": "1.6 MPa",
                                   "compression_modulus": "8 MPa", "law": law}})  # fmt: skip
    given["pulley"][0]["effective_tension"] = pull
    given["pulley"][0]["creep_limit"] = "5 mm"
    return drive_from_document(given)


def test_rows_have_the_end_of_the_interval_of_single_arcs() -> None:
    """Expected: the interval that the solver of one arc finds, under each law."""
    drive, factors = fitted(), np.array([1.0, 1.2, 1.5])
    lagging = drive.pulleys[0].lagging
    rows = VariantRows(
        drives=(drive,), which=np.zeros(3, dtype=np.int64), lift=np.zeros(3), pull=np.ones(3),
        factors={"friction": factors},
    )  # fmt: skip
    law = Fitted(lagging.law, lagging.fit)
    found = farthest_creeps(rows.arcs().arcs, [law], (factors, np.ones(3)))
    (friction, *_) = inputs_of(drive)
    assert friction.name == "friction"
    for creep, factor in zip(found.tolist(), factors.tolist(), strict=True):
        ends = solve(changed_drive(drive, friction, factor - 1.0)).governing.creep_interval
        assert creep == pytest.approx(max(ends), rel=2e-4)
        assert creep > 1.05 * abs(min(ends))


def test_the_reserve_counts_the_interval() -> None:
    """Every change holds from both sides, and the interval decides before the creep does."""
    result = solve(fitted())
    reserve = find_reserve(result)
    assert (reserve.level, reserve.reason) == ("OK", "")
    assert len(reserve.flips) > 5
    assert [*faults(result, reserve, reserve.flips)] == []
    pull = flip_of(reserve, "effective_tension", 1.0)
    assert pull is not None
    changed = changed_drive(by_pulley(result).drive, pull.input, pull.change)
    assert [check.name for check in judge(solve(changed)).missed] == ["creep_interval"]


def test_friction_is_uncertain_by_its_fit() -> None:
    """The 95 % interval of the peaks, and no check of its own: the interval of the creep is it."""
    result = solve(fitted())
    reserve = find_reserve(result)
    for name, spread in (("friction", SPREAD), ("slip", SLIPS)):
        (of,) = (of for of in reserve.inputs if of.name == name)
        found = uncertainty_of(by_pulley(result).drive, of)
        assert found.kind == FIT
        assert found.value == pytest.approx(math.expm1(FACTOR * spread))
        assert found.lower == pytest.approx(1.0 - math.exp(-FACTOR * spread))
        assert found.source == "95 % interval of the law of lagging own"
    # within that interval the verdict changes, and the level stays
    assert any(flip.is_within and flip.uncertainty.kind == FIT for flip in reserve.flips)
    assert judge_uncertain(result) is judge(result)
    assert "reserve" not in {check.name for check in judge_uncertain(result).checks}


def test_draws_have_friction_once() -> None:
    """Friction is drawn from its fit: that the end of its interval passes is not asked of draws.

    A drive that only the interval fails is OK in more than half of them.
    """
    result = solve(fitted("63 kN"))
    assert [check.name for check in judge(result).missed] == ["creep_interval"]
    found = find_probability(result)
    assert found.reason == ""
    assert 0.5 < found.shares[Level.OK] < 1.0
