"""The integral-log law: its closed forms, units of A and b, dependence on pressure.

Expected values: the formula mu = A x ln x - b x of the paper (eq. 2) evaluated with 40 digits,
algebra done by hand, SciPy's PCHIP.
"""

from __future__ import annotations

import math

import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.interpolate import PchipInterpolator

from friction.laws import LAWS, TRENDS
from wraparc.friction import (
    CoefficientPieces,
    IntegralLog,
    Piece,
    PressureKnots,
    TestedRange,
    Trend,
    ab_from_peak,
    convert_ab,
    peak_from_ab,
)
from wraparc.friction.interpolation import evaluate, pchip

MM, INCH = 1e-3, 25.4e-3

peaks = st.tuples(st.floats(0.05, 3.0), st.floats(1e-4, 0.2))  # friction [-], slip [m]
units = st.sampled_from([1.0, MM, INCH, 12 * INCH, 1e-6])


def plain(peak_friction: float, peak_slip: float, slope: float, residual: float) -> IntegralLog:
    """A law without dependence on pressure."""
    return IntegralLog(
        coefficients=PressureKnots(
            pressure=(2e5,),
            peak_friction=(peak_friction,),
            peak_slip=(peak_slip,),
            post_peak_slope=(slope,),
            residual_friction=(residual,),
        )
    )


def exact(a: float, b: float, x: float) -> float:
    """A x ln x - b x with 40 digits."""
    with mpmath.workdps(40):
        return float(mpmath.mpf(a) * x * mpmath.log(x) - mpmath.mpf(b) * x)


@given(peaks, st.floats(1e-6, 1.0))
def test_the_law_is_the_formula_of_the_paper_up_to_its_peak(
    peak: tuple[float, float], r: float
) -> None:
    a, b = ab_from_peak(*peak)
    x = r * peak[1]
    # A x ln x and b x cancel: the size of either is what rounding is relative to
    size = abs(a * x * math.log(x)) + abs(b * x)
    got = float(plain(*peak, -1.0, 0.01).friction(x, 1e5))
    assert got == pytest.approx(exact(a, b, x), abs=4e-16 * size)


@given(peaks)
def test_peak_and_zero_of_the_formula(peak: tuple[float, float]) -> None:
    a, b = ab_from_peak(*peak)
    friction, slip = peak
    scale = abs(a * slip)
    assert a < 0.0
    assert exact(a, b, slip) == pytest.approx(friction, rel=1e-12)
    # slope A ln x + A - b is 0 at the peak, the formula is 0 at e times the slip of the peak
    assert abs(a * math.log(slip) + a - b) * slip <= 1e-14 * scale * (1 + abs(math.log(slip)))
    assert exact(a, b, math.e * slip) == pytest.approx(0.0, abs=1e-13 * scale * 10)
    assert exact(a, b, 0.999 * slip) < friction > exact(a, b, 1.001 * slip)


@given(peaks)
def test_ab_and_peak_are_inverse(peak: tuple[float, float]) -> None:
    assert peak_from_ab(*ab_from_peak(*peak)) == pytest.approx(peak, rel=1e-13)


def test_ab_by_hand() -> None:
    # x_pk = 20 mm, mu_pk = 0.86: A = -0.043 1/mm, b = -0.043 (1 + ln 20) 1/mm
    a, b = ab_from_peak(0.86, 20.0)
    assert a == pytest.approx(-0.043, rel=1e-15)
    assert b == pytest.approx(-0.043 * 3.995732273553991, rel=1e-15)
    # peak at e^2 of a law with A = -1, b = -3: exp(b/A - 1) = e^2 and mu = e^2
    assert peak_from_ab(-1.0, -3.0) == pytest.approx((math.e**2, math.e**2), rel=1e-15)


@given(peaks, units, units, st.floats(1e-5, 1.0))
def test_conversion_keeps_the_friction(
    peak: tuple[float, float], first: float, second: float, r: float
) -> None:
    a, b = ab_from_peak(peak[0], peak[1] / first)
    a_other, b_other = convert_ab(a, b, first, second)
    x = r * peak[1]
    # what rounding in A and b is relative to, in either unit
    size = sum(
        abs(k * x / unit) * (1 + abs(math.log(x / unit)))
        for k, unit in ((a, first), (a_other, second), (b, first), (b_other, second))
    )
    assert exact(a_other, b_other, x / second) == pytest.approx(
        exact(a, b, x / first), abs=1e-15 * size
    )


@given(peaks, units, units)
def test_conversion_there_and_back(peak: tuple[float, float], first: float, second: float) -> None:
    ab = ab_from_peak(peak[0], peak[1] / first)
    back = convert_ab(*convert_ab(*ab, first, second), second, first)
    scale = abs(ab[0]) * (1 + abs(math.log(first / second)))
    assert back[0] == pytest.approx(ab[0], rel=1e-15)
    assert back[1] == pytest.approx(ab[1], rel=1e-14, abs=1e-14 * scale)


def test_conversion_by_hand() -> None:
    # from metres to millimetres c = 1000: A / 1000, (b + A ln 1000) / 1000
    a, b = convert_ab(-43.0, 125.0, 1.0, MM)
    assert (a, b) == pytest.approx((-0.043, (125.0 - 43.0 * math.log(1000)) / 1000), rel=1e-15)
    a, b = convert_ab(-1.0, -3.0, INCH, MM)
    assert (a, b) == pytest.approx((-1 / 25.4, (-3.0 - math.log(25.4)) / 25.4), rel=1e-15)
    assert convert_ab(-1.0, -3.0, MM, MM) == (-1.0, -3.0)


@given(peaks, units)
def test_printed_coefficients_have_the_peak_of_the_law(
    peak: tuple[float, float], unit: float
) -> None:
    law = plain(*peak, 0.0, 9.0)
    friction, slip = peak_from_ab(*law.coefficients_ab(1e5, unit))
    assert (friction, slip * unit) == pytest.approx(peak, rel=1e-12)
    assert law.coefficients_ab(1e5) == law.coefficients_ab(1e5, MM)  # the paper's unit


def test_straight_line_past_the_peak_and_residual_level() -> None:
    # mu_pk 0.8 at 9 mm, -12 1/m from there: 0.6 is reached 16.67 mm later
    law = plain(0.8, 9e-3, -12.0, 0.6)
    x = np.array([9e-3, 10e-3, 20e-3, 9e-3 + 0.2 / 12, 0.03, 1.0])
    assert law.friction(x, 2e5) == pytest.approx([0.8, 0.788, 0.668, 0.6, 0.6, 0.6], rel=1e-14)
    # a residual level above the peak counts as the peak; without one there is no fall
    for residual in ((0.9,), ()):
        c = PressureKnots(
            pressure=(2e5,),
            peak_friction=(0.8,),
            peak_slip=(9e-3,),
            post_peak_slope=(-12.0,),
            residual_friction=residual,
        )
        assert np.all(IntegralLog(coefficients=c).friction(x, 2e5) == 0.8)


def test_knots_are_met_and_columns_are_monotone_between() -> None:
    for name in ("rubber", "softening", "crossing", "two knots"):
        law = LAWS[name]
        assert isinstance(law, IntegralLog)
        c = law.coefficients
        assert isinstance(c, PressureKnots)
        slip, peak, slope, residual = law.parameters(c.pressure)
        assert slip == pytest.approx(c.peak_slip, rel=1e-14)
        assert peak == pytest.approx(c.peak_friction, rel=1e-14)
        if c.post_peak_slope:
            assert slope == pytest.approx(c.post_peak_slope, rel=1e-14)
            assert residual == pytest.approx(np.minimum(c.residual_friction, peak), rel=1e-14)
        fine = np.geomspace(c.pressure[0], c.pressure[-1], 2000)
        assert np.all(np.diff(law.parameters(fine)[0]) > 0.0)
        assert np.all(np.diff(law.parameters(fine)[1]) < 0.0)
        wanted = PchipInterpolator(c.pressure, c.peak_slip)(fine)
        assert law.parameters(fine)[0] == pytest.approx(wanted, rel=1e-13)


columns = st.integers(2, 9).flatmap(
    lambda n: st.tuples(
        st.lists(st.floats(0.01, 3.0), min_size=n - 1, max_size=n - 1),
        st.lists(st.integers(-5000, 5000).map(lambda k: 1e-3 * k), min_size=n, max_size=n),
    )
)


@given(columns, st.lists(st.floats(0.0, 1.0), min_size=1, max_size=8))
def test_interpolation_is_scipys_pchip(
    column: tuple[list[float], list[float]], at: list[float]
) -> None:
    x = np.concatenate([[0.3], 0.3 + np.cumsum(column[0])])
    y = np.array(column[1])
    points = x[0] + np.array(at) * (x[-1] - x[0])
    wanted = PchipInterpolator(x, y)(points)
    assert evaluate(x, pchip(x, y), points) == pytest.approx(wanted, rel=1e-11, abs=1e-11)


def test_trend_forms() -> None:
    # by hand: 1 + 2 p + 3 p2 + 4 p3 at 10; 5 - 2 ln p at e^2; 2 p^-0.5 at 16; -3 e^(p/2) at 4
    assert Trend(coefficients=(1.0, 2.0, 3.0, 4.0))(10.0) == pytest.approx(4321.0)
    assert Trend(form="logarithmic", coefficients=(5.0, -2.0))(math.e**2) == pytest.approx(1.0)
    assert Trend(form="power", coefficients=(math.log(2), -0.5))(16.0) == pytest.approx(0.5)
    falling = Trend(form="exponential", coefficients=(math.log(3), 0.5), sign=-1)
    assert falling([0.0, 4.0]) == pytest.approx([-3.0, -3.0 * math.e**2])


def test_pieces_hold_a_and_b_in_their_own_unit() -> None:
    # the paper's unit: A = -0.05 1/mm and b/A - 1 = 2.9 at the transition pressure
    slip, friction, _, _ = TRENDS.parameters(172e3)
    assert slip == pytest.approx(MM * math.exp(2.9), rel=1e-12)
    assert friction == pytest.approx(0.05 * math.exp(2.9), rel=1e-12)
    assert TRENDS.coefficients_ab(172e3) == pytest.approx((-0.05, -0.05 * 3.9), rel=1e-12)
    c = TRENDS.coefficients
    assert isinstance(c, CoefficientPieces)
    for p in (34e3, 100e3, 172e3, 400e3, 690e3):
        piece = c.pieces[0 if p < 172e3 else 1]
        wanted = [exact(float(piece.a(p)), float(piece.b(p)), x) for x in (0.2, 1.0, 4.0)]
        assert TRENDS.friction([0.2e-3, 1e-3, 4e-3], p) == pytest.approx(wanted, rel=1e-13)


def test_pieces_agree_with_knots_where_both_are_constant() -> None:
    a, b = ab_from_peak(0.8, 9.0)
    constant = Piece(
        a=Trend(coefficients=(a,)),
        b=Trend(coefficients=(b,)),
        post_peak_slope=Trend(coefficients=(-12.0,)),
        residual_friction=Trend(coefficients=(0.6,)),
    )
    pieces = IntegralLog(
        coefficients=CoefficientPieces(pressure=(1e5, 3e5), pieces=(constant,), slip_unit=MM),
        tested=TestedRange(pressure_min=1e5, pressure_max=3e5, slip_max=0.01),
    )
    x = np.linspace(-0.05, 0.05, 101)
    assert pieces.friction(x, 2e5) == pytest.approx(
        plain(0.8, 9e-3, -12.0, 0.6).friction(x, 2e5), rel=1e-12, abs=1e-16
    )
