"""The application: routes, errors, and the door in front of them."""

import asyncio
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from typing import Any

from fastapi import FastAPI, Request, Response
from fastapi.exceptions import RequestValidationError
from starlette.exceptions import HTTPException

from wraparc.errors import InputError, MissingExtraError
from wraparc.version import __version__
from wraparc.web.errors import PROBLEM_JSON, ApiError, refusal_of, request_problems
from wraparc.web.packing import Packing
from wraparc.web.routes import (
    designs,
    drives,
    events,
    files,
    logs,
    pages,
    shear_tests,
    start,
    studies,
)
from wraparc.web.routes.parts import BEARER, State
from wraparc.web.security import Door
from wraparc.web.settings import Settings

_DESCRIPTION = (
    "Belt-conveyor drive pulleys: creep, slip, lagging shear and traction capacity. Numbers are "
    "SI; texts come in metric units with the numbers in them. What is wrong with a request comes "
    "as a list of problems, each with the sentence of the command line."
)


class _App(FastAPI):
    """An application whose OpenAPI document tells of the token that the door asks for."""

    def openapi(self) -> dict[str, Any]:
        """Return the OpenAPI document."""
        found = super().openapi()
        told = "The token of the user, or that of this start, which pages have."
        scheme = {"type": "http", "description": told, "scheme": "bearer"}
        found["components"]["securitySchemes"] = {BEARER: scheme}
        return found


def create_app(settings: Settings) -> FastAPI:
    """Return the application of one server.

    Parameters
    ----------
    settings
        How it runs.
    """
    state = State(settings)

    @asynccontextmanager
    async def running(_: FastAPI) -> AsyncIterator[None]:
        state.workers.start()
        solving = asyncio.create_task(start.solve_first(state)) if settings.workers else None
        yield
        if solving:
            solving.cancel()
        state.close()

    app = _App(
        title="wraparc",
        version=__version__,
        description=_DESCRIPTION,
        openapi_url="/api/v1/openapi.json",
        docs_url=None,
        redoc_url=None,
        lifespan=running,
        redirect_slashes=False,
    )
    app.state.wraparc = state
    for part in (drives, start, designs, shear_tests, files, logs, studies, events, pages):
        app.include_router(part.api)
    app.include_router(pages.pages)
    for kind in (InputError, ApiError, MissingExtraError, HTTPException, Exception):
        app.add_exception_handler(kind, _refuse)
    app.add_exception_handler(RequestValidationError, _bad_request)
    app.add_middleware(Packing)
    app.add_middleware(Door, settings=settings)  # the first that a request comes to
    return app


async def _bad_request(_: Request, error: Exception) -> Response:
    errors = error.errors() if isinstance(error, RequestValidationError) else ()
    return refusal(ApiError(422, request_problems(errors)))


async def _refuse(_: Request, error: Exception) -> Response:
    return refusal(refusal_of(error))


def refusal(error: ApiError) -> Response:
    """Return the answer that refuses."""
    return Response(error.body(), error.status_code, error.headers, PROBLEM_JSON)
