"""Drives in time: starting, stopping, and whether the second drive pulsates.

Modules are imported when a name of theirs is first used.
"""

import importlib
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from wraparc.motion.control import (
        Control,
        CoupledMotor,
        Droop,
        ExactSpeed,
        Follower,
        InductionMotor,
        SpeedLoop,
        Trim,
    )
    from wraparc.motion.event import (
        Event,
        Happening,
        LoadStep,
        Measured,
        OnBelt,
        OnDrum,
        PowerFailure,
        Start,
        Stop,
    )
    from wraparc.motion.follow import simulate
    from wraparc.motion.result import DrumHistory, Outcome, Peak, RunResult
    from wraparc.motion.station import Drum, Station
    from wraparc.motion.vibration import (
        StabilityMap,
        StabilityResult,
        stability,
        stability_map,
    )
    from wraparc.motion.write import motion_text

__all__ = [
    "Control",
    "CoupledMotor",
    "Droop",
    "Drum",
    "DrumHistory",
    "Event",
    "ExactSpeed",
    "Follower",
    "Happening",
    "InductionMotor",
    "LoadStep",
    "Measured",
    "OnBelt",
    "OnDrum",
    "Outcome",
    "Peak",
    "PowerFailure",
    "RunResult",
    "SpeedLoop",
    "StabilityMap",
    "StabilityResult",
    "Start",
    "Station",
    "Stop",
    "Trim",
    "motion_text",
    "simulate",
    "stability",
    "stability_map",
]

_MODULES = {
    "control": ("Control CoupledMotor Droop ExactSpeed Follower InductionMotor SpeedLoop Trim"),
    "event": "Event Happening LoadStep Measured OnBelt OnDrum PowerFailure Start Stop",
    "result": "DrumHistory Outcome Peak RunResult",
    "follow": "simulate",
    "vibration": "StabilityMap StabilityResult stability stability_map",
    "station": "Drum Station",
    "write": "motion_text",
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
