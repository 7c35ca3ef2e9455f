"""The conveyor on the drive page: in the place of tensions, and back.

Expected tensions: what `wraparc.load_drive` reads from the same file (tests/conveyor hold those to
the standards).
"""

from pathlib import Path

import pytest
from playwright.sync_api import expect

from web.browser import Calculator, Visitor
from wraparc import load_drive

UPHILL = Path(__file__).parents[2] / "examples" / "uphill-conveyor.toml"
TYPED = {
    "length": "600 m",
    "lift": "20 m",
    "capacity": "1000 t/h",
    "belt_mass": "22 kg/m",
    "carry_idler_mass": "16 kg/m",
    "return_idler_mass": "6 kg/m",
    "counterweight": "8 t",
    "start_factor": "1.3",
    "stop_time": "15 s",
}


def test_tensions_from_the_conveyor_and_back(calculator: Calculator) -> None:
    browser, server = calculator
    visitor = Visitor(browser, server.address)
    page = visitor.open("drive")
    visitor.load(UPHILL)
    names = [case.name for case in load_drive(UPHILL).load_cases]
    assert names == ["full", "empty", "start", "stop"]
    picked = page.locator("#cases button")
    expect(picked).to_have_count(len(names))
    picked.nth(3).click()
    visitor.solved()
    expect(page.locator("#cases [aria-pressed=true]")).to_contain_text("stop")

    # out: the tensions of every load case stay, those of the case on the screen in their fields
    page.get_by_role("button", name="Give the tensions themselves").click()
    visitor.solved()
    stop = load_drive(UPHILL).load_case("stop").tensions["head"]
    entry = page.locator("#f-load_case-3-pulley-head-entry_tension")
    kept = float(entry.input_value())
    assert kept == pytest.approx(stop.entry / 1e3, rel=1e-4)
    expect(picked).to_have_count(len(names))
    expect(page.locator("#toast")).to_contain_text("Removed: conveyor.")

    # in again, typed anew: what is missing is asked for at its field, Undo brings tensions back
    page.get_by_role("button", name="Tensions from the conveyor").click()
    expect(page.locator("#f-conveyor-belt_mass-e")).to_contain_text("Missing.")
    # what is only missing is not called wrong, and a length is asked for in metres
    expect(page.locator(".rail .wrong")).to_have_count(0)
    expect(page.locator("#f-conveyor-length-u")).to_have_text("m")
    page.click("#undo")
    expect(page.locator("#describe-conveyor")).to_be_visible()
    doc = page.evaluate("() => JSON.parse(localStorage.getItem('wraparc.drafts'))[0].doc")
    assert [case["name"] for case in doc["load_case"]] == names
    page.click("#redo")
    for key, text in TYPED.items():
        page.fill(f"#f-conveyor-{key}", text)
        page.press(f"#f-conveyor-{key}", "Tab")
    visitor.solved()
    expect(picked).to_have_count(len(names))
    doc = page.evaluate("() => JSON.parse(localStorage.getItem('wraparc.drafts'))[0].doc")
    assert set(doc["conveyor"]) == set(TYPED)
    # a wrong value is told at its field, with what is allowed
    page.fill("#f-conveyor-length", "-600 m")
    page.press("#f-conveyor-length", "Tab")
    expect(page.locator("#f-conveyor-length-e")).to_contain_text("-600 m")
    visitor.close()
    assert visitor.wrong == []
