"""Belt-conveyor drive pulleys: creep, slip, lagging shear and traction capacity."""

from wraparc.errors import (
    BreakawayError,
    ConvergenceError,
    InputError,
    MissingExtraError,
    Problem,
    WraparcError,
)
from wraparc.provenance import Kind, Provenance
from wraparc.version import __version__

__all__ = [
    "BreakawayError",
    "ConvergenceError",
    "InputError",
    "Kind",
    "MissingExtraError",
    "Problem",
    "Provenance",
    "WraparcError",
    "__version__",
]
