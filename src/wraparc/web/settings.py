"""How one server runs."""

import secrets
import socket
from dataclasses import dataclass, field
from functools import lru_cache
from ipaddress import ip_address

_LOCAL_NAMES = ("localhost",)


@dataclass(frozen=True, kw_only=True)
class Settings:
    """What the command line decides.

    Attributes
    ----------
    host, port
        Where the server listens.
    token
        By which programs request answers, or empty; needed beyond this machine. It outlives the
        server.
    start_token
        The token of this start, which pages have: it opens nothing after the server has stopped.
    linked
        Whether an address with `token` opens a page: one that its owner hands out.
    database
        URL of the database of saved designs.
    names
        Names besides addresses under which the server is reached.
    start
        A drive document to open first with its name, or None for the first example.
    start_file, start_text
        The file it was read from, as the user gave it, and what stands in it.
    workers
        Processes that solve; 0 solves in threads of this one.
    """

    host: str = "127.0.0.1"
    port: int = 8765
    token: str = ""
    start_token: str = field(default_factory=lambda: secrets.token_urlsafe(24), repr=False)
    linked: bool = True
    database: str = "sqlite://"
    names: tuple[str, ...] = ()
    start: dict[str, object] | None = None
    start_file: str = ""
    start_text: str = ""
    workers: int = 2

    @property
    def local(self) -> bool:
        """Whether only this machine can reach the server."""
        return is_loopback(self.host)

    @property
    def address(self) -> str:
        """What to type into a browser."""
        everywhere = self.host in ("0.0.0.0", "::")  # noqa: S104 - compared, not bound
        host = socket.gethostname() if everywhere else self.host
        host = f"[{host}]" if ":" in host else host
        query = f"?token={self.token if self.linked else self.start_token}" if self.token else ""
        return f"http://{host}:{self.port}/{query}"

    @property
    def shown_database(self) -> str:
        """The database as it may be shown: without a password."""
        kind, _, rest = self.database.partition("://")
        if kind == "sqlite":
            return rest.removeprefix("/")
        return f"{kind.partition('+')[0]}://{rest.rpartition('@')[2]}"


@lru_cache(maxsize=256)  # every request names its host
def is_loopback(host: str) -> bool:
    """Whether a host name or address is this machine and no other."""
    if host.lower().rstrip(".") in _LOCAL_NAMES:
        return True
    try:
        return ip_address(host).is_loopback
    except ValueError:
        return False


@lru_cache(maxsize=256)
def is_address(host: str) -> bool:
    """Whether a host is written as an IP address."""
    try:
        ip_address(host)
    except ValueError:
        return False
    return True
