"""The calculator of one file, opened from the disk with no network: the numbers of the command."""

import base64
import hashlib
import json
import re
import subprocess
import zlib
from collections.abc import Iterator
from html import unescape
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, Page, expect

import site_pages
from cli.running import wraparc
from web.browser import Visitor, show_case, turn, unsigned
from web.calculators import wait_for
from web.firefox import Firefox, firefox
from web.test_case_loads import EMPTY_FIRST, meant
from web.test_page_file_trains import assert_firefox_says
from web.test_pages_looks import violations
from worded import worded
from wraparc.answer.arc_tables import capacity_table
from wraparc.answer.checks_table import check_table
from wraparc.answer.least_tension import least_sentence
from wraparc.answer.sheet import shown as shown_in
from wraparc.arc import solve
from wraparc.checks import judge
from wraparc.files import load_drive
from wraparc.schema.source import parse
from wraparc.units import RESULT_DIGITS, System, display, in_units
from wraparc.web.answers.compare import CompareAnswer, compare
from wraparc.web.answers.documents import json_like
from wraparc.web.asked import CompareRequest

pytestmark = pytest.mark.usefixtures("solved_once")
ROOT = Path(__file__).parents[2]
EXAMPLES = ROOT / "examples"
#: Largest size of a page [bytes].
MOST = 378_000
HEAD = (EXAMPLES / "head-drive-fabric.toml").read_text("utf-8")
OWN = (
    'condition = { name = "dusty", friction_factor = 0.8 }\n'
    + HEAD.replace('lagging = "diamond-rubber"', 'lagging = "ours"')
    + """
[lagging.ours]
surface = "rubber"
thickness = "11 mm"
shear_modulus = "2.2 MPa"
bond_strength = "0.6 bar"
law = { kind = "elastic-plastic", friction = 0.55, stiffness = "60 kPa/mm" }
"""
)
#: Drives, with the levels of their verdicts: each takes a way of its own through the page. What is
#: read and judged of every shipped drive: test_page_documents.py and test_judging.py.
DRIVES: dict[str, tuple[str, str]] = {
    "kept": (
        HEAD.partition("# The tensions above")[0].replace('"60 kN"', '"92 kN"')
        + '[take_up]\nkind = "gravity"\n[sag]\nidler_spacing = "3 m"\nline_mass = "22 kg/m"\n',
        "OK",
    ),
    "breakaway": (HEAD.replace('exit_tension = "60 kN"', 'exit_tension = "2 kN"'), "FAILS"),
    "wet and dry": ('condition = ["dry", "wet"]\n' + HEAD, "ATTENTION"),
    "braking, US units": ((EXAMPLES / "downhill-braking.toml").read_text("utf-8"), "OK"),
    "contradicted take-up": (
        HEAD.replace("[[load_case]]", '[take_up]\nkind = "fixed"\n[[load_case]]', 1)
        + '[design_standard]\nname = "DIN 22101"\nbinding = true\n',
        "ATTENTION",
    ),
}
DRIVES["own lagging, dusty"] = OWN, "ATTENTION"
_COVERS = (
    '[belt]\nstrength = "1000 kN/m"\n'
    'pulley_cover = "4 mm"\ncarry_cover = "8 mm"\nmass = "20 kg/m"\n'
    'cover_shear_modulus = "0.9 MPa"\n'
)
DRIVES["carry side, covers, bond strength"] = (
    HEAD.replace("[belt]\n", _COVERS).replace(
        'lagging = "diamond-rubber"',
        'side = "carry"\nlagging = { preset = "diamond-rubber", bond_strength = "0.1 MPa", '
        'fatigue_limit = "0.2 MPa" }',
    ),
    "ATTENTION",
)
DRIVES["steel cord of no rating"] = (
    HEAD.replace(
        'preset = "Plylon Plus 1000/4"',
        'name = "ST1000"\nkind = "steel cord"\nmodulus = "72000 kN/m"',
    ).replace('"60 kN"', '"120 kN"'),
    "ATTENTION",
)
FITTED = (
    HEAD.replace('lagging = "diamond-rubber"', 'lagging = "ours"')
    + """
[lagging.ours]
surface = "rubber"
thickness = "12 mm"
shear_modulus = "2.3 MPa"
[lagging.ours.law]
kind = "integral-log"
knots = [
    { pressure = "34 kPa", peak_friction = 0.9, peak_slip = "10 mm" },
    { pressure = "200 kPa", peak_friction = 0.8, peak_slip = "12 mm" },
    { pressure = "690 kPa", peak_friction = 0.6, peak_slip = "14 mm" },
]
[lagging.ours.law.fit]
parameters = ["knots[2].peak_friction", "knots[2].peak_slip"]
values = [0.8, 0.012]
covariance = [[1e-3, 0.0], [0.0, 1e-6]]
"""
)
UPHILL = (EXAMPLES / "uphill-conveyor.toml").read_text("utf-8")
DRIVES["conveyor, drive at the tail"] = (
    UPHILL.replace('lift = "20 m"', 'lift = "-4 m"\ndrive_at = "tail"\nstart_time = "25 s"')
    .replace("start_factor = 1.3", "# start_factor")
    .replace('counterweight = "8 t"', 'take_up_tension = "60 kN"'),
    "OK",
)
READY = "html:not(.stale) #drive .screen[data-whole]"


@pytest.fixture
def page_of(chrome: Browser, tmp_path: Path) -> Iterator[Any]:
    """A function that writes the page of a drive and opens it from the disk, without a network."""
    visits, written = [], set()

    def opened(text: str, name: str = "drive", *, governing: bool = False) -> Page:
        file, html = tmp_path / f"{name}.toml", tmp_path / f"{name}.html"
        written.add(html.as_uri())
        file.write_text(text, "utf-8")
        assert wraparc("page", str(file), "-o", str(html))[0] == 0
        visitor = Visitor(chrome, html.as_uri(), offline=True)
        visits.append(visitor)
        visitor.page.goto(html.as_uri())
        visitor.page.wait_for_selector(READY)
        if not governing:
            show_case(visitor.page, meant(file))
            visitor.page.wait_for_selector(READY)
        visitor.unfold()
        return visitor.page

    yield opened
    for visitor in visits:
        visitor.close()
        assert visitor.wrong == []
        assert set(visitor.elsewhere) <= written


def figure(page: Page, name: str) -> str:
    """Return a key figure as shown."""
    found = page.locator("#drive .figures > div").filter(has=page.locator(f"dt:text-is('{name}')"))
    return str(found.locator("b").inner_text())


def unpacked(digits: str) -> str:
    """Return the text of an element: base 85 of Python, a comma in the place of ``<``."""
    return zlib.decompress(base64.b85decode(digits.replace(",", "<"))).decode("utf-8")


def assert_shows_what_solve_says(page: Page, file: Path) -> str:
    """Compare what a page shows with `wraparc solve`; return the level."""
    told = json.loads(wraparc("solve", str(file), "--json", "-")[1])
    verdict = told["verdict"]
    case = load_drive(file).load_case().name  # which the page looks at
    arc = next(a for a in told["arcs"] if a["load_case"] == case)
    result = solve(load_drive(file), raise_on_failure=False)
    found, least = judge(result), least_sentence(result)
    carried_by = capacity_table(result.arc(arc["pulley"], case))
    systems: tuple[System, System] = ("si", "us")
    for system in systems:
        page.get_by_label(system.upper(), exact=True).check(force=True)
        said = page.locator(".governing .headline").inner_text()
        assert said.partition(" ")[2] == f"{verdict['label']} {in_units(found.text, system)}"
        sentences = page.locator(".governing li").all_inner_texts()
        assert sentences == [in_units(text, system) for text in (least, *found.full)]
        rows = page.locator("#drive .t-checks tbody tr").all_inner_texts()
        shown = [[unsigned(cell) for cell in row.split("\t")[:5]] for row in rows]
        assert shown == [[r.title, *r.values] for r in shown_in(check_table(found), system).rows]
        carried = shown_in(carried_by, system)
        assert carried is not None
        cells: list[list[str]] = page.locator("#drive .t-capacity tbody tr").evaluate_all(
            "rows => rows.map((r) => [...r.cells].map((c) => c.textContent.trim()))"
        )
        expected_rows = [[r.title, *r.values, r.note] for r in carried.rows]
        assert [[c[0], c[2], c[3]] for c in cells[: len(expected_rows)]] == expected_rows
        creep = arc["exit_creep"]
        expected = "–" if creep is None else display(creep, "length", system, digits=RESULT_DIGITS)
        assert figure(page, "Creep at exit") == expected
    page.get_by_label("SI", exact=True).check(force=True)
    assert figure(page, "Margin to the creep limit") == display(
        arc["creep_limit_margin"], "number", digits=RESULT_DIGITS
    )
    return str(verdict["level"])


#: Those that Firefox is shown.
FOXES = ("breakaway", "braking, US units", "kept")


@pytest.mark.parametrize("name", [n for n in DRIVES if n not in ("breakaway", "kept")])
def test_page_from_the_disk_shows_what_solve_says(page_of: Any, tmp_path: Path, name: str) -> None:
    # expected: the command line, to the last digit it prints
    text, level = DRIVES[name]
    page = page_of(text)
    assert assert_shows_what_solve_says(page, tmp_path / "drive.toml") == level


#: What a page shows of its answer, for a browser that only runs scripts.
SHOWN = """
const folded = ["more", "details"].map((id) => document.getElementById(id));
if (folded.includes(null)) return null;
for (const part of folded) part.open = true;
const texts = (of) => [...document.querySelectorAll(of)].map((e) => e.innerText.trim());
if (!document.querySelector("html:not(.stale) #drive .t-capacity")) return null;
return {
  headline: texts(".governing .headline")[0],
  sentences: texts(".governing li"),
  rows: [...document.querySelectorAll("#drive .t-checks tbody tr")].map((row) =>
    [...row.cells].slice(0, 5).map((cell) => cell.textContent)),
  creep: texts("#drive .figures b")[0],
};
"""
MOVE = """
const slider = document.querySelector("[aria-label='Exit tension, slider']");
slider.value = +slider.value + 40;
slider.dispatchEvent(new Event("input", { bubbles: true }));
"""
EXIT = "return document.querySelector('#f-pulley-0-exit_tension').value;"


@pytest.mark.processes
def test_firefox_shows_from_the_disk_what_solve_says(tmp_path: Path) -> None:
    # expected: the command line; after a moved slider too; trains by motors and by speeds
    profile = tmp_path / "profile"
    profile.mkdir()
    with firefox(profile) as browser:
        for name in FOXES:
            file, html = tmp_path / "drive.toml", tmp_path / "drive.html"
            file.write_text(DRIVES[name][0], "utf-8")
            assert wraparc("page", str(file), "-o", str(html))[0] == 0
            browser.open(html.as_uri())
            assert_is_what_solve_says(browser, file, "us" if "US" in name else "si")
        before = browser.run(SHOWN)
        browser.run(MOVE)
        wait_for(lambda: browser.run(SHOWN) not in (None, before))
        moved = browser.run(EXIT)
        assert moved != "92"
        file.write_text(DRIVES["kept"][0].replace('"92 kN"', f'"{moved} kN"'), "utf-8")
        assert_is_what_solve_says(browser, file, "si")
        for name in ("motors", "speeds break away"):
            assert_firefox_says(browser, tmp_path, name)


def assert_is_what_solve_says(browser: Firefox, file: Path, system: System) -> None:
    found: list[Any] = []

    def complete() -> bool:
        found.append(browser.run(SHOWN))
        return found[-1] is not None

    wait_for(complete)
    result = solve(load_drive(file), raise_on_failure=False)
    verdict, shown = judge(result), found[-1]
    headline = f"{verdict.label} {in_units(verdict.text, system)}"
    assert shown["headline"].partition(" ")[2].strip() == headline
    sentences = [in_units(text, system) for text in (least_sentence(result), *verdict.full)]
    assert shown["sentences"] == sentences
    # the balance is what the search leaves, and each browser has an exponential of its own
    told = [[unsigned(cell) for cell in row] for row in shown["rows"]]
    rest = [row for row in told if "balance" not in row[0]]
    rows = shown_in(check_table(verdict), system).rows
    assert rest == [[r.title, *r.values] for r in rows if "balance" not in r.title]


def saved(page: Page, into: Path) -> str:
    """Save the drive of a page; return its text."""
    with page.expect_download() as download:
        page.click("#file > summary")
        page.get_by_role("button", name="Download the drive file").click()
    download.value.save_as(into)
    return into.read_text("utf-8")


def test_what_is_moved_and_saved_is_solved_alike_and_keeps_its_comments(
    page_of: Any, tmp_path: Path
) -> None:
    page = page_of(HEAD)
    page.get_by_label("Exit tension, slider", exact=True).focus()
    for _ in range(9):
        page.keyboard.press("ArrowRight")
    page.get_by_label("Condition of the lagging").select_option("wet")
    page.select_option("#f-pulley-0-lagging", "full-ceramic")
    page.select_option("#f-belt-preset", "Plylon Plus 1250/5")
    page.wait_for_selector(READY)
    file = tmp_path / "saved.toml"
    text = saved(page, file)
    assert_shows_what_solve_says(page, file)
    document = parse(text)
    assert document["condition"] == "wet"
    assert document["pulley"][0]["lagging"] == "full-ceramic"
    assert document["belt"]["preset"] == "Plylon Plus 1250/5"
    assert document["pulley"][0]["exit_tension"] != "60 kN"
    # every line of the file but those that changed, with its comment
    kept = [line for line in HEAD.splitlines() if line in text.splitlines()]
    assert len(HEAD.splitlines()) - len(kept) == 3
    assert "# T2, set by the take-up" in text


def test_saved_file_is_opened_again(page_of: Any, tmp_path: Path) -> None:
    page = page_of(HEAD)
    other = tmp_path / "other.toml"
    other.write_text(DRIVES["braking, US units"][0], "utf-8")
    with page.expect_file_chooser() as asked:
        page.click("#file > summary")
        page.get_by_role("button", name="Open a drive file").click()
    asked.value.set_files(other)
    expect(page.locator("#title")).to_have_text("Downhill conveyor, braking drive")
    page.wait_for_selector(READY)
    show_case(page, meant(other))
    page.wait_for_selector(READY)
    assert_shows_what_solve_says(page, other)
    assert saved(page, tmp_path / "again.toml") == other.read_text("utf-8")


def test_what_is_left_to_the_program_is_no_failure(page_of: Any) -> None:
    # expected: `wraparc solve` finds nothing wrong with either drive, and the page does not judge
    page = page_of(HEAD)
    page.wait_for_selector(READY)
    alert = page.locator("#results [role=alert]")
    page.fill("#f-pulley-0-exit_tension", "150")  # as T1: an idle pulley
    page.press("#f-pulley-0-exit_tension", "Tab")
    expect(alert).to_contain_text("Not solved in this page")
    expect(alert).not_to_contain_text("FAILS")
    with page.expect_file_chooser() as asked:
        page.click("#file > summary")
        page.get_by_role("button", name="Open a drive file").click()
    asked.value.set_files(EXAMPLES / "worn-head-drive-fabric.toml")
    expect(alert).to_contain_text("The load across the width of pulley head is not solved")
    expect(alert).to_contain_text("wraparc solve FILE")
    expect(page.locator(".badge.good:visible")).to_have_count(0)
    expect(page.locator("#results")).not_to_contain_text("needed")


def test_each_page_brings_back_its_own_drive(page_of: Any) -> None:
    # pages from the disk share what their window keeps
    tension = "#f-pulley-0-exit_tension"
    page = page_of(HEAD)
    show_case(page, 0)
    page.fill(tension, "72.5")
    page.reload()
    expect(page.locator(tension)).to_have_value("72.5")
    address = page.url.partition("#")[0]
    steel_cord = (EXAMPLES / "steel-cord-drive.toml").read_text("utf-8")
    page.goto(page_of(steel_cord, "other").url)
    page.wait_for_selector(READY)
    show_case(page, 0)
    page.fill(tension, "44")
    page.go_back()
    page.wait_for_url(f"{address}**")
    expect(page.locator(tension)).to_have_value("72.5")


def test_profiles_are_those_of_solve(page_of: Any, tmp_path: Path) -> None:
    # expected: `wraparc solve --csv` of the same file, to what rounding leaves
    page = page_of(HEAD)
    page.wait_for_selector(READY)
    page.click("#file > summary")
    with page.expect_download() as asked:
        page.get_by_role("button", name="Profiles along the wrap (CSV)").click()
    asked.value.save_as(tmp_path / "own.csv")
    (tmp_path / "drive.toml").write_text(HEAD, "utf-8")
    wraparc("solve", tmp_path / "drive.toml", "--csv", tmp_path / "all.csv")
    own, told = ((tmp_path / n).read_text("utf-8").splitlines() for n in ("own.csv", "all.csv"))
    assert own[0] == told[0]
    assert len(own) == len(told) > 3 * 181
    for ours, theirs in zip(own[1:], told[1:], strict=True):
        a, b = ours.split(","), theirs.split(",")
        assert a[:3] == b[:3]
        numbers = [[float(v) for v in cells[3:]] for cells in (a, b)]
        assert numbers[0] == pytest.approx(numbers[1], rel=1e-7, abs=1e-9)


def test_a_belt_that_would_push_is_told_as_by_solve(page_of: Any, tmp_path: Path) -> None:
    page = page_of(UPHILL)
    page.wait_for_selector(READY)
    file = tmp_path / "push.toml"
    file.write_text(
        UPHILL.replace('counterweight = "8 t"', 'counterweight = "0.2 t"').replace(
            'lift = "20 m"', 'lift = "-20 m"'
        ),
        "utf-8",
    )
    ran = wraparc("solve", file)
    assert ran.code != 0
    told = ran.err.partition("conveyor.take_up_tension: ")[2].strip().partition(". ")[0]
    assert told.startswith("leaves -10.86 kN at the drive pulley in load case stop")
    with page.expect_file_chooser() as asked:
        page.click("#file > summary")
        page.get_by_role("button", name="Open a drive file").click()
    asked.value.set_files(file)
    expect(page.locator("#results")).to_contain_text(told)
    expect(page.locator("#results")).not_to_contain_text("not calculated in this page")


def test_a_drive_typed_from_nothing_is_solved(page_of: Any, tmp_path: Path) -> None:
    page = page_of(HEAD)
    page.click("#file > summary")
    page.get_by_role("button", name="New drive", exact=True).click()
    expect(page.locator("#results")).to_contain_text("Type T1 and T2")
    typed = {
        "pulley-0-entry_tension": "120", "pulley-0-exit_tension": "60", "belt-width": "1000 mm",
        "pulley-0-diameter": "630", "pulley-0-wrap_angle": "190", "belt-modulus": "12000",
    }  # fmt: skip
    for key, value in typed.items():
        page.fill(f"#f-{key}", value)
    page.select_option("#f-pulley-0-lagging", "medium-ceramic")
    page.wait_for_selector(READY)
    file = tmp_path / "typed.toml"
    saved(page, file)
    assert_shows_what_solve_says(page, file)
    page.fill("#f-pulley-0-diameter", "0")
    expect(page.locator("#f-pulley-0-diameter-e")).to_contain_text(
        "must be between 1 mm and 1000 m"
    )


HOSTILE = "</script><script>alert(1)</script><!--'\"&⟦belt⟧{value}"


def test_hostile_names_stay_names(page_of: Any) -> None:
    title = json.dumps(HOSTILE, ensure_ascii=False)
    text = HEAD.replace('"Head drive, ROM conveyor"', title).replace('"head"', title)
    text = text.replace("pulley.head.", f"pulley.{title}.")
    page = page_of(text)
    dialogs: list[str] = []
    page.on("dialog", lambda dialog: dialogs.append(dialog.message))
    expect(page.locator("#title")).to_have_text(HOSTILE)
    expect(page.locator(".governing .headline").first).to_contain_text(f"({HOSTILE}, ")
    assert dialogs == []


def test_pictures_are_taken_away_without_a_server(page_of: Any, tmp_path: Path) -> None:
    # expected: the courses that the page draws, as the served page gives them
    page = page_of(HEAD)
    page.click("#file > summary")
    with page.expect_download() as arriving:
        page.get_by_role("button", name="Pictures of this page (SVG)").click()
    arriving.value.save_as(tmp_path / "pictures.svg")
    told = (tmp_path / "pictures.svg").read_text("utf-8")
    for course in page.locator("#drive .plots path.line").all():
        assert f'd="{course.get_attribute("d")}"' in told
    assert not any(word in told for word in ("var(", "class=", "href"))
    # what only a server makes is not offered
    expect(page.get_by_text("Results (JSON)")).to_have_count(0)


def test_page_is_accessible(page_of: Any) -> None:
    assert violations(page_of(HEAD)) == []


def made(*arguments: str) -> str:
    code, out, _ = wraparc("page", *arguments, "-o", "-")
    assert code == 0
    return out


def test_file_is_small_runs_its_own_scripts_alone_and_reaches_nothing() -> None:
    for example in sorted(EXAMPLES.glob("*.toml")):
        code, out, _ = wraparc("page", str(example), "-o", "-")
        assert len(out.encode("utf-8")) < MOST
        assert code == (0 if out else 2)
    html = made()
    policy = unescape(re.findall(r'Content-Security-Policy" content="([^"]*)"', html)[0])
    rules = {rule.split()[0]: rule.split()[1:] for rule in policy.split("; ")}
    (start,) = re.findall(r'<script type="module">(.*?)</script>', html, re.S)
    packed = re.findall(r'id="(?:style|solver|program)-packed">(.*?)</script>', html, re.S)
    style, *scripts = map(unpacked, packed)
    assert len(scripts) == 2
    assert rules["script-src"] == [digest(script) for script in (start, *scripts)]
    assert rules["style-src"] == [digest(style)]
    for nothing in ("default-src", "connect-src", "base-uri", "form-action"):
        assert rules[nothing] == ["'none'"]
    assert rules["worker-src"] == ["blob:"]
    assert (
        re.findall(r"""(?:src|href)=["']?(?!data:|#)[^"'\s>]+""", html.partition("<body>")[0]) == []
    )
    assert "https://" not in html


def digest(text: str) -> str:
    hashed = hashlib.sha256(text.encode("utf-8")).digest()
    return f"'sha256-{base64.b64encode(hashed).decode('ascii')}'"


def test_bundle_is_what_its_source_gives() -> None:
    done = subprocess.run(
        ["node", "tools/page_bundle.mjs", "--check"],
        cwd=ROOT, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize(
    ("file", "says"),
    [
        ("worn-head-drive-fabric.toml", "across: is not solved in"),
        ("studies/wet-dry.toml", "is a study"),
        ("nowhere.toml", "nowhere.toml: file not found."),
    ],
)
def test_what_a_page_cannot_solve_is_expected_rowsand_nothing_is_written(
    tmp_path: Path, file: str, says: str
) -> None:
    code, _, error = wraparc("page", str(EXAMPLES / file), "-o", str(tmp_path / "page.html"))
    assert code == 2
    assert says in error
    assert "Traceback" not in error
    assert list(tmp_path.iterdir()) == []


def test_interval_of_a_fitted_law_is_left_to_the_program_and_told(
    page_of: Any, tmp_path: Path
) -> None:
    # expected: numbers and every other check as of `wraparc solve`
    page = page_of(FITTED, "fitted")
    told = json.loads(wraparc("solve", str(tmp_path / "fitted.toml"), "--json", "-")[1])
    arc = told["arcs"][0]
    assert arc["exit_creep_high"] is not None
    creep = display(arc["exit_creep"], "length", digits=RESULT_DIGITS)
    assert figure(page, "Creep at exit") == creep
    note = page.locator("#drive .t-checks").inner_text()
    assert "Creep, 95 % bound" in note
    # what the page cannot find leaves no bare OK
    assert "ATTENTION" in page.locator(".governing .headline").first.inner_text()
    said = page.locator(".governing").inner_text()
    assert "Creep, 95 % bound, is not computed in this page" in said
    said = "The interval of the creep that the fit of ours leaves is not calculated in this page"
    assert said in page.locator("#results").inner_text()


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (('exit_tension = "60 kN"', 'exit_tension = "150 kN"'), "pulley head transmits no Te"),
        (('diameter = "800 mm"', 'diameter = "80 mm"'), ""),  # it is asked about, as by solve
        (("3 m/s", "3 m/s"), ""),
    ],
)
def test_what_the_page_does_not_judge_is_told(
    tmp_path: Path, change: tuple[str, str], says: str
) -> None:
    file = tmp_path / "drive.toml"
    file.write_text(HEAD.replace(*change), "utf-8")
    code, _, told = wraparc("page", str(file), "-o", str(tmp_path / "page.html"))
    assert code == 0
    assert says in told
    assert ("does not judge" in told) is bool(says)


def test_no_page_is_written_where_none_can_stand(tmp_path: Path) -> None:
    code, _, error = wraparc("page", "-o", str(tmp_path / "none" / "page.html"))
    assert (code, "its folder does not exist" in error) == (2, True)
    code, _, error = wraparc("page", "-o", str(tmp_path / "page.pdf"))
    assert (code, "must end in .html or .htm" in error) == (2, True)


def test_a_report_carries_the_page_of_its_drive(tmp_path: Path) -> None:
    # expected: what is put over the file by options is in the page, as in the note
    note, html = tmp_path / "note.md", tmp_path / "note.html"
    told = ("--set", 'pulley.head.exit_tension="70 kN"', "--creep-limit", "9 mm")
    code, _, said = wraparc(
        "report", str(EXAMPLES / "head-drive-fabric.toml"), "-o", str(note),
        "--page", str(html), *told, "--conditions", "wet",
    )  # fmt: skip
    assert code == 0
    assert said.splitlines()[-1] == f"Wrote {html}"
    packed = re.findall(r'id="data">(.*?)</script>', html.read_text("utf-8"), re.S)[0]
    data = json.loads(unpacked(packed))
    document = data["start"]["document"]
    assert document["pulley"][0]["exit_tension"] == "70 kN"
    assert (document["creep_limit"], document["condition"]) == ("9 mm", ["wet"])
    assert parse(data["start"]["toml"]) == document


def test_no_note_is_written_where_its_page_cannot_be(tmp_path: Path) -> None:
    file = str(EXAMPLES / "worn-head-drive-fabric.toml")
    out = str(tmp_path / "note.md"), "--page", str(tmp_path / "note.html")
    code, _, error = wraparc("report", file, "-o", *out)
    assert (code, "across: is not solved" in error) == (2, True)
    assert list(tmp_path.iterdir()) == []


def test_site_has_calculator_and_examples(tmp_path: Path) -> None:
    site_pages.write(tmp_path)
    listed = (tmp_path / "examples" / "index.html").read_text("utf-8")
    links = re.findall(r'href="([^"]*)"', listed)
    there = {link for link in links if (tmp_path / "examples" / link).is_file()}
    assert set(links) - there == {"../index.html"}  # the documentation
    assert {f"{path.stem}.toml" for path in EXAMPLES.glob("*.toml")} <= there
    assert "head-drive-fabric.html" in there
    assert "tandem-fabric.html" in there
    assert "worn-head-drive-fabric.html" not in there


@pytest.mark.parametrize("name", ["braking, US units", "wet"])
def test_comparison_is_that_of_the_server(page_of: Any, name: str) -> None:
    # expected: the server's own comparison, without what it costs
    text = 'condition = "wet"\n' + HEAD if name == "wet" else DRIVES[name][0]
    page = page_of(text)
    turn(page, "compare")
    whats: tuple[Any, ...] = ("laggings",) if name == "wet" else ("laggings", "belts")
    for what in whats:
        page.get_by_label(what.capitalize(), exact=True).check(force=True)
        expected = compare(CompareRequest(document=json_like(parse(text)), what=what))
        assert_compares(page, expected, what, "us" if "US" in name else "si")
        if not expected.rows[0].present:
            page.locator("#compare tbody tr").first.get_by_role("button", name="Use").click()
            first = expected.rows[0].name if what == "belts" else expected.rows[0].title
            present = page.locator("#compare tbody tr.present th")
            expect(present).to_contain_text(first)
            page.click("#undo")
            expect(present).not_to_contain_text(first)


def assert_compares(page: Page, expected: CompareAnswer, what: str, system: System) -> None:
    rows = page.locator("#compare tbody tr")
    expect(rows).to_have_count(len(expected.rows))
    expect(page.locator("#compare [role=status]")).to_contain_text(f"{len(expected.rows)} {what}")
    keys = [c.key for c in expected.columns if not c.key.startswith("cost") and c.key != "outside"]
    keys = [k for k in keys if any(r.cells[k].value is not None for r in expected.rows)]
    for shown, row in zip(rows.all(), expected.rows, strict=True):
        cells = [cell.text_content() for cell in shown.locator("td.num").all()]
        told = [worded(row.cells[key].text, system) for key in keys]
        assert [str(cell).replace(" (best)", "") for cell in cells] == told
        answer = str(shown.locator("td").nth(1).text_content())
        assert answer.endswith(f"{row.label} {row.short}")
        titled = f"{row.name}, {row.title}" if what == "belts" else row.title
        assert str(shown.locator("th").text_content()).startswith(titled)


def test_the_case_that_governs_is_looked_at(page_of: Any) -> None:
    # where none is named: that of the worst check, by hand the start of a drive, and of a train the
    # case that pulls most; not the first of the file
    page = page_of(EMPTY_FIRST, governing=True)
    expect(page.locator("#cases [aria-pressed=true]")).to_contain_text("start")
    train = (
        (EXAMPLES / "tandem-fabric.toml").read_text("utf-8").partition("# The drives in time")[0]
    )
    heavy = '[[load_case]]\nname = "heavy"\ntrain.effective_tension = "110 kN"\n'
    page = page_of(train + heavy, "train", governing=True)
    expect(page.locator("#cases [aria-pressed=true]")).to_contain_text("heavy")
