"""What every part of the API uses."""

import asyncio
import hashlib
import inspect
import pickle
from collections.abc import Awaitable, Callable, Coroutine, Mapping
from typing import Any, get_type_hints

from fastapi import APIRouter, Request, Response
from fastapi.routing import APIRoute

from wraparc.version import __version__
from wraparc.web.answers import rows
from wraparc.web.answers.shown import Answer
from wraparc.web.database.store import Store
from wraparc.web.errors import Problems, ToldProblem, refused
from wraparc.web.jobs import Jobs
from wraparc.web.jobs import State as JobState
from wraparc.web.kept import Kept
from wraparc.web.one_time import OneTimeLinks
from wraparc.web.processes import Function
from wraparc.web.routes.bodies import Body, Readers
from wraparc.web.sessions import Sessions
from wraparc.web.settings import Settings
from wraparc.web.work import QUICK, WHOLE, Workers

JSON = "application/json"

#: How the OpenAPI document calls the token: nothing looks for it here, the door has looked already.
BEARER = "HTTPBearer"


class Standing(Answer):
    """How a job stands."""

    id: str
    state: JobState
    done: int
    total: int
    message: str
    problems: list[ToldProblem]


class State:
    """What a server holds while it runs."""

    def __init__(self, settings: Settings) -> None:
        self.settings = settings
        self.workers = Workers(settings.workers)
        self.readers = Readers(self.workers)
        self.kept = Kept()
        self.sessions = Sessions()
        self.links = OneTimeLinks()
        self.jobs = Jobs()
        self.runs = Jobs(one="run", many="runs in time")
        self.learning = Jobs(one="log", many="logs")
        self.store = Store.open(settings.database, settings.shown_database)
        self.first = b""  # the answers of the drive to begin with, once they are there

    def close(self) -> None:
        """End what runs, and give back what is held."""
        self.jobs.stop()
        self.runs.stop()
        self.learning.stop()
        self.workers.stop()
        self.store.close()


class Route(APIRoute):
    """A route that is described by the words of its function, and says how it can refuse."""

    def __init__(self, path: str, endpoint: Callable[..., Any], **more: Any) -> None:
        summary, _, rest = (inspect.getdoc(endpoint) or "").partition("\n")
        more["summary"], more["description"] = summary.rstrip("."), rest.strip()
        known = {400: "Not readable.", 401: "No token.", 403: "Not from here."}
        known |= {413: "Too large.", 422: "Wrong.", 503: "Busy."}
        known |= {404: "Not there."} if "{" in path else {}
        if not {"GET", "DELETE"} & set(more.get("methods") or ()):
            known[415] = "Of a type not known here."
        refusals: dict[int | str, dict[str, Any]] = {
            code: {"model": Problems, "description": text} for code, text in known.items()
        }
        more["responses"] = refusals | (more.get("responses") or {})
        more["openapi_extra"] = {"security": [{BEARER: []}]}
        super().__init__(path, endpoint, **more)

    def get_route_handler(self) -> Callable[[Request], Coroutine[Any, Any, Response]]:
        """Return what serves a request, whatever the type of its body."""
        serve = super().get_route_handler()
        model = self.body_field and self.body_field.field_info.annotation

        async def handler(request: Request) -> Response:
            answer = await serve(Body(request, state_of(request).readers, model))
            answer.headers["wraparc-version"] = __version__  # a page of another one says so
            if request.method == "GET" and answer.status_code == 200:
                return _tagged(request, answer)
            return answer

        return handler


def _tagged(request: Request, answer: Response) -> Response:
    """Return an answer with what changes when it changes, or that it has not changed."""
    tag = f'"{hashlib.sha256(answer.body).hexdigest()[:32]}"'
    if tag in request.headers.get("if-none-match", ""):
        return Response(status_code=304, headers={"etag": tag})
    answer.headers["etag"] = tag
    return answer


def router(prefix: str, tag: str) -> APIRouter:
    """Return a part of the API."""
    return APIRouter(prefix=f"/api/v1{prefix}", tags=[tag], route_class=Route)


def refuses(*codes: int) -> dict[int | str, dict[str, Any]]:
    """Return what a route says of further refusals."""
    return {code: {"model": Problems} for code in codes}


def state_of(request: Request) -> State:
    """Return the state of the server."""
    found: State = request.app.state.wraparc
    return found


def client_of(request: Request) -> str:
    """Return who asks: clients take turns."""
    return request.client.host if request.client else ""


def offer(
    part: APIRouter,
    path: str,
    function: Function,
    *,
    queue: str = WHOLE,
    long: Callable[[Any], bool] = lambda asked: False,
) -> None:
    """Offer what a function gives to a request: its types are the form of both.

    It must give the same for the same request: its answers are kept.
    """
    hints = get_type_hints(function)
    listed = hints["return"] in rows.WITH_ROWS

    async def endpoint(request: Request, asked: Any) -> Response:
        workers, kept, client = (
            state_of(request).workers,
            state_of(request).kept,
            client_of(request),
        )
        lines = listed and rows.MEDIA in request.headers.get("accept", "")
        question = (rows.csv_of, function, asked) if lines else (function, asked)
        # a slider never asks the same again: quick answers are not kept
        key = b"" if queue == QUICK else await asyncio.to_thread(_key_of, question)
        found = kept.find(key)
        if found is None:
            if long(asked):
                work = workers.long(client, *question)
            else:
                work = workers.short(client, *question, queue=queue)
            found = await waited(request, work)
            if key:
                kept.keep(key, found)
        return Response(found, media_type=rows.MEDIA) if lines else json_answer(found)

    endpoint.__annotations__["asked"] = hints["asked"]
    endpoint.__name__, endpoint.__doc__ = function.__name__, function.__doc__
    media: dict[int | str, dict[str, Any]] = {200: {"content": {rows.MEDIA: {}}}}
    part.add_api_route(
        path,
        endpoint,
        methods=["POST"],
        response_model=hints["return"],
        responses=media if listed else None,
    )


def _key_of(question: tuple[Any, ...]) -> bytes:
    return hashlib.sha256(pickle.dumps(question)).digest()


async def waited(request: Request, work: Awaitable[bytes]) -> bytes:
    """Return an answer, and give it up when nobody waits for it any more."""
    working = asyncio.ensure_future(work)
    leaving = asyncio.ensure_future(_left(request))
    try:
        await asyncio.wait((working, leaving), return_when=asyncio.FIRST_COMPLETED)
        if not working.done():
            raise refused(503, "nobody waits for the answer any more")
        return working.result()
    except asyncio.CancelledError:  # by a server that waits no longer for what still runs
        raise refused(503, "the calculator is being stopped") from None
    finally:
        leaving.cancel()
        working.cancel()


async def _left(request: Request) -> None:
    while (await request.receive())["type"] != "http.disconnect":
        pass


def json_answer(body: bytes) -> Response:
    """Return an answer that is JSON already."""
    return Response(body, media_type=JSON)


def picture_of(pictures: Mapping[str, str], name: str) -> Response:
    """Return a picture, SVG."""
    if name not in pictures:
        raise refused(404, "there is no such picture")
    # what is drawn carries its styles in attributes; it is shown as an image, where nothing runs
    policy = "default-src 'none'; style-src 'unsafe-inline'"
    headers = {"content-security-policy": policy}
    return Response(pictures[name], media_type="image/svg+xml", headers=headers)
