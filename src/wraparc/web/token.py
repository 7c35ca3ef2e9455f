"""The token of this user: on one machine the server lets in whoever can read it, nobody else."""

import os
import re
import secrets
from contextlib import suppress
from pathlib import Path

from wraparc.errors import InputError
from wraparc.saving import unwritable

TOKEN = re.compile(r"[A-Za-z0-9_-]{16,200}")


def own_token(folder: Path, *, new: bool = False) -> str:
    """Return the token kept in a folder, made if there is none; the same after every start.

    One that others could read or have written is no secret: another takes its place. Where none
    can be kept, a new one is returned.

    Parameters
    ----------
    folder
        The data folder of the user.
    new
        Whether to make another in place of the one that is kept.

    Raises
    ------
    InputError
        If a new one was asked for and cannot be kept: the next start would take the old one.
    """
    file = folder / "token"
    found = "" if new else _kept(file)
    if found:
        return found
    made = secrets.token_urlsafe(24)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        file.unlink(missing_ok=True)
        # readable by its owner alone from the first moment
        with open(os.open(file, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600), "w") as out:
            out.write(made)
    except OSError as error:
        if new:
            raise InputError(unwritable(file, error, key="--new-token")) from None
    return made


def _kept(file: Path) -> str:
    """Return the token in a file, or empty if there is none that only this user knows."""
    with suppress(OSError, ValueError), file.open(encoding="ascii") as opened:
        status = os.fstat(opened.fileno())
        known = os.name == "posix" and (status.st_mode & 0o077 or status.st_uid != os.getuid())
        found = opened.read(1000).strip()
        if TOKEN.fullmatch(found) and not known:
            return found
    return ""
