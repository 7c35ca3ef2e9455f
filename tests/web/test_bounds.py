"""What one request can hold up: nothing that grows with it runs where all others are served.

The expected numbers are the limits that the refusals themselves name.
"""

import contextlib
import json
import os
import socket
import sys
import threading
from collections import Counter
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from starlette.testclient import TestClient

from web.calculators import API, TOKEN, Process, client, document, serving
from wraparc.schema import bounds
from wraparc.web.answers import documents, drives
from wraparc.web.asked import SolveRequest
from wraparc.web.connections import LONGEST_HEAD

JSON, TOML = "application/json", "application/toml"
#: Bytes of the bodies; where nothing grows, a hundredth of it costs the loop as much.
LARGE, SMALL = 1_900_000, 19_000
#: After this long [s] a server is taken to stand still; one that does not never waits for it.
_STUCK = 60.0


def _toml(line: Callable[[int], str]) -> Callable[[int], bytes]:
    def made(size: int) -> bytes:
        lines = size // len(line(10_000))
        return "".join(line(i) for i in range(lines)).encode()

    return made


def _json(before: str, item: str, after: str) -> Callable[[int], bytes]:
    return lambda size: f'{{"document": {before}{item * (size // len(item))}{after}}}'.encode()


def _drive(size: int) -> bytes:
    """Return a drive of load cases that cannot be read, each of another name."""
    case = {"pulley": {"head": {"entry_tension": "82 kN", "slack": "1 kN"}}}
    cases = [{"name": f"case {i}", **case} for i in range(size // 100)]
    return json.dumps({"document": {**document(), "load_case": cases}}).encode()


def _files(size: int) -> bytes:
    part = b'\r\n--edge\r\ncontent-disposition: form-data; name="files"; filename="a"\r\n\r\n1'
    return part[2:] + part * (size // len(part)) + b"\r\n--edge--\r\n"


KINDS: dict[str, tuple[str, str, Callable[[int], bytes]]] = {
    "dotted keys": ("/solve", TOML, _toml(lambda i: f"k{i}.a.b.c.d = 1\n")),
    "headed tables": ("/solve", TOML, _toml(lambda i: f"[t{i}.b]\nk = 1\n")),
    "comments": ("/solve/fast", TOML, _toml(lambda i: "#\n")),
    "keys": ("/solve", JSON, lambda n: json.dumps({f"k{i}": 1 for i in range(n // 14)}).encode()),
    "numbers": ("/solve", JSON, _json('{"a": [', "1,", "1]}")),
    "texts": ("/solve/fast", JSON, _json('{"a": [', '"x",', '"x"]}')),
    "escapes": ("/check", JSON, _json('{"title": "', "\\u00e4", '"}')),
    "tables in tables": ("/designs", JSON, _json("", '{"a":', "1")),
    "load cases": ("/solve", JSON, _drive),
    "pieces of files": ("/across/profile", "multipart/form-data; boundary=edge", _files),
    "studies": ("/studies", JSON, _json('{"a": [', '{"a":1},', "1]}")),
}


@contextlib.contextmanager
def counted(local: TestClient) -> Iterator[Counter[str]]:
    """Count what is called in the thread of the event loop."""
    found: Counter[str] = Counter()

    def note(frame: Any, event: str, called: Any) -> None:
        if event == "call":
            found[frame.f_code.co_qualname] += 1
        elif event == "c_call":
            found[f"{called.__module__}.{called.__name__}"] += 1

    assert local.portal is not None
    local.portal.call(sys.setprofile, note)
    try:
        yield found
    finally:
        local.portal.call(sys.setprofile, None)


@pytest.fixture(scope="module")
def local() -> Iterator[TestClient]:
    with client() as found:
        yield found


@pytest.mark.parametrize("kind", KINDS)
def test_nothing_that_grows_with_a_request_runs_on_the_event_loop(
    local: TestClient, kind: str
) -> None:
    path, media, body = KINDS[kind]

    def calls(size: int) -> tuple[Counter[str], int]:
        content = body(size)
        with counted(local) as found:
            answer = local.post(API + path, content=content, headers={"content-type": media})
        assert answer.status_code in (413, 422), answer.text[:300]
        assert answer.json()["problems"]
        return found, len(content)

    calls(SMALL)  # what is done but once
    few, small = calls(SMALL)
    many, large = calls(LARGE)
    assert 1_500_000 < large < 2_000_000
    assert large > 50 * small
    # what waits for a thread looks round now and then; what grew would be called 100 times as often
    assert many.total() < 2 * few.total() + 1000, (many - few).most_common(5)
    for found in (few, many):
        parsing = ("loads", "JSONDecoder.decode", "_pickle.dumps", "zlib.compress", "re.Pattern")
        assert not [name for name in found if name.startswith(parsing)]


@pytest.mark.parametrize("what", ["json", "toml", "files"])
def test_others_are_answered_while_a_request_is_being_read(
    local: TestClient, monkeypatch: pytest.MonkeyPatch, what: str
) -> None:
    """The reading of one waits until the other is answered: on one thread it never would be."""
    reading, answered = threading.Event(), threading.Event()
    place = {
        "json": "wraparc.web.routes.bodies.check_json",
        "toml": "wraparc.schema.source.check_toml",
        "files": "wraparc.web.routes.bodies._parts",
    }[what]
    module, _, name = place.rpartition(".")
    usual = getattr(sys.modules[module], name)

    def held(*given: Any) -> Any:
        reading.set()
        assert answered.wait(_STUCK)
        return usual(*given)

    monkeypatch.setattr(place, held)
    path, media, body = KINDS[
        {"json": "numbers", "toml": "dotted keys", "files": "pieces of files"}[what]
    ]
    big: list[int] = []

    def send() -> None:
        headers = {"content-type": media}
        big.append(local.post(API + path, content=body(LARGE), headers=headers).status_code)

    sender = threading.Thread(target=send)
    sender.start()
    assert reading.wait(_STUCK)
    assert local.get(f"{API}/about").status_code == 200
    assert not big
    answered.set()
    sender.join()
    assert big in ([413], [422])


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ('{"a": ' + "[1" + ",1" * 100_001 + "]}", "contains 100,001 values in lists"),
        ("{" + '"a":1,' * bounds.MOST_KEYS + '"a":1}', "contains 20,001 keys; at most 20,000"),
        ("[" * 61 + "]" * 61, "is nested more than 60 deep"),
        ('{"' + "k" * 201 + '" : 1}', "a key of more than 200 characters"),
        ('{"' + 'k\\"' * 101 + "k" * 100 + '" : 1}', "a key of more than 200 characters"),
        ('{"a": "' + "k" * 2001 + '"}', ""),
        ('{"a": "' + "[" * 2001 + '", "b": "\\\\", "c": "' + ":" * 30_000 + '"}', ""),
        ("[" * 60 + "]" * 60, ""),
    ],
)
def test_what_json_may_hold_is_counted_before_it_is_parsed(text: str, message: str) -> None:
    json.loads(text)  # each of them is JSON
    _expect(bounds.check_json, text, message)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("a = [" + "1," * 100_001 + "]", "contains 100,001 values in lists"),
        ("".join(f"k{i} = 1\n" for i in range(20_001)), "contains 20,001 keys; at most 20,000"),
        ("a = " + "[" * 61 + "]" * 61, "is nested more than 60 deep"),
        ("#\n" * 150_001, "contains 150,001 lines; at most 150,000 are read"),
        ("a = [\n" + "1,\n" * 100_000 + "]", ""),
        ("\n" + "k" * 201 + " = 1", "a key or number of more than 200 characters"),
        ('\n"' + "k " * 101 + '" = 1', "line 2: a key of more than 200 characters"),
        ("\n['" + "k " * 101 + "']", "line 2: a key of more than 200 characters"),
        ("\n" + "a . " * 10 + "b = 1", "line 2: a key of more than 10 parts"),
        ('a."b".' * 5 + "b = 1", "line 1: a key of more than 10 parts"),
        ('a = "' + "x = [" * 21_000 + '"', ""),
        ("a = '" + "x = [" * 21_000 + "'", ""),
        ('a = """' + '\n"x" = [' * 21_000 + '\\""""', ""),
        ("a = '''" + "\n'x' = [" * 21_000 + "'''", ""),
        ("# " + "x = [" * 21_000 + "\na = 1", ""),
        ("a = 0." + "1" * 100 + "\nb = [1.5, 2.5]", ""),
        (".".join("abcdefghij") + " = 1", ""),
    ],
)
def test_what_toml_may_hold_is_counted_before_it_is_parsed(text: str, message: str) -> None:
    _expect(bounds.check_toml, text, message)


def _expect(check: Callable[[str], None], text: str, message: str) -> None:
    if not message:
        return check(text)
    with pytest.raises(Exception, match=r"^.*$") as caught:
        check(text)
    assert message in str(caught.value)
    return None


def _cases(count: int, pulleys: int = 1) -> dict[str, Any]:
    """Return a drive of so many load cases, the design case among them."""
    found = document("head-drive-fabric" if pulleys == 1 else "tandem-fabric")
    head = found["pulley"][0]["name"]
    for pulley in found["pulley"]:
        pulley.pop("condition", None)
    tension = {"pulley": {head: {"entry_tension": "100 kN"}}} if pulleys == 1 else {}
    found["load_case"] = [{"name": f"case {i}", **tension} for i in range(count - 1)]
    return found


@pytest.mark.parametrize("path", ["/solve", "/solve/fast", "/compare", "/designs", "/report/md"])
def test_a_thousand_load_cases_are_refused_with_how_many_are_taken(
    local: TestClient, path: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    def solves(*_: object, **__: object) -> None:
        raise AssertionError("nothing is solved")

    for place in ("arc.Distributed.solve", "arc.PaperMarch.solve", "arc.drive_solve.solve"):
        monkeypatch.setattr(f"wraparc.{place}", solves)
    name = {"name": "mine"} if path == "/designs" else {}
    answer = local.post(API + path, json={"document": _cases(1000), **name})
    assert answer.status_code == 422
    told = answer.json()["problems"][0]["message"]
    assert told.startswith(f"1,000 load cases with conditions, at most {documents.MOST_ARCS}")


def test_the_work_grows_with_the_load_cases_and_no_faster(monkeypatch: pytest.MonkeyPatch) -> None:
    # what a check asks of the slack side was sought for all load cases once for each of them
    module = sys.modules["wraparc.checks.least_tension"]  # the package names its function so
    usual, sought = module._figures, Counter[int]()

    def figures(case_count: int) -> int:
        def counted(*given: Any) -> Any:
            sought[case_count] += 1
            return usual(*given)

        monkeypatch.setattr(module, "_figures", counted)
        drives.solve_all(SolveRequest(document=_cases(case_count), prepared=True, points=60))
        return sought[case_count]

    few, twice, thrice = figures(3), figures(6), figures(9)
    assert 0 < few < twice
    assert thrice - twice == twice - few


def test_the_slow_part_of_a_judgement_is_found_once_for_all_tables(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    # of an arc, by whichever method it was solved: where its grip ends, the margin by each of three
    # ways to hold the take-up, one of them that of its check, and one rise of the tensions
    called = Counter[str]()

    def counted(module: str, name: str) -> None:
        usual = getattr(sys.modules[module], name)

        def once_more(*given: Any) -> Any:
            called[name] += 1
            return usual(*given)

        monkeypatch.setattr(sys.modules[module], name, once_more)

    # ways to better it are solved and judged anew
    monkeypatch.setattr("wraparc.actions.find._find", lambda _: None)
    counted("wraparc.arc.grip", "pull_at_sliding")
    counted("wraparc.arc.grip", "at_limits")
    counted("wraparc.arc.grip", "lift_for_safety")
    drive = _cases(10)
    drive["pulley"][0]["diameter"] = "801 mm"  # which no other test has solved before
    for i, case in enumerate(drive["load_case"]):
        case["pulley"] = {"head": {"entry_tension": f"{90 + i} kN"}}
    drives.solve_all(SolveRequest(document=drive, prepared=True, points=60))
    assert called["at_limits"] == 10
    assert called["pull_at_sliding"] == 3 * 10
    assert called["lift_for_safety"] == 10


def test_no_number_depends_on_how_many_load_cases_are_asked() -> None:
    # each alone is what each is among the others, to the last digit of every number and table
    drive = _cases(6)
    for i, case in enumerate(drive["load_case"]):
        case["pulley"] = {"head": {"entry_tension": f"{80 + 25 * i} kN"}}
    every = drives.solve_all(SolveRequest(document=drive, points=60)).arcs
    shown = {arc.load_case: arc.model_dump() for arc in every}
    assert len(shown) == 6  # the design case breaks away, the others carry more and more
    for case in drive["load_case"]:
        single = {**drive, "load_case": [case]}
        found = drives.solve_all(SolveRequest(document=single, points=60)).arcs
        alone = {arc.load_case: arc.model_dump() for arc in found}
        for name, arc in alone.items():
            assert arc == shown[name]


def test_pulleys_share_how_many_load_cases_are_taken() -> None:
    documents.read(_cases(documents.MOST_ARCS))
    with pytest.raises(Exception, match="201 load cases with conditions, at most 200"):
        documents.read(_cases(documents.MOST_ARCS + 1))
    half = documents.MOST_ARCS // 2
    documents.read(_cases(half, pulleys=2))
    with pytest.raises(Exception, match="101 load cases on 2 pulleys with conditions, at most 100"):
        documents.read(_cases(half + 1, pulleys=2))


@pytest.fixture(scope="module")
def plain() -> Iterator[Process]:
    with serving("--workers", "1", "--no-open") as process:
        yield process


@pytest.mark.parametrize("head", ["lines", "address"])
def test_a_head_that_does_not_end_is_cut_off(plain: Process, head: str) -> None:
    start = f"GET /api/v1/about HTTP/1.1\r\nhost: 127.0.0.1\r\nauthorization: Bearer {TOKEN}\r\n"
    short, long = {
        "lines": (start + "a: b\r\n" * 100, start + "a: b\r\n" * (LONGEST_HEAD // 2)),
        "address": (start, start.replace("about", "about?" + "a" * 2_000_000)),
    }[head]
    for sent, status in ((short, b"200"), (long, b"400")):
        with socket.create_connection(("127.0.0.1", plain.port)) as connection:
            with contextlib.suppress(OSError):  # it is shut before all is sent
                connection.sendall(sent.encode() + b"\r\n")
            with contextlib.suppress(OSError):
                assert connection.recv(1000).split()[1] == status
    assert plain.ask(f"{API}/about").status == 200


#: Files opened to write while this is a list.
_written: list[list[str]] = []


def _watch(event: str, given: tuple[Any, ...]) -> None:
    if _written and event == "open" and given[2] & (os.O_WRONLY | os.O_RDWR | os.O_CREAT):
        _written[-1].append(str(given[0]))


@pytest.fixture(scope="module")
def audited() -> None:
    sys.addaudithook(_watch)  # for good: an interpreter forgets no hook


@pytest.mark.usefixtures("audited")
def test_what_is_uploaded_never_touches_the_disk(local: TestClient) -> None:
    session = local.post(f"{API}/tests").json()["session"]
    rows = b"".join(b"%d.%d;%d\n" % (i // 10, i % 10, i % 977) for i in range(300_000))
    table = b"position (mm);reading (mm)\n" + rows
    assert len(table) > 3_000_000
    files = [("files", (f"test {i}.csv", table, "text/csv")) for i in range(2)]
    _written.append([])
    try:
        read = local.post(f"{API}/tests/{session}/files", files=files)
        fits = {"width": "1200 mm"}
        profile = local.post(f"{API}/across/profile", files={"file": ("a", table)}, data=fits)
    finally:
        found = _written.pop()
    assert [one["bytes"] for one in read.json()["files"]] == [len(table)] * 2
    assert profile.status_code == 413  # it is no upload of shear tests: 2 MB are enough
    assert found == []


@pytest.mark.parametrize(
    ("named", "expected"),
    [
        ('filename="plain.csv"', "plain.csv"),
        ('filename="Prüfung 5 °C.csv"', "Prüfung 5 °C.csv"),  # browsers send UTF-8
        ('filename="a \\"b\\" c.csv"', 'a "b" c.csv'),  # quotes as RFC 2616 escapes them
        ("filename*=UTF-8''Pr%C3%BCfung.csv", "Prüfung.csv"),  # RFC 5987
        ('filename="../../etc/passwd"', "passwd"),
        ('filename=""', "file"),
    ],
)
def test_files_have_the_names_they_were_sent_with(
    local: TestClient, named: str, expected: str
) -> None:
    session = local.post(f"{API}/tests").json()["session"]
    body = f'--x\r\ncontent-disposition: form-data; name="files"; {named}\r\n\r\n1\r\n--x--'
    headers = {"content-type": "multipart/form-data; boundary=x"}
    answer = local.post(f"{API}/tests/{session}/files", content=body.encode(), headers=headers)
    assert [file["name"] for file in answer.json()["files"]] == [expected]


@pytest.mark.parametrize(
    ("body", "status", "message"),
    [
        (b"", 400, "ends before its last part"),
        (
            b'--x\r\ncontent-disposition: form-data; name="files"; filename="a"\r\n\r\n1',
            400,
            "ends",
        ),
        (b"--x\r\nno head\r\n--x--", 400, "a part of the body has no head"),
        (
            b"--x\r\na: " + b"b" * 9000 + b"\r\n\r\n1\r\n--x--",
            400,
            "a part of the body has no head",
        ),
        (
            b"--x\r\n\r\n\r\n1" + b"\r\n--x\r\n\r\n1" * 101 + b"\r\n--x--",
            413,
            "more than 100 parts",
        ),
        (b"--x--", 422, "field required"),
        (b'--x\r\ncontent-disposition: form-data; name="files"\r\n\r\n1\r\n--x--', 422, "files"),
    ],
)
def test_files_that_do_not_come_whole_are_refused(
    local: TestClient, body: bytes, status: int, message: str
) -> None:
    session = local.post(f"{API}/tests").json()["session"]
    headers = {"content-type": "multipart/form-data; boundary=x"}
    answer = local.post(f"{API}/tests/{session}/files", content=body, headers=headers)
    assert (answer.status_code, message in answer.text) == (status, True), answer.text
    plain = {"content-type": "multipart/form-data"}
    unnamed = local.post(f"{API}/tests/{session}/files", content=body or b"1", headers=plain)
    assert (unnamed.status_code, "no boundary" in unnamed.text) == (400, True)
