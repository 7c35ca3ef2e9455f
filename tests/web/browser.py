"""A real browser on a server of its own, for the tests of the pages."""

import asyncio
import contextlib
import os
import re
import shutil
from collections.abc import Awaitable, Callable, Iterator
from functools import cache
from importlib.metadata import distributions
from pathlib import Path
from typing import Any

from playwright._impl._sync_base import SyncBase
from playwright.sync_api import (
    Browser,
    Error,
    Page,
    ViewportSize,
    expect,
    sync_playwright,
)

from web.calculators import PATIENCE, TOKEN, Process, wait_for

#: A load case by its name or its place; None for the one that governs.
Case = str | int | None
#: A browser, and the server that it visits.
Calculator = tuple[Browser, Process]

#: After this long [ms] what a page was to show is taken to be missing.
_LONG = 120e3
STUDY = 1e3 * PATIENCE
#: All that a page requests of its server, but for the proof that it is the one.
REQUESTS = re.compile(r"/api/v1/(?!same/)")
#: Most time between two questions of a page, whether its server is there [ms].
LATER = 5_000
expect.set_options(timeout=_LONG)  # a busy machine is no fault of the page
#: After this long [s] any call into the browser is an error, also one that Playwright waits for
#: without a limit: what a page computes, a promise, a window that opens or closes.
LIMIT = PATIENCE + 20.0
_call = SyncBase._sync


def _call_within_limit(self: SyncBase, awaitable: Awaitable[Any]) -> Any:
    async def limited() -> Any:
        async with asyncio.timeout(LIMIT):
            return await awaitable

    try:
        return _call(self, limited())
    except TimeoutError:
        kind = type(self).__name__
        raise AssertionError(f"the browser gave no answer within {LIMIT:g} s ({kind})") from None


SyncBase._sync = _call_within_limit  # type: ignore[method-assign]
FLAGS = [
    "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
    "--disable-background-networking", "--disable-component-update", "--disable-sync",
    "--hide-scrollbars", "--force-color-profile=srgb",
]  # fmt: skip
#: What a page compiles ahead on other threads is seldom used: most visits are a few presses.
_BRIEF = "--js-flags=--single-threaded"
PAGES = ("drive", "compare", "across", "tests", "logs", "train", "events", "study", "report",
         "saved")  # fmt: skip
PHONE: ViewportSize = {"width": 390, "height": 844}
DESKTOP: ViewportSize = {"width": 1360, "height": 900}
#: What a page shows once everything it asked for has arrived.
READY = {
    "drive": "html:has(#more fieldset) #drive .screen[data-whole]",
    "compare": "#compare tbody tr",
    "across": "#across [data-stands=fresh] .list li",
    "tests": "#tests .drop",
    "logs": "#logs .drop",
    "train": "#train .screen[data-stands=fresh]",
    "events": "#events form",
    "study": "#study form",
    "report": "#report form",
    "saved": "#saved .scroll :is(table, p)",
}
#: Views whose whole answer is folded away.
FOLDED = ("train", "across", "events", "tests")
_NAMES = (
    "chromium-headless-shell", "chrome-headless-shell", "chromium", "chromium-browser",
    "google-chrome-stable", "google-chrome",
)  # fmt: skip
#: Answers that a test provokes, and that the browser then reports as errors.
_REFUSED = ("status of 422", "status of 409")

#: What is told in the corner stays until something else is: a busy machine reads it late.
_TOLD_LONG = """{
  const usual = window.setTimeout;
  const told = [6000, 12000];
  window.setTimeout = (f, wait, ...more) =>
    usual(f, told.includes(wait) ? 10 * wait : wait, ...more);
}"""
PAINTED = """() => new Promise((done) => {
  requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done)));
})"""
#: Times from a key press to the painted plot [ms], collected in `steps`.
STEPS = """() => {
  window.steps = [];
  let pressed = 0;
  addEventListener("keydown", (e) => { pressed = e.timeStamp; }, true);
  document.addEventListener("painted", () => {
    const from = pressed;
    requestAnimationFrame(() => {  // the message comes after the frame is painted
      const channel = new MessageChannel();
      channel.port1.onmessage = () => steps.push(performance.now() - from);
      channel.port2.postMessage(0);
    });
  });
}"""
#: What a finger misses, lower or narrower than 44 px with the margin that takes its touch too; not
#: what stands in a line of text (WCAG 2.5.8), nor curves, which are read where they are touched.
SMALL = """() => {
  const aim = "a[href], button, summary, select, textarea, .hit, [role=slider]:not(g),"
    + "label:has(:is([type=radio], [type=checkbox])),"
    + "input:not([type=hidden], [type=radio], [type=checkbox], #cursor)";
  const size = (e) => {
    const {width, height} = (e.closest(".rail .box") ?? e).getBoundingClientRect();
    const margin = getComputedStyle(e, "::after");
    return margin.position === "absolute" && margin.content !== "none"
      ? Math.min(parseFloat(margin.height), parseFloat(margin.width)) : Math.min(width, height);
  };
  const text = (e) => e.matches("a, .link") && e.closest("p, li, td, small, .help, footer");
  return [...document.querySelectorAll(aim)]
    .filter((e) => e.checkVisibility({visibilityProperty: true}))
    .filter((e) => !text(e) && !e.closest(".skip, .away"))
    .map((e) => [e.tagName, e.id || e.textContent.slice(0, 30), size(e)])
    .filter((e) => e[2] < 43.5);
}"""


def chromium() -> str:
    """Return the path of the browser; there are no tests of the pages without one."""
    found = os.environ.get("CHROMIUM") or next(filter(None, map(shutil.which, _NAMES)), None)
    assert found, "no chromium: `make system` installs it, or set CHROMIUM to its path"
    return found


@cache
def axe() -> str:
    """Return the source of axe-core, from whichever package carries it."""
    for package in distributions():
        for file in package.files or ():
            if file.name == "axe.min.js":
                return Path(str(file.locate())).read_text("utf-8")
    raise AssertionError("no package of the environment carries axe.min.js")


#: The tab that a page is under; that of saved designs is in the menu of files.
TABS = {
    **dict.fromkeys(("drive", "train", "across", "events"), "drive"),
    **dict.fromkeys(("compare", "study"), "choose"),
    "tests": "measure",
    "logs": "measure",
    "report": "report",
}


def unsigned(text: str) -> str:
    """Return the text of a cell without the sign of its level."""
    return re.sub("^[✓▲✕] ", "", text)


def unfold_plan(page: Page) -> None:
    """Open the form of lagging, rig and fit, which is folded where tests have its place."""
    page.locator("#tests .plan details").evaluate_all("all => all.forEach((e) => (e.open = true))")


def choose_test(page: Page, name: str) -> None:
    """Unfold what is said of a test file."""
    page.locator("#tests .rows-of").get_by_text(name, exact=True).click()


def ask_now(page: Page) -> None:
    """Have the server asked at once, unless the page has done so by itself meanwhile."""
    page.get_by_role("button", name="Calculate").evaluate_all("all => all.map((e) => e.click())")


def evaluated(page: Page, script: str, argument: Any = None) -> Any:
    """Evaluate what imports a module of the page, and may be done twice.

    Chromium now and then loses the promise of an import, so that it never comes to an end.
    """
    try:
        return page.evaluate(script, argument)
    except Error as error:
        if "garbage collected" not in str(error):
            raise
        return page.evaluate(script, argument)


def show_case(page: Page, case: Case = 0) -> None:
    """Look at a load case of a design on the page, if it has it: by its name or its place.

    None leaves the one that the page has chosen, which governs.
    """
    if case is not None and evaluated(page, SHOW_CASE, case):
        page.wait_for_selector("#drive .screen[data-stands=fresh]", state="attached")


#: Chooses a load case; on a page of one file by its chip, which leaves the focus where it is.
SHOW_CASE = """async (which) => {
  if (location.protocol === "file:") {
    const chips = [...document.querySelectorAll("#cases .chip")];
    const named = (e) => e.querySelector("span")?.textContent.split(":")[0] === which;
    const chip = typeof which === "number" ? chips[which] : chips.find(named);
    if (!chip || chip.getAttribute("aria-pressed") === "true") return false;
    chip.click();
    return true;
  }
  const { app, caseNames, look } = await import("/static/main.js");
  const names = caseNames(app.doc);
  const name = typeof which === "number" ? names[which] : which;
  if (!names.includes(name) || app.case === name) return false;
  look({ case: name });
  return true;
}"""


def turn(page: Page, name: str) -> None:
    """Go to a page, in two presses at most."""
    if name == "saved":
        page.click("#file > summary")
        page.get_by_role("button", name="saved designs").click()
        return
    at = page.locator(f"#nav-{name}")
    if not at.is_visible():
        page.click(f"#tab-{TABS[name]}")
    if at.count():
        at.click()


#: Windows that visits left, by what they set, each with an empty page: what that opens is of its
#: process, in which all that a page is made of is fetched and compiled already.
_LEFT: dict[tuple[Any, ...], Page] = {}
#: What a page may keep there; the next visitor finds nothing of it.
_KEPT = "cookies,local_storage,indexeddb,cache_storage"


class Visitor:
    """A page of the browser that remembers what went wrong on it.

    In a window that another visit has left, but `fresh` for who sets something in it.
    """

    def __init__(
        self,
        browser: Browser,
        address: str,
        size: ViewportSize = DESKTOP,
        *,
        told_long: bool = True,
        fresh: bool = False,
        **context: Any,
    ) -> None:
        # a page that moves by itself is painted without end, and a test has only to look at it
        context = {"reduced_motion": "reduce", **context}
        origin = "/".join(address.split("/")[:3])
        self._kind = None if fresh else (browser, origin, *size.values(), *context.items())
        left = _LEFT.pop(self._kind, None) if self._kind else None
        self.context = (
            left.context
            if left
            else browser.new_context(
                viewport=size, accept_downloads=True, locale="en-GB", **context
            )
        )
        self.context.set_default_timeout(_LONG)
        if told_long and not left:
            self.context.add_init_script(_TOLD_LONG)
        self.page: Page = self.context.new_page() if fresh else self._opened(left, origin)
        self.address = address
        self.wrong: list[str] = []
        self.elsewhere: list[str] = []
        self.page.on("console", lambda m: self._said(m.type, m.text))
        self.page.on("pageerror", lambda e: self.wrong.append(str(e)))
        self.page.on("request", lambda r: self._asked(r.url))
        self.page.on("dialog", lambda d: d.accept())

    def _opened(self, left: Page | None, origin: str) -> Page:
        self._empty = left or self.context.new_page()
        if left:
            session = self.context.new_cdp_session(left)
            session.send("Storage.clearDataForOrigin", {"origin": origin, "storageTypes": _KEPT})
            session.detach()
        else:
            file = Path(__file__).as_uri()
            self._empty.goto(file if origin == "file://" else f"{origin}/static/icon.svg")
        with self._empty.expect_popup() as opened:
            self._empty.evaluate("void open('about:blank')")
        return opened.value

    def _said(self, kind: str, text: str) -> None:
        if kind in ("error", "warning") and not any(known in text for known in _REFUSED):
            self.wrong.append(text)

    def _asked(self, url: str) -> None:
        if not url.startswith((self.address, "blob:", "data:")):
            self.elsewhere.append(url)

    def close(self) -> None:
        """Go away; an answer that a test still holds back is for nobody then."""
        if not self.page.is_closed():
            self.page.unroute_all(behavior="ignoreErrors")
        self.context.unroute_all(behavior="ignoreErrors")
        if not self._kind:
            self.context.close()
            return
        for page in self.context.pages:
            if page != self._empty:
                page.close()
        _LEFT[self._kind] = self._empty

    def open(self, name: str = "drive", *, unfold: bool | None = None, case: Case = 0) -> Page:
        """Go to a page as a user does, and wait until it shows what it has to.

        What is folded away of the drive is unfolded if that is where to go, or if told so. Of the
        drive to begin with the load case `case` is looked at.
        """
        if self.page.url == "about:blank":
            page, mark, design = self.address.partition("#")
            self.page.goto(f"{page}?token={TOKEN}{mark}{design}")
            self.page.wait_for_selector(READY["drive"])
            show_case(self.page, case)
            if name == "drive" if unfold is None else unfold:
                self.unfold()
        if not self.page.locator(f"#{name}").is_visible():
            turn(self.page, name)
        self.page.wait_for_selector(READY[name])
        if name == "events":
            self.page.evaluate("document.querySelector('#events .more:has(#e-points)').open = true")
        if name in FOLDED and unfold is not False:
            self.page.evaluate(
                "name => document.getElementById(`${name}-details`).open = true", name
            )
        return self.page

    def unfold(self) -> None:
        """Open what is folded away of the drive: more inputs, and the details of the answer."""
        self.page.evaluate(
            "for (const id of ['more', 'details']) document.getElementById(id).open = true"
        )
        self.page.wait_for_selector("#details .details")

    def anew(self, opening: Callable[[], None], case: Case = 0) -> None:
        """Open a design in some way, wait until it is there, and look at a load case of it."""
        opened = "import('/static/main.js').then((m) => m.app.opened)"
        before = evaluated(self.page, opened)
        opening()
        wait_for(lambda: evaluated(self.page, opened) > before)
        show_case(self.page, case)

    def example(self, title: str, case: Case = 0) -> None:
        """Open an example from the menu, which comes from the server, and look at a load case."""

        def chosen() -> None:
            self.page.click("#file > summary")
            self.page.get_by_role("button", name=title, exact=True).click()

        self.anew(chosen, case)

    def load(self, file: Path) -> None:
        """Open a file from the menu."""
        with self.page.expect_file_chooser() as asked:
            self.page.click("#file > summary")
            self.page.get_by_role("button", name="Open a drive or lagging file").click()
        asked.value.set_files(file)

    def solved(self) -> None:
        """Wait until everything is solved anew."""
        self.page.wait_for_selector("html:not(.stale) #drive .screen[data-whole]", state="attached")

    def alone(self) -> None:
        """Wait until the page can solve and judge without the server."""
        self.page.wait_for_function("() => performance.getEntriesByName('own').length > 0")
        evaluated(self.page, "import('/static/pages/drive/judging.js').then((m) => m.ready)")

    def painted(self) -> None:
        """Wait until what was changed has been laid out and painted."""
        self.page.evaluate(PAINTED)


@contextlib.contextmanager
def browser(*, brief: bool = True) -> Iterator[Browser]:
    """Run a browser for a while, for brief visits or as people have it."""
    with sync_playwright() as tool:
        flags = [*FLAGS, _BRIEF] if brief else FLAGS
        found = tool.chromium.launch(executable_path=chromium(), args=flags)
        try:
            yield found
        finally:
            found.close()
