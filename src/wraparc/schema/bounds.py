"""How much a document may hold: counted in its text, before any of it is parsed.

Parsing takes a time that grows with what stands there, for some of it faster than in proportion;
counting takes some milliseconds a megabyte, whatever it is.
"""

import re

import numpy as np

from wraparc.errors import InputError, input_error

#: Most keys, most lists and tables, most values in lists. A thousand load cases are a fifth.
MOST_KEYS, MOST_TABLES, MOST_VALUES = 20_000, 20_000, 100_000
#: Most lines of a text: each costs its time, also one that says nothing.
MOST_LINES = 150_000
#: Tables within tables; those of a drive file are not a tenth as deep.
DEEPEST = 60
#: Most parts of one dotted key: those of a drive file have four.
MOST_KEY_PARTS = 10
_JSON_REMEDY = "Send a drive document."
#: Longest key [characters].
LONGEST_KEY = 200

# What is left open goes on to the end: so each character is looked at once, whatever it is.
_TOML_TEXT = re.compile(
    r'"""(?:[^"\\]|\\.|"(?!""))*+(?:"""|\Z)'
    r"|'''(?:[^']|'(?!''))*+(?:'''|\Z)"
    r'|"(?:[^"\\\n]|\\[^\n])*+"?+'
    r"|'[^'\n]*+'?+"
    r"|#[^\n]*+",
    re.DOTALL,
)
_PART = r"""(?:[\w-]++|"[^"\n]*+"|'[^'\n]*+')"""
_MANY_PARTS = re.compile(rf"(?<![\w\"'.-])(?:{_PART}[ \t]*+\.[ \t]*+){{{MOST_KEY_PARTS}}}")
_LONG_WORD = re.compile(rf"(?<![\w-])[\w-]{{{LONGEST_KEY + 1},}}+")
_LONG_QUOTED = re.compile(
    rf"""(?:"(?:[^"\\\n]|\\.){{{LONGEST_KEY + 1},}}+"|'[^'\n]{{{LONGEST_KEY + 1},}}+')"""
    r"[ \t]*+[=.]"
)
_LONG_HEAD = re.compile(rf"""^\[[\[ \t]*+["'][^\n]{{{LONGEST_KEY + 1}}}""", re.MULTILINE)


def check_toml(text: str, file: str = "") -> None:
    """Refuse a TOML text that holds more than is read.

    Raises
    ------
    InputError
        With what is too many, too deep or too long.
    """
    _check_count(text.count("\n"), MOST_LINES, "lines", file)
    for found, message in (
        (_LONG_QUOTED.search(text), f"a key of more than {LONGEST_KEY} characters"),
        (_LONG_HEAD.search(text), f"a key of more than {LONGEST_KEY} characters"),
        (_MANY_PARTS.search(text), f"a key of more than {MOST_KEY_PARTS} parts"),
    ):
        if found:
            raise _refused(message, "Check that it is the right file.", file, text, found.start())
    bare = _TOML_TEXT.sub("", text)
    if _LONG_WORD.search(bare):
        message = f"a key or number of more than {LONGEST_KEY} characters"
        raise _refused(message, "Check that it is the right file.", file)
    _check_counts(bare, bare.count("="), file)


def check_json(text: str) -> None:
    """Refuse a JSON text that holds more than is read.

    Raises
    ------
    InputError
        With what is too many, too deep or too long.
    """
    if text.count('"') > 2 * (2 * MOST_KEYS + MOST_VALUES):
        raise _refused("contains too many texts", _JSON_REMEDY)
    # without what is escaped every quote begins or ends a text: bare, text, bare, text ...
    parts = text.replace("\\\\", "").replace('\\"', "").split('"')
    bare, texts = parts[::2], parts[1::2]
    for written, after in zip(texts, bare[1:], strict=False):
        if len(written) > LONGEST_KEY and after.lstrip()[:1] == ":":
            raise _refused(f"a key of more than {LONGEST_KEY} characters", _JSON_REMEDY)
    whole = "".join(bare)
    _check_counts(whole, whole.count(":"), "", _JSON_REMEDY)


def _check_counts(
    bare: str, keys: int, file: str, remedy: str = "Check that it is the right file."
) -> None:
    """Refuse by a text without its strings and comments."""
    tables = bare.count("[") + bare.count("{")
    for count, most, what in (
        (keys, MOST_KEYS, "keys"),
        (tables, MOST_TABLES, "lists and tables"),
        (bare.count(","), MOST_VALUES, "values in lists"),
    ):
        _check_count(count, most, what, file, remedy)
    if tables > DEEPEST and _deepest(bare) > DEEPEST:
        message = f"is nested more than {DEEPEST} deep"
        raise _refused(message, remedy, file)


def _check_count(
    count: int, most: int, what: str, file: str, remedy: str = "Check that it is the right file."
) -> None:
    if count > most:
        raise _refused(f"contains {count:,} {what}; at most {most:,} are read", remedy, file)


def _deepest(bare: str) -> int:
    """Return how deep lists and tables lie in each other."""
    signs = np.frombuffer(bare.encode("utf-8", "replace"), np.uint8)
    opens = (signs == ord("[")) | (signs == ord("{"))
    shuts = (signs == ord("]")) | (signs == ord("}"))
    return int(np.cumsum(opens.astype(np.int32) - shuts).max(initial=0))


def _refused(
    message: str, remedy: str, file: str = "", text: str = "", at: int | None = None
) -> InputError:
    line = None if at is None else text.count("\n", 0, at) + 1
    return input_error(message=message, remedy=remedy, file=file, line=line)
