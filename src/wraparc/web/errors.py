"""Errors as the API answers them: RFC 9457, with every problem as the command line tells it."""

import json
from collections.abc import Iterable, Sequence
from http import HTTPStatus
from typing import Any

from starlette.exceptions import HTTPException

from wraparc.errors import InputError, MissingExtraError, Problem, shown
from wraparc.saving import FULL
from wraparc.version import __version__
from wraparc.web.answers.shown import Answer

PROBLEM_JSON = "application/problem+json"
_MOST = 60
_BODY = 'Send {"document": {...}}, or a drive file as application/toml (see /docs).'


class ToldProblem(Answer):
    """One thing wrong, with the sentence of the command line; `code` says of what kind it is."""

    path: str
    message: str
    value: str
    remedy: str
    line: int | None
    code: str
    meant: str
    sentence: str


class Problems(Answer):
    """Everything that is wrong, as RFC 9457 tells it."""

    type: str = "about:blank"
    title: str
    status: int
    detail: str
    problems: list[ToldProblem]


class ApiError(HTTPException):
    """A request that is refused.

    Parameters
    ----------
    status
        HTTP status.
    problems
        What is wrong.
    headers
        Further headers of the response.
    """

    def __init__(
        self,
        status: int,
        problems: Problem | Iterable[Problem],
        headers: dict[str, str] | None = None,
    ) -> None:
        self.problems = (problems,) if isinstance(problems, Problem) else tuple(problems)
        super().__init__(status, " ".join(map(str, self.problems)), headers or {})

    def body(self) -> bytes:
        """Return the body of the answer, in ASCII: what was sent may hold anything."""
        title = HTTPStatus(self.status_code).phrase
        found = Problems(
            title=title,
            status=self.status_code,
            detail=self.detail,
            problems=told(self.problems),
        )
        return json.dumps(found.model_dump(), separators=(",", ":")).encode("ascii")


def refused(
    status: int, message: str, remedy: str = "", key: str = "", value: str = ""
) -> ApiError:
    """Return the error of one problem."""
    return ApiError(status, Problem(message=message, remedy=remedy, key=key, value=value))


def told(problems: Iterable[Problem]) -> list[ToldProblem]:
    """Return problems as the API tells them."""
    return [
        ToldProblem(
            path=problem.key,
            message=problem.message,
            value=problem.value,
            remedy=problem.remedy,
            line=problem.line,
            code=problem.code,
            meant=problem.meant,
            sentence=str(problem),
        )
        for problem in problems
    ]


def refusal_of(error: BaseException) -> ApiError:
    """Return how any error is answered; of a fault the server's own output has the traceback."""
    if isinstance(error, ApiError):
        return error
    if isinstance(error, InputError):
        return ApiError(422, error.problems)
    if isinstance(error, MissingExtraError):
        return refused(501, f"this server {error}")
    if isinstance(error, HTTPException):
        problem = Problem(message=str(error.detail).lower())
        return ApiError(error.status_code, problem, dict(error.headers or {}))
    if isinstance(error, OSError) and error.errno in FULL:
        return refused(507, "the disk of the server is full", "Make room there, and try again.")
    message = f"a fault in wraparc {__version__} ({type(error).__name__})"
    return refused(500, message, "Please report it with the drive file.")


def request_problems(errors: Sequence[Any]) -> list[Problem]:
    """Return the problems of a request that does not have the form it must have."""
    found = []
    for error in errors[:_MOST]:
        steps = [step for step in error["loc"] if step not in ("body", "query", "path", "header")]
        key = ".".join(map(str, steps))
        message = str(error["msg"])
        if error["type"] == "json_invalid":  # its place is a count of characters
            key, message = "", f"the body is not JSON from character {int(steps[-1]) + 1:,} on"
        given = error.get("input")
        value = "" if error["type"] in ("missing", "json_invalid") else shown(_small(given))
        remedy = _BODY if error["type"] == "missing" and key in ("", "document") else ""
        message = message[:1].lower() + message[1:]
        found.append(Problem(key=key, value=value, message=message, remedy=remedy))
    return found


def _small(value: object) -> object:
    """Return what of a value can be shown without walking all of a hostile one."""
    if isinstance(value, str):
        return value[:200]
    if value is None or isinstance(value, bool | int | float):
        return value if not isinstance(value, int) or abs(value) < 10**30 else "a huge number"
    return f"<{type(value).__name__}>"
