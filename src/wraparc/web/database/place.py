"""Where the database of saved designs is."""

import os
import sys
from pathlib import Path

from wraparc.errors import input_error, shown
from wraparc.web.private import close_to_others

_FILE = "designs.sqlite"
_KINDS = ("sqlite", "postgresql")


def database_url(given: str | None) -> str:
    """Return the URL of a database: as given, of a file as given, or of the user's own file.

    Raises
    ------
    InputError
        If it is of another kind, or its folder cannot be made.
    """
    if given is None:
        url = _of_file(user_folder() / _FILE)
        if not os.environ.get("WRAPARC_DATA"):  # a folder that was named may hold other things
            close_to_others(user_folder())
        return url
    kind, mark, rest = given.partition("://")
    if not mark or len(kind) == 1:  # C://... is a path too
        return _of_file(Path(given))
    dialect = kind.partition("+")[0]
    if dialect not in _KINDS:
        raise input_error(
            key="--database",
            value=shown(f"{kind}://..."),
            message="no database that can be used",
            remedy="Write the path of a file, or postgresql://user@host/name.",
        )
    return f"postgresql+psycopg://{rest}" if dialect == "postgresql" else given


def user_folder() -> Path:
    """Return the folder of this user's data."""
    given = os.environ.get("WRAPARC_DATA")
    if given:
        return Path(given)
    try:
        home = Path.home()
    except RuntimeError:
        message = "this user has no home folder"
        remedy = "Set WRAPARC_DATA to a folder, or give --database."
        raise input_error(message=message, remedy=remedy) from None
    if sys.platform == "win32":
        base = Path(os.environ.get("LOCALAPPDATA", home / "AppData" / "Local"))
    elif sys.platform == "darwin":
        base = home / "Library" / "Application Support"
    else:
        base = Path(os.environ.get("XDG_DATA_HOME") or home / ".local" / "share")
    return base / "wraparc"


def _of_file(path: Path) -> str:
    whole = path.expanduser().absolute()
    try:
        whole.parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise input_error(
            key="--database",
            value=shown(str(path)),
            message=f"its folder cannot be made: {error.strerror}",
            remedy="Name another file.",
        ) from None
    if "?" in whole.name:
        message, remedy = "a ? begins the options of a database", "Name another file."
        raise input_error(key="--database", value=shown(str(path)), message=message, remedy=remedy)
    return f"sqlite:///{whole.as_posix()}"
