"""Runs and a server killed (SIGKILL) at random moments: what is left, and what they go on to.

    python benchmarks/killed.py [--kills 20] [--seed 1] [--only server]

A study, a study over an event, a run with a saved state, a choice and a fit are killed again and
again and go on, or begin anew, each time, until each has been killed that often; then they go on to
their end. After every kill the file is to be the whole one, bit for bit, or not there. A server is
killed while three clients save designs, and started again on the same file; every design whose save
it has acknowledged is to be there, and the file sound. POSIX only: work is forked, so that nothing
is imported anew.
"""

import argparse
import http.client
import io
import json
import os
import random
import signal
import socket
import sqlite3
import sys
import tempfile
import threading
import time
from collections.abc import Callable
from contextlib import closing, redirect_stderr, redirect_stdout, suppress
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))

from web.calculators import API, TOKEN, document
from wraparc.cli import run
from wraparc.motion.checkpoint import Checkpoint

ROOT = Path(__file__).parents[1]
TANDEM = ROOT / "examples" / "tandem-fabric.toml"
CANDIDATES = ROOT / "examples" / "wet-season" / "choose.toml"
TESTS = ROOT / "examples" / "shear_tests" / "plan.toml"
STUDY = f"""
format = 1
drive = "{ROOT}/examples/studies/head-drive.toml"
[[axis]]
field = "pulley.head.exit_tension"
from = "30 kN"
to = "90 kN"
count = 4000
"""
OVER_EVENT = f"""
format = 1
drive = "{TANDEM}"
event = "start"
points = 10
set = ["motion.event.start.duration=2 s"]
[[axis]]
field = "motion.event.start.happens[1].time"
from = "8 s"
to = "20 s"
count = 6
"""
SAVERS = 3


def works(folder: Path) -> dict[str, tuple[list[str], list[str], str]]:
    """Commands by what they are, each with what makes it go on and the ending of its file."""
    study, over = folder / "study.toml", folder / "over-event.toml"
    study.write_text(STUDY, "utf-8")
    over.write_text(OVER_EVENT, "utf-8")
    long = ["--quiet", "--points", "40", "--set", "motion.event.start.duration=10 s"]
    return {
        "study": (["study", str(study), "--part", "100", "-o"], ["--resume"], "parquet"),
        "study over an event": (["study", str(over), "-o"], ["--resume"], "csv"),
        "run with a saved state": (
            ["run", str(TANDEM), *long, "--checkpoint", str(folder / "run.npz"), "--csv"],
            [],
            "csv",
        ),
        "choose": (["choose", str(CANDIDATES), "--csv"], [], "csv"),
        "fit": (["fit", str(TESTS), "-o"], [], "toml"),
    }  # fmt: skip


def forked(work: Callable[[], int]) -> int:
    """Begin some work in a process of its own; return its number."""
    number = os.fork()
    if number:
        return number
    code = 3
    with open(os.devnull, "w") as nowhere:
        os.dup2(nowhere.fileno(), 1)
        os.dup2(nowhere.fileno(), 2)
        with suppress(BaseException):
            code = work()
    os._exit(code)


def ended(number: int) -> int:
    """Wait for a process; return its exit code, below 0 for a signal."""
    return os.waitstatus_to_exitcode(os.waitpid(number, 0)[1])


def killed(number: int, after: float) -> bool:
    """Kill a process after some time; return whether it was still at work."""
    time.sleep(after)
    os.kill(number, signal.SIGKILL)
    return ended(number) < 0


def one_work(
    folder: Path,
    name: str,
    work: tuple[list[str], list[str], str],
    kills: int,
    draw: random.Random,
) -> None:
    """Kill a command again and again; print what was found."""
    command, go_on, ending = work
    whole, file = folder / f"whole.{ending}", folder / f"file.{ending}"
    silent = io.StringIO()
    with redirect_stdout(silent), redirect_stderr(silent):
        run([*command, str(whole)])  # what is loaded once is loaded before processes are forked
    whole.unlink()
    begin = time.monotonic()
    assert ended(forked(lambda: run([*command, str(whole)]))) in (0, 1)
    lasts = time.monotonic() - begin
    expected, told = whole.read_bytes(), {"not there": 0, "whole": 0, "torn": 0}
    count = ends = 0
    while count < kills:
        if killed(forked(lambda: run([*command, str(file), *go_on])), draw.uniform(0, lasts)):
            count += 1
            there = file.exists()
            good = there and file.read_bytes() == expected
            told["not there" if not there else "whole" if good else "torn"] += 1
        else:
            ends += 1
            assert file.read_bytes() == expected, "it went on to another file"
            file.unlink()
    code = ended(forked(lambda: run([*command, str(file), *go_on])))
    same = file.exists() and file.read_bytes() == expected
    left = sorted(p.name for p in folder.iterdir() if p.name.startswith((".", "file.")))
    print(
        f"{name}: {lasts:.1f} s undisturbed; {count} kills, after which the file was "
        + ", ".join(f"{number} x {what}" for what, number in told.items())
        + f"; went on to its end {ends + 1} times, the last with exit code {code}, "
        + ("bit for bit" if same else "TO ANOTHER FILE")
        + f"; left beside it: {', '.join(left)}"
    )
    for path in (whole, file):
        path.unlink()


def saves(port: int, number: int, told: list[str]) -> None:
    """Save designs until the server is gone; note those that it has acknowledged."""
    connection = http.client.HTTPConnection("127.0.0.1", port)
    headers = {"content-type": "application/json", "authorization": f"Bearer {TOKEN}"}
    body: dict[str, Any] = {"document": document(), "note": "x" * 2000}
    for count in range(1_000_000):
        body["name"] = f"{os.getpid()} {threading.get_ident()} {number} {count} {time.time_ns()}"
        try:
            connection.request("POST", f"{API}/designs", json.dumps(body), headers)
            answer = connection.getresponse()
            answer.read()
        except (OSError, http.client.HTTPException):
            return
        if answer.status == 201:
            told.append(body["name"])


def a_server(folder: Path, kills: int, draw: random.Random) -> None:
    """Kill a server again and again while designs are saved; print what was found."""
    file, told, sound = folder / "designs.sqlite", list[str](), 0
    os.environ["WRAPARC_TOKEN"] = TOKEN
    for _ in range(kills):
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        command = ["serve", "--port", str(port), "--workers", "0", "--database", str(file)]
        server = forked(lambda command=command: run(command))  # type: ignore[misc]
        while True:
            with suppress(OSError):
                socket.create_connection(("127.0.0.1", port)).close()
                break
        threads = [threading.Thread(target=saves, args=(port, n, told)) for n in range(SAVERS)]
        for thread in threads:
            thread.start()
        assert killed(server, draw.uniform(0.5, 3.0))
        for thread in threads:
            thread.join()
        with closing(sqlite3.connect(file)) as found:
            sound += found.execute("PRAGMA integrity_check").fetchone() == ("ok",)
            names = {name for (name,) in found.execute("SELECT name FROM designs")}
        assert set(told) <= names, "a design that was acknowledged is lost"
    print(
        f"server: {kills} kills while {SAVERS} clients saved; file sound after {sound}; "
        f"{len(told)} saves acknowledged, all {len(told)} there, {len(names) - len(told)} more "
        "whose answer was cut off"
    )


def main() -> None:
    """Kill."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--kills", type=int, default=20)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", default="", help="what begins so, of those told")
    told = parser.parse_args()
    draw = random.Random(told.seed)  # noqa: S311 - moments, no secrets
    setattr(Checkpoint, "due", Checkpoint.save)  # noqa: B010 - as often as can be
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        for name, work in works(folder).items():
            if name.startswith(told.only):
                one_work(folder, name, work, told.kills, draw)
        if "server".startswith(told.only):
            a_server(folder, told.kills, draw)


if __name__ == "__main__":
    main()
