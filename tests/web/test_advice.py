"""The first way of an action, made by one press, and taken back."""

import json
import re
import tomllib
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Page, Route, expect

from cli.running import wraparc
from web.browser import Visitor, evaluated, turn
from web.test_standing import take
from wraparc.units import parse_quantity
from wraparc.web.answers.drives import solve_all
from wraparc.web.asked import SolveRequest

pytestmark = pytest.mark.usefixtures("solved_once")
EXAMPLES = Path(__file__).parents[2] / "examples"
HEAD = (EXAMPLES / "head-drive-fabric.toml").read_text("utf-8")
#: The drive of the example in its load case design, in one that takes T2 over from it, and in
#: one with both ends of its own.
DESIGN = f"covered = true\n{HEAD.partition('[[load_case]]')[0]}"
SHARED = (
    DESIGN
    + '[[load_case]]\nname = "light"\npulley.head.entry_tension = "120 kN"\n'
    + '[[load_case]]\nname = "own"\npulley.head.entry_tension = "120 kN"\n'
    + 'pulley.head.exit_tension = "70 kN"\n'
)
#: Braking, T2 and the pull given: T1 is the slack side.
BRAKING = DESIGN.replace('entry_tension = "150 kN"', 'effective_tension = "-90 kN"').replace(
    'exit_tension = "60 kN"', 'exit_tension = "145 kN"'
)
TANDEM = (EXAMPLES / "tandem-fabric.toml").read_text("utf-8").partition("# The drives in time")[0]
#: T1 is given, so that T2 follows the pull: the load cases ask for different lifts.
SLIPS = TANDEM.replace('exit_tension = "45 kN"', 'exit_tension = "0.65 kN"')
#: The entry holds one tension, so the take-up is there.
HELD_AHEAD = TANDEM.replace('exit_tension = "45 kN"', 'entry_tension = "105.65 kN"')
#: With another tension speeds divide the load anew.
SPEEDS = TANDEM.replace('exit_tension = "45 kN"', 'exit_tension = "20 kN"').replace(
    'share = ["50 %", "50 %"]', 'speeds = "equal"'
)


def solved(file: Path) -> Any:
    return json.loads(wraparc("solve", str(file), "--json", "-")[1])


def downloaded(page: Page, into: Path) -> Path:
    with page.expect_download() as arriving:
        page.keyboard.press("Control+s")
    file = into / "after.toml"
    arriving.value.save_as(file)
    return file


#: Ways of one change and of several, of tensions at either end and of laggings, by their drives.
PRESSED = {
    "T2 in load cases that share it": SHARED,
    "T1 of a brake": BRAKING,
    "a lagging for every load case": f"covered = true\n{HEAD}",
    "T2 of a train that slips": SLIPS,
    "the tension ahead of a train": HELD_AHEAD,
    "a lagging of drives by speeds": SPEEDS,
}


def pulls(arcs: list[Any]) -> dict[str, float]:
    """Return the pull of all drives in every load case."""
    names = dict.fromkeys(arc["load_case"] for arc in arcs)
    return {
        name: sum(arc["effective_tension"] for arc in arcs if arc["load_case"] == name)
        for name in names
    }


def value_at(document: Any, key: str) -> Any:
    """Return what a file has at a key, rows by their names."""
    for step in key.split("."):
        named = isinstance(document, list)
        document = next(r for r in document if r["name"] == step) if named else document[step]
    return document


def arcs_of(answer: Any) -> list[Any]:
    found: list[Any] = answer["arcs"]
    return found


@pytest.mark.parametrize("name", PRESSED)
def test_first_way_is_pressed_once_and_every_check_passes(
    visitor: Visitor, tmp_path: Path, name: str
) -> None:
    # expected: `wraparc solve` of the file before and after
    file = tmp_path / "before.toml"
    file.write_text(PRESSED[name], "utf-8")
    before = solved(file)
    assert before["verdict"]["level"] != "OK"
    action = before["verdict"]["action"]
    way = action["ways"][0]
    assert way["left"] == 0
    page = visitor.open("drive")
    visitor.load(file)
    expect(page.locator("#toast")).to_contain_text("Opened")
    turn(page, "drive")  # a drive of several pulleys opens on Tandem
    visitor.solved()
    press = page.locator(".verdict").get_by_role("button", name=way["text"], exact=True)
    said = page.locator(".verdict .line").filter(has_text="Action").first
    expect(said).to_have_text(f"Action {action['text']}")
    press.click()
    expect(page.locator("#toast")).to_contain_text(way["text"])
    if PRESSED[name] is SHARED:  # and back by the button in the message
        page.locator("#toast").get_by_role("button", name="Undo").click()
        visitor.solved()
        press.click()
    visitor.solved()
    expect(press).to_have_count(0)
    saved = downloaded(page, tmp_path)
    document = tomllib.loads(saved.read_text("utf-8"))
    for change in way["changes"]:
        value = value_at(document, change["key"])
        if change["unit"] == "N":
            assert parse_quantity(value, "force") == pytest.approx(change["to"], rel=1e-8)
        else:
            assert (value, change["unit"]) == (change["to"], None)
    after = solved(saved)
    assert after["verdict"]["level"] == "OK"
    assert pulls(arcs_of(after)) == pytest.approx(pulls(arcs_of(before)), rel=1e-6)
    page.click("#undo")
    visitor.solved()
    expect(press).to_be_visible()
    assert arcs_of(solved(downloaded(page, tmp_path))) == arcs_of(before)


def test_page_offers_what_it_has_tried_while_the_server_is_silent(visitor: Visitor) -> None:
    # expected: with what is pressed every check passes, by the program
    page = visitor.open("drive", unfold=False)
    take(page, tomllib.loads(DESIGN))
    visitor.solved()
    visitor.alone()
    held: list[Route] = []
    page.route("**/api/v1/solve**", lambda route: held.append(route))  # noqa: PLW0108
    before = page.locator("#verdict .advice").inner_text()
    page.get_by_label("Entry tension, slider").focus()
    page.keyboard.press("ArrowLeft")
    offered = page.locator("#verdict .advice")
    expect(offered).to_have_text(re.compile(r"^(Use|Raise|Increase) .*\.$"))
    expect(offered).not_to_have_text(before)
    offered.click()
    made = evaluated(page, "import('/static/main.js').then((m) => m.app.doc)")
    assert solve_all(SolveRequest(document=made, search=False)).verdict.level == "OK"
    page.unroute_all(behavior="ignoreErrors")
