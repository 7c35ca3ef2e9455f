"""Saved designs: the same on SQLite and PostgreSQL, both real; nothing saved is ever lost."""

import errno
import os
import shutil
import signal
import sqlite3
import threading
from collections.abc import Iterator
from contextlib import closing
from datetime import datetime
from http.client import HTTPException
from pathlib import Path
from typing import Any

import pytest
from alembic.autogenerate import compare_metadata
from alembic.runtime.migration import MigrationContext
from sqlalchemy import create_engine, event, text

from web.calculators import API, PATIENCE, Process, client, document, serving
from web.postgres import PostgreSQL, postgresql
from wraparc.errors import InputError
from wraparc.web.database import engine
from wraparc.web.database.engine import _to_wal, migrate, open_engine
from wraparc.web.database.place import database_url, user_folder
from wraparc.web.database.store import NewerVersionError, NoSuchDesignError, Store, VersionAnswer
from wraparc.web.database.tables import Base
from wraparc.web.errors import ApiError


@pytest.fixture(scope="module")
def server() -> Iterator[PostgreSQL]:
    with postgresql() as found:
        yield found


@pytest.fixture(params=["sqlite", "postgresql"])
def url(request: pytest.FixtureRequest, tmp_path: Path) -> Iterator[str]:
    if request.param == "sqlite":
        yield f"sqlite:///{tmp_path}/designs.sqlite"
        return
    yield from emptied(request.getfixturevalue("server"))


@pytest.fixture
def on_postgresql(server: PostgreSQL) -> Iterator[str]:
    yield from emptied(server)


def emptied(server: PostgreSQL) -> Iterator[str]:
    """Lend its database, and take everything out of it again."""
    yield server.url
    engine = create_engine(server.url)
    with engine.begin() as connection:
        connection.execute(text("DROP SCHEMA public CASCADE"))
        connection.execute(text("CREATE SCHEMA public"))
    engine.dispose()


@pytest.fixture
def store(url: str) -> Iterator[Store]:
    found = Store.open(url)
    yield found
    found.close()


def save(store: Store, name: str = "Kopfantrieb ä 世界", **more: Any) -> VersionAnswer:
    return store.create(name, "drive", document(), **{"note": "", "who": "somebody", **more})


def test_a_design_comes_back_as_it_was_saved(store: Store) -> None:
    made = save(store, note='zero "quotes"; DROP TABLE designs; -- 100 %')
    found = store.version(made.id, 1)
    assert found.document == document()
    assert found.note == 'zero "quotes"; DROP TABLE designs; -- 100 %'
    assert found.name == "Kopfantrieb ä 世界"
    assert found.created == made.created
    assert found.model_dump()["created"].endswith("Z")


def test_versions_follow_each_other_and_stay(store: Store) -> None:
    made = save(store)
    changed = document()
    changed["belt"]["width"] = "1400 mm"
    second = store.add(made.id, 1, "drive", changed, note="wider", who="b")
    assert second.version == 2
    assert store.version(made.id, 1).document == document()
    assert store.version(made.id, 2).document == changed
    with pytest.raises(NewerVersionError) as raised:
        store.add(made.id, 1, "drive", document(), note="", who="c")
    assert raised.value.newest == 2
    listed = store.design(made.id)
    assert [v.version for v in listed.versions] == [1, 2]
    assert (listed.note, listed.newest) == ("wider", 2)


def test_lists_are_searched_and_cut(store: Store) -> None:
    for number in range(7):
        save(store, f"Drive {number} 50%_x")
    save(store, "other")
    found = store.listed("drive", 0, 5)
    assert (found.total, len(found.designs)) == (7, 5)
    assert found.designs[0].name == "Drive 6 50%_x"
    assert len(store.listed("drive", 5, 5).designs) == 2
    assert store.listed("50%_").total == 7
    assert store.listed("%").total == 7  # a sign of the name, no wildcard
    assert store.listed("_o").total == 0


def test_a_design_is_renamed_and_deleted_with_its_versions(store: Store, url: str) -> None:
    made = save(store)
    store.add(made.id, 1, "drive", document(), note="", who="")
    store.rename(made.id, "new")
    assert store.design(made.id).name == "new"
    store.throw_away(made.id)
    assert store.listed("new").total == 0
    for missing in (
        lambda: store.design(made.id),
        lambda: store.version(made.id, 1),
        lambda: store.rename(made.id, "x"),
        lambda: store.throw_away(made.id),
        lambda: store.add(made.id, 2, "drive", document(), note="", who=""),
    ):
        with pytest.raises(NoSuchDesignError):
            missing()
    assert [d.name for d in store.listed(binned=True).designs] == ["new"]
    store.take_back(made.id)
    assert store.design(made.id).newest == 2
    with pytest.raises(NoSuchDesignError):
        store.delete(made.id)  # only what is in the bin goes for good
    store.throw_away(made.id)
    store.delete(made.id)
    assert store.listed(binned=True).total == 0
    engine = create_engine(url)
    with engine.begin() as connection:
        assert connection.execute(text("SELECT count(*) FROM versions")).scalar() == 0
    engine.dispose()


def test_a_refused_version_does_not_rename(store: Store) -> None:
    made = save(store, "old")
    second = store.add(made.id, 1, "drive", document(), note="", who="", name="new")
    assert (second.name, second.version) == ("new", 2)
    with pytest.raises(NewerVersionError):
        store.add(made.id, 1, "drive", document(), note="", who="", name="refused")
    assert store.design(made.id).name == "new"


def test_what_is_sent_twice_is_saved_once(store: Store) -> None:
    made = [save(store, "once", request="key-1") for _ in range(2)]
    assert made[0] == made[1]
    added = [
        store.add(made[0].id, 1, "drive", document(), note="", who="", request="key-2")
        for _ in range(2)
    ]
    assert added[0] == added[1]
    assert added[0].version == 2
    assert store.listed("once").total == 1
    with pytest.raises(ApiError, match="another design"):
        store.create("x", "drive", {"other": 1}, note="", who="", request="key-1")
    with pytest.raises(NewerVersionError):
        store.add(made[0].id, 1, "drive", document(), note="", who="", request="key-3")


@pytest.mark.processes
def test_of_many_who_save_at_once_one_wins_and_nothing_is_lost(store: Store) -> None:
    made = save(store)
    won, lost = [], []
    start = threading.Barrier(6)

    def work(number: int) -> None:
        start.wait()
        save(store, f"own {number}")
        try:
            won.append(store.add(made.id, 1, "drive", document(), note=str(number), who=""))
        except NewerVersionError:
            lost.append(number)

    threads = [threading.Thread(target=work, args=(n,)) for n in range(6)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert (len(won), len(lost)) == (1, 5)
    assert store.listed("own").total == 6
    assert store.design(made.id).newest == 2


def test_migrations_make_the_tables_of_the_program(url: str) -> None:
    engine = open_engine(url, "")
    with engine.begin() as connection:
        assert compare_metadata(MigrationContext.configure(connection), Base.metadata) == []
    engine.dispose()
    again = open_engine(url, "")  # nothing is left to do, and nothing is done twice
    again.dispose()


@pytest.mark.processes
def test_servers_that_start_together_migrate_once(url: str) -> None:
    errors: list[BaseException] = []

    def start() -> None:
        try:
            Store.open(url).close()
        except BaseException as error:  # noqa: BLE001
            errors.append(error)

    threads = [threading.Thread(target=start) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert errors == []


def test_a_newer_database_is_refused(url: str) -> None:
    open_engine(url, "").dispose()
    engine = create_engine(url)
    with engine.begin() as connection:
        connection.execute(text("UPDATE alembic_version SET version_num = '9999'"))
    engine.dispose()
    with pytest.raises(InputError, match="made by a newer wraparc"):
        open_engine(url, "designs")


def test_what_is_no_database_is_refused_in_a_sentence(tmp_path: Path) -> None:
    file = tmp_path / "designs.sqlite"
    file.write_text("no database at all, and long enough to be looked at" * 20)
    for url in (
        f"sqlite:///{file}",
        f"sqlite:///{tmp_path}/none/designs.sqlite",
        "postgresql+psycopg://nobody:secret@/nothing?host=/nowhere",
    ):
        with pytest.raises(InputError) as raised:
            open_engine(url, "shown")
        told = str(raised.value)
        assert told.startswith("--database: ")
        assert ", got shown. " in told
        assert "secret" not in told
        assert "\n" not in told
    assert file.read_text().startswith("no database")


def file_of(tmp_path: Path) -> tuple[Path, str]:
    file = tmp_path / "designs.sqlite"
    return file, f"sqlite:///{file}"


def test_an_older_database_is_kept_before_it_is_changed(tmp_path: Path) -> None:
    file, url = file_of(tmp_path)
    engine = create_engine(url)
    with engine.begin() as connection:
        migrate(connection, "0001")
        connection.execute(
            text(
                "INSERT INTO designs (name, kind, created, changed, newest) "
                "VALUES ('old', 'drive', '2024-01-01', '2024-01-01', 1)"
            )
        )
        connection.execute(
            text(
                "INSERT INTO versions (design_id, number, created, who, note, document, program) "
                "VALUES (1, 1, '2024-01-01', '', '', '{}', '0')"
            )
        )
    engine.dispose()
    store = Store.open(url)
    assert [d.name for d in store.listed().designs] == ["old"]
    store.close()
    with closing(sqlite3.connect(f"{file}.before-0002")) as kept:
        assert kept.execute("SELECT name FROM designs").fetchall() == [("old",)]
        assert "binned" not in kept.execute("SELECT sql FROM sqlite_master").fetchone()[0]


def test_a_damaged_database_is_told_and_left_as_it_is(tmp_path: Path) -> None:
    file, url = file_of(tmp_path)
    store = Store.open(url)
    for number in range(20):
        save(store, f"design {number}")
    store.close()
    content = bytearray(file.read_bytes())
    middle = len(content) // 2
    content[middle : middle + 4096] = b"\xff" * 4096
    file.write_bytes(content)
    with pytest.raises(InputError, match=r"damaged|malformed"):
        open_engine(url, "shown")
    assert file.read_bytes() == content


def test_a_damaged_database_names_the_copy_of_its_last_sound_state(tmp_path: Path) -> None:
    file, url = file_of(tmp_path)
    for number in range(20):  # each start keeps what was there
        store = Store.open(url)
        save(store, f"design {number}")
        store.close()
    kept = tmp_path / "designs.sqlite.backup"
    file.write_bytes(file.read_bytes()[:5000])
    with pytest.raises(InputError) as caught:
        open_engine(url, "shown")
    day = datetime.fromtimestamp(kept.stat().st_mtime).astimezone()
    assert str(caught.value).endswith(
        f', got shown. Give a copy of "{kept}" ({day:%Y-%m-%d %H:%M}).'
    )
    assert str(caught.value).startswith("--database: the file is damaged (")
    copied = kept.read_bytes()
    again = Store.open(f"sqlite:///{shutil.copy(kept, tmp_path / 'copy.sqlite')}")
    assert again.listed().total == 19
    again.close()
    assert kept.read_bytes() == copied


def test_a_copy_is_made_only_of_what_has_changed(tmp_path: Path) -> None:
    file, url = file_of(tmp_path)
    kept = tmp_path / "designs.sqlite.backup"
    Store.open(url).close()
    assert not kept.exists()  # there was nothing to lose
    Store.open(url).close()
    second = 10**9
    os.utime(kept, ns=(second, second))
    for changed, anew in ((0, False), (2 * second, True)):
        os.utime(file, ns=(changed, changed))
        Store.open(url).close()
        assert (kept.stat().st_mtime_ns != second) == anew


def test_no_room_for_the_copy_keeps_nobody_from_working(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*_: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    _, url = file_of(tmp_path)
    Store.open(url).close()
    monkeypatch.setattr(engine, "replacing", full)
    store = Store.open(url)
    assert save(store).id == 1
    store.close()


def test_servers_that_make_a_file_together_wait_for_each_other() -> None:
    """SQLite refuses at once who would switch to the log while another does."""
    asked = []

    class Cursor:
        def execute(self, sql: str) -> None:
            asked.append(sql)
            if len(asked) < 3:
                error = sqlite3.OperationalError("database is locked")
                error.sqlite_errorcode = sqlite3.SQLITE_BUSY
                raise error
            if len(asked) == 4:
                error = sqlite3.OperationalError("disk I/O error")
                error.sqlite_errorcode = sqlite3.SQLITE_IOERR
                raise error

    _to_wal(Cursor())
    assert asked == ["PRAGMA journal_mode=WAL"] * 3
    with pytest.raises(sqlite3.OperationalError, match="I/O"):
        _to_wal(Cursor())


def test_a_full_disk_is_told_and_loses_nothing(tmp_path: Path) -> None:
    _, url = file_of(tmp_path)
    store = Store.open(url)
    before = save(store, "before")
    full = store._engine.execution_options()
    with full.connect() as connection:
        pages = connection.exec_driver_sql("PRAGMA page_count").scalar()
    event.listen(store._engine, "connect", lambda c, _: c.execute(f"PRAGMA max_page_count={pages}"))
    store._engine.dispose()
    with pytest.raises(ApiError, match="full") as raised:
        save(store, "more", note="x" * 100_000)
    assert raised.value.status_code == 507
    assert store.version(before.id, 1).document == document()
    store.close()


def test_two_servers_on_one_file_lose_nothing(tmp_path: Path) -> None:
    _, url = file_of(tmp_path)
    stores = [Store.open(url) for _ in range(2)]
    errors: list[BaseException] = []

    def work(number: int) -> None:
        try:
            for count in range(20):
                save(stores[number], f"{number}-{count}")
        except BaseException as error:  # noqa: BLE001
            errors.append(error)

    threads = [threading.Thread(target=work, args=(n,)) for n in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert errors == []
    for store in stores:
        assert store.listed().total == 40
        store.close()


def test_a_list_asks_twice_however_many_designs_there_are(store: Store) -> None:
    for number in range(30):
        save(store, f"{number}")
    asked: list[str] = []
    event.listen(store._engine, "before_cursor_execute", lambda *e: asked.append(e[2]))
    assert len(store.listed(limit=30).designs) == 30
    assert len([one for one in asked if one.lstrip().startswith("SELECT")]) == 2


def test_a_list_of_many_is_not_sorted_anew(tmp_path: Path) -> None:
    # `benchmarks/web_designs.py` measures it; the plan is what makes it quick
    store = Store.open(file_of(tmp_path)[1])
    save(store)
    asked: list[tuple[str, Any]] = []
    event.listen(store._engine, "before_cursor_execute", lambda *e: asked.append((e[2], e[3])))
    store.listed()
    listing = [one for one in asked if "ORDER BY" in one[0]]
    with store._engine.connect() as connection:
        plan = [
            str(row)
            for sql, given in listing
            for row in connection.exec_driver_sql(f"EXPLAIN QUERY PLAN {sql}", given)
        ]
    assert any("ix_designs_listed" in row for row in plan)
    assert not any("TEMP B-TREE" in row for row in plan)
    store.close()


def test_urls_of_databases(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("WRAPARC_DATA", str(tmp_path / "data"))
    assert user_folder() == tmp_path / "data"
    assert database_url(None) == f"sqlite:///{tmp_path}/data/designs.sqlite"
    assert (tmp_path / "data").is_dir()
    assert database_url(f"{tmp_path}/a.db") == f"sqlite:///{tmp_path}/a.db"
    assert database_url("postgresql://u@h/n") == "postgresql+psycopg://u@h/n"
    with pytest.raises(InputError, match="no database that can be used"):
        database_url("mysql://u:secret@h/n")


def test_every_commit_is_written_through(tmp_path: Path) -> None:
    engine = open_engine(f"sqlite:///{tmp_path}/designs.sqlite", "")
    with engine.begin() as connection:
        for name, value in (("journal_mode", "wal"), ("synchronous", 2), ("foreign_keys", 1)):
            assert connection.exec_driver_sql(f"PRAGMA {name}").scalar() == value
    engine.dispose()


@pytest.mark.processes
def test_a_database_that_is_restarted_has_lost_nothing(
    server: PostgreSQL, on_postgresql: str
) -> None:
    """It ends as by a crash, and comes back; the server goes on by itself."""
    store = Store.open(on_postgresql)
    for number in range(3):
        save(store, f"before {number}")
    server.stop(signal.SIGQUIT)
    try:
        with pytest.raises(ApiError, match="Leave the page open") as raised:
            save(store, "while it is down")
        assert raised.value.status_code == 503
        with pytest.raises(ApiError, match="Try again in a moment"):
            store.listed()
    finally:
        server.start()
    save(store, "after")
    server.stop()
    server.start()
    names = [design.name for design in store.listed().designs]
    assert names == ["after", "before 2", "before 1", "before 0"]
    store.close()


def test_a_save_whose_fate_is_not_known_is_not_called_lost(on_postgresql: str) -> None:
    store, other = Store.open(on_postgresql), create_engine(on_postgresql)

    def cut_off(connection: Any) -> None:
        """End the connection just before it commits."""
        number = connection.exec_driver_sql("SELECT pg_backend_pid()").scalar()
        with other.begin() as killer:
            killer.execute(text("SELECT pg_terminate_backend(:n)"), {"n": number})

    event.listen(store._engine, "commit", cut_off)
    with pytest.raises(ApiError, match="See whether it is listed") as raised:
        save(store)
    assert raised.value.status_code == 503
    event.remove(store._engine, "commit", cut_off)
    assert save(store, "another").id
    other.dispose()
    store.close()


@pytest.mark.processes
def test_a_killed_server_has_lost_no_saved_design(tmp_path: Path) -> None:
    # saved by several clients at once; the process is killed (SIGKILL) in the middle
    file = tmp_path / "designs.sqlite"
    server = Process("--database", str(file), "--workers", "0")
    told: list[str] = []
    enough = threading.Event()

    def keep_saving(number: int) -> None:
        for count in range(1000):
            name = f"{number}-{count}"
            body = {"name": name, "document": document(), "note": "x" * 2000}
            try:
                answer = server.ask(f"{API}/designs", body)
            except (OSError, HTTPException):  # refused, cut off, or cut off in its answer
                return
            if answer.status == 201:
                told.append(name)
            if len(told) >= 10:
                enough.set()

    threads = [threading.Thread(target=keep_saving, args=(n,)) for n in range(4)]
    for thread in threads:
        thread.start()
    assert enough.wait(PATIENCE)
    server.kill()
    for thread in threads:
        thread.join()
    with sqlite3.connect(file) as connection:
        assert connection.execute("PRAGMA integrity_check").fetchone() == ("ok",)
    connection.close()
    with serving("--database", str(file), "--workers", "0") as again:
        found = again.ask(f"{API}/designs?limit=200").json()
        assert set(told) <= {d["name"] for d in found["designs"]}
        newest = again.ask(f"{API}/designs/{found['designs'][0]['id']}/versions/1").json()
        assert newest["document"] == document()


def test_the_api_saves_opens_and_tells_of_conflicts(url: str) -> None:
    with client(database=url) as api:
        body = {"name": "mine", "document": document(), "note": "first", "who": "A"}
        made = api.post(f"{API}/designs", json=body)
        assert made.status_code == 201
        path = f"{API}/designs/{made.json()['id']}"
        version = {"document": document("tandem-fabric"), "base": 1, "note": "second"}
        added = api.post(f"{path}/versions", json=version)
        assert (added.status_code, added.json()["kind"]) == (201, "train")
        conflict = api.post(f"{path}/versions", json=version)
        assert conflict.status_code == 409
        assert "version 2" in conflict.json()["problems"][0]["message"]
        assert api.get(f"{path}/versions/1").json()["document"] == document()
        assert api.patch(path, json={"name": "yours"}).status_code == 204
        assert api.get(path).json()["name"] == "yours"
        wrong = {"name": "x", "document": {"format": 1}}
        assert api.post(f"{API}/designs", json=wrong).status_code == 422
        for bad in ({"name": ""}, {"name": "a\x00b"}, {"name": "x" * 201}, {"name": "\ud800"}):
            assert api.patch(path, content=_ascii(bad)).status_code == 422
        assert api.get(f"{API}/designs?query=%00your").json()["total"] == 1
        assert api.delete(path).status_code == 204
        assert api.get(path).status_code == 404
        assert api.delete(path).status_code == 404
        assert api.get(f"{API}/designs?bin=true").json()["total"] == 1
        assert api.post(f"{path}/restore").status_code == 204
        assert api.get(path).is_success
        assert api.delete(f"{path}?final=true").status_code == 404
        assert api.delete(path).status_code == 204
        assert api.delete(f"{path}?final=true").status_code == 204
        assert api.post(f"{path}/restore").status_code == 404


def test_a_save_says_where_it_is_and_reads_can_be_asked_again() -> None:
    with client() as api:
        body = {"name": "mine", "document": document()}
        key = {"idempotency-key": "a1"}
        made = [api.post(f"{API}/designs", json=body, headers=key) for _ in range(2)]
        assert made[0].json() == made[1].json()
        place = made[0].headers["location"]
        found = api.get(place)
        assert found.json()["document"] == document()
        again = api.get(place, headers={"if-none-match": found.headers["etag"]})
        assert (again.status_code, again.content) == (304, b"")
        head = api.head(place)
        assert (head.status_code, head.content) == (200, b"")
        assert head.headers["etag"] == found.headers["etag"]
        assert head.headers["content-length"] == str(len(found.content))
        version = {"document": document(), "base": 1, "name": "yours"}
        added = api.post(f"{API}/designs/1/versions", json=version)
        assert added.headers["location"].endswith("/designs/1/versions/2")
        refused = api.post(f"{API}/designs/1/versions", json={**version, "name": "theirs"})
        assert refused.status_code == 409
        assert api.get(f"{API}/designs/1").json()["name"] == "yours"


def _ascii(data: Any) -> bytes:
    import json

    return json.dumps(data).encode()
