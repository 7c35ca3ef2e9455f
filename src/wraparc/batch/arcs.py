"""Many wrap arcs by column: what a batch solves."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from wraparc.arc import WrapArc
from wraparc.arc.summary import overrun_coefficient
from wraparc.arrays import Array, Integers
from wraparc.batch.columns import (
    Column,
    columns_of,
    length_problems,
    read_column,
    refused,
    row_problem,
)
from wraparc.batch.laws import LawBank
from wraparc.drive import CREEP_LIMIT, Lagging, Pulley
from wraparc.drive.pitch import thin_belt
from wraparc.errors import InputError, Problem, name_remedy, shown
from wraparc.friction import FrictionLaw
from wraparc.glossary import GLOSSARY
from wraparc.units import display

nan = float("nan")

REQUIRED = (
    "entry_tension",
    "exit_tension",
    "diameter",
    "wrap_angle",
    "belt_width",
    "belt_modulus",
)
#: what a column is where the table does not have it; None takes it from the lagging
DEFAULTS: Mapping[str, float | None] = {
    "lagging_thickness": None,
    "shear_modulus": None,
    "compression_modulus": None,
    "wear_coefficient": None,
    "overrun": nan,
    "recovery": 1.0,
    "creep_limit": CREEP_LIMIT,
    "belt_speed": nan,
    "pitch_offset": 0.0,
    "cover_compliance": 0.0,
    "centrifugal_force": 0.0,
}
COLUMNS = (*REQUIRED, *DEFAULTS)
LAGGING = "lagging"

_POSITIVE = {*REQUIRED, "creep_limit", "shear_modulus", "compression_modulus"}
_RIGID = {"belt_modulus", "shear_modulus", "compression_modulus"}  # may be infinite
_MAY_BE_MISSING = {"overrun", "belt_speed", "wear_coefficient"}  # nan says so


def present(whole: NDArray[Any]) -> list[int]:
    """Return which whole numbers >= 0 there are; `np.unique` imports masked arrays first."""
    found: list[int] = np.flatnonzero(np.bincount(whole)).tolist()
    return found


@dataclass(frozen=True, eq=False, kw_only=True)
class Arcs:
    """Columns of arcs, each of shape (n,), and the laws they refer to.

    Attributes
    ----------
    laws
        Friction laws.
    law
        Law of each arc, its place in `laws`.
    entry_tension, exit_tension
        T1 and T2 [N].
    diameter, wrap_angle
        D over the lagging [m] and phi [rad].
    belt_width, belt_modulus
        B [m] and M [N/m]; M may be infinite.
    lagging_thickness, shear_modulus, compression_modulus
        h [m], G and E_c [Pa]; the moduli may be infinite.
    wear_coefficient
        Worn volume per frictional energy [m3/J], nan if unknown.
    overrun
        x_c [m], nan for the formula 1.25 delta sqrt(delta/R).
    recovery
        1 where the lagging recovers along the arc, 0 where it does not.
    creep_limit
        Creep that is accepted [m].
    belt_speed
        v [m/s], nan if unknown.
    pitch_offset
        Offset e of the tension member over the lagging, 0 where it is not known [m].
    cover_compliance
        h_b/G_b of the belt cover on the pulley, in series with the lagging [m/Pa].
    centrifugal_force
        m v^2, 0 where the mass of the belt is not known [N].
    """

    laws: LawBank
    law: Integers
    entry_tension: Array
    exit_tension: Array
    diameter: Array
    wrap_angle: Array
    belt_width: Array
    belt_modulus: Array
    lagging_thickness: Array
    shear_modulus: Array
    compression_modulus: Array
    wear_coefficient: Array
    overrun: Array
    recovery: Array
    creep_limit: Array
    belt_speed: Array
    pitch_offset: Array
    cover_compliance: Array
    centrifugal_force: Array

    def __len__(self) -> int:
        return len(self.law)

    def columns(self) -> dict[str, Array]:
        """Return the columns by name."""
        return {name: getattr(self, name) for name in COLUMNS}

    def rows(self, which: slice | Integers) -> Arcs:
        """Return some of the arcs; the laws are shared."""
        some: dict[str, Any] = {name: v[which] for name, v in self.columns().items()}
        return replace(self, law=self.law[which], **some)

    def by_kind(self) -> list[Integers]:
        """Rows of every kind of law that there is."""
        kind = self.laws.kind[self.law]
        return [np.flatnonzero(kind == k) for k in present(kind)]

    def arc(self, i: int, laws: Sequence[FrictionLaw]) -> WrapArc:
        """Return one of the arcs, with its law out of those that the bank was made of."""
        one = {name: float(column[i]) for name, column in self.columns().items()}

        def known(name: str) -> float | None:
            return None if math.isnan(one[name]) else one[name]

        return WrapArc(
            law=laws[int(self.law[i])],
            entry_tension=one["entry_tension"],
            exit_tension=one["exit_tension"],
            diameter=one["diameter"],
            wrap_angle=one["wrap_angle"],
            width=one["belt_width"],
            axial_stiffness=one["belt_modulus"] * one["belt_width"],
            thickness=one["lagging_thickness"],
            shear_modulus=one["shear_modulus"],
            compression_modulus=one["compression_modulus"],
            overrun=known("overrun"),
            recovery=bool(one["recovery"]),
            creep_limit=one["creep_limit"],
            belt_speed=known("belt_speed"),
            wear_coefficient=known("wear_coefficient"),
            pitch_offset=one["pitch_offset"],
            cover_compliance=one["cover_compliance"],
            centrifugal=one["centrifugal_force"],
        )

    def with_laws(self, used: Integers) -> Arcs:
        """Return the arcs with the bank of only the laws `used`, ascending places of theirs."""
        return replace(self, laws=self.laws.take(used), law=np.searchsorted(used, self.law))

    @property
    def axial_stiffness(self) -> Array:
        """EA = M B [N]."""
        return self.belt_modulus * self.belt_width

    @property
    def recovery_compliance(self) -> Array:
        """Kappa = 2 h/(B D R E_c), 0 without recovery [1/N]."""
        squeeze = self.lagging_thickness / self.compression_modulus
        area = self.belt_width * self.diameter * (0.5 * self.diameter)
        return np.where(self.recovery != 0.0, 2.0 * squeeze / area, 0.0)

    @property
    def compliance(self) -> Array:
        """1/EA' = 1/EA + kappa [1/N]."""
        return 1.0 / self.axial_stiffness + self.recovery_compliance

    @property
    def shear_compliance(self) -> Array:
        """h/G + h_b/G_b, without what the slip of the laws includes [m/Pa]."""
        apart = ~self.laws.with_shear[self.law]
        return apart * (self.lagging_thickness / self.shear_modulus) + self.cover_compliance

    @property
    def traction_width(self) -> Array:
        """Width of the same arc without thickness, B R/(R + e) [m]."""
        return self._thin()[2]

    @property
    def traction_wrap(self) -> Array:
        """Wrap angle of the same arc without thickness, phi R/(R + e) [rad]."""
        return self._thin()[1]

    def light(self) -> Arcs:
        """Return the same arcs without mass, of the tensions above m v^2."""
        lift = self.centrifugal_force
        return replace(
            self,
            entry_tension=self.entry_tension - lift,
            exit_tension=self.exit_tension - lift,
            centrifugal_force=np.zeros(len(self)),
        )

    def _thin(self) -> tuple[Array, Array, Array]:
        return thin_belt(0.5 * self.diameter, self.wrap_angle, self.belt_width, self.pitch_offset)

    def inputs(self) -> Array:
        """Numbers of every arc that a kernel reads, in the order of `row.INPUTS`, shape (n, 15)."""
        radius = 0.5 * self.diameter
        squeeze = self.lagging_thickness / self.compression_modulus
        by_formula, lift = np.isnan(self.overrun), self.centrifugal_force
        pitch, wrap, width = self._thin()
        tested = self.laws.tested[self.law]
        columns = (
            np.where(self.entry_tension >= self.exit_tension, 1.0, -1.0),
            pitch,
            wrap,
            width,
            self.compliance,
            self.shear_compliance,
            np.where(by_formula, 0.0, self.overrun),
            np.where(by_formula, overrun_coefficient(squeeze, radius), 0.0),
            self.entry_tension - lift,
            self.exit_tension - lift,
            self.creep_limit,
            tested[:, 0],
            tested[:, 1],
            tested[:, 2],
            self.laws.steepest_fall[self.law],
        )
        return np.ascontiguousarray(np.stack(columns, axis=1))


def arcs_of_table(table: Mapping[str, ArrayLike], laggings: Sequence[Lagging] | Lagging) -> Arcs:
    """Return checked arcs from a table of columns.

    Parameters
    ----------
    table
        Columns by their names in the glossary, as for `wraparc.batch.solve_batch` [SI].
    laggings
        The laggings.

    Raises
    ------
    InputError
        With every unknown or missing column and, column by column, the rows that cannot be.
    """
    some = [laggings] if isinstance(laggings, Lagging) else list(laggings)
    given = columns_of(table)
    problems = _unknown(given, len(some))
    if problems:
        raise InputError(problems)
    which_of = np.asarray(given.pop(LAGGING, 0))
    read = {name: read_column(raw, flags=name == "recovery") for name, raw in given.items()}
    shapes = {name: column.value.shape for name, column in read.items()}
    n, problems = length_problems({**shapes, LAGGING: which_of.shape})
    which, more = _lagging_column(which_of, some, n)
    columns: dict[str, Array] = {}
    for name in COLUMNS:
        column = read.get(name) or Column(_default(name, some, which, columns))
        more += _refused(name, column)
        shape = column.value.shape
        value = column.value if shape in ((), (1,), (n,)) else np.array(nan)  # told already
        columns[name] = np.broadcast_to(value, (n,)).copy()
    lift = columns["centrifugal_force"]
    tensions = np.minimum(columns["entry_tension"], columns["exit_tension"])
    flying = np.flatnonzero((lift >= tensions) & (tensions > 0.0)).tolist()
    if flying:
        told = display(float(lift[flying[0]]), "force")
        more.append(
            row_problem("centrifugal_force", flying, told, "must be less than both tensions")
        )
    if problems or more:
        raise InputError(problems + more)
    return Arcs(laws=LawBank.of([lag.law for lag in some]), law=which, **columns)


def _unknown(given: Mapping[str, Any], laggings: int) -> list[Problem]:
    known = (*COLUMNS, LAGGING)
    problems = [
        Problem(
            key=f"column {shown(name)}",
            message="no such column",
            remedy=name_remedy(name, known),
        )
        for name in given
        if name not in known
    ]
    needed = REQUIRED if laggings == 1 else (*REQUIRED, LAGGING)
    problems += [
        Problem(key=f"column {shown(name)}", message="missing", remedy=_meaning(name))
        for name in needed
        if name not in given
    ]
    if laggings == 0:
        problems.append(Problem(key="laggings", message="at least one lagging is needed"))
    return problems


def _meaning(name: str) -> str:
    if name == LAGGING:
        return "Say which of the laggings each row has, by name or by place from 0."
    return GLOSSARY[name].meaning


def _lagging_column(
    value: NDArray[Any], laggings: Sequence[Lagging], n: int
) -> tuple[Integers, list[Problem]]:
    names = [lag.name for lag in laggings]
    if value.shape not in ((), (1,), (n,)):
        return np.zeros(n, dtype=np.int64), []  # its length is a problem already
    if value.dtype.kind in "iu":
        which = np.broadcast_to(value, (n,)).astype(np.int64)
        bad = np.flatnonzero((which < 0) | (which >= len(names)))
        allowed = f"must be a place from 0 to {len(names) - 1}"
    else:
        place = {name: i for i, name in enumerate(names)}
        found = np.array([place.get(str(v), -1) for v in np.atleast_1d(value)], dtype=np.int64)
        which = np.broadcast_to(found, (n,)).copy()
        bad = np.flatnonzero(which < 0)
        allowed = f"must be one of {', '.join(map(shown, names[:10]))}"
    if not len(bad):
        return which, []
    text = shown(np.broadcast_to(value, (n,))[bad[0]].item())
    return np.zeros(n, dtype=np.int64), [row_problem(LAGGING, bad.tolist(), text, allowed)]


def _default(
    name: str, laggings: Sequence[Lagging], which: Integers, columns: Mapping[str, Array]
) -> Array:
    """A column that the table does not have; E_c by the thickness, which stands before it."""
    default = DEFAULTS[name]
    if default is not None:
        return np.array(default)
    if name == "compression_modulus":
        return compression_moduli(laggings, which, columns["lagging_thickness"])
    attribute = "thickness" if name == "lagging_thickness" else name
    of_lagging = [getattr(lag, attribute) for lag in laggings]
    return np.array([nan if v is None else v for v in of_lagging], dtype=float)[which]


def compression_moduli(laggings: Sequence[Lagging], which: Integers, thickness: Array) -> Array:
    """Return E_c of rows that each have the place of their lagging, at their thickness [Pa].

    See `Lagging.compression_modulus_at`.
    """
    found = np.empty(len(which))
    for i in present(which):
        rows = which == i
        found[rows] = laggings[i].compression_modulus_at(thickness[rows])
    return found


def _refused(name: str, column: Column) -> list[Problem]:
    """Problems of a column: what WrapArc refuses, for all rows at once."""
    value, missing = column.value, name in _MAY_BE_MISSING
    if name == "recovery":
        good, allowed = (value == 0.0) | (value == 1.0), "must be 1 or 0"
    else:
        least = 0.0
        if name == "overrun":  # negative is towards travel
            least = Pulley.LIMITS[name].least
        good = value > 0.0 if name in _POSITIVE else value >= least
        allowed = "must be more than 0" if name in _POSITIVE else f"must be at least {least:g}"
        if name not in _RIGID:
            good &= value < math.inf
            allowed += " and finite"
        if missing:
            good |= np.isnan(value)
            allowed += ", or nan where it is not known"
    quantity = GLOSSARY.get(name)
    dimension = quantity.dimension if quantity else None
    return refused(
        name, column, np.asarray(good), allowed, dimension=dimension, may_be_missing=missing
    )
