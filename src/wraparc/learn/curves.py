"""The creep of a pulley by pull, slack tension and friction, tabled once and read often."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike

from wraparc.arc import WrapArc
from wraparc.arrays import Array, Integers
from wraparc.batch import solve_batch
from wraparc.drive import Drive, Lagging

#: Where a belt counts as sliding through [-], the largest ratio that is tabled, and what keeps
#: the logarithm of none finite.
SLIPS, _TOP, _LEAST = 0.05, 0.30, 1e-5
#: ln of the friction factor, Te over the tension behind the pulley, its tensions over the range.
FRICTION = np.linspace(math.log(0.20), math.log(3.0), 38)
_PULL = np.concatenate([[0.01, 0.03], np.geomspace(0.06, 3.2, 46)])
_TENSIONS = 6
#: Steps of ln belt modulus, peak slip and shear for slopes.
STEPS: Mapping[str, float] = {"belt_modulus": 0.10, "peak_slip": 0.10, "lagging_shear": 0.15}


@dataclass(frozen=True, eq=False)
class CreepTable:
    """ln(g + 1e-5) of a pulley, g = entry creep ratio, and its slopes.

    Attributes
    ----------
    arc
        The pulley as described.
    ln_tension
        ln of the tension behind the pulley [N].
    values
        Of g and, in the order of `STEPS`, its slopes, each over (tension, pull, friction).
    """

    arc: WrapArc
    ln_tension: Array
    values: Array

    def ratio(
        self, pull: Array, behind: Array, ln_friction: Array, nuisance: Mapping[str, float]
    ) -> Array:
        """Return the entry creep ratio g [-].

        Parameters
        ----------
        pull, behind
            Te, and the tension behind the pulley [N].
        ln_friction
            ln of the factor on the friction law.
        nuisance
            Changes of the logarithms of `STEPS`.
        """
        pull, behind, ln_friction = np.broadcast_arrays(pull, behind, ln_friction)
        shape = pull.shape
        axes = (
            (np.log(behind).ravel(), self.ln_tension),
            (np.log(np.maximum(pull / behind, _PULL[0])).ravel(), np.log(_PULL)),
            (ln_friction.ravel(), FRICTION),
        )
        places = [_place(x, knots) for x, knots in axes]
        shifts = np.array([1.0, *(nuisance.get(name, 0.0) for name in STEPS)])
        # slopes shift the corner values of a linear interpolation as they shift the result
        table = np.tensordot(shifts, self.values, axes=1)
        _, ny, nz = table.shape
        flat, total = table.ravel(), np.zeros(pull.size)
        for i in (0, 1):
            for j in (0, 1):
                for k in (0, 1):
                    index = ((places[0][0] + i) * ny + places[1][0] + j) * nz + places[2][0] + k
                    weight = (
                        _part(places[0][1], i) * _part(places[1][1], j) * _part(places[2][1], k)
                    )
                    total += weight * flat[index]
        return np.asarray(np.minimum(np.exp(total), _TOP) - _LEAST).reshape(shape)

    def friction_at_slip(self, pull: float, behind: float, nuisance: Mapping[str, float]) -> float:
        """Return ln of the friction factor at which the belt slides through, nan if none does."""
        ln_f = np.linspace(FRICTION[0], FRICTION[-1], 400)
        g = self.ratio(np.full(400, pull), np.full(400, behind), ln_f, nuisance)
        if g[0] < SLIPS:
            return math.nan
        return float(np.interp(-SLIPS, -np.minimum.accumulate(g), ln_f))


def _place(x: Array, knots: Array) -> tuple[Integers, Array]:
    """Return the interval of each number, and how far in it, held at the ends."""
    x = np.clip(x, knots[0], knots[-1])
    k = np.clip(np.searchsorted(knots, x, side="right") - 1, 0, len(knots) - 2)
    return k, (x - knots[k]) / (knots[k + 1] - knots[k])


def _part(share: Array, end: int) -> Array:
    return share if end else 1.0 - share


@lru_cache(maxsize=16)
def creep_table(drive: Drive, pulley: str, low: float, high: float) -> CreepTable:
    """Return the creep of a pulley of a drive, its tension behind from `low` to `high` [N]."""
    on = drive.pulley(pulley)
    arc = WrapArc.of(drive, on, drive.load_case())
    lagging = on.lagging_in(drive.load_case().condition)
    tensions = np.geomspace(low, high, _TENSIONS)
    base = _solve(arc, drive, lagging, tensions, {})
    values = [base]
    for name, step in STEPS.items():
        up, down = (_solve(arc, drive, lagging, tensions, {name: s}) for s in (step, -step))
        values.append((up - down) / (2.0 * step))
    return CreepTable(arc, np.log(tensions), np.array(values))


def _solve(
    arc: WrapArc, drive: Drive, lagging: Lagging, tensions: Array, change: Mapping[str, float]
) -> Array:
    """Return ln(g + 1e-5) over tensions, pulls and frictions, some inputs changed."""
    slip = math.exp(change.get("peak_slip", 0.0))
    shear = math.exp(change.get("lagging_shear", 0.0))
    laggings = [
        replace(
            lagging, name=f"{k}", law=lagging.law.scaled(math.exp(f), slip), fit=None,
            shear_modulus=lagging.shear_modulus / shear, uncertainty={},
        )
        for k, f in enumerate(FRICTION.tolist())
    ]  # fmt: skip
    behind, share = map(np.ravel, np.meshgrid(tensions, _PULL, indexing="ij"))
    count, each = len(behind), len(FRICTION)
    table: dict[str, ArrayLike] = {
        "entry_tension": np.tile(behind * (1.0 + share), each),
        "exit_tension": np.tile(behind, each),
        "diameter": arc.diameter,
        "wrap_angle": arc.wrap_angle,
        "belt_width": arc.width,
        "belt_modulus": drive.belt.modulus * math.exp(change.get("belt_modulus", 0.0)),
        "overrun": math.nan if arc.overrun is None else arc.overrun,
        "recovery": float(arc.recovery),
        "pitch_offset": arc.offset,
        "cover_compliance": arc.cover_compliance,
        "centrifugal_force": arc.centrifugal,
        "lagging": np.repeat(np.arange(each), count),
    }
    found = solve_batch(table, laggings, capacities=False, threads=1)
    ratio = np.where(np.asarray(found.solved), np.asarray(found["entry_creep_ratio"]), _TOP)
    ratio = np.clip(np.nan_to_num(ratio, nan=_TOP), 0.0, _TOP)
    by_friction = np.log(ratio + _LEAST).reshape(each, _TENSIONS, len(_PULL))
    return np.ascontiguousarray(np.moveaxis(by_friction, 0, -1))
