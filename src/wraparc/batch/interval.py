"""The far end of the 95 % interval of the creep, of many arcs under fitted laws.

What `wraparc.arc.interval` finds of one arc, with the same steps and the same direction: the slopes
of the creep over the peaks of the law from rows of one batch, and the laws at the ends in another.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from wraparc.arc.interval import step_of
from wraparc.arrays import Array, Flags, Integers
from wraparc.batch import row
from wraparc.batch.arcs import Arcs, present
from wraparc.batch.laws import LawBank
from wraparc.batch.scaled import solve_scaled
from wraparc.batch.setting import Setting
from wraparc.drive import Fit, knots_of, with_peaks
from wraparc.friction import FrictionLaw, PressureKnots


class Fitted(NamedTuple):
    """A law, and the statistics of its fit where it has some."""

    law: FrictionLaw
    fit: Fit | None

    @property
    def has_knots(self) -> bool:
        """Whether the statistics are of knots that the law has."""
        knots = knots_of(self.law)
        if self.fit is None or knots is None or not self.fit.knots:
            return False
        return all(0 <= place < len(knots.pressure) for place, _ in self.fit.knots)


def farthest_creeps(
    arcs: Arcs,
    laws: Sequence[Fitted],
    factors: tuple[Array, Array],
    setting: Setting = Setting.ENGINEERING,
) -> Array:
    """Return the largest creeps of the 95 % interval by the fits, magnitudes of shape (n,) [m].

    Parameters
    ----------
    arcs
        The arcs, solved ones.
    laws
        What the bank of the arcs was made of.
    factors
        Factors on the friction and on the slips of the laws, shape (n,) each [-].
    setting
        How accurately.

    Returns
    -------
    Infinite where the friction of that end does not carry the load, nan without statistics.
    """
    found = np.full(len(arcs), np.nan)
    for index in present(arcs.law):
        of = laws[index]
        if of.fit is not None and of.has_knots:
            which = np.flatnonzero(arcs.law == index)
            some = factors[0][which], factors[1][which]
            found[which] = _farthest(arcs.rows(which), of.law, of.fit, some, setting)
    return found


def _farthest(
    arcs: Arcs, law: FrictionLaw, fit: Fit, factors: tuple[Array, Array], setting: Setting
) -> Array:
    knots = knots_of(law)
    assert knots is not None  # noqa: S101 - see `Fitted.has_knots`
    peaks = np.array([getattr(knots, quantity)[place] for place, quantity in fit.knots])
    covariance, n = fit.log_covariance, len(arcs)
    steps = [step_of(fit, i) for i in range(len(peaks))]

    def moved(logs: Array) -> FrictionLaw:
        return with_peaks(law, dict(zip(fit.knots, (peaks * np.exp(logs)).tolist(), strict=True)))

    def creep_of(laws: Sequence[FrictionLaw], which: Integers, of: Integers) -> Array:
        some = replace(arcs.rows(which), laws=LawBank.of(laws), law=of)
        friction, slip = (factor[which] for factor in factors)
        solved = solve_scaled(some, friction, slip, setting=setting, parts=row.RATIO)
        return np.where(solved.solved, solved["exit_creep"], np.inf)

    felt = _felt(arcs, knots, [place for place, _ in fit.knots]) & (np.array(steps) != 0.0)
    rows, places = np.nonzero(felt)
    each = np.eye(len(peaks)) * steps
    there = creep_of(
        [law, *(moved(of) for of in each)],
        np.concatenate([np.arange(n), rows]),
        np.concatenate([np.zeros(n, np.int64), 1 + places]),
    )
    creep, slopes = there[:n], np.zeros((n, len(peaks)))
    with np.errstate(invalid="ignore"):
        slopes[rows, places] = (there[n:] - creep[rows]) / np.array(steps)[places]
    slopes = np.where(np.isfinite(slopes), slopes, 0.0)
    deviation = np.sqrt(np.maximum(np.einsum("ni,ij,nj->n", slopes, covariance, slopes), 0.0))
    wide = np.flatnonzero((deviation > 0.0) & np.isfinite(creep))
    farthest = np.abs(creep)
    if len(wide):
        length = fit.coverage_factor / deviation[wide] * np.sign(creep[wide])
        ways = length[:, None] * (slopes[wide] @ covariance)
        end = creep_of([moved(way) for way in ways], wide, np.arange(len(wide)))
        farthest[wide] = np.maximum(farthest[wide], np.abs(end))
    return farthest


def _felt(arcs: Arcs, knots: PressureKnots, places: Sequence[int]) -> Flags:
    """Return which of the fitted knots the pressures along arcs can feel, shape (n, fitted)."""
    area = 0.5 * arcs.belt_width * arcs.diameter
    ends = np.sort(np.stack([arcs.entry_tension, arcs.exit_tension]), axis=0)
    low, high = (ends - arcs.centrifugal_force) / area
    first = np.searchsorted(knots.pressure, low, side="right") - 2
    last = np.searchsorted(knots.pressure, high, side="right") + 1
    at = np.array(places)
    return np.asarray((first[:, None] <= at) & (at <= last[:, None]))
