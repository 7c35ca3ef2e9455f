"""Random drives solved in Python and by the kernel of the page, and how far these are apart."""

from __future__ import annotations

import json
import math
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from arc.drives import LAWS, random_arc
from wraparc.arc import WrapArc
from wraparc.arc.answer import operating_point
from wraparc.arc.capacity import CAPACITIES, find_capacities
from wraparc.arc.profile import RECORD, Range, Read, read, records
from wraparc.arc.quantities import SOLVED

POINTS = 120
#: The laws of the tests, and each as a factor on its friction and slip leaves it.
ALL_LAWS = LAWS | {f"{name}, scaled": law.scaled(0.8, 1.1) for name, law in LAWS.items()}
Data = dict[str, Any]
LOSS = Read._fields.index("loss")


def arcs(each: int, seed: int) -> Iterator[tuple[str, WrapArc]]:
    """Yield so many random drives of every law."""
    for k, (name, law) in enumerate(ALL_LAWS.items()):
        rng = np.random.default_rng([seed, k])
        yield from ((name, random_arc(law, rng)) for _ in range(each))


def case_of(arc: WrapArc, capacities: bool) -> Data:
    """Return what the kernel is given."""
    return {
        "law": arc.law.compact()._asdict(),
        "geometry": arc.geometry()._asdict(),
        "load": arc.load()._asdict(),
        "points": POINTS,
        "parts": CAPACITIES if capacities else 0,
    }


def in_python(arc: WrapArc, capacities: bool) -> Data:
    """Return what the kernel finds, interpreted."""
    law, geometry, load = arc.law.compact(), arc.geometry(), arc.load()
    found = operating_point(law, geometry, load.entry_tension, load.exit_tension)
    carried = find_capacities(law, geometry, load, CAPACITIES) if capacities else ()
    if found.outcome != SOLVED:
        return {"outcome": found.outcome, "capacities": list(carried)}
    out, count = records(geometry, found.met, POINTS)
    tested = Range(load.pressure_min, load.pressure_max, load.slip_max)
    return {
        "outcome": found.outcome,
        "count": count,
        "read": list(read(geometry, found.met, tested)),
        "records": list(out[: RECORD * count]),
        "capacities": list(carried),
    }


def in_node(cases: list[Data], script: str = "kernel_cases.mjs") -> list[Data]:
    """Return what the kernel of the page finds."""
    done = subprocess.run(
        ["node", str(Path(__file__).with_name(script))],
        input=json.dumps(_written(cases)),
        capture_output=True, text=True, encoding="utf-8", check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    found: list[Data] = _read(json.loads(done.stdout))
    return found


def _written(value: Any) -> Any:
    """Return data with words for what JSON has no number for."""
    if isinstance(value, dict):
        return {key: _written(part) for key, part in value.items()}
    if isinstance(value, list | tuple | np.ndarray):
        return [_written(part) for part in value]
    if isinstance(value, float):
        return value if math.isfinite(value) else str(float(value))
    return value


def _read(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _read(part) for key, part in value.items()}
    if isinstance(value, list):
        return [_read(part) for part in value]
    return float(value) if value in ("nan", "inf", "-inf") else value


def apart(here: Data, there: Data) -> dict[str, float]:
    """Return how far two answers are apart, quantity by quantity, over their size [-].

    Infinite where they end otherwise. A column of the profile has the size of its largest number.
    """
    if (here["outcome"], here.get("count")) != (there["outcome"], there.get("count")):
        return {"outcome": math.inf}
    pairs = zip(here["capacities"], there["capacities"], strict=True)
    carried = {f"capacities {i}": _relative(x, y) for i, (x, y) in enumerate(pairs)}
    if here["outcome"] != SOLVED:
        return carried
    a, b = (np.reshape(x["records"], (-1, RECORD)) for x in (here, there))
    size = np.abs(a).max(axis=0)
    columns = np.abs(a - b).max(axis=0) / np.where(size > 0.0, size, 1.0)
    found = carried | {f"record {i}": float(miss) for i, miss in enumerate(columns)}
    for name, x, y in zip(Read._fields, here["read"], there["read"], strict=True):
        if name == "miss":  # rounding, of the loss
            found[name] = abs(x - y) / max(abs(here["read"][LOSS]), 1e-300)
        elif name == "outside":  # a share of the arc
            found[name] = 0.0 if x == y or (math.isnan(x) and math.isnan(y)) else abs(x - y)
        else:
            found[name] = _relative(x, y)
    return found


def _relative(x: float, y: float) -> float:
    if x == y or (math.isnan(x) and math.isnan(y)):
        return 0.0
    miss = abs(x - y) / max(abs(x), abs(y))
    return miss if math.isfinite(miss) else math.inf
