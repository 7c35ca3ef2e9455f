"""Settings that every test shares."""

import os
import subprocess
import sys
from collections.abc import Iterator

import pytest
from hypothesis import settings

# No wall clock in a test; in CI the same examples every time, at a desk new ones.
settings.register_profile("wraparc", deadline=None, derandomize="CI" in os.environ)
settings.load_profile("wraparc")

# The width of a pipe, whatever the terminal: pytest-xdist gives its workers 80 columns.
os.environ["COLUMNS"] = "110"


def pytest_addoption(parser: pytest.Parser) -> None:
    """Add ``--under-load TIMES``: what waits for processes or threads must never fail by luck."""
    parser.addoption(
        "--under-load",
        type=int,
        default=0,
        metavar="TIMES",
        help="run only the tests marked `processes`, each so often, beside two busy processes",
    )


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    times = metafunc.config.getoption("--under-load")
    if times and metafunc.definition.get_closest_marker("processes"):
        metafunc.fixturenames.append("time")
        metafunc.parametrize("time", range(times))


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    if config.getoption("--under-load"):
        others = [item for item in items if not item.get_closest_marker("processes")]
        config.hook.pytest_deselected(items=others)
        items[:] = [item for item in items if item.get_closest_marker("processes")]


@pytest.fixture(scope="session", autouse=True)
def load(request: pytest.FixtureRequest) -> Iterator[None]:
    """Two busy processes beside the tests, if that is asked for."""
    count = 2 if request.config.getoption("--under-load") else 0
    busy = [subprocess.Popen([sys.executable, "-c", "while True: pass"]) for _ in range(count)]
    yield
    for process in busy:
        process.kill()
        process.wait()
