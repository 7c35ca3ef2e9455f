"""What hangs is ended and named, and the tests beside it still run."""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

import hanging

ROOT = Path(__file__).parents[1]
CONFTEST = """
import hanging

hanging.GRACE = {grace}

def pytest_configure(config):
    config.pluginmanager.register(hanging, "hanging")
"""
# the browser starts outside the limit, so that only what never comes can reach it
BROWSER = """
import pytest
from web.browser import browser

@pytest.fixture(scope="module")
def page():
    with browser() as found:
        yield found.new_page()

@pytest.mark.timeout(1, func_only=True)
def test_promise(page):
    page.evaluate("new Promise(() => {})")

@pytest.mark.timeout(1, func_only=True)
def test_frame(page):
    with page.expect_console_message(timeout=0):
        page.evaluate("1 + 1")

def test_rest(page):
    assert page.evaluate("1 + 1") == 2
"""
# no signal arrives, and the lock of the interpreter is held: nothing in Python can end it
IN_C = """
import ctypes, signal
import pytest

def test_before():
    pass

@pytest.mark.timeout(1)
def test_in_c():
    signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGALRM})
    ctypes.PyDLL(None).sleep(10**9)

def test_after():
    pass
"""
# what ends the test does not end its fixture
TEARDOWN = """
import threading
import pytest

@pytest.fixture
def hangs_too():
    yield
    threading.Event().wait()

@pytest.mark.timeout(1)
def test_twice(hangs_too):
    threading.Event().wait()

def test_after():
    pass
"""


def run(folder: Path, *files: str, grace: float = hanging.GRACE) -> str:
    """Run test files with the settings of the project, two at a time; what it printed."""
    (folder / "conftest.py").write_text(CONFTEST.format(grace=grace))
    for number, text in enumerate(files):
        (folder / f"test_{number}.py").write_text(text)
    command = [sys.executable, "-m", "pytest", "-c", f"{ROOT}/pyproject.toml", "--rootdir", ".",
               "-p", "xdist", "-p", "pytest_timeout", "-n", "2", "--dist", "loadfile",
               "-o", "addopts=", "-o", "required_plugins=", "."]  # fmt: skip
    environment = {**os.environ, "PYTHONPATH": str(ROOT / "tests"),
                   "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1"}  # fmt: skip
    environment.pop("PYTEST_ADDOPTS", None)
    done = subprocess.run(
        command, cwd=folder, env=environment, capture_output=True, text=True, check=False
    )
    assert done.returncode == 1, done.stdout + done.stderr
    return done.stdout + done.stderr


def failed(told: str) -> list[str]:
    return sorted(re.findall(r"^FAILED \S*::(\w+)", told, re.MULTILINE))


def test_a_browser_that_never_answers_fails_its_test_and_serves_the_next(tmp_path: Path) -> None:
    told = run(tmp_path, BROWSER)
    assert failed(told) == ["test_frame", "test_promise"], told
    assert "1 passed" in told
    assert 'page.evaluate("new Promise(() => {})")' in told
    assert re.search(r"^greenlet <.*MainGreenlet", told, re.MULTILINE), told


@pytest.mark.skipif(not hasattr(os, "fork"), reason="signals and processes of POSIX")
@pytest.mark.parametrize(("file", "name"), [(IN_C, "test_in_c"), (TEARDOWN, "test_twice")])
def test_what_no_signal_ends_is_named_and_the_rest_runs(
    file: str, name: str, tmp_path: Path
) -> None:
    told = run(tmp_path, file, "def test_elsewhere():\n    pass\n", grace=0.1)
    assert set(failed(told)) == {name}, told
    assert f"crashed while running 'test_0.py::{name}'" in told
    assert "most recent call first" in told
    assert f"{file.count('def test_')} passed" in told
