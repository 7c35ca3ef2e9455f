"""The section Load of the drive page: it shows and changes the load case that is shown."""

import base64
import contextlib
import json
import zlib
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Locator, Page, expect

from cli.running import wraparc
from web.browser import Calculator, Visitor, show_case
from web.calculators import client
from web.test_advice import downloaded
from web.test_api import post
from web.test_inputs import kept
from web.test_pages import in_the_address
from worded import worded
from wraparc.errors import InputError
from wraparc.schema.source import parse
from wraparc.train import Train
from wraparc.train.file import load_drive_or_train
from wraparc.units import System

pytestmark = pytest.mark.usefixtures("solved_once")
EXAMPLES = Path(__file__).parents[2] / "examples"
HEAD = (EXAMPLES / "head-drive-fabric.toml").read_text("utf-8")


def arcs(file: Path) -> dict[str, Any]:
    """Return the arcs that `wraparc solve` finds, by load case."""
    told = json.loads(wraparc("solve", str(file), "--json", "-")[1])
    return {arc["load_case"]: arc for arc in told["arcs"]}


@pytest.fixture
def visitor(long_visit: Visitor) -> Visitor:
    return long_visit


def opened(visitor: Visitor, folder: Path, text: str, *, governing: bool = False) -> Page:
    """Open a drive file, and look at the load case that governs, or that the program means."""
    file = folder / "before.toml"
    file.write_text(text, "utf-8")
    visitor.anew(lambda: visitor.load(file), None)
    if not governing:
        with contextlib.suppress(InputError):
            show_case(visitor.page, meant(file))
    visitor.unfold()
    visitor.solved()
    return visitor.page


def meant(file: Path) -> str:
    """Return the load case that the program means where none is named."""
    found = load_drive_or_train(file)
    return found.case().name if isinstance(found, Train) else found.load_case().name


def look(page: Page, case: str) -> Locator:
    """Press the chip of a load case; return the form, which then shows its load."""
    page.locator("#cases").get_by_role("button", name=case).click()
    found = page.get_by_role("group", name=f"Load: {case}", exact=True)
    expect(found).to_be_visible()
    return page.get_by_role("form", name="Drive")


def creep(page: Page) -> str:
    return page.locator("#drive .figures b").first.inner_text()


def test_typed_tension_goes_to_the_load_case_that_is_shown(
    visitor: Visitor, tmp_path: Path
) -> None:
    # expected: the file before with one line of the case "start" changed, and `wraparc solve` of it
    page = opened(visitor, tmp_path, HEAD)
    load = look(page, "start")
    expect(load.get_by_label("Exit tension T2", exact=True)).to_have_value("60")
    load.get_by_label("Exit tension T2", exact=True).fill("70")
    visitor.solved()
    after = downloaded(page, tmp_path)
    line = 'pulley.head.exit_tension = "60 kN"'
    assert after.read_text("utf-8") == HEAD.replace(line, line.replace("60", "70"))
    said = arcs(after)["start"]
    assert said["exit_tension"] == 70e3
    assert said["effective_tension"] == 126e3
    assert creep(page) == f"{1e3 * said['exit_creep']:.1f} mm"
    # nothing else has changed, and design is still what is edited where design is shown
    assert arcs(after)["design"] == arcs(tmp_path / "before.toml")["design"]
    design = look(page, "design")
    expect(design.get_by_label("Exit tension T2", exact=True)).to_have_value("60")
    page.click("#undo")
    start = look(page, "start")
    expect(start.get_by_label("Exit tension T2", exact=True)).to_have_value("60")


def test_load_case_that_takes_over_writes_the_changed_key_alone(
    visitor: Visitor, tmp_path: Path
) -> None:
    # expected: "empty" gives T1 and has T2 of design; what it gives itself is then in the file
    page = opened(visitor, tmp_path, HEAD)
    load = look(page, "empty")
    exit_ = load.get_by_label("Exit tension T2", exact=True)
    expect(exit_).to_have_value("")
    expect(exit_).to_have_attribute("placeholder", "60")
    expect(load).to_contain_text('What is left empty is that of the load case "design"')
    load.get_by_label("Entry tension, slider").focus()
    page.keyboard.press("ArrowRight")
    moved = load.get_by_label("Entry tension T1", exact=True).input_value()
    assert moved != "82"
    doc = kept(page)
    assert doc["load_case"][0]["pulley"]["head"] == {"entry_tension": f"{moved} kN"}
    exit_.fill("65")
    visitor.solved()
    assert kept(page)["load_case"][0]["pulley"]["head"] == {
        "entry_tension": f"{moved} kN",
        "exit_tension": "65 kN",
    }
    said = arcs(downloaded(page, tmp_path))
    assert said["empty"]["exit_tension"] == 65e3
    assert said["design"]["exit_tension"] == said["start"]["exit_tension"] == 60e3
    # left empty it is that of design again
    exit_.fill("")
    exit_.press("Tab")
    visitor.solved()
    assert arcs(downloaded(page, tmp_path))["empty"]["exit_tension"] == 60e3


@pytest.mark.parametrize("case", ["design", "start"])
def test_box_that_is_emptied_to_be_typed_anew_stays(
    visitor: Visitor, tmp_path: Path, case: str
) -> None:
    # the pull of the pair T2 and pull: a box that goes away takes the typing hand's place with it
    page = opened(visitor, tmp_path, HEAD)
    load = look(page, case)
    if case == "design":
        load.get_by_label("Load input").select_option(label="T2 and Te")
    expect(load.get_by_label("Effective tension Te", exact=True)).to_be_visible()
    pull = page.get_by_label("Effective tension Te", exact=True)
    pull.focus()
    for _ in range(4):
        page.keyboard.press("Backspace")
    expect(pull).to_have_value("")
    expect(pull).to_be_focused()
    page.keyboard.type("95")
    visitor.solved()
    where = kept(page)["pulley"][0] if case == "design" else kept(page)["load_case"][1]["pulley"]
    assert {**where, **where.get("head", {})}["effective_tension"] == "95 kN"


FIXED = HEAD.replace("[[load_case]]", '[take_up]\nkind = "fixed"\n\n[[load_case]]', 1).replace(
    'pulley.head.exit_tension = "60 kN"\n', ""
)


def test_a_fixed_take_up_gives_the_tensions_for_a_pull(visitor: Visitor, tmp_path: Path) -> None:
    # expected: half of the sum of 150 kN and 60 kN, less half of the pull, by hand
    page = opened(visitor, tmp_path, FIXED)
    load = look(page, "start")
    expect(load).to_contain_text("the take-up fixes the sum of both")
    entry = load.get_by_label("Entry tension T1", exact=True)
    expect(entry).to_have_attribute("placeholder", "168")
    load.get_by_label("Effective tension Te", exact=True).fill("110")
    expect(entry).to_have_attribute("placeholder", "160")
    visitor.solved()
    assert kept(page)["load_case"][1]["pulley"]["head"] == {"effective_tension": "110 kN"}
    said = arcs(downloaded(page, tmp_path))["start"]
    assert (said["entry_tension"], said["exit_tension"]) == (160e3, 50e3)


def test_other_two_numbers_of_a_load_case_leave_the_others_as_they_are(
    visitor: Visitor, tmp_path: Path
) -> None:
    # expected: `wraparc solve` before and after
    page = opened(visitor, tmp_path, HEAD)
    load = look(page, "start")
    load.get_by_label("Load input").select_option(label="T1 and Power")
    expect(load.get_by_label("Power", exact=False).first).to_have_value("378")
    visitor.solved()
    after = downloaded(page, tmp_path)
    assert kept(page)["load_case"][1]["pulley"]["head"] == {
        "entry_tension": "186 kN",
        "power": "378 kW",
    }
    for name, arc in arcs(tmp_path / "before.toml").items():
        assert arcs(after)[name]["exit_creep"] == pytest.approx(arc["exit_creep"], rel=1e-9)


SHARED = HEAD.replace('entry_tension = "150 kN"', "# no entry tension")


def test_tensions_that_load_cases_share_are_called_so(visitor: Visitor, tmp_path: Path) -> None:
    # the pulley gives T2 alone: no load case "design", as the file format has it
    page = opened(visitor, tmp_path, SHARED)
    expect(page.locator("#cases [aria-pressed=true]")).to_contain_text("empty")
    page.get_by_role("button", name="Show the load that all share").click()
    shared = page.get_by_role("group", name="Load: shared by all load cases", exact=True)
    expect(shared).to_be_visible()
    expect(
        page.get_by_role("form", name="Drive").get_by_label("Exit tension T2", exact=True)
    ).to_have_value("60")
    load = look(page, "empty")
    expect(load.get_by_label("Entry tension T1", exact=True)).to_have_value("82")
    load.get_by_label("Entry tension T1", exact=True).fill("84")
    visitor.solved()
    assert kept(page)["load_case"][0]["pulley"]["head"] == {"entry_tension": "84 kN"}
    assert set(arcs(downloaded(page, tmp_path))) == {"empty", "start"}
    page.get_by_role("button", name="Show the load that all share").click()
    expect(shared).to_be_visible()


def test_new_load_case_is_shown_and_takes_everything_over(visitor: Visitor, tmp_path: Path) -> None:
    page = opened(visitor, tmp_path, HEAD.partition("[[load_case]]")[0])
    expect(page.get_by_role("group", name="Load", exact=True)).to_be_visible()
    page.click("#add-case")
    expect(page.get_by_role("group", name="Load: case 2", exact=True)).to_be_visible()
    load = page.get_by_role("form", name="Drive")
    expect(load.get_by_label("Entry tension T1", exact=True)).to_have_attribute(
        "placeholder", "150"
    )
    load.get_by_label("Entry tension T1", exact=True).fill("140")
    visitor.solved()
    said = arcs(downloaded(page, tmp_path))
    assert {name: arc["entry_tension"] for name, arc in said.items()} == {
        "design": 150e3,
        "case 2": 140e3,
    }


def test_units_and_conditions_are_views_of_the_load_case(visitor: Visitor, tmp_path: Path) -> None:
    page = opened(visitor, tmp_path, 'condition = ["dry", "wet"]\n' + HEAD)
    page.locator("#cases").get_by_role("button", name="empty, wet").click()
    expect(page.get_by_role("group", name="Load: empty", exact=True)).to_be_visible()
    load = page.get_by_role("form", name="Drive")
    before = kept(page)
    page.get_by_label("US", exact=True).check(force=True)
    expect(load.get_by_label("Exit tension T2", exact=True)).to_have_attribute(
        "placeholder", "13488.5"
    )
    assert kept(page) == before
    load.get_by_label("Exit tension T2", exact=True).fill("14000")
    visitor.solved()
    after = kept(page)
    assert after["load_case"][0]["pulley"]["head"].pop("exit_tension") == "14000 lbf"
    assert after == before
    # a draft opens at the load case that was shown, and Load with it
    page.reload()
    expect(load.get_by_label("Exit tension T2", exact=True)).to_have_value("14000")


def test_value_of_a_load_case_is_sought(visitor: Visitor, tmp_path: Path) -> None:
    # expected: `wraparc seek` for the same key path and load case
    page = opened(visitor, tmp_path, HEAD)
    load = look(page, "start")
    load.get_by_role("button", name="Help: Exit tension").click()
    load.get_by_role("button", name="Which value gives a result?").click()
    page.fill("#seek-value", "9 mm")
    page.keyboard.press("Enter")
    field = "load_case.start.pulley.head.exit_tension"
    _, out, _ = wraparc(
        "seek", str(tmp_path / "before.toml"), "--vary", field, "--result", "exit_creep",
        "--value", "9 mm", "--load-case", "start", "--json", "-",
    )  # fmt: skip
    (value,) = (x["value"] for x in json.loads(out)["found"])
    page.locator(".seek").get_by_role("button", name="Use").click()
    visitor.solved()
    assert creep(page) == "9.00 mm"
    said = arcs(downloaded(page, tmp_path))["start"]["exit_tension"]
    assert said == pytest.approx(value, rel=1e-5)


#: The example with the empty conveyor first: each case gives its own tensions.
EMPTY_FIRST = HEAD.replace('entry_tension = "150 kN"       # T1\n', "").replace(
    '[[load_case]]\nname = "start"',
    '[[load_case]]\nname = "full"\npulley.head.entry_tension = "150 kN"\n\n'
    '[[load_case]]\nname = "start"',
)


def test_the_case_that_governs_is_looked_at_and_the_chosen_one_stays(
    visitor: Visitor, calculator: Calculator, tmp_path: Path
) -> None:
    # where none is named that is the start, which creeps most
    page = opened(visitor, tmp_path, EMPTY_FIRST, governing=True)
    pressed = page.locator("#cases [aria-pressed=true]")
    expect(pressed).to_contain_text("start")
    show_case(page, "full")
    expect(pressed).to_contain_text("full")
    t1 = page.locator("#f-load_case-1-pulley-head-entry_tension")
    expect(t1).to_have_value("150")
    # it stays the one that is looked at, also where another pulls more then
    t1.fill("70")
    visitor.solved()
    expect(pressed).to_contain_text("full")
    page.wait_for_url(lambda url: url.count("/") > 4 and in_the_address(url)["c"] == "full")
    link = json.dumps({**in_the_address(page.url), "c": "", "d": parse(EMPTY_FIRST)})
    packer = zlib.compressobj(wbits=-15)
    told = base64.urlsafe_b64encode(packer.compress(link.encode()) + packer.flush()).decode()
    other = Visitor(calculator[0], f"{page.url.partition('#')[0]}#/drive/{told.rstrip('=')}")
    other.open("drive", case=None)
    expect(other.page.locator("#cases [aria-pressed=true]")).to_contain_text("start")
    other.close()


@pytest.mark.parametrize(
    ("path", "more"), [("solve/fast", {}), ("compare", {"what": "laggings"}), ("across", {})]
)
def test_the_server_means_the_same_case(path: str, more: dict[str, Any]) -> None:
    with client() as api:
        found = post(api, f"/{path}", document=parse(EMPTY_FIRST), **more)
    assert found["load_case"] == "full"


def test_the_server_means_the_same_case_of_a_train() -> None:
    train = parse((EXAMPLES / "tandem-fabric.toml").read_text("utf-8"))
    light = {"name": "heavy", "train": {"effective_tension": "110 kN"}}
    train["load_case"].append(light)
    with client() as api:
        assert post(api, "/solve/fast", document=train)["load_case"] == "heavy"


@pytest.mark.parametrize("case", [None, "design", "start"])
def test_across_says_one_creep(case: str | None) -> None:
    # the sentence and the table are of one load case, also where another one is worse
    worn = parse((EXAMPLES / "worn-head-drive-fabric.toml").read_text("utf-8"))
    start = {"effective_tension": "110 kN", "exit_tension": "60 kN"}
    worn["load_case"] = [{"name": "start", "kind": "starting", "pulley": {"head": start}}]
    with client() as api:
        found = post(api, "/across", document=worn, load_case=case)
    (row,) = (r for r in found["tables"][0]["rows"] if r["name"] == "largest_creep")
    systems: tuple[System, System] = ("si", "us")
    for system in systems:
        creep = worded(row["values"][0], system)
        assert f"Creep {creep} " in worded(found["verdict"]["text"], system)
    assert found["load_case"] == (case or "start")
