"""The API gives what the command line gives: the same numbers, texts, files and errors."""

import copy
import csv
import json
import math
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest
from starlette.testclient import TestClient

from cli.running import wraparc
from web.calculators import API, client, document
from worded import worded
from wraparc import Distributed, WrapArc, solve, solve_train
from wraparc.checks import Level, judge, least_tension
from wraparc.choose.cost import catalogue_price, energy_cost, lagging_cost
from wraparc.drive.changes import with_lagging
from wraparc.files import drive_from_document, load_lagging
from wraparc.train.file import train_from_document
from wraparc.units import System
from wraparc.web.examples import examples

pytestmark = pytest.mark.usefixtures("solved_once")

REPOSITORY = Path(__file__).parents[2]
SYSTEMS: tuple[System, ...] = ("si", "us")


@pytest.fixture(scope="module")
def api() -> Iterator[TestClient]:
    with client() as found:
        yield found


def post(api: TestClient, path: str, status: int = 200, **body: Any) -> Any:
    answer = api.post(API + path, json=body)
    assert answer.status_code == status, answer.text
    return answer.json()


@pytest.mark.parametrize("name", ["head-drive-fabric", "tandem-steel-cord"])
def test_solve_has_the_numbers_of_the_command_line(
    api: TestClient, name: str, tmp_path: Path
) -> None:
    # expected: `wraparc solve --method both` on the file that the page would save
    saved = post(api, "/toml/write", document=document(name))
    file = tmp_path / saved["name"]
    file.write_text(saved["toml"], "utf-8")
    _, out, _ = wraparc("solve", str(file), "--method", "both", "--json", "-")
    expected = json.loads(out)
    found = post(api, "/solve", document=document(name))
    assert worded(found["verdict"]["text"]) == expected["verdict"]["text"]
    assert found["solved"] == expected["solved"]
    arcs = [a for a in expected["arcs"] if a["method"] == "distributed"]
    papers = [a for a in expected["arcs"] if a["method"] == "paper"]
    assert len(found["arcs"]) == len(arcs)
    for mine, theirs, paper in zip(found["arcs"], arcs, papers, strict=True):
        assert (mine["pulley"], mine["load_case"]) == (theirs["pulley"], theirs["load_case"])
        assert mine["numbers"] == {name: theirs[name] for name in mine["numbers"]}
        assert mine["paper"]["numbers"] == {n: paper[n] for n in mine["paper"]["numbers"]}
        exact = theirs["profile"]["tension"]
        assert mine["profile"]["tension"] == pytest.approx(exact, rel=1e-5)


def test_fast_agrees_with_the_whole_answer(api: TestClient) -> None:
    whole = post(api, "/solve", document=document())
    for arc in whole["arcs"]:
        where = {"pulley": arc["pulley"], "load_case": arc["load_case"]}
        fast = post(api, "/solve/fast", document=document(), sequence=7, tables=True, **where)
        assert fast["sequence"] == 7
        for name in ("exit_creep", "peak_shear_stress", "entry_creep_ratio", "power_loss"):
            # the peak is read off a coarser profile: within the 1e-5 of every solve
            assert fast["numbers"][name] == pytest.approx(arc["numbers"][name], rel=1e-5)
        assert fast["level"] == arc["level"]
        assert [t["key"] for t in fast["tables"]] == ["answer", "creep"]
        assert fast["numbers"]["creep_limit_capacity"] is None


def test_stretches_outside_the_tested_range_add_up_to_the_share(api: TestClient) -> None:
    drive = document()
    drive["pulley"][0]["entry_tension"] = "700 kN"  # wrap pressures beyond those tested
    drive["pulley"][0]["exit_tension"] = "450 kN"
    found = post(api, "/solve/fast", document=drive, points=1000, load_case="design")
    span = sum(b - a for a, b in found["outside"])
    share = found["numbers"]["outside_tested_share"]
    assert share > 0.0
    assert span / math.pi == pytest.approx(share, abs=0.004)  # wrap of 180 degrees


def test_answers_have_the_form_of_every_json(api: TestClient) -> None:
    """Expected: the schema of `--json`, for verdict, tables, remarks and single texts."""
    schema = json.loads((REPOSITORY / "docs" / "reference" / "answer.schema.json").read_text())
    kind = import_module("jsonschema").Draft202012Validator

    def hold(part: Any, form: str) -> None:
        kind({**schema, "$ref": f"#/$defs/{form}"}).validate(part)

    found = post(api, "/solve", document=document("head-drive-fabric"))
    train = post(api, "/train", document=document("tandem-fabric"))
    tables = [*train["tables"], *(table for arc in found["arcs"] for table in arc["tables"])]
    assert len(tables) > 20
    for told in (found, train):
        hold(told["verdict"], "verdict")
    for table in [*tables, found["checks"], found["summary"], found["least_tension"]["table"]]:
        del table["key"]  # a name that no two tables share
        hold(table, "table")
    for bar in found["arcs"][0]["bars"]:
        for text in (bar["found"], bar["limit"], bar["says"]):
            hold(text, "text")
    least = post(api, "/solve", document=document("downhill-braking"))["least_tension"]
    cell = least["shown"]
    assert cell["value"] == pytest.approx(least["tension"], rel=1e-12)
    assert (cell["unit"], cell["form"]) == ("N", "up")


def test_what_is_still_to_be_filled_in_has_a_code(api: TestClient) -> None:
    """By it the page marks fields; expected: the codes that `Problem` names."""
    drive = document("head-drive-fabric")
    del drive["load_case"]
    drive["belt"]["speed"] = "3 kN"
    (pulley,) = drive["pulley"]
    del pulley["diameter"], pulley["entry_tension"]
    answer = api.post(f"{API}/solve", json={"document": drive})
    assert answer.headers["content-type"] == "application/problem+json"
    codes = {p["path"]: p["code"] for p in answer.json()["problems"]}
    assert codes["belt.speed"] == ""
    assert codes["pulley.head.diameter"] == "missing"
    del drive["belt"]["speed"]
    pulley["diameter"] = "800 mm"
    (few,) = api.post(f"{API}/solve", json={"document": drive}).json()["problems"]
    assert (few["path"], few["code"]) == ("pulley.head", "few_tensions")


def test_a_breakaway_is_an_answer(api: TestClient) -> None:
    drive = document()
    drive["pulley"][0]["exit_tension"] = "2 kN"
    # the quick one knows the load case looked at only
    for path, fault in (("/solve/fast", "Gross slip: safety"), ("/solve", "gross-slip limit")):
        found = post(api, path, document=drive)
        assert found["verdict"]["level"] == "FAILS"
        assert fault in worded(found["verdict"]["text"], "us")


def test_every_error_comes_at_once_with_the_sentences_of_the_command_line(
    api: TestClient, tmp_path: Path
) -> None:
    drive = document()
    drive["belt"]["width"] = "1200 mn"
    drive["pulley"][0]["wrap_angle"] = "-5 deg"
    drive["pulley"][0]["lagging"] = "diamond-ruber"
    drive["pulley"][0]["colour"] = 1
    file = tmp_path / "drive.toml"
    file.write_text(post(api, "/toml/write", document=drive)["toml"], "utf-8")
    code, _, told = wraparc("solve", str(file))
    assert code == 2
    for path in ("/solve", "/solve/fast", "/check", "/compare", "/train"):
        problems = post(api, path, 422, document=drive)["problems"]
        assert [p["path"] for p in problems] == [
            "belt.width", "pulley.head.wrap_angle", "pulley.head.colour", "pulley.head.lagging"
        ] or {p["path"] for p in problems} == {
            "belt.width", "pulley.head.wrap_angle", "pulley.head.colour", "pulley.head.lagging"
        }  # fmt: skip
        for problem in problems:
            assert problem["sentence"] in told
            assert problem["message"] in problem["sentence"]


def test_paths_of_files_are_refused(api: TestClient) -> None:
    for path in ("/etc/passwd", "../secret.toml", "x.toml", "C:\\x.toml"):
        drive = document()
        drive["pulley"][0]["lagging"] = path
        problems = post(api, "/solve", 422, document=drive)["problems"]
        assert problems[0]["path"] == "pulley.head.lagging"
        assert "root:" not in json.dumps(problems)


@pytest.mark.parametrize("example", [e.name for e in examples()])
def test_examples_open_check_and_save(api: TestClient, example: str) -> None:
    found = api.get(f"{API}/examples/{example}").json()
    read = post(api, "/toml/read", toml=found["toml"])
    assert read["document"] == found["document"]
    assert read["valid"]
    assert read["kind"] == found["kind"]
    written = post(api, "/toml/write", document=found["document"])
    again = post(api, "/toml/read", toml=written["toml"])
    assert again["document"] == found["document"]
    assert post(api, "/check", toml=written["toml"])["kind"] == found["kind"]


def test_a_wrong_drive_can_be_saved_and_says_what_is_wrong(api: TestClient) -> None:
    drive = document()
    drive["pulley"][0]["diameter"] = ""
    drive["pulley"][0]["power"] = None  # a field left empty
    written = post(api, "/toml/write", document=drive)
    assert not written["valid"]
    assert written["problems"][0]["path"] == "pulley.head.diameter"
    assert "power" not in written["toml"]
    assert post(api, "/toml/read", toml=written["toml"])["problems"] == written["problems"]
    broken = post(api, "/toml/read", 422, toml="a = [")
    assert broken["problems"][0]["line"] == 1


def test_quantities_are_read_as_strictly_as_in_files(api: TestClient) -> None:
    items = [
        {"text": "150 kN", "dimension": "force"},
        {"text": "1,5 kN", "dimension": "force"},
        {"text": "1/3", "dimension": "number"},
        {"text": "180 deg", "dimension": "angle"},
        {"text": "3", "dimension": "colour"},
        {"text": "40 in", "dimension": "length"},
    ]
    read = post(api, "/quantities", items=items)["items"]
    assert read[0]["value"] == 150e3
    assert [worded(read[0]["text"], s) for s in SYSTEMS] == ["150 kN", "33720 lbf"]
    assert read[1]["value"] is None
    assert "comma" in read[1]["problem"]["message"]
    assert read[2]["problem"]
    assert worded(read[3]["exact"], "us") == "180 deg"
    assert read[4]["problem"]["value"] == '"colour"'
    assert [worded(read[5]["exact"], s) for s in SYSTEMS] == ["1016 mm", "40 in"]
    texts = [{"text": worded(read[0]["exact"], s), "dimension": "force"} for s in SYSTEMS]
    again = post(api, "/quantities", items=texts)["items"]
    assert [item["value"] for item in again] == [150e3, 150e3]


def test_comparison_agrees_with_solving_and_pricing_each(api: TestClient) -> None:
    found = post(api, "/compare", document=document(), tariff=0.2, hours=5000, years=10)
    rows = {row["name"]: row for row in found["rows"]}
    assert rows["diamond-rubber"]["present"]
    assert rows["diamond-rubber"]["change"] == []
    drive = drive_from_document(document())
    case = drive.load_cases[0]
    for name, row in rows.items():
        changed = with_lagging(drive, "head", load_lagging(name))
        result = Distributed().solve(WrapArc.of(changed, changed.pulleys[0], case))
        assert row["cells"]["exit_creep"]["value"] == pytest.approx(result.exit_creep, rel=1e-12)
        margin = result.capacities.creep_limit_margin
        assert row["cells"]["creep_limit_margin"]["value"] == pytest.approx(margin, rel=1e-12)
        price = catalogue_price(load_lagging(name))
        energy = float(energy_cost(result.energy.power_loss, 5000, 0.2, 10))
        assert row["cells"]["cost_energy"]["value"] == pytest.approx(energy)
        if price is None:
            assert row["cells"]["cost_total"]["value"] is None
            continue
        bought = float(lagging_cost(price.cost, math.pi * 0.8 * 1.2, 10)[0])
        assert row["cells"]["cost_total"]["value"] == pytest.approx(bought + energy)


def test_comparison_judges_every_load_case_and_shows_one(api: TestClient) -> None:
    """The answers are those of `judge` for the whole drive, the numbers those of a case."""
    asked = document()
    asked["load_case"] = [
        {"name": "light", "pulley": {"head": {"entry_tension": "90 kN", "exit_tension": "80 kN"}}},
        {"name": "jam", "pulley": {"head": {"entry_tension": "180 kN", "exit_tension": "9 kN"}}},
    ]
    found = post(api, "/compare", document=asked, load_case="light")
    assert (found["load_case"], found["load_cases"]) == ("light", 3)
    told = set()
    for row in found["rows"]:
        whole = with_lagging(drive_from_document(asked), "head", load_lagging(row["name"]))
        answered = solve(whole, raise_on_failure=False)
        judged, shown = judge(answered), answered.arc("head", "light")
        assert row["level"] == judged.level.value
        assert judged.governing is not None
        assert row["short"].endswith(f", {judged.governing.place.load_case}")
        creep = row["cells"]["exit_creep"]["value"]
        assert creep == pytest.approx(shown.exit_creep, rel=1e-12)
        least = least_tension(answered)
        assert least is not None
        expected = None if math.isinf(least.tension) else least.tension
        assert row["cells"]["least_slack"]["value"] == pytest.approx(expected)
        told.add(row["level"])
    assert "OK" not in told


def test_comparison_of_one_pulley_is_no_ok_where_another_slips(api: TestClient) -> None:
    # expected: the verdict of `wraparc solve`; the second drum of this tandem is in gross slip
    tandem = document("tandem-fabric")
    tandem["train"]["exit_tension"] = "0.3 kN"
    whole = solve_train(train_from_document(tandem), raise_on_failure=False)
    assert judge(whole).level is Level.FAILS
    rows = post(api, "/compare", document=tandem, pulley="first")["rows"]
    assert {row["level"] for row in rows} == {"FAILS"}
    assert all("pulley second" in row["short"] for row in rows)


@pytest.mark.parametrize(
    "change",
    [{"share": ["130 %", "-30 %"]}, {"share": None, "speeds": ["100 %", "99 %"]}, {}],
    ids=["shares that fight", "speeds that divide the load anew", "as it is"],
)
def test_comparison_of_a_train_is_that_of_solve(api: TestClient, change: dict[str, Any]) -> None:
    # expected: `solve` of the file with the other lagging in it, its load divided anew
    tandem = document("tandem-fabric")
    tandem["train"] = {k: v for k, v in {**tandem["train"], **change}.items() if v is not None}
    rows = post(api, "/compare", document=tandem, pulley="first", load_case="design")["rows"]
    assert len(rows) > 2
    for row in rows:
        made = copy.deepcopy(tandem)
        made["pulley"][0]["lagging"] = row["name"]
        whole = solve_train(train_from_document(made), raise_on_failure=False)
        judged, found = judge(whole), whole.drive_result().arc("first", "design")
        assert (row["level"], row["label"]) == (judged.level.value, judged.label)
        least = least_tension(whole)
        tension = None if least is None or math.isinf(least.tension) else least.tension
        assert row["cells"]["least_slack"]["value"] == pytest.approx(tension)
        if found.status.solved:
            creep = row["cells"]["exit_creep"]["value"]
            assert creep == pytest.approx(abs(found.exit_creep), rel=1e-6)


def test_what_a_comparison_changes_makes_that_drive(api: TestClient) -> None:
    for what in ("laggings", "belts"):
        found = post(api, "/compare", document=document(), what=what)
        assert found["rows"]
        for row in found["rows"]:
            drive = document()
            for change in row["change"]:
                table = drive["belt"] if change["path"].startswith("belt.") else drive["pulley"][0]
                key = change["path"].rpartition(".")[2]
                if change["value"] is None:
                    table.pop(key, None)
                else:
                    table[key] = change["value"]
            fast = post(api, "/solve/fast", document=drive)
            exact = row["cells"]["exit_creep"]["value"]
            assert fast["numbers"]["exit_creep"] == pytest.approx(exact, rel=1e-9)


def test_comparison_names_what_cannot_be_had(api: TestClient) -> None:
    found = post(api, "/compare", document=document(), names=["nothing", "full-ceramic"])
    assert [row["name"] for row in found["rows"]] == ["full-ceramic"]
    assert found["not_possible"][0]["name"] == "nothing"


def test_schema_has_every_key_of_the_form_with_its_words(api: TestClient) -> None:
    schema = api.get(f"{API}/schema").json()
    fields = {f["path"]: f for s in schema["sections"] for f in s["fields"]}
    assert {"belt.width", "pulley[].diameter", "pulley[].entry_tension", "creep_limit"} <= set(
        fields
    )
    width = fields["belt.width"]
    assert (width["kind"], width["dimension"], width["required"]) == ("quantity", "length", True)
    assert fields["pulley[].overrun"]["word"] == "formula"
    assert fields["pulley[].lagging.shear_modulus"]["word"] == "rigid"
    for field in fields.values():
        assert field["title"]
        if field["kind"] in ("quantity", "number"):
            assert field["dimension"] in schema["units"]
        slider = field["slider"]
        if slider:
            limits = [field["least"] or -math.inf, field["most"] or math.inf]
            assert limits[0] <= slider["least"] < slider["most"] <= limits[1]
    for units in schema["units"].values():
        assert units["si"]["unit"] in units["factors"] or not units["factors"]


def test_catalogue_and_unknown_names(api: TestClient) -> None:
    catalogue = api.get(f"{API}/catalogue").json()
    assert {"diamond-rubber", "full-ceramic"} <= {one["name"] for one in catalogue["laggings"]}
    one = api.get(f"{API}/catalogue/laggings/full-ceramic").json()
    assert len(one["law"]["friction"]) == len(one["law"]["pressures"])
    assert post(api, "/check", document={**document(), "lagging": {"mine": one["document"]}})
    assert api.get(f"{API}/catalogue/laggings/none").status_code == 422
    assert api.get(f"{API}/examples/none").status_code == 404
    assert api.get(f"{API}/none").status_code == 404
    problem = api.get(f"{API}/none").json()["problems"][0]
    assert problem["sentence"]


def test_a_lagging_file_becomes_a_table_of_the_drive(api: TestClient) -> None:
    from wraparc.catalogue import lagging_text

    read = post(api, "/lagging/read", toml=lagging_text("medium-ceramic"))
    drive = document()
    drive["lagging"] = {"mine": read["lagging"]}
    drive["pulley"][0]["lagging"] = "mine"
    own = post(api, "/solve/fast", document=drive)
    drive["pulley"][0]["lagging"] = "medium-ceramic"
    assert own["numbers"] == post(api, "/solve/fast", document=drive)["numbers"]


def test_train_divides_the_load_as_the_command_line_does(api: TestClient, tmp_path: Path) -> None:
    drive = document("tandem-fabric")
    file = tmp_path / "train.toml"
    file.write_text(post(api, "/toml/write", document=drive)["toml"], "utf-8")
    _, out, _ = wraparc("solve", str(file), "--json", "-")
    expected = json.loads(out)["train"]
    found = post(api, "/train", document=drive)
    assert found["matching"] is None
    for mine, theirs in zip(found["load_cases"], expected["load_cases"], strict=True):
        shares = [d["share"] for d in theirs["drives"]]
        assert [d["share"] for d in mine["drives"]] == pytest.approx(shares)
    more = post(api, "/train", document=drive, match=True, points=9)
    curve = more["matching"]["curves"][0]
    assert len(curve["values"]) == 9
    sums = [sum(shares) for shares in zip(*curve["shares"].values(), strict=True)]
    assert sums == pytest.approx([1.0] * 9, abs=1e-6)
    assert more["matching"]["map"] is None
    problem = post(api, "/train", 422, document=document(), match=True)["problems"][0]
    assert problem["path"] == "pulley"


def test_reports_download(api: TestClient) -> None:
    begins = {"pdf": b"%PDF-", "xlsx": b"PK", "md": b"# Head drive"}
    for kind, begin in begins.items():
        answer = api.post(
            f"{API}/report/{kind}",
            json={"document": document(), "name": 'Ä "x"/..\\drive', "head": {"author": "A. B."}},
        )
        assert answer.status_code == 200, answer.text
        assert answer.content.startswith(begin)
        named = answer.headers["content-disposition"]
        assert named == f'attachment; filename="x-drive.{kind}"'
    long = {"document": document(), "head": {"author": "x" * 121}}
    assert api.post(f"{API}/report/pdf", json=long).status_code == 422


def test_the_api_page_and_document_load_nothing_from_elsewhere(api: TestClient) -> None:
    page = api.get("/docs")
    assert page.status_code == 200
    assert "http://" not in page.text
    assert "https://" not in page.text
    openapi = api.get(f"{API}/openapi.json").json()
    assert all(path.startswith(API) for path in openapi["paths"])


def test_a_bare_curl_gets_a_helpful_sentence(api: TestClient) -> None:
    # curl -d '{}' sends what forms send
    form = {"content-type": "application/x-www-form-urlencoded"}
    told = api.post(f"{API}/solve", content=b"{}", headers=form)
    assert told.status_code == 415
    assert "-H 'Content-Type: application/json'" in told.json()["detail"]
    told = api.post(f"{API}/solve", json={})
    assert told.status_code == 422
    assert '{"document": {...}}' in told.json()["detail"]
    assert "application/toml" in told.json()["detail"]


def test_a_drive_file_is_taken_as_it_is(api: TestClient) -> None:
    text = next(e for e in examples() if e.name == "head-drive-fabric").text
    toml = {"content-type": "application/toml"}
    found = api.post(f"{API}/solve", content=text.encode(), headers=toml)
    assert found.json()["arcs"] == post(api, "/solve", document=document())["arcs"]
    wrong = api.post(f"{API}/solve", content=b"a = [", headers=toml)
    assert wrong.status_code == 422
    assert wrong.json()["problems"][0]["line"] == 1
    assert api.post(f"{API}/solve", content=b"\xff", headers=toml).status_code == 422


def test_spreadsheets_get_lines(api: TestClient) -> None:
    whole = post(api, "/solve", document=document())
    for path in ("/solve", "/solve/fast", "/compare"):
        answer = api.post(API + path, json={"document": document()}, headers={"accept": "text/csv"})
        assert answer.headers["content-type"] == "text/csv; charset=utf-8"
        lines = list(csv.DictReader(answer.content.decode("utf-8-sig").splitlines()))
        assert lines
        if path == "/solve":
            assert [line["load_case"] for line in lines] == ["design", "empty", "start"]
            for line, arc in zip(lines, whole["arcs"], strict=True):
                assert float(line["exit_creep"]) == arc["numbers"]["exit_creep"]
    shares = api.post(
        f"{API}/train",
        json={"document": document("tandem-fabric")},
        headers={"accept": "text/csv"},
    )
    assert "share" in shares.text.splitlines()[0]


def test_no_text_of_a_drive_becomes_a_formula(api: TestClient) -> None:
    drive = document()
    drive["pulley"][0]["name"] = "@SUM(1)"
    drive.pop("load_case", None)
    body = {"document": drive}
    found = api.post(f"{API}/solve/fast", json=body, headers={"accept": "text/csv"})
    assert found.status_code == 200, found.text
    assert "'@SUM(1)" in found.text


def test_the_openapi_document_names_token_types_and_refusals(api: TestClient) -> None:
    told = api.get(f"{API}/openapi.json").json()
    assert "HTTPBearer" in told["components"]["securitySchemes"]
    for path, methods in told["paths"].items():
        for method, operation in methods.items():
            assert operation["security"], (path, method)
            assert {"401", "403", "422", "503"} <= set(operation["responses"])
            good = next(v for k, v in operation["responses"].items() if k.startswith("2"))
            typed = good.get("content", {}).get("application/json", {}).get("schema")
            assert typed != {}, (path, method)  # every JSON answer states its form


def test_what_is_not_solved_at_the_start_the_page_asks_for(api: TestClient) -> None:
    # nothing is solved in advance by a server without processes
    solved = api.get(f"{API}/start/solved")
    assert (solved.status_code, solved.content) == (204, b"")
