"""Several drives on one belt: how the load divides, the speeds needed, motors, maps.

Modules are imported when a name of theirs is first used: to read a file takes only descriptions.
"""

import importlib
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from wraparc.train.batch import solve_train_batch
    from wraparc.train.batch_result import TRAIN_STATUSES, DrumColumns, TrainBatchResult
    from wraparc.train.change import what_if
    from wraparc.train.curve import Mark, MarkKind, ShareCurve, share_curve
    from wraparc.train.grid import ShareMap, share_map
    from wraparc.train.matching import Change, Matching, match_drives
    from wraparc.train.motors import (
        FluidCoupling,
        Induction,
        Motor,
        TorqueFollower,
        VariableSpeed,
    )
    from wraparc.train.result import CaseResult, MemberResult, MotorPoint, TrainResult, TrainStatus
    from wraparc.train.solve import solve_train
    from wraparc.train.train import Division, Motors, Pulls, Shares, Speeds, Train, TrainCase
    from wraparc.train.walk import Axis

__all__ = [
    "TRAIN_STATUSES",
    "Axis",
    "CaseResult",
    "Change",
    "Division",
    "DrumColumns",
    "FluidCoupling",
    "Induction",
    "Mark",
    "MarkKind",
    "Matching",
    "MemberResult",
    "Motor",
    "MotorPoint",
    "Motors",
    "Pulls",
    "ShareCurve",
    "ShareMap",
    "Shares",
    "Speeds",
    "TorqueFollower",
    "Train",
    "TrainBatchResult",
    "TrainCase",
    "TrainResult",
    "TrainStatus",
    "VariableSpeed",
    "match_drives",
    "share_curve",
    "share_map",
    "solve_train",
    "solve_train_batch",
    "what_if",
]

_MODULES = {
    "batch": "solve_train_batch",
    "batch_result": "TRAIN_STATUSES DrumColumns TrainBatchResult",
    "curve": "Mark MarkKind ShareCurve share_curve",
    "matching": "Change Matching match_drives",
    "motors": "FluidCoupling Induction Motor TorqueFollower VariableSpeed",
    "result": "CaseResult MemberResult MotorPoint TrainResult TrainStatus",
    "grid": "ShareMap share_map",
    "solve": "solve_train",
    "train": "Division Motors Pulls Shares Speeds Train TrainCase",
    "walk": "Axis",
    "change": "what_if",
}
_MODULE_OF = {name: module for module, names in _MODULES.items() for name in names.split()}


def __getattr__(name: str) -> object:
    if name not in _MODULE_OF:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value: object = getattr(importlib.import_module(f"{__name__}.{_MODULE_OF[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
