"""The page across the width: profiles drawn and loaded, and its four questions."""

import json
import re
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from cli.running import wraparc
from web.browser import Visitor
from wraparc.answer.sheet import named, shown

#: Counts what a hand does: presses of the mouse, wherever they land.
_COUNT = "window.presses = 0; addEventListener('pointerdown', () => { presses += 1; }, true);"
_CHOSEN = 2  # presses to choose from a list, or a file in its window: outside the page


@pytest.fixture
def visitor(visitor: Visitor) -> Visitor:
    visitor.page.add_init_script(_COUNT)
    return visitor


def presses(page: Page) -> int:
    return int(page.evaluate("window.presses"))


def settled(page: Page) -> None:
    """Wait until the answer is that of what stands in the form."""
    expect(page.locator("#across [data-stands=computing]")).to_have_count(0)


def downloaded(page: Page, folder: Path) -> Path:
    with page.expect_download() as arriving:
        page.keyboard.press("Control+s")
    file = folder / "drive.toml"
    arriving.value.save_as(file)
    return file


def figure(page: Page, title: str) -> str:
    row = page.locator("#across .t-answer tr", has=page.locator(f"th:text-is('{title}')"))
    # what is far from the screen is not laid out, and has no inner text yet
    return row.locator("td.num").text_content() or ""


def load(page: Page, file: Path) -> None:
    with page.expect_file_chooser() as asked:
        page.click("#load-profile")
    asked.value.set_files(file)


def test_will_this_measured_wear_heal(visitor: Visitor, tmp_path: Path) -> None:
    # expected: what the march of wear says of a driving pulley
    file = tmp_path / "gauge.csv"
    rows = [(-22, 0.457), (-11, 0.413), (0, 0.374), (11, 0.414), (22, 0.456)]
    lines = [f"{y};{h}" for y, h in rows]
    file.write_text("\n".join(["position [in];thickness [in]", *lines]) + "\n", "utf-8")
    page = visitor.open("drive")
    visitor.open("across")
    load(page, file)
    expect(page.locator("#toast")).to_contain_text("5 readings of thickness")
    expect(page.locator("#x-pulley-0-across-worn_depth-rows-0-0")).to_have_value("-558.8")
    settled(page)
    page.click("#ask-hours")
    page.fill("#ask-hours", "18 000")
    with page.expect_request("**/across/wear") as sent:
        page.click("#ask-wear")
    assert (sent.value.post_data_json or {})["hours"] == 18000
    told = page.locator("#question-wear .verdict .headline")
    expect(told).to_contain_text("Heals: wear evens it out")
    assert presses(page) + _CHOSEN < 10
    expect(page.locator("#question-wear")).to_contain_text("Re-lag after")


def test_is_build_up_on_one_side_serious_and_may_this_pulley_be_crowned(visitor: Visitor) -> None:
    page = visitor.open("drive")
    visitor.example("Crowned and dirty head drive, overland conveyor")
    before = presses(page)
    visitor.open("across")
    page.click("#across .tabs button:has-text('Build-up')")
    page.click("#shape-side")
    settled(page)
    expect(page.locator("#across-result .verdict .headline")).to_contain_text(
        re.compile(r"Edge tension [\d.]+ kN/m exceeds the [\d.]+ kN/m limit \(")
    )
    assert presses(page) - before < 10
    # may it be crowned?
    before = presses(page)
    page.click("#across .tabs button >> nth=0")
    box = page.locator("#x-pulley-0-across-shell_profile-crown")
    box.click()
    box.fill("1")
    box.press("Tab")
    settled(page)
    expect(page.locator("#across-result")).to_contain_text("is not allowed with steel cord")
    assert presses(page) - before < 10
    # cleared: the crown goes, what was there of the shell with it
    box.fill("")
    box.press("Tab")
    settled(page)
    expect(page.locator("#across-result")).not_to_contain_text("is not allowed with steel cord")
    page.keyboard.press("Control+z")
    expect(box).to_have_value("1")


def test_does_thicker_lagging_help(visitor: Visitor) -> None:
    page = visitor.open("drive")
    visitor.example("Worn head drive, ROM conveyor")
    before = presses(page)
    visitor.open("across")
    # one verdict, one action: that of the card is what was tried
    tried = page.locator("#across .say .line", has_text="Action").first
    expect(tried).to_contain_text("full-ceramic")
    below = page.locator("#across-result .verdict .lines")
    expect(below).to_contain_text("Use lagging full-ceramic")
    expect(below).not_to_contain_text("Try an even pulley face")
    page.click("#ask-thickness")
    told = page.locator("#question-thickness .verdict .headline")
    expect(told).to_contain_text(re.compile(r"takes \d+ % off the unevenness .* creep by \+\d+ %"))
    assert presses(page) - before < 10
    # what cannot be read is said, and no older answer stands beside it
    for box, text, button, says in (
        ("#ask-thicknesses", "8 mm", "#ask-thickness", "two or more"),
        ("#ask-hours", "3,5", "#ask-wear", "a plain number"),
        ("#ask-passes", "soon", "#ask-wear", "a plain number"),
    ):
        page.fill(box, text)
        page.click(button)
        expect(page.locator("#toast")).to_contain_text(says)
        page.fill(box, "")
        expect(told).to_have_count(0)
    page.fill("#ask-thicknesses", "8,5 mm, 12 mm")
    page.click("#ask-thickness")
    expect(page.locator("#question-thickness")).to_contain_text('Write "8.5 mm"')


def test_a_drawn_profile_is_what_the_command_line_solves(visitor: Visitor, tmp_path: Path) -> None:
    # expected: what `wraparc solve` says of the file that the page downloads
    page = visitor.open("across")
    page.fill("#shape-height", "1 mm")
    page.click("#shape-middle")
    settled(page)
    grip = page.locator("#across .grip").nth(2)
    box = grip.bounding_box()
    assert box is not None
    page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    page.mouse.down()
    page.mouse.move(box["x"] + box["width"] / 2 + 40, box["y"] + 25, steps=4)
    page.mouse.up()
    grip = page.locator("#across .grip").nth(2)
    dragged = grip.get_attribute("aria-valuetext") or ""
    assert float(dragged.split()[0]) > 1.0  # down is deeper
    grip.press("ArrowUp")
    lifted = f"{float(dragged.split()[0]) - 0.1:.4g} mm"
    expect(grip).to_have_attribute("aria-valuetext", lifted)
    page.click("#across .tabs button:has-text('Build-up')")
    page.click("#add-point")
    page.fill("#x-pulley-0-across-build_up-1-1", "0.02 in")
    page.press("#x-pulley-0-across-build_up-1-1", "Tab")
    page.fill("#x-pulley-0-across-misalignment", "1.5")
    page.press("#x-pulley-0-across-misalignment", "Tab")
    page.select_option("#across-before", "pulley")
    page.fill("#x-pulley-0-across-before-distance", "2.5 m")
    page.press("#x-pulley-0-across-before-distance", "Tab")
    settled(page)
    file = downloaded(page, tmp_path)
    code, out, _ = wraparc("solve", str(file), "--json", "-")
    assert code == 0
    answer = json.loads(out)
    told = next(a for a in answer["across"] if a["load_case"] == "design")  # which is looked at
    running = shown(named("largest_running_tension", told["largest_running_tension"]), "si")
    assert figure(page, "Maximum tension, running") == running
    assert figure(page, "Wear, maximum over mean") == shown(
        named("energy_unevenness", told["energy_unevenness"]), "si"
    )
    text = file.read_text("utf-8")
    for words in ("across = {", "worn_depth", lifted, "0.02 in", "1.5 mm/m", "2.5 m"):
        assert words in text
    # undo goes back through all of it
    given = page.locator("#across .tabs .mark:visible")
    expect(given).to_have_count(2)
    for _ in range(40):
        page.keyboard.press("Control+z")
    expect(given).to_have_count(0)


def test_errors_stand_at_the_field(visitor: Visitor) -> None:
    page = visitor.open("across")
    page.click("#shape-slope")
    cell = page.locator("#x-pulley-0-across-worn_depth-1-0")
    cell.fill("900")
    cell.press("Tab")
    wrong = page.locator("#across .editor .error").first
    expect(wrong).to_contain_text("must be between -600 mm and 600 mm, the edges")
    cell.fill("1e99")  # so far off that no picture has a number for it
    cell.press("Tab")
    expect(wrong).to_contain_text("must be between -600 mm and 600 mm, the edges")
    cell.fill("-700")
    cell.press("Tab")
    expect(wrong).to_contain_text(re.compile("ascend|the edges"))
    cell.fill("-600 mm")
    cell.press("Tab")
    expect(wrong).to_contain_text("must ascend")
    cell.fill("600 mm")
    cell.press("Tab")
    expect(page.locator("#across .editor .error:not(:empty)")).to_have_count(0)
    value = page.locator("#x-pulley-0-across-worn_depth-1-1")
    value.fill("2 kg")
    value.press("Tab")
    row = page.locator("#across .rows .wrong .error")
    expect(row).to_contain_text("kg")
    value.fill("")
    value.press("Tab")
    expect(row).to_be_visible()
    value.fill("0.08 in")
    value.press("Tab")
    expect(page.locator("#across .rows .wrong")).to_have_count(0)
    page.get_by_label("US", exact=True).check(force=True)
    expect(value).to_have_value("0.08")
    expect(cell).to_have_value("23.622")
    page.click("#clear-points")
    expect(page.locator("#across .grip")).to_have_count(0)


def test_a_map_of_each_quantity_and_a_slack_belt(visitor: Visitor) -> None:
    page = visitor.open("drive")
    visitor.example("Worn head drive, ROM conveyor")
    visitor.open("across")
    for quantity, words in (
        ("shear_stress", "Shear stress over wrap angle"),
        ("creep", "Creep over wrap angle"),
        ("wrap_pressure", "Wrap pressure over wrap angle"),
        ("frictional_energy", "Frictional energy over wrap angle"),
    ):
        page.locator(f"input[name=across-quantity][value={quantity}]").check(force=True)
        expect(page.locator("#across svg.map")).to_have_attribute("aria-label", re.compile(words))
        expect(page.locator("#across svg.widths path.course")).to_have_count(1)
    # tension has three courses over the same width: at entry, exit and standstill
    page.locator("input[name=across-quantity][value=tension]").check(force=True)
    expect(page.locator("#across svg.widths path.course")).to_have_count(3)
    # a slack belt is told in the verdict
    page.click("#across .tabs button:has-text('Build-up')")
    page.fill("#shape-height", "40 mm")
    page.click("#shape-side")
    settled(page)
    told = page.locator("#across-result .verdict").first
    expect(told).to_contain_text("the strip lacks")
