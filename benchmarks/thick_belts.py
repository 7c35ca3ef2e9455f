"""Belts with thickness, covers and mass: 300 random drives against an integration of their own.

``PYTHONPATH=tests python benchmarks/thick_belts.py`` tells the largest differences by law; the gate
has a small set of them, tests/arc/test_thick_belt.py.
"""

from arc.test_thick_belt import SMOOTH, misses, solved

COUNT = 300


def main() -> None:
    """Print the largest relative differences of creep, slip and entry creep ratio."""
    for name in SMOOTH:
        found = [misses(result) for result in solved(name, COUNT // len(SMOOTH), 300)]
        worst = ", ".join(f"{key} {max(f[key] for f in found):.1e}" for key in found[0])
        print(f"{name}: {len(found)} drives, {worst}")


if __name__ == "__main__":
    main()
