"""Studies of any size: time, bytes and memory a design, and a cluster that loses a worker.

    python benchmarks/study.py            1,000 to 1,000,000 designs on the threads of this process
    python benchmarks/study.py 10000000   other sizes
    python benchmarks/study.py few ...    only creep, slip and shear: no capacities
    python benchmarks/study.py row        processor time of a row, solving alone [us]
    python benchmarks/study.py dask       1,000,000 designs on a scheduler and two workers as
                                          processes, one killed half way, beside the local run

Every row is a process of its own; its memory is the largest resident set. Head drive under
diamond rubber, five fields drawn at random, plain Monte Carlo; all 13 results, capacities included.
"""

from __future__ import annotations

import json
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

import numpy as np

ROOT = Path(__file__).parents[1]
DASK = [sys.executable, "-c", "from dask.__main__ import main; main()"]
MILLION = 1_000_000


def axis(field: str, low: str, high: str) -> dict[str, Any]:
    return {"field": field, "distribution": "uniform", "from": low, "to": high}


FEW = ["exit_creep", "exit_slip", "peak_shear_stress"]


def study(designs: int, few: bool = False) -> Any:
    from wraparc.study.file import study_from_document

    document = {
        "format": 1,
        "drive": "head-drive.toml",
        **({"outputs": FEW} if few else {}),
        "sampling": {"method": "random", "samples": designs, "seed": 1},
        "axis": [
            axis("pulley.head.effective_tension", "50 kN", "80 kN"),
            axis("pulley.head.exit_tension", "45 kN", "80 kN"),
            axis("pulley.head.wrap_angle", "175 deg", "215 deg"),
            axis("belt.modulus", "9 MN/m", "18 MN/m"),
            {**axis("pulley.head.lagging.friction_factor", "", ""), "from": 0.8, "to": 1.15},
        ],
    }
    return study_from_document(document, folder=str(ROOT / "examples" / "studies")).study


def memory() -> float:
    """Largest resident set of this process [MB]."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024.0


def one(designs: int, few: bool) -> dict[str, float]:
    """Run a study in this process."""
    from wraparc.study.monte_carlo import summarise
    from wraparc.study.run import Run, run_study

    with tempfile.TemporaryDirectory(dir=ROOT / "build") as folder:
        path = Path(folder) / "a.parquet"
        start, used = time.perf_counter(), time.process_time()
        run_study(study(designs, few), path, Run(confirmed_rows=designs))
        took, used = time.perf_counter() - start, time.process_time() - used
        size, solving = path.stat().st_size, memory()
        again = time.perf_counter()
        summarise(path)
        told = time.perf_counter() - again
    return {
        "designs": designs, "seconds": took, "cpu": used, "bytes": size / designs,
        "memory": solving, "summary": told, "memory_with_summary": memory(),
    }  # fmt: skip


def row(n: int = 16_384) -> float:
    """Least processor time of a row, solving alone: no files, one thread [us]."""
    asked, times = study(n), []
    for _ in range(4):
        start = time.process_time()
        asked.solve(0, n)
        times.append(time.process_time() - start)
    return 1e6 * min(times) / n


def sizes(designs: list[int], few: bool) -> None:
    heads = ("designs", "s", "CPU us/design", "designs/s", "bytes/design", "MB solving", "MB all")
    print(("{:>14}" * len(heads)).format(*heads), "  summary s")
    for count in designs:
        command = [sys.executable, __file__, "one", str(count), *(["few"] if few else [])]
        r = json.loads(subprocess.run(command, check=True, capture_output=True).stdout)
        row = (r["cpu"] / count * 1e6, count / r["seconds"], r["bytes"], r["memory"])
        numbers = "".join(f"{n:14,.1f}" for n in (r["seconds"], *row, r["memory_with_summary"]))
        print(f"{count:14,d}{numbers}{r['summary']:11.1f}", flush=True)


class Cluster:
    """A scheduler and two workers as processes."""

    def __init__(self, folder: Path) -> None:
        told, quiet = folder / "scheduler.json", subprocess.DEVNULL
        command = [*DASK, "scheduler", "--host", "127.0.0.1", "--port", "0", "--no-dashboard"]
        command += ["--scheduler-file", str(told)]
        self.processes = [subprocess.Popen(command, stdout=quiet, stderr=quiet)]
        while not (told.exists() and told.read_text().endswith("}")):
            time.sleep(0.05)
        self.address = json.loads(told.read_text())["address"]
        command = [*DASK, "worker", self.address, "--no-nanny", "--nthreads", "1"]
        command += ["--no-dashboard", "--local-directory", str(folder)]
        self.processes += [subprocess.Popen(command, stdout=quiet, stderr=quiet) for _ in range(2)]

    def memory(self) -> list[float]:
        """Largest resident set of the processes that are alive [MB]."""
        found = []
        for process in self.processes:
            status = Path(f"/proc/{process.pid}/status")
            lines = status.read_text().splitlines() if status.exists() else []
            found += [float(x.split()[1]) / 1024.0 for x in lines if x.startswith("VmHWM")]
        return found

    def end(self) -> None:
        for process in self.processes:
            process.kill()
            process.wait()


def dask(designs: int = MILLION) -> None:
    import pyarrow as pa
    import pyarrow.parquet as pq

    from wraparc.study.executor import DaskCluster, require_distributed
    from wraparc.study.run import Run, run_study

    with tempfile.TemporaryDirectory(dir=ROOT / "build") as name:
        folder = Path(name)
        cluster = Cluster(folder)
        try:
            distributed = require_distributed()
            with distributed.Client(cluster.address, set_as_default=False) as client:
                client.wait_for_workers(2, timeout=120)
            killed: list[int] = []

            def tell(done: int, total: int) -> None:
                if done >= total // 2 and not killed:
                    cluster.processes[1].kill()
                    killed.append(done)

            asked = study(designs)
            start = time.perf_counter()
            run_study(
                asked,
                folder / "cluster.parquet",
                Run(executor=DaskCluster(cluster.address), confirmed_rows=designs, progress=tell),
            )
            took, used = time.perf_counter() - start, cluster.memory()
        finally:
            cluster.end()
        start = time.perf_counter()
        run_study(asked, folder / "here.parquet", Run(confirmed_rows=designs))
        here, client = time.perf_counter() - start, memory()
        one_, other = (pq.read_table(folder / f"{n}.parquet") for n in ("cluster", "here"))
        numbers = one_["design"].to_numpy()
        same = all(
            one_[c].combine_chunks().to_pylist() == other[c].combine_chunks().to_pylist()
            if pa.types.is_dictionary(one_[c].type)
            else one_[c].to_numpy().tobytes() == other[c].to_numpy().tobytes()
            for c in one_.column_names
        )
        print(f"{designs:,} designs, scheduler and two workers, one killed at {killed[0]:,}")
        print(f"  cluster {took:.1f} s, threads of this process {here:.1f} s")
        print(f"  rows {len(numbers):,}, different designs {len(np.unique(numbers)):,}")
        print(f"  every bit as in the local run: {same}")
        print(f"  memory of scheduler and remaining worker {used} MB, client {client:.0f} MB")


if __name__ == "__main__":
    (ROOT / "build").mkdir(exist_ok=True)
    arguments = sys.argv[1:]
    if arguments[:1] == ["one"]:
        print(json.dumps(one(int(arguments[1]), "few" in arguments)))
    elif arguments[:1] == ["row"]:
        print(f"{row():.1f}")
    elif arguments[:1] == ["dask"]:
        dask(*map(int, arguments[1:]))
    else:
        asked = [int(a) for a in arguments if a != "few"]
        sizes(asked or [1_000, 10_000, 100_000, MILLION], "few" in arguments)
