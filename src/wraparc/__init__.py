"""Belt-conveyor drive pulleys: creep, slip, lagging shear and traction capacity.

Every name below is imported when it is first used, so that ``import wraparc`` costs next to
nothing.
"""

import typing

from wraparc import lazily, views

if typing.TYPE_CHECKING:
    from wraparc.across import AcrossResult as AcrossResult
    from wraparc.across import solve_across as solve_across
    from wraparc.arc import ArcResult as ArcResult
    from wraparc.arc import Capacities as Capacities
    from wraparc.arc import ClassicalDrive as ClassicalDrive
    from wraparc.arc import Distributed as Distributed
    from wraparc.arc import DriveResult as DriveResult
    from wraparc.arc import Energy as Energy
    from wraparc.arc import PaperMarch as PaperMarch
    from wraparc.arc import Profile as Profile
    from wraparc.arc import Status as Status
    from wraparc.arc import WrapArc as WrapArc
    from wraparc.arc import solve as solve
    from wraparc.batch import BatchResult as BatchResult
    from wraparc.batch import Setting as Setting
    from wraparc.batch import solve_batch as solve_batch
    from wraparc.drive import Across as Across
    from wraparc.drive import Belt as Belt
    from wraparc.drive import Drive as Drive
    from wraparc.drive import GrippingPulley as GrippingPulley
    from wraparc.drive import Lagging as Lagging
    from wraparc.drive import LoadCase as LoadCase
    from wraparc.drive import Pulley as Pulley
    from wraparc.drive import Tensions as Tensions
    from wraparc.drive import Transition as Transition
    from wraparc.drive import WidthProfile as WidthProfile
    from wraparc.errors import BreakawayError as BreakawayError
    from wraparc.errors import ConvergenceError as ConvergenceError
    from wraparc.errors import InputError as InputError
    from wraparc.errors import MissingExtraError as MissingExtraError
    from wraparc.errors import Problem as Problem
    from wraparc.errors import SlackBeltError as SlackBeltError
    from wraparc.errors import WraparcError as WraparcError
    from wraparc.files import load_lagging as load_lagging
    from wraparc.friction import CoefficientPieces as CoefficientPieces
    from wraparc.friction import Constant as Constant
    from wraparc.friction import ElasticPlastic as ElasticPlastic
    from wraparc.friction import FrictionLaw as FrictionLaw
    from wraparc.friction import IntegralLog as IntegralLog
    from wraparc.friction import MeasuredTable as MeasuredTable
    from wraparc.friction import Piece as Piece
    from wraparc.friction import PressureKnots as PressureKnots
    from wraparc.friction import PressurePower as PressurePower
    from wraparc.friction import TestedRange as TestedRange
    from wraparc.friction import Trend as Trend
    from wraparc.motion import Event as Event
    from wraparc.motion import RunResult as RunResult
    from wraparc.motion import StabilityResult as StabilityResult
    from wraparc.motion import Station as Station
    from wraparc.motion import simulate as simulate
    from wraparc.motion import stability as stability
    from wraparc.motion.file import load_motion as load_motion
    from wraparc.provenance import Kind as Kind
    from wraparc.provenance import Provenance as Provenance
    from wraparc.train import Train as Train
    from wraparc.train import TrainBatchResult as TrainBatchResult
    from wraparc.train import TrainResult as TrainResult
    from wraparc.train import solve_train as solve_train
    from wraparc.train import solve_train_batch as solve_train_batch
    from wraparc.train.file import load_drive as load_drive
    from wraparc.train.file import load_train as load_train
    from wraparc.version import __version__ as __version__

_ROOMS = {
    "arc": (
        "ArcResult Capacities ClassicalDrive Distributed DriveResult Energy PaperMarch Profile "
        "Status WrapArc solve"
    ),
    "across": "AcrossResult solve_across",
    "drive": (
        "Across Belt Drive GrippingPulley Lagging LoadCase Pulley Tensions Transition WidthProfile"
    ),
    "errors": (
        "BreakawayError ConvergenceError InputError MissingExtraError Problem SlackBeltError "
        "WraparcError"
    ),
    "files": "load_lagging",
    "friction": (
        "CoefficientPieces Constant ElasticPlastic FrictionLaw IntegralLog MeasuredTable Piece "
        "PressureKnots PressurePower TestedRange Trend"
    ),
    "motion": "Event RunResult StabilityResult Station simulate stability",
    "motion.file": "load_motion",
    "provenance": "Kind Provenance",
    "batch": "BatchResult Setting solve_batch",
    "train": "Train TrainBatchResult TrainResult solve_train solve_train_batch",
    "train.file": "load_drive load_train",
    "version": "__version__",
}
__all__, __getattr__, __dir__ = lazily.offer(__name__, _ROOMS)

views.install(
    html="wraparc.render.notebook:html",
    text="wraparc.render.notebook:text",
    plot="wraparc.plot:plot",
    frame="wraparc.render.notebook:frame",
)
