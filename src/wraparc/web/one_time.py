"""Links of one use: a browser saves what they lead to without a value that opens anything else."""

import secrets
import time
from collections.abc import Callable

from fastapi import Response

from wraparc.web.errors import refused

LIFE, MOST = 60.0, 100


class OneTimeLinks:
    """What links lead to, each until it is used, for a minute.

    Parameters
    ----------
    clock
        The time [s].
    """

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock = clock
        self._links: dict[str, tuple[float, Callable[[], Response]]] = {}

    def make(self, content: Callable[[], Response]) -> str:
        """Return the address of a link to what a function gives; of too many the oldest goes."""
        self._sweep()
        if len(self._links) >= MOST:
            del self._links[next(iter(self._links))]
        name = secrets.token_urlsafe(24)
        self._links[name] = self._clock(), content
        return f"/api/v1/once/{name}"

    def use(self, name: str) -> Response:
        """Return what a link leads to, which leads nowhere from then on.

        Raises
        ------
        ApiError
            If there is no such link, if it was used, or if its minute is over.
        """
        self._sweep()
        if name not in self._links:
            raise refused(404, "this link was used, or is over a minute old", "Press it again.")
        return self._links.pop(name)[1]()

    def _sweep(self) -> None:
        now = self._clock()
        self._links = {k: v for k, v in self._links.items() if now - v[0] <= LIFE}
