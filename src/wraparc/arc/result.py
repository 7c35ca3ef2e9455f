"""Everything a solve of one arc has to say, in one frozen result."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, fields
from enum import StrEnum
from functools import cached_property
from typing import Any

import numpy as np

from wraparc.arc.answer import operating_point
from wraparc.arc.grip import sliding
from wraparc.arc.interval import creep_interval
from wraparc.arc.quantities import SOLVED
from wraparc.arc.sliding import NOT_CARRIED
from wraparc.arc.summary import spring_rate
from wraparc.arc.wrap_arc import WrapArc
from wraparc.arrays import Array
from wraparc.drive.pull import idles
from wraparc.views import Viewable

nan = math.nan
#: Names of the ends of the interval of the creep.
_INTERVAL = ("exit_creep_low", "exit_creep_high")
#: Numbers that only a check reads: times the belt speed it is the slip speed.
_UNREPORTED = frozenset({"steepest_slip"})


#: What helps a drive that slips, at the end of what else does.
MORE_FRICTION = "choose a lagging with more friction."


class Status(StrEnum):
    """How a solve ended: the value is the sentence the user reads, with its remedy."""

    SOLVED = "The pulley transmits its load."
    BREAKAWAY = (
        "Gross slip: no creep gives enough friction for this tension ratio. Raise the slack-side "
        f"tension (take-up), increase the wrap angle, or {MORE_FRICTION}"
    )
    UNSOLVED = (
        "The solver did not reach its accuracy on this arc. Please report the drive file; until "
        "then change a value slightly."
    )

    @property
    def solved(self) -> bool:
        """Whether the pulley carries its load."""
        return self is Status.SOLVED


@dataclass(frozen=True, eq=False)
class Profile(Viewable):
    """Quantities along the arc, from the entry nip to the exit nip; arrays of one shape (n,).

    Attributes
    ----------
    position
        theta from the entry nip [rad].
    tension
        T [N].
    wrap_pressure
        p [Pa].
    friction
        Friction available, mu(x, p), with the sign of the slip [-].
    friction_used
        tau/p [-].
    slip, creep
        x and u, rearward positive [m].
    shear_stress
        tau, positive where the pulley drives the belt [Pa].
    shear_angle
        gamma [rad].
    sliding
        1 where the belt slides on the lagging, 0 where it sticks.
    """

    position: Array
    tension: Array
    wrap_pressure: Array
    friction: Array
    friction_used: Array
    slip: Array
    creep: Array
    shear_stress: Array
    shear_angle: Array
    sliding: Array

    def __len__(self) -> int:
        return len(self.position)

    def columns(self) -> Iterator[tuple[str, Array]]:
        """Yield each column with its name in the glossary; 4e-15 of its largest is rounding."""
        for f in fields(self):
            column: Array = getattr(self, f.name)
            size = np.abs(column)
            yield f.name, np.where(size < 4e-15 * size.max(initial=0.0), 0.0, column)


@dataclass(frozen=True)
class Capacities:
    """What the pulley could carry with its tight side held (T1 driving, T2 braking).

    Ratios are tight over slack side; margins are the capacity over the actual ratio.

    Attributes
    ----------
    creep_limit_capacity, creep_limit_margin
        Ratio at the creep limit, the design number [-].
    equivalent_friction
        ln(creep_limit_capacity)/phi: a constant friction to set beside CEMA and DIN values [-].
    least_exit_tension
        Least slack-side tension that carries the same effective tension within the creep limit
        [N]; nan if there is none with the tight-side pressure in the tested range.
    largest_effective_tension
        Largest magnitude of T1 - T2 within the creep limit with the tight-side pressure in the
        tested range [N]; nan where `least_exit_tension` exists.
    tested_slip_capacity, tested_slip_margin
        Ratio at which the exit slip is the largest tested [-]; nan without a tested range.
    gross_slip_capacity, extrapolated_gross_slip_margin
        Ratio at gross slip by the law alone, an extrapolation beyond its tests: no safety factor;
        that is `ArcResult.gross_slip_safety` [-].
    gross_slip_creep
        Exit creep there [m]; inf if no finite creep attains it.
    """

    creep_limit_capacity: float = nan
    creep_limit_margin: float = nan
    equivalent_friction: float = nan
    least_exit_tension: float = nan
    largest_effective_tension: float = nan
    tested_slip_capacity: float = nan
    tested_slip_margin: float = nan
    gross_slip_capacity: float = nan
    extrapolated_gross_slip_margin: float = nan
    gross_slip_creep: float = nan


@dataclass(frozen=True)
class Energy:
    """Losses and wear; powers are nan where the belt speed is not known.

    Attributes
    ----------
    transmitted_power
        v_s (T1 - T2) with the speed v_s of the lagging surface at the entry [W].
    sliding_power
        v_s B int tau dx [W].
    shear_loss
        Shear energy given up at the exit, v_s B (h/2G)(tau_exit^2 - tau_entry^2) [W].
    power_loss
        Sum of both [W].
    efficiency
        Driving 1 - loss/power, braking 1/(1 + loss/abs(power)) [-].
    frictional_energy
        int tau dx, per area of lagging and pass [J/m2].
    wear_rate
        Depth per million passes [m]; nan without a wear coefficient.
    identity_error
        Relative miss of the exact loss (T1 - T2)[g + (T1 - T2)/(2 EA')]: a check of the solve [-].
    """

    transmitted_power: float = nan
    sliding_power: float = nan
    shear_loss: float = nan
    power_loss: float = nan
    efficiency: float = nan
    frictional_energy: float = nan
    wear_rate: float = nan
    identity_error: float = nan


@dataclass(frozen=True, eq=False)
class ArcResult(Viewable):
    """The complete answer for one arc.

    An arc that is not solved has no state: its profile is empty and its numbers are nan, all but
    the tensions asked for and, on a breakaway, the capacities.

    Attributes
    ----------
    status
        How the solve ended.
    method
        Name of the method.
    arc
        What was solved.
    profile
        Quantities along the arc.
    entry_tension, exit_tension
        Tensions asked for [N]; the paper's integration, from the exit on, misses T1 by its steps.
    exit_creep, creep_shrinkage, creep_compression, creep_global
        Creep at the exit and its three parts [m].
    exit_slip
        Slip at the exit [m].
    entry_creep_ratio, exit_creep_ratio
        g and g + (T1 - T2)/EA' [-].
    peak_shear_stress, peak_shear_angle, peak_shear_position
        Largest shear stress [Pa], angle [rad], and where [rad].
    mean_friction
        abs(ln(T1/T2))/phi [-].
    active_arc
        Exit part that takes 99 % of the tension change [rad].
    outside_tested_share
        Fraction of the wrap outside the tested range; nan for a law without one [-].
    stuck_arc
        Entry part over which the belt does not slip [rad].
    capacities, energy
        See there.
    steepest_slip
        Largest growth of slip per length of the arc, not among `scalars` [-].
    """

    status: Status
    method: str
    arc: WrapArc
    profile: Profile
    entry_tension: float
    exit_tension: float
    exit_creep: float
    creep_shrinkage: float
    creep_compression: float
    creep_global: float
    exit_slip: float
    entry_creep_ratio: float
    exit_creep_ratio: float
    peak_shear_stress: float
    peak_shear_angle: float
    peak_shear_position: float
    mean_friction: float
    active_arc: float
    outside_tested_share: float
    stuck_arc: float
    capacities: Capacities
    energy: Energy
    steepest_slip: float = nan

    @classmethod
    def without_state(
        cls, status: Status, method: str, arc: WrapArc, capacities: Capacities
    ) -> ArcResult:
        """Return the answer for an arc that is not solved."""
        empty = np.zeros(0)
        given: dict[str, Any] = {f.name: nan for f in fields(cls)} | {
            "status": status,
            "method": method,
            "arc": arc,
            "profile": Profile(*(empty for _ in fields(Profile))),
            "entry_tension": arc.entry_tension,
            "exit_tension": arc.exit_tension,
            "capacities": capacities,
            "energy": Energy(),
        }
        return cls(**given)

    @property
    def tension_ratio(self) -> float:
        """T1/T2 of the solution [-]."""
        return self.entry_tension / self.exit_tension

    @property
    def effective_tension(self) -> float:
        """T1 - T2 of the solution [N]."""
        return self.entry_tension - self.exit_tension

    @property
    def k_factor(self) -> float:
        """Spring rate of the belt over its active arc, k = M B/(R phi_a) [N/m]; nan if idle.

        Equation 7 of B. DeVries, *A model of lagging friction as a function of creep history and
        wrap pressure*; a change of tension dT shrinks that length of belt by dT/k.
        """
        length = self.arc.radius * self.active_arc
        return spring_rate(self.arc.axial_stiffness, length, self.exit_creep)

    @cached_property
    def creep_interval(self) -> tuple[float, float]:
        """95 % interval of the exit creep by the uncertainty of the law, see `creep_interval` [m].

        nan where the arc is not solved, by the paper's integration, or its law has no statistics.
        """
        if not self.status.solved or self.method == "paper":
            return nan, nan
        return creep_interval(self.arc)

    @cached_property
    def covered_creep(self) -> float:
        """Creep at the exit with the belt cover in series, where the slip may include it [m].

        inf where friction does not carry that; nan where there is no such cover, or no state.
        """
        arc = self.arc
        if not self.status.solved or arc.cover_left_out == 0.0:
            return nan
        load, geometry = arc.load(), arc.geometry()
        series = geometry._replace(shear=geometry.shear + arc.cover_left_out)
        found = operating_point(arc.law.compact(), series, load.entry_tension, load.exit_tension)
        if found.outcome != SOLVED:
            return math.copysign(math.inf, arc.side)
        return found.met.course.creep[-1]

    @cached_property
    def gross_slip_safety(self) -> float:
        """Pull at which the belt slides over the pull, growing as the take-up lets it [-].

        The number of the check "Safety against gross slip": the belt slides at a creep of 63.5 mm,
        at the end of the tested slip or where all friction is used up, whichever comes first. inf
        of a pulley that pulls nothing; less than 1 in gross slip; nan where it is not found.
        """
        if self.status is Status.UNSOLVED:
            return nan
        if idles(self.arc.entry_tension, self.arc.exit_tension):
            return math.inf
        place = sliding(self).place
        return place if self.status.solved else min(place, NOT_CARRIED)

    @property
    def sticks(self) -> bool:
        """Whether the belt is at rest on part of the arc; 1e-9 rad of it is rounding."""
        return self.stuck_arc > 1e-9

    @property
    def extrapolates(self) -> bool:
        """Whether part of the arc is outside what was tested; 1e-9 of it is rounding."""
        return self.outside_tested_share > 1e-9

    @property
    def share_of_limit(self) -> float:
        """Magnitude of the exit creep over the creep limit [-]."""
        return abs(self.exit_creep) / self.arc.creep_limit

    @property
    def within_creep_limit(self) -> bool:
        """Whether the magnitude of the exit creep is within the creep limit."""
        return self.status.solved and abs(self.exit_creep) <= self.arc.creep_limit

    def scalar(self, name: str) -> float:
        """Return one of `scalars` [SI], without the others: some are a search of their own."""
        if name in _INTERVAL:
            return self.creep_interval[_INTERVAL.index(name)]
        for part in (self, self.capacities, self.energy):
            if hasattr(part, name):
                return float(getattr(part, name))
        raise KeyError(name)

    def scalars(self) -> dict[str, float]:
        """Every reported number by its name in the glossary [SI]."""
        named = {
            f.name: getattr(self, f.name)
            for f in fields(self)
            if isinstance(getattr(self, f.name), float) and f.name not in _UNREPORTED
        }
        named["tension_ratio"] = self.tension_ratio
        named["effective_tension"] = self.effective_tension
        named["k_factor"] = self.k_factor
        named["gross_slip_safety"] = self.gross_slip_safety
        named.update(zip(_INTERVAL, self.creep_interval, strict=True))
        for part in (self.capacities, self.energy):
            named.update({f.name: getattr(part, f.name) for f in fields(part)})
        return named
