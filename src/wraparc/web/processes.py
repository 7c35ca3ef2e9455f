"""Processes that answer one question after the other, and how they come into being.

What solves is loaded once, by a parent from which processes are split off: what they share stands
in memory once. Windows and macOS cannot split; there each loads for itself.
"""

import asyncio
import gc
import multiprocessing
import os
import pickle
import signal
import socket
import struct
import sys
import threading
import time
from collections.abc import Callable
from contextlib import suppress
from typing import Any, Protocol

from wraparc.errors import InputError, MissingExtraError
from wraparc.web.answers.shown import Answer
from wraparc.web.errors import ApiError, refusal_of
from wraparc.web.progress import Tell, tell_to

_PRELOADED = (
    "wraparc.web.answers.drives",
    "wraparc.web.answers.compare",
    "wraparc.web.answers.trains",
)
#: What goes between the processes: of which kind, how many bytes, and the bytes.
_HEAD = struct.Struct("!cQ")
_QUESTION, _DONE, _ERROR, _PROGRESS = b"q", b"d", b"e", b"p"
#: What a parent says of a process that it has split off: its number.
_SPLIT = struct.Struct("!q")
Function = Callable[..., Any]
Prepare = Callable[[], object]


class EndedError(Exception):
    """The process that worked on an answer was ended, or died."""


def context() -> Any:
    """Return how processes are started: from a clean server where there is one, else anew."""
    if not splits():
        return multiprocessing.get_context("spawn")
    found = multiprocessing.get_context("forkserver")
    found.set_forkserver_preload(list(_PRELOADED))
    return found


def splits() -> bool:
    """Whether a process can be split in two here, with what it has loaded."""
    return "forkserver" in multiprocessing.get_all_start_methods() and sys.platform != "darwin"


def answer(function: Function, *asked: Any) -> bytes:
    """Return what a function gives, as JSON unless it is bytes or to be pickled."""
    found = function(*asked)
    if isinstance(found, Answer):
        return found.model_dump_json().encode()
    return found if isinstance(found, bytes) else pickle.dumps(found)


class _Process(Protocol):
    """What can be ended at once."""

    @property
    def pid(self) -> int | None: ...

    def kill(self) -> None: ...


class Worker:
    """A process that answers one question after the other.

    Parameters
    ----------
    connection
        Our end of the connection to it.
    process
        The process.

    Attributes
    ----------
    ended
        Whether it was ended.
    stepped_back
        Whether it goes on behind the other processes.
    """

    def __init__(self, connection: socket.socket, process: _Process) -> None:
        self._socket, self._process = connection, process
        self._streams: tuple[asyncio.StreamReader, asyncio.StreamWriter] | None = None
        self.ended = self.stepped_back = False
        connection.setblocking(False)

    @classmethod
    def started(cls, start: Any, prepare: Prepare) -> "Worker":
        """Return one that was started anew, and prepares itself before its first question."""
        return cls(*_started(start, _serve, prepare))

    @property
    def alive(self) -> bool:
        """Whether it can be asked: its end of the connection is open."""
        try:
            return not self.ended and bool(self._socket.recv(1, socket.MSG_PEEK))
        except BlockingIOError:  # open, and nothing said
            return True
        except OSError:
            return False

    def processor_time(self) -> float:
        """Return the processor time that it has used [s]; where none is told, the time."""
        try:
            with open(f"/proc/{self._process.pid}/stat", "rb") as file:
                used = file.read().rpartition(b")")[2].split()[11:13]
            return sum(map(int, used)) / os.sysconf("SC_CLK_TCK")
        except (OSError, ValueError, AttributeError):  # no Linux, or it has just ended
            return time.monotonic()

    def step_back(self) -> None:
        """Let the other processes go first, from now on."""
        self.stepped_back = True
        with suppress(OSError, AttributeError):  # AttributeError: Windows
            if self._process.pid:
                os.setpriority(os.PRIO_PROCESS, self._process.pid, 10)

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


class Parent:
    """A process that prepares itself once; workers split off from it share what it has loaded.

    It is started when the first worker is wanted, and again if it has died. It must have no
    threads: what they hold when a worker is split off would never be let go of in it.

    Parameters
    ----------
    start
        How it is started.
    prepare
        What it does first.
    """

    def __init__(self, start: Any, prepare: Prepare) -> None:
        self._start, self._prepare = start, prepare
        self._alone, self._ended = threading.Lock(), threading.Event()
        self._socket: socket.socket | None = None
        self._process: _Process | None = None

    def worker(self) -> Worker:
        """Return a worker split off; it waits until the parent has prepared itself.

        Raises
        ------
        OSError, EOFError
            If there is none to be had.
        """
        again = True
        with self._alone:
            while True:
                try:
                    return self._split()
                except (OSError, EOFError):  # EOFError: what starts processes is just ending
                    self._forget()
                    if self._ended.is_set() or not again:
                        raise
                    again = False

    def _split(self) -> Worker:
        if self._ended.is_set():
            raise ConnectionAbortedError("the server is being stopped")
        if self._socket is None:
            self._socket, self._process = _started(self._start, _splits_off, self._prepare)
            if self._ended.is_set():  # meanwhile
                self._process.kill()
        ours, theirs = _pair()
        with theirs:
            try:
                socket.send_fds(self._socket, [_QUESTION], [theirs.fileno()])
                said = self._socket.recv(_SPLIT.size, socket.MSG_WAITALL)
                if len(said) < _SPLIT.size:
                    raise ConnectionResetError("the process to split others from has ended")
            except OSError:
                ours.close()
                raise
        return Worker(ours, _SplitOff(*_SPLIT.unpack(said)))

    def _forget(self) -> None:
        if self._socket is not None and self._process is not None:
            self._process.kill()
            self._socket.close()
            self._socket = None

    def end(self) -> None:
        """End the process, for good."""
        self._ended.set()
        if self._process is not None:
            self._process.kill()
        if self._alone.acquire(blocking=False):  # else who waits for it hears that it has ended
            self._forget()
            self._alone.release()


class _SplitOff:
    """A process that is nobody's child here."""

    def __init__(self, pid: int) -> None:
        self.pid = pid

    def kill(self) -> None:
        """End it at once."""
        with suppress(ProcessLookupError):
            os.kill(self.pid, signal.SIGKILL)


def _started(
    start: Any, serve: Callable[..., None], prepare: Prepare
) -> tuple[socket.socket, _Process]:
    """Start a process that serves what comes over a connection; return our end of it, and it."""
    ours, theirs = _pair()
    with theirs:
        process = start.Process(target=serve, args=(theirs, prepare), daemon=True)
        process.start()
    return ours, process


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
    return ours, theirs


def _serve(connection: socket.socket, prepare: Prepare) -> None:
    """Answer until nobody asks any more."""
    _ignore_interrupts()
    prepare()
    tell_to(lambda *content: connection.sendall(_framed(_PROGRESS, pickle.dumps(content))))
    with suppress(OSError), connection.makefile("rb") as stream:
        while head := stream.read(_HEAD.size):
            _, size = _HEAD.unpack(head)
            connection.sendall(_framed(*_told(stream.read(size))))


def _splits_off(connection: socket.socket, prepare: Prepare) -> None:
    """Split off a process for each connection that comes, until nobody asks any more."""
    _ignore_interrupts()
    prepare()
    gc.collect()
    gc.freeze()  # a collector that looks at what is shared would write to it
    cleared = signal.signal(signal.SIGCHLD, signal.SIG_IGN)  # who has ended is cleared away
    with suppress(OSError):
        while given := socket.recv_fds(connection, len(_QUESTION), 1)[1]:
            pid = os.fork()
            if not pid:
                try:
                    connection.close()
                    signal.signal(signal.SIGCHLD, cleared)
                    _serve(socket.socket(fileno=given[0]), os.getpid)
                finally:
                    os._exit(0)
            os.close(given[0])
            connection.sendall(_SPLIT.pack(pid))


def _ignore_interrupts() -> None:
    """Leave Ctrl-C to the server: it ends its processes itself."""
    if threading.current_thread() is threading.main_thread():
        signal.signal(signal.SIGINT, signal.SIG_IGN)


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
