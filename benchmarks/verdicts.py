"""Judgement of random drives: python benchmarks/verdicts.py [drives].

Prints the drives that end otherwise in columns than alone, how all of them ended, those that a door
(JSON, calculator, note, Excel) tells otherwise, and those whose least or largest tension, solved
anew, does not keep its checks or does so beyond it. The gate runs the same with few (tests/checks).
"""

from __future__ import annotations

import sys
from collections import Counter
from pathlib import Path
from tempfile import TemporaryDirectory

sys.path[0] = str(Path(__file__).parents[1] / "tests")  # its `arc`, not the benchmark of it


def main() -> None:
    from checks.test_doors import test_every_door_tells_the_same as every_door
    from checks.test_least_tension import both_ways, random_drives
    from checks.test_of_rows import of_rows, one_by_one, random_pairs

    count = int(sys.argv[1]) if len(sys.argv) > 1 else 300
    ends: Counter[tuple[str, str]] = Counter()
    unlike = 0
    for number, drive in enumerate(random_pairs(count)):
        many, one = of_rows(drive), one_by_one(drive)
        ends[one] += 1
        if many != one:
            unlike += 1
            print(f"drive {number}: {many} in columns, {one} alone", flush=True)
    for (level, name), of in sorted(ends.items()):
        print(f"{level:12} {name:20} {of}")
    print(f"{unlike} of {count} unlike")
    unlike = 0
    with TemporaryDirectory() as folder:
        for number in range(min(count, 300)):
            try:
                every_door(number, Path(folder))
            except AssertionError as error:
                unlike += 1
                print(f"drive {number} in its doors: {error}", flush=True)
    print(f"{unlike} of {min(count, 300)} told otherwise by a door")
    wrong = 0
    for number, drive in enumerate(random_drives(count)):
        try:
            both_ways(drive)
        except AssertionError as error:
            wrong += 1
            print(f"drive {number}, solved anew: {error}", flush=True)
    print(f"{wrong} of {count} wrong when solved anew")
    sys.exit(1 if unlike or wrong else 0)


if __name__ == "__main__":
    main()
