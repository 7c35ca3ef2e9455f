"""The card of the first screen: the verdict on the whole drive, and nothing green on less."""

import re
import tomllib
from pathlib import Path

import pytest
from playwright.sync_api import Page, Route, expect

from web.browser import Visitor, ask_now, turn
from web.test_standing import take
from wraparc.answer.words import format_verdict
from wraparc.arc import solve
from wraparc.checks import Level, Verdict, judge
from wraparc.drive import Drive
from wraparc.units import in_units
from wraparc.web.answers.documents import read

EXAMPLES = Path(__file__).parents[2] / "examples"
HEAD = (EXAMPLES / "head-drive-fabric.toml").read_text("utf-8")
#: It never runs wet, and its load case start is the only one that is missed.
COVERED = "covered = true\n" + HEAD.replace('"60 kN"', '"95 kN"', 1)
CLASSES = {Level.OK: "good", Level.ATTENTION: "warn", Level.FAILS: "bad"}


def opened(visitor: Visitor, text: str) -> Page:
    page = visitor.open("drive", unfold=False)
    take(page, tomllib.loads(text))
    visitor.solved()
    return page


def judged(text: str) -> Verdict:
    drive = read(tomllib.loads(text))
    assert isinstance(drive, Drive)
    return judge(solve(drive, raise_on_failure=False))


def without_colour(page: Page) -> None:
    expect(page.locator("#verdict")).to_have_class(re.compile(r"^say\s*$"))


def test_sentence_is_of_the_load_case_that_governs(long_visit: Visitor) -> None:
    # expected: the verdict of the program on the whole drive, whichever load case is looked at
    page = opened(long_visit, COVERED)
    verdict = judged(COVERED)
    assert verdict.within("design").level is verdict.within("empty").level is Level.OK
    text = in_units(format_verdict(verdict, verdict.full).text, "si")
    assert text.endswith("(head, start).")
    said = page.locator("#verdict")
    for case in ("design", "empty", "start"):
        page.locator("#cases").get_by_role("button", name=case).click()
        expect(page.locator("#cases [aria-pressed=true]")).to_contain_text(case)
        expect(said.locator("p")).to_have_text(f"ATTENTION: {text}")
        expect(said).to_have_class(re.compile("warn"))
    page.locator("#cases").get_by_role("button", name="empty").click()
    said.get_by_role("button", name="start").click()
    expect(page.locator("#cases [aria-pressed=true]")).to_contain_text("start")
    expect(said.locator(".line").filter(has_text="Governing")).to_have_count(0)


def test_a_chip_has_level_and_highest_use_of_its_own_case(long_visit: Visitor) -> None:
    # expected: the checks of the program in each load case
    text = HEAD.replace('"60 kN"', '"40 kN"', 1)
    page = opened(long_visit, text)
    verdict = judged(text)
    for case in ("design", "empty", "start"):
        own = verdict.within(case)
        used = max(c.share if c.at_most else 1 / c.share for c in own.listed if c.share == c.share)
        chip = page.locator("#cases").get_by_role("button", name=case)
        expect(chip.locator("svg")).to_have_class(f"g {CLASSES[own.level]}")
        expect(chip.locator("i")).to_have_class(CLASSES[own.level])
        shown = float((chip.locator("i").text_content() or "").split()[0])
        assert shown == pytest.approx(100 * used, rel=6e-3)


@pytest.mark.parametrize("name", ["uphill-conveyor", "tandem-fabric"])
def test_checks_are_counted_once(long_visit: Visitor, name: str) -> None:
    page = opened(long_visit, (EXAMPLES / f"{name}.toml").read_text("utf-8"))
    counted = re.compile(r"\b\d+ of \d+ pass|All \d+ checks pass")
    assert len(counted.findall(page.locator("#drive .frame").inner_text())) == 1
    turn(page, "train")
    if name == "tandem-fabric":
        expect(page.locator("#train-verdict p")).to_contain_text("checks pass")
        assert len(counted.findall(page.locator("#train .frame").inner_text())) == 1


def test_one_load_case_alone_is_not_green(visitor: Visitor) -> None:
    # the first answer is of one arc; that of the whole drive is held back, and the page has no
    # solver yet
    visitor.page.route("**/drive/judging.js", lambda route: None)
    page = opened(visitor, COVERED.partition("[[load_case]]")[0])
    expect(page.locator("#verdict")).to_have_class(re.compile("good"))
    held: list[Route] = []
    page.route("**/api/v1/solve", lambda route: held.append(route))  # noqa: PLW0108
    before = page.locator(".hub-number tspan").first.text_content() or ""
    page.fill("#f-pulley-0-exit_tension", "90")
    expect(page.locator(".hub-number tspan").first).not_to_have_text(before)
    expect(page.locator("#results")).to_have_attribute("data-stands", "fresh")
    expect(page.locator("#verdict p")).to_have_text(re.compile(r"^Creep .* of the limit\.$"))
    without_colour(page)
    assert page.locator("#cases .good").count() == 0
    page.unroute("**/api/v1/solve")
    for route in held:
        route.continue_()
    visitor.solved()
    expect(page.locator("#verdict")).to_have_class(re.compile("good"))
    page.unroute_all(behavior="ignoreErrors")


def test_without_the_server_the_page_says_that_it_judges_alone(visitor: Visitor) -> None:
    page = opened(visitor, COVERED.partition("[[load_case]]")[0])
    visitor.alone()
    ground = "(e) => getComputedStyle(e).backgroundColor"
    card = page.locator("#verdict")
    green, tick = card.evaluate(ground), "(e) => getComputedStyle(e).color"
    ink = page.locator("#verdict .g").evaluate(tick)
    page.route("**/api/v1/**", lambda route: route.abort())
    page.fill("#f-pulley-0-exit_tension", "90")
    expect(page.locator(".gone")).to_be_visible()
    expect(card.locator("p")).to_contain_text("OK: ")
    expect(card.locator(".line").filter(has_text="Server")).to_have_text(
        "Server No answer: judged by this page alone."
    )
    assert card.evaluate(ground) != green
    assert page.locator("#verdict .g").evaluate(tick) != ink
    page.unroute_all(behavior="wait")
    ask_now(page)
    visitor.solved()
    assert card.evaluate(ground) == green
    visitor.wrong.clear()  # requests that this test let fail


def test_a_load_case_that_lacks_a_tension_stays_the_one_looked_at(long_visit: Visitor) -> None:
    # expected: T1 is asked for, the other load cases keep their levels, nothing turns green
    page = opened(long_visit, HEAD)
    page.fill("#f-pulley-0-entry_tension", "")
    card = page.locator("#verdict")
    expect(card.locator("p")).to_have_text("Missing: Entry tension (design).")
    without_colour(page)
    expect(page.locator("#cases [aria-pressed=true]")).to_have_text("design T1?")
    expect(page.locator("#results")).to_have_attribute("data-stands", "refused")
    verdict = judged(HEAD.replace('entry_tension = "150 kN"\n', "", 1))
    expect(card.locator(".line").filter(has_text="Also").first).to_have_text(
        f"Also ATTENTION: {in_units(format_verdict(verdict, verdict.full).text, 'si')}"
    )
    expect(page.locator("#cases .warn i")).to_have_count(0)
    for case in ("empty", "start"):
        chip = page.locator("#cases").get_by_role("button", name=case)
        expect(chip.locator("i")).to_have_class(CLASSES[verdict.within(case).level])
    card.get_by_role("button", name="Enter T1").click()
    expect(page.locator("#f-pulley-0-entry_tension")).to_be_focused()
    page.keyboard.type("150")
    long_visit.solved()
    expect(card).to_have_class(re.compile("warn"))
    expect(page.locator("#cases [aria-pressed=true]")).to_contain_text("design")


def test_a_new_drive_names_what_it_assumes_until_it_is_touched(visitor: Visitor) -> None:
    page = visitor.open("drive", unfold=False)
    page.click("#file > summary")
    page.get_by_role("button", name="New drive").click()
    expect(page.locator("#s-pulley-0-entry_tension")).to_be_focused()
    for value in ("150", "60"):
        page.keyboard.type(value)
        page.keyboard.press("Tab")
    line = page.locator("#verdict .line").filter(has_text="Assumed")
    usual = ["Plylon Plus 1000/4", "1200 mm", "800 mm", "180 deg", "diamond-rubber"]
    expect(line).to_have_text(f"Assumed {', '.join(usual)}.")
    marked = page.locator(".rail .assumed")
    expect(marked).to_have_count(5)
    # also where it is typed as it is
    page.locator("#f-belt-width").press_sequentially("0")
    page.locator("#f-belt-width").fill("1200")
    expect(line).to_have_text(f"Assumed {', '.join([usual[0], *usual[2:]])}.")
    page.fill("#f-pulley-0-diameter", "1000")
    expect(marked).to_have_count(3)
    page.reload()
    expect(line).to_contain_text("Plylon Plus 1000/4")
    visitor.example("Head drive, ROM conveyor")
    visitor.solved()
    expect(marked).to_have_count(0)
    expect(line).to_have_count(0)
