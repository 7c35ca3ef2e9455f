"""The load case and pulley that a drive shows first: those that govern its verdict."""

import tomllib
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Page, Route, expect

from web.browser import PAINTED, Calculator, Visitor
from web.calculators import API, TOKEN, wait_for
from web.test_standing import take
from web.test_verdict_card import COVERED
from wraparc.arc import solve
from wraparc.checks import judge
from wraparc.train import Train, solve_train
from wraparc.train.file import drive_or_train_from_document
from wraparc.train.whole import Whole

EXAMPLES = Path(__file__).parents[2] / "examples"
DRIVES = [
    "head-drive-fabric", "steel-cord-drive", "downhill-braking", "uphill-conveyor", "tandem-fabric",
]  # fmt: skip
#: Every name of a load case and every number in the hub that was painted, in their order.
SEEN = """() => {
  window.seen = [];
  const look = () => {
    const chip = document.querySelector("#cases [aria-pressed=true] span")?.textContent;
    const hub = document.querySelector(".hub-number")?.textContent;
    const fresh = document.querySelector("#drive .screen[data-stands=fresh]");
    const now = fresh && chip ? `${chip} ${hub}` : "";
    if (now && now !== window.seen.at(-1)) window.seen.push(now);
    requestAnimationFrame(look);
  };
  look();
}"""


#: What a link to the design on the page has behind the name of the page.
LINK = """() => new Promise((done) => {
  navigator.clipboard.writeText = (text) => Promise.resolve(done(text.split("/drive/")[1]));
  document.querySelector("#file > summary").click();
  setTimeout(() => [...document.querySelectorAll("button")]
    .find((e) => e.textContent.startsWith("Copy a link")).click());
})"""
#: Puts a design on the page: what is seen from then on is of it.
ANEW = """(doc) => import('/static/main.js').then((m) => {
  m.take(doc);
  window.seen = [];
})"""


def document(name: str) -> dict[str, Any]:
    return tomllib.loads((EXAMPLES / f"{name}.toml").read_text("utf-8"))


def solved(doc: dict[str, Any]) -> Whole:
    thing = drive_or_train_from_document(doc)
    if isinstance(thing, Train):
        return solve_train(thing, raise_on_failure=False)
    return solve(thing, raise_on_failure=False)


def chosen(page: Page) -> Any:
    return page.locator("#cases [aria-pressed=true] span").first


#: The card with the answer that is asked for last, the reserve of the verdict.
ANSWERED = "html:not(.stale) #drive .screen[data-whole] #verdict .line:has-text('Reserve')"


def at_rest(page: Page) -> None:
    """Wait until every answer that is asked for is there, and painted."""
    page.wait_for_selector(ANSWERED, state="attached")
    page.evaluate(PAINTED)


@pytest.mark.parametrize("name", DRIVES)
def test_what_governs_is_shown_first_and_nothing_jumps(long_visit: Visitor, name: str) -> None:
    # expected: the place of the check that governs, by the program
    doc = document(name)
    worst = judge(solved(doc)).governing
    assert worst is not None
    page = long_visit.open("drive", unfold=False)
    page.evaluate(SEEN)
    page.evaluate(ANEW, doc)
    long_visit.solved()
    at_rest(page)
    expect(chosen(page)).to_have_text(worst.place.load_case)
    seen = page.evaluate("window.seen")
    assert len(seen) == 1, seen
    assert seen[0].startswith(f"{worst.place.load_case} ")
    if len(doc["pulley"]) > 1:
        picked = page.locator("#pick-pulley option:checked")
        expect(picked).to_have_text(worst.place.pulley)
    expect(page.locator("#verdict .line").filter(has_text="Governing")).to_have_count(0)
    expect(page.locator("html.stale")).to_have_count(0)


def test_the_drive_to_begin_with_comes_with_what_governs(calculator: Calculator) -> None:
    # solved by the server before the page came: nothing is asked for its first answer
    browser, server = calculator
    wait_for(lambda: server.ask(f"{API}/start/solved").status == 200)
    visitor = Visitor(browser, server.address)
    page, asked = visitor.page, list[str]()
    page.on("request", lambda r: asked.append(r.url.partition(f"{API}/")[2]))
    page.add_init_script(f"addEventListener('DOMContentLoaded', {SEEN})")
    page.goto(f"{server.address}?token={TOKEN}")
    visitor.solved()
    expect(chosen(page)).to_have_text("start")
    at_rest(page)
    assert {a for a in asked if a.startswith("solve")} == {"solve/reserve"}
    assert page.evaluate("window.seen") == ["start 11.4mm"]
    visitor.close()


def test_a_choice_made_before_the_answer_stays(visitor: Visitor) -> None:
    # the first answer is held back; somebody looks elsewhere meanwhile
    page = visitor.open("drive", unfold=False)
    held: list[Route] = []
    page.route("**/solve/fast", lambda route: held.append(route))  # noqa: PLW0108
    take(page, document("downhill-braking"), None)
    wait_for(lambda: page.evaluate("true") and held)
    page.locator("#cases").get_by_role("button", name="empty").click()
    page.route("**/solve/fast", lambda route: route.continue_())
    held[0].continue_()
    visitor.solved()
    at_rest(page)
    expect(chosen(page)).to_have_text("empty")


def test_what_is_changed_before_the_answer_is_of_the_case_that_stands_there(
    visitor: Visitor,
) -> None:
    page = visitor.open("drive", unfold=False)
    held: list[Route] = []
    page.route("**/solve/fast", lambda route: held.append(route))  # noqa: PLW0108
    take(page, document("head-drive-fabric"), None)
    wait_for(lambda: page.evaluate("true") and held)
    tension = "#f-pulley-0-exit_tension"
    page.fill(tension, "72.5")
    page.press(tension, "Tab")
    page.route("**/solve/fast", lambda route: route.continue_())
    for route in held:
        route.continue_()
    visitor.solved()
    expect(chosen(page)).to_have_text("design")
    page.reload()
    visitor.solved()
    expect(chosen(page)).to_have_text("design")
    expect(page.locator(tension)).to_have_value("72.5")


def test_a_chosen_load_case_stays_through_changes_and_a_reload(visitor: Visitor) -> None:
    page = visitor.open("drive", unfold=False)
    take(page, tomllib.loads(COVERED), None)
    visitor.solved()
    expect(chosen(page)).to_have_text("start")
    page.locator("#cases").get_by_role("button", name="empty").click()
    page.fill("#f-pulley-0-diameter", "1000")
    page.press("#f-pulley-0-diameter", "Tab")
    visitor.solved()
    expect(chosen(page)).to_have_text("empty")
    page.reload()
    visitor.solved()
    expect(chosen(page)).to_have_text("empty")


def test_a_link_with_a_load_case_keeps_it(visitor: Visitor) -> None:
    page = visitor.open("drive", unfold=False, case="empty")
    at_rest(page)
    link = page.evaluate(LINK)
    page.goto("about:blank")
    page.goto(f"{visitor.address}?token={TOKEN}#/drive/{link}")
    visitor.solved()
    at_rest(page)
    expect(chosen(page)).to_have_text("empty")
