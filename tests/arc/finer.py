"""An arc with less misfit let stand than usual: the solver's own check of its meshes."""

from __future__ import annotations

from wraparc.arc import WrapArc
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
