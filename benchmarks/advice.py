"""Advice followed on random drives: python benchmarks/advice.py [drives].

Prints the drives of which an advice, taken as it is printed and solved again, does not do what it
says: the least tension of solve and of what-if, the choice of choose, what the checks across the
width advise, and a start in time. The gate runs the same with few, by the same functions
(tests/judgement/test_advised.py).
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory

sys.path[0] = str(Path(__file__).parents[1] / "tests")  # its `arc`, not the benchmark of it


def main() -> None:
    from checks.test_least_tension import random_drives
    from judgement import test_advised as advised
    from wraparc import Drive

    count = int(sys.argv[1]) if len(sys.argv) > 1 else 300
    wrong = 0
    with TemporaryDirectory() as folder:
        doors: dict[str, Callable[[Drive, int], None]] = {
            "solve": lambda drive, _: advised.followed(drive),
            "what-if": lambda drive, _: advised.followed_what_if(drive),
            "choose": lambda drive, _: advised.followed_choice(drive, Path(folder)),
            "across": advised.followed_across,
            "run": lambda _, number: advised.followed_run(number),
        }
        for number, drive in enumerate(random_drives(count, seed=11)):
            for door, followed in doors.items():
                try:
                    followed(drive, number)
                except AssertionError as error:
                    wrong += 1
                    print(f"drive {number}, {door}: {error}", flush=True)
    print(f"{wrong} advices of {count} drives do not hold")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
