"""Drives in time: starting, stopping, and whether the second drive pulsates.

Modules are imported when a name of theirs is first used.
"""

from typing import TYPE_CHECKING

from wraparc.lazily import offer

if TYPE_CHECKING:
    from wraparc.motion.control import Control as Control
    from wraparc.motion.control import CoupledMotor as CoupledMotor
    from wraparc.motion.control import Droop as Droop
    from wraparc.motion.control import ExactSpeed as ExactSpeed
    from wraparc.motion.control import Follower as Follower
    from wraparc.motion.control import InductionMotor as InductionMotor
    from wraparc.motion.control import SpeedLoop as SpeedLoop
    from wraparc.motion.control import Trim as Trim
    from wraparc.motion.event import Event as Event
    from wraparc.motion.event import Happening as Happening
    from wraparc.motion.event import LoadStep as LoadStep
    from wraparc.motion.event import Measured as Measured
    from wraparc.motion.event import OnBelt as OnBelt
    from wraparc.motion.event import OnDrum as OnDrum
    from wraparc.motion.event import PowerFailure as PowerFailure
    from wraparc.motion.event import Start as Start
    from wraparc.motion.event import Stop as Stop
    from wraparc.motion.follow import simulate as simulate
    from wraparc.motion.result import DrumHistory as DrumHistory
    from wraparc.motion.result import Outcome as Outcome
    from wraparc.motion.result import Peak as Peak
    from wraparc.motion.result import RunResult as RunResult
    from wraparc.motion.station import Drum as Drum
    from wraparc.motion.station import Station as Station
    from wraparc.motion.vibration import StabilityMap as StabilityMap
    from wraparc.motion.vibration import StabilityResult as StabilityResult
    from wraparc.motion.vibration import stability as stability
    from wraparc.motion.vibration import stability_map as stability_map
    from wraparc.motion.write import motion_text as motion_text

_MODULES = {
    "control": ("Control CoupledMotor Droop ExactSpeed Follower InductionMotor SpeedLoop Trim"),
    "event": "Event Happening LoadStep Measured OnBelt OnDrum PowerFailure Start Stop",
    "result": "DrumHistory Outcome Peak RunResult",
    "follow": "simulate",
    "vibration": "StabilityMap StabilityResult stability stability_map",
    "station": "Drum Station",
    "write": "motion_text",
}
__all__, __getattr__, __dir__ = offer(__name__, _MODULES)
