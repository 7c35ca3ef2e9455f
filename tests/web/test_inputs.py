"""The inputs of the drive page: their order, sliders with the focus, the condition by the lagging.

Expected values: the layout that the page promises; which key goes before which as
docs/reference/file_formats.md has it; verdicts of the command line.
"""

import json
import re
from pathlib import Path
from typing import Any

from playwright.sync_api import Locator, Page, expect

from cli.running import wraparc
from web.browser import PHONE, REQUESTS, Calculator, Visitor, evaluated
from web.calculators import document, wait_for
from web.test_standing import take
from wraparc.drive.conditions import covered
from wraparc.files.lagging_file import lagging_from_text, load_lagging_conditions
from wraparc.schema.emit import document_text
from wraparc.train.keys import TRAIN_FILE

HEAD = (Path(__file__).parents[2] / "examples" / "head-drive-fabric.toml").read_text("utf-8")
#: Where the rows stand within the form, from its top on.
PLACES = """() => {
  const form = document.querySelector("form.inputs");
  const top = form.getBoundingClientRect().top - form.scrollTop;
  return [...form.querySelectorAll(":is(.field, fieldset:not(.switch), details)")]
    .filter((e) => e.checkVisibility())
    .map((e) => Math.round(e.getBoundingClientRect().top - top));
}"""
JUDGED = """async () => {
  const { answer, app } = await import("/static/main.js");
  return answer.judgedDoc === app.doc;
}"""


def row(page: Page, name: str) -> Locator:
    return page.locator("form.inputs .field").filter(has=slider(page, name))


def slider(page: Page, name: str) -> Locator:
    return page.get_by_label(f"{name}, slider", exact=True)


def seen(page: Page) -> list[str]:
    """Return the names of the sliders that show."""
    names = page.locator("form.inputs .field > input[type=range]").evaluate_all(
        "all => all.filter((e) => getComputedStyle(e).opacity === '1').map((e) => e.ariaLabel)"
    )
    return [name.removesuffix(", slider") for name in names]


def kept(page: Page) -> Any:
    return evaluated(page, "import('/static/main.js').then((m) => m.app.doc)")


def switch(page: Page) -> Locator:
    return page.get_by_label("Condition of the lagging")


def says(page: Page, name: str) -> None:
    expect(switch(page)).to_have_value(name)


def turn(page: Page, name: str) -> None:
    switch(page).select_option(name)
    says(page, name)


def test_load_stands_first_and_a_slider_shows_with_the_pointer_and_moves_nothing(
    visitor: Visitor,
) -> None:
    # those of the first screen are always there; no slider is a tab stop, the box goes its steps
    page = visitor.open("drive")
    legends = page.locator("#more > fieldset > legend").all_inner_texts()
    assert legends[:4] == ["Load: design", "Pulley head", "Lagging", "Belt"]
    page.mouse.move(900, 500)
    assert seen(page) == []
    assert page.locator(".rail > .field input[type=range]").count() == 5
    places = page.evaluate(PLACES)
    row(page, "Belt speed").hover()
    assert seen(page) == ["Belt speed"]
    assert page.evaluate(PLACES) == places
    number = page.locator("#f-belt-speed")
    number.focus()
    page.keyboard.press("ArrowUp")
    expect(number).not_to_have_value("3")
    for _ in range(2):
        page.keyboard.press("Tab")
        assert page.evaluate("document.activeElement.type") != "range"
    # and it stays while it is dragged away from
    row(page, "Exit tension").hover()
    box = slider(page, "Exit tension").bounding_box()
    assert box is not None
    page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    page.mouse.down()
    page.mouse.move(900, 30, steps=4)
    # its upper end: 95 % of the tight side
    expect(page.locator("#f-pulley-0-exit_tension")).to_have_value("142.5")
    page.mouse.up()


def test_slider_is_found_by_finger_and_not_moved_unseen(calculator: Calculator) -> None:
    visitor = Visitor(calculator[0], calculator[1].address, PHONE, has_touch=True, is_mobile=True)
    page = visitor.open("drive")
    number = page.locator("#f-belt-speed")  # of those that are turned less
    number.scroll_into_view_if_needed()
    places = page.evaluate(PLACES)
    box = slider(page, "Belt speed").bounding_box()
    assert box is not None
    x, y = box["x"] + box["width"] / 10, box["y"] + box["height"] / 2
    page.touchscreen.tap(x, y)
    visitor.painted()
    assert seen(page) == []
    expect(number).to_have_value("3")
    number.tap()
    assert seen(page) == ["Belt speed"]
    assert box["height"] >= 24  # WCAG 2.2, 2.5.8
    assert page.evaluate(PLACES) == places
    page.touchscreen.tap(x, y)
    expect(number).not_to_have_value("3")
    visitor.close()
    assert visitor.wrong == []


def opened(visitor: Visitor, tmp_path: Path, text: str) -> Page:
    """Open a drive file on the page."""
    file = tmp_path / "drive.toml"
    file.write_text(text, "utf-8")
    visitor.anew(lambda: visitor.load(file))
    visitor.solved()
    return visitor.page


def test_switch_of_the_condition_is_answered_without_the_server(
    visitor: Visitor, tmp_path: Path
) -> None:
    page = visitor.open("drive")
    visitor.solved()
    visitor.alone()
    before = kept(page)
    assert "condition" not in before
    says(page, "dry")
    page.route(REQUESTS, lambda route: None)
    turn(page, "wet")
    wait_for(lambda: page.evaluate(JUDGED))
    visitor.painted()
    assert kept(page) == {**before, "condition": "wet"}
    file = tmp_path / "wet.toml"
    file.write_text(document_text(kept(page), TRAIN_FILE), "utf-8")
    told = json.loads(wraparc("solve", str(file), "--json", "-")[1])["verdict"]
    said = page.locator(".governing .headline").inner_text()
    assert said.partition(" ")[2] == f"{told['label']} {told['text']}"
    page.click("#undo")
    says(page, "dry")
    assert kept(page) == before
    page.unroute_all(behavior="ignoreErrors")


def test_switch_says_and_changes_the_condition_of_the_shown_load_case(
    long_visit: Visitor, tmp_path: Path
) -> None:
    # a load case goes before its pulley, that before the drive
    own = HEAD.replace('name = "start"', 'name = "start"\ncondition = "wet and dirty"')
    own = own.replace('lagging = "diamond-rubber"', 'lagging = "diamond-rubber"\ncondition = "wet"')
    page = opened(long_visit, tmp_path, 'condition = "dry"\n' + own)
    lagging = page.locator("#more > fieldset").filter(
        has=page.locator("legend", has_text="Lagging")
    )
    says(page, "wet")
    expect(lagging).to_contain_text("Of this pulley alone")
    page.locator("#cases").get_by_role("button", name="start").click()
    expect(lagging).to_contain_text("Of load case start alone")
    says(page, "wet and dirty")
    turn(page, "dry")
    assert [c.get("condition") for c in kept(page)["load_case"]] == [None, "dry"]
    assert kept(page)["pulley"][0]["condition"] == "wet"
    # without its own it has that of the pulley, and without that the drive's
    for alone in ("load case start", "this pulley"):
        expect(lagging).to_contain_text(f"Of {alone} alone")
        lagging.get_by_role("button", name="Take that of the drive").click()
    expect(lagging.get_by_role("button", name="Take that of the drive")).to_have_count(0)
    says(page, "dry")
    turn(page, "wet")
    doc = kept(page)
    assert doc["condition"] == "wet"
    assert "condition" not in {**doc["pulley"][0], **doc["load_case"][1]}


def test_switch_looks_at_one_of_conditions_side_by_side(
    long_visit: Visitor, tmp_path: Path
) -> None:
    own = HEAD.replace('name = "start"', 'name = "start"\ncondition = "wet"')
    page = opened(long_visit, tmp_path, 'condition = ["dry", "wet"]\n' + own)
    before = kept(page)
    cases = page.get_by_role("group", name="Load case", exact=True).get_by_role("button")
    wait_for(lambda: cases.count() == 5)  # that with a condition of its own stands once
    says(page, "dry")
    turn(page, "wet")
    assert kept(page) == before
    expect(page.locator("#why")).to_contain_text("head, design, wet")
    # one more is solved beside them
    turn(page, "wet and dirty")
    assert kept(page)["condition"] == ["dry", "wet", "wet and dirty"]
    expect(page.locator("#condition")).to_have_value("2")
    long_visit.solved()
    expect(page.locator("#why")).to_contain_text("head, design, wet and dirty")
    # and the shown one alone
    page.select_option("#condition", "0")
    assert kept(page)["condition"] == "wet and dirty"
    says(page, "wet and dirty")
    page.select_option("#condition", "1")
    assert kept(page)["condition"] == ["dry", "wet"]
    says(page, "dry")


#: A lagging of the design, in lagging files as in drive files.
PLAIN = 'law = { kind = "constant", friction = 0.4 }\n'
SIZES = 'thickness = "12 mm"\nshear_modulus = "1 MPa"\ncompression_modulus = "9 MPa"\n'
LAGGINGS = {
    "no surface": PLAIN,
    "published": 'surface = "polyurethane"\n' + PLAIN,
    "own factor": PLAIN + 'condition_factor = [{ condition = "muddy", factor = 0.6, '
    'provenance = { kind = "given" } }]\n',
    "two laws": 'law = [{ condition = "icy", kind = "constant", friction = 0.2 }, '
    '{ kind = "constant", friction = 0.4 }]\n',
    "tested oily": 'surface = "rubber"\n' + PLAIN.replace("{ ", '{ condition = "oily", '),
}  # fmt: skip


def test_switch_offers_what_the_friction_of_a_lagging_is_known_in(
    long_visit: Visitor, tmp_path: Path
) -> None:
    for name, more in LAGGINGS.items():
        table = SIZES + more
        laws = lagging_from_text(f'format = 1\nname = "mine"\n{table}')
        text = HEAD.replace('lagging = "diamond-rubber"', 'lagging = "mine"')
        page = opened(long_visit, tmp_path, f"{text}\n[lagging.mine]\n{table}")
        known = list(covered(laws))
        assert offered(page) == (known if len(known) > 1 else []), name
    page.select_option("#f-pulley-0-lagging", "full-ceramic")
    expect(switch(page).locator("option")).to_have_count(3)
    assert offered(page) == list(covered(load_lagging_conditions("full-ceramic")))


def offered(page: Page) -> list[str]:
    return [str(e.evaluate("(e) => e.value")) for e in switch(page).locator("option").all()]


def test_another_belt_of_the_catalogue_is_judged_as_by_the_command(
    visitor: Visitor, tmp_path: Path
) -> None:
    # ST1600 qualifies for the customary creep limit alone, and its least pulley is larger than this
    # one; expected: `wraparc solve` of the downloaded file, and what the server says of it
    page = visitor.open("drive")
    visitor.solved()
    page.locator("#f-belt-preset").select_option("Flexsteel ST1600")
    wait_for(lambda: page.evaluate(JUDGED) or page.locator("html:not(.stale)").count())
    file = tmp_path / "steel.toml"
    visitor.solved()
    file.write_text(document_text(kept(page), TRAIN_FILE), "utf-8")
    told = json.loads(wraparc("solve", str(file), "--json", "-")[1])["verdict"]
    assert told["level"] != "OK"
    said = page.locator(".governing .headline").inner_text()
    assert said.partition(" ")[2] == f"{told['label']} {told['text']}"
    # a number that is moved then is judged by the page, the server silent: the same command
    visitor.alone()
    page.route("**/api/v1/solve**", lambda route: None)
    page.fill("#f-pulley-0-exit_tension", "61")
    wait_for(lambda: page.evaluate(JUDGED))
    visitor.painted()
    file.write_text(document_text(kept(page), TRAIN_FILE), "utf-8")
    told = json.loads(wraparc("solve", str(file), "--json", "-")[1])["verdict"]
    said = page.locator(".governing .headline").inner_text()
    assert said.partition(" ")[2] == f"{told['label']} {told['text']}"
    page.unroute_all(behavior="ignoreErrors")


def test_a_form_names_fields_and_no_keys_of_a_file(visitor: Visitor) -> None:
    # expected: the sentence of `wraparc solve`, with the labels of the fields in place of keys
    page = visitor.open("drive")
    take(page, document("tandem-fabric"))
    visitor.solved()
    visitor.open("train")
    box = page.locator("#train input[id$='train-entry_tension']:visible").first
    box.fill("200")
    box.press("Tab")
    told = page.locator("#train [id$='-e']:visible", has_text="makes 105 kN")
    expect(told).to_contain_text("Effective tension makes 105 kN, the tensions 155 kN")
    assert not re.search(r"\w_\w", told.inner_text())
