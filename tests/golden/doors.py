"""The doors through which the golden answers are taken: the only place that knows inner modules.

Everything else reaches wraparc by its public names. If a module moves, this file changes and the
golden files do not.
"""

import io
import json
import time
from collections.abc import Iterator
from contextlib import contextmanager, redirect_stderr, redirect_stdout
from pathlib import Path
from typing import Any

from starlette.testclient import TestClient

from wraparc.cli import run
from wraparc.web.app import create_app
from wraparc.web.settings import Settings

EXAMPLES = Path(__file__).parents[2] / "examples"
_ADDRESS = "http://127.0.0.1:8765"
_API = "/api/v1"
_SHORT, _OFTEN = 0.05, 12_000  # a study is asked for that often before it counts as stuck


def wraparc(*arguments: object) -> str:
    """Run the command line in this process; return what it printed, after its exit code."""
    out, err = io.StringIO(), io.StringIO()
    with redirect_stdout(out), redirect_stderr(err):
        code = run([str(argument) for argument in arguments])
    if code not in (0, 1):
        raise AssertionError(f"wraparc {arguments}: exit code {code}\n{err.getvalue()}")
    return f"exit code {code}\n{out.getvalue()}"


class Calculator:
    """The API of the calculator."""

    def __init__(self, client: TestClient) -> None:
        self._client = client

    def get(self, path: str) -> Any:
        """Return what a path holds."""
        return self._checked("GET", path)

    def post(self, path: str, **body: Any) -> Any:
        """Return the answer to a request."""
        return self._checked("POST", path, json=body)

    def put(self, path: str, **body: Any) -> Any:
        """Return the answer to a change."""
        return self._checked("PUT", path, json=body)

    def upload(self, path: str, files: list[Path]) -> Any:
        """Return the answer to dropped files."""
        sent = [("files", (file.name, file.read_bytes())) for file in files]
        return self._checked("POST", path, files=sent)

    def done(self, path: str) -> Any:
        """Return a study once it is done."""
        for _ in range(_OFTEN):
            found = self.get(path)
            if found["state"] not in ("queued", "running"):
                return found
            time.sleep(_SHORT)
        raise AssertionError(f"{path} is not done")

    def _checked(self, method: str, path: str, **request: Any) -> Any:
        answer = self._client.request(method, _API + path, **request)
        if answer.status_code >= 300:
            raise AssertionError(f"{method} {path}: {answer.status_code} {answer.text}")
        kind = answer.headers.get("content-type", "")
        return json.loads(answer.content) if "json" in kind else answer.text


@contextmanager
def calculator() -> Iterator[Calculator]:
    """Return a calculator inside this process, its designs in memory."""
    app = create_app(Settings(workers=0))
    with TestClient(app, base_url=_ADDRESS, raise_server_exceptions=False) as client:
        yield Calculator(client)
