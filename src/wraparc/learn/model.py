"""What a healthy or a tired drive shows by its torque: speeds by friction and by every error.

Of pulley j in a steady window, y = 1 - v/(omega R/i), to first order,

    y = z(t) + g(Te, T2; f(t)) + (T1 - T_wheel)/EA(t) + (h/(B R^2 E_c)) T1 + c (m - 0.3) + d(m)

with the torque m over the rated one, Te = T_rated (m - o)/gain, T2 by the take-up and its play and
the pulls of the drives behind, z the zero of wheel, pulley and belt thickness.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from wraparc.arrays import Array
from wraparc.drive import Drive
from wraparc.learn.curves import CreepTable, creep_table
from wraparc.learn.file import LearnPlan, TagChoice

#: Torque at which the slope of speed by torque is none [-], least pull [N].
_MIDDLE, _LEAST_PULL = 0.3, 300.0
#: Part of the strain of the belt that shows again in the creep of the pulley.
_IN_CREEP = 0.3
Nuisance = Mapping[str, float]


@dataclass(frozen=True, eq=False)
class SpeedModel:
    """Speed differences of the pulleys of a drive by torque.

    Attributes
    ----------
    drive
        As described.
    names
        Pulleys in belt order.
    rated_pull
        Effective tension at rated torque of each [N].
    take_up
        T2 as described [N].
    falls_with_pull
        Part of the pull by which T2 falls: 0.5 with a fixed take-up, else 0 [-].
    wheel
        Where the belt speed is measured.
    tables
        Creep of each pulley.
    """

    drive: Drive
    names: tuple[str, ...]
    rated_pull: tuple[float, ...]
    take_up: float
    falls_with_pull: float
    wheel: str
    tables: tuple[CreepTable, ...]

    def tensions(
        self, torque: Array, nuisance: Nuisance, play: Array | float
    ) -> tuple[Array, Array]:
        """Return Te and the tension behind each pulley [N], shape (k, n)."""
        pulls = [
            rated
            * (m - nuisance.get(f"torque_offset.{name}", 0.0))
            * np.exp(-nuisance.get(f"torque_gain.{name}", 0.0))
            for name, rated, m in zip(self.names, self.rated_pull, torque, strict=True)
        ]
        pull = np.maximum(np.array(pulls), _LEAST_PULL)
        last = self.take_up * np.exp(
            nuisance.get("exit_tension", 0.0) + nuisance.get("take_up_friction", 0.0) * play
        )
        if self.falls_with_pull:
            design = sum(self._design_pulls())
            last = np.maximum(
                last - self.falls_with_pull * (pull.sum(axis=0) - design), 0.1 * self.take_up
            )
        beyond = np.cumsum(pull[::-1], axis=0)[::-1] - pull
        return pull, last + beyond

    def _design_pulls(self) -> list[float]:
        case = self.drive.load_case()
        return [case.tensions[name].entry - case.tensions[name].exit for name in self.names]

    def creep(
        self, torque: Array, ln_friction: Array, nuisance: Nuisance, play: Array | float = 0.0
    ) -> Array:
        """Return the entry creep ratio of each pulley [-], shape (k, n)."""
        pull, behind = self.tensions(torque, nuisance, play)
        return np.array(
            [
                table.ratio(te, tx, f, nuisance)
                for table, te, tx, f in zip(self.tables, pull, behind, ln_friction, strict=True)
            ]
        )

    def curve(
        self, torque: Array, ln_friction: Array, nuisance: Nuisance, play: Array | float = 0.0
    ) -> Array:
        """Return y without its zero [-], shape (k, n)."""
        pull, behind = self.tensions(torque, nuisance, play)
        entering = pull + behind
        g = np.array(
            [
                table.ratio(te, tx, f, nuisance)
                for table, te, tx, f in zip(self.tables, pull, behind, ln_friction, strict=True)
            ]
        )
        wheel = entering[0] if self.wheel == "entry" else behind[-1]
        stiffness = self.drive.belt.axial_stiffness * np.exp(nuisance.get("belt_modulus", 0.0))
        strain = (entering - wheel) / stiffness
        squeeze = np.array([_compression(table) for table in self.tables])[:, None] * (
            entering - self.take_up
        )
        slope = np.array(
            [
                nuisance.get(f"speed_by_torque.{name}", 0.0) * (m - _MIDDLE)
                for name, m in zip(self.names, torque, strict=True)
            ]
        )
        return np.asarray(g + strain + squeeze + slope)

    def strain(self, torque: Array, nuisance: Nuisance) -> Array:
        """Return what a change of the belt's modulus changes of y [-], shape (k, n)."""
        pull, behind = self.tensions(torque, nuisance, 0.0)
        entering = pull + behind
        wheel = entering[0] if self.wheel == "entry" else behind[-1]
        stiffness = self.drive.belt.axial_stiffness * np.exp(nuisance.get("belt_modulus", 0.0))
        creep = self.creep(torque, np.zeros_like(torque), nuisance)
        return np.asarray((entering - wheel) / stiffness + _IN_CREEP * creep)


def _compression(table: CreepTable) -> float:
    """Compression of the lagging over the radius, per tension [1/N]."""
    arc = table.arc
    return arc.compression_compliance / (arc.width * arc.radius**2)


def speed_model(plan: LearnPlan, pulleys: tuple[TagChoice, ...], top: float) -> SpeedModel:
    """Return the model of a drive; `top` is the largest torque over the rated one [-]."""
    drive, case = plan.drive, plan.drive.load_case()
    names = tuple(choice.pulley for choice in pulleys)
    rated = tuple(_rated_pull(choice, drive) for choice in pulleys)
    take_up = case.tensions[names[-1]].exit
    tables = []
    beyond = 0.0
    for name, pull in reversed(list(zip(names, rated, strict=True))):
        low, high = 0.5 * take_up, 1.5 * take_up + 1.1 * beyond * top
        tables.append(creep_table(drive, name, round(low, 3), round(high, 3)))
        beyond += pull
    falls = 0.5 if plan.take_up == "fixed" else 0.0
    return SpeedModel(drive, names, rated, take_up, falls, plan.wheel, tuple(reversed(tables)))


def _rated_pull(choice: TagChoice, drive: Drive) -> float:
    """Return the effective tension at rated torque [N]."""
    radius = running_radius(drive, choice.pulley)
    torque = (choice.rated_torque or 0.0) * choice.motors * (choice.gear_ratio or 1.0)
    return torque * choice.gear_efficiency / radius


def running_radius(drive: Drive, pulley: str) -> float:
    """Return the radius at which the belt runs over the unloaded lagging [m]."""
    from wraparc.arc import WrapArc

    arc = WrapArc.of(drive, drive.pulley(pulley), drive.load_case())
    return arc.radius + arc.offset
