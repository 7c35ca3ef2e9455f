"""The illustrative laggings, held to what has been published of such laggings.

Statements: B. DeVries, "A model of lagging friction as a function of creep history and wrap
pressure"; a maker's "two to three times" for full ceramic over rubber, of which these stay
below on purpose; the dry design values of CEMA and DIN 22101.
"""

import numpy as np
import pytest

from wraparc import Kind
from wraparc.catalogue import design_friction, lagging_names
from wraparc.drive import Lagging
from wraparc.files import load_lagging, load_lagging_conditions
from wraparc.friction import IntegralLog

PRESSURE = np.linspace(34e3, 690e3, 1313)
SLIP = np.linspace(0.25e-3, 15e-3, 60)
CERAMICS = ("medium-ceramic", "full-ceramic")
NAMES = ("diamond-rubber", *CERAMICS)


def law(name: str) -> IntegralLog:
    found = load_lagging(name).law
    assert isinstance(found, IntegralLog)
    return found


def friction(name: str) -> np.ndarray:
    """Friction over slip (rows) and pressure (columns)."""
    return law(name).friction(SLIP[:, None], PRESSURE[None, :])


def peak_slip(name: str) -> np.ndarray:
    return law(name).parameters(PRESSURE)[0]


def test_the_catalogue_has_the_three_laggings() -> None:
    assert set(lagging_names()) == set(NAMES)


@pytest.mark.parametrize("name", NAMES)
def test_illustrative_data_says_so(name: str) -> None:
    (lagging,) = load_lagging_conditions(name)
    assert lagging.name == name
    assert lagging.condition == "dry"
    assert lagging.source_of("law").kind is Kind.ILLUSTRATIVE
    assert "(illustrative)" in lagging.title
    assert any("Illustrative" in note for note in lagging.notes)
    assert lagging.source_of("thickness").kind is Kind.PUBLISHED
    assert "estimated" in lagging.source_of("shear_modulus").note
    assert "Gent and Lindley" in lagging.source_of("compression_modulus").note


@pytest.mark.parametrize(
    ("name", "thickness"), list(zip(NAMES, (12e-3, 15e-3, 12e-3), strict=True))
)
def test_sizes_as_published(name: str, thickness: float) -> None:
    lagging: Lagging = load_lagging(name)
    assert lagging.thickness == thickness
    assert lagging.elastic_modulus == 6.9e6
    assert lagging.block is not None
    assert lagging.shear_modulus == pytest.approx(2.3e6 * lagging.block.contact_fraction)
    assert 8e6 < lagging.compression_modulus < 20e6
    tested = lagging.law.tested
    assert tested is not None
    assert (tested.pressure_min, tested.pressure_max, tested.slip_max) == (34e3, 690e3, 15e-3)


@pytest.mark.parametrize("name", NAMES)
def test_friction_falls_with_pressure_at_every_slip(name: str) -> None:
    assert np.all(np.diff(friction(name), axis=1) < 0.0)


@pytest.mark.parametrize("name", NAMES)
def test_traction_rises_to_a_maximum(name: str) -> None:
    """'A maximum available traction, regardless of increasing pressure': near 550 kPa here."""
    traction = friction(name) * PRESSURE
    at = PRESSURE[traction.argmax(axis=1)]
    assert np.all((at > 500e3) & (at < 620e3))
    rising = PRESSURE < 500e3
    best = np.maximum.accumulate(traction, axis=1)
    # Where the peak slip of a ceramic runs away (122-168 kPa) traction at small slip dips.
    dip = {"diamond-rubber": 0.0, "medium-ceramic": 0.02, "full-ceramic": 0.055}[name]
    assert np.all(traction[:, rising] >= (1.0 - dip) * best[:, rising])
    steady = rising & (PRESSURE > 170e3)
    assert np.all(np.diff(traction[:, steady], axis=1) > 0.0)
    level = traction[:, PRESSURE > 500e3]
    assert np.all(level > 0.97 * level.max(axis=1, keepdims=True))


def test_rubber_shows_no_peak_in_its_tested_slip() -> None:
    assert np.all(peak_slip("diamond-rubber") > 15e-3)


@pytest.mark.parametrize("name", CERAMICS)
def test_the_peak_of_ceramics_moves_out_with_pressure(name: str) -> None:
    """Static and dynamic friction at low pressure; the peak disappears at 172 kPa."""
    slips = peak_slip(name)
    assert slips[0] <= 5e-3
    assert np.all(np.diff(slips) > 0.0)
    assert np.all(slips[PRESSURE < 140e3] < 15e-3)
    assert np.all(slips[PRESSURE > 172.5e3] > 15e-3)
    low = law(name).friction(SLIP, 34e3)
    assert low.argmax() < len(SLIP) - 1
    assert low[-1] > 0.85 * low.max()  # 'actual friction remains near the peak value'


def test_full_ceramic_against_rubber_at_207_kpa() -> None:
    slip = np.linspace(0.01e-3, 6e-3, 200)
    ratio = law("full-ceramic").friction(slip, 207e3) / law("diamond-rubber").friction(slip, 207e3)
    assert np.all((ratio > 1.7) & (ratio < 1.9))
    medium = law("medium-ceramic").friction(slip, 207e3)
    assert np.all(medium > law("diamond-rubber").friction(slip, 207e3))
    assert np.all(medium < law("full-ceramic").friction(slip, 207e3))


@pytest.mark.parametrize("name", NAMES)
def test_dry_values_lie_above_those_of_the_standards(name: str) -> None:
    lagging = load_lagging(name)
    published = [
        value.friction[1]
        for value in design_friction()
        if value.standard != "practice"
        and value.surface == lagging.surface
        and value.condition in ("", "dry")
    ]
    assert len(published) == 2
    assert float(lagging.law.friction(6.35e-3, 200e3)) > max(published)


@pytest.mark.parametrize(
    ("name", "pressure"), [("diamond-rubber", 172e3), *((name, 230e3) for name in CERAMICS)]
)
def test_the_transition_pressures_are_knots(name: str, pressure: float) -> None:
    assert pressure in law(name).coefficients.pressure
