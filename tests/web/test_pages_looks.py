"""How the pages look and read: accessibility, keyboard, phone, paper, and the docs' pictures.

The pictures of the documentation are made here. To renew them:
``WRAPARC_SCREENS=docs/_static/screens python -m pytest -n 0 tests/web/test_pages_looks.py``
"""

import io
import os
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from PIL import Image
from playwright.sync_api import Browser, FloatRect, Page, expect

from web.browser import DESKTOP, PAGES, PHONE, READY, SMALL, STUDY, Calculator, Visitor, axe
from web.calculators import document, wait_for
from web.test_standing import take

#: How much of each page is shown in the documentation.
HEIGHTS = {
    "drive": 930, "compare": 560, "across": 1240, "tests": 1560, "logs": 930, "train": 1050,
    "events": 1560, "study": 1180, "report": 560, "saved": 440,
}  # fmt: skip
#: Where pictures are kept, if that is asked for.
KEPT = os.environ.get("WRAPARC_SCREENS")
TAGS = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa"]


@pytest.fixture(scope="module")
def desktop(calculator: Calculator) -> Iterator[Visitor]:
    """One visit to all pages, each left as a user would leave it."""
    visitor = Visitor(*_at(calculator), DESKTOP)
    visitor.open("drive")
    yield visitor
    visitor.close()


@pytest.fixture(scope="module")
def phone(calculator: Calculator) -> Iterator[Visitor]:
    """One visit to all pages by telephone."""
    visitor = Visitor(*_at(calculator), PHONE, has_touch=True, is_mobile=True)
    visitor.open("drive")
    yield visitor
    visitor.close()


def _at(calculator: Calculator) -> tuple[Browser, str]:
    return calculator[0], calculator[1].address


#: The drive to begin with.
HEAD = "Head drive, ROM conveyor"


def used(visitor: Visitor, name: str) -> Page:
    """Open a page and use it, so that all of its parts show."""
    tandem = "Tandem head drive, fabric belt"
    examples = {
        "train": tandem,
        "events": tandem if KEPT else "",
        "study": HEAD,
        "across": "Worn head drive, ROM conveyor",
    }
    if name in examples:
        page = visitor.open("drive")
        if examples[name]:
            visitor.example(examples[name])
        else:  # no start as long as the one that is shown
            doc = document("tandem-fabric")
            doc["motion"]["event"] = [{**doc["motion"]["event"][0], "duration": "8 s"}]
            take(page, doc)
    page = visitor.open(name)
    if name == "drive":
        visitor.solved()
    elif name == "tests":
        page.get_by_role("button", name="made-up tests").click()
        page.wait_for_selector("#tests .rows-of li")
        page.get_by_role("button", name="Fit the lagging").click()
        page.get_by_role("button", name="Apply to drive").wait_for()
    elif name == "across":
        page.wait_for_selector("#across .t-shares")
    elif name == "train":
        page.wait_for_selector("#train .tables table:visible")
    elif name == "events":
        page.select_option("#e-points", "30")
        page.click("#follow")
        page.wait_for_selector("#play")
        page.locator("#play-time").fill("5.6")
    elif name == "saved" and page.locator("#saved tbody tr", has_text=HEAD).count() == 0:
        page.get_by_label("Note on this version").fill("as tendered")
        page.get_by_role("button", name="Save as a new design").click()
        page.wait_for_selector("#saved tbody tr")
    elif name == "study":
        page.get_by_label("Samples").fill("128")
        page.get_by_role("button", name="Start the study").click()
        image = page.locator("#study .job img").first
        image.wait_for(timeout=STUDY)
        wait_for(lambda: image.evaluate("(e) => e.naturalWidth") > 100)
    expect(page.locator("[aria-busy=true]")).to_have_count(0)  # what is at work is dimmed
    visitor.painted()
    return page


def keep(shot: bytes, name: str) -> None:
    """Keep a picture for the documentation, with few colours, if that is asked for."""
    picture = Image.open(io.BytesIO(shot)).convert("RGB")
    assert len(picture.getcolors(1_000_000) or ()) > 20, "a blank page"
    if KEPT:
        Path(KEPT).mkdir(parents=True, exist_ok=True)
        few = picture.quantize(255, dither=Image.Dither.NONE)
        few.save(Path(KEPT) / f"{name}.png", optimize=True)


#: All rules but that of contrast where `colours` are not asked for, otherwise those that judge by
#: colours, of one text of each kind: what has the same style, in what has the same backgrounds,
#: reads the same, and most of the time goes into cells of tables. Only what is wrong is described.
_CHECK = """([tags, colours]) => {
  const known = new Map();
  const kind = (e) => {
    if (!e) return "";
    if (!known.has(e)) {
      const { backgroundColor, backgroundImage, opacity } = getComputedStyle(e);
      const own = [e.tagName, e.getAttribute("class"), backgroundColor, backgroundImage, opacity];
      known.set(e, `${kind(e.parentElement)}/${own}`);
    }
    return known.get(e);
  };
  const texts = new Map();
  for (const e of colours ? document.body.querySelectorAll("*") : []) {
    const own = [...e.childNodes].some((n) => n.nodeType === 3 && n.data.trim());
    if (!(own || e.matches("input, select, textarea")) || !e.checkVisibility()) continue;
    const { color, fontSize, fontWeight, textShadow } = getComputedStyle(e);
    const all = `${kind(e)} ${color} ${fontSize} ${fontWeight} ${textShadow}`;
    if (!texts.has(all)) texts.set(all, e);
  }
  return axe.run(colours ? { include: [...texts.values()] } : document, {
    runOnly: colours ? ["color-contrast", "link-in-text-block"] : tags,
    rules: colours ? {} : { "color-contrast": { enabled: false } },
    resultTypes: ["violations"],
    selectors: false,
  });
}"""


def violations(page: Page) -> list[str]:
    """Return what is wrong with a page as it is, and with its colours in the light and the dark."""
    if not page.evaluate("() => 'axe' in window"):
        page.evaluate(f"() => {{ {axe()} }}")
    found = _violations(page, colours=False) + _violations(page, colours=True)
    page.emulate_media(color_scheme="dark")
    found += [f"dark: {violation}" for violation in _violations(page, colours=True)]
    page.emulate_media(color_scheme="light")
    return found


def _violations(page: Page, *, colours: bool) -> list[str]:
    found: dict[str, Any] = page.evaluate(_CHECK, [TAGS, colours])
    assert found["passes"], "axe looked at nothing"
    return [
        f"{v['id']}: {v['help']}: {[n['html'][:160] for n in v['nodes'][:3]]}"
        for v in found["violations"]
    ]


@pytest.mark.parametrize("name", PAGES)
def test_no_violation_of_wcag_and_a_picture_for_the_docs(desktop: Visitor, name: str) -> None:
    page = used(desktop, name)
    page.evaluate("document.querySelectorAll('#main details').forEach((d) => { d.open = true; })")
    assert violations(page) == []
    page.evaluate("document.querySelectorAll('main .more').forEach((d) => { d.open = false; })")
    page.evaluate("scrollTo(0, 0)")
    page.evaluate("document.getElementById('toast').replaceChildren()")
    part: FloatRect = {"x": 0, "y": 0, "width": DESKTOP["width"], "height": HEIGHTS[name]}
    keep(page.screenshot(full_page=True, clip=part), name)


def test_axe_finds_what_is_wrong(desktop: Visitor) -> None:
    # the check itself: a field without a label is found, and words that only the dark hides
    page = desktop.open("saved")
    page.evaluate("""() => {
      const hidden = document.createElement("p");
      hidden.append("dark on dark");
      hidden.style.color = "#171e26";
      document.querySelector("#saved").append(document.createElement("input"), hidden);
    }""")
    found = [violation.partition(":")[0] for violation in violations(page)]
    assert found == ["label", "dark"]
    page.evaluate(
        "document.querySelectorAll('#saved > :is(input, p:last-child)').forEach((e) => e.remove())"
    )


def test_dark_page_stays_light_on_paper(visitor: Visitor) -> None:
    page = visitor.open("saved")
    shade = "getComputedStyle(document.documentElement).getPropertyValue('--paper')"
    page.emulate_media(color_scheme="dark")
    assert page.evaluate(shade) == "#171e26"
    page.emulate_media(media="print")
    assert page.evaluate(shade) == "#fff"


@pytest.mark.parametrize("name", PAGES)
def test_phone_shows_everything_without_scrolling_sideways(phone: Visitor, name: str) -> None:
    page = phone.open(name)
    phone.painted()
    assert page.evaluate("document.documentElement.scrollWidth") == PHONE["width"]
    assert page.evaluate(SMALL) == []
    if name == "drive":
        keep(page.screenshot(), "phone")


def test_a_load_case_is_one_sheet_of_paper(visitor: Visitor) -> None:
    page = visitor.open("drive", unfold=False)
    visitor.alone()
    page.wait_for_selector(".ways li")
    for case in ("design", "start"):
        page.locator("#cases").get_by_role("button", name=case).click()
        visitor.solved()
        for paper in ("A4", "Letter"):
            data = page.pdf(format=paper, prefer_css_page_size=False)
            assert len(re.findall(rb"/Type\s*/Page\b", data)) == 1, (case, paper)


#: What of a sheet of paper still looks like a box to type in, and how many verdicts are read there.
ON_PAPER = """() => {
  const seen = (e) => e.checkVisibility();
  const boxes = [...document.querySelectorAll("#drive :is(input, select, textarea, .box)")];
  const framed = boxes.filter(seen).filter((e) => {
    const { borderTopWidth, backgroundColor } = getComputedStyle(e);
    return parseFloat(borderTopWidth) > 0 || !/, 0\\)$|transparent/.test(backgroundColor);
  });
  const said = [...document.querySelectorAll("#drive :is(.say p, .headline)")].filter(seen);
  const empty = boxes.filter(seen).filter((e) => e.matches("input.amount"))
    .filter((e) => !e.value && !e.placeholder);
  return [framed.map((e) => e.id || e.className), said.length, empty.map((e) => e.id)];
}"""


def test_paper_has_inputs_as_text_and_one_verdict(visitor: Visitor) -> None:
    page = visitor.open("drive")
    visitor.solved()
    page.emulate_media(media="print")
    assert page.evaluate(ON_PAPER) == [[], 1, []]
    page.emulate_media(media="screen")


def test_print_fits_the_paper(visitor: Visitor) -> None:
    page = visitor.open("drive")
    visitor.solved()
    for paper in ("A4", "Letter"):
        data = page.pdf(format=paper, prefer_css_page_size=False)
        pages = len(re.findall(rb"/Type\s*/Page\b", data))
        assert 2 <= pages <= 6, pages  # the first screen, and all the details unfolded
    # inputs and their sources stand on paper even where they are folded away on the screen
    assert page.locator("#drive details.t-inputs[open]").count() == 0
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    assert page.locator("#drive details.t-inputs[open]").count() == 1
    page.emulate_media(media="print")
    for width in (794, 816):  # of A4 and Letter
        page.set_viewport_size({"width": width - 91, "height": 1000})  # less margins, 12 mm each
        visitor.painted()
        assert page.evaluate("document.documentElement.scrollWidth") <= width - 91
        assert not page.locator("header").is_visible()
        assert page.locator("svg.stage").is_visible()


def test_keyboard_alone_reaches_and_works_everything(calculator: Calculator) -> None:
    visitor = Visitor(*_at(calculator))
    page = visitor.open("drive", unfold=False)
    page.keyboard.press("Tab")
    assert page.evaluate("document.activeElement.className") == "skip"
    seen: list[str] = []
    for _ in range(60):
        page.keyboard.press("Tab")
        seen.append(
            page.evaluate(
                "document.activeElement.id || document.activeElement.getAttribute('aria-label')"
                " || document.activeElement.parentElement.id"
            )
        )
    for wanted in (
        "tab-drive",
        "tab-measure",
        "nav-train",
        "file",
        "tab-report",
        "f-belt-preset",
        "f-belt-width",
    ):
        assert wanted in seen, wanted
    assert {"Tight-side tension T1", "Slack-side tension T2", "Wrap angle"} < set(seen)
    # help is out of the order, and a key of its field
    assert [stop for stop in seen if "Help" in str(stop)] == []
    for field in ("#f-belt-width", "#f-pulley-0-lagging"):
        page.locator(field).focus()
        page.keyboard.press("F1")
        expect(page.locator(f"{field}-h")).to_be_visible()
        page.keyboard.press("F1")
        expect(page.locator(f"{field}-h")).to_be_hidden()
    page.locator("#file > summary").focus()
    page.keyboard.press("Enter")
    expect(page.get_by_role("button", name="Download the drive file")).to_be_visible()
    page.keyboard.press("Escape")
    expect(page.get_by_role("button", name="Download the drive file")).to_be_hidden()
    assert page.evaluate("document.activeElement.parentElement.id") == "file"
    page.locator("#tab-choose").focus()
    page.keyboard.press("Enter")
    page.wait_for_selector(READY["compare"])
    page.locator("#sort-creep_limit_margin").focus()
    page.keyboard.press("Enter")
    assert page.evaluate("document.activeElement.id") == "sort-creep_limit_margin"
    visitor.close()


def test_the_verdict_of_a_phone_leads_to_what_is_worse(visitor: Visitor) -> None:
    # the design case is OK where it carries little; the start case is not
    page = visitor.open("drive", unfold=False)
    page.set_viewport_size({"width": 390, "height": 844})
    page.fill("#f-pulley-0-entry_tension", "80")
    said = page.locator("#verdict")
    said.get_by_role("button", name="start").click()
    expect(page.locator("#cases [aria-pressed=true]")).to_contain_text("start")


def test_the_views_of_a_phone_stand_above_the_load_cases(visitor: Visitor) -> None:
    # as on a wide screen: what is looked at first, then in which case
    page = visitor.open("drive", unfold=False)
    page.set_viewport_size({"width": 390, "height": 844})
    views, chips = (page.locator(f"#drive .{name}").bounding_box() for name in ("views", "chips"))
    assert views is not None
    assert chips is not None
    assert views["y"] + views["height"] <= chips["y"]
    assert page.evaluate("document.documentElement.scrollWidth") == 390
