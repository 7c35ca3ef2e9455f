"""Memory of the server while eight clients work: solve, save, list and open.

    python benchmarks/web_memory.py [--clients 8] [--minutes 5] [--workers N]

Every client solves with another exit tension each time, every tenth time wholly, saves a design,
lists what is saved and opens one. Printed is the memory of all processes of the server together,
every half minute, what processes share counted once (Pss of Linux). The first minute is left out
of the growth: what is loaded once is loaded there.
"""

import argparse
import http.client
import json
import os
import sys
import tempfile
import threading
import time
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))

from web.calculators import API, TOKEN, Process, document


def works(port: int, number: int, until: float, counts: list[int]) -> None:
    """Work as a client until a moment; count the requests."""
    connection = http.client.HTTPConnection("127.0.0.1", port)
    headers = {"content-type": "application/json", "authorization": f"Bearer {TOKEN}"}

    def ask(path: str, body: Any = None) -> Any:
        method, data = ("GET", None) if body is None else ("POST", json.dumps(body))
        connection.request(method, f"{API}/{path}", data, headers)
        answer = connection.getresponse()
        content = answer.read()
        assert answer.status in (200, 201), (path, answer.status, content[:500])
        counts[number] += 1
        return json.loads(content)

    drive, turn = document(), 0
    while time.monotonic() < until:
        turn += 1
        drive["pulley"][0]["exit_tension"] = f"{50 + number + 0.001 * turn:.3f} kN"
        ask("solve/fast", {"document": drive, "points": 120})
        if turn % 10 == 0:
            ask("solve", {"document": drive})
            made = ask("designs", {"name": f"{number} {turn}", "document": drive})
            ask("designs?limit=50")
            ask(f"designs/{made['id']}/versions/1")
    connection.close()


def memory_of(group: int) -> float:
    """Memory of every process of a group [MB], what they share counted once."""
    total = 0
    for path in Path("/proc").iterdir():
        if path.name.isdecimal():
            try:
                fields = (path / "stat").read_text().rpartition(")")[2].split()
                if int(fields[2]) == group:
                    lines = (path / "smaps_rollup").read_text().splitlines()
                    total += sum(int(line.split()[1]) for line in lines if line.startswith("Pss:"))
            except OSError:
                continue
    return total / 1024


def main() -> None:
    """Measure."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--clients", type=int, default=8)
    parser.add_argument("--minutes", type=float, default=5.0)
    parser.add_argument("--workers", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--compiling", type=float, default=180.0, help="wait so long at most [s]")
    told = parser.parse_args()
    counts, found = [0] * told.clients, list[tuple[float, float]]()
    with tempfile.TemporaryDirectory() as folder:
        place = ("--database", f"{folder}/designs.sqlite")
        server = Process(*place, "--workers", str(told.workers))
        try:
            end = time.monotonic() + told.compiling
            while not server.ask(f"{API}/about").json()["compiled"] and time.monotonic() < end:
                time.sleep(0.5)
            begin = time.monotonic()
            until = begin + 60.0 * told.minutes
            threads = [
                threading.Thread(target=works, args=(server.port, n, until, counts))
                for n in range(told.clients)
            ]
            for thread in threads:
                thread.start()
            while time.monotonic() < until:
                time.sleep(min(30.0, max(0.0, until - time.monotonic())))
                found.append((time.monotonic() - begin, memory_of(server.process.pid)))
                print(f"{found[-1][0]:4.0f} s  {found[-1][1]:6.1f} MB  {sum(counts)} requests")
            for thread in threads:
                thread.join()
        finally:
            server.kill()
    later = [memory for at, memory in found if at > 59.0]
    growth = later[-1] - later[0]
    print(f"after the first minute it grew by {growth:.1f} MB, {100 * growth / later[0]:.1f} %")


if __name__ == "__main__":
    main()
