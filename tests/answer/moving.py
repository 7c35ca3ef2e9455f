"""Results with what rounding leaves: numbers moved in their last bits."""

import dataclasses
from dataclasses import replace
from typing import Any

import numpy as np

#: What results hold of the solution, not of the input.
SOLVED = ("Result", "Point", "Energy", "Capacities", "Profile", "Fields", "Extremes", "Peak",
          "History", "Linear")  # fmt: skip


def moved(value: Any, rng: np.random.Generator, size: float = 1.0) -> Any:
    """Return a result with every number a few units in the last place off; inputs as they are."""
    if isinstance(value, float):
        if value == 0.0:
            return size * float(rng.choice([-1e-15, -0.0, 1e-15]))
        return value * (1.0 + float(rng.integers(-4, 5)) * 2.0**-52)
    if isinstance(value, np.ndarray) and value.dtype == float and value.any():
        size = float(np.abs(value[np.isfinite(value)]).max(initial=0.0))
        return np.reshape([moved(v, rng, size) for v in value.ravel().tolist()], value.shape)
    if isinstance(value, dict):
        return {name: moved(v, rng) for name, v in value.items()}
    if isinstance(value, tuple):
        kind = type(value)
        items = [moved(v, rng) for v in value]
        return kind(*items) if hasattr(value, "_fields") else kind(items)
    if dataclasses.is_dataclass(value) and type(value).__name__.endswith(SOLVED):
        fields = [f.name for f in dataclasses.fields(value) if f.init]
        return replace(value, **{n: moved(getattr(value, n), rng) for n in fields})  # type: ignore[type-var]
    return value
