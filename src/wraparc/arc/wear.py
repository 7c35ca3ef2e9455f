"""Where friction wears belt and lagging along the wrap, and how long the lagging lasts.

Frictional energy is the measure of wear here: the shear stress times the slip under it. A wear
coefficient, depth per frictional energy per area, turns it into a depth; nobody publishes one for
laggings, so it is given or calibrated to a wear that was measured.
"""

from __future__ import annotations

import math

import numpy as np

from wraparc.arc.result import ArcResult
from wraparc.arrays import Array

#: Part of the thickness that may be worn off where nothing else is said [-].
WORN_SHARE = 0.5

#: Least sum over what is summed that parts are made to keep [-].
_SUM = 1e-6
#: Frictional energy of a pass of which only rounding is left [J/m2].
IDLE_ENERGY = 1e-9


def frictional_power(result: ArcResult, parts: int = 6) -> tuple[Array, Array]:
    """Mean frictional power per area in equal parts of the wrap [W/m2].

    tau v_s dx/ds R/(R + e), the shear stress times the speed of the belt on the lagging surface,
    with v_s = v/(1 - g) at the pitch radius. Summed over the parts and the area of the wrap it is
    the sliding power of `Energy`.

    Parameters
    ----------
    result
        A solved arc.
    parts
        Number of parts.

    Returns
    -------
    edges
        Positions of their ends, shape (parts + 1,) [rad].
    power
        Mean of each, shape (parts,) [W/m2]; nan without a belt speed.
    """
    arc, profile = result.arc, result.profile
    edges = np.linspace(0.0, arc.wrap_angle, parts + 1)
    g = result.entry_creep_ratio
    if arc.belt_speed is None or g >= 1.0 or len(profile) < 2:
        return edges, np.full(parts, math.nan)
    tau = profile.shear_stress
    work = np.r_[0.0, np.cumsum(0.5 * (tau[1:] + tau[:-1]) * np.diff(profile.slip))]
    at = np.interp(edges, profile.position, work)
    # the profile has points, and the solver the exact work: its parts keep its sum, unless that is
    # what rounding leaves of work in either sense, as on a pulley that idles
    whole = at[-1] - at[0]
    known = abs(whole) > _SUM * np.abs(np.diff(work)).sum()
    scale = result.energy.frictional_energy / whole if known else 1.0
    length = arc.length / parts
    share = arc.radius / (arc.radius + arc.offset)
    return edges, scale * np.diff(at) * arc.belt_speed / (1.0 - g) / length * share


def wear_life(depth: float, coefficient: float, energy: float, passes: float) -> float:
    """Hours until a depth is worn off [h]: depth / (coefficient * energy * passes per hour).

    Parameters
    ----------
    depth
        Depth that may be worn off [m].
    coefficient
        Energetic wear coefficient [m3/J].
    energy
        Frictional energy per area and pass [J/m2].
    passes
        Passes in an hour [1/h].
    """
    worn = coefficient * abs(energy) * passes
    return depth / worn if worn > 0.0 else math.inf


def coefficient_of_life(depth: float, hours: float, energy: float, passes: float) -> float:
    """Wear coefficient that a life stands for at a frictional energy [m3/J]; see `wear_life`.

    Parameters
    ----------
    depth
        Depth that is worn off [m].
    hours
        Life [h].
    energy, passes
        As for `wear_life`.
    """
    worn = hours * abs(energy) * passes
    return depth / worn if worn > 0.0 else math.inf
