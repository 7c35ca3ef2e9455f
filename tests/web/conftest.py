"""The server and the browser that the tests of the pages share."""

import asyncio
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser

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


@pytest.fixture(scope="session")
def only_browser() -> Iterator[tuple[Browser, asyncio.AbstractEventLoop]]:
    """One browser for all files of pages, and the loop of Playwright."""
    with browser() as found:
        loop = asyncio.get_running_loop()
        yield found, loop
        asyncio._set_running_loop(loop)


@pytest.fixture(scope="module")
def chrome(only_browser: tuple[Browser, asyncio.AbstractEventLoop]) -> Iterator[Browser]:
    """The browser, for a file.

    Playwright's loop is marked as running as long as the browser is open, and needs to be where it
    is asked; other files run loops of their own.
    """
    found, loop = only_browser
    asyncio._set_running_loop(loop)
    yield found
    asyncio._set_running_loop(None)


@pytest.fixture(scope="module")
def calculator(chrome: Browser, server: Process) -> Calculator:
    return chrome, server


@pytest.fixture(scope="module")
def long_visit(calculator: Calculator) -> Iterator[Visitor]:
    """One visit for a file whose tests each begin by opening a drive of their own."""
    browser, server = calculator
    found = Visitor(browser, server.address)
    found.open("drive")
    yield found
    found.close()
    assert found.wrong == []
    assert found.elsewhere == []


@pytest.fixture
def visitor(calculator: Calculator) -> Iterator[Visitor]:
    browser, server = calculator
    found = Visitor(browser, server.address)
    yield found
    found.close()
    assert found.wrong == []
    assert found.elsewhere == []
