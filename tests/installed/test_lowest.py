"""The lowest versions that the gate tries are those that the package says it works with."""

import re
import tomllib
from pathlib import Path

ROOT = Path(__file__).parents[2]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
LOWEST = dict(
    line.partition(" ")[0].split("==")
    for line in Path(__file__).with_name("lowest.txt").read_text("utf-8").splitlines()
)


def test_every_bound_is_the_version_that_is_tried() -> None:
    """Made anew by ``make lock``; a bound that no version meets exactly is a bound too low."""
    extras = [line for lines in PROJECT["optional-dependencies"].values() for line in lines]
    declared = [line for line in PROJECT["dependencies"] + extras if not line.startswith("wraparc")]
    for line in declared:
        name, bound = re.fullmatch(r"([\w-]+)(?:\[\w+\])?[>=]=([\d.]+)", line).groups()  # type: ignore[union-attr]
        tried = [int(part) for part in LOWEST[name].split(".")]
        asked = [int(part) for part in bound.split(".")]
        assert tried[: len(asked)] == asked, f"{line}: {LOWEST[name]} is tried"


def test_every_python_that_is_named_is_one_that_is_supported() -> None:
    named = [c for c in PROJECT["classifiers"] if re.search(r":: 3\.\d+$", c)]
    assert [c.rpartition(" ")[2] for c in named] == ["3.11", "3.12", "3.13"]
    assert PROJECT["requires-python"] == ">=3.11"
