"""The check of the documentation's links: it finds what leads nowhere and what is loaded."""

import importlib.util
from pathlib import Path
from types import ModuleType

import pytest

FILE = Path(__file__).parents[2] / "docs" / "building" / "links.py"


@pytest.fixture(scope="module")
def links() -> ModuleType:
    spec = importlib.util.spec_from_file_location("links", FILE)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize(
    ("line", "fault"),
    [
        ('<a href="b.html#there">b</a>', ""),
        ('<a href="sub/">b</a>', ""),
        ('<a href="https://example.org/none">elsewhere</a>', ""),
        ('<link rel="canonical" href="https://example.org/">', ""),
        ('<a href="c.html">c</a>', "a.html points to c.html, which is not there"),
        ('<a href="b.html#none">b</a>', "there is no such place on that page"),
        ('<a href="#none">here</a>', "there is no such place on that page"),
        ('<img src="none.png">', "a.html points to none.png, which is not there"),
        ('<script src="https://example.org/x.js"></script>', "loads https://example.org/x.js from"),
        ('<link rel="stylesheet" href="//example.org/x.css">', "loads //example.org/x.css from"),
    ],
)
def test_a_link_that_leads_nowhere_is_told(
    links: ModuleType, tmp_path: Path, line: str, fault: str
) -> None:
    (tmp_path / "b.html").write_text('<h1 id="there">b</h1>', "utf-8")
    (tmp_path / "sub").mkdir()
    (tmp_path / "sub" / "index.html").write_text("<p>sub</p>", "utf-8")
    (tmp_path / "a.html").write_text(line, "utf-8")
    found = list(links.faults(tmp_path))
    assert len(found) == bool(fault)
    assert fault in "".join(found)


def test_links_of_a_text(links: ModuleType, tmp_path: Path) -> None:
    file = tmp_path / "a.md"
    file.write_text("[a](a.md#x) [b](none.md) [c](https://example.org)", "utf-8")
    assert list(links.text_faults(file)) == ["a.md points to none.md, which is not there"]
