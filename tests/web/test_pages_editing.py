"""Typing, opening, turning back, losing the server: nothing typed is lost or changed silently."""

import json
from pathlib import Path
from typing import Any

from playwright.sync_api import Page, Route, expect

from cli.running import wraparc
from web.browser import LATER, Calculator, Visitor, evaluated, turn
from web.calculators import TOKEN, document, wait_for
from web.test_pages import key_figure
from worded import worded
from wraparc.units import display

EXAMPLES = Path(__file__).parents[2] / "examples"


LOAD = ("entry_tension", "exit_tension", "effective_tension", "power", "torque")


def kept(page: Page) -> Any:
    """Return the design of the newest draft that the browser keeps."""
    return json.loads(page.evaluate("localStorage.getItem('wraparc.drafts')"))[0]["doc"]


def unfold(page: Page, words: str) -> None:
    page.locator("#drive summary", has_text=words).click()


def test_names_are_typed_letter_by_letter_and_what_names_them_goes_along(visitor: Visitor) -> None:
    page = visitor.open("drive")
    unfold(page, "empty")
    case = page.locator("#f-load_case-0-name")
    case.fill("")
    case.press_sequentially("a b")
    expect(case).to_be_focused()
    expect(case).to_have_value("a b")
    name = page.locator("#f-pulley-0-name")
    name.fill("")
    name.press_sequentially("ta")
    name.press("Tab")
    visitor.solved()
    doc = kept(page)
    assert [c["name"] for c in doc["load_case"]] == ["a b", "start"]
    assert [list(c["pulley"]) for c in doc["load_case"]] == [["ta"], ["ta"]]
    assert doc["load_case"][0]["pulley"]["ta"] == {"entry_tension": "82 kN"}
    # and the drive is still one that can be solved
    expect(page.locator("#results [role=alert]")).to_have_text("")
    # a name that another has is refused where it is typed, and changes nothing
    case.fill("start")
    case.press("Tab")
    expect(page.locator("#f-load_case-0-name-e")).to_contain_text("Another load case")
    assert kept(page) == doc


def test_units_are_a_view_and_the_file_keeps_what_was_typed(visitor: Visitor) -> None:
    page = visitor.open("drive")
    page.fill("#f-pulley-0-exit_tension", "61.5")
    page.press("#f-pulley-0-exit_tension", "Tab")
    before = kept(page)
    page.get_by_label("US", exact=True).check(force=True)
    expect(page.locator("#f-belt-width")).to_have_value("47.2441")
    visitor.solved()
    assert kept(page) == before
    assert before["belt"]["width"] == "1200 mm"
    # what is typed in the view is kept in its own unit, and nothing else changes
    page.fill("#f-pulley-0-diameter", "31.5")
    page.press("#f-pulley-0-diameter", "Tab")
    after = kept(page)
    assert after["pulley"][0]["diameter"] == "31.5 in"
    after["pulley"][0]["diameter"] = before["pulley"][0]["diameter"]
    assert after == before


def test_comments_of_an_opened_file_stay_in_what_is_downloaded(
    visitor: Visitor, tmp_path: Path
) -> None:
    # expected: the file itself, with the one line that was typed over, after a reload too
    text = (EXAMPLES / "head-drive-fabric.toml").read_text("utf-8") + "# not to be forgotten\n"
    before = next(line for line in text.splitlines() if line.startswith("exit_tension"))
    assert "#" in before
    file = tmp_path / "with-words.toml"
    file.write_text(text, "utf-8")
    page = visitor.open("drive")
    visitor.anew(lambda: visitor.load(file))
    expect(page.locator("#toast")).to_contain_text("Opened")
    page.fill("#f-pulley-0-exit_tension", "61.5")
    page.press("#f-pulley-0-exit_tension", "Tab")
    page.reload()
    visitor.solved()
    page.click("#file > summary")
    with page.expect_download() as arriving:
        page.get_by_role("button", name="Download the drive file").click()
    found = Path(arriving.value.path()).read_text("utf-8")
    assert found == text.replace(before, before.replace("60 kN", "61.5 kN"))


#: Files that are no drive: what is told of each, and the page that is shown then.
OTHERS = {
    "empty.toml": ("is empty", "drive"),
    "studies/load-cases.toml": ("is a study", "study"),
    "shear_tests/plan.toml": ("is a plan of shear tests", "tests"),
    "wet-season/choose.toml": ("wraparc choose choose.toml", "drive"),
    "wet-season/wet-day-record.toml": ("wraparc calibrate wet-day-record.toml", "drive"),
    "other.toml": ("is no drive file", "drive"),
}


def test_file_that_is_no_drive_says_what_it_is(visitor: Visitor, tmp_path: Path) -> None:
    page = visitor.open("drive")
    for name, (told, shown) in OTHERS.items():
        turn(page, "drive")
        file = EXAMPLES / name
        if not file.exists():
            file = tmp_path / name
            file.write_text("" if name == "empty.toml" else "colour = 'red'\n", "utf-8")
        visitor.load(file)
        expect(page.locator("#toast")).to_contain_text(told)
        expect(page.locator(f"#{shown}")).to_be_visible()
        if shown == "study":
            expect(page.locator("#study select").nth(3)).to_have_value("belt.preset")
            expect(page.locator("#study tbody input").nth(1)).to_have_value(
                "10 mm, 12 mm, 15 mm, 20 mm"
            )
        if shown == "tests":
            expect(page.locator("#t-lagging-name")).to_have_value("diamond-rubber-virtual")
    # the page goes on as before
    expect(page.locator("#title")).to_have_text("Head drive, ROM conveyor")
    page.fill("#f-pulley-0-exit_tension", "70")
    visitor.solved()
    expect(page.locator("#results [role=alert]")).to_have_text("")


def test_back_turns_the_page_and_keeps_the_design(visitor: Visitor) -> None:
    page = visitor.open("drive")
    visitor.solved()
    page.wait_for_function("() => location.hash.split('/').length === 3")
    turn(page, "compare")
    page.wait_for_selector("#compare tbody tr")
    turn(page, "drive")
    page.fill("#f-pulley-0-exit_tension", "71")
    page.press("#f-pulley-0-exit_tension", "Tab")
    page.go_back()
    expect(page.locator("#compare")).to_be_visible()
    page.go_back()
    expect(page.locator("#drive")).to_be_visible()
    expect(page.locator("#f-pulley-0-exit_tension")).to_have_value("71")
    # undo reaches over pages
    turn(page, "saved")
    page.click("#undo")
    turn(page, "drive")
    expect(page.locator("#f-pulley-0-exit_tension")).to_have_value("60")


def test_back_while_the_address_is_written_turns_the_page(visitor: Visitor) -> None:
    page = visitor.open("drive")
    visitor.solved()
    page.wait_for_function("() => location.hash.split('/').length === 3")
    turn(page, "compare")
    page.wait_for_selector("#compare tbody tr")
    turn(page, "drive")
    # packing the design takes until it is let go
    page.evaluate("""() => {
      const whole = Response.prototype.arrayBuffer;
      const gate = new Promise((open) => { window.letGo = open; });
      Response.prototype.arrayBuffer = async function () {
        window.packing = true;
        await gate;
        return whole.call(this);
      };
    }""")
    page.fill("#f-pulley-0-exit_tension", "71")
    page.press("#f-pulley-0-exit_tension", "Tab")
    page.wait_for_function("() => window.packing === true")
    page.go_back()
    expect(page.locator("#compare")).to_be_visible()
    page.evaluate("window.letGo()")
    page.wait_for_function("() => location.hash.split('/').length === 3")
    assert page.evaluate("location.hash.split('/')[1]") == "compare"
    expect(page.locator("#compare")).to_be_visible()


def test_new_drive_says_what_is_needed_and_calls_nothing_wrong(visitor: Visitor) -> None:
    page = visitor.open("drive")
    page.click("#file > summary")
    page.get_by_role("button", name="New drive").click()
    # all but the load has usual values, and is marked so
    expect(page.locator("#f-belt-width")).to_have_value("1200")
    expect(page.locator(".rail h2")).to_contain_text("italic: assumed")
    # the load is typed on the strands, and mirrored in the rail
    expect(page.locator("#s-pulley-0-entry_tension")).to_be_focused()
    told = page.locator("#verdict")
    expect(told).to_contain_text("Type T1 and T2: the rest has usual values.")
    assert "FAILS" not in told.inner_text()
    expect(page.locator("#f-pulley-0-exit_tension")).to_have_attribute("aria-invalid", "false")
    expect(page.locator("#f-pulley-0-exit_tension-e")).to_have_text("Missing.")
    # a value that cannot be read is told as such, though others are still needed
    page.fill("#f-pulley-0-entry_tension", "much")
    expect(page.locator("#f-pulley-0-entry_tension-e")).to_contain_text('"much"')
    expect(page.locator("#s-pulley-0-entry_tension")).to_have_attribute("aria-invalid", "true")
    expect(told).to_contain_text("Not computed: Entry tension.")
    # no answer of the drive before stands under the new one
    expect(page.locator(".hub-number")).to_have_text("– mm")
    page.fill("#f-pulley-0-entry_tension", "100")
    page.fill("#f-pulley-0-exit_tension", "50")
    visitor.solved()
    expect(page.locator(".hub-number")).not_to_have_text("– mm")
    expect(page.locator(".typed")).to_have_count(0)


def test_governing_case_comes_first_and_keeps_its_advice(visitor: Visitor) -> None:
    # expected: the headline of `wraparc solve`, whichever load case is chosen on the page
    page = visitor.open("drive")
    visitor.solved()
    answer = page.request.post(
        f"{visitor.address}api/v1/solve",
        data={"document": document()},
        headers={"origin": visitor.address.rstrip("/"), "authorization": f"Bearer {TOKEN}"},
    ).json()
    headline = page.locator(".governing .headline").first
    for case in ("design", "empty", "start"):
        chip = page.locator("#cases button").filter(has_text=case)
        chip.click()
        expect(chip).to_have_attribute("aria-pressed", "true")
        arc = next(a for a in answer["arcs"] if a["load_case"] == case)
        known = [bar for bar in arc["bars"] if bar["share"]]
        share = max(b["share"] if b["at_most"] else 1 / b["share"] for b in known)
        expect(chip).to_contain_text(f"{case} {display(100 * share, 'number', digits=3)} %")
        sign = {"OK": "good", "ATTENTION": "warn", "FAILS": "bad"}[arc["level"]]
        expect(chip.locator("svg")).to_have_class(f"g {sign}")
        expect(page.locator("#why")).to_contain_text(f"head, {case}")
        expect(headline).to_contain_text(worded(answer["verdict"]["text"]))
        expect(page.locator(".governing")).to_contain_text(
            worded(answer["verdict"]["sentences"][0])
        )


def test_late_word_on_a_load_case_does_not_bring_it_back(visitor: Visitor) -> None:
    # expected: the case that is pressed, when the server's word on another comes after it
    page = visitor.open("drive")
    visitor.solved()
    visitor.alone()
    chips, chosen = page.locator("#cases button"), page.locator("#why")
    held: list[Route] = []
    page.route("**/api/v1/solve/fast", lambda route: held.append(route))  # noqa: PLW0108
    chips.filter(has_text="empty").click()
    expect(chosen).to_contain_text("head, empty")
    wait_for(lambda: page.evaluate("true") and held)
    chips.filter(has_text="start").click()
    expect(chosen).to_contain_text("head, start")
    held.pop(0).continue_()
    wait_for(lambda: page.evaluate("true") and held)  # the one behind it
    with page.expect_response("**/api/v1/solve/fast"):
        held.pop(0).continue_()
    visitor.painted()
    expect(chosen).to_contain_text("head, start")


def test_load_given_by_other_numbers_is_the_same_load(visitor: Visitor) -> None:
    # expected: Te = T1 - T2, power Te v, torque Te D/2, of 150 kN and 60 kN, 3 m/s, 800 mm; the
    # headline of every load case as it was
    page = visitor.open("drive")
    visitor.solved()
    headline, chips = page.locator(".governing .headline").first, page.locator("#cases")
    before = headline.inner_text(), chips.inner_text()

    def given() -> dict[str, str]:
        pulley = kept(page)["pulley"][0]
        return {key: pulley[key] for key in LOAD if key in pulley}

    pair = page.get_by_label("Load input")
    expect(pair.locator("option")).to_have_count(7)
    # each number beside one of the ends, each end twice
    for index, expected in (
        (2, {"exit_tension": "60 kN", "effective_tension": "90 kN"}),
        (3, {"entry_tension": "150 kN", "power": "270 kW"}),
        (6, {"exit_tension": "60 kN", "torque": "36 kN m"}),
        (0, {"entry_tension": "150 kN", "exit_tension": "60 kN"}),
    ):
        pair.select_option(index=index)
        expect(page.locator(f"#f-pulley-0-{list(expected)[1]}")).not_to_have_value("")
        visitor.solved()
        assert given() == expected
        assert (headline.inner_text(), chips.inner_text()) == before
    # in gross slip too, where what was solved is another state
    page.fill("#f-pulley-0-exit_tension", "4")
    page.press("#f-pulley-0-exit_tension", "Tab")
    visitor.solved()
    expect(headline).to_contain_text("FAILS")
    pair.select_option(index=1)
    expect(page.locator("#f-pulley-0-effective_tension")).to_have_value("146")
    visitor.solved()
    expect(headline).to_contain_text("FAILS")


def test_number_typed_over_what_could_not_be_read_takes_the_unit_of_its_field(
    visitor: Visitor,
) -> None:
    # expected: what the field has always asked for, a number; and no level beside a load case
    # while a value cannot be used
    page = visitor.open("drive")
    visitor.solved()
    field, chips = page.locator("#f-pulley-0-exit_tension"), page.locator("#cases")
    expect(chips.locator("svg:is(.good, .warn, .bad)")).to_have_count(3)
    field.fill("abc")
    field.press("Tab")
    expect(page.locator("#f-pulley-0-exit_tension-e")).to_contain_text("plain number")
    expect(chips.locator("svg:is(.good, .warn, .bad)")).to_have_count(0)
    field.fill("70")
    field.press("Tab")
    visitor.solved()
    expect(page.locator("#f-pulley-0-exit_tension-e")).to_be_empty()
    expect(chips.locator("svg:is(.good, .warn, .bad)")).to_have_count(3)
    assert kept(page)["pulley"][0]["exit_tension"] == "70 kN"


def test_best_is_bold_only_where_everything_is_kept(visitor: Visitor) -> None:
    page = visitor.open("compare", unfold=True)
    for field, value in (("covered", "true"), ("creep_limit", "'7 mm'")):
        evaluated(page, f"import('/static/main.js').then((m) => m.edit(['{field}'], {value}))")
    rows = page.locator("#compare tbody tr")
    failing = rows.filter(has=page.locator(".badge:not(.good)"))
    passing = rows.filter(has=page.locator(".badge.good"))
    expect(passing).to_have_count(1)
    assert failing.count() >= 1
    assert rows.locator("strong").count() == 0  # one alone is no best
    # with a larger creep limit another lagging keeps everything too
    turn(page, "drive")
    page.fill("#f-creep_limit", "10")
    page.press("#f-creep_limit", "Tab")
    turn(page, "compare")
    expect(passing).to_have_count(2)
    assert failing.locator("strong").count() == 0
    assert passing.locator("strong").count() >= 1
    # and the focus stays on what was pressed
    pin = page.get_by_role("button", name="Pin Medium ceramic")
    pin.click()
    expect(pin).to_be_focused()
    expect(pin).to_have_attribute("aria-pressed", "true")


def test_idle_drive_shows_no_noise_and_one_that_slips_no_state_not_asked_for(
    visitor: Visitor,
) -> None:
    page = visitor.open("drive")
    page.fill("#f-pulley-0-exit_tension", "150")
    expect(page.locator("svg.stage")).to_contain_text("idles")
    visitor.solved()
    figures = page.locator("#drive .figures").inner_text()
    assert "e-" not in figures
    # nor in the middle of the arc, where nothing is left of what the entry does
    reading = page.locator("#drive .reading").inner_text()
    assert "0 kPa" in reading
    assert "e-" not in reading
    page.fill("#f-pulley-0-exit_tension", "2")
    expect(page.locator("#drive .figures")).to_contain_text("gross slip")
    visitor.solved()
    expect(page.locator("svg.stage")).to_contain_text("slips")
    expect(page.get_by_role("region", name="Along the wrap")).to_be_hidden()
    assert "FAILS" in page.inner_text("#verdict")
    page.fill("#f-pulley-0-exit_tension", "60")
    expect(page.locator("svg.stage")).not_to_contain_text("slips")


def test_skip_link_leads_into_the_page_that_is_open(visitor: Visitor) -> None:
    page = visitor.open("compare")
    page.locator("#skip").focus()
    page.keyboard.press("Enter")
    expect(page.locator("#compare-title")).to_be_focused()
    expect(page.locator("#compare")).to_be_visible()
    # on the first page the load is the first thing after its views: its cases, one more, numbers
    page = visitor.open("drive")
    page.locator("#skip").focus()
    views = page.locator("#drive .views a").count()
    for key in ("Enter", *["Tab"] * (views + 5)):
        page.keyboard.press(key)
    expect(page.locator("#f-pulley-0-entry_tension")).to_be_focused()


QUESTIONS = {
    "What if … wet, worn, bare?": ".what-if",
    "On site: what to measure, when to alarm": ".site",
    "Which design has the lowest cost?": ".choosing",
    "Which input gives …?": ".seek",
}


def test_questions_are_asked_again_once_the_server_is_back(calculator: Calculator) -> None:
    """The server drops requests in the middle; what was asked needs no second press."""
    visitor = Visitor(calculator[0], calculator[1].address, fresh=True)
    visitor.page.clock.install()
    page = visitor.open("drive")
    visitor.solved()
    for name, of in QUESTIONS.items():  # one at a time
        panel = page.locator(f"#drive {of}")
        page.get_by_role("button", name=name).click()
        panel.wait_for()
        page.route("**/api/v1/**", lambda route: route.abort())
        press = "Find" if "seek" in of else "Calculate"
        panel.get_by_role("button", name=press, exact=True).click()
        expect(panel).to_contain_text("does not answer")
        expect(panel).not_to_contain_text("Solving …")
        page.unroute("**/api/v1/**")
        page.clock.fast_forward(LATER)
        expect(page.locator(".gone")).to_have_count(0)
        expect(panel).not_to_contain_text("does not answer")
        expect(panel.locator("table, .told, p").first).to_be_visible()
    visitor.close()
    assert [w for w in visitor.wrong if "ERR_FAILED" not in w] == []


def test_paper_says_what_it_is_and_when(visitor: Visitor, tmp_path: Path) -> None:
    page = visitor.open("drive")
    visitor.solved()
    modes = page.eval_on_selector_all(
        "#drive input[type=text]", "(all) => all.map((e) => e.inputMode)"
    )
    assert len(modes) > 10
    assert set(modes) == {""}  # the keyboard of a phone offers letters for units
    _, out, _ = wraparc("--version")
    page.emulate_media(media="print")
    told = page.locator("#print-head")
    for words in (out.split()[-1], "head-drive-fabric", "printed"):
        expect(told).to_contain_text(words)


def test_what_a_drive_is_held_against_is_typed_cleared_renamed_and_undone(
    visitor: Visitor,
) -> None:
    page = visitor.open("drive")
    visitor.example("Tandem head drive, steel-cord belt")
    turn(page, "drive")
    for words in ("Take-up", "Design standard", "Belt sag"):
        unfold(page, words)
    page.select_option("#f-take_up-kind", "gravity")
    page.select_option("#f-take_up-after", "first")
    page.select_option("#f-design_standard-name", "DIN 22101")
    expect(page.locator("#results")).to_contain_text("at the take-up behind pulley first")
    expect(page.locator("#results")).to_contain_text("DIN 22101")
    assert kept(page)["take_up"] == {"kind": "gravity", "after": "first"}
    name = page.locator("#f-pulley-0-name")
    name.fill("head")
    name.press("Tab")
    expect(page.locator("#results")).to_contain_text("at the take-up behind pulley head")
    # half of a table asks for the rest; nothing of it leaves no table
    page.fill("#f-sag-idler_spacing", "3")
    page.press("#f-sag-idler_spacing", "Tab")
    expect(page.locator("#verdict")).to_contain_text("Missing: Mass per length.")
    page.fill("#f-sag-idler_spacing", "")
    page.press("#f-sag-idler_spacing", "Tab")
    expect(page.locator("#verdict")).not_to_contain_text("needed")
    page.select_option("#f-take_up-after", "")
    expect(page.locator("#results")).to_contain_text("Minimum T2")
    assert "sag" not in kept(page)
    page.keyboard.press("Control+z")
    expect(page.locator("#results")).to_contain_text("at the take-up behind pulley head")


def test_what_is_unfolded_stays_so_while_its_fields_change(visitor: Visitor) -> None:
    page = visitor.open("drive")
    changes = (
        ("#f-pulley-0-name", "tail"),
        ("#f-pulley-0-lagging-thickness", "15"),
        ("#f-pulley-0-lagging-thickness", ""),
    )
    for field, text in changes:
        page.fill(field, text)
        page.press(field, "Tab")
        expect(page.locator("#f-pulley-0-overrun")).to_be_visible()
        expect(page.locator("#f-pulley-0-lagging-thickness")).to_be_visible()
    # what the hand folds stays folded
    page.locator("summary", has_text="More inputs").first.click()
    page.fill("#f-belt-width", "1000")
    page.press("#f-belt-width", "Tab")
    expect(page.locator("legend", has_text="Pulley head")).to_be_hidden()
    expect(page.locator("#f-pulley-0-lagging-thickness")).to_be_hidden()


#: Where a curve ends, from above.
END = "(e) => e.getPointAtLength(e.getTotalLength()).y"


def test_a_pinned_design_stands_beside_the_present_one(visitor: Visitor) -> None:
    page = visitor.open("drive")
    visitor.solved()
    before = key_figure(visitor, "Creep at exit")
    ghosts = page.locator("#drive .plots path.ghost:not([d=''])")
    marches = page.locator("#drive .plots path.paper:not([d=''])")
    assert (ghosts.count(), marches.count()) == (0, 0)  # neither stands there unasked
    page.get_by_role("button", name="Pin this design").click()
    page.fill("#f-pulley-0-exit_tension", "90")
    row = page.locator(".pinned-table tr", has_text="Exit tension")
    expect(row.locator("td")).to_have_text(["60 kN", "90 kN", "+30 kN"])
    creep = page.locator(".pinned-table tr", has_text="Creep at exit").locator("td")
    visitor.solved()
    assert creep.all_inner_texts()[:2] == [before, key_figure(visitor, "Creep at exit")]
    # tension, friction, creep and shear of the pinned one
    expect(ghosts).to_have_count(4)
    # and a thin line on the first screen, which ends where the one that was pinned did: the higher
    # of both curves, whose limit is the same
    ends = [
        page.locator(f".curve-svg .course{which}").evaluate(END)
        for which in (".thin", ":not(.thin)")
    ]
    assert ends[0] < ends[1]
    page.get_by_label("Compare with the paper's integration").check()
    expect(marches).to_have_count(4)
    page.get_by_role("button", name="Take the pin out").click()
    expect(page.locator(".pinned-table")).to_have_count(0)
    expect(ghosts).to_have_count(0)
    expect(page.locator(".curve-svg .course.thin")).to_have_attribute("d", "")
