"""What the server writes is for its user alone: files 0600, folders 0700.

On Windows modes protect nothing; there the folder of the user's data is private by its place.
"""

import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from glob import escape
from html import escape as for_html
from pathlib import Path

#: What SQLite and the copies of a database put beside its file.
_BESIDE = ("-wal", "-shm", "-journal", ".backup", ".before-*")


@contextmanager
def private_files() -> Iterator[None]:
    """Let every file and folder that this process and its own make be the user's alone."""
    before = os.umask(0o077)
    try:
        yield
    finally:
        os.umask(before)


def close_to_others(path: Path) -> None:
    """Take from others what they may do with a file or folder of this user, if there is one."""
    with suppress(OSError):  # of another user, or on a disk without modes: nothing can be taken
        mode = path.stat().st_mode
        if mode & 0o077:
            path.chmod(mode & 0o700)


def mend_database(file: str) -> None:
    """Close an SQLite file, its log, its copies and their drafts to others, as found."""
    whole = Path(os.path.realpath(file))
    close_to_others(whole)
    name = escape(whole.name)
    for pattern in (*(name + end for end in _BESIDE), f".{name}*.tmp"):
        for found in whole.parent.glob(pattern):
            if not found.is_symlink():  # it leads to what is not ours to change
                close_to_others(found)


@contextmanager
def redirecting(address: str) -> Iterator[str]:
    """Give the address of a file that only this user can read, and that leads to a page.

    For a browser: what stands on its command line is shown to every user of the machine.
    """
    place = for_html(address)
    page = (
        '<!doctype html><meta charset="utf-8"><meta name="referrer" content="no-referrer">'
        f'<meta http-equiv="refresh" content="0; url={place}"><title>wraparc</title>'
        f'<a href="{place}">The calculator</a>'
    )
    opened, name = tempfile.mkstemp(prefix="wraparc-", suffix=".html")  # 0600
    try:
        with open(opened, "w", encoding="utf-8") as out:
            out.write(page)
        yield Path(name).as_uri()
    finally:
        Path(name).unlink(missing_ok=True)
