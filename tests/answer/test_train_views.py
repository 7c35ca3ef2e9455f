"""A solved train in a notebook: its tables, its pictures, its data frame."""

import functools
import re
from dataclasses import replace
from pathlib import Path

import pytest

from answer.test_notebook import checked
from wraparc import Distributed, TrainResult, load_train, solve_train
from wraparc.answer.sheet import shown
from wraparc.answer.train_sheet import matching_sheet, train_sheet
from wraparc.plot import plot
from wraparc.render.page import sheet_html
from wraparc.train import Motors, VariableSpeed, match_drives

pytestmark = pytest.mark.usefixtures("solved_once")

EXAMPLES = Path(__file__).parents[2] / "examples"


@functools.cache
def tandem() -> TrainResult:
    """The shipped tandem with a fabric belt."""
    train = load_train(EXAMPLES / "tandem-fabric.toml")
    return solve_train(train, method=Distributed(capacities=False, points=20))


def test_it_shows_its_drives() -> None:
    text = " ".join(checked(tandem()._repr_html_()).text)
    assert "OK All 12 checks pass. Closest: wet creep (estimated) " in text
    assert " of 6.35 mm (second, design). Wet Creep " in text
    assert "Data Friction, block, E_c illustrative; G estimated." in text
    full = tandem().full()
    assert "Load case design: first takes 50 %, second takes 50 %." in full
    for words in ("Drives: load case design", "Drives: load case empty", "extra creep ", "g - g1"):
        assert words in full


def test_its_frame_has_a_row_for_each_drive_of_each_case() -> None:
    table = tandem().to_frame()
    assert list(table.index) == [
        ("design", "first"), ("design", "second"), ("empty", "first"), ("empty", "second"),
    ]  # fmt: skip
    row, member = table.loc[("design", "second")], tandem()["design"]["second"]
    for name in ("share", "speed_trim", "contraction_term", "creep_term"):
        assert row[name] == getattr(member, name)
    assert row["exit_creep"] == member.arc.exit_creep


@pytest.mark.parametrize("case", ["design", "empty"])
def test_it_draws_the_load_case_asked_for(case: str) -> None:
    picture = tandem().plot(case=case)
    texts = [t.get_text() for ax in picture.figure.axes for t in ax.texts]
    for m in tandem()[case]:
        assert f"{100 * m.share:.1f} %" in texts
        assert f"{m.arc.entry_tension / 1e3:.4g}" in " ".join(texts)
    tension, creep = picture.figure.axes[1:3]
    for line, m in zip(tension.lines, tandem()[case], strict=False):
        assert line.get_ydata() == pytest.approx(m.arc.profile.tension / 1e3)
    for line, m in zip(creep.lines, tandem()[case], strict=False):
        assert line.get_ydata() == pytest.approx(1e3 * m.arc.profile.creep)


def test_the_matching_draws_its_curves() -> None:
    matching = match_drives(tandem(), points=5)
    picture = plot(matching)
    shares = {ax.get_title("left") or ax.get_title(): ax for ax in picture.figure.axes}
    for title, curve in (
        ("Shares against trim", matching.trim),
        ("Shares against diameter", matching.diameter),
        ("Shares against load", matching.load),
    ):
        for i, name in enumerate(("first", "second")):
            (line,) = (drawn for drawn in shares[title].lines if drawn.get_label() == name)
            assert line.get_xdata() == pytest.approx(100 * curve.values)
            assert line.get_ydata() == pytest.approx(100 * curve.shares[:, i], nan_ok=True)


def test_in_us_units_nothing_stays_in_si() -> None:
    motor = VariableSpeed(rated_power=2e5, rated_speed=155.0, gear_ratio=20.6, droop=0.02)
    train = tandem().train
    driven = replace(train, cases=(replace(train.cases[0], division=Motors((motor, motor))),))
    result = solve_train(driven, method=Distributed(capacities=False, points=20))
    page = checked(sheet_html(shown(train_sheet(result, []), "us"))).text
    page += checked(
        sheet_html(shown(matching_sheet(tandem(), match_drives(tandem(), points=3)), "us"))
    ).text
    assert not re.findall(r"\d (?:kN|N|mm|m|kW|W|kPa|kN m)\b", " ".join(page))
    assert re.search(r"Motor torque M_m [\d.]+ lbf ft", " ".join(" ".join(page).split()))
    assert "0.0394 in worn off first" in " ".join(page)
