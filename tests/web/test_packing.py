"""Answers are packed for who can unpack them, and stay what they are."""

import gzip
import threading
from collections.abc import Iterator

import pytest
from starlette.testclient import TestClient

from web.calculators import API, client, document
from wraparc.web.packing import LEAST

PLAIN, PACKED = {"accept-encoding": "identity"}, {"accept-encoding": "gzip"}


@pytest.fixture(scope="module")
def local() -> Iterator[TestClient]:
    with client() as found:
        yield found


@pytest.mark.parametrize(
    "path",
    [
        "/",
        "/docs",
        "/static/main.js",
        "/static/style.css",
        f"{API}/schema",
        f"{API}/catalogue",
        f"{API}/book",
        f"{API}/openapi.json",
        f"{API}/start",
    ],
)
def test_what_a_page_fetches_comes_packed_and_is_the_same(local: TestClient, path: str) -> None:
    plain = local.get(path, headers=PLAIN)
    packed = local.get(path, headers=PACKED)
    assert "content-encoding" not in plain.headers
    assert packed.headers["content-encoding"] == "gzip"
    assert "accept-encoding" in packed.headers["vary"]
    assert packed.content == plain.content  # the client unpacks it
    length = int(packed.headers["content-length"])
    assert length < 0.6 * len(plain.content)
    assert packed.headers["content-security-policy"] == plain.headers["content-security-policy"]
    tagged = packed.headers.get("etag")
    assert tagged == plain.headers.get("etag")
    if tagged:
        again = local.get(path, headers=PACKED | {"if-none-match": tagged})
        assert (again.status_code, again.content) == (304, b"")


def test_an_answer_that_is_asked_for_comes_packed_in_a_thread(
    local: TestClient, monkeypatch: pytest.MonkeyPatch
) -> None:
    packed_in: list[int] = []
    usual = gzip.compress

    def noted(data: bytes, level: int) -> bytes:
        packed_in.append(threading.get_ident())
        return usual(data, level)

    monkeypatch.setattr(gzip, "compress", noted)
    asked = {"document": document()}
    plain = local.post(f"{API}/solve", json=asked, headers=PLAIN)
    assert not packed_in
    packed = local.post(f"{API}/solve", json=asked, headers=PACKED)
    assert packed.headers["content-encoding"] == "gzip"
    assert packed.json() == plain.json()
    assert local.portal is not None
    assert len(packed_in) == 1
    assert packed_in != [local.portal.call(threading.get_ident)]


def test_what_is_small_goes_as_it_is(local: TestClient) -> None:
    small = local.get(f"{API}/about", headers=PACKED)
    assert len(small.content) < LEAST
    assert "content-encoding" not in small.headers
    head = local.head(f"{API}/book", headers=PACKED)
    assert (head.status_code, head.content) == (200, b"")


def test_an_archive_goes_as_it_is(local: TestClient) -> None:
    pytest.importorskip("xlsxwriter", reason="of the extra `report`")
    workbook = local.post(f"{API}/report/xlsx", json={"document": document()}, headers=PACKED)
    assert workbook.status_code == 200, workbook.text
    assert "content-encoding" not in workbook.headers  # a workbook is one
