"""How what stands on a page stands to what is asked: nothing of before passes for the present.

Expected of every page: an answer is marked fresh only if it is of the drive as it is typed, and no
verdict is given (no OK, no green) of one that is not.
"""

import contextlib
import re
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from playwright.sync_api import Error, Page, Route, ViewportSize, expect

from web.browser import (
    DESKTOP,
    PAGES,
    PHONE,
    REQUESTS,
    STUDY,
    Calculator,
    Case,
    Visitor,
    evaluated,
    turn,
    unfold_plan,
)
from web.calculators import document, wait_for
from wraparc.cli.demo import examples_folder

NARROW: ViewportSize = {"width": 1024, "height": 900}
#: Pages that answer by themselves as the drive changes.
ANSWERING = ("drive", "compare", "across", "train")
#: Marks of their own answer: it stands in the frame of a drive and in what is below that.
MARKS = {"drive": 2, "across": 2, "train": 2}


@pytest.fixture
def guest(calculator: Calculator) -> Iterator[Visitor]:
    """One whose page may complain: its server is taken away."""
    found = Visitor(calculator[0], calculator[1].address, told_long=False, fresh=True)
    found.page.clock.install()
    yield found
    found.close()


def take(page: Page, doc: dict[str, Any], case: Case = 0) -> None:
    """Put a design on the page, and look at a load case: the first, or None for what governs."""
    evaluated(page, TAKE, [doc, case])


TAKE = """([doc, which]) => import('/static/main.js').then((m) => {
  m.take(doc);
  const names = m.caseNames(doc);
  const name = typeof which === "number" ? names[which] : which;
  if (names.includes(name) && names.length > 1) m.look({ case: name });
})"""


def tandem(visitor: Visitor) -> Page:
    """Open a drive of two pulleys, and every page of it."""
    page = visitor.open("drive")
    doc = document("tandem-fabric")
    take(page, doc)
    for name in PAGES:
        visitor.open(name)
    for name in ANSWERING:
        turn(page, name)
        expect(page.locator(f"#{name} [data-stands]").first).to_have_attribute(
            "data-stands", "fresh"
        )
    return page


def stands(page: Page, name: str) -> list[str]:
    turn(page, name)
    return _marks(page, name)


def _marks(page: Page, name: str) -> list[str]:
    # all at once: a mark may go while it is asked for
    marks = page.locator(f"#{name} [data-stands]:visible")
    found: list[str] = marks.evaluate_all("(all) => all.map((mark) => mark.dataset.stands)")
    return found


def come_to(page: Page, name: str, right: Callable[[list[str]], bool]) -> None:
    """Go to a page and wait until its answers stand so: it is drawn by itself, not by going."""
    turn(page, name)
    wait_for(lambda: right(_marks(page, name)))


def computed(marks: list[str]) -> bool:
    return "computing" not in marks


def _count_fresh(count: int) -> Callable[[list[str]], bool]:
    return lambda marks: marks.count("fresh") == count


def judged(page: Page, name: str) -> list[str]:
    """Verdicts of answers that a page gives, by their words."""
    boxes = page.locator(f"#{name} [data-stands] .verdict:visible:not([role=status])")
    return [box.inner_text() for box in boxes.all() if box.locator(".badge").count()]


#: What of the answers of a page, fresh or not, is said to be good: in green, or by the word.
_PRAISE = """([name, fresh]) => {
  const probe = document.createElement("i");
  probe.style.color = "var(--good)";
  document.body.append(probe);
  const green = getComputedStyle(probe).color;
  probe.remove();
  const own = (e) => [...e.childNodes].filter((n) => n.nodeType === 3).map((n) => n.data).join("");
  const praised = (e) => {
    const { color, borderLeftColor, borderLeftWidth, fill } = getComputedStyle(e);
    return /\\bOK\\b/.test(own(e)) || (color === green && own(e).trim()) ||
      (e instanceof SVGElement && fill === green) ||
      (borderLeftColor === green && parseFloat(borderLeftWidth) > 0 && e.matches(".verdict"));
  };
  const all = document.querySelectorAll(`#${name} [data-stands], #${name} [data-stands] *`);
  const asked = (e) => (e.closest("[data-stands]").dataset.stands === "fresh") === fresh;
  return [...all].filter((e) => e.checkVisibility() && asked(e) && praised(e))
    .map((e) => e.textContent);
}"""


def praised(page: Page, name: str, *, fresh: bool = False) -> list[str]:
    turn(page, name)
    found: list[str] = page.evaluate(_PRAISE, [name, fresh])
    return found


def _questions(page: Page) -> None:
    # one at a time: the last stays open
    page.get_by_role("button", name="Which input gives …?").click()
    page.fill("#seek-value", "5 mm")
    page.keyboard.press("Enter")
    page.locator("[data-stands] button:has-text('Use ')").first.wait_for()
    for name, section in (
        ("On site: what to measure, when to alarm", "site"),
        ("Which design has the lowest cost?", "choosing"),
        ("What if … wet, worn, bare?", "what-if"),
    ):
        page.get_by_role("button", name=name).click()
        page.locator(f".{section} h2").wait_for()
        if section == "choosing":
            page.locator(".choosing").get_by_role("button", name="Calculate").click()
        page.locator(f".{section} [data-stands] table").first.wait_for()


def _thicknesses(page: Page) -> None:
    page.click("#ask-thickness")
    page.locator("#question-thickness [data-stands] table").wait_for()


def _fit(page: Page) -> None:
    folder = examples_folder() / "shear_tests"
    names = ("0034kPa-1.csv", "0069kPa-2.csv", "0207kPa-1.csv", "0276kPa-1.TRA")
    page.set_input_files("#test-files", [folder / f"dry-{name}" for name in names])
    page.wait_for_selector("text=4 tests")
    page.get_by_role("button", name="Fit the lagging").click()
    page.locator("#fitted [data-stands]").wait_for()


def _study(page: Page) -> None:
    page.locator("#study").get_by_label("Samples").fill("64")
    page.get_by_role("button", name="Start the study").click()
    page.locator("#study .job [data-stands] table").first.wait_for(timeout=STUDY)


def _match(page: Page) -> None:
    page.get_by_role("button", name="Find the trim limits").click()
    expect(page.locator("#train [data-stands]")).to_have_count(3)


def _follow(page: Page) -> None:
    page.select_option("#e-points", "30")
    page.click("#follow")
    page.locator("#events [data-stands] table").first.wait_for(timeout=STUDY)
    page.get_by_role("button", name="Plot Te against run-out").click()
    page.locator("#events figure [data-stands] img").wait_for(timeout=STUDY)


def _typed(place: str, text: str) -> Callable[[Page], None]:
    def typed(page: Page) -> None:
        page.fill(place, text)
        page.locator(place).blur()

    return typed


def _finer(page: Page) -> None:
    page.select_option("#e-points", "120")


Step = Callable[[Page], None]


#: What is asked on a page besides what it answers by itself, how many answers stand there then,
#: and how something else is asked on the page itself.
def _thicker(page: Page) -> None:
    unfold_plan(page)
    _typed("#t-lagging-thickness", "15 mm")(page)


ASKED: dict[str, dict[str, tuple[Step | None, int, Step | None]]] = {
    "head-drive-fabric": {
        "drive": (_questions, 3, _typed(".what-if input >> nth=0", "0.8")),
        "compare": (None, 1, None),
        "across": (_thicknesses, 3, _typed("#ask-thicknesses", "10 mm, 14 mm")),
        "tests": (_fit, 2, _thicker),
        "study": (_study, 1, _typed("#study input[type=text] >> nth=1", "65")),
    },
    "tandem-fabric": {
        "train": (_match, 3, None),
        "events": (_follow, 3, _finer),
    },
}


@pytest.mark.parametrize("drive", ASKED)
def test_whatever_was_asked_nothing_of_it_is_good_once_it_is_of_before(
    guest: Visitor, drive: str
) -> None:
    page = guest.open("drive")
    doc = document(drive)
    for event in doc.get("motion", {}).get("event", ()):
        event["duration"] = "3 s"
    take(page, doc)
    asked = ASKED[drive]
    for name, (ask, count, _) in asked.items():
        guest.open(name)
        if name in ANSWERING:
            own = ["fresh"] * MARKS.get(name, 1)
            come_to(page, name, own.__eq__)
        if ask:
            ask(page)
        come_to(page, name, (["fresh"] * count).__eq__)
        assert praised(page, name) == []
    assert any(praised(page, name, fresh=True) for name in asked)
    for name, (_, count, other) in asked.items():
        if other:  # asked for something else on the page itself: one answer is of before
            turn(page, name)
            other(page)
            come_to(page, name, computed)
            found = stands(page, name)
            n = 2 if name in ("events", "tests") else 1  # in the frame, too
            assert sorted(found) == ["fresh"] * (count - n) + ["stale"] * n, (name, found)
            assert praised(page, name) == [], name
    for width in ("wide", "1399"):
        turn(page, "drive")
        page.fill("#f-belt-width", width)
        page.locator("#f-belt-width").blur()
        for name in asked:
            anew = MARKS.get(name, 1) if name in ANSWERING and width != "wide" else 0
            come_to(page, name, _count_fresh(anew))
            come_to(page, name, computed)
            assert stands(page, name).count("fresh") == anew
            assert praised(page, name) == [], (name, width)


def test_no_page_gives_a_verdict_of_another_drive_or_one_that_has_not_come(guest: Visitor) -> None:
    page = tandem(guest)
    assert judged(page, "train")  # there is one to be taken back
    turn(page, "drive")
    page.fill("#f-belt-width", "wide")
    page.wait_for_selector("#f-belt-width[aria-invalid=true]")
    for name in PAGES:
        come_to(page, name, computed)
        assert "fresh" not in stands(page, name), name
        assert judged(page, name) == [], name
        if name == "train":
            expect(page.locator("#train .say [role=alert] .reasons")).to_be_visible()
            expect(page.locator("#train")).to_contain_text("Inputs changed")
    turn(page, "drive")
    page.fill("#f-belt-width", "1400")
    for name in ANSWERING:
        come_to(page, name, lambda marks: set(marks) == {"fresh"})
        wait_for(lambda name=name: name == "compare" or judged(page, name))
    # none comes, and then the server is gone
    held: list[Route] = []
    page.route(REQUESTS, lambda route: held.append(route))  # noqa: PLW0108
    turn(page, "drive")
    page.fill("#f-belt-width", "1410")
    for name in PAGES:
        found = stands(page, name)
        assert set(found) <= {"computing"}, (name, found)
        assert judged(page, name) == [], name
    page.route("**/api/v1/**", lambda route: route.abort())
    for route in held:
        with contextlib.suppress(Error):  # what the page has given up meanwhile
            route.abort()
    turn(page, "drive")
    page.fill("#f-belt-width", "1420")
    for name in PAGES:
        found = stands(page, name)
        assert set(found) <= {"gone", "computing"}, (name, found)
        assert judged(page, name) == [], name
    for name in ANSWERING:
        come_to(page, name, lambda marks: set(marks) == {"gone"})
    expect(page.locator(".gone[role=alert]")).to_have_count(1)
    page.unroute_all(behavior="ignoreErrors")


def test_nothing_of_a_drive_stands_under_the_name_of_the_next(guest: Visitor) -> None:
    page = tandem(guest)
    turn(page, "drive")
    held: list[Route] = []

    def first_arcs() -> list[Route]:
        assert page.evaluate("1") == 1  # lets what has come be seen
        return [route for route in held if "solve/fast" in route.request.url]

    page.route(REQUESTS, lambda route: held.append(route))  # noqa: PLW0108
    # what was asked of the drive before is answered when the next is open
    page.fill("#f-belt-width", "1250")
    wait_for(first_arcs)
    take(page, document("tandem-steel-cord"))
    (first,) = first_arcs()
    held.remove(first)
    first.fulfill(response=first.fetch())
    wait_for(first_arcs)  # the page has taken the answer, and asks for its own
    for name in ("drive", *ANSWERING):
        turn(page, name)
        found = page.inner_text(f"#{name}")
        assert not re.search(r"\d k?[NW]\b", found), name  # nothing is known of this one yet
        assert judged(page, name) == [], name
        assert page.locator(f"#{name} svg.chain, #{name} .map").count() == 0, name
    page.unroute_all(behavior="ignoreErrors")


def test_a_load_case_that_cannot_be_solved_is_named(visitor: Visitor) -> None:
    # T1 of the load that all share is cleared: the other load cases give their own and are solved
    page = visitor.open("drive")
    visitor.solved()
    page.fill("#f-pulley-0-entry_tension", "")
    told = page.locator("#verdict")
    expect(told.locator("p")).to_have_text("Missing: Entry tension (design).")
    expect(page.locator(".governing .verdict.good")).to_have_count(0)
    assert "OK" not in page.locator(".governing .headline").first.inner_text()
    page.fill("#f-pulley-0-entry_tension", "150")
    expect(told).not_to_contain_text("Missing")
    visitor.solved()


def test_buttons_that_do_nothing_look_so(visitor: Visitor) -> None:
    page = visitor.open("drive")
    take(page, document("tandem-fabric"))
    visitor.open("train")
    held: list[Route] = []
    page.route("**/api/v1/train", lambda route: held.append(route))  # noqa: PLW0108
    main = page.locator("#train .act button")
    main.click()
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
    page.unroute_all(behavior="ignoreErrors")


def test_what_takes_long_says_so_and_can_be_ended(guest: Visitor) -> None:
    page = guest.open("drive")
    take(page, document("tandem-fabric"))
    guest.open("train")
    ended: list[str] = []
    page.on("requestfailed", lambda r: ended.append(r.url))
    held: list[str] = []

    def hold(route: Route) -> None:  # a server at work: it answers who asks whether it is there
        if "/same/" in route.request.url:
            route.continue_()
        else:
            held.append(route.request.url)

    page.route("**/api/v1/**", hold)
    page.get_by_role("button", name="Find the trim limits").click()
    wait_for(lambda: page.evaluate("1") and held)
    toast, work = page.locator("#toast"), page.locator("footer #work")
    for seconds in (3, 9, 30):
        page.clock.run_for(1000)

        def told(seconds: int = seconds) -> bool:
            found = re.search(r"Calculating for (\d+) s", work.inner_text())
            if found and int(found[1]) >= seconds:
                return True
            page.clock.run_for(1000)
            return False

        wait_for(told)
        expect(page.locator(".gone")).to_have_count(0)  # it is at work, and not gone
    work.get_by_role("button", name="Cancel").click()
    wait_for(lambda: page.evaluate("1") and any(url.endswith("/train") for url in ended))
    expect(toast).to_have_text("Cancelled.")
    expect(page.locator(".gone")).to_have_count(0)
    expect(page.get_by_role("button", name="Find the trim limits")).to_be_enabled()
    page.unroute_all(behavior="ignoreErrors")


def test_a_long_title_widens_no_page(visitor: Visitor) -> None:
    # 300 are more than a drive file may have: refused, they stand on the page nevertheless
    page = visitor.open("drive")
    for name in PAGES:
        visitor.open(name)
    for title, names in (("W" * 200, PAGES), ("W" * 300, ("drive", "saved"))):
        take(page, {**document(), "title": title})
        for name in names:
            page.set_viewport_size(DESKTOP)
            turn(page, name)
            if name == "drive":
                expect(page.locator("#title")).to_have_text(title)
            for size in (DESKTOP, NARROW, PHONE):
                page.set_viewport_size(size)
                visitor.painted()
                widths = page.evaluate("[document.documentElement.scrollWidth, innerWidth]")
                assert widths[0] <= widths[1], (name, size)
