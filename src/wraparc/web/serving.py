"""Run one server until it is stopped."""

import logging
import os
import socket
import sys
import threading
import webbrowser
from collections.abc import Callable
from contextlib import ExitStack, closing
from dataclasses import replace

import uvicorn

from wraparc.errors import input_error, shown
from wraparc.web.app import create_app
from wraparc.web.connections import Connection
from wraparc.web.private import redirecting
from wraparc.web.settings import Settings

_KEEP_ALIVE, _MOST_CONNECTIONS = 30, 400


class _Server(uvicorn.Server):
    """A server that says when it is ready."""

    def __init__(self, config: uvicorn.Config, ready: Callable[[], None]) -> None:
        super().__init__(config)
        self._ready = ready

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        """Start, and say so."""
        await super().startup(sockets=sockets)
        if self.started:
            self._ready()


def run(settings: Settings, *, tell: Callable[[Settings], None], browser: bool = False) -> None:
    """Serve until interrupted.

    Parameters
    ----------
    settings
        How it runs.
    tell
        Called once requests are answered, with the port that was really taken.
    browser
        Whether to open the first page.

    Raises
    ------
    InputError
        If the database cannot be used, or the address not be listened on.
    """
    logging.getLogger("uvicorn.error").setLevel(logging.WARNING)
    app = create_app(settings)
    with (
        closing(app.state.wraparc),
        closing(listener(settings.host, settings.port)) as found,
        ExitStack() as until_the_end,
    ):
        known = replace(settings, port=found.getsockname()[1])

        def ready() -> None:
            tell(known)
            if browser:
                page = until_the_end.enter_context(redirecting(known.address))
                opening = threading.Thread(target=webbrowser.open, args=(page,))
                opening.daemon = True
                opening.start()

        config = uvicorn.Config(
            app,
            access_log=False,
            log_level="warning",
            server_header=False,
            limit_concurrency=_MOST_CONNECTIONS,
            timeout_keep_alive=_KEEP_ALIVE,
            timeout_graceful_shutdown=3,
            ws="none",
            http=Connection,
        )
        _Server(config, ready).run(sockets=[found])


def listener(host: str, port: int) -> socket.socket:
    """Return a bound socket; what stands in the way is told before anything starts.

    Raises
    ------
    InputError
        If there is no such address, or the port is taken.
    """
    found = None
    try:
        family, kind, protocol, _, address = socket.getaddrinfo(
            host, port, type=socket.SOCK_STREAM, flags=socket.AI_PASSIVE
        )[0]
        found = socket.socket(family, kind, protocol)
        if os.name == "posix":
            found.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        elif sys.platform == "win32":  # else another program could listen at the same port
            found.setsockopt(socket.SOL_SOCKET, socket.SO_EXCLUSIVEADDRUSE, 1)
        found.bind(address)
    except OSError as error:
        if found is not None:
            found.close()
        unknown = isinstance(error, socket.gaierror)
        raise input_error(
            key="--host" if unknown else "--port",
            value=shown(host) if unknown else str(port),
            message=f"cannot listen on {host}: {error.strerror or error}",
            remedy="Give another address."
            if unknown
            else "Choose another with --port, or stop the other server.",
        ) from None
    return found
