"""Connections that send nothing whole never keep others out."""

import asyncio
from collections import Counter
from typing import ClassVar

import httptools
from uvicorn.protocols.http.httptools_impl import HttpToolsProtocol

#: Most connections that may be without a whole request; one more, and the oldest is closed.
MOST_SILENT = 200
#: Seconds for a request to arrive as a whole: its head, and its body.
HEAD_LIMIT, BODY_LIMIT = 20.0, 300.0
#: Most bytes of the head of a request: each of its lines is looked at one by one.
LONGEST_HEAD = 64_000


class Connection(HttpToolsProtocol):
    """A connection that has a limited time for a request, and gives way when there are many."""

    _head = 0
    silent: ClassVar[dict["Connection", asyncio.TimerHandle]] = {}  # the oldest first

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        """Begin."""
        super().connection_made(transport)
        self._wait(HEAD_LIMIT)
        if len(self.silent) > MOST_SILENT:
            self._make_room()

    def on_message_begin(self) -> None:
        """Begin a request."""
        super().on_message_begin()
        self._head = 0
        self._wait(HEAD_LIMIT)

    def on_url(self, url: bytes) -> None:
        """Take a piece of the address."""
        self._count(len(url))
        super().on_url(url)

    def on_header(self, name: bytes, value: bytes) -> None:
        """Take a line of the head."""
        self._count(len(name) + len(value))
        super().on_header(name, value)

    def _count(self, size: int) -> None:
        self._head += size + 4
        if self._head > LONGEST_HEAD:
            raise httptools.HttpParserError("the head of the request is too long")

    def on_headers_complete(self) -> None:
        """Take the head of a request."""
        super().on_headers_complete()
        self._wait(BODY_LIMIT)

    def on_message_complete(self) -> None:
        """Take the end of a request."""
        super().on_message_complete()
        self._answered_for()

    def on_response_complete(self) -> None:
        """Wait for the next request."""
        super().on_response_complete()
        if not self.pipeline and not self.transport.is_closing():
            self._wait(self.timeout_keep_alive + HEAD_LIMIT)

    def connection_lost(self, exc: Exception | None) -> None:
        """End."""
        self._answered_for()
        super().connection_lost(exc)

    def _wait(self, limit: float) -> None:
        self._answered_for()
        self.silent[self] = self.loop.call_later(limit, self._close)

    def _answered_for(self) -> None:
        timer = self.silent.pop(self, None)
        if timer is not None:
            timer.cancel()

    def _make_room(self) -> None:
        """Close the oldest silent connection of the address that has most of them."""
        addresses = Counter(one.client and one.client[0] for one in self.silent)
        most = addresses.most_common(1)[0][0]
        oldest = next(one for one in self.silent if (one.client and one.client[0]) == most)
        oldest._close()

    def _close(self) -> None:
        self._answered_for()
        self.transport.abort()
