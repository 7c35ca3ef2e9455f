"""Many trains by column: one train, some of its numbers different from row to row."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from math import isnan
from typing import Any

import numpy as np

from wraparc.arc.wrap_arc import of_belt
from wraparc.arrays import Array, Integers
from wraparc.batch.arcs import Arcs
from wraparc.batch.laws import LawBank
from wraparc.drive.belt_mass import in_width, masses_at
from wraparc.drive.pitch import centrifugal_force, pitch_offset
from wraparc.train.motor_rows import MotorRows
from wraparc.train.motors import TorqueFollower
from wraparc.train.train import Division, Motors, Shares, Speeds, Train

Which = slice | Integers


@dataclass(frozen=True, eq=False, kw_only=True)
class Followers:
    """A drive whose torque follows another one.

    Attributes
    ----------
    master
        Its place.
    ratio
        Of the torques, shape (n,) [-].
    """

    master: int
    ratio: Array


@dataclass(frozen=True, eq=False, kw_only=True)
class TrainRows:
    """Trains of the same pulleys, in one load case each.

    Attributes
    ----------
    train
        The train that they come from, with that load case alone and no condition left.
    whole
        What they have once, by column, shape (n,) each [SI]: ``entry_tension``, ``exit_tension``,
        ``belt_width``, ``belt_modulus``, ``belt_speed`` (nan if unknown).
    drums
        What every drum has, by column, shape (n, drums) each [SI]: ``diameter``, ``wrap_angle``,
        ``overrun`` ..., ``run`` (the rise of tension before it), ``nominal_diameter``.
    pulls
        Effective tensions where they are given, shape (n, drums) [N].
    speeds
        Speeds of the drums where they are held, shape (n, drums) [rad/s].
    absolute
        Whether the belt speed follows from them.
    motors
        What turns the drums otherwise.
    bank
        Their friction laws, a pulley each, unscaled.
    """

    train: Train
    whole: Mapping[str, Array]
    drums: Mapping[str, Array]
    pulls: Array | None = None
    speeds: Array | None = None
    absolute: bool = False
    motors: tuple[MotorRows | Followers, ...] = ()
    bank: LawBank

    def __len__(self) -> int:
        return len(self.whole["entry_tension"])

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the pulleys."""
        return tuple(p.name for p in self.train.pulleys)

    def rows(self, which: Which) -> TrainRows:
        """Return some of the trains."""

        def some(value: Array | None) -> Array | None:
            return None if value is None else value[which]

        return replace(
            self,
            whole={k: v[which] for k, v in self.whole.items()},
            drums={k: v[which] for k, v in self.drums.items()},
            pulls=some(self.pulls),
            speeds=some(self.speeds),
            motors=tuple(
                replace(m, ratio=m.ratio[which]) if isinstance(m, Followers) else m.rows(which)
                for m in self.motors
            ),
        )

    @property
    def runs(self) -> Array:
        """Rise of tension from each pulley to the next, shape (n, drums - 1) [N]."""
        return self.drums["run"][:, 1:]

    @property
    def total(self) -> Array:
        """Sum of T1 - T2 over all pulleys, shape (n,) [N]."""
        ends = self.whole["entry_tension"] - self.whole["exit_tension"]
        return np.asarray(ends + self.runs.sum(axis=1))

    @property
    def lift(self) -> Array:
        """M v^2 of the belt, 0 where its mass or its speed is not known, shape (n,) [N]."""
        which = np.zeros(len(self), dtype=np.intp)
        mass = masses_at([self.train.belt], which, self.whole["belt_width"])
        return np.nan_to_num(centrifugal_force(mass, self.whole["belt_speed"]))

    @property
    def light_stiffness(self) -> Array:
        """EA + m v^2, which goes with tensions above m v^2, shape (n,) [N]."""
        return self.stiffness + self.lift

    @property
    def offsets(self) -> Array:
        """Offset e of the tension member at every drum, 0 where not known, shape (drums,) [m]."""
        belt = self.train.belt
        return np.array([pitch_offset(belt, p.side) or 0.0 for p in self.train.pulleys])

    @property
    def stiffness(self) -> Array:
        """EA of the belt, shape (n,) [N]."""
        return self.whole["belt_modulus"] * self.whole["belt_width"]

    def arcs(self) -> Arcs:
        """Return their arcs, drum by drum of row by row, at the entry tension everywhere.

        Tensions are those above m v^2.
        """
        n, count = len(self), len(self.names)

        def spread(value: Array) -> Array:
            return np.repeat(value, count)

        entry = spread(self.whole["entry_tension"] - self.lift)
        flat: dict[str, Any] = {
            name: self.drums[name].ravel()
            for name in (
                "diameter", "wrap_angle", "lagging_thickness", "shear_modulus",
                "compression_modulus", "wear_coefficient", "overrun", "creep_limit",
            )
        }  # fmt: skip
        covers = [
            of_belt(self.train.belt, p.side, p.lagging.law)["cover_compliance"]
            for p in self.train.pulleys
        ]
        recovery = np.array([float(p.recovery) for p in self.train.pulleys])
        return Arcs(
            laws=self.bank,
            law=np.tile(np.arange(count), n),
            entry_tension=entry,
            exit_tension=entry.copy(),
            belt_width=spread(self.whole["belt_width"]),
            belt_modulus=spread(self.whole["belt_modulus"]),
            belt_speed=np.full(n * count, np.nan),
            recovery=np.tile(recovery, n),
            pitch_offset=np.tile(self.offsets, n),
            cover_compliance=np.tile(np.array(covers), n),
            centrifugal_force=np.zeros(n * count),
            **flat,
        )

    def row(self, i: int) -> Train:
        """Return the train of one row, as the solver of one train takes it."""
        one = {name: float(v[i]) for name, v in self.whole.items()}
        of_drums = {name: v[i].tolist() for name, v in self.drums.items()}
        belt = replace(
            in_width(self.train.belt, one["belt_width"]),
            modulus=one["belt_modulus"],
            speed=_known(one["belt_speed"]),
        )
        pulleys = []
        for k, old in enumerate(self.train.pulleys):
            at = {name: values[k] for name, values in of_drums.items()}
            lagging = replace(
                old.lagging,
                law=old.lagging.law.scaled(at["friction_factor"], at["slip_factor"]),
                thickness=at["lagging_thickness"],
                shear_modulus=at["shear_modulus"],
                compression_modulus=at["compression_modulus"],
                wear_coefficient=_known(at["wear_coefficient"]),
            )
            made = replace(
                old,
                diameter=at["diameter"],
                wrap_angle=at["wrap_angle"],
                overrun=_known(at["overrun"]),
                creep_limit=at["creep_limit"],
                lagging=lagging,
            )
            pulleys.append(made)
        case = replace(
            self.train.cases[0],
            entry_tension=one["entry_tension"],
            exit_tension=one["exit_tension"],
            runs=tuple(self.runs[i].tolist()),
            division=self._division(i),
        )
        return replace(
            self.train,
            belt=belt,
            pulleys=tuple(pulleys),
            nominal_diameters=tuple(of_drums["nominal_diameter"]),
            cases=(case,),
        )

    def _division(self, i: int) -> Division:
        if self.pulls is not None:
            total = float(self.total[i])
            if total == 0.0:
                return self.train.cases[0].division
            return Shares(tuple((self.pulls[i] / total).tolist()))
        if self.speeds is not None:
            return Speeds(tuple(self.speeds[i].tolist()), absolute=self.absolute)
        return Motors(
            tuple(
                TorqueFollower(master=self.names[m.master], ratio=float(m.ratio[i]))
                if isinstance(m, Followers)
                else m.row(i)
                for m in self.motors
            )
        )


def _known(value: float) -> float | None:
    return None if isnan(value) else value
