"""What a search asks of its arcs: the one place where it calls the solver."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from wraparc.arrays import Array
from wraparc.batch import Setting, solve_arcs
from wraparc.batch.arcs import Arcs

#: what is asked of every arc; breakaways have nan but for capacities
ANSWERS = (
    "exit_creep",
    "peak_shear_stress",
    "power_loss",
    "frictional_energy",
    "creep_limit_margin",
    "tested_slip_margin",
    "gross_slip_margin",
    "least_exit_tension",
    "largest_effective_tension",
)
_OF_CAPACITY = ANSWERS[4:]


def solve_columns(arcs: Arcs, *, capacities: bool, precise: bool = False) -> Mapping[str, Array]:
    """Solve arcs by the batch.

    Parameters
    ----------
    arcs
        The arcs.
    capacities
        Whether capacities and margins are wanted; breakaways get them always.
    precise
        Whether at the accuracy of one arc instead of the batch's own (1e-4).

    Returns
    -------
    ``solved`` (1 or 0) and the columns of `ANSWERS`, shape (n,) each, SI.
    """
    setting = Setting.PRECISE if precise else Setting.ENGINEERING
    batch = solve_arcs(arcs, setting=setting, capacities=capacities)
    answers = {name: np.array(batch[name]) for name in ANSWERS}
    lost = np.flatnonzero(batch.breakaway)
    if not capacities and len(lost):
        again = solve_arcs(arcs.rows(lost), setting=setting)
        for name in _OF_CAPACITY:
            answers[name][lost] = again[name]
    return {"solved": batch.solved.astype(float), **answers}
