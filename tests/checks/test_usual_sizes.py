"""Usual sizes hold for every input, and the unit that was probably meant is named."""

from dataclasses import replace
from typing import Any

import pytest

from checks.test_rows import lagging, quiet
from worded import check_words
from wraparc.checks import Level, judge
from wraparc.checks.judge import before
from wraparc.drive import Criteria, Sag
from wraparc.units import meant_by


def said(**of: Any) -> list[str]:
    """Return what is unusual of a drive that is quiet but for something."""
    found = [c for c in before(quiet(**of)).checks if c.name == "usual_sizes"]
    return [check_words(c) for c in found if c.level is not Level.OK]


@pytest.mark.parametrize(
    ("of", "text"),
    [
        ({"pulley": {"wrap_angle": 9.42}}, "Wrap 540 deg exceeds 270 deg on one pulley (head)."),
        (
            {"pulley": {"wrap_angle": 0.0575958653158129}},
            "Check the unit of wrap: 3.3 rad?",
        ),  # 3.3 deg
        ({"creep_limit": 0.25}, "Check the unit of creep limit: 25 mm or 0.25 in?"),  # 250 mm
        ({"creep_limit": 0.16129}, "Check the unit of creep limit: 6.35 mm?"),  # 6.35 in
        ({"pulley": {"diameter": 630.0}}, "Check the unit of diameter: 630 mm?"),
        (
            {"lagging": lagging(thickness=0.12)},
            "Lagging thickness 120 mm is outside the usual 0 to 60 mm (head).",
        ),
        ({"lagging": lagging(shear_modulus=2.3e3)}, "2.3 MPa"),  # 2.3 kPa
        (
            {"lagging": lagging(bond_strength=2.0)},
            "Bond strength 0.002 kPa is outside the usual 10 kPa to 50 MPa (head).",
        ),
        (
            {"lagging": lagging(fatigue_limit=2e9)},
            "Check the unit of fatigue limit: 2 MPa or 2 psi?",
        ),  # 2 GPa
        (
            {"belt": {"modulus": 175e3}},
            "Belt modulus over rating 1 is outside the usual 15 to 1000. Check belt.modulus",
        ),
        ({"belt": {"modulus": 1000e3}}, "Check belt.modulus and belt.rating: both per width."),
        ({"belt": {"rating": 175.0}}, "Check the unit of belt rating: 175 kN/m"),
        (
            {"belt": {"strength": 100e3}},
            "Belt strength over rating 0.571 is outside the usual 4 to 20.",
        ),
        (
            {"pulley": {"diameter": 0.2}},
            "Wrap pressure at the belt rating 1750 kPa is outside the usual 0 to",
        ),
        ({"belt": {"mass": 500.0}}, "Check belt.mass: per length of belt."),
        ({"belt": {"mass": 0.3}}, "Belt mass 0.3 kg/m is outside the usual 1.2 to 156 kg/m."),
        ({"entry": 60.064e3}, "Power 0.192 kW is outside the usual"),  # 0.19 kW at 3 m/s
        (
            {"criteria": Criteria(sag=Sag(spacing=1.2, line_mass=0.06, share=0.02))},
            "Line mass for the sag of the belt 0.06 kg/m is outside the usual 1 to",
        ),
    ],
)
def test_a_slip_of_unit_is_asked_about(of: dict[str, Any], text: str) -> None:
    found = said(**of)
    assert len(found) == 1
    assert text in " ".join(found)


def test_what_does_not_deform_and_what_is_idle_is_usual() -> None:
    rigid = lagging(thickness=0.0, shear_modulus=float("inf"))
    assert said(lagging=rigid, entry=60e3) == []


def test_a_snub_pulley_may_be_wrapped_little() -> None:
    """Expected: what pulls nothing may be a snub or a bend; a drive has half a turn."""
    assert said(pulley={"wrap_angle": 0.5}, entry=60e3) == []
    (told,) = said(pulley={"wrap_angle": 0.5})
    assert told.startswith("Wrap 28.6 deg is outside the usual 120 to 270 deg (head).")


def test_what_is_unusual_in_a_condition_or_a_load_case_is_told_once() -> None:
    of = quiet(pulley={"wrap_angle": 9.42})
    two = replace(of, load_cases=(*of.load_cases, replace(of.load_cases[0], name="other")))
    assert len([c for c in judge_all(two) if c.name == "usual_sizes"]) == 1


def judge_all(drive: Any) -> Any:
    from wraparc import solve

    return judge(solve(drive, raise_on_failure=False)).checks


def test_units_that_a_number_may_have_had() -> None:
    # expected: 630 m is 630 of another unit of length; 1/3 m is no number that anybody writes
    assert meant_by(630.0, "length", 0.15, 3.0) == ["630 mm"]
    assert meant_by(1.0 / 3.0, "length", 1e-3, 0.06) == []
    assert meant_by(160.0, "power", 250.0, 2e7) == ["160 kW", "160 hp"]
    assert meant_by(0.9, "mass", 94.7, 7100.0) == ["900 kg"]  # 0.9 t is the same mass
