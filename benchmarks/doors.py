"""Random drives asked through every door: python benchmarks/doors.py [drives] [--seed 1].

Each drive is solved by the library, and asked of every command, of columns, of the server and of
the page (tests/doors): verdict, numbers and exit code must be the same. Prints each difference with
the drive file that shows it, how the drives end, how often each door answered, and at the end how
many drives differ. The files are left in build/doors; `--from 120 --doors trim,run` asks anew.
`trim` is asked about every tenth drive; with `--quick` slow doors are asked as seldom as in the
gate, which does the same with few.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

sys.path[0] = str(Path(__file__).parents[1] / "tests")  # its `arc`, not the benchmark of it

#: Drives that are asked about together.
TOGETHER = 50


def main() -> None:
    from doors import net
    from once import solved_once

    parser = argparse.ArgumentParser()
    parser.add_argument("drives", type=int, nargs="?", default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--from", type=int, default=0, dest="first")
    parser.add_argument("--folder", type=Path, default=Path("build/doors"))
    parser.add_argument("--doors", default="")
    parser.add_argument("--quick", action="store_true")
    asked = parser.parse_args()
    asked.folder = asked.folder.resolve()  # files name each other
    asked.folder.mkdir(parents=True, exist_ok=True)
    doors = [name for name in asked.doors.split(",") if name]
    one_of = net.IN_A_TEST if asked.quick else net.OF_MANY
    whole, last = net.Net([]), asked.first + asked.drives
    for begin in range(asked.first, last, TOGETHER):
        numbers = range(begin, min(begin + TOGETHER, last))
        with solved_once():
            some = net.cast(asked.seed, numbers, asked.folder, doors, {} if doors else one_of)
        for line in net.differences_told(some):
            print(line, flush=True)
        whole.add(some)
    print("\n".join(net.summary(whole)))
    sys.exit(1 if whole.found else 0)


if __name__ == "__main__":
    main()
