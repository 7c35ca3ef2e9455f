"""Quantities in, SI out. Expected values: by definition of the unit, or from pint's own table.

pint is an independent definition of the same units and is used here only.
"""

import json
import math
from decimal import Decimal
from typing import Any

import pint
import pytest
from hypothesis import given
from hypothesis import strategies as st

from wraparc import InputError
from wraparc.units import (
    DEFINITIONS,
    DIMENSION_TEXT,
    DIMENSIONS,
    RESULT_DIGITS,
    Dimension,
    System,
    dimension_of,
    display,
    display_unit,
    parse_number,
    parse_quantity,
    unit_factor,
    unit_names,
)

FINITE = st.floats(allow_nan=False, allow_infinity=False)


def complaint(value: Any, dimension: Dimension) -> str:
    with pytest.raises(InputError) as caught:
        parse_quantity(value, dimension)
    assert len(caught.value.problems) == 1
    problem = caught.value.problems[0]
    assert problem.message
    assert problem.remedy
    assert (problem.file, problem.key, problem.line) == ("", "", None)
    return str(problem)


# ---- by definition ----


@pytest.mark.parametrize(
    ("text", "dimension", "si"),
    [
        ("1200 mm", "length", 1.2),
        ("120 cm", "length", 1.2),
        ("0.1 mm", "length", 0.0001),
        ("48 in", "length", 1.2192),
        ("48inch", "length", 1.2192),
        ("4 ft", "length", 1.2192),
        (".25 in", "length", 0.00635),
        ("12 µm", "length", 12e-6),
        ("12 μm", "length", 12e-6),
        ("150 kN", "force", 150e3),
        ("150\N{NO-BREAK SPACE}kN", "force", 150e3),
        ("150kN", "force", 150e3),
        ("1.5e5N", "force", 150e3),
        ("+0.15 MN", "force", 150e3),
        ("500 daN", "force", 5000.0),
        ("1000 lbf", "force", 4448.2216152605),
        ("1 kip", "force", 4448.2216152605),
        ("1 klbf", "force", 4448.2216152605),
        ("100 kgf", "force", 980.665),
        ("12960 kN/m", "force_per_width", 12.96e6),
        ("140 N/mm", "force_per_width", 140e3),
        ("1000 PIW", "force_per_width", 1000 * 4.4482216152605 / 0.0254),
        ("1000 lbf/in", "force_per_width", 1000 * 4.4482216152605 / 0.0254),
        ("1000 lb/in", "force_per_width", 1000 * 4.4482216152605 / 0.0254),
        ("207 kPa", "pressure", 207e3),
        ("6.9 N/mm2", "pressure", 6.9e6),
        ("6.9 N/mm²", "pressure", 6.9e6),
        ("6.9 N/mm^2", "pressure", 6.9e6),
        ("2 bar", "pressure", 2e5),
        ("30 psi", "pressure", 30 * 4.4482216152605 / 0.0254**2),
        ("192 kPa/mm", "pressure_per_length", 192e6),
        ("5 N/mm3", "pressure_per_length", 5e9),
        ("3 m/s", "speed", 3.0),
        ("600 fpm", "speed", 600 * 0.3048 / 60),
        ("600 ft/min", "speed", 600 * 0.3048 / 60),
        ("18 km/h", "speed", 5.0),
        ("180 deg", "angle", math.pi),
        ("180°", "angle", math.pi),
        ("-0.5 rad", "angle", -0.5),
        ("250 kW", "power", 250e3),
        ("1 hp", "power", 745.6998715822702),
        ("40 kNm", "torque", 40e3),
        ("40 kN m", "torque", 40e3),
        ("40 kN*m", "torque", 40e3),
        ("40 kN·m", "torque", 40e3),
        ("100 lbf*ft", "torque", 135.5817948331400),
        ("100 ft-lb", "torque", 135.5817948331400),
        ("100 ft lbf", "torque", 135.5817948331400),
        ("1200 lbf.in", "torque", 135.5817948331400),
        ("2500 mm2", "area", 0.0025),
        ("1.5 min", "time", 90.0),
        ("2 h", "time", 7200.0),
        ("20 degC", "temperature", 293.15),
        ("-40 °F", "temperature", 233.15),
        ("273.15 K", "temperature", 273.15),
        ("-0.016 1/mm", "per_length", -16.0),
        ("-0.016 mm^-1", "per_length", -16.0),
        ("-0.016 /mm", "per_length", -16.0),
        ("1 1/in", "per_length", 1 / 0.0254),
        ("0.05 mm3/J", "wear_coefficient", 5e-11),
        ("0.05 mm3/(N m)", "wear_coefficient", 5e-11),
        ("0.05 mm³/Nm", "wear_coefficient", 5e-11),
        ("800 J/m2", "energy_per_area", 800.0),
        ("60 rpm", "rotation_speed", 2 * math.pi),
        ("6 rad/s", "rotation_speed", 6.0),
        ("1.5 t", "mass", 1500.0),
        ("1 lbm", "mass", 0.45359237),
        # printed units: a pound is one of mass where only a mass can stand (NIST SP 811)
        ("1 lb", "mass", 0.45359237),
        ("30 lb/ft", "mass_per_length", 30 * 0.45359237 / 0.3048),
        ("30 lbs/ft", "mass_per_length", 30 * 0.45359237 / 0.3048),
        ("30 lbm/ft", "mass_per_length", 30 * 0.45359237 / 0.3048),
        ("1000 lbs/in", "force_per_width", 1000 * 4.4482216152605 / 0.0254),
        ("1000 lb/ft", "force_per_width", 1000 * 4.4482216152605 / 0.3048),
        ("200 lb ft2", "moment_of_inertia", 200 * 0.45359237 * 0.3048**2),
        ("200 lb-ft2", "moment_of_inertia", 200 * 0.45359237 * 0.3048**2),
        ("1500 t/h", "mass_flow", 1500 / 3.6),
        ("1500 tph", "mass_flow", 1500 / 3.6),
        ("1500 TPH", "mass_flow", 1500 / 3.6),
        ("1500 mtph", "mass_flow", 1500 / 3.6),
        ("1500 stph", "mass_flow", 1500 * 907.18474 / 3600),
        ("1500 STPH", "mass_flow", 1500 * 907.18474 / 3600),
        ("1500 ltph", "mass_flow", 1500 * 1016.0469088 / 3600),
        ("1500 lb/h", "mass_flow", 1500 * 0.45359237 / 3600),
        ("20 ston", "mass", 20 * 907.18474),
        ("3.5 mps", "speed", 3.5),
        ("0.35", "number", 0.35),
        ("35 %", "number", 0.35),
        ("2 mm/m", "number", 0.002),
        (0.35, "number", 0.35),
        (2, "number", 2.0),
    ],
)
def test_quantities_that_users_write(text: str | float, dimension: Dimension, si: float) -> None:
    assert parse_quantity(text, dimension) == pytest.approx(si, rel=1e-15)


def test_the_decimal_as_written_is_met_exactly() -> None:
    """1200 * 0.001 in floats is 1.2, but 1.1 * 0.001 is not 0.0011: no such slip here."""
    assert parse_quantity("1.1 mm", "length") == 0.0011
    assert parse_quantity("0.3 mm", "length") == 0.0003
    assert parse_quantity("180 deg", "angle") == math.pi


# ---- other code ----

PINT_NAMES = {
    "kp": "kgf", "tf": "tonne * g_0", "gf": "gram * g_0", "lb": "lbf", "lbs": "lbf", "lbm": "lb",
    "klbf": "kilolbf", "kips": "kip", "t": "tonne", "PIW": "lbf/in", "piw": "lbf/in",
    "PLI": "lbf/in", "pli": "lbf/in", "PSI": "psi", "Nm": "N*m", "kNm": "kN*m", "MNm": "MN*m",
    "PS": "metric_horsepower", "HP": "hp", "fpm": "ft/min", "fps": "ft/s", "kmh": "kph",
    "RPM": "rpm", "%": "percent", "sec": "s", "d": "day", "rev": "turn", "mi": "mile",
    '"': "inch", "bhp": "hp", "BHP": "hp", "cv": "metric_horsepower", "CV": "metric_horsepower",
    "hp(metric)": "metric_horsepower", "FPM": "ft/min", "mps": "m/s", "ston": "short_ton",
    "stons": "short_ton", "lton": "long_ton", "ltons": "long_ton", "tph": "tonne/h",
    "TPH": "tonne/h", "mtph": "tonne/h", "MTPH": "tonne/h", "stph": "short_ton/h",
    "STPH": "short_ton/h", "ltph": "long_ton/h", "LTPH": "long_ton/h",
}  # fmt: skip


@pytest.fixture(scope="module")
def registry() -> "pint.UnitRegistry[float]":
    return pint.UnitRegistry()


@pytest.mark.parametrize("name", unit_names())
def test_every_unit_agrees_with_pint(name: str, registry: "pint.UnitRegistry[float]") -> None:
    dimension = dimension_of(name)
    assert dimension is not None
    theirs = PINT_NAMES.get(name, name)
    si_unit = DIMENSION_TEXT[dimension].si_unit or "dimensionless"
    si_unit = si_unit.replace("N m", "N*m").replace("m2", "m**2").replace("m3", "m**3")
    if dimension == "temperature":
        expected = registry.Quantity(20, theirs).to("K").magnitude
        assert parse_quantity(f"20 {name}", dimension) == pytest.approx(expected, rel=1e-12)
        return
    expected = (1 * registry.parse_expression(theirs)).to(si_unit).magnitude
    assert unit_factor(name, dimension) == pytest.approx(expected, rel=1e-12)


# ---- refusals ----


@pytest.mark.parametrize(
    ("text", "dimension", "sentence"),
    [
        (
            "1500 ton/h", "mass_flow",
            'ton may be metric, short or long, got "1500 ton/h". Write t/h (1000 kg), ston/h '
            "(2000 lb) or lton/h (2240 lb).",
        ),
        (
            "20 tons", "force",
            'tons may be metric, short or long, got "20 tons". Write tf (1000 kgf) or kip (1000 '
            "lbf).",
        ),
        (
            "20 ton", "length",
            'ton may be metric, short or long, got "20 ton". Write for example "1200 mm".',
        ),
        (
            "60 kg", "force",
            'a mass, where a force is needed, got "60 kg". Write kgf if it is a force.',
        ),
        (
            "100 kg/cm", "force_per_width",
            'a mass per length, where a force per width is needed, got "100 kg/cm". Write kgf/cm '
            "if it is a force.",
        ),
        (
            "7 kg/cm2", "pressure",
            'of no dimension used here, where a pressure is needed, got "7 kg/cm2". Write kgf/cm2 '
            "if it is a force.",
        ),
        (
            "30 lbf/ft", "mass_per_length",
            'a force per width, where a mass per length is needed, got "30 lbf/ft". Write lbm/ft '
            "if it is a mass.",
        ),
        ("20 KN/M", "force_per_width", 'unknown unit "KN", got "20 KN/M". Did you mean kN/m?'),
        ("20 T/H", "mass_flow", 'unknown unit "T", got "20 T/H". Did you mean t/h?'),
        (
            "3 m", "force",
            'a length, where a force is needed, got "3 m". Write for example "150 kN".',
        ),
    ],
)  # fmt: skip
def test_a_hint_says_what_to_write(text: str, dimension: Dimension, sentence: str) -> None:
    with pytest.raises(InputError) as caught:
        parse_quantity(text, dimension)
    assert str(caught.value) == sentence


@pytest.mark.parametrize("dimension", DIMENSIONS)
def test_no_hint_names_a_unit_of_another_dimension(dimension: Dimension) -> None:
    """Every unit with a letter too many, alone and in a quotient: what is offered can be read."""
    for name in unit_names():
        for text in (f"{name}q", f"{name}q/h", f"kq/{name}", f"{name.swapcase()}/M"):
            try:
                parse_quantity(f"3 {text}", dimension)
            except InputError as error:
                _readable(error.problems[0].remedy, text, dimension)


def _readable(remedy: str, text: str, dimension: Dimension) -> None:
    """Assert that one of the units offered, whole or for its part, is of the dimension."""
    meant = remedy.removeprefix("Did you mean ").removesuffix("?")
    if meant == remedy:
        return
    for unit in meant.split(" or "):
        parts = [unit, *(text.replace(part, unit) for part in text.split("/"))]
        assert any(_is_of(part, dimension) for part in parts), (text, dimension, remedy)


def _is_of(unit: str, dimension: Dimension) -> bool:
    try:
        parse_quantity(f"3 {unit}", dimension)
    except InputError:
        return False
    return True


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        (
            "1,5 kN",
            ('a comma can mean decimal point or thousands separator, got "1,5 kN". Write '
              '"1.5 kN".'),
        ),
        (
            "0,25 kN",
            ('a comma can mean decimal point or thousands separator, got "0,25 kN". Write '
              '"0.25 kN".'),
        ),
        (
            "1,200 N",
            ('a comma can mean decimal point or thousands separator, got "1,200 N". Write '
              '"1200 N" or "1.200 N".'),
        ),
        (
            "1,200,000 N",
            ('a comma can mean decimal point or thousands separator, got "1,200,000 N". '
              'Write "1200000 N".'),
        ),
        (
            "1.800,5 N",
            ('a comma can mean decimal point or thousands separator, got "1.800,5 N". Write '
              '"1800.5 N".'),
        ),
        (
            "1,5e3 N",
            ('a comma can mean decimal point or thousands separator, got "1,5e3 N". Write '
              '"1.5e3 N".'),
        ),
        (
            "1 800 N",
            ('digits in groups can be one number or several, got "1 800 N". Write "1800 N".'),
        ),
        (
            "1'800 N",
            ("digits in groups can be one number or several, got \"1'800 N\". Write \"1800 N\"."),
        ),
        (
            "1_800 N",
            ('digits in groups can be one number or several, got "1_800 N". Write "1800 N".'),
        ),
        ("nan kN", ('not a finite number, got "nan kN". Give the size that was measured or '
                   "meant.")),
        ("-inf kN", ('not a finite number, got "-inf kN". Give the size that was measured or '
                    "meant.")),
        ("1e999 N", ('not a finite number, got "1e999 N". Give the size that was measured or '
                    "meant.")),
        ("1e99999 N", 'its exponent is out of range, got "1e99999 N". Check the exponent.'),
        ("1e-999 N", ('too small to tell from zero, got "1e-999 N". Write 0, or check the '
                     "exponent.")),
        (
            "１２ kN",
            ('digits other than 0-9, got "１２ kN". Write digits and a decimal point: 1234.5.'),
        ),
        (
            "5１ kN",
            ('digits other than 0-9, got "5１ kN". Write digits and a decimal point: 1234.5.'),
        ),
        (
            "--5 kN",
            ('not a plain number, got "--5 kN". Write digits and a decimal point: 1234.5.'),
        ),
        (
            "1/2 kN",
            ('a fraction, where a decimal number is needed, got "1/2 kN". Write digits and a '
              "decimal point: 1234.5."),
        ),
        ("−5 kN", "a typographic minus sign, got \"−5 kN\". Use the plain hyphen-minus '-'."),
        ("", 'empty, where a number is needed, got "". Write a number.'),
        (
            "5",
            ('no unit, where a force is needed, got "5". Write the unit too, for example "150 '
            'kN".'),
        ),
        ("5 mm", 'a length, where a force is needed, got "5 mm". Write for example "150 kN".'),
        ("5 kg", 'a mass, where a force is needed, got "5 kg". Write kgf if it is a force.'),
        ("5 kN kN", ('of no dimension used here, where a force is needed, got "5 kN kN". '
                    'Write for example "150 kN".')),
        ("5 kn", 'unknown unit "kn", got "5 kn". Did you mean kN?'),
        ("5 newtonn", ('unknown unit "newtonn", got "5 newtonn". Did you mean newton or '
                      "newtons?")),
        (
            "5 xyzzy",
            ('unknown unit "xyzzy", got "5 xyzzy". Write for example "150 kN".'),
        ),
        (
            "5 J/m m",
            ('the unit "J/m m" cannot be read, got "5 J/m m". Write for example "150 kN".'),
        ),
        (
            "5 degC/m",
            ('degC cannot be part of a compound unit: its zero is not 0 K, got "5 degC/m". '
            "Use K."),
        ),
        ("1" * 81, f"longer than 80 characters, got \"{'1' * 55}...\". Shorten it."),
        (5, ('no unit, where a force is needed, got 5. Write the unit too, for example "150 '
            'kN".')),
        (
            True,
            ("neither text nor a number, where a force is needed, got true. Write for example "
            '"150 kN".'),
        ),
        (
            None,
            ("neither text nor a number, where a force is needed, got null. Write for example "
            '"150 kN".'),
        ),
    ],
)  # fmt: skip
def test_a_force_that_cannot_be_used(text: Any, sentence: str) -> None:
    assert complaint(text, "force") == sentence


@pytest.mark.parametrize("value", [float("nan"), float("inf"), -float("inf"), 10**400])
def test_a_bare_number_must_be_finite(value: float) -> None:
    assert "not a finite number" in complaint(value, "number")


@pytest.mark.parametrize(
    "text",
    ["5 mm\x00", "5 m**99", "5 m^0", "5 (m)", "5 m//s", "5 mm/m/m", "5 9 m", "5 m2 3", "5 °C2",
     "5 __import__", "5 m;m", "5 m + m", "0x10 m", "5 1e3", "five m", "1.2.3 m", "5- m", "5e",
     "٥ m"],
)  # fmt: skip
def test_hostile_and_broken_text_is_refused(text: str) -> None:
    complaint(text, "length")


@given(st.text(max_size=100), st.sampled_from(DIMENSIONS))
def test_random_text_never_ends_in_a_traceback(text: str, dimension: Dimension) -> None:
    try:
        value = parse_quantity(text, dimension)
    except InputError as error:
        sentence = str(error)
    else:
        assert math.isfinite(value)
        return
    assert sentence.isprintable()


@given(
    st.text(alphabet="0123456789.,eE+-'_ \u00a0/", max_size=12),
    st.sampled_from(["mm", "kN/m", ""]),
)
def test_number_like_text_is_read_as_python_reads_it_or_refused(digits: str, unit: str) -> None:
    try:
        dimension = dimension_of(unit)
        assert dimension is not None
        value = parse_quantity(f"{digits} {unit}", dimension)
    except InputError:
        return
    plain = digits.strip()
    assert "_" not in plain
    assert value == pytest.approx(float(plain) * unit_factor(unit, dimension), rel=1e-15)


# ---- round trips ----


@given(FINITE)
def test_a_number_comes_back_as_it_was(number: float) -> None:
    assert parse_number(repr(number)) == number
    assert parse_quantity(f"{number!r} m", "length") == number
    assert parse_quantity(number, "number") == number


@pytest.mark.parametrize("text", ["5 mm", "1,5", "nan", "", "1 2", "٥"])
def test_a_plain_number_is_nothing_else(text: str) -> None:
    with pytest.raises(InputError):
        parse_number(text)


@given(st.floats(1e-3, 1e6), st.sampled_from(unit_names()))
def test_column_factors_and_single_values_agree(number: float, unit: str) -> None:
    dimension = dimension_of(unit)
    assert dimension is not None
    value = parse_quantity(f"{number!r} {unit}", dimension)
    if unit in ("degC", "degF", "°C", "°F"):
        with pytest.raises(InputError, match="zero elsewhere than 0 K"):
            unit_factor(unit, dimension)
    else:
        assert value == pytest.approx(number * unit_factor(unit, dimension), rel=1e-14)


@given(
    st.floats(1e-9, 1e9) | st.floats(-1e9, -1e-9),
    st.sampled_from(DIMENSIONS),
    st.sampled_from(["si", "us"]),
)
def test_what_is_displayed_can_be_read_back(
    value: float, dimension: Dimension, system: System
) -> None:
    text = display(value, dimension, system, digits=12)
    back = parse_quantity(text, dimension)
    small = abs(value / display_unit(dimension, system)[1]) < 1e-9
    if small and dimension not in ("temperature", "wear_coefficient"):
        assert back == 0.0  # what rounding leaves
        return
    tolerance = 1e-9 if dimension == "temperature" else 0.0  # the zero is 273 K away
    assert back == pytest.approx(value, rel=1e-11, abs=tolerance)


@pytest.mark.parametrize(
    ("value", "dimension", "si", "us"),
    [
        (150e3, "force", "150 kN", "33700 lbf"),
        (12.96e6, "force_per_width", "12960 kN/m", "74000 PIW"),
        (0.00635, "length", "6.35 mm", "0.25 in"),
        (1.2, "length", "1200 mm", "47.2 in"),
        (500.0, "length", "500 m", "1640 ft"),
        (9.9996e-3, "length", "10.0 mm", "0.394 in"),
        (9.99999, "length", "10.0 m", "394 in"),
        (207e3, "pressure", "207 kPa", "30.0 psi"),
        (9.999999e6, "pressure", "10.0 MPa", "1450 psi"),
        (math.pi, "angle", "180 deg", "180 deg"),
        (3.0, "speed", "3 m/s", "591 fpm"),
        (250e3, "power", "250 kW", "335 hp"),
        (40e3, "torque", "40 kN m", "29500 lbf ft"),
        (293.15, "temperature", "20 degC", "68 degF"),
        (5e-14, "wear_coefficient", "5.00e-05 mm3/J", "4.14e-09 in3/(ft lbf)"),
        (0.35, "number", "0.35", "0.35"),
        (417.5e3, "force", "417.5 kN", "93900 lbf"),  # given, it is shown whole
        (417.53e3, "force", "418 kN", "93900 lbf"),
        (107.287e6, "force_per_width", "107000 kN/m", "613000 PIW"),
        (0.0, "force", "0 kN", "0 lbf"),
        (-0.0, "force", "0 kN", "0 lbf"),
        (-150e3, "force", "-150 kN", "-33700 lbf"),
        (math.inf, "length", "inf mm", "inf in"),
        (math.nan, "length", "nan mm", "nan in"),
    ],
)
def test_display(value: float, dimension: Dimension, si: str, us: str) -> None:
    assert display(value, dimension, digits=RESULT_DIGITS) == si
    assert display(value, dimension, "us", RESULT_DIGITS) == us


def test_what_is_given_keeps_a_fourth_digit() -> None:
    assert display(417.53e3, "force") == "417.5 kN"
    assert display(1.2, "length", "us") == "47.24 in"


def test_display_units_have_their_factor() -> None:
    assert display_unit("length") == ("mm", 0.001)
    assert display_unit("force", "us") == ("lbf", 4.4482216152605)
    assert display_unit("temperature", "us") == ("K", 1.0)
    assert display_unit("number") == ("", 1.0)


# ---- what a unit measures ----


@pytest.mark.parametrize(
    ("unit", "dimension"),
    [
        ("N", "force"), ("kN", "force"), ("mN", "force"), ("lbf", "force"), ("gf", "force"),
        ("kgf", "force"), ("mm", "length"), ("cm", "length"), ("in", "length"), ("m", "length"),
        ("um", "length"), ("µm", "length"), ("kPa", "pressure"), ("MPa", "pressure"),
        ("N/mm2", "pressure"), ("psi", "pressure"), ("s", "time"), ("%", "number"), ("", "number"),
        ("mm/mm", "number"), ("N/m", "force_per_width"), ("J/m2", "energy_per_area"),
        ("N m", "torque"), ("mm/min", "speed"), ("degC", "temperature"), ("kg m7", None),
        ("furlong", None), ("N/", None), ("\x00", None), ("m" * 1000, None),
    ],
)  # fmt: skip
def test_dimension_of(unit: str, dimension: Dimension | None) -> None:
    assert dimension_of(unit) == dimension


def test_the_table_is_sound() -> None:
    names = [name for definition in DEFINITIONS for name in definition.names]
    assert len(names) == len(set(names))
    assert all(definition.factor > Decimal(0) for definition in DEFINITIONS)
    assert set(DIMENSION_TEXT) == set(DIMENSIONS)
    for dimension, text in DIMENSION_TEXT.items():
        assert math.isfinite(parse_quantity(text.example, dimension))
        assert json.dumps(text.name)


@pytest.mark.parametrize(
    ("text", "dimension", "expected"),
    [
        # NIST SP 811: ft/min 5.08e-3 m/s, hp (550 ft lbf/s) 745.6999 W, metric hp 735.49875 W
        ("500 FPM", "speed", 2.54),
        ("250 bhp", "power", 250.0 * 745.69987158227022),
        ("100 hp(metric)", "power", 73549.875),
        ("100 cv", "power", 73549.875),
        ('48"', "length", 1.2192),
        ("48″", "length", 1.2192),
        ("1500 tonnes/h", "mass_flow", 1500e3 / 3600.0),
    ],
)
def test_spellings_of_the_field_are_read(text: str, dimension: Dimension, expected: float) -> None:
    assert parse_quantity(text, dimension) == pytest.approx(expected, rel=1e-12)
