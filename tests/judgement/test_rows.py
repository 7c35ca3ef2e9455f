"""The first two lines of an answer lead nobody wrong: see `rows`.

Expected: the words of each row, written by hand for what its drive is made to do.
"""

import json
import re
import subprocess
import tomllib
from pathlib import Path

import pytest

from cli.running import wraparc
from judgement.rows import ALIKE, DOORS, PLAN, ROWS, SEARCH, Row
from wraparc import load_drive, solve
from wraparc.answer.least_tension import least_sentence
from wraparc.answer.sheet import shown
from wraparc.arc import DriveResult
from wraparc.web.answers.book import book
from wraparc.web.answers.form import form

pytestmark = pytest.mark.usefixtures("solved_once")


def solved(path: Path) -> DriveResult:
    """Return a drive file solved."""
    return solve(load_drive(str(path)), raise_on_failure=False)


def lead(words: str) -> str:
    """Return the first lines of an answer, up to what it says of a wet drive and of its data."""
    return re.split(r" Wet (?!creep)| Reserve | Data ", words)[0]


@pytest.fixture(scope="module")
def of_page() -> dict[str, dict[str, str | None]]:
    """Return what the page of one file says first of its rows, and of the least tension."""
    rows = [row for row in ROWS if "page" in row.doors]
    told = {
        "form": json.loads(form().model_dump_json()),
        "book": json.loads(book().model_dump_json()),
        "documents": [tomllib.loads(row.text) for row in rows],
    }
    done = subprocess.run(
        ["node", str(Path(__file__).with_name("page.mjs"))], input=json.dumps(told),
        capture_output=True, text=True, encoding="utf-8", check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    return dict(zip((row.name for row in rows), json.loads(done.stdout), strict=True))


def first_of(row: Row, door: str, folder: Path) -> str:
    """Return what a door says first."""
    names = {"FILE": "drive.toml", "PLAN": "plan.toml", "SEARCH": "search.toml",
             "ROWS": "rows.parquet", "NOTE": "note.md"}  # fmt: skip
    slack = row.text.partition('exit_tension = "')[2].partition('"')[0]
    plan = PLAN.replace("{slack}1", slack.replace(" kN", ".1 kN")).replace("{slack}", slack)
    for name, text in (("drive", row.text), ("plan", plan), ("search", SEARCH)):
        (folder / f"{name}.toml").write_text(text, "utf-8")
    ran = wraparc(*(folder / names[w] if w in names else w for w in DOORS[door]))
    if door != "note":
        return lead(ran.words)
    paragraphs = (folder / "note.md").read_text("utf-8").split("\n\n")
    verdict = next(p for p in paragraphs if p.startswith("- **"))
    return lead(re.sub(r"[\\*]|^- ", "", " ".join(verdict.replace("\n- ", " ").split())))


@pytest.mark.parametrize(
    ("row", "door"),
    [(row, door) for row in ROWS for door in row.doors],
    ids=[f"{row.name}: {door}" for row in ROWS for door in row.doors],
)
def test_the_first_lines_say_what_is_the_matter(
    row: Row, door: str, tmp_path: Path, request: pytest.FixtureRequest
) -> None:
    if door == "page":
        first = request.getfixturevalue("of_page")[row.name]["first"]
    else:
        first = first_of(row, door, tmp_path)
    for word in row.must:
        assert word in first, first
    for word in row.must_not:
        assert word not in first, first
    if row.level and door in ALIKE:
        assert f" {row.level}" in f" {first}", first


def test_the_page_tells_the_least_tension_of_the_program(
    of_page: dict[str, dict[str, str | None]], tmp_path: Path
) -> None:
    path = tmp_path / "drive.toml"
    judged = [row for row in ROWS if of_page.get(row.name, {}).get("least") is not None]
    assert len(judged) > 10
    for row in judged:
        path.write_text(row.text, "utf-8")
        assert of_page[row.name]["least"] == shown(least_sentence(solved(path)), "si"), row.name


def test_there_are_sixty_ways_to_fail() -> None:
    assert len({row.name for row in ROWS}) == len(ROWS)
    assert len({row.text for row in ROWS}) >= 60
