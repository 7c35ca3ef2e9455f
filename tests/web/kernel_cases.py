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
from wraparc.arc.kernel.answer import (
    CAPACITIES,
    answer,
    find_capacities,
    profile_of,
    profile_size,
)
from wraparc.arc.kernel.quantities import RECORD, SOLVED, zeros
from wraparc.arc.profile import active_length, peak_stress, share_outside

STEPS, POINTS = 24, 120
#: The laws of the tests, and each as a factor on its friction and slip leaves it.
ALL_LAWS = LAWS | {f"{name}, scaled": law.scaled(0.8, 1.1) for name, law in LAWS.items()}
Data = dict[str, Any]


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
        "steps": STEPS,
        "points": POINTS,
        "parts": CAPACITIES if capacities else 0,
    }


def in_python(arc: WrapArc, capacities: bool) -> Data:
    """Return what the kernel finds, interpreted."""
    law, geometry, load = arc.law.compact(), arc.geometry(), arc.load()
    found = answer(law, geometry, load, STEPS)
    carried = find_capacities(law, geometry, load, CAPACITIES, STEPS) if capacities else ()
    if found.outcome != SOLVED:
        return {"outcome": found.outcome, "capacities": list(carried)}
    out = zeros(profile_size(law, found, POINTS))
    shot, count = profile_of(law, found, load.exit_tension, POINTS, out)
    tested = load.pressure_min, load.pressure_max, load.slip_max
    return {
        "outcome": found.outcome,
        "count": count,
        "shot": list(shot),
        "records": list(out[: RECORD * count]),
        "peak": list(peak_stress(law, found.par, shot.creep_ratio, out, count)),
        "active": active_length(out, count),
        "outside": share_outside(found.par, out, count, *tested),
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
    for name in ("shot", "peak"):
        pairs = zip(here[name], there[name], strict=True)
        found |= {f"{name} {i}": _relative(x, y) for i, (x, y) in enumerate(pairs)}
    found["active"] = _relative(here["active"], there["active"])
    one, other = here["outside"], there["outside"]  # shares of the arc
    return found | {"outside": 0.0 if one == other else abs(one - other)}


def _relative(x: float, y: float) -> float:
    if x == y or (math.isnan(x) and math.isnan(y)):
        return 0.0
    miss = abs(x - y) / max(abs(x), abs(y))
    return miss if math.isfinite(miss) else math.inf
