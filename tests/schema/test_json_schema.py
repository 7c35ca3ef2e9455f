"""The JSON Schema says of a document what reading it says."""

from functools import cache
from pathlib import Path
from typing import Any

import jsonschema  # type: ignore[import-untyped]
import pytest

from files.samples import EXAMPLE_DRIVES, example
from wraparc import InputError
from wraparc.catalogue import lagging_names, lagging_text
from wraparc.files import drive_from_document
from wraparc.files.lagging_keys import LAGGING_FILE
from wraparc.schema.source import parse
from wraparc.schema.tables import json_schema
from wraparc.train.keys import TRAIN_FILE

FILES = {"drive": TRAIN_FILE, "lagging": LAGGING_FILE}
EXAMPLES = [example(name) for name in EXAMPLE_DRIVES]


@cache
def validator(file: str) -> jsonschema.Draft202012Validator:
    schema = json_schema(FILES[file])
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_examples_satisfy_the_schema(path: Path) -> None:
    validator("drive").validate(parse(path.read_text("utf-8")))


@pytest.mark.parametrize("name", lagging_names())
def test_catalogue_laggings_satisfy_the_schema(name: str) -> None:
    validator("lagging").validate(parse(lagging_text(name)))


@pytest.mark.parametrize(
    ("place", "value"),
    [
        (("belt", "widht"), "1 m"),
        (("belt", "width"), 1200),
        (("pulley",), []),
        (("pulley", 0, "recovery"), "no"),
        (("pulley", 0, "lagging"), 7),
        (("load_case",), {}),
        (("belt",), None),
    ],
)
def test_what_the_schema_refuses_reading_refuses(
    place: tuple[str | int, ...], value: object
) -> None:
    document = parse(EXAMPLES[1].read_text("utf-8"))
    node: Any = document
    for step in place[:-1]:
        node = node[step]
    if value is None:
        del node[place[-1]]
    else:
        node[place[-1]] = value
    assert not validator("drive").is_valid(document)
    with pytest.raises(InputError):
        drive_from_document(document)


def test_what_a_form_needs() -> None:
    schema = json_schema(TRAIN_FILE)
    width = schema["properties"]["belt"]["properties"]["width"]
    assert width == {
        "title": "Belt width",
        "description": "Width of the belt, over which tension and friction are spread evenly.",
        "type": "string",
        "examples": ["1200 mm"],
        "x-dimension": "length",
        "x-units": {"si": "mm", "us": "in"},
        "x-allowed": "between 1 mm and 10 m",
        "x-bounds-si": [1e-3, 10.0],
    }
    pulley = schema["properties"]["pulley"]["items"]
    assert pulley["required"] == ["name", "diameter", "lagging"], "or a belt path"
    assert set(pulley["properties"]) >= {"entry_tension", "power", "overrun", "recovery"}


def test_every_key_has_a_title_and_a_help_text() -> None:
    def walk(node: object) -> None:
        if isinstance(node, dict):
            for key, entry in node.get("properties", {}).items():
                assert entry["title"], key
                assert entry["description"].endswith((".", "...")), key
            for value in node.values():
                walk(value)
        elif isinstance(node, list):
            for value in node:
                walk(value)

    walk(json_schema(TRAIN_FILE))
    walk(json_schema(LAGGING_FILE))
