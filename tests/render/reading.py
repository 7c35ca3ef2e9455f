"""A little reading of PDF files, enough for tests: objects, metadata, the alternative texts."""

import re
import zlib
from typing import Any

import pytest
import typst

_STREAM = re.compile(rb"stream\r?\n(.*?)\r?\nendstream", re.S)


def objects(pdf: bytes) -> bytes:
    """The file with its compressed streams unpacked behind it."""
    unpacked = [pdf]
    for found in _STREAM.finditer(pdf):
        try:
            unpacked.append(zlib.decompress(found[1]))
        except zlib.error:
            continue
    return b"\n".join(unpacked)


def metadata(pdf: bytes) -> str:
    """The XMP packet, which must not be compressed."""
    found = re.search(rb"<x:xmpmeta.*?</x:xmpmeta>", pdf, re.S)
    assert found
    return found[0].decode("utf-8")


def structure(pdf: bytes, kind: str) -> list[bytes]:
    """Structure elements of a kind: ``Figure``, ``Formula``, ``TH`` ..."""
    pattern = rb"<</Type/StructElem/S/%s/.*?>>\s*endobj" % kind.encode()
    return re.findall(pattern, objects(pdf), re.S)


def pages(pdf: bytes) -> int:
    return len(re.findall(rb"/Type/Page\b", objects(pdf)))


def media_box(pdf: bytes) -> list[float]:
    found = re.search(rb"/MediaBox\s*\[([^\]]*)\]", objects(pdf))
    assert found
    return [float(number) for number in found[1].split()]


#: A sign of Linear A: the fonts that come with the typesetter lack it.
RARE = "\U00010600"


def without_system_fonts(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let the typesetter see its own fonts only, whatever this machine has."""
    compile_files: Any = typst.compile

    def own_fonts(parts: object, **settings: Any) -> Any:
        return compile_files(parts, **(settings | {"ignore_system_fonts": True}))

    monkeypatch.setattr(typst, "compile", own_fonts)
