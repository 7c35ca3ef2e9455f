"""What a press takes out of what was typed is named, and Undo brings it back.

Expected of a press and its Undo: the document of before, to the last key. That of two presses which
are each other's opposite: the loads of `wraparc solve` before.
"""

import json
import re
import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Page, expect

from web.browser import Visitor, turn
from web.test_standing import take
from wraparc.arc import solve
from wraparc.drive import Drive
from wraparc.web.answers.documents import read

EXAMPLES = Path(__file__).parents[2] / "examples"
HEAD = (EXAMPLES / "head-drive-fabric.toml").read_text("utf-8")
TESTS = EXAMPLES / "shear_tests"
DOC = "import('/static/main.js').then((m) => m.app.doc)"


def doc_of(page: Page) -> dict[str, Any]:
    found: dict[str, Any] = page.evaluate(DOC)
    return found


def opened(visitor: Visitor, document: dict[str, Any]) -> Page:
    page = visitor.open("drive", unfold=False)
    take(page, document)
    visitor.solved()
    return page


def undone(page: Page) -> None:
    page.locator("#toast").get_by_role("button", name="Undo").click()


def another_belt(page: Page) -> None:
    page.select_option("#f-belt-preset", index=2)


def another_load_input(page: Page) -> None:
    page.evaluate("document.getElementById('more').open = true")
    page.select_option("select[id^=pair-]", label="T2 and Te")


def condition_of_the_drive(page: Page) -> None:
    page.evaluate("document.getElementById('more').open = true")
    page.get_by_role("button", name="Take that of the drive").click()


def of_head(**more: Any) -> dict[str, Any]:
    """Return the drive of the example with other keys of belt, pulley and drive."""
    document = tomllib.loads(HEAD)
    for table, keys in more.items():
        target = document["pulley"][0] if table == "pulley" else document[table]
        target.update(keys)
    return document


def one_tension() -> dict[str, Any]:
    """Return a drive of which T1 alone is known."""
    document = tomllib.loads(HEAD.partition("[[load_case]]")[0])
    del document["pulley"][0]["exit_tension"]
    return document


#: A drive, a press that takes something out of it, and what is named.
PRESSES: dict[str, tuple[dict[str, Any], Callable[[Page], None], str]] = {
    "numbers typed over a belt": (
        of_head(belt={"rating": "200 kN/m", "modulus": "9000 kN/m"}),
        another_belt,
        "Removed: belt rating, belt modulus.",
    ),
    "a tension that is not told by the others": (
        one_tension(),
        another_load_input,
        "Removed: pulley head entry tension.",
    ),
    "the condition of a pulley": (
        of_head(pulley={"condition": "wet"}),
        condition_of_the_drive,
        "Removed: pulley head condition.",
    ),
}


@pytest.mark.parametrize("name", PRESSES)
def test_what_a_press_removes_is_named_and_comes_back(visitor: Visitor, name: str) -> None:
    document, press, text = PRESSES[name]
    page = visitor.open("drive", unfold=False)
    take(page, document)
    page.locator("#f-pulley-0-diameter").wait_for()
    press(page)
    expect(page.locator("#toast")).to_contain_text(text)
    assert doc_of(page) != document
    undone(page)
    assert doc_of(page) == document


def loads(document: dict[str, Any]) -> dict[str, float]:
    drive = read(document)
    assert isinstance(drive, Drive)
    arcs = solve(drive, raise_on_failure=False)
    return {f"{a.arc.load_case} T1": a.entry_tension for a in arcs} | {
        f"{a.arc.load_case} T2": a.exit_tension for a in arcs
    }


def test_load_cases_move_to_two_drives_and_back(visitor: Visitor) -> None:
    # expected: tensions of every load case before the first of the drives and behind the last
    document = tomllib.loads(HEAD)
    page = opened(visitor, document)
    turn(page, "train")
    page.get_by_role("button", name="Add a second drive").click()
    expect(page.locator("#train .parts i")).to_have_count(2)
    both = doc_of(page)
    assert [case["name"] for case in both["load_case"]] == ["empty", "start"]
    assert "Removed" not in page.locator("#toast").inner_text()
    page.get_by_role("button", name="Remove this drive").last.click()
    expect(page.locator("#train .parts i")).to_have_count(0)
    assert loads(doc_of(page)) == pytest.approx(loads(document), rel=1e-9)


def test_drafts_that_are_deleted_come_back(visitor: Visitor) -> None:
    page = visitor.open("drive", unfold=False)
    page.fill("#f-pulley-0-exit_tension", "70")
    stored = "localStorage.getItem('wraparc.drafts')"
    page.wait_for_function(f"{stored}?.includes('70 kN')")
    before = [draft["doc"] for draft in json.loads(page.evaluate(stored))]
    page.click("#file > summary")
    page.get_by_role("button", name="Delete all drafts").click()
    assert json.loads(page.evaluate(stored)) == []
    undone(page)
    assert [draft["doc"] for draft in json.loads(page.evaluate(stored))] == before


def test_points_of_a_profile_that_are_cleared_come_back(visitor: Visitor) -> None:
    worn = (EXAMPLES / "worn-head-drive-fabric.toml").read_text("utf-8")
    page = opened(visitor, tomllib.loads(worn))
    before = doc_of(page)
    turn(page, "across")
    page.locator("#clear-points").click()
    expect(page.locator("#toast")).to_contain_text("All points are removed.")
    assert doc_of(page) != before
    undone(page)
    assert doc_of(page) == before


def test_a_removed_file_comes_back_with_what_was_said_of_it(visitor: Visitor) -> None:
    page = visitor.open("tests")
    page.set_input_files("#test-files", sorted(TESTS.glob("dry-0034kPa-*.csv"))[:1])
    page.locator("#tests .rows-of .name").click()
    page.locator("button[id^=remove-]").wait_for()
    condition = page.locator("#tests").get_by_label(re.compile("^Condition of"))
    condition.fill("wet")
    condition.press("Tab")
    name = page.locator("button[id^=remove-]").get_attribute("aria-label") or ""
    page.locator("button[id^=remove-]").click()
    expect(page.locator("button[id^=remove-]")).to_have_count(0)
    expect(page.locator("#toast")).to_contain_text("is removed.")
    undone(page)
    expect(page.get_by_role("button", name=name)).to_be_visible()
    expect(condition).to_have_value("wet")
