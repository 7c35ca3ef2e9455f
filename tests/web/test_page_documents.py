"""What the page reads of a document is what the program reads: the translated functions."""

import enum
import json
import math
import random
import subprocess
from collections.abc import Mapping
from copy import deepcopy
from dataclasses import fields, is_dataclass
from pathlib import Path
from typing import Any

import pytest

from web.test_assembled import SHIPPED, assembled, spoilt
from web.test_judging import apart, told
from wraparc.errors import InputError
from wraparc.schema.source import parse
from wraparc.train.file import any_drive_from_document, train_from_document
from wraparc.units import Dimension, parse_quantity, unit_names
from wraparc.web.answers.book import book
from wraparc.web.answers.documents import json_like, without_none

Data = dict[str, Any]
EXAMPLES = sorted((Path(__file__).parents[2] / "examples").glob("*.toml"))


def read_by_the_page(documents: list[Data]) -> list[Data]:
    """Return drives in all their fields, and what is wrong with the others."""
    program = Path(__file__).with_name("own_documents.mjs")
    told = {"catalogue": json.loads(book().catalogue.model_dump_json()), "documents": documents}
    done = subprocess.run(
        ["node", str(program)], input=json.dumps(told),
        capture_output=True, text=True, encoding="utf-8", check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    found: list[Data] = json.loads(done.stdout)
    return found


def read_by_the_program(document: Data) -> Data:
    try:
        read = train_from_document if "train" in document else any_drive_from_document
        return {"found": plain(read(document)), "sentences": []}
    except InputError as error:
        return {"found": None, "sentences": [f"{p} {p.code}" for p in error.problems]}


def plain(value: Any) -> Any:
    """Return a value in its fields, what JSON has no word for as text."""
    if isinstance(value, enum.Enum):
        return value.value
    if isinstance(value, float) and not math.isfinite(value):
        return str(value).replace("inf", "Infinity").replace("nan", "NaN")
    if is_dataclass(value):
        return {f.name: plain(getattr(value, f.name)) for f in fields(value)}
    if isinstance(value, Mapping):
        return [plain(pair) for pair in value.items()]
    return [plain(item) for item in value] if isinstance(value, tuple | list) else value


def differences(ours: Any, theirs: Any, at: str = "") -> list[str]:
    """Return the places in which two values are not the same."""
    if isinstance(ours, dict) and isinstance(theirs, dict):
        return [
            d
            for k in ours.keys() | theirs.keys()
            for d in differences(ours.get(k, "-"), theirs.get(k, "-"), f"{at}.{k}")
        ]
    if isinstance(ours, list) and isinstance(theirs, list) and len(ours) == len(theirs):
        pairs = enumerate(zip(ours, theirs, strict=True))
        return [d for i, (x, y) in pairs for d in differences(x, y, f"{at}[{i}]")]
    return [] if ours == theirs else [f"{at}: {ours!r} and {theirs!r}"]


def test_every_example_is_read_to_the_same_drive() -> None:
    # expected: every field of the program's own drive, each number to its last bit
    documents = [json_like(parse(path.read_text("utf-8"))) for path in EXAMPLES]
    assert len(documents) > 8
    for path, document, found in zip(EXAMPLES, documents, read_by_the_page(documents), strict=True):
        expected = read_by_the_program(document)
        assert expected["sentences"] == [], path
        assert differences(found, expected) == [], path


KNOTS = [
    {"pressure": "34 kPa", "peak_friction": 0.9, "peak_slip": "10 mm"},
    {"pressure": "200 kPa", "peak_friction": 0.8, "peak_slip": "12 mm"},
    {"pressure": "690 kPa", "peak_friction": 0.6, "peak_slip": "14 mm"},
]
FIT = {
    "parameters": ["knots[2].peak_friction", "knots[2].peak_slip"],
    "values": [0.8, 0.012],
    "covariance": [[1e-3, 0.0], [0.0, 1e-6]],
}
PIECES = [
    {"from": "30 kPa", "to": "200 kPa", "A": "-0.31 + 0.042 ln(p)", "b": "0.01 - 0.00021 p"},
    {"from": "200 kPa", "to": "700 kPa", "A": "-1.6 p^-0.45", "b": "-0.2 exp(-0.0031 p)"},
]
FACTOR = {
    "slip_speed": ["1 mm/s", "20 mm/s", "0.1 m/s"],
    "factor": [1.0, 0.95, 0.8],
    "provenance": {"kind": "measured", "source": "our own tests"},
}
TESTED = {"tested_pressure": ["30 kPa", "700 kPa"], "tested_slip": "15 mm"}
#: A law of every kind.
LAWS: list[Data] = [
    {"kind": "integral-log", "knots": KNOTS, "fit": FIT, "tested_slip": "14 mm"},
    {"kind": "integral-log", "pieces": PIECES, "slip_unit": "mm", "pressure_unit": "kPa"},
    {"kind": "constant", "friction": 0.35, **TESTED, "slip_speed_factor": FACTOR},
    {"kind": "elastic-plastic", "friction": 0.55, "stiffness": "60 kPa/mm", **TESTED},
    {"kind": "power", "friction": 0.5, "reference_pressure": "200 kPa", "exponent": 0.3},
    {
        "kind": "table",
        "slip": ["0 mm", "2 mm", "9 mm"],
        "rows": [
            {"pressure": "40 kPa", "friction": [0, 0.3, 0.5]},
            {"pressure": "400 kPa", "friction": [0, 0.2, 0.4]},
        ],
    },
]


def with_law(law: Data) -> Data:
    """Return a drive whose lagging has a law of its own, once and in a condition."""
    lagging = {
        "surface": "rubber",
        "thickness": "11 mm",
        "elastic_modulus": "6 MPa",
        "block": {"width": "20 mm", "height": "8 mm"},
        "law": [law, {"kind": "constant", "friction": 0.2, "condition": "icy"}],
    }
    pulley = {
        "name": "head",
        "diameter": "800 mm",
        "wrap_angle": "180 deg",
        "lagging": "ours",
        "entry_tension": "150 kN",
        "exit_tension": "60 kN",
    }
    belt = {"width": "1200 mm", "modulus": "12960 kN/m", "speed": "3 m/s"}
    return {
        "format": 1,
        "belt": belt,
        "condition": ["dry", "wet", "icy", {"name": "dusty", "friction_factor": 0.8}],
        "pulley": [pulley],
        "lagging": {"ours": lagging},
    }


def test_laws_of_every_kind_are_read_to_the_same_drive_or_refused_alike() -> None:
    # expected: as above; of the law that has a fault, the sentence of the program
    documents = [with_law(law) for law in LAWS]
    taken = 0
    for document, found in zip(documents, read_by_the_page(documents), strict=True):
        expected = read_by_the_program(document)
        assert nearly(found, expected) == [], document["lagging"]["ours"]["law"]
        taken += not expected["sentences"]
    assert taken > 3


def nearly(ours: Any, theirs: Any) -> list[str]:
    """Return the places of two values that are apart by more than a logarithm's last bits."""
    if isinstance(ours, float) and ours == pytest.approx(theirs, rel=1e-14):
        return []
    if isinstance(ours, dict) and isinstance(theirs, dict) and ours.keys() == theirs.keys():
        return [d for k in ours for d in nearly(ours[k], theirs[k])]
    if isinstance(ours, list) and isinstance(theirs, list) and len(ours) == len(theirs):
        return [d for x, y in zip(ours, theirs, strict=True) for d in nearly(x, y)]
    return differences(ours, theirs)


def test_laws_with_junk_in_them_are_refused_in_the_same_sentences() -> None:
    # expected: the program's reader, of 120 laws of every kind with junk in some place
    pick = random.Random(5)  # noqa: S311 - documents to try, no secrets
    documents = []
    for i in range(120):
        document = with_law(deepcopy(LAWS[i % len(LAWS)]))
        lagging = document["lagging"]["ours"]
        lagging["law"][0] = spoilt(lagging["law"][0], pick)
        documents.append(document)
    refused = 0
    for document, found in zip(documents, read_by_the_page(documents), strict=True):
        told = read_by_the_program(without_none(document))["sentences"]
        assert found["sentences"] == told, document["lagging"]["ours"]["law"][0]
        refused += bool(told)
    assert refused > 60


def test_every_unit_is_read_to_the_same_number() -> None:
    # expected: `parse_quantity`, to the last bit, through the width and the load of a drive
    quantities: dict[str, tuple[str, Any]] = {}
    for dimension, path in PLACES.items():
        for unit in unit_names():
            for text in (f"1.7 {unit}", f"3e-4 {unit}/m", f"0.31 {unit}^2"):
                try:
                    quantities[f"{dimension} {text}"] = (path, text)
                    parse_quantity(text, dimension)
                except InputError:
                    del quantities[f"{dimension} {text}"]
    documents = []
    for path, text in quantities.values():
        document: Data = with_law(LAWS[2])
        document["lagging"]["ours"] = {**document["lagging"]["ours"]}
        document[path.partition(".")[0]][path.partition(".")[2]] = text
        documents.append(document)
    assert len(documents) > 60
    for document, found in zip(documents, read_by_the_page(documents), strict=True):
        assert differences(found, read_by_the_program(document)) == []


#: A key for each of some dimensions.
PLACES: dict[Dimension, str] = {
    "length": "belt.width",
    "speed": "belt.speed",
    "force_per_width": "belt.modulus",
    "pressure": "belt.largest_wrap_pressure",
    "mass_per_length": "belt.mass",
    "number": "belt.momentary_factor",
}


BROKEN = [
    "width = 1200 mm\n",
    'title = "again"\ntitle = "and again"\n',
    '[belt]\nwidth = "1 m"\n[belt]\n',
    'path = "C:\\users"\n',
    "a = [1, 2\n",
    "x = 2024-13-45\n",
    "= 3\n",
    'a = "open\nb = 1\n',
    "[belt\n",
    "a = 1 b = 2\n",
    "a = 01\n",
    "[[pulley]]\nname = head\n",
    "a.b = 1\na = 2\n",
]


def test_what_is_no_toml_is_told_in_the_same_sentence() -> None:
    # expected: the program's sentence, of the line that its own reader of TOML stops at
    program = Path(__file__).with_name("own_toml.mjs")
    texts = [f"# a drive\nformat = 1\n{text}" for text in BROKEN]
    done = subprocess.run(
        ["node", str(program)], input=json.dumps(texts),
        capture_output=True, text=True, encoding="utf-8", check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    for text, said in zip(texts, json.loads(done.stdout), strict=True):
        with pytest.raises(InputError) as refused:
            parse(text, "drive.toml")
        assert said == str(refused.value)


@pytest.mark.parametrize("law", LAWS, ids=[law["kind"] for law in LAWS])
def test_a_law_of_any_kind_is_judged_as_by_the_program(law: Data) -> None:
    # without statistics, whose interval the page leaves to the program
    own = {"thickness": "12 mm", "shear_modulus": "2.3 MPa", "surface": "rubber"}
    document = deepcopy(SHIPPED["head-drive-fabric"])
    document["pulley"][0]["lagging"] = "ours"
    plain = {k: v[:1] if k == "pieces" else v for k, v in law.items() if k != "fit"}
    document["lagging"] = {"ours": {**own, "law": plain}}
    (found,) = assembled([document], of=document)
    assert found["problems"] == []
    assert apart(told(document), found) == {}
