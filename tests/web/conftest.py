"""The server and the browser that the tests of the pages share."""

from collections.abc import Iterator

import pytest

from web.browser import Calculator, Visitor, browser
from web.calculators import Process, serving


@pytest.fixture(scope="session")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Process]:
    """One server for all files of pages: it has to start and to compile only once."""
    database = tmp_path_factory.mktemp("designs") / "designs.sqlite"
    with serving("--no-open", "--workers", "1", "--database", str(database)) as found:
        yield found


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
    found.context.close()
    assert found.wrong == []
    assert found.elsewhere == []
