"""Who works on what when: turns of clients, shared and abandoned questions, processes that die."""

import asyncio
import errno
import multiprocessing
import os
import pickle
import signal
import time
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

import pytest
from fastapi import Request

from web.calculators import PATIENCE
from wraparc.errors import InputError, Problem
from wraparc.web import work
from wraparc.web.errors import ApiError
from wraparc.web.routes.parts import waited
from wraparc.web.turns import Turns
from wraparc.web.work import Workers

pytestmark = pytest.mark.processes


async def until(condition: Callable[[], bool]) -> None:
    """Wait until something holds."""
    async with asyncio.timeout(PATIENCE):
        while not condition():
            await asyncio.sleep(0.001)


@pytest.fixture(autouse=True)
def _cold(monkeypatch: pytest.MonkeyPatch) -> None:
    """Processes begin at once: what they solve beforehand is no matter here."""
    monkeypatch.setattr(work, "_warm", os.getpid)
    monkeypatch.setattr("wraparc.web.warm.compile_kernel", bool)


@asynccontextmanager
async def workers(count: int = 1) -> AsyncIterator[Workers]:
    found = Workers(count)
    try:
        yield found
    finally:
        found.stop()


def test_clients_take_turns_and_one_cannot_hold_every_place() -> None:
    async def scenario() -> None:
        turns, order = Turns(2, 1, 10), list[str]()
        release = asyncio.Event()

        async def ask(client: str) -> None:
            async with turns.turn(client):
                order.append(client)
                await release.wait()

        asked = [asyncio.create_task(ask(client)) for client in "aaab"]
        await until(lambda: len(order) == 2)
        assert order == ["a", "b"]  # b came last and does not wait for all of a
        release.set()
        await asyncio.gather(*asked)
        assert order == ["a", "b", "a", "a"]

    asyncio.run(scenario())


def test_no_place_is_lost_by_those_who_leave() -> None:
    async def scenario() -> None:
        turns = Turns(1, 1, 2)

        async def hold() -> None:
            async with turns.turn("a"):
                await asyncio.Event().wait()

        holding, waiting, last = [asyncio.create_task(hold()) for _ in range(3)]
        await until(lambda: turns.waiting == 2)
        with pytest.raises(ApiError, match="503") as raised:
            await hold()
        assert int((raised.value.headers or {})["retry-after"]) > 0
        waiting.cancel()
        await until(lambda: turns.waiting == 1)
        holding.cancel()
        await until(lambda: turns.waiting == 0)
        last.cancel()
        await asyncio.wait([last])
        async with turns.turn("b"):
            pass

    asyncio.run(scenario())


def test_a_process_that_cannot_start_leaks_no_place(monkeypatch: pytest.MonkeyPatch) -> None:
    class Broken:
        def __init__(self, *_: object) -> None:
            raise OSError("no process can be started")

    async def scenario() -> None:
        async with workers() as found:
            monkeypatch.setattr(work, "Worker", Broken)
            for _ in range(300):  # more than may wait
                with pytest.raises(OSError, match="no process"):
                    await found.short("a", os.getpid)
            monkeypatch.undo()
            monkeypatch.setattr(work, "_warm", os.getpid)
            assert unpacked(await found.short("a", os.getpid)) != os.getpid()

    asyncio.run(scenario())


def test_the_same_question_is_computed_once(tmp_path: Path) -> None:
    async def scenario() -> None:
        async with workers(2) as found:
            asked = [found.short("a", _note, str(tmp_path)) for _ in range(5)]
            answers = await asyncio.gather(*asked)
            assert len(set(answers)) == 1
            assert len(list(tmp_path.iterdir())) == 1

    asyncio.run(scenario())


def unpacked(answer: bytes) -> Any:
    return pickle.loads(answer)  # noqa: S301 - of a process of the test


def _note(folder: str) -> int:
    Path(folder, str(time.monotonic_ns())).write_text("")
    return os.getpid()


def _held(file: str) -> str:
    while not Path(file).exists():
        time.sleep(0.001)
    return "held"


def _fills() -> None:
    raise OSError(errno.ENOSPC, "No space left on device")


def _raises(message: str) -> None:
    raise InputError(Problem(message=message))


def test_what_a_process_raises_comes_back_and_it_lives_on() -> None:
    async def scenario() -> None:
        async with workers() as found:
            before = await found.short("a", os.getpid)
            with pytest.raises(InputError, match="wrong"):
                await found.short("a", _raises, "wrong")
            with pytest.raises(ApiError, match="ZeroDivisionError") as raised:
                await found.short("a", divmod, 1, 0)
            assert raised.value.status_code == 500
            with pytest.raises(ApiError, match="the disk of the server is full") as full:
                await found.short("a", _fills)
            assert full.value.status_code == 507
            assert await found.short("a", os.getpid) == before

    asyncio.run(scenario())


def test_a_process_that_dies_costs_its_own_question_only(tmp_path: Path) -> None:
    gate = tmp_path / "go"

    async def scenario() -> None:
        async with workers(2) as found:
            other = asyncio.create_task(found.short("b", _held, str(gate), queue=work.QUICK))
            with pytest.raises(ApiError, match="503"):
                await found.short("a", os._exit, 1, queue=work.QUICK)
            gate.write_text("")
            assert unpacked(await other) == "held"
            assert unpacked(await found.short("a", os.getpid, queue=work.QUICK))
            # one that dies while it has nothing to do costs nobody anything
            for worker in [worker for worker in found._all if worker.alive]:
                os.kill(worker._process.pid, signal.SIGKILL)
                worker._process.join()
            assert unpacked(await found.short("a", os.getpid, queue=work.QUICK))

    asyncio.run(scenario())


@pytest.mark.parametrize("begun", [False, True], ids=["starting", "at work"])
def test_an_abandoned_solve_is_ended_and_makes_room(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, begun: bool
) -> None:
    monkeypatch.setattr(work, "LEFT_LIMIT", 0.0)

    async def scenario() -> None:
        async with workers() as found:
            left = asyncio.create_task(found.short("a", _sleeps, str(tmp_path), 3600.0))
            behind = asyncio.create_task(found.short("a", _sleeps, str(tmp_path), 3601.0))
            await until(lambda: found._turns[work.WHOLE].waiting == 1)
            await until(lambda: not begun or any(tmp_path.iterdir()))
            for task in (left, behind):
                task.cancel()
            assert unpacked(await found.short("a", os.getpid))
            await until(lambda: len(multiprocessing.active_children()) == 1)

    asyncio.run(scenario())


def test_who_asks_what_is_just_being_given_up_gets_an_answer(tmp_path: Path) -> None:
    gate = tmp_path / "go"

    async def scenario() -> None:
        async with workers() as found:
            left = asyncio.create_task(found.short("a", _held, str(gate)))
            await until(lambda: any(not idle for idle in found._idle.values()) and bool(found._all))
            ((task, _),) = found._shared.values()
            task.cancel()  # as it is when nobody has waited for a while
            asked = asyncio.create_task(found.short("b", _held, str(gate)))
            gate.write_text("")
            assert unpacked(await asked) == "held"
            with pytest.raises(asyncio.CancelledError):
                await left
            await until(lambda: not found._shared)

    asyncio.run(scenario())


def _sleeps(folder: str, seconds: float) -> None:
    _note(folder)
    time.sleep(seconds)


def test_what_nobody_waits_for_any_more_is_given_up() -> None:
    async def scenario() -> None:
        gone = asyncio.Event()

        async def receive() -> dict[str, Any]:
            await gone.wait()
            return {"type": "http.disconnect"}

        work = asyncio.get_running_loop().create_future()
        waiting = asyncio.create_task(waited(Request({"type": "http"}, receive), work))
        gone.set()
        with pytest.raises(ApiError, match="nobody waits"):
            await waiting
        assert work.cancelled()

    asyncio.run(scenario())


def test_a_server_that_stops_says_so_to_who_still_waits() -> None:
    async def scenario() -> None:
        heard = asyncio.Event()

        async def receive() -> dict[str, Any]:
            heard.set()
            await asyncio.Event().wait()
            return {}

        work = asyncio.get_running_loop().create_future()
        waiting = asyncio.create_task(waited(Request({"type": "http"}, receive), work))
        await heard.wait()
        waiting.cancel()
        with pytest.raises(ApiError, match="being stopped"):
            await waiting
        assert work.cancelled()

    asyncio.run(scenario())


def test_an_answer_that_is_late_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(work, "SHORT_LIMIT", 0.05)

    async def scenario() -> None:
        async with workers() as found:
            with pytest.raises(ApiError, match="no answer within") as raised:
                await found.short("a", time.sleep, 3600.0)
            assert raised.value.status_code == 503
            assert (raised.value.headers or {})["retry-after"]

    asyncio.run(scenario())


def test_a_long_task_leaves_no_folder_behind() -> None:
    async def scenario() -> None:
        async with workers() as found:
            made: Any = unpacked(await found.apart("a", _folder))
            assert "wraparc-task-" in made
            assert not Path(made).exists()

    asyncio.run(scenario())


def _folder() -> str:
    import tempfile

    return tempfile.mkdtemp()
