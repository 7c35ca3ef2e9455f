"""Saved designs: the same on SQLite and PostgreSQL, both real; nothing saved is ever lost."""

import sqlite3
import threading
from collections.abc import Iterator
from http.client import HTTPException
from pathlib import Path
from typing import Any

import pytest
from alembic.autogenerate import compare_metadata
from alembic.runtime.migration import MigrationContext
from sqlalchemy import create_engine, text

from web.calculators import API, PATIENCE, Process, client, document, serving
from web.postgres import postgresql
from wraparc.errors import InputError
from wraparc.web.database.engine import open_engine
from wraparc.web.database.place import database_url, user_folder
from wraparc.web.database.store import NewerVersionError, NoSuchDesignError, Store, VersionAnswer
from wraparc.web.database.tables import Base


@pytest.fixture(scope="module")
def server() -> Iterator[str]:
    with postgresql() as url:
        yield url


@pytest.fixture(params=["sqlite", "postgresql"])
def url(request: pytest.FixtureRequest, tmp_path: Path) -> Iterator[str]:
    if request.param == "sqlite":
        yield f"sqlite:///{tmp_path}/designs.sqlite"
        return
    found: str = request.getfixturevalue("server")
    yield found
    engine = create_engine(found)
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
    return store.create(name, "drive", document(), note=more.get("note", ""), who="somebody")


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
    store.delete(made.id)
    for missing in (
        lambda: store.design(made.id),
        lambda: store.version(made.id, 1),
        lambda: store.rename(made.id, "x"),
        lambda: store.delete(made.id),
        lambda: store.add(made.id, 2, "drive", document(), note="", who=""),
    ):
        with pytest.raises(NoSuchDesignError):
            missing()
    engine = create_engine(url)
    with engine.begin() as connection:
        assert connection.execute(text("SELECT count(*) FROM versions")).scalar() == 0
    engine.dispose()


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
    with pytest.raises(InputError, match="newer version of wraparc"):
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
        assert "--database = shown" in told
        assert "secret" not in told
        assert "\n" not in told
    assert file.read_text().startswith("no database")


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


def _ascii(data: Any) -> bytes:
    import json

    return json.dumps(data).encode()
