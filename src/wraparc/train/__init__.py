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
from wraparc.train.solve import solve_train
from wraparc.train.train import Division, Motors, Pulls, Shares, Speeds, Train, TrainCase
from wraparc.train.walk import Axis

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
    "Shares",
    "Speeds",
    "TorqueFollower",
    "Train",
    "TrainCase",
    "TrainResult",
    "TrainStatus",
    "VariableSpeed",
    "share_curve",
    "solve_train",
]
