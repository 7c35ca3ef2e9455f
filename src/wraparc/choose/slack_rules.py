"""What the safety against gross slip and a design standard ask of the slack side."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np

from wraparc.arc import solve
from wraparc.arrays import Array, Flags
from wraparc.batch import Setting
from wraparc.batch.sliding import LoadedRows, tight_at_sliding
from wraparc.checks.design_standard import asked
from wraparc.checks.least_tension import figures
from wraparc.choose.search import Grid, Search
from wraparc.drive import LoadCase
from wraparc.drive.pull import given_up, rises_of


def gross_slip_slack(search: Search, grid: Grid, case: LoadCase, condition: int) -> Array:
    """Least tension at the take-up with the safety factor on gross slip, by design [N].

    As `wraparc.checks` judges it: the pull of the whole drive times the factor just does not slide
    the belt with its slack side held (gravity take-up), or the sum of both sides (fixed take-up).
    0 without a pull, inf where no tension carries it.
    """
    tensions = case.tensions[search.pulley]
    pull, tight = abs(tensions.effective), max(tensions.entry, tensions.exit)
    if pull == 0.0:
        return np.zeros(len(grid))
    factor = search.drive.criteria.safety.of(case.kind)
    names = [p.name for p in search.drive.pulleys]
    pulls = np.array([[case.tensions[name].effective] for name in names])
    lost = given_up(pulls, names, search.drive.criteria.take_up)
    rise = rises_of(pulls, names.index(search.pulley), lost)[0][0]
    lifted = tight - search.drive.take_up_tension(case) + (factor - 1.0) * float(rise)
    own = replace(grid, slack=np.full(len(grid), np.nan))  # each by the tensions of the drive
    arcs = own.arcs(case, condition)
    of = LoadedRows.of(arcs, setting=Setting.PRECISE)
    found = (
        tight_at_sliding(of, np.full(len(grid), factor * pull)) + arcs.centrifugal_force - lifted
    )
    return np.where(np.isnan(found), np.inf, found)


def standard_slack(search: Search, grid: Grid, case: LoadCase, condition: int) -> Array:
    """Tension at the take-up that the design standard asks for, by design [N]; 0 for none."""
    offset = slack_offset(search, case)

    def least(lagging: int, wrap_angle: float) -> float:
        tension, rule = _asked(search, case, lagging, wrap_angle)
        return tension + offset if rule else 0.0

    return _by_design(search, grid, condition, least)


def standard_asks(search: Search, grid: Grid, design: int) -> tuple[float, str]:
    """Largest tension at the take-up that the standard asks of a design [N], and its words."""
    wrap_angle, count = float(grid.wrap_angle[design]), len(search.laggings)
    found = [(0.0, "")]
    for condition in range(len(search.conditions)):
        lagging = int(grid.places[0, design]) + condition * count
        for case in search.drive.load_cases:
            tension, rule = _asked(search, case, lagging, wrap_angle)
            if rule:
                found.append((tension + slack_offset(search, case), rule))
    return max(found)


def below_standard(search: Search, grid: Grid, slack: Array) -> Flags:
    """Whether designs with a tension at the take-up [N] stand below the design standard."""
    asked_for = np.zeros(len(grid))
    for condition in range(len(search.conditions)):
        for case in search.drive.load_cases:
            asked_for = np.maximum(asked_for, standard_slack(search, grid, case, condition))
    return slack < asked_for * (1.0 - 1e-9)


def inapplicable(search: Search, grid: Grid, design: int) -> str:
    """Why a standard that was chosen says nothing on a design; empty where it does, or none was."""
    criteria, wrap_angle = search.drive.criteria, float(grid.wrap_angle[design])
    if not criteria.standard.name:
        return ""
    surface = search.conditioned()[int(grid.places[0, design])]
    rule = asked(criteria.standard, criteria.take_up, surface, wrap_angle)
    return "" if rule is None or not rule.why_not else f"{rule.rule}, {rule.why_not}"


def slack_offset(search: Search, case: LoadCase) -> float:
    """Tension at the take-up of the drive less that of the slack side of the pulley [N]."""
    t = case.tensions[search.pulley]
    return search.drive.take_up_tension(case) - min(t.entry, t.exit)


def sag_slack(search: Search, case: LoadCase) -> float:
    """Tension at the take-up that the sag of the belt asks for, 0 where it is no limit [N]."""
    sag = search.limits.sag
    if sag is None:
        return 0.0
    return sag.tension + search.drive.take_up_tension(case) - search.drive.slack_end(case)


def others_slack(search: Search) -> float:
    """Tension at the take-up that the other pulleys ask for, every one pulling as it does [N].

    As `wraparc.checks.least_tension` has it; inf where no tension keeps their checks.
    """
    drive = search.drive
    if len(drive.pulleys) == 1:
        return 0.0
    asked_for = figures(solve(drive, raise_on_failure=False), drive)
    others = (f for f in asked_for if f.place.pulley not in ("", search.pulley))
    return max((f.tension for f in others if f.binding and f.at_least), default=0.0)


def _asked(search: Search, case: LoadCase, lagging: int, wrap_angle: float) -> tuple[float, str]:
    criteria = search.drive.criteria
    pull = abs(case.tensions[search.pulley].effective)
    pull *= criteria.standard.start_factor if case.kind == "running" else 1.0
    surface = search.conditioned()[lagging]
    rule = asked(criteria.standard, criteria.take_up, surface, wrap_angle)
    if rule is None:
        return 0.0, ""
    if math.isnan(rule.wrap_factor):  # a rule that binds and cannot be applied is never kept
        return (math.inf, rule.rule) if criteria.standard.binding else (0.0, "")
    return rule.wrap_factor * pull, rule.rule


def _by_design(
    search: Search,
    grid: Grid,
    condition: int,
    least: Callable[[int, float], float],
) -> Array:
    """Return a number for each design, found once for those that do not differ in it."""
    lagging = grid.places[0] + condition * len(search.laggings)
    keys = np.stack([lagging.astype(float), grid.wrap_angle])
    different, place = np.unique(keys, axis=1, return_inverse=True)
    found = np.array([least(int(lag), wrap_angle) for lag, wrap_angle in different.T.tolist()])
    return np.asarray(found[place.ravel()])
