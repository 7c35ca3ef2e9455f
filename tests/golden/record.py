"""Recording the golden files: every answer of every shipped example, with the digits compared.

    PYTHONPATH=tests python -m golden.record               record what is new
    PYTHONPATH=tests python -m golden.record cli-report    through one door
    PYTHONPATH=tests python -m golden.record --numbers     numbers are meant to change, too

Texts may be said in other words and answers may be added: both are written and listed. Numbers
that change or vanish are listed and refused unless ``--numbers`` says that they are meant to; then
the log of the change tells why.
"""

import contextlib
import json
import shutil
import sys
import tempfile
from pathlib import Path
from typing import Any

from golden.answers import DOORS
from golden.compare import Kind, differences
from golden.doors import EXAMPLES
from golden.plain import plain

DATA = Path(__file__).with_name("data")
KNOWN = 1e-11  # of a number: what is kept of it


def answers_of(door: str, examples: Path = EXAMPLES) -> dict[str, Any]:
    """Return the answers of one door, with their texts."""
    with tempfile.TemporaryDirectory() as folder:
        shutil.copytree(examples, folder, dirs_exist_ok=True)
        with contextlib.chdir(folder):
            return dict(sorted(DOORS[door]().items()))


def record(door: str, examples: Path = EXAMPLES) -> dict[str, Any]:
    """Return the answers of one door, as a golden file keeps them."""
    return {name: plain(answer) for name, answer in answers_of(door, examples).items()}


def golden(door: str) -> dict[str, Any]:
    """Return what was recorded; nothing if it never was."""
    file = DATA / f"{door}.json"
    found: dict[str, Any] = json.loads(file.read_text("utf-8")) if file.exists() else {}
    return found


def known(answer: Any) -> Any:
    """Return an answer with no more digits than are compared, 1e-10, and two."""
    if isinstance(answer, dict):
        return {key: known(value) for key, value in answer.items()}
    if isinstance(answer, list):
        return [known(value) for value in answer]
    return float(f"{answer:.12g}") if isinstance(answer, float) else answer


def save(door: str, answers: dict[str, Any]) -> None:
    """Write a golden file, one line an answer."""
    lines = (
        f"{json.dumps(name)}:"
        f"{json.dumps(known(answer), allow_nan=False, separators=(',', ':'), sort_keys=True)}"
        for name, answer in answers.items()
    )
    DATA.mkdir(exist_ok=True)
    (DATA / f"{door}.json").write_text("{\n" + ",\n".join(lines) + "\n}\n", "utf-8")


def main(arguments: list[str]) -> int:
    """Record the doors named, or all."""
    meant = "--numbers" in arguments
    doors = [a for a in arguments if a != "--numbers"] or list(DOORS)
    refused = False
    for door in doors:
        old, new = golden(door), record(door)
        found = list(differences(old, known(new), KNOWN)) if old else []
        print("\n".join(f"{door}: {d}" for d in found) or f"{door}: no difference")  # noqa: T201
        changed = any(d.kind in (Kind.NUMBER, Kind.MISSING) for d in found)
        if changed and not meant:
            refused = True
            continue
        save(door, new)
    if refused:
        print("Numbers changed: nothing written there. If they are meant to, say --numbers.")  # noqa: T201
    return int(refused)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
