"""The wrap-arc problem: how a belt creeps, slips and hands over its tension on one pulley."""

from wraparc.arc.constant_friction import (
    ClassicalDrive,
    capstan_ratio,
    classical_drives,
    slipping_arc,
    wrap_factor,
)
from wraparc.arc.drive_solve import DriveResult, Method, solve
from wraparc.arc.paper_march import PaperMarch
from wraparc.arc.result import ArcResult, Capacities, Energy, Profile, Status
from wraparc.arc.solver import Distributed
from wraparc.arc.wrap_arc import WrapArc

__all__ = [
    "ArcResult",
    "Capacities",
    "ClassicalDrive",
    "Distributed",
    "DriveResult",
    "Energy",
    "Method",
    "PaperMarch",
    "Profile",
    "Status",
    "WrapArc",
    "capstan_ratio",
    "classical_drives",
    "slipping_arc",
    "solve",
    "wrap_factor",
]
