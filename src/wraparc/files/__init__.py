"""Drive and lagging files: the only place that knows their formats."""

from wraparc.files.drive_file import drive_from_document, drive_from_text, load_drive
from wraparc.files.lagging_file import (
    lagging_from_document,
    lagging_from_text,
    load_lagging,
    load_lagging_conditions,
)
from wraparc.files.overrides import overridden, parse_override
from wraparc.files.schema import json_schema
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
    "load_lagging",
    "load_lagging_conditions",
    "overridden",
    "parse_override",
    "save_drive",
    "save_lagging",
]
