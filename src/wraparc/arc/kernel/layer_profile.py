"""Profile of a long arc, solved by layers: the layers as marched, and the rest in between."""

from __future__ import annotations

from math import log

from wraparc.arc.kernel.layer_march import (
    MOST_STEPS,
    STEP_TOLERANCE,
    TO_CREEP,
    TO_RATIO,
    friction_of_creep,
    layer_step,
    march_layer,
)
from wraparc.arc.kernel.layers import Layers, shot_of_layers
from wraparc.arc.kernel.quantities import RECORD, Buffer, Parameters, Shot, zeros
from wraparc.arc.profile import sort
from wraparc.friction.compact import CompactLaw, branch_of, segment_of

NODES = 400  # of a layer that a profile records at most
KINKS = 200  # of a layer, the same
HALVINGS = 50  # of a step, to where the law changes its piece


def trace_layers(
    law: CompactLaw, par: Parameters, found: Layers, points: int, out: Buffer
) -> tuple[Shot, int]:
    """Profile of solved layers: exit quantities and the number of records."""
    path = zeros(3 * MOST_STEPS + 10)
    count, part = 0, (found.creep, found.ratio)
    g = par.compliance * (found.rest_tension - par.entry_tension)
    begin = min(found.entry_length, par.length)
    out_length = max(found.length - found.entry_length, 0.0)
    if begin > 0.0:
        march_layer(
            law, par, found.rest_tension, part, -1.0, TO_CREEP, par.kick, STEP_TOLERANCE, path
        )
        count = _record_path(law, par, found.rest_tension, g, path, begin, -1.0, points, out, 0)
        count = _record_kinks(law, par, found.rest_tension, g, path, begin, -1.0, out, count)
    elif par.kick == 0.0:
        _record(law, par, found.rest_tension, g, 0.0, 0.0, found.ratio, out, 0)
        count = 1
    # the rest in between
    end = max(par.length - out_length, begin)
    j = int(begin / par.length * points * (1.0 + 1e-12)) + 1
    while j < points and j * par.length / points < end:
        _record(law, par, found.rest_tension, g, j * par.length / points, 0.0, 0.0, out, count)
        count += 1
        j += 1
    path[0] = 0.0
    if out_length > 0.0:
        march_layer(
            law,
            par,
            found.rest_tension,
            part,
            1.0,
            TO_RATIO,
            found.exit_ratio,
            STEP_TOLERANCE,
            path,
        )
    else:
        path[0], path[1], path[2], path[3] = 1.0, 0.0, found.exit_creep, found.exit_ratio
    count = _record_path(law, par, found.rest_tension, g, path, end, 1.0, points, out, count)
    out[RECORD * (count - 1)] = par.length
    count = _record_kinks(law, par, found.rest_tension, g, path, end, 1.0, out, count)
    sort(out, count)
    return shot_of_layers(law, par, found), count


def _record_path(
    law: CompactLaw,
    par: Parameters,
    rest: float,
    g: float,
    path: Buffer,
    origin: float,
    towards: float,
    points: int,
    out: Buffer,
    count: int,
) -> int:
    """Record a layer in order of position, with the points of the equal division inside it."""
    n = int(path[0])
    skip = 1 + n // NODES
    for k in range(n):
        i = k if towards > 0.0 else n - 1 - k
        s, u, w = path[3 * i + 1], path[3 * i + 2], path[3 * i + 3]
        here = origin + towards * s
        if k > 0:
            # points between the node before and this one, from the nearer to where they part
            m = i - 1 if towards > 0.0 else i
            from_s = path[3 * m + 1]
            start = (path[3 * m + 2], path[3 * m + 3])
            before = origin + towards * path[3 * (i - 1 if towards > 0.0 else i + 1) + 1]
            j = int(before / par.length * points * (1.0 + 1e-12)) + 1
            while j < points and j * par.length / points < here * (1.0 - 1e-12):
                at = j * par.length / points
                h = towards * (towards * (at - origin) - from_s)
                v, y = layer_step(law, par, rest, start[0], start[1], h)
                _record(law, par, rest, g, at, v, y, out, count)
                count += 1
                j += 1
        if k in (0, n - 1) or k % skip == 0:
            _record(law, par, rest, g, max(here, 0.0), u, w, out, count)
            count += 1
    return count


def _record_kinks(
    law: CompactLaw,
    par: Parameters,
    rest: float,
    g: float,
    path: Buffer,
    origin: float,
    towards: float,
    out: Buffer,
    count: int,
) -> int:
    """Record where the law changes its piece between two steps of a layer."""
    most = count + KINKS
    for i in range(int(path[0]) - 1):
        s, u, w = path[3 * i + 1], path[3 * i + 2], path[3 * i + 3]
        piece = _piece(law, par, rest, u, w)
        h = towards * (path[3 * i + 4] - s)
        if count == most or piece == _piece(law, par, rest, path[3 * i + 5], path[3 * i + 6]):
            continue
        low, high = 0.0, 1.0
        for _ in range(HALVINGS):
            part = 0.5 * (low + high)
            v, y = layer_step(law, par, rest, u, w, part * h)
            if _piece(law, par, rest, v, y) == piece:
                low = part
            else:
                high = part
        v, y = layer_step(law, par, rest, u, w, high * h)
        _record(law, par, rest, g, max(origin + towards * s + high * h, 0.0), v, y, out, count)
        count += 1
    return count


def _piece(law: CompactLaw, par: Parameters, rest: float, u: float, w: float) -> tuple[int, int]:
    """Segment and branch of the law at a creep and a creep ratio; -1 where the belt is held."""
    tension = rest - w / par.compliance
    _, x = friction_of_creep(law, par, tension, u)
    pressure = par.entry_pressure * max(tension / par.entry_tension, 1e-9)
    segment = segment_of(law, pressure)
    return segment, branch_of(law, segment, abs(x), pressure) if x != 0.0 else -1


def _record(
    law: CompactLaw,
    par: Parameters,
    rest: float,
    g: float,
    s: float,
    u: float,
    w: float,
    out: Buffer,
    count: int,
) -> None:
    """Write one point of a profile, see wraparc.arc.kernel.march.record."""
    tension = rest - w / par.compliance
    tau, x = friction_of_creep(law, par, tension, u)
    entry_tau, _ = friction_of_creep(law, par, par.entry_tension, par.kick)
    work = 0.5 * (w * w - g * g) / (par.compliance * par.width)
    work -= 0.5 * par.shear * (tau * tau - entry_tau * entry_tau)
    i = RECORD * count
    out[i], out[i + 1], out[i + 2] = s, log(tension / par.entry_tension), x
    out[i + 3], out[i + 4], out[i + 5] = u, tau, work
