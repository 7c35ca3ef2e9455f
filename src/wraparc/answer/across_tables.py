"""The belt across its width as tables and as plain data."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from wraparc.across import (
    AcrossResult,
    AcrossStatus,
    across_of,
    in_plane_stiffness,
    screen,
    slack_words,
)
from wraparc.alike import place_of_largest
from wraparc.answer.sheet import NONE, Row, Table, headed, named, number, percent, row_of
from wraparc.arc import DriveResult
from wraparc.arrays import Array
from wraparc.checks import Level, Verdict, judge
from wraparc.checks.rules import ACROSS_CHECKS
from wraparc.drive import Drive
from wraparc.glossary import GLOSSARY
from wraparc.train.turning import surface_sentence

#: Places across the belt in a table; all of them are in the data.
_PLACES = 9
#: Defects in words.
DEFECTS = {
    "shell_profile": "shell: crown, out of true",
    "worn_depth": "worn lagging",
    "build_up": "build-up",
    "misalignment": "misalignment",
    "deflection": "shaft deflection",
    "entry_profile": "uneven tension far before",
    "before": "trough transition",
}


def across_tables(result: DriveResult) -> list[Table]:
    """Return the tables of every uneven pulley, in the load case that governs it in full.

    Further load cases of the same pulley have the answer alone.
    """
    tables: list[Table] = []
    told: set[str] = set()
    for uneven in worst_first(result):
        pulley = uneven.wide.arc.pulley
        tables.append(answer_table(uneven))
        if pulley not in told and uneven.status is AcrossStatus.SOLVED:
            tables += [profile_table(uneven), shares_table(result.drive, uneven)]
        told.add(pulley)
    return tables


def worst_first(result: DriveResult) -> list[AcrossResult]:
    """Return uneven pulleys in their load cases, the one with the worst check across first."""
    checks = [c for c in judge(result).checks if c.name in ACROSS_CHECKS]

    def badness(found: AcrossResult) -> tuple[float, float]:
        of = found.wide.arc.pulley, found.wide.arc.load_case
        here = tuple(c for c in checks if (c.place.pulley, c.place.load_case) == of)
        worst = Verdict(here).governing
        return (math.inf, math.inf) if worst is None else worst.order

    return sorted(across_of(result), key=badness)


def answer_table(result: AcrossResult) -> Table:
    """What comes of the unevenness: edges, worst places, wear, forces."""
    arc = result.wide.arc
    title = f"Across the width: pulley {arc.pulley}, load case {arc.load_case}"
    if result.status is not AcrossStatus.SOLVED:
        words = slack_words(result) or str(result.status)
        return Table(
            title, (Row("Not solved", (NONE,), note=words, level=Level.FAILS),), name="width"
        )
    strips, y = result.fields.tension, result.position
    least = place_of_largest(-np.min(strips, axis=0))

    def at(strip: int) -> str:
        return f"at {named('across_position', float(y[strip]))} from the middle"

    def row(name: str, note: str = "") -> Row:
        return row_of(name, getattr(result, name), note=note)

    depths = ", ".join(named("levelling_depth", d) for d in result.levelling_depth.tolist())
    rows = [
        row("largest_running_tension", _of_mean(result.largest_running_tension, arc.entry_tension,
                                                arc.width)),
        row("tightest_strip_tension", "the mean over it; above, extrapolated to the very edge"),
        row("least_tension", at(least)),
        row("entry_unevenness", at(place_of_largest(result.entry_tension))),
        row("exit_unevenness", at(place_of_largest(result.exit_tension))),
        row("energy_unevenness", f"wears fastest {at(place_of_largest(result.frictional_energy))}"),
        row("largest_pressure"),
        row("largest_creep", at(place_of_largest(np.abs(result.exit_creep)))),
        Row("Levelling depth, modes 1 to 4", (depths,), "w_n",
            _wear_words(result), "levelling_depth"),
        row("yaw_moment"),
        row("entry_guide_force"),
        row("exit_guide_force"),
        row("drum_number", "" if arc.pitch_offset is not None else surface_sentence(arc.diameter)),
    ]  # fmt: skip
    if result.wide.static_profile is not None:
        rows.insert(2, row("largest_static_tension", "the label lines fixed at both ends"))
    if not math.isnan(result.outside_tested_share):
        note = "of the wrapped area" if result.outside_tested_share else ""
        value = percent(result.outside_tested_share)
        rows.insert(
            8, Row("Share outside tested range", (value,), "", note, "outside_tested_share")
        )
    return Table(
        title, tuple(rows), note=f"{result.wide.strips} strips; values are theirs.", name="width"
    )


def _of_mean(tension: float, entry: float, width: float) -> str:
    return f"{percent(tension * width / entry)} of the mean at the entry"


def _wear_words(result: AcrossResult) -> str:
    if not result.wear_grows:
        return "uneven wear heals: each of this mean wear leaves 37 % of it"
    return "negative: uneven wear grows, as on a pulley that brakes"


def profile_table(result: AcrossResult) -> Table:
    """Tension, creep, shear and wear at places across the belt."""
    columns: tuple[tuple[str, str, Array], ...] = (
        ("width_tension", "t1", result.entry_tension),
        ("width_tension", "t2", result.exit_tension),
        ("exit_creep", "creep", result.exit_creep),
        ("peak_shear_stress", "shear stress", result.peak_shear_stress),
        ("lagging_thickness", "lagging", result.wide.thickness),
    )
    heads = [headed(words, GLOSSARY[name].dimension) for name, words, _ in columns]
    y = result.position
    edge = 0.5 * result.wide.arc.width
    places = np.linspace(-edge, edge, _PLACES)
    energy = result.frictional_energy / float(np.mean(result.frictional_energy))
    rows = []
    for place in places.tolist():
        values = [number(name, float(np.interp(place, y, column))) for name, _, column in columns]
        values.append(percent(float(np.interp(place, y, energy))))
        rows.append(Row(named("across_position", place), tuple(values)))
    return Table("Across the belt", tuple(rows), (*heads, "wear of mean"), name="strips")


def shares_table(drive: Drive, result: AcrossResult) -> Table:
    """What each defect does alone, to the first order, and how sure the sum is."""
    arc = result.wide.arc
    pulley, case = drive.pulley(arc.pulley), drive.load_case(arc.load_case)
    found = screen(drive, pulley, case)
    mean = float(np.mean(result.frictional_energy))
    rows = [
        Row(
            DEFECTS[share.name].capitalize(),
            (
                named("width_tension", float(np.max(np.abs(share.entry_tension)))),
                percent(float(np.max(np.abs(share.energy))) / mean),
            ),
        )
        for share in found.shares
    ]
    low, high = found.band
    stiffness = in_plane_stiffness(drive.belt)
    note = "Each alone and to the first order; the strips above take them together."
    if stiffness.estimated:
        note += (
            f" In-plane shear stiffness of the belt {stiffness.source.note}: the entry tension is "
            f"then {low:.3f} to {high:.3f} times its mean at most."
        )
    heads = ("entry tension, up to", "wear, up to")
    return Table("Share of each defect", tuple(rows), heads, note, "defects")


#: What is compared of a belt across its width.
_COMPARED = (
    "largest_running_tension",
    "tightest_strip_tension",
    "least_tension",
    "entry_unevenness",
    "exit_unevenness",
    "energy_unevenness",
    "largest_creep",
)


def compared_table(results: Sequence[DriveResult], heads: tuple[str, ...]) -> Table | None:
    """Return what becomes of a belt across its width in several drives of one uneven pulley.

    None where all of them are even; a drive that is even beside others has no numbers.
    """
    found = [next(iter(across_of(result)), None) for result in results]
    if not any(found):
        return None

    def value(result: AcrossResult | None, name: str) -> float:
        if result is None or result.status is not AcrossStatus.SOLVED:
            return math.nan
        return float(getattr(result, name))

    words = tuple(
        "even" if r is None else r.status.name.lower().replace("solved", "carried") for r in found
    )
    rows = [Row("Belt across its width", words, name="status")]
    rows += [row_of(name, *(value(r, name) for r in found)) for name in _COMPARED]
    return Table("Across the width", tuple(rows), heads, name="width")


def across_data(result: AcrossResult) -> dict[str, Any]:
    """Return everything of a result as plain data [SI]."""
    arc = result.wide.arc
    fields = result.fields
    solved = result.status is AcrossStatus.SOLVED
    return {
        "load_case": arc.load_case,
        "pulley": arc.pulley,
        "status": result.status.name.lower(),
        "status_text": str(result.status),
        "slack": slack_words(result) or None,
        "strips": result.wide.strips,
        "in_plane_shear_stiffness": result.wide.shear_stiffness,
        "in_plane_shear_stiffness_source": str(result.wide.stiffness_source),
        **{name: value if solved else None for name, value in result.scalars().items()},
        "levelling_depth": result.levelling_depth.tolist() if solved else None,
        "across_position": result.position.tolist(),
        "across": {
            "entry_tension": result.entry_tension.tolist(),
            "exit_tension": result.exit_tension.tolist(),
            "span_tension": result.span_tension.tolist(),
            "static_tension": result.static_tension.tolist(),
            "entry_creep_ratio": result.entry_creep_ratio.tolist(),
            "exit_creep": result.exit_creep.tolist(),
            "exit_slip": result.exit_slip.tolist(),
            "peak_shear_stress": result.peak_shear_stress.tolist(),
            "frictional_energy": result.frictional_energy.tolist(),
            "lagging_thickness": result.wide.thickness.tolist(),
            "radius_deviation": result.wide.radius_deviation.tolist(),
        },
        "position": result.angle.tolist(),
        "fields": {
            "tension": fields.tension.tolist(),
            "wrap_pressure": fields.wrap_pressure.tolist(),
            "creep": fields.creep.tolist(),
            "slip": fields.slip.tolist(),
            "shear_stress": fields.shear_stress.tolist(),
            "frictional_energy": fields.frictional_energy.tolist(),
        },
    }
