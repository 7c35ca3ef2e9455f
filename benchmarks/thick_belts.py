"""Belts with thickness, covers and mass: 300 random drives against an integration of their own.

``python benchmarks/thick_belts.py`` tells the largest differences by law; the gate
has a small set of them, tests/arc/test_thick_belt.py.
"""

import sys
from pathlib import Path

sys.path[0] = str(Path(__file__).parents[1] / "tests")  # its `arc`, not the benchmark of it

COUNT = 300


def main() -> None:
    """Print the largest relative differences of creep, slip and entry creep ratio."""
    from arc.test_thick_belt import SMOOTH, misses, solved

    for name in SMOOTH:
        found = [misses(result) for result in solved(name, COUNT // len(SMOOTH), 300)]
        worst = ", ".join(f"{key} {max(f[key] for f in found):.1e}" for key in found[0])
        print(f"{name}: {len(found)} drives, {worst}")


if __name__ == "__main__":
    main()
