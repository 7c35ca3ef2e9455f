"""A station before it starts: the belt as tight as its take-up makes it, an incline hung in."""

from __future__ import annotations

from wraparc.errors import input_error
from wraparc.motion.station_state import StationState


def rest(march: StationState) -> None:
    """Put a station to rest.

    Raises
    ------
    InputError
        If its state at rest is not known.
    """
    for d in march.drums:
        d.arc.lift = 0.0
        march.wraps.lay_at_rest(d.arc, march.slack)
        d.locked = True
        d.turning.run(0.0, 0.0, 0.0)
    march.T = [march.slack] * (march.n + 1)
    for i, rise in enumerate(march.runs):
        if rise:
            message = "must be 0 at rest"
            remedy = "Leave [train.run] out."
            raise input_error(key=f"run[{i + 1}]", message=message, remedy=remedy)
    lift = march.station.lift_share * march.pull
    if lift <= 0.0:
        return
    if not any(d.backstop or d.brake for d in march.drums):
        message = "nothing holds an inclined conveyor at rest"
        remedy = "Give a drum backstop = true or a brake_torque."
        raise input_error(key="lift_share", message=message, remedy=remedy)
    for j in range(1, 41):  # the load hangs itself into the drums, which stand
        march.T[0] = march.slack + lift * j / 40.0
        _hang(march)


def _hang(march: StationState) -> None:
    """Find the tensions between standing drums for the outer ones: no belt runs through."""
    for i in range(1, march.n):
        march.T[i] = march.slack + (march.T[0] - march.slack) * 0.5
    exits = [*march.T[1:-1], march.slack]
    arcs = march.wraps.arcs
    travels, m = [a.travel for a in arcs], [a.m for a in arcs]
    march.wraps.begin(travels)
    for _ in range(30):
        found = march.wraps.sweep(travels, m, exits)
        steps = [(t - out.entry) / out.entry_m for t, out in zip(march.T, found, strict=False)]
        m = [a + dm for a, dm in zip(m, steps, strict=True)]
        if max(map(abs, steps)) < 1e-12:
            break
    march.wraps.finish(m, exits)
