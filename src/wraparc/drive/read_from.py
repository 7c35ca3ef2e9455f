"""What a drive or a train was read from, for those who read it again with other values."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True, eq=False)
class ReadFrom:
    """A document that was read.

    Attributes
    ----------
    document
        Tables of a drive file; not to be changed.
    folder
        What the paths of lagging files are relative to.
    allow_paths
        Whether files may be named at all.
    """

    document: Mapping[str, Any]
    folder: str = ""
    allow_paths: bool = False
