"""Servers for tests: inside the test, or as a process of its own."""

import contextlib
import json
import os
import re
import signal
import subprocess
import sys
import time
import urllib.error
import urllib.request
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

from starlette.testclient import TestClient

from wraparc.web.app import create_app
from wraparc.web.examples import examples
from wraparc.web.settings import Settings

ADDRESS = "http://127.0.0.1:8765"
API = "/api/v1"
#: Of servers that tests start.
TOKEN = "token-of-the-tests-0123"  # noqa: S105
#: After this long [s] what a test waits for is taken to hang, before the test is; no test counts
#: on it.
PATIENCE = 180.0


def document(name: str = "head-drive-fabric") -> dict[str, Any]:
    """Return a copy of an example drive."""
    found = next(e for e in examples() if e.name == name)
    copy: dict[str, Any] = json.loads(json.dumps(found.document))
    return copy


@contextlib.contextmanager
def client(**settings: Any) -> Iterator[TestClient]:
    """Return a client of a server inside this process, its designs in memory."""
    app = create_app(Settings(workers=0, **settings))
    with TestClient(app, base_url=ADDRESS, raise_server_exceptions=False) as found:
        yield found


class Answer(NamedTuple):
    status: int
    body: bytes
    headers: Any

    def json(self) -> Any:
        return json.loads(self.body)


class Process:
    """``wraparc serve`` as a process."""

    def __init__(self, *arguments: str, cwd: Path | None = None) -> None:
        run = "from wraparc.cli import main; main()"
        port = [] if "--port" in arguments else ["--port", "0"]
        command = [sys.executable, "-c", run, "serve", *port, *arguments]
        self.process = subprocess.Popen(
            command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=cwd,
            start_new_session=True,
            env={**os.environ, "PYTHONUNBUFFERED": "1", "WRAPARC_TOKEN": TOKEN},
        )  # fmt: skip
        assert self.process.stdout is not None
        self.told = ""
        for line in self.process.stdout:
            self.told += line
            if line.startswith("Stop"):
                break
        else:
            assert self.process.stderr is not None
            complaints = self.process.stderr.read()
            raise AssertionError(f"ended with {self.process.wait()}: {self.told}{complaints}")
        found = re.search(r"http://\S+:(\d+)/\S*", self.told)
        assert found, self.told
        self.address, self.port = found[0].partition("?")[0], int(found[1])

    def ask(self, path: str, data: Any = None, method: str | None = None) -> Answer:
        """Ask the server."""
        body = None if data is None else json.dumps(data).encode()
        request = urllib.request.Request(
            f"http://127.0.0.1:{self.port}{path}",
            body,
            {"content-type": "application/json", "authorization": f"Bearer {TOKEN}"},
            method=method,
        )
        try:
            with urllib.request.urlopen(request, timeout=PATIENCE) as answer:  # noqa: S310
                return Answer(answer.status, answer.read(), answer.headers)
        except urllib.error.HTTPError as error:
            return Answer(error.code, error.read(), error.headers)

    def start_token(self) -> str:
        """Return the token of this start, as a page is given it."""
        address = f"http://127.0.0.1:{self.port}/?token={TOKEN}"
        with urllib.request.urlopen(address, timeout=PATIENCE) as answer:
            return str(answer.url).partition("token=")[2]

    def kill(self) -> None:
        """End it at once, with everything it started."""
        with contextlib.suppress(ProcessLookupError):
            os.killpg(self.process.pid, signal.SIGKILL)
        if self.process.stdout is not None and not self.process.stdout.closed:
            self.process.communicate()

    def stop(self) -> tuple[int, str]:
        """Press Ctrl-C, which goes to all its processes; return exit code and complaints."""
        os.killpg(self.process.pid, signal.SIGINT)
        try:
            _, complaints = self.process.communicate(timeout=PATIENCE)
        finally:
            with contextlib.suppress(ProcessLookupError):
                os.killpg(self.process.pid, signal.SIGKILL)
        return self.process.returncode, complaints


@contextlib.contextmanager
def serving(*arguments: str) -> Iterator[Process]:
    """Run ``wraparc serve`` for a while."""
    process = Process(*arguments)
    try:
        yield process
    finally:
        process.kill()


def wait_for(condition: Any) -> None:
    """Wait until something holds."""
    end = time.monotonic() + PATIENCE
    while not condition():
        assert time.monotonic() < end, "it did not come to pass"
        time.sleep(0.05)
