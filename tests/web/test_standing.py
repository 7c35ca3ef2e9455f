"""How what stands on a page stands to what is asked: nothing of before passes for the present.

Expected of every page: an answer is marked fresh only if it is of the drive as it is typed, and no
verdict is given (no OK, no green) of one that is not.
"""

import re
from collections.abc import Iterator
from typing import Any

import pytest
from playwright.sync_api import Page, Route, expect

from web.browser import DESKTOP, PAGES, PHONE, Calculator, Visitor
from web.calculators import document, wait_for

#: Pages that answer by themselves as the drive changes.
ANSWERING = ("drive", "compare", "across", "train")


@pytest.fixture
def guest(calculator: Calculator) -> Iterator[Visitor]:
    """One whose page may complain: its server is taken away."""
    found = Visitor(calculator[0], calculator[1].address, told_long=False)
    found.page.clock.install()
    yield found
    found.context.close()


def take(page: Page, doc: dict[str, Any]) -> None:
    page.evaluate("(doc) => import('/static/main.js').then((m) => m.take(doc))", doc)


def tandem(visitor: Visitor) -> Page:
    """Open a drive of two pulleys, and every page of it."""
    page = visitor.open("drive")
    doc = document("tandem-fabric")
    take(page, doc)
    for name in PAGES:
        visitor.open(name)
    for name in ANSWERING:
        page.click(f"#nav-{name}")
        expect(page.locator(f"#{name} [data-stands]").first).to_have_attribute(
            "data-stands", "fresh"
        )
    return page


def stands(page: Page, name: str) -> list[str]:
    page.click(f"#nav-{name}")
    marks = page.locator(f"#{name} [data-stands]:visible").all()
    return [str(mark.get_attribute("data-stands")) for mark in marks]


def judged(page: Page, name: str) -> list[str]:
    """Verdicts of answers that a page gives, by their words."""
    boxes = page.locator(f"#{name} [data-stands] .verdict:visible:not([role=status])")
    return [box.inner_text() for box in boxes.all() if box.locator(".badge").count()]


def test_no_page_gives_a_verdict_of_another_drive(guest: Visitor) -> None:
    page = tandem(guest)
    assert judged(page, "train")  # there is one to be taken back
    page.click("#nav-drive")
    page.fill("#f-belt-width", "wide")
    page.wait_for_selector("#f-belt-width[aria-invalid=true]")
    for name in PAGES:
        wait_for(lambda name=name: "computing" not in stands(page, name))
        assert "fresh" not in stands(page, name), name
        assert judged(page, name) == [], name
        if name == "train":
            expect(page.locator("#train [role=alert] .verdict.bad")).to_be_visible()
            expect(page.locator("#train")).to_contain_text("Below is the answer before the change")
    page.click("#nav-drive")
    page.fill("#f-belt-width", "1400")
    for name in ANSWERING:
        wait_for(lambda name=name: set(stands(page, name)) == {"fresh"})
        wait_for(lambda name=name: name == "compare" or judged(page, name))


@pytest.mark.parametrize("how", ["computing", "gone"])
def test_no_page_gives_a_verdict_that_has_not_come(guest: Visitor, how: str) -> None:
    page = tandem(guest)

    def waits(route: Route) -> None:
        if how == "gone":
            route.abort()

    page.route("**/api/v1/**", waits)
    page.click("#nav-drive")
    page.fill("#f-belt-width", "1400")
    for name in PAGES:
        found = stands(page, name)
        assert set(found) <= {how, "computing"}, (name, found)
        assert judged(page, name) == [], name
    if how == "gone":
        for name in ANSWERING:
            wait_for(lambda name=name: set(stands(page, name)) == {"gone"})
        expect(page.locator(".gone[role=alert]")).to_have_count(1)
    page.unroute_all(behavior="ignoreErrors")


def test_a_load_case_that_cannot_be_solved_is_named(visitor: Visitor) -> None:
    # T1 of the load that all share is cleared: the other load cases give their own and are solved,
    # and what is shown is one of those
    page = visitor.open("drive")
    visitor.solved()
    page.fill("#f-pulley-0-entry_tension", "")
    told = page.locator("#verdict")
    expect(told).to_contain_text("Load case design lacks a tension and is left out")
    expect(told).to_contain_text(re.compile(r"Shown is (empty|start)"))
    expect(told.locator(".verdict.good")).to_have_count(0)
    assert "OK" not in told.locator(".headline").first.inner_text()
    page.fill("#f-pulley-0-entry_tension", "150")
    expect(told).not_to_contain_text("left out")
    visitor.solved()


def test_buttons_that_do_nothing_look_so(visitor: Visitor) -> None:
    page = visitor.open("train")  # of one pulley: nothing to match
    main = page.get_by_role("button", name="Work out how exactly they must be matched")
    expect(main).to_be_disabled()
    look = "(b) => [getComputedStyle(b).backgroundColor, getComputedStyle(b).color]"
    plain = page.evaluate(
        f"""() => {{
          const button = document.createElement("button");
          button.disabled = true;
          document.getElementById("main").append(button);
          const found = ({look})(button);
          button.remove();
          return found;
        }}"""
    )
    for name in PAGES:
        visitor.open(name)
        for button in page.locator(f"#{name} button.main").all():
            if button.is_visible():
                assert (button.evaluate(look) == plain) == button.is_disabled()
    visitor.open("train")
    assert main.evaluate(look) == plain


def test_what_takes_long_says_so_and_can_be_ended(guest: Visitor) -> None:
    page = guest.open("drive")
    take(page, document("tandem-fabric"))
    guest.open("train")
    ended: list[str] = []
    page.on("requestfailed", lambda r: ended.append(r.url))
    held: list[str] = []

    def hold(route: Route) -> None:  # a server at work: it answers who asks whether it is there
        if route.request.url.endswith("/about"):
            route.continue_()
        else:
            held.append(route.request.url)

    page.route("**/api/v1/**", hold)
    page.get_by_role("button", name="Work out how exactly").click()
    wait_for(lambda: page.evaluate("1") and held)
    toast = page.locator("#toast")
    for seconds in (3, 9, 30):
        page.clock.run_for(1000)

        def told(seconds: int = seconds) -> bool:
            found = re.search(r"At work for (\d+) s", toast.inner_text())
            if found and int(found[1]) >= seconds:
                return True
            page.clock.run_for(1000)
            return False

        wait_for(told)
        expect(page.locator(".gone")).to_have_count(0)  # it is at work, and not gone
    toast.get_by_role("button", name="Cancel").click()
    wait_for(lambda: page.evaluate("1") and any(url.endswith("/train") for url in ended))
    expect(toast).to_have_text("Cancelled.")
    expect(page.locator(".gone")).to_have_count(0)
    expect(page.get_by_role("button", name="Work out how exactly")).to_be_enabled()
    page.unroute_all(behavior="ignoreErrors")


@pytest.mark.parametrize("size", [DESKTOP, PHONE], ids=["desktop", "phone"])
def test_a_long_title_widens_no_page(calculator: Calculator, size: Any) -> None:
    # more than a drive file may have: it is refused, and stands on the page nevertheless
    visitor = Visitor(calculator[0], calculator[1].address, size)
    page = visitor.open("drive")
    for name in PAGES:
        visitor.open(name)
    for title in ("W" * 200, "W" * 300):
        take(page, {**document(), "title": title})
        for name in PAGES:
            page.click(f"#nav-{name}")
            visitor.painted()
            if name == "drive":
                expect(page.locator("#drive .pick h2")).to_have_text(title)
            widths = page.evaluate("[document.documentElement.scrollWidth, innerWidth]")
            assert widths[0] <= widths[1], name
    visitor.context.close()
