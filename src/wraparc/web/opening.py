"""A drive file to a document that needs no other file."""

import os
from collections.abc import Collection
from typing import Any

from wraparc.files.lagging_file import is_path, load_lagging_conditions
from wraparc.files.write import lagging_text
from wraparc.schema.source import Document, parse, read_text
from wraparc.train.file import load_drive_or_train


def opened(path: str) -> Document:
    """Return the document of a drive file, with the lagging files it names put into it.

    Raises
    ------
    InputError
        With everything that is wrong with the file.
    """
    load_drive_or_train(path)
    document = parse(read_text(path), path)
    folder = os.path.dirname(path)
    own: dict[str, Any] = dict(document.get("lagging", {}))
    for pulley in document["pulley"]:
        named = pulley["lagging"]
        if isinstance(named, str) and named not in own and is_path(named):
            conditions = load_lagging_conditions(os.path.join(folder, named))
            table = parse(lagging_text(conditions))
            table.pop("format")
            name = _free(table.pop("name"), own)
            own[name] = table
            pulley["lagging"] = name
    return {**document, "lagging": own} if own else document


def _free(name: str, taken: Collection[str]) -> str:
    """Return the name, with a number behind it if another lagging has it."""
    others = (f"{name[:50]}-{number}" for number in range(2, len(taken) + 3))
    return next(n for n in (name, *others) if n not in taken)
