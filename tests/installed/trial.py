"""wraparc as it is installed, tried extra by extra: ``python trial.py all``, or ``plot fit web``.

It needs nothing but the package and stands outside its folder. Each extra is made to do what its
libraries are for, once; expected numbers are those of the golden answers, which the tests hold with
the locked libraries: other versions may change the last digits, and nothing else.
"""

import base64
import csv
import io
import json
import math
import os
import re
import sys
import tempfile
import tomllib
import urllib.request
import zlib
from collections.abc import Callable
from contextlib import redirect_stderr, redirect_stdout
from functools import partial
from importlib import metadata
from pathlib import Path
from queue import Queue
from threading import Thread
from typing import Any
from zipfile import ZipFile

DRIVE, CASE = "head-drive-fabric.toml", ("--load-case", "design")
#: Its creep at exit in that load case [m].
CREEP = 7.49273e-3


def wraparc(*arguments: object) -> None:
    """Run the command line in this process; it must succeed."""
    from wraparc.cli import run

    out, err = io.StringIO(), io.StringIO()
    with redirect_stdout(out), redirect_stderr(err):
        code = run([str(argument) for argument in arguments])
    assert code == 0, f"wraparc {' '.join(map(str, arguments))}: exit code {code}; {err.getvalue()}"


def base() -> None:
    """One drive solved; numbers and tables in files."""
    from wraparc.cli.demo import lay_out

    lay_out(Path())
    wraparc("solve", DRIVE, *CASE, "--json", "a.json", "--csv", "a.csv")
    creep = json.loads(Path("a.json").read_text("utf-8"))["arcs"][0]["exit_creep"]
    assert math.isclose(creep, CREEP, rel_tol=1e-5), creep
    with open("a.csv", encoding="utf-8", newline="") as table:
        assert len(list(csv.reader(table))) > 100


def plot() -> None:
    """Pictures of every kind, letters of formulas among them."""
    wraparc("solve", DRIVE, *CASE, "--plot", "a.png")
    wraparc("lagging", "full-ceramic", "--plot", "a.svg")
    assert Path("a.png").read_bytes().startswith(b"\x89PNG")
    assert "</svg>" in Path("a.svg").read_text("utf-8")


def report() -> None:
    """The calculation note as PDF and as workbook."""
    for name, start in (("note.pdf", b"%PDF-"), ("note.xlsx", b"PK")):
        wraparc("report", DRIVE, "--case", "design", "-o", name)
        assert Path(name).read_bytes().startswith(start)
    with ZipFile("note.xlsx") as book:
        assert "xl/workbook.xml" in book.namelist()


def fit() -> None:
    """Simulated tests fitted."""
    from wraparc import load_lagging

    _rig()
    wraparc("fit", "rig/plan.toml", "-o", "fitted.toml")
    assert load_lagging("fitted.toml").fit is not None


def bayes() -> None:
    """The same, by a few draws of the posterior."""
    from wraparc import load_lagging
    from wraparc.shear_test import bayes

    bayes._STEPS, bayes._BURN = 8, 3
    _rig()
    wraparc("fit", "rig/plan.toml", "--bayes", "-o", "drawn.toml")
    assert load_lagging("drawn.toml").fit is not None


def _rig() -> None:
    """A workbook of a test machine read; tests of a known law simulated."""
    wraparc("read", "shear_tests/dry-0069kPa-1.xlsx")
    if not Path("rig").exists():
        few = ("--repeats", "1", "--points", "40", "--pressures", "69 207 690")
        wraparc("rig", "rig", *few)


def batch() -> None:
    """Two designs, to both settings; not in the gate."""
    import numpy as np

    from wraparc import Setting, load_lagging, solve_batch

    table: dict[str, Any] = {
        "entry_tension": np.array([150e3, 120e3]), "exit_tension": 60e3, "diameter": 0.8,
        "wrap_angle": math.pi, "belt_width": 1.2192, "belt_modulus": 12.96e6,
    }  # fmt: skip
    laws = load_lagging("diamond-rubber")
    found = solve_batch(table, laws, capacities=False)
    plain = solve_batch(table, laws, capacities=False, setting=Setting.PRECISE)
    assert np.allclose(found["exit_creep"], plain["exit_creep"], rtol=1e-4)


_STUDY = """
format = 1
drive = "head-drive-fabric.toml"
load_cases = ["design"]
outputs = ["exit_creep"]
[sampling]
samples = 8
method = "sobol"
seed = 1
[[axis]]
field = "pulley.head.exit_tension"
distribution = "normal"
mean = "70 kN"
standard_deviation = "1 kN"
"""


def study() -> None:
    """A sampled study into a Parquet file."""
    import pyarrow.parquet as pq

    Path("study.toml").write_text(_STUDY, "utf-8")
    wraparc("study", "study.toml", "-o", "study.parquet", "--plot", "study.svg")
    assert pq.read_table("study.parquet").num_rows == 8


def dask() -> None:
    """The same on a cluster, to the same rows."""
    import pyarrow.parquet as pq
    from distributed import LocalCluster

    settings = {"processes": False, "protocol": "tcp://", "dashboard_address": None}
    with LocalCluster(1, **settings) as cluster:
        address = cluster.scheduler_address
        wraparc("study", "study.toml", "-o", "dask.parquet", "--scheduler", address)
    assert pq.read_table("dask.parquet").equals(pq.read_table("study.parquet"))


def web() -> None:
    """The server: its page, an answer, an upload, a saved design; PostgreSQL out of reach."""
    from wraparc.cli import run
    from wraparc.web import serving
    from wraparc.web.settings import Settings

    away = ["--database", "postgresql://127.0.0.1:1/none", "--workers", "0"]
    with redirect_stderr(io.StringIO()) as told:
        assert run(["serve", "--port", "0", *away]) == 2
    assert "cannot be used: connection failed" in told.getvalue()
    started: Queue[str] = Queue()
    settings = Settings(port=0, database="sqlite:///designs.sqlite", workers=0)
    serve = partial(serving.run, settings, tell=lambda known: started.put(known.address))
    Thread(target=serve, daemon=True).start()
    _ask(started.get())
    wraparc("page", DRIVE, "-o", "page.html")
    page = Path("page.html").read_text("utf-8")
    kept = re.search(r'id="data">([^<]+)<', page)
    assert kept
    data = json.loads(zlib.decompress(base64.b85decode(kept[1].replace(",", "<"))))
    assert data["start"]["toml"] == Path(DRIVE).read_text("utf-8")


def _ask(address: str) -> None:
    def asked(path: str, body: bytes | None = None, kind: str = "application/json") -> bytes:
        headers = {"content-type": kind}
        request = urllib.request.Request(address + path[1:], body, headers)  # noqa: S310 - our own
        with urllib.request.urlopen(request) as answer:  # noqa: S310
            return bytes(answer.read())

    assert b"<html" in asked("/")
    assert b"import" in asked("/static/main.js")
    text = Path(DRIVE).read_bytes()
    arcs = json.loads(asked("/api/v1/solve", text, "application/toml"))["arcs"]
    assert any(math.isclose(a["numbers"]["exit_creep"], CREEP, rel_tol=1e-5) for a in arcs)
    session = json.loads(asked("/api/v1/tests", b""))["session"]
    part = b'--x\r\ncontent-disposition: form-data; name="files"; filename="a.csv"\r\n\r\n'
    file = part + Path("shear_tests/dry-0034kPa-1.csv").read_bytes() + b"\r\n--x--"
    form = "multipart/form-data; boundary=x"
    assert json.loads(asked(f"/api/v1/tests/{session}/files", file, form))["files"]
    design = json.dumps({"name": "a", "document": tomllib.loads(text.decode())}).encode()
    assert json.loads(asked("/api/v1/designs", design))["version"] == 1
    assert len(json.loads(asked("/api/v1/designs"))["designs"]) == 1


def notebook() -> None:
    """Numbers as a data frame."""
    from wraparc import load_drive, solve
    from wraparc.render.notebook import frame

    result = solve(load_drive(DRIVE))
    assert len(frame(result)) == len(result.arcs)
    assert "<table" in result._repr_html_()


#: What an extra brings, in the order in which they build on one another.
EXTRAS: dict[str, Callable[[], None]] = {
    "base": base, "plot": plot, "report": report, "fit": fit, "bayes": bayes,
    "batch": batch, "study": study, "dask": dask, "web": web, "notebook": notebook,
}  # fmt: skip


def main() -> None:
    """Try what is asked for in an empty folder."""
    import wraparc as package

    asked = EXTRAS if sys.argv[1:] == ["all"] else ["base", *sys.argv[1:]]
    with tempfile.TemporaryDirectory(prefix="wraparc-trial-") as folder:
        os.chdir(folder)
        for name in asked:
            EXTRAS[name]()
        os.chdir("/")
    version = metadata.version("wraparc")
    print(  # noqa: T201
        f"wraparc {version}, Python {sys.version.split()[0]}, {Path(package.__file__).parent}: "
        f"{', '.join(asked)}"
    )


if __name__ == "__main__":
    main()
