"""The server and the browser that the tests of the pages share."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from web.browser import Calculator, Visitor, browser
from web.calculators import Process


@pytest.fixture(scope="session")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where the server keeps its designs and the folders of its tasks."""
    return tmp_path_factory.mktemp("server")


@pytest.fixture(scope="session")
def server(folder: Path) -> Iterator[Process]:
    """One server for all files of pages: it has to start only once."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("TMPDIR", str(folder))
        database = str(folder / "designs.sqlite")
        found = Process("--no-open", "--workers", "1", "--database", database)
    yield found
    found.kill()


@pytest.fixture(scope="module")
def calculator(server: Process) -> Iterator[Calculator]:
    """A browser of each file's own: Playwright keeps a loop running as long as it is open."""
    with browser() as found:
        yield found, server


@pytest.fixture
def visitor(calculator: Calculator) -> Iterator[Visitor]:
    browser, server = calculator
    found = Visitor(browser, server.address)
    yield found
    found.close()
    assert found.wrong == []
    assert found.elsewhere == []
