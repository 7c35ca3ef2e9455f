"""Every page of a decision has its four parts, is short and listed, and names files that exist."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
FOLDER = ROOT / "docs" / "decisions"
PAGES = sorted(path for path in FOLDER.glob("*.md") if path.name != "index.md")
#: Folders in which a page may name a file by its name alone.
SHORT = ("", "src/wraparc", "benchmarks/results", "tests/web", "tests/batch", "docs")
PARTS = ["## Question", "## Measured", "## Decision", "## What would change it"]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_a_decision_has_its_parts_and_names_what_exists(page: Path) -> None:
    text = page.read_text("utf-8")
    assert re.findall(r"^## .*", text, re.MULTILINE) == PARTS
    assert 200 <= len(text.split()) <= 400
    measured = text.partition(PARTS[1])[2].partition(PARTS[2])[0]
    assert len(re.findall(r"\d", measured)) > 10
    for name in re.findall(r"`(?:python )?([\w/.]+\.(?:py|md|typ|mjs))`", text):
        assert any((ROOT / folder / name).is_file() for folder in SHORT), name


def test_every_decision_is_listed_and_in_the_navigation() -> None:
    index = (FOLDER / "index.md").read_text("utf-8")
    described = re.findall(r"^\{doc\}`(\w+)`$", index, re.MULTILINE)
    navigated = index.partition("```{toctree}")[2].split()[1:-1]
    assert described == navigated
    assert sorted(navigated) == [page.stem for page in PAGES]
    assert "\ndecisions/index\n" in (ROOT / "docs" / "explanation.md").read_text("utf-8")
