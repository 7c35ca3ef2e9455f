"""The solver of the page is the solver of Python: made from it, and with its numbers."""

from math import exp, log
from types import FunctionType
from typing import Any, NamedTuple, cast

import pytest

import page_kernel
from javascript.names import Refused
from javascript.translate import translate
from web.kernel_cases import apart, arcs, case_of, in_node, in_python


def test_the_file_is_what_its_source_gives() -> None:
    assert page_kernel.module() == page_kernel.FILE.read_text("utf-8"), "make kernel"


@pytest.mark.parametrize(("each", "capacities"), [(5, False), (1, True)])
def test_random_drives_as_in_python(each: int, capacities: bool) -> None:
    # expected: the kernel itself, interpreted; 2,000 drives by benchmarks/page_kernel.py
    drives = list(arcs(each, seed=7))
    there = in_node([case_of(arc, capacities) for _, arc in drives])
    missed: dict[tuple[str, str], float] = {}
    for (name, arc), found in zip(drives, there, strict=True):
        misses = apart(in_python(arc, capacities), found)
        missed |= {(name, what): miss for what, miss in misses.items() if not miss <= 1e-12}
    assert missed == {}
    outcomes = {found["outcome"] for found in there}
    assert outcomes == {0, 1}  # solved ones and breakaways are among them


class Pair(NamedTuple):
    low: float
    high: float


def slices(x: Any) -> Any:
    return x[1:]


def from_the_end(x: Any) -> Any:
    return x[-1]


def named_arguments(x: float) -> float:
    return default(x=x)


def field_left_out(x: float) -> Pair:
    return Pair(high=x)  # type: ignore[call-arg]


def comprehension(x: Any) -> Any:
    return [y for y in x]  # noqa: C416


def empty_list_as_condition() -> int:
    if []:
        return 1
    return 0


def text(x: float) -> str:
    return f"{x}"


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
    slices, from_the_end, named_arguments, field_left_out, comprehension, empty_list_as_condition,
    text, other_package, loop_with_else, default, other_operator,
)  # fmt: skip


@pytest.mark.parametrize("function", REFUSED, ids=lambda f: f.__name__)
def test_what_is_not_translated_is_named_by_its_place(function: FunctionType) -> None:
    with pytest.raises(Refused) as refused:
        translate([function], package=__name__.partition(".")[0])
    file, line, _ = str(refused.value).split(":", 2)
    first = function.__code__.co_firstlineno
    assert file == __file__
    assert first <= int(line) <= first + 6


def new(x: float, y: float) -> Pair:
    low, high = min(x, y), max(x, y)
    low, high = high, low
    for i in range(3, -1, -1):
        if i % 3 == 2 or not low < high:
            continue
        low += exp(-high) // 1
    return Pair(high=log(2.0), low=low + high)


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
