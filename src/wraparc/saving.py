"""Files written as a whole or not at all, and told beforehand where that cannot be done."""

import json
import os
import stat
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path

from wraparc.errors import InputError, Problem

Location = str | os.PathLike[str]


@contextmanager
def replacing(target: Path) -> Iterator[Path]:
    """Give a draft beside a file; it takes the file's place if all goes well, else it goes."""
    draft = _draft(target)
    try:
        yield draft
        if target.exists():
            draft.chmod(stat.S_IMODE(target.stat().st_mode))
        os.replace(draft, target)
    finally:
        draft.unlink(missing_ok=True)


def _draft(target: Path) -> Path:
    return target.with_name(f".{target.name[:80]}.{os.getpid()}.tmp")


def save_file(path: Location, data: str | bytes) -> None:
    """Write a file: text as UTF-8, whole or not at all.

    A draft beside the file takes its place when it is complete; what was there before stays
    untouched until then. A device or pipe is written to directly.

    Raises
    ------
    InputError
        If it cannot be written.
    """
    content = data.encode("utf-8") if isinstance(data, str) else data
    target = Path(os.path.realpath(path))
    try:
        if target.exists() and not stat.S_ISREG(target.stat().st_mode):
            target.write_bytes(content)
            return
        with replacing(target) as draft:
            draft.write_bytes(content)
    except (OSError, ValueError) as error:
        raise InputError(_unwritable(path, error)) from None


def saving_problems(
    path: Location, *, suffixes: Iterable[str] = (), inputs: Iterable[Location] = (), key: str = ""
) -> list[Problem]:
    """Return why a file could not be written; nothing if it can.

    Parameters
    ----------
    path
        The file to be written.
    suffixes
        What its name may end in, if that matters.
    inputs
        Files that are read and must not be written over.
    key
        What asked for it, for the message.
    """
    name = os.fspath(path)
    allowed = tuple(suffixes)
    if allowed and not name.lower().endswith(allowed):
        message = f"the kind of file is told by its ending, which must be {' or '.join(allowed)}"
        remedy = f"Write for example {_quoted((os.path.splitext(name)[0] or 'file') + allowed[0])}."
        return [Problem(key=key, value=_quoted(name), message=message, remedy=remedy)]
    if any(_same(name, given) for given in inputs):
        message = "is the file that is read, and would be written over"
        remedy = "Choose another name."
        return [Problem(key=key, value=_quoted(name), message=message, remedy=remedy)]
    problem = _trial(name)
    return [] if problem is None else [_with_key(problem, key)]


def _same(path: str, given: Location) -> bool:
    try:
        return os.path.samefile(path, given)
    except (OSError, ValueError):
        return False


def _trial(name: str) -> Problem | None:
    """Put an empty draft beside the file and take it away again."""
    try:
        target = Path(os.path.realpath(name))
        if target.is_dir():
            return Problem(
                value=_quoted(name), message="is a folder", remedy="Name a file in that folder."
            )
        if not target.parent.is_dir():
            message = f"there is no folder {_quoted(str(target.parent))}"
            return Problem(value=_quoted(name), message=message, remedy="Make the folder first.")
        if target.exists() and not os.access(target, os.W_OK):
            raise PermissionError(0, "Permission denied")
        if not target.exists() or stat.S_ISREG(target.stat().st_mode):
            draft = _draft(target)
            draft.touch()
            draft.unlink()
    except (OSError, ValueError) as error:
        return _unwritable(name, error)
    return None


def _unwritable(path: Location, error: Exception) -> Problem:
    reason = getattr(error, "strerror", None) or str(error)
    message = f"cannot be written: {reason}"
    remedy = "Choose another place."
    return Problem(value=_quoted(os.fspath(path)), message=message, remedy=remedy)


def _quoted(path: str) -> str:
    """Return a path for a message: whole, so that it can be found, and printable."""
    text = json.dumps(path, ensure_ascii=False)
    return "".join(c if c.isprintable() else f"\\u{ord(c):04x}" for c in text)


def _with_key(problem: Problem, key: str) -> Problem:
    return Problem(key=key, value=problem.value, message=problem.message, remedy=problem.remedy)
