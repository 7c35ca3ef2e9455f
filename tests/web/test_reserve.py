"""The reserve of the verdict on the first screen: drawn, and each change of it a press."""

import tomllib
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from web.browser import PHONE, SMALL, Calculator, Visitor, axe
from web.test_standing import take
from wraparc.answer.reserve_words import input_name, nearest_text, percent_text
from wraparc.checks import Level
from wraparc.reserve import Flip, find_reserve
from wraparc.reserve.keys import ReserveKeys
from wraparc.train.file import drive_or_train_from_document
from wraparc.train.whole import Whole, by_pulley, solved
from wraparc.units import in_units

EXAMPLES = Path(__file__).parents[2] / "examples"
CLASSES = {Level.OK: "good", Level.ATTENTION: "warn", Level.FAILS: "bad"}


def shown(visitor: Visitor, name: str) -> Page:
    """Put an example on the page, and look at its reserve."""
    page = visitor.open("drive", unfold=False)
    visitor.alone()
    take(page, tomllib.loads((EXAMPLES / f"{name}.toml").read_text("utf-8")))
    visitor.solved()
    switch = page.locator(".changes .switch").get_by_text("Reserve")
    expect(switch.or_(page.locator(".changes h2", has_text="Reserve")).first).to_be_visible()
    if switch.count():
        switch.click()
    expect(page.locator("#verdict .line").filter(has_text="Reserve")).to_have_count(1)
    expect(page.locator(".reserves:not(.before) li").first).to_be_visible()
    return page


def result_of(name: str) -> Whole:
    return solved(
        drive_or_train_from_document(
            tomllib.loads((EXAMPLES / f"{name}.toml").read_text("utf-8")),
        )
    )


@pytest.mark.parametrize("name", ["head-drive-fabric", "downhill-braking", "tandem-fabric"])
def test_every_change_is_drawn_to_scale_and_pressed_where_a_key_makes_it(
    long_visit: Visitor, name: str
) -> None:
    # expected: the reserve of the program
    page = shown(long_visit, name)
    result = result_of(name)
    drive, reserve, keys = by_pulley(result).drive, find_reserve(result), ReserveKeys.of(result)
    line = page.locator("#verdict .line").filter(has_text="Reserve")
    expect(line).to_have_text(f"Reserve {in_units(nearest_text(reserve, drive), 'si')}")
    sides: dict[tuple[str, bool], Flip] = {}
    for flip in reserve.flips:
        sides.setdefault((input_name(flip.input, drive), flip.change > 0), flip)
    rows = page.locator(".reserves li")
    expect(rows).to_have_count(len({name for name, _ in sides}))
    for (name, up), flip in sides.items():
        row = rows.filter(has=page.locator(f".n[title='{name}']"))
        side = row.locator(".side").nth(int(up))
        expect(side.locator("> span").first).to_have_text(in_units(percent_text(flip.change), "si"))
        bar = side.locator("u > b")
        expect(bar).to_have_class(CLASSES[flip.level])
        part = bar.evaluate("(e) => parseFloat(e.style.width)")
        assert part == pytest.approx(100 * abs(flip.change) / (1.0 if up else 0.5), abs=0.01)
        pressed = bool(keys.changes(flip.input, 1.0 + flip.change))
        assert side.evaluate("(e) => e.localName") == ("button" if pressed else "span"), name


def test_a_press_sets_the_input_turns_the_level_and_is_undone(visitor: Visitor) -> None:
    # expected: the levels that the bars end in, on the verdict of the server
    page = shown(visitor, "head-drive-fabric")
    level = page.locator("#verdict p .level")
    expect(level).to_have_text("ATTENTION:")
    for button, to, path, value in (
        ("Te", "FAILS", "#f-pulley-0-entry_tension", "168"),
        ("wrap", "FAILS", "#f-pulley-0-wrap_angle", "91.8"),
    ):
        row = page.locator(".reserves li").filter(has=page.locator(f".n[title='{button}']"))
        row.locator("button.side").last.click()
        expect(page.locator(path)).to_have_value(value)
        expect(level).to_have_text(f"{to}:")
        expect(page.locator("#toast")).to_contain_text(button)
        page.locator("#toast").get_by_role("button", name="Undo").click()
        expect(level).to_have_text("ATTENTION:")
        expect(page.locator(".reserves:not(.before) button").first).to_be_enabled()
    # by the keyboard as by the mouse
    page.locator(".reserves button").first.focus()
    page.keyboard.press("Enter")
    expect(level).to_have_text("OK:")
    page.click("#undo")
    expect(level).to_have_text("ATTENTION:")


def test_what_is_drawn_of_a_drive_before_is_not_pressed(visitor: Visitor) -> None:
    page = shown(visitor, "head-drive-fabric")
    page.route("**/solve/reserve", lambda route: None)
    page.fill("#f-pulley-0-diameter", "1000")
    page.press("#f-pulley-0-diameter", "Tab")
    visitor.solved()
    expect(page.locator(".reserves.before button:enabled")).to_have_count(0)
    expect(page.locator("#verdict .line").filter(has_text="Reserve")).to_have_count(0)


def test_nothing_is_said_where_no_server_is(visitor: Visitor) -> None:
    page = visitor.open("drive", unfold=False)
    page.route("**/solve/reserve", lambda route: route.abort())
    visitor.alone()
    page.fill("#f-pulley-0-diameter", "1000")
    page.press("#f-pulley-0-diameter", "Tab")
    visitor.solved()
    expect(page.locator("#verdict .line").filter(has_text="Reserve")).to_have_count(0)
    visitor.wrong.clear()  # the request that was cut


def test_accessible_and_large_enough_for_a_finger(calculator: Calculator) -> None:
    browser, server = calculator
    visitor = Visitor(browser, server.address, PHONE, has_touch=True, is_mobile=True)
    page = shown(visitor, "head-drive-fabric")
    page.evaluate(axe())
    found = page.evaluate("axe.run('.changes').then((r) => r.violations.map((v) => v.id))")
    small = page.evaluate(SMALL)
    wide = page.evaluate("document.documentElement.scrollWidth")
    visitor.close()
    assert (found, small, wide) == ([], [], PHONE["width"])
