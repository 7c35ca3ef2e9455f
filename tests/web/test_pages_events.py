"""The page of drives in time: a start of a shipped tandem is followed and played."""

import re
from pathlib import Path

import pytest
from playwright.sync_api import Page, Route, expect

from web.browser import PHONE, Calculator, Visitor
from web.calculators import wait_for
from wraparc.errors import InputError
from wraparc.motion.file import check_motion
from wraparc.schema.source import parse
from wraparc.web.answers.documents import read
from wraparc.web.examples import examples


def short() -> str:
    """Return a shipped tandem whose start is looked at for 2 s: every frame of it is drawn."""
    text = next(e.text for e in examples() if e.name == "tandem-fabric")
    assert 'duration = "40 s"' in text
    return text.replace('duration = "40 s"', 'duration = "2 s"')


def with_layers(text: str) -> str:
    """Return a drive with the layers of a belt of 15 mm."""
    layers = 'pulley_cover = "3 mm"\ncarry_cover = "6 mm"\ncarcass = "6 mm"\n'
    assert "[belt]\n" in text
    return text.replace("[belt]\n", f"[belt]\n{layers}")


def minutes(page: Page) -> None:
    """Ask for a run that takes minutes: there is time to cancel it."""
    page.fill("#e-step", "0.01 ms")
    page.press("#e-step", "Tab")


def opened(visitor: Visitor, text: str, folder: Path) -> Page:
    """Open a drive file from the menu and go to its events."""
    page = visitor.open("drive")
    file = folder / "mine.toml"
    file.write_text(text, "utf-8")
    visitor.load(file)
    expect(page.locator("#toast")).to_contain_text("opened", ignore_case=True)
    visitor.open("events")
    page.select_option("#e-points", "30")
    return page


def test_a_wrong_mass_is_refused_under_its_field_before_anything_runs(
    visitor: Visitor, tmp_path: Path
) -> None:
    page = opened(visitor, short(), tmp_path)
    mass, error = page.locator("#e-motion-conveyor_mass"), "#e-motion-conveyor_mass-e"
    mass.fill("-3 t")
    mass.press("Tab")
    expect(page.locator(error)).to_contain_text("must be more than 0 kg")
    expect(mass).to_have_attribute("aria-invalid", "true")
    mass.fill("120 t")
    mass.press("Tab")
    expect(page.locator(error)).to_have_text("")


def test_what_moves_may_be_given_in_any_order() -> None:
    """The drive is solved beside a table that is not whole yet; what is wrong in it is refused."""
    document = parse(short())
    document["motion"] = {"conveyor_mass": "120 t"}
    assert len(read(document).pulleys) == 2
    with pytest.raises(InputError, match="drum"):
        check_motion(document)
    document["motion"] = {"conveyor_mass": "-3 t"}
    with pytest.raises(InputError, match="must be more than 0 kg") as refused:
        read(document)
    assert len(refused.value.problems) == 1


def test_a_start_of_a_shipped_tandem_plays(visitor: Visitor, tmp_path: Path) -> None:
    page = opened(visitor, with_layers(short()), tmp_path)
    page.emulate_media(reduced_motion="no-preference")
    page.click("#follow")
    # the answers stand first, and it plays by itself
    expect(page.locator("#events .verdict .headline").nth(1)).to_contain_text("Te ripple")
    expect(page.locator("#play")).to_contain_text("Play")  # when it has come to its end
    reading = page.locator("#events .reading-time")
    expect(reading).to_contain_text(re.compile(r"^2\.0\d s: belt"))
    drum = page.locator("#events svg.stage").first
    told, colours = drum.get_attribute("aria-label"), _colours(page)
    # the belt is as thick as its tension: of the strands T1 is the thicker one
    thick = drum.locator("g ~ .strand").evaluate_all(
        "(all) => all.map((e) => parseFloat(e.getAttribute('stroke-width')))"
    )
    assert thick[0] > thick[1] > 3
    assert told is not None
    assert re.match(r"first: pulls [\d.]+ kN, creep at exit [\d.]+ mm", told)
    assert len(set(colours)) > 5
    # by keyboard to its beginning: no pull, no colour, belt and drum at another place
    marks = page.locator("#events .belt-marks").first.get_attribute("stroke-dashoffset")
    page.focus("#play-time")
    page.keyboard.press("Home")
    expect(reading).to_have_text(re.compile(r"^0\.00 s: belt 0"))
    assert drum.get_attribute("aria-label") != told
    assert len(set(_colours(page))) == 1
    assert page.locator("#events .belt-marks").first.get_attribute("stroke-dashoffset") != marks
    assert page.locator("#events .curve .cursor[d]").count() == 1
    # and it plays and stops: slowly, so that it does not come to its end before it is stopped
    page.select_option("#play-rate", "0.1")
    page.focus("#play")
    page.keyboard.press("Space")
    expect(page.locator("#play")).to_contain_text("Pause")
    page.keyboard.press("Space")
    expect(page.locator("#play")).to_contain_text("Play")


def _colours(page: Page) -> list[str]:
    cells = page.locator("#events svg.stage").first.locator("path[stroke]")
    found: list[str] = cells.evaluate_all("(all) => all.map((e) => e.getAttribute('stroke'))")
    return found


def test_what_is_missing_is_told_at_its_field_and_can_be_filled_in(visitor: Visitor) -> None:
    page = visitor.open("events")
    assert "no events: the usual ones" in page.inner_text("#events")
    page.click("#follow")
    field = "#e-motion-drum-head-inertia"
    expect(page.locator(f"{field}-e")).to_contain_text("Missing.")
    page.fill(field, "2200")
    # at once, and not when the button below is pressed, which would move from under the press
    assert page.locator(f"{field}-e").inner_text() == ""
    held: list[Route] = []
    page.route("**/solve/fast", lambda route: held.append(route))  # noqa: PLW0108
    page.select_option("#e-motion-drum-head-control-kind", "speed-loop")
    page.click("#follow")
    reset = page.locator("#e-motion-drum-head-control-reset-e")
    expect(reset).to_contain_text("Missing.")
    expect(page.locator(f"{field}-e")).to_be_empty()
    # an answer of the drive that comes after it takes nothing of it away
    wait_for(lambda: page.evaluate("1") and held)
    page.route("**/solve/fast", lambda route: route.continue_())
    with page.expect_response("**/solve/fast"):
        for route in held:
            route.continue_()
    visitor.painted()
    assert reset.inner_text() == "Missing."
    page.fill(field, "2300")  # two changes of one field within a second undo as one
    page.select_option("#e-motion-drum-head-control-kind", "")
    page.click("#follow")
    mass = page.locator("#e-motion-conveyor_mass-e")
    expect(mass).to_contain_text("missing: starts and stops need it.")
    page.click("#undo")
    expect(page.locator("#e-motion-drum-head-control-kind")).to_have_value("speed-loop")
    page.fill(field, "")
    page.click("#follow")
    expect(page.locator(f"{field}-e")).to_contain_text("Missing.")


def test_a_run_is_cancelled_and_another_one_goes_slack(
    calculator: Calculator, tmp_path: Path
) -> None:
    # on a phone, by somebody who wants less motion
    browser, server = calculator
    visitor = Visitor(browser, server.address, PHONE)
    back = '{ kind = "load-step", at = "0.5 s", factor = -2.0, time = "0.5 s" }'
    start = '{ kind = "start", shape = "s-curve", time = "20 s" }'
    text = short()
    assert start in text
    page = opened(visitor, text.replace(start, back), tmp_path)
    minutes(page)
    page.click("#follow")
    page.locator("#events").get_by_role("button", name="Cancel").click()
    expect(page.locator("#events .say")).to_contain_text("Cancelled.")
    page.fill("#e-step", "")
    page.press("#e-step", "Tab")
    page.click("#follow")
    headline = page.locator("#events .verdict .headline").first
    expect(headline).to_contain_text("Belt goes slack before first at 1.3")
    assert float(page.get_attribute("#play-time", "max") or 0) < 1.5
    # nothing moves before it is asked to, and then in steps
    expect(page.locator("#events .reading-time")).to_have_text(re.compile(r"^0\.00 s"))
    expect(page.locator("#play")).to_contain_text("Play")
    assert page.locator("#events .belt-marks[stroke-dashoffset]").count() == 0
    assert page.evaluate("document.documentElement.scrollWidth") == PHONE["width"]
    # an answer of another design says so
    page.fill("#e-motion-conveyor_mass", "120")
    expect(page.locator("#events .say")).to_contain_text("The design changed.")
    assert visitor.wrong == []
    visitor.close()
