"""Bytes of a machine export to text: what the file is, and its encoding.

Nothing is guessed that changes a number: encodings of one byte a character differ in
letters only, so the choice among them touches column names and nothing else.
"""

import codecs
from dataclasses import dataclass
from itertools import pairwise

from wraparc.errors import shown
from wraparc.machine_tables.code_pages import ASKED, page_of, printable
from wraparc.machine_tables.limits import refused

_BOMS = (
    (codecs.BOM_UTF8, "utf-8-sig"),
    (codecs.BOM_UTF16_LE, "utf-16"),
    (codecs.BOM_UTF16_BE, "utf-16"),
)
_ZIP = b"PK\x03\x04"
_OLE = b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1"
_OTHER_FORMATS = (
    (b"%PDF", "a PDF document"),
    (b"\x89PNG", "a PNG picture"),
    (b"\xff\xd8\xff", "a JPEG picture"),
    (b"\x1f\x8b", "a gzip archive"),
    (b"7z\xbc\xaf", "a 7-Zip archive"),
    (b"SQLite format 3", "an SQLite database"),
)
_REMEDY = "Export it as CSV or Excel workbook."
# Letters seen in column names of the languages these code pages serve.
_CENTRAL_EUROPEAN = set("ąćęłńśźżčďěňřšťůžőűăşţĄĆĘŁŃŚŹŻČĎĚŇŘŠŤŮŽŐŰ")
_WESTERN = set("äöüßéèêàâçîïôûñáíóúãõåæøìòùëÄÖÜÉÈÀÇÑÁÍÓÚÃÕÅÆØÌÒÙË°²µ")
# Letters beyond ASCII of a head that is looked at, their share beside another such letter, which
# words of Latin letters have not; the answer where they are no words.
_SOME, _TOGETHER, _UNCLEAR = 4, 0.5, "unclear"


@dataclass(frozen=True)
class Decoded:
    """Text of a file, and how it was encoded.

    Parameters
    ----------
    text
        The text, its line ends those of Unix.
    encoding
        Python's name of the encoding.
    ended
        Whether the last line has its line end.
    notes
        What had to be passed over, as sentences.
    """

    text: str
    encoding: str
    ended: bool
    notes: tuple[str, ...] = ()


def is_workbook(data: bytes) -> bool:
    """Whether `data` starts as an Excel workbook (xlsx, xlsb, ods: zip; xls: OLE) does."""
    return data.startswith((_ZIP, _OLE))


def decode(data: bytes, file: str, encoding: str | None = None) -> Decoded:
    """Decode a text export.

    A byte-order mark decides; without one, UTF-16 is recognised by its zero bytes and
    UTF-8 by being valid; else the code page (cp1252, cp1250, latin-1) whose letters are
    those of the languages it serves.

    Parameters
    ----------
    data
        The file.
    file
        Its name, for the error.
    encoding
        Python's name of the encoding, to be used instead of looking for one.

    Raises
    ------
    InputError
        If `data` is empty or is no text, or `encoding` does not fit.
    """
    if not data.strip(b"\x00\x1a\r\n\t "):
        raise refused(file, "is empty", _REMEDY)
    for magic, kind in _OTHER_FORMATS:
        if data.startswith(magic):
            raise refused(file, f"is {kind}, no table", _REMEDY)
    name = encoding or _encoding_of(data)
    if name == _UNCLEAR:
        remedy = f"Give --encoding, such as {ASKED} (in a plan: encoding)."
        raise refused(file, "encoding unclear", remedy)
    if name is None:
        raise refused(file, "is binary, no text", _REMEDY)
    text, notes = _decode(data, name, file, found=encoding is None)
    text = text.rstrip("\x1a\x00").replace("\r\r\n", "\n").replace("\r\n", "\n").replace("\r", "\n")
    text = printable(text)
    return Decoded(text=text, encoding=name, ended=text.endswith("\n"), notes=notes)


def _decode(data: bytes, name: str, file: str, *, found: bool) -> tuple[str, tuple[str, ...]]:
    try:
        return data.decode(name), ()
    except UnicodeDecodeError as error:
        # A transfer that broke off may end inside a character.
        if error.start >= len(data) - 3:
            text = data[: error.start].decode(name)
            return text, ("the file ends inside a character, which was left out",)
        raise refused(
            file,
            f"byte {error.start} is not of encoding {name}",
            "Give --encoding, such as gbk, shift_jis or cp1251 (in a plan: encoding)."
            if found
            else "Leave the encoding out, or correct it.",
        ) from None
    except (LookupError, ValueError):
        raise refused(
            file,
            "no such encoding",
            "Write for example utf-8, utf-16, cp1252, cp1250 or latin-1.",
            key="encoding",
            value=shown(name),
        ) from None


def _encoding_of(data: bytes) -> str | None:
    for mark, name in _BOMS:
        if data.startswith(mark):
            return name
    head = data[:65536]
    if head.count(0) > len(head) // 5:
        return _utf16_of(head)
    controls = sum(head.count(c) for c in range(32) if c not in (9, 10, 11, 12, 13, 26, 27))
    if controls > len(head) // 500:
        return None
    try:
        data.decode("utf-8")
    except UnicodeDecodeError as error:
        if error.start >= len(data) - 3 and error.reason == "unexpected end of data":
            return "utf-8"
    else:
        return "utf-8"
    page = page_of(data)
    if page is not None:
        return page
    best = max(("cp1252", "cp1250", "latin-1"), key=lambda name: _plausibility(data, name))
    odd = [ord(c) > 127 and c.isalpha() for c in head.decode(best, errors="replace")]
    beside = sum(a and b for a, b in pairwise(odd))
    return _UNCLEAR if sum(odd) >= _SOME and beside > _TOGETHER * sum(odd) else best


def _utf16_of(head: bytes) -> str | None:
    """UTF-16 without a mark: Latin text has zeros at every other byte, and at no other."""
    even, odd = head[0::2].count(0), head[1::2].count(0)
    if odd > 0.4 * len(head) / 2 and even * 50 < odd:
        return "utf-16-le"
    if even > 0.4 * len(head) / 2 and odd * 50 < even:
        return "utf-16-be"
    return None


def _plausibility(data: bytes, name: str) -> float:
    """How much the letters beyond ASCII look like words, in `name`."""
    high = bytes(b for b in data[:65536] if b >= 128)
    text = high.decode(name, errors="replace")
    familiar = _CENTRAL_EUROPEAN | _WESTERN if name == "cp1250" else _WESTERN
    odd = sum(c == "�" or "\x80" <= c <= "\x9f" for c in text)
    # Western names are the commoner: another page must explain letters this one cannot.
    preference = {"cp1252": 0.02, "cp1250": 0.01, "latin-1": 0.0}[name]
    return sum(c in familiar for c in text) - 5.0 * odd + preference
