"""Results in a notebook: well-formed HTML, data frames, and a hint where a library lacks."""

import sys
from dataclasses import replace
from html.parser import HTMLParser

import numpy as np
import pandas as pd
import pytest

from answer.drives import drive, solved
from wraparc import MissingExtraError, load_lagging
from wraparc.render.notebook import frame, html

pytestmark = pytest.mark.usefixtures("solved_once")


class Checker(HTMLParser):
    """Collects the text and insists that every tag is closed in order."""

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.text: list[str] = []
        self.tags: set[str] = set()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.open.append(tag)
        self.tags.add(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        self.text.append(data)


def checked(text: str) -> Checker:
    checker = Checker()
    checker.feed(text)
    checker.close()
    assert checker.open == []
    return checker


def test_a_result_shows_itself_with_its_verdict_and_sources() -> None:
    page = checked(solved()._repr_html_())
    text = " ".join(page.text)
    assert "ATTENTION Creep 7.49 mm exceeds the 6.35 mm limit (head, full)." in text
    assert "Action Use lagging full-ceramic: creep 4.36 mm." in text
    assert "Data Friction, block, E_c illustrative; G estimated." in text
    assert "The friction of diamond-rubber is illustrative" in solved().full().replace("\n", " ")
    assert "CEMA, Belt Conveyors for Bulk Materials" not in text
    assert "CEMA, Belt Conveyors for Bulk Materials" in solved().full()
    assert {"table", "caption", "th"} <= page.tags


def test_everything_that_can_be_shown_shows_itself() -> None:
    arc = solved().arc("head")
    for thing in (arc, arc.profile, drive(), load_lagging("full-ceramic")):
        assert checked(thing._repr_html_()).text
    with pytest.raises(TypeError, match="nothing known to show of int"):
        html(1)


def test_names_cannot_smuggle_markup() -> None:
    hostile = replace(drive(), title="<script>alert(1)</script>")
    page = checked(hostile._repr_html_())
    assert "script" not in page.tags
    assert "<script>alert(1)</script>" in page.text


def test_a_profile_becomes_a_frame() -> None:
    profile = solved().arc("head").profile
    table = profile.to_frame()
    assert isinstance(table, pd.DataFrame)
    assert list(table.columns) == [name for name, _ in profile.columns()]
    for name, values in profile.columns():
        assert np.array_equal(table[name].to_numpy(), values)
    pd.testing.assert_frame_equal(solved().arc("head").to_frame(), table)


def test_a_drive_becomes_a_frame_of_scalars() -> None:
    table = solved().to_frame()
    assert list(table.index.names) == ["load_case", "pulley"]
    assert table.loc[("full", "head"), "exit_creep"] == solved().arc("head").exit_creep
    assert table.loc[("full", "head"), "status"] == "solved"
    with pytest.raises(TypeError, match="no data frame of Drive"):
        drive().to_frame()


def test_without_pandas_the_extra_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(MissingExtraError, match=r"needs pandas: pip install 'wraparc\[notebook\]'"):
        frame(solved())
