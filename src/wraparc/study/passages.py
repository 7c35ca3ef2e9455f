"""Passages of the belt over a pulley of a train, many at once, compiled where numba is installed.

Given to `wraparc.train.share_map`, whose own way is one passage after the other.
"""

from __future__ import annotations

from math import exp, sinh
from typing import Any

import numpy as np
from numpy.typing import NDArray

from wraparc.arc.capacity import parameters_at
from wraparc.arc.march import KICK, room
from wraparc.arc.shoot import effort_of, fire
from wraparc.study.batch.elementwise import memory
from wraparc.study.batch.native import available, compiled
from wraparc.train.member import RATIO_SCALE, SHARP, Member
from wraparc.train.passage_table import one_by_one

Array = NDArray[np.float64]


def shoot_all(
    kind: int,
    numbers: Any,
    place: Any,
    geometry: Any,
    logs: Any,
    efforts: Any,
    steps: int,
    found: Any,
) -> None:
    """Send the belt over a pulley at many ln(entry tension) and efforts; compiled only.

    The pulley is as in `Member.passage` for laws that rise from zero friction; `found` is filled
    with ln(exit over entry tension) and the exit creep, (2, n).
    """
    a, b = place[0], place[1]
    law = (
        kind,
        memory(numbers[:a], "edges"),
        memory(numbers[a:b], "coefficients"),
        memory(numbers[b:], "slips"),
    )
    none = room(0)
    g = geometry
    for i in range(len(efforts)):
        entry, side = exp(logs[i]), 1.0
        par = parameters_at(entry, (side, g[1], g[2], g[3], g[4], g[5], g[6], g[7], g[8]))
        if efforts[i] < 0.0 and par[KICK] == 0.0:
            side = -1.0
            par = parameters_at(entry, (side, g[1], g[2], g[3], g[4], g[5], g[6], g[7], g[8]))
        z = effort_of(par, RATIO_SCALE * sinh(efforts[i]))
        shot, _ = fire(law, par, z, steps, 0, none)
        found[0, i], found[1, i] = shot[0], shot[2]


def all_at_once(member: Member, logs: Array, efforts: Array) -> Array:
    """Passages of a pulley whose law rises from zero friction, see `wraparc.train.share_map`.

    Parameters
    ----------
    member
        The pulley.
    logs, efforts
        ln(entry tension) and effort of each passage, (n,).

    Returns
    -------
    ln(exit over entry tension) [-] and exit creep [m], (2, n). The same to the last bit as
    `wraparc.train.passage_table.one_by_one`, which does the work where numba is not installed.
    """
    if not available():
        return one_by_one(member, logs, efforts)
    kind, edges, c, slips = member.law
    numbers = np.array([*edges, *c, *slips], dtype=float)
    place = np.array([len(edges), len(edges) + len(c)], dtype=np.int64)
    found = np.empty((2, len(logs)))
    run = compiled(shoot_all)
    geometry = np.array(member.geometry, dtype=float)
    run(kind, numbers, place, geometry, logs, efforts, SHARP, found)
    if not np.all(np.isfinite(found)):  # more tension than numbers have
        return one_by_one(member, logs, efforts)
    return found
