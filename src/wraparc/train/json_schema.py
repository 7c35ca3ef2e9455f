"""JSON Schema of the files, for web forms and editors."""

from typing import Any

from wraparc.files.lagging_keys import LAGGING_FILE
from wraparc.train.keys import TRAIN_FILE

_FILES = {"drive": TRAIN_FILE, "lagging": LAGGING_FILE}


def json_schema(file: str) -> dict[str, Any]:
    """Return the JSON Schema of a ``"drive"`` or ``"lagging"`` file.

    Quantities are text with a unit; ``x-dimension``, ``x-units``, ``x-allowed`` and
    ``x-bounds-si`` say what a form must know of them.
    """
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", **_FILES[file].schema()}
