"""The first two lines of an answer, as one reads them who reads no more; and a drive without one.

Drives are invented so that each fails in a way of its own. Expected of each: a sentence that is
whole at every width, and an action that comes to what it told.
"""

import contextlib
import re
from collections.abc import Iterator
from typing import Any

import pytest
from playwright.sync_api import Page, Route, ViewportSize, expect

from judgement.test_first_sentence import MOST
from web.browser import PHONE, Calculator, Visitor, ask_now, evaluated
from web.calculators import wait_for
from worded import worded
from wraparc.arc import WrapArc
from wraparc.drive import Drive
from wraparc.schema.overrides import put_over
from wraparc.train.keys import TRAIN_FILE
from wraparc.web.answers.documents import read
from wraparc.web.answers.drives import solve_all
from wraparc.web.asked import SolveRequest

pytestmark = pytest.mark.usefixtures("solved_once")

SCREEN: ViewportSize = {"width": 1440, "height": 900}
WIDTHS: list[ViewportSize] = [SCREEN, {"width": 1024, "height": 768}, PHONE]
#: Drives by what is wrong with them: T1 and T2, and other fields; the level that they come to.
DRIVES: dict[str, tuple[str, str, dict[str, str], str]] = {
    "slips": ("130", "4", {}, "FAILS"),
    "brakes": ("60", "150", {}, "ATTENTION"),
    "idles": ("100", "100", {}, "OK"),
    "weak belt": ("300", "150", {}, "FAILS"),
    "no tension helps": ("900", "10", {}, "FAILS"),
    "tension below the tests": ("8", "2", {}, "ATTENTION"),
    "small pulley": ("120", "60", {"pulley-0-diameter": "100"}, "FAILS"),
    "short wrap": ("120", "60", {"pulley-0-wrap_angle": "90"}, "ATTENTION"),
    "brakes a little": ("100", "101", {}, "OK"),
}
#: A number with its unit is one word.
UNIT = re.compile(r"(?<=\d) (?=[A-Za-z%°])")
#: Fields that an action names, with the number that it gives them.
NAMED = {
    "exit_tension": r"T2 (?:from [\d.]+ )?(?:to )?([\d.]+) kN",
    "entry_tension": r"T1 (?:\(slack-side tension\) )?(?:from [\d.]+ )?to ([\d.]+) kN",
    "wrap_angle": r"wrap (?:from [\d.]+ to )?([\d.]+) deg",
    "diameter": r"diameter ([\d.]+) mm",
    "lagging": r"lagging ([\w-]+\w)",
}
#: What of the two lines and the button is cut off [px].
CUT = """() => ["p", "small", ".act button"].flatMap((q) => {
  const e = document.querySelector(`#verdict ${q}`);
  return e && e.scrollHeight > e.clientHeight + 1 ? [`${q}: ${e.textContent}`] : [];
})"""


def new(visitor: Visitor, units: str = "SI", size: ViewportSize = SCREEN) -> Page:
    """Begin a new drive, on a page that may have shown another."""
    page = visitor.page
    if page.url == "about:blank":
        visitor.open("drive", unfold=False)
    page.set_viewport_size(size)
    visitor.alone()
    page.get_by_label(units, exact=True).check(force=True)
    page.click("#file > summary")
    page.get_by_role("button", name="New drive").click()
    expect(page.locator("#s-pulley-0-entry_tension")).to_be_focused()
    return page


def test_a_new_drive_asked_for_again_has_the_keys_in_its_first_box(visitor: Visitor) -> None:
    new(visitor)
    visitor.page.keyboard.type("1")
    new(visitor)
    expect(visitor.page.locator("#s-pulley-0-entry_tension")).to_have_value("")
    new(visitor)


def typed(visitor: Visitor, entry: str, exit_: str, units: str = "SI") -> Page:
    page = new(visitor, units)
    page.keyboard.type(entry)
    page.keyboard.press("Tab")
    page.keyboard.type(exit_)
    page.keyboard.press("Tab")
    visitor.solved()
    return page


@pytest.mark.parametrize("name", DRIVES)
def test_the_first_two_lines_are_whole_and_the_action_does_what_it_says(
    long_visit: Visitor, name: str
) -> None:
    entry, exit_, fields, level = DRIVES[name]
    page = typed(long_visit, entry, exit_)
    evaluated(page, "import('/static/main.js').then((m) => m.edit(['covered'], true))")
    for field, value in fields.items():
        page.fill(f"#f-{field}", value)
    long_visit.solved()
    said = page.locator("#verdict p")
    expect(said).to_contain_text(f"{level}: ")
    assert len(re.sub(UNIT, "", said.inner_text()).removeprefix(f"{level}: ").split()) <= MOST
    button = page.locator("#verdict .advice")
    action = page.locator("#verdict .line").filter(has_text="Action")
    hopeless = name == "no tension helps"
    expect(button).to_have_count(0 if level == "OK" or hopeless else 1)
    expect(action).to_have_count(0 if level == "OK" else 1)
    if hopeless:  # by how much Te is too large is no change to press
        expect(action).to_contain_text("Te must be")
    expect(page.locator("#verdict .line").filter(has_text="Data")).to_have_count(1)
    expect(page.locator("#verdict .line").filter(has_text="Reserve")).to_have_count(1)
    for size in WIDTHS:
        page.set_viewport_size(size)
        long_visit.painted()
        assert page.evaluate(CUT) == [], size
    if level == "OK" or hopeless:
        return
    told = " ".join(button.inner_text().split())
    left = re.search(r"\((?:(\d+) checks?|(.+)) still fails?\)", told)
    count = int(left[1] or len(left[2].split(" and "))) if left else 0
    button.click()
    expect(page.locator("#toast")).to_contain_text(told)
    for key, amount in NAMED.items():
        if named := re.search(amount, told):
            expect(page.locator(f"#f-pulley-0-{key}")).to_have_value(named[1])
    # expected: the program on the drive that the press has made
    made = evaluated(page, "import('/static/main.js').then((m) => m.app.doc)")
    after = solve_all(SolveRequest(document=made, search=False)).verdict
    assert after.missed == count
    long_visit.solved()
    expect(said).to_have_text(f"{after.level}: {worded(after.model_dump()['text'])}")


def test_all_changes_of_the_first_way_are_one_press_and_one_step_back(visitor: Visitor) -> None:
    # expected: what `wraparc solve` offers first of the same drive: full ceramic, wrap and T2
    page = visitor.open("drive", unfold=False)
    page.fill("#f-pulley-0-entry_tension", "130")
    page.fill("#f-pulley-0-exit_tension", "4")
    visitor.solved()
    before = evaluated(page, "import('/static/main.js').then((m) => m.app.doc)")
    action = solve_all(SolveRequest(document=before)).verdict.model_dump(by_alias=True)["action"]
    way = action["ways"][0]
    assert len(way["changes"]) > 1
    button = page.locator("#verdict .act button")
    expect(button).to_have_text(worded(way["text"]))
    action_line = page.locator("#verdict .line").filter(has_text="Action")
    expect(action_line).to_have_text(f"Action {worded(action['text'])}")
    button.click()
    made = evaluated(page, "import('/static/main.js').then((m) => m.app.doc)")
    settings = {
        change["key"]: f"{change['to']!r} {change['unit']}" if change["unit"] else change["to"]
        for change in way["changes"]
    }
    expected = put_over(before, settings, TRAIN_FILE)
    assert drive_texts(made) == drive_texts(expected)
    page.click("#undo")
    assert evaluated(page, "import('/static/main.js').then((m) => m.app.doc)") == before


def drive_texts(document: dict[str, Any]) -> list[tuple[str, list[float]]]:
    """Return lagging and numbers of the pulley in every load case, to nine digits."""
    drive = read(document)
    assert isinstance(drive, Drive)
    (pulley,) = drive.pulleys
    arcs = [WrapArc.of(drive, pulley, case) for case in drive.load_cases]
    numbers = [[arc.wrap_angle, arc.entry_tension, arc.exit_tension] for arc in arcs]
    return [(pulley.lagging.name, [float(f"{v:.9g}") for v in row]) for row in numbers]


def test_five_questions_are_answered_by_hub_sentence_and_drawing(visitor: Visitor) -> None:
    page = visitor.open("drive", unfold=False)
    visitor.alone()
    evaluated(page, "import('/static/main.js').then((m) => m.edit(['covered'], true))")
    page.locator("#cases").get_by_role("button", name="start").click()
    visitor.solved()
    # does it hold; what is wrong; what do I do; where on the arc; in which case
    expect(page.locator("#verdict .level")).to_have_text("ATTENTION: ")
    expect(page.locator("#verdict p")).to_have_text(
        "ATTENTION: Creep 11.4 mm exceeds the 6.35 mm limit (head, start)."
    )
    assert page.locator("svg.stage.warn .hub-number tspan").first.text_content() == "11.4"
    expect(page.locator("#verdict .act button")).to_have_text(
        "Use lagging full-ceramic, and raise T2 from 60 to 75 kN."
    )
    assert page.locator("svg.stage .band-over").get_attribute("d")
    expect(page.locator("#cases [aria-pressed=true]")).to_contain_text("start 180 %")


#: Counts what a hand does: presses of the mouse, choices from a list and numbers typed.
COUNT = """() => {
  window.presses = 0;
  addEventListener("pointerdown", () => { presses += 1; }, true);
  addEventListener("change", (e) => { presses += e.target.matches("select, .box input"); }, true);
}"""


def test_ten_jobs_take_the_fewest_presses(visitor: Visitor) -> None:
    # two numbers for a drive, one press for all else; of a list the choice is counted
    page = new(visitor)
    page.evaluate(COUNT)
    number = page.locator(".hub-number tspan").first
    done: dict[str, int] = {}

    @contextlib.contextmanager
    def job(name: str) -> Iterator[None]:
        page.evaluate("presses = 0")
        yield
        done[name] = page.evaluate("presses")

    def undone() -> None:
        page.click("#undo")
        expect(number).to_have_text("7.49")
        page.wait_for_selector(".ways li")

    with job("new drive to verdict"):
        page.keyboard.type("150")
        page.keyboard.press("Tab")
        page.keyboard.type("60")
        page.keyboard.press("Tab")
        expect(page.locator("#verdict p")).to_contain_text("ATTENTION")
    visitor.example("Head drive, ROM conveyor")
    page.wait_for_selector(".ways li")
    with job("what to do"):
        page.locator("#verdict .act button").click()
        expect(page.locator("#f-pulley-0-wrap_angle")).to_have_value("223")
    undone()
    with job("which lagging"):
        page.get_by_role("button", name="Full ceramic").click()
        expect(number).to_have_text("4.36")
    undone()
    with job("wet"):
        page.select_option(".rail > .pick-row .condition select", "wet")
        expect(number).not_to_have_text("7.49")
    undone()
    with job("the worst load case"):
        page.locator("#verdict").get_by_role("button", name="start").click()
        expect(number).to_have_text("11.4")
    with job("why, by which source"):
        page.locator(".list button").nth(1).click()
        expect(page.locator("#why")).to_contain_text("CEMA")
    with job("where on the arc"):
        page.locator(".curve").get_by_text("Shear", exact=True).click()
        expect(page.locator("svg.stage .legend")).to_contain_text("shear to")
    with job("US units"):
        page.get_by_label("US", exact=True).check(force=True)
        expect(page.locator("#verdict p")).to_contain_text("exceeds the 0.25 in limit")
    with job("what to measure on site"):
        page.get_by_role("button", name="On site: what to measure, when to alarm").click()
        page.locator("#question .site table").first.wait_for()
    with job("costs over the years"):
        page.click("#tab-choose")
        expect(page.locator("#compare tbody tr").first).to_be_visible()
    most = {"new drive to verdict": 2}
    assert {name: most.get(name, 1) for name in done} == done
    assert len(done) == 10


def test_two_numbers_on_the_strands_give_the_verdict(long_visit: Visitor) -> None:
    page = new(long_visit)
    assert page.locator("#verdict .act button").inner_text() == "Load the example"
    page.keyboard.type("150")
    page.keyboard.press("Tab")
    expect(page.locator("#s-pulley-0-exit_tension")).to_be_focused()
    page.keyboard.type("6")  # solved while it is typed, and the box stays
    expect(page.locator("#verdict p")).to_contain_text("FAILS")
    page.keyboard.type("0")
    expect(page.locator(".hub-number tspan").first).to_have_text("7.49")
    expect(page.locator("#s-pulley-0-exit_tension")).to_be_focused()
    assert page.input_value("#f-pulley-0-exit_tension") == "60"
    page.keyboard.press("Tab")
    expect(page.locator(".typed")).to_have_count(0)
    expect(page.locator(".h:visible")).to_have_count(3)
    # cleared, it is a value that lacks, beside the last answer
    page.fill("#f-pulley-0-exit_tension", "")
    expect(page.locator("#verdict p")).to_have_text("Missing: Exit tension.")
    expect(page.locator(".typed")).to_have_count(0)
    expect(page.locator("#results")).to_have_attribute("data-stands", "refused")


@pytest.mark.parametrize("size", WIDTHS, ids=lambda s: str(s["width"]))
def test_boxes_on_the_strands_are_beside_them(calculator: Calculator, size: ViewportSize) -> None:
    browser, server = calculator
    visitor = Visitor(browser, server.address, size, has_touch=True)
    page = new(visitor, size=size)
    found = page.evaluate(
        """() => {
          const box = (e) => e.getBoundingClientRect();
          const [a, b] = [...document.querySelectorAll(".typed .box")].map(box);
          const [over, under] = [...document.querySelectorAll(".strand")].map(box);
          const stage = box(document.querySelector(".stage-box"));
          return [a.top - stage.top, over.bottom - a.bottom, b.top - under.top,
            stage.bottom - b.bottom, Math.min(a.height, b.height)];
        }"""
    )
    assert min(found[:4]) >= 0, found
    assert found[4] >= 36
    assert page.evaluate("document.documentElement.scrollWidth") == size["width"]
    visitor.close()
    assert visitor.wrong == []


def test_a_new_drive_leads_to_the_conveyor_and_to_examples(long_visit: Visitor) -> None:
    page = new(long_visit)
    page.get_by_role("button", name="Compute T1, T2 from the conveyor").click()
    expect(page.locator("#f-conveyor-length")).to_be_focused()
    expect(page.locator("#verdict p")).to_contain_text("Missing: Length")
    expect(page.locator(".typed")).to_have_count(0)
    page.click("#undo")
    expect(page.locator(".typed")).to_be_visible()
    page.locator(".from").get_by_role(
        "button", name="Uphill conveyor, tensions from its resistances"
    ).click()
    expect(page.locator("#title")).to_have_text("Uphill conveyor, tensions from its resistances")
    long_visit.solved()
    expect(page.locator(".from")).to_have_count(0)


def gone(page: Page) -> None:
    """Take the server away; expected: it is said once, and nothing moves by it."""
    boxes = """() => [".sub", ".rail", ".say", ".stage-box", ".checks", ".foot-line"].map((q) => {
      const { x, y, width, height } = document.querySelector(q).getBoundingClientRect();
      return [x, y, width, height];
    })"""
    before = page.evaluate(boxes)
    page.route("**/api/v1/**", lambda route: route.abort())
    page.fill("#f-pulley-0-exit_tension", "75")
    expect(page.locator(".gone")).to_be_visible()
    assert page.inner_text("body").count("The server does not answer.") == 1
    assert page.inner_text("body").count("Asked again every 5 s.") == 1
    assert page.evaluate(boxes) == before


def back(page: Page) -> None:
    page.unroute_all(behavior="wait")
    ask_now(page)
    expect(page.locator(".gone")).to_have_count(0)


def test_a_server_that_is_gone_is_told_once_below_what_the_page_solves(
    calculator: Calculator,
) -> None:
    browser, server = calculator
    visitor = Visitor(browser, server.address, SCREEN)
    page = visitor.open("drive", unfold=False)
    visitor.alone()
    evaluated(page, "import('/static/main.js').then((m) => m.edit(['covered'], true))")
    evaluated(page, "import('/static/main.js').then((m) => m.edit(['load_case'], undefined))")
    visitor.solved()
    gone(page)
    # the page solves and judges this itself: it is an answer, and no old one
    expect(page.locator(".hub-number tspan").first).to_have_text("5.53")
    expect(page.locator("#verdict p")).to_contain_text("OK: ")
    expect(page.locator(".foot-line .gone")).to_be_visible()
    back(page)
    visitor.solved()
    visitor.close()


def test_a_server_that_is_gone_takes_the_place_of_the_verdict(calculator: Calculator) -> None:
    browser, server = calculator
    visitor = Visitor(browser, server.address, SCREEN)
    held: list[Route] = []  # the solver of the page is long in coming
    visitor.page.route("**/judging.js", lambda route: held.append(route))  # noqa: PLW0108
    page = visitor.open("drive", unfold=False)
    visitor.solved()
    wait_for(lambda: page.evaluate("1") and held)
    gone(page)
    said = page.locator("#verdict")
    expect(said).to_contain_text("The server does not answer. Previous results.")
    expect(said).to_have_class(re.compile(r"^say\s*$"))
    expect(page.locator("#results")).to_have_attribute("data-stands", "gone")
    # the colours of the last results are gone
    expect(page.locator(".checks")).to_have_css("filter", "grayscale(1)")
    page.unroute("**/api/v1/**")
    ask_now(page)
    visitor.solved()
    held[0].continue_()
    visitor.alone()
    expect(page.locator("#f-pulley-0-exit_tension")).to_have_value("75")
    visitor.close()
