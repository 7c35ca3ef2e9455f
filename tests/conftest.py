"""Settings that every test shares."""

import gc
import os
import signal
import subprocess
import sys
import time
from collections.abc import Generator, Iterator
from contextlib import ExitStack, suppress
from hashlib import md5

import pytest
from hypothesis import settings
from hypothesis.internal.conjecture import providers

import hanging

# No wall clock in a test; in CI the same examples every time, at a desk new ones.
settings.register_profile("wraparc", deadline=None, derandomize="CI" in os.environ)
settings.load_profile("wraparc")
# Nor constants of the modules that happen to be loaded: the order of tests would count.
providers._get_local_constants = lambda: providers._local_constants

# What a shell starts in the background ignores Ctrl-C, and so would every process of a test.
signal.signal(signal.SIGINT, signal.default_int_handler)

# What is imported and collected stays to the end: it is looked through for rubbish no time at all
# (`pytest_collection_finish`), where each time takes a second, a tenth of all that tests take.
gc.disable()

BEGIN = time.monotonic()
LEFT = "left to make test"

# The width of a pipe, whatever the terminal: pytest-xdist gives its workers 80 columns.
os.environ["COLUMNS"] = "110"
# The catalogue that ships, whatever laggings and belts of their own who runs this may have.
os.environ.pop("WRAPARC_CATALOGUE", None)


def pytest_configure(config: pytest.Config) -> None:
    config.pluginmanager.register(hanging, "hanging")


def pytest_addoption(parser: pytest.Parser) -> None:
    """Add ``--under-load TIMES``: what waits for processes or threads must never fail by luck."""
    parser.addoption(
        "--under-load",
        type=int,
        default=0,
        metavar="TIMES",
        help="run only the tests marked `processes`, each so often, beside two busy processes",
    )
    parser.addoption(
        "--budget",
        type=float,
        default=0.0,
        metavar="SECONDS",
        help="run tests in the order given, and begin none after so long (make check)",
    )
    parser.addoption(
        "--shuffle",
        metavar="SEED",
        help="run files, and tests within each, in another order: no test may need another's",
    )


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_setup(item: pytest.Item) -> None:
    budget = item.config.getoption("--budget")
    if budget and time.monotonic() > BEGIN + budget:
        pytest.skip(LEFT)


def pytest_report_teststatus(
    report: pytest.CollectReport | pytest.TestReport,
) -> tuple[str, str, str] | None:
    left = report.skipped and LEFT in str(report.longrepr)
    return (LEFT, "", LEFT) if left else None


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    times = metafunc.config.getoption("--under-load")
    if times and metafunc.definition.get_closest_marker("processes"):
        metafunc.fixturenames.append("time")
        metafunc.parametrize("time", range(times))


#: What takes longest, so that workers who begin with it end together.
FIRST = (
    "golden/test_golden", "web/test_pages", "web/test_page_file", "web/test_standing",
    "web/test_pages_looks", "web/test_pages_editing", "web/test_cut_off",
    "web/test_page_file_trains", "web/test_case_loads", "web/test_first_screen",
    "web/test_pages_figure", "answer/test_rounding", "web/test_ten_questions",
    "web/test_across_page", "arc/test_wide_net", "web/test_questions", "web/test_states_looks",
    "calibrate/test_calibration", "web/test_inputs", "web/test_advice", "calibrate/test_speeds",
    "judgement/test_rows", "motion/test_station", "web/test_drafts", "web/test_exports",
    "web/test_pages_tests", "motion/test_motion_file", "web/test_keyboard_focus",
    "motion/test_long_steps", "arc/test_thick_belt", "train/test_curves", "web/test_pages_events",
    "web/test_seek_page", "web/test_restarted", "web/test_serve", "cli/test_process",
    "cli/test_readme", "study/test_study_dask", "judgement/test_advised", "web/test_assembled",
    "checks/test_runs", "arc/test_capacity", "motion/test_checkpoint", "cli/test_belt_doors",
    "cli/test_trim", "batch/test_batch", "web/test_jobs", "train/test_branches",
    "render/test_note_pdf", "motion/test_real_belt",
)  # fmt: skip


def _place(item: pytest.Item) -> str:
    return f"{item.path.parent.name}/{item.path.stem}"


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    places = {name: place for place, name in enumerate(FIRST)}
    if seed := config.getoption("--shuffle"):
        # of the names alone, so that every worker finds the same order
        def mixed(name: str) -> bytes:
            return md5(f"{seed} {name}".encode(), usedforsecurity=False).digest()

        items.sort(key=lambda i: (mixed(i.nodeid.partition("::")[0]), mixed(i.nodeid)))
    elif not config.getoption("--budget"):
        items.sort(key=lambda i: places.get(_place(i), len(FIRST)))
    if config.getoption("--under-load"):
        others = [item for item in items if not item.get_closest_marker("processes")]
        config.hook.pytest_deselected(items=others)
        items[:] = [item for item in items if item.get_closest_marker("processes")]


def pytest_collection_finish() -> None:
    gc.freeze()
    gc.set_threshold(20_000)
    gc.enable()


@pytest.hookimpl(wrapper=True)
def pytest_make_collect_report(
    collector: pytest.Collector,
) -> Generator[None, pytest.CollectReport, pytest.CollectReport]:
    """One worker reads a file first and rewrites its assertions; the others find that on disk."""
    with ExitStack() as stack:
        if isinstance(collector, pytest.Module):
            with suppress(ImportError):  # Windows
                import fcntl

                file = stack.enter_context(open(collector.path, "rb"))
                fcntl.flock(file, fcntl.LOCK_EX)
        return (yield)


@pytest.fixture(scope="session", autouse=True)
def load(request: pytest.FixtureRequest) -> Iterator[None]:
    """Two busy processes beside the tests, if that is asked for."""
    count = 2 if request.config.getoption("--under-load") else 0
    busy = [subprocess.Popen([sys.executable, "-c", "while True: pass"]) for _ in range(count)]
    yield
    for process in busy:
        process.kill()
        process.wait()


@pytest.fixture(scope="module")
def solved_once() -> Iterator[None]:
    """What several tests of doors and words ask for is found once in a session, see `once`."""
    from once import solved_once

    with solved_once():
        yield


@pytest.fixture
def untried(monkeypatch: pytest.MonkeyPatch) -> None:
    """Nothing is tried to find what to do about a verdict: for tests of all else that is said."""
    from wraparc import actions
    from wraparc.answer.words import stated_action
    from wraparc.checks import judge

    monkeypatch.setattr(actions, "find_action", lambda result: stated_action(judge(result)))
