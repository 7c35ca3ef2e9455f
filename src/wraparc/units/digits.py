"""Numbers as people write them: significant digits, plain notation where it fits."""

import math

#: Significant digits of what was computed: no friction is known to more. Files hold every digit.
RESULT_DIGITS = 3
#: A number that so many digits hold entirely is one that somebody gave, and is shown as it is.
GIVEN_DIGITS = 4
_EXACT = 1e-9
#: Digits of a given number that is shown as typed.
_TYPED = 6
#: Digits behind the first that tell any two numbers apart.
_EVERY = 16
#: What is less, in the unit shown, is what rounding leaves of a difference of equal numbers.
NOTHING = 1e-9


def rounded(number: float, digits: int) -> str:
    """Return the number with so many significant digits, in plain notation where it fits."""
    if math.isnan(number):
        return "nan"
    if math.isinf(number):
        return "inf" if number > 0.0 else "-inf"
    if number == 0.0:
        return "0"
    given = scientific(number, GIVEN_DIGITS - 1)
    power = exponent_of(given)
    if digits <= GIVEN_DIGITS and _equal(read(given), number) and -4 <= power < 12:
        return trimmed(fixed(read(given), max(0, GIVEN_DIGITS - 1 - power)))
    text = scientific(number, digits - 1)
    power = exponent_of(text)
    return fixed(read(text), max(0, digits - 1 - power)) if -4 <= power < 12 else text


def safe(value: float, size: float, up: bool) -> float:
    """Return the same of a value that shows in units of a size."""
    number = value / size
    if not math.isfinite(number) or abs(number) < NOTHING:
        return value
    shown = _stepped(number, RESULT_DIGITS, up)
    return value if shown == number else shown * size


def rounded_limit(number: float, digits: int, up: bool) -> str:
    """Return a number with so many significant digits, rounded up or down.

    What `GIVEN_DIGITS` hold entirely was given, and stays as it is.
    """
    if not math.isfinite(number) or abs(number) < NOTHING:
        return rounded(number, digits)
    shown = _stepped(number, digits, up)
    return rounded(number, digits) if shown == number else every_digit(shown, digits)


def every_limit_digit(number: float, digits: int, up: bool) -> str:
    """Return a number rounded up or down to so many significant digits, zeros at its end too."""
    return every_digit(_stepped(number, digits, up), digits)


def every_digit(number: float, digits: int) -> str:
    """Return a number with so many significant digits, zeros at its end too."""
    if number == 0.0 or not math.isfinite(number):
        return rounded(number, digits)
    text = scientific(number, digits - 1)
    power = exponent_of(text)
    return fixed(read(text), max(0, digits - 1 - power)) if -4 <= power < 12 else text


def as_typed(number: float, text: str) -> str:
    """Return a given number with the digits that it was typed with, six at most.

    `text` is what stands for one that six digits do not hold, as after a change of units.
    """
    if number == 0.0 or not math.isfinite(number):
        return text
    typed = scientific(number, _TYPED - 1)
    power = exponent_of(typed)
    if not _equal(read(typed), number) or not -4 <= power < 12:
        return text
    return trimmed(fixed(read(typed), max(0, _TYPED - 1 - power)))


def decimals(number: float, digits: int, signed: bool) -> str:
    """Return a number with so many digits behind the point; its sign always, unless it is 0."""
    if not math.isfinite(number):
        return rounded(number, digits)
    text = fixed(0.0, digits)
    if number != 0.0:
        power = exponent_of(scientific(number, _EVERY))
        if power + digits >= _EVERY - 2:  # no float has more
            text = rounded(number, _EVERY - 1)
        elif power + digits >= 0:  # rounded to that digit once, a tie to the even one
            text = fixed(read(scientific(number, power + digits)), digits)
        elif abs(number) > 0.5 * 10.0**-digits:
            text = fixed(10.0**-digits if number > 0.0 else -(10.0**-digits), digits)
    if read(text) == 0.0:
        return "0" if signed else fixed(0.0, digits)
    return "+" + text if signed and number > 0.0 else text


def with_error(number: float, error: float) -> str:
    """Return ``number ± error``: the number to three digits, the error to the same place.

    Where the error is less than one of that place, both get a fourth digit; an error below even
    that is said to be below it. An error that is larger than the number leaves two digits of both.

    Parameters
    ----------
    number
        The number.
    error
        Half its 95 % interval; none is shown that is 0 or not finite.
    """
    if not (math.isfinite(number) and math.isfinite(error) and error > 0.0):
        return rounded(number, RESULT_DIGITS)
    if error >= abs(number):  # not known, not even its sign
        return every_digit(number, 2) + " \u00b1 " + every_digit(error, 2)
    first = exponent_of(scientific(number, _EVERY))
    places = max(0, min(1 - exponent_of(scientific(error, _EVERY)), RESULT_DIGITS - 1 - first))
    if error < 0.5 * 10.0**-places:
        places = max(0, GIVEN_DIGITS - 1 - first)
    least = 10.0**-places
    shown = (
        decimals(error, places, False)
        if error >= 0.5 * least
        else "< " + decimals(least, places, False)
    )
    return decimals(number, places, False) + " \u00b1 " + shown


def _stepped(number: float, digits: int, up: bool) -> float:
    """Return a number rounded up or down to so many digits; itself where they hold it."""
    shown = read(rounded(number, digits))
    if _equal(shown, number):
        return number
    if (shown < number) == up:
        step = 10.0 ** (exponent_of(scientific(shown, 3)) - digits + 1)
        shown += step if up else -step
    return shown


def _equal(a: float, b: float) -> bool:
    return abs(a - b) <= _EXACT * max(abs(a), abs(b))


# What JavaScript writes otherwise: these stand in `web/static/base/digits.js`.


def read(text: str) -> float:
    """Return the number that such a text is."""
    return float(text)


def scientific(number: float, digits: int) -> str:
    """Return a number with so many digits behind the point, and an exponent."""
    return f"{number:.{digits}e}"


def exponent_of(text: str) -> int:
    """Return the exponent of such a text."""
    return int(text.rpartition("e")[2])


def fixed(number: float, digits: int) -> str:
    """Return a number with so many digits behind the point."""
    return f"{number:.{digits}f}"


def trimmed(text: str) -> str:
    """Return such a text without zeros at its end that say nothing."""
    return text.rstrip("0").rstrip(".") if "." in text else text


def grouped(text: str) -> str:
    """Return whole digits in groups of three."""
    return text if "e" in text else f"{int(text):,}"
