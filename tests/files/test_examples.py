"""The example drives are what their comments say."""

import pytest

from files.samples import EXAMPLE_DRIVES, example
from wraparc import Kind
from wraparc.checks import Place, before
from wraparc.drive import Drive
from wraparc.files import load_drive
from wraparc.units import in_units


def load(name: str) -> Drive:
    return load_drive(example(name))


@pytest.mark.parametrize("name", EXAMPLE_DRIVES)
def test_examples_say_that_their_laggings_are_illustrative(name: str) -> None:
    drive = load(name)
    told = before(drive)
    remarks = " ".join(told.remarks)
    assert "friction" in told.data.of_class("illustrative")
    assert drive.title
    for pulley in drive.pulleys:
        assert f"The friction of {pulley.lagging.name} is illustrative" in remarks
    assert "usual_sizes" not in {c.name for c in told.missed}


def test_the_fabric_drive() -> None:
    drive = load("head-drive-fabric")
    assert [case.name for case in drive.load_cases] == ["design", "empty", "start"]
    assert drive.load_cases[0].tensions["head"].ratio == 2.5
    assert drive.load_cases[2].tensions["head"].effective == pytest.approx(1.4 * 90e3)


def test_the_steel_cord_drive_leaves_the_tested_pressures() -> None:
    missed = next(
        c for c in before(load("steel-cord-drive")).missed if c.name == "tested_pressure_max"
    )
    assert missed.place == Place("head", "start")
    assert (
        in_units(missed.text) == "Wrap pressure 696 kPa exceeds the tested 690 kPa (head, start)."
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
    of_belt = {key: of for key, of in drive.belt.sources.items() if key != "carcass"}
    for source in (*pulley.sources.values(), *of_belt.values()):
        assert source.kind in (Kind.ILLUSTRATIVE, Kind.CALIBRATED)
    # the carcass of the belt that it is described by, which enters no answer without its covers
    assert drive.belt.source_of("carcass").kind is Kind.PUBLISHED
    assert drive.belt.pulley_cover is None
