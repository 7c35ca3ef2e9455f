"""The share of each defect in the unevenness, in milliseconds, and how sure it is."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from wraparc.across.build import in_plane_stiffness, wide_arc
from wraparc.across.modes import CAUSES, ModeResponse, mode_response
from wraparc.across.wide_arc import WideArc
from wraparc.alike import falling
from wraparc.arrays import Array
from wraparc.drive import Across, Drive, LoadCase, Pulley, Transition

#: modes of the screening
MODES = 16


@dataclass(frozen=True, eq=False, kw_only=True)
class DefectShare:
    """What one defect does alone, to the first order.

    Attributes
    ----------
    name
        The defect, by its key in a drive file.
    entry_tension
        Deviation of the entry tension, shape (n,) [N/m].
    energy
        Deviation of the frictional energy, shape (n,) [J/m2].
    """

    name: str
    entry_tension: Array
    energy: Array


@dataclass(frozen=True, eq=False, kw_only=True)
class Screening:
    """Shares of the defects of a pulley, to the first order.

    Attributes
    ----------
    position
        Places across the belt [m].
    shares
        One for each defect that is there, the largest tension first.
    response
        What small deviations do, by mode.
    entry_unevenness
        Largest over mean entry tension of all together [-].
    band
        The same at the least and the largest in-plane shear stiffness that the belt may have [-];
        twice the same where it is given.
    """

    position: Array
    shares: tuple[DefectShare, ...]
    response: ModeResponse
    entry_unevenness: float
    band: tuple[float, float]


def screen(drive: Drive, pulley: Pulley, case: LoadCase) -> Screening:
    """Return the shares of the defects of a pulley and the band of their sum.

    Raises
    ------
    ConvergenceError
        If the even belt is not carried.
    """
    own = in_plane_stiffness(drive.belt)
    found = [
        _screened(drive, pulley, case, stiffness)
        for stiffness in dict.fromkeys((own.value, own.low, own.high))
    ]
    wide, response, shares = found[0]
    sums = [_unevenness(w, s) for w, _, s in found]
    return Screening(
        position=wide.position,
        shares=tuple(falling(shares, lambda s: float(np.max(np.abs(s.entry_tension))))),
        response=response,
        entry_unevenness=sums[0],
        band=(min(sums), max(sums)),
    )


def _screened(
    drive: Drive, pulley: Pulley, case: LoadCase, stiffness: float
) -> tuple[WideArc, ModeResponse, list[DefectShare]]:
    wide = wide_arc(drive, pulley, case, stiffness=stiffness)
    response = mode_response(wide, MODES)
    causes = _causes(wide, pulley.across or Across())
    return wide, response, [_share(wide, response, name, by) for name, by in causes.items()]


def _causes(wide: WideArc, across: Across) -> dict[str, dict[str, Array]]:
    """Profiles of the causes by defect."""
    y, width = wide.position, wide.arc.width
    skew = np.sin(0.5 * wide.arc.wrap_angle)
    found: dict[str, dict[str, Array]] = {}
    for name, cause, sign in (
        ("shell_profile", "radius", 1.0),
        ("worn_depth", "lagging", -1.0),
        ("build_up", "radius", 1.0),
        ("entry_profile", "entry_profile", 1.0),
    ):
        profile = getattr(across, name)
        if profile is not None:
            found[name] = {cause: sign * profile.at(y, width)}
    bend = -across.deflection * (1.0 - (2.0 * y / width) ** 2)
    for name, path in (("misalignment", across.misalignment * y), ("deflection", bend)):
        if np.any(path != 0.0):
            found[name] = dict.fromkeys(("entry_misfit", "exit_misfit"), path * skew)
    if isinstance(across.before, Transition) and wide.transition is not None:
        found["before"] = {"entry_profile": wide.transition.free_profile() @ wide.modes[1:]}
    return found


def _share(
    wide: WideArc, response: ModeResponse, name: str, profiles: dict[str, Array]
) -> DefectShare:
    c = wide.modes[1 : 1 + len(response.entry_tension)]
    tension, energy = np.zeros(len(c)), np.zeros(len(c))
    for cause, profile in profiles.items():
        amplitude, j = c @ profile, CAUSES.index(cause)
        tension += response.entry_tension[:, j] * amplitude
        energy += response.energy[:, j] * amplitude
    return DefectShare(name=name, entry_tension=tension @ c, energy=energy @ c)


def _unevenness(wide: WideArc, shares: list[DefectShare]) -> float:
    mean = wide.arc.entry_tension / wide.arc.width
    deviation = sum((s.entry_tension for s in shares), start=np.zeros(wide.strips))
    return 1.0 + float(np.max(deviation)) / mean
