"""What a hostile neighbour of the server may try, and what it costs everybody else.

    python benchmarks/attacks.py

Requests that are wrong in as many places as the bounds allow, from one client, while another asks
for a solve: processor time of the refusal, and the longest wait of the other. Listeners beside the
server and in its place are tried in a browser by ``tests/web/test_stranger.py``. Ends with 1 where
a refusal takes longer than `MOST` or the other waits longer than `WAIT` (on a quiet machine).
"""

from __future__ import annotations

import random
import sys
import threading
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))

from web.calculators import API, Process, document, serving

MOST, WAIT = 1.0, 2.0  # [s]
LETTERS = "abcdefghijklmnop_"


def word(draw: random.Random, length: int) -> str:
    """Return a word that is no key."""
    return "".join(draw.choice(LETTERS) for _ in range(length))


def unknown_keys(draw: random.Random) -> dict[str, Any]:
    """Return a drive with 5,000 keys that nothing has."""
    drive = document()
    drive["belt"] |= {word(draw, 180): 1 for _ in range(5_000)}
    return drive


def unknown_in_cases(draw: random.Random) -> dict[str, Any]:
    """Return a drive of 200 load cases with 90 keys each that nothing has."""
    drive = document()
    keys = {word(draw, 180): 1 for _ in range(90)}
    drive["load_case"] = [{"name": f"case {i}", **keys} for i in range(200)]
    return drive


def no_choices(draw: random.Random) -> dict[str, Any]:
    """Return a drive of 1,000 load cases of kinds that there are not."""
    drive = document()
    drive["load_case"] = [{"name": f"case {i}", "kind": word(draw, 190)} for i in range(1_000)]
    return drive


def no_laggings(draw: random.Random) -> dict[str, Any]:
    """Return a drive of 100 pulleys with laggings that nobody has."""
    drive = document()
    pulley = drive["pulley"][0]
    drive["pulley"] = [pulley | {"name": f"p{i}", "lagging": word(draw, 190)} for i in range(100)]
    return drive


ATTACKS: tuple[Callable[[random.Random], dict[str, Any]], ...] = (
    unknown_keys, unknown_in_cases, no_choices, no_laggings,
)  # fmt: skip


def attack(server: Process, drive: dict[str, Any]) -> tuple[int, float, float]:
    """Send a drive eight times at once; return status, mean time and the longest wait beside."""
    taken, statuses, waits = list[float](), set[int](), list[float]()

    def send() -> None:
        begin = time.perf_counter()
        statuses.add(server.ask(f"{API}/solve/fast", {"document": drive}).status)
        taken.append(time.perf_counter() - begin)

    senders = [threading.Thread(target=send) for _ in range(8)]
    for sender in senders:
        sender.start()
    while any(sender.is_alive() for sender in senders):
        begin = time.perf_counter()
        assert server.ask(f"{API}/solve/fast", {"document": document()}).status == 200
        waits.append(time.perf_counter() - begin)
    (status,) = statuses
    return status, sum(taken) / len(taken), max(waits, default=0.0)


def main() -> int:
    """Print a line an attack."""
    draw, bad = random.Random(1), 0  # noqa: S311
    with serving("--no-open", "--workers", "2", "--database", "sqlite://") as server:
        for _ in range(20):  # warm
            server.ask(f"{API}/solve/fast", {"document": document()})
        for make in ATTACKS:
            status, mean, wait = attack(server, make(draw))
            bad += mean > 8 * MOST or wait > WAIT
            print(
                f"{make.__name__:20s} {status}  mean of 8 {mean:6.2f} s  longest wait {wait:5.2f} s"
            )
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
