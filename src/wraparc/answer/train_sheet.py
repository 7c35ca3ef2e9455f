"""The sheet of a solved train: several drives on one belt."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from math import isnan

from wraparc.answer.conveyor_table import conveyor_tables
from wraparc.answer.drive_sheet import drive_sheet, read_sheet, with_sides
from wraparc.answer.input_tables import input_tables
from wraparc.answer.inputs import drive_inputs
from wraparc.answer.key_figures import figure_of, key_figures
from wraparc.answer.sheet import (
    NONE,
    ReserveWanted,
    Row,
    Sheet,
    Table,
    named,
    percent,
    quantity,
    term,
)
from wraparc.answer.sources import Sources
from wraparc.answer.train_inputs import train_inputs
from wraparc.answer.train_words import matching_verdict, train_verdict
from wraparc.arc import DriveResult
from wraparc.checks import TRAIN_BALANCE, Level, idle, least_tension
from wraparc.glossary import GLOSSARY
from wraparc.train import (
    CaseResult,
    Mark,
    Matching,
    MemberResult,
    MotorPoint,
    ShareCurve,
    Train,
    TrainResult,
    TrainStatus,
)
from wraparc.units import GIVEN_DIGITS, RESULT_DIGITS, fixed

Cell = Callable[[MemberResult], str]
Number = Callable[[MemberResult], float]
_ROUNDING = 1e-9  # loss over power that is none


def train_sheet(
    result: TrainResult,
    detail: Sequence[int] | None = None,
    pulleys: Sequence[DriveResult] = (),
    *,
    search: bool = True,
    reserve: ReserveWanted = "",
    probability: bool = False,
    of: Sources | None = None,
) -> Sheet:
    """Return everything to show of a solved train.

    Parameters
    ----------
    result
        The train.
    detail
        Positions of the arcs to show in full, see `drive_sheet`.
    pulleys
        Its pulleys by one method or several; as in the train unless given.
    search
        Whether changes of the drive are tried for the action.
    reserve
        Whether to say what little change of an input changes the verdict: in a line, or of all.
    probability
        Whether to say how probable an OK is.
    of
        Takes the sources, where more refers to them than the sheet.
    """
    results = list(pulleys) or [result.drive_result()]
    arcs = drive_sheet(results, detail, result, of, reserve=reserve, probability=probability)
    checks = 1 + bool(least_tension(result)) + bool(result.train.conditions)
    tables = (*arcs.tables[:checks], *train_tables(result), *arcs.tables[checks:])
    verdict = train_verdict(result, search=search)
    if reserve:
        from wraparc.answer.reserve_words import with_reserve  # solves rows

        verdict = with_reserve(verdict, result, every=reserve == "all")
    if probability:
        from wraparc.answer.probability_words import with_probability  # solves rows

        verdict = with_probability(verdict, result)
    verdict = with_sides(verdict, results)
    return replace(arcs, verdict=verdict, tables=tables)


def train_input_sheet(train: Train) -> Sheet:
    """Return what was read of a train, before it is solved."""
    of = Sources()
    inputs = (*drive_inputs(train, divided=True), *train_inputs(train))
    tables = input_tables(inputs, of)
    return read_sheet(train, (*conveyor_tables(train, of), *tables), of)


def train_tables(result: TrainResult) -> tuple[Table, ...]:
    """Return a table of the drives for each load case of a train."""
    return tuple(case_table(case) for case in result)


def case_table(case: CaseResult) -> Table:
    """Return how the drives share one load case, and the speeds that go with it."""
    members = case.members

    def row(name: str, of: Cell, note: str) -> Row:
        return Row(term(name).title, tuple(of(m) for m in members), term(name).symbol, note, name)

    def told(name: str, of: Number) -> Row:
        return row(name, lambda m: named(name, of(m)), "")

    def known(name: str, of: Number, digits: int) -> Row:
        return row(name, lambda m: _shown(of(m), name, digits), "")

    def small(name: str, of: Number, note: str) -> Row:
        return row(name, lambda m: signed(of(m)), note)

    thick: list[Row] = []
    if any(m.arc.arc.pitch_offset is not None for m in members):
        thick = [small("thickness_term", lambda m: m.thickness_term, "")]
    rows = [
        row("share", _share, ""),
        told("effective_tension", lambda m: m.arc.effective_tension),
        *_run_rows(case),
        told("entry_tension", lambda m: m.arc.entry_tension),
        told("exit_tension", lambda m: m.arc.exit_tension),
        known("drum_power", lambda m: m.drum_power, RESULT_DIGITS),
        known("drum_torque", lambda m: m.drum_torque, RESULT_DIGITS),
        *_motor_rows(members),
        small("speed_ratio", lambda m: m.speed_ratio - 1.0, "exactly"),
        small("contraction_term", lambda m: m.contraction_term, "to first order"),
        small("creep_term", lambda m: m.creep_term, "to first order"),
        small("compression_term", lambda m: m.compression_term, "to first order"),
        *thick,
        small("drum_ratio", lambda m: m.drum_ratio - 1.0, "exactly, for equal diameters"),
        known("rotation_speed", lambda m: m.rotation_speed, 6),
        row("speed_trim", lambda m: trim_text(m.speed_trim), "what a speed control is set to"),
        *[_key_row(case, f.name) for f in key_figures("drives") if _has_key_row(members, f.name)],
        _sensitivity_row(case),
    ]
    note = _precision(case) if case.status is TrainStatus.SOLVED else case.reason
    return Table(f"Drives: load case {case.case.name}", tuple(rows), _names(case), note, "drives")


def _has_key_row(members: Sequence[MemberResult], name: str) -> bool:
    """Whether a key figure is a row of its own: tensions stand above, a margin may be unknown."""
    if name in ("entry_tension", "exit_tension", "effective_tension"):
        return False
    searched = name == "creep_limit_margin"
    return not (searched and all(isnan(figure_of(m.arc, name)) for m in members))


def _key_row(case: CaseResult, name: str) -> Row:
    """Return the row of a key figure of the drives."""
    if name == "exit_creep":
        return _creep_row(case)
    entry, members = term(name), case.members
    if name == "power_loss":
        texts = tuple(_lost(m) for m in members)
        return Row(entry.title, texts, entry.symbol, _loss_note(case), name)
    values = tuple(named(name, figure_of(m.arc, name)) for m in members)
    return Row(entry.title, values, entry.symbol, name=name)


def _share(m: MemberResult) -> str:
    return "not driven" if idle(m.arc.arc) and not isnan(m.share) else percent(m.share)


def _lost(m: MemberResult) -> str:
    """Return what creep costs; of a drum that is not driven nothing but rounding is left."""
    loss = m.arc.energy.power_loss
    return named("power_loss", 0.0 if idle(m.arc.arc) and not isnan(loss) else loss)


def _run_rows(case: CaseResult) -> list[Row]:
    """Return the rise of tension before each pulley, where there is any."""
    if len(case.case.runs) == 0:
        return []
    entry = term("run")
    texts = (NONE, *[named("run", run) for run in case.case.runs])
    return [Row(entry.title, texts, entry.symbol, name="run")]


def _names(case: CaseResult) -> tuple[str, ...]:
    return tuple(m.name for m in case.members)


def _shown(value: float, name: str, digits: int) -> str:
    return quantity(value, term(name).dimension, digits)


def _motor_rows(members: Sequence[MemberResult]) -> list[Row]:
    points = [m.motor for m in members if m.motor is not None]
    if len(points) == 0:
        return []

    def of(name: str, show: Callable[[float], str]) -> Row:
        texts = [
            show(getattr(m.motor, name)) if m.motor is not None else "follows" for m in members
        ]
        return Row(term(name).title, tuple(texts), term(name).symbol, name=name)

    def told(name: str) -> Row:
        return of(name, lambda value: named(name, value))

    return [
        of("motor_load", percent),
        told("motor_power"),
        told("motor_torque"),
        of("motor_speed", lambda value: quantity(value, "rotation_speed", GIVEN_DIGITS)),
        *[told(name) for name in _motor_extras(points)],
    ]


def _motor_extras(points: Sequence[MotorPoint]) -> list[str]:
    """Return what there is to tell between mains and drum: nothing that is the same or unknown."""
    names = []
    if any(p.gear_speed != p.motor_speed for p in points):
        names.append("gear_speed")
        names.append("coupling_loss")
    if any(abs(p.gear_loss) > _ROUNDING * abs(p.motor_power) for p in points):
        names.append("gear_loss")
    if not all(isnan(p.electrical_power) for p in points):
        names.append("motor_loss")
        names.append("electrical_power")
    return names


def signed(ratio: float) -> str:
    """Return a small ratio as percent with its sign: ``-0.3121 %``."""
    return fixed(ratio, 4, "percent signed")


def trim_text(trim: float) -> str:
    """Return a trim as percent of nominal: ``99.655 %``."""
    return fixed(trim, 3, "percent fixed")


def _creep_row(case: CaseResult) -> Row:
    texts = []
    for m in case.members:
        creep = m.arc.exit_creep
        part = f" ({percent(m.arc.share_of_limit)})"
        texts.append(f"{named('exit_creep', creep)}{'' if isnan(creep) else part}")
    over = any(not m.arc.within_creep_limit for m in case.members)
    entry = term("exit_creep")
    level = Level.ATTENTION if over else None
    note = "and as a part of the limit"
    return Row(entry.title, tuple(texts), entry.symbol, note, "exit_creep", level)


def _loss_note(case: CaseResult) -> str:
    if isnan(case.loss_ratio):
        return ""
    ratio = f"{percent(case.loss_ratio)} of the power"
    if isnan(case.power_loss):
        return f"together {ratio}"
    return f"together {named('power_loss', case.power_loss)}, {ratio}"


def _sensitivity_row(case: CaseResult) -> Row:
    texts = [
        percent(case.share_per_trim(i), 2) if case.sensitivity[i][i] != 0.0 else NONE
        for i in range(len(case.members))
    ]
    entry = term("share_sensitivity")
    return Row(entry.title, tuple(texts), entry.symbol, "of the load", "share_sensitivity")


def _precision(case: CaseResult) -> str:
    miss = max(case.tension_error, case.speed_error, TRAIN_BALANCE)
    return f"Tensions, speeds and torques of the drives agree within {miss:.0e} of their size."


def matching_sheet(result: TrainResult, matching: Matching) -> Sheet:
    """Return how exactly the drives of a train must be matched."""
    tables = [
        case_table(matching.case),
        _curve_table(
            "trim",
            f"Against {GLOSSARY[matching.trim.quantity].title.lower()}",
            matching.trim,
            trim_text,
        ),
        _curve_table(
            "diameter", "Against diameter, pulleys turning as before", matching.diameter, trim_text
        ),
        _curve_table(
            "load", "Against load, speeds and take-up as they are", matching.load, percent
        ),
        _changes_table(matching),
    ]
    pulleys = drive_sheet([result.drive_result()], [])
    verdict = matching_verdict(result, matching)
    title = f"{pulleys.title}: matching of {_names(matching.case)[matching.drive]}"
    return Sheet(title, "", verdict, tuple(tables), pulleys.remarks, pulleys.sources)


def _curve_table(name: str, title: str, curve: ShareCurve, text: Callable[[float], str]) -> Table:
    """Where something happens along a curve."""
    names = [m.name for m in curve.case.members]
    rows = tuple(
        Row(
            f"{names[mark.drive]} {mark.kind}",
            (text(mark.value),),
            note=_place(mark),
            name=mark.kind.name.lower(),
        )
        for mark in curve.marks
    )
    low, high = text(float(curve.values[0])), text(float(curve.values[-1]))
    entry = GLOSSARY[curve.quantity]
    of = "" if curve.axis.value == "load_ratio" else f" of {names[curve.drive]}"
    return Table(title, rows, note=f"{entry.title}{of} from {low} to {high}.", name=name)


def _place(mark: Mark) -> str:
    # rounded first, and 0 added, so that next to nothing is not -0
    return "shares " + ", ".join(f"{round(100.0 * share, 1) + 0.0:.1f} %" for share in mark.shares)


def _changes_table(matching: Matching) -> Table:
    rows = []
    for change in matching.changes:
        lagging = change.lagging
        what = f"{named('lagging_thickness', change.wear)} worn off {change.pulley}"
        if lagging is not None:
            what = f"{change.pulley} {lagging.condition}"
        shares = tuple(percent(m.share) for m in change.after.members)
        note = change.after.reason
        rows.append(Row(what, shares, note=note))
    before = tuple(percent(m.share) for m in matching.case.members)
    rows.insert(0, Row("now", before))
    return Table(
        "Shares when one pulley changes, speeds constant",
        tuple(rows),
        _names(matching.case),
        name="changed",
    )
