"""Several drives on one belt: how the load divides, the speeds needed, motors, maps."""

from wraparc.train.curve import Mark, MarkKind, ShareCurve, share_curve
from wraparc.train.motors import (
    FluidCoupling,
    Induction,
    Motor,
    TorqueFollower,
    VariableSpeed,
)
from wraparc.train.result import CaseResult, MemberResult, MotorPoint, TrainResult, TrainStatus
from wraparc.train.share_map import ShareMap, share_map
from wraparc.train.solve import solve_train
from wraparc.train.train import Division, Motors, Pulls, Shares, Speeds, Train, TrainCase
from wraparc.train.walk import Axis
from wraparc.train.what_if import what_if

__all__ = [
    "Axis",
    "CaseResult",
    "Division",
    "FluidCoupling",
    "Induction",
    "Mark",
    "MarkKind",
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
    "TrainCase",
    "TrainResult",
    "TrainStatus",
    "VariableSpeed",
    "share_curve",
    "share_map",
    "solve_train",
    "what_if",
]
