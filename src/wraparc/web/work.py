"""Where the work runs: processes that stay warm for short answers, one each for long tasks.

Every process has a connection of its own: one that dies, or is ended because its answer comes too
late or nobody waits for it any more, costs nobody else anything.
"""

import asyncio
import multiprocessing
import pickle
import shutil
import signal
import socket
import struct
import sys
import tempfile
import threading
from collections.abc import Callable
from contextlib import suppress
from typing import Any

from wraparc.errors import InputError, MissingExtraError
from wraparc.web.answers.shown import Answer
from wraparc.web.errors import ApiError, refusal_of
from wraparc.web.progress import Tell, tell_to, unheard
from wraparc.web.turns import Turns, busy

#: Queues of short answers, with processes of their own: sliders do not wait for whole answers.
QUICK, WHOLE = "quick", "whole"
#: Most seconds for a short answer, for a long one, and for one that nobody waits for any more.
SHORT_LIMIT, LONG_LIMIT, LEFT_LIMIT = 90.0, 600.0, 0.5
_LONG_TASKS, _MOST_WAITING = 2, 200
#: Most memory of a long task [bytes]: a file made to fill it all fills no more than this.
_MEMORY = 6 * 1024**3
_PRELOADED = (
    "wraparc.web.answers.drives",
    "wraparc.web.answers.compare",
    "wraparc.web.answers.trains",
)
Function = Callable[..., Any]
#: What goes between the processes: of which kind, how many bytes, and the bytes.
_HEAD = struct.Struct("!cQ")
_QUESTION, _DONE, _ERROR, _PROGRESS = b"q", b"d", b"e", b"p"


class EndedError(Exception):
    """The process that worked on an answer was ended, or died."""


def context() -> Any:
    """Return how processes are started: from a clean server where there is one, else anew."""
    methods = multiprocessing.get_all_start_methods()
    if "forkserver" not in methods or sys.platform == "darwin":
        return multiprocessing.get_context("spawn")
    found = multiprocessing.get_context("forkserver")
    found.set_forkserver_preload(list(_PRELOADED))
    return found


def answer(function: Function, *asked: Any) -> bytes:
    """Return what a function gives, as JSON unless it is bytes or to be pickled."""
    found = function(*asked)
    if isinstance(found, Answer):
        return found.model_dump_json().encode()
    return found if isinstance(found, bytes) else pickle.dumps(found)


class Worker:
    """A process that answers one question after the other.

    Parameters
    ----------
    start
        How processes are started.
    prepare
        What it does before the first question.

    Attributes
    ----------
    ended
        Whether it was ended.
    """

    def __init__(self, start: Any, prepare: Callable[[], None]) -> None:
        self._socket, theirs = _pair()
        self._process = start.Process(target=_serve, args=(theirs, prepare), daemon=True)
        self._process.start()
        self._streams: tuple[asyncio.StreamReader, asyncio.StreamWriter] | None = None
        self.ended = False
        theirs.close()

    @property
    def alive(self) -> bool:
        """Whether it can be asked: its end of the connection is open."""
        try:
            return not self.ended and bool(self._socket.recv(1, socket.MSG_PEEK))
        except BlockingIOError:  # open, and nothing said
            return True
        except OSError:
            return False

    async def ask(self, question: bytes, tell: Tell) -> bytes:
        """Wait for the answer to a pickled question.

        Raises
        ------
        InputError, MissingExtraError, ApiError
            As the function raises them; 500 for a fault.
        EndedError
            If the process ends before it has answered.
        """
        kind = _PROGRESS
        try:
            if self._streams is None:
                self._streams = await asyncio.open_connection(sock=self._socket)
            reader, writer = self._streams
            writer.write(_framed(_QUESTION, question))
            await writer.drain()
            while kind == _PROGRESS:
                said, size = _HEAD.unpack(await reader.readexactly(_HEAD.size))
                content = await reader.readexactly(size)
                kind = said
                if kind == _PROGRESS:
                    tell(*pickle.loads(content))  # noqa: S301 - from our own process
        except (EOFError, OSError):
            raise EndedError from None
        finally:
            if kind == _PROGRESS:  # it is late, or nobody waits for the rest
                self.end()
        if kind == _ERROR:
            raise pickle.loads(content)  # noqa: S301 - from our own process
        return content

    def end(self) -> None:
        """End the process."""
        self.ended = True
        self._process.kill()
        if self._streams is None:
            self._socket.close()
        else:
            with suppress(RuntimeError):  # of a server that has ended, with its connections
                self._streams[1].transport.abort()


def _pair() -> tuple[socket.socket, socket.socket]:
    """Return two sockets that speak to each other, and to nobody else.

    Raises
    ------
    OSError
        If another program has come between them, as can be where they have a port.
    """
    ours, theirs = socket.socketpair()
    crossed = ours.getsockname(), theirs.getsockname()
    if crossed != (theirs.getpeername(), ours.getpeername()):
        ours.close()
        theirs.close()
        raise ConnectionError("another program has connected to a process of the server")
    ours.setblocking(False)
    return ours, theirs


class Workers:
    """Everything that computes.

    Parameters
    ----------
    count
        Processes for quick answers; 0 to do everything in threads of this process, where nothing
        can be ended.

    Attributes
    ----------
    compiled
        Whether the processes solve by compiled code by now.
    filled
        Done once the processes are started.
    """

    def __init__(self, count: int) -> None:
        self._count, self._context = count, context()
        self.compiled = self._stopped = False
        self._sizes = {QUICK: max(1, count), WHOLE: max(2, count // 2)}
        self._turns = {
            QUICK: Turns(self._sizes[QUICK], self._sizes[QUICK], _MOST_WAITING),
            WHOLE: Turns(self._sizes[WHOLE], self._sizes[WHOLE] - 1, _MOST_WAITING),
        }
        self._long = Turns(_LONG_TASKS, _LONG_TASKS - 1, _MOST_WAITING)
        self._idle: dict[str, list[Worker]] = {QUICK: [], WHOLE: []}
        self._all: set[Worker] = set()
        self._shared: dict[bytes, tuple[asyncio.Task[bytes], list[object]]] = {}
        self._tasks: set[asyncio.Task[None]] = set()

    def start(self) -> None:
        """Start the processes, and others with compiled code that take their place later."""
        if self._count:
            self.filled = asyncio.create_task(self._fill())
            self._tasks = {self.filled, asyncio.create_task(self._compile())}

    async def _fill(self) -> None:
        for queue, size in self._sizes.items():
            self._idle[queue] += [await self._started() for _ in range(size)]

    async def _started(self, prepare: Callable[[], None] | None = None) -> Worker:
        ready = prepare or (_warm_compiled if self.compiled else _warm)
        loop = asyncio.get_running_loop()
        starting = loop.run_in_executor(None, Worker, self._context, ready)
        try:
            worker = await asyncio.shield(starting)
        except asyncio.CancelledError:
            starting.add_done_callback(_end)
            raise
        self._all = {one for one in self._all if not one.ended} | {worker}
        if self._stopped:
            worker.end()
        return worker

    async def _compile(self) -> None:
        """Compile once on this machine; then put processes that have loaded it in the place."""
        from wraparc.web.warm import compile_kernel

        try:
            if not pickle.loads(await self.apart("", compile_kernel)):  # noqa: S301 - our own
                return
            new = {
                q: [await self._started(_warm_compiled) for _ in range(n)]
                for q, n in self._sizes.items()
            }
            for worker in [worker for workers in new.values() for worker in workers]:
                await self._asked(worker, pickle.dumps((bytes, ())), None)  # until it is ready
        except (ApiError, OSError):
            return  # the interpreter does it too
        old, self._idle, self.compiled = self._idle, new, True
        for worker in [worker for workers in old.values() for worker in workers]:
            worker.end()

    def stop(self) -> None:
        """End the processes."""
        self._stopped = True
        while self._tasks:
            self._tasks.pop().cancel()
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
            503 if too many wait, if it takes too long, or its process died.
        """
        if not self._count:
            return await asyncio.to_thread(answer, function, *asked)
        question = pickle.dumps((function, asked))
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
        async with self._turns[queue].turn(client):
            compiled, idle = self.compiled, self._idle[queue]
            worker = idle.pop() if idle else await self._started()
            if not worker.alive:  # it died while it had nothing to do
                worker.end()
                worker = await self._started()
            try:
                return await self._asked(worker, question, SHORT_LIMIT)
            finally:
                if not worker.ended and compiled == self.compiled:
                    self._idle[queue].append(worker)
                else:
                    worker.end()

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
            worker = await self._started(_Alone(folder))
            try:
                return await self._asked(worker, pickle.dumps((function, asked)), limit, tell)
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


def _warm_compiled() -> None:
    from wraparc.web.warm import warm

    warm(compiled=True)


class _Alone:
    """What the process of a long task does first: it gets a folder, and limits."""

    def __init__(self, folder: str) -> None:
        self._folder = folder

    def __call__(self) -> None:
        tempfile.tempdir = self._folder
        try:
            import resource
        except ImportError:  # Windows
            return
        soft, hard = resource.getrlimit(resource.RLIMIT_AS)
        if soft == resource.RLIM_INFINITY or soft > _MEMORY:
            with suppress(OSError, ValueError):  # macOS limits no memory
                resource.setrlimit(resource.RLIMIT_AS, (_MEMORY, hard))


def _serve(connection: socket.socket, prepare: Callable[[], None]) -> None:
    """Answer until nobody asks any more."""
    if threading.current_thread() is threading.main_thread():
        signal.signal(signal.SIGINT, signal.SIG_IGN)  # the server ends its processes itself
    prepare()
    tell_to(lambda *content: connection.sendall(_framed(_PROGRESS, pickle.dumps(content))))
    with suppress(OSError), connection.makefile("rb") as stream:
        while head := stream.read(_HEAD.size):
            _, size = _HEAD.unpack(head)
            connection.sendall(_framed(*_told(stream.read(size))))


def _told(question: bytes) -> tuple[bytes, bytes]:
    """Return the answer to a pickled question and of which kind it is."""
    try:
        function, asked = pickle.loads(question)  # noqa: S301 - from the server itself
        return _DONE, answer(function, *asked)
    except (InputError, MissingExtraError, ApiError) as error:
        return _ERROR, pickle.dumps(error)
    except Exception as error:  # noqa: BLE001 - told to whoever waits
        return _ERROR, pickle.dumps(refusal_of(error))


def _framed(kind: bytes, content: bytes) -> bytes:
    return _HEAD.pack(kind, len(content)) + content
