"""``wraparc serve``: the calculator in the browser."""

import os
import secrets
from typing import TYPE_CHECKING, Any

import click

from wraparc.errors import input_error, require, shown
from wraparc.saving import interrupted

if TYPE_CHECKING:
    from wraparc.web.settings import Settings


@click.command()
@click.argument("file", type=click.Path(), required=False)
@click.option("--host", default="127.0.0.1", show_default=True, help="Address to listen on.")
@click.option("--port", type=click.IntRange(0, 65535), default=8765, show_default=True)
@click.option(
    "--database", metavar="URL", help="Where designs are saved: a file, or postgresql://..."
)
@click.option(
    "--token",
    metavar="TEXT",
    help='Access token, required outside this machine; "new" makes one. Other users see it in the '
    "list of processes: WRAPARC_TOKEN is safer.",
    envvar="WRAPARC_TOKEN",
)
@click.option("--new-token", is_flag=True, help="Replace your token; the old one stops working.")
@click.option("--name", "names", multiple=True, help="Host name that this server is reached by.")
@click.option("--workers", type=click.IntRange(0, 64), help="Processes that solve.")
@click.option("--open/--no-open", "browser", default=False, help="Open the page in the browser.")
def serve(
    file: str | None,
    host: str,
    port: int,
    database: str | None,
    token: str | None,
    new_token: bool,
    names: tuple[str, ...],
    workers: int | None,
    browser: bool,
) -> int:
    """Serve the calculator as a web page, beginning with a drive FILE.

    Only this machine can reach it unless --host says otherwise, which needs a --token. On this
    machine only who opens the printed address gets in; other users of the machine do not.
    """
    require("web", "fastapi", "uvicorn", "sqlalchemy", "alembic")
    from wraparc.web.private import private_files
    from wraparc.web.serving import run
    from wraparc.web.settings import Settings

    with private_files():
        handed_out = bool(token)
        token = _token(host, token, new_token)
        _check_catalogue()
        start, start_text = _start(file)
        settings = Settings(
            host=host,
            port=port,
            token=token,
            linked=handed_out,
            database=_database(database),
            names=names,
            start=start,
            start_file=file or "",
            start_text=start_text,
            workers=workers if workers is not None else max(1, min(8, os.cpu_count() or 1)),
        )
        with interrupted(lambda: "No saved design is lost."):
            run(settings, tell=_tell, browser=browser)
    return 0


def _token(host: str, given: str | None, new: bool) -> str:
    """Return the token of this run: as given, made, or kept for this user."""
    from wraparc.web.database.place import user_folder
    from wraparc.web.settings import is_loopback
    from wraparc.web.token import own_token

    if new and given:
        message = "contradicts the token in --token or WRAPARC_TOKEN"
        remedy = "Leave out one of the two."
        raise input_error(key="--new-token", message=message, remedy=remedy)
    if given == "new":
        given = secrets.token_urlsafe(24)
    if not given and is_loopback(host):
        given = own_token(user_folder(), new=new)
    return _checked_token(host, given)


def _check_catalogue() -> None:
    """Read the user's own laggings and belts: what is wrong is told before anything starts."""
    from wraparc import catalogue
    from wraparc.files import load_lagging_conditions

    catalogue.belts()
    for name in catalogue.own_lagging_names():
        load_lagging_conditions(name)


def _checked_token(host: str, token: str | None) -> str:
    from wraparc.web.token import TOKEN

    if not token:
        raise input_error(
            key="--host",
            value=shown(host),
            message="the server would be open to the network",
            remedy="Add --token new, or leave out --host.",
        )
    if not TOKEN.fullmatch(token):
        raise input_error(
            key="--token",
            message="must be at least 16 letters, digits, - or _",
            remedy="Write --token new to have one made.",
        )
    return token


def _start(file: str | None) -> tuple[dict[str, Any] | None, str]:
    if file is None:
        return None, ""
    from wraparc.schema.source import read_text
    from wraparc.web.opening import opened

    return opened(file), read_text(file)


def _database(given: str | None) -> str:
    from wraparc.web.database.place import database_url

    return database_url(given)


def _tell(settings: "Settings") -> None:
    click.echo(f"Calculator: {settings.address}")
    click.echo(f"Designs: {settings.shown_database}")
    click.echo("Stop: Ctrl+C")
