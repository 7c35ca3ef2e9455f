"""Where the work runs: processes that stay warm for short answers, one each for long tasks.

Every process has a connection of its own: one that dies, or is ended because its answer comes too
late or nobody waits for it any more, costs nobody else anything.
"""

import asyncio
import os
import pickle
import shutil
import tempfile
from contextlib import AsyncExitStack, suppress
from functools import partial
from typing import Any

from wraparc.web.processes import EndedError, Function, Parent, Worker, answer, context, splits
from wraparc.web.progress import Tell, unheard
from wraparc.web.turns import Turns, busy

#: Queues of short answers, with processes of their own: sliders do not wait for whole answers.
QUICK, WHOLE = "quick", "whole"
#: Most seconds for a short answer, for a long one, and for one that nobody waits for any more.
SHORT_LIMIT, LONG_LIMIT, LEFT_LIMIT = 90.0, 600.0, 0.5
#: A short answer that has taken so long, and as much processor time again [s], goes on in a worker
#: of its own: its place is for others.
BUDGET = 1.0
_MOST_MOVED = 4
#: Most seconds of a job, which goes on by itself until it is cancelled: a study, a run in time.
JOB_LIMIT = 4 * 3600.0
_LONG_TASKS, _MOST_WAITING = 2, 200
#: Most memory of a long task [bytes]: a file made to fill it all fills no more than this.
_MEMORY = 6 * 1024**3


class Workers:
    """Everything that computes.

    Parameters
    ----------
    count
        Processes for quick answers; 0 to do everything in threads of this process, where nothing
        can be ended.

    Attributes
    ----------
    filled
        Done once the processes are started.
    """

    def __init__(self, count: int) -> None:
        self._count, self._context = count, context()
        self._parent = Parent(self._context, _warm) if splits() else None
        self._stopped = False
        self._sizes = {QUICK: max(1, count), WHOLE: max(2, count // 2)}
        self._turns = {
            QUICK: Turns(self._sizes[QUICK], self._sizes[QUICK], _MOST_WAITING),
            WHOLE: Turns(self._sizes[WHOLE], self._sizes[WHOLE] - 1, _MOST_WAITING),
        }
        self._moved = Turns(_MOST_MOVED, _MOST_MOVED // 2, _MOST_WAITING)
        self._long = Turns(_LONG_TASKS, _LONG_TASKS - 1, _MOST_WAITING)
        self._reading = Turns(1, 1, _MOST_WAITING)
        self._idle: dict[str, list[Worker]] = {QUICK: [], WHOLE: []}
        self._all: set[Worker] = set()
        self._shared: dict[bytes, tuple[asyncio.Task[bytes], list[object]]] = {}
        self._tasks: set[asyncio.Task[None]] = set()

    def start(self) -> None:
        """Start the processes."""
        if self._count:
            self.filled = asyncio.create_task(self._fill())
            self._tasks = {self.filled}

    async def _fill(self) -> None:
        for queue, size in self._sizes.items():
            self._idle[queue] += [await self._started() for _ in range(size)]

    async def _started(self, *, warm: bool = True) -> Worker:
        """Start a process; it is warm if it has solved before its first question."""
        if self._parent:
            begin = self._parent.worker
        else:
            begin = partial(Worker.started, self._context, _warm if warm else os.getpid)
        loop = asyncio.get_running_loop()
        starting = loop.run_in_executor(None, begin)
        try:
            worker = await asyncio.shield(starting)
        except asyncio.CancelledError:
            starting.add_done_callback(_end)
            raise
        except (OSError, EOFError):
            raise busy("no process could be started to work on this", "Try again.") from None
        self._all = {one for one in self._all if not one.ended} | {worker}
        if self._stopped:
            worker.end()
        return worker

    def stop(self) -> None:
        """End the processes."""
        self._stopped = True
        while self._tasks:
            self._tasks.pop().cancel()
        if self._parent:
            self._parent.end()
        for worker in self._all:
            worker.end()

    async def short(
        self, client: str, function: Function, *asked: Any, queue: str = WHOLE
    ) -> bytes:
        """Return the answer to a question; who asks the same at the same time shares it.

        Parameters
        ----------
        client
            Who asks: clients take turns.
        function, asked
            What is called with what.
        queue
            `QUICK` for what must not wait behind larger work.

        Raises
        ------
        InputError
            As the function raises it.
        ApiError
            503 if too many wait, if it takes too long, or its process died or did not start.
        """
        if not self._count:
            return await asyncio.to_thread(answer, function, *asked)
        question = await asyncio.to_thread(pickle.dumps, (function, asked))
        task, waiting = self._shared.get(question, (None, []))
        if task is None or task.cancelling():  # what is given up gives nobody an answer
            task, waiting = asyncio.create_task(self._short(client, question, queue)), []
            self._shared[question] = task, waiting
            task.add_done_callback(lambda done: self._forget(question, done))
        me = object()
        waiting.append(me)
        try:
            return await asyncio.shield(task)
        finally:
            waiting.remove(me)
            if not waiting and not task.done():
                loop = asyncio.get_running_loop()
                loop.call_later(LEFT_LIMIT, lambda: None if waiting else task.cancel())

    def _forget(self, question: bytes, task: asyncio.Task[bytes]) -> None:
        if self._shared.get(question, (None,))[0] is task:
            del self._shared[question]
        if not task.cancelled():
            task.exception()  # told to whoever still waits

    async def _short(self, client: str, question: bytes, queue: str) -> bytes:
        async with AsyncExitStack() as place:
            await place.enter_async_context(self._turns[queue].turn(client))
            idle = self._idle[queue]
            worker = idle.pop() if idle else await self._started()
            if not worker.alive:  # it died while it had nothing to do
                worker.end()
                worker = await self._started()
            moves: list[asyncio.Task[None]] = []
            late = asyncio.get_running_loop().call_later(
                BUDGET, lambda: moves.append(asyncio.create_task(self._move(worker, client, place)))
            )
            try:
                return await self._asked(worker, question, SHORT_LIMIT)
            finally:
                late.cancel()
                for move in moves:
                    move.cancel()
                if worker.stepped_back:
                    worker.end()
                elif not worker.ended:
                    self._idle[queue].append(worker)

    async def _move(self, worker: Worker, client: str, place: AsyncExitStack) -> None:
        """Let a process that takes long be that of one question, behind others; until cancelled.

        Parameters
        ----------
        worker
            What works on the question.
        client
            Whose it is: only some of one client are moved, the others go on where they are.
        place
            Its place among short answers, which is given back.
        """
        begin = worker.processor_time()
        while worker.processor_time() - begin < BUDGET:
            await asyncio.sleep(BUDGET / 10)
        async with self._moved.turn(client):
            worker.step_back()
            await place.aclose()
            await asyncio.Event().wait()

    async def _asked(
        self, worker: Worker, question: bytes, limit: float | None, tell: Tell = unheard
    ) -> bytes:
        """Ask a process; it is ended if the answer is late or nobody waits for it."""
        try:
            async with asyncio.timeout(limit):
                return await worker.ask(question, tell)
        except TimeoutError:
            raise busy(f"no answer within {limit:g} s", "Ask for less.", 60) from None
        except EndedError:
            message = "the process that worked on this has ended, perhaps for want of memory"
            raise busy(message, "Try again, or ask for less.") from None

    async def long(
        self, client: str, function: Function, *asked: Any, limit: float | None = LONG_LIMIT
    ) -> bytes:
        """Return an answer that may take long, from a process of its own."""
        async with self._long.turn(client):
            return await self.apart(client, function, *asked, limit=limit)

    async def read(self, client: str, function: Function, *asked: Any, limit: float) -> bytes:
        """Return an answer out of files: one such at a time, for a long file fills much memory."""
        async with self._reading.turn(client):
            return await self.apart(client, function, *asked, limit=limit)

    async def apart(
        self,
        client: str,
        function: Function,
        *asked: Any,
        limit: float | None = None,
        tell: Tell = unheard,
    ) -> bytes:
        """Return an answer from a process of its own, with a folder that goes when it ends."""
        if not self._count:
            return await asyncio.to_thread(answer, function, *asked)
        folder = tempfile.mkdtemp(prefix="wraparc-task-")
        try:
            worker = await self._started(warm=False)
            try:
                alone = (_alone, (folder, function, *asked))
                question = await asyncio.to_thread(pickle.dumps, alone)
                return await self._asked(worker, question, limit, tell)
            finally:
                worker.end()
        finally:
            await asyncio.to_thread(shutil.rmtree, folder, ignore_errors=True)


def _end(started: asyncio.Future[Worker]) -> None:
    if not started.cancelled() and not started.exception():
        started.result().end()


def _warm() -> None:
    from wraparc.web.warm import warm

    warm()


def _alone(folder: str, function: Function, *asked: Any) -> Any:
    """Do a long task, in a process of its own: it gets a folder, and limits."""
    tempfile.tempdir = folder
    with suppress(ImportError):  # Windows
        import resource

        soft, hard = resource.getrlimit(resource.RLIMIT_AS)
        if soft == resource.RLIM_INFINITY or soft > _MEMORY:
            with suppress(OSError, ValueError):  # macOS limits no memory
                resource.setrlimit(resource.RLIMIT_AS, (_MEMORY, hard))
    return function(*asked)
