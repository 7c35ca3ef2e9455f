"""The ten questions: their commands work where `wraparc demo` has laid out the examples.

That they run, and show what the page is about, is tested by building the documentation.
"""

import re
import shlex
from pathlib import Path

import pytest

from wraparc.cli.demo import lay_out

DOCS = Path(__file__).parents[2] / "docs"
PAGES = sorted((DOCS / "questions").glob("*.md"))
COMMAND = re.compile(r"""wraparc\(f?(["'])(?P<command>(?:\\.|(?!\1).)*)\1""")


@pytest.fixture(scope="module")
def laid_out(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("empty")
    lay_out(folder / "wraparc-demo")
    return folder


def test_there_are_ten() -> None:
    told = (DOCS / "how_to.md").read_text("utf-8")
    assert len(PAGES) == 10
    assert all(f"{{doc}}`questions/{page.stem}`" in told for page in PAGES)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_every_file_that_a_command_names_is_there(page: Path, laid_out: Path) -> None:
    text = page.read_text("utf-8")
    commands = [m["command"].replace("\\", "") for m in COMMAND.finditer(text)]
    assert commands
    for command in commands:
        typed = command.replace("../../examples/", "wraparc-demo/")
        assert "../" not in typed
        files = [word for word in shlex.split(typed) if word.endswith(".toml")]
        assert files
        assert all((laid_out / file).is_file() for file in files)
