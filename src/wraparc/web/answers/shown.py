"""Sheets of :mod:`wraparc.present` as plain data, in both systems of units at once."""

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from wraparc.arc import ArcResult, Profile
from wraparc.present.sheet import Row, Sheet, Table, Verdict
from wraparc.units import Dimension, System, display

Data = dict[str, Any]


def both(make: Callable[[System], Any]) -> Data:
    """Return what a function gives for each system of units."""
    return {"si": make("si"), "us": make("us")}


def quantity_both(value: float, dimension: Dimension) -> Data:
    """Return a value [SI] as text in both systems."""
    return both(lambda system: display(value, dimension, system))


def verdict_data(make: Callable[[System], Verdict]) -> Data:
    """Return a verdict."""
    si, us = make("si"), make("us")
    return {
        "level": si.level.value,
        "headline": {"si": si.headline, "us": us.headline},
        "sentences": texts_data(si.sentences, us.sentences),
    }


def texts_data(si: Iterable[str], us: Iterable[str]) -> list[Data]:
    """Return sentences."""
    return [{"si": a, "us": b} for a, b in zip(si, us, strict=True)]


def table_data(key: str, si: Table, us: Table) -> Data:
    """Return a table made in both systems."""
    return {
        "key": key,
        "title": si.title,
        "heads": {"si": list(si.heads), "us": list(us.heads)},
        "note": {"si": si.note, "us": us.note},
        "rows": [_row_data(a, b) for a, b in zip(si.rows, us.rows, strict=True)],
    }


def _row_data(si: Row, us: Row) -> Data:
    return {
        "name": si.name,
        "title": si.title,
        "symbol": si.symbol,
        "values": {"si": list(si.values), "us": list(us.values)},
        "note": {"si": si.note, "us": us.note},
        "level": si.level.value if si.level else None,
    }


def tables_data(
    si: Sequence[Table | None], us: Sequence[Table | None], keys: Iterable[str] = ()
) -> list[Data]:
    """Return tables made in both systems, those that are there; keys by position."""
    names = [*keys] or [f"table{i}" for i in range(1, len(si) + 1)]
    return [
        table_data(key, a, b)
        for key, a, b in zip(names, si, us, strict=True)
        if a is not None and b is not None
    ]


def sheet_data(make: Callable[[System], Sheet]) -> Data:
    """Return a whole sheet."""
    si, us = make("si"), make("us")
    told = None
    if si.verdict is not None and us.verdict is not None:
        verdicts = {"si": si.verdict, "us": us.verdict}
        told = verdict_data(lambda system: verdicts[system])
    return {
        "title": si.title,
        "subtitle": si.subtitle,
        "verdict": told,
        "tables": tables_data(si.tables, us.tables),
        "remarks": texts_data(si.remarks, us.remarks),
        "table_sources": list(si.sources),
    }


def numbers_data(scalars: Mapping[str, float]) -> Data:
    """Return numbers by name, None where there is none or no bound."""
    return {name: value if math.isfinite(value) else None for name, value in scalars.items()}


def arrays_data(columns: Iterable[tuple[str, Any]], digits: int = 6) -> dict[str, list[Any]]:
    """Return arrays by name, rounded to significant digits for a picture."""
    return {name: rounded(column, digits) for name, column in columns}


def rounded(values: Any, digits: int = 6) -> list[Any]:
    """Return numbers of an array with so many significant digits; None for what is not finite."""
    array = np.asarray(values, float)
    if array.ndim > 1:
        return [rounded(row, digits) for row in array]
    with np.errstate(divide="ignore", invalid="ignore"):
        power = np.floor(np.log10(np.abs(array)))
    power = np.where(np.isfinite(power), power, 0.0)
    # by division and by multiplication with whole powers of ten: the shortest text comes out
    shift = np.clip(digits - 1 - power, -300, 300)
    up = 10.0 ** np.maximum(shift, 0.0)
    down = 10.0 ** np.maximum(-shift, 0.0)
    result = np.round(array * up / down) / up * down
    if np.all(np.isfinite(result)):
        return list(result.tolist())
    return [v if math.isfinite(v) else None for v in result.tolist()]


def profile_data(profile: Profile, most: int = 0) -> dict[str, list[Any]]:
    """Return a profile, of at most so many points if said, both ends included."""
    columns = profile.columns()
    if 0 < most < len(profile):
        kept = np.unique(np.linspace(0, len(profile) - 1, most).round().astype(int))
        return arrays_data((name, column[kept]) for name, column in columns)
    return arrays_data(columns)


def outside_data(result: ArcResult) -> list[list[float]]:
    """Return the stretches of the arc outside the tested range [rad]."""
    tested = result.arc.law.tested
    if tested is None:
        return []
    p, x = result.profile.wrap_pressure, np.abs(result.profile.slip)
    out = (p < tested.pressure_min) | (p > tested.pressure_max) | (x > tested.slip_max)
    edges = np.flatnonzero(np.diff(np.concatenate([[0], out.astype(int), [0]])))
    at = result.profile.position
    last = len(at) - 1
    return [
        [float(at[max(a - 1, 0)]), float(at[min(b, last)])]
        for a, b in zip(edges[::2], edges[1::2], strict=True)
    ]


def tested_data(result: ArcResult) -> Data | None:
    """Return the tested range of the law, None without one."""
    tested = result.arc.law.tested
    if tested is None:
        return None
    names = ("pressure_min", "pressure_max", "slip_max")
    return {name: getattr(tested, name) for name in names}
