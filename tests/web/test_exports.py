"""Files that the page takes away: those of the command line, and both ways."""

import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as ET

import pytest
from PIL import Image
from playwright.sync_api import Page, expect

from cli.running import wraparc
from web.browser import PHONE, READY, Calculator, Visitor, choose_test, turn
from web.calculators import wait_for
from wraparc.schema.source import parse

pytestmark = pytest.mark.usefixtures("solved_once")

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture(scope="module")
def clerk(calculator: Calculator) -> Iterator[Visitor]:
    browser, server = calculator
    found = Visitor(browser, server.address)
    yield found
    found.close()
    assert found.wrong == []


def exported(page: Page, words: str, into: Path) -> Path:
    """Take a file away by the menu, or from the page Report."""
    if words.startswith("Pictures"):
        page.click("#file > summary")
    else:
        page.click("#tab-report")
    with page.expect_download() as arriving:
        page.get_by_role("button", name=words, exact=True).click()
    file = into / arriving.value.suggested_filename
    arriving.value.save_as(file)
    return file


def opened(file: Path) -> Image.Image:
    with Image.open(file) as picture:
        return picture.convert("RGB")


def downloaded(page: Page, words: str, into: Path) -> Path:
    with page.expect_download() as arriving:
        page.get_by_role("button", name=words, exact=True).click()
    file = into / arriving.value.suggested_filename
    arriving.value.save_as(file)
    return file


@pytest.mark.parametrize(
    ("title", "units"),
    [("Head drive, ROM conveyor", "US"), ("Tandem head drive, fabric belt", "SI")],
)
def test_results_and_profiles_are_the_files_of_the_command_line(
    visitor: Visitor, tmp_path: Path, title: str, units: str
) -> None:
    # expected: what `wraparc solve --json --csv` writes of the drive file that the page downloads
    page = visitor.open("drive")
    if page.locator("#title").inner_text() != title:
        visitor.example(title)
    expect(page.locator("#title")).to_have_text(title)
    if title.startswith("Tandem"):  # which several pulleys open on
        page.wait_for_selector(READY["train"])
        turn(page, "drive")
    page.get_by_label(units, exact=True).check(force=True)
    visitor.solved()
    assert_files_are_those_of_solve(page, tmp_path, units.lower())


def assert_files_are_those_of_solve(page: Page, folder: Path, units: str) -> None:
    with page.expect_download() as arriving:
        page.keyboard.press("Control+s")
    drive = folder / arriving.value.suggested_filename
    arriving.value.save_as(drive)
    results = exported(page, "Results (JSON)", folder)
    profiles = exported(page, "Profiles along the wrap (CSV)", folder)
    assert {results.stem, profiles.stem} == {drive.stem}
    how = ("solve", str(drive), "--units", units)
    _, out, _ = wraparc(*how, "--json", "-")
    told = json.loads(results.read_text("utf-8"))
    assert told["drive"].pop("file") == drive.name
    expected = json.loads(out)
    del expected["drive"]["file"]
    near = {k: pytest.approx(v, rel=1e-9) for k, v in leaves(expected).items() if is_number(v)}
    assert leaves(told) == leaves(expected) | near
    # ten digits, in the units looked at
    wraparc(*how, "--csv", str(folder / "expected.csv"))
    assert profiles.read_bytes() == (folder / "expected.csv").read_bytes()


def leaves(value: Any, path: str = "") -> dict[str, Any]:
    """Return every number and text of a document by its place, without what rounding left."""
    if isinstance(value, dict):
        return {k: v for key in value for k, v in leaves(value[key], f"{path}.{key}").items()}
    if isinstance(value, list):
        parts = (leaves(item, f"{path}[{i}]") for i, item in enumerate(value))
        return {k: v for part in parts for k, v in part.items()}
    return {} if path.endswith("identity_error") else {path: value}


def is_number(value: Any) -> bool:
    return isinstance(value, float)


def test_pictures_stand_for_themselves_in_the_colours_of_paper(
    calculator: Calculator, tmp_path: Path
) -> None:
    # expected: the courses that the page draws; its colours for paper (--blue, --red of frame.css)
    browser, server = calculator
    visitor = Visitor(browser, server.address, color_scheme="dark")
    page = visitor.open("drive")
    visitor.solved()
    seen = page.locator("#drive .plots path.line").evaluate_all(
        "(all) => all.map((e) => e.getAttribute('d')).filter(Boolean)"
    )
    ground = page.evaluate("getComputedStyle(document.body).backgroundColor")
    text = exported(page, "Pictures of this page (SVG)", tmp_path).read_text("utf-8")
    assert len(seen) >= 6
    assert all(f'd="{course}"' in text for course in seen)
    assert "rgb(0, 114, 178)" in text
    assert "rgb(165, 15, 21)" in text
    assert "Head drive, ROM conveyor; design; wraparc " in text
    assert "limit 6.35 mm" in text
    # the lagging, from little to the most (--q0 to --q3), in words that every program reads
    drawn = page.locator("svg.stage path[stroke^=color-mix]").count()
    assert drawn > 20
    assert len(set(re.findall(r"stroke=\"(rgb\(\d+,\d+,\d+\))\"", text))) > drawn / 2
    assert not any(
        word in text for word in ("color(", "var(", "class=", "style=", "href", "<script")
    )
    # the page itself is as dark as before
    assert page.evaluate("getComputedStyle(document.body).backgroundColor") == ground
    assert page.evaluate("document.documentElement.getAttribute('style')") in (None, "")
    picture = opened(exported(page, "Pictures of this page (PNG)", tmp_path))
    assert picture.width > 1200
    assert picture.getpixel((2, 2)) == (255, 255, 255)
    assert len(picture.getcolors(1_000_000) or ()) > 100
    page.set_viewport_size(PHONE)
    visitor.painted()
    narrow = opened(exported(page, "Pictures of this page (PNG)", tmp_path))
    assert 600 < narrow.width < 900
    assert visitor.wrong == []
    visitor.close()


def test_a_sentence_that_wraps_is_whole_in_the_picture(
    calculator: Calculator, tmp_path: Path
) -> None:
    """In gross slip there is a sentence in the place of curves, broken into lines on the page."""
    browser, server = calculator
    visitor = Visitor(browser, server.address, {"width": 1100, "height": 900})
    page = visitor.open("drive")
    page.fill("#f-pulley-0-exit_tension", "1")
    page.press("#f-pulley-0-exit_tension", "Tab")
    page.wait_for_selector("figure:has-text('gross slip')")
    text = exported(page, "Pictures of this page (SVG)", tmp_path).read_text("utf-8")
    root = ET.fromstring(text)  # noqa: S314 - of our own page
    wide, lines = float(root.attrib["width"]), list(root.iter("{http://www.w3.org/2000/svg}text"))
    told = [e for e in lines if "".join(e.itertext()).strip()]
    sentence = " ".join("".join(e.itertext()) for e in told)
    assert "Gross slip: no curve" in sentence
    # by hand: a letter of such a face takes about half its size
    for e in told:
        if e.attrib.get("text-anchor", "start") != "start":
            continue
        size = float(e.attrib["font-size"].removesuffix("px"))
        assert float(e.attrib["x"]) + 0.5 * size * len("".join(e.itertext())) < wide + size
    visitor.close()


def test_page_without_a_picture_says_so(clerk: Visitor) -> None:
    page = clerk.open("saved")
    page.click("#file > summary")
    page.get_by_role("button", name="Pictures of this page (SVG)").click()
    expect(page.locator("#toast")).to_have_text("There is no picture on this page yet.")


@pytest.mark.parametrize(
    "name", ["load-cases", "sensitivity", "take-up-grid", "tolerances", "wet-dry"]
)
def test_study_file_comes_back_as_it_was(clerk: Visitor, tmp_path: Path, name: str) -> None:
    # expected: the tables of the shipped study; its drive is the one on the page
    page = clerk.open("drive")
    file = EXAMPLES / "studies" / f"{name}.toml"
    clerk.load(file)
    expect(page.locator("#study form")).to_be_visible()
    given = parse(file.read_text("utf-8"))
    expect(page.locator("#study").get_by_label("Title", exact=True)).to_have_value(given["title"])
    saved = downloaded(page, "Download the study file", tmp_path)
    expect(page.locator("#toast")).to_contain_text("names its drive file")
    written = parse(saved.read_text("utf-8"))
    assert written.pop("drive") != given.pop("drive")
    assert written == {"setting": "engineering"} | given
    turn(page, "drive")


def test_study_of_the_page_runs_on_the_command_line(clerk: Visitor, tmp_path: Path) -> None:
    page = clerk.open("drive")
    clerk.example("Head drive, ROM conveyor")
    page = clerk.open("study")
    page.get_by_label("Samples").fill("16")
    page.get_by_label("Samples").press("Tab")
    study = downloaded(page, "Download the study file", tmp_path)
    with page.expect_download() as arriving:
        page.keyboard.press("Control+s")
    drive = tmp_path / arriving.value.suggested_filename
    arriving.value.save_as(drive)
    assert parse(study.read_text("utf-8"))["drive"] == drive.name
    code, out, error = wraparc("study", str(study), "-o", str(tmp_path / "out.parquet"))
    assert code == 0, error
    assert "Study of Head drive, ROM conveyor" in out


def test_test_plan_goes_out_and_comes_back(visitor: Visitor, tmp_path: Path) -> None:
    # expected: the shipped plan, less the tests whose files were not dropped
    page = visitor.open("drive")
    plan = EXAMPLES / "shear_tests" / "plan.toml"
    given = parse(plan.read_text("utf-8"))
    visitor.load(plan)
    expect(page.locator("#t-lagging-name")).to_have_value("diamond-rubber-virtual")
    names = ["dry-0034kPa-2.TRA", "dry-0103kPa-2.MTR", "wet-0207kPa-1.dat"]
    page.set_input_files("#test-files", [plan.parent / name for name in names])
    expect(page.locator("#tests .rows-of li")).to_have_count(len(names))
    wait_for(lambda: page.locator("#tests .rows-of .g.warn").count() == 0)
    choose_test(page, "wet-0207kPa-1.dat")
    expect(page.get_by_label("Condition of wet-0207kPa-1.dat")).to_have_value("wet")
    choose_test(page, "dry-0103kPa-2.MTR")
    expect(page.get_by_label("Set pressure of dry-0103kPa-2.MTR")).to_have_value("103 kPa")
    page.evaluate("document.getElementById('tests-details').open = true")
    written = parse(downloaded(page, "Download the test plan", tmp_path).read_text("utf-8"))
    given["test"] = [test for test in given["test"] if test["file"] in names]
    assert written == given
