"""The door: who may ask, how much, and what browsers may do with the answers.

Written as a plain ASGI layer, so that it costs microseconds and sees every byte.
"""

import hmac
import socket
from collections.abc import Iterable
from urllib.parse import parse_qsl, quote, urlencode, urlsplit

from wraparc.web.errors import PROBLEM_JSON, refused
from wraparc.web.packing import App, Message, Receive, Scope, Send
from wraparc.web.settings import Settings, is_address, is_loopback

Refusal = tuple[int, str, str]

#: Most bytes of a request, and of one that uploads files.
BODY_LIMIT, UPLOAD_LIMIT = 2_000_000, 64_000_000
_MOST_DIGITS = 12  # of a length: more are too large, and int() refuses thousands of them
UPLOADS = ("/api/v1/tests/", "/api/v1/logs/", "/api/v1/measured")
_SAFE = ("GET", "HEAD", "OPTIONS")
#: What is sent to everybody: the program's own files and forms, proofs, and links of one use.
_OPEN = ("/api/v1/openapi.json", "/api/v1/same/", "/api/v1/once/")

POLICY = (
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; "
    "connect-src 'self'; font-src 'self'; manifest-src 'self'; form-action 'self'; "
    "base-uri 'none'; frame-ancestors 'none'"
)
_NO_LENGTH: Refusal = 400, "the length of the request is no number", "Send it as it is."
HEADERS: tuple[tuple[bytes, bytes], ...] = (
    (b"content-security-policy", POLICY.encode()),
    (b"x-content-type-options", b"nosniff"),
    (b"x-frame-options", b"DENY"),
    (b"referrer-policy", b"no-referrer"),
    (b"cross-origin-opener-policy", b"same-origin"),
    (b"cross-origin-resource-policy", b"same-origin"),
    (b"permissions-policy", b"camera=(), geolocation=(), microphone=()"),
)


class Door:
    """Checks every request before the application sees it, and every answer on its way out."""

    def __init__(self, app: App, settings: Settings) -> None:
        self.app = app
        self.settings = settings
        names = {"localhost", *settings.names}
        if not settings.local:
            names |= {socket.gethostname(), socket.getfqdn(), settings.host}
        self._names = {name.lower().rstrip(".") for name in names}

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Serve one request."""
        if scope["type"] != "http":
            if scope["type"] == "lifespan":
                await self.app(scope, receive, send)
            return
        headers = {key.decode("latin-1"): v.decode("latin-1") for key, v in scope["headers"]}
        outgoing = _with_headers(send)
        if scope["method"] == "HEAD":  # what GET would answer, without its content
            scope, outgoing = {**scope, "method": "GET"}, _without_content(outgoing)
        if self._enters(scope, headers):
            await _answer(outgoing, 303, b"", self._welcome(scope))
            return
        refusal = self._refusal(scope, headers)
        if refusal is not None:
            await _refuse(outgoing, *refusal)
            return
        limit = UPLOAD_LIMIT if scope["path"].startswith(UPLOADS) else BODY_LIMIT
        length = headers.get("content-length", "0")
        if not length.isdecimal():
            await _refuse(outgoing, *_NO_LENGTH)
            return
        if len(length) > _MOST_DIGITS or int(length) > limit:
            await _refuse(outgoing, *_too_large(limit))
            return
        await self.app(scope, *_counted(receive, outgoing, limit))

    def _refusal(self, scope: Scope, headers: dict[str, str]) -> Refusal | None:
        """Return why a request is refused: status, message, remedy."""
        host = headers.get("host", "")
        if not self._known_host(host):
            return 403, "this server is not known under that name", self._host_remedy()
        if scope["method"] not in _SAFE and not _same_origin(scope, headers, host):
            message = "a page of another origin may not change anything here"
            return 403, message, "Use the pages of this server."
        if self.settings.token and not _is_open(scope) and not self._has_token(headers):
            message = "this server asks for its token"
            remedy = "Open the address with ?token=... that the server has printed"
            return 401, message, f"{remedy}, or send Authorization: Bearer ..."
        return None

    def _known_host(self, host: str) -> bool:
        name = _host_name(host)
        if is_address(name):
            return is_loopback(name) if self.settings.local else True
        return name.rstrip(".") in self._names

    def _host_remedy(self) -> str:
        where = "localhost or 127.0.0.1" if self.settings.local else "its address"
        return f"Use {where}, or start it with --name."

    def _has_token(self, headers: dict[str, str]) -> bool:
        scheme, _, given = headers.get("authorization", "").partition(" ")
        tokens = (self.settings.start_token, self.settings.token)
        return scheme.lower() == "bearer" and any(_equal(given.strip(), t) for t in tokens)

    def _enters(self, scope: Scope, headers: dict[str, str]) -> bool:
        """Whether a browser comes with the token that is handed out in the address of a page."""
        if not (self.settings.token and self.settings.linked and _is_page(scope)):
            return False
        given = [value for name, value in _query(scope) if name == "token"]
        known = self._known_host(headers.get("host", ""))
        return known and bool(given) and _equal(given[0], self.settings.token)

    def _welcome(self, scope: Scope) -> list[tuple[bytes, bytes]]:
        """Lead to the same page with the token of this start, which the page takes and hides."""
        pairs = [pair for pair in _query(scope) if pair[0] != "token"]
        query = urlencode([*pairs, ("token", self.settings.start_token)])
        place = quote("/" + scope["path"].lstrip("/")) + f"?{query}"
        return [(b"location", place.encode())]


def _equal(given: str, token: str) -> bool:
    return hmac.compare_digest(given.encode(), token.encode())


def _is_open(scope: Scope) -> bool:
    return _is_page(scope) or (scope["method"] == "GET" and scope["path"].startswith(_OPEN))


def _is_page(scope: Scope) -> bool:
    return scope["method"] == "GET" and not scope["path"].startswith("/api/")


def _query(scope: Scope) -> list[tuple[str, str]]:
    return parse_qsl(scope["query_string"][:1000].decode("latin-1"), keep_blank_values=True)


def _host_name(host: str) -> str:
    """Return the name in a Host header, without the port; empty if it is not one."""
    if len(host) > 300 or not host.isprintable() or set(host) & set("/?#@\\ "):
        return ""
    try:
        return urlsplit(f"//{host}").hostname or ""
    except ValueError:
        return ""


def _same_origin(scope: Scope, headers: dict[str, str], host: str) -> bool:
    if headers.get("sec-fetch-site", "same-origin") not in ("same-origin", "none"):
        return False
    origin = headers.get("origin")
    if origin is None:
        return True  # no browser leaves it out of a request that changes something
    try:
        return origin.startswith(("http://", "https://")) and urlsplit(origin).netloc == host
    except ValueError:
        return False


def _counted(receive: Receive, send: Send, limit: int) -> tuple[Receive, Send]:
    """Return what counts a request as it comes in, and refuses it once it is too large."""
    left, answered = limit, False

    async def receiving() -> Message:
        nonlocal left
        message = await receive()
        if message["type"] == "http.request":
            left -= len(message.get("body", b""))
            if left < 0:  # the application sees an empty end, its answer is not sent
                return {"type": "http.request", "body": b"", "more_body": False}
        return message

    async def sending(message: Message) -> None:
        nonlocal answered
        if left >= 0:
            await send(message)
        elif not answered:
            answered = True
            await _refuse(send, *_too_large(limit))

    return receiving, sending


def _too_large(limit: int) -> Refusal:
    return 413, f"the request is larger than {limit / 1e6:g} MB", "Send less at a time."


def _with_headers(send: Send) -> Send:
    """Return `send` with the headers that protect every answer."""

    async def sending(message: Message) -> None:
        if message["type"] == "http.response.start":
            present = {key.lower() for key, _ in message["headers"]}
            more = [pair for pair in HEADERS if pair[0] not in present]
            if b"cache-control" not in present:
                more.append((b"cache-control", b"no-store"))
            message = {**message, "headers": [*message["headers"], *more]}
        await send(message)

    return sending


def _without_content(send: Send) -> Send:
    async def sending(message: Message) -> None:
        await send({**message, "body": b""} if "body" in message else message)

    return sending


async def _refuse(send: Send, status: int, message: str, remedy: str) -> None:
    body = refused(status, message, remedy).body()
    kind = [(b"content-type", PROBLEM_JSON.encode())]
    if status == 401:
        kind.append((b"www-authenticate", b"Bearer"))
    await _answer(send, status, body, kind)


async def _answer(
    send: Send, status: int, body: bytes, headers: Iterable[tuple[bytes, bytes]]
) -> None:
    length = (b"content-length", str(len(body)).encode())
    start = {"type": "http.response.start", "status": status, "headers": [*headers, length]}
    await send(start)
    await send({"type": "http.response.body", "body": body})
