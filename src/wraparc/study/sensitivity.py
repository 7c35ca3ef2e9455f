"""Which input matters: each alone (tornado), and all together (Sobol indices)."""

from __future__ import annotations

import math
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from statistics import NormalDist

import numpy as np

from wraparc.alike import falling
from wraparc.arrays import Array
from wraparc.batch import Setting
from wraparc.errors import input_error
from wraparc.study.parameter_study import Study
from wraparc.study.parquet import batches, read_data
from wraparc.study.plan import Drawn, DrawnField
from wraparc.study.share import CONFIDENCE

#: by load case and condition, then by result
Local = Mapping[tuple[str, str], Mapping[str, Sequence["Swing"]]]
Global = Mapping[tuple[str, str], Mapping[str, "Indices"]]

#: Part of a distribution that its plausible range holds: from 5 % to 95 %.
RANGE = (0.05, 0.95)
STEP = 0.01
#: Largest part of the draws that may lack a result; they are left out.
MOST_LOST = 0.01


@dataclass(frozen=True)
class Swing:
    """What a field alone does to a result, all others at their medians.

    Attributes
    ----------
    field
        The field.
    median, low, high
        Its median and its plausible range, `RANGE` [SI].
    base
        The result with everything at its median [SI].
    at_low, at_high
        The result at the ends of the range [SI]; nan where there is none (breakaway).
    per_percent
        Change of the result for 1 % more of the field, by central difference [SI].
    """

    field: str
    median: float
    low: float
    high: float
    base: float
    at_low: float
    at_high: float
    per_percent: float

    @property
    def width(self) -> float:
        """Change over the plausible range [SI]."""
        return abs(self.at_high - self.at_low)


def local_sensitivity(study: Study) -> Local:
    """Swings of every field that is drawn, the widest first.

    Laws drawn from a fit have no single field to move and are left to the Sobol indices.

    Returns
    -------
    By load case and condition, then by result.
    """
    fields = [axis for axis in study.plan.drawn if isinstance(axis, DrawnField)]
    middle = np.full((1, study.plan.dimensions), 0.5)
    median = {name: float(v[0]) for name, v in study.plan.draw(middle).items()}
    columns = {name: [value] for name, value in median.items()}
    ends = {}
    for axis in fields:
        x = median[axis.field]
        ends[axis.field] = tuple(axis.distribution.quantile(np.array(RANGE)).tolist())
        for value in (x * (1.0 - STEP), x * (1.0 + STEP), *ends[axis.field]):
            for name, column in columns.items():
                column.append(value if name == axis.field else median[name])
    values = {name: np.array(column) for name, column in columns.items()}
    size = 1 + 4 * len(fields)
    # by differences of a per cent, in which the misses of a setting for large samples would show
    solved = replace(study, setting=Setting.PRECISE).solve_values(values, size)
    count = len(study.cases)
    found: dict[tuple[str, str], dict[str, tuple[Swing, ...]]] = {}
    for place, (load, condition) in enumerate(study.cases):
        of_case = found.setdefault((load, condition.name if condition else ""), {})
        for name in study.outputs:
            y = solved[name].reshape(size, count)[:, place]
            swings = [
                _swing(axis, median[axis.field], ends[axis.field], y[0], y[1 + 4 * k : 5 + 4 * k])
                for k, axis in enumerate(fields)
            ]
            of_case[name] = tuple(falling(swings, _width))
    return found


def _swing(
    axis: DrawnField, median: float, ends: tuple[float, ...], base: float, y: Array
) -> Swing:
    less, more, low, high = (float(v) for v in y)
    return Swing(
        field=axis.field,
        median=median,
        low=ends[0],
        high=ends[1],
        base=float(base),
        at_low=low,
        at_high=high,
        per_percent=0.5 * (more - less) if median else math.nan,
    )


def _width(swing: Swing) -> float:
    return math.inf if math.isnan(swing.width) else swing.width


@dataclass(frozen=True)
class Index:
    """Part of the variance of a result that an input makes [-].

    Attributes
    ----------
    name
        The field, or the lagging whose law is drawn from its fit.
    first, total
        First-order index, of the input alone; total index, with all it does together with others.
    first_interval, total_interval
        Their intervals at `CONFIDENCE`, as for independent draws.
    """

    name: str
    first: float
    total: float
    first_interval: tuple[float, float]
    total_interval: tuple[float, float]


@dataclass(frozen=True)
class Indices:
    """Sobol indices of a result in a case.

    Attributes
    ----------
    inputs
        The indices, the largest total one first; none if too many draws lack the result.
    samples, lost
        Draws, and those of them left out because the result is missing in one of their designs.
    deviation
        Standard deviation of the result [SI].
    """

    inputs: tuple[Index, ...]
    samples: int
    lost: int
    deviation: float


def sobol_indices(y: Array, names: tuple[str, ...]) -> Indices:
    """First-order and total indices from the results of a Saltelli plan.

    S_i = mean(f_B (f_ABi - f_A))/V, T_i = mean((f_A - f_ABi)^2)/(2 V), with the mean of all f_A and
    f_B taken off first and their variance V. The interval of such a ratio of means follows from the
    scatter of (term - index (f_A^2 + f_B^2)/2)/V over the draws (delta method).

    Parameters
    ----------
    y
        Results in the order of the plan, shape (samples (inputs + 2),).
    names
        The inputs.

    References
    ----------
    A. Saltelli and others, Comput. Phys. Commun. 181 (2010) 259, table 2, (b) and (f).
    """
    blocks = y.reshape(len(names) + 2, -1)
    whole = np.all(np.isfinite(blocks), axis=0)
    samples, kept = blocks.shape[1], blocks[:, whole]
    lost = samples - kept.shape[1]
    deviation = float(np.std(kept[:2])) if kept.size else math.nan
    if lost > MOST_LOST * samples or not deviation > 0.0:
        return Indices((), samples, lost, deviation)
    f = (kept - kept[:2].mean()) / deviation
    made = []
    for i, name in enumerate(names):
        alone, alone_interval = _mean_ratio(f[1] * (f[2 + i] - f[0]), f)
        both, both_interval = _mean_ratio(0.5 * (f[0] - f[2 + i]) ** 2, f)
        made.append(Index(name, alone, both, alone_interval, both_interval))
    return Indices(tuple(falling(made, lambda x: x.total)), samples, lost, deviation)


def _mean_ratio(term: Array, f: Array) -> tuple[float, tuple[float, float]]:
    """Mean of a term over the variance 1 of f, and its interval."""
    index = float(term.mean())
    scatter = float(np.std(term - 0.5 * index * (f[0] ** 2 + f[1] ** 2)))
    half = NormalDist().inv_cdf(0.5 + 0.5 * CONFIDENCE) * scatter / math.sqrt(len(term))
    return index, (index - half, index + half)


def global_sensitivity(
    path: str | os.PathLike[str], study: Study, outputs: tuple[str, ...]
) -> Global:
    """Sobol indices of results, by load case and condition, then by result.

    Raises
    ------
    InputError
        If the file holds no results of a Saltelli plan.
    """
    data = read_data(path)
    if data["plan"] != "saltelli":
        message = "the results are not those of a sensitivity study"
        raise input_error(value=os.fspath(path), message=message)
    names = tuple(_name(axis) for axis in study.plan.drawn)
    columns = _columns(path, outputs)
    count = len(study.cases)
    found: dict[tuple[str, str], dict[str, Indices]] = {}
    for place, (load, condition) in enumerate(study.cases):
        of_case = found.setdefault((load, condition.name if condition else ""), {})
        for name in outputs:
            y = columns[name].reshape(-1, count)[:, place]
            of_case[name] = sobol_indices(y, names)
    return found


def sensitivities(
    path: str | os.PathLike[str], study: Study, outputs: tuple[str, ...]
) -> tuple[Local | None, Global | None]:
    """Local and global sensitivity of results of a study; None each if none is asked for."""
    if not outputs:
        return None, None
    return local_sensitivity(study), global_sensitivity(path, study, outputs)


def _columns(path: str | os.PathLike[str], outputs: tuple[str, ...]) -> Mapping[str, Array]:
    parts = list(batches(path, outputs))
    return {name: np.concatenate([part[name] for part in parts]) for name in outputs}


def _name(axis: Drawn) -> str:
    return str(getattr(axis, "field", "")) or next(iter(axis.columns))
