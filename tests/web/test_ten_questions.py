"""The ten questions of the documentation, answered on the page; prints the presses of each.

``python -m pytest -n 0 -s tests/web/test_ten_questions.py`` prints how many clicks, choices and
typed values an answer takes, from the first screen with the drive open.
"""

import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Locator, expect

from cli.running import wraparc
from web.browser import Visitor, turn, unsigned

EXAMPLES = Path(__file__).parents[2] / "examples"
HEAD = str(EXAMPLES / "head-drive-fabric.toml")
#: Most presses that an answer may take.
MOST = 7


class Hand:
    """A user who counts what it takes."""

    def __init__(self, visitor: Visitor) -> None:
        self.visitor, self.page, self.presses = visitor, visitor.open("drive"), 0
        visitor.solved()

    def click(self, found: Locator) -> None:
        self.presses += 1
        found.click()

    def press(self, name: str) -> None:
        self.click(self.page.get_by_role("button", name=name).locator("visible=true").first)

    def turn(self, name: str) -> None:
        self.presses += 1 if self.page.locator(f"#nav-{name}").is_visible() else 2
        turn(self.page, name)

    def choose(self, found: Locator, value: str) -> None:
        self.presses += 1
        found.select_option(value)

    def type(self, found: Locator, text: str) -> None:
        self.presses += 1
        found.fill(text)
        found.press("Tab")

    def example(self, title: str) -> None:
        self.presses += 2
        self.visitor.example(title)
        expect(self.page.locator("#title")).to_have_text(title)
        if self.page.locator("#train").is_visible():  # several pulleys open there
            expect(self.page.locator("#train .screen")).to_have_attribute("data-stands", "fresh")
        else:
            self.visitor.solved()


def words(text: str) -> str:
    return " ".join(text.split())


def printed(*command: str) -> str:
    with pytest.MonkeyPatch.context() as wide:
        wide.setenv("COLUMNS", "4000")
        return words(wraparc(*command, "--full")[1])


def cells(table: Locator) -> list[str]:
    """Return the numbers of a table, levels without their sign."""
    expect(table).to_be_attached()
    texts = [words(text) for text in table.locator("td.num").all_text_contents()]
    return [unsigned(text) for text in texts]


def assert_told(numbers: list[str], out: str) -> None:
    assert numbers
    assert [n for n in numbers if n not in out] == []


def least_tension_and_counterweight(hand: Hand) -> None:
    hand.choose(hand.page.locator("#f-pulley-0-lagging"), "full-ceramic")
    hand.visitor.solved()
    out = printed("solve", HEAD, "--set", "pulley.head.lagging=full-ceramic")
    least = hand.page.locator(".t-least")
    assert re.search(r"Counterweight ?\d+ kg", words(least.text_content() or ""))
    assert_told(cells(least), out)


def wrap_take_up_or_ceramic(hand: Hand) -> None:
    hand.press("What if")
    card = hand.page.locator(".what-if")
    hand.choose(card.locator("label", has_text="Lagging").locator("select").first, "full-ceramic")
    hand.click(card.get_by_role("button", name="Calculate"))
    expect(card.locator("thead")).to_contain_text("full-ceramic")
    assert_told(cells(card.locator("table").first), printed(
        "what-if", HEAD, "--load-case", "design", "--lagging", "full-ceramic",
        "--wet", "DIN 22101", "--worn", "6 mm", "--bare", "CEMA",
    ))  # fmt: skip
    hand.press("Which input gives")
    seek = hand.page.locator(".seek")
    hand.type(seek.locator("#seek-value"), "6.35 mm")
    hand.click(seek.get_by_role("button", name="Find"))
    goal = ("--vary", "pulley.head.wrap_angle", "--result", "exit_creep", "--value", "6.35 mm")
    (found,) = json.loads(wraparc("seek", HEAD, *goal, "--json", "-")[1])["found"]
    wrap = f"{found['value'] * 57.29577951308232:.1f} deg"
    expect(seek.get_by_role("button", name=f"Use {wrap}")).to_be_visible()
    # and what to do stands on the button beside the verdict
    expect(hand.page.locator("#verdict .advice")).to_have_text(
        "Use lagging full-ceramic and wrap 223 deg (now 180 deg)."
    )


def normal_slip(hand: Hand) -> None:
    hand.press("On site")
    card = hand.page.locator(".site")
    expect(card.locator(".headline")).to_contain_text("Speed difference")
    assert_told(cells(card.locator("table").first), printed("field", HEAD))


def wet_and_dry_friction(hand: Hand) -> None:
    hand.choose(hand.page.locator("#condition"), "2")
    hand.visitor.solved()
    table = hand.page.locator(".t-conditions")
    assert_told(cells(table), printed("solve", HEAD, "--conditions", "dry,wet,wet and dirty"))


def debonding_shear(hand: Hand) -> None:
    hand.type(hand.page.locator("#f-pulley-0-lagging-bond_strength"), "1 MPa")
    hand.type(hand.page.locator("#f-pulley-0-lagging-fatigue_limit"), "100 kPa")
    hand.visitor.solved()
    told = words(hand.page.locator(".t-checks").text_content() or "")
    assert "Bond shear stress" in told
    assert "Cyclic shear stress" in told
    assert_told(cells(hand.page.locator(".t-checks")), printed(
        "solve", HEAD, "--set", "pulley.head.lagging.bond_strength=1 MPa",
        "--set", "pulley.head.lagging.fatigue_limit=100 kPa",
    ))  # fmt: skip


def rubber_or_ceramic(hand: Hand) -> None:
    hand.turn("compare")
    rows = hand.page.locator("#compare tbody tr")
    expect(rows).to_have_count(3)
    expect(rows.filter(has_text="Full ceramic")).to_contain_text("4.36 mm")
    costs = [words(text) for text in rows.locator("td.num").all_text_contents()]
    assert any("," in cost for cost in costs)  # over the years, grouped by thousands


def ceramic_and_the_belt(hand: Hand) -> None:
    hand.choose(hand.page.locator("#f-pulley-0-lagging"), "full-ceramic")
    hand.visitor.solved()
    out = printed(
        "solve", HEAD, "--load-case", "design", "--set", "pulley.head.lagging=full-ceramic"
    )
    assert_told(cells(hand.page.locator(".t-wear")), out)


def speed_trim(hand: Hand) -> None:
    hand.example("Tandem head drive, fabric belt")
    hand.turn("train")
    hand.press("Find the trim limits")
    table = hand.page.locator("#train details.table", has_text="Against speed trim")
    assert_told(cells(table), printed("trim", str(EXAMPLES / "tandem-fabric.toml")))


def drives_that_fight(hand: Hand) -> None:
    hand.example("Tandem head drive, fabric belt")
    hand.turn("train")
    hand.choose(hand.page.locator("#train-mode"), "equal")
    hand.type(hand.page.locator("#t-pulley-1-diameter"), "804 mm")
    _, out, _ = wraparc(
        "solve", str(EXAMPLES / "tandem-fabric.toml"), "--set", "train.share=", "--set",
        "train.speeds=equal", "--set", "pulley.second.diameter=804 mm", "--json", "-",
    )  # fmt: skip
    drives = json.loads(out)["train"]["load_cases"][0]["drives"]
    shares = [f"{100.0 * drive['share']:.3g} %" for drive in drives]
    for share in shares:
        expect(hand.page.locator("#train")).to_contain_text(share)


def worn_edges(hand: Hand) -> None:
    hand.example("Worn head drive, ROM conveyor")
    hand.turn("across")
    expect(hand.page.locator("#across .screen")).to_have_attribute("data-stands", "fresh")
    file = EXAMPLES / "worn-head-drive-fabric.toml"
    out = printed("solve", str(file), "--load-case", "design")
    told = words(hand.page.locator("#across .say p").inner_text())
    assert told.partition(" ")[2].rstrip(".").split(":")[-1].strip() in out


QUESTIONS: dict[str, Callable[[Hand], None]] = {
    "Which T2, and which counterweight?": least_tension_and_counterweight,
    "More wrap, more take-up or ceramic?": wrap_take_up_or_ceramic,
    "How much slip is normal?": normal_slip,
    "Which friction, wet or dry?": wet_and_dry_friction,
    "What shear debonds a lagging?": debonding_shear,
    "Rubber or ceramic over the life?": rubber_or_ceramic,
    "Does ceramic wear the belt?": ceramic_and_the_belt,
    "Which speed trim does a tandem need?": speed_trim,
    "Why do two drives oppose each other?": drives_that_fight,
    "What do worn edges do?": worn_edges,
}


@pytest.mark.parametrize("question", QUESTIONS)
def test_question_is_answered_in_a_few_presses(
    visitor: Visitor, question: str, record_property: Any
) -> None:
    # expected: what the command of the question's page in docs/questions prints
    hand = Hand(visitor)
    QUESTIONS[question](hand)
    print(f"{hand.presses} presses: {question}")  # noqa: T201 - what it is for
    record_property("presses", hand.presses)
    assert hand.presses <= MOST


def test_they_are_those_of_the_documentation() -> None:
    pages = sorted((Path(__file__).parents[2] / "docs" / "questions").glob("*.md"))
    assert len(pages) == len(QUESTIONS)
