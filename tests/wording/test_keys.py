"""A key that an action names is a key of a file.

Expected are the keys of the tables that read the files. Read are the texts in the sources of the
checks and the actions: words with an underscore or a dot, which no sentence of English has.
"""

import ast
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import wraparc
from wraparc.files.drive_keys import LOAD_CASE, PULLEY
from wraparc.motion.keys import MOTION
from wraparc.schema.kinds import Kind
from wraparc.schema.tables import Entry, Table
from wraparc.train.keys import TRAIN_FILE

SOURCE = Path(wraparc.__file__).parent
#: Words of a key: with an underscore, or a table and its key.
KEY = re.compile(r"(?<![\w{])[a-z]+(?:_[a-z]+)+\b|\b[a-z]+(?:_[a-z]+)*\.[a-z]+(?:_[a-z]+)*\b")


def keys_of(kind: Any, seen: set[int]) -> Iterator[str]:
    """Yield every key that a table and the tables within it read."""
    if id(kind) in seen:
        return
    seen.add(id(kind))
    if isinstance(kind, Entry):
        yield kind.key
        yield from keys_of(kind.kind, seen)
    elif isinstance(kind, list | tuple):
        for one in kind:
            yield from keys_of(one, seen)
    elif isinstance(kind, dict):
        for one in kind.values():
            yield from keys_of(one, seen)
    elif isinstance(kind, Table):
        yield from keys_of(kind.entries, seen)
    elif isinstance(kind, Kind):
        yield from keys_of(vars(kind), seen)


KEYS = set(keys_of([TRAIN_FILE, LOAD_CASE, PULLEY, MOTION], set()))


def actions_of(path: Path) -> Iterator[str]:
    """Yield the texts of a module that tell someone to do something."""
    for node in ast.walk(ast.parse(path.read_text("utf-8"))):
        text = node.value if isinstance(node, ast.Constant) else None
        if isinstance(text, str) and re.match(r"(Check|Set|Give|Write|Use|Try|Lower|Raise) ", text):
            yield text.split("\n")[0]


FILES = sorted([*(SOURCE / "checks").glob("*.py"), *(SOURCE / "actions").glob("*.py")])


@pytest.mark.parametrize("path", FILES, ids=[path.name for path in FILES])
def test_what_an_action_names_is_a_key(path: Path) -> None:
    assert {"gear_ratio", "take_up", "inertia", "friction"} <= KEYS
    named = {key for text in actions_of(path) for key in KEY.findall(text)}
    assert {key for key in named if not set(key.split(".")) <= KEYS} == set()
