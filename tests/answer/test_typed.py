"""Values of tables are numbers with their units, in every kind of answer, not finished text.

Expected: what a reader of the JSON needs, who sorts and converts; no formula of the program.
"""

import json
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from cli.running import wraparc
from worded import worded

EXAMPLES = Path(__file__).parents[2] / "examples"
#: A command of each kind, and how many values with a number in them stay texts: names, lists and
#: sentences, and bounds that are told in powers of ten.
KINDS: dict[str, tuple[tuple[str, ...], int]] = {
    "solve": (("solve", "head-drive-fabric.toml", "--method", "both"), 3),
    "train": (("solve", "tandem-fabric.toml"), 5),
    "uneven": (("solve", "worn-head-drive-fabric.toml"), 6),
    "fit": (("fit", "shear_tests/plan.toml"), 1),
    "choose": (("choose", "wet-season/choose.toml"), 0),
    "trim": (("trim", "tandem-fabric.toml", "--points", "9"), 0),
    "study": (("study", "studies/load-cases.toml"), 2),
    "field": (("field", "downhill-braking.toml"), 0),
    "stability": (("stability", "tandem-fabric.toml"), 0),
    "calibrate": (("calibrate", "test-pulley/published-pair.toml"), 0),
    "what-if": (("what-if", "downhill-braking.toml", "--other-carcass"), 0),
}
#: Texts that are the user's own, as typed, and a law as it is defined, for slip in mm and kPa.
AS_TYPED = re.compile(
    r"computed from|^1 mm/m$|^10 mm, 12 mm, 15 mm, 20 mm$|^[Ab] \[1/mm\]$|^(?:x_pk|mu_pk|A = )"
)
NUMBER = re.compile(r"(?<![\w.])[-+]?\d")
#: Units that nobody reads US units for.
METRIC = re.compile(
    r"(?:(?<![\w.-])[\d.]+|\[|/)\s?"
    r"(?:[mck]?m|k?N|[kM]?Pa|k?W|J|kg|t/h|degC|m2|mm3/J|kN m)(?:/\w+)?(?![\w.])"
)


@cache
def answer(kind: str, folder: Path) -> Any:
    """The answer of a kind, as JSON has it."""
    command, name, *more = KINDS[kind][0]
    file = folder / f"{kind}.json"
    if command == "study":
        more += ["-o", str(folder / "out.parquet")]
    if command == "fit":
        more += ["-o", str(folder / "lagging.toml")]
    ran = wraparc(command, str(EXAMPLES / name), *more, "--json", str(file))
    assert ran.code in (0, 1), ran.err
    return json.loads(file.read_text("utf-8"))["answer"]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("answers")


def values(of: Any) -> Iterator[Any]:
    for table in of["tables"]:
        for row in table["rows"]:
            yield from row["values"]


def texts(of: Any) -> Iterator[Any]:
    """Every text of an answer."""
    yield from values(of)
    yield from (of["verdict"]["text"], *of["verdict"]["sentences"], *of["remarks"])
    for table in of["tables"]:
        yield from (table["title"], table["note"], *table["heads"])
        for row in table["rows"]:
            yield from (row["title"], row["note"])


@pytest.mark.parametrize("kind", KINDS)
def test_values_are_typed(kind: str, folder: Path) -> None:
    found = list(values(answer(kind, folder)))
    finished = [v for v in found if isinstance(v, str) and NUMBER.search(v)]
    assert len(finished) <= KINDS[kind][1], finished
    assert sum(isinstance(v, dict) for v in found) > 10


@pytest.mark.parametrize("kind", KINDS)
def test_us_units_have_the_same_numbers_and_no_metric_unit(kind: str, folder: Path) -> None:
    found = list(texts(answer(kind, folder)))
    told = [worded(text, "us") for text in found]
    assert [t for t in told if METRIC.search(t) and not AS_TYPED.search(t)] == []
    metric = [worded(text) for text in found]
    assert any(map(METRIC.search, metric)) or kind == "trim"
