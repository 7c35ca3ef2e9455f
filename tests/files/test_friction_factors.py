"""Factors of slip speed, temperature and condition: read, applied in every door, written."""

from pathlib import Path

import numpy as np
import pytest

from wraparc import load_drive, load_lagging, solve
from wraparc.checks import judge
from wraparc.errors import InputError
from wraparc.files.lagging_file import lagging_from_text
from wraparc.files.write import lagging_text
from wraparc.provenance import Kind
from wraparc.render import NoteHead, markdown

LAGGING = """
format = 1
name = "mine"
surface = "rubber"
[law]
kind = "constant"
friction = 0.5
tested_pressure = ["40 kPa", "700 kPa"]
tested_slip = "10 mm"
tested_slip_speed = "0.17 mm/s"
[law.slip_speed_factor]
slip_speed = ["0.17 mm/s", "10 mm/s", "30 mm/s"]
factor = [1.0, 0.95, 0.9]
provenance = { kind = "illustrative", source = "made up" }
[law.temperature_factor]
temperature = ["-20 degC", "20 degC", "60 degC"]
factor = [1.1, 1.0, 0.8]
provenance = { kind = "measured", source = "Lab A" }
"""
MUDDY = """
condition_factor = [
  { condition = "muddy", factor = 0.5, provenance = { kind = "measured", source = "Mine B" } },
]
"""
DRIVE = """
format = 1
condition = ["dry", "muddy"]
[belt]
width = "1200 mm"
modulus = "7000 kN/m"
speed = "3 m/s"
[[pulley]]
name = "head"
diameter = "800 mm"
wrap_angle = "180 deg"
lagging = "mine.toml"
entry_tension = "90 kN"
exit_tension = "60 kN"
"""


def used(*state: str) -> float:
    """Friction that is used, with lines of state put in."""
    at = 'name = "mine"'
    (found,) = lagging_from_text(LAGGING.replace(at, "\n".join((at, *state))))
    return float(found.law.friction(1e-3, 1e5))


@pytest.mark.parametrize(
    ("state", "factor"),
    [
        ((), 0.9 * 0.8),  # nothing said: the least of both tables
        (('slip_speed = "20 mm/s"',), 0.925 * 0.8),  # between 10 and 30 mm/s
        (('slip_speed = "0.1 mm/s"',), 1.0 * 0.8),  # slower than any test
        (('temperature = "40 degC"',), 0.9 * 0.9),  # between 20 and 60 degC
        (('slip_speed = "10 mm/s"', 'temperature = "-20 degC"'), 0.95 * 1.1),
    ],
)
def test_the_tested_law_is_multiplied_by_both_factors(
    state: tuple[str, ...], factor: float
) -> None:
    """Worked by hand from the tables: straight lines between their rows."""
    assert used(*state) == pytest.approx(0.5 * factor, rel=1e-12)


def test_without_tables_there_is_no_effect() -> None:
    text = LAGGING[: LAGGING.index("[law.slip_speed_factor]")]
    (plain,) = lagging_from_text(text)
    assert plain.factors is None
    assert plain.law.friction(1e-3, 1e5) == 0.5


def test_what_rises_with_speed_counts_where_it_is_least() -> None:
    """A belt slips at every speed from nothing to its fastest."""
    text = LAGGING.replace("[1.0, 0.95, 0.9]", "[0.7, 1.0, 1.2]")
    (found,) = lagging_from_text(text)
    assert found.factors is not None
    assert found.factors.of_slip_speed == 0.7


@pytest.mark.parametrize(
    ("state", "said"),
    [
        ('slip_speed = "50 mm/s"', "must be between "),
        ('temperature = "70 degC"', "must be between "),
    ],
)
def test_outside_its_table_a_factor_is_not_known(state: str, said: str) -> None:
    with pytest.raises(InputError) as caught:
        used(state)
    assert said in str(caught.value)
    assert "Test the lagging there" in str(caught.value)


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("[1.0, 0.95, 0.9]", "[1.0, 0.95]", "as many factors as values"),
        ("[1.0, 0.95, 0.9]", "[1.0, 0.95, 90.0]", "at most 10"),
        ('["0.17 mm/s", "10 mm/s", "30 mm/s"]', '["10 mm/s", "10 mm/s", "30 mm/s"]', "ascend"),
        ('provenance = { kind = "measured", source = "Lab A" }', "", "provenance"),
        ("[law.temperature_factor]", "[law.temperature]", "temperature_factor"),
    ],
)
def test_a_wrong_table_is_refused(old: str, new: str, said: str) -> None:
    assert old in LAGGING
    with pytest.raises(InputError) as caught:
        lagging_from_text(LAGGING.replace(old, new))
    assert said in str(caught.value)


def test_a_speed_or_temperature_without_a_table_is_refused() -> None:
    text = LAGGING[: LAGGING.index("[law.slip_speed_factor]")]
    with pytest.raises(InputError) as caught:
        lagging_from_text(text.replace('name = "mine"', 'name = "mine"\ntemperature = "20 degC"'))
    assert "the law has no temperature_factor" in str(caught.value)


def test_what_is_written_reads_back_equal() -> None:
    """The tested law and its tables, not the law they make."""
    state = 'name = "mine"\nslip_speed = "20 mm/s"\ntemperature = "30 degC"' + MUDDY
    found = lagging_from_text(LAGGING.replace('name = "mine"', state))
    text = lagging_text(found)
    assert "friction = 0.5" in text
    assert lagging_from_text(text) == found
    assert found[0].condition_factors == lagging_from_text(text)[0].condition_factors


def test_a_drive_is_solved_with_them_and_says_so(tmp_path: Path) -> None:
    """Euler: the friction of an arc that slips as a whole is the factor times the tested one."""
    path = tmp_path / "mine.toml"
    path.write_text(LAGGING.replace('name = "mine"', 'name = "mine"' + MUDDY), "utf-8")
    (tmp_path / "drive.toml").write_text(DRIVE, "utf-8")
    of = load_drive(tmp_path / "drive.toml")
    result = solve(of, raise_on_failure=False)
    frictions = [
        np.log(arc.capacities.gross_slip_capacity) / np.pi for arc in result
    ]  # dry, muddy: half of it
    assert frictions == pytest.approx([0.5 * 0.9 * 0.8, 0.25 * 0.9 * 0.8], rel=1e-6)
    verdict = judge(result)
    speed = next(c for c in verdict.checks if c.name == "tested_slip_speed")
    assert speed.limit == pytest.approx(30e-3)  # what the factors were known to
    assert verdict.data.text == "Slip speed factor illustrative."
    assert load_lagging(path).sources["slip_speed_factor"].kind is Kind.ILLUSTRATIVE
    muddy = next(c for c in verdict.checks if c.name == "condition")
    assert "Mine B" in muddy.source


def test_a_drive_may_say_the_speed_of_its_own(tmp_path: Path) -> None:
    (tmp_path / "mine.toml").write_text(LAGGING, "utf-8")
    preset = "lagging = { preset = 'mine.toml', slip_speed = '10 mm/s' }"
    own = DRIVE.replace('condition = ["dry", "muddy"]\n', "")
    (tmp_path / "drive.toml").write_text(own.replace('lagging = "mine.toml"', preset), "utf-8")
    of = load_drive(tmp_path / "drive.toml")
    assert of.pulleys[0].lagging.law.friction(1e-3, 1e5) == pytest.approx(0.5 * 0.95 * 0.8)


def test_a_note_assumes_nothing_that_the_factors_contradict(tmp_path: Path) -> None:
    (tmp_path / "mine.toml").write_text(LAGGING, "utf-8")
    (tmp_path / "drive.toml").write_text(
        DRIVE.replace('condition = ["dry", "muddy"]\n', ""), "utf-8"
    )
    text = markdown([solve(load_drive(tmp_path / "drive.toml"))], NoteHead())
    assert "not on speed, temperature or time (but by the factors among the inputs" in text
