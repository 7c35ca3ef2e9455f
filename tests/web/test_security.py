"""The door: hosts, origins, tokens, sizes, headers, paths; and hostile requests."""

import json
from collections.abc import Iterator
from hashlib import sha256
from typing import Any

import pytest
from fastapi import Response
from starlette.testclient import TestClient

from web.calculators import ADDRESS, API, client, document
from wraparc.web import one_time, security
from wraparc.web.errors import ApiError
from wraparc.web.one_time import OneTimeLinks
from wraparc.web.settings import Settings, is_loopback

TOKEN, START = "0123456789abcdef0123", "of-this-start-3210fedcba9876543210"


@pytest.fixture(scope="module")
def local() -> Iterator[TestClient]:
    with client() as found:
        yield found


@pytest.fixture(scope="module")
def remote() -> Iterator[TestClient]:
    names = ("conveyor.example",)
    with client(host="192.0.2.7", token=TOKEN, start_token=START, names=names) as found:
        yield found


@pytest.mark.parametrize(
    ("host", "status"),
    [
        ("127.0.0.1:8765", 200),
        ("localhost:8765", 200),
        ("LOCALHOST", 200),
        ("[::1]:8765", 200),
        ("evil.example", 403),  # DNS rebinding: a foreign name that leads here
        ("evil.example:8765", 403),
        ("localhost.evil.example", 403),
        ("192.168.0.9:8765", 403),
        ("127.0.0.1@evil.example", 403),
        ("evil.example#127.0.0.1", 403),
        ("[::1", 403),
        ("", 403),
    ],
)
def test_only_names_of_this_machine(local: TestClient, host: str, status: int) -> None:
    assert local.get(f"{API}/about", headers={"host": host}).status_code == status


@pytest.mark.parametrize(
    ("headers", "status"),
    [
        ({}, 201),
        ({"origin": ADDRESS}, 201),
        ({"origin": ADDRESS, "sec-fetch-site": "same-origin"}, 201),
        ({"origin": "http://evil.example"}, 403),
        ({"origin": "http://127.0.0.1:9999"}, 403),
        ({"origin": "http://127.0.0.1:8765.evil.example"}, 403),
        ({"origin": "null"}, 403),
        ({"origin": "http://["}, 403),
        ({"sec-fetch-site": "cross-site"}, 403),
        ({"sec-fetch-site": "same-site"}, 403),
    ],
)
def test_other_origins_change_nothing(
    local: TestClient, headers: dict[str, str], status: int
) -> None:
    body = {"name": "mine", "document": document()}
    before = local.get(f"{API}/designs").json()["total"]
    assert local.post(f"{API}/designs", json=body, headers=headers).status_code == status
    after = local.get(f"{API}/designs").json()["total"]
    assert after - before == (status == 201)
    if status == 403:  # nor is anything deleted, renamed or solved from there
        for method in ("DELETE", "PATCH", "PUT", "POST"):
            answer = local.request(method, f"{API}/designs/1", headers=headers)
            assert answer.status_code == 403


def test_a_token_is_asked_for_beyond_this_machine(remote: TestClient) -> None:
    host = {"host": "192.0.2.7:8765"}
    for path in (f"{API}/about", f"{API}/start", f"{API}/designs", f"{API}/samefold", f"{API}/"):
        answer = remote.get(path, headers=host)
        assert answer.status_code == 401
        assert answer.headers["www-authenticate"] == "Bearer"
        assert answer.headers["content-type"] == "application/problem+json"
    for method in ("POST", "PUT", "PATCH", "DELETE"):  # what is open is open to be read
        for path in ("/", f"{API}/openapi.json", f"{API}/same/x", f"{API}/once/x"):
            assert remote.request(method, path, headers=host).status_code == 401
    right = {"authorization": f"Bearer {TOKEN}"}
    assert remote.get(f"{API}/about", headers=host | right).status_code == 200
    assert remote.get(f"{API}/about", headers=right | {"host": "conveyor.example"}).is_success
    for wrong in (f"Bearer {TOKEN}x", f"Bearer {TOKEN[:-1]}", f"Basic {TOKEN}", "Bearer", "Ä"):
        headers = [(b"host", b"192.0.2.7"), (b"authorization", wrong.encode("latin-1"))]
        assert remote.get(f"{API}/about", headers=headers).status_code == 401
    assert remote.get(f"{API}/about", headers=right | {"host": "evil.example"}).status_code == 403


def test_what_is_sent_to_everybody_is_of_the_program_alone(remote: TestClient) -> None:
    # expected: bytes that every installation of this version has
    host = {"host": "192.0.2.7:8765"}
    for path in ("/", "/designs", "/docs", "/static/main.js", f"{API}/openapi.json"):
        answer = remote.get(path, headers=host)
        assert answer.status_code == 200
        assert TOKEN not in answer.text
        assert START not in answer.text
        assert remote.get(path, headers={"host": "evil.example"}).status_code == 403


def test_the_address_with_the_token_leads_to_that_of_this_start(remote: TestClient) -> None:
    # expected: no cookie; the token that lasts is in no page, only that of this start
    host = {"host": "192.0.2.7:8765"}
    answer = remote.get(f"/?token={TOKEN}", headers=host, follow_redirects=False)
    assert answer.status_code == 303
    assert answer.headers["location"] == f"/?token={START}"
    assert "set-cookie" not in answer.headers
    of_page = host | {"authorization": f"Bearer {START}"}
    assert remote.get(f"{API}/about", headers=of_page).status_code == 200
    for name in ("cookie", "x-token"):
        sent = host | {name: f"wraparc_token_8765={TOKEN}"}
        assert remote.get(f"{API}/about", headers=sent).status_code == 401
    entered = remote.get(f"/designs?open=3&token={TOKEN}", headers=host, follow_redirects=False)
    assert entered.headers["location"] == f"/designs?open=3&token={START}"
    for query in ("?token=wrong", "?token=", "?token=%00", "?" + "a=1&" * 500, f"?token={START}"):
        answer = remote.get(f"/{query}", headers=host, follow_redirects=False)
        assert answer.status_code == 200  # the page, which asks for the address
    assert remote.get(f"/?token={TOKEN}", headers={"host": "evil.example"}).status_code == 403
    for path in ("//evil.example/", "/\\evil.example"):
        answer = remote.get(f"http://192.0.2.7:8765{path}?token={TOKEN}", follow_redirects=False)
        assert answer.headers.get("location", "/").startswith(("/evil", "/%5C"))


def test_a_token_of_the_user_alone_opens_no_page(remote: TestClient) -> None:
    # who takes the port later is sent what a bookmark holds: it is to open nothing
    with client(token=TOKEN, start_token=START, linked=False) as own:
        answer = own.get(f"/?token={TOKEN}", follow_redirects=False)
        assert (answer.status_code, answer.text[:15]) == (200, "<!doctype html>")
        assert own.get(f"{API}/about", headers={"authorization": f"Bearer {TOKEN}"}).is_success
        settings = own.app.state.wraparc.settings  # type: ignore[attr-defined]
        assert settings.address.endswith(f"?token={START}")
        assert START not in repr(settings)
    settings = remote.app.state.wraparc.settings  # type: ignore[attr-defined]
    assert settings.address.endswith(f"?token={TOKEN}")


def test_a_server_proves_to_know_the_token_of_its_start(remote: TestClient) -> None:
    # expected: HMAC-SHA256 by its definition (RFC 2104), over SHA-256 alone
    def by_definition(key: bytes, message: bytes) -> bytes:
        block = key.ljust(64, b"\0")
        inner, outer = (bytes(byte ^ pad for byte in block) for pad in (0x36, 0x5C))
        return sha256(outer + sha256(inner + message).digest()).digest()

    for nonce in ("0b7a5b0e-1111-4222-8333-123456789abc", "x" * 300):
        answer = remote.get(f"{API}/same/{nonce}", headers={"host": "192.0.2.7:8765"})
        assert answer.content == by_definition(START.encode(), nonce[:100].encode())
        assert answer.headers["wraparc-version"]
        assert answer.headers["cache-control"] == "no-store"


def test_every_start_has_a_token_of_its_own() -> None:
    made = {Settings().start_token for _ in range(20)}
    assert len(made) == 20
    assert min(map(len, made)) >= 32


def test_a_link_of_one_use_is_used_once_and_for_a_minute() -> None:
    now = [0.0]
    links = OneTimeLinks(lambda: now[0])
    first, second = links.make(lambda: Response("first")), links.make(lambda: Response("second"))
    assert links.use(first.rpartition("/")[2]).body == b"first"
    for gone in (first, "/none", "/"):
        with pytest.raises(ApiError, match="used"):
            links.use(gone.rpartition("/")[2])
    now[0] = 60.5
    with pytest.raises(ApiError, match="minute"):
        links.use(second.rpartition("/")[2])
    many = [links.make(lambda: Response("one")) for _ in range(one_time.MOST + 1)]
    assert len(set(many)) == len(many)
    with pytest.raises(ApiError):
        links.use(many[0].rpartition("/")[2])
    assert links.use(many[1].rpartition("/")[2]).body == b"one"


def test_every_answer_carries_the_headers_that_protect(local: TestClient) -> None:
    for path in ("/", "/docs", f"{API}/about", f"{API}/none", "/static/../app.py"):
        headers = local.get(path).headers
        policy = headers["content-security-policy"]
        assert "unsafe" not in policy
        assert policy.startswith("default-src 'none'; script-src 'self';")
        assert headers["x-content-type-options"] == "nosniff"
        assert headers["x-frame-options"] == "DENY"
        assert headers["referrer-policy"] == "no-referrer"
        assert "access-control-allow-origin" not in headers
        assert "server" not in headers
    assert local.get(f"{API}/about").headers["cache-control"] == "no-store"


@pytest.mark.parametrize(
    "name",
    [
        "../app.py",
        "..%2fapp.py",
        "%2e%2e%2f%2e%2e%2fapp.py",
        "/etc/passwd",
        "%2fetc%2fpasswd",
        "..\\app.py",
        "app.js%00.html",
        "%2e%2e",
        "",
    ],
)
def test_no_path_of_a_request_reaches_the_files(local: TestClient, name: str) -> None:
    answer = local.get(f"/static/{name}")
    assert answer.status_code == 404
    assert b"import" not in answer.content
    assert b"root:" not in answer.content


def test_pages_are_packed_and_asked_for_once(local: TestClient) -> None:
    first = local.get("/", headers={"accept-encoding": "gzip"})
    assert first.status_code == 200
    assert first.headers["content-encoding"] == "gzip"
    again = local.get("/", headers={"if-none-match": first.headers["etag"]})
    assert again.status_code == 304
    assert again.content == b""


def test_large_requests_are_refused(local: TestClient, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(security, "BODY_LIMIT", 10_000)
    big = json.dumps({"document": {"title": "x" * 20_000}})
    headers = {"content-type": "application/json"}
    answer = local.post(f"{API}/solve", content=big, headers=headers)
    assert answer.status_code == 413
    assert "larger than" in answer.json()["problems"][0]["message"]

    def pieces() -> Iterator[bytes]:  # sent in chunks, without a length
        yield big[:5000].encode()
        yield big[5000:].encode()

    assert local.post(f"{API}/solve", content=pieces(), headers=headers).status_code == 413
    endless = headers | {"content-length": "9" * 5000}
    assert local.post(f"{API}/solve", content=b"{}", headers=endless).status_code == 413


@pytest.mark.parametrize("length", ["", "-5", "1e3", "²"])
def test_a_length_that_is_no_number_is_a_sentence(local: TestClient, length: str) -> None:
    # a server's parser refuses these before; behind another one they may come through
    headers = [(b"content-length", length.encode("latin-1"))]
    for answer in (
        local.get(f"{API}/catalogue", headers=headers),
        local.post(f"{API}/solve", content=b"{}", headers=headers),
    ):
        assert answer.status_code == 400
        assert "the length" in answer.json()["problems"][0]["message"]


HOSTILE: list[Any] = [
    b"",
    b"null",
    b"[]",
    b"{",
    b'{"document": ' + b"[" * 100_000 + b"]" * 100_000 + b"}",
    b'{"document": ' + b'{"a":' * 20_000 + b"1" + b"}" * 20_000 + b"}",
    b'{"document": ' + b'{"a":' * 900 + b"1" + b"}" * 900 + b"}",
    b'{"document": ' + b'{"a":' * 100 + b"1" + b"}" * 100 + b"}",
    b'{"document": {"belt": {"width": NaN}}}',
    b'{"document": {"format": 1e999}}',
    b'{"document": {"format": ' + b"9" * 5000 + b"}}",
    b'{"document": {"title": "\\ud800"}}',
    b'{"document": {"\\ud800": "\\u0000"}}',
    b'{"document": {"title": "\xff"}}',
    b'{"document": {"lagging": {"__proto__": {}}, "pulley": [null, 1, [], {}]}}',
    b'{"document": {"pulley": [{"name": {"a": 1}, "lagging": {"law": [{"kind": "table"}]}}]}}',
    b'{"document": {"train": 1, "pulley": "x"}}',
    b'{"document": {"pulley": {"a": 1}, "load_case": [[]]}}',
]


@pytest.mark.parametrize("body", HOSTILE, ids=range(len(HOSTILE)))
def test_hostile_documents_are_answered_with_problems(local: TestClient, body: bytes) -> None:
    headers = {"content-type": "application/json"}
    for path in ("/solve/fast", "/solve", "/check", "/compare", "/train", "/report/md"):
        answer = local.post(API + path, content=body, headers=headers)
        assert answer.status_code in (400, 422), (path, answer.text[:200])
        assert answer.json()["problems"]
    answer = local.post(f"{API}/toml/write", content=body, headers=headers)
    assert answer.status_code in (200, 400, 422)


def test_a_body_that_is_not_json_says_where(local: TestClient) -> None:
    for body, place in ((b"{", "2"), (b'{"document": x}', "14"), (b" " * 2000 + b"x", "2,001")):
        headers = {"content-type": "application/json"}
        answer = local.post(API + "/solve", content=body, headers=headers)
        assert answer.status_code == 422
        assert answer.json()["detail"] == f"the body is not JSON from character {place} on."


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (rb"\ud800", "half of a character"),
        (b"\xed\xa0\x80", "not UTF-8"),
        (b"\xe9", "not UTF-8"),
        (rb"\u00e9, \ud83d\ude00", ""),
        ("é, 😀".encode(), ""),
    ],
)
def test_text_is_whole_characters_in_utf8(local: TestClient, text: bytes, message: str) -> None:
    headers = {"content-type": "application/json"}
    for mark in (b"", b"\xef\xbb\xbf"):  # with and without the mark of UTF-8
        body = mark + b'{"document": {"title": "' + text + b'"}}'
        answer = local.post(f"{API}/toml/write", content=body, headers=headers)
        assert answer.status_code == (422 if message else 200), answer.text
        assert message in answer.text


def test_hostile_toml(local: TestClient) -> None:
    texts = ("a" * 300_000, "a=" + "[" * 50_000, "a." * 20_000 + "b=1", "x = 1979-05-27", "\x00")
    for text in (*texts, "n = 1e400", "n = nan", "[a]\n[a]", "'\ud800'=1"):
        answer = local.post(f"{API}/toml/read", content=json.dumps({"toml": text}))
        assert answer.status_code in (200, 422), answer.text[:200]
        answer.json()


def test_a_fault_tells_nothing_of_the_program(
    local: TestClient, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fails(_: object) -> None:
        raise RuntimeError("secret /home/somebody")

    monkeypatch.setattr("wraparc.web.answers.drives.read", fails)
    answer = local.post(f"{API}/check", json={"document": document()})
    assert answer.status_code == 500
    assert "secret" not in answer.text
    assert "Traceback" not in answer.text
    assert "fault in wraparc" in answer.json()["problems"][0]["message"]


def test_which_hosts_are_this_machine() -> None:
    for host in ("127.0.0.1", "127.8.9.1", "localhost", "::1", "LocalHost."):
        assert is_loopback(host)
    for host in ("0.0.0.0", "::", "192.168.1.2", "example.org", "", "localhost.example"):  # noqa: S104
        assert not is_loopback(host)
