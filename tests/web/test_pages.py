"""The pages in a real browser: what an engineer does with them, and what comes of it."""

import base64
import contextlib
import json
import re
import zlib
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Error, Route, expect

from cli.running import wraparc
from web.browser import (
    PAGES,
    REQUESTS,
    STEPS,
    STUDY,
    TABS,
    Calculator,
    Visitor,
    evaluated,
    turn,
    unfold_plan,
)
from web.calculators import TOKEN, document, wait_for
from wraparc.checks.check import INFO_CHECKS
from wraparc.schema.emit import document_text
from wraparc.train.keys import TRAIN_FILE
from wraparc.units import RESULT_DIGITS, display, on_safe_side


def key_figure(visitor: Visitor, name: str) -> str:
    return visitor.page.locator(f"#drive .figures > div:has(dt:text-is('{name}')) b").inner_text()


def in_the_address(url: str) -> Any:
    """Return the design that an address holds: JSON, deflated, in base64 for addresses."""
    _, _, state = url.partition("#/")[2].partition("/")
    return json.loads(zlib.decompress(base64.urlsafe_b64decode(state + "=="), wbits=-15))


def test_every_page_opens_without_a_word_of_complaint(visitor: Visitor) -> None:
    for name in PAGES:
        page = visitor.open(name)
        assert page.locator("main > section:visible").count() == 1
        assert page.title().endswith("wraparc")
        if name in TABS:
            assert page.get_attribute(f"#tab-{TABS[name]}", "aria-current") == "page"


def test_drive_page_shows_the_answer_of_the_command_line(visitor: Visitor, tmp_path: Path) -> None:
    # expected: what `wraparc solve` prints of the file that the page downloads
    page = visitor.open("drive")
    page.fill("#f-pulley-0-exit_tension", "64.5")
    page.press("#f-pulley-0-exit_tension", "Tab")
    page.select_option("#f-pulley-0-lagging", "medium-ceramic")
    visitor.solved()
    with page.expect_download() as arriving:
        page.keyboard.press("Control+s")
    file = tmp_path / "downloaded.toml"
    arriving.value.save_as(file)
    code, out, _ = wraparc("solve", str(file), "--method", "both", "--json", "-")
    told = json.loads(out)
    first = told["arcs"][0]
    assert code == 0
    assert first["exit_tension"] == 64500.0
    assert key_figure(visitor, "Creep at exit") == f"{1e3 * first['exit_creep']:.2f} mm"
    capacity = first["creep_limit_margin"]
    assert key_figure(visitor, "Margin to the creep limit") == f"{capacity:.2f}"
    angle = first["peak_shear_angle"] * 57.29577951308232
    assert key_figure(visitor, "Peak shear angle") == f"{angle:.2f} deg"
    # the paper's integration stands beside it, in a table that is laid out when it is scrolled to
    paper = next(a for a in told["arcs"] if a["method"] == "paper")
    cells = page.locator(".t-answer tbody tr").first.locator("td.num").all_text_contents()
    assert cells == [f"{1e3 * a['exit_creep']:#.3g} mm" for a in (first, paper)]
    # capstan, CEMA and DIN too; what is far below is laid out when it is scrolled to
    page.locator(".t-comparison").scroll_into_view_if_needed()
    beside = page.text_content(".t-comparison") or ""
    assert all(word in beside for word in ("CEMA", "DIN 22101", "slipping arc"))


def test_units_switch_converts_what_is_typed_and_any_unit_may_be_typed(visitor: Visitor) -> None:
    # expected: 1200 mm / 25.4 mm, 150 kN / 4.4482216 N, 3 m/s / 0.00508 m/s
    page = visitor.open("drive")
    names = ("belt-width", "pulley-0-entry_tension", "belt-speed")
    typed = [page.input_value(f"#f-{n}") for n in names]
    page.get_by_label("US", exact=True).check(force=True)
    expect(page.locator("#f-belt-width")).to_have_value("47.2441")
    assert [page.input_value(f"#f-{n}") for n in names] == ["47.2441", "33721.3", "590.551"]
    assert [page.inner_text(f"#f-{n}-u") for n in names] == ["in", "lbf", "fpm"]
    visitor.solved()
    assert key_figure(visitor, "Creep at exit") == "0.295 in"
    assert "0.451 in" in page.inner_text("#verdict")  # of the load case that governs
    # every force in the unit of its field: T1 of the example is 33721 lbf
    told = page.inner_text("#drive")
    assert "T1 33700 lbf" in told
    assert "klbf" not in told
    page.get_by_label("SI", exact=True).check(force=True)
    expect(page.locator("#f-belt-width")).to_have_value("1200")
    assert [page.input_value(f"#f-{n}") for n in names] == typed == ["1200", "150", "3"]
    assert key_figure(visitor, "Creep at exit") == "7.49 mm"
    page.fill("#f-belt-width", "1.2 m")
    page.press("#f-belt-width", "Tab")
    assert (page.input_value("#f-belt-width"), page.inner_text("#f-belt-width-u")) == ("1.2", "m")
    visitor.solved()
    assert key_figure(visitor, "Creep at exit") == "7.49 mm"


#: Values that are wrong, by their field: its place in a file, and what is right there.
WRONG = {
    "belt-width": ("belt.width", "1,2", "1000"),
    "pulley-0-diameter": ("pulley.head.diameter", "8 kN", "1000"),
    "pulley-0-wrap_angle": ("pulley.head.wrap_angle", "900", "180"),
}


def test_wrong_value_turns_red_with_the_sentence_of_the_command_line(
    visitor: Visitor, tmp_path: Path
) -> None:
    page = visitor.open("drive")
    for field, (key, text, right) in WRONG.items():
        page.fill(f"#f-{field}", text)
        page.wait_for_selector(f"#f-{field}[aria-invalid=true]")
        told = page.inner_text(f"#f-{field}-e")
        value = text if " " in text else f"{text} {'deg' if 'angle' in field else 'mm'}"
        wrong = document()
        where = wrong["belt"] if field.startswith("belt") else wrong["pulley"][0]
        where[field.rsplit("-", 1)[1]] = value
        file = tmp_path / "wrong.toml"
        file.write_text(document_text(wrong, TRAIN_FILE), "utf-8")
        _, _, errors = wraparc("check", str(file))
        assert told in errors
        assert key not in told  # a key of the file: here the field says what it is of
        name = page.locator(f"label[for=f-{field}]").evaluate("(e) => e.firstChild.textContent")
        expect(page.locator("#verdict p")).to_have_text(f"Not computed: {name}.")
        # and it goes away with its cause
        page.fill(f"#f-{field}", right)
        page.wait_for_selector(f"#f-{field}[aria-invalid=false]")
        expect(page.locator("#verdict p")).not_to_contain_text("Not computed")


@pytest.mark.processes
def test_late_answer_never_stands_under_another_drive(visitor: Visitor) -> None:
    page = visitor.open("drive")
    held: list[Route] = []
    page.route("**/api/v1/solve/fast", lambda route: held.append(route))  # noqa: PLW0108
    visitor.example("Head drive, overland conveyor", None)
    page.wait_for_selector("#results.waiting >> text=Solving")
    expect(page.locator("#title")).to_have_text("Head drive, overland conveyor")
    wait_for(lambda: page.evaluate("true") and held)
    held[0].continue_()
    page.wait_for_selector("#results:not(.waiting)")
    visitor.solved()
    assert key_figure(visitor, "Creep at exit") != "7.49 mm"


@pytest.mark.processes
def test_undo_redo_and_link(visitor: Visitor, calculator: Calculator) -> None:
    page = visitor.open("drive")
    page.fill("#f-pulley-0-diameter", "1000")
    page.press("#f-pulley-0-diameter", "Tab")
    page.select_option("#f-pulley-0-lagging", "full-ceramic")
    page.click("#undo")
    expect(page.locator("#f-pulley-0-lagging")).to_have_value("diamond-rubber")
    page.click("#undo")
    expect(page.locator("#f-pulley-0-diameter")).to_have_value("800")
    page.click("#redo")
    page.click("#redo")
    expect(page.locator("#f-pulley-0-diameter")).to_have_value("1000")
    page.wait_for_function("() => location.hash.split('/').length === 3")
    page.get_by_label("US", exact=True).check(force=True)
    wait_for(lambda: in_the_address(page.evaluate("location.href"))["u"] == "us")
    visitor.solved()
    creep = key_figure(visitor, "Creep at exit")
    other = Visitor(calculator[0], page.url)
    other.open("drive")
    other.solved()
    assert other.page.input_value("#f-pulley-0-diameter") == "39.3701"
    assert other.page.input_value("#f-pulley-0-lagging") == "full-ceramic"
    assert key_figure(other, "Creep at exit") == creep
    other.close()


def test_saved_design_comes_back_in_every_version(visitor: Visitor) -> None:
    page = visitor.open("drive")
    page.fill("#f-title", "Drive of a test")
    page.press("#f-title", "Tab")
    turn(page, "saved")
    expect(page.locator("#saved").get_by_label("Name", exact=True)).to_have_value("Drive of a test")
    page.get_by_label("Who").fill("A. Tester")
    page.get_by_label("Note on this version").fill("as built")
    page.get_by_role("button", name="Save as a new design").click()
    page.wait_for_selector("text=This is version 1 of")
    turn(page, "drive")
    page.fill("#f-pulley-0-exit_tension", "90")
    page.press("#f-pulley-0-exit_tension", "Tab")
    turn(page, "saved")
    page.get_by_label("Note on this version").fill("more take-up")
    page.get_by_role("button", name="Save a new version").click()
    page.wait_for_selector("text=This is version 2 of")
    page.get_by_role("button", name="Versions of Drive of a test").click()
    row = page.locator("tr.versions li").filter(has_text="as built")
    assert "A. Tester" in row.inner_text()
    page.get_by_role("button", name="Changes of version 2 of Drive of a test").click()
    changed = page.locator("tr.versions table tr")
    expect(changed).to_have_text(["Valueversion 1version 2", "pulley.head.exit_tension60 kN90 kN"])
    turn(page, "drive")
    page.fill("#f-pulley-0-diameter", "900")
    page.press("#f-pulley-0-diameter", "Tab")
    turn(page, "saved")
    page.get_by_role("button", name="Changes of the present design of").click()
    expect(changed).to_have_text(
        ["Valueversion 2the present design", "pulley.head.diameter800 mm900 mm"]
    )
    visitor.anew(row.get_by_role("button").click)
    page.wait_for_selector("#drive:visible")
    expect(page.locator("#f-pulley-0-exit_tension")).to_have_value("60")
    turn(page, "saved")
    visitor.anew(page.get_by_role("button", name="Open Drive of a test", exact=True).click)
    expect(page.locator("#f-pulley-0-exit_tension")).to_have_value("90")


def test_a_design_goes_into_the_bin_and_comes_back(visitor: Visitor) -> None:
    page = visitor.open("saved")
    name = page.locator("#saved").get_by_label("Name", exact=True)
    name.fill("for the bin")
    page.get_by_role("button", name="Save as a new design").click()
    page.wait_for_selector("text=This is version 1 of")
    name.fill("renamed")
    page.get_by_role("button", name="Save a new version").click()
    page.get_by_role("button", name="Delete renamed", exact=True).click()
    row = page.get_by_role("rowheader", name="renamed")
    row.wait_for(state="detached")
    page.get_by_label("Bin", exact=True).check()
    page.get_by_role("button", name="Restore renamed").click()
    row.wait_for(state="detached")
    page.get_by_label("Bin", exact=True).uncheck()
    row.wait_for()
    page.get_by_role("button", name="Delete renamed", exact=True).click()
    row.wait_for(state="detached")
    page.get_by_label("Bin", exact=True).check()
    page.get_by_role("button", name="Delete for good renamed").click()
    row.wait_for(state="detached")


def test_compare_sorts_pins_and_puts_a_lagging_in(visitor: Visitor) -> None:
    page = visitor.open("compare")
    rows = page.locator("#compare tbody tr")
    page.click("#sort-exit_creep")
    names = rows.locator("th").all_inner_texts()
    assert names[0].startswith("Full ceramic")
    assert names[-1].startswith("Diamond rubber")
    page.get_by_role("button", name="Pin Diamond rubber (illustrative)").click()
    assert rows.locator("th").all_inner_texts()[0].startswith("Diamond rubber")
    page.click("#sort-exit_creep")
    assert page.get_attribute("th:has(#sort-exit_creep)", "aria-sort") == "descending"
    page.get_by_role("button", name="Use Full ceramic").click()
    expect(rows.filter(has_text="(present)")).to_contain_text("Full ceramic")
    page.get_by_text("Belts", exact=True).click()
    page.wait_for_selector("#compare tbody tr:has-text('ST')")
    turn(page, "drive")
    expect(page.locator("#f-pulley-0-lagging")).to_have_value("full-ceramic")


def test_file_is_opened_and_what_it_says_is_kept(visitor: Visitor, tmp_path: Path) -> None:
    page = visitor.open("drive")
    file = tmp_path / "mine.toml"
    headers = {"authorization": f"Bearer {TOKEN}"}
    place = f"{visitor.address}api/v1/examples/downhill-braking"
    answer = page.request.get(place, headers=headers).json()
    file.write_text(answer["toml"], "utf-8")
    visitor.load(file)
    expect(page.locator("#title")).to_have_text("Downhill conveyor, braking drive")
    expect(page.locator("svg.stage")).to_contain_text("brakes")
    assert page.input_value("#f-belt-width") == "48"
    assert page.inner_text("#f-belt-width-u") == "in"
    # a file that is no drive file says so and changes nothing
    broken = tmp_path / "broken.toml"
    broken.write_text("format = = 1", "utf-8")
    visitor.load(broken)
    page.wait_for_selector("#toast.bad:not(:empty)")
    expect(page.locator("svg.stage")).to_contain_text("brakes")


def test_tests_are_read_fitted_and_used_at_once(visitor: Visitor, tmp_path: Path) -> None:
    # not the dialect without units: the law of the others would miss what is left out
    dialects = ("bluehill", "testxpert", "excel", "testsuite", "logger", "trapezium", "polish")
    rig = ["rig", str(tmp_path / "rig"), "--repeats", "1", "--points", "120"]
    code, _, errors = wraparc(*rig, *(part for name in dialects for part in ("--dialect", name)))
    assert code == 0, errors
    files = sorted(f for f in (tmp_path / "rig").iterdir() if f.suffix != ".toml")
    page = visitor.open("tests", unfold=True)
    page.set_input_files("#test-files", files)
    page.wait_for_selector(f"text={len(files)} tests")
    expect(page.locator("#tests .rows-of .g.warn")).to_have_count(0)
    unfold_plan(page)
    page.fill("#t-lagging-name", "from-the-rig")
    page.fill("#t-rig-sample_area", "0.04 kN")
    page.get_by_role("button", name="Fit the lagging").click()
    page.wait_for_selector("#t-rig-sample_area[aria-invalid=true]")
    assert "an area is needed" in page.inner_text("#t-rig-sample_area-e")
    page.fill("#t-rig-sample_area", "0.04 m2")
    page.get_by_role("button", name="Fit the lagging").click()
    page.get_by_role("button", name="Apply to drive").wait_for()
    assert page.locator("#tests svg.chart").count() >= 3
    with page.expect_download() as arriving:
        page.get_by_role("button", name="Download the lagging file").click()
    file = tmp_path / "lagging.toml"
    arriving.value.save_as(file)
    assert wraparc("lagging", str(file))[0] == 0
    page.get_by_role("button", name="Apply to drive").click()
    expect(page.locator("#f-pulley-0-lagging")).to_have_value("from-the-rig")
    visitor.solved()
    assert re.fullmatch(r"[\d.]+ mm", key_figure(visitor, "Creep at exit"))
    interval = r"95 % by the law: [\d.]+ mm to [\d.]+ mm"
    expect(page.locator("#drive .figures")).to_contain_text(re.compile(interval))


def test_reports_of_the_page_are_those_of_the_drive_on_it(visitor: Visitor, tmp_path: Path) -> None:
    # expected: the file signatures of PDF and ZIP, and in the text what was typed on the page
    page = visitor.open("drive")
    page.fill("#f-pulley-0-exit_tension", "71.25")
    page.press("#f-pulley-0-exit_tension", "Tab")
    visitor.solved()
    page.click("#tab-report")
    for label, start in (
        ("Calculation note (PDF)", b"%PDF-"),
        ("Workbook (Excel)", b"PK"),
        ("Text (Markdown)", b"#"),
    ):
        page.fill("#head-author", "E. Euler")
        with page.expect_download() as arriving:
            page.get_by_role("button", name=label).click()
        file = tmp_path / arriving.value.suggested_filename
        arriving.value.save_as(file)
        assert file.read_bytes().startswith(start), label
    text = file.read_text("utf-8")
    assert "71.25 kN" in text
    assert "E. Euler" in text


def test_train_shares_and_trims(visitor: Visitor) -> None:
    page = visitor.open("drive")
    visitor.example("Tandem head drive, fabric belt")
    visitor.open("train")
    page.wait_for_selector("#train svg.chain")
    assert "second must turn 0.346 % slower" in page.inner_text("#train .verdict")
    # by hand: 45 kN leave, 105 kN are divided in halves; the wider the line the more tension
    drawn = page.get_by_label("Load case design", exact=True).locator("svg.chain")
    told = drawn.locator("text").all_text_contents()
    assert {"carrying strand 150 kN", "97.5 kN", "return strand", "45 kN"} <= set(told)
    assert {"180° wrap", "200° wrap"} <= set(told)
    spans = drawn.locator("path[d*='L'][stroke-width]").all()
    widths = [float(span.get_attribute("stroke-width") or "") for span in spans]
    assert widths == pytest.approx([12.0, 3.0 + 9.0 * 97.5 / 150, 3.0 + 9.0 * 45 / 150], abs=0.051)
    # one divider: what one drive gives the other takes, by keys and by hand, and one step undoes it
    divider = page.get_by_role("slider", name="Load of first and second")
    divider.focus()
    for _ in range(2):
        page.keyboard.press("PageUp")
    expect(divider).to_have_attribute("aria-valuetext", "first 70 %, second 30 %")
    expect(page.locator("#t-train-share-1")).to_have_value("30 %")
    page.wait_for_selector("#train .verdict:has-text('first takes 70 %')")
    box = divider.bounding_box()
    assert box is not None
    page.mouse.move(box["x"] + 10, box["y"] + 10)
    page.mouse.down()
    for _ in range(8):
        page.mouse.move(box["x"] + 10 - 20 * _, box["y"] + 10)
    page.mouse.up()
    parts = [float(page.input_value(f"#t-train-share-{i}").split()[0]) for i in (0, 1)]
    assert sum(parts) == pytest.approx(100.0, abs=1e-9)
    assert parts[0] < 60
    page.click("#undo")
    expect(page.locator("#t-train-share-0")).to_have_value("70 %")
    page.get_by_role("button", name="Add a drive behind").click()
    expect(page.locator("#train fieldset legend").filter(has_text="Drive 3")).to_be_visible()
    page.get_by_role("button", name="Remove this drive").last.click()
    page.wait_for_selector("#train .verdict:has-text('first takes 70 %')")
    page.fill("#t-train-exit_tension", "0.1")
    page.locator("#t-train-exit_tension").blur()
    expect(drawn.locator("text", has_text="slips")).to_have_count(1)
    expect(drawn).to_have_attribute("aria-label", re.compile("second: slips on its whole wrap"))
    turn(page, "drive")
    page.wait_for_selector("#pick-pulley")


@pytest.mark.processes
def test_study_is_started_followed_shown_and_cancelled(visitor: Visitor) -> None:
    page = visitor.open("study")
    page.get_by_label("Samples").fill("many")
    page.get_by_role("button", name="Start the study").click()
    page.wait_for_selector("#study .verdict.bad:has-text('sampling.samples')")
    page.get_by_label("Samples").fill("64")
    page.locator("#study").get_by_label("Title").fill("Followed")
    page.get_by_role("button", name="Start the study").click()
    done = page.locator("#study .job[aria-label=Followed][data-state=done]")
    done.locator("table").first.wait_for(timeout=STUDY)
    image = done.locator("img").first
    wait_for(lambda: image.evaluate("(e) => e.naturalWidth") > 100)
    assert image.get_attribute("alt")
    # a link of one use, without a token: it leads nowhere from then on
    with page.expect_download() as saved:
        done.get_by_role("button", name="results.parquet").click()
    assert Path(saved.value.path()).read_bytes()[:4] == b"PAR1"
    assert re.search(r"/api/v1/once/[\w-]{32}$", saved.value.url)
    assert page.request.get(saved.value.url).status == 404
    page.get_by_label("Samples").fill("200000")
    # the share in the headline, of all draws; the picture has its limit as a labelled line
    headline = done.locator(".headline")
    expect(headline).to_contain_text(
        re.compile(r"% of [\d,]+ designs exceed the 6.35 mm creep limit")
    )
    spread = done.locator(".spread")
    expect(spread.locator("svg text", has_text="creep limit 6.35 mm")).to_be_visible()
    spread.get_by_label("Result").select_option(label="Margin to the creep limit")
    expect(spread.locator("svg")).to_have_attribute(
        "aria-label", re.compile("fall short of the margin of 1")
    )
    assert "pulley.head" not in done.locator(".t-, .verdict").all_inner_texts()[0]
    page.locator("#study").get_by_label("Title").fill("Cancelled")
    page.get_by_role("button", name="Start the study").click()
    # its own button: what asks for long, as the start may, has one as well
    job = page.locator("#study .job[aria-label=Cancelled]")
    job.get_by_role("button", name="Cancel").click()
    expect(job).to_have_attribute("data-state", "cancelled")
    done.get_by_role("button", name="Delete").click()
    expect(done).to_have_count(0)


def test_moved_slider_is_answered_without_the_server(visitor: Visitor) -> None:
    # expected: the server's own figures, once it is let answer
    page = visitor.open("drive")
    visitor.alone()
    held: list[Route] = []
    page.route("**/api/v1/solve**", lambda route: held.append(route))  # noqa: PLW0108
    page.get_by_label("Entry tension, slider").focus()
    page.evaluate(STEPS)
    seen, hub = list[str](), page.locator(".hub-number tspan").first
    for i in range(8):
        page.keyboard.press("ArrowRight")
        wait_for(lambda i=i: page.evaluate("steps.length") > i)
        seen.append(hub.text_content() or "")
    assert len(set(seen)) == 8
    assert len([r for r in held if r.request.url.endswith("/fast")]) <= 1  # where the hand rested
    chosen = page.locator("#verdict")
    expect(chosen).to_have_class("say warn ")  # judged as well
    expect(page.locator("#drive .figures")).to_contain_text(f"{seen[-1]} mm")  # follows with it
    own = page.locator("#drive .figures").inner_text()
    page.unroute("**/api/v1/solve**")
    for route in held:
        with contextlib.suppress(Error):  # what the page has given up meanwhile
            route.continue_()
    visitor.solved()
    expect(chosen).to_have_class("say warn ")
    told = page.locator("#drive .figures").inner_text()
    assert own.splitlines()[:2] == told.splitlines()[:2]  # creep at exit and what it is made of
    assert len(page.evaluate("steps")) == 8  # nothing was drawn twice


SLIDE = """(slider, part) => {
  slider.value = +slider.min + part * (slider.max - slider.min);
  slider.dispatchEvent(new Event("input", { bubbles: true }));
  slider.dispatchEvent(new Event("change", { bubbles: true }));
}"""


#: Moves of sliders, to a part of their way: a drive that slips, one that creeps, one that holds.
#: That of the width reaches two standard sizes far: 1600 mm, then 2000 mm.
SLIDES = (
    ("Exit tension", 0.0), ("Exit tension", 0.6), ("Wrap angle", 0.99), ("Belt width", 1.0),
    ("Belt width", 1.0),
)  # fmt: skip


#: Whether the page has judged what it shows.
JUDGED = """async () => {
  const { answer, app } = await import("/static/main.js");
  return answer.judgedDoc === app.doc;
}"""


@pytest.mark.usefixtures("untried")
def test_checks_follow_the_slider_without_the_server(visitor: Visitor, tmp_path: Path) -> None:
    # expected: what `wraparc solve` says of the same drive
    page = visitor.open("drive")
    evaluated(page, "import('/static/main.js').then((m) => m.edit(['covered'], true))")
    visitor.solved()
    visitor.alone()
    page.route("**/api/v1/solve**", lambda route: None)
    file = tmp_path / "moved.toml"
    levels = set()
    for name, part in SLIDES:
        page.get_by_label(f"{name}, slider", exact=True).evaluate(SLIDE, part)
        wait_for(lambda: page.evaluate(JUDGED))
        visitor.painted()
        expect(page.locator(".governing")).to_contain_text("follow once the hand rests")
        moved = evaluated(page, "import('/static/main.js').then((m) => m.app.doc)")
        file.write_text(document_text(moved, TRAIN_FILE), "utf-8")
        told = json.loads(wraparc("solve", str(file), "--no-reserve", "--json", "-")[1])
        verdict, arc = told["verdict"], told["arcs"][0]
        said = page.locator(".governing .headline").inner_text()
        assert said.partition(" ")[2] == f"{verdict['label']} {verdict['text']}"
        levels.add(verdict["level"])
        creep = arc["exit_creep"]
        expected = "–" if creep is None else display(creep, "length", digits=RESULT_DIGITS)
        assert key_figure(visitor, "Creep at exit") == expected
        found = key_figure(visitor, "Margin to the creep limit")
        assert found == display(arc["creep_limit_margin"], "number", digits=RESULT_DIGITS)
        least = told["least_tension"]
        shown = page.locator(".governing li").first.inner_text()
        assert shown == least["sentence"]
        tension = least["tension"]
        found = key_figure(visitor, "Minimum T2")
        assert found == (
            "none"
            if tension is None
            else display(on_safe_side(tension, "force"), "force", digits=3)
        )
        rows = page.locator("#drive .t-checks tbody tr")
        judged = [c for c in verdict["checks"] if c["level"] != "NOT CHECKED"]
        titles = [row.partition("\t")[0] for row in rows.all_inner_texts()]
        assert titles == [c["title"] for c in judged if c["name"] not in INFO_CHECKS]
    page.unroute_all(behavior="ignoreErrors")
    assert levels == {"OK", "ATTENTION", "FAILS"}


#: Choices on the drive page, by their field.
CHOICES = (
    ("#f-pulley-0-lagging", "full-ceramic"), ("#f-belt-preset", "Flexsteel ST1000"),
    ("#f-take_up-kind", "fixed"), ("#f-design_standard-name", "DIN 22101"),
    ("#f-pulley-0-lagging", "medium-ceramic"), ("#condition", "1"), ("#condition", "2"),
)  # fmt: skip


@pytest.mark.usefixtures("untried")
def test_choices_are_answered_without_the_server(visitor: Visitor, tmp_path: Path) -> None:
    # expected: what `wraparc solve` says of the same drive
    page = visitor.open("drive")
    visitor.alone()
    page.route(REQUESTS, lambda route: None)
    for name in ("Take-up", "Design standard"):
        page.locator("summary", has_text=name).first.click()
    file = tmp_path / "chosen.toml"
    for field, choice in CHOICES:
        page.select_option(field, choice)
        wait_for(lambda: page.evaluate(JUDGED))
        visitor.painted()
        chosen = evaluated(page, "import('/static/main.js').then((m) => m.app.doc)")
        file.write_text(document_text(chosen, TRAIN_FILE), "utf-8")
        told = json.loads(wraparc("solve", str(file), "--no-reserve", "--json", "-")[1])
        said = page.locator(".governing .headline").inner_text()
        said = re.split(r"\s+Raise [^.]+? to \d", said)[0]  # a button stands behind it
        verdict = told["verdict"]
        assert said.partition(" ")[2] == f"{verdict['label']} {verdict['text']}"
        creep = display(told["arcs"][0]["exit_creep"], "length", digits=RESULT_DIGITS)
        assert key_figure(visitor, "Creep at exit") == creep
        rows = page.locator("#drive .t-checks tbody tr")
        judged = [c for c in verdict["checks"] if c["level"] != "NOT CHECKED"]
        titles = [row.partition("\t")[0] for row in rows.all_inner_texts()]
        assert titles == [c["title"] for c in judged if c["name"] not in INFO_CHECKS]
    page.unroute_all(behavior="ignoreErrors")


def test_server_that_finds_other_numbers_is_shown_and_told(calculator: Calculator) -> None:
    visitor = Visitor(calculator[0], calculator[1].address)
    page = visitor.open("drive")
    visitor.alone()

    def other(route: Route) -> None:
        answer = route.fetch()
        told = answer.json()
        told["numbers"]["exit_creep"] = 5.55e-3
        route.fulfill(response=answer, json=told)

    page.route("**/api/v1/solve/fast", other)
    page.get_by_label("Entry tension, slider").focus()
    page.keyboard.press("ArrowRight")
    expect(page.locator("#drive .figures")).to_contain_text("5.55 mm")
    assert visitor.wrong == ["The page and the server differ in exit_creep."]
    visitor.close()


def test_a_page_that_cannot_be_drawn_says_so_once(calculator: Calculator) -> None:
    # expected: one fault, told; it was told by drawing, which failed, and so on without end
    visitor = Visitor(calculator[0], calculator[1].address)
    page = visitor.open("drive")
    evaluated(
        page,
        "import('/static/main.js').then(({ app, redraw }) => {"
        "app.doc = { ...app.doc, title: Symbol('no text') }; redraw(); })",
    )
    expect(page.locator("#toast")).to_contain_text("TypeError")
    visitor.painted()
    assert 0 < len(visitor.wrong) < 9  # once a drawing: of the change, and of its answers
    visitor.close()


def test_what_is_being_typed_outlives_a_drawing(visitor: Visitor) -> None:
    # expected: the title as typed; a list of studies that came meanwhile took it away
    page = visitor.open("study")
    title = page.locator("#study").get_by_label("Title")
    title.fill("Typed")
    evaluated(page, "import('/static/main.js').then((m) => m.redraw())")
    visitor.painted()
    expect(title).to_have_value("Typed")
    title.blur()
    visitor.painted()
    expect(title).to_have_value("Typed")


def test_trim_limits_are_those_of_the_command(visitor: Visitor) -> None:
    # expected: `wraparc trim --json`: where each drive meets its creep limit, and the part of the
    # trim in which the share is kept within 5 %
    page = visitor.open("drive")
    visitor.example("Tandem head drive, fabric belt")
    visitor.open("train")
    expect(page.locator("#train .strip output")).to_have_text(
        "99.654 % (± 0.077 % for a share within 5 %)"
    )
    page.get_by_role("button", name="Find the trim limits").click()
    keeps = page.locator("#train .strip .keeps")
    keeps.wait_for(timeout=STUDY)
    told = json.loads(wraparc("trim", "examples/tandem-fabric.toml", "--json", "-")[1])
    marks = told["curves"][0]["marks"]
    low, high = sorted(m["at"] for m in marks if m["what"] == "creep_limit")
    (now,) = (m["at"] for m in marks if m["what"] == "operating")
    box, track = keeps.bounding_box(), page.locator("#train .strip-track").last.bounding_box()
    place = page.get_by_role("slider", name="Trim of second").bounding_box()
    assert box
    assert track
    assert place
    size = box["width"] / (high - low)  # px for a trim of one
    assert place["x"] + place["width"] / 2 == pytest.approx(box["x"] + size * (now - low), abs=1.0)
    assert track["x"] < box["x"] < box["x"] + box["width"] < track["x"] + track["width"]
    # a line of the charts has a look and a name of its own
    for figure in page.locator("#train .plots figure").all():
        names = [text for text in figure.locator("figcaption span").all_inner_texts() if text]
        looks = figure.locator("figcaption .line").evaluate_all(
            "(all) => all.map((e) => e.getAttribute('class'))"
        )
        assert len(names) == len(set(names)) == len(set(looks)) >= 2, (names, looks)
