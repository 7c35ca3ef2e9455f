"""Arcs under scaled friction laws, each by factors of its own, without a law for each.

With mu'(x, p) = f mu(x/s, p) the equations of an arc are those of the unscaled law for another
one: creep, slip and overrun over s, wrap angle times f, compliance of the belt over f s, shear
compliance of the lagging times f/s, shear stress over f. Exact.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

from wraparc.arrays import Array, Integers
from wraparc.batch import row
from wraparc.batch.arcs import Arcs
from wraparc.batch.result import BatchResult
from wraparc.batch.setting import Setting
from wraparc.batch.solve import solve_arcs

#: numbers that a kernel reads and that change: (power of f, power of s)
GIVEN_POWERS = {
    "wrap_angle": (1, 0),
    "compliance": (-1, -1),
    "shear": (1, -1),
    "overrun_constant": (0, -1),
    "overrun_coefficient": (0, -1),
    "creep_limit": (0, -1),
    "slip_max": (0, -1),
}
#: numbers that a kernel finds and that change back
FOUND_POWERS = {
    row.EXIT_CREEP: (0, 1),
    row.EXIT_SLIP: (0, 1),
    row.EXIT_STRESS: (1, 0),
    row.ENTRY_STRESS: (1, 0),
    row.WORK: (1, 1),
    row.CREEP_RATIO: (1, 1),
    row.STUCK_LENGTH: (-1, 0),
    row.PEAK_STRESS: (1, 0),
    row.PEAK_AT: (-1, 0),
    row.ACTIVE: (-1, 0),
    row.GROSS_CREEP: (0, 1),
    row.LARGEST_SLIP: (0, 1),
    row.STEEPEST_SLIP: (1, 1),
    row.RATIO_BY_ENTRY: (1, 1),
    row.RATIO_BY_EXIT: (1, 1),
}


@dataclass(frozen=True, eq=False, kw_only=True)
class Unscaled(Arcs):
    """Arcs as the unscaled laws see them; f and s of each, shape (n,) [-]."""

    friction_factor: Array
    slip_factor: Array

    def rows(self, which: slice | Integers) -> Arcs:
        """Return some of the arcs."""
        some: dict[str, Any] = {name: v[which] for name, v in self.columns().items()}
        some["friction_factor"] = self.friction_factor[which]
        some["slip_factor"] = self.slip_factor[which]
        return replace(self, law=self.law[which], **some)

    def inputs(self) -> Array:
        """Numbers of every arc that a kernel reads."""
        given = super().inputs()
        for name, (of_f, of_s) in GIVEN_POWERS.items():
            given[:, row.INPUTS.index(name)] *= self.friction_factor**of_f * self.slip_factor**of_s
        return given


def solve_scaled(
    arcs: Arcs,
    friction_factor: Array,
    slip_factor: Array,
    *,
    setting: Setting = Setting.ENGINEERING,
    capacities: bool = True,
    parts: int | None = None,
    threads: int | None = 1,
    progress: Callable[[int, int], object] | None = None,
) -> BatchResult:
    """Solve arcs, the friction law of each scaled.

    Parameters
    ----------
    arcs
        The arcs, with the unscaled laws.
    friction_factor, slip_factor
        f and s of mu'(x, p) = f mu(x/s, p), > 0, shape (n,) [-]. The tested slip of a law stays
        where it is.
    setting, capacities, parts, threads, progress
        As for `wraparc.batch.solve_arcs`.
    """
    f, s = friction_factor, slip_factor
    columns: dict[str, Any] = dict(arcs.columns())
    unscaled = Unscaled(laws=arcs.laws, law=arcs.law, friction_factor=f, slip_factor=s, **columns)
    found = solve_arcs(
        unscaled,
        setting=setting,
        capacities=capacities,
        parts=parts,
        threads=threads,
        progress=progress,
    ).found
    for place, (of_f, of_s) in FOUND_POWERS.items():
        found[:, place] *= f**of_f * s**of_s
    return BatchResult(arcs, found, setting=setting, friction_factor=f, slip_factor=s)
