"""The lists of a conveyor on the page: flights, loading points, load cases, drives, resistances.

Expected are the design's own values, and what the rules of its file say of them.
"""

from typing import Any

from playwright.sync_api import Page, expect

from web.browser import Visitor, evaluated, turn

EXAMPLE = "Overland conveyor, three flights, head and tail drive"


def conveyor(page: Page) -> Any:
    """Return what the design holds of its conveyor."""
    found = evaluated(page, 'async () => (await import("/static/main.js")).app.doc.conveyor')
    return found or {}


def test_flights_are_changed_named_removed_and_brought_back(visitor: Visitor) -> None:
    page = visitor.open("drive")
    visitor.example(EXAMPLE, None)
    turn(page, "drive")
    visitor.unfold()
    flights = page.locator("details", has=page.locator("summary", has_text="Flights: 3")).last
    flights.locator("summary").first.click()

    page.fill("#f-conveyor-flight-2-length", "600")
    page.fill("#f-conveyor-flight-1-name", "dip")
    visitor.solved()
    of = conveyor(page)
    assert [(f["name"], f["length"]) for f in of["flight"]] == [
        ("mine", "1100 m"), ("dip", "600 m"), ("ramp", "600 m"),
    ]  # fmt: skip
    assert of["loading"][1]["flight"] == "dip"  # a name is followed
    page.get_by_role("button", name="Remove mine").click()
    assert [f["name"] for f in conveyor(page)["flight"]] == ["dip", "ramp"]
    expect(page.locator("#toast")).to_contain_text("Removed: conveyor flight mine.")
    page.locator("#toast button").click()
    visitor.solved()
    assert len(conveyor(page)["flight"]) == 3
    # how long the conveyor is, is the sum of its flights
    expect(page.locator("#f-conveyor-length")).to_have_count(0)


def test_the_first_flight_and_loading_point_take_over_what_was_typed(visitor: Visitor) -> None:
    page = visitor.open("drive")
    visitor.example("Uphill conveyor, tensions from its resistances", None)
    visitor.unfold()
    before = conveyor(page)
    for of, add in (("Flights", "Add a flight"), ("Loading points", "Add a loading point")):
        page.locator("summary", has_text=of).click()
        page.get_by_role("button", name=add).click()
    visitor.solved()
    after = conveyor(page)
    assert after["flight"] == [
        {"name": "flight 1", "length": before["length"], "lift": before["lift"]}
    ]
    assert after["loading"] == [{"name": "loading point 1", "capacity": before["capacity"]}]
    assert not {"length", "lift", "capacity"} & after.keys()
