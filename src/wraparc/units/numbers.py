"""The number grammar: what is a number, and what to say of a text that is not one.

A number is ``[+-]digits[.digits][e[+-]digits]`` in ASCII. Whatever could be read in two
ways (a comma, a gap between digits) is refused with the readings it could have: a
guessed factor of ten or a thousand must never reach a calculation.
"""

import math
import re
from decimal import Decimal

from wraparc.errors import InputError, input_error, shown

#: Longest text that is looked at; nothing that is meant comes near it.
LONGEST_TEXT = 80

_NUMBER = re.compile(r"[+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")
_EXPONENT = re.compile(r"[eE][+-]?([0-9]+)$")
_PER = re.compile(r"1\s*/\s*[A-Za-z(]")
_CONTINUES = re.compile(r"[0-9.,'’_´`+\-−:;]|/\s*[0-9]")
_NOT_FINITE = re.compile(r"[+-]?\s*(?:nan|inf|infinity|∞)\b", re.IGNORECASE)
_NUMERIC_HEAD = re.compile(r"[0-9.,'’_´`\s+\-−/:;]*(?:(?<=[0-9])[eE][+-]?[0-9]+)?")
_GAPS = re.compile(r"(?<=[0-9])[\s'’_´`]+(?=[0-9])")
_PLAIN = "Write digits and a decimal point: 1234.5."


def split_number(text: str) -> tuple[Decimal, str]:
    """Split ``"150 kN"`` into its number and the rest of the text, stripped.

    Raises
    ------
    InputError
        If the text is too long, or does not begin with one finite number that can be
        read in one way only.
    """
    if len(text) > LONGEST_TEXT:
        raise _refused(text, f"longer than {LONGEST_TEXT} characters", "Shorten it.")
    stripped = text.strip()
    match = _NUMBER.match(stripped)
    if match is None:
        raise _malformed(text, stripped)
    rest = stripped[match.end() :].strip()
    inverse_unit = match.end() < len(stripped) and _PER.match(rest)
    if rest and (_CONTINUES.match(rest) or rest[0].isdecimal()) and not inverse_unit:
        raise _malformed(text, stripped)
    return _decimal(match.group(), text), rest


def parse_number(text: str) -> float:
    """Read a plain finite number, for example ``"-0.016"`` or ``"1.2e3"``.

    Raises
    ------
    InputError
        If the text is anything else, with one problem that says what.
    """
    number, rest = split_number(text)
    if rest:
        raise _refused(text, f"{shown(rest)} after the number", "Write the number alone.")
    return finite(number, text)


def finite(number: Decimal | float, given: object) -> float:
    """Return the number as a float, refusing what a float cannot hold.

    Raises
    ------
    InputError
        If it is not finite, too large for a float, or too small to differ from zero.
    """
    try:
        value = float(number)
    except OverflowError:
        value = math.inf
    if not math.isfinite(value):
        raise _refused(given, "not a finite number", "Give the size that was measured or meant.")
    if value == 0 and number != 0:
        raise _refused(given, "too small to tell from zero", "Write 0, or check the exponent.")
    return value


def _decimal(digits: str, given: str) -> Decimal:
    exponent = _EXPONENT.search(digits)
    if exponent is not None and len(exponent.group(1).lstrip("0")) > 4:
        raise _refused(given, "its exponent is out of range", "Check the exponent.")
    return Decimal(digits)


def _malformed(text: str, stripped: str) -> InputError:
    """Say what keeps the text from beginning with a number, and how to write it."""
    head = _NUMERIC_HEAD.match(stripped)
    digits = head.group().strip() if head else ""
    rest = stripped[len(head.group()) :].strip() if head else ""
    if not stripped:
        return _refused(text, "empty, where a number is needed", "Write a number.")
    if _NOT_FINITE.match(stripped):
        return _refused(text, "not a finite number", "Give the size that was measured or meant.")
    if any(c.isdecimal() and not c.isascii() for c in stripped):
        return _refused(text, "digits other than 0-9", _PLAIN)
    if "," in digits:
        message = "a comma can mean decimal point or thousands separator"
        return _refused(text, message, _write(_comma_readings(digits), rest))
    if _GAPS.search(digits) and "/" not in digits:
        message = "digits in groups can be one number or several"
        return _refused(text, message, _write([_GAPS.sub("", digits)], rest))
    if "/" in digits:
        return _refused(text, "a fraction, where a decimal number is needed", _PLAIN)
    if "−" in digits:
        return _refused(text, "a typographic minus sign", "Use the plain hyphen-minus '-'.")
    return _refused(text, "not a plain number", _PLAIN)


def _comma_readings(digits: str) -> list[str]:
    """Return the numbers that a text with commas may stand for."""
    exponent = _EXPONENT.search(digits)
    power = exponent.group() if exponent else ""
    joined = _GAPS.sub("", digits.removesuffix(power))
    whole, _, decimals = joined.rpartition(",")
    bare_whole = re.sub(r"[,.]", "", whole)
    readings = [joined.replace(",", "")]
    if "," not in whole and "." not in decimals:
        decimal = f"{bare_whole}.{decimals}"
        readings = [decimal] if "." in whole or len(decimals) != 3 else [*readings, decimal]
    return [reading + power for reading in readings]


def _write(readings: list[str], rest: str) -> str:
    if not all(_NUMBER.fullmatch(reading) for reading in readings):
        return _PLAIN
    return "Write " + " or ".join(shown(f"{r} {rest}".strip()) for r in readings) + "."


def _refused(given: object, message: str, remedy: str) -> InputError:
    return input_error(message=message, remedy=remedy, value=shown(given))
