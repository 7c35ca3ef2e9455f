"""Fourteen jobs of the page by keyboard alone; prints the keys of each.

Keys are counted, and apart from them the stops of Tab from the top of the page; by mouse:
`test_first_lines.py`.
"""

import re
from collections.abc import Callable
from typing import NamedTuple

import pytest
from playwright.sync_api import Page, ViewportSize, expect

from web.browser import Calculator, Visitor, show_case

SCREEN: ViewportSize = {"width": 1440, "height": 900}
#: Most stops from the top of the page to what a job needs.
MOST_STOPS = 75
ACTIVE = "(of) => document.activeElement?.matches(of) ?? false"


def _verdict(page: Page, text: str) -> None:
    expect(page.locator("#verdict p")).to_contain_text(text)


def _hub(page: Page, text: str) -> None:
    expect(page.locator(".hub-number")).to_have_text(re.compile(text))


class Job(NamedTuple):
    """A job: where to press, the keys there, what it comes to, and the view that it is done in."""

    name: str
    where: str
    keys: tuple[str, ...]
    then: Callable[[Page], None]
    view: str = "drive"


#: Load case `design` of the head drive is looked at.
JOBS = (
    Job("what to do", "#verdict .act button", ("Enter",), lambda p: _verdict(p, "All ")),
    Job("which lagging", ".ways li:first-child button", ("Enter",), lambda p: _hub(p, r"^4\.36")),
    Job("wrap", "#f-pulley-0-wrap_angle", ("ArrowUp",), lambda p: _hub(p, r"^7\.[0-4]")),
    Job(
        "wet",
        "#lagging-condition",
        ("ArrowDown",),
        lambda p: expect(p.locator("#lagging-condition")).to_have_value("wet"),
    ),
    Job("worst load case", "#verdict .link", ("Enter",), lambda p: _hub(p, r"^11\.4")),
    Job(
        "why",
        ".list li:nth-child(2) button",
        ("Enter",),
        lambda p: expect(p.locator("#why")).to_contain_text("CEMA"),
    ),
    Job(
        "where on the arc",
        "input[name=quantity]",
        ("ArrowRight",),
        lambda p: expect(p.locator("svg.stage .legend")).to_contain_text("shear to"),
    ),
    Job("T2 by its handle", ".h[aria-label^='Slack']", ("PageUp",), lambda p: _hub(p, r"^[67]\.")),
    Job(
        "how sure",
        "input[name=below-checks]",
        ("ArrowRight",),
        lambda p: expect(p.locator(".reserves li").first).to_be_visible(),
    ),
    Job(
        "US units",
        "input[name=units]",
        ("ArrowRight",),
        lambda p: _verdict(p, "exceeds the 0.25 in limit"),
    ),
    Job(
        "on site",
        ".screen > .inline button",
        ("Enter",),
        lambda p: expect(p.locator("#question")).to_be_visible(),
    ),
    Job(
        "costs",
        "#tab-choose",
        ("Enter",),
        lambda p: expect(p.locator("#compare tbody tr").first).to_be_visible(),
    ),
    Job(
        "in time",
        "#nav-events",
        ("Enter",),
        lambda p: expect(p.locator("#events svg.stage")).to_be_visible(),
    ),
    Job(
        "report",
        "#tab-report",
        ("Enter",),
        lambda p: expect(p.locator("#report form")).to_be_visible(),
    ),
)


@pytest.fixture(scope="module")
def drive(calculator: Calculator) -> Visitor:
    browser, server = calculator
    return Visitor(browser, server.address, SCREEN)


def begun(visitor: Visitor) -> Page:
    """Show the head drive as it comes, all of it there."""
    page = visitor.open("drive", unfold=False)
    if not page.locator("#drive").is_visible():
        page.click("#tab-drive")
    page.get_by_label("SI", exact=True).check(force=True)
    visitor.example("Head drive, ROM conveyor")
    visitor.solved()
    visitor.alone()
    show_case(page, "design")
    page.locator(".changes .switch").get_by_text("Changes").click()
    expect(page.locator(".changes h2", has_text="design")).to_be_visible()
    expect(page.locator(".ways .bone")).to_have_count(0)
    return page


def test_fourteen_jobs_by_keyboard_alone(drive: Visitor) -> None:
    assert len(JOBS) == 14
    for job in JOBS:
        page = begun(drive)
        page.evaluate("document.activeElement.blur(); scrollTo(0, 0)")
        page.evaluate("document.querySelector('#skip').focus()")
        stops = 0
        while not page.evaluate(ACTIVE, job.where) and stops < MOST_STOPS:
            page.keyboard.press("Tab")
            stops += 1
        assert page.evaluate(ACTIVE, job.where), f"{job.name}: not within {stops} stops"
        for key in job.keys:
            page.keyboard.press(key)
        job.then(page)
        print(f"{job.name}: {len(job.keys)} keys after {stops} stops")  # noqa: T201
    drive.close()
    assert drive.wrong == []
