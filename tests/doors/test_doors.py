"""Random drives say the same in every door: levels, checks, places, numbers, texts, exit codes.

Expected is what the library says of the same file; thousands are asked by benchmarks/doors.py.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from doors import net
from once import solved_once

SEED, DRIVES, TOGETHER = 5, 60, 10


@pytest.mark.parametrize("begin", range(0, DRIVES, TOGETHER))
def test_every_door_says_the_same(begin: int, tmp_path: Path) -> None:
    with solved_once():
        found = net.cast(SEED, range(begin, begin + TOGETHER), tmp_path, one_of=net.IN_A_TEST)
    assert not found.found, "\n".join(net.differences_told(found))
    assert {name for name, count in found.asked.items() if count} >= {"solve", "rows", "page"}
