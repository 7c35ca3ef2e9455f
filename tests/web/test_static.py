"""The files of the page: what is vendored is what was published, the rest is small and whole."""

import gzip
import hashlib
import json
import re
from pathlib import Path

import pytest
from starlette.testclient import TestClient

import wraparc
from web.calculators import client

STATIC = Path(wraparc.__file__).parent / "web" / "static"
ROOT = Path(__file__).parents[2]
#: Digest of `dist/preact.mjs` in the package preact 11.2.0 as the registry gave it.
PREACT = "bdcbd9abdf2c77c5c45326eab42191e949222d479d0d5f69467387a77040cb55"
BUILT = STATIC / "built"
FILES = sorted(
    p for p in STATIC.rglob("*") if p.suffix in (".js", ".css", ".html") and BUILT not in p.parents
)
OWN = [p for p in FILES if "vendor" not in p.parts]


def name(path: Path) -> str:
    return path.relative_to(STATIC).as_posix()


def test_the_renderer_is_the_published_file() -> None:
    held = (STATIC / "vendor" / "preact.js").read_bytes()
    assert hashlib.sha256(held).hexdigest() == PREACT
    # and of the version that the lock pins for its types
    lock = json.loads((ROOT / "package-lock.json").read_text("utf-8"))
    version = lock["packages"]["node_modules/preact"]["version"]
    told = (STATIC / "vendor" / "README.md").read_text("utf-8")
    assert f"Preact {version}" in told
    assert "MIT" in (STATIC / "vendor" / "preact-LICENSE.txt").read_text("utf-8")


def test_the_lock_names_no_place() -> None:
    assert "resolved" not in (ROOT / "package-lock.json").read_text("utf-8")


@pytest.mark.parametrize("path", OWN, ids=name)
def test_page_asks_nobody_else_and_runs_no_text(path: Path) -> None:
    text = path.read_text("utf-8")
    assert "style=" not in text
    assert not re.search(r"\b(eval|Function)\(|innerHTML|dangerouslySet", text)
    addresses = re.findall(r"https?://[^\s\"'<>)]+", text)
    assert [a for a in addresses if a != "http://www.w3.org/2000/svg"] == []
    made = path.name == "reader.js"  # a constant a line, by the translator
    assert max(map(len, text.splitlines())) <= 100 or path.suffix == ".html" or made


STATIC_IMPORT = r"^(?:im|ex)port [^;(]*?from \"(\.[^\"]+)\";"
LATE_IMPORT = r"(?:import|new URL)\(\"(\.[^\"]+\.js)\""


def imported(start: str, *how: str) -> set[str]:
    """Return the modules that one loads by such imports, itself included."""
    found, waiting = set[str](), [start]
    while waiting:
        at = waiting.pop()
        if at not in found:
            found.add(at)
            text, folder = (STATIC / at).read_text("utf-8"), (STATIC / at).parent
            steps = [step for pattern in how for step in re.findall(pattern, text, re.M | re.S)]
            waiting += [name((folder / step).resolve()) for step in steps]
    return found


def test_every_module_and_style_is_used() -> None:
    scripts = {name(p) for p in FILES if p.suffix == ".js"}
    assert imported("main.js", STATIC_IMPORT, LATE_IMPORT) == scripts
    first = {"style.css", "late.css"}
    styles = {name(p) for p in FILES if p.suffix == ".css"} - first
    text = "".join((STATIC / file).read_text("utf-8") for file in sorted(first))
    assert set(re.findall(r"@import \"\./(.*)\";", text)) == styles


#: Addresses of files in what is served.
NAMED = re.compile(r"[\"'`](?:/static/|(?:\.\.?/)+)([\w./-]+\.(?:js|css|svg))[\"'`]")


def test_what_is_served_names_only_what_is_served() -> None:
    # built by tools/page_bundle.mjs; that it is what the modules give, test_page_file.py says
    there = {p.relative_to(BUILT).as_posix() for p in BUILT.rglob("*") if p.is_file()}
    named = {"index.html"}
    for file in there:
        for found in NAMED.findall((BUILT / file).read_text("utf-8")):
            beside = Path(file).parent / found  # the worker is named by what stands beside it
            named.add(found if found in there else beside.as_posix())
    assert named == there


def test_what_comes_later_finds_its_names_in_the_first_script() -> None:
    (exports,) = re.findall(r"export\{([^}]*)\}", (BUILT / "main.js").read_text("utf-8"))
    there = {part.split(" as ")[-1] for part in exports.split(",")}
    taken = set[str]()
    for file in BUILT.rglob("*.js"):
        for part in re.findall(
            r"import\{([^}]*)\}from\"/static/main.js\"", file.read_text("utf-8")
        ):
            taken |= {name.partition(" as ")[0] for name in part.split(",")}
    assert "app" in taken
    assert taken - there == set()


def test_first_page_is_small_and_fetched_at_once() -> None:
    # what the first page loads, packed as the server sends it: one script and one style, and the
    # script waits for no other
    index = (BUILT / "index.html").read_text("utf-8")
    first = re.findall(r"(?:src|stylesheet\" href)=\"/static/([\w/.]+)\"", index)
    assert first == ["style.css", "main.js"]
    assert not re.search(r"(?:from|import)\s*\"", (BUILT / "main.js").read_text("utf-8"))
    whole = ["index.html", *first]
    assert sum(len(gzip.compress((BUILT / n).read_bytes(), 9)) for n in whole) < 45_500


@pytest.fixture
def local() -> TestClient:
    with client() as found:
        return found


def test_files_in_folders_are_served_by_name(local: TestClient) -> None:
    assert local.get("/static/pages/compare.js").status_code == 200
    assert local.get("/static/style.css").headers["content-type"].startswith("text/css")
    for absent in ("vendor/preact.js", "pages", "pages/", "pages/../../kernel.js"):
        assert local.get(f"/static/{absent.replace('..', '%2e%2e')}").status_code == 404, absent
