"""Letters that no font at hand has: which they are, and boxes with their codes in their place."""

import json
import re
import unicodedata
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from typing import Any

from wraparc.errors import format_list

#: How a document of words alone is set to learn whether every letter can be shown.
PROBE: dict[str, Any] = {"format": "pdf", "pdf_standards": ["a-2a"]}
_WORDS = b"""#let data = json("data.json")
#set text(font: data.fonts)
#for word in data.words [#word #parbreak()]
"""
_SHOWN = re.compile(r'the text `"(.*?)"` could not be displayed', re.DOTALL)
_ESCAPED = re.compile(r"\\u\{([0-9a-f]+)\}")
#: What the template makes a box of: a code between two letters that no text has.
_BEGIN, _END = "\ue000", "\ue001"
_IN_PICTURES = "\u25a1"
#: After so many letters of a script that are lacking, no other of it is tried.
_MANY = 8


def find_lacking(
    data: Mapping[str, Any], parts: Mapping[str, bytes], typeset: Callable[[dict[str, bytes]], Any]
) -> set[str]:
    """Return the letters of a document that no font at hand has.

    Parameters
    ----------
    data, parts
        The document: what its template asks for, and its files.
    typeset
        Sets a document of words; its error names a text that cannot be shown.
    """
    import typst

    words = {word for text in _texts(data) for word in text.split() if not word.isascii()}
    for name, picture in parts.items():
        if name.endswith(".svg"):
            words |= {w for w in re.split(r"[\s<>]", picture.decode()) if not w.isascii()}
    lacking = {_BEGIN, _END}
    while True:
        left = sorted({"".join(c for c in word if c not in lacking) for word in words})
        probe = {"fonts": data["fonts"], "words": left}
        try:
            typeset({"main.typ": _WORDS, "data.json": json.dumps(probe).encode()})
        except typst.TypstError as error:
            lacking |= _named(error.message, left, lacking)
        else:
            return lacking


def _named(message: str, words: list[str], lacking: set[str]) -> set[str]:
    """Return the letters that an error names, with the marks of their script.

    All of their script if many of it are lacking: a mark alone would stand on what is before it.
    """
    letters = {letter for word in words for letter in word if not letter.isascii()}
    shown = _SHOWN.search(message)
    text = _ESCAPED.sub(lambda code: chr(int(code[1], 16)), shown[1]) if shown else ""
    found = letters & set(text)
    many = Counter(map(_script, lacking | found))
    marks = {letter for letter in letters if unicodedata.category(letter).startswith("M")}
    scripts = set(map(_script, found))
    found |= {letter for letter in marks if _script(letter) in scripts}
    found |= {letter for letter in letters if many[_script(letter)] >= _MANY}
    return found or marks or letters  # an error that names none: no other letter is sure


def _script(letter: str) -> str:
    return unicodedata.name(letter, "").partition(" ")[0]


def _texts(value: Any) -> Iterator[str]:
    if isinstance(value, str):
        yield value
    elif isinstance(value, Mapping):
        for item in value.values():
            yield from _texts(item)
    elif isinstance(value, list | tuple):
        for item in value:
            yield from _texts(item)


def boxed(
    data: Mapping[str, Any], parts: Mapping[str, bytes], lacking: set[str]
) -> dict[str, bytes]:
    """Return the files of a document with boxes in the place of letters, and a line on them.

    Parameters
    ----------
    data, parts
        The document.
    lacking
        The letters.
    """
    codes = str.maketrans({c: f"{_BEGIN}{ord(c):04X}{_END}" for c in lacking})
    empty = str.maketrans(dict.fromkeys(lacking, _IN_PICTURES))
    used = sorted({c for text in _texts(data) for c in text} & lacking)
    line = format_list([f"U+{ord(c):04X}" for c in used])
    shown = {key: _translated(value, codes) for key, value in data.items() if key != "file"}
    shown["file"] = data["file"]
    shown["letters"] = (
        f"No installed font has these letters, shown as boxes with their codes: {line}. "
        "Install a font of that script."
    )
    pictures = {
        name: part.decode().translate(empty).encode() if name.endswith(".svg") else part
        for name, part in parts.items()
    }
    return {**pictures, "data.json": json.dumps(shown).encode()}


def _translated(value: Any, table: dict[int, str]) -> Any:
    if isinstance(value, str):
        return value.translate(table)
    if isinstance(value, Mapping):
        return {key: _translated(item, table) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_translated(item, table) for item in value]
    return value
