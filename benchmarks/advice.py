"""Advice followed on random drives: python benchmarks/advice.py [drives].

Draws drives, conveyors and trains that fail in many ways, and takes all shipped examples. Every way
that is offered is put over the file as ``--set`` does and solved again, the first one until nothing
is offered any more. Prints those that do not do what they say, after which a check fails that
passed, and that lead in a circle; how they end; and what they take. Then the choice of choose, the
least tension of what-if and a start in time. The gate runs the same with few
(tests/actions/test_followed.py, tests/judgement/test_advised.py).
"""

from __future__ import annotations

import sys
import time
import tomllib
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

sys.path[0] = str(Path(__file__).parents[1] / "tests")  # its `arc`, not the benchmark of it

EXAMPLES = Path(__file__).parents[1] / "examples"


def shipped() -> Iterator[tuple[str, dict[str, Any]]]:
    """Yield every example that describes a drive."""
    for path in sorted(EXAMPLES.rglob("*.toml")):
        document = tomllib.loads(path.read_text("utf-8"))
        if "pulley" in document and "format" in document:
            yield path.name, document


def follow_all(count: int) -> int:
    """Follow the actions of so many random drives and of all examples; return how many fail."""
    from actions.draws import failing
    from actions.follow import Followed, follow, solved_document
    from wraparc.actions import find_action
    from wraparc.checks import judge
    from wraparc.units import in_units

    ends, wrong, ways, slow = Counter[str](), 0, 0, list[float]()
    drawn = ((f"drive {number}", d) for number, d in enumerate(failing(count)))
    for name, document in (*shipped(), *drawn):
        result = solved_document(document)
        if judge(result).level == "OK":
            ends["OK as it is"] += 1
            continue
        begin = time.process_time()
        action = find_action(result)
        slow.append(time.process_time() - begin)
        told: Followed = follow(document)
        ends[told.end] += 1
        wrong, ways = wrong + len(told.wrong), ways + told.ways
        for text in told.wrong:
            print(f"{name}: {text}", flush=True)
        words = len(action.text.split()) if action else 0  # a number with its unit is one
        if words > 20:
            print(f"{name}: {words} words: {in_units(action.text) if action else ''}", flush=True)
            wrong += 1
    slow.sort()
    for end, number in ends.most_common():
        print(f"{number:5} {end}")
    if slow:
        half, most = slow[len(slow) // 2], slow[-1]
        print(f"{ways} ways followed; an action takes {half:.2f} s, {most:.2f} s at most")
    print(f"{wrong} do not hold")
    return wrong


def main() -> None:
    from checks.test_least_tension import random_drives
    from judgement import test_advised as advised
    from wraparc import Drive

    count = int(sys.argv[1]) if len(sys.argv) > 1 else 300
    wrong = follow_all(count)
    with TemporaryDirectory() as folder:
        doors: dict[str, Callable[[Drive, int], None]] = {
            "what-if": lambda drive, _: advised.followed_what_if(drive),
            "choose": lambda drive, _: advised.followed_choice(drive, Path(folder)),
            "run": lambda _, number: advised.followed_run(number),
        }
        for number, drive in enumerate(random_drives(count, seed=11)):
            for door, followed in doors.items():
                try:
                    followed(drive, number)
                except AssertionError as error:
                    wrong += 1
                    print(f"drive {number}, {door}: {error}", flush=True)
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
