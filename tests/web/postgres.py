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


@contextlib.contextmanager
def postgresql() -> Iterator[str]:
    """Run a server on a socket of its own; yield the URL of an empty database."""
    folder = Path(tempfile.mkdtemp(prefix="wraparc-pg-"))
    who = _as_user()
    server = None
    try:
        if who:
            shutil.chown(folder, "postgres")
        data = folder / "data"
        init = [_program("initdb"), "-D", str(data), "-A", "trust", "-U", "postgres", "-N"]
        subprocess.run([*init, "-E", "UTF8"], check=True, capture_output=True, cwd=folder, **who)
        server = subprocess.Popen(
            [
                _program("postgres"), "-D", str(data), "-k", str(folder),
                "-c", "listen_addresses=", "-c", "fsync=off",
            ],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, cwd=folder, **who,
        )  # fmt: skip
        _wait(folder, server)
        yield f"postgresql+psycopg://postgres@/postgres?host={folder}"
    finally:
        if server is not None:
            server.send_signal(signal.SIGINT)  # without waiting for its clients
            server.wait()
        shutil.rmtree(folder, ignore_errors=True)


def _wait(folder: Path, server: "subprocess.Popen[bytes]") -> None:
    ready = [_program("pg_isready"), "-h", str(folder), "-q", "-U", "postgres"]

    def answers() -> bool:
        assert server.poll() is None, "the PostgreSQL server has ended"
        return subprocess.run(ready, check=False).returncode == 0

    wait_for(answers)
