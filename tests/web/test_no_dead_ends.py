"""No dead ends: what is wrong at a field or in a file is mended where it is said."""

import re
import tomllib
from pathlib import Path

from playwright.sync_api import Page, expect

from web.browser import Visitor, evaluated, turn
from web.calculators import document
from web.test_standing import take

EXAMPLES = Path(__file__).parents[2] / "examples"
HEAD = (EXAMPLES / "head-drive-fabric.toml").read_text("utf-8")


def opened(visitor: Visitor, folder: Path, text: str) -> Page:
    page = visitor.open("drive", unfold=False)
    file = folder / "own.toml"
    file.write_text(text, "utf-8")
    visitor.anew(lambda: visitor.load(file), None)  # refused: no load case can be looked at
    return page


def belt(page: Page) -> dict[str, str]:
    found: dict[str, str] = evaluated(page, "import('/static/main.js').then((m) => m.app.doc.belt)")
    return found


def test_an_unknown_key_is_renamed_or_removed_by_a_press(visitor: Visitor, tmp_path: Path) -> None:
    text = HEAD.replace("speed =", "sped =", 1).replace("[belt]", '[belt]\nlorem = "1"', 1)
    page = opened(visitor, tmp_path, text)
    said = page.locator("#verdict")
    expect(said.locator(".reasons li")).to_have_count(2)
    said.get_by_role("button", name="Remove lorem").click()
    expect(page.locator("#toast")).to_contain_text("Removed: belt lorem.")
    said.get_by_role("button", name="Rename sped to speed").click()
    visitor.solved()
    assert belt(page) == tomllib.loads(HEAD)["belt"]
    expect(said).to_have_class(re.compile("warn"))
    visitor.wrong.clear()  # what is refused is told


def test_a_number_of_another_unit_is_asked_about_at_its_field(visitor: Visitor) -> None:
    page = visitor.open("drive", unfold=False)
    width = page.locator("#f-belt-width")
    width.fill("1.2")
    ask = page.locator(".rail .field", has=width).get_by_role("button", name="1200 mm?")
    expect(ask).to_be_visible()
    ask.click()
    expect(width).to_have_value("1200")
    expect(ask).to_have_count(0)
    assert belt(page)["width"] == "1200 mm"
    visitor.solved()
    # of a usual size nothing is asked, and what no belt has is refused
    width.fill("1.2 m")
    expect(page.locator(".rail .error button")).to_have_count(0)
    width.fill("1 km")
    expect(page.locator("#f-belt-width-e")).to_contain_text("between 1 mm and 10 m")
    visitor.wrong.clear()


def test_a_share_that_is_typed_moves_the_other(visitor: Visitor) -> None:
    page = visitor.open("drive", unfold=False)
    take(page, document("tandem-fabric"))
    visitor.open("train", unfold=False)
    page.fill("#t-train-share-0", "60 %")
    expect(page.locator("#t-train-share-1")).to_have_value("40 %")
    page.fill("#t-train-share-1", "30 %")
    expect(page.locator("#t-train-share-0")).to_have_value("70 %")
    expect(page.locator("#train .parts i")).to_have_text(["first 70 %", "second 30 %"])


def test_names_follow_a_renaming(visitor: Visitor) -> None:
    page = visitor.open("drive", unfold=False)
    take(page, document("tandem-fabric"))
    visitor.open("train", unfold=False)
    name = page.locator("#t-pulley-0-name")
    name.fill("tail")
    name.press("Tab")
    expect(page.locator("#train .parts i").first).to_have_text("tail 50 %")
    expect(page.locator("#train [data-stands=fresh] .list li").first).to_be_visible()
    assert not re.search(r"\bfirst\b", page.locator("#train .frame").inner_text())
    page.fill("#t-train-share-0", "much")
    expect(page.locator("#train-verdict")).to_contain_text("tail")
    visitor.wrong.clear()


def test_what_is_lost_says_of_what(visitor: Visitor) -> None:
    page = visitor.open("drive", unfold=False)
    take(page, document("tandem-fabric"))
    visitor.solved()
    expect(page.locator("svg.stage")).to_contain_text("Power lost here")
    turn(page, "train")
    expect(page.locator("#train .sums")).to_contain_text("Power lost, all drives")
