"""A PostgreSQL server for the tests, from the package of the system."""

import contextlib
import os
import pwd
import shutil
import signal
import subprocess
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from web.calculators import wait_for

_HINT = "the tests need PostgreSQL: run `make system`, or install the package postgresql"


def _program(name: str) -> str:
    """Return the path of a program of the server; Debian keeps them off the path."""
    folders = sorted(Path("/usr/lib/postgresql").glob("*/bin"), reverse=True)
    places = os.pathsep.join([*map(str, folders), os.environ.get("PATH", "")])
    found = shutil.which(name, path=places)
    assert found, _HINT
    return found


def _as_user() -> dict[str, Any]:
    """Return how to start it: the server refuses to run as root."""
    if os.geteuid() != 0:
        return {}
    names = [entry.pw_name for entry in pwd.getpwall()]
    assert "postgres" in names, _HINT
    return {"user": "postgres", "group": pwd.getpwnam("postgres").pw_gid, "extra_groups": []}


class PostgreSQL:
    """A server on a socket of its own, with an empty database."""

    def __init__(self, folder: Path) -> None:
        self.folder, self.url = folder, f"postgresql+psycopg://postgres@/postgres?host={folder}"
        self._who, self._data = _as_user(), folder / "data"
        if self._who:
            shutil.chown(folder, "postgres")
        init = [_program("initdb"), "-D", str(self._data), "-A", "trust", "-U", "postgres", "-N"]
        how: dict[str, Any] = {"cwd": folder, **self._who}
        subprocess.run([*init, "-E", "UTF8"], check=True, capture_output=True, **how)
        self.start()

    def start(self) -> None:
        """Start it, and wait until it answers."""
        self._server = subprocess.Popen(
            [
                _program("postgres"), "-D", str(self._data), "-k", str(self.folder),
                "-c", "listen_addresses=", "-c", "fsync=off",
            ],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, cwd=self.folder, **self._who,
        )  # fmt: skip
        _wait(self.folder, self._server)

    def stop(self, how: signal.Signals = signal.SIGINT) -> None:
        """Stop it without waiting for its clients; with SIGQUIT as a crash does."""
        self._server.send_signal(how)
        self._server.wait()


@contextlib.contextmanager
def postgresql() -> Iterator[PostgreSQL]:
    """Run a server."""
    folder, server = Path(tempfile.mkdtemp(prefix="wraparc-pg-")), None
    try:
        server = PostgreSQL(folder)
        yield server
    finally:
        if server is not None:
            server.stop()
        shutil.rmtree(folder, ignore_errors=True)


def _wait(folder: Path, server: "subprocess.Popen[bytes]") -> None:
    ready = [_program("pg_isready"), "-h", str(folder), "-q", "-U", "postgres"]

    def answers() -> bool:
        assert server.poll() is None, "the PostgreSQL server has ended"
        return subprocess.run(ready, check=False).returncode == 0

    wait_for(answers)
