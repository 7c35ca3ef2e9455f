"""Drive and lagging files: the only place that knows their formats."""

from typing import TYPE_CHECKING, Any

from wraparc.files.drive_file import (
    drive_from_document,
    drive_from_text,
    load_drive,
    overridden,
)
from wraparc.files.lagging_file import (
    lagging_from_document,
    lagging_from_text,
    load_lagging,
    load_lagging_conditions,
)
from wraparc.schema.overrides import parse_override

if TYPE_CHECKING:
    from wraparc.files.write import (
        drive_document,
        drive_text,
        lagging_text,
        save_drive,
        save_lagging,
    )

__all__ = [
    "drive_document",
    "drive_from_document",
    "drive_from_text",
    "drive_text",
    "lagging_from_document",
    "lagging_from_text",
    "lagging_text",
    "load_drive",
    "load_lagging",
    "load_lagging_conditions",
    "overridden",
    "parse_override",
    "save_drive",
    "save_lagging",
]


def __getattr__(name: str) -> Any:
    """Import what writes files only where it is used: reading must start fast."""
    if name not in __all__:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from wraparc.files import write

    return getattr(write, name)


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
