"""Connections to the database, and its migrations."""

import os
import sqlite3
from contextlib import closing
from pathlib import Path
from threading import Lock
from typing import Any

from alembic import command
from alembic.config import Config
from alembic.runtime.migration import MigrationContext
from alembic.script import ScriptDirectory
from alembic.util import CommandError
from sqlalchemy import Connection, Engine, create_engine, event, text
from sqlalchemy.exc import ArgumentError, SQLAlchemyError
from sqlalchemy.pool import StaticPool

from wraparc.errors import InputError, Problem
from wraparc.saving import replacing

MIGRATIONS = Path(__file__).with_name("migrations")
#: Execution option of a transaction that will write.
WRITES = "wraparc_writes"
_BUSY_MS = 15_000
_CHECK = "Check that it is there and can be written, or name another with --database."
_migrating = Lock()  # alembic has one context in a process
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
            with _migrating:
                if engine.dialect.name == "sqlite":
                    _sound_and_kept(engine)
                with engine.execution_options(**{WRITES: True}).begin() as connection:
                    migrate(connection)
        except BaseException:
            engine.dispose()
            raise
    except CommandError:
        message = "this database was made by a newer version of wraparc"
        raise _unusable(shown, message, "Update wraparc, or name another database.") from None
    except ArgumentError:
        message = "is no URL of a database"
        raise _unusable(shown, message, "Write postgresql://user@host/name.") from None
    except (SQLAlchemyError, sqlite3.Error, OSError) as error:
        raise _unusable(shown, f"cannot be used: {reason(error)}", _CHECK) from None
    return engine


def reason(error: Exception) -> str:
    """Return what a database says of an error, in its own first line."""
    return str(getattr(error, "orig", None) or error).strip().splitlines()[0][:300]


def _sound_and_kept(engine: Engine) -> None:
    """Look whether a file is damaged, and keep a copy of it before its tables are changed."""
    file = engine.url.database
    if not file or not os.path.exists(file) or not os.path.getsize(file):
        return
    with engine.connect() as connection:
        found = connection.exec_driver_sql("PRAGMA quick_check(1)").scalar()
        if found != "ok":
            raise sqlite3.DatabaseError(
                f"the file is damaged ({str(found).splitlines()[-1][:100]})"
            )
        now = MigrationContext.configure(connection).get_current_revision()
        newest = ScriptDirectory.from_config(configuration()).get_heads()
        if now is None or now in newest or now > max(newest):
            return
        kept = Path(f"{file}.before-{max(newest)}")
        source = connection.connection.driver_connection
        if not kept.exists() and isinstance(source, sqlite3.Connection):
            with replacing(kept) as draft, closing(sqlite3.connect(draft)) as copy:
                source.backup(copy)


def _engine(url: str) -> Engine:
    if not url.startswith("sqlite"):
        return create_engine(url, pool_pre_ping=True, pool_size=5, connect_args=_patience())
    memory = url.rstrip("/") in ("sqlite:", "sqlite:///:memory:")
    more: dict[str, Any] = {"poolclass": StaticPool} if memory else {}
    engine = create_engine(url, connect_args={"check_same_thread": False}, **more)
    event.listen(engine, "connect", _prepare_sqlite)
    event.listen(engine, "begin", _begin_sqlite)
    return engine


def _patience() -> dict[str, Any]:
    return {"connect_timeout": 5}


def _prepare_sqlite(connection: Any, _: object) -> None:
    """Make every commit last: written through to the disk before it is answered."""
    connection.isolation_level = None  # transactions are begun below
    cursor = connection.cursor()
    cursor.execute(f"PRAGMA busy_timeout={_BUSY_MS}")
    cursor.execute("PRAGMA journal_mode=WAL")
    cursor.execute("PRAGMA synchronous=FULL")
    cursor.execute("PRAGMA foreign_keys=ON")
    cursor.close()


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
    return InputError(Problem(key="--database", value=shown, message=message, remedy=remedy))
