"""What a thicker lagging cushions of an uneven belt, and what it costs in creep."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from wraparc.across.build import wide_arc
from wraparc.across.result import AcrossResult
from wraparc.across.solve import uneven_pulleys
from wraparc.across.solver import AcrossSolver
from wraparc.arrays import Array
from wraparc.drive import Drive


@dataclass(frozen=True, eq=False, kw_only=True)
class Cushion:
    """One pulley with laggings of several thicknesses, its unevenness the same.

    Attributes
    ----------
    thickness
        Thicknesses of the new lagging, shape (k,) [m].
    results
        The belt across its width with each.
    """

    thickness: Array
    results: tuple[AcrossResult, ...]

    @property
    def unevenness(self) -> Array:
        """Largest over mean entry tension less 1, nan where not carried, shape (k,) [-]."""
        return self._of(lambda r: r.entry_unevenness - 1.0)

    @property
    def wear_unevenness(self) -> Array:
        """Largest over mean frictional energy, nan where not carried, shape (k,) [-]."""
        return self._of(lambda r: r.energy_unevenness)

    @property
    def creep(self) -> Array:
        """Mean creep at the exit, nan where not carried, shape (k,) [m]."""
        return self._of(lambda r: float(np.mean(r.exit_creep)))

    def _of(self, value: Callable[[AcrossResult], float]) -> Array:
        return np.array([value(r) if r.status.solved else np.nan for r in self.results])


def cushion(
    drive: Drive,
    thicknesses: Sequence[float],
    pulley: str | None = None,
    load_case: str | None = None,
    *,
    strips: int | None = None,
    solver: AcrossSolver | None = None,
) -> Cushion:
    """Solve an uneven pulley with laggings of several thicknesses.

    The profiles stay as they are, and the diameter over the lagging; the compression modulus
    follows the shape of the blocks where the lagging has them, see `Lagging.with_thickness`.

    Parameters
    ----------
    drive
        The drive.
    thicknesses
        Of the new lagging [m].
    pulley, load_case
        Names; the first pulley that says what is uneven, and the running load case of the largest
        pull.
    strips, solver
        As for `solve_across`.

    Raises
    ------
    InputError
        If there is no such pulley or load case, or a lagging is thinner than what is worn off.
    """
    chosen = drive.pulley(pulley) if pulley is not None else uneven_pulleys(drive)[0]
    case = drive.load_case(load_case)
    results = []
    for thickness in thicknesses:
        lagging = chosen.lagging_in(case.condition)
        thick = replace(chosen, lagging=lagging.with_thickness(thickness), conditions=())
        wide = wide_arc(drive, thick, replace(case, condition=""), strips=strips)
        results.append((solver or AcrossSolver()).solve(wide))
    return Cushion(thickness=np.array(thicknesses, dtype=float), results=tuple(results))
