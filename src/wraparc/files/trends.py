"""Equations over pressure as a spreadsheet prints them, read to trend lines in SI and back.

The grammar is small and closed; nothing is evaluated::

    0.12 - 0.00021 p + 1.4e-7 p^2        polynomial, up to p^3
    -0.31 + 0.042 ln(p)                  logarithmic, up to ln(p)^3
    -1.6 p^-0.45                         power
    -0.2 exp(-0.0031 p)                  exponential
    -exp(0.31 - 0.45 ln(p))              power or exponential, written by its exponent

Coefficients stay decimal until they are scaled, so that what is written reads back equal.
"""

import math
import re
from decimal import Decimal
from functools import cache
from typing import NamedTuple

from wraparc.errors import InputError, input_error, shown
from wraparc.friction import Trend
from wraparc.friction.trend import Form

_NUMBER = r"(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]{1,3})?"
_GRAMMAR = "Write a polynomial, logarithm, power or exponential of p."
_MOST_COEFFICIENTS = 4


class _Term(NamedTuple):
    coefficient: Decimal
    function: str  # "p", "ln", "exp"
    power: float
    exponent: Trend | None


def read_trend(text: str, pressure_unit: float = 1.0, factor: float = 1.0) -> Trend:
    """Return the trend line of an equation, times `factor`, over pressure in pascal.

    Parameters
    ----------
    text
        The equation, for the pressure p in `pressure_unit`.
    pressure_unit
        SI value of the unit of pressure [Pa].
    factor
        What the value of the equation is multiplied by, > 0.

    Raises
    ------
    InputError
        If the text is no equation of the grammar.
    """
    terms = _terms(text)
    single = terms[0] if len(terms) == 1 else None
    if single and single.exponent is not None:
        trend = _scaled_exponent(single.exponent, single.coefficient * Decimal(factor), text)
    elif single and single.function == "p" and single.power not in (0, 1, 2, 3):
        exponent = Trend(form="logarithmic", coefficients=(0.0, single.power))
        trend = _scaled_exponent(exponent, single.coefficient * Decimal(factor), text)
    else:
        trend = _sum(terms, text, Decimal(factor))
    return _over_pascal(trend, pressure_unit)


def trend_text(trend: Trend, factor: float = 1.0) -> str:
    """Return the equation over p in pascal that `read_trend` reads as this trend line.

    Parameters
    ----------
    trend
        The trend line.
    factor
        What reading will multiply the equation by, > 0.
    """
    variable = "ln(p)" if trend.form in ("logarithmic", "power") else "p"
    exponential = trend.form in ("power", "exponential")
    divisor = Decimal(1 if exponential else factor)
    text = ""
    for power, coefficient in enumerate(trend.coefficients):
        size = abs(Decimal(repr(coefficient)) / divisor)
        term = (
            f"{size}" if power == 0 else f"{size} {variable}" + (f"^{power}" if power > 1 else "")
        )
        minus = math.copysign(1.0, coefficient) < 0
        text += (" - " if minus else " + ") + term if text else ("-" if minus else "") + term
    if not exponential:
        return text
    number = "" if factor == 1.0 else f"{1 / Decimal(factor)} "
    return f"{'-' if trend.sign < 0 else ''}{number}exp({text})"


@cache
def _grammar() -> re.Pattern[str]:
    """Return the pattern of one term; few files need it."""
    return re.compile(
        rf"""\s*(?P<sign>[+-])?\s*(?P<number>{_NUMBER})?\s*\*?\s*
        (?P<factor>
            p (?:\s*\^\s* (?:\(\s*(?P<within>[+-]?{_NUMBER})\s*\) | (?P<power>[+-]?{_NUMBER})))?
          | ln\(\s*p\s*\) (?:\s*\^\s*(?P<log_power>[123]))?
          | exp\((?P<exponent>(?:[^()]|\(\s*p\s*\))*)\)
        )?\s*""",
        re.VERBOSE,
    )


def _terms(text: str) -> list[_Term]:
    pattern = _grammar()
    terms: list[_Term] = []
    position = 0
    while position < len(text):
        match = pattern.match(text, position)
        if match is None or match.end() == position:
            raise _refused(text, "no equation over the pressure p")
        if not (match["number"] or match["factor"]) or (terms and not match["sign"]):
            raise _refused(text, "no equation over the pressure p")
        terms.append(_term(match, text))
        position = match.end()
    if not terms:
        raise _refused(text, "empty, where an equation is needed")
    return terms


def _term(match: re.Match[str], text: str) -> _Term:
    coefficient = Decimal(match["number"] or "1")
    if match["sign"] == "-":
        coefficient = -coefficient
    factor = match["factor"] or ""
    if factor.startswith("ln"):
        return _Term(coefficient, "ln", float(match["log_power"] or 1), None)
    if factor.startswith("exp"):
        inner = _sum(_terms(match["exponent"]), text, Decimal(1))
        return _Term(coefficient, "exp", 0.0, inner)
    power = float(match["within"] or match["power"] or "1") if factor else 0.0
    return _Term(coefficient, "p", power, None)


def _sum(terms: list[_Term], text: str, factor: Decimal) -> Trend:
    """Return a polynomial in p or in ln p, times a factor."""
    functions = {term.function for term in terms if term.power}
    if len(functions) > 1 or "exp" in {term.function for term in terms}:
        raise _refused(text, "mixes kinds of trend lines")
    coefficients = [0.0] * _MOST_COEFFICIENTS
    seen: set[float] = set()
    for term in terms:
        if term.power not in (0, 1, 2, 3):
            raise _refused(text, "adds a power of p besides 1, 2 and 3")
        if term.power in seen:
            raise _refused(text, "has two terms of the same kind")
        seen.add(term.power)
        coefficients[int(term.power)] = _finite(term.coefficient * factor, text)
    count = 1 + int(max(seen))
    form: Form = "logarithmic" if functions == {"ln"} else "polynomial"
    return Trend(form=form, coefficients=tuple(coefficients[:count]))


def _scaled_exponent(exponent: Trend, coefficient: Decimal, text: str) -> Trend:
    """Return the trend coefficient * exp(exponent)."""
    size = abs(_finite(coefficient, text))
    if size == 0.0:
        raise _refused(text, "is 0 everywhere")
    c = exponent.coefficients
    first = c[0] + math.log(size)
    form: Form = "power" if exponent.form == "logarithmic" else "exponential"
    sign = 1 if coefficient > 0 else -1
    return Trend(form=form, coefficients=(first, *c[1:]), sign=sign)


def _over_pascal(trend: Trend, unit: float) -> Trend:
    """Return the trend for pressure in pascal: p is p_SI / unit, ln p is ln p_SI - ln unit."""
    c = trend.coefficients
    if unit != 1.0:
        if trend.form in ("logarithmic", "power"):
            c = _shifted(c, -math.log(unit))
        else:
            c = tuple(value / unit**power for power, value in enumerate(c))
    return Trend(form=trend.form, coefficients=c, sign=trend.sign)


def _shifted(c: tuple[float, ...], shift: float) -> tuple[float, ...]:
    """Return the coefficients of sum c_k (v + shift)^k as powers of v."""
    return tuple(
        math.fsum(c[k] * math.comb(k, power) * shift ** (k - power) for k in range(power, len(c)))
        for power in range(len(c))
    )


def _finite(number: Decimal, text: str) -> float:
    value = float(number)
    if not math.isfinite(value):
        raise _refused(text, "a number that is not finite")
    return value


def _refused(text: str, message: str) -> InputError:
    return input_error(message=message, remedy=_GRAMMAR, value=shown(text))
