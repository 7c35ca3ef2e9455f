"""The views of a drive beside the first screen: tandem, across the width, in time.

Expected of each: a frame in which nothing moves while a hand drags, checks of the answer that is
shown and of no other, and everything else one press away.
"""

import json
import re
import tomllib
from pathlib import Path

import pytest
from playwright.sync_api import Page, Request, expect

from cli.running import wraparc
from web.browser import STUDY, Visitor, turn
from web.calculators import document
from web.test_first_screen import MOVED, SCREEN, STILL, WATCH, drag, middle
from web.test_standing import take
from worded import worded
from wraparc.arc import solve
from wraparc.checks import Level, judge
from wraparc.files import drive_from_text

pytestmark = pytest.mark.usefixtures("solved_once")

EXAMPLES = Path("examples")


def shows(visitor: Visitor, name: str, view: str) -> Page:
    """Open a shipped drive in a view, as it is at first."""
    page = visitor.open("drive", unfold=False)
    page.evaluate(
        "document.querySelectorAll('details[id$=-details]').forEach((d) => { d.open = false; })"
    )
    page.set_viewport_size(SCREEN)
    doc = document(name)
    for event in doc.get("motion", {}).get("event", ()):
        event["duration"] = "3 s"
    take(page, doc)
    visitor.solved()
    visitor.open(view, unfold=False)
    if view != "events":
        expect(page.locator(f"#{view} .screen")).to_have_attribute("data-stands", "fresh")
    return page


#: What is dragged in each view: everything that a hand can hold.
HELD = ":is([role=slider], input[type=range]):not(:disabled):visible"
#: What stands still besides what the first screen has.
BOXES = (
    ".rail fieldset, .rail fieldset > .field, .rail fieldset > .field > *, .rail legend,"
    " .rail details, .strip, .strip-name, .strip output, .facts, .facts *, .kv > *, .hero .bar,"
    " .hero .bar > *, .tabs > *, .drums, .drums p, .rows, .inline, .face-head,"
    " .transport > *, .transport label, .rail summary,"
    " .stage-box > *, .scale, .hue"
)
VIEWS = {"train": "tandem-fabric", "across": "worn-head-drive-fabric"}


def run(page: Page) -> None:
    page.select_option("#e-points", "30")
    page.get_by_role("button", name="Run it").click()
    expect(page.locator("#events .screen")).to_have_attribute("data-stands", "fresh", timeout=STUDY)


def dragged(page: Page, view: str, x: float, y: float) -> list[str]:
    """Drag from a place; what moved meanwhile, and what was asked of the server."""
    asked: list[str] = []
    page.wait_for_selector("html:not(.stale)")  # nothing of before is still to be asked

    def listen(request: Request) -> None:
        if "/api/" in request.url:
            asked.append(request.url)

    boxes = ", ".join(f"#{view} {part.strip()}" for part in f"{STILL}, {BOXES}".split(","))
    boxes += (
        f", header nav *, header .switch *, #{view} .switch *, #{view} .views *, #{view} .use *"
    )
    page.evaluate(WATCH, boxes)
    page.on("request", listen)
    drag(page, x, y, (x + 30, y + 20), 24)
    found, frames = page.evaluate(MOVED)
    page.remove_listener("request", listen)
    assert frames > 5
    return [*found, *asked]


@pytest.mark.parametrize("view", VIEWS)
def test_nothing_moves_and_nothing_is_asked_while_a_hand_drags(
    long_visit: Visitor, view: str
) -> None:
    page = shows(long_visit, VIEWS[view], view)
    handles = page.locator(f"#{view} {HELD}")
    count = handles.count()
    assert count >= {"train": 2, "across": 9}[view]
    for i in sorted({0, 1, count // 2, count - 1}):  # of points of one curve its ends and middle
        handle = handles.nth(i)
        handle.scroll_into_view_if_needed()
        box = handle.bounding_box()
        assert box is not None
        x, y = box["x"] + 0.4 * box["width"], box["y"] + box["height"] / 2
        name, before = handle.get_attribute("aria-label"), handle.get_attribute("aria-valuetext")
        assert dragged(page, view, x, y) == [], name
        assert handle.get_attribute("aria-valuetext") != before, name
        # Escape gives back, and what the hand does then is nothing
        page.keyboard.press("Escape")
        page.mouse.move(x + 60, y + 30)
        expect(handle).to_have_attribute("aria-valuetext", str(before))
        page.mouse.up()
    # one drag is asked once, when the hand lets go, and is one step back
    page.wait_for_selector("html:not(.stale)")
    asked: list[str] = []

    def listen(request: Request) -> None:
        what = request.url.rpartition("/v1/")[2]
        if not what.startswith("same/") and what != "solve/reserve":  # proofs; what comes last
            asked.append(what)

    page.on("request", listen)
    handle = page.locator(f"#{view} [role=slider]").first
    box = handle.bounding_box()
    before = handle.get_attribute("aria-valuetext")
    assert box is not None
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    drag(page, x, y, (x + 30, y + 20), 12)
    page.evaluate("const now = performance.now(); performance.now = () => now + 1e5")
    page.mouse.move(x + 40, y + 25)
    page.mouse.up()
    expect(handle).not_to_have_attribute("aria-valuetext", str(before))
    page.wait_for_selector("html:not(.stale)")
    expect(page.locator(f"#{view} .screen")).to_have_attribute("data-stands", "fresh")
    page.remove_listener("request", listen)
    page.evaluate("delete performance.now")
    assert sorted(asked) == sorted(["solve", "solve/fast", view])
    page.click("#undo")
    expect(handle).to_have_attribute("aria-valuetext", str(before))


@pytest.mark.parametrize("view", VIEWS)
def test_the_whole_answer_is_one_press_away(long_visit: Visitor, view: str) -> None:
    page = shows(long_visit, VIEWS[view], view)
    tables = page.locator(f"#{view} details.table")
    expect(tables.first).to_be_hidden()
    assert page.evaluate("document.documentElement.scrollHeight") < 1100
    page.click(f"#{view}-details > summary")
    expect(tables.first).to_be_visible()
    if view == "across":  # the strip that comes off worst: one number wherever it is said
        for place in (".say p", ".list li >> nth=0", ".t-checks"):
            expect(page.locator(f"#across {place}")).to_contain_text("8.98 mm")
        assert len(page.locator("#across .say p").inner_text().split()) <= 15 + 1  # and its level


def test_an_event_before_its_run_and_after(visitor: Visitor) -> None:
    page = shows(visitor, "tandem-fabric", "events")
    # before: as the drive runs steadily; expected: the pulls and creeps of `wraparc solve` in the
    # load case of the largest tension
    told = json.loads(wraparc("solve", "examples/tandem-fabric.toml", "--json", "-")[1])
    arcs = [a for a in told["arcs"] if a["load_case"] == "design"]
    captions = page.locator("#events .drums p")
    expect(captions).to_have_count(2)
    for caption, arc in zip(captions.all(), arcs, strict=True):
        pull = f"{arc['effective_tension'] / 1e3:.1f} kN"
        creep = f"{arc['exit_creep'] * 1e3:.2f} mm"
        expect(caption).to_have_text(f"{arc['pulley']} pulls {pull}, creep {creep}")
    expect(page.locator("#events")).to_contain_text("Running steadily, load case design")
    expect(page.locator("#events .play, #play")).to_have_count(0)
    # no verdict and no check goes with it
    checks, say = page.locator("#events .checks"), page.locator("#events .say")
    expect(checks).to_contain_text("not run")
    expect(checks.locator("li")).to_have_count(0)
    assert page.locator("#events :is(.good, .warn, .bad)").count() == 0
    # after: the checks are those of the command
    run(page)
    settings = ("--set", "motion.event.start.duration=3 s", "--points", "30", "--quiet")
    out = wraparc("run", str(EXAMPLES / "tandem-fabric.toml"), *settings, "--json", "-")[1]
    (table,) = (t for t in json.loads(out)["answer"]["tables"] if t["name"] == "checks")
    expected = {worded(row["title"]): worded(row["values"][0]) for row in table["rows"]}
    rows = checks.locator("li").all_inner_texts()
    assert len(rows) > 3
    for row in rows:
        title, value = row.replace("\n", " ").rsplit(", ", 1)[0], row
        assert expected[title.strip()] in value, row
    # nothing moves and nothing is asked while a hand drags the time, or along the curve
    time = page.locator("#play-time")
    assert page.locator(f"#events {HELD}").count() == 1
    for handle in ("#play-time", "#events .curve .chart"):
        before = time.get_attribute("aria-valuetext")
        assert dragged(page, "events", *middle(page, handle)) == []
        page.mouse.up()
        assert time.get_attribute("aria-valuetext") != before
    # of another design nothing is judged, and it says so
    page.fill("#e-motion-conveyor_mass", "120")
    expect(say).to_contain_text("The design changed.")
    expect(say.get_by_role("button", name="Run again")).to_be_enabled()
    expect(page.locator("#events .screen")).to_have_attribute("data-stands", "stale")
    assert page.locator("#events .say:is(.good, .warn, .bad)").count() == 0


def test_three_drives_share_the_whole_and_have_a_trim_each(long_visit: Visitor) -> None:
    page = shows(long_visit, "tandem-fabric", "train")
    page.click("#add-pulley")  # which idles: it is given nothing
    expect(page.locator("#train .strip")).to_have_count(3)
    parts = page.locator("#train .parts i")
    expect(parts).to_have_text(["first 50 %", "second 50 %", "third 0 %"])
    divider = page.get_by_role("slider", name="Load of second and third")
    divider.focus()
    for _ in range(2):
        page.keyboard.press("PageDown")
    expect(parts).to_have_text(["first 50 %", "second 30 %", "third 20 %"])
    shares = [page.input_value(f"#t-train-share-{i}") for i in range(3)]
    assert sum(float(share.split()[0]) for share in shares) == pytest.approx(100.0, abs=1e-9)
    expect(page.locator("#train svg.chain")).to_contain_text("third")
    # which of them is explained is chosen at its strip
    page.get_by_role("button", name="Trim of third").click()
    expect(page.locator("#train .facts").first).to_contain_text("Why third turns")
    # a drive with a speed of its own may be added and taken away
    page.select_option("#train-mode", "speeds")
    page.click("#add-pulley")
    page.get_by_role("button", name="Remove this drive").last.click()
    expect(page.locator("#train .screen")).to_have_attribute("data-stands", "fresh")


def test_the_sentence_is_of_the_load_case_that_governs(long_visit: Visitor) -> None:
    page = shows(long_visit, "triple-steel-cord", "train")
    page.locator("#cases-train").get_by_role("button", name="design").click()
    say = page.locator("#train .say")
    expect(say.locator("p")).to_have_text("ATTENTION: Drives oppose each other by 1.17 kN (empty).")
    governing = say.locator(".line").filter(has_text="Governing")
    expect(governing).to_have_text("Governing empty")
    say.get_by_role("button", name="empty").click()
    expect(governing).to_have_count(0)
    expect(say.locator(".line").filter(has_text="Action")).to_have_text(
        "Action Try torque sharing or closer speeds: run wraparc trim."
    )
    turn(page, "drive")
    expect(page.locator("#cases [aria-pressed=true]")).to_contain_text("empty")


def test_the_action_of_drives_that_fail_is_what_helps(long_visit: Visitor) -> None:
    # expected: what is said first is of the drum that it names, and is mended by one press
    page = long_visit.open("drive", unfold=False)
    doc = document("tandem-fabric")
    doc["train"]["exit_tension"] = "12 kN"
    doc["design_standard"] = {"name": "CEMA", "binding": True}
    doc["covered"] = True
    take(page, doc)
    long_visit.solved()
    long_visit.open("train", unfold=False)
    said = page.locator("#train-verdict")
    expect(said).to_have_class(re.compile("bad|warn"))
    expect(said.locator("p")).to_contain_text(re.compile(r": [A-Z].*\d.* \(second, \w+\)\."))
    expect(said.get_by_role("button", name="Find the trim limits")).to_have_count(0)
    said.get_by_role("button", name=re.compile(r"^Raise T2 from 12 to [\d.]+ kN\.$")).click()
    expect(said).to_have_class(re.compile("good"))


#: Two load cases that need attention: one creeps more, the other is further beyond its limit.
TWO_FAULTS = """format = 1
[belt]
preset = "Plylon Plus 1000/4"
largest_wrap_pressure = "320 kPa"
width = "1200 mm"
speed = "3 m/s"
[[pulley]]
name = "head"
diameter = "800 mm"
wrap_angle = "180 deg"
lagging = "diamond-rubber"
entry_tension = "120 kN"
exit_tension = "75 kN"
[[load_case]]
name = "creeps"
pulley.head.entry_tension = "150 kN"
pulley.head.exit_tension = "60 kN"
[[load_case]]
name = "presses"
pulley.head.entry_tension = "200 kN"
pulley.head.exit_tension = "150 kN"
"""


def test_worse_elsewhere_is_where_the_verdict_is_worst(long_visit: Visitor) -> None:
    # expected: the load case of the check that governs the verdict of the program
    verdict = judge(solve(drive_from_text(TWO_FAULTS)))
    assert verdict.governing is not None
    assert verdict.governing.place.load_case == "presses"
    assert verdict.within("creeps").level is verdict.level
    page = long_visit.open("drive", unfold=False)
    take(page, tomllib.loads(TWO_FAULTS))
    long_visit.solved()
    say = page.locator("#verdict")
    expect(say.locator(".line").filter(has_text="Governing")).to_have_text("Governing presses")
    expect(say.locator("p")).to_contain_text(
        "Face pressure 417 kPa exceeds the belt limit 320 kPa (head, presses)."
    )
    say.get_by_role("button", name="presses").click()
    expect(page.locator("#cases [aria-pressed=true]")).to_contain_text("presses")


def test_what_would_help_is_judged_in_every_load_case(long_visit: Visitor) -> None:
    # expected: levels of the program, of the whole drive with the change in it; in the load case
    # that is looked at alone every one of them is kept
    page = long_visit.open("drive", unfold=False)
    take(page, tomllib.loads(TWO_FAULTS.replace('"120 kN"', '"140 kN"')))
    long_visit.solved()
    page.wait_for_selector(".ways li")
    text = TWO_FAULTS.replace('"120 kN"', '"140 kN"').replace("diamond-rubber", "full-ceramic")
    judged = judge(solve(drive_from_text(text)))
    assert judged.level is Level.ATTENTION
    assert judged.within("design").level is Level.OK
    told = page.locator(".ways li").filter(has_text="Full ceramic")
    expect(told).to_contain_text(f", {judged.level}")


def test_a_second_drive_takes_the_load_cases_along_and_gives_them_back(
    long_visit: Visitor,
) -> None:
    page = shows(long_visit, "head-drive-fabric", "train")
    design = "() => JSON.parse(localStorage.getItem('wraparc.drafts'))[0].doc"
    page.get_by_role("button", name="Add a second drive").click()
    expect(page.locator("#train .screen")).to_have_attribute("data-stands", "fresh")
    several = page.evaluate(design)
    assert [case["name"] for case in several["load_case"]] == ["empty", "start"]
    assert all("train" in case for case in several["load_case"])
    # what does not move is named, and comes back with a press
    page.get_by_role("button", name="Remove this drive").last.click()
    expect(page.locator("#toast")).to_contain_text("Removed: pulley second, train share.")
    alone = page.evaluate(design)
    assert [[*case["pulley"]] for case in alone["load_case"]] == [["head"], ["head"]]
    page.locator("#toast").get_by_role("button", name="Undo").click()
    assert page.evaluate(design) == several
