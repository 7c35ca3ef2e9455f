"""Links of the built documentation, checked without a network.

``python docs/building/links.py build/docs README.md CONTRIBUTING.md``: every link within the
pages leads to a page and a place that are there, and no page loads anything from elsewhere.
"""

import re
import sys
from collections.abc import Iterator
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

# Attributes that a browser follows by itself, so that a page without a network lacks something.
_LOADED = {
    ("script", "src"), ("img", "src"), ("iframe", "src"), ("link", "href"), ("source", "src"),
    ("object", "data"), ("image", "href"), ("use", "href"), ("use", "xlink:href"),
}  # fmt: skip
_LINKED = {("a", "href")}
#: Links of a page to itself elsewhere, for search engines: nothing is loaded.
_ONLY_TOLD = {"canonical", "next", "prev", "search", "index", "author", "license"}


class _Page(HTMLParser):
    """The places of a page, and what it points to."""

    def __init__(self, path: Path) -> None:
        super().__init__()
        self.places, self.loaded, self.linked = {"", "top"}, list[str](), list[str]()
        self.feed(path.read_text("utf-8"))

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        given = {name: value or "" for name, value in attrs}
        self.places |= {given[name] for name in ("id", "name") if name in given}
        told = tag == "link" and given.get("rel") in _ONLY_TOLD
        for name, value in given.items():
            if (tag, name) in _LOADED and not told:
                self.loaded.append(value)
            if (tag, name) in _LINKED:
                self.linked.append(value)


def faults(folder: Path) -> Iterator[str]:
    """Yield a sentence for every link of a folder of pages that leads nowhere."""
    found = (path for path in sorted(folder.rglob("*.html")) if "_static" not in path.parts)
    pages = {path.resolve(): _Page(path) for path in found}
    for path, page in pages.items():
        name = path.relative_to(folder.resolve())
        for target in page.loaded:
            if urlsplit(target).netloc:
                yield f"{name} loads {target} from elsewhere"
        for target in page.loaded + page.linked:
            parts = urlsplit(target)
            if parts.scheme or parts.netloc:
                continue
            there = (path.parent / unquote(parts.path)).resolve() if parts.path else path
            there = there / "index.html" if there.is_dir() else there
            if not there.exists():
                yield f"{name} points to {target}, which is not there"
            elif there in pages and unquote(parts.fragment) not in pages[there].places:
                yield f"{name} points to {target}, and there is no such place on that page"


def text_faults(file: Path) -> Iterator[str]:
    """Yield a sentence for every link of a Markdown file to a file that is not there."""
    for target in re.findall(r"\]\(([^)\s]+)\)", file.read_text("utf-8")):
        parts = urlsplit(target)
        if not parts.scheme and parts.path and not (file.parent / unquote(parts.path)).exists():
            yield f"{file.name} points to {target}, which is not there"


def main(folder: str, *files: str) -> int:
    """Print all faults; return 1 if there are any."""
    found = [*faults(Path(folder)), *(f for name in files for f in text_faults(Path(name)))]
    print("\n".join(found) or "links: every one leads somewhere, nothing is loaded from elsewhere")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
