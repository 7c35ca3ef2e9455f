"""The interval of the creep by the uncertainty of a fitted law."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from wraparc.arc import Distributed, PaperMarch, Status, WrapArc
from wraparc.arc.answer import operating_point
from wraparc.drive import Fit, with_peaks
from wraparc.friction import IntegralLog, PressureKnots

PRESSURES = (40e3, 100e3, 180e3, 280e3, 400e3, 700e3)
LAW = IntegralLog(
    coefficients=PressureKnots(
        pressure=PRESSURES,
        peak_friction=(1.25, 1.0, 0.85, 0.72, 0.6, 0.4),
        peak_slip=(15e-3, 17e-3, 19e-3, 21e-3, 23e-3, 24e-3),
    )
)
QUANTITIES = ("peak_slip", "peak_friction")


def fit(spread: float, law: IntegralLog = LAW, *, factor: float = 1.96) -> Fit:
    """Statistics made up: knots near each other go together, slip and friction in part."""
    knots = law.coefficients
    n = len(knots.pressure)
    values = np.array([getattr(knots, q) for q in QUANTITIES]).ravel()
    near = np.exp(-0.5 * np.abs(np.subtract.outer(np.arange(n), np.arange(n))))
    logs = spread**2 * np.kron([[1.0, 0.3], [0.3, 0.6]], near)
    return Fit(
        parameters=tuple(f"knots[{k + 1}].{q}" for q in QUANTITIES for k in range(n)),
        values=tuple(values.tolist()),
        covariance=tuple(map(tuple, (logs * np.outer(values, values)).tolist())),
        coverage_factor=factor,
    )


def arc(entry: float = 150e3, leaving: float = 60e3, **changed: object) -> WrapArc:
    usual: dict[str, object] = {
        "law": LAW, "entry_tension": entry, "exit_tension": leaving, "diameter": 0.8,
        "wrap_angle": math.pi, "width": 1.2, "axial_stiffness": 8e6, "thickness": 12e-3,
        "shear_modulus": 1e6, "compression_modulus": 8e6,
    }  # fmt: skip
    return WrapArc(**(usual | changed))  # type: ignore[arg-type]


@pytest.mark.parametrize(("entry", "leaving"), [(150e3, 60e3), (70e3, 150e3)])
def test_the_interval_holds_95_of_100_laws_drawn_from_the_fit(entry: float, leaving: float) -> None:
    """Quantiles of 200 draws: each end within 0.15 of the interval's length.

    The quantile of 2.5 % of 200 draws has a standard error of 2.7 / sqrt(200) = 0.19 standard
    deviations, 5 % of the interval's length.
    """
    of = arc(entry, leaving, fit=fit(0.04))
    low, high = Distributed(capacities=False).solve(of).creep_interval
    statistics = of.fit
    assert statistics is not None
    root = np.linalg.cholesky(statistics.log_covariance)
    random = np.random.default_rng(4)
    drawn = []
    for _ in range(200):
        moved = np.array(statistics.values) * np.exp(root @ random.standard_normal(len(root)))
        law = with_peaks(LAW, dict(zip(statistics.knots, moved.tolist(), strict=True)))
        found = operating_point(law.compact(), of.geometry(), entry, leaving)
        drawn.append(found.met.course.creep[-1])
    ends = np.quantile(drawn, [0.025, 0.975])
    assert abs(low - ends[0]) < 0.15 * (high - low)
    assert abs(high - ends[1]) < 0.15 * (high - low)


def test_slip_alone_scales_the_creep_of_an_arc_without_elasticity() -> None:
    """Closed form: belt and lagging rigid, the creep is one slip, a fixed part of x_pk.

    One knot with an uncertain x_pk and nothing else: the interval is x_pk's.
    """
    law = IntegralLog(
        coefficients=PressureKnots(pressure=(1e5,), peak_friction=(0.8,), peak_slip=(10e-3,))
    )
    sure = Fit(
        parameters=("knots[1].peak_slip",), values=(10e-3,), covariance=((1e-6,),),
        coverage_factor=2.5,
    )  # fmt: skip
    rigid = arc(law=law, axial_stiffness=math.inf, thickness=0.0, overrun=0.0, fit=sure)
    result = Distributed(capacities=False).solve(rigid)
    low, high = result.creep_interval
    assert low == pytest.approx(result.exit_creep * math.exp(-0.25), rel=1e-6)
    assert high == pytest.approx(result.exit_creep * math.exp(0.25), rel=1e-6)


def test_few_tests_widen_it_by_their_coverage_factor() -> None:
    """2.57 instead of 1.96 standard deviations (Student's t, 5 degrees of freedom)."""
    wide, usual = (
        Distributed(capacities=False).solve(arc(fit=fit(0.02, factor=k))).creep_interval
        for k in (2.571, 1.96)
    )
    assert wide[1] - wide[0] == pytest.approx((usual[1] - usual[0]) * 2.571 / 1.96, rel=5e-3)


def test_an_end_that_breaks_away_is_without_bound() -> None:
    """Just above the ratio that breaks away, with 10 % of uncertainty in friction."""
    law = replace(LAW)
    capacity = Distributed().solve(arc()).capacities.gross_slip_capacity
    tight = arc(150e3, 150e3 / (0.95 * capacity), law=law, fit=fit(0.1))
    result = Distributed().solve(tight)
    assert result.status is Status.SOLVED
    low, high = result.creep_interval
    assert low < result.exit_creep
    assert math.isinf(high)


def test_without_statistics_that_fit_the_law_there_is_none() -> None:
    beyond = replace(fit(0.04), parameters=tuple(f"knots[{k + 9}].peak_slip" for k in range(12)))
    other = replace(fit(0.04), parameters=tuple(f"pieces[{k}].A" for k in range(12)))
    for statistics in (None, beyond, other):
        result = Distributed(capacities=False).solve(arc(fit=statistics))
        assert np.isnan(result.creep_interval).all()
    assert np.isnan(PaperMarch().solve(arc(fit=fit(0.04))).creep_interval).all()
