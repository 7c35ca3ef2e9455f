"""The token of this user: on one machine the server lets in whoever can read it, nobody else."""

import os
import re
import secrets
from pathlib import Path

TOKEN = re.compile(r"[A-Za-z0-9_-]{16,200}")


def own_token(folder: Path) -> str:
    """Return the token kept in a folder, made if there is none; the same after every start.

    Where none can be kept, a new one is returned.
    """
    file = folder / "token"
    try:
        found = file.read_text("ascii").strip()
        if TOKEN.fullmatch(found):
            return found
    except (OSError, ValueError):
        pass
    made = secrets.token_urlsafe(24)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        file.unlink(missing_ok=True)
        # readable by its owner alone from the first moment
        with open(os.open(file, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600), "w") as out:
            out.write(made)
    except OSError:
        pass
    return made
