"""Everything a solve across the width has to say, in one frozen result."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from functools import cached_property

import numpy as np

from wraparc.across.modes import mode_response
from wraparc.across.wide_arc import WideArc
from wraparc.alike import place_of_largest
from wraparc.arc import ArcResult
from wraparc.arrays import Array
from wraparc.views import Viewable


class AcrossStatus(StrEnum):
    """How a solve across the width ended: the value is the sentence the user reads."""

    SOLVED = "Every strip of the belt is under tension."
    SLACK = (
        "A strip of the belt goes slack: it would have to push. Take out the build-up, "
        "misalignment or profile that slackens it, or raise the tension."
    )
    BREAKAWAY = (
        "Gross slip: with this unevenness friction is too low for the tension ratio. "
        "Raise the slack-side tension (take-up), or even out the pulley."
    )
    UNSOLVED = (
        "The solver did not reach its accuracy across the width. Please report the drive file; "
        "until then use fewer strips or a smoother profile."
    )

    @property
    def solved(self) -> bool:
        """Whether the result holds."""
        return self is AcrossStatus.SOLVED


@dataclass(frozen=True, eq=False, kw_only=True)
class Slack:
    """Where the belt goes slack.

    Attributes
    ----------
    position
        Place across the belt, 0 in the middle [m].
    angle
        Place on the wrap, from the entry nip [rad].
    tension
        Tension per unit width that the linear belt would have there, negative [N/m].
    share
        Share of the given unevenness at which the first strip goes slack [-]; nan if not sought.
    """

    position: float
    angle: float
    tension: float
    share: float = float("nan")


@dataclass(frozen=True, eq=False, kw_only=True)
class Fields:
    """Quantities over the wrap arc and the width, arrays of shape (m, n).

    Attributes
    ----------
    tension
        t, tension per unit width [N/m].
    wrap_pressure
        p [Pa].
    creep, slip
        u and x, rearward positive [m].
    shear_stress
        tau, positive where the pulley drives the belt [Pa].
    lag
        How far the label line, straight across the unstretched belt, is behind; mean 0 at the
        entry [m].
    frictional_energy
        int tau dx from the entry to here, per area and pass [J/m2].
    """

    tension: Array
    wrap_pressure: Array
    creep: Array
    slip: Array
    shear_stress: Array
    lag: Array
    frictional_energy: Array


@dataclass(frozen=True, eq=False, kw_only=True)
class AcrossResult(Viewable):
    """The complete answer for one arc across the width.

    Attributes
    ----------
    status
        How the solve ended.
    wide
        What was solved.
    even
        The even belt on the even pulley, as `wraparc.solve` answers it.
    angle
        Places on the wrap, from the entry nip, shape (m,) [rad].
    fields
        Quantities over arc and width.
    drum_number
        Gamma = 1 - V/(omega R), one number for all strips [-].
    friction_force
        int tau ds by strip, what friction takes from each, shape (n,) [N/m].
    entry_creep_ratio
        g by strip, shape (n,) [-].
    span_tension
        Largest tension of each strip in the span before the pulley, shape (n,) [N/m].
    static_tension
        Tension of each strip at standstill, with the label lines held at both ends of the
        transition, shape (n,) [N/m].
    yaw_moment
        int t1 y dy: how the belt turns its frame [N m].
    entry_guide_force, exit_guide_force
        Sideways force that idlers must hold, S times the lag from edge to edge [N].
    identity_error
        Relative miss of the exact balance of energy, with friction between the points of the solve:
        a check of it [-].
    error_estimate
        Estimated error of tensions, creep and drum number along the arc, over the largest of each
        [-]; that of strips of finite width comes on top.
    slack
        Where a strip goes slack, or None.
    iterations
        Newton steps.
    """

    status: AcrossStatus
    wide: WideArc
    even: ArcResult
    angle: Array
    fields: Fields
    drum_number: float
    friction_force: Array
    entry_creep_ratio: Array
    span_tension: Array
    static_tension: Array
    yaw_moment: float
    entry_guide_force: float
    exit_guide_force: float
    identity_error: float
    error_estimate: float = float("nan")
    slack: Slack | None = None
    iterations: int = 0

    @property
    def position(self) -> Array:
        """Positions of the strips, 0 in the middle of the belt [m]."""
        return self.wide.position

    @property
    def entry_tension(self) -> Array:
        """t1 by strip [N/m]."""
        return np.asarray(self.fields.tension[0])

    @property
    def exit_tension(self) -> Array:
        """t2 by strip [N/m]."""
        return np.asarray(self.fields.tension[-1])

    @property
    def exit_creep(self) -> Array:
        """Creep u at the exit by strip [m]."""
        return np.asarray(self.fields.creep[-1])

    @property
    def exit_slip(self) -> Array:
        """Slip x at the exit by strip [m]."""
        return np.asarray(self.fields.slip[-1])

    @property
    def peak_shear_stress(self) -> Array:
        """Largest shear stress by strip, which is that on the bond [Pa]."""
        return np.asarray(np.max(np.abs(self.fields.shear_stress), axis=0))

    @property
    def frictional_energy(self) -> Array:
        """Frictional energy e by strip, per area and pass, int tau dx [J/m2]."""
        return np.asarray(self.fields.frictional_energy[-1])

    @property
    def largest_running_tension(self) -> float:
        """Largest tension per unit width anywhere in the wrap or the span before it [N/m].

        At the very edges carried on from the outer strips, see `to_the_edges`.
        """
        wrap, span = to_the_edges(self.fields.tension), to_the_edges(self.span_tension)
        return float(max(np.max(wrap), np.max(span)))

    @property
    def tightest_strip_tension(self) -> float:
        """Largest tension per unit width of a strip, the mean over it, in wrap or span [N/m]."""
        return float(max(np.max(self.fields.tension), np.max(self.span_tension)))

    @property
    def largest_static_tension(self) -> float:
        """Largest tension per unit width at standstill, at the very edges too [N/m]."""
        return float(np.max(to_the_edges(self.static_tension)))

    @property
    def least_tension(self) -> float:
        """Least tension per unit width anywhere in the wrap [N/m]."""
        return float(np.min(self.fields.tension))

    @property
    def largest_pressure(self) -> float:
        """Largest wrap pressure [Pa]."""
        return float(np.max(self.fields.wrap_pressure))

    @property
    def largest_creep(self) -> float:
        """Creep at the exit of the strip that creeps most, with its sign [m]."""
        return float(self.exit_creep[place_of_largest(np.abs(self.exit_creep))])

    @property
    def entry_unevenness(self) -> float:
        """Largest over mean entry tension [-]."""
        return _unevenness(self.entry_tension)

    @property
    def exit_unevenness(self) -> float:
        """Largest over mean exit tension [-]."""
        return _unevenness(self.exit_tension)

    @property
    def energy_unevenness(self) -> float:
        """Largest over mean frictional energy: how much faster the worst strip wears [-]."""
        return _unevenness(self.frictional_energy)

    @cached_property
    def levelling_depth(self) -> Array:
        """Mean wear that levels the modes 1 to 4 by 2.72 [m]; negative where wear makes them grow.

        Shape (4,); nan where the even belt is not carried.
        """
        if not self.even.status.solved:
            return np.full(4, np.nan)
        return mode_response(self.wide, 4, even=self.even).levelling_depth

    @property
    def wear_grows(self) -> bool:
        """Whether wear makes some unevenness of the lagging larger, as on a pulley that brakes."""
        return bool(np.any(self.levelling_depth < 0.0))

    @property
    def outside_tested_share(self) -> float:
        """Share of the wrapped area outside the tested range [-]; nan without one."""
        tested = self.wide.arc.law.tested
        if tested is None:
            return float("nan")
        p, x = self.fields.wrap_pressure, np.abs(self.fields.slip)
        outside = (p < tested.pressure_min) | (p > tested.pressure_max) | (x > tested.slip_max)
        share = np.mean(outside, axis=1)
        return float(np.trapezoid(share, self.angle) / (self.angle[-1] - self.angle[0]))

    def scalars(self) -> dict[str, float]:
        """Every reported number by its name in the glossary [SI]."""
        return {name: float(getattr(self, name)) for name in SCALARS}


#: What tells how uneven the belt runs and stands, and wears.
UNEVEN = (
    "largest_running_tension",
    "tightest_strip_tension",
    "largest_static_tension",
    "least_tension",
    "largest_pressure",
    "largest_creep",
    "entry_unevenness",
    "exit_unevenness",
    "energy_unevenness",
)
SCALARS = (
    *UNEVEN,
    "outside_tested_share",
    "yaw_moment",
    "entry_guide_force",
    "exit_guide_force",
    "drum_number",
)


def _unevenness(values: Array) -> float:
    mean = float(np.mean(values))
    return float(np.max(values)) / mean if mean != 0.0 else float("nan")


def to_the_edges(tension: Array) -> Array:
    """Tensions of strips with those at both edges of the belt, shape (..., n + 2).

    A strip holds the mean over its width; at its edge the belt has t_1 + (t_1 - t_2)/2, carried on
    linearly from the two outer strips: exact where the tension runs linearly to the edge.
    """
    if tension.shape[-1] < 2:
        return tension
    first = 1.5 * tension[..., :1] - 0.5 * tension[..., 1:2]
    last = 1.5 * tension[..., -1:] - 0.5 * tension[..., -2:-1]
    return np.concatenate([first, tension, last], axis=-1)
