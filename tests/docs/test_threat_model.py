"""Every promise of the threat model names the test that holds it, and the test is there."""

import re
from pathlib import Path

from wraparc.schema import bounds
from wraparc.web import connections, security, sessions, work
from wraparc.web.answers import documents

TESTS = Path(__file__).parents[1]
PAGE = TESTS.parent / "docs" / "server.md"


def test_every_promise_names_a_test_that_is_there() -> None:
    model = PAGE.read_text("utf-8").partition("## Threat model")[2].partition("\n## ")[0]
    rows = model.partition("| promise |")[2].partition("\n\n")[0].splitlines()[2:]
    assert len(rows) > 10
    for row in rows:
        named = re.findall(r"`(web/test_\w+\.py)::(test_\w+)`", row)
        assert named, row
        for file, name in named:
            assert f"\ndef {name}(" in (TESTS / file).read_text("utf-8"), (file, name)


def test_what_is_said_of_bounds_is_what_is_bound() -> None:
    told = " ".join(PAGE.read_text("utf-8").split())
    for said in (
        f"{bounds.MOST_KEYS:,} keys of {bounds.LONGEST_KEY} characters",
        f"{bounds.MOST_KEY_PARTS} parts, {bounds.MOST_TABLES:,} lists and tables, "
        f"{bounds.DEEPEST} deep",
        f"{bounds.MOST_VALUES:,} values in lists, {bounds.MOST_LINES:,} lines",
        f"A request is at most {security.BODY_LIMIT / 1e6:g} MB, one that uploads files "
        f"{security.UPLOAD_LIMIT / 1e6:g} MB",
        f"at most {documents.MOST_ARCS} arcs",
        f"{work.SHORT_LIMIT:g} s for a short answer, {work.LONG_LIMIT / 60:g} minutes for a long",
        f"{work.JOB_LIMIT / 3600:g} hours for a study or a run in time",
        f"{sessions.MOST_FILES} files of {sessions.MOST_FILE / 1e6:g} MB, "
        f"{sessions.MOST_SESSION / 1e6:g} MB in all",
        f"{connections.MOST_SILENT} at most, {connections.HEAD_LIMIT:g} s for a head of "
        f"{connections.LONGEST_HEAD / 1e3:g} kB",
    ):
        assert said in told, said


def test_every_question_of_the_server_has_a_bound() -> None:
    routes = TESTS.parent / "src" / "wraparc" / "web" / "routes"
    asked = 0
    for path in routes.glob("*.py"):
        for call in re.finditer(r"workers\.(?:apart|read)\(", code := path.read_text("utf-8")):
            asked += 1
            assert "limit=" in code[call.start() : call.start() + 160], path.name
    assert asked == 4
