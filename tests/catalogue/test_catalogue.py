"""The data that ships with the program, against its publications and against itself."""

import math
from dataclasses import replace
from pathlib import Path

import pytest

from wraparc import InputError, Kind
from wraparc.catalogue import (
    CatalogueBelt,
    belt,
    belts,
    design_friction,
    lagging_costs,
    lagging_names,
    lagging_text,
)
from wraparc.drive.changes import with_belt
from wraparc.drive.pitch import pitch_offset
from wraparc.files import drive_from_text, drive_text
from wraparc.train.file import load_drive

EXAMPLE = Path(__file__).parents[2] / "examples" / "head-drive-fabric.toml"


def designation(item: CatalogueBelt) -> float:
    """Breaking strength that the name states: "Plylon Plus 1000/4", "Flexsteel ST2000" [N/m]."""
    return 1e3 * float(item.name.split()[-1].split("/")[0].removeprefix("ST"))


def test_belts_as_published() -> None:
    """Rows of the maker's catalogue: ends and middle of each table."""
    rows = {
        "Plylon 220/2": (39e3, 4.028e6, None),
        "Plylon Plus 1000/4": (175e3, 12.96e6, None),
        "Plylon Plus 1800/4": (315e3, 21.9e6, None),
        "Flexsteel ST800": (120e3, 58e6, 0.8),
        "Flexsteel ST2000": (300e3, 144e6, 1.0),
        "Flexsteel ST7000": (1049e3, 504e6, 2.0),
    }
    for name, numbers in rows.items():
        item = belt(name)
        assert (item.rating, item.modulus, item.least_pulley_diameter) == numbers
        assert item.provenance.kind is Kind.PUBLISHED
        assert "Goodyear" in item.provenance.source
    assert [sum(b.kind == kind for b in belts()) for kind in ("fabric", "steel cord")] == [16, 15]
    assert len({b.name for b in belts()}) == len(belts())


def test_carcasses_as_published() -> None:
    """Goodyear EP catalogue 2012, p. 15, 21 and 71, metric: gauge or cable, mass, cover mass."""
    rows = {
        "Plylon 330/3": (4.11e-3, 4.8, 1200.0, "p. 21"),
        "Plylon Plus 250/2": (3.3e-3, 3.7, 1200.0, "p. 15"),
        "Plylon Plus 1000/5": (10.9e-3, 11.7, 1200.0, "p. 15"),
        "Flexsteel ST2500": (5.2e-3, 14.2, 1150.0, "p. 71"),
        "Flexsteel ST7000": (12.4e-3, 40.3, 1150.0, "p. 71"),
    }
    for name, (carcass, mass, cover, page) in rows.items():
        item = belt(name)
        assert item.carcass == pytest.approx(carcass, rel=1e-12)
        assert (item.carcass_mass, item.cover_mass) == pytest.approx((mass, cover))
        assert page in item.sources["carcass"].note
    # the same construction again: thicker carcasses are heavier, some 1.0 to 1.3 kg/m2 a mm of
    # fabric and 1.9 to 3.3 of cords in rubber; a shifted row of the table would fall out
    for item in belts():
        assert item.carcass is not None
        assert item.carcass_mass is not None
        low, high = (1.0, 1.25) if item.kind == "fabric" else (1.8, 3.4)
        assert low < 1e-3 * item.carcass_mass / item.carcass < high, item.name


def test_a_belt_of_the_catalogue_brings_its_carcass_and_no_covers() -> None:
    drive = load_drive(EXAMPLE)
    row = belt("Flexsteel ST1600")
    assert drive.belt.carcass == belt(drive.belt.name).carcass
    assert "p. 15" in drive.belt.source_of("carcass").note
    covered = replace(drive, belt=replace(drive.belt, pulley_cover=3e-3, carry_cover=6e-3))
    changed = with_belt(covered, row).belt
    assert (changed.carcass, changed.pulley_cover, changed.carry_cover) == (5.2e-3, 3e-3, 6e-3)
    assert changed.source_of("carcass") == row.sources["carcass"]
    assert pitch_offset(with_belt(drive, row).belt, "pulley") is None
    assert drive_from_text(drive_text(drive)) == drive


def test_ratings_follow_from_the_designations() -> None:
    """The safety factor is one number for each class of belt: a slip of a digit would show."""
    for item in belts():
        factor = designation(item) / item.rating
        if item.kind == "fabric":
            assert factor == pytest.approx(5.70, rel=0.012), item.name
        else:
            assert factor == pytest.approx(6.67, rel=0.005), item.name
            assert item.modulus / designation(item) == pytest.approx(72.0, rel=0.008), item.name


def test_least_pulleys_grow_with_the_belt() -> None:
    sizes = [b.least_pulley_diameter for b in belts() if b.kind == "steel cord"]
    assert sizes == sorted(s for s in sizes if s is not None)


def test_names_are_found_whatever_their_case_and_blanks() -> None:
    assert belt("flexsteel  st2000") is belt("Flexsteel ST2000")


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        (
            "Flexsteel ST7001",
            (
                'the catalogue has no belt of this name, got "Flexsteel ST7001". Did you mean '
                '"Flexsteel ST7000" or "Flexsteel ST800" or "Flexsteel ST6500"?'
            ),
        ),
        (
            "Plylon Plus 1000/6",
            (
                'the catalogue has no belt of this name, got "Plylon Plus 1000/6". Did you '
                'mean "Plylon Plus 1200/6" or "Plylon Plus 1000/5" or "Plylon Plus 1000/4"?'
            ),
        ),
        (
            "?",
            'the catalogue has no belt of this name, got "?". List them: wraparc belts.',
        ),
    ],
)
def test_an_unknown_belt_names_the_nearest(name: str, expected: str) -> None:
    with pytest.raises(InputError) as caught:
        belt(name)
    assert str(caught.value) == expected


def test_an_unknown_lagging_names_the_nearest() -> None:
    with pytest.raises(InputError) as caught:
        lagging_text("../costs")
    assert str(caught.value) == (
        'the catalogue has no lagging of this name, got "../costs". List them: wraparc laggings.'
    )
    assert lagging_names() == ("diamond-rubber", "full-ceramic", "medium-ceramic")


def test_ten_year_costs_add_up() -> None:
    """As published: one lagging and its installation, as often as it is worn out in ten years."""
    renewals = {"rubber": 6, "ceramic, cold bonded": 1, "ceramic, hot vulcanised": 1}
    for cost in lagging_costs():
        assert cost.ten_year_cost == renewals[cost.name] * (cost.material + cost.installation)
        fewest, most = (math.ceil(10.0 / years) for years in reversed(cost.life_years))
        assert fewest <= renewals[cost.name] <= most
        assert cost.area == pytest.approx(math.pi * 1.0 * 2.0)
        assert "AUD assumed" in cost.provenance.note


def test_design_friction_as_published() -> None:
    values = {(d.standard, d.surface, d.condition): d.friction for d in design_friction()}
    assert values["CEMA", "rubber", ""] == (0.35, 0.35)
    assert values["CEMA", "ceramic", ""] == (0.5, 0.5)
    assert values["DIN 22101", "bare", "wet and dirty"] == (0.05, 0.10)
    assert values["DIN 22101", "rubber", "dry"] == (0.40, 0.45)
    assert values["practice", "ceramic", "dry"] == (0.8, 0.8)
    assert len(values) == len(design_friction()) == 21


def test_design_friction_is_plausible() -> None:
    """Never better when wetter or dirtier; single wet values are marked."""
    order = ("dry", "wet", "wet and dirty")
    for d in design_friction():
        low, high = d.friction
        assert 0.0 < low <= high < 1.0
        marked = "IS 11592" in d.provenance.note
        assert marked == (d.standard == "DIN 22101" and low == high)
        for other in design_friction():
            same = (d.standard, d.surface) == (other.standard, other.surface)
            if same and d.condition and order.index(d.condition) < order.index(other.condition):
                assert low >= other.friction[0]
                assert high >= other.friction[1]
