"""Another listener of the machine, beside the server and in its place, under a real browser.

Expected: no cookie goes to it, no value that opens anything, no input of the user; a page goes on
with its own server alone, and says what to do where another one answers.
"""

import re
import threading
import urllib.error
import urllib.request
from collections.abc import Iterator
from contextlib import contextmanager
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import pytest
from playwright.sync_api import Page, Route, expect

from web.browser import LATER, READY, Calculator, Visitor, ask_now, turn
from web.calculators import API, TOKEN, Process, serving, wait_for


class Stranger(ThreadingHTTPServer):
    """A server of another user: it writes down all that it is sent, and answers anything."""

    daemon_threads = True

    def __init__(self, port: int = 0) -> None:
        super().__init__(("127.0.0.1", port), _Listening)
        self.heard: list[str] = []

    @property
    def all(self) -> str:
        """All that it was sent: addresses, heads and bodies."""
        return "\n".join(self.heard)


class _Listening(BaseHTTPRequestHandler):
    server: Stranger

    def do_GET(self) -> None:
        body = self.rfile.read(int(self.headers.get("content-length", 0)))
        self.server.heard.append(f"{self.requestline}\n{self.headers}\n{body!r}")
        self.send_response(200)
        self.end_headers()
        # of the length of a proof, so that nothing but its content tells it from one
        self.wfile.write(b"0" * 32)

    do_POST = do_GET  # noqa: N815

    def log_message(self, *_: object) -> None:
        """Say nothing."""


@contextmanager
def listening(port: int = 0) -> Iterator[Stranger]:
    """Listen for a while."""
    found = Stranger(port)
    thread = threading.Thread(target=found.serve_forever, args=(0.05,), daemon=True)
    thread.start()
    try:
        yield found
    finally:
        found.shutdown()
        found.server_close()


def of_this_window(page: Page) -> str:
    """Return all that a window keeps."""
    return str(page.evaluate("JSON.stringify({...sessionStorage})"))


def answers_to(port: int, value: str) -> int:
    """Return the status of a server's answer to a value."""
    request = urllib.request.Request(
        f"http://127.0.0.1:{port}{API}/designs", headers={"authorization": f"Bearer {value}"}
    )
    try:
        with urllib.request.urlopen(request) as answer:  # noqa: S310
            return int(answer.status)
    except urllib.error.HTTPError as error:
        return error.code


@pytest.fixture
def place(tmp_path: Path) -> tuple[str, ...]:
    return ("--no-open", "--workers", "0", "--database", str(tmp_path / "designs.sqlite"))


def test_a_listener_beside_the_server_is_sent_no_cookie_by_a_visiting_browser(
    visitor: Visitor,
) -> None:
    page = visitor.open("drive")
    assert visitor.context.cookies() == []
    with listening() as stranger:
        page.goto(f"http://127.0.0.1:{stranger.server_port}/")
        assert "GET / " in stranger.all
        assert "cookie" not in stranger.all.lower()
        assert TOKEN not in stranger.all
        assert of_this_window(page) == "{}"
    visitor.elsewhere.clear()


def test_who_takes_the_port_of_a_stopped_server_is_sent_nothing(
    calculator: Calculator, place: tuple[str, ...]
) -> None:
    with serving(*place) as server:
        visitor = Visitor(calculator[0], server.address, fresh=True)
        page = visitor.page
        page.clock.install()
        visitor.open("drive")
        value = server.start_token()
        assert value in of_this_window(page)
        assert TOKEN not in of_this_window(page)
    with listening(server.port) as stranger:
        page.fill("#f-pulley-0-exit_tension", "77.125")
        ask_now(page)
        turn(page, "study")  # a part that was not fetched yet
        page.clock.run_for(LATER)
        expect(page.locator(".gone")).to_contain_text("was restarted")
        wait_for(lambda: page.evaluate("1") and len(stranger.heard) > 2)
        asked = [one.partition(" HTTP")[0] for one in stranger.heard]
        assert [one for one in asked if not re.fullmatch(rf"GET {API}/same/[\w-]{{36}}", one)] == []
        for secret in (value, TOKEN, "77.125", "authorization", "cookie"):
            assert secret not in stranger.all.lower()
    # the value of before opens nothing after the next start, and the page goes on with its address
    again = Process(*place, "--port", str(server.port))
    try:
        assert answers_to(server.port, value) == 401
        page.clock.run_for(LATER)
        expect(page.locator(".gone")).to_contain_text("was restarted")
        box = page.get_by_label("Address")
        box.fill("http://127.0.0.1/?token=0123456789abcdef0123")
        page.get_by_role("button", name="Continue").click()
        wrong = "document.querySelector('.gone input').validity.customError"
        wait_for(lambda: page.evaluate(wrong))
        box.fill(f"http://127.0.0.1:{server.port}/?token={again.start_token()}")
        page.get_by_role("button", name="Continue").click()
        with page.expect_event("load"):  # for the part that did not come
            page.clock.run_for(LATER)
        page.wait_for_selector(READY["study"])
        turn(page, "drive")
        expect(page.locator("#f-pulley-0-exit_tension")).to_have_value("77.125")
        assert value not in of_this_window(page)
        visitor.close()
    finally:
        again.kill()


def test_an_address_without_its_value_asks_for_it_and_goes_on(
    calculator: Calculator, place: tuple[str, ...]
) -> None:
    with serving(*place) as server:
        for pasted in (TOKEN, f"{server.address}?token={server.start_token()}"):
            visitor = Visitor(calculator[0], server.address, fresh=True)
            page = visitor.page
            page.goto(f"{visitor.address}#/compare")
            page.get_by_label("Address").fill(pasted)
            page.get_by_role("button", name="Continue").click()
            page.wait_for_selector(READY["compare"])
            assert "token" not in page.url
            page.reload()
            page.wait_for_selector(READY["compare"])
            visitor.close()


def test_an_open_page_is_not_held_to_a_value_that_it_cannot_prove(visitor: Visitor) -> None:
    # a proof of another length is no answer of a server at all
    page = visitor.open("drive")

    def short(route: Route) -> None:
        route.fulfill(status=200, body=b"0" * 31)

    visitor.context.route("**/api/v1/same/*", short)
    page.fill("#f-pulley-0-exit_tension", "77")
    expect(page.locator(".gone")).to_contain_text("does not answer")
    visitor.context.unroute_all(behavior="ignoreErrors")
    ask_now(page)
    expect(page.locator(".gone")).to_have_count(0)
    visitor.solved()
