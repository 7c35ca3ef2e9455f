"""Every state of the pages is accessible, light and dark: failing, empty, asked, left alone.

Pages as they are used without a fault: test_pages_looks.py.
"""

from collections.abc import Callable, Iterator, Sequence

import pytest
from playwright.sync_api import Page, expect

from web.browser import STUDY, Calculator, Visitor, turn
from web.calculators import document
from web.test_pages_looks import used, violations
from web.test_standing import take


@pytest.fixture
def guest(calculator: Calculator) -> Iterator[Visitor]:
    """One whose page may complain: its server is taken away."""
    browser, server = calculator
    found = Visitor(browser, server.address)
    yield found
    found.close()


def slips(visitor: Visitor) -> Page:
    page = visitor.open("drive")
    page.fill("#f-pulley-0-exit_tension", "2")
    expect(page.locator("#drive .figures")).to_contain_text("gross slip")
    visitor.solved()
    return page


def empty(visitor: Visitor) -> Page:
    page = visitor.open("drive")
    page.click("#file > summary")
    page.get_by_role("button", name="New drive").click()
    expect(page.locator("#s-pulley-0-entry_tension")).to_be_focused()
    page.click("#file > summary")
    return page


def overtyped_and_refused(visitor: Visitor) -> Page:
    page = visitor.open("drive")
    page.fill("#f-pulley-0-diameter", "1000")
    page.fill("#f-pulley-0-exit_tension", "150")
    expect(page.locator("svg.stage")).to_contain_text("creep at exit")
    visitor.solved()
    page.fill("#f-belt-width", "wide")
    page.wait_for_selector("#f-belt-width[aria-invalid=true]")
    page.click("#file > summary")
    return page


def pinned_and_without_a_server(visitor: Visitor) -> Page:
    page = visitor.open("drive")
    visitor.solved()
    page.get_by_role("button", name="Pin this design").click()
    page.get_by_label("Compare with the paper's integration").check()
    page.locator("#verdict .advice").click()
    page.locator("#toast").get_by_role("button", name="Undo").wait_for()
    page.get_by_role("button", name="Help: Wrap angle").click()
    visitor.solved()
    page.route("**/api/v1/**", lambda route: route.abort())
    page.fill("#f-pulley-0-exit_tension", "75")
    expect(page.locator(".gone")).to_be_visible()
    return page


def versions(visitor: Visitor) -> Page:
    page = used(visitor, "saved")
    page.locator("#saved tbody button", has_text="").filter(visible=True).nth(1).click()
    page.locator("tr.versions li").first.wait_for()
    page.locator("tr.versions li button").last.click()
    return page


STATES: dict[str, Callable[[Visitor], Page]] = {
    "gross slip": slips,
    "new drive, menu open": empty,
    "overtyped example that idles, a wrong value, menu open": overtyped_and_refused,
    "raised beside what is pinned, help open, server gone": pinned_and_without_a_server,
    "versions": versions,
}


@pytest.mark.parametrize("state", STATES)
def test_no_violation_of_wcag(guest: Visitor, state: str) -> None:
    page = STATES[state](guest)
    guest.painted()
    assert violations(page) == []


#: Questions, by the button that asks each of them, and where its answer stands.
QUESTIONS = {
    "What if": ("", ".what-if table"),
    "Which design has the lowest cost": ("Calculate", ".choosing table"),
    "On site": ("", ".site table"),
    "Which input gives": ("Find", ".seek svg.chart"),
}


def test_no_violation_of_wcag_in_questions_of_a_load_case_that_takes_over(guest: Visitor) -> None:
    page = guest.open("drive")
    guest.solved()
    page.locator("#cases").get_by_role("button", name="empty").click()
    page.get_by_role("group", name="Load: empty", exact=True).wait_for(state="attached")
    for name, (show, answer) in QUESTIONS.items():
        page.get_by_role("button", name=name).click()
        if show:
            page.locator("#question").get_by_role("button", name=show, exact=True).click()
        page.locator(answer).first.wait_for(timeout=STUDY)
        assert violations(page) == [], name


def test_no_violation_of_wcag_in_the_views_of_three_drives(guest: Visitor) -> None:
    page = guest.open("drive", unfold=False)
    take(page, document("triple-steel-cord"))
    guest.solved()
    views = ("train", "across", "events")
    for name in views:
        guest.open(name, unfold=False)

    def looked_at(state: str, views: Sequence[str]) -> None:
        for name in views:
            turn(page, name)
            expect(page.locator(f"#{name} [data-stands=computing]")).to_have_count(0)
            guest.painted()
            assert violations(page) == [], f"{name}, {state}"
        turn(page, "drive")

    looked_at("solved, not run", views)
    page.fill("#f-belt-width", "wide")
    page.wait_for_selector("#f-belt-width[aria-invalid=true]")
    looked_at("refused", ("train", "events"))
