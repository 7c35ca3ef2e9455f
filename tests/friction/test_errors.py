"""What the laws refuse, in whole sentences. Expected values: the words of the errors themselves."""

from __future__ import annotations

from collections.abc import Callable
from math import exp, inf, nan

import pytest

from arc.drives import RANGE
from wraparc import InputError
from wraparc.friction import (
    CoefficientPieces,
    Constant,
    ElasticPlastic,
    IntegralLog,
    MeasuredTable,
    Piece,
    PressureKnots,
    PressurePower,
    TestedRange,
    Trend,
)


def problems(make: Callable[[], object]) -> list[str]:
    with pytest.raises(InputError) as caught:
        make()
    return [str(problem) for problem in caught.value.problems]


def flat(value: float) -> Trend:
    return Trend(coefficients=(value,))


CASES: dict[str, tuple[Callable[[], object], list[str]]] = {
    "tested range": (
        lambda: TestedRange(pressure_min=3e5, pressure_max=2e5, slip_max=0.0),
        [
            "pressure: the tested pressures must be positive, finite and in order, got "
            "300000 .. 200000 Pa.",
            "slip_max: the largest tested slip must be positive and finite, got 0 m.",
        ],
    ),
    "constant": (
        lambda: Constant(friction_coefficient=-0.4),
        ["friction_coefficient: friction must be at least 1e-06 and finite, got -0.4."],
    ),
    "not a number": (
        lambda: Constant(friction_coefficient=nan),
        ["friction_coefficient: friction must be at least 1e-06 and finite, got nan."],
    ),
    "elastic-plastic": (
        lambda: ElasticPlastic(stiffness=inf, friction_coefficient=0.0),
        [
            "friction_coefficient: friction must be at least 1e-06 and finite, got 0.",
            "stiffness: the stiffness must be positive and finite, got inf Pa/m.",
        ],
    ),
    "power": (
        lambda: PressurePower(friction_coefficient=0.0, reference_pressure=-1.0, exponent=1.0),
        [
            "friction_coefficient: friction must be at least 1e-06 and finite, got 0.",
            "reference_pressure: the pressure must be positive and finite, got -1 Pa.",
            "exponent: the exponent must lie in 0 <= n < 1, got 1.",
        ],
    ),
    "knots out of order": (
        lambda: PressureKnots(
            pressure=(2e5, 1e5), peak_friction=(0.8, -0.7), peak_slip=(0.01, 0.0)
        ),
        [
            "pressure: the pressures of the knots must be positive and in ascending order, "
            "got 200000, 100000 Pa.",
            "peak_friction: friction must be at least 1e-06, got 0.8, -0.7.",
            "peak_slip: slip at the peak must be 1 nm to 1 km, got 0.01, 0 m.",
        ],
    ),
    "tails": (
        lambda: PressureKnots(
            pressure=(1e5,),
            peak_friction=(0.8,),
            peak_slip=(0.01,),
            post_peak_slope=(3.0,),
            residual_friction=(0.0,),
        ),
        [
            "post_peak_slope: the slope past the peak must be 0 or negative, got 3 1/m.",
            "residual_friction: residual friction must be at least 1e-06, got 0.",
        ],
    ),
    "columns of different length": (
        lambda: PressureKnots(
            pressure=(1e5, 2e5),
            peak_friction=(0.8,),
            peak_slip=(0.01, 0.01),
            post_peak_slope=(-1.0,),
        ),
        [
            "peak_friction: must have 2 values, one for each pressure, got 1 values.",
            "post_peak_slope: must have 2 values, one for each pressure, got 1 values.",
        ],
    ),
    "no knots": (
        lambda: PressureKnots(pressure=(), peak_friction=(), peak_slip=()),
        ["pressure: at least one knot is needed, got 0."],
    ),
    "ends of the tested range": (
        lambda: IntegralLog(
            coefficients=PressureKnots(
                pressure=(4e4, 5e5), peak_friction=(0.8, 0.7), peak_slip=(0.01, 0.01)
            ),
            tested=RANGE,
        ),
        [
            "tested: the tested pressures must be the ends of the law, 40000 .. 500000 Pa, "
            "got 40000 .. 600000 Pa.",
        ],
    ),
    "trend": (
        lambda: Trend(form="cubic", coefficients=(), sign=2),  # type: ignore[arg-type]
        [
            "form: the form must be one of polynomial, logarithmic, power, exponential, got cubic.",
            "coefficients: one to four coefficients are needed, got 0.",
            "sign: the sign must be 1 or -1, got 2.",
        ],
    ),
    "trend with an infinite coefficient": (
        lambda: Trend(coefficients=(1.0, inf)),
        ["coefficients: must be finite, got (1.0, inf)."],
    ),
    "transition pressures": (
        lambda: CoefficientPieces(
            pressure=(2e5, 1e5, 3e5), pieces=(Piece(a=flat(-1), b=flat(-3)),), slip_unit=0.0
        ),
        [
            "pressure: must have 2 pressures, the ends of 1 pieces, got 200000, 100000, 300000 Pa.",
            "slip_unit: the unit of slip must be positive and finite, got 0 m.",
            "pressure: the transition pressures must be positive, finite and in ascending "
            "order, got 200000, 100000, 300000 Pa.",
        ],
    ),
    "negative friction": (
        lambda: CoefficientPieces(
            pressure=(1e5, 2e5, 3e5),
            pieces=(
                Piece(a=flat(0.5), b=flat(-3)),
                Piece(
                    a=flat(-1),
                    b=flat(-3),
                    post_peak_slope=flat(1.0),
                    residual_friction=flat(-0.1),
                ),
            ),
        ),
        [
            "pieces[1].a: A must be negative between 100000 and 200000 Pa, else the law "
            "gives no positive friction, got 0.5 1/m.",
            "pieces[2].post_peak_slope: the slope past the peak must be 0 or negative "
            "between 200000 and 300000 Pa, got 1 1/m.",
            "pieces[2].residual_friction: residual friction must be at least 1e-06 between "
            "200000 and 300000 Pa, got -0.1.",
        ],
    ),
    "peak at no finite slip": (
        lambda: CoefficientPieces(pressure=(1e5, 2e5), pieces=(Piece(a=flat(-1e-3), b=flat(-3)),)),
        [
            "pieces[1].b: the slip at the peak exp(b/A - 1) must be 1 nm to 1 km between "
            "100000 and 200000 Pa, got -3 1/m.",
        ],
    ),
    "peak beyond all that can slip": (  # 5e84 m, of a misplaced decimal point
        lambda: CoefficientPieces(
            pressure=(1e5, 2e5), pieces=(Piece(a=flat(-0.05), b=flat(-9.8)),), slip_unit=1e-3
        ),
        [
            "pieces[1].b: the slip at the peak exp(b/A - 1) must be 1 nm to 1 km between "
            "100000 and 200000 Pa, got -9.8 1/m.",
        ],
    ),
    "slips of a table beyond that": (
        lambda: MeasuredTable(slip=(0.0, 1e-3, 2e3), pressure=(1e5,), values=((0.0, 0.4, 0.5),)),
        ["slip: the slips must be at most 1 km, got 2000 m."],
    ),
    "pieces that do not meet": (
        lambda: CoefficientPieces(
            pressure=(1e5, 2e5, 3e5),
            pieces=(Piece(a=flat(-1), b=flat(-3)), Piece(a=flat(-1), b=flat(-3.1))),
        ),
        [
            "pieces[2]: peak friction jumps at the transition pressure 200000 Pa; pieces "
            "must meet within 2 %, got 7.38906 and 8.16617.",
            "pieces[2]: peak slip jumps at the transition pressure 200000 Pa; pieces must "
            "meet within 2 %, got 7.38906 and 8.16617.",
        ],
    ),
    "table": (
        lambda: MeasuredTable(
            slip=(1e-3, 5e-3), pressure=(2e5, 1e5), values=((0.1, 0.2), (0.1, -0.2, 0.3))
        ),
        [
            "slip: at least two slips, the first of them 0, are needed, got 2 slips.",
            "pressure: the pressures must be positive and in ascending order.",
            "friction: the table must have a row of 2 values for each of 2 pressures.",
            "friction: friction must be at least 1e-06 past slip 0, that or 0 at slip 0.",
        ],
    ),
    "table with a jump at one pressure only": (
        lambda: MeasuredTable(
            slip=(0.0, 5e-3, 4e-3),
            pressure=(1e5, 2e5),
            values=((0.0, 0.2, 0.3), (0.1, 0.2, nan)),
        ),
        [
            "values: the table must hold finite numbers only.",
            "slip: the slips must be in ascending order.",
            "friction: friction must be at least 1e-06 past slip 0, that or 0 at slip 0.",
            "friction: friction at slip 0 must be 0 at every pressure or positive at every "
            "pressure.",
        ],
    ),
}


@pytest.mark.parametrize(("make", "sentences"), CASES.values(), ids=CASES.keys())
def test_sentence(make: Callable[[], object], sentences: list[str]) -> None:
    assert problems(make) == sentences


def test_all_errors_at_once() -> None:
    make, sentences = CASES["knots out of order"]
    with pytest.raises(InputError) as caught:
        make()
    assert str(caught.value) == "3 problems:\n" + "\n".join(f"  - {s}" for s in sentences)


def test_rounded_coefficients_may_miss_by_what_is_allowed() -> None:
    # b moves the peak by exp(0.019): 1.9 %, inside the 2 % that printed coefficients are allowed
    pieces = (Piece(a=flat(-1), b=flat(-3)), Piece(a=flat(-1), b=flat(-3.019)))
    law = CoefficientPieces(pressure=(1e5, 2e5, 3e5), pieces=pieces)
    assert law.continuity == 0.02
    assert (
        len(
            problems(
                lambda: CoefficientPieces(pressure=(1e5, 2e5, 3e5), pieces=pieces, continuity=0.01)
            )
        )
        == 2
    )


def _tails(*tails: tuple[float, float]) -> CoefficientPieces:
    """Pieces of peak friction e^2 at a slip of e^2, each with a slope [1/m] and a residual."""
    made = tuple(
        Piece(a=flat(-1), b=flat(-3), post_peak_slope=flat(m), residual_friction=flat(r))
        for m, r in tails
    )
    pressure = tuple(1e5 * (k + 1) for k in range(len(tails) + 1))
    return CoefficientPieces(pressure=pressure, pieces=made)


def test_tails_past_the_peak_must_meet_too() -> None:
    """Peak e^2 at e^2: a slope of -0.1 takes a tenth of the peak friction off over a peak slip."""
    assert problems(lambda: _tails((-0.1, 5.0), (-0.13, 5.0))) == [
        "pieces[2].post_peak_slope: the slope past the peak jumps at the transition pressure "
        "200000 Pa; pieces must meet within 2 % of the peak friction over a peak slip, got "
        "-0.1 and -0.13 1/m."
    ]
    assert problems(lambda: _tails((-0.1, 5.0), (-0.1, 5.2))) == [
        "pieces[2].residual_friction: residual friction jumps at the transition pressure "
        "200000 Pa; pieces must meet within 2 %, got 5 and 5.2."
    ]
    _tails((-0.1, 5.0), (-0.119, 5.09))  # within 2 %
    _tails((0.0, 9.0), (-0.5, 9.0))  # a slope without a level below the peak does nothing


def test_tails_of_pieces_are_continuous_functions_of_pressure() -> None:
    """Across the transition friction steps by no more than the continuity that was asked for."""
    law = IntegralLog(coefficients=_tails((-0.1, 5.0), (-0.115, 5.05)))
    peak = exp(2.0)
    for slip in (0.5 * peak, peak, 1.5 * peak, 2.0 * peak, 9.0 * peak):
        low, high = (float(law.friction(slip, p)) for p in (2e5 * (1 - 1e-12), 2e5 * (1 + 1e-12)))
        assert abs(high - low) <= 0.02 * peak * max(1.0, slip / peak - 1.0)
