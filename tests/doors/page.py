"""Doors of the page: its own kernel and reader, and the calculator of one file, in one node."""

from __future__ import annotations

import json
import math
import subprocess
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from doors.record import Case, Record, told_of
from wraparc.errors import InputError
from wraparc.train import Train
from wraparc.web.answers.book import book
from wraparc.web.answers.form import form
from wraparc.web.page_file import packed, page_data

Data = dict[str, Any]
_SCRIPT = Path(__file__).with_name("page.mjs")


def in_node(kernel: Sequence[Data], files: Sequence[Data]) -> Data:
    asked = {"form": json.loads(form().model_dump_json()), "kernel": kernel, "files": files}
    done = subprocess.run(
        ["node", str(_SCRIPT)], input=json.dumps(asked),
        capture_output=True, text=True, encoding="utf-8", check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr[-3000:]
    found: Data = json.loads(done.stdout)
    return found


def kernel(cases: Sequence[Case], folder: Path) -> list[Record | None]:
    """What the page judges itself of a drive of one pulley."""
    some = [case for case in cases if not isinstance(driven(case), Train)]
    asked = [
        {"document": case.document, "book": json.loads(book(case.document).model_dump_json())}
        for case in some
    ]
    found = dict(zip((case.number for case in some), in_node(asked, [])["kernel"], strict=True))
    return [record(case, found.get(case.number)) for case in cases]


def file(cases: Sequence[Case], folder: Path) -> list[Record | None]:
    """What the calculator of one file answers, opened with the drive."""
    asked, numbers = [], []
    for case in cases:
        try:
            data = page_data(case.document, case.path.name, case.path.read_text("utf-8"))
        except InputError:  # no page is written
            continue
        asked.append({"document": case.document, "data": packed(json.dumps(data))})
        numbers.append(case.number)
    found = dict(zip(numbers, in_node([], asked)["files"], strict=True))
    return [record(case, found.get(case.number)) for case in cases]


def driven(case: Case) -> Any:
    return None if case.refusal else case.drive


def record(case: Case, found: Data | None) -> Record | None:
    """Return what the page says; None where it leaves the drive to the program."""
    if found is None:
        return None
    if "problems" in found:
        problems = found["problems"]
        if any(p.get("beyond") for p in problems):
            return None
        return Record(refusal=tuple(p["sentence"] for p in problems))
    verdict = {key: read(value) for key, value in found["verdict"].items()}
    spots, numbers = {}, dict[tuple[str, str, str], float]()
    for arc in found["arcs"]:
        place = arc["load_case"], arc["pulley"]
        spots[place] = arc["level"], arc["name"]
        numbers |= {(*place, name): read(value) for name, value in arc["numbers"].items()}
    numbers = told_of(numbers, case)
    return Record(verdict=verdict, spots=spots, numbers=numbers)


def read(value: Any) -> Any:
    words = {"NaN": math.nan, "Infinity": math.inf, "-Infinity": -math.inf}
    if value is None:
        return math.nan
    return words.get(value, value) if isinstance(value, str) else value
