"""Before and after a change: one table, and the reason for each change in words."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

from wraparc.across import across_of
from wraparc.alike import alike
from wraparc.answer.across_tables import across_data, compared_table
from wraparc.answer.key_figures import key_figures
from wraparc.answer.least_tension import at_least, least_name, shown_least
from wraparc.answer.sheet import NONE, Row, Sheet, Table, Verdict, named, percent, row_of
from wraparc.answer.words import action_of, alone, format_verdict, short
from wraparc.arc import ArcResult, DriveResult, WrapArc
from wraparc.checks import Level, Place, judge, least_tension
from wraparc.checks import Verdict as Judgement
from wraparc.choose.what_if import WhatIf
from wraparc.glossary import GLOSSARY
from wraparc.train import TrainResult
from wraparc.train.whole import Whole
from wraparc.units import per_stress

#: What stands behind a key figure: parts of the creep, and the capacity before its friction.
_BEHIND = {
    "exit_creep": ("creep_shrinkage", "creep_compression", "creep_global"),
    "peak_shear_angle": ("creep_limit_capacity",),
}
#: rows that stand there only where a change moves them
_TENSIONS = frozenset({"entry_tension", "exit_tension", "effective_tension"})
#: numbers that a pulley in gross slip has too
_KNOWN = _TENSIONS | {"creep_limit_capacity", "creep_limit_margin", "equivalent_friction"}
#: parts of the creep that change less than this share of it are not told
_WORTH_TELLING = 0.02
#: part of the creep by which it differs where it is the same
_NO_EFFECT = 1e-3


def what_if_sheet(found: WhatIf, title: str) -> Sheet:
    """Return the table of a pulley before and after changes, with reasons."""
    results, wholes = found.results, found.wholes
    heads, first = ("before", *(c.title for c in found.changes)), found.drives[0].drive
    several = len(first.pulleys) > 1
    whole = " on the whole drive" if several or len(first.load_cases) > 1 else ""
    rows = [
        Row("Result", tuple(short(w, r) for w, r in zip(found.drives, results, strict=True))),
        Row(f"Verdict{whole}", tuple(judge(w).label for w in wholes)),
    ]
    rows += [
        row_of(name, *(_value(r, name) for r in results))
        for name in _shown()
        if not all(math.isnan(_value(r, name)) for r in results)
        and not (name in _TENSIONS and alike([_value(r, name) for r in results]))
    ]
    least = tuple(shown_least(whole) for whole in wholes)
    behind = ", behind the drives" if several and not first.criteria.take_up.after else ""
    note = f"for every check that it helps to pass{behind}"
    rows.append(Row(f"Minimum {least_name(wholes[0])}", least, note=note))
    rows += _standards(wholes)
    across = compared_table(_by_itself(found), heads)
    return Sheet(
        title=title,
        subtitle=f"Pulley {found.pulley}, load case {found.load_case}, before and after.",
        verdict=_verdict(found),
        tables=(
            Table("Before and after", tuple(rows), heads, name="changes"),
            *([across] if across else []),
        ),
        remarks=tuple(f"{c.title}: {c.note}" for c in found.changes if c.note),
        kept=(),
    )


def _verdict(found: WhatIf) -> Verdict:
    """Return the verdict on the drive as it is, with what each change comes to."""
    now, sentences, changes = found.wholes[0], list[str](), list[str]()
    for change, whole, after in zip(found.changes, found.wholes[1:], found.after, strict=True):
        changes.append(f"{change.title}: {_outcome(found, whole, after)}.")
        why = (*_missed(found, whole), *_reasons(found, whole, after))
        sentences += [f"{change.title}: {sentence}" for sentence in why]
    return replace(
        format_verdict(judge(now), sentences, action_of(now)),
        changes=tuple(changes),
        checks_at="wraparc solve",
    )


def _outcome(found: WhatIf, whole: Whole, after: ArcResult) -> str:
    """Return what a change comes to: the creep, and whether the whole drive passes with it."""
    judged, before = judge(whole), judge(found.wholes[0])
    worst = judged.governing
    if worst is not None and worst.missed and not after.status.solved:
        return f"{worst.level} {worst.label}"
    creep = named("exit_creep", abs(after.exit_creep))
    moved = abs(after.exit_creep - found.before.exit_creep)
    if moved <= _NO_EFFECT * abs(after.exit_creep) and _misses(before) == _misses(judged):
        return f"creep {creep}, no effect"
    if worst is None or not worst.missed:
        return f"creep {creep}, passes"
    if worst.name == "creep" and worst.place[:2] == (found.pulley, found.load_case):
        value, limit = worst.texts()
        return f"creep {value} exceeds the {limit} limit"
    return f"creep {creep}, {worst.level} {worst.label}"


def _misses(judged: Judgement) -> set[tuple[str, Place, Level]]:
    return {(check.name, check.place, check.level) for check in judged.missed}


def _standards(wholes: Sequence[Whole]) -> Iterator[Row]:
    """Yield what a design standard that does not bind asks for beside the least tension."""
    found = [least_tension(whole) for whole in wholes]
    asked = [None if f is None else f.standard for f in found]
    some = [f for f in asked if f is not None and not f.binding]
    if some:
        texts = (NONE if f is None else at_least(f.tension) for f in asked)
        yield Row(f"The same by {some[0].title}", tuple(texts), note="not binding")


def _value(result: ArcResult, name: str) -> float:
    if not result.status.solved and name not in _KNOWN:
        return math.nan
    return result.scalar(name)


def _shown() -> list[str]:
    """Return the names of what is compared, in its order."""
    names = [figure.name for figure in key_figures("changes")]
    return [name for key in names for name in (key, *_BEHIND.get(key, ()))]


def _missed(found: WhatIf, whole: Whole) -> Iterator[str]:
    """Yield what a change makes miss a limit that is kept before it: a new belt, a small drum."""
    already = {check.name: check.level.rank for check in judge(found.wholes[0]).missed}
    for check in judge(whole).missed:
        if check.level.rank > already.get(check.name, 0):
            yield f"{check.level}: {check.text}"


def reasons(before: ArcResult, after: ArcResult, several: bool = False) -> Iterator[str]:
    """Yield why a result differs from another, from the largest part of the creep down.

    `several` says that other pulleys share the load.
    """
    yield from _tension_words(before.arc, after.arc, several)
    if not after.status.solved:
        yield "gross slip: no creep transmits its Te."
        return
    if not before.status.solved:
        yield "it transmits the load; before it slipped."
        return
    told = sorted(_parts(before, after), key=lambda part: -part[0])
    floor = _WORTH_TELLING * abs(before.exit_creep)
    some = [sentence for size, sentence in told if size > floor]
    yield from some or ["nothing moves by more than 2 % of the creep."]


def _tension_words(before: WrapArc, after: WrapArc, several: bool) -> Iterator[str]:
    """Yield which Te a change of tensions implies: a take-up alone does not change it."""

    def of(name: str, arc: WrapArc) -> str:
        return named(name, getattr(arc, name))

    moved = [
        n for n in ("entry_tension", "exit_tension") if getattr(before, n) != getattr(after, n)
    ]
    if not moved:
        return
    changes = [f"{GLOSSARY[n].symbol} from {of(n, before)} to {of(n, after)}" for n in moved]
    pulls = [of("effective_tension", arc) for arc in (before, after)]
    told = f"with {' and '.join(changes)}"
    if pulls[0] == pulls[1]:
        yield f"{told}, Te stays at {pulls[0]}."
        return
    if several:
        yield f"{told}, Te goes from {pulls[0]} to {pulls[1]}: the load divides anew."
        return
    held = {"entry_tension": "T2", "exit_tension": "T1"}[moved[0]] if len(moved) == 1 else ""
    other = f" at constant {held}" if held else ""
    yield (
        f"{told}{other}, Te goes from {pulls[0]} to {pulls[1]}; a take-up alone leaves Te "
        "unchanged and moves T1 and T2 alike."
    )


def _parts(before: ArcResult, after: ArcResult) -> Iterator[tuple[float, str]]:
    a, b = before.arc, after.arc
    change = after.creep_shrinkage - before.creep_shrinkage
    why = _stiffness_words(a.axial_stiffness, b.axial_stiffness) or _pull_words(a, b)
    why = why or "the tension drops at a different place along the arc"
    yield abs(change), _moved("belt shrinkage", before, after, "creep_shrinkage", why)
    change = after.creep_compression - before.creep_compression
    more = abs(after.creep_compression) > abs(before.creep_compression)  # negative on a brake
    why = f"the lagging is compressed {'more' if more else 'less'}"
    if 0.0 < a.compression_compliance != b.compression_compliance:  # a bare pulley has none
        why += f" (h/E_c times {b.compression_compliance / a.compression_compliance:.3g})"
    text = _moved("lagging compression", before, after, "creep_compression", why)
    yield abs(change), text
    change = after.creep_global - before.creep_global
    yield (
        abs(change),
        _moved("global creep", before, after, "creep_global", _global_words(before, after)),
    )
    shear = [r.exit_creep - r.exit_slip for r in (before, after)]
    if a.shear_compliance != b.shear_compliance:
        texts = [named("exit_creep", v) for v in shear]
        text = (
            f"of the creep the lagging shears {texts[0]} before and {texts[1]} after, as h/G goes "
            f"from {per_stress(a.shear_compliance)} to {per_stress(b.shear_compliance)}; the "
            f"slip goes from {named('exit_slip', before.exit_slip)} to "
            f"{named('exit_slip', after.exit_slip)}."
        )
        yield abs(shear[1] - shear[0]), text


def _moved(what: str, before: ArcResult, after: ArcResult, name: str, why: str) -> str:
    first, second = (named(name, getattr(r, name)) for r in (before, after))
    return f"{what} goes from {first} to {second}: {why}."


def _pull_words(before: WrapArc, after: WrapArc) -> str:
    """Say that the pulley has to hand over more or less tension, where it has."""
    first, second = (abs(math.log(a.entry_tension / a.exit_tension)) for a in (before, after))
    if abs(second - first) <= 1e-6 * max(first, second):
        return ""
    return f"the pulley works at a {'larger' if second > first else 'smaller'} tension ratio"


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
    asked = _pull_words(before.arc, after.arc)
    if asked and more == asked.endswith("larger tension ratio"):
        return asked
    if first > 0.0 and abs(second / first - 1.0) > 0.01:
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


def _by_itself(found: WhatIf) -> list[DriveResult]:
    """Return the pulley by itself, as it is and after each change: for what is across the width."""
    return [alone(w.drive, r) for w, r in zip(found.drives, found.results, strict=True)]


def _reasons(found: WhatIf, whole: Whole, after: ArcResult) -> Iterator[str]:
    if isinstance(whole, TrainResult) and whole[found.load_case].adrift:
        yield whole[found.load_case].reason
        return
    yield from reasons(found.before, after, len(found.drives[0].drive.pulleys) > 1)


def what_if_document(found: WhatIf) -> dict[str, Any]:
    """Return the results before and after as plain data [SI] for JSON."""
    results = found.results
    titles = ("before", *(c.title for c in found.changes))
    uneven = [next(iter(across_of(one)), None) for one in _by_itself(found)]
    return {
        "format": 1,
        "pulley": found.pulley,
        "load_case": found.load_case,
        "results": [
            {
                "title": title,
                "status": r.status.name.lower(),
                **{name: _value(r, name) for name in _shown()},
                "verdict": str(judge(whole).level),
                "label": judge(whole).label,
                "reasons": [] if r is found.before else list(_reasons(found, whole, r)),
                **({"across": across_data(a)} if a is not None else {}),
            }
            for title, whole, r, a in zip(titles, found.wholes, results, uneven, strict=True)
        ],
    }
