"""The network cut under the eyes of a page, in every way, and at everything that it fetches.

Expected: one bar says it, what was typed stays, the page is whole once the server answers; nothing
is asked more often than 1, 2, 4, 5, 5 ... s apart. Time is the page's own: no test waits for it.
"""

import re
from collections.abc import Callable, Iterator

import pytest
from playwright.sync_api import Error, Route, expect

from web.browser import PAGES, READY, Calculator, Visitor, ask_now, evaluated, turn
from web.calculators import TOKEN, wait_for
from web.test_static import STATIC

LATE = [name for name in PAGES if name != "drive"]


def _offline(route: Route) -> None:
    route.abort("connectionfailed")


def _fault(route: Route) -> None:
    route.fulfill(status=500, content_type="text/plain", body="Internal Server Error")


def _half(route: Route) -> None:
    script = "/static/" in route.request.url
    kind = "text/javascript" if script else "application/json"
    route.fulfill(status=200, content_type=kind, body='export const a = {"b": {' * (1 + script))


#: A way of cutting makes a request fail otherwise; what comes of one that failed is the same: of a
#: script that does not come, of a question by its kind. Silence, the fourth, is that of `Cut`.
CUTS: dict[str, Callable[[Route], None]] = {
    "offline": _offline,
    "500": _fault,
    "half an answer": _half,
}


class Cut:
    """A visitor whose network can be cut."""

    def __init__(self, calculator: Calculator) -> None:
        self.visitor = Visitor(calculator[0], calculator[1].address, told_long=False, fresh=True)
        self.page = self.visitor.page
        self.page.clock.install()
        self.asked: list[str] = []
        self.held: list[Route] = []
        self.page.on("request", lambda r: self.asked.append(r.url))
        self.page.on("dialog", lambda d: d.accept())
        self.visitor.open("drive")
        wait_for(lambda: self.page.evaluate("1") and any("worker" in url for url in self.asked))
        evaluated(self.page, "import('/static/pages/drive/judging.js').then((m) => m.ready)")
        wait_for(lambda: self.page.evaluate("1") and any("behind" in url for url in self.asked))
        evaluated(self.page, "import('/static/frame/behind.js').then(() => true)")

    def cut(self, how: str) -> None:
        self.visitor.context.route("**/*", self._silent if how == "silence" else CUTS[how])

    def _silent(self, route: Route) -> None:
        self.held.append(route)

    def mend(self) -> None:
        # what a silent server was asked breaks off: let go, it would be answered after all
        for route in self.held:
            route.abort("connectionreset")
        self.held.clear()
        self.visitor.context.unroute_all(behavior="ignoreErrors")

    def gone(self) -> None:
        """Let time pass until the bar is there; who is silent is asked twice."""
        bar = self.page.locator(".gone")

        def there() -> bool:
            self.page.clock.run_for(5000)
            return bar.count() > 0

        wait_for(there)
        expect(bar).to_have_count(1)
        expect(bar).to_contain_text("does not answer")

    def reloaded(self) -> None:
        """Let time pass until the page loads itself anew; what it asks comes in its own time."""
        self.page.evaluate("() => void (globalThis.before = true)")

        def anew() -> bool:
            try:
                self.page.clock.run_for(5000)
                return bool(self.page.evaluate("() => !globalThis.before"))
            except Error:  # between two pages
                return False

        wait_for(anew)

    def again(self) -> None:
        """Let time pass until the bar is gone: 5 s is the longest pause."""

        def back() -> bool:
            self.page.clock.run_for(5000)
            return self.page.locator(".gone").count() == 0

        wait_for(back)


@pytest.fixture
def cut(calculator: Calculator) -> Iterator[Cut]:
    found = Cut(calculator)
    yield found
    found.visitor.close()
    wrong = [w for w in found.visitor.wrong if "Failed to load resource" not in w]
    assert [w for w in wrong if "Unexpected" not in w] == []  # of half a script


def _press(name: str) -> Callable[[Cut], None]:
    def pressed(cut: Cut) -> None:
        cut.page.get_by_role("button", name=name, exact=True).first.click()

    return pressed


def _menu(menu: str, name: str) -> Callable[[Cut], None]:
    def pressed(cut: Cut) -> None:
        cut.page.click(f"#{menu} > summary")
        entry = cut.page.locator(f"#{menu}-menu").get_by_role("button", name=name)
        if menu == "file" or entry.count():  # that of files is there by then
            entry.first.click()

    return pressed


#: Parts of the first page that are fetched when they are wanted.
PARTS: dict[str, Callable[[Cut], None]] = {
    "download": _menu("file", "Download the drive file"),
    "link": _menu("file", "Copy a link"),
    "exporting": _menu("file", "Pictures of this page (SVG)"),
    "seek": _press("Which input gives …?"),
    "what_if": _press("What if … wet, worn, bare?"),
    "choosing": _press("Which design has the lowest cost?"),
    "site": _press("On site: what to measure, when to alarm"),
    "measured": _press("A measured drive"),
}


@pytest.mark.parametrize("how", ["half an answer", "silence"])
def test_parts_and_pages_that_do_not_come_are_one_bar_and_come_with_the_server(
    cut: Cut, how: str
) -> None:
    page = cut.page
    page.fill("#f-pulley-0-exit_tension", "77")
    cut.visitor.solved()
    cut.cut(how)
    before = len(cut.asked)
    for press in PARTS.values():
        press(cut)
        page.keyboard.press("Escape")
    for name in LATE:
        turn(page, name)
        expect(page.locator(f"#{name}")).to_contain_text("Loading")
    cut.gone()
    expect(page.locator("#toast")).to_have_text("")  # the bar is enough
    # from a server that has not proved to be the one of this window nothing is fetched
    assert [url for url in cut.asked[before:] if "/same/" not in url] == []
    cut.mend()
    cut.reloaded()  # no browser asks anew for a script that did not come
    for name in (*LATE, "drive"):
        turn(page, name)
        page.wait_for_selector(READY[name])
    expect(page.locator("#f-pulley-0-exit_tension")).to_have_value("77")
    expect(page.locator(".gone")).to_have_count(0)
    PARTS["seek"](cut)
    expect(page.locator(".seek, section[aria-label*='gives']").first).to_be_visible()


@pytest.mark.parametrize("how", ["silence", "half an answer"])
def test_questions_that_are_not_answered_are_asked_again(cut: Cut, how: str) -> None:
    page = cut.page
    for name in PAGES:
        cut.visitor.open(name)
    turn(page, "drive")
    cut.cut(how)
    page.fill("#f-pulley-0-exit_tension", "77")
    cut.gone()
    before = len(cut.asked)
    for name in PAGES:
        turn(page, name)
        for button in page.locator(f"#{name} button.main:not(:disabled, .advice)").all():
            if button.is_visible():
                button.click()
        expect(page.locator(".gone")).to_have_count(1)
    assert len(cut.asked) - before < 60
    assert cut.visitor.page.locator("#toast").inner_text() == ""
    turn(page, "drive")
    cut.mend()
    cut.again()
    expect(page.locator("#f-pulley-0-exit_tension")).to_have_value("77")
    cut.visitor.solved()
    for name in PAGES:
        cut.visitor.open(name)


def test_the_pauses_double_up_to_five_seconds(cut: Cut) -> None:
    page = cut.page
    cut.cut("offline")
    failed: list[str] = []
    page.on("requestfailed", lambda r: failed.append(r.url.split("/")[-2]))
    page.clock.pause_at(page.evaluate("Date.now() / 1000 + 60"))
    page.fill("#f-pulley-0-exit_tension", "77")
    page.clock.run_for(300)  # the hand rests
    expect(page.locator(".gone")).to_have_count(1)
    wait_for(lambda: page.evaluate("1") and failed)
    asked = failed.count("same")
    page.clock.run_for(1000)
    for pause in (2000, 4000, 5000, 5000, 5000):
        asked += 1
        wait_for(lambda n=asked: page.evaluate("1") and failed.count("same") == n)
        page.clock.run_for(pause - 1)
        page.evaluate("1")
        assert failed.count("same") == asked
        page.clock.run_for(1)
    page.fill("#f-pulley-0-exit_tension", "78")  # what is typed asks by itself, and no more
    page.get_by_role("button", name="Calculate").click()
    wait_for(lambda: page.evaluate("1") and failed.count("same") == asked + 2)
    cut.mend()
    page.clock.resume()
    ask_now(page)
    expect(page.locator(".gone")).to_have_count(0)
    cut.visitor.solved()
    expect(page.locator("#f-pulley-0-exit_tension")).to_have_value("78")


def test_a_server_of_another_version_asks_for_a_reload(cut: Cut) -> None:
    page = cut.page
    pressed: list[str] = []  # from then on the server is of the page's own version
    page.on("request", lambda r: pressed.append(r.url) if r.is_navigation_request() else None)

    def newer(route: Route) -> None:
        answer = route.fetch()
        version = {} if pressed else {"wraparc-version": "99.0"}
        route.fulfill(response=answer, headers={**answer.headers, **version})

    cut.visitor.context.route("**/api/v1/**", newer)
    page.fill("#f-pulley-0-exit_tension", "77")
    bar = page.locator(".gone")
    expect(bar).to_contain_text("another version")
    with page.expect_navigation():
        bar.get_by_role("button", name="Reload").click()
    cut.visitor.solved()
    expect(page.locator("#f-pulley-0-exit_tension")).to_have_value("77")
    expect(bar).to_have_count(0)


def test_a_part_that_is_not_there_any_more_asks_for_a_reload(cut: Cut) -> None:
    page = cut.page  # after an update: the server answers, and has no such file
    cut.visitor.context.route("**/static/pages/*", lambda r: r.fulfill(status=404, body=""))
    page.fill("#f-pulley-0-exit_tension", "77")
    turn(page, "study")
    expect(page.locator(".gone")).to_contain_text("A part of this page did not come")
    cut.mend()
    with page.expect_navigation():
        page.get_by_role("button", name="Reload").click()
    page.wait_for_selector(READY["study"])
    turn(page, "drive")
    expect(page.locator("#f-pulley-0-exit_tension")).to_have_value("77")


def test_a_page_that_begins_without_a_server_begins_with_it(calculator: Calculator) -> None:
    visitor = Visitor(calculator[0], calculator[1].address, told_long=False, fresh=True)
    page = visitor.page
    page.clock.install()
    visitor.context.route("**/api/v1/**", _fault)
    page.goto(f"{visitor.address}?token={TOKEN}")

    def told() -> bool:
        page.clock.run_for(5000)
        return "does not answer" in page.inner_text("#main")

    wait_for(told)
    visitor.context.unroute_all(behavior="ignoreErrors")
    with page.expect_navigation():
        page.clock.run_for(31_000)
    page.wait_for_selector(READY["drive"])
    visitor.close()


def test_all_that_is_fetched_is_fetched_in_one_place() -> None:
    wrong = []
    for path in sorted(STATIC.rglob("*.js")):
        if {"built", "vendor"} & set(path.relative_to(STATIC).parts) or path.name == "kernel.js":
            continue
        code = re.sub(r"/\*.*?\*/|//[^\n]*", "", path.read_text("utf-8"), flags=re.DOTALL)
        if path.name not in (
            "server.js",
            "proof.js",
        ):  # proof.js asks who answers, before server.js
            wrong += re.findall(r"\bfetch\(|XMLHttpRequest|EventSource", code)
            if path.name not in ("pages.js", "main.js", "entry.js"):
                wrong += re.findall(r"location\.reload", code)
        tables = path.name in ("registry.js", "questions.js")  # which are handed to part()
        for found in re.finditer(r"(?<!typeof )\bimport\(", code):
            alone = not code[: found.start()].rstrip().endswith("part(() =>")
            wrong += [f"{path.name}: {found}"] if alone and not tables else []
    assert wrong == []
