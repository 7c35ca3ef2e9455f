"""The keyboard stays where it works: what is pressed may vanish, the focus does not fall out."""

import pytest
from playwright.sync_api import Locator, Page, Route, expect

from web.browser import Calculator, Visitor, choose_test
from web.calculators import wait_for
from web.test_pages_events import minutes
from web.test_pages_looks import used
from web.test_pages_tests import FILES

#: What holds the focus: its own name, or that of the first thing around it that has one.
_AT = """() => {
  const e = document.activeElement;
  const holds = e.closest("[id], [aria-label]");
  return [e === document.body, e.id || holds?.id || holds?.getAttribute("aria-label")];
}"""


def pressed(found: Locator) -> Page:
    """Press a button with the keyboard."""
    found.focus()
    found.page.keyboard.press("Enter")
    return found.page


def at(page: Page) -> str:
    """Return the name of what has the focus."""
    outside, name = page.evaluate(_AT)
    assert not outside, "the focus has fallen out of the page"
    return str(name)


#: Buttons that are gone, or of no use, once pressed: page, button, where the focus is then.
GONE = (
    ("drive", "Use lagging full-ceramic and wrap 223 deg (now 180 deg).", "verdict"),
    ("drive", "Pin this design", "Along the wrap"),
    ("train", "Find the trim limits", "train-verdict"),
    ("saved", "Open Head drive, ROM conveyor", "drive-title"),
)


@pytest.mark.parametrize(("name", "button", "then"), GONE)
def test_focus_stays_beside_a_button_that_goes(
    visitor: Visitor, name: str, button: str, then: str
) -> None:
    page = used(visitor, name)
    found = page.get_by_role("button", name=button, exact=True).first
    found.wait_for()
    handle = found.element_handle()
    pressed(found)
    wait_for(lambda: page.evaluate("(e) => !e.checkVisibility() || e.disabled", handle))
    wait_for(lambda: not page.evaluate(_AT)[0])
    assert at(page) == then


def test_focus_stays_while_an_answer_is_long_in_coming(visitor: Visitor) -> None:
    # the answer before is not seen meanwhile, and what is hidden loses the focus
    held: list[Route] = []
    visitor.page.route("**/drive/judging.js", lambda route: None)  # the server answers alone
    page = used(visitor, "drive")
    page.route("**/api/v1/solve/fast", lambda route: held.append(route))  # noqa: PLW0108
    pressed(page.locator("#verdict .advice"))
    page.wait_for_selector("#results.waiting")
    visitor.painted()
    assert at(page) == "verdict"
    wait_for(lambda: page.evaluate("true") and held)
    held[0].continue_()
    visitor.solved()
    visitor.painted()
    assert at(page) == "verdict"
    page.unroute_all(behavior="ignoreErrors")


def test_focus_stays_at_a_question_beside_the_map(visitor: Visitor) -> None:
    # the answer comes below the button, and the map is drawn anew with the page
    page = visitor.open("across")
    found = page.locator("#across").get_by_role("button", name="Compare thicknesses")
    pressed(found)
    expect(page.locator("#across [id^=question-] [role=status] .verdict")).to_have_count(1)
    visitor.painted()
    expect(found).to_be_focused()


def test_focus_stays_when_a_run_is_cancelled(visitor: Visitor) -> None:
    visitor.open("drive")
    visitor.example("Tandem head drive, fabric belt")
    page = visitor.open("events")
    minutes(page)
    pressed(page.locator("#follow"))
    cancel = page.locator("#events").get_by_role("button", name="Cancel")
    cancel.wait_for()
    assert at(page) != ""
    pressed(cancel)
    expect(page.locator("#events")).to_contain_text("Cancelled.")
    visitor.painted()
    assert at(page) == "follow"


def test_focus_stays_when_a_study_is_cancelled_and_forgotten(visitor: Visitor) -> None:
    page = visitor.open("study")
    page.get_by_label("Samples").fill("200000")
    page.locator("#study").get_by_label("Title").fill("Left")
    page.get_by_role("button", name="Start the study").click()
    job = page.locator("#study .job[aria-label=Left]")
    pressed(job.get_by_role("button", name="Cancel"))
    forget = job.get_by_role("button", name="Delete")
    expect(forget).to_be_focused()
    page.keyboard.press("Enter")
    expect(job).to_have_count(0)
    assert at(page) == "jobs"


def test_focus_stays_while_the_pressure_of_a_test_is_typed(visitor: Visitor) -> None:
    page = visitor.open("tests")
    page.set_input_files("#test-files", FILES)
    choose_test(page, FILES[1].name)
    box = page.get_by_label(f"Set pressure of {FILES[1].name}")
    expect(box).not_to_have_value("")
    held: list[Route] = []
    page.route("**/tests/*/files/*", lambda route: held.append(route))  # noqa: PLW0108
    box.fill("70 kPa")
    page.keyboard.press("Tab")
    after = page.get_by_label(f"Condition of {FILES[1].name}")
    expect(after).to_be_focused()
    wait_for(lambda: page.evaluate("true") and held)
    held[0].continue_()
    expect(page.locator("#tests")).to_contain_text(f"{len(FILES)} tests")
    visitor.painted()
    expect(after).to_be_focused()
    expect(box).to_have_value("70 kPa")


def test_load_is_few_tab_stops_from_the_top(calculator: Calculator) -> None:
    # the first stop is the skip link, then the pages, units and menus, the views of a drive and
    # its load cases; it was the 34th
    visitor = Visitor(calculator[0], calculator[1].address)
    page = visitor.open("drive")
    stops = 0
    while stops < 30 and page.evaluate("document.activeElement.id") != "f-pulley-0-entry_tension":
        page.keyboard.press("Tab")
        stops += 1
    assert stops <= 16
    visitor.close()
