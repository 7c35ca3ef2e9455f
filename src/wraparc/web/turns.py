"""Whose turn it is: places for work, given to clients one after the other."""

import asyncio
from collections import Counter
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager

from wraparc.web.errors import ApiError, refused


def busy(message: str, remedy: str, seconds: int = 5) -> ApiError:
    """Return the refusal of what may be asked again later."""
    error = refused(503, message, remedy)
    error.headers = {"retry-after": str(seconds)}
    return error


class Turns:
    """So many at a time; who waits, waits for one of each other client, not for all they ask.

    Parameters
    ----------
    places
        How much runs at the same time.
    each
        How much of that is for one client.
    most_waiting
        What waits beyond this is refused.
    """

    def __init__(self, places: int, each: int, most_waiting: int) -> None:
        self._free, self._each, self._most = places, max(1, each), most_waiting
        self._held: Counter[str] = Counter()
        self._waiting: dict[str, list[asyncio.Future[None]]] = {}  # the next to serve first

    @property
    def waiting(self) -> int:
        """How much waits."""
        return sum(map(len, self._waiting.values()))

    @asynccontextmanager
    async def turn(self, client: str) -> AsyncIterator[None]:
        """Wait for a place, and hold it.

        Raises
        ------
        ApiError
            503 if too much waits already.
        """
        if self.waiting >= self._most:
            raise busy("too many requests are waiting", "Try again in a moment.")
        mine = asyncio.get_running_loop().create_future()
        self._waiting.setdefault(client, []).append(mine)
        self._serve()
        try:
            await mine
            yield
        finally:
            if mine in self._waiting.get(client, ()):  # gave up before it was served
                self._waiting[client].remove(mine)
            else:
                self._free += 1
                self._held[client] -= 1
            self._serve()

    def _serve(self) -> None:
        for client in [c for c, queue in self._waiting.items() if not queue]:
            del self._waiting[client]
        while self._free:
            able = [c for c in self._waiting if self._held[c] < self._each]
            if not able:
                return
            client = able[0]
            queue = self._waiting.pop(client)
            granted = queue.pop(0)
            if queue:
                self._waiting[client] = queue  # behind the others
            self._free -= 1
            self._held[client] += 1
            if not granted.done():
                granted.set_result(None)
