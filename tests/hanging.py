"""An end for tests that hang, with their names and with stacks; the rest goes on.

``timeout`` in pyproject.toml limits every test with its fixtures: there pytest-timeout raises in
the main thread, inside a call into a browser too. What no signal ends, such as a call into C that
goes on or a fixture that hangs once more while it is closed, meets a watchdog in C: it prints the
stacks of all threads and ends the process. pytest-xdist names the test that the process ended in,
starts another and runs the rest.
"""

import faulthandler
import gc
import os
import sys
import threading
import traceback
from collections.abc import Generator, Iterator
from typing import Any

import pytest
from xdist.scheduler import LoadFileScheduling

#: So long after the limit of a test [s] the watchdog ends the process.
GRACE = 30.0
_STDERR = pytest.StashKey[int]()


def pytest_configure(config: pytest.Config) -> None:
    # the terminal's, which tests are not connected to
    config.stash[_STDERR] = os.dup(2)


def pytest_unconfigure(config: pytest.Config) -> None:
    faulthandler.cancel_dump_traceback_later()
    os.close(config.stash[_STDERR])


def _watch(item: pytest.Item, *, fixtures: bool = True) -> None:
    """Set the watchdog, from now on."""
    marker = item.get_closest_marker("timeout")
    own = marker and not (fixtures and marker.kwargs.get("func_only"))
    every = item.config.getoption("timeout") or item.config.getini("timeout")
    if limit := float(marker.args[0] if marker and own else every):
        error = item.config.stash[_STDERR]
        faulthandler.dump_traceback_later(limit + GRACE, exit=True, file=error)


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_setup(item: pytest.Item) -> None:
    _watch(item)


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_call(item: pytest.Item) -> None:
    _watch(item, fixtures=False)


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_teardown(item: pytest.Item) -> None:
    # pytest-timeout does not limit it once more, and pytest calls the watchdog off after a failure
    _watch(item)


def pytest_runtest_logfinish() -> None:
    faulthandler.cancel_dump_traceback_later()


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(
    call: pytest.CallInfo[None],
) -> Generator[None, pytest.TestReport, pytest.TestReport]:
    report = yield
    if call.excinfo and "pytest-timeout" in str(call.excinfo.value):
        report.sections.append(("stacks of the other threads and greenlets", "".join(_stacks())))
    return report


def _stacks() -> Iterator[str]:
    """Yield the stacks of all threads and greenlets but the one that runs."""
    names = {thread.ident: thread.name for thread in threading.enumerate()}
    frames: list[tuple[str, Any]] = [
        (f"thread {names.get(ident, ident)}", frame)
        for ident, frame in sys._current_frames().items()
        if ident != threading.get_ident()
    ]
    if greenlet := sys.modules.get("greenlet"):
        frames += [
            (f"greenlet {one!r}", one.gr_frame)
            for one in gc.get_objects()
            if isinstance(one, greenlet.greenlet) and one.gr_frame
        ]
    for name, frame in frames:
        yield f"{name}:\n{''.join(traceback.format_stack(frame))}"


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config: pytest.Config, log: Any) -> Any:
    """Hand files to workers; xdist alone would begin a test that ends each worker for ever."""
    if config.getvalue("dist") != "loadfile":
        return None
    scheduler = LoadFileScheduling(config, log)
    remove = scheduler.remove_node

    def remove_node(node: Any) -> str | None:
        for unit in scheduler.assigned_work[node].values():
            for name, done in unit.items():
                if not done:
                    unit[name] = True
                    remove(node)
                    return str(name)
        remove(node)
        return None

    scheduler.remove_node = remove_node
    return scheduler
