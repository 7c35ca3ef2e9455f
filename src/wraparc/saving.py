"""Files written as a whole or not at all, and told beforehand where that cannot be done."""

import errno
import json
import os
import secrets
import stat
import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import BinaryIO

from wraparc.errors import InputError, Problem, input_error

Location = str | os.PathLike[str]
#: What an error of the system is called when there is no room left.
FULL = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG)


@contextmanager
def replacing(target: Path) -> Iterator[Path]:
    """Give a draft beside a file; it takes the file's place if all goes well, else it goes."""
    draft = _draft(target)
    try:
        yield draft
        put_in_place(draft, target)
    finally:
        draft.unlink(missing_ok=True)


def put_in_place(draft: Path, target: Path) -> None:
    """Let a complete draft, once it is on the disk, take the place of a file, with its mode."""
    with draft.open("r+b") as file:
        to_disk(file.fileno())
    if target.exists():
        draft.chmod(stat.S_IMODE(target.stat().st_mode))
    os.replace(draft, target)


def to_disk(file: int) -> None:
    """Wait until what was written to a file is on the disk, where the system can tell."""
    try:
        os.fsync(file)
    except OSError as error:
        if error.errno in (*FULL, errno.EIO):  # else there is nothing to wait for
            raise


def _draft(target: Path) -> Path:
    """Path of a draft that nobody else writes, on whatever machine he is."""
    return target.with_name(f".{target.name[:40]}.{os.getpid()}-{secrets.token_hex(4)}.tmp")


def is_device(target: Path) -> bool:
    """Whether something is there that is written to, and never replaced: a device or a pipe."""
    return target.exists() and not stat.S_ISREG(target.stat().st_mode)


@contextmanager
def alone(path: Location, key: str = "") -> Iterator[None]:
    """Keep other runs from writing the same file; ends with its process, however that ends.

    Where there are no locks (some network drives), nobody is kept away.

    Parameters
    ----------
    path
        The file that is written.
    key
        What asked for it, for the message.

    Raises
    ------
    InputError
        If another run is writing it.
    """
    target = Path(os.path.realpath(path))
    place = target.with_name(f".{target.name}.lock")
    try:
        file = _lock(place)
    except (OSError, ValueError):  # what stands in its way stands in the way of the file too
        yield
        return
    if file is None:
        message = "another run is writing this file"
        remedy = "Wait until it has ended, or name another file."
        raise input_error(key=key, value=quoted(os.fspath(path)), message=message, remedy=remedy)
    with file:
        try:
            yield
        finally:
            with suppress(OSError):  # Windows removes no open file: it stays, and is used again
                place.unlink(missing_ok=True)


def _lock(place: Path) -> BinaryIO | None:
    """Open and lock a file; None if another has it."""
    while True:
        file = place.open("ab")
        if not _locked(file):
            file.close()
            return None
        if os.fstat(file.fileno()).st_nlink:
            return file
        file.close()  # removed meanwhile by whoever had it: the next one is another file


def _locked(file: BinaryIO) -> bool:
    """Lock an open file; False if another has it."""
    try:
        if sys.platform == "win32":
            import msvcrt

            msvcrt.locking(file.fileno(), msvcrt.LK_NBLCK, 1)
            return True
        import fcntl

        fcntl.flock(file.fileno(), fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError as error:
        return error.errno not in (errno.EWOULDBLOCK, errno.EACCES, errno.EDEADLK)
    return True


@contextmanager
def interrupted(kept: Callable[[], str]) -> Iterator[None]:
    """Let an interruption say what is kept, if anything: a note, which the command line shows."""
    try:
        yield
    except KeyboardInterrupt as error:
        note = kept()
        if note:
            error.add_note(note)
        raise


def save_file(path: Location, data: str | bytes) -> None:
    """Write a file: text as UTF-8, whole or not at all.

    What UTF-8 has no place for, as in names that are not UTF-8, is written as an escape.

    A draft beside the file takes its place when it is complete; what was there before stays
    untouched until then. A device or pipe is written to directly.

    Raises
    ------
    InputError
        If it cannot be written.
    """
    content = as_bytes(data)
    target = Path(os.path.realpath(path))
    try:
        if is_device(target):
            target.write_bytes(content)
            return
        with replacing(target) as draft:
            draft.write_bytes(content)
    except (OSError, ValueError) as error:
        raise InputError(unwritable(path, error)) from None


def as_bytes(data: str | bytes) -> bytes:
    """Return text as the bytes of a file."""
    return data.encode("utf-8", "backslashreplace") if isinstance(data, str) else data


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
        message = f"must end in {' or '.join(allowed)}"
        remedy = f"Write for example {quoted((os.path.splitext(name)[0] or 'file') + allowed[0])}."
        return [_of_path(name, message, remedy, key)]
    if any(_same(name, given) for given in inputs):
        return [_of_path(name, "must not be a file that is read", "Choose another name.", key)]
    problem = _trial(name, key) or _no_text(name, key)
    return [] if problem is None else [problem]


def _of_path(path: Location, message: str, remedy: str, key: str) -> Problem:
    """Return the problem of a path: the value of what asked for it, else the place itself."""
    name = os.fspath(path)
    if key:
        return Problem(key=key, value=quoted(name), message=message, remedy=remedy)
    return Problem(file=_printable(name), message=message, remedy=remedy)


def _no_text(name: str, key: str) -> Problem | None:
    """What writes Parquet takes paths as text alone."""
    if not name.lower().endswith(".parquet"):
        return None
    try:
        os.path.realpath(name).encode("utf-8")
    except UnicodeEncodeError:
        return _of_path(name, "its path must be UTF-8", "Name another file.", key)
    return None


def _same(path: str, given: Location) -> bool:
    try:
        return os.path.samefile(path, given)
    except (OSError, ValueError):
        return False


def _trial(name: str, key: str) -> Problem | None:
    """Put an empty draft beside the file and take it away again."""
    try:
        target = Path(os.path.realpath(name))
        if target.is_dir():
            return _of_path(name, "is a folder", "Name a file in it.", key)
        if not target.parent.is_dir():
            return _of_path(name, "its folder does not exist", "Make the folder first.", key)
        if target.exists() and not os.access(target, os.W_OK):
            raise PermissionError(0, "Permission denied")
        if not is_device(target):
            draft = _draft(target)
            draft.touch()
            draft.unlink()
    except (OSError, ValueError) as error:
        return unwritable(name, error, key=key)
    return None


def unwritable(
    path: Location, error: Exception, remedy: str = "Choose another place.", *, key: str = ""
) -> Problem:
    """Return the problem of a file that cannot be written, with the words of the system."""
    reason = getattr(error, "strerror", None) or str(error)
    return _of_path(path, f"cannot be written: {reason}", remedy, key)


def quoted(path: str) -> str:
    """Return a path for a message: whole, so that it can be found, and printable."""
    return _printable(json.dumps(path, ensure_ascii=False))


def _printable(text: str) -> str:
    return "".join(c if c.isprintable() else f"\\u{ord(c):04x}" for c in text)
