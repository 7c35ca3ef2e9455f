"""What the page puts together itself is what the server prepares: every choice of the form."""

import json
import math
import random
import subprocess
from copy import deepcopy
from pathlib import Path
from typing import Any

import pytest

from web.test_in_page import DRIVES
from wraparc import catalogue
from wraparc.arc import Distributed, solve
from wraparc.drive import Drive
from wraparc.errors import InputError
from wraparc.web.answers.book import book
from wraparc.web.answers.documents import read
from wraparc.web.answers.drives import SolveAnswer
from wraparc.web.answers.form import form
from wraparc.web.answers.judging import judging

Data = dict[str, Any]
#: What only the program itself solves.
BEYOND = {"uphill-conveyor", "worn-head-drive-fabric", "worn-head-drive-steel-cord"}
SHIPPED = {name: document for name, document in DRIVES.items() if name not in BEYOND}
#: What stands for itself in JSON.
SPECIAL = {"NaN": math.nan, "Infinity": math.inf, "-Infinity": -math.inf}


def assembled(documents: list[Data], *, of: Data | None = None) -> list[Data]:
    program = Path(__file__).with_name("own_assembled.mjs")
    told = {
        "form": json.loads(form().model_dump_json()),
        "book": json.loads(book(of).model_dump_json()),
        "documents": documents,
    }
    done = subprocess.run(
        ["node", str(program)], input=json.dumps(told),
        capture_output=True, text=True, encoding="utf-8", check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    found: list[Data] = json.loads(done.stdout)
    return found


def prepared_by_the_server(document: Data) -> Data | None:
    """Return what the server prepares; None where it leaves the drive to itself."""
    drive = read(document)
    assert isinstance(drive, Drive)
    result = solve(drive, method=Distributed(points=24), raise_on_failure=False)
    construct: Any = SolveAnswer.model_construct
    found: Data | None = json.loads(construct(judging=judging(document, result)).model_dump_json())[
        "judging"
    ]
    if found is not None:
        for case, arc in zip(found["cases"], result, strict=True):
            case["tensions"] = [arc.arc.entry_tension, arc.arc.exit_tension]
    return found


def comparable(told: Data) -> Data:
    """Return what a judging says without what only one of the two has."""
    return {
        "qualifier": told["qualifier"],
        "take_up": told["take_up"],
        "least_name": told["least_name"],
        "levels": told["levels"],
        "counterweight": told["counterweight"],
        "checks": [_check(c) for c in told["checks"]],
        "cases": [
            {
                "load_case": case["load_case"],
                "law": case["prepared"]["law"],
                "given": {
                    key: value
                    for key, value in case["prepared"]["given"].items()
                    if key not in ("entry_tension", "exit_tension", "effective_tension", "torque")
                    and key != "power"
                },
                "tensions": case["tensions"],
                "tested": case["tested"] and {
                    key: case["tested"][key] for key in ("pressure_min", "pressure_max", "slip_max")
                },
                "criteria": case["criteria"],
                "checks": [_check(c) for c in case["checks"]],
                "asks": case["asks"],
            }
            for case in told["cases"]
        ],
    }  # fmt: skip


def _check(check: Data) -> Data:
    """Return a check without the numbers and words that its value decides on."""
    if check["miss"]:
        open_ = ("level", "short", "says", "remedy", "otherwise", "value", "limit")
        return {key: value for key, value in check.items() if key not in (*open_, "more")}
    unknown = {key: check[key] == "NaN" for key in ("value", "limit")}
    return {**{k: v for k, v in check.items() if k != "more"}, **unknown}


def differences(ours: Any, theirs: Any, at: str = "") -> list[str]:
    """Return the places in which two answers are not one, numbers within rounding."""
    a, b = (SPECIAL.get(x, x) if isinstance(x, str) else x for x in (ours, theirs))
    if isinstance(a, dict) and isinstance(b, dict):
        return [
            d for k in a.keys() | b.keys() for d in differences(a.get(k), b.get(k), f"{at}.{k}")
        ]
    if isinstance(a, list) and isinstance(b, list) and len(a) == len(b):
        pairs = enumerate(zip(a, b, strict=True))
        return [d for i, (x, y) in pairs for d in differences(x, y, f"{at}[{i}]")]
    if isinstance(a, int | float) and isinstance(b, int | float):
        same = a == pytest.approx(b, rel=1e-13, abs=0.0, nan_ok=True)
        return [] if same else [f"{at}: {a!r} and {b!r}"]
    return [] if a == b else [f"{at}: {a!r} and {b!r}"]


@pytest.mark.parametrize("name", SHIPPED)
def test_every_shipped_drive_is_put_together_as_by_the_server(name: str) -> None:
    expected = prepared_by_the_server(SHIPPED[name])
    assert expected is not None
    (found,) = assembled([SHIPPED[name]])
    assert found["problems"] == []
    assert differences(comparable(found["judging"]), comparable(expected)) == []


TENSIONS = ("entry_tension", "exit_tension", "effective_tension", "torque", "power")
LOADS: list[Data] = [
    {"entry_tension": "140 kN", "exit_tension": "61 kN"},
    {"exit_tension": "60 kN", "effective_tension": "75 kN"},
    {"entry_tension": "33000 lbf", "torque": "30 kN m"},
    {"exit_tension": "55 kN", "power": "200 kW"},
    {"entry_tension": "60 kN", "effective_tension": "-50 kN"},
]
OVERS: list[Data] = [{}, {"exit_tension": "50 kN"}, {"power": "150 kW"}, *LOADS]
CONDITIONS: list[Any] = [
    "dry", "wet", "wet and dirty", ["dry", "wet"], ["dry", "wet", "wet and dirty"],
]  # fmt: skip


def some(pick: random.Random, share: float, of: Data) -> Data:
    """Return some of the keys of a table."""
    return {key: value for key, value in of.items() if pick.random() < share}


def some_belt(pick: random.Random, width: str) -> Data:
    belt: Data = {"width": width, **some(pick, 0.8, {"speed": "3 m/s"})}
    if pick.random() < 0.7:
        belt["preset"] = pick.choice(catalogue.belts()).name
    else:
        belt |= {"modulus": "15000 kN/m", "name": pick.choice(["ST 2000", "own"])}
        belt["kind"] = pick.choice(["fabric", "steel cord", "aramid"])
    more = {
        "rating": pick.choice(["100 kN/m", "1000 PIW", "400 kN/m"]),
        "momentary_factor": pick.choice([1, 1.4]),
        "least_pulley_diameter": "700 mm",
        "largest_wrap_pressure": "0.5 MPa",
    }
    return belt | some(pick, 0.3, more)


def some_lagging(pick: random.Random) -> Any:
    name = pick.choice(catalogue.lagging_names())
    more = {
        "thickness": "10.5 mm",
        "shear_modulus": "2.2 MPa",
        "compression_modulus": pick.choice(["8.5 MPa", "rigid"]),
    }
    return name if pick.random() < 0.7 else {"preset": name, **some(pick, 0.5, more)}


def some_cases(pick: random.Random, pulley: str) -> list[Data]:
    cases = []
    for name in ("start", "stop")[: pick.choice([1, 2])]:
        more = {"kind": pick.choice(["running", "starting", "braking"]), "condition": "wet"}
        over = {"pulley": {pulley: pick.choice(OVERS)}}
        cases.append({"name": name, **over, **some(pick, 0.4, more)})
    return cases


def some_drive(pick: random.Random) -> Data:
    """Return a drive with choices of the form taken at random."""
    shipped = deepcopy(SHIPPED[pick.choice(sorted(SHIPPED))])
    pulley = {k: v for k, v in shipped["pulley"][0].items() if k not in TENSIONS}
    pulley |= {**pick.choice(LOADS), "lagging": some_lagging(pick)}
    pulley |= some(pick, 0.2, {"condition": pick.choice(["dry", "wet"])})
    name = pulley["name"]
    take_ups = [{"kind": "fixed"}, {"kind": "gravity", "sheave_ratio": 1.5}, {"after": name}]
    standards: list[Data] = [
        {"name": "DIN 22101", "condition": pick.choice(["dry", "wet and dirty"])},
        {"name": "DIN 22101", "binding": True},
        {"name": "own", "friction": 0.3, "start_factor": 1.4},
        {"name": "none"},
        {"name": "CEMA", "start_factor": 1.2},
    ]
    more = {
        "condition": pick.choice(CONDITIONS),
        "load_case": some_cases(pick, name),
        "take_up": pick.choice(take_ups),
        "design_standard": pick.choice(standards),
        "safety_factor": {"running": 1.5, "starting": 1.2},
        "sag": {"idler_spacing": "3 m", "line_mass": "22 kg/m", "share": "1.5 %"},
        "creep_limit": pick.choice(["10 mm", "0.25 in"]),
    }
    belt = some_belt(pick, shipped["belt"]["width"])
    return {"format": 1, "belt": belt, "pulley": [pulley], **some(pick, 0.5, more)}


def test_drives_of_any_choice_are_put_together_as_by_the_server() -> None:
    # expected: the server's own preparation; what it refuses, the page refuses
    pick = random.Random(11)  # noqa: S311 - drives to try, no secrets
    documents = [some_drive(pick) for _ in range(60)]
    wrong: dict[int, Any] = {}
    judged = refused = 0
    for i, (document, found) in enumerate(zip(documents, assembled(documents), strict=True)):
        try:
            expected = prepared_by_the_server(document)
        except InputError as error:
            refused += 1
            if not found["problems"]:
                wrong[i] = str(error), document
            continue
        if expected is None:
            continue  # unusual sizes, no pull, or a take-up that is contradicted
        judged += 1
        if found["problems"]:
            wrong[i] = found["problems"], document
            continue
        apart = differences(comparable(found["judging"]), comparable(expected))
        if apart:
            wrong[i] = apart[:6]
    assert wrong == {}
    assert judged > 30
    assert refused > 3


#: Values that no drive has, by the place that both tell.
WRONG: list[tuple[str, Any]] = [
    ("pulley.head.diameter", "0 mm"), ("pulley.head.diameter", "800"), ("belt.width", "12 kN"),
    ("pulley.head.wrap_angle", "800 deg"), ("pulley.head.creep_limit", "0 mm"),
    ("belt.speed", "0 m/s"), ("belt.rating", "-1 kN/m"), ("take_up.kind", "spring"),
    ("take_up.after", "tail"), ("design_standard.friction", 0.3), ("design_standard.name", "own"),
    ("safety_factor.running", 0.9), ("sag.idler_spacing", "0 m"), ("pulley.head.torque", "5 kN m"),
    ("pulley.head.lagging", "velvet"), ("belt.preset", "Goodbelt"), ("condition", "icy"),
    ("pulley.head.recovery", "yes"), ("load_case", [{"name": "design"}]),
]  # fmt: skip


def test_what_the_server_refuses_the_page_refuses() -> None:
    documents = []
    for path, value in WRONG:
        document = deepcopy(DRIVES["head-drive-fabric"])
        *tables, key = path.split(".")
        table: Any = document
        for name in tables:
            table = table["pulley"][0] if name == "pulley" else table
            table = table if name in ("pulley", "head") else table.setdefault(name, {})
        table[key] = value
        if "sag" in document:
            document["sag"]["line_mass"] = "20 kg/m"
        documents.append(document)
    for (path, value), document, found in zip(WRONG, documents, assembled(documents), strict=True):
        told = [problem["sentence"] for problem in found["problems"]]
        assert told == sentences(document) != [], (path, value)


#: Tensions of the pulley, and of a load case where there is one, that fix nothing or too much.
UNFIT: list[tuple[Data, Data]] = [
    ({"entry_tension": "90 kN"}, {}),
    ({"power": "200 kW"}, {}),
    ({"effective_tension": "60 kN", "torque": "24 kN m", "exit_tension": "30 kN"}, {}),
    ({"entry_tension": "90 kN", "exit_tension": "30 kN", "effective_tension": "60 kN"}, {}),
    ({"entry_tension": "90 kN", "exit_tension": "30 kN", "effective_tension": "55 kN"}, {}),
    ({"entry_tension": "90 kN", "exit_tension": "30 kN", "torque": "20 kN m"}, {}),
    ({"entry_tension": "90 kN", "exit_tension": "30 kN"}, {"effective_tension": "80 kN"}),
    ({"exit_tension": "30 kN"}, {"exit_tension": "40 kN"}),
    ({"exit_tension": "30 kN", "torque": "24 kN m"}, {"power": "10 kW", "torque": "5 kN m"}),
]


@pytest.mark.parametrize(("own", "over"), UNFIT)
def test_tensions_that_do_not_fix_the_load_are_refused_in_the_same_words(
    own: Data, over: Data
) -> None:
    document = deepcopy(DRIVES["head-drive-fabric"])
    pulley = document["pulley"][0]
    for key in ("entry_tension", "exit_tension", "effective_tension", "torque", "power"):
        pulley.pop(key, None)
    pulley |= own
    document.pop("load_case", None)
    if over:
        document["load_case"] = [{"name": "peak", "pulley": {pulley["name"]: over}}]
    with pytest.raises(InputError) as refused:
        read(document)
    found = assembled([document])[0]
    # one rule, `drive.tension_rules`, on both sides: message and remedy, character for character
    assert [p["sentence"] for p in found["problems"]] == list(map(str, refused.value.problems))


JUNK: list[Any] = [
    None,
    [],
    {},
    5,
    -1.5,
    "x",
    "",
    True,
    "5 kN",
    ["dry"],
    [{}],
    {"name": "a"},
    "1e999 m",
]


def spoilt(document: Data, pick: random.Random) -> Data:
    """Return a document with junk in some place."""
    after = deepcopy(document)
    node: Any = after
    while True:
        keys: list[Any] = list(node) if isinstance(node, dict) else list(range(len(node)))
        key = pick.choice(keys)
        inner = node[key]
        if not isinstance(inner, dict | list) or not inner or pick.random() < 0.3:
            node[key] = pick.choice(JUNK)
            return after
        node = inner


def test_junk_is_refused_in_the_same_sentences() -> None:
    # expected: the program's reader, sentence by sentence, of 400 documents; it takes the others
    pick = random.Random(3)  # noqa: S311 - documents to try, no secrets
    documents = [spoilt(some_drive(pick), pick) for _ in range(400)]
    wrong: dict[int, Any] = {}
    refused = 0
    for i, (document, found) in enumerate(zip(documents, assembled(documents), strict=True)):
        told = [p["sentence"] for p in found["problems"] if not p.get("beyond")]
        expected = sentences(document)
        refused += bool(expected)
        if told != expected and not unusual(found):
            wrong[i] = told, expected
    assert wrong == {}
    assert refused > 250


def sentences(document: Data) -> list[str]:
    """Return what the program says is wrong with a document."""
    try:
        read(document)
    except InputError as error:
        return [str(problem) for problem in error.problems]
    return []


def unusual(found: Data) -> bool:
    """Whether the page leaves a drive that it has read to the program: no belt carries it."""
    return any("friction falls too steeply" in p["message"] for p in found["problems"])


@pytest.mark.parametrize("junk", ["x", "-5", "1,5 m", True])
def test_junk_in_every_field_is_refused(junk: Any) -> None:
    # expected: Python's reader, of every number, choice and switch that the form has for a drive
    documents: dict[str, Data] = {}
    for section in form().sections:
        if section.key in ("conveyor", "train", "lagging", "load_case") or "." in section.title:
            continue
        for field in section.fields:
            keys: list[Any] = [part for part in field.path.split(".") if part]
            if field.kind not in ("quantity", "number", "choice", "flag") or len(keys) > 2:
                continue
            document = deepcopy(SHIPPED["head-drive-fabric"])
            node: Any = document
            if len(keys) == 2:
                node = document.setdefault(keys[0].removesuffix("[]"), {})
                node = node[0] if keys[0].endswith("[]") else node
            node[keys[-1]] = junk
            documents[field.path] = document
    assert len(documents) > 25
    wrong = {}
    for (path, document), found in zip(
        documents.items(), assembled(list(documents.values())), strict=True
    ):
        if [p["sentence"] for p in found["problems"] if not p.get("beyond")] != sentences(document):
            wrong[path] = found["problems"], sentences(document)
    assert wrong == {}
