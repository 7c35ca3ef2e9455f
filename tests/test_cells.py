"""Cells: numbers in texts before a system of units is chosen.

Expected texts are those of `display`, which shows a number at once, and written out by hand where a
form has rules of its own.
"""

import math
from typing import Literal

import numpy as np
import pytest

from wraparc.units import (
    Cell,
    Dimension,
    System,
    bare,
    cells_in,
    count,
    display,
    distinct,
    either,
    fixed,
    format_limit,
    in_unit,
    in_units,
    percent,
    plus_minus,
    quantity,
    unit_of,
)
from wraparc.units.cell import Form

SYSTEMS: tuple[System, ...] = ("si", "us")


@pytest.mark.parametrize("system", SYSTEMS)
@pytest.mark.parametrize("value", [6.35e-3, -12.3456, 0.0, 1e-13, 2.5e7, np.float64(0.1)])
def test_a_cell_shows_as_the_number_does(value: float, system: System) -> None:
    for dimension in ("length", "force", "pressure", "temperature", "number"):
        cell = quantity(value, dimension, 3)
        assert in_units(cell, system) == display(value, dimension, system, 3)
        text = " ".join(["A", f"{cell}."]).removesuffix(".")  # texts keep what they are made of
        assert in_units(text, system) == f"A {display(value, dimension, system, 3)}"


def test_what_is_no_number_is_a_text() -> None:
    assert (quantity(math.nan, "force"), bare(math.nan, "force")) == ("-", "-")
    assert quantity(math.inf, "force") == bare(-math.inf, "force") == "infinite"
    assert percent(math.nan) == "-"


@pytest.mark.parametrize(
    ("cell", "si", "us"),
    [
        (bare(150e3, "force"), "150", "33700"),
        (unit_of("force"), "kN", "lbf"),
        (percent(0.12345), "12.3 %", "12.3 %"),
        (Cell(118_612.0, "force", form="up"), "119 kN", "26700 lbf"),
        (Cell(118_612.0, "force", form="down"), "118 kN", "26600 lbf"),
        (Cell(118_612.0, "force", form="bare up"), "119", "26700"),
        (Cell(62_911.0, "force", form="up"), "63.0 kN", "14200 lbf"),
        (format_limit(62_911.0, "force", "minimum"), "63.0 kN", "14200 lbf"),
        (format_limit(62_911.0, "force", "maximum"), "62.9 kN", "14100 lbf"),
        (format_limit(6.35e-3, "length", "maximum"), "6.35 mm", "0.25 in"),
        (format_limit(0.012, "speed", "maximum"), "12 mm/s", "0.472 in/s"),
        (format_limit(math.inf, "force", "maximum"), "infinite", "infinite"),
        (Cell(84_021.5, "force", form="to up", other=50e3), "50 to 84.1 kN", "11200 to 18900 lbf"),
        (Cell(84_021.5, "force", form="to down", other=9e4), "90 to 84.0 kN", "20200 to 18800 lbf"),
        (Cell(210e3, "force", form="of", other=150_210.0), "150 of 210 kN", "33800 of 47200 lbf"),
        (Cell(0.0123, "speed"), "0.0123 m/s", "2.42 fpm"),
        (Cell(0.0123, "speed", form="slip"), "12.3 mm/s", "0.484 in/s"),
        (Cell(30e3, "force", form="to", other=50e3), "50 to 30 kN", "11200 to 6740 lbf"),
        (Cell(30e3, "force", form="to", other=30e3), "30 kN", "6740 lbf"),
        (Cell(2e-2, "length", form="-", other=12.0), "12 m-20 mm", "39.4 ft-0.787 in"),
        (Cell(105.65e3, "force", form="typed"), "105.65 kN", "23800 lbf"),
        (Cell(105.6543219e3, "force", form="typed"), "106 kN", "23800 lbf"),
        (
            Cell(120e3, "force", form="to up", other=105.65e3),
            "105.65 to 120 kN",
            "23800 to 27000 lbf",
        ),
        (plus_minus(15.68e-3, 0.21e-3, "length"), "15.7 \u00b1 0.2", "0.617 \u00b1 0.008"),
        (plus_minus(0.40312, 0.0), "0.403", "0.403"),
        (plus_minus(math.nan, 1.0), "-", "-"),
        (fixed(1.2938, 3), "1.294", "1.294"),
        (fixed(0.25, 1), "0.2", "0.2"),  # a tie goes to the even digit
        (fixed(0.0009, 3, dimension="length"), "0.900", "0.035"),
        (fixed(0.2, 2, "signed"), "+0.20", "+0.20"),
        (fixed(-0.001, 2, "signed"), "0", "0"),
        (fixed(-0.0031214, 4, "percent signed"), "-0.3121 %", "-0.3121 %"),
        (fixed(0.996546, 3, "percent fixed"), "99.655 %", "99.655 %"),
        (fixed(math.nan, 3), "-", "-"),
        (count(12_842.6), "12,843", "12,843"),
        (count(250), "250", "250"),
        (quantity(1.19, "frequency"), "1.19 Hz", "1.19 Hz"),
        (either("1 mm", f"{Cell(0.0254, 'length')}"), "1 mm", "1 in"),
        (in_unit("length", lambda size: f"{0.0254 / size:g} (held)"), "25.4 (held)", "1 (held)"),
    ],
)
def test_forms(cell: str, si: str, us: str) -> None:
    """By hand: 118.612 kN is 26,665 lbf, 0.0123 m/s 2.4213 fpm or 0.4843 in/s."""
    assert (in_units(cell, "si"), in_units(cell, "us")) == (si, us)


def test_numbers_are_told_apart_in_each_system() -> None:
    """In millimetres it takes four digits, in inches (0.250047 and 0.250134) as many."""
    value, limit = 6.3512e-3, 6.3534e-3
    texts = (
        Cell(value, "length", form="apart", other=limit),
        Cell(limit, "length", form="apart", other=value),
    )
    assert [in_units(text) for text in texts] == ["6.351 mm", "6.353 mm"]
    assert [in_units(text, "us") for text in texts] == ["0.2500 in", "0.2501 in"]


@pytest.mark.parametrize(
    ("value", "limit", "sense", "texts"),
    [
        (6.3512e-3, 6.35e-3, "maximum", ["6.351 mm", "6.350 mm"]),
        (7e-3, 6.35e-3, "maximum", ["7 mm", "6.35 mm"]),
        (999.96e-3, 1.0, "minimum", ["999.96 mm", "1000.0 mm"]),
        (60e3, 62_911.0, "minimum", ["60 kN", "63.0 kN"]),
        (62_988.0, 62_992.0, "minimum", ["62.99 kN", "63.00 kN"]),
    ],
)
def test_a_limit_and_what_misses_it_never_read_alike(
    value: float, limit: float, sense: Literal["maximum", "minimum"], texts: list[str]
) -> None:
    """By hand; digits are added to both until they differ."""
    form: Form = "exceeds" if sense == "maximum" else "below"
    dimension: Dimension = "force" if limit > 10.0 else "length"
    value_cell = Cell(value, dimension, form=form, other=limit)
    assert [*map(in_units, (value_cell, format_limit(limit, dimension, sense, value)))] == texts


def test_a_text_tells_its_numbers() -> None:
    first, last = cells_in(f"Creep {quantity(7e-3, 'length', name='exit_creep')}, {percent(0.5)}")
    assert (first.value, first.dimension, first.name) == (7e-3, "length", "exit_creep")
    assert (last.value, last.form) == (0.5, "percent")
    assert not [*cells_in("7 mm")]


def test_of_texts_that_read_the_same_one_is_left() -> None:
    same = [quantity(v, "length") for v in (6.35e-3, 6.35e-3 * (1.0 + 1e-15), 7e-3)]
    assert [in_units(text) for text in distinct(same)] == ["6.35 mm", "7 mm"]


@pytest.mark.parametrize(
    "text",
    [
        "\x02", "\x02length|3||1|2\x03", "\x02wit|3||1.0|nan|\x03", "\x02length|3|odd|1.0|nan|\x03",
        "\x02length|3||one|nan|\x03", "\x04one\x05", "\x04\x02\x05\x06", "\x02" * 50_000,
        "\x02length|3||" + "1" * 50_000, "\x04" * 50_000,
    ],
)  # fmt: skip
def test_what_only_looks_like_a_cell_does_no_harm(text: str) -> None:
    """Titles come from files, and may hold any letter."""
    assert isinstance(in_units(f"A{text}B"), str)
    assert in_units(f"{text} {quantity(1.0, 'length')}").endswith("1000 mm")
