"""Belt-conveyor drive pulleys: creep, slip, lagging shear and traction capacity.

Every name below is imported when it is first used, so that ``import wraparc`` costs next to
nothing.
"""

import importlib
import typing

from wraparc import views

if typing.TYPE_CHECKING:
    from wraparc.across import AcrossResult, solve_across
    from wraparc.arc import (
        ArcResult,
        Capacities,
        ClassicalDrive,
        Distributed,
        DriveResult,
        Energy,
        PaperMarch,
        Profile,
        Status,
        WrapArc,
        solve,
    )
    from wraparc.batch import BatchResult, Setting, solve_batch
    from wraparc.drive import (
        Across,
        Belt,
        Drive,
        GrippingPulley,
        Lagging,
        LoadCase,
        Pulley,
        Tensions,
        Transition,
        WidthProfile,
    )
    from wraparc.errors import (
        BreakawayError,
        ConvergenceError,
        InputError,
        MissingExtraError,
        Problem,
        SlackBeltError,
        WraparcError,
    )
    from wraparc.files import load_lagging
    from wraparc.friction import (
        CoefficientPieces,
        Constant,
        ElasticPlastic,
        FrictionLaw,
        IntegralLog,
        MeasuredTable,
        Piece,
        PressureKnots,
        PressurePower,
        TestedRange,
        Trend,
    )
    from wraparc.motion import Event, RunResult, StabilityResult, Station, simulate, stability
    from wraparc.motion.file import load_motion
    from wraparc.provenance import Kind, Provenance
    from wraparc.train import (
        Train,
        TrainBatchResult,
        TrainResult,
        solve_train,
        solve_train_batch,
    )
    from wraparc.train.file import load_drive, load_train
    from wraparc.version import __version__

__all__ = [
    "Across",
    "AcrossResult",
    "ArcResult",
    "BatchResult",
    "Belt",
    "BreakawayError",
    "Capacities",
    "ClassicalDrive",
    "CoefficientPieces",
    "Constant",
    "ConvergenceError",
    "Distributed",
    "Drive",
    "DriveResult",
    "ElasticPlastic",
    "Energy",
    "Event",
    "FrictionLaw",
    "GrippingPulley",
    "InputError",
    "IntegralLog",
    "Kind",
    "Lagging",
    "LoadCase",
    "MeasuredTable",
    "MissingExtraError",
    "PaperMarch",
    "Piece",
    "PressureKnots",
    "PressurePower",
    "Problem",
    "Profile",
    "Provenance",
    "Pulley",
    "RunResult",
    "Setting",
    "SlackBeltError",
    "StabilityResult",
    "Station",
    "Status",
    "Tensions",
    "TestedRange",
    "Train",
    "TrainBatchResult",
    "TrainResult",
    "Transition",
    "Trend",
    "WidthProfile",
    "WrapArc",
    "WraparcError",
    "__version__",
    "load_drive",
    "load_lagging",
    "load_motion",
    "load_train",
    "simulate",
    "solve",
    "solve_across",
    "solve_batch",
    "solve_train",
    "solve_train_batch",
    "stability",
]

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
_ROOM_OF = {name: room for room, names in _ROOMS.items() for name in names.split()}

views.install(
    html="wraparc.render.notebook:html",
    text="wraparc.render.notebook:text",
    plot="wraparc.plot:plot",
    frame="wraparc.render.notebook:frame",
)


def __getattr__(name: str) -> object:
    if name not in _ROOM_OF:
        raise AttributeError(f"module 'wraparc' has no attribute {name!r}")
    value: object = getattr(importlib.import_module(f"wraparc.{_ROOM_OF[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return list(__all__)
