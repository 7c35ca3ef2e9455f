"""A scheduler and two workers as processes of their own; one dies half way."""

import json
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from cli.running import wraparc
from study.studies import FOLDER
from study.test_study_run import columns, small
from wraparc.errors import InputError
from wraparc.study import executor
from wraparc.study.executor import DaskCluster, _check_workers, require_distributed
from wraparc.study.run import Run, parts_folder, run_study

pytestmark = pytest.mark.processes
DASK = [sys.executable, "-c", "from dask.__main__ import main; main()"]


class Cluster:
    """Processes of a cluster, and the address of its scheduler."""

    def __init__(self, folder: Path) -> None:
        told = folder / "scheduler.json"
        command = [*DASK, "scheduler", "--host", "127.0.0.1", "--port", "0", "--no-dashboard"]
        self.scheduler = subprocess.Popen(
            [*command, "--scheduler-file", str(told)],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
        )  # fmt: skip
        self.folder, self.workers = folder, list[subprocess.Popen[bytes]]()
        while not (told.exists() and told.read_text().endswith("}")):
            assert self.scheduler.poll() is None
            time.sleep(0.05)
        self.address = str(json.loads(told.read_text())["address"])

    def add_workers(self, count: int) -> None:
        """Start some and wait until they have come."""
        for _ in range(count):
            self._add_worker()
        with self.client() as client:
            client.wait_for_workers(count)

    def client(self) -> Any:
        return require_distributed().Client(self.address, set_as_default=False)

    def _add_worker(self) -> None:
        command = [*DASK, "worker", self.address, "--no-nanny", "--nthreads", "1"]
        command += ["--no-dashboard", "--local-directory", str(self.folder)]
        self.workers.append(
            subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        )

    def end(self) -> None:
        for process in (*self.workers, self.scheduler):
            process.kill()
            process.wait()


@pytest.fixture
def cluster(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Cluster]:
    made = Cluster(tmp_path_factory.mktemp("cluster"))
    try:
        yield made
    finally:
        made.end()


def test_a_worker_or_a_cluster_that_dies_loses_nothing(cluster: Cluster, tmp_path: Path) -> None:
    """All rows there, none twice, every bit as on the threads of this process."""
    with (
        cluster.client() as client,
        pytest.raises(InputError, match=r"the scheduler has no worker after 0\.2 s"),
    ):
        _check_workers(client, cluster.address, 0.2)
    cluster.add_workers(2)
    study, alive = small(), []

    def tell(done: int, total: int) -> None:
        if done >= total // 2 and cluster.workers[0].poll() is None:
            cluster.workers[0].kill()
            cluster.workers[0].wait()
            alive.append(total - done)

    path, here = tmp_path / "cluster.parquet", tmp_path / "here.parquet"
    solver = DaskCluster(cluster.address, timeout=60.0)
    run_study(study, path, Run(executor=solver, part_designs=4, progress=tell))
    assert alive, "the worker was to die in the middle of the work"
    assert alive[0] > 0
    run_study(study, here)
    assert columns(path) == columns(here)
    loses_its_scheduler(cluster, tmp_path / "lost.parquet", here)


def loses_its_scheduler(cluster: Cluster, path: Path, here: Path) -> None:
    """What is done stays, and the rest is solved without the cluster."""
    study = small()

    def tell(done: int, total: int) -> None:
        if done >= total // 4:
            cluster.scheduler.kill()

    solver = DaskCluster(cluster.address, timeout=60.0)
    with pytest.raises(InputError, match=r"the cluster was lost: .*Go on with --resume"):
        run_study(study, path, Run(executor=solver, part_designs=4, progress=tell))
    assert len(list(parts_folder(path).glob("*.parquet"))) >= 10
    run_study(study, path, Run(resume=True))
    assert columns(path) == columns(here)


def test_a_cluster_without_workers_is_not_waited_for(monkeypatch: pytest.MonkeyPatch) -> None:
    """Its scheduler lives on; none of its workers does, and no other comes."""

    class Client:
        looks = iter([{"tcp://a:1": 1}, {}, {}, {}])

        def nthreads(self) -> dict[str, int]:
            return next(self.looks)

    class Running:
        thread_condition = threading.Condition()

        def has_ready(self) -> bool:
            return False

    moments = iter([0.0, 30.0, 60.0, 91.0])
    monkeypatch.setattr(executor, "monotonic", lambda: next(moments))
    monkeypatch.setattr(executor, "_LOOK", 0.0)
    with pytest.raises(TimeoutError, match="no worker is left, and none has come in 60 s"):
        DaskCluster("tcp://a:1")._next(Client(), Running())
    told = str(executor._lost("tcp://a:1", TimeoutError("no worker is left")))
    assert told.endswith('got "tcp://a:1". Go on with --resume.')


def test_processes_of_this_computer(tmp_path: Path) -> None:
    file = Path(FOLDER) / "load-cases.toml"
    path, here = tmp_path / "a.parquet", tmp_path / "here.parquet"
    ran = wraparc("study", file, "-o", path, "--scheduler", "local:1")
    assert ran.code == 0, ran.err
    assert wraparc("study", file, "-o", here).code == 0
    assert columns(path) == columns(here)
