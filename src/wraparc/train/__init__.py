"""Several drives on one belt: how the load divides, the speeds needed, motors, maps.

Modules are imported when a name of theirs is first used: to read a file takes only descriptions.
"""

from typing import TYPE_CHECKING

from wraparc.lazily import offer

if TYPE_CHECKING:
    from wraparc.train.batch import solve_train_batch as solve_train_batch
    from wraparc.train.batch_result import TRAIN_STATUSES as TRAIN_STATUSES
    from wraparc.train.batch_result import DrumColumns as DrumColumns
    from wraparc.train.batch_result import TrainBatchResult as TrainBatchResult
    from wraparc.train.change import what_if as what_if
    from wraparc.train.conveyed import conveyor_states as conveyor_states
    from wraparc.train.conveyed import states_of as states_of
    from wraparc.train.curve import Mark as Mark
    from wraparc.train.curve import MarkKind as MarkKind
    from wraparc.train.curve import ShareCurve as ShareCurve
    from wraparc.train.curve import share_curve as share_curve
    from wraparc.train.grid import ShareMap as ShareMap
    from wraparc.train.grid import share_map as share_map
    from wraparc.train.matching import Change as Change
    from wraparc.train.matching import Matching as Matching
    from wraparc.train.matching import match_drives as match_drives
    from wraparc.train.motors import FluidCoupling as FluidCoupling
    from wraparc.train.motors import Induction as Induction
    from wraparc.train.motors import Motor as Motor
    from wraparc.train.motors import TorqueFollower as TorqueFollower
    from wraparc.train.motors import VariableSpeed as VariableSpeed
    from wraparc.train.result import CaseResult as CaseResult
    from wraparc.train.result import MemberResult as MemberResult
    from wraparc.train.result import MotorPoint as MotorPoint
    from wraparc.train.result import TrainResult as TrainResult
    from wraparc.train.result import TrainStatus as TrainStatus
    from wraparc.train.solve import solve_train as solve_train
    from wraparc.train.train import Division as Division
    from wraparc.train.train import Motors as Motors
    from wraparc.train.train import Pulls as Pulls
    from wraparc.train.train import Shares as Shares
    from wraparc.train.train import Speeds as Speeds
    from wraparc.train.train import Train as Train
    from wraparc.train.train import TrainCase as TrainCase
    from wraparc.train.walk import Axis as Axis

_MODULES = {
    "batch": "solve_train_batch",
    "batch_result": "TRAIN_STATUSES DrumColumns TrainBatchResult",
    "conveyed": "conveyor_states states_of",
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
__all__, __getattr__, __dir__ = offer(__name__, _MODULES)
