"""One pulley of a train as numbers: what goes in at the entry nip, what comes out.

The unknown of a pulley is its *effort* y, a number of order one that grows with the creep towards
the slack side. For laws that rise from zero friction the entry creep ratio is g = 1e-5 sinh(y); for
laws that hold the belt without slip, y is the effort of :mod:`wraparc.arc.kernel.effort`, with its
sign.
Both are continuous where the pulley changes from driving to braking.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import asinh, copysign, cosh, exp, isfinite, log1p, nan, sinh

from wraparc.arc import WrapArc
from wraparc.arc.answer import operating_point
from wraparc.arc.kernel.effort import CREEP_SCALE, effort_of, largest_effort, shoot_from
from wraparc.arc.kernel.quantities import NO_SHOT, Parameters, Shot, parameters_at
from wraparc.arc.kernel.stick import zone_end
from wraparc.arc.profile import Range, Read, read
from wraparc.arc.quantities import SOLVED, Geometry, jumps
from wraparc.friction import CompactLaw

# mesh steps: to search, to search among pieces of a law, and those of `Distributed`
COARSE, SHARP, FINE = 8, 16, 24
#: Entry creep ratio where the scale of efforts turns from linear to logarithmic.
RATIO_SCALE = 1e-5
_LARGEST_EFFORT = asinh(0.9 / RATIO_SCALE)  # of laws that rise from zero friction
_BEYOND = 30.0  # logarithm of the tension ratio that stands for one too large for numbers
_STEP = 1e-4  # of effort and of ln(tension), for differences


@dataclass(frozen=True)
class Passage:
    """One pulley passed by the belt.

    Attributes
    ----------
    entry, exit
        Tensions [N].
    effort
        y [-].
    ratio
        Entry creep ratio g [-].
    creep, slip
        At the exit [m].
    held
        Whether the belt still sticks somewhere on the wrap.
    """

    entry: float
    exit: float
    effort: float
    ratio: float
    creep: float
    slip: float
    held: bool


@dataclass(frozen=True)
class Slopes:
    """How a passage answers to its entry tension a and its effort y: exit tension b and ratio g."""

    exit_by_entry: float
    exit_by_effort: float
    ratio_by_entry: float
    ratio_by_effort: float


@dataclass(frozen=True)
class Member:
    """A pulley of a train.

    Attributes
    ----------
    law, geometry
        As the kernel of :mod:`wraparc.arc` reads them.
    radius
        R over the unloaded lagging [m].
    stretch
        1/EA of the belt [1/N].
    squeeze
        Compression of the lagging at the entry per tension there, 2 h/(E_c B D) [m/N].
    """

    law: CompactLaw
    geometry: Geometry
    radius: float
    stretch: float
    squeeze: float

    @classmethod
    def of(cls, arc: WrapArc) -> Member:
        """Return the member of an arc, whose tensions do not matter."""
        squeeze = 2.0 * arc.compression_compliance / (arc.width * arc.diameter)
        stretch = 1.0 / arc.axial_stiffness
        return cls(arc.law.compact(), arc.geometry(), arc.radius, stretch, squeeze)

    @property
    def holds(self) -> bool:
        """Whether the law holds the belt without slip."""
        return jumps(self.law)

    @property
    def rests(self) -> bool:
        """Whether the belt can rest without any creep (a held belt, nothing that shears)."""
        par = parameters_at(1.0, self.geometry)
        return self.holds and par.shear + par.onset == 0.0

    @property
    def compliance(self) -> float:
        """1/EA' [1/N]."""
        return self.geometry.compliance

    def parameters(self, entry: float, side: float) -> Parameters:
        """Return the numbers of the march at an entry tension [N] and a side (+1, -1)."""
        return parameters_at(entry, self.geometry._replace(side=side))

    def arm(self, entry: float) -> float:
        """R - delta, the lever of the belt on the shaft [m]."""
        return self.radius - self.squeeze * entry

    def stretch_log(self, entry: float) -> float:
        """ln(1 + T1/EA) - ln(1 - delta/R): surface speed over belt speed without creep [-]."""
        return log1p(entry * self.stretch) - log1p(-self.squeeze * entry / self.radius)

    def stretch_slope(self, entry: float) -> float:
        """Change of `stretch_log` with tension, about 1/EA + delta/(R T1) [1/N]."""
        return self.stretch / (1.0 + entry * self.stretch) + self.squeeze / self.arm(entry)

    def effort_at(self, ratio: float) -> float:
        """Effort of an entry creep ratio; for laws that rise from zero friction."""
        return asinh(ratio / RATIO_SCALE)

    def passage(self, entry: float, effort: float, steps: int) -> Passage:
        """Send the belt over the pulley at an effort."""
        side = 1.0 if effort >= 0.0 else -1.0
        if self.holds:
            par = self.parameters(entry, side)
            z = abs(effort) - (0.0 if self.rests else 1.0)
            z = min(z, largest_effort(self.law, par))
        else:
            effort = min(max(effort, -_LARGEST_EFFORT), _LARGEST_EFFORT)
            if self.parameters(entry, 1.0).kick != 0.0:
                side = 1.0
            par = self.parameters(entry, side)
            z = effort_of(par, RATIO_SCALE * sinh(effort))
        shot = shoot(self.law, par, z, steps)
        if not isfinite(shot.log_tension):  # a trial far beyond any sense
            gone = copysign(_BEYOND, effort)
            return Passage(entry, entry * exp(-gone), effort, 0.01 * gone, gone, gone, False)
        ratio = shot.creep_ratio if self.holds else RATIO_SCALE * sinh(effort)
        return Passage(
            entry,
            entry * exp(shot.log_tension),
            effort,
            ratio,
            shot.creep,
            shot.slip,
            shot.stuck_length > 0.0,
        )

    def between(self, entry: float, exit_: float) -> Passage | None:
        """Send the belt over the pulley between two tensions; None if friction cannot."""
        side = 1.0 if entry >= exit_ else -1.0
        geometry = self.geometry._replace(side=side)
        found = operating_point(self.law, geometry, entry, exit_)
        if found.outcome != SOLVED:
            return None
        told = read(geometry, found.met, Range(nan, nan, nan))
        effort = self.effort_at(told.creep_ratio)
        if self.holds:
            effort = self._effort_of(self.parameters(entry, side), told)
        held = told.stuck > 0.0
        return Passage(entry, exit_, effort, told.creep_ratio, told.creep, told.slip, held)

    def _effort_of(self, par: Parameters, told: Read) -> float:
        """Effort of a law that holds the belt, by its rest arc; see `effort.shoot_from`."""
        length, zone = par.length, told.stuck
        if self.rests:
            slide = par.side * told.creep_ratio * length / CREEP_SCALE
            return par.side * (1.0 - zone / length if zone > 0.0 else 1.0 + max(slide, 0.0))
        end = zone_end(self.law, par, length)[1]
        if zone >= length:
            return par.side * told.creep / end  # an overrun may turn the creep of a light load
        zone = zone if zone > 0.0 else min(end / told.creep_ratio, length)
        return par.side * length / zone

    def slopes(self, at: Passage, steps: int = FINE) -> Slopes:
        """Slopes of a passage, by differences."""
        rise = at.entry * _STEP
        sign = 1.0 if at.effort >= 0.0 else -1.0
        further = self.passage(at.entry, at.effort + sign * _STEP, steps)
        tighter = self.passage(at.entry + rise, at.effort, steps)
        here = self.passage(at.entry, at.effort, steps)
        if self.holds:
            by_effort = (further.ratio - here.ratio) / (sign * _STEP)
        else:
            by_effort = RATIO_SCALE * cosh(at.effort)
        return Slopes(
            exit_by_entry=(tighter.exit - here.exit) / rise,
            exit_by_effort=(further.exit - here.exit) / (sign * _STEP),
            ratio_by_entry=(tighter.ratio - here.ratio) / rise if self.holds else 0.0,
            ratio_by_effort=by_effort,
        )


def shoot(law: CompactLaw, par: Parameters, z: float, steps: int) -> Shot:
    """March one arc to its exit at an effort; see `wraparc.arc.kernel.effort.shoot_from`.

    Where tension grows beyond all numbers, that of the shot is not finite.
    """
    try:
        return shoot_from(law, par, z, steps)
    except OverflowError:
        return NO_SHOT
