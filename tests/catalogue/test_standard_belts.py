"""Belts by their standard names: what real data sheets say of them, each with its sheet."""

import math
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from typing import Any, NamedTuple

import pytest

from wraparc import InputError, Kind
from wraparc.catalogue import belt, find_belt
from wraparc.catalogue.belt_names import STRENGTHS, parse_belt_name
from wraparc.catalogue.standard_belts import CORDS, MODULUS
from wraparc.drive.changes import with_belt
from wraparc.drive.pitch import pitch_offset, whole_thickness
from wraparc.files import drive_from_document, drive_from_text, drive_text
from wraparc.train.file import load_drive

EXAMPLE = Path(__file__).parents[2] / "examples" / "head-drive-fabric.toml"
MM, PIW, INCH = 1e-3, 4.4482216152605 / 0.0254, 0.0254


class Sheet(NamedTuple):
    """What a sheet says [N/mm, mm, kg/m2]: thickness and mass of the whole belt, its carcass."""

    name: str
    strength: float
    plies: int = 0
    covers: tuple[float, float] | None = None
    tension: float | None = None
    thickness: float | None = None
    mass: float | None = None
    carcass: float | None = None
    modulus: float | None = None
    cords: tuple[float, float | None] | None = None


#: Roulunds, Ro-Ply, 2001: type, covers, largest working tension, thickness, mass.
ROULUNDS = [
    Sheet("EP 200/2 2+1", 200, 2, (2, 1), 20, 5.2, 6.8),
    Sheet("EP 250/2 3+1", 250, 2, (3, 1), 25, 6.6, 8.4),
    Sheet("EP 250/2 4+2", 250, 2, (4, 2), 25, 8.6, 10.6),
    Sheet("EP 315/2 3+1", 315, 2, (3, 1), 31.5, 6.8, 8.6),
    Sheet("EP 400/2 3+1", 400, 2, (3, 1), 40, 7.3, 9.1),
    Sheet("EP 400/2 5+1.5", 400, 2, (5, 1.5), 40, 9.8, 11.7),
    Sheet("EP 630/2 5+1.5", 630, 2, (5, 1.5), 63, 10.5, 13.4),
]
#: Neelkanth Beltings, selection chart, heavy duty: strength, working tension, carcass.
NEELKANTH = [
    Sheet("EP 315/3", 315, 3, tension=31, carcass=3.6),
    Sheet("EP 400/3", 400, 3, tension=40, carcass=3.6),
    Sheet("EP 400/4", 400, 4, tension=44, carcass=4.5),
    Sheet("EP 500/3", 500, 3, tension=50, carcass=3.7),
    Sheet("EP 500/4", 500, 4, tension=55, carcass=4.5),
    Sheet("EP 630/3", 630, 3, tension=63, carcass=3.9),
    Sheet("EP 630/4", 630, 4, tension=70, carcass=5.0),
    Sheet("EP 800/4", 800, 4, tension=90, carcass=5.4),
    Sheet("EP 1000/4", 1000, 4, tension=110, carcass=5.8),
    Sheet("EP 1000/5", 1000, 5, tension=110, carcass=6.6),
    Sheet("EP 1250/5", 1250, 5, tension=140, carcass=7.1),
]
#: Goodyear EP catalogue, 2012, p. 71: strength, operating tension, modulus.
GOODYEAR = [
    Sheet(f"ST{strength}", strength, tension=tension, modulus=modulus)
    for strength, tension, modulus in (
        (800, 120, 58000), (1250, 187, 90000), (1600, 240, 115000), (2500, 375, 180000),
        (3500, 525, 252000), (4500, 675, 324000), (5400, 810, 389000), (6000, 900, 432000),
        (6500, 975, 468000), (7500, 1124, 540000), (10000, 1499, 720000),
    )
]  # fmt: skip
#: Cords: NRC Industries, belts of steel cord (thickness with covers); BVH Rubber, DIN 22131.
CORDED = [
    Sheet("St 1000 5/5", 1000, 0, (5, 5), 143, 14.1, cords=(3.9, None)),
    Sheet("ST-2000 6+6", 2000, 0, (6, 6), 286, 17.6, cords=(5.4, None)),
    Sheet("ST 3150 7+7", 3150, 0, (7, 7), 450, 22.1, cords=(8.1, None)),
    Sheet("ST 4500 8:8", 4500, 0, (8, 8), 643, 25.7, cords=(9.7, None)),
    Sheet("ST 1000", 1000, cords=(3.85, 12)),
    Sheet("ST 2500", 2500, cords=(7.0, 15)),
    Sheet("ST 4000", 4000, cords=(9.0, 15)),
]
OTHERS = [
    # Phoebus, technical data sheet, 2020: 1000 mm, 11.4 mm thick, 14.73 kg/m
    Sheet("P630/4 5+2 DIN-K B", 630, 4, (5, 2), thickness=11.4, mass=14.73),
    # Sempertrans, belt data sheet of a project in Peru, 2014: 1200 mm, 33.1 kg/m, 72000
    Sheet("ST 1000 12+6 DIN X", 1000, 0, (12, 6), mass=33.1 / 1.2, modulus=72000),
    # conveyorbeltguide.com, designation by DIN 22102 and 22131
    Sheet("DIN 22102 AB 1000 EP 630/4 6/2 Y", 630, 4, (6, 2)),
    Sheet("DIN 22131 AB 1200 St 1600 7T/5 X", 1600, 0, (7, 5)),
    # Tehnoguma and Bison, how belts are labelled
    Sheet("EP – 400/3 – 4/2 – Y", 400, 3, (4, 2)),
    Sheet("EP 400/3 4+2 DIN Y", 400, 3, (4, 2)),
    Sheet("EP 1000/4 6+3 Y 1200mm", 1000, 4, (6, 3)),
    Sheet("NN 1250/5 8+3 M-24", 1250, 5, (8, 3)),
    # JT Conveyor: of 630 N/mm 360 PIW at 10 to 1
    Sheet("EP630/3", 630, 3, tension=360 * PIW / 1e3),
    # Goodyear EP catalogue, 2012, p. 20: Plylon 330/3 and 440/4, gauge and modulus
    Sheet("330 PIW 3 ply", 10 * 330 * PIW / 1e3, 3, None, 330 * PIW / 1e3,
          carcass=0.162 * 25.4, modulus=34500 * PIW / 1e3),
    Sheet("440 PIW/4", 10 * 440 * PIW / 1e3, 4, None, 440 * PIW / 1e3,
          carcass=0.219 * 25.4, modulus=46000 * PIW / 1e3),
    # Tatanka, NN belts: of NN 250 two plies, 250 PIW, 0.094 in
    Sheet("2-250 PIW 3/16x1/16", 10 * 250 * PIW / 1e3, 2, (25.4 * 3 / 16, 25.4 / 16),
          tension=250 * PIW / 1e3, carcass=0.094 * 25.4),
]  # fmt: skip
SHEETS = [*ROULUNDS, *NEELKANTH, *GOODYEAR, *CORDED, *OTHERS]


def test_forty_sheets_are_here() -> None:
    assert len({sheet.name for sheet in SHEETS}) >= 40


@pytest.mark.parametrize("sheet", SHEETS, ids=[sheet.name for sheet in SHEETS])
def test_a_name_is_read_as_its_sheet_has_it(sheet: Sheet) -> None:
    """Strength, plies and covers exactly; what is usual within the spread that is told of it."""
    of, row = parse_belt_name(sheet.name), find_belt(sheet.name)
    assert of is not None
    assert row is not None
    assert row.strength == pytest.approx(1e3 * sheet.strength, rel=1e-9)
    assert of.plies == sheet.plies
    carry, pulley = sheet.covers or (None, None)
    assert row.carry_cover == (carry and pytest.approx(MM * carry))
    assert row.pulley_cover == (pulley and pytest.approx(MM * pulley))
    if sheet.tension is not None:  # makers have 8 to 10 of textile belts, 6.67 to 7 of cords
        least, most = (0.94, 1.07) if of.is_steel else (0.8, 1.02)
        assert least <= row.rating / (1e3 * sheet.tension) <= most
    if sheet.modulus is not None:
        assert row.modulus_ends is not None
        low, high = row.modulus_ends
        assert low <= 1e3 * sheet.modulus <= 1.01 * high
        assert row.modulus == pytest.approx(1e3 * sheet.modulus, rel=0.01 if of.is_steel else 0.3)
    if sheet.cords is not None:
        assert row.carcass == pytest.approx(MM * sheet.cords[0], rel=0.02)
        assert sheet.cords[1] is None or row.cord_pitch == pytest.approx(MM * sheet.cords[1])
    if sheet.carcass is not None:
        assert row.carcass is not None
        assert 0.8 <= MM * sheet.carcass / row.carcass <= 1.4
    _as_a_whole(sheet, row)


def _as_a_whole(sheet: Sheet, row: Any) -> None:
    """Compare thickness and mass of the belt in a drive a metre wide."""
    if sheet.thickness is None and sheet.mass is None:
        return
    built = drive_from_document(document({"preset": sheet.name, "modulus": "5000 kN/m"})).belt
    if sheet.thickness is not None:
        assert whole_thickness(built) == pytest.approx(MM * sheet.thickness, rel=0.1)
    if sheet.mass is not None:
        assert built.mass is not None
        assert built.mass == pytest.approx(sheet.mass, rel=0.16)
        assert built.source_of("mass").note.startswith("estimated")


def document(of: dict[str, Any]) -> dict[str, Any]:
    return {
        "format": 1,
        "belt": {"width": "1000 mm", "speed": "2 m/s", **of},
        "pulley": [
            {
                "name": "head", "diameter": "630 mm", "wrap_angle": "200 deg",
                "lagging": "diamond-rubber", "entry_tension": "40 kN", "exit_tension": "15 kN",
            }
        ],
    }  # fmt: skip


def refusal(of: dict[str, Any]) -> str:
    with pytest.raises(InputError) as caught:
        drive_from_document(document(of))
    return str(caught.value)


@pytest.mark.parametrize(
    ("slip", "meant"),
    [
        ("EP 6300/3", '"EP 630/3"'),  # a digit too many
        ("EP 630/33", '"EP 630/3"'),
        ("EP 650/3", '"EP 630/3"'),  # no strength of any belt
        ("EB 630/3", '"EP 630/3"'),  # a wrong letter
        ("630/3", '"EP 630/3"'),  # no carcass
        ("ST 1OOO", '"ST 1000"'),  # letters for digits
        ("ST 160", '"ST 1600"'),
        ("EP200x4", '"EP 800/4"'),  # four fabrics EP 200, as some makers write
        ("NN150*5", '"NN 750/5"'),
        ("EP 200/4", '"EP 800/4"'),  # no fabric is as weak as 50 N/mm
        ("ST 1650", '"ST 1600"'),
    ],
)
def test_a_typing_slip_is_asked_and_no_makers_belt_offered(slip: str, meant: str) -> None:
    for key in ("preset", "name"):
        text = refusal({key: slip})
        assert meant in text
        assert "Did you mean" in text
        assert "Plylon" not in text
        assert "Flexsteel" not in text
        assert text.startswith(f"belt.{key}: ")


def test_a_cover_too_thick_is_refused() -> None:
    assert refusal({"name": "EP 630/3 60+3"}) == (
        'belt.name: no cover is thicker than 35 mm, got "EP 630/3 60+3". Write covers as "6+3", in '
        "mm."
    )


@pytest.mark.parametrize("name", ["Fördergurt 7", "belt", "CV-07", "EP", "ST", "PIW", "1200 mm"])
def test_other_names_are_no_standard_names(name: str) -> None:
    assert parse_belt_name(name) is None


def test_a_fibre_that_is_not_told_is_asked_unless_the_modulus_is_given() -> None:
    """P is polyamide by DIN 22102, polyester on sheets of EP belts (Phoebus 2020)."""
    assert refusal({"name": "P 500/3"}) == (
        'belt.name: warp of P is polyester or polyamide, got "P 500/3". Write "EP 500/3" or '
        '"NN 500/3", or give modulus or elongation.'
    )
    assert "belt.preset: warp of PP is" in refusal({"preset": "PP 500/3"})
    by_elongation = drive_from_document(document({"name": "P 500/3", "elongation": "2 % at 10 %"}))
    assert by_elongation.belt.modulus == pytest.approx(0.1 * 500e3 / 0.02)
    own = drive_from_document(document({"preset": "P 500/3", "modulus": "3000 kN/m"})).belt
    assert (own.modulus, own.rating, own.strength) == (3000e3, 50e3, 500e3)


def test_what_is_usual_is_marked_and_has_its_source() -> None:
    for name in ("EP 630/3 5+2", "NN 500/4", "EE 800/4", "PN 1000/4", "ST 2000 8+6", "500 PIW"):
        row = belt(name)
        assert row.modulus == pytest.approx(row.modulus)  # no nan
        assert {"modulus"} <= {*row.sources}
        for source in row.sources.values():
            assert source.note.startswith("estimated: ")
            assert source.kind is Kind.PUBLISHED
        assert row.provenance.note.startswith("by its name")
    # nobody publishes cords of these: None, and no pulley that follows from them
    for name in ("ST 7500", "ST 6300"):
        row = belt(name)
        unknown = (row.carcass, row.cord_pitch, row.carcass_mass, row.least_pulley_diameter)
        assert unknown == (None, None, None, None)


def test_least_pulleys_by_din_22101() -> None:
    """108 times the carcass of polyester, 90 of polyamide, 145 of cords, rounded up to a size."""
    assert belt("EP 630/3").least_pulley_diameter == 0.5  # 108 x 4.0 mm = 432 mm
    assert belt("NN 630/3").least_pulley_diameter == 0.315  # 90 x 3.4 mm = 306 mm
    assert belt("ST 1000").least_pulley_diameter == 0.63  # 145 x 3.9 mm = 566 mm
    assert belt("ST 5400").least_pulley_diameter == 1.8  # 145 x 11.3 mm = 1639 mm


def test_stronger_belts_are_stiffer_thicker_and_heavier() -> None:
    """A slip of a digit in a table would fall out."""
    rows = [belt(f"ST {strength}") for strength in sorted(CORDS)]
    for lighter, heavier in pairwise(rows):
        assert lighter.modulus < heavier.modulus
        assert (lighter.carcass or 0.0) <= (heavier.carcass or 0.0)
        assert (lighter.carcass_mass or 0.0) < (heavier.carcass_mass or 0.0)
    plies = [belt(f"EP {strength}/4") for strength in STRENGTHS[2:]]
    assert [row.carcass for row in plies] == sorted(row.carcass or 0.0 for row in plies)
    for ends in MODULUS.values():
        assert ends.least <= ends.value <= ends.most


def test_masses_of_cords_as_goodyear_publishes_them() -> None:
    """Within 7 % of the carcass weights of p. 71, by the diameters there."""
    for name, mass in (("ST6000", 36.4), ("ST6500", 38.4), ("ST7000", 40.3)):
        assert belt(name).carcass_mass == pytest.approx(mass, rel=0.07)


def test_a_name_alone_is_a_preset_and_own_keys_override_it() -> None:
    by_name = drive_from_document(document({"name": "EP 630/3 5+2"}))
    assert by_name == drive_from_document(document({"preset": "EP 630/3 5+2"}))
    of = by_name.belt
    assert (of.strength, of.rating, of.kind) == (630e3, 63e3, "fabric")
    assert pitch_offset(of, "pulley") == pytest.approx(2e-3 + 0.5 * of.carcass)  # type: ignore[operator]
    own = drive_from_document(document({"name": "EP 630/3 5+2", "rating": "70 kN/m"})).belt
    assert own == replace(of, rating=70e3, sources=own.sources)
    assert own.source_of("rating").note == ""
    # beside a modulus a name is a name, as before
    plain = drive_from_document(document({"name": "EP 630/3", "modulus": "6300 kN/m"})).belt
    assert (plain.rating, plain.carcass, plain.breaking_strength) == (None, None, 630e3)


def test_a_thickness_or_a_cord_diameter_of_ones_own_replaces_the_usual_carcass() -> None:
    of = drive_from_document(document({"name": "EP 630/3 5+2", "thickness": "11.2 mm"})).belt
    assert of.carcass is None
    assert whole_thickness(of) == pytest.approx(11.2e-3)
    cords = drive_from_document(document({"name": "ST 2000 8+6", "cord_diameter": "5.6 mm"})).belt
    assert cords.cord == pytest.approx(5.6e-3)
    assert cords.cord_pitch == pytest.approx(12e-3)


@pytest.mark.parametrize(
    "of",
    [
        {"name": "EP 630/3"},
        {"name": "DIN 22102 AB 1000 EP 630/4 6/2 Y"},
        {"preset": "ST 2000 8+6", "rating": "280 kN/m"},
        {"preset": "330 PIW 3 ply", "carry_cover": "3 mm", "pulley_cover": "2 mm"},
        {"name": "NN 500/4", "elongation": "2.5 % at 10 %"},
        {"preset": "P 500/3", "modulus": "3000 kN/m"},
        {"name": "EP 630/3", "modulus": "6300 kN/m"},
        {"name": "EP 6300/3", "modulus": "6300 kN/m"},
    ],
)
def test_a_written_file_is_the_same_drive(of: dict[str, Any]) -> None:
    drive = drive_from_document(document(of))
    assert drive_from_text(drive_text(drive)) == drive


def test_a_belt_by_its_name_replaces_another() -> None:
    drive = load_drive(EXAMPLE)
    changed = with_belt(drive, belt("EP 1000/4 6+3 Y")).belt
    assert changed.carry_cover == pytest.approx(6e-3)
    assert changed.pulley_cover == pytest.approx(3e-3)
    assert changed.mass is not None
    assert changed.width == drive.belt.width
    assert drive_from_text(drive_text(replace(drive, belt=changed))).belt == changed
    # the covers of a belt without any in its name stay those of before
    kept = with_belt(replace(drive, belt=changed), belt("EP 800/4")).belt
    assert kept.pulley_cover == changed.pulley_cover


def test_elongation_is_refused_with_what_to_write() -> None:
    example = 'Write for example "1.5 % at 10 %".'
    wrong = {
        "1.5 %": "must be an elongation at a share of the strength",
        "0 % at 10 %": "must be above 0 %, at most 20 % at 100 %",
        "x % at 10 %": "must be an elongation at a share of the strength",
        "1.5 % at 150 %": "must be above 0 %, at most 20 % at 100 %",
    }
    for text, message in wrong.items():
        expected = f'belt.elongation: {message}, got "{text}". {example}'
        assert refusal({"name": "EP 630/3", "elongation": text}) == expected
    both = {"name": "EP 630/3", "elongation": "1.5 % at 10 %", "modulus": "6300 kN/m"}
    assert refusal(both) == ("belt.elongation: modulus gives it already. Leave one of them out.")
    assert refusal({"name": "mine", "elongation": "1.5 % at 10 %"}) == (
        'belt.elongation: needs the strength of the belt. Write strength = "630 kN/m", or name '
        "the belt EP 630/3."
    )


@pytest.mark.parametrize("text", ["1.5 % at 10 %", "1,5 % bei 10 %", "1.5% @ 10%", "1.5 %/10 %"])
def test_elongation_gives_the_modulus(text: str) -> None:
    """A tenth of 630 kN/m over 1.5 %: 4200 kN/m."""
    of = drive_from_document(document({"name": "EP 630/3", "elongation": text})).belt
    assert of.modulus == pytest.approx(4.2e6, rel=1e-12)
    assert of.source_of("modulus").note == "by elongation, 1.5 % at 10 %"
    assert (of.modulus_test, of.modulus_loads) == ("static", (0.0, 0.1))  # a first stretch
    own = {"name": "mine", "strength": "630 kN/m", "elongation": text}
    assert drive_from_document(document(own)).belt.modulus == pytest.approx(4.2e6, rel=1e-12)


def test_all_names_stay_names() -> None:
    """No name of a belt takes long or falls over, whatever stands in it."""
    for name in ("EP " + "A " * 28, "A" * 60, "EP 630/3 " + "A" * 50, "1/" * 30, "ST" + "9" * 58):
        try:
            parse_belt_name(name)
        except InputError:
            continue
    assert math.isnan(parse_belt_name("330 PIW").strength)  # type: ignore[union-attr]
