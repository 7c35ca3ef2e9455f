"""An arc with less misfit let stand than usual: the solver's own check of its meshes."""

from __future__ import annotations

import numpy as np

from wraparc.arc import ArcResult, WrapArc
from wraparc.arc.answer import operating_point
from wraparc.arc.collocation import MESH, between_tensions
from wraparc.arc.meet import Guess, Met, meet

FINER = MESH / 300.0  # misfit of an element that is let stand: five times as many of them


def finer(arc: WrapArc, tol: float = FINER) -> Met:
    """Operating point on finer meshes."""
    law, geometry = arc.law.compact(), arc.geometry()
    entry, leaving = arc.entry_tension, arc.exit_tension
    first = operating_point(law, geometry, entry, leaving).met
    guess = Guess(entry, leaving, first.course.creep[-1])
    near = first.course if first.rest == 0.0 else None
    return meet(law, geometry, between_tensions(entry, leaving), guess, near, tol)


def energy_miss(result: ArcResult) -> float:
    """Miss of loss = (T1 - T2)(g + (T1 - T2)/(2 EA')), of the work done along the profile.

    The work is counted without sign: what an overrun puts in and what comes out of it again cancel
    on an idle pulley.
    """
    arc, p, pull = result.arc, result.profile, result.effective_tension
    mean = 0.5 * (p.shear_stress[1:] + p.shear_stress[:-1])
    work = arc.width * float(np.sum(np.abs(mean * np.diff(p.creep))))
    exact = pull * (result.entry_creep_ratio + 0.5 * pull * arc.compliance)
    least = 1e-6 * arc.entry_tension * abs(result.entry_creep_ratio)
    work = max(work, least)  # rounding of a pull that is next to none
    return result.energy.identity_error * max(abs(exact), least) / work if work > 0.0 else 0.0
