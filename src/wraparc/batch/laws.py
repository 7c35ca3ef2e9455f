"""Many friction laws in flat arrays, as a batch reads them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from wraparc.arrays import Array, Flags, Integers
from wraparc.batch.traction import Laws, laws_of
from wraparc.drive.pitch import counts_shear
from wraparc.friction import LAGGING_SHEAR, FrictionLaw
from wraparc.friction.compact import CompactLaw

nan = float("nan")


@dataclass(frozen=True, eq=False)
class LawBank:
    """Laws in the numeric form that the solvers read, one after the other.

    Attributes
    ----------
    kind
        Kind of each law, shape (m,).
    numbers
        Edges, coefficients and slips of every law in one array.
    places
        Where they begin and how many there are, (edges, n, coefficients, n, slips, n) of each law,
        shape (m, 6).
    onset_compliance
        Slip per shear stress before the limit of an elastic-plastic law, shape (m,) [m/Pa].
    steepest_fall
        Steepest fall of friction with slip, <= 0, shape (m,) [1/m].
    tested
        Lowest and highest tested pressure and largest tested slip, nan without a tested range,
        shape (m, 3) [Pa, Pa, m].
    tested_speed
        Slip speed of the tests, nan where it is not stated, shape (m,) [m/s].
    with_shear
        Whether the slip of each law includes the shear of its lagging, shape (m,).
    """

    kind: Integers
    numbers: Array
    places: Integers
    onset_compliance: Array
    steepest_fall: Array
    tested: Array
    tested_speed: Array
    with_shear: Flags

    def __len__(self) -> int:
        return len(self.kind)

    @classmethod
    def of(cls, laws: Sequence[FrictionLaw]) -> LawBank:
        """Return the bank of some laws."""
        compact = [law.compact() for law in laws]
        numbers, places = _packed(compact)
        return cls(
            kind=np.array([law.kind for law in compact], dtype=np.int64),
            numbers=numbers,
            places=places,
            onset_compliance=np.array([law.onset_compliance for law in compact], dtype=float),
            steepest_fall=np.array([law.steepest_fall() for law in laws], dtype=float),
            tested=np.array([tested_ends(law) for law in laws], dtype=float).reshape(-1, 3),
            tested_speed=np.array([_tested_speed(law) for law in laws], dtype=float),
            with_shear=np.array([counts_shear(law, LAGGING_SHEAR) is True for law in laws], bool),
        )

    def traction(self, law: Integers) -> Laws:
        """Traction of rows that each have the place of their law; the laws are of one kind."""
        used, place = np.unique(law, return_inverse=True)
        return laws_of([self.compact(int(i)) for i in used], place)

    def compact(self, index: int) -> CompactLaw:
        """One law as the solvers read it."""
        e, ne, c, nc, s, ns = self.places[index].tolist()
        v = self.numbers
        parts = (v[e : e + ne], v[c : c + nc], v[s : s + ns])
        edges, coefficients, slips = (tuple(part.tolist()) for part in parts)
        onset = float(self.onset_compliance[index])
        return CompactLaw(int(self.kind[index]), edges, coefficients, slips, onset)

    def take(self, index: Integers) -> LawBank:
        """Return the bank of some of the laws, in the order asked for."""
        numbers, places = _packed([self.compact(int(i)) for i in index])
        return LawBank(
            kind=self.kind[index],
            numbers=numbers,
            places=places,
            onset_compliance=self.onset_compliance[index],
            steepest_fall=self.steepest_fall[index],
            tested=self.tested[index],
            tested_speed=self.tested_speed[index],
            with_shear=self.with_shear[index],
        )


def tested_ends(law: FrictionLaw) -> tuple[float, float, float]:
    """Least and largest pressure [Pa] and largest slip [m] tested; nan where nothing was."""
    t = law.tested
    return (nan, nan, nan) if t is None else (t.pressure_min, t.pressure_max, t.slip_max)


def _tested_speed(law: FrictionLaw) -> float:
    speed = law.tested.slip_speed if law.tested is not None else None
    return nan if speed is None else speed


def _packed(laws: Sequence[CompactLaw]) -> tuple[Array, Integers]:
    parts = [np.asarray(p, float) for c in laws for p in (c.edges, c.coefficients, c.slips)]
    sizes = np.array([len(p) for p in parts], dtype=np.int64)
    starts = np.concatenate([[0], np.cumsum(sizes)[:-1]]) if parts else sizes
    numbers = np.concatenate(parts) if parts else np.empty(0)
    return numbers, np.stack([starts, sizes], axis=1).reshape(-1, 6).astype(np.int64)
