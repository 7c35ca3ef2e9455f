"""No marker of a cell that waits for its units is left in what is kept of shipped examples."""

import json
import re
from pathlib import Path

import pytest

from cli.running import wraparc
from render.test_note_files import sheets

pytestmark = pytest.mark.usefixtures("solved_once")

#: All but two trains, whose tables are those of the third.
EXAMPLES = [
    path
    for path in sorted((Path(__file__).parents[2] / "examples").glob("*.toml"))
    if path.stem not in ("tandem-steel-cord", "triple-steel-cord")
]
#: What `wraparc.units.cell` begins and ends cells with, and their inside.
MARKER = re.compile("[\x02-\x06]|[|](percent|apart|bare)[|]|_x000[2-6]_|[|]nan[|]")


@pytest.mark.parametrize("path", EXAMPLES, ids=[path.stem for path in EXAMPLES])
def test_no_marker_is_left(path: Path, tmp_path: Path) -> None:
    """Expected: none; what a cell may hold is told in `wraparc.units.cell`."""
    wraparc("report", path, "-o", tmp_path / "note.xlsx")
    wraparc("report", path, "-o", tmp_path / "note.md")
    wraparc("solve", path, "--json", tmp_path / "out.json")
    cells = [
        cell
        for rows in sheets((tmp_path / "note.xlsx").read_bytes()).values()
        for row in rows
        for cell in row
        if isinstance(cell, str)
    ]
    texts = [(tmp_path / "note.md").read_text("utf-8")]
    document = json.loads((tmp_path / "out.json").read_text("utf-8"))
    texts.append(json.dumps(document, ensure_ascii=False))
    assert len(cells) > 100
    assert [
        text for text in (*cells, *texts) if MARKER.search(text.replace("\\u000", "_x000"))
    ] == []
