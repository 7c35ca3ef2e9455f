"""The advice of a check that gives a number, applied by one press, and taken back."""

import json
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Page, Route, expect

from cli.running import wraparc
from web.browser import Visitor

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


def solved(file: Path) -> Any:
    return json.loads(wraparc("solve", str(file), "--json", "-")[1])


def downloaded(page: Page, into: Path) -> Path:
    with page.expect_download() as arriving:
        page.keyboard.press("Control+s")
    file = into / "after.toml"
    arriving.value.save_as(file)
    return file


@pytest.mark.parametrize("text", [SHARED, BRAKING])
def test_raised_tension_keeps_every_check_and_every_pull(
    visitor: Visitor, tmp_path: Path, text: str
) -> None:
    # expected: `wraparc solve` of the file before and after: the least tension it names is kept
    file = tmp_path / "before.toml"
    file.write_text(text, "utf-8")
    before = solved(file)
    least = before["least_tension"]
    assert least["tension"] > least["given"]
    page = visitor.open("drive")
    visitor.load(file)
    expect(page.locator("#toast")).to_contain_text("Opened")
    visitor.solved()
    side = "T1" if text is BRAKING else "T2"
    step = 1e2  # three digits of some 60 kN to 100 kN
    asked = f"{-(-least['tension'] // step) * step / 1e3:g} kN"
    press = page.locator(".verdict").get_by_role("button", name=f"Raise {side} to {asked}")
    given = page.input_value("#f-pulley-0-exit_tension")
    press.click()
    expect(page.locator("#toast")).to_contain_text(f"{side} is at least {asked} now")
    if text is SHARED:  # and back by the button in the message
        page.locator("#toast").get_by_role("button", name="Undo").click()
        expect(page.locator("#f-pulley-0-exit_tension")).to_have_value(given)
        visitor.solved()
        press.click()
    expect(page.locator("#f-pulley-0-exit_tension")).not_to_have_value(given)
    visitor.solved()
    expect(press).to_have_count(0)
    after = solved(downloaded(page, tmp_path))
    assert after["least_tension"]["tension"] <= after["least_tension"]["given"]
    assert after["verdict"]["level"] == "OK"
    for old, new in zip(before["arcs"], after["arcs"], strict=True):
        assert new["effective_tension"] == pytest.approx(old["effective_tension"], rel=1e-8)
        assert min(new["entry_tension"], new["exit_tension"]) >= least["tension"]
    page.click("#undo")
    visitor.solved()
    expect(press).to_be_visible()
    assert solved(downloaded(page, tmp_path))["arcs"] == before["arcs"]


def test_page_finds_the_advice_itself_while_a_slider_moves(visitor: Visitor) -> None:
    # expected: the least tension that `wraparc solve` names; the server is silent meanwhile
    page = visitor.open("drive")
    visitor.solved()
    first = page.locator("#verdict").get_by_role("button", name="Raise T2 to 94.1 kN")
    expect(first).to_be_visible()
    visitor.alone()
    held: list[Route] = []
    page.route("**/api/v1/solve**", lambda route: held.append(route))  # noqa: PLW0108
    page.get_by_label("Entry tension, slider").focus()
    page.keyboard.press("ArrowLeft")
    _, out, _ = wraparc(
        "solve", str(EXAMPLES / "head-drive-fabric.toml"), "--load-case", "design", "--json", "-",
        "--set", f"pulley.head.entry_tension={page.input_value('#f-pulley-0-entry_tension')} kN",
    )  # fmt: skip
    least = json.loads(out)["least_tension"]["tension"]
    text = f"Raise T2 to {-(-least // 1e2) / 10:g} kN"
    expect(page.locator("#verdict").get_by_role("button", name=text)).to_be_visible()


def test_one_load_case_is_raised_alone_where_no_tension_keeps_all(
    visitor: Visitor, tmp_path: Path
) -> None:
    # expected: `wraparc solve` of the file before and after; 94.1 kN is what it prints for design
    file, text = tmp_path / "before.toml", EXAMPLES / "head-drive-fabric.toml"
    file.write_text(f"covered = true\n{text.read_text('utf-8')}", "utf-8")
    page = visitor.open("drive")
    visitor.load(file)
    visitor.solved()
    before = solved(file)
    # beside the load case alone: its start no slack-side tension keeps
    expect(page.locator("#verdict .advice")).to_have_count(1)
    expect(page.locator(".verdict .advice")).to_have_count(0)
    page.get_by_role("button", name="Raise T2 to 94.1 kN").click()
    visitor.solved()
    after = solved(downloaded(page, tmp_path))
    ends = {arc["load_case"]: (arc["entry_tension"], arc["exit_tension"]) for arc in after["arcs"]}
    assert ends["design"] == pytest.approx((184.1e3, 94.1e3))
    assert after["arcs"][0]["level"] == "OK"
    for old, new in zip(before["arcs"][1:], after["arcs"][1:], strict=True):
        assert ends[new["load_case"]] == (old["entry_tension"], old["exit_tension"])
        assert new["level"] == old["level"]


TANDEM = (EXAMPLES / "tandem-fabric.toml").read_text("utf-8").partition("# The drives in time")[0]
#: T1 is given, so that T2 follows the pull: the load cases ask for different lifts.
SLIPS = TANDEM.replace('exit_tension = "45 kN"', 'exit_tension = "0.65 kN"')
#: The entry holds one tension, so the take-up is there: no button promises one of the slack side.
HELD_AHEAD = TANDEM.replace('exit_tension = "45 kN"', 'entry_tension = "105.65 kN"')


def test_the_slack_side_of_a_train_is_raised_in_every_load_case(
    visitor: Visitor, tmp_path: Path
) -> None:
    # expected: `wraparc solve` of the file before and after
    file = tmp_path / "before.toml"
    file.write_text(SLIPS, "utf-8")
    before = solved(file)["train"]
    least = before["least_tension"]
    page = visitor.open("drive")
    visitor.load(file)
    expect(page.locator("#toast")).to_contain_text("Opened")
    visitor.solved()
    # the second drum slips: no green beside it, whichever pulley is chosen
    expect(page.locator("#cases button").first).to_contain_text("design: second slips")
    expect(page.locator("#verdict")).to_contain_text("design, second: breaks away")
    page.locator(".verdict").get_by_role("button", name="Raise T2 to").click()
    expect(page.locator("#toast")).to_contain_text("T2 is at least")
    visitor.solved()
    expect(page.locator("button.advice")).to_have_count(0)
    after = solved(downloaded(page, tmp_path))["train"]
    assert after["least_tension"]["tension"] == pytest.approx(least["tension"], rel=1e-6)
    assert after["verdict"]["level"] in ("OK", "ATTENTION")  # CEMA asks for more, and binds not
    for old, new in zip(before["load_cases"], after["load_cases"], strict=True):
        ends = [
            (c["drives"][0]["entry_tension"], c["drives"][-1]["exit_tension"]) for c in (old, new)
        ]
        (a, b), (c, d) = ends
        assert c - d == pytest.approx(a - b, rel=1e-8)
        assert d >= least["tension"]


def test_no_button_stands_where_no_number_is_the_advice(visitor: Visitor, tmp_path: Path) -> None:
    # the least tension is of the load divided as it is: with another one speeds divide it anew,
    # so that no number can be promised; expected: `wraparc solve` names one above that given
    file = tmp_path / "speeds.toml"
    text = TANDEM.replace('exit_tension = "45 kN"', 'exit_tension = "20 kN"')
    file.write_text(text.replace('share = ["50 %", "50 %"]', 'speeds = "equal"'), "utf-8")
    least = solved(file)["train"]["least_tension"]
    assert least["given"] < least["tension"]
    page = visitor.open("drive", unfold=False)
    visitor.example("Tandem head drive, fabric belt")  # nothing to be raised
    visitor.unfold()
    visitor.solved()
    expect(page.locator(".advice")).to_have_count(0)
    visitor.load(file)
    expect(page.locator("#toast")).to_contain_text("Opened")
    visitor.solved()
    expect(page.locator("#details")).to_contain_text("No button raises it: by speeds or motors")
    expect(page.locator(".advice")).to_have_count(0)
    file.write_text(HELD_AHEAD, "utf-8")
    told = solved(file)["train"]["least_tension"]
    assert "at the take-up ahead of pulley" in told["sentence"]
    assert told["given"] < told["tension"]
    visitor.load(file)
    visitor.solved()
    expect(page.locator("#verdict")).to_contain_text("second: breaks away")
    expect(page.locator(".advice")).to_have_count(0)
