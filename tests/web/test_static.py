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
FILES = sorted(p for p in STATIC.rglob("*") if p.suffix in (".js", ".css", ".html"))
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
    assert max(map(len, text.splitlines())) <= 100 or path.suffix == ".html"


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


FIRST_STYLE = re.compile(r"/static/(style/\w+\.css)")


def late_styles(script: str) -> list[str]:
    """Return the styles that a module brings along."""
    text = (STATIC / script).read_text("utf-8")
    return re.findall(r"new URL\(\"\.\./(style/\w+\.css)\"", text)


def test_every_module_and_style_is_used() -> None:
    scripts = {name(p) for p in FILES if p.suffix == ".js"}
    assert imported("main.js", STATIC_IMPORT, LATE_IMPORT) == scripts
    styles = {name(p) for p in FILES if p.suffix == ".css"}
    index = (STATIC / "index.html").read_text("utf-8")
    late = {s for script in scripts for s in late_styles(script)}
    assert set(FIRST_STYLE.findall(index)) | late == styles


def test_first_page_is_small_and_fetched_at_once() -> None:
    # what the first page loads, packed as the server sends it; every module is named in the index,
    # so that none waits for another that imports it
    first = imported("main.js", STATIC_IMPORT)
    index = (STATIC / "index.html").read_text("utf-8")
    assert set(re.findall(r"/static/([\w/]+\.js)", index)) == first
    whole = {"index.html", *first, *FIRST_STYLE.findall(index)}
    assert sum(len(gzip.compress((STATIC / n).read_bytes(), 9)) for n in whole) < 65_000


@pytest.fixture
def local() -> TestClient:
    with client() as found:
        return found


def test_files_in_folders_are_served_by_name(local: TestClient) -> None:
    assert local.get("/static/vendor/preact.js").status_code == 200
    assert local.get("/static/style/frame.css").headers["content-type"].startswith("text/css")
    for absent in ("vendor/preact.d.ts", "vendor", "vendor/", "vendor/../main.py"):
        assert local.get(f"/static/{absent.replace('..', '%2e%2e')}").status_code == 404, absent
