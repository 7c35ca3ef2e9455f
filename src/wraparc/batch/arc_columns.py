"""Many arcs at once: columns in, columns out; the one place where selection asks the solver."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields

import numpy as np
from numpy.typing import NDArray

from wraparc.arc import WrapArc
from wraparc.batch import Setting, solve_arcs
from wraparc.batch.arcs import Arcs, arcs_of_table
from wraparc.drive import Lagging

Array = NDArray[np.float64]
Integers = NDArray[np.int64]

#: what is asked of every arc; breakaways have nan but for capacities
ANSWERS = (
    "exit_creep",
    "peak_shear_stress",
    "power_loss",
    "creep_limit_margin",
    "tested_slip_margin",
    "gross_slip_margin",
    "least_exit_tension",
    "largest_effective_tension",
)
_ALWAYS = ANSWERS[3:]


@dataclass(frozen=True, eq=False, kw_only=True)
class ArcColumns:
    """Arcs by column, each of shape (n,).

    Attributes
    ----------
    lagging
        Place in the list of laggings.
    entry_tension, exit_tension
        T1 and T2 [N].
    diameter, wrap_angle
        D over the lagging [m] and phi [rad].
    thickness
        h of the lagging [m].
    belt_width, belt_modulus
        B [m] and M [N/m].
    creep_limit
        Creep that is accepted [m].
    belt_speed
        v [m/s], nan if unknown.
    overrun
        x_c [m], nan for the formula.
    recovery
        1 where the lagging recovers along the arc, else 0.
    """

    lagging: Integers
    entry_tension: Array
    exit_tension: Array
    diameter: Array
    wrap_angle: Array
    thickness: Array
    belt_width: Array
    belt_modulus: Array
    creep_limit: Array
    belt_speed: Array
    overrun: Array
    recovery: Array

    def __len__(self) -> int:
        return len(self.lagging)

    def rows(self, which: Integers) -> ArcColumns:
        """Return some of the arcs."""
        return ArcColumns(**{f.name: getattr(self, f.name)[which] for f in fields(self)})

    def table(self, laggings: Sequence[Lagging]) -> Arcs:
        """Return the arcs as a batch takes them."""
        names = [f.name for f in fields(self) if f.name != "thickness"]
        columns = {name: getattr(self, name) for name in names}
        return arcs_of_table({**columns, "lagging_thickness": self.thickness}, laggings)

    def arc(self, i: int, laggings: Sequence[Lagging]) -> WrapArc:
        """Return one of the arcs."""
        lagging = laggings[int(self.lagging[i])]
        speed, overrun = float(self.belt_speed[i]), float(self.overrun[i])
        return WrapArc(
            law=lagging.law,
            entry_tension=float(self.entry_tension[i]),
            exit_tension=float(self.exit_tension[i]),
            diameter=float(self.diameter[i]),
            wrap_angle=float(self.wrap_angle[i]),
            width=float(self.belt_width[i]),
            axial_stiffness=float(self.belt_modulus[i] * self.belt_width[i]),
            thickness=float(self.thickness[i]),
            shear_modulus=lagging.shear_modulus,
            compression_modulus=lagging.compression_modulus,
            overrun=None if np.isnan(overrun) else overrun,
            recovery=bool(self.recovery[i]),
            creep_limit=float(self.creep_limit[i]),
            belt_speed=None if np.isnan(speed) else speed,
            wear_coefficient=lagging.wear_coefficient,
        )


def solve_columns(
    arcs: ArcColumns, laggings: Sequence[Lagging], *, capacities: bool, precise: bool = False
) -> Mapping[str, Array]:
    """Solve arcs by the batch.

    Parameters
    ----------
    arcs
        The arcs.
    laggings
        What their `lagging` points to.
    capacities
        Whether capacities and margins are wanted; breakaways get them always.
    precise
        Whether at the accuracy of one arc instead of the batch's own (1e-4).

    Returns
    -------
    ``solved`` (1 or 0) and the columns of `ANSWERS`, shape (n,) each, SI.
    """
    setting = Setting.PRECISE if precise else Setting.ENGINEERING
    table = arcs.table(laggings)
    batch = solve_arcs(table, setting=setting, capacities=capacities)
    answers = {name: np.array(batch[name]) for name in ANSWERS}
    lost = np.flatnonzero(batch.breakaway)
    if not capacities and len(lost):
        again = solve_arcs(table.rows(lost), setting=setting)
        for name in _ALWAYS:
            answers[name][lost] = again[name]
    return {"solved": batch.solved.astype(float), **answers}
