"""Equations over pressure. Expected values: the same equation written in NumPy."""

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from wraparc import InputError
from wraparc.files.trends import read_trend, trend_text
from wraparc.friction import Trend

Function = Callable[[np.ndarray], np.ndarray]
KPA = np.array([34.0, 120.0, 230.0, 690.0])

EQUATIONS: list[tuple[str, Function]] = [
    ("-0.3", lambda p: -0.3 + 0 * p),
    ("0.12 - 0.00021 p + 1.4e-7 p^2", lambda p: 0.12 - 0.00021 * p + 1.4e-7 * p**2),
    ("5E-07p^2-0.0004p", lambda p: 5e-7 * p**2 - 0.0004 * p),
    ("-1e-9 * p^3 + .5", lambda p: -1e-9 * p**3 + 0.5),
    ("-0.31 + 0.042 ln(p)", lambda p: -0.31 + 0.042 * np.log(p)),
    ("0.042ln(p)-0.31", lambda p: 0.042 * np.log(p) - 0.31),
    ("1 - 0.2 ln(p) + 0.01 ln(p)^2", lambda p: 1 - 0.2 * np.log(p) + 0.01 * np.log(p) ** 2),
    ("-1.6 p^-0.45", lambda p: -1.6 * p**-0.45),
    ("p^(0.5)", lambda p: p**0.5),
    ("-0.2*exp(-0.0031 p)", lambda p: -0.2 * np.exp(-0.0031 * p)),
    ("-exp(0.31 - 0.45 ln(p))", lambda p: -np.exp(0.31 - 0.45 * np.log(p))),
    ("2 exp(0.1 - 1e-3 p + 1e-7 p^2)", lambda p: 2 * np.exp(0.1 - 1e-3 * p + 1e-7 * p**2)),
]


@pytest.mark.parametrize(("text", "function"), EQUATIONS)
@pytest.mark.parametrize("factor", [1.0, 1e3, 1 / 0.0254])
def test_equations_in_kilopascal(text: str, function: Function, factor: float) -> None:
    trend = read_trend(text, 1e3, factor)
    assert trend(KPA * 1e3) == pytest.approx(factor * function(KPA), rel=1e-12)


@pytest.mark.parametrize(("text", "function"), EQUATIONS)
def test_equations_in_psi(text: str, function: Function) -> None:
    psi = 6894.757293168361
    assert read_trend(text, psi)(KPA * psi) == pytest.approx(function(KPA), rel=1e-12)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "empty, where an equation is needed"),
        ("-", "no equation over the pressure p"),
        ("0.1 x", "no equation over the pressure p"),
        ("1 2", "no equation over the pressure p"),
        ("2 p p", "no equation over the pressure p"),
        ("0,1 p", "no equation over the pressure p"),
        ("0.1 - - p", "no equation over the pressure p"),
        ("__import__('os')", "no equation over the pressure p"),
        ("exp(" + "(" * 200, "no equation over the pressure p"),
        ("0.1 + ln(p) + p", "mixes kinds of trend lines"),
        ("1 + exp(p)", "mixes kinds of trend lines"),
        ("exp(exp(p))", "mixes kinds of trend lines"),
        ("p^2 + p^2", "has two terms of the same kind"),
        ("p^0.5 + 1", "adds a power of p besides 1, 2 and 3"),
        ("0 exp(p)", "is 0 everywhere"),
        ("1e999 p", "a number that is not finite"),
    ],
)
def test_what_is_no_equation(text: str, message: str) -> None:
    with pytest.raises(InputError) as caught:
        read_trend(text, 1e3)
    problem = caught.value.problems[0]
    assert problem.message == message
    assert problem.remedy == "Write a polynomial, logarithm, power or exponential of p."


NUMBERS = st.floats(min_value=1e-12, max_value=1e6).flatmap(lambda v: st.sampled_from([v, -v]))


@given(
    form=st.sampled_from(["polynomial", "logarithmic", "power", "exponential"]),
    coefficients=st.lists(NUMBERS, min_size=2, max_size=4),
    sign=st.sampled_from([1, -1]),
    factor=st.sampled_from([1.0, 1e3, 1 / 0.0254]),
)
def test_what_is_written_reads_back_equal(
    form: str, coefficients: list[float], sign: int, factor: float
) -> None:
    signed = sign if form in ("power", "exponential") else 1
    trend = Trend(form=form, coefficients=tuple(coefficients), sign=signed)  # type: ignore[arg-type]
    assert read_trend(trend_text(trend, factor), 1.0, factor) == trend


@given(st.text(alphabet="0123456789.eE+-*^() pln(exp)", max_size=40))
def test_no_text_is_more_than_refused(text: str) -> None:
    try:
        trend = read_trend(text, 1e3, 1e3)
    except InputError:
        return
    assert isinstance(trend, Trend)
