"""Where the work runs: worker processes for short answers, one process each for long tasks.

Short answers (a solve) go to a pool that stays warm. A long task (a fit, a study) gets a process
of its own, so that it can be followed, cancelled and limited in time, and never stands in the way
of anybody else.
"""

import asyncio
import multiprocessing
import shutil
import signal
import sys
import tempfile
import threading
import time
from collections.abc import Callable
from concurrent.futures import BrokenExecutor, Executor, ProcessPoolExecutor, ThreadPoolExecutor
from importlib import import_module
from multiprocessing.connection import Connection
from typing import Any

from wraparc.errors import InputError, MissingExtraError, Problem
from wraparc.web.errors import ApiError, Data, json_bytes, refused

#: Queues of short answers, with processes of their own.
QUICK, WHOLE = "quick", "whole"
#: Most seconds for a short answer, and for a long one.
SHORT_LIMIT, LONG_LIMIT = 90.0, 600.0
_MOST_WAITING, _MOST_LONG_WAITING = 200, 40
#: Most memory of a long task [bytes]: a file made to fill it all fills no more than this.
_MEMORY = 6 * 1024**3
_PRELOADED = (
    "wraparc.web.answers.drives",
    "wraparc.web.answers.compare",
    "wraparc.web.answers.trains",
)


def context() -> Any:
    """Return how processes are started: from a clean server where there is one, else anew."""
    methods = multiprocessing.get_all_start_methods()
    if "forkserver" not in methods or sys.platform == "darwin":
        return multiprocessing.get_context("spawn")
    found = multiprocessing.get_context("forkserver")
    found.set_forkserver_preload(list(_PRELOADED))
    return found


def answer(where: str, request: Data) -> bytes:
    """Return the answer of ``module:function`` to a request, as JSON unless it is bytes."""
    module, _, function = where.partition(":")
    found = getattr(import_module(module), function)(request)
    return found if isinstance(found, bytes) else json_bytes(found)


def _here(where: str, request: Data) -> bytes:
    """Do a long task in this process."""
    with tempfile.TemporaryDirectory(prefix="wraparc-task-") as folder:
        return answer(where, {**request, "folder": folder, "progress": _ignored})


def _warm(compiled: bool = False) -> None:
    from wraparc.web.warm import warm

    _leave_interrupts()
    warm(compiled=compiled)


def _leave_interrupts() -> None:
    """Ctrl-C goes to every process of a terminal; the server ends the others itself."""
    if threading.current_thread() is threading.main_thread():
        signal.signal(signal.SIGINT, signal.SIG_IGN)


def _nothing() -> None:
    time.sleep(0.05)  # long enough for every process to be started for one of these


class Workers:
    """The pool for short answers, and the count of long tasks.

    Parameters
    ----------
    count
        Processes for short answers; 0 to do everything in threads of this process, where nothing
        can be ended.
    long_tasks
        Long tasks that may run at the same time.

    Attributes
    ----------
    compiled
        Whether the processes solve by compiled code by now.
    """

    def __init__(self, count: int, long_tasks: int = 2) -> None:
        self._count = count
        self._context = context()
        self._pools: dict[str, Executor] = {}
        self._compiled = self._stopped = False
        self.compiled = False
        self._lock = threading.Lock()
        self._waiting = 0
        self._long = asyncio.Semaphore(long_tasks)
        self._long_waiting = 0

    def _executor(self, queue: str) -> Executor:
        with self._lock:
            if queue not in self._pools:
                self._pools[queue] = self._made(queue)
            return self._pools[queue]

    def _made(self, queue: str) -> Executor:
        if not self._count:
            return ThreadPoolExecutor(4, thread_name_prefix=queue)
        count = self._count if queue == QUICK else max(1, self._count // 2)
        return ProcessPoolExecutor(
            count, mp_context=self._context, initializer=_warm, initargs=(self._compiled,)
        )

    def start(self) -> None:
        """Start the processes, and others with compiled code that take their place later."""
        if self._count:
            for queue in (QUICK, WHOLE):
                self._filled(self._executor(queue))
            threading.Thread(target=self._compile, daemon=True).start()

    def _filled(self, pool: Executor) -> list[Any]:
        return [pool.submit(_nothing) for _ in range(self._count)]

    def _compile(self) -> None:
        """Compile once on this machine; then put processes that have loaded it in the place."""
        try:
            task = Task(self._context, "wraparc.web.warm:compile_kernel", {}, _ignored)
            if task.result() != b"true":
                return
            self._compiled = True
            pools = {queue: self._made(queue) for queue in (QUICK, WHOLE)}
            for ready in [future for pool in pools.values() for future in self._filled(pool)]:
                ready.result()
        except (CancelledTaskError, ApiError, BrokenExecutor, OSError, RuntimeError):
            return  # the interpreter does it too
        with self._lock:
            old = pools if self._stopped else self._pools
            self._pools = {} if self._stopped else pools
            self.compiled = True
        for pool in old.values():
            pool.shutdown(wait=False)

    def stop(self) -> None:
        """End the processes."""
        with self._lock:
            self._stopped = True
            pools, self._pools = list(self._pools.values()), {}
        for pool in pools:
            pool.shutdown(wait=False, cancel_futures=True)

    async def short(self, where: str, request: Data, queue: str = WHOLE) -> bytes:
        """Return the answer to a request, computed apart from this thread.

        Parameters
        ----------
        where
            ``module:function``.
        request
            What the function gets.
        queue
            `QUICK` for what must not wait behind larger work.

        Raises
        ------
        InputError
            As the function raises it.
        ApiError
            503 if too many wait, if it takes too long, or a worker died.
        """
        if self._waiting >= _MOST_WAITING:
            raise refused(503, "too many requests are waiting", "Try again in a moment.")
        self._waiting += 1
        pool = self._executor(queue)
        try:
            future = asyncio.get_running_loop().run_in_executor(pool, answer, where, request)
            return await asyncio.wait_for(future, SHORT_LIMIT)
        except BrokenExecutor:
            self._forget(pool)
            raise refused(503, "the process that worked on this has ended", "Try again.") from None
        except TimeoutError:
            self._replace(pool)
            message = f"no answer within {SHORT_LIMIT:g} s"
            raise refused(503, message, "Change a value, and report the drive file.") from None
        finally:
            self._waiting -= 1

    def _forget(self, pool: Executor) -> None:
        with self._lock:
            self._pools = {name: one for name, one in self._pools.items() if one is not pool}

    def _replace(self, pool: Executor) -> None:
        """Give up a pool with a process that does not come back."""
        self._forget(pool)
        for process in list((getattr(pool, "_processes", None) or {}).values()):
            process.kill()
        pool.shutdown(wait=False, cancel_futures=True)

    async def long(self, where: str, request: Data, limit: float = LONG_LIMIT) -> bytes:
        """Return the answer to a request that may take long, from a process of its own."""
        if self._long_waiting >= _MOST_LONG_WAITING:
            message = "too many long tasks are waiting"
            raise refused(503, message, "Try again when they are done.")
        self._long_waiting += 1
        try:
            async with self._long:
                if not self._count:
                    return await asyncio.to_thread(_here, where, request)
                return await self._apart(where, request, limit)
        finally:
            self._long_waiting -= 1

    async def _apart(self, where: str, request: Data, limit: float) -> bytes:
        task = await asyncio.to_thread(self.task, where, request, _ignored)
        try:
            return await asyncio.wait_for(asyncio.to_thread(task.result), limit)
        except TimeoutError:
            raise refused(503, f"no answer within {limit:g} s", "Ask for less.") from None
        except CancelledTaskError:
            message = "the process that worked on this has ended; it may have lacked memory"
            raise refused(503, message, "Ask for less.") from None
        finally:
            task.cancel()

    def task(self, where: str, request: Data, progress: Callable[[int, int, str], None]) -> "Task":
        """Start a task that tells of its progress; the function gets a callback for it."""
        return Task(self._context, where, request, progress)


def _ignored(done: int, total: int, message: str = "") -> None:
    """Progress that nobody asks for."""


class CancelledTaskError(Exception):
    """The process of a task was ended."""


class Task:
    """A function that runs in a process of its own.

    Its request gets a ``folder`` that goes when it ends, however it does, and a function
    ``progress`` to tell (done, in all, message).
    """

    def __init__(
        self,
        start: Any,
        where: str,
        request: Data,
        progress: Callable[[int, int, str], None],
    ) -> None:
        self._progress = progress
        self._folder = tempfile.mkdtemp(prefix="wraparc-task-")
        request = {**request, "folder": self._folder}
        self._receiver, sender = start.Pipe(duplex=False)
        self._process = start.Process(
            target=_run_task, args=(where, request, sender), daemon=True, name="wraparc task"
        )
        self._process.start()
        sender.close()

    def result(self) -> bytes:
        """Wait for the answer.

        Raises
        ------
        InputError
            As the function raises it.
        CancelledTaskError
            If the process was ended.
        """
        try:
            while True:
                kind, *content = self._receiver.recv()
                if kind == "progress":
                    self._progress(*content)
                elif kind == "done":
                    return bytes(content[0])
                elif kind == "fault":
                    raise ApiError(500, Problem(message=content[0]))
                else:
                    raise content[0]
        except (EOFError, OSError):
            raise CancelledTaskError from None
        finally:
            self._process.join(timeout=5.0)
            self._receiver.close()
            shutil.rmtree(self._folder, ignore_errors=True)

    def cancel(self) -> None:
        """End the process."""
        if self._process.is_alive():
            self._process.kill()


def _limit_memory() -> None:
    try:
        import resource
    except ImportError:  # Windows
        return
    soft, hard = resource.getrlimit(resource.RLIMIT_AS)
    if soft == resource.RLIM_INFINITY or soft > _MEMORY:
        resource.setrlimit(resource.RLIMIT_AS, (_MEMORY, hard))


def _run_task(where: str, request: Data, sender: Connection) -> None:
    module, _, function = where.partition(":")
    _leave_interrupts()
    _limit_memory()

    def progress(done: int, total: int, message: str = "") -> None:
        sender.send(("progress", done, total, message))

    try:
        data = getattr(import_module(module), function)({**request, "progress": progress})
        sender.send(("done", json_bytes(data)))
    except (InputError, MissingExtraError, ApiError) as error:
        sender.send(("error", error))
    except Exception as error:  # noqa: BLE001 - told to whoever waits
        sender.send(("fault", f"a fault in the program ({type(error).__name__})"))
    finally:
        sender.close()
