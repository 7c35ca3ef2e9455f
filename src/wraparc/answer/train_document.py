"""Trains as plain data for JSON and CSV: SI numbers under the names of the glossary."""

import csv
import io
from typing import Any

from wraparc.answer.checks_table import verdict_document
from wraparc.answer.least_tension import least_data
from wraparc.answer.reserve_check import judge_uncertain
from wraparc.answer.train_words import matching_verdict
from wraparc.answer.verdict_data import verdict_object
from wraparc.answer.words import action_of
from wraparc.checks import TRAIN_BALANCE
from wraparc.train import CaseResult, Matching, MemberResult, ShareCurve, ShareMap, TrainResult
from wraparc.units import in_units
from wraparc.version import __version__

Data = dict[str, Any]


def train_document(
    result: TrainResult, *, search: bool = True, reserve: bool = False, probability: bool = False
) -> Data:
    """Return what a solved train has besides its arcs.

    `search` is as `train_verdict` has it, `reserve` and `probability` as `result_document`.
    """
    action = action_of(result, search=search)
    return {
        "solved": result.solved,
        "verdict": verdict_document(
            judge_uncertain(result),
            action,
            result if reserve else None,
            result if probability else None,
        ),
        "least_tension": least_data(result),
        "load_cases": [_case_data(case) for case in result],
    }


def matching_document(
    result: TrainResult, matching: Matching, over_load: ShareMap | None = None, *, file: str = ""
) -> Data:
    """Return how the drives of a train must be matched."""
    return {
        "format": 2,
        "program": {"name": "wraparc", "version": __version__},
        "file": file,
        "verdict": verdict_object(matching_verdict(result, matching), in_units),
        "drive": matching.case.members[matching.drive].name,
        "load_case": _case_data(matching.case),
        "equal_shares": _case_data(matching.equal),
        "curves": [_curve_data(c) for c in (matching.trim, matching.diameter, matching.load)],
        "changes": [
            {
                "pulley": change.pulley,
                "wear": change.wear,
                "condition": change.lagging.condition if change.lagging else "",
                "notes": list(change.lagging.notes) if change.lagging else [],
                "after": _case_data(change.after),
            }
            for change in matching.changes
        ],
        **({} if over_load is None else {"map": _map_data(over_load)}),
    }


def curve_csv(curve: ShareCurve) -> str:
    """Return a curve as CSV: the axis, shares, creeps in metres and the loss ratio."""
    names = [m.name for m in curve.case.members]
    page = io.StringIO()
    out = csv.writer(page, lineterminator="\n")
    heads = [f"share {n}" for n in names] + [f"exit_creep {n} [m]" for n in names]
    out.writerow([curve.quantity, *heads, "loss_ratio"])
    for value, shares, creeps, loss in zip(
        curve.values, curve.shares, curve.creeps, curve.loss_ratio, strict=True
    ):
        out.writerow([f"{v + 0.0:.9g}" for v in (value, *shares, *creeps, loss)])
    return page.getvalue()


def _case_data(case: CaseResult) -> Data:
    return {
        "load_case": case.case.name,
        "status": case.status.name.lower(),
        "reason": case.reason,
        "belt_speed": case.belt_speed,
        "power_loss": case.power_loss,
        "loss_ratio": case.loss_ratio,
        "motor_losses": case.motor_losses,
        "drives": [_member_data(case, i, m) for i, m in enumerate(case.members)],
        "sensitivity": [list(row) for row in case.sensitivity],
        "other_splits": [list(split) for split in case.other_splits],
        "tension_error": case.tension_error,
        "speed_error": case.speed_error,
        "error_floor": TRAIN_BALANCE,
    }


def _member_data(case: CaseResult, index: int, m: MemberResult) -> Data:
    return {
        "pulley": m.name,
        "status": m.arc.status.name.lower(),
        "side": m.arc.arc.side_of_belt,
        "wrap_angle": m.arc.arc.wrap_angle,
        **m.scalars(),
        "share_sensitivity": case.share_per_trim(index),
        "entry_tension": m.arc.entry_tension,
        "exit_tension": m.arc.exit_tension,
        "exit_creep": m.arc.exit_creep,
        "entry_creep_ratio": m.arc.entry_creep_ratio,
        "power_loss": m.arc.energy.power_loss,
    }


def _curve_data(curve: ShareCurve) -> Data:
    names = [m.name for m in curve.case.members]
    return {
        "axis": curve.quantity,
        "values": curve.values.tolist(),
        "shares": {n: curve.shares[:, i].tolist() for i, n in enumerate(names)},
        "exit_creep": {n: curve.creeps[:, i].tolist() for i, n in enumerate(names)},
        "loss_ratio": curve.loss_ratio.tolist(),
        "marks": [
            {
                "what": mark.kind.name.lower(),
                "pulley": names[mark.drive],
                "at": mark.value,
                "shares": list(mark.shares),
                "loss_ratio": mark.loss_ratio,
            }
            for mark in curve.marks
        ],
    }


def _map_data(over: ShareMap) -> Data:
    names = [m.name for m in over.case.members]
    return {
        "across": over.across.value,
        "down": over.down.value,
        "x": over.x.tolist(),
        "y": over.y.tolist(),
        "shares": {n: over.shares[:, :, i].tolist() for i, n in enumerate(names)},
    }
