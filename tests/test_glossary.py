"""One name, one symbol, one meaning for each quantity."""

import re

import pytest

from wraparc.glossary import GLOSSARY, QUANTITIES, Quantity
from wraparc.units import DIMENSIONS

# Vocabulary that files, flags and reports rely on: renaming one of these breaks users.
PROMISED = {
    "active_arc", "axial_stiffness", "belt_modulus", "creep", "creep_compression",
    "creep_global", "creep_limit_capacity", "creep_shrinkage", "effective_tension",
    "efficiency", "entry_creep_ratio", "entry_tension", "equivalent_friction", "exit_creep",
    "exit_slip", "exit_tension", "friction", "frictional_energy", "gross_slip_capacity", "lash",
    "least_exit_tension", "mean_friction", "outside_tested_share", "overrun", "peak_friction",
    "peak_shear_angle", "peak_shear_position", "peak_shear_stress", "peak_slip",
    "post_peak_slope", "power_loss", "residual_friction", "shear_angle", "shear_loss",
    "shear_stress", "sliding_power", "slip", "tension_ratio", "tested_slip_capacity",
    "wear_rate", "wrap_angle", "wrap_pressure",
}  # fmt: skip


def test_names_and_titles_are_unique() -> None:
    assert len({quantity.name for quantity in QUANTITIES}) == len(QUANTITIES)
    assert len({quantity.title for quantity in QUANTITIES}) == len(QUANTITIES)
    symbols = [quantity.symbol for quantity in QUANTITIES if quantity.symbol]
    assert len(set(symbols)) == len(symbols)


def test_the_vocabulary_is_there() -> None:
    assert set(GLOSSARY) >= PROMISED
    assert tuple(GLOSSARY.values()) == QUANTITIES


@pytest.mark.parametrize("quantity", QUANTITIES, ids=lambda quantity: quantity.name)
def test_every_entry_is_complete(quantity: Quantity) -> None:
    assert re.fullmatch(r"[a-z]+(_[a-z]+)*", quantity.name)
    assert quantity.symbol.isascii()
    assert quantity.dimension in DIMENSIONS
    assert quantity.title[0].isupper()
    assert not quantity.title.endswith(".")
    assert quantity.meaning[0].isupper()
    assert quantity.meaning.endswith(".")
    assert quantity.meaning.count(". ") == 0, "one sentence"
    assert "  " not in quantity.meaning


def test_headings_name_the_unit_of_the_system() -> None:
    assert GLOSSARY["wrap_pressure"].heading() == "Wrap pressure p [kPa]"
    assert GLOSSARY["wrap_pressure"].heading("us") == "Wrap pressure p [psi]"
    assert GLOSSARY["mean_friction"].heading() == "Mean friction mu_m"
    assert GLOSSARY["outside_tested_share"].heading() == "Share outside tested range"
