"""Every answer of every shipped example, door by door; each runs in a copy of the examples."""

import csv
import io
import json
import tomllib
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import wraparc as w
from golden.doors import calculator, wraparc

Answers = dict[str, Any]
DRIVES = (
    "downhill-braking", "head-drive-fabric", "steel-cord-drive", "test-pulley-calibrated",
    "studies/head-drive", "wet-season/wet-season-drive",
)  # fmt: skip
TEXTS = ("downhill-braking", "tandem-fabric")  # in both systems of units, and as CSV
TRAINS = ("tandem-fabric", "tandem-steel-cord", "triple-steel-cord")
WHAT_IF = ("downhill-braking", "head-drive-fabric", "steel-cord-drive")  # a kind of drive each
STUDIES = {  # and how many samples, where the file asks for more
    "load-cases": 0, "sensitivity": 256, "take-up-grid": 0, "tolerances": 500, "wet-dry": 200,
}  # fmt: skip
MEASURED = ("test-pulley/published-pair", "wet-season/wet-day-record")
LAGGINGS = ("diamond-rubber", "medium-ceramic", "full-ceramic")
HELD = {  # a drive of the calculator that cannot carry its load, and one that does nothing
    "breakaway": "2 kN",
    "idle": "150 kN",
}


def _file(name: str) -> str:
    return f"{name}.toml"


def _json(*arguments: object) -> Any:
    """Return the JSON that a command writes, without its answer: see `cli_answers`."""
    wraparc(*arguments, "--json", "out.json")
    return _written()


def _written(*, answer: bool = False) -> Any:
    """Return what was written, or the answer in it."""
    document = json.loads(Path("out.json").read_text("utf-8"))
    told = document.pop("answer")
    return told if answer else document


@cache
def _asked(*arguments: str) -> tuple[str, Any]:
    """Return the short answer to a question and that in its JSON: two doors, asked once."""
    told = wraparc(*arguments, "--json", "out.json")
    return told, _written(answer=True)


def _csv(text: str) -> dict[str, list[float | str]]:
    """Return the columns of a CSV."""
    head, *rows = csv.reader(io.StringIO(text))
    return {name: [_cell(row[i]) for row in rows] for i, name in enumerate(head)}


def _cell(text: str) -> float | str:
    try:
        return float(text)
    except ValueError:
        return text


def library() -> Answers:
    """Solve drives by both methods, trains, and a grid by the batch; result objects by field."""
    found: Answers = {}
    for name in TRAINS:
        found[name] = w.solve_train(w.load_train(_file(name)), raise_on_failure=False)
    for name in DRIVES:
        drive = w.load_drive(_file(name))
        found[f"{name} distributed"] = w.solve(drive, raise_on_failure=False)
        found[f"{name} paper"] = w.solve(drive, method=w.PaperMarch(), raise_on_failure=False)
    return found


def batch() -> Answers:
    """Solve 60 arcs of an example under its lagging, in both settings."""
    drive = w.load_drive(_file("head-drive-fabric"))
    columns: dict[str, float | list[float]] = {
        "entry_tension": [90e3 + 1e3 * (i % 12) * 7 for i in range(60)],
        "exit_tension": [12e3 + 2.1e3 * i for i in range(60)],
        "diameter": 0.8, "wrap_angle": 3.2, "belt_width": 1.2, "belt_modulus": 12.96e6,
        "belt_speed": 3.0,
    }  # fmt: skip
    return {
        setting.name: dict(w.solve_batch(columns, drive.pulleys[0].lagging, setting=setting))
        for setting in w.Setting
    }


def cli_solve() -> Answers:
    """``wraparc solve``: JSON and CSV."""
    found: Answers = {}
    for name in (*DRIVES, *TRAINS):
        found[name] = _json("solve", _file(name), "--method", "both", "--csv", "out.csv")
        if name in TEXTS:
            found[f"{name} csv"] = _csv(Path("out.csv").read_text("utf-8"))
    return found


def cli_trim() -> Answers:
    """``wraparc trim``: JSON and CSV, one with the map over trim and load."""
    found: Answers = {}
    for name in TRAINS:
        more = ["--map"] if name == "tandem-fabric" else []
        found[name] = _json("trim", _file(name), "--csv", "out.csv", "--points", "9", *more)
        found[f"{name} csv"] = _csv(Path("out.csv").read_text("utf-8"))
    return found


def cli_fit() -> Answers:
    """``wraparc fit``: JSON, lagging file and the report printed."""
    more = ["-o", "lagging.toml", "--json", "out.json", "--full"]
    told = wraparc("fit", "shear_tests/plan.toml", *more)
    return {
        "shear_tests": _written(),
        "shear_tests lagging": tomllib.loads(Path("lagging.toml").read_text("utf-8")),
        "shear_tests text": told,
    }


def cli_study() -> Answers:
    """``wraparc study``: JSON of the summary, every column of the results."""
    from pyarrow import parquet

    found: Answers = {}
    for name, samples in STUDIES.items():
        fewer = ["--set", f"sampling.samples={samples}"] if samples else []
        found[name] = _json("study", f"studies/{name}.toml", "-o", "out.parquet", *fewer)
        table = parquet.read_table("out.parquet")
        found[f"{name} results"] = {c: _coded(table[c].to_pylist()) for c in table.column_names}
        Path("out.parquet").unlink()
    return found


def _coded(values: list[Any]) -> list[Any]:
    """Return a column of words as their numbers in the alphabet."""
    words = sorted({value for value in values if isinstance(value, str)})
    return [words.index(v) if isinstance(v, str) else v for v in values]


def cli_choose() -> Answers:
    """``wraparc choose``: JSON, CSV, text."""
    file = "wet-season/choose.toml"
    more = ["--lightest-belt", "--json", "out.json", "--csv", "out.csv", "--full"]
    told = wraparc("choose", file, *more)
    return {
        "wet-season": _written(),
        "wet-season csv": _csv(Path("out.csv").read_text("utf-8")),
        "wet-season text": told,
    }


def cli_calibrate() -> Answers:
    """``wraparc calibrate``: JSON, lagging file, text; ``overlay``; ``virtual-record``."""
    found: Answers = {}
    for name in MEASURED:
        told = wraparc("calibrate", _file(name), "-o", "out.toml", "--json", "out.json", "--full")
        found[name] = _written()
        found[f"{name} text"] = told
        found[f"{name} lagging"] = tomllib.loads(Path("out.toml").read_text("utf-8"))
        found[f"{name} overlay"] = wraparc("overlay", _file(name), "--full")
    drive = "wet-season/wet-season-drive.toml"
    wraparc("virtual-record", drive, "record.csv", "--samples", 600, "--revolutions", 2)
    found["virtual record"] = _csv(Path("record.csv").read_text("utf-8"))
    return found


def cli_what_if() -> Answers:
    """``wraparc what-if``: JSON and text."""
    found: Answers = {}
    for name in WHAT_IF:
        ceramic = name in ("downhill-braking", "steel-cord-drive")
        changes = [
            "--belt", "Flexsteel ST1000", "--other-carcass", "--lagging",
            "diamond-rubber" if ceramic else "full-ceramic", "--thickness", "10 mm", "--worn",
            "6 mm", "--bare", "CEMA", "--wet", "DIN 22101",
        ]  # fmt: skip
        told = wraparc("what-if", _file(name), *changes, "--json", "out.json", "--full")
        found[name] = _written()
        found[f"{name} text"] = told
    return found


def cli_field() -> Answers:
    """``wraparc field``: JSON and text."""
    found: Answers = {}
    for name in DRIVES:
        wear = ["--wear-coefficient", "0.001 mm3/J", "--hours", "design=6000"]
        speed = ["--set", 'belt.speed="3 m/s"'] if name == "test-pulley-calibrated" else []
        told = wraparc("field", _file(name), *wear, *speed, "--json", "out.json", "--full")
        found[name] = _written()
        found[f"{name} text"] = told
    return found


def cli_report() -> Answers:
    """``wraparc report``: the numbers of the calculation note, with their units."""
    found: Answers = {}
    for name in (*DRIVES, *TRAINS):
        for units in ("si", "us") if name in TEXTS else ("si",):
            wraparc("report", _file(name), "-o", "note.md", "--date", "-", "--units", units)
            found[f"{name} {units}"] = Path("note.md").read_text("utf-8")
    return found


def cli_text() -> Answers:
    """Tables as printed, in both systems of units: numbers with their units."""
    found: Answers = {}
    for units in ("si", "us"):
        for name in TEXTS if units == "us" else (*DRIVES[:4], *TRAINS[:2]):
            found[f"solve {name} {units}"] = wraparc(
                "solve", _file(name), "--units", units, "--full"
            )
        for name in LAGGINGS:
            found[f"lagging {name} {units}"] = wraparc("lagging", name, "--units", units, "--full")
        found[f"belts {units}"] = wraparc("belts", "--units", units)
        found[f"laggings {units}"] = wraparc("laggings", "--units", units)
    for name in (*DRIVES, *TRAINS):
        found[f"check {name}"] = wraparc("check", _file(name), "--full")
    for file in sorted(Path("shear_tests").glob("dry-00*")):
        found[f"read {file.name}"] = wraparc("read", file)
    return found


def cli_short() -> Answers:
    """The short answer of every command."""
    found: Answers = {}
    asked: list[tuple[str, ...]] = [
        *(("solve", _file(name)) for name in (*DRIVES, *TRAINS)),
        *(("solve", _file(name), "--units", "us") for name in TEXTS),
        ("trim", _file(TRAINS[0]), "--points", "9"),
        ("run", _file(TRAINS[0]), "--event", "run-out"),
        ("stability", _file(TRAINS[0])),
        ("choose", "wet-season/choose.toml"),
        ("what-if", _file(DRIVES[-1]), "--other-carcass", "--wet", "DIN 22101"),
        ("field", _file(DRIVES[-1])),
        ("fit", "shear_tests/plan.toml", "-o", "lagging.toml"),
        ("study", "studies/load-cases.toml", "-o", "out.parquet"),
        *(("calibrate", _file(name)) for name in MEASURED),
    ]
    for arguments in asked:
        alone = arguments[0] in ("run", "stability")  # there is no JSON of them
        found[" ".join(arguments)] = wraparc(*arguments) if alone else _asked(*arguments)[0]
    return found


def cli_answers() -> Answers:
    """The answer in the JSON of every question: texts, and the numbers in them."""
    found: Answers = {}
    asked: list[tuple[str, ...]] = [
        ("solve", _file("head-drive-fabric"), "--method", "both"),
        ("solve", _file(TRAINS[0])),
        ("trim", _file(TRAINS[0]), "--points", "9"),
        ("fit", "shear_tests/plan.toml", "-o", "lagging.toml"),
        ("study", "studies/load-cases.toml", "-o", "out.parquet"),
        ("choose", "wet-season/choose.toml"),
        ("calibrate", _file(MEASURED[0])),
        ("what-if", _file(DRIVES[0]), "--other-carcass"),
        ("field", _file(DRIVES[0])),
    ]
    for arguments in asked:
        found[" ".join(arguments)] = _asked(*arguments)[1]
    return found


def web_drives() -> Answers:
    """The calculator: solving."""
    with calculator() as api:
        found: Answers = {}
        for name in (*DRIVES[:4], *TRAINS):
            document = api.get(f"/examples/{name}")["document"]
            found[f"fast {name}"] = api.post("/solve/fast", document=document, tables=True)
            if name in (*DRIVES[:2], TRAINS[0]):
                found[f"solve {name}"] = api.post("/solve", document=document)
        for name, tension in HELD.items():
            document = api.get("/examples/head-drive-fabric")["document"]
            document["pulley"][0]["exit_tension"] = tension
            found[f"fast {name}"] = api.post("/solve/fast", document=document)
        return found


def web_compare() -> Answers:
    """The calculator: the same drive with every lagging and every belt."""
    with calculator() as api:
        document = api.get("/examples/head-drive-fabric")["document"]
        return {
            what: api.post("/compare", document=document, what=what, tariff=0.2)
            for what in ("laggings", "belts")
        }


def web_trains() -> Answers:
    """The calculator: trains, and how the load of one moves with speed, diameter and load."""
    with calculator() as api:
        documents = {name: api.get(f"/examples/{name}")["document"] for name in TRAINS}
        found = {name: api.post("/train", document=d) for name, d in documents.items()}
        match = {"match": True, "points": 9}
        found["matching"] = api.post("/train", document=documents["tandem-fabric"], **match)
        return found


def web_catalogue() -> Answers:
    """The calculator: form, catalogue, laggings, report."""
    with calculator() as api:
        document = api.get("/examples/head-drive-fabric")["document"]
        found = {name: api.get(f"/catalogue/laggings/{name}") for name in LAGGINGS}
        found["form"] = api.get("/schema")
        found["catalogue"] = api.get("/catalogue")
        found["report"] = api.post("/report/md", document=document, head={"date": "-"})
        return found


def web_study() -> Answers:
    """The calculator: a study from start to tables."""
    study = tomllib.loads(Path("studies/take-up-grid.toml").read_text("utf-8"))
    drive = tomllib.loads(Path("studies/head-drive.toml").read_text("utf-8"))
    asked = {key: value for key, value in study.items() if key != "drive"}
    with calculator() as api:
        started = api.post("/studies", study=asked, document=drive)
        return {"take-up-grid": api.done(f"/studies/{started['id']}")}


def web_shear_tests() -> Answers:
    """The calculator: machine files dropped, read, described; virtual tests fitted."""
    lagging = {
        "name": "virtual", "surface": "rubber", "thickness": "12 mm", "shear_modulus": "2300 kPa",
    }  # fmt: skip
    rig = {"name": "virtual rig", "sample_area": "0.04 m2", "faces": 2}
    with calculator() as api:
        place = f"/tests/{api.post('/tests')['session']}"
        files = sorted(Path("shear_tests").glob("wet-0*-1.*"))
        read = api.upload(f"{place}/files", files)
        first = read["files"][0]["id"]
        said = api.put(f"{place}/files/{first}", pressure="34 kPa", condition="wet")
        other = f"/tests/{api.post('/tests')['session']}"
        virtual = api.post(f"{other}/example")
        fit = api.post(f"{other}/fit", lagging=lagging, rig=rig)
        return {"read": read, "described": said, "virtual tests": virtual, "fit": fit}


DOORS: dict[str, Callable[[], Answers]] = {
    found.__name__.replace("_", "-"): found
    for found in (
        library, batch, cli_solve, cli_trim, cli_fit, cli_study, cli_choose, cli_calibrate,
        cli_what_if, cli_field, cli_report, cli_text, cli_short, cli_answers,
        web_drives, web_compare, web_trains, web_catalogue, web_study, web_shear_tests,
    )
}  # fmt: skip
