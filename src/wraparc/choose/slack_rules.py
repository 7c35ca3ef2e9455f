"""What the safety against gross slip and a binding design standard ask of the slack side."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from wraparc.arc import WrapArc
from wraparc.checks.design_standard import asked
from wraparc.checks.gross_slip import Grip
from wraparc.choose.search import Grid, Search
from wraparc.drive import LoadCase

Array = NDArray[np.float64]


def gross_slip_slack(search: Search, grid: Grid, case: LoadCase, condition: int) -> Array:
    """Least slack-side tension with the safety factor on gross slip, by design [N].

    As `wraparc.checks` judges it: the pull times the factor is just carried at gross slip with the
    slack side held (gravity take-up), or the sum of both sides (fixed take-up). 0 without a pull,
    inf where no tension carries it.
    """
    tensions = case.tensions[search.pulley]
    pull = abs(tensions.effective)
    factor = search.drive.criteria.safety.of(case.kind)

    def least(lagging: int, diameter: float, wrap_angle: float, thickness: float) -> float:
        law = search.conditioned()[lagging]
        arc = WrapArc(
            law=law.law,
            entry_tension=tensions.entry,
            exit_tension=tensions.exit,
            diameter=diameter,
            wrap_angle=wrap_angle,
            width=search.drive.belt.width,
            axial_stiffness=search.drive.belt.axial_stiffness,
            thickness=thickness,
            shear_modulus=law.shear_modulus,
            compression_modulus=law.compression_modulus,
            overrun=search.base.overrun,
            recovery=search.base.recovery,
        )
        tight = Grip(arc).tight_for(factor * pull)
        if search.drive.criteria.take_up.fixed:
            return tight - 0.5 * (factor + 1.0) * pull
        return tight - factor * pull

    return _by_design(search, grid, condition, least) if pull > 0.0 else np.zeros(len(grid))


def standard_slack(search: Search, grid: Grid, case: LoadCase, condition: int) -> Array:
    """Slack-side tension that a binding design standard asks for, by design [N]; 0 for none."""

    def least(lagging: int, _diameter: float, wrap_angle: float, _thickness: float) -> float:
        return _asked(search, case, lagging, wrap_angle)[0]

    if not search.drive.criteria.standard.binding:
        return np.zeros(len(grid))
    return _by_design(search, grid, condition, least)


def standard_asks(search: Search, grid: Grid, design: int) -> tuple[float, str]:
    """Largest slack-side tension that the design standard asks of a design [N], and its words."""
    wrap_angle, count = float(grid.wrap_angle[design]), len(search.laggings)
    return max(
        _asked(search, case, int(grid.places[0, design]) + condition * count, wrap_angle)
        for condition in range(len(search.conditions))
        for case in search.drive.load_cases
    )


def _asked(search: Search, case: LoadCase, lagging: int, wrap_angle: float) -> tuple[float, str]:
    criteria = search.drive.criteria
    pull = abs(case.tensions[search.pulley].effective)
    pull *= criteria.standard.start_factor if case.kind == "running" else 1.0
    surface = search.conditioned()[lagging]
    rule = asked(criteria.standard, criteria.take_up, surface, wrap_angle)
    if rule is None or math.isnan(rule.wrap_factor):
        return 0.0, ""
    return rule.wrap_factor * pull, rule.rule


def _by_design(
    search: Search,
    grid: Grid,
    condition: int,
    least: Callable[[int, float, float, float], float],
) -> Array:
    """Return a number for each design, found once for those that do not differ in it."""
    lagging = grid.places[0] + condition * len(search.laggings)
    softens = np.array([lag.law.steepest_fall() < 0.0 for lag in search.laggings])
    # only where friction falls past its peak does the thickness tell
    thickness = np.where(softens[grid.places[0]], grid.thickness, 0.0)
    keys = np.stack([lagging.astype(float), grid.diameter, grid.wrap_angle, thickness])
    different, place = np.unique(keys, axis=1, return_inverse=True)
    found = np.array([least(int(lag), d, phi, h) for lag, d, phi, h in different.T.tolist()])
    return np.asarray(found[place.ravel()])
