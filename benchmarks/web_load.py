"""Eight people at sliders: solves a second and latency of the server, against a plain solve.

    python benchmarks/web_load.py [--clients 8] [--seconds 10] [--workers N]

Every client asks ``/api/v1/solve/fast`` again and again over a connection that stays open, each
time with another exit tension. Client and server share the processors, as they do on a desk.
"""

import argparse
import http.client
import json
import os
import statistics
import sys
import tempfile
import threading
import time
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))

from web.calculators import API, TOKEN, Process, document
from wraparc.arc import Distributed, WrapArc
from wraparc.files import drive_from_document


def plain() -> float:
    """Processor time of one solve without a server [s]: what the ratios are taken to."""
    drive = drive_from_document(document())
    arc = WrapArc.of(drive, drive.pulleys[0], drive.load_cases[0])
    solver = Distributed(points=120, capacities=False)
    times = []
    for _ in range(30):
        begin = time.process_time()
        solver.solve(arc)
        times.append(time.process_time() - begin)
    return statistics.median(times)


def asks(port: int, number: int, until: float, taken: list[float]) -> None:
    """Ask until a moment; note how long each answer took."""
    connection = http.client.HTTPConnection("127.0.0.1", port)
    body: dict[str, Any] = {"document": document(), "points": 120}
    count = 0
    while time.perf_counter() < until:
        count += 1
        body["document"]["pulley"][0]["exit_tension"] = f"{50 + number + 0.01 * (count % 997)} kN"
        begin = time.perf_counter()
        headers = {"content-type": "application/json", "authorization": f"Bearer {TOKEN}"}
        connection.request("POST", f"{API}/solve/fast", json.dumps(body), headers)
        answer = connection.getresponse()
        answer.read()
        taken.append(time.perf_counter() - begin)
        assert answer.status == 200, answer.status
    connection.close()


def load(port: int, clients: int, seconds: float) -> list[float]:
    """Let clients ask for a while; return how long every answer took [s], sorted."""
    taken: list[list[float]] = [[] for _ in range(clients)]
    until = time.perf_counter() + seconds
    threads = [
        threading.Thread(target=asks, args=(port, n, until, taken[n])) for n in range(clients)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    return sorted(t for one in taken for t in one)


def cpu_of(group: int) -> float:
    """Processor time of every process of a group [s]."""
    ticks = 0
    for path in Path("/proc").iterdir():
        if path.name.isdecimal():
            try:
                fields = (path / "stat").read_text().rpartition(")")[2].split()
            except OSError:
                continue
            if int(fields[2]) == group:
                ticks += int(fields[11]) + int(fields[12])
    return ticks / os.sysconf("SC_CLK_TCK")


def main() -> None:
    """Measure."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--clients", type=int, default=8)
    parser.add_argument("--seconds", type=float, default=10.0)
    parser.add_argument("--workers", type=int, default=os.cpu_count() or 1)
    told = parser.parse_args()
    alone = plain()
    print(f"one solve without a server: {1e3 * alone:.2f} ms CPU, interpreted")
    with tempfile.TemporaryDirectory() as folder:
        place = ("--database", f"{folder}/designs.sqlite")
        server = Process(*place, "--workers", str(told.workers))
        try:
            for clients in (1, told.clients):
                load(server.port, clients, 1.0)
                before = cpu_of(server.process.pid)
                taken = load(server.port, clients, told.seconds)
                each = (cpu_of(server.process.pid) - before) / len(taken)
                median, p95 = (taken[int(len(taken) * q)] for q in (0.5, 0.95))
                rate = len(taken) / told.seconds
                print(
                    f"{clients} clients: {rate:.0f} solves/s, median {1e3 * median:.1f} ms, "
                    f"p95 {1e3 * p95:.1f} ms; the server took {1e3 * each:.2f} ms CPU an answer, "
                    f"{each / alone:.2f} of a plain solve"
                )
        finally:
            server.kill()


if __name__ == "__main__":
    main()
