"""The application: routes, errors, and the door in front of them."""

from collections.abc import AsyncIterator
from contextlib import asynccontextmanager

from fastapi import FastAPI, Request, Response
from fastapi.exceptions import RequestValidationError
from starlette.exceptions import HTTPException

from wraparc.errors import InputError, MissingExtraError, Problem
from wraparc.version import __version__
from wraparc.web.errors import ApiError, problems_body, request_problems
from wraparc.web.routes import designs, drives, pages, reports, shear_tests, studies
from wraparc.web.routes.parts import State, json_answer
from wraparc.web.security import Door
from wraparc.web.settings import Settings

_DESCRIPTION = (
    "Belt-conveyor drive pulleys: creep, slip, lagging shear and traction capacity. Numbers are "
    "SI; texts with units come in both systems. What is wrong with a request comes as a list of "
    "problems, each with the sentence of the command line."
)


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
        yield
        state.close()

    app = FastAPI(
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
    parts = (drives, designs, shear_tests, reports, studies)
    for part in (*(p.router for p in parts), pages.api, pages.router):
        app.include_router(part)
    app.add_exception_handler(InputError, _bad_input)
    app.add_exception_handler(RequestValidationError, _bad_request)
    app.add_exception_handler(ApiError, _refused)
    app.add_exception_handler(MissingExtraError, _missing)
    app.add_exception_handler(HTTPException, _http)
    app.add_exception_handler(Exception, _fault)
    app.add_middleware(Door, settings=settings)
    return app


def _bad_input(_: Request, error: Exception) -> Response:
    problems = error.problems if isinstance(error, InputError) else ()
    return json_answer(problems_body(problems), 422)


def _bad_request(_: Request, error: Exception) -> Response:
    errors = error.errors() if isinstance(error, RequestValidationError) else ()
    return json_answer(problems_body(request_problems(errors)), 422)


def _refused(_: Request, error: Exception) -> Response:
    if not isinstance(error, ApiError):
        raise error
    return json_answer(problems_body(error.problems), error.status, **error.headers)


def _missing(_: Request, error: Exception) -> Response:
    return json_answer(problems_body([Problem(message=f"this server {error}")]), 501)


def _http(_: Request, error: Exception) -> Response:
    if not isinstance(error, HTTPException):
        raise error
    problem = Problem(message=str(error.detail).lower())
    headers = dict(error.headers or {})
    return json_answer(problems_body([problem]), error.status_code, **headers)


def _fault(_: Request, error: Exception) -> Response:
    """Tell of a fault; the server's own output has the traceback."""
    message = f"a fault in wraparc {__version__} ({type(error).__name__})"
    remedy = "Please report it with the drive file."
    return json_answer(problems_body([Problem(message=message, remedy=remedy)]), 500)
