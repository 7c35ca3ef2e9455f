"""Who works on what when: turns of clients, shared and abandoned questions, processes that die."""

import asyncio
import multiprocessing
import os
import pickle
import signal
import threading
import time
from collections.abc import AsyncIterator, Callable, Iterator
from contextlib import asynccontextmanager
from functools import partial
from pathlib import Path
from typing import Any

import pytest
from fastapi import Request

from web import tasks
from web.calculators import PATIENCE
from wraparc.errors import InputError
from wraparc.web import work
from wraparc.web.errors import ApiError
from wraparc.web.processes import EndedError, Parent, Worker, context, splits
from wraparc.web.progress import unheard
from wraparc.web.routes.parts import waited
from wraparc.web.turns import Turns
from wraparc.web.work import Workers

pytestmark = pytest.mark.processes
needs_splitting = pytest.mark.skipif(not splits(), reason="no process can be split here")


async def until(condition: Callable[[], bool]) -> None:
    """Wait until something holds."""
    async with asyncio.timeout(PATIENCE):
        while not condition():
            await asyncio.sleep(0.001)


@pytest.fixture(autouse=True)
def _cold(monkeypatch: pytest.MonkeyPatch) -> None:
    """Processes begin at once: what they solve beforehand is no matter here."""
    monkeypatch.setattr(work, "_warm", os.getpid)


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


@pytest.mark.parametrize("error", [OSError, EOFError])
def test_a_process_that_cannot_start_leaks_no_place(
    monkeypatch: pytest.MonkeyPatch, error: type[Exception]
) -> None:
    # EOFError: of multiprocessing, where the server that starts its processes ends meanwhile
    def broken(*_: object) -> None:
        raise error

    async def scenario() -> None:
        async with workers() as found:
            monkeypatch.setattr(Parent, "worker", broken)
            monkeypatch.setattr(Worker, "started", broken)
            for _ in range(300):  # more than may wait
                with pytest.raises(ApiError, match="503") as raised:
                    await found.short("a", os.getpid)
                assert "no process could be started" in raised.value.detail
            monkeypatch.undo()
            monkeypatch.setattr(work, "_warm", os.getpid)
            assert unpacked(await found.short("a", os.getpid)) != os.getpid()

    asyncio.run(scenario())


def test_the_same_question_is_computed_once(tmp_path: Path) -> None:
    async def scenario() -> None:
        async with workers(2) as found:
            asked = [found.short("a", tasks.note, str(tmp_path)) for _ in range(5)]
            answers = await asyncio.gather(*asked)
            assert len(set(answers)) == 1
            assert len(list(tmp_path.iterdir())) == 1

    asyncio.run(scenario())


def test_a_question_is_packed_off_the_event_loop() -> None:
    packed_in: list[int] = []

    class Question:
        def __reduce__(self) -> tuple[type, tuple[()]]:
            packed_in.append(threading.get_ident())
            return object, ()

    async def scenario() -> None:
        async with workers() as found:
            await found.short("a", id, Question())
            await found.apart("a", id, Question())
            assert len(packed_in) == 2
            assert threading.get_ident() not in packed_in

    asyncio.run(scenario())


def unpacked(answer: bytes) -> Any:
    return pickle.loads(answer)  # noqa: S301 - of a process of the test


def test_what_a_process_raises_comes_back_and_it_lives_on() -> None:
    async def scenario() -> None:
        async with workers() as found:
            before = await found.short("a", os.getpid)
            with pytest.raises(InputError, match="wrong"):
                await found.short("a", tasks.raises, "wrong")
            with pytest.raises(ApiError, match="ZeroDivisionError") as raised:
                await found.short("a", divmod, 1, 0)
            assert raised.value.status_code == 500
            with pytest.raises(ApiError, match="the disk of the server is full") as full:
                await found.short("a", tasks.fills)
            assert full.value.status_code == 507
            assert await found.short("a", os.getpid) == before

    asyncio.run(scenario())


def test_a_process_that_dies_costs_its_own_question_only(tmp_path: Path) -> None:
    gate = tmp_path / "go"

    async def scenario() -> None:
        async with workers(2) as found:
            other = asyncio.create_task(found.short("b", tasks.held, str(gate), queue=work.QUICK))
            with pytest.raises(ApiError, match="503"):
                await found.short("a", os._exit, 1, queue=work.QUICK)
            gate.write_text("")
            assert unpacked(await other) == "held"
            assert unpacked(await found.short("a", os.getpid, queue=work.QUICK))
            # one that dies while it has nothing to do costs nobody anything
            for worker in [worker for worker in found._all if worker.alive]:
                process: Any = worker._process
                os.kill(process.pid, signal.SIGKILL)
                await until(partial(lambda one: not one.alive, worker))
            assert unpacked(await found.short("a", os.getpid, queue=work.QUICK))

    asyncio.run(scenario())


@pytest.mark.parametrize("begun", [False, True], ids=["starting", "at work"])
def test_an_abandoned_solve_is_ended_and_makes_room(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, begun: bool
) -> None:
    monkeypatch.setattr(work, "LEFT_LIMIT", 0.0)

    async def scenario() -> None:
        async with workers() as found:
            left = asyncio.create_task(found.short("a", tasks.sleeps, str(tmp_path), 3600.0))
            behind = asyncio.create_task(found.short("a", tasks.sleeps, str(tmp_path), 3601.0))
            await until(lambda: found._turns[work.WHOLE].waiting == 1)
            await until(lambda: not begun or any(tmp_path.iterdir()))
            shared = [task for task, _ in found._shared.values()]
            for task in (left, behind):
                task.cancel()
            assert unpacked(await found.short("a", os.getpid))
            await until(lambda: all(task.done() for task in shared))
            assert [task.cancelled() for task in shared] == [True, True]  # not only late
            await until(lambda: len(multiprocessing.active_children()) == 1)

    asyncio.run(scenario())


def test_what_uses_more_processor_time_than_its_share_leaves_its_place(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    # expected: the only place is given to others, though the first is not answered yet; who waits
    # without working is moved nowhere
    monkeypatch.setattr(work, "BUDGET", 0.2)
    gate = tmp_path / "go"
    folder = tmp_path / "begun"
    folder.mkdir()

    async def scenario() -> None:
        async with workers() as found:
            first = asyncio.create_task(
                found.short("a", tasks.works, str(folder), str(gate), queue=work.QUICK)
            )
            await until(lambda: any(folder.iterdir()))
            others = [await found.short(who, os.getpid, queue=work.QUICK) for who in "ab"]
            assert not first.done()
            (busy,) = (one for one in found._all if one.stepped_back)
            assert {unpacked(one) for one in others} == {unpacked(others[0])}
            gate.write_text("")
            assert unpacked(await first) == "worked"
            assert busy.ended  # it was of its own
            assert len(found._idle[work.QUICK]) == 1
            gate.unlink()
            waits = asyncio.create_task(found.short("a", tasks.held, str(gate), queue=work.QUICK))
            await asyncio.sleep(5 * work.BUDGET)
            assert not any(one.stepped_back for one in found._all if not one.ended)
            gate.write_text("")
            assert unpacked(await waits) == "held"

    asyncio.run(scenario())


def test_who_asks_what_is_just_being_given_up_gets_an_answer(tmp_path: Path) -> None:
    gate = tmp_path / "go"

    async def scenario() -> None:
        async with workers() as found:
            left = asyncio.create_task(found.short("a", tasks.held, str(gate)))
            await until(lambda: any(not idle for idle in found._idle.values()) and bool(found._all))
            ((task, _),) = found._shared.values()
            task.cancel()  # as it is when nobody has waited for a while
            asked = asyncio.create_task(found.short("b", tasks.held, str(gate)))
            gate.write_text("")
            assert unpacked(await asked) == "held"
            with pytest.raises(asyncio.CancelledError):
                await left
            await until(lambda: not found._shared)

    asyncio.run(scenario())


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


def test_long_files_are_read_one_after_the_other(tmp_path: Path) -> None:
    gate, begun = tmp_path / "go", tmp_path / "begun"
    begun.mkdir()

    async def scenario() -> None:
        async with workers() as found:
            asked = [
                asyncio.create_task(
                    found.read(c, tasks.noted_and_held, str(begun), str(gate), limit=PATIENCE)
                )
                for c in "ab"
            ]
            await until(lambda: any(begun.iterdir()))
            assert found._reading.waiting == 1
            gate.write_text("")
            await asyncio.gather(*asked)
            assert len(list(begun.iterdir())) == 2

    asyncio.run(scenario())


def test_a_long_task_leaves_no_folder_behind() -> None:
    async def scenario() -> None:
        async with workers() as found:
            made: Any = unpacked(await found.apart("a", tasks.folder))
            assert "wraparc-task-" in made
            assert not Path(made).exists()

    asyncio.run(scenario())


@pytest.fixture
def parent(tmp_path: Path) -> Iterator[Parent]:
    found = Parent(context(), partial(tasks.note, str(tmp_path)))
    try:
        yield found
    finally:
        found.end()


async def asked(worker: Worker, function: Callable[..., Any], *given: Any) -> Any:
    return unpacked(await worker.ask(pickle.dumps((function, given)), unheard))


@needs_splitting
def test_what_is_split_off_is_prepared_once_and_ends_with_nobody_else(
    parent: Parent, tmp_path: Path
) -> None:
    async def scenario() -> None:
        first, second = parent.worker(), parent.worker()
        pids = [await asked(worker, os.getpid) for worker in (first, second)]
        assert len({*pids, os.getpid()}) == 3
        assert len(list(tmp_path.iterdir())) == 1
        with pytest.raises(EndedError):
            await asked(first, os._exit, 1)
        assert not first.alive
        assert await asked(second, os.getpid) == pids[1]
        second.end()
        await until(lambda: not Path(f"/proc/{pids[1]}").exists())  # cleared away too
        # what a process starts itself is waited for as everywhere
        third = parent.worker()
        assert await asked(third, tasks.exit_code, 3) == 3
        third.end()

    asyncio.run(scenario())


@needs_splitting
def test_a_parent_that_dies_is_started_again_and_its_workers_live_on(
    parent: Parent, tmp_path: Path
) -> None:
    async def scenario() -> None:
        before = parent.worker()
        os.kill(await asked(before, os.getppid), signal.SIGKILL)
        after = parent.worker()
        assert await asked(before, os.getpid) != await asked(after, os.getpid)
        assert len(list(tmp_path.iterdir())) == 2
        before.end()
        after.end()
        parent.end()
        with pytest.raises(ConnectionError):
            parent.worker()
        assert len(list(tmp_path.iterdir())) == 2

    asyncio.run(scenario())


@needs_splitting
def test_a_server_that_stops_waits_for_no_parent(tmp_path: Path) -> None:
    async def scenario() -> None:
        never = tmp_path / "never"
        parent = Parent(context(), partial(tasks.noted_and_held, str(tmp_path), str(never)))
        starting = asyncio.create_task(asyncio.to_thread(parent.worker))
        await until(lambda: any(tmp_path.iterdir()))
        parent.end()
        with pytest.raises(ConnectionError):
            await starting

    asyncio.run(scenario())


@needs_splitting
def test_what_solves_is_loaded_once_for_all_and_leaves_no_threads(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(work, "_warm", partial(tasks.note, str(tmp_path)))

    async def scenario() -> None:
        async with workers(2) as found:
            found.start()
            await found.filled
            parents = {unpacked(await found.short(c, os.getppid, queue=q)) for c, q in _PLACES}
            parents.add(unpacked(await found.apart("a", os.getppid)))
            assert len(parents) == len(list(tmp_path.iterdir())) == 1
            assert len(list(Path(f"/proc/{parents.pop()}/task").iterdir())) == 1

    asyncio.run(scenario())


_PLACES = (("a", work.QUICK), ("b", work.WHOLE))
