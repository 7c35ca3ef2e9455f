"""The pages: files of the package, known by name from the start, packed and tagged."""

import gzip
import hashlib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

_KINDS = {
    ".html": "text/html; charset=utf-8",
    ".js": "text/javascript; charset=utf-8",
    ".css": "text/css; charset=utf-8",
    ".svg": "image/svg+xml",
    ".png": "image/png",
    ".ico": "image/x-icon",
    ".webmanifest": "application/manifest+json",
    ".json": "application/json",
}


@dataclass(frozen=True)
class StaticFile:
    """One file as it is sent.

    Attributes
    ----------
    kind
        Its media type.
    plain, packed
        Its bytes, and those packed by gzip.
    tag
        What changes when it changes, with its quotes.
    """

    kind: str
    plain: bytes
    packed: bytes
    tag: str


class Static:
    """The files of a folder and those in it. A request names a file by a key of a table."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._paths = self._listed()
        self._kept: dict[str, tuple[int, StaticFile]] = {}

    def _listed(self) -> Mapping[str, Path]:
        return {
            path.relative_to(self._folder).as_posix(): path
            for path in self._folder.rglob("*")
            if path.is_file() and path.suffix in _KINDS
        }

    def get(self, name: str) -> StaticFile | None:
        """Return a file, read anew if it has changed; None if there is none of this name."""
        if name not in self._paths:
            self._paths = self._listed()  # a file that came later
        path = self._paths.get(name)
        if path is None:
            return None
        try:
            changed = path.stat().st_mtime_ns
            kept = self._kept.get(name)
            if kept is None or kept[0] != changed:
                kept = changed, _packed(path)
                self._kept[name] = kept
        except OSError:
            return None
        return kept[1]


def _packed(path: Path) -> StaticFile:
    content = path.read_bytes()
    digest = hashlib.sha256(content).hexdigest()[:32]
    return StaticFile(_KINDS[path.suffix], content, gzip.compress(content, 9), f'"{digest}"')
