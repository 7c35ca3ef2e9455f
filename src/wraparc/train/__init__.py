"""Several drives on one belt: how the load divides, the speeds needed, motors, maps."""

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

__all__ = [
    "CaseResult",
    "Division",
    "FluidCoupling",
    "Induction",
    "MemberResult",
    "Motor",
    "MotorPoint",
    "Motors",
    "Pulls",
    "Shares",
    "Speeds",
    "TorqueFollower",
    "Train",
    "TrainCase",
    "TrainResult",
    "TrainStatus",
    "VariableSpeed",
    "solve_train",
]
