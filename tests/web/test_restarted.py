"""A server that is killed and started again on its port, under the eyes of a page."""

from pathlib import Path

from playwright.sync_api import Page, Route, expect

from web.browser import LATER, READY, Calculator, Visitor, turn
from web.calculators import TOKEN, Process, serving, wait_for
from web.test_pages_tests import FILES


def test_a_killed_server_is_waited_for_and_comes_back(
    calculator: Calculator, tmp_path: Path
) -> None:
    # two windows on one server; what computes is no matter here
    place = ("--no-open", "--workers", "0", "--database", str(tmp_path / "designs.sqlite"))
    with serving(*place) as server:
        window, other = (Visitor(calculator[0], server.address, fresh=True) for _ in range(2))
        for visitor in (window, other):
            visitor.page.clock.install()  # it is turned to when the server is asked for again
        page = window.open("tests", unfold=True)
        page.set_input_files("#test-files", FILES)
        page.wait_for_selector(f"text={len(FILES)} tests")
        turn(page, "drive")
        window.solved()
        failed: list[str] = []
        other.open("drive").on("requestfailed", lambda request: failed.append(request.url))
        server.kill()
        loses_its_server(page)
        asks_for_a_page_once(other.page, failed)
        again = Process(*place, "--port", str(server.port))
    try:
        for visitor in (window, other):
            visitor.page.clock.fast_forward(LATER)
            is_told_the_address(visitor.page, again)
            visitor.page.clock.fast_forward(LATER)
        finds_it_again(window)
        other.page.wait_for_selector(READY["study"])
        turn(other.page, "drive")
        expect(other.page.locator("#f-pulley-0-exit_tension")).to_have_value("77")
        for visitor in (window, other):
            visitor.close()
    finally:
        again.kill()


def is_told_the_address(page: Page, server: Process) -> None:
    # expected: a page has the token of the start that it was opened from, and goes on with another
    # start when it is told its address; nothing typed is lost
    expect(page.locator(".gone")).to_contain_text("was restarted")
    page.get_by_label("Address").fill(f"{server.address}?token={server.start_token()}")
    page.get_by_role("button", name="Continue").click()


def loses_its_server(page: Page) -> None:
    # expected: what was typed while it was away is solved on its return
    page.fill("#f-pulley-0-exit_tension", "77")
    expect(page.locator(".gone")).to_contain_text("does not answer")
    assert "Not computed" not in page.inner_text("#results")


def asks_for_a_page_once(page: Page, failed: list[str]) -> None:
    # expected: a page not yet seen is fetched from no server but that of this window, the others
    # work on, and it comes with the server; it was asked for again the moment it did not come, and
    # nothing could be pressed any more
    turn(page, "study")
    expect(page.locator(".gone")).to_contain_text("does not answer")
    expect(page.locator("#study")).to_contain_text("Loading")
    turn(page, "drive")
    page.fill("#f-pulley-0-exit_tension", "77")
    turn(page, "study")

    def asked_thrice() -> bool:
        page.clock.fast_forward(LATER)
        return sum("/same/" in url for url in failed) > 2

    # three questions later, whether it is there, hundreds of tries were none
    wait_for(asked_thrice)
    assert sum("study" in url for url in failed) == 0
    assert len(failed) < 30


def finds_it_again(visitor: Visitor) -> None:
    # expected: a test session ended with the server and says so, where the page waited for ever
    page = visitor.page
    expect(page.locator(".gone")).to_have_count(0)
    visitor.solved()
    expect(page.locator("#f-pulley-0-exit_tension")).to_have_value("77")
    expect(page.locator("#results [role=alert]")).to_have_text("")
    turn(page, "tests")
    page.get_by_role("button", name="Fit the lagging").click()
    expect(page.locator("#toast")).to_contain_text("drop the files again")
    expect(page.get_by_text("Fitting …")).to_have_count(0)
    page.set_input_files("#test-files", FILES)
    page.wait_for_selector(f"text={len(FILES)} tests")


def test_a_link_is_shown_where_the_clipboard_is_closed(calculator: Calculator) -> None:
    # as on plain HTTP, where a browser has no clipboard for a page
    visitor = Visitor(calculator[0], calculator[1].address)
    visitor.page.add_init_script("Object.defineProperty(navigator, 'clipboard', {})")
    page = visitor.open("drive")
    page.fill("#f-pulley-0-exit_tension", "71")
    page.press("#f-pulley-0-exit_tension", "Tab")
    page.click("#file > summary")
    page.get_by_role("button", name="Copy a link").click()
    link = page.get_by_label("Link", exact=True)
    expect(link).to_be_focused()
    other = Visitor(calculator[0], link.input_value())
    # what reads the link comes last, after all that is drawn later
    held: list[Route] = []
    other.page.route("**/frame/link.js", lambda route: held.append(route))  # noqa: PLW0108
    with other.page.expect_response("**/drive/more.js"):
        other.page.goto(other.address.replace("/#", f"/?token={TOKEN}#"))
    other.painted()
    wait_for(lambda: other.page.evaluate("true") and held)
    held[0].continue_()
    other.open("drive")
    expect(other.page.locator("#f-pulley-0-exit_tension")).to_have_value("71")
    assert visitor.wrong == []
    visitor.close()
    other.close()
