"""What the page puts together itself is what the server prepares: every choice of the form."""

import random
from collections.abc import Callable
from copy import deepcopy
from typing import Any

import pytest

from web.test_in_page import DRIVES
from web.test_judging import apart, in_node, told
from wraparc import catalogue
from wraparc.errors import InputError
from wraparc.web.answers.documents import json_like, read
from wraparc.web.answers.form import form
from wraparc.web.examples import examples

Data = dict[str, Any]
#: What only the program itself solves.
BEYOND = {"uphill-conveyor", "worn-head-drive-fabric", "worn-head-drive-steel-cord"}
SHIPPED = {name: document for name, document in DRIVES.items() if name not in BEYOND}
TRAINS = {e.name: json_like(e.document) for e in examples() if "train" in e.document}
DRAWN = 60


def assembled(documents: list[Data], *, of: Data | None = None) -> list[Data]:
    return in_node([{"changed": document} for document in documents], of)


@pytest.mark.parametrize("name", SHIPPED)
def test_every_shipped_drive_is_judged_as_by_the_program(name: str) -> None:
    (found,) = assembled([SHIPPED[name]])
    assert found["problems"] == []
    assert apart(told(SHIPPED[name]), found) == {}


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


def test_drives_of_any_choice_are_judged_as_by_the_program() -> None:
    # expected: every check of Python's judgement, its text and numbers, or what it refuses
    pick = random.Random(11)  # noqa: S311 - drives to try, no secrets
    documents = [some_drive(pick) for _ in range(DRAWN)]
    wrong: dict[int, Any] = {}
    judged = refused = 0
    for i, (document, found) in enumerate(zip(documents, assembled(documents), strict=True)):
        if any(problem.get("beyond") for problem in found["problems"]):
            continue  # no pull
        try:
            expected = told(document)
        except InputError as error:
            refused += 1
            if [p["sentence"] for p in found["problems"]] != list(map(str, error.problems)):
                wrong[i] = str(error), found["problems"]
            continue
        judged += 1
        different = found["problems"] or apart(expected, found)
        if different:
            wrong[i] = different, document
    assert wrong == {}
    assert judged > 0.5 * DRAWN
    assert refused > 3


#: Belts by their standard names, some with a slip or a fibre that is not told.
NAMED_BELTS: list[Data] = [
    {"name": "EP 630/3 5+2"}, {"preset": "DIN 22102 AB 1000 EP 630/4 6/2 Y"},
    {"preset": "ST 2000 8+6", "rating": "280 kN/m"}, {"preset": "330 PIW 3 ply 3/16x1/16"},
    {"name": "NN 500/4", "elongation": "2,5 % bei 10 %"}, {"preset": "ST 7500"},
    {"name": "EP 630/3 5+2", "thickness": "11 mm"}, {"preset": "st-1000", "cord_diameter": "4 mm"},
    {"preset": "P 500/3", "modulus": "3000 kN/m"}, {"name": "P 500/3"}, {"name": "EP 6300/3"},
    {"preset": "ST 1OOO"}, {"name": "EP 630/3", "elongation": "1.5 %"}, {"preset": "EP 630/3 60+3"},
    {"name": "own", "elongation": "1.5 % at 10 %"}, {"name": "EP 630/3", "modulus": "6300 kN/m"},
]  # fmt: skip


def test_belts_by_their_standard_names_are_read_as_by_the_program() -> None:
    shipped = deepcopy(SHIPPED["head-drive-fabric"])
    sizes = {"width": "1200 mm", "speed": "3 m/s"}
    documents = [{**shipped, "belt": {**belt, **sizes}} for belt in NAMED_BELTS]
    wrong: dict[int, Any] = {}
    refused = 0
    for i, (document, found) in enumerate(zip(documents, assembled(documents), strict=True)):
        try:
            expected = told(document)
        except InputError as error:
            refused += 1
            if [p["sentence"] for p in found["problems"]] != list(map(str, error.problems)):
                wrong[i] = str(error), found["problems"]
            continue
        different = found["problems"] or apart(expected, found)
        if different:
            wrong[i] = different, document
    assert wrong == {}
    assert refused == 6


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


def test_what_load_cases_have_of_the_train_is_refused_once() -> None:
    # expected: the sentence of the program, which names the table that gives it
    document = deepcopy(TRAINS["tandem-fabric"])
    document["train"]["share"] = ["50 %", "50.001 %"]
    (found,) = assembled([document])
    assert [p["sentence"] for p in found["problems"]] == sentences(document)
    assert found["problems"][0]["path"] == "train.share"
    assert len(found["problems"]) == 1


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


def some_train(pick: random.Random) -> Data:
    """Return a train of shipped ones, with load cases that replace a part of its table."""
    document: Data = deepcopy(TRAINS[pick.choice([*TRAINS])])
    document.pop("motion", None)  # which the server alone reads
    cases = document.setdefault("load_case", [])
    cases += [{"name": f"case {i}", "train": {"effective_tension": "40 kN"}} for i in range(2)]
    return document


@pytest.mark.parametrize(("some", "most"), [(some_drive, 250), (some_train, 150)])
def test_junk_is_refused_in_the_same_sentences(
    some: Callable[[random.Random], Data], most: int
) -> None:
    # expected: the program's reader, sentence by sentence, of 400 documents; it takes the others
    pick = random.Random(3)  # noqa: S311 - documents to try, no secrets
    documents = [spoilt(some(pick), pick) for _ in range(400)]
    wrong: dict[int, Any] = {}
    refused = 0
    for i, (document, found) in enumerate(zip(documents, assembled(documents), strict=True)):
        told = [p["sentence"] for p in found["problems"] if not p.get("beyond")]
        expected = sentences(document)
        refused += bool(expected)
        if told != expected and not steep(found):
            wrong[i] = told, expected
    assert wrong == {}
    assert refused > most


def sentences(document: Data) -> list[str]:
    """Return what the program says is wrong with a document."""
    try:
        read(document)
    except InputError as error:
        return [str(problem) for problem in error.problems]
    return []


def steep(found: Data) -> bool:
    """Whether the page has read a drive, and refuses its law on an arc as the program does."""
    return any("friction falls so steeply" in p["message"] for p in found["problems"])


@pytest.mark.parametrize("junk", ["x", "-5", "1,5 m", True])
def test_junk_in_every_field_is_refused(junk: Any) -> None:
    # expected: Python's reader, of every number, choice and switch that the form has for a drive
    documents: dict[str, Data] = {}
    for section in form().sections:
        # what moves is read by the server alone
        apart = section.key in ("conveyor", "train", "lagging", "load_case", "motion")
        if apart or "." in section.title:
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
