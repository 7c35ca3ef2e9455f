"""Connections to the database, and its migrations."""

import os
import sqlite3
from contextlib import closing, suppress
from datetime import datetime
from pathlib import Path
from threading import Lock
from time import monotonic, sleep
from typing import Any

from alembic import command
from alembic.config import Config
from alembic.runtime.migration import MigrationContext
from alembic.script import ScriptDirectory
from alembic.util import CommandError
from sqlalchemy import Connection, Engine, create_engine, event, make_url, text
from sqlalchemy.exc import ArgumentError, SQLAlchemyError
from sqlalchemy.pool import StaticPool

from wraparc.errors import InputError, input_error
from wraparc.saving import quoted, replacing
from wraparc.web.private import mend_database

MIGRATIONS = Path(__file__).with_name("migrations")
#: Execution option of a transaction that will write.
WRITES = "wraparc_writes"
_BUSY_MS, _AGAIN = 15_000, 0.02
_CHECK = "Check that it is there and can be written, or name another with --database."
_migrating = Lock()  # alembic has one context in a process
_BACKUP = ".backup"  # of a file, as it was found sound the last time
_LOCK = 0x77726170  # of all servers on one PostgreSQL database while one of them migrates


def open_engine(url: str, shown: str) -> Engine:
    """Return an engine on a database that has every table.

    Parameters
    ----------
    url
        Of the database.
    shown
        The same without secrets.

    Raises
    ------
    InputError
        If it cannot be opened, is no database, or of a newer version of the program.
    """
    try:
        engine = _engine(url)
        try:
            if engine.dialect.name == "sqlite" and engine.url.database:
                mend_database(engine.url.database)
            with _migrating:
                if engine.dialect.name == "sqlite":
                    _sound_and_kept(engine)
                with engine.execution_options(**{WRITES: True}).begin() as connection:
                    migrate(connection)
        except BaseException:
            engine.dispose()
            raise
    except CommandError:
        message = "was made by a newer wraparc"
        raise _unusable(shown, message, "Update wraparc, or name another database.") from None
    except ArgumentError:
        message = "is no URL of a database"
        raise _unusable(shown, message, "Write postgresql://user@host/name.") from None
    except (SQLAlchemyError, sqlite3.Error, OSError) as error:
        if _is_damage(error):
            message = f"the file is damaged ({reason(error)})"
            remedy = _after_damage(make_url(url).database or "")
            raise _unusable(shown, message, remedy) from None
        raise _unusable(shown, f"cannot be used: {reason(error)}", _CHECK) from None
    return engine


def reason(error: Exception) -> str:
    """Return what a database says of an error, in its own first line."""
    return str(getattr(error, "orig", None) or error).strip().splitlines()[0][:300]


def _sound_and_kept(engine: Engine) -> None:
    """Look whether a file is damaged; keep a copy of a sound one, and one before it is changed."""
    file = engine.url.database
    if not file or not os.path.exists(file) or not os.path.getsize(file):
        return
    with engine.connect() as connection:
        found = connection.exec_driver_sql("PRAGMA quick_check(1)").scalar()
        if found != "ok":
            damage = sqlite3.DatabaseError(str(found).splitlines()[-1][:100])
            damage.sqlite_errorcode = sqlite3.SQLITE_CORRUPT
            raise damage
        now = MigrationContext.configure(connection).get_current_revision()
        newest = ScriptDirectory.from_config(configuration()).get_heads()
        source = connection.connection.driver_connection
        if now is None or now > max(newest) or not isinstance(source, sqlite3.Connection):
            return
        if now not in newest and not os.path.exists(kept := f"{file}.before-{max(newest)}"):
            _copy(source, kept)
        with suppress(sqlite3.Error, OSError):  # no room for it is no reason not to serve
            if _changed(file):
                _copy(source, f"{file}{_BACKUP}")


def _changed(file: str) -> bool:
    """Whether a file has changed since its copy was made; what is not in it yet is in its log."""
    kept, log = Path(f"{file}{_BACKUP}"), Path(f"{file}-wal")
    logged = log.exists() and log.stat().st_size > 0
    return not kept.exists() or logged or kept.stat().st_mtime < Path(file).stat().st_mtime


def _copy(source: sqlite3.Connection, to: str) -> None:
    with replacing(Path(to)) as draft, closing(sqlite3.connect(draft)) as copy:
        source.backup(copy)


def _is_damage(error: Exception) -> bool:
    code = getattr(getattr(error, "orig", None) or error, "sqlite_errorcode", 0) & 0xFF
    return code in (sqlite3.SQLITE_CORRUPT, sqlite3.SQLITE_NOTADB)


def _after_damage(file: str) -> str:
    """Say what can be done with a damaged file."""
    kept = Path(f"{file}{_BACKUP}")
    if not kept.exists():
        return f"Repair it: sqlite3 {quoted(file)} .recover."
    day = datetime.fromtimestamp(kept.stat().st_mtime).astimezone()
    return f"Give a copy of {quoted(str(kept))} ({day:%Y-%m-%d %H:%M})."


def _engine(url: str) -> Engine:
    if not url.startswith("sqlite"):
        patience = {"connect_timeout": 5}
        return create_engine(url, pool_pre_ping=True, pool_size=5, connect_args=patience)
    memory = url.rstrip("/") in ("sqlite:", "sqlite:///:memory:")
    more: dict[str, Any] = {"poolclass": StaticPool} if memory else {}
    engine = create_engine(url, connect_args={"check_same_thread": False}, **more)
    event.listen(engine, "connect", _prepare_sqlite)
    event.listen(engine, "begin", _begin_sqlite)
    return engine


def _prepare_sqlite(connection: Any, _: object) -> None:
    """Make every commit last: written through to the disk before it is answered."""
    connection.isolation_level = None  # transactions are begun below
    cursor = connection.cursor()
    cursor.execute(f"PRAGMA busy_timeout={_BUSY_MS}")
    _to_wal(cursor)
    cursor.execute("PRAGMA synchronous=FULL")
    cursor.execute("PRAGMA fullfsync=ON")  # macOS: through the cache of the disk too
    cursor.execute("PRAGMA foreign_keys=ON")
    cursor.close()


def _to_wal(cursor: Any) -> None:
    """Switch to the log; while another server does it, SQLite refuses at once and never waits."""
    end = monotonic() + _BUSY_MS / 1e3
    while True:
        try:
            cursor.execute("PRAGMA journal_mode=WAL")
        except sqlite3.OperationalError as error:
            if error.sqlite_errorcode & 0xFF != sqlite3.SQLITE_BUSY or monotonic() > end:
                raise
            sleep(_AGAIN)
        else:
            return


def _begin_sqlite(connection: Connection) -> None:
    # a transaction that writes takes the lock at once: one that reads first could find it taken
    writes = connection.get_execution_options().get(WRITES)
    connection.exec_driver_sql("BEGIN IMMEDIATE" if writes else "BEGIN")


def migrate(connection: Connection, revision: str = "head") -> None:
    """Bring the tables to a revision; servers that start together take turns."""
    if connection.dialect.name == "postgresql":
        connection.execute(text("SELECT pg_advisory_xact_lock(:key)"), {"key": _LOCK})
    config = configuration()
    config.attributes["connection"] = connection
    command.upgrade(config, revision)


def configuration() -> Config:
    """Return where the migrations are."""
    config = Config()
    config.set_main_option("script_location", MIGRATIONS.as_posix().replace("%", "%%"))
    return config


def _unusable(shown: str, message: str, remedy: str) -> InputError:
    return input_error(key="--database", value=shown, message=message, remedy=remedy)
