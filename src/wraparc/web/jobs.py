"""Long work that goes on by itself: started, followed, cancelled, looked at."""

import secrets
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from wraparc.errors import InputError, MissingExtraError, Problem
from wraparc.web.errors import ApiError, Data, problems_data, refused
from wraparc.web.work import CancelledTaskError, Task

MOST_RUNNING, MOST_WAITING, MOST_KEPT = 1, 10, 20
LIFE = 6 * 3600.0
Begin = Callable[[Callable[[int, int, str], None]], Task]


@dataclass
class Job:
    """One piece of work.

    Attributes
    ----------
    id, title
        Its number, and what it is called.
    state
        ``queued``, ``running``, ``done``, ``failed`` or ``cancelled``.
    done, total, message
        How far it is.
    problems
        Why it failed.
    result
        What came out.
    """

    id: str
    title: str
    state: str = "queued"
    done: int = 0
    total: int = 0
    message: str = ""
    problems: list[Data] = field(default_factory=list)
    result: bytes = b""
    changed: float = 0.0
    task: Any = None

    @property
    def busy(self) -> bool:
        """Whether it waits or runs."""
        return self.state in ("queued", "running")

    def told(self) -> Data:
        """Return how it stands."""
        names = ("id", "title", "state", "done", "total", "message", "problems")
        return {name: getattr(self, name) for name in names}


class Jobs:
    """All jobs of a server; a few run, the others wait their turn."""

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock = clock
        self._lock = threading.Lock()
        self._turn = threading.BoundedSemaphore(MOST_RUNNING)
        self._jobs: dict[str, Job] = {}

    def start(self, title: str, begin: Begin) -> Job:
        """Start a job, or put it in the queue; `begin` starts its process."""
        with self._lock:
            self._sweep()
            if sum(job.busy for job in self._jobs.values()) >= MOST_RUNNING + MOST_WAITING:
                message = "too many studies are waiting"
                raise refused(429, message, "Wait, or cancel one.")
            job = Job(secrets.token_urlsafe(9), title, changed=self._clock())
            self._jobs[job.id] = job
        thread = threading.Thread(target=self._work, args=(job, begin), daemon=True)
        thread.start()
        return job

    def listed(self) -> list[Job]:
        """Return all jobs, the newest first."""
        with self._lock:
            self._sweep()
            return list(reversed(self._jobs.values()))

    def get(self, name: str) -> Job:
        """Return a job."""
        with self._lock:
            found = self._jobs.get(name)
        if found is None:
            raise refused(404, "there is no such study", "It may have been forgotten.")
        return found

    def end(self, name: str) -> None:
        """Cancel a job that is at work, forget one that is not."""
        job = self.get(name)
        with self._lock:
            if not job.busy:
                self._jobs.pop(name, None)
                return
            job.state, job.changed = "cancelled", self._clock()
            task = job.task
        if task is not None:
            task.cancel()

    def stop(self) -> None:
        """Cancel everything."""
        for job in self.listed():
            if job.busy:
                self.end(job.id)

    def _work(self, job: Job, begin: Begin) -> None:
        with self._turn:
            with self._lock:
                if job.state != "queued":
                    return
                job.state = "running"

            def progress(done: int, total: int, message: str = "") -> None:
                job.done, job.total, job.message = done, total, message

            try:
                task = begin(progress)
                with self._lock:
                    job.task = task
                    cancelled = job.state == "cancelled"
                if cancelled:
                    task.cancel()
                found = task.result()
            except (InputError, ApiError) as error:
                self._end(job, "failed", problems=problems_data(error.problems))
            except MissingExtraError as error:
                problem = Problem(message=f"this server {error}")
                self._end(job, "failed", problems=problems_data([problem]))
            except CancelledTaskError:
                problem = Problem(
                    message="its process has ended, perhaps for want of memory",
                    remedy="Ask for fewer designs or results.",
                )
                self._end(job, "failed", problems=problems_data([problem]))
            else:
                self._end(job, "done", result=found)

    def _end(self, job: Job, state: str, **more: Any) -> None:
        with self._lock:
            job.task, job.changed = None, self._clock()
            if job.state == "cancelled":
                return
            for name, value in more.items():
                setattr(job, name, value)
            job.state, job.message = state, ""

    def _sweep(self) -> None:
        now = self._clock()
        ended = [job for job in self._jobs.values() if not job.busy]
        ended.sort(key=lambda job: job.changed)
        surplus = ended[: max(0, len(ended) - MOST_KEPT)]
        for job in [*surplus, *(job for job in ended if now - job.changed > LIFE)]:
            self._jobs.pop(job.id, None)
