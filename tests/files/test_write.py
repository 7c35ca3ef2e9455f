"""What is written reads back equal; what the user wrote is kept where it still holds."""

import os
from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from files.samples import EXAMPLE_DRIVES, LAGGINGS, drives, example, numbers
from wraparc import InputError
from wraparc.drive import Drive, Lagging
from wraparc.files import (
    drive_from_document,
    drive_from_text,
    drive_text,
    lagging_from_text,
    lagging_text,
    load_drive,
    load_lagging,
    load_lagging_conditions,
    save_drive,
    save_lagging,
)
from wraparc.schema.quantity_text import quantity_text
from wraparc.schema.source import parse
from wraparc.units import DIMENSIONS, Dimension, parse_quantity

EXAMPLES = [example(name) for name in EXAMPLE_DRIVES]


@given(st.sampled_from(DIMENSIONS), numbers(-1e12, 1e12))
def test_a_quantity_reads_back_equal(dimension: Dimension, value: float) -> None:
    if 0.0 < abs(value) < 1e-30:
        return
    assert parse_quantity(quantity_text(value, dimension), dimension) == value


@pytest.mark.parametrize(
    ("text", "dimension"),
    [
        ("1200 mm", "length"),
        ("0.1 mm", "length"),
        ("150 kN", "force"),
        ("180 deg", "angle"),
        ("33.3 deg", "angle"),
        ("12960 kN/m", "force_per_width"),
        ("-0.016 1/mm", "per_length"),
        ("0.05 mm3/J", "wear_coefficient"),
    ],
)
def test_quantities_are_written_as_people_write_them(text: str, dimension: Dimension) -> None:
    assert quantity_text(parse_quantity(text, dimension), dimension) == text


@settings(max_examples=60)
@given(LAGGINGS)
def test_a_lagging_reads_back_equal(lagging: Lagging) -> None:
    assert lagging_from_text(lagging_text(lagging)) == (lagging,)


@settings(max_examples=60)
@given(drives())
def test_a_drive_reads_back_equal(drive: Drive) -> None:
    assert drive_from_text(drive_text(drive)) == drive


@pytest.mark.parametrize("name", ["diamond-rubber", "medium-ceramic", "full-ceramic"])
def test_catalogue_laggings_read_back_equal(name: str) -> None:
    laggings = load_lagging_conditions(name)
    assert lagging_from_text(lagging_text(laggings)) == laggings


def test_a_changed_catalogue_lagging_reads_back_equal() -> None:
    """The blocks that its modulus was estimated from stand there with it."""
    lagging = replace(load_lagging("diamond-rubber"), bond_strength=1e5)
    assert lagging.block is not None
    assert lagging_from_text(lagging_text(lagging)) == (lagging,)


def test_a_rigid_belt_reads_back_equal() -> None:
    drive = load_drive(example("head-drive-fabric"))
    rigid = replace(drive, belt=replace(drive.belt, name="rigid belt", modulus=float("inf")))
    assert 'modulus = "rigid"' in drive_text(rigid)
    assert drive_from_text(drive_text(rigid)) == rigid


def test_conditions_of_one_lagging_share_a_file() -> None:
    dry = load_lagging("full-ceramic")
    wet = replace(
        dry,
        condition="wet",
        law=load_lagging("diamond-rubber").law,
        notes=(*dry.notes, "tested under a spray"),
    )
    assert lagging_from_text(lagging_text([dry, wet])) == (dry, wet)
    with pytest.raises(InputError) as caught:
        lagging_text([dry, replace(wet, thickness=0.02)])
    assert str(caught.value) == (
        "laggings of one file differ in more than their laws: full-ceramic. "
        "Write them into files of their own."
    )


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_examples_read_back_equal(path: Path) -> None:
    drive = load_drive(path)
    assert drive_from_text(drive_text(drive)) == drive


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_an_unchanged_drive_keeps_every_text(path: Path) -> None:
    document = parse(path.read_text("utf-8"))
    assert parse(drive_text(load_drive(path), like=document)) == document


def test_a_changed_drive_keeps_what_still_holds() -> None:
    path = next(path for path in EXAMPLES if path.stem == "downhill-braking")
    document = parse(path.read_text("utf-8"))
    drive = load_drive(path)
    (pulley,) = drive.pulleys
    wider = replace(drive, pulleys=(replace(pulley, diameter=1.2),))
    text = drive_text(wider, like=document)
    assert drive_from_text(text) == wider
    written = parse(text)
    assert written["belt"] == document["belt"]
    assert written["creep_limit"] == "0.25 in"
    (before,), (after,) = document["pulley"], written["pulley"]
    assert after["diameter"] == "1200 mm"
    for key in ("wrap_angle", "lagging", "entry_tension"):
        assert after[key] == before[key]


def test_a_lagging_from_elsewhere_is_written_into_the_drive(tmp_path: Path) -> None:
    save_lagging(replace(load_lagging("full-ceramic"), name="ours"), tmp_path / "ours.toml")
    file = tmp_path / "drive.toml"
    text = EXAMPLES[1].read_text("utf-8")
    assert 'lagging = "diamond-rubber"' in text
    file.write_text(text.replace("diamond-rubber", "ours.toml"), "utf-8")
    drive = load_drive(file)
    assert drive.pulleys[0].lagging.name == "ours"
    assert drive_from_text(drive_text(drive)) == drive


def test_a_changed_preset_stays_a_preset() -> None:
    drive = load_drive(EXAMPLES[1], overrides=["pulley.head.lagging.thickness=20 mm"])
    (pulley,) = parse(drive_text(drive))["pulley"]
    assert pulley["lagging"] == {"preset": "diamond-rubber", "thickness": "20 mm"}


@pytest.mark.parametrize(
    "more",
    [
        {"shear_modulus": "1500 kPa"},
        {"compression_modulus": "9000 kPa"},
        {"shear_modulus": "1500 kPa", "compression_modulus": "9000 kPa"},
    ],
    ids="+".join,
)
def test_a_preset_with_other_moduli_keeps_them_and_its_blocks(more: dict[str, str]) -> None:
    """As they were given: the shear modulus is that of the rubber, blocks cover 85 % of it."""
    over = {f"pulley.head.lagging.{key}": value for key, value in more.items()}
    drive = load_drive(EXAMPLES[1], overrides=over)
    document = parse(drive_text(drive))
    (pulley,) = document["pulley"]
    assert pulley["lagging"] == {"preset": "diamond-rubber", **more}
    again = drive_from_document(document)
    assert again.pulleys[0].lagging.block == drive.pulleys[0].lagging.block
    assert again.pulleys[0].lagging.contact_fraction == 0.85


def test_a_stated_shear_modulus_of_blocks_reads_back_with_its_source() -> None:
    text = lagging_text(load_lagging("diamond-rubber")).replace("diamond-rubber", "mine", 1)
    own = '{ kind = "measured", source = "own test", note = "cut out" }'
    text = text.replace("[sources]\n", f"[sources]\nshear_modulus = {own}\n")
    text = text.replace("thickness =", 'shear_modulus = "1.7 MPa"\nthickness =', 1)
    (lagging,) = lagging_from_text(text)
    assert lagging.shear_modulus == pytest.approx(0.85 * 1.7e6)
    of = lagging.source_of("shear_modulus")
    assert (of.kind.value, of.source) == ("measured", "own test")
    assert "contact fraction 0.85" in of.note
    assert of.note.endswith("; cut out")
    text = lagging_text(lagging)
    assert 'shear_modulus = "1700 kPa"' in text
    (again,) = lagging_from_text(text)
    assert (again, again.block) == (lagging, lagging.block)


# ---- writing to disk ----


def test_a_file_is_written_whole_or_not_at_all(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    drive = load_drive(EXAMPLES[0])
    file = tmp_path / "drive.toml"
    file.write_text("before")

    def no_space(*_: object) -> None:
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr(os, "replace", no_space)
        with pytest.raises(InputError) as caught:
            save_drive(drive, file)
    assert str(caught.value) == (
        f"{file}: cannot be written: No space left on device. Choose another place."
    )
    assert file.read_text() == "before"
    assert list(tmp_path.iterdir()) == [file]
    save_drive(drive, file)
    assert load_drive(file) == drive
    assert list(tmp_path.iterdir()) == [file]


def test_a_place_that_is_not_there(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="cannot be written: No such file or directory"):
        save_lagging(load_lagging("full-ceramic"), tmp_path / "no" / "lagging.toml")
