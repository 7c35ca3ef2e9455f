"""Errors as the API answers them: problems as data, with the sentence of the command line."""

import json
from collections.abc import Iterable, Sequence
from typing import Any

from wraparc.errors import Problem, shown

Data = dict[str, Any]
_MOST = 60


class ApiError(Exception):
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
        self.status = status
        self.problems = (problems,) if isinstance(problems, Problem) else tuple(problems)
        self.headers = headers or {}
        super().__init__(status, self.problems, self.headers)


def refused(status: int, message: str, remedy: str = "", key: str = "") -> ApiError:
    """Return the error of one problem."""
    return ApiError(status, Problem(message=message, remedy=remedy, key=key))


def problem_data(problem: Problem) -> Data:
    """Return a problem as the API tells it."""
    return {
        "path": problem.key,
        "message": problem.message,
        "value": problem.value,
        "remedy": problem.remedy,
        "line": problem.line,
        "sentence": str(problem),
    }


def problems_data(problems: Iterable[Problem]) -> list[Data]:
    """Return problems as the API tells them."""
    return [problem_data(problem) for problem in problems]


def problems_body(problems: Iterable[Problem]) -> bytes:
    """Return the body of an answer that refuses."""
    return json_bytes({"problems": problems_data(problems)})


def json_bytes(data: object) -> bytes:
    """Return plain data as JSON in ASCII: lone surrogates of a hostile request pass as escapes."""
    return json.dumps(data, allow_nan=False, separators=(",", ":")).encode("ascii")


def request_problems(errors: Sequence[Any]) -> list[Problem]:
    """Return the problems of a request that does not have the form it must have."""
    found = []
    for error in errors[:_MOST]:
        steps = [step for step in error["loc"] if step not in ("body", "query", "path", "header")]
        key = ".".join(map(str, steps))
        message = str(error["msg"])
        given = error.get("input")
        value = "" if error["type"] in ("missing", "json_invalid") else shown(_small(given))
        found.append(Problem(key=key, value=value, message=message[:1].lower() + message[1:]))
    return found


def _small(value: object) -> object:
    """Return what of a value can be shown without walking all of a hostile one."""
    if isinstance(value, str):
        return value[:200]
    if value is None or isinstance(value, bool | int | float):
        return value if not isinstance(value, int) or abs(value) < 10**30 else "a huge number"
    return f"<{type(value).__name__}>"
