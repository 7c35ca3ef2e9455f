"""Run one server until it is stopped."""

import logging
import socket
import threading
import webbrowser
from collections.abc import Callable

import uvicorn

from wraparc.web.app import create_app
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


def run(
    settings: Settings, listener: socket.socket, *, tell: Callable[[], None], browser: bool = False
) -> None:
    """Serve on a socket until interrupted.

    Parameters
    ----------
    settings
        How it runs.
    listener
        A bound socket.
    tell
        Called once requests are answered.
    browser
        Whether to open the first page.
    """
    logging.getLogger("uvicorn.error").setLevel(logging.WARNING)
    config = uvicorn.Config(
        create_app(settings),
        access_log=False,
        log_level="warning",
        server_header=False,
        limit_concurrency=_MOST_CONNECTIONS,
        timeout_keep_alive=_KEEP_ALIVE,
        timeout_graceful_shutdown=3,
        ws="none",
    )

    def ready() -> None:
        tell()
        if browser:
            query = f"?token={settings.token}" if settings.token else ""
            url = f"http://{settings.host}:{settings.port}/{query}"
            threading.Thread(target=webbrowser.open, args=(url,), daemon=True).start()

    _Server(config, ready).run(sockets=[listener])
