"""Drive and lagging files: the only place that knows their formats."""

from typing import TYPE_CHECKING, Any

from wraparc.files.drive_file import drive_from_document, drive_from_text, load_drive
from wraparc.files.lagging_file import (
    lagging_from_document,
    lagging_from_text,
    load_lagging,
    load_lagging_conditions,
)
from wraparc.files.overrides import overridden, parse_override

if TYPE_CHECKING:
    from wraparc.files.schema import json_schema
    from wraparc.files.train_file import (
        load_drive_or_train,
        load_train,
        train_from_document,
        train_from_text,
    )
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
    "json_schema",
    "lagging_from_document",
    "lagging_from_text",
    "lagging_text",
    "load_drive",
    "load_drive_or_train",
    "load_lagging",
    "load_lagging_conditions",
    "load_train",
    "overridden",
    "parse_override",
    "save_drive",
    "save_lagging",
    "train_from_document",
    "train_from_text",
]
_TRAIN = ("load_drive_or_train", "load_train", "train_from_document", "train_from_text")


def __getattr__(name: str) -> Any:
    """Import what writes files, or reads trains, only where it is used: reading must start fast."""
    if name not in __all__:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    if name in _TRAIN:
        from wraparc.files import train_file

        return getattr(train_file, name)
    from wraparc.files import schema, write

    return getattr(schema if name == "json_schema" else write, name)


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
