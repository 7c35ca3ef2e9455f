"""What is asked beside the answer: the sentences and tables of the command line."""

import base64
import re
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Locator, expect
from starlette.testclient import TestClient

from cli.running import wraparc
from web.browser import Visitor, evaluated, unsigned
from web.calculators import API, client, document
from web.test_pages_looks import violations
from worded import worded
from wraparc.units import System

EXAMPLES = Path(__file__).parents[2] / "examples"
HEAD = str(EXAMPLES / "head-drive-fabric.toml")


@pytest.fixture(scope="module")
def api() -> Iterator[TestClient]:
    with client() as found:
        yield found


def words(text: str) -> str:
    return " ".join(text.split())


def printed(*command: str) -> str:
    """Return what a command prints, on lines that hold everything."""
    with pytest.MonkeyPatch.context() as wide:
        wide.setenv("COLUMNS", "4000")
        return words(wraparc(*command, "--full")[1])


def told(sheet: Any, system: System = "si") -> list[str]:
    """Return every text of a sheet."""
    found = [sheet["verdict"]["text"], *sheet["verdict"]["sentences"], *sheet["remarks"]]
    for table in sheet["tables"]:
        found += [table["title"], *table["heads"]]
        for row in table["rows"]:
            found += [row["title"], *row["values"]]
    return [words(worded(text, system)) for text in found]


@pytest.mark.parametrize(
    ("name", "asked", "options"),
    [
        (
            "head-drive-fabric",
            {"wet": "DIN 22101", "worn": ["6 mm"], "bare": "CEMA", "load_case": "design"},
            ["--wet", "DIN 22101", "--worn", "6 mm", "--bare", "CEMA", "--load-case", "design"],
        ),
        (
            "head-drive-fabric",
            {"other_carcass": True, "belts": ["Plylon Plus 800/4"], "laggings": ["full-ceramic"]},
            ["--other-carcass", "--belt", "Plylon Plus 800/4", "--lagging", "full-ceramic"],
        ),
        (
            "tandem-fabric",
            {"thicknesses": ["20 mm"], "wet": "0.8", "pulley": "second"},
            ["--thickness", "20 mm", "--wet", "0.8", "--pulley", "second"],
        ),
    ],
)
@pytest.mark.parametrize("system", ["si", "us"])
def test_what_if_is_that_of_the_command(
    api: TestClient, name: str, asked: dict[str, Any], options: list[str], system: System
) -> None:
    # expected: everything that `wraparc what-if` prints
    answer = api.post(f"{API}/what-if", json={"document": document(name), **asked})
    assert answer.status_code == 200, answer.text
    out = printed("what-if", str(EXAMPLES / f"{name}.toml"), *options, "--units", system)
    missing = [text for text in told(answer.json(), system) if text not in out]
    assert missing == []


def test_what_is_expected_on_site_is_that_of_the_command(api: TestClient) -> None:
    # expected: everything that `wraparc field` prints
    hours = {"design": 4000.0, "empty": 1000.0}
    wear = {"measured_wear": "1 mm", "wear_hours": {"design": 12000.0}, "depth": "6 mm"}
    asked = {"document": document(), "hours": hours, **wear}
    answer = api.post(f"{API}/field", json=asked)
    assert answer.status_code == 200, answer.text
    out = printed(
        "field", HEAD, "--hours", "design=4000", "--hours", "empty=1000", "--measured-wear",
        "1 mm", "--wear-hours", "design=12000", "--depth", "6 mm",
    )  # fmt: skip
    missing = [text for text in told(answer.json()) if text not in out]
    assert missing == []


@pytest.mark.parametrize(
    ("path", "asked", "key"),
    [
        ("what-if", {}, ""),
        ("what-if", {"worn": ["-1 mm"]}, "worn"),
        ("what-if", {"worn": ["thin"]}, "worn"),
        ("what-if", {"wet": "CEMA 9"}, "condition.wet"),
        ("what-if", {"laggings": ["../secret.toml"]}, "lagging"),
        ("choose", {"laggings": ["../secret.toml"]}, "candidates.laggings[1]"),
        ("choose", {"belts": ["rope"]}, "candidates.belts[1]"),
        ("choose", {"diameters": ["-1 m"]}, "candidates.diameters[1]"),
        (
            "choose",
            {
                "diameters": ["1 m"] * 50,
                "wrap_angles": ["180 deg"] * 50,
                "thicknesses": ["10 mm"] * 9,
            },
            "candidates",
        ),
        ("field", {"measured_wear": "1 mm"}, "wear_hours"),
        ("field", {"depth": "0 mm"}, "depth"),
    ],
)
def test_what_cannot_be_asked_is_refused_in_its_place(
    api: TestClient, path: str, asked: dict[str, Any], key: str
) -> None:
    answer = api.post(f"{API}/{path}", json={"document": document(), **asked})
    assert answer.status_code == 422, answer.text
    assert answer.json()["problems"][0]["path"] == key


def test_choice_is_that_of_the_command(api: TestClient, tmp_path: Path) -> None:
    # expected: everything that `wraparc choose` prints of the same candidates
    (tmp_path / "drive.toml").write_text(Path(HEAD).read_text("utf-8"), "utf-8")
    (tmp_path / "choose.toml").write_text(
        """
        format = 1
        drive = "drive.toml"
        [candidates]
        laggings = ["diamond-rubber", "full-ceramic"]
        thicknesses = ["10 mm", "15 mm"]
        wrap_angles = ["180 deg", "210 deg"]
        slack_tensions = "least"
        [cost]
        currency = "AUD"
        years = 8
        tariff = 0.2
        hours.design = 5000
        """,
        "utf-8",
    )
    asked = {
        "laggings": ["diamond-rubber", "full-ceramic"],
        "thicknesses": ["10 mm", "15 mm"],
        "wrap_angles": ["180 deg", "210 deg"],
        "least_slack": True,
        "years": 8,
        "tariff": 0.2,
        "hours": {"design": 5000},
    }
    answer = api.post(f"{API}/choose", json={"document": document(), **asked})
    assert answer.status_code == 200, answer.text
    out = printed("choose", str(tmp_path / "choose.toml"))
    texts = told(answer.json())
    assert len(texts) > 40
    assert [text for text in texts if text not in out] == []


def test_a_choice_is_made_and_alarm_levels_stand_on_the_page(visitor: Visitor) -> None:
    # expected: of designs that differ in nothing else the least wrap comes first, as what a snub
    # pulley costs is in no price
    page = visitor.open("drive")
    visitor.solved()
    page.get_by_role("button", name="Which design has the lowest cost").click()
    card = page.locator(".choosing")
    card.get_by_label("Medium ceramic").uncheck()
    card.get_by_label("Wrap angles").fill("180; 210 deg")
    card.get_by_role("button", name="Calculate").click()
    rows = card.locator("table").first.locator("tbody th")
    expect(rows).to_have_text(["full-ceramic, wrap 180 deg", "full-ceramic, wrap 210 deg"])
    expect(card.locator(".headline")).to_contain_text(
        "Lowest cost: full-ceramic, wrap 180 deg with "
    )
    card.get_by_label("Wrap angles").fill("flat")
    card.get_by_role("button", name="Calculate").click()
    expect(card).to_contain_text(re.compile(r'candidates\.wrap_angles\[1\].*got "flat"'))
    # expected: the headline and the levels that `wraparc field` prints
    page.get_by_role("button", name="On site").click()
    card = page.locator(".site")
    expect(card.locator("table").first).to_be_visible()
    out = printed("field", HEAD)
    assert words(card.locator(".headline").inner_text()).partition(" ")[2] in out
    assert [cell for cell in cells(card) if words(cell) not in out] == []
    card.get_by_label("Hours a year, design").fill("4000")
    card.get_by_label("Measured wear").fill("1 mm")
    card.get_by_label("Hours that it took, design").fill("12000")
    card.get_by_role("button", name="Calculate").click()
    expect(card).to_contain_text("calibrated to the wear measured")
    # nonsense is told in its sentence, with what was typed
    card.get_by_label("Hours a year, design").fill("often")
    card.get_by_role("button", name="Calculate").click()
    expect(card.locator(".verdict.bad")).to_contain_text('"often"')
    card.get_by_label("Hours a year, design").fill("4000")
    card.get_by_label("Depth to wear off").fill("deep")
    card.get_by_role("button", name="Calculate").click()
    expect(card.locator(".verdict.bad")).to_contain_text("depth")


def cells(card: Locator) -> list[str]:
    """Return the values of a table, levels without their sign."""
    texts = card.locator("table").first.locator("td.num").all_inner_texts()
    return [unsigned(text) for text in texts]


def test_wet_worn_and_bare_stand_side_by_side_on_the_page(visitor: Visitor) -> None:
    # expected: the numbers that `wraparc what-if` prints, in both systems of units
    page = visitor.open("drive")
    visitor.solved()
    page.get_by_role("button", name="What if").click()
    card = page.locator(".what-if")
    expect(card.locator("table")).to_be_visible()
    options = ["--wet", "DIN 22101", "--worn", "6 mm", "--bare", "CEMA"]
    options += ["--load-case", "design"]  # which is looked at
    out = printed("what-if", HEAD, *options)
    assert len(cells(card)) > 40
    assert [cell for cell in cells(card) if words(cell) not in out] == []
    slips = "bare, CEMA: FAILS: Gross slip: safety 0.568 is below 1 (head, start)."
    assert slips in out
    assert slips in words(card.inner_text())
    page.get_by_label("US", exact=True).check(force=True)
    out = printed("what-if", HEAD, *options, "--units", "us")
    assert [cell for cell in cells(card) if words(cell) not in out] == []
    page.get_by_label("SI", exact=True).check(force=True)
    # of another drive it is marked as of before, and asked again by its button
    page.select_option("#f-pulley-0-lagging", "full-ceramic")
    expect(card.locator("[data-stands=stale]")).to_be_visible()
    card.get_by_role("button", name="Calculate").click()
    expect(card.locator("[data-stands=stale]")).to_have_count(0)
    expect(card.locator("table").first).to_contain_text("4.36 mm")


WET = EXAMPLES / "wet-season"


def sent(*names: str) -> list[dict[str, str]]:
    return [
        {"name": name, "data": base64.b64encode((WET / name).read_bytes()).decode()}
        for name in names
    ]


def wet_season() -> dict[str, Any]:
    return tomllib.loads((WET / "wet-season-drive.toml").read_text("utf-8"))


def test_a_measured_drive_is_told_as_by_the_commands(api: TestClient) -> None:
    # expected: what `wraparc calibrate` and `wraparc overlay` print of the same files
    files = sent("wet-day-record.toml", "wet-day.csv")
    answer = api.post(f"{API}/measured", json={"document": wet_season(), "files": files})
    assert answer.status_code == 200, answer.text
    found = answer.json()
    plan = str(WET / "wet-day-record.toml")
    out = printed("calibrate", plan) + printed("overlay", plan)
    assert [text for text in told(found) if text not in out] == []
    assert found["picture"].startswith("<?xml")
    lagging = found["lagging"]
    assert lagging["name"] == "diamond-rubber-calibrated"
    assert lagging["provenance"]["kind"] == "calibrated"
    # the record alone, all else chosen on the page, is the same
    asked = {"document": wet_season(), "files": sent("wet-day.csv"), "parameters": ["friction"]}
    alone = api.post(f"{API}/measured", json=asked).json()
    assert alone["tables"][0] == found["tables"][0]
    # and nothing is calibrated where nothing is asked for
    only = api.post(f"{API}/measured", json={**asked, "parameters": []}).json()
    assert only["lagging"] is None
    assert [t["rows"] for t in only["tables"]] == [t["rows"] for t in found["tables"][-2:]]


@pytest.mark.parametrize(
    ("files", "says"),
    [
        (lambda: sent("wet-day-record.toml"), "was not chosen together with the calibrate file"),
        (lambda: [{"name": "a.csv", "data": "!"}], "a.csv: is not in base 64"),
        (lambda: [{"name": "../../etc/passwd", "data": "YSxiCg=="}], "passwd: contains no table"),
        (lambda: sent("choose.toml"), "nothing measured was chosen"),
        (lambda: [*sent("wet-day-record.toml"), *sent("choose.toml")], "more than one calibrate"),
    ],
)
def test_what_is_no_record_is_refused(api: TestClient, files: Any, says: str) -> None:
    asked = {"document": wet_season(), "files": files(), "parameters": ["friction"]}
    answer = api.post(f"{API}/measured", json=asked)
    assert answer.status_code == 422, answer.text
    problems = answer.json()["problems"]
    assert says in " ".join(p["sentence"] for p in problems)
    assert "record-1" not in answer.text
    assert "/tmp" not in answer.text  # noqa: S108 - where files are kept meanwhile


def test_a_record_calibrates_the_drive_on_the_page(visitor: Visitor) -> None:
    # expected: the friction of `wraparc calibrate`, 0.782 of the law; see its example
    page = visitor.open("drive")
    evaluated(
        page,
        "(doc) => import('/static/main.js').then((m) => m.take(doc, { name: 'wet' }))",
        wet_season(),
    )
    visitor.solved()
    page.get_by_role("button", name="A measured drive").click()
    card = page.locator(".measured")
    card.locator("input[type=file]").set_input_files(str(WET / "wet-day.csv"))
    card.get_by_role("button", name="Calculate").click()
    expect(card.locator("table").first).to_contain_text("0.782")
    expect(page.locator("img.overlay")).to_be_visible()
    assert violations(page) == []
    page.get_by_role("button", name="Use the calibrated lagging").click()
    expect(page.locator("#f-pulley-0-lagging")).to_have_value("diamond-rubber-calibrated")
    expect(card.locator("[data-stands=stale]")).to_be_visible()
