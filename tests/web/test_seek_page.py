"""Goal seek on the page: the answer of ``wraparc seek``, used with one press."""

import json
from pathlib import Path

import pytest
from playwright.sync_api import expect

from cli.running import wraparc
from web.browser import Visitor
from web.calculators import API, client, document

pytestmark = pytest.mark.usefixtures("solved_once")
EXAMPLES = Path(__file__).parents[2] / "examples"
HEAD = str(EXAMPLES / "head-drive-fabric.toml")


def sought(*goal: str) -> list[float]:
    found = json.loads(wraparc("seek", HEAD, *goal, "--json", "-")[1])["found"]
    return [value["value"] for value in found]


def test_which_wrap_gives_6_mm(visitor: Visitor) -> None:
    # expected: `wraparc seek`, and the creep that the page shows with the value used
    page = visitor.open("drive")
    visitor.solved()
    page.get_by_role("button", name="Help: Wrap angle").click()
    page.get_by_role("button", name="Which value gives a result?").click()
    expect(page.locator("#seek-value")).to_have_value("7.49 mm")
    results = page.locator(".seek select").nth(1).locator("option").all_inner_texts()
    assert not any("_" in title for title in results)  # each has a title of the glossary
    page.fill("#seek-value", "6 mm")
    page.keyboard.press("Enter")
    (value,) = sought(
        "--vary", "pulley.head.wrap_angle", "--result", "exit_creep", "--value", "6 mm"
    )
    degrees = value * 57.29577951308232
    card = page.locator(".seek")
    expect(card).to_contain_text(f"Wrap {degrees:.1f} deg gives creep 6 mm (head, ")
    expect(card.locator("svg.chart")).to_be_visible()
    card.get_by_role("button", name=f"Use {degrees:.1f} deg").click()
    visitor.solved()
    assert float(page.input_value("#f-pulley-0-wrap_angle")) == pytest.approx(degrees, rel=1e-5)
    expect(page.locator("#drive .figures b").first).to_have_text("6.00 mm")
    # what was found is of the drive before, and looks so; undo brings that back
    expect(card.locator("[data-stands=stale]")).to_have_count(1)
    page.click("#undo")
    expect(page.locator("#f-pulley-0-wrap_angle")).to_have_value("180")
    expect(card.locator("[data-stands=stale]")).to_have_count(0)
    # what is refused, and what no value gives
    page.fill("#seek-value", "6 kN")
    card.get_by_role("button", name="Find").click()
    expect(card.locator(".verdict.bad")).to_contain_text("kN")
    page.fill("#seek-value", "1")
    card.get_by_role("button", name="Find").click()
    expect(card).to_contain_text("No wrap from 60 to 540 deg gives creep 1 mm; minimum 4.86 mm")
    card.get_by_role("button", name="Close").click()
    expect(card).to_have_count(0)


def test_a_number_of_the_catalogue_is_sought_in_us_units_too(visitor: Visitor) -> None:
    # expected: `wraparc seek` for the same wanted value; 0.2953 in are 7.5 mm
    page = visitor.open("drive")
    page.get_by_label("US", exact=True).check(force=True)
    visitor.solved()
    page.get_by_role("button", name="Which input gives").click()
    card = page.locator(".seek")
    card.get_by_label("Input").select_option("pulley,0,lagging,thickness")
    page.fill("#seek-value", "0.295")
    card.get_by_role("button", name="Find").click()
    (value, *_) = sought(
        "--vary", "pulley.head.lagging.thickness", "--result", "exit_creep", "--value", "0.295 in",
        "--from", "4 mm", "--to", "36 mm",
    )  # fmt: skip
    card.get_by_role("button", name=f"Use {value / 0.0254:.4f} in").click()
    visitor.solved()
    expect(page.locator("#drive .figures b").first).to_have_text("0.295 in")
    typed = page.input_value("#f-pulley-0-lagging-thickness")
    assert float(typed) == pytest.approx(value / 0.0254, rel=1e-5)


def test_answer_is_that_of_the_command_in_every_load_case_and_of_a_train() -> None:
    # expected: the values of `wraparc seek`
    with client() as api:
        for name, field, value, more in (
            ("head-drive-fabric", "pulley.head.wrap_angle", "9 mm", {"load_case": "start"}),
            ("tandem-fabric", "train.exit_tension", "5 mm", {"pulley": "second"}),
        ):
            asked = {"field": field, "result": "exit_creep", "value": value, **more}
            answer = api.post(f"{API}/seek", json={"document": document(name), **asked})
            assert answer.status_code == 200, answer.text
            options = [f"--{k.replace('_', '-')}={v}" for k, v in more.items()]
            goal = ("--vary", field, "--result", "exit_creep", "--value", value, *options)
            file = str(EXAMPLES / f"{name}.toml")
            told = json.loads(wraparc("seek", file, *goal, "--json", "-")[1])
            found = answer.json()["found"]
            assert [v["value"] for v in found] == pytest.approx(
                [v["value"] for v in told["found"]], rel=1e-8
            )
            assert found
            assert [v["level"] for v in found] == [v["level"] for v in told["found"]]
