"""The example drives are what their comments say."""

import pytest

from files.samples import EXAMPLE_DRIVES, example
from wraparc import Kind
from wraparc.drive import Drive, design_remarks
from wraparc.files import load_drive


def load(name: str) -> Drive:
    return load_drive(example(name))


@pytest.mark.parametrize("name", EXAMPLE_DRIVES)
def test_examples_say_that_their_laggings_are_illustrative(name: str) -> None:
    drive = load(name)
    remarks = " ".join(design_remarks(drive))
    assert drive.title
    for pulley in drive.pulleys:
        assert f"The friction of {pulley.lagging.name} is illustrative" in remarks
    assert "check the unit" not in remarks


def test_the_fabric_drive() -> None:
    drive = load("head-drive-fabric")
    assert [case.name for case in drive.load_cases] == ["design", "empty", "start"]
    assert drive.load_cases[0].tensions["head"].ratio == 2.5
    assert drive.load_cases[2].tensions["head"].effective == pytest.approx(1.4 * 90e3)


def test_the_steel_cord_drive_leaves_the_tested_pressures() -> None:
    remarks = design_remarks(load("steel-cord-drive"))
    assert remarks[1] == (
        "Load case start, pulley head: the wrap pressure at the entry, 695.8 kPa, is outside the "
        "tested 34.00 kPa to 690.0 kPa of lagging full-ceramic."
    )


def test_the_downhill_drive_brakes() -> None:
    """250 hp at 600 fpm hold back 33000 x 250/600 = 13750 lbf."""
    cases = load("downhill-braking").load_cases
    design, empty, _ = (case.tensions["tail"] for case in cases)
    assert design.effective == pytest.approx(-13750 * 4.4482216152605, rel=1e-12)
    assert design.ratio < 1.0
    assert empty.ratio > 1.0


def test_the_calibrated_pulley_marks_every_input_as_assumed() -> None:
    drive = load("test-pulley-calibrated")
    assert "calibrated" in drive.title.casefold()
    assert "assumed" in drive.description
    (pulley,) = drive.pulleys
    inputs = {"diameter", "wrap_angle", "lagging", "entry_tension", "exit_tension"}
    assert set(pulley.sources) == inputs
    assert {"modulus", "width"} <= set(drive.belt.sources)
    for source in (*pulley.sources.values(), *drive.belt.sources.values()):
        assert source.kind in (Kind.ILLUSTRATIVE, Kind.CALIBRATED)
