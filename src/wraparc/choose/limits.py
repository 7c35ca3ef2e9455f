"""How every design stands to every limit, in its worst load case and condition."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from wraparc.arrays import Array, Flags, Integers
from wraparc.batch.arcs import Arcs
from wraparc.choose.search import Grid, Search
from wraparc.choose.slack_rules import gross_slip_slack, sag_slack, standard_slack
from wraparc.drive import LoadCase

#: a value may pass its limit by this much, as a least tension meets its limit exactly [-]
TOLERANCE = 1e-6
#: stands for a tension that no belt has [N]
NO_TENSION = 1e12
#: limits in the order they are told
LIMITS = (
    "traction",
    "creep",
    "bond_stress",
    "creep_limit_margin",
    "tested_slip_margin",
    "gross_slip_margin",
    "tested_pressure",
    "gross_slip",
    "design_standard",
    "least_slack",
    "belt_sag",
    "other_pulleys",
    "belt_rating",
    "edge_tension",
    "least_pulley_diameter",
)
#: limits of what the solver answers
OF_THE_ARC = {"creep", "bond_stress", "creep_limit_margin", "tested_slip_margin",
              "gross_slip_margin"}  # fmt: skip


@dataclass(frozen=True, eq=False)
class Held:
    """How every design stands to one limit.

    Attributes
    ----------
    excess
        How far the worst case is beyond the limit, as a share of it: > 0 broken, nan where the
        limit does not apply, shape (n,) [-].
    value, limit
        What it is in the worst case and what is allowed [SI], shape (n,).
    where
        Place of the worst case: load case + condition * number of load cases, shape (n,).
    """

    excess: Array
    value: Array
    limit: Array
    where: Integers

    @property
    def broken(self) -> Flags:
        """Whether each design breaks it."""
        return self.excess > TOLERANCE


def feasible(held: Mapping[str, Held], n: int) -> Flags:
    """Whether each design keeps every limit, shape (n,)."""
    good = np.ones(n, dtype=bool)
    for one in held.values():
        good &= ~one.broken
    return good


def held_to(
    search: Search,
    grid: Grid,
    answers: Sequence[Mapping[str, Array]],
    shortage: Array,
) -> dict[str, Held]:
    """Return how the designs stand to each limit that the search has.

    Parameters
    ----------
    search, grid
        What is searched, and its designs with their slack-side tensions.
    answers
        Of the solver, by condition and load case.
    shortage
        Pull over the largest that a design could carry where it has no least tension [-], else 0.
    """
    limits, cases = search.limits, search.drive.load_cases
    n = len(grid)
    parts: dict[str, list[tuple[Array, Array]]] = {name: [] for name in LIMITS}
    for k, answer in enumerate(answers):
        condition, at = divmod(k, len(cases))
        _of_arc(search, parts, answer)
        if limits.tested_pressure:
            _of_pressure(parts["tested_pressure"], grid.arcs(cases[at], condition))
        _of_slack(search, grid, parts, cases[at], condition)
    if limits.rating is not None:
        for case in cases:
            parts["belt_rating"].append(_of_rating(search, grid, case))
    others = min(grid.others, NO_TENSION)
    for case in cases:
        for name, least in (("belt_sag", sag_slack(search, case)), ("other_pulleys", others)):
            if least > 0.0:
                parts[name].append((-grid.ends(case)[0], np.full(n, -least)))
    if limits.least_pulley_diameter:
        asked = _of_belts(search, grid, "least_pulley_diameter")
        # the other way round: what is allowed is the least
        parts["least_pulley_diameter"].append((-grid.diameter, -asked))
    if search.least_slack:
        parts["least_slack"].append((shortage, np.ones(n)))
    return {name: _of_parts(pairs, n) for name, pairs in parts.items() if pairs}


def _of_slack(
    search: Search,
    grid: Grid,
    parts: dict[str, list[tuple[Array, Array]]],
    case: LoadCase,
    condition: int,
) -> None:
    """Add what safety against gross slip and a binding standard ask of the slack side."""
    slack, _ = grid.ends(case)
    for name, rule in (("gross_slip", gross_slip_slack), ("design_standard", standard_slack)):
        if name == "design_standard" and not search.drive.criteria.standard.binding:
            continue
        least = rule(search, grid, case, condition)
        if least.any():
            parts[name].append((-slack, -np.minimum(least, NO_TENSION)))


def _of_arc(
    search: Search, parts: dict[str, list[tuple[Array, Array]]], answer: Mapping[str, Array]
) -> None:
    """Add what one load case in one condition says of the limits (value, limit); signs as there."""
    limits, n = search.limits, len(answer["solved"])
    solved = answer["solved"] > 0.0
    # a breakaway misses by the ratio it would have to carry over the largest it can
    gross = answer["gross_slip_margin"]
    beyond = np.where(gross > 0.0, 1.0 / np.where(gross > 0.0, gross, 1.0), np.inf)
    beyond = np.where(beyond > 1.0, beyond, 1.0 + 1e-3)
    parts["traction"].append((np.where(solved, 0.0, beyond), np.ones(n)))
    parts["creep"].append((np.abs(answer["exit_creep"]), np.full(n, search.creep_limit)))
    if limits.bond_stress is not None:
        stress = np.abs(answer["peak_shear_stress"])
        parts["bond_stress"].append((stress, np.full(n, limits.bond_stress)))
    for name in ("creep_limit_margin", "tested_slip_margin", "gross_slip_margin"):
        least = getattr(limits, name)
        if least is not None:
            parts[name].append((-answer[name], np.full(n, -least)))


def _of_pressure(parts: list[tuple[Array, Array]], arcs: Arcs) -> None:
    low, high, _ = arcs.laws.tested[arcs.law].T
    area = arcs.belt_width * arcs.diameter
    arcs = arcs.light()
    most = 2.0 * np.maximum(arcs.entry_tension, arcs.exit_tension) / area
    least = 2.0 * np.minimum(arcs.entry_tension, arcs.exit_tension) / area
    above, below = most / high - 1.0, low / least - 1.0
    # one number for both ends: the worse of them
    upper = ~(below > above)
    parts.append((np.where(upper, most, -least), np.where(upper, high, -low)))


def _of_rating(search: Search, grid: Grid, case: LoadCase) -> tuple[Array, Array]:
    share: Array | float | None = (search.limits.rating or {}).get(case.name)
    if share is None:
        momentary = np.nan_to_num(_of_belts(search, grid, "momentary_factor"), nan=1.0)
        share = 1.0 if case.kind == "running" else momentary
    tight = grid.ends(case)[1] / search.drive.belt.width
    return np.asarray(tight), share * _of_belts(search, grid, "rating")


def _of_belts(search: Search, grid: Grid, name: str) -> Array:
    values = [getattr(b, name) for b in search.belts]
    known: Array = np.array([np.nan if v is None else v for v in values], dtype=float)
    return np.asarray(known[grid.places[2]])


def _of_parts(pairs: list[tuple[Array, Array]], n: int) -> Held:
    """Worst of several (value, limit) pairs; negative ones are lower limits."""
    values = np.stack([v for v, _ in pairs])
    bounds = np.stack([b for _, b in pairs])
    with np.errstate(invalid="ignore", divide="ignore"):
        excess = np.where(
            bounds > 0.0, values / bounds - 1.0, 1.0 - np.abs(values) / np.abs(bounds)
        )
    ranked = np.where(np.isnan(excess), -np.inf, excess)
    where = np.argmax(ranked, axis=0)
    at = np.arange(n)
    return Held(
        excess=excess[where, at],
        value=np.abs(values[where, at]),
        limit=np.abs(bounds[where, at]),
        where=where.astype(np.int64),
    )
