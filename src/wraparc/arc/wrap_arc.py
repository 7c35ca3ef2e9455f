"""One loaded wrap arc: everything a solver needs to know, in SI."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, TypedDict

from wraparc.arc.quantities import Geometry, Load
from wraparc.arc.summary import (
    Description,
    geometry_of,
    held_creep,
    overrun_loosens,
    recovery_compliance,
    too_steep,
)
from wraparc.drive import CREEP_LIMIT, Belt, Drive, Fit, Lagging, LoadCase, Pulley
from wraparc.drive.belt import Side
from wraparc.drive.pitch import (
    centrifugal_of,
    counts_shear,
    cover_compliance,
    pitch_offset,
    pitch_radius,
    strain_ratio,
    whole_thickness,
)
from wraparc.drive.pull import ALONE, Growth, growth_in
from wraparc.errors import InputError, Problem
from wraparc.friction import COVER_SHEAR, LAGGING_SHEAR, FrictionLaw


class OfBelt(TypedDict):
    """What of a belt beside its width and its stiffness an arc has; see `WrapArc`."""

    pitch_offset: float | None
    cover_compliance: float
    cover_left_out: float
    side_of_belt: Side
    belt_thickness: float | None
    centrifugal: float


def of_belt(belt: Belt, side: Side, law: FrictionLaw) -> OfBelt:
    """Return what a belt adds to an arc: thickness, cover and mass, as far as they are known.

    The cover shears in series where the slip of the law is known not to include that already; where
    that is not known it is left out.
    """
    counted, cover = counts_shear(law, COVER_SHEAR), cover_compliance(belt, side)
    return OfBelt(
        pitch_offset=pitch_offset(belt, side),
        cover_compliance=cover if counted is False else 0.0,
        cover_left_out=cover if counted is None else 0.0,
        side_of_belt=side,
        belt_thickness=whole_thickness(belt),
        centrifugal=centrifugal_of(belt),
    )


def _speed_at(drive: Drive, case: LoadCase, tension: float) -> float | None:
    """Return the speed of the belt at a tension: that of the belt is at the first entry nip."""
    if drive.belt.speed is None:
        return None
    first = case.tensions[drive.pulleys[0].name].entry
    return drive.belt.speed * strain_ratio(tension, first, drive.belt.axial_stiffness)


@dataclass(frozen=True, kw_only=True)
class WrapArc:
    """A belt on one pulley in one load case.

    Attributes
    ----------
    law
        Friction law of the lagging.
    entry_tension, exit_tension
        T1 and T2, > 0 [N].
    diameter
        D over the unloaded lagging [m].
    wrap_angle
        phi [rad].
    width
        Belt width B [m].
    axial_stiffness
        EA = M B [N]; inf for a rigid belt.
    thickness
        Thickness h of the lagging that shears [m].
    shear_modulus
        G of the lagging [Pa]; inf if it does not shear.
    compression_modulus
        Effective compression modulus E_c of the lagging [Pa]; inf if it does not compress.
    overrun
        Slip x_c at the entry nip, rearward, negative towards travel [m], or None for
        1.25 delta sqrt(delta/R) with the compression delta = (h/E_c) p1.
    recovery
        Whether the lagging recovers along the arc as the pressure falls.
    creep_limit
        Creep at the exit that is accepted [m].
    belt_speed
        Speed of the belt at the entry [m/s], or None.
    wear_coefficient
        Worn volume per frictional energy [m3/J], or None.
    pitch_offset
        Offset e of the tension member over the surface of the lagging [m], or None where the belt
        is not known that well: the tension then runs at the surface.
    cover_compliance
        h_b/G_b of the belt cover on the pulley, which shears in series with the lagging [m/Pa].
    cover_left_out
        The same of a cover that the slip of the law may include or not: it is left out [m/Pa].
    side_of_belt
        Side of the belt that meets the pulley.
    belt_thickness
        Covers and carcass in all [m], or None: for pictures alone.
    centrifugal
        m v^2, the part of the tension that presses on no pulley [N].
    fit
        Statistics of the law, or None: for the interval of the creep alone.
    growth
        How its tensions grow over its pull, as the pull of the drive grows and the take-up holds:
        for the safety against gross slip alone.
    pulley, load_case
        Names, for reports.
    """

    law: FrictionLaw
    entry_tension: float
    exit_tension: float
    diameter: float
    wrap_angle: float
    width: float
    axial_stiffness: float
    thickness: float = 0.0
    shear_modulus: float = math.inf
    compression_modulus: float = math.inf
    overrun: float | None = None
    recovery: bool = True
    creep_limit: float = CREEP_LIMIT
    belt_speed: float | None = None
    wear_coefficient: float | None = None
    pitch_offset: float | None = None
    cover_compliance: float = 0.0
    cover_left_out: float = 0.0
    side_of_belt: Side = "pulley"
    belt_thickness: float | None = None
    centrifugal: float = 0.0
    fit: Fit | None = None
    growth: Growth = ALONE
    pulley: str = ""
    load_case: str = ""

    def __post_init__(self) -> None:
        problems = [
            Problem(key=key, value=f"{value:g} {unit}", message="must be positive and finite")
            for key, value, unit in (
                ("entry_tension", self.entry_tension, "N"),
                ("exit_tension", self.exit_tension, "N"),
                ("diameter", self.diameter, "m"),
                ("wrap_angle", self.wrap_angle, "rad"),
                ("width", self.width, "m"),
                ("creep_limit", self.creep_limit, "m"),
            )
            if not 0.0 < value < math.inf
        ]
        if not 0.0 <= self.thickness < math.inf:
            message = "must be 0 or positive, and finite"
            problems.append(
                Problem(key="thickness", value=f"{self.thickness:g} m", message=message)
            )
        if self.overrun is not None and not math.isfinite(self.overrun):
            message = "must be finite"
            problems.append(Problem(key="overrun", value=f"{self.overrun:g} m", message=message))
        problems += [
            Problem(key=key, value=f"{value:g} {unit}", message="must be positive")
            for key, value, unit in (
                ("axial_stiffness", self.axial_stiffness, "N"),
                ("shear_modulus", self.shear_modulus, "Pa"),
                ("compression_modulus", self.compression_modulus, "Pa"),
            )
            if not value > 0.0
        ]
        least = min(self.entry_tension, self.exit_tension)
        least = least if least > 0.0 else math.inf  # what is no tension was told
        for key, value, unit, most in (
            ("pitch_offset", self.pitch_offset or 0.0, "m", math.inf),
            ("cover_compliance", self.cover_compliance, "m/Pa", math.inf),
            ("centrifugal", self.centrifugal, "N", least),
        ):
            if not 0.0 <= value < most:
                ends = "at least 0" + ("" if most == math.inf else ", and less than the tensions")
                message = f"must be {ends}"
                problems.append(Problem(key=key, value=f"{value:g} {unit}", message=message))
        if not problems:
            problems = self._law_problems()
        if problems:
            raise InputError(problems)

    def _law_problems(self) -> list[Problem]:
        problems = []
        top = self.wrap_pressure(max(self.entry_tension, self.exit_tension))
        if too_steep(self.described(), self.law.steepest_fall()):
            fall = -1.0 / (self.shear_compliance * top)
            problems.append(
                Problem(
                    key="lagging",
                    value=f"{self.law.steepest_fall():g} 1/m",
                    message=f"post_peak_slope must be more than {fall:g} 1/m",
                    remedy="Check slope, thickness and shear modulus.",
                )
            )
        law = self.law.compact()
        if overrun_loosens(law, self.geometry(), self.entry_pressure):
            held = held_creep(law, self.shear_compliance, self.entry_pressure)
            problems.append(
                Problem(
                    key="overrun",
                    value=f"{self.entry_overrun:g} m",
                    message=f"must be within {held:g} m of 0, where this law starts to slip",
                    remedy='Write overrun = "0 mm".',
                )
            )
        return problems

    @classmethod
    def of(cls, drive: Drive, pulley: Pulley, case: LoadCase) -> WrapArc:
        """Return the arc of one pulley of a drive in one load case."""
        lagging, tensions = pulley.lagging_in(case.condition), case.tensions[pulley.name]
        return cls.on(
            drive.belt,
            pulley,
            lagging,
            entry_tension=tensions.entry,
            exit_tension=tensions.exit,
            creep_limit=drive.creep_limit_of(pulley),
            belt_speed=_speed_at(drive, case, tensions.entry),
            fit=lagging.fit,
            growth=growth_in(drive, case, pulley),
            load_case=case.name,
        )

    @classmethod
    def on(cls, belt: Belt, pulley: Pulley, lagging: Lagging, **more: Any) -> WrapArc:
        """Return the arc of a belt on a pulley; `more` is what neither of them says."""
        return cls(
            law=lagging.law,
            **of_belt(belt, pulley.side, lagging.law),
            diameter=pulley.diameter,
            wrap_angle=pulley.wrap_angle,
            width=belt.width,
            axial_stiffness=belt.axial_stiffness,
            thickness=lagging.thickness,
            shear_modulus=lagging.shear_modulus,
            compression_modulus=lagging.compression_modulus,
            overrun=pulley.overrun,
            recovery=pulley.recovery,
            wear_coefficient=lagging.wear_coefficient,
            pulley=pulley.name,
            **more,
        )

    @property
    def radius(self) -> float:
        """R = D/2 [m]."""
        return 0.5 * self.diameter

    @property
    def length(self) -> float:
        """L = R phi [m]."""
        return self.radius * self.wrap_angle

    @property
    def pitch_radius(self) -> float:
        """R - delta + e, at which the belt pulls and runs [m]."""
        return pitch_radius(self.radius, self.compression, self.offset)

    @property
    def effective_tension(self) -> float:
        """T1 - T2 [N]."""
        return self.entry_tension - self.exit_tension

    @property
    def duty(self) -> str:
        """What the pulley does to the belt: ``driving``, ``braking`` or ``idling``."""
        pull = self.effective_tension
        return "driving" if pull > 0.0 else "braking" if pull < 0.0 else "idling"

    @property
    def side(self) -> float:
        """+1 on a driving or idling pulley, -1 on a braking one."""
        return 1.0 if self.entry_tension >= self.exit_tension else -1.0

    def wrap_pressure(self, tension: float) -> float:
        """Wrap pressure p = 2 (T - m v^2)/(B D) [Pa]."""
        return 2.0 * (tension - self.centrifugal) / (self.width * self.diameter)

    @property
    def entry_pressure(self) -> float:
        """Wrap pressure at the entry nip [Pa]."""
        return self.wrap_pressure(self.entry_tension)

    @property
    def offset(self) -> float:
        """e, as far as it is known [m]."""
        return self.pitch_offset or 0.0

    @property
    def shear_compliance(self) -> float:
        """h/G + h_b/G_b, shear displacement of lagging and cover per shear stress [m/Pa].

        Without the part that the slip of the law includes.
        """
        return self.lagging_compliance + self.cover_compliance

    @property
    def lagging_compliance(self) -> float:
        """h/G of the lagging alone [m/Pa]; 0 where the slip of the law includes its shear."""
        return 0.0 if self.slip_with_shear else self.thickness / self.shear_modulus

    @property
    def slip_with_shear(self) -> bool:
        """Whether the slip of the law includes the shear of the lagging."""
        return counts_shear(self.law, LAGGING_SHEAR) is True

    @property
    def compression_compliance(self) -> float:
        """h/E_c, compression per wrap pressure [m/Pa]."""
        return self.thickness / self.compression_modulus

    @property
    def recovery_compliance(self) -> float:
        """Extra compliance kappa = 2 h/(B D R E_c), from the recovery of the lagging [1/N]."""
        return recovery_compliance(self.described())

    @property
    def compliance(self) -> float:
        """1/EA' = 1/EA + kappa [1/N]."""
        return 1.0 / self.axial_stiffness + self.recovery_compliance

    @property
    def compression(self) -> float:
        """Compression delta = (h/E_c) p1 of the lagging at the entry [m]."""
        return self.compression_compliance * self.entry_pressure

    @property
    def entry_overrun(self) -> float:
        """x_c, the slip at the entry nip that is used; negative towards travel [m]."""
        found, pressure = self.geometry(), self.entry_pressure
        return found.overrun_constant + found.overrun_coefficient * pressure * math.sqrt(pressure)

    def described(self) -> Description:
        """The arc but for its law and its limits, as plain numbers."""
        return Description(
            entry_tension=self.entry_tension,
            exit_tension=self.exit_tension,
            diameter=self.diameter,
            wrap_angle=self.wrap_angle,
            width=self.width,
            axial_stiffness=self.axial_stiffness,
            thickness=self.thickness,
            shear_modulus=self.shear_modulus,
            compression_modulus=self.compression_modulus,
            overrun=math.nan if self.overrun is None else self.overrun,
            recovery=self.recovery,
            belt_speed=math.nan if self.belt_speed is None else self.belt_speed,
            wear_coefficient=math.nan if self.wear_coefficient is None else self.wear_coefficient,
            shear_compliance=self.shear_compliance,
            pitch_offset=self.offset,
            centrifugal=self.centrifugal,
        )

    def geometry(self) -> Geometry:
        """Numbers of the arc that do not depend on its tensions."""
        return geometry_of(self.described())

    def load(self) -> Load:
        """Tensions above m v^2 and limits."""
        tested = self.law.tested
        ends = (math.nan, math.nan, math.nan)
        if tested is not None:
            ends = (tested.pressure_min, tested.pressure_max, tested.slip_max)
        return Load(
            self.entry_tension - self.centrifugal,
            self.exit_tension - self.centrifugal,
            self.creep_limit,
            *ends,
            self.law.steepest_fall(),
        )
