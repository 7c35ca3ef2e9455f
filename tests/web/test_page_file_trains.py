"""Trains in the calculator of one file: the numbers and sentences of the program."""

import json
from itertools import zip_longest
from pathlib import Path
from typing import Any, get_args

import pytest
from playwright.sync_api import Browser, Page

from cli.running import wraparc
from judgement.rows import MOTORS
from web.browser import Visitor
from web.calculators import wait_for
from web.firefox import Firefox
from worded import worded
from wraparc.checks import judge
from wraparc.train import solve_train
from wraparc.train.file import train_from_text
from wraparc.units import System, in_units
from wraparc.web.answers.trains import train_part

EXAMPLES = Path(__file__).parents[2] / "examples"
HEAD = (EXAMPLES / "head-drive-fabric.toml").read_text("utf-8")
FABRIC = (EXAMPLES / "tandem-fabric.toml").read_text("utf-8").partition("# The drives in time")[0]
SHARES = 'share = ["50 %", "50 %"]       # or speeds = "equal", speeds = ["100 %", "99.7 %"], ...'
LAYERS = 'pulley_cover = "3 mm"\ncarry_cover = "7 mm"\ncarcass = "6 mm"\nmass = "20 kg/m"\n'
WRAP, CARRY = 'wrap_angle = "200 deg"\n', 'side = "carry"\n'
assert SHARES in FABRIC
assert WRAP in FABRIC


def divided(by: str, more: str = "") -> str:
    return FABRIC.replace(SHARES, by) + more


#: Each takes a way of its own through the page; numbers of many more: test_page_trains.py.
TRAINS: dict[str, str] = {
    "tandem": FABRIC,
    "motors": (EXAMPLES / "triple-steel-cord.toml").read_text("utf-8"),
    "overloaded motors": divided(
        'diameters = ["796 mm", "800 mm"]',
        "".join(
            f'[train.motor.{name}]\nkind = "induction"\nrated_power = "180 kW"\n'
            f'synchronous_speed = "1500 rpm"\nrated_speed = "1480 rpm"\ngear_ratio = 20.67\n'
            for name in ("first", "second")
        ),
    ),
    "trims that fight": divided('speeds = ["100 %", "98.2 %"]'),
    "powers, a run": divided('share = ["200 kW", "115 kW"]\nrun.second = "2 kN"')
    .replace('effective_tension = "105', '# "105')
    .partition("# The tensions above")[0],
    "no division": divided('speeds = "equal"').replace('"45 kN"', '"0.65 kN"')
    .replace('"105 kN"', '"300 kN"').replace("format = 1", 'format = 1\ncondition = "wet"'),
    "speeds break away": divided('speeds = ["100 %", "104 %"]').replace('"45 kN"', '"9 kN"'),
    "take-up between": divided('share = ["50 %", "50 %"]', '[take_up]\nafter = "first"\n'),
    "fixed take-up, worn drum": divided(
        'speeds = "equal"\ndiameters = ["800 mm", "797 mm"]', '[take_up]\nkind = "fixed"\n'
    ),
    "S-wrap": FABRIC.replace("[belt]\n", f"[belt]\n{LAYERS}", 1).replace(WRAP, f"{WRAP}{CARRY}"),
    "two diameters, covers": FABRIC.replace("[belt]\n", f"[belt]\n{LAYERS}", 1).replace(
        f'diameter = "800 mm"\n{WRAP}', f'diameter = "1000 mm"\n{WRAP}'
    ),
    "two diameters, no covers": FABRIC.replace(
        f'diameter = "800 mm"\n{WRAP}', f'diameter = "1000 mm"\n{WRAP}'
    ),
    "opposite sides, no covers": FABRIC.replace(WRAP, f"{WRAP}{CARRY}").replace(
        'preset = "Plylon Plus 1000/4"',
        'name = "own"\nkind = "fabric"\nmodulus = "12960 kN/m"\nrating = "175 kN/m"',
    ),
    # belt contraction 126 kN/9.6 MN is -1.3125 %: a tie goes to the even digit
    "shares that fight, no rating": divided('share = ["120 %", "-20 %"]').replace(
        'preset = "Plylon Plus 1000/4"', 'modulus = "8000 kN/m"'
    ),
    "wet and dry, with sag": divided(
        'speeds = "equal"', '[sag]\nidler_spacing = "3 m"\nline_mass = "22 kg/m"\n'
    ).replace("format = 1", 'format = 1\ncondition = ["dry", "wet"]'),
}  # fmt: skip


def answer_of(text: str) -> dict[str, Any]:
    """What `wraparc solve` says of a train."""
    result = solve_train(train_from_text(text), raise_on_failure=False)
    found: dict[str, Any] = json.loads(train_part(result).model_dump_json())
    return found


def tables_of(page: Page) -> dict[str, list[list[str]]]:
    """Tables of the page by title: the cells of every row, levels without their sign."""
    found: dict[str, list[list[str]]] = page.evaluate(
        """() => Object.fromEntries([...document.querySelectorAll("#train .tables details")].map(
          (d) => [
            d.querySelector("summary").textContent.trim(),
            [...d.querySelectorAll("tbody tr")].map((r) =>
              [...r.cells].map((c) => c.textContent.trim().replace(/^[✓▲✕] /, ""))),
          ]))"""
    )
    return found


@pytest.mark.parametrize("name", TRAINS)
def test_train_page_says_what_the_program_says(chrome: Browser, tmp_path: Path, name: str) -> None:
    file, html = tmp_path / "train.toml", tmp_path / "train.html"
    file.write_text(TRAINS[name], "utf-8")
    assert wraparc("page", str(file), "-o", str(html))[0] == 0
    visitor = Visitor(chrome, html.as_uri(), offline=True)
    page = visitor.page
    page.goto(html.as_uri())
    page.click("#nav-train")
    page.click("#train-details > summary")
    page.wait_for_selector("#train .tables details")
    answer = answer_of(TRAINS[name])
    for system in get_args(System):
        page.get_by_label(system.upper(), exact=True).check(force=True)
        assert_says(page, answer, system)
    drawn = page.locator("#train svg.chart").first.locator("text").all_text_contents()
    both = ["pulley side", "carry side"] if CARRY in TRAINS[name] else []
    assert [t for t in drawn if t.endswith(" side")] == both
    visitor.close()
    assert (visitor.wrong, visitor.elsewhere) == ([], [])


def assert_says(page: Page, answer: dict[str, Any], system: System) -> None:
    verdict = answer["verdict"]
    said = page.locator("#train .verdict .headline").first.inner_text()
    assert said.partition(" ")[2].endswith(worded(verdict["text"], system))
    sentences = page.locator("#train .verdict li").all_inner_texts()
    assert sentences == [worded(s, system) for s in verdict["sentences"]]
    shown = tables_of(page)
    for table in answer["tables"]:
        title = worded(table["title"], system)
        if title.startswith(("Drives", "Checks", "Least")):
            values = [[worded(v, system) for v in row["values"]] for row in table["rows"]]
            cells = [row[-len(values[0]) - 1 : -1] for row in shown[title]]
            assert cells == values, title


def test_drive_page_shows_every_pulley(chrome: Browser, tmp_path: Path) -> None:
    html = tmp_path / "train.html"
    file = EXAMPLES / "tandem-fabric.toml"
    assert wraparc("page", str(file), "-o", str(html))[0] == 0
    told = json.loads(wraparc("solve", str(file), "--json", "-")[1])
    titles = [f"{arc['load_case']}: {arc['pulley']}" for arc in told["arcs"]]
    visitor = Visitor(chrome, html.as_uri(), offline=True)
    page = visitor.page
    page.goto(html.as_uri())
    page.wait_for_selector("html:not(.stale) #drive .screen[data-whole]")
    visitor.unfold()
    rows = page.locator("#drive .t-summary tbody tr").all_text_contents()
    assert [row[: len(t)] for row, t in zip(rows, titles, strict=True)] == titles
    visitor.close()
    assert (visitor.wrong, visitor.elsewhere) == ([], [])


#: A machine whose functions end in other digits, a few units in their last place.
OTHER_MACHINE = """
  window.asked = 0;
  for (const name of ["exp", "expm1", "log", "log1p", "sqrt", "sinh", "cosh", "tan", "atan"]) {
    const usual = Math[name];
    Math[name] = (x) => usual(x) * (1 + (((asked++ * SEED) % 7) - 3) * 2 ** -52);
  }
  delete window.Worker;  // which has functions of its own: without it the page does all itself
"""
#: Every word and number of the two pages, those of their pictures too.
WORDS = """() => {
  const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  const found = [];
  while (texts.nextNode())
    if (texts.currentNode.parentElement.closest("#drive, #train"))
      found.push(texts.currentNode.data);
  return found;
}"""


#: Two load cases of equal numbers: which of them governs is no matter of the last digit.
TWICE = HEAD.partition("[[load_case]]")[0] + "".join(
    f'[[load_case]]\nname = "{name}"\n' for name in ("once", "again")
)
READ_ALIKE = {
    "twice": TWICE,
    "braking, US units": (EXAMPLES / "downhill-braking.toml").read_text("utf-8"),
    "motors": TRAINS["motors"],
    "take-up between": TRAINS["take-up between"],
}


@pytest.mark.parametrize("name", READ_ALIKE)
def test_a_page_reads_the_same_on_another_machine(
    chrome: Browser, tmp_path: Path, name: str
) -> None:
    # expected: its words by the functions of this machine
    file, html = tmp_path / "drive.toml", tmp_path / "page.html"
    file.write_text(READ_ALIKE[name], "utf-8")
    assert wraparc("page", str(file), "-o", str(html))[0] == 0
    texts = []
    for seed in (0, 3):
        visitor = Visitor(chrome, html.as_uri(), fresh=bool(seed), offline=True)
        if seed:
            visitor.context.add_init_script(OTHER_MACHINE.replace("SEED", str(seed)))
        page = visitor.page
        page.goto(html.as_uri())
        page.wait_for_selector("html:not(.stale) #drive .screen[data-whole]")
        visitor.unfold()
        if name == "twice":
            page.wait_for_selector(".ways:not(:has(.bone)) li")
        if name in TRAINS:
            page.click("#nav-train")
            page.click("#train-details > summary")
            page.wait_for_selector("#train .tables details")
        texts.append(page.evaluate(WORDS))
        assert not seed or page.evaluate("window.asked") > 1000
        visitor.close()
        assert (visitor.wrong, visitor.elsewhere) == ([], [])
    assert len(texts[0]) > 300
    for moved in texts[1:]:
        assert [pair for pair in zip_longest(texts[0], moved) if pair[0] != pair[1]] == []


#: Draws the screen anew at each question to the worker, and keeps how long its list of changes is.
DRAWN_OFTEN = """
  window.lengths = [];
  const ask = Worker.prototype.postMessage;
  let turn = 0;
  Worker.prototype.postMessage = function (...asked) {
    const checks = document.querySelectorAll("#drive .checks .list button");
    checks[turn++ % checks.length]?.click();
    requestAnimationFrame(() => {
      window.lengths.push(document.querySelectorAll(".ways li").length);
      ask.apply(this, asked);
    });
  };
"""


def test_what_would_change_the_creep_is_shown_whole_at_once(
    chrome: Browser, tmp_path: Path
) -> None:
    # expected: no part of the list at any time, however often the screen is drawn meanwhile
    html = tmp_path / "page.html"
    file = EXAMPLES / "head-drive-fabric.toml"
    assert wraparc("page", str(file), "-o", str(html))[0] == 0
    visitor = Visitor(chrome, html.as_uri(), fresh=True, offline=True)
    visitor.context.add_init_script(DRAWN_OFTEN)
    visitor.page.goto(html.as_uri())
    visitor.page.wait_for_selector(".ways:not(:has(.bone)) li")
    whole = visitor.page.locator(".ways li").count()
    lengths = visitor.page.evaluate("window.lengths")
    assert len(lengths) > whole > 3
    assert set(lengths) <= {0, whole}
    visitor.close()
    assert (visitor.wrong, visitor.elsewhere) == ([], [])


SHOWN = """
  const told = document.querySelector("#train .verdict .headline");
  const tables = document.querySelectorAll("#train .tables details");
  return told && tables.length ? {
    headline: told.textContent,
    sentences: [...document.querySelectorAll("#train .verdict li")].map((x) => x.textContent),
    tables: Object.fromEntries([...tables].map((d) => [
      d.querySelector("summary").textContent.trim(),
      [...d.querySelectorAll("tbody tr")].map((r) =>
        [...r.cells].map((c) => c.textContent.trim().replace(/^[✓▲✕] /, ""))),
    ])),
  } : null;
"""


def assert_firefox_says(browser: Firefox, folder: Path, name: str) -> None:
    """Hold what the page of a train says in Firefox against the program."""
    file, html = folder / "train.toml", folder / "train.html"
    file.write_text(TRAINS[name], "utf-8")
    assert wraparc("page", str(file), "-o", str(html))[0] == 0
    browser.open("about:blank")
    browser.open(html.as_uri() + "#/train")
    wait_for(lambda: browser.run(SHOWN) is not None)
    shown, answer = browser.run(SHOWN), answer_of(TRAINS[name])
    verdict = answer["verdict"]
    assert shown["headline"].strip().endswith(worded(verdict["text"], "si"))
    assert shown["sentences"] == [worded(s, "si") for s in verdict["sentences"]]
    for table in answer["tables"]:
        title = worded(table["title"], "si")
        if title.startswith("Drives"):
            values = [[worded(value) for value in row["values"]] for row in table["rows"]]
            cells = [row[-len(values[0]) - 1 : -1] for row in shown["tables"][title]]
            assert cells == values


def test_motors_far_too_large_are_asked_about_as_by_solve(chrome: Browser, tmp_path: Path) -> None:
    """1100 kW where 110 kW is meant: the words of `wraparc solve`."""
    text = MOTORS.replace('"110 kW"', '"1100 kW"')
    file, html = tmp_path / "train.toml", tmp_path / "train.html"
    file.write_text(text, "utf-8")
    verdict = judge(solve_train(train_from_text(text), raise_on_failure=False))
    (asked,) = (c for c in verdict.missed if c.name == "usual_sizes")
    said = in_units(asked.text, "si")
    assert "is outside the usual" in said
    assert "rated_power" in in_units(asked.action_text, "si")
    assert wraparc("page", str(file), "-o", str(html))[0] == 0
    visitor = Visitor(chrome, html.as_uri(), offline=True)
    page = visitor.page
    page.goto(html.as_uri())
    page.click("#nav-train")
    page.get_by_text(said).first.wait_for(state="attached")
    visitor.close()
