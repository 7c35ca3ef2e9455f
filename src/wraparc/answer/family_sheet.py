"""The sheet and the plain data of a family of tension ratios."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from wraparc.answer.sheet import (
    NONE,
    Row,
    Sheet,
    Table,
    Verdict,
    headed,
    named,
    number,
    percent,
)
from wraparc.answer.words import alone, level_of, short
from wraparc.arc import ArcResult, DriveResult
from wraparc.checks import Level, Place, judge
from wraparc.checks.check import escaped
from wraparc.drive import Drive


def family_sheet(drive: Drive, results: Sequence[ArcResult], title: str) -> Sheet:
    """Return a row for each tension ratio: tensions, creep, slip, shear and what comes of it."""
    arc = results[0].arc
    tight, slack = ("T1", "T2") if arc.side > 0.0 else ("T2", "T1")
    fixed = named("tension", max(arc.entry_tension, arc.exit_tension))
    heads = (
        headed(slack, "force"), headed("Te", "force"), headed("creep", "length"), "of limit",
        headed("slip", "length"), "shear angle [deg]", "status",
    )  # fmt: skip
    rows = tuple(
        Row(
            f"{tight}/{slack} = {named('tension_ratio', _ratio(r))}",
            _values(alone(drive, r), r),
            level=level_of(alone(drive, r), r),
        )
        for r in results
    )
    limit = named("creep_limit", arc.creep_limit)
    note = f"{tight} constant at {fixed}; creep limit {limit}."
    return Sheet(
        title=title,
        subtitle=f"Pulley {arc.pulley}, load case {arc.load_case}: {arc.duty}, at several ratios "
        "of tight-side to slack-side tension.",
        verdict=_verdict(drive, results, f"{tight}/{slack}"),
        tables=(Table("Creep by tension ratio", rows, heads, note),),
    )


def _verdict(drive: Drive, results: Sequence[ArcResult], ratio: str) -> Verdict:
    """Return up to which ratio the creep passes, or from which one the worst check is missed."""
    rows = sorted(results, key=_ratio)
    judged = [judge(alone(drive, row)) for row in rows]
    checks = [one.governing for one in judged]
    worst = min(
        (c for c in checks if c is not None and c.missed), key=lambda c: c.order, default=None
    )
    last = named("tension_ratio", _ratio(rows[-1]))
    data = judged[0].data.text
    if worst is None:
        place = Place(rows[0].arc.pulley, rows[0].arc.load_case).bracket
        text = f"Creep passes up to {ratio} = {last}{place}."
        return Verdict(Level.OK, text, data=data, name="family")
    first, row = next(
        (c, row)
        for c, row in zip(checks, rows, strict=True)
        if c is not None and (c.name, c.level) == (worst.name, worst.level)
    )
    at = escaped(f" at {ratio} = {named('tension_ratio', _ratio(row))}")
    text = replace(first, headline=f"{first.headline}{at}").text
    return Verdict(first.level, text, data=data, name="family")


def _ratio(result: ArcResult) -> float:
    arc = result.arc
    return max(arc.entry_tension, arc.exit_tension) / min(arc.entry_tension, arc.exit_tension)


def _values(of: DriveResult, result: ArcResult) -> tuple[str, ...]:
    arc, solved = result.arc, result.status.solved
    texts = (
        number("exit_creep", result.exit_creep),
        percent(result.share_of_limit),
        number("exit_slip", result.exit_slip),
        number("peak_shear_angle", result.peak_shear_angle),
    )
    return (
        number("tension", min(arc.entry_tension, arc.exit_tension)),
        number("effective_tension", abs(arc.effective_tension)),
        *(texts if solved else [NONE] * len(texts)),
        short(of, result),
    )


def family_document(results: Sequence[ArcResult]) -> dict[str, Any]:
    """Return a family as plain data [SI] for JSON, with creep along the wrap."""
    return {
        "format": 1,
        "pulley": results[0].arc.pulley,
        "load_case": results[0].arc.load_case,
        "results": [
            {
                "ratio": _ratio(r),
                "entry_tension": r.arc.entry_tension,
                "exit_tension": r.arc.exit_tension,
                "status": r.status.name.lower(),
                "exit_creep": r.exit_creep,
                "exit_slip": r.exit_slip,
                "position": r.profile.position.tolist(),
                "creep": r.profile.creep.tolist(),
            }
            for r in results
        ],
    }
