"""Before and after a change: one table, and the reason for each change in words."""

import math
from collections.abc import Iterator
from typing import Any

from wraparc.arc import ArcResult
from wraparc.checks import Level
from wraparc.choose.what_if import WhatIf
from wraparc.drive import Drive
from wraparc.present.least_tension import shown_least
from wraparc.present.sheet import Row, Sheet, Table, Verdict, named, percent, row_of
from wraparc.present.words import alone, level_of
from wraparc.present.words import short as shortly
from wraparc.units import System

_SHOWN = (
    "exit_creep",
    "creep_shrinkage",
    "creep_compression",
    "creep_global",
    "exit_slip",
    "peak_shear_stress",
    "peak_shear_angle",
    "creep_limit_capacity",
    "equivalent_friction",
    "power_loss",
)
_FAILED = frozenset(_SHOWN) - {"creep_limit_capacity", "equivalent_friction"}
#: parts of the creep that change less than this share of it are not told
_WORTH_TELLING = 0.02


def what_if_sheet(found: WhatIf, title: str, system: System = "si") -> Sheet:
    """Return the table of a pulley before and after changes, with reasons."""
    results = (found.before, *found.after)
    drives = (found.drive, *(c.drive for c in found.changes))
    heads = ("before", *(c.title for c in found.changes))
    rows = [
        Row("Result", tuple(short(d, r) for d, r in zip(drives, results, strict=True))),
        Row("Verdict", tuple(str(level(d, r)) for d, r in zip(drives, results, strict=True))),
    ]
    rows += [
        row_of(name, *(_value(r, name) for r in results), system=system)
        for name in _SHOWN
        if not all(math.isnan(_value(r, name)) for r in results)
    ]
    least = tuple(shown_least(alone(d, r), system) for d, r in zip(drives, results, strict=True))
    rows.append(Row("Least slack-side tension", least, note="every binding check kept"))
    sentences = []
    for change, after in zip(found.changes, found.after, strict=True):
        sentences += [f"{change.title}: {s}" for s in reasons(found.before, after, system)]
    return Sheet(
        title=title,
        subtitle=f"Pulley {found.pulley}, load case {found.load_case}, before and after.",
        verdict=Verdict(_level(found), _headline(found, system), tuple(sentences)),
        tables=(Table("Before and after", tuple(rows), heads),),
        remarks=tuple(f"{c.title}: {c.note}" for c in found.changes if c.note),
    )


def _value(result: ArcResult, name: str) -> float:
    if not result.status.solved and name in _FAILED:
        return math.nan
    return float(result.scalars()[name])


def short(drive: Drive, result: ArcResult) -> str:
    """Return the answer for an arc of a drive in a few words."""
    return shortly(alone(drive, result), result)


def level(drive: Drive, result: ArcResult) -> Level:
    """Return the level of an arc of a drive."""
    return level_of(alone(drive, result), result)


def _level(found: WhatIf) -> Level:
    """Return the worst level after the changes."""
    levels = [level(c.drive, a) for c, a in zip(found.changes, found.after, strict=True)]
    return max(levels, key=lambda one: one.rank)


def _headline(found: WhatIf, system: System) -> str:
    parts = []
    for change, after in zip(found.changes, found.after, strict=True):
        if after.status.solved:
            parts.append(f"{change.title} {named('exit_creep', after.exit_creep, system)}")
        else:
            parts.append(f"{change.title} {short(change.drive, after)}")
    before = "breaks away"
    if found.before.status.solved:
        before = named("exit_creep", found.before.exit_creep, system)
    return f"Creep at the exit: now {before}; {'; '.join(parts)}."


def reasons(before: ArcResult, after: ArcResult, system: System = "si") -> Iterator[str]:
    """Yield why a result differs from another, from the largest part of the creep down."""
    if not after.status.solved:
        most = named("tension_ratio", after.capacities.gross_slip_capacity)
        asked = named("tension_ratio", after.arc.entry_tension / after.arc.exit_tension)
        yield f"its friction carries a tension ratio of {most} at most, and {asked} is asked for."
        return
    if not before.status.solved:
        yield "it carries the load, which before it did not."
        return
    told = sorted(_parts(before, after, system), key=lambda part: -part[0])
    floor = _WORTH_TELLING * abs(before.exit_creep)
    some = [sentence for size, sentence in told if size > floor]
    yield from some or ["nothing moves by more than 2 % of the creep."]


def _parts(before: ArcResult, after: ArcResult, system: System) -> Iterator[tuple[float, str]]:
    a, b = before.arc, after.arc
    change = after.creep_shrinkage - before.creep_shrinkage
    why = _stiffness_words(a.axial_stiffness, b.axial_stiffness) or (
        "the tension drops at a different place along the arc"
    )
    yield abs(change), _moved("belt shrinkage", before, after, "creep_shrinkage", why, system)
    change = after.creep_compression - before.creep_compression
    why = "the lagging is compressed " + ("more" if change > 0.0 else "less")
    if a.compression_compliance != b.compression_compliance:
        why += f" (h/E_c times {b.compression_compliance / a.compression_compliance:.3g})"
    text = _moved("lagging compression", before, after, "creep_compression", why, system)
    yield abs(change), text
    change = after.creep_global - before.creep_global
    yield (
        abs(change),
        _moved("global creep", before, after, "creep_global", _global_words(before, after), system),
    )
    shear = [r.exit_creep - r.exit_slip for r in (before, after)]
    if a.shear_compliance != b.shear_compliance:
        texts = [named("exit_creep", v, system) for v in shear]
        text = (
            f"of the creep the lagging shears {texts[0]} before and {texts[1]} after, as h/G goes "
            f"from {_per_stress(a.shear_compliance)} to {_per_stress(b.shear_compliance)}; the "
            f"slip goes from {named('exit_slip', before.exit_slip, system)} to "
            f"{named('exit_slip', after.exit_slip, system)}."
        )
        yield abs(shear[1] - shear[0]), text


def _moved(
    what: str, before: ArcResult, after: ArcResult, name: str, why: str, system: System
) -> str:
    first, second = (named(name, getattr(r, name), system) for r in (before, after))
    return f"{what} goes from {first} to {second}: {why}."


def _stiffness_words(before: float, after: float) -> str:
    if before == after:
        return ""
    if after > before:
        return f"the belt is {after / before:.3g} times as stiff"
    return f"the belt is {before / after:.3g} times less stiff"


def _global_words(before: ArcResult, after: ArcResult) -> str:
    """Say why the uniform creep changes: friction to be had at one slip, or the other sources."""
    slip = abs(before.exit_slip)
    pressure = before.arc.wrap_pressure(0.5 * (before.entry_tension + before.exit_tension))
    first, second = (float(r.arc.law.friction(slip, pressure)) for r in (before, after))
    more = after.creep_global > before.creep_global
    if abs(second / first - 1.0) > 0.01:
        share = percent(abs(second / first - 1.0), 2)
        word = "more" if second > first else "less"
        return (
            f"at the same slip and the mean wrap pressure the lagging has {share} {word} friction"
        )
    if before.arc.shear_compliance != after.arc.shear_compliance:
        into = "more" if more else "less"
        return f"{into} of the creep goes into shear of the lagging, where it adds no friction"
    return (
        f"the other sources of creep supply {'less' if more else 'more'} of the slip that the "
        f"friction needs, so that global creep has to supply {'more' if more else 'less'}"
    )


def _per_stress(compliance: float) -> str:
    return f"{compliance * 1e9:.3g} mm/MPa"


def what_if_document(found: WhatIf) -> dict[str, Any]:
    """Return the results before and after as plain data [SI] for JSON."""
    results = (found.before, *found.after)
    titles = ("before", *(c.title for c in found.changes))
    return {
        "format": 1,
        "pulley": found.pulley,
        "load_case": found.load_case,
        "results": [
            {
                "title": title,
                "status": r.status.name.lower(),
                **{name: _value(r, name) for name in _SHOWN},
                "reasons": [] if r is found.before else list(reasons(found.before, r)),
            }
            for title, r in zip(titles, results, strict=True)
        ],
    }
