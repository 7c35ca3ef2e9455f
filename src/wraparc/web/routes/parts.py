"""What every part of the API uses."""

from typing import Any

from fastapi import Request, Response

from wraparc.web.database.store import Store
from wraparc.web.jobs import Jobs
from wraparc.web.sessions import Sessions
from wraparc.web.settings import Settings
from wraparc.web.work import WHOLE, Workers

JSON = "application/json"


class State:
    """What a server holds while it runs."""

    def __init__(self, settings: Settings) -> None:
        self.settings = settings
        self.workers = Workers(settings.workers)
        self.sessions = Sessions()
        self.jobs = Jobs()
        self.store = Store.open(settings.database, settings.shown_database)

    def close(self) -> None:
        """End what runs, and give back what is held."""
        self.jobs.stop()
        self.workers.stop()
        self.store.close()


def state_of(request: Request) -> State:
    """Return the state of the server."""
    found: State = request.app.state.wraparc
    return found


def json_answer(body: bytes, status: int = 200, **headers: str) -> Response:
    """Return an answer that is JSON already."""
    return Response(body, status, headers=headers or None, media_type=JSON)


async def short(request: Request, where: str, body: Any, queue: str = WHOLE) -> Response:
    """Return the answer of a worker."""
    return json_answer(await state_of(request).workers.short(where, body.model_dump(), queue))


async def long(request: Request, where: str, body: Any) -> Response:
    """Return the answer of a process of its own."""
    return json_answer(await state_of(request).workers.long(where, body.model_dump()))
