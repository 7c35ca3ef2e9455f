"""Across the width: uneven tension, worn and crowned pulleys, and what wear makes of them."""

from wraparc.across.build import Stiffness, in_plane_stiffness, wide_arc
from wraparc.across.measured import READINGS, MeasuredProfile, profile_of, read_profile, within
from wraparc.across.modes import CAUSES, ModeResponse, mode_response
from wraparc.across.result import AcrossResult, AcrossStatus, Fields, Slack
from wraparc.across.screening import DefectShare, Screening, screen
from wraparc.across.solve import across_of, slack_words, solve_across, uneven_pulleys
from wraparc.across.solver import AcrossSolver
from wraparc.across.spans import TransitionSpan
from wraparc.across.thickness import Cushion, cushion
from wraparc.across.wear import WearHistory, march_wear, measured_coefficient
from wraparc.across.wide_arc import WideArc

__all__ = [
    "CAUSES",
    "READINGS",
    "AcrossResult",
    "AcrossSolver",
    "AcrossStatus",
    "Cushion",
    "DefectShare",
    "Fields",
    "MeasuredProfile",
    "ModeResponse",
    "Screening",
    "Slack",
    "Stiffness",
    "TransitionSpan",
    "WearHistory",
    "WideArc",
    "across_of",
    "cushion",
    "in_plane_stiffness",
    "march_wear",
    "measured_coefficient",
    "mode_response",
    "profile_of",
    "read_profile",
    "screen",
    "slack_words",
    "solve_across",
    "uneven_pulleys",
    "wide_arc",
    "within",
]
