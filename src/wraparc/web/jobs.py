"""Long work that goes on by itself: started, followed, cancelled, looked at."""

import asyncio
import secrets
import time
from collections.abc import Awaitable, Callable
from dataclasses import dataclass, field
from typing import Any, Literal

from wraparc.web.errors import ToldProblem, refusal_of, refused, told
from wraparc.web.progress import Tell
from wraparc.web.turns import Turns

MOST_RUNNING, MOST_WAITING, MOST_KEPT = 1, 10, 20
LIFE = 6 * 3600.0
State = Literal["queued", "running", "done", "failed", "cancelled"]
Work = Callable[[Tell], Awaitable[Any]]


@dataclass(eq=False)
class Job:
    """One piece of work.

    Attributes
    ----------
    id, title
        Its number, and what it is called.
    state
        How it stands.
    done, total, message
        How far it is.
    problems
        Why it failed.
    result
        What came out.
    asked
        What it is of.
    """

    id: str
    title: str
    total: int = 0
    state: State = "queued"
    done: int = 0
    message: str = ""
    problems: list[ToldProblem] = field(default_factory=list)
    result: Any = None
    asked: Any = None
    changed: float = 0.0
    task: asyncio.Task[None] | None = None

    @property
    def busy(self) -> bool:
        """Whether it waits or runs."""
        return self.state in ("queued", "running")

    def tell(self, done: int, total: int, message: str) -> None:
        """Take note of progress."""
        self.done, self.total, self.message = done, total, message


class Jobs:
    """All jobs of one kind of a server; a few run, the others wait their turn.

    Parameters
    ----------
    clock
        Tells how old a job is.
    one, many
        What a job is called.
    """

    def __init__(
        self,
        clock: Callable[[], float] = time.monotonic,
        one: str = "study",
        many: str = "studies",
    ) -> None:
        self._clock, self._one, self._many = clock, one, many
        self._turns = Turns(MOST_RUNNING, MOST_RUNNING, MOST_WAITING + MOST_RUNNING)
        self._jobs: dict[str, Job] = {}

    def start(self, client: str, title: str, total: int, work: Work) -> Job:
        """Start a job, or put it in the queue."""
        self._sweep()
        if sum(job.busy for job in self._jobs.values()) >= MOST_RUNNING + MOST_WAITING:
            error = refused(429, f"too many {self._many} are waiting", "Wait, or cancel one.")
            error.headers = {"retry-after": "60"}
            raise error
        job = Job(secrets.token_urlsafe(9), title, total)
        self._jobs[job.id] = job
        job.task = asyncio.create_task(self._run(client, job, work))
        return job

    async def _run(self, client: str, job: Job, work: Work) -> None:
        state: State = "cancelled"
        try:
            async with self._turns.turn(client):
                job.state = "running"
                job.result = await work(job.tell)
                state, job.done = "done", job.total
        except Exception as error:  # noqa: BLE001 - whatever it is, the job ends and tells of it
            job.problems, state = told(refusal_of(error).problems), "failed"
        finally:
            job.state, job.message, job.changed = state, "", self._clock()

    def listed(self) -> list[Job]:
        """Return all jobs, the newest first."""
        self._sweep()
        return list(reversed(self._jobs.values()))

    def get(self, name: str) -> Job:
        """Return a job."""
        if name not in self._jobs:
            raise refused(404, f"there is no such {self._one}", "It may have been forgotten.")
        return self._jobs[name]

    def result(self, name: str) -> Any:
        """Return what came out of a job that is done."""
        job = self.get(name)
        if job.state != "done":
            raise refused(409, f"the {self._one} is not done", "Wait for it.")
        return job.result

    def end(self, name: str) -> None:
        """Cancel a job that is at work, forget one that is not."""
        job = self.get(name)
        if not job.busy:
            del self._jobs[name]
            return
        if job.task is not None:
            job.task.cancel()
        job.state, job.message, job.changed = "cancelled", "", self._clock()

    def stop(self) -> None:
        """Cancel everything."""
        while self._jobs:
            task = self._jobs.popitem()[1].task
            if task is not None:
                task.cancel()

    def _sweep(self) -> None:
        now = self._clock()
        ended = sorted((j for j in self._jobs.values() if not j.busy), key=lambda j: j.changed)
        kept = [job for job in ended if now - job.changed <= LIFE][-MOST_KEPT:]
        for job in ended:
            if job not in kept:
                del self._jobs[job.id]
