"""What the page reads of a document is what the program reads: the translated functions."""

import enum
import json
import math
import subprocess
from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from pathlib import Path
from typing import Any

from wraparc.errors import InputError
from wraparc.schema.source import parse
from wraparc.train.file import any_drive_from_document, train_from_document
from wraparc.web.answers.book import book
from wraparc.web.answers.documents import json_like

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
        return {"found": None, "sentences": [str(problem) for problem in error.problems]}


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


HEAD = {
    "format": 1,
    "belt": {"preset": "PVG 1000S", "width": "1200 mm", "speed": "3 m/s"},
}
