"""Text of a file to a document (nested tables), whatever the file turns out to be."""

import os
import re
import stat
import tomllib
from typing import Any

from wraparc.errors import InputError, Problem, input_error, shown
from wraparc.schema.bounds import check_toml
from wraparc.schema.kinds import Kind
from wraparc.schema.problems import Report
from wraparc.schema.shared_keys import FORMAT

#: Largest file that is read [bytes].
LARGEST = 5_000_000
_POSITION = re.compile(r"\(at line (\d+), column \d+\)$")

Document = dict[str, Any]


def read_text(path: str | os.PathLike[str]) -> str:
    """Return the text of a plain UTF-8 file of at most 5 MB.

    Raises
    ------
    InputError
        If it cannot be read, or is something else.
    """
    file = printable(os.fspath(path))
    try:
        status = os.stat(path)
        if stat.S_ISDIR(status.st_mode):
            raise _file_problem(file, "is a folder", "Name a file in it.")
        if not stat.S_ISREG(status.st_mode):
            raise _file_problem(file, "is not a plain file", "Give the path of a text file.")
        if status.st_size > LARGEST:
            size = f"{status.st_size / 1e6:.1f} MB"
            raise _file_problem(
                file,
                f"is {size} large, more than {LARGEST / 1e6:.0f} MB",
                "Check that it is the right file.",
            )
        with open(path, "rb") as stream:
            data = stream.read(LARGEST + 1)
    except FileNotFoundError:
        raise _file_problem(file, "file not found") from None
    except (OSError, ValueError) as error:
        if isinstance(error, InputError):
            raise
        reason = getattr(error, "strerror", None) or str(error)
        raise _file_problem(file, f"cannot be read: {reason}", "Check the path.") from None
    if not data.strip():
        raise _file_problem(file, "is empty", "Check that it is the right file.")
    return decoded(data, file)


def printable(path: str) -> str:
    """Return a path as messages show it, with its control characters escaped."""
    return "".join(c if c.isprintable() else ascii(c)[1:-1] for c in path)


def decoded(data: bytes, file: str = "") -> str:
    """Return bytes as text, refusing all but UTF-8 (with or without a byte order mark)."""
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data[: error.start].count(b"\n") + 1
        problem = Problem(
            message=f"is not UTF-8 text: byte 0x{data[error.start]:02x}",
            remedy="Save it as UTF-8 text.",
            file=file,
            line=line,
        )
        raise InputError(problem) from None


def parse(text: str, file: str = "") -> Document:
    """Return the tables of a TOML text.

    Raises
    ------
    InputError
        If it is no TOML, with the line, or holds more than is read.
    """
    if len(text) > LARGEST:
        raise _file_problem(file, "is too large", "Check that it is the right file.")
    check_toml(text, file)
    try:
        return tomllib.loads(text)
    except RecursionError:
        raise _file_problem(
            file, "is nested too deeply", "Check that it is the right file."
        ) from None
    except tomllib.TOMLDecodeError as error:
        position = _POSITION.search(str(error))
        line = int(position[1]) if position else text.count("\n") + 1
        raise InputError(syntax_problem(text, line, file)) from None
    except ValueError:  # of int(), beyond the digits it converts
        message = "contains a whole number of thousands of digits"
        raise _file_problem(file, message, "Check that it is the right file.") from None


def check_format(document: Document, file: str = "") -> None:
    """Refuse a document of a newer format before complaining of keys that are new in it."""
    if "format" not in document:
        return
    given = document["format"]
    whole = isinstance(given, int) and not isinstance(given, bool)
    if whole and 1 <= given <= FORMAT:
        return
    if whole and given > FORMAT:
        message = f"must be at most {FORMAT} for this version of wraparc"
        remedy = "Update wraparc."
    else:
        message, remedy = "must be a whole number from 1", f"Write format = {FORMAT}."
    raise input_error(message=message, remedy=remedy, file=file, key="format", value=shown(given))


def read_whole(table: Kind, document: Document, file: str) -> tuple[Any, Report]:
    """Return a document read by its keys, and the report that goes on; its faults are raised."""
    record, report = read_tables(table, document, file)
    report.raise_all()
    return record, report


def read_tables(table: Kind, document: Document, file: str) -> tuple[Any, Report]:
    """Return a document read by its keys, and the report with what is wrong so far."""
    check_format(document, file)
    report = Report(file)
    return table.read(document, (), report), report


def syntax_problem(text: str, line: int, file: str = "") -> Problem:
    """Return what is said of a text that is no TOML, by the line that reading it stops at.

    In words of our own: every reader of TOML has others, and the page reads with another.
    """
    lines = text.split("\n")
    written = lines[line - 1].strip() if 0 < line <= len(lines) else ""
    message = "not valid TOML"
    remedy = 'Text needs quotes, and so does a quantity: width = "1200 mm".'
    if not "".join(lines[line - 1 :]).strip():
        message, remedy = "ends too early", "Close the bracket or the quotes that are left open."
    elif _stands_before(written, lines[: line - 1]):
        message, remedy = "is there twice", "Leave one of them out."
    elif "\\" in written:  # of "C:\drives", "C:\users"
        remedy = "Write paths with / , or in single quotes: 'C:\\drives\\lagging.toml'."
    value = shown(written) if written else ""
    return Problem(message=message, remedy=remedy, value=value, file=file, line=line)


def _stands_before(written: str, lines: list[str]) -> bool:
    """Whether a key stands in its table already, or a table in its file."""
    key = written.partition("=")[0].strip()
    if written.startswith("["):
        return written in [before.strip() for before in lines]
    keys: list[str] = []
    for before in lines:
        keys = [] if before.startswith("[") else [*keys, before.partition("=")[0].strip()]
    return key != "" and key in keys


def _file_problem(file: str, message: str, remedy: str = "") -> InputError:
    return input_error(message=message, remedy=remedy, file=file)
