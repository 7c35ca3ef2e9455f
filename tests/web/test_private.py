"""Another user of the machine sees neither the token nor a design: modes, and tried as one."""

import json
import os
import re
import subprocess
import sys
import tempfile
import urllib.error
import urllib.request
from collections.abc import Iterator
from contextlib import contextmanager, nullcontext
from pathlib import Path
from urllib.parse import unquote, urlsplit

import pytest
from sqlalchemy import create_engine

from cli.running import wraparc
from web.browser import READY, browser
from web.calculators import API, TOKEN, client, document, serving, wait_for
from wraparc.errors import InputError
from wraparc.web.database.engine import migrate
from wraparc.web.private import private_files
from wraparc.web.token import own_token

_NOBODY = 65534


def mode(path: Path) -> int:
    """Return what is allowed to whom."""
    return path.stat().st_mode & 0o777


def others_read(path: Path) -> bool:
    """Whether another user reads a file: tried where this runs as root, else by its modes."""
    if os.getuid():
        return bool(mode(path) & 0o044) and bool(mode(path.parent) & 0o011)
    return not subprocess.run(
        ["/bin/cat", path],
        check=False,
        capture_output=True,
        user=_NOBODY,
        group=_NOBODY,
        extra_groups=[],
    ).returncode


@contextmanager
def usual_umask() -> Iterator[None]:
    """Let new files be readable by all, as most systems do."""
    before = os.umask(0o022)
    try:
        yield
    finally:
        os.umask(before)


@pytest.fixture
def home(monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """Give a home that others may enter; that of pytest is closed to them as a whole."""
    with tempfile.TemporaryDirectory() as made:
        Path(made).chmod(0o755)
        monkeypatch.delenv("WRAPARC_DATA", raising=False)
        monkeypatch.setenv("XDG_DATA_HOME", made)
        yield Path(made)


@pytest.mark.processes
def test_nobody_else_reads_what_is_saved_and_old_files_are_mended(home: Path) -> None:
    # expected: 0600 and 0700, as ssh keeps its keys; what earlier versions left was 0644 and 0755
    folder = home / "wraparc"
    file = folder / "designs.sqlite"
    with usual_umask():
        folder.mkdir()
        engine = create_engine(f"sqlite:///{file}")
        with engine.begin() as connection:
            migrate(connection, "0001")
        engine.dispose()
        for left in ("designs.sqlite.before-0001", ".designs.sqlite.backup.1-ab.tmp", "token"):
            (folder / left).write_text("a secret of before")
        assert (mode(folder), mode(file)) == (0o755, 0o644)
        assert others_read(file)
        with serving("--workers", "0") as server:
            kept = {"name": "mine", "document": document()}
            assert server.ask(f"{API}/designs", kept).status == 201
            found = {path.name: mode(path) for path in folder.iterdir()}
            assert found.pop("token") == 0o644  # not read here: a token is given
            assert set(found.values()) == {0o600}
            names = ("", "-wal", "-shm", ".backup", ".before-0001", ".before-0002")
            assert {f"designs.sqlite{end}" for end in names} <= set(found)
            assert mode(folder) == 0o700
            assert not any(others_read(folder / name) for name in found)
            folder.chmod(0o755)  # the files hold by themselves
            assert others_read(folder / "token")
            assert not any(others_read(folder / name) for name in found)


def test_a_database_that_is_named_is_closed_and_its_folder_left(home: Path) -> None:
    named = f"sqlite:///{home / 'd.sqlite'}"
    with usual_umask(), private_files(), client(database=named) as server:
        assert server.get(f"{API}/designs").status_code == 200
        assert mode(home) == 0o755  # it may hold what is meant for others
        assert {mode(path) for path in home.glob("d.sqlite*")} == {0o600}
        assert not others_read(home / "d.sqlite")


@pytest.mark.processes
def test_the_browser_is_given_a_file_that_nobody_else_reads(
    home: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # what a browser is started with is its command line, which `ps` shows to every user; that a new
    # token takes the place of the old one is seen by the way
    folder = home / "wraparc"
    old = own_token(folder)
    script, seen = home / "browser.py", home / "seen.json"
    script.write_text(
        "import json, pathlib, sys\n"
        f"draft = pathlib.Path({str(home / 'draft')!r})\n"
        "draft.write_text(json.dumps(sys.argv))\n"
        f"draft.rename({str(seen)!r})\n"
    )
    monkeypatch.setenv("BROWSER", f"{sys.executable} {script} %s")
    asked = ("--workers", "0", "--open", "--token", "", "--new-token")
    with usual_umask(), serving(*asked) as server:
        wait_for(seen.exists)
        given = json.loads(seen.read_text())
        new = own_token(folder)
        assert new not in (old, TOKEN)
        # the browser is given the token of this start; the one that lasts is for programs
        (start,) = re.findall(r"\?token=(\S{16,})", server.told)
        assert start not in (new, old, TOKEN)
        assert new not in server.told
        assert start not in " ".join(given)
        file = Path(unquote(urlsplit(given[-1]).path))
        assert start in file.read_text()
        assert new not in file.read_text()
        assert mode(file) == 0o600
        assert not others_read(file)
        with browser() as found:
            page = found.new_context().new_page()
            page.goto(given[-1])
            page.wait_for_url(f"http://127.0.0.1:{server.port}/")
            page.wait_for_selector(READY["drive"])
        for token, opens in ((new, True), (start, True), (old, False)):
            request = urllib.request.Request(
                f"http://127.0.0.1:{server.port}{API}/designs",
                headers={"authorization": f"Bearer {token}"},
            )
            with nullcontext() if opens else pytest.raises(urllib.error.HTTPError, match="401"):
                urllib.request.urlopen(request).close()  # noqa: S310
        server.stop()
        assert not file.exists()


def test_a_token_that_others_could_know_is_replaced(home: Path) -> None:
    old = own_token(home)
    (home / "token").chmod(0o644)
    new = own_token(home)
    assert new != old
    assert own_token(home) == new
    assert mode(home / "token") == 0o600


def test_a_new_token_that_cannot_be_kept_or_is_not_used_is_told(home: Path) -> None:
    (home / "file").write_text("")
    with pytest.raises(InputError, match="--new-token"):
        own_token(home / "file", new=True)
    code, _, told = wraparc("serve", "--new-token", "--token", TOKEN)
    assert code == 2
    assert "--new-token" in told
    assert TOKEN not in told
