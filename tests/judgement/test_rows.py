"""The first two lines of an answer lead nobody wrong: see `rows`.

Expected: the words of each row, written by hand for what its drive is made to do.
"""

from pathlib import Path

import pytest

from cli.running import wraparc
from judgement.rows import ROWS, Row


def lead(words: str) -> str:
    """Return the first two lines of an answer, without its title: up to the first of its points."""
    return words.partition(" - ")[0]


@pytest.mark.parametrize(
    ("row", "door"),
    [(row, door) for row in ROWS for door in row.doors],
    ids=[f"{row.name}: {door[0]}" for row in ROWS for door in row.doors],
)
def test_the_first_lines_say_what_is_the_matter(
    row: Row, door: tuple[str, ...], tmp_path: Path
) -> None:
    path = tmp_path / "drive.toml"
    path.write_text(row.text, "utf-8")
    ran = wraparc(*(path if word == "FILE" else word for word in door))
    first = lead(ran.words)
    for word in row.must:
        assert word in first, first
    for word in row.must_not:
        assert word not in first, first
    if row.level and door[0] == "solve":
        assert f" {row.level}" in f" {first}", first


def test_every_row_has_a_name_of_its_own() -> None:
    assert len({row.name for row in ROWS}) == len(ROWS)
