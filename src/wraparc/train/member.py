"""One pulley of a train as numbers: what goes in at the entry nip, what comes out.

The unknown of a pulley is its *place* on the way from braking to driving, in metres: the creep at
its exit, c. Exit tension and entry creep ratio follow from it and the entry tension, for every law
and on both sides. Where the belt rests without any creep, the tension falls like the root of c, and
the place x is that: c = x |x|/1 mm.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import copysign, exp, log1p, nan, sqrt
from typing import NamedTuple

from wraparc.arc import WrapArc
from wraparc.arc.answer import operating_point
from wraparc.arc.collocation import MESH
from wraparc.arc.meet import Met
from wraparc.arc.passage import NO_MESH, SLIDE, Passed, passed, slide_slope
from wraparc.arc.profile import traction_of
from wraparc.arc.quantities import SOLVED, Geometry, jumps
from wraparc.friction import CompactLaw

#: Misfit of the arcs that is let stand: of a search, of curves, of what is told.
COARSE, SHARP, FINE = NO_MESH, 1e-5, MESH
#: Largest entry creep ratio that is considered, either way.
LARGEST_RATIO = 0.5
REST_SCALE = 1e-3  # creep of a slide behind a rest arc where its root is a place of the same size
_LEAST_RISE = 1e-9  # of tension, over a creep as long as the wrap: less is none
_BEYOND = 30.0  # logarithm of the tension ratio that stands for one too large for numbers


class Response(NamedTuple):
    """How a passage answers to its entry tension a and its place x: exit tension b and ratio g."""

    exit_by_entry: float
    exit_by_place: float
    ratio_by_entry: float
    ratio_by_place: float


UNKNOWN = Response(nan, nan, nan, nan)


@dataclass(frozen=True, eq=False)
class Passage:
    """One pulley passed by the belt.

    Attributes
    ----------
    entry, exit
        Tensions [N].
    place
        x [m]; nan where only the tensions are known.
    ratio
        Entry creep ratio g [-].
    creep, slip
        At the exit [m].
    held
        Whether the belt still sticks somewhere on the wrap.
    slopes
        How it answers.
    met
        The arc, to begin the next one with; or None.
    """

    entry: float
    exit: float
    place: float = nan
    ratio: float = nan
    creep: float = nan
    slip: float = nan
    held: bool = False
    slopes: Response = UNKNOWN
    met: Met | None = None


@dataclass(frozen=True)
class Member:
    """A pulley of a train.

    Attributes
    ----------
    law, geometry
        As the solver of :mod:`wraparc.arc` reads them.
    radius
        R + e of the tension member over the unloaded lagging [m].
    stretch
        1/(EA + m v^2) of the belt [1/N]: tensions are those above m v^2, and 1 + T/EA goes with
        1 + (T - m v^2)/(EA + m v^2).
    squeeze
        Compression of the lagging at the entry per tension there, 2 h/(E_c B D) [m/N].
    offset
        e of the tension member, 0 where it is not known [m].
    """

    law: CompactLaw
    geometry: Geometry
    radius: float
    stretch: float
    squeeze: float
    offset: float = 0.0

    @classmethod
    def of(cls, arc: WrapArc) -> Member:
        """Return the member of an arc, whose tensions do not matter."""
        squeeze = 2.0 * arc.compression_compliance / (arc.width * arc.diameter)
        stretch = 1.0 / (arc.axial_stiffness + arc.centrifugal)
        radius = arc.radius + arc.offset
        return cls(arc.law.compact(), arc.geometry(), radius, stretch, squeeze, arc.offset)

    @property
    def holds(self) -> bool:
        """Whether the law holds the belt without slip."""
        return jumps(self.law)

    @property
    def rests(self) -> bool:
        """Whether the belt can rest without any creep (a held belt, nothing that shears)."""
        return self.holds and self.geometry.shear == 0.0

    @property
    def compliance(self) -> float:
        """1/EA' [1/N]."""
        return self.geometry.compliance

    @property
    def length(self) -> float:
        """Length of the wrap [m]."""
        return self.geometry.radius * self.geometry.wrap_angle

    @property
    def largest_place(self) -> float:
        """Largest place that is considered, either way [m]."""
        return self.place_of(LARGEST_RATIO * self.length)

    def arm(self, entry: float) -> float:
        """R - delta + e, the lever of the belt on the shaft [m]."""
        return self.radius - self.squeeze * entry

    def stretch_log(self, entry: float) -> float:
        """ln(1 + T1/EA) - ln(1 - delta/(R + e)): surface over belt speed without creep [-]."""
        return log1p(entry * self.stretch) - log1p(-self.squeeze * entry / self.radius)

    def stretch_slope(self, entry: float) -> float:
        """Change of `stretch_log` with tension, about 1/EA + delta/(R T1) [1/N]."""
        return self.stretch / (1.0 + entry * self.stretch) + self.squeeze / self.arm(entry)

    def rises(self, at: Passage) -> bool:
        """Whether the pulley pulls more if it creeps more; where not, it is past its peak."""
        return at.slopes.exit_by_place * self.length < -_LEAST_RISE * at.exit

    def place_of(self, creep: float) -> float:
        """Place of a creep at the exit [m]."""
        return copysign(sqrt(abs(creep) * REST_SCALE), creep) if self.rests else creep

    def passage(self, entry: float, place: float, near: Met | None, tol: float) -> Passage:
        """Send the belt over the pulley at a place.

        Parameters
        ----------
        entry, place
            Tension [N] and x [m].
        near
            An arc nearly the same, to begin with.
        tol
            Misfit that is let stand: `COARSE`, `SHARP` or `FINE`.
        """
        arc = self._driven(place >= 0.0)
        if not self.rests:
            found = passed(self.law, arc, entry, place, near, tol)
            return self._told(arc, entry, place, place, 1.0, found)
        fall = slide_slope(self.law, arc, entry) / sqrt(REST_SCALE)
        creep = place * abs(place) / REST_SCALE
        if abs(fall * place) <= SLIDE * entry:
            slopes = Response(1.0, -fall, 0.0, 0.0)
            return Passage(entry, entry - fall * place, place, 0.0, creep, creep, True, slopes)
        found = passed(self.law, arc, entry, creep, near, tol)
        return self._told(arc, entry, place, creep, 2.0 * abs(place) / REST_SCALE, found)

    def _driven(self, driving: bool) -> Geometry:
        return self.geometry._replace(side=1.0 if driving else -1.0)

    def _told(
        self, arc: Geometry, entry: float, place: float, creep: float, by_place: float, at: Passed
    ) -> Passage:
        """Return what an arc says; `by_place` is the slope of its creep."""
        met = at.met
        if not met.done:  # a trial far beyond any sense
            gone = copysign(_BEYOND, place)
            ratio = copysign(LARGEST_RATIO, place)
            return Passage(entry, entry * exp(-gone), place, ratio, creep, creep)
        slopes = Response(
            at.leaving_by_entry,
            at.leaving_by_creep * by_place,
            at.ratio_by_entry,
            at.ratio_by_creep * by_place,
        )
        slip = traction_of(arc, met, at.leaving, creep).slip
        held = self.holds and (met.rest > 0.0 or not self.rests)
        return Passage(entry, at.leaving, place, at.ratio, creep, slip, held, slopes, met)

    def between(self, entry: float, exit_: float) -> Passage | None:
        """Send the belt over the pulley between two tensions; None if friction cannot."""
        arc = self._driven(entry >= exit_)
        found = operating_point(self.law, arc, entry, exit_)
        if found.outcome != SOLVED:
            return None
        place = self.place_of(found.met.course.creep[-1])
        # one step of the same arc on its mesh tells how it answers
        return replace(self.passage(entry, place, found.met, COARSE), exit=exit_)
