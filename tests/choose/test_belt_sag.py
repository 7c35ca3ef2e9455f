"""Belt sag: the customary factors of CEMA, a floor of the least take-up, a reason of rejection."""

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from choose.searches import search
from cli.running import wraparc
from wraparc import InputError
from wraparc.answer.choose_sheet import choose_sheet
from wraparc.answer.choose_words import reason, saving_words
from wraparc.answer.sheet import shown
from wraparc.choose.file import load_search
from wraparc.choose.search import Limits
from wraparc.choose.selection import choose, own_slack
from wraparc.drive import GRAVITY, Sag

EXAMPLES = Path(__file__).parents[2] / "examples" / "wet-season"
HEAVY = Sag(spacing=3.0, line_mass=220.0)


@pytest.mark.parametrize(("share", "factor"), [(0.03, 4.2), (0.02, 6.25), (0.015, 8.4)])
def test_the_tension_is_that_of_cema(share: float, factor: float) -> None:
    """CEMA, Belt Conveyors for Bulk Materials: T = 4.2, 6.25, 8.4 S W for 3, 2, 1.5 % (rounded)."""
    sag = Sag(spacing=1.2, line_mass=50.0, share=share)
    assert sag.tension == pytest.approx(factor * 1.2 * 50.0 * GRAVITY, rel=0.01)


def test_a_parabola_sags_by_that_much() -> None:
    """Moment at mid-span m' g l^2/8 over the tension is the sag."""
    sag = Sag(spacing=2.0, line_mass=40.0, share=0.015)
    middle = 40.0 * GRAVITY * 2.0**2 / 8.0 / sag.tension
    assert middle / 2.0 == pytest.approx(0.015)


@pytest.mark.parametrize(
    ("field", "value"), [("spacing", 0.0), ("line_mass", -1.0), ("share", 0.2), ("share", 0.0)]
)
def test_senseless_values_are_refused(field: str, value: float) -> None:
    with pytest.raises(InputError) as caught:
        Sag(**({"spacing": 3.0, "line_mass": 20.0} | {field: value}))
    assert caught.value.problems[0].key == field


def test_the_least_take_up_is_not_below_it() -> None:
    without = choose(search(slack_tensions=()))
    limits = Limits(sag=HEAVY)
    within = choose(search(slack_tensions=(), limits=limits))
    floor = HEAVY.tension + 15e3  # what the take-up behind the pulley holds more than the entry
    solved = ~without.standings["creep"].missed & ~without.standings["gross_slip"].missed
    assert np.any(without.slack_tension[solved] < floor)
    assert np.any(without.slack_tension[solved] > floor)
    expected = np.maximum(without.slack_tension, floor)[solved]
    assert within.slack_tension[solved] == pytest.approx(expected)
    assert not within.standings["sag"].broken[solved].any()


def test_a_given_take_up_below_it_is_rejected_with_the_reason() -> None:
    """220 kg/m on 3 m at 2 % take 40.5 kN: 45 kN behind a braking pulley are 30 kN before it."""
    found = choose(search(limits=Limits(sag=HEAVY)))
    short = found.grid.slack == 45e3
    assert np.array_equal(found.standings["sag"].broken, short)
    design = int(np.flatnonzero(short)[0])
    told = shown(reason(found, design, "sag"), "si")
    assert told == "the sag of the belt: 30 kN, min 40.5 kN (26 % under) [brake]"


def test_the_choose_file_gives_it_and_the_remarks_say_whether() -> None:
    given = load_search(EXAMPLES / "choose.toml")
    assert given.limits.sag == Sag(spacing=3.0, line_mass=22.0)
    told = shown(choose_sheet(choose(given)), "si")
    assert any("belt sag of 2 % of the idler spacing (4.05 kN)" in r for r in told.remarks)
    assert any("CEMA" in s and "DIN 22101" in s for s in told.sources)
    silent = shown(
        choose_sheet(choose(replace(given, limits=replace(given.limits, sag=None)))), "si"
    )
    assert any("it is not checked" in remark for remark in silent.remarks)


def test_a_table_that_lacks_the_mass_is_told(tmp_path: Path) -> None:
    text = (EXAMPLES / "choose.toml").read_text("utf-8")
    lines = [line for line in text.splitlines() if not line.startswith("sag.line_mass")]
    (tmp_path / "choose.toml").write_text("\n".join(lines), "utf-8")
    drive = (EXAMPLES / "wet-season-drive.toml").read_text("utf-8")
    (tmp_path / "wet-season-drive.toml").write_text(drive, "utf-8")
    ran = wraparc("choose", tmp_path / "choose.toml")
    assert ran.code == 2
    assert "limits.sag.line_mass" in ran.err
    assert "22 kg/m" in ran.err


def mass(tension: float) -> str:
    """Mass of a counterweight in three digits, rounded upwards: it is to hold as told."""
    unit = 10.0 ** (math.floor(math.log10(2.0 * tension / GRAVITY)) - 2)
    return f"{math.ceil(2.0 * tension / GRAVITY / unit) * unit:.0f}"


def test_the_saving_is_that_of_the_cheapest_design() -> None:
    """Both load cases of the drive keep 55 kN behind the pulley; 130 kN is its largest tension."""
    found = choose(search(slack_tensions=()))
    assert own_slack(found.search) == 55e3
    best = int(found.ranking[0])
    then = float(found.slack_tension[best])
    take_up, rating = shown(tuple(saving_words(found)), "si")
    assert f"{abs(55e3 - then) / 1e3:.4g}"[:3] in take_up
    assert "less" in take_up if then < 55e3 else "more" in take_up
    assert f"from {mass(55e3)} kg to {mass(then)} kg" in take_up
    tight = float(found.tight_tension[best]) / 1.2e3
    assert f"from {130 / 1.2:.0f} kN/m to {tight:.2f}"[:19] in rating
    assert list(shown(tuple(saving_words(choose(search()))), "si")) == []
