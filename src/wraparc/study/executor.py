"""Where the parts of a study are solved: threads of this process, or a Dask cluster."""

from __future__ import annotations

import logging
import os
import re
import socket
from collections.abc import Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, CancelledError, Future, ThreadPoolExecutor, wait
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from itertools import islice
from threading import Event
from time import monotonic
from typing import Any, NamedTuple, Protocol

from wraparc.errors import InputError, MissingExtraError, Problem, input_error, shown
from wraparc.study.parameter_study import Study
from wraparc.study.parquet import solve_part
from wraparc.version import __version__

_ADDRESS = re.compile(r"(?:tcp|tls)://(\[[0-9a-fA-F:]+\]|[^:/\s]{1,253}):([0-9]{1,5})")

#: Seconds that a cluster may be without workers, and between two looks whether it has any.
_WITHOUT_WORKERS, _LOOK = 60.0, 1.0


class Part(NamedTuple):
    """A range of designs."""

    start: int
    stop: int


Solved = Iterator[tuple[Part, bytes]]


class Executor(Protocol):
    """What solves parts; each comes back as a Parquet file, in any order."""

    def check(self) -> None:
        """Raise `InputError` if it cannot work, before anything is done."""

    def solve(self, study: Study, parts: Sequence[Part]) -> Solved:
        """Solve parts; closing the iterator drops those not begun."""


class _StoppedError(Exception):
    """The work was given up."""


@dataclass(frozen=True)
class Threads:
    """Threads of this process.

    Attributes
    ----------
    count
        How many; one a processor if None.
    """

    count: int | None = None

    @property
    def workers(self) -> int:
        """How many there are."""
        return self.count or os.cpu_count() or 1

    def check(self) -> None:
        """Refuse fewer than one."""
        if self.count is not None and self.count < 1:
            text = str(self.count)
            raise input_error(key="threads", value=text, message="must be at least 1")

    def solve(self, study: Study, parts: Sequence[Part]) -> Solved:
        """Solve parts, a few more begun than there are threads, so that memory stays the same."""
        stop = Event()

        def tell(*_: int) -> None:
            if stop.is_set():
                raise _StoppedError

        waiting: dict[Future[bytes], Part] = {}
        todo = iter(parts)
        with ThreadPoolExecutor(self.workers) as pool:
            try:
                while True:
                    for part in islice(todo, self.workers + 1 - len(waiting)):
                        waiting[pool.submit(solve_part, study, *part, tell)] = part
                    if not waiting:
                        return
                    for future in wait(waiting, return_when=FIRST_COMPLETED).done:
                        yield waiting.pop(future), future.result()
            finally:
                stop.set()
                pool.shutdown(wait=True, cancel_futures=True)


@dataclass(frozen=True)
class DaskCluster:
    """A Dask cluster that is running already.

    Parts are tasks with a name of their own that are tried again on another worker if theirs dies;
    a part that was solved twice is taken once.

    Attributes
    ----------
    address
        Of its scheduler, ``tcp://host:8786``.
    timeout
        How long to wait for the scheduler and for a first worker [s].
    retries
        How often a part is tried again.
    """

    address: str
    timeout: float = 15.0
    retries: int = 5

    def check(self) -> None:
        """Refuse a cluster that does not answer, has no workers, or another version of wraparc."""
        with self._client() as client:
            _check_workers(client, self.address, self.timeout)

    @contextmanager
    def _client(self) -> Iterator[Any]:
        distributed = require_distributed()
        _knock(self.address, self.timeout)
        try:
            client = distributed.Client(self.address, timeout=self.timeout, set_as_default=False)
        except (OSError, ValueError, TimeoutError) as error:
            raise _unreachable(self.address, error) from None
        try:
            yield client
        finally:
            client.close(timeout=self.timeout)

    def solve(self, study: Study, parts: Sequence[Part]) -> Solved:
        """Solve parts on the workers, a few more begun than they have threads."""
        distributed = require_distributed()
        lost = (OSError, TimeoutError, CancelledError, distributed.KilledWorker)
        with self._client() as client:
            running = distributed.as_completed(loop=client.loop)
            try:
                yield from self._solved(client, running, study, iter(parts))
            except lost as error:
                raise _lost(self.address, error) from None
            finally:
                with suppress(*lost):
                    client.cancel(list(running.futures))

    def _solved(self, client: Any, running: Any, study: Study, todo: Iterator[Part]) -> Solved:
        name = f"wraparc-{study.fingerprint[:16]}"
        places: dict[str, Part] = {}
        while True:
            room = 2 * max(1, sum(client.nthreads().values())) - len(places)
            for part in islice(todo, max(0, room)):
                key = f"{name}-{part.start}-{part.stop}"
                future = client.submit(
                    solve_part, study, *part, key=key, retries=self.retries, pure=True
                )
                places[future.key] = part
                running.add(future)
            if not places:
                return
            future = self._next(client, running)
            content = bytes(future.result())
            yield places.pop(future.key), content
            future.release()

    def _next(self, client: Any, running: Any) -> Any:
        """Wait for a part; without any worker only so long as one may take to come back."""
        worked = monotonic()
        while not running.has_ready():
            if client.nthreads():
                worked = monotonic()
            elif monotonic() - worked > _WITHOUT_WORKERS:
                raise TimeoutError(
                    f"no worker is left, and none has come in {_WITHOUT_WORKERS:g} s"
                )
            with running.thread_condition:
                running.thread_condition.wait_for(running.has_ready, _LOOK)
        return next(running)


@dataclass(frozen=True)
class LocalCluster:
    """Processes of this computer under a Dask scheduler that is started for the study.

    Attributes
    ----------
    workers
        How many; one a processor if None.
    """

    workers: int | None = None

    def check(self) -> None:
        """Refuse where Dask is not installed."""
        require_distributed()

    def solve(self, study: Study, parts: Sequence[Part]) -> Solved:
        """Solve parts on the processes."""
        distributed = require_distributed()
        with distributed.LocalCluster(
            n_workers=self.workers or os.cpu_count() or 1,
            threads_per_worker=1,
            dashboard_address=None,
            host="127.0.0.1",
        ) as cluster:
            yield from DaskCluster(cluster.scheduler_address).solve(study, parts)


def executor_named(text: str) -> Executor:
    """Return the executor of a command line: an address, ``local`` or ``local:4``."""
    if text == "local" or text.startswith("local:"):
        count = text.partition(":")[2]
        if count and not (count.isascii() and count.isdigit() and 1 <= int(count) <= 1000):
            message, remedy = "no number of processes", "Write local:4, or local."
            raise input_error(key="--scheduler", value=shown(text), message=message, remedy=remedy)
        return LocalCluster(int(count) if count else None)
    return DaskCluster(text)


def require_distributed() -> Any:
    """Return dask.distributed, its own messages kept quiet, or say how to get it."""
    try:
        import distributed
    except ImportError as error:
        raise MissingExtraError("distributed", "dask") from error
    logging.getLogger("distributed").setLevel(logging.CRITICAL)
    return distributed


def _knock(address: str, timeout: float) -> None:
    """Try the door before a client is made that would try for long, and complain at its end."""
    match = _ADDRESS.fullmatch(address)
    if match is None:
        message, remedy = "is no address of a scheduler", "Write for example tcp://host:8786."
        problem = Problem(key="--scheduler", value=shown(address), message=message, remedy=remedy)
        raise InputError(problem)
    try:
        socket.create_connection((match[1].strip("[]"), int(match[2])), timeout).close()
    except (OSError, OverflowError) as error:
        raise _unreachable(address, error) from None


def _unreachable(address: str, error: Exception) -> InputError:
    reason = str(error).splitlines()[0][:200] if str(error) else type(error).__name__
    return input_error(
        key="--scheduler",
        value=shown(address),
        message=f"no Dask scheduler answers there: {reason}",
        remedy="Start one: dask scheduler.",
    )


def _check_workers(client: Any, address: str, timeout: float) -> None:
    try:
        client.wait_for_workers(1, timeout=timeout)
        versions: dict[str, Any] = client.run(_version_here, on_error="return")
    except (OSError, TimeoutError) as error:
        message = f"the scheduler has no worker after {timeout:g} s"
        raise input_error(
            key="--scheduler",
            value=shown(address),
            message=message,
            remedy=f"Start some: dask worker {address}",
        ) from error
    wrong = {worker: told for worker, told in versions.items() if told != __version__}
    if wrong:
        worker, told = next(iter(wrong.items()))
        has = told if isinstance(told, str) else "none"
        raise input_error(
            key="--scheduler",
            value=shown(address),
            message=f"{len(wrong)} of {len(versions)} workers lack wraparc {__version__}",
            remedy=f"Install it: {worker} has {has}.",
        )


def _version_here() -> str:
    return __version__


def _lost(address: str, error: BaseException) -> InputError:
    reason = str(error).splitlines()[0][:200] if str(error) else type(error).__name__
    return input_error(
        key="--scheduler",
        value=shown(address),
        message=f"the cluster was lost: {reason}",
        remedy="Go on with --resume.",
    )
