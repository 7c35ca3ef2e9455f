"""A drive pulley under its lagging."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import ClassVar, Self

from wraparc.drive.across import Across
from wraparc.drive.belt import SIDES, Side
from wraparc.drive.criteria import choice_problems
from wraparc.drive.lagging import Lagging
from wraparc.errors import Problem
from wraparc.provenance import Provenance
from wraparc.schema.limits import Limit, limit_problems, name_problems, raise_all
from wraparc.schema.uncertain import uncertainty_problems
from wraparc.units import display

#: Numbers that have an uncertainty; that of torque and power is the effective tension's.
UNCERTAIN_OF_PULLEY = (
    "diameter", "wrap_angle", "entry_tension", "exit_tension", "effective_tension",
)  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class Pulley:
    """A lagged pulley that drives or brakes the belt.

    Parameters
    ----------
    name
        Name of the pulley in its drive.
    diameter
        Diameter D over the unloaded lagging [m].
    wrap_angle
        Wrap angle phi, more than 0 and up to two turns [rad].
    lagging
        The lagging.
    overrun
        Slip x_c at the entry nip, rearward [m], or None to compute it from the compression of the
        lagging, 1.25 delta sqrt(delta/R). Negative is towards travel, as the brief positive spikes
        of belt movement in figure 11 of DeVries are: friction first works against a driving
        pulley, until slip passes zero. The law is odd in slip and takes no notice of the turn, as
        on a braking pulley with an overrun rearward.
    recovery
        Whether the lagging, recovering as the pressure changes along the arc, adds creep.
    creep_limit
        Largest creep accepted on this pulley [m], or None for the limit of the drive.
    side
        Side of the belt that meets the pulley: ``pulley``, or ``carry`` where the belt is bent the
        other way, as on one pulley of an S-wrap.
    mass
        Mass of the pulley with lagging and shaft [kg], or None where it is not known: the load of
        shaft and bearings is then that of the belt alone.
    across
        What is uneven across the width, or None for an even pulley under an even belt.
    uncertainty
        How far single numbers may be off either way (95 %), by field, or by tension in every load
        case: `UNCERTAIN_OF_PULLEY` [-].
    sources
        Where single numbers came from, by field or tension.
    conditions
        The same lagging in the conditions that single load cases name (wet ...).

    Raises
    ------
    InputError
        With every number outside its limit.
    """

    LIMITS: ClassVar[Mapping[str, Limit]] = {
        "diameter": Limit("length", least=1e-3, most=1e3),
        "wrap_angle": Limit("angle", least=math.radians(1.0), most=4.0 * math.pi),
        "overrun": Limit("length", least=-1.0, most=1.0),
        "creep_limit": Limit("length", open=True, most=1.0),
        "mass": Limit("mass", open=True, most=1e6),
    }

    name: str
    diameter: float
    wrap_angle: float
    lagging: Lagging
    overrun: float | None = None
    recovery: bool = True
    creep_limit: float | None = None
    side: Side = "pulley"
    mass: float | None = None
    across: Across | None = None
    uncertainty: Mapping[str, float] = field(default_factory=dict, hash=False)
    sources: Mapping[str, Provenance] = field(default_factory=dict, hash=False)
    conditions: tuple[Lagging, ...] = ()

    def __post_init__(self) -> None:
        problems = name_problems("name", self.name) + limit_problems(self, self.LIMITS)
        problems += choice_problems(self, {"side": SIDES})
        problems += uncertainty_problems(self.uncertainty, UNCERTAIN_OF_PULLEY)
        worn = self.across.worn_depth if self.across else None
        if worn is not None and worn.largest >= self.lagging.thickness:
            problems.append(
                Problem(
                    key="across.worn_depth",
                    value=display(worn.largest, "length"),
                    message="must be less than the lagging thickness "
                    + display(self.lagging.thickness, "length"),
                    remedy="Give the depth worn off, on radius.",
                )
            )
        raise_all(problems)

    def lagging_in(self, condition: str) -> Lagging:
        """Return the lagging in a condition of `conditions`; its own for an empty name.

        Raises
        ------
        KeyError
            If there is no such condition.
        """
        if not condition:
            return self.lagging
        try:
            return next(lagging for lagging in self.conditions if lagging.condition == condition)
        except StopIteration:
            raise KeyError(condition) from None

    def in_condition(self, condition: str) -> Self:
        """Return the pulley with its lagging in a condition; errors as for `lagging_in`."""
        return replace(self, lagging=self.lagging_in(condition)) if condition else self

    @property
    def radius(self) -> float:
        """R = D/2 [m]."""
        return self.diameter / 2.0

    @property
    def wrap_length(self) -> float:
        """L = R phi [m]."""
        return self.radius * self.wrap_angle
