"""``wraparc serve`` as a user starts it: what it says, what it refuses, how it ends."""

import gc
import os
import re
import signal
import socket
import urllib.error
import urllib.request
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest

from cli.running import drive_file, wraparc
from web.calculators import API, Process, document, serving, wait_for
from wraparc.web.token import own_token


@pytest.fixture(scope="module")
def plain(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Process]:
    """A server that only listens: it has no processes to solve in."""
    database = tmp_path_factory.mktemp("designs") / "d.sqlite"
    with serving("--database", str(database), "--workers", "0") as found:
        yield found


@pytest.mark.processes
def test_it_opens_a_file_and_solves_in_other_processes_that_are_replaced(tmp_path: Path) -> None:
    lagging = Path(tmp_path / "mine.toml")
    from wraparc.catalogue import lagging_text

    lagging.write_text(lagging_text("medium-ceramic"), "utf-8")
    text = drive_file(tmp_path).read_text("utf-8")
    file = drive_file(tmp_path, text.replace('"diamond-rubber"', '"mine.toml"'), "own.toml")
    database = tmp_path / "folder" / "designs.sqlite"
    with serving(str(file), "--database", str(database), "--workers", "1") as server:
        assert f"Calculator: http://127.0.0.1:{server.port}/" in server.told
        assert str(database) in server.told
        assert database.exists()
        start = server.ask(f"{API}/start").json()
        assert start["name"] == "own"
        # the lagging file stands in the document: it can be saved, sent and solved elsewhere
        assert start["document"]["pulley"][0]["lagging"] == "medium-ceramic"
        assert "law" in start["document"]["lagging"]["medium-ceramic"]
        fast = server.ask(f"{API}/solve/fast", {"document": start["document"]})
        assert fast.status == 200
        _, out, _ = wraparc("solve", file, "--json", "-")
        exact = re.search(r'"exit_creep": ([-0-9.e]+)', out)
        assert exact
        creep = fast.json()["numbers"]["exit_creep"]
        assert creep == pytest.approx(float(exact[1]), rel=1e-9)
        # what the page would ask first is solved already, as it would be answered
        wait_for(lambda: server.ask(f"{API}/start/solved").status == 200)
        solved = server.ask(f"{API}/start/solved").json()
        asked = {"document": start["document"], "prepared": True}
        quick, whole = (
            server.ask(f"{API}/{path}", asked).json() for path in ("solve/fast", "solve")
        )
        for key in ("verdict", "remarks", "kind"):
            assert (solved["quick"][key], solved["whole"][key]) == (quick[key], whole[key])
        assert solved["quick"]["numbers"]["exit_creep"] == pytest.approx(creep, rel=1e-9)
        assert (solved["quick"]["prepared"], solved["whole"]["judging"]) != (None, None)
        about = server.ask(f"{API}/about").json()
        assert (about["database"], about["token"]) == ("sqlite", True)
        # a worker that dies is replaced
        for pid in _children(server.process.pid):
            os.kill(pid, signal.SIGKILL)
        another = {"document": document()}
        wait_for(lambda: server.ask(f"{API}/solve/fast", another).status == 200)
        assert server.ask(f"{API}/about").json()["name"] == "wraparc"
        code, complaints = server.stop()
        assert code in (0, 130, -2)
        assert "Traceback" not in complaints


def _children(pid: int) -> list[int]:
    """Return the processes of a server's group, itself left out."""
    found = []
    for path in Path("/proc").iterdir():
        if path.name.isdecimal():
            try:
                fields = (path / "stat").read_text().rpartition(")")[2].split()
            except OSError:
                continue
            if int(fields[2]) == pid and int(path.name) != pid:
                found.append(int(path.name))
    return found


def test_beyond_this_machine_it_needs_a_token() -> None:
    for host in ("0.0.0.0", "192.0.2.7", "::", "conveyor.example"):  # noqa: S104
        code, _, told = wraparc("serve", "--host", host)
        assert code == 2
        assert "--token" in told
        assert host in told
    code, _, told = wraparc("serve", "--host", "0.0.0.0", "--token", "short")  # noqa: S104
    assert code == 2
    assert "at least 16" in told


@pytest.mark.processes
def test_beyond_this_machine_with_a_token_it_serves(tmp_path: Path) -> None:
    place = ("--database", str(tmp_path / "d.sqlite"), "--workers", "0")
    with serving("--host", "0.0.0.0", "--token", "new", *place) as server:  # noqa: S104
        found = re.search(r"\?token=(\S{16,})", server.told)
        assert found
        assert server.ask(f"{API}/about").status == 401
        request = urllib.request.Request(
            f"http://127.0.0.1:{server.port}{API}/about",
            headers={"authorization": f"Bearer {found[1]}"},
        )
        with urllib.request.urlopen(request) as answer:  # noqa: S310
            assert answer.status == 200


@pytest.mark.processes
@pytest.mark.parametrize(
    "sent",
    [
        b"GET /api/v1/about HTTP/1.1\r\nHost: 127.0.0.1\r\nX: ",
        b"POST /api/v1/solve HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: 1000\r\n"
        b"Content-Type: application/json\r\n\r\n{",
        b"",
    ],
    ids=["half a head", "half a body", "nothing"],
)
def test_connections_that_send_nothing_whole_keep_nobody_out(plain: Process, sent: bytes) -> None:
    silent = []
    for _ in range(450):
        silent.append(socket.create_connection(("127.0.0.1", plain.port)))
        silent[-1].sendall(sent)
    for _ in range(3):
        assert plain.ask(f"{API}/about").status == 200
    for one in silent:
        one.close()


def test_a_request_that_does_not_come_is_given_up(monkeypatch: pytest.MonkeyPatch) -> None:
    import asyncio

    import uvicorn

    from wraparc.web import connections

    async def app(scope: Any, receive: Any, send: Any) -> None:
        """Answer nothing."""

    async def scenario() -> None:
        monkeypatch.setattr(connections, "HEAD_LIMIT", 0.0)
        config = uvicorn.Config(app, http=connections.Connection, lifespan="off")
        config.load()
        state = uvicorn.server.ServerState()
        loop = asyncio.get_running_loop()
        server = await loop.create_server(
            lambda: connections.Connection(config, state, {}), "127.0.0.1", 0
        )
        reader, writer = await asyncio.open_connection(*server.sockets[0].getsockname())
        writer.write(b"GET / HTTP/1.1\r\n")
        with suppress(ConnectionResetError):
            assert await reader.read() == b""  # closed by the server
        writer.close()
        server.close()
        assert not connections.Connection.silent

    asyncio.run(scenario())


def test_requests_leave_nothing_in_memory() -> None:
    """`benchmarks/web_memory.py` watches a real server for five minutes."""
    from web.calculators import client, document

    drive, turns, counts = document(), 0, []

    def ask(count: int) -> None:
        nonlocal turns
        for _ in range(count):
            turns += 1
            drive["pulley"][0]["exit_tension"] = f"{50 + 0.01 * turns:.2f} kN"
            asked = {"document": drive, "points": 40}
            assert api.post(f"{API}/solve/fast", json=asked).status_code == 200
            made = {"name": f"{turns}", "document": drive}
            assert api.post(f"{API}/designs", json=made).status_code == 201
            assert api.get(f"{API}/designs?limit=5").status_code == 200
            session = api.post(f"{API}/tests").json()["session"]
            assert api.delete(f"{API}/tests/{session}").status_code == 204
            assert api.post(f"{API}/solve/fast", json={"document": {}}).status_code == 422

    with client() as api:
        for count in (10, 50):  # what is loaded once is there after the first
            ask(count)
            gc.collect()
            counts.append(len(gc.get_objects()))
    assert counts[1] - counts[0] < 4 * 50  # an error or a session that is kept is more each time


@pytest.mark.processes
def test_on_one_machine_other_users_are_kept_out(plain: Process) -> None:
    address = f"http://127.0.0.1:{plain.port}"
    with pytest.raises(urllib.error.HTTPError, match="401"):
        urllib.request.urlopen(f"{address}{API}/designs")  # noqa: S310
    # who has the printed address has the token of this start, which no cookie repeats
    opener = urllib.request.build_opener(cookies := urllib.request.HTTPCookieProcessor())
    printed = re.search(r"http://\S+", plain.told)
    assert printed
    page = opener.open(printed[0])
    assert page.status == 200
    assert list(cookies.cookiejar) == []
    token = page.url.partition("token=")[2]
    headers = {"authorization": f"Bearer {token}"}
    designs = urllib.request.Request(f"{address}{API}/designs", headers=headers)  # noqa: S310
    assert urllib.request.urlopen(designs).status == 200  # noqa: S310


def test_the_token_of_a_user_stays_and_is_read_by_nobody_else(tmp_path: Path) -> None:
    folder = tmp_path / "new"
    made = own_token(folder)
    assert own_token(folder) == made
    assert len(made) >= 32
    file = folder / "token"
    assert file.stat().st_mode & 0o077 == 0
    file.write_text("short")
    assert own_token(folder) != "short"
    (tmp_path / "file").write_text("")
    assert own_token(tmp_path / "file") != own_token(tmp_path / "file")  # it cannot be kept


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["none.toml"], "none.toml"),
        (["--port", "99999"], "99999"),
        (["--database", "mysql://u:secret@h/n"], "no database that can be used"),
        (["--database", "postgresql://u:secret@localhost:1/n"], "cannot be used"),
        (["--host", "no.such.host.invalid", "--token", "0123456789abcdef"], "cannot listen"),
    ],
)
def test_what_is_wrong_is_told_before_it_starts(
    arguments: list[str], told: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("WRAPARC_DATA", str(tmp_path))
    code, out, error = wraparc(
        "serve", *([] if "--port" in arguments else ["--port", "0"]), *arguments
    )
    assert code == 2
    assert told in error
    assert "secret" not in error
    assert "Traceback" not in error
    assert "calculator" not in out


@pytest.mark.processes
def test_a_port_that_is_taken(tmp_path: Path) -> None:
    with socket.socket() as other:
        other.bind(("127.0.0.1", 0))
        other.listen()
        port = str(other.getsockname()[1])
        code, _, error = wraparc("serve", "--port", port, "--database", tmp_path / "d.sqlite")
    assert code == 2
    assert "--port" in error
    assert "in use" in error
