"""Every state of the pages is accessible, light and dark: failing, empty, asked, left alone."""

from collections.abc import Callable, Iterator

import pytest
from playwright.sync_api import Page, expect

from web.browser import STUDY, Calculator, Visitor
from web.test_pages_looks import used, violations


@pytest.fixture(params=["light", "dark"])
def guest(calculator: Calculator, request: pytest.FixtureRequest) -> Iterator[Visitor]:
    browser, server = calculator
    found = Visitor(browser, server.address, color_scheme=request.param)
    yield found
    found.context.close()


def slips(visitor: Visitor) -> Page:
    page = visitor.open("drive")
    page.fill("#f-pulley-0-exit_tension", "2")
    expect(page.locator("#drive .figures")).to_contain_text("gross slip")
    visitor.solved()
    return page


def idles(visitor: Visitor) -> Page:
    page = visitor.open("drive")
    page.fill("#f-pulley-0-exit_tension", "150")
    visitor.solved()
    return page


def empty(visitor: Visitor) -> Page:
    page = visitor.open("drive")
    page.click("#file > summary")
    page.get_by_role("button", name="New drive").click()
    expect(page.locator("#results [role=alert]")).to_contain_text("still needed")
    return page


def overtyped(visitor: Visitor) -> Page:
    page = visitor.open("drive")
    page.fill("#f-pulley-0-diameter", "1000")
    expect(page.locator("#drive .aside")).to_be_visible()
    visitor.solved()
    return page


def without_a_server(visitor: Visitor) -> Page:
    page = visitor.open("drive")
    visitor.solved()
    page.route("**/api/v1/**", lambda route: route.abort())
    page.fill("#f-pulley-0-exit_tension", "75")
    expect(page.locator(".gone")).to_be_visible()
    return page


def refused(visitor: Visitor) -> Page:
    page = visitor.open("drive")
    page.fill("#f-belt-width", "wide")
    page.wait_for_selector("#f-belt-width[aria-invalid=true]")
    page.click("#file > summary")
    return page


def pinned(visitor: Visitor) -> Page:
    page = visitor.open("drive")
    visitor.solved()
    page.get_by_role("button", name="Pin this design").click()
    page.get_by_label("Paper's march beside it").check()
    page.fill("#f-pulley-0-exit_tension", "90")
    page.get_by_role("button", name="Help: Wrap angle").click()
    visitor.solved()
    return page


def asked(visitor: Visitor) -> Page:
    page = visitor.open("drive")
    visitor.solved()
    for name, show in (("What if", ""), ("Which design costs least", "Show"), ("On site", "")):
        page.get_by_role("button", name=name).click()
        if show:
            page.locator(".choosing").get_by_role("button", name=show, exact=True).click()
    for card in (".what-if", ".choosing", ".site"):
        page.locator(f"{card} table").first.wait_for(timeout=STUDY)
    return page


def versions(visitor: Visitor) -> Page:
    page = used(visitor, "saved")
    page.locator("#saved tbody button", has_text="").filter(visible=True).nth(1).click()
    page.locator("tr.versions li").first.wait_for()
    page.locator("tr.versions li button").last.click()
    return page


def every(name: str) -> Callable[[Visitor], Page]:
    def show(visitor: Visitor) -> Page:
        page = used(visitor, name)
        page.evaluate("for (const d of document.querySelectorAll('main details')) d.open = true")
        return page

    return show


STATES: dict[str, Callable[[Visitor], Page]] = {
    "gross slip": slips,
    "idling": idles,
    "new drive": empty,
    "overtyped example": overtyped,
    "server gone": without_a_server,
    "wrong value, menu open": refused,
    "pinned, help open": pinned,
    "questions answered": asked,
    "versions": versions,
    "across": every("across"),
    "tests fitted": every("tests"),
    "train": every("train"),
    "event played": every("events"),
    "study done": every("study"),
}


@pytest.mark.parametrize("state", STATES)
def test_no_violation_of_wcag(guest: Visitor, state: str) -> None:
    page = STATES[state](guest)
    guest.painted()
    assert violations(page) == []
