"""Memory of the server while clients work: solve, save, list and open, and upload long files.

    python benchmarks/web_memory.py [--clients 8] [--uploads 3] [--minutes 5] [--workers N]

Every client solves with another exit tension each time, every tenth time wholly, saves a design,
lists what is saved and opens one. Beside them others upload shear tests, at once and again and
again: a text of the largest size allowed, and a workbook of a million rows. Printed is the memory
of all processes of the server together, every half minute, and its peak, looked at every half
second; what processes share is counted once (Pss of Linux). The first minute is left out of the
growth: what is loaded once is loaded there.

Goal: a peak below 1 GB.
"""

import argparse
import http.client
import io
import json
import os
import sys
import tempfile
import threading
import time
from collections import Counter
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))

import xlsxwriter

from web.calculators import API, TOKEN, Process, document
from wraparc.web.sessions import MOST_FILE

HEAD = ("Time [s]", "Extension [mm]", "Load [N]")


def text() -> bytes:
    """Return a machine file of the largest size that may be uploaded."""
    rows = [";".join(HEAD)]
    size = len(rows[0]) + 1
    for k in range(MOST_FILE):
        row = f"{0.001 * k:.3f};{0.0001 * k:.4f};{0.5 * k:.1f}"
        size += len(row) + 1
        if size > MOST_FILE:
            break
        rows.append(row)
    return "\n".join([*rows, ""]).encode()


def workbook(rows: int) -> bytes:
    """Return the same readings as a workbook."""
    data = io.BytesIO()
    book = xlsxwriter.Workbook(data, {"constant_memory": True})
    sheet = book.add_worksheet()
    sheet.write_row(0, 0, HEAD)
    for k in range(rows):
        sheet.write_row(k + 1, 0, (round(0.001 * k, 3), round(0.0001 * k, 4), 0.5 * k))
    book.close()
    return data.getvalue()


def uploads(port: int, files: dict[str, bytes], until: float, said: Counter[int]) -> None:
    """Upload files in turn until a moment, each to a place of its own; count the answers."""
    connection = http.client.HTTPConnection("127.0.0.1", port)
    token = {"authorization": f"Bearer {TOKEN}"}

    def ask(method: str, path: str, data: bytes | None = None, kind: str = "") -> Any:
        headers = {**token, **({"content-type": kind} if kind else {})}
        connection.request(method, f"{API}/tests{path}", data, headers)
        answer = connection.getresponse()
        content = answer.read()
        assert answer.status < 500, (path, answer.status, content[:500])
        said[answer.status] += method == "POST" and bool(path)
        return json.loads(content) if content else None

    while time.monotonic() < until:
        for name, data in files.items():
            place = f"/{ask('POST', '', b'')['session']}"
            edge = "shear-test-edge"
            head = f'--{edge}\r\ncontent-disposition: form-data; name="files"; filename="{name}"'
            body = f"{head}\r\n\r\n".encode() + data + f"\r\n--{edge}--\r\n".encode()
            ask("POST", f"{place}/files", body, f"multipart/form-data; boundary={edge}")
            ask("DELETE", place)
    connection.close()


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
    parser.add_argument("--uploads", type=int, default=3, help="clients that upload")
    parser.add_argument("--rows", type=int, default=600_000, help="of the workbook")
    parser.add_argument("--minutes", type=float, default=5.0)
    parser.add_argument("--workers", type=int, default=os.cpu_count() or 1)
    told = parser.parse_args()
    counts, found = [0] * told.clients, list[tuple[float, float]]()
    said, peak = Counter[int](), 0.0
    files = {"long.csv": text(), "long.xlsx": workbook(told.rows)}
    assert all(len(data) <= MOST_FILE for data in files.values())
    with tempfile.TemporaryDirectory() as folder:
        place = ("--database", f"{folder}/designs.sqlite")
        server = Process(*place, "--workers", str(told.workers))
        try:
            begin = time.monotonic()
            until = begin + 60.0 * told.minutes
            threads = [
                threading.Thread(target=works, args=(server.port, n, until, counts))
                for n in range(told.clients)
            ] + [
                threading.Thread(target=uploads, args=(server.port, files, until, said))
                for _ in range(told.uploads)
            ]
            for thread in threads:
                thread.start()
            while any(thread.is_alive() for thread in threads):
                time.sleep(0.5)
                at, memory = time.monotonic() - begin, memory_of(server.process.pid)
                peak = max(peak, memory)
                if at > 30.0 * (len(found) + 1):
                    found.append((at, memory))
                    print(f"{at:4.0f} s  {memory:6.1f} MB  {sum(counts)} requests")
            for thread in threads:
                thread.join()
        finally:
            server.kill()
    sizes = ", ".join(f"{name} {len(data) / 1e6:.1f} MB" for name, data in files.items())
    print(f"peak {peak:.0f} MB; uploaded {sizes}, answers {dict(said)}")
    later = [memory for at, memory in found if at > 59.0]
    growth = later[-1] - later[0]
    print(f"after the first minute it grew by {growth:.1f} MB, {100 * growth / later[0]:.1f} %")


if __name__ == "__main__":
    main()
