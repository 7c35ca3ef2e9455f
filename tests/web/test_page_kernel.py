"""The solver of the page is the solver of Python: made from it, and with its numbers."""

import json
import subprocess
import sys
from collections import Counter
from dataclasses import dataclass, replace
from enum import StrEnum
from functools import cached_property
from itertools import pairwise
from math import exp, log
from pathlib import Path
from types import FunctionType
from typing import Any, NamedTuple, cast

import pytest

import page_kernel
import page_watch
from javascript import whole
from javascript.names import Refused
from javascript.translate import translate, translated
from web.kernel_cases import apart, arcs, case_of, in_node, in_python


@pytest.mark.parametrize("file", page_kernel.MADE, ids=lambda file: file.name)
def test_the_file_is_what_its_source_gives(file: Path) -> None:
    assert page_kernel.MADE[file]() == file.read_text("utf-8"), "make kernel"


def test_what_is_saved_is_made_anew_and_what_is_made_is_not(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(page_watch, "ROOT", tmp_path)
    names = ["pages/drive.js", "solver.py", "built/main.js", "notes.txt"]
    for name in names:
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text("")
    before = page_watch.times(tmp_path)
    assert {path.relative_to(tmp_path).as_posix() for path in before} == set(names[:2])
    assert not page_kernel.MADE.keys() & page_watch.times().keys()
    assert page_watch.changed(before, dict(before)) == set()
    page, solver = (tmp_path / name for name in names[:2])
    assert page_watch.changed(before, {page: before[page] + 1}) == {page, solver}  # one has gone

    ran = list[Any]()

    def run(command: list[str], **_: object) -> Any:
        ran.append(Path(command[-1]).name)
        return subprocess.CompletedProcess(command, 1 if len(ran) == 3 else 0)

    monkeypatch.setattr(subprocess, "run", run)
    started = [page_watch.made({page}), page_watch.made({page, solver}), page_watch.made({solver})]
    assert ran == ["page_bundle.mjs", "page_kernel.py", "page_kernel.py"]
    assert started == [False, True, False]  # what does not translate leaves the server as it is


@pytest.mark.parametrize(("each", "capacities"), [(2, False), (1, True)])
def test_random_drives_as_in_python(each: int, capacities: bool) -> None:
    # expected: the source itself, interpreted; 2,000 drives by benchmarks/page_kernel.py. Newton's
    # method ends where its steps are rounding: of a pulley that hardly pulls, 1e-11 of the pull
    drives = list(arcs(each, seed=7))
    there = in_node([case_of(arc, capacities) for _, arc in drives])
    missed: dict[tuple[str, str], float] = {}
    for (name, arc), found in zip(drives, there, strict=True):
        misses = apart(in_python(arc, capacities), found)
        missed |= {(name, what): miss for what, miss in misses.items() if not miss <= 1e-10}
    assert missed == {}
    outcomes = {found["outcome"] for found in there}
    assert outcomes == {0, 1}  # solved ones and breakaways are among them


class Pair(NamedTuple):
    low: float
    high: float


def every_other(x: Any) -> Any:
    return x[::2]


def set_from_the_end(x: Any) -> None:
    x[-1] = 0.0


def argument_that_is_none(x: float) -> float:
    return default(y=x)  # type: ignore[call-arg]


def field_left_out(x: float) -> Pair:
    return Pair(high=x)  # type: ignore[call-arg]


def two_loops(x: Any) -> Any:
    return [z for y in x for z in y]


def set_of_numbers(x: Any) -> Any:
    return {y for y in x}  # noqa: C416


def lists_added(x: Any) -> Any:
    return [*x, 1.0] + [2.0]  # noqa: RUF005


def no_such_method(x: Any) -> Any:
    return x.flies()


def empty_list_as_condition() -> int:
    if []:
        return 1
    return 0


def number_in_a_text(x: float) -> str:
    return f"about {x:>9}"


def other_package(x: Any) -> Any:
    return pytest.approx(x)


def loop_with_else(x: Any) -> Any:
    for y in x:
        if y:
            break
    else:
        return 0
    return 1


def default(x: float = 1.0) -> float:
    return x


def other_operator(x: int) -> int:
    return x << 1


REFUSED: tuple[Any, ...] = (
    every_other, set_from_the_end, argument_that_is_none, field_left_out, two_loops,
    set_of_numbers, lists_added, no_such_method, empty_list_as_condition, number_in_a_text,
    other_package, loop_with_else, other_operator,
)  # fmt: skip


@pytest.mark.parametrize("function", REFUSED, ids=lambda f: f.__name__)
def test_what_is_not_translated_is_named_by_its_place(function: FunctionType) -> None:
    with pytest.raises(Refused) as refused:
        translate([function], package=__name__.partition(".")[0])
    file, line, _ = str(refused.value).split(":", 2)
    first = function.__code__.co_firstlineno
    assert file == __file__
    assert first <= int(line) <= first + 6


def first_only(text: str) -> str:
    return text.replace(", ", " ", 1)


def head_and_rest(text: str) -> list[str]:
    return text.split(":", 1)


def called_from(name: str, text: str) -> str:
    ways = {"head": first_head, "same": first_head}
    return ways[name](text)


def first_head(text: str) -> str:
    return text.partition(":")[0]


def test_a_function_out_of_a_table_is_called_and_not_the_table() -> None:
    module = whole.Module(__name__.partition(".")[0], {})
    module.export("f", called_from)
    assert "$at(ways, name)(text)" in module.text()


@pytest.mark.parametrize("function", [first_only, head_and_rest], ids=lambda f: f.__name__)
def test_an_argument_that_javascript_would_drop_is_refused(function: FunctionType) -> None:
    module = whole.Module(__name__.partition(".")[0], {})
    module.export("f", function)
    with pytest.raises(Refused, match="more arguments"):
        module.text()


def new(x: float, y: float) -> Pair:
    low, high = min(x, y), max(x, y)
    low, high = high, low
    for i in range(3, -1, -1):
        if i % 3 == 2 or not low < high:
            continue
        low += exp(-high) // 1
    return Pair(high=log(2.0), low=low + high)


@dataclass(frozen=True)
class Key:
    name: str
    ends: tuple[float, float]


KEYS = (Key("width", (0.1, 5.0)), Key("speed", (0.0, 20.0)), Key("modulus", (0.1, 5.0)))


def key(place: int) -> str:
    return KEYS[place].name + str(KEYS[place].ends)


def test_a_row_that_comes_to_a_table_changes_its_own_lines(monkeypatch: pytest.MonkeyPatch) -> None:
    def lines() -> list[str]:
        module = whole.Module(__name__.partition(".")[0], {})
        module.export("key", key)
        return module.text().splitlines()

    before = lines()
    monkeypatch.setattr(sys.modules[__name__], "KEYS", (Key("mass", (0.3, 7.0)), *KEYS))
    after = lines()
    # the row, its ends, the table
    assert len(after) == len(before) + 2
    assert len([*Counter(after) - Counter(before)]) == 3


def test_what_a_translation_reads_like() -> None:
    # written by hand: what each construct of the function above means in JavaScript
    found = translate([cast(FunctionType, new)], package=__name__.partition(".")[0])
    told = found[found.index("export function") :].replace(f"{__name__.rpartition('.')[2]}__", "")
    assert told.splitlines() == [
        "export function new(x, y) {",
        "let i;",
        "let low = min(x, y);",
        "let high = max(x, y);",
        "[low, high] = [high, low];",
        "for (let each1 = 3, end1 = (-1); each1 > end1; each1 += (-1)) {",
        "i = each1;",
        "if (((modulo(i, 3) === 2) || !((low < high)))) {",
        "continue;",
        "}",
        "low += Math.floor(Math.exp((-high)) / 1);",
        "}",
        "return new Pair((low + high), Math.log(2.0));",
        "}",
    ]


@dataclass(frozen=True)
class Body:
    mass: float
    name: str = "body"

    @property
    def weight(self) -> float:
        return 9.81 * self.mass

    def heavier(self, by: float) -> "Body":
        return replace(self, mass=self.mass + by)


@dataclass(frozen=True)
class Sphere(Body):
    radius: float = 1.0

    @property
    def weight(self) -> float:
        return super().weight - 10.0

    @cached_property
    def volume(self) -> float:
        return self.radius**3


class Count:
    def __init__(self, start: int = 0) -> None:
        self.now = start

    def next_one(self, by: int = 1) -> int:
        self.now += by
        return self.now


class Outcome(StrEnum):
    FINE = "All is well."
    LOST = "Nothing is."


def objects(x: float) -> Any:
    bodies = [Body(x), Sphere(2.0 * x, radius=3.0), Body(name="other", mass=0.5)]
    count = Count(start=4)
    said = f"{bodies[-1].name} of {' and '.join(b.name for b in bodies[:2])}"
    outcome = Outcome.FINE if count.next_one() == 5 else Outcome.LOST
    sphere = Sphere(1.0, "ball", 2.0)
    return [said, outcome, [b.heavier(1.0).weight for b in bodies], count.now, sphere.volume]


def sequences(x: float) -> Any:
    values = [3.0, -1.0, x, *(2.0 * y for y in [1.0, 2.0])]

    def above(least: float) -> list[float]:
        most = 100.0
        return [v for v in values if least < v < most]

    pairs = [(a, b) for a, b in pairwise(sorted(values))]
    far = sorted(enumerate(values), key=lambda pair: -pair[1])
    first = next((v for v in values if v > 1e9), -7.0)
    rest = 0.0
    while True:
        rest += 1.0
        if rest > 2.5:
            break
    return [
        above(0.0), pairs, [[i, v] for i, v in far], first, sum(values), max(values), min(values),
        any(v < 0.0 for v in values), all(v < 0.0 for v in values), [0.0] * 3, list(range(2, 5)),
        [a * b for a, b in zip(values[1:], values[:-1], strict=True)], rest, wanted(2.0, scale=3.0),
    ]  # fmt: skip


def wanted(x: float, shift: float = 1.0, scale: float = 1.0) -> float:
    return scale * x + shift


@pytest.mark.parametrize("function", [objects, sequences], ids=lambda f: f.__name__)
def test_what_is_translated_answers_as_in_python(function: FunctionType) -> None:
    # expected: the function itself
    text = translate([function], package=__name__.partition(".")[0])
    name = f"{__name__.rpartition('.')[2]}__{function.__name__}"
    script = f"{text}\nconsole.log(JSON.stringify({name}(1.5)));"
    done = subprocess.run(
        ["node", "--input-type=module", "-e", script],
        capture_output=True, text=True, encoding="utf-8", check=True,
    )  # fmt: skip
    assert json.loads(done.stdout) == json.loads(json.dumps(function(1.5)))


def test_what_another_module_has_is_taken_from_there() -> None:
    package = __name__.partition(".")[0]
    there = translated([cast(FunctionType, wanted)], package)
    there.text()
    here = translated([cast(FunctionType, sequences)], package, elsewhere=there.exports)
    name = f"{__name__.rpartition('.')[2]}__wanted"
    assert f"function {name}" not in here.text()
    assert here.taken == {name}
