"""Every answer of every shipped example is what it was, through every door.

Expected: pinned, as recorded before the rooms were moved; regenerate with
``PYTHONPATH=tests python -m golden.record``, which refuses to change a number unless told to.
What a new feature adds to an answer is no failure; it is held from when it is recorded.

On a machine like the one that recorded (`golden.record.machine`: processor, system library,
versions of Python, NumPy, SciPy, Numba) every number has the same bits. Elsewhere the last bits of
exp and log, of fused multiplications and of linear algebra differ; there numbers agree within
`ELSEWHERE`, and the last digit of a number in a text may turn.
"""

from collections.abc import Iterator
from functools import cache

import pytest

from golden.answers import DOORS, TRAINS
from golden.compare import Difference, Kind, differences
from golden.record import DATA, MACHINE, golden, machine, record
from wraparc.arc import Distributed
from wraparc.train import compiled as train

#: Largest relative differences on another kind of machine, some ten times what one changed last bit
#: of belt width or sample area moved: 1e-11 on a pulley, 1e-8 where speeds of a train are found by
#: iterating. Fits stop at a tolerance of their own.
ELSEWHERE, TRAIN, FIT = 1e-10, 1e-6, 1e-6
_FITS = ("cli-calibrate", "cli-fit", "web-shear-tests")
_SHOWN = 30


@pytest.fixture(scope="module", autouse=True)
def each_arc_is_solved_once() -> Iterator[None]:
    """Many doors ask for the same arcs of the same examples, and an arc has one answer."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Distributed, "solve", cache(Distributed.solve))
        yield


def elsewhere(door: str, name: str) -> float:
    """Return the tolerance of an answer on another kind of machine."""
    if door in _FITS:
        return FIT
    return TRAIN if door == "web-trains" or any(train in name for train in TRAINS) else ELSEWHERE


@pytest.mark.parametrize("door", DOORS)
def test_answers_are_what_they_were(door: str, monkeypatch: pytest.MonkeyPatch) -> None:
    # trains march interpreted in the library, and compiled, to the same numbers, elsewhere
    monkeypatch.setitem(train._ready, "compiled", door != "library")
    old = golden(door)
    recorded = old.pop(MACHINE)
    here = machine()
    exactly, new = here == recorded, record(door)
    found: list[Difference] = []
    for name in old.keys() | new.keys():
        tolerance = 0.0 if exactly else elsewhere(door, name)
        one, other = ({name: side[name]} if name in side else {} for side in (old, new))
        found += differences(one, other, tolerance)
    found.sort(key=lambda d: (d.kind is Kind.ADDED, d.place))
    if any(d.kind is not Kind.ADDED for d in found):
        how = "bit for bit" if exactly else f"to rounding (another kind of machine: {here})"
        lines = "\n".join(f"  {door}: {difference}" for difference in found[:_SHOWN])
        more = f"\n  and {len(found) - _SHOWN} more" if len(found) > _SHOWN else ""
        again = f"PYTHONPATH=tests python -m golden.record {door}"
        pytest.fail(f"{len(found)} differences, {how}:\n{lines}{more}\nIf meant: {again}")


def test_every_door_has_its_golden_file() -> None:
    assert {file.stem for file in DATA.glob("*.json")} == set(DOORS)


@pytest.mark.parametrize(
    ("old", "new", "tolerance", "kinds"),
    [
        ({"a": 1.0}, {"a": 1.0000000000000002}, 0.0, ["number"]),
        ({"a": 1.0}, {"a": 1.0000000000000002}, 1e-12, []),
        ({"a": 1.0}, {"a": 1.00000000001}, 1e-12, ["number"]),
        ({"a": 0.0}, {"a": -0.0}, 0.0, ["number"]),
        ({"a": 1.0}, {"a": "inf"}, 1e-12, ["number"]),
        ({"a": 1.0}, {"a": None}, 1e-12, ["number"]),
        ({"a": True}, {"a": False}, 1e-12, ["number"]),
        ({"a": 1.0}, {"b": 1.0}, 0.0, ["missing", "added"]),
        ({"a": [1.0, 2.0]}, {"a": [1.0]}, 0.0, ["missing"]),
        ({"a": [1.0, 1e-9]}, {"a": [1.0, 1.0005e-9]}, 1e-12, []),  # of the largest of the row
        ({"a": ["1.20 mm"]}, {"a": ["3 %", "1.20 mm"]}, 0.0, ["added"]),
        ({"digest": "a"}, {"digest": "b"}, 0.0, ["text"]),
        ({"level": "OK"}, {"level": "FAILS"}, 1e-12, ["text"]),
        ({"a": ["1.20 mm"]}, {"a": ["1.20 m"]}, 0.0, ["text"]),
        ({"a": ["1.20 mm"]}, {"a": ["1.21 mm"]}, 1e-12, []),  # the last digit shown may turn
        ({"a": ["1.20 mm"]}, {"a": ["1.22 mm"]}, 1e-12, ["text"]),
        ({"a": ["1.20 mm"]}, {"a": ["1.21 mm"]}, 0.0, ["text"]),
    ],
)
def test_differences_are_seen(
    old: dict[str, object], new: dict[str, object], tolerance: float, kinds: list[str]
) -> None:
    assert [d.kind for d in differences(old, new, tolerance)] == kinds


def test_a_difference_says_where_it_is() -> None:
    old, new = {"head-drive": {"arcs": [{"slip": 1.0}]}}, {"head-drive": {"arcs": [{"slip": 2.0}]}}
    (found,) = differences(old, new)
    assert found.kind == Kind.NUMBER
    assert str(found) == "head-drive.arcs[0].slip: number was 1.0, is 2.0"
