"""The line, table and data of the reserve; figures by hand."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from cli.running import wraparc
from wraparc import load_drive
from wraparc.answer.reserve_words import (
    flip_data,
    input_name,
    percent_text,
    reserve_text,
    with_reserve,
)
from wraparc.answer.words import verdict
from wraparc.arc import solve
from wraparc.checks import Level
from wraparc.drive import Drive
from wraparc.reserve import Flip, Input, Reserve, Uncertainty
from wraparc.units import in_units

EXAMPLES = Path(__file__).parents[2] / "examples"
HARD = Uncertainty(0.2, "usual", "Gent")
WORDS = 20


@pytest.fixture(scope="module")
def drive() -> Drive:
    return load_drive(EXAMPLES / "uphill-conveyor.toml")


def flip(name: str, change: float, level: Level, label: str = "") -> Flip:
    return Flip(Input(name, ("head",), label), change, level, "start", HARD)


@pytest.mark.parametrize(
    ("change", "text"),
    [
        (-0.0904, "-9.1 %"), (-0.19576, "-20 %"), (0.0601, "+6.1 %"), (0.3996, "+40 %"),
        (-0.00005, "-0.1 %"), (0.0021, "+0.3 %"), (0.99, "+99 %"), (-0.09, "-9.0 %"),
    ],
)  # fmt: skip
def test_a_change_is_rounded_to_where_the_level_has_changed(change: float, text: str) -> None:
    assert in_units(percent_text(change)) == text


def test_changes_of_a_level_stand_together(drive: Drive) -> None:
    worse = (
        flip("friction", -0.0904, Level.ATTENTION),
        flip("belt_modulus", -0.14, Level.ATTENTION),
        flip("diameter", -0.005, Level.FAILS, "head"),
    )
    text = in_units(reserve_text(Reserve(Level.OK, flips=worse), drive))
    assert text == (
        "ATTENTION at friction -9.1 % or belt modulus -14 %, within their uncertainties; "
        "FAILS at diameter of head -0.5 % (within its uncertainty)."
    )
    both = (flip("friction", 0.12, Level.OK), flip("effective_tension", 0.2, Level.FAILS))
    text = in_units(reserve_text(Reserve(Level.ATTENTION, flips=both), drive))
    assert text == (
        "OK at friction +12 % (within its uncertainty); FAILS at Te +20 % (within its uncertainty)."
    )
    some = (*worse[:2], flip("effective_tension", 0.3, Level.ATTENTION))
    assert in_units(reserve_text(Reserve(Level.OK, flips=some), drive)) == (
        "ATTENTION at friction -9.1 %, belt modulus -14 % (within their uncertainties) or Te +30 %."
    )


def test_nothing_within_the_range_and_nothing_calculated(drive: Drive) -> None:
    inputs = tuple(Input(str(number)) for number in range(11))
    none = reserve_text(Reserve(Level.OK, inputs), drive)
    assert none == "None of 11 inputs changes the verdict within -50 to +100 %."
    text = reserve_text(Reserve(Level.OK, reason="pulley uneven across its width"), drive)
    assert text == "Not calculated: pulley uneven across its width."


def test_the_line_of_an_example_has_twenty_words_at_most(drive: Drive) -> None:
    result = solve(drive, raise_on_failure=False)
    own = with_reserve(verdict(result, search=False), result, every=False)
    (text,) = own.reserve
    assert text.startswith("ATTENTION at ")
    assert len(text.replace(" %", "%").split()) <= WORDS
    assert len(own.flips) == 3
    assert own.flips == tuple(sorted(own.flips, key=lambda f: f.units))
    every = with_reserve(verdict(result, search=False), result, every=True)
    assert every.reserve == own.reserve
    assert len(every.flips) > 3


def test_data_of_a_change_have_its_uncertainty_and_place() -> None:
    data = flip_data(flip("shear_modulus", -0.1, Level.OK, "head"))
    assert data == {
        "input": "shear_modulus", "pulley": "head", "lagging": None, "load_case": None,
        "change": -0.1, "level": "OK", "uncertainty": 0.2, "uncertainty_kind": "usual",
        "source": "Gent",
    }  # fmt: skip


def test_t2_is_called_what_it_is(drive: Drive) -> None:
    assert input_name(Input("slack_tension"), replace(drive, conveyor=None)) == "T2"


def test_solve_shows_the_line_unless_told_not_to() -> None:
    path = str(EXAMPLES / "uphill-conveyor.toml")
    assert "\nReserve " in wraparc("solve", path)[1]
    assert "\nReserve " not in wraparc("solve", path, "--no-reserve")[1]
    table = wraparc("solve", path, "--table", "reserve")[1]
    assert "belt modulus" in table
    assert "DIN 22101:2002-08, 6.2.3" in " ".join(table.split())


def test_a_table_without_a_change_says_why() -> None:
    ran = wraparc("solve", str(EXAMPLES / "worn-head-drive-fabric.toml"), "--table", "reserve")
    assert "Not calculated: pulley uneven across its width." in ran.words
