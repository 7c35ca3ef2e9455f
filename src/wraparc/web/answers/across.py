"""Across the width: what is uneven, what comes of it, what wear makes of it, and thickness."""

from dataclasses import replace

import numpy as np

from wraparc.across import (
    AcrossResult,
    AcrossStatus,
    across_of,
    cushion,
    march_wear,
    measured_coefficient,
    profile_of,
    slack_words,
    solve_across,
    within,
)
from wraparc.answer.across_answers import (
    cushion_table,
    cushion_verdict,
    wear_table,
    wear_verdict,
)
from wraparc.answer.across_tables import (
    answer_table,
    profile_table,
    shares_table,
    worst_first,
)
from wraparc.answer.checks_table import check_table
from wraparc.answer.sheet import Verdict as ToldVerdict
from wraparc.answer.train_words import train_verdict
from wraparc.answer.words import format_verdict, stated_action, under, verdict
from wraparc.checks import Verdict as Judgement
from wraparc.checks import judge
from wraparc.checks.rules import ACROSS_CHECKS
from wraparc.choose.what_if import redivided
from wraparc.drive import Drive, LoadCase, Pulley
from wraparc.drive.changes import with_thickness
from wraparc.errors import InputError, input_error
from wraparc.files.across_keys import ACROSS
from wraparc.train import Train, TrainResult
from wraparc.train.whole import Described, Whole, by_pulley, solved
from wraparc.units import GIVEN_DIGITS, Dimension, parse_quantity, quantity
from wraparc.web.answers.documents import asked_for, divided, read
from wraparc.web.answers.shown import (
    Answer,
    Bar,
    Data,
    Numbers,
    Table,
    Text,
    Verdict,
    bars,
    finite,
    numbers,
    rounded,
    tables,
    texts,
    worded,
)
from wraparc.web.asked import AcrossRequest, AcrossThicknessRequest, AcrossWearRequest

#: Places along the wrap in a map.
_PLACES = 61
#: Strips that wear is marched with: its many solves need no more for shapes of a few waves.
_WEAR_STRIPS = 12
#: Steps of the march over a levelling depth: 0.7 % of what is levelled.
_PER_DEPTH = 5


class WidthMap(Answer):
    """Quantities over wrap angle [rad] and position across the belt [m], a row an angle [SI]."""

    angle: Numbers
    position: Numbers
    shear_stress: list[Numbers]
    creep: list[Numbers]
    wrap_pressure: list[Numbers]
    frictional_energy: list[Numbers]


class WidthProfiles(Answer):
    """Quantities over the position across the belt [SI]."""

    entry_tension: Numbers
    exit_tension: Numbers
    static_tension: Numbers | None
    radius_deviation: Numbers
    thickness: Numbers
    frictional_energy: Numbers


class AcrossAnswer(Answer):
    """A pulley across the width of its belt."""

    pulley: str
    load_case: str
    even: bool
    solved: bool
    status_text: Text
    verdict: Verdict
    remarks: list[Text]
    bars: list[Bar]
    checks: Table | None
    tables: list[Table]
    numbers: dict[str, float | None]
    levelling_depth: Numbers
    rating: float | None
    map: WidthMap | None
    profiles: WidthProfiles | None


class AcrossWearAnswer(Answer):
    """How an uneven lagging wears on."""

    verdict: Verdict
    table: Table
    heals: bool
    grows: bool
    relag_hours: float | None
    mean_depth: Numbers
    unevenness: Numbers
    position: Numbers
    thickness: list[Numbers]


class AcrossThicknessAnswer(Answer):
    """What thicker laggings cushion, and what they cost in creep."""

    verdict: Verdict
    table: Table


class ProfileAnswer(Answer):
    """A profile measured over the face, as it stands in ``[pulley.across]``."""

    key: str
    profile: list[list[str]] | Data
    readings: int
    told: list[Text]


def solve_width(asked: AcrossRequest) -> AcrossAnswer:
    """A pulley across its width: verdict, maps, profiles, shares of the defects."""
    whole = solved(read(asked.document))
    result, judged = by_pulley(whole), judge(whole)
    drive = result.drive
    pulley, case = asked_for(drive, asked.pulley, asked.load_case)
    if asked.load_case is None:
        worst = [r.wide.arc for r in worst_first(result) if r.wide.arc.pulley == pulley.name]
        case = drive.load_case(worst[0].load_case) if worst else case
    if pulley.across is None:
        found = solve_across(drive, pulley.name, case.name, strips=8, raise_on_failure=False)
    else:
        found = next(
            r
            for r in across_of(result)
            if (r.wide.arc.pulley, r.wide.arc.load_case) == (pulley.name, case.name)
        )
    carried = found.status is AcrossStatus.SOLVED
    own = judged.at(pulley.name, case.name)
    told = (
        format_verdict(own, own.full, stated_action(own))
        if asked.load_case is not None
        else _told(whole)
    )
    return AcrossAnswer(
        pulley=pulley.name,
        load_case=case.name,
        even=pulley.across is None,
        solved=carried,
        status_text=worded(slack_words(found) or str(found.status)),
        verdict=Verdict.of(told),
        remarks=texts(judged.remarks),
        bars=bars(own.listed),
        checks=_checks(judged, pulley, case),
        tables=_tables(drive, found, carried),
        numbers=numbers(found.scalars()) if carried else {},
        levelling_depth=rounded(found.levelling_depth) if carried else [],
        rating=drive.belt.rating,
        map=_map(found) if carried else None,
        profiles=_profiles(found) if carried else None,
    )


def _told(whole: Whole) -> ToldVerdict:
    if isinstance(whole, TrainResult):
        return train_verdict(whole, search=False)
    return verdict(whole, search=False)


def _checks(told: Judgement, pulley: Pulley, case: LoadCase) -> Table | None:
    own = tuple(
        c
        for c in told.checks
        if c.name in ACROSS_CHECKS
        and c.place.pulley == pulley.name
        and c.place.load_case in ("", case.name)
    )
    if not own:
        return None
    return tables([check_table(replace(told, checks=own))], ["checks"])[0]


def _tables(drive: Drive, found: AcrossResult, solved: bool) -> list[Table]:
    made = [answer_table(found)]
    if solved:
        made += [shares_table(drive, found), profile_table(found)]
    return tables(made, ("answer", "shares", "profile")[: len(made)])


def _map(found: AcrossResult) -> WidthMap:
    even = np.linspace(0.0, found.angle[-1], _PLACES)

    def along(name: str) -> list[Numbers]:
        columns = getattr(found.fields, name).T
        return rounded(np.array([np.interp(even, found.angle, c) for c in columns]).T, 4)

    return WidthMap(
        angle=rounded(even),
        position=rounded(found.position),
        shear_stress=along("shear_stress"),
        creep=along("creep"),
        wrap_pressure=along("wrap_pressure"),
        frictional_energy=along("frictional_energy"),
    )


def _profiles(found: AcrossResult) -> WidthProfiles:
    still = found.wide.static_profile is not None
    return WidthProfiles(
        entry_tension=rounded(found.entry_tension),
        exit_tension=rounded(found.exit_tension),
        static_tension=rounded(found.static_tension) if still else None,
        radius_deviation=rounded(found.wide.radius_deviation),
        thickness=rounded(found.wide.thickness),
        frictional_energy=rounded(found.frictional_energy),
    )


def _asked(asked: AcrossRequest) -> tuple[Described, Drive, Pulley, LoadCase]:
    thing = read(asked.document)
    drive = divided(thing) if isinstance(thing, Train) else thing
    return thing, drive, *asked_for(drive, asked.pulley, asked.load_case)


def wear_width(asked: AcrossWearRequest) -> AcrossWearAnswer:
    """Wear marched on: whether it heals or runs away, and when to re-lag."""
    least = _quantity("least_thickness", asked.least_thickness, "length")
    depth = None if asked.depth is None else _quantity("depth", asked.depth, "length")
    thing, drive, pulley, case = _asked(asked)
    strips = min(_WEAR_STRIPS, pulley.across.strips if pulley.across else _WEAR_STRIPS)
    now = solve_across(drive, pulley.name, case.name, strips=strips, raise_on_failure=False)
    if not now.status.solved:
        message = slack_words(now) or str(now.status)
        raise input_error(key=f"pulley.{pulley.name}.across", message=message)
    wide = now.wide
    worn = float(np.mean(wide.arc.thickness - wide.thickness))
    if depth is None and asked.passes is None:  # on to re-lagging
        depth = max(float(np.mean(wide.thickness)) - least, 1e-4)
    rate = None if asked.hours is None else measured_coefficient(now, worn, asked.hours)
    history = march_wear(
        wide,
        depth,
        passes=asked.passes,
        coefficient=rate,
        least_thickness=0.5 * least,  # past it, to read the hours off
        per_depth=_PER_DEPTH,
    )
    return AcrossWearAnswer(
        verdict=Verdict.of(
            under(wear_verdict(now, history, least), format_verdict(judge(solved(thing))))
        ),
        table=tables([wear_table(history)], ["wear"])[0],
        heals=history.heals,
        grows=now.wear_grows,
        relag_hours=finite(history.hours_to(least)),
        mean_depth=rounded(history.mean_depth),
        unevenness=rounded(history.unevenness),
        position=rounded(wide.position),
        thickness=rounded(history.thickness[:: max(1, len(history.mean_depth) // 6)]),
    )


def thickness_width(asked: AcrossThicknessRequest) -> AcrossThicknessAnswer:
    """What thicker laggings cushion of the same unevenness."""
    wanted = sorted(_quantity("thicknesses", text, "length") for text in asked.thicknesses)
    thing, drive, pulley, case = _asked(asked)
    found = cushion(drive, wanted, pulley.name, case.name, strips=_WEAR_STRIPS)
    changed = with_thickness(drive, pulley.name, wanted[-1])
    thick = redivided(thing, changed) if isinstance(thing, Train) else changed
    told = cushion_verdict(found)
    return AcrossThicknessAnswer(
        verdict=Verdict.of(under(told, format_verdict(judge(solved(thick))))),
        table=tables([cushion_table(found)], ["thickness"])[0],
    )


def read_profile(data: bytes, name: str, width: str, unit: str, new: str) -> ProfileAnswer:
    """Return a measured profile as rows of a drive document, the part under the belt."""
    found = profile_of(data, name, unit=unit, new=_quantity("new", new, "length") if new else None)
    across = _quantity("width", width, "length") if width else None
    rows = found.profile if across is None else within(found, across)
    kind = next(e.kind for e in ACROSS.entries if e.key == found.key)

    ends = (float(found.position[place]) for place in (0, -1))
    told = " to ".join(quantity(y, "length", GIVEN_DIGITS) for y in ends)
    lines = [f"{len(found.position)} readings of {found.reading} from {told}."]
    if found.order:
        scatter = quantity(found.scatter, "length")
        lines.append(f"Smoothed by a polynomial of order {found.order}; they scatter by {scatter}.")
    return ProfileAnswer(
        key=found.key,
        profile=kind.written(rows),
        readings=len(found.position),
        told=texts(lines),
    )


def _quantity(key: str, text: str, dimension: Dimension) -> float:
    try:
        value = parse_quantity(text, dimension)
    except InputError as error:
        raise InputError(replace(error.problems[0], key=key)) from None
    if not 0.0 < value < 10.0:
        message = "must be more than 0, and less than 10 m"
        raise input_error(key=key, value=text, message=message)
    return value
