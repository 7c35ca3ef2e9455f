"""The sheet of a solved drive."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

from wraparc.answer.arc_tables import (
    METHOD_TITLES,
    Results,
    answer_table,
    belongs,
    capacity_table,
    creep_table,
    energy_table,
)
from wraparc.answer.checks_table import check_table
from wraparc.answer.conditions_table import conditions_table
from wraparc.answer.conveyor_table import conveyor_tables
from wraparc.answer.design_values import comparison_table
from wraparc.answer.input_tables import input_table, input_tables
from wraparc.answer.inputs import drive_inputs
from wraparc.answer.key_figures import figure_of, key_figures
from wraparc.answer.least_tension import least_table, margins_table
from wraparc.answer.reserve_check import judge_uncertain
from wraparc.answer.sheet import (
    NONE,
    ReserveWanted,
    Row,
    Sheet,
    Table,
    Verdict,
    headed,
    named,
    number,
    percent,
    quantity,
    term,
)
from wraparc.answer.sources import Sources
from wraparc.answer.wear_table import life_table, wear_table
from wraparc.answer.words import (
    alone_of,
    format_verdict,
    level_of,
    short,
    stated_action,
    under,
    verdict,
)
from wraparc.arc import ArcResult, DriveResult, WrapArc
from wraparc.checks import Level, before, judge, least_tension
from wraparc.drive import CREEP_LIMIT, Drive
from wraparc.drive.load_case import Resultant, resultant
from wraparc.train import Train, TrainResult
from wraparc.units import GIVEN_DIGITS, RESULT_DIGITS, Cell


def drive_sheet(
    results: Sequence[DriveResult],
    detail: Sequence[int] | None = None,
    train: TrainResult | None = None,
    of: Sources | None = None,
    *,
    reserve: ReserveWanted = "",
    probability: bool = False,
) -> Sheet:
    """Return everything to show of a solved drive.

    Parameters
    ----------
    results
        The drive solved by one method, or by several; the first gives the verdict.
    detail
        Positions in `DriveResult.arcs` to show in full; the governing arc unless given.
    train
        What the pulleys are of, where they are those of a train: it is judged.
    of
        Takes the sources, where more refers to them than the sheet.
    reserve
        Whether to say what little change of an input changes the verdict: in a line, or of all.
    probability
        Whether to say how probable an OK is.
    """
    first = results[0]
    whole = train or first
    if detail is None:
        detail = [first.arcs.index(first.governing)]
    of = Sources() if of is None else of
    tables = [conditions_table(first, whole)] if first.drive.conditions else []
    tables.append(check_table(judge_uncertain(whole), of))
    least = least_table(whole)
    tables += [least] if least else []
    tables += conveyor_tables(first.drive if train is None else train.train, of, train)
    tables.append(summary_table(results, whole))
    if len(first) > 1:
        tables.append(figures_table(results))
    tables.append(loads_table(first))
    for position in detail:
        found = arc_tables(first, tuple(r.arcs[position] for r in results), of)
        tables += [table for name, table in found.items() if name != "loads"]
    if any(pulley.across for pulley in first.drive.pulleys):
        from wraparc.answer.across_tables import across_tables

        tables += across_tables(first)
    own = verdict(first, search=train is None)
    if reserve:
        from wraparc.answer.reserve_words import reserve_table, with_reserve  # solves rows

        own = with_reserve(own, whole, every=reserve == "all") if train is None else own
        tables += [reserve_table(whole)] if reserve == "all" else []
    if probability:
        from wraparc.answer.probability_words import probability_table, with_probability

        own = with_probability(own, whole) if train is None else own
        tables.append(probability_table(whole))
    return Sheet(
        title=first.drive.title or "Drive",
        subtitle=first.drive.description,
        verdict=with_sides(own, results),
        tables=tuple(tables),
        remarks=(*judge(first).remarks, *method_remarks(results)),
        kept=tuple(method_remarks(results)),
        sources=of.listed(),
    )


def with_sides(told: Verdict, results: Sequence[DriveResult]) -> Verdict:
    """Add where two methods stand on different sides of a creep limit, each limit once."""
    places: dict[float, list[str]] = {}
    for arcs in zip(*results, strict=True):
        one, other = arcs[0], arcs[-1]
        solved = one.status.solved and other.status.solved
        if not solved or one.within_creep_limit == other.within_creep_limit:
            continue
        creeps = " and ".join(
            f"{named('exit_creep', abs(arc.exit_creep))} ({METHOD_TITLES[arc.method]})"
            for arc in (one, other)
        )
        places.setdefault(one.arc.creep_limit, []).append(f"{belongs(one)}, creeps {creeps}")
    said = tuple(
        f"The methods differ in whether creep passes the limit {named('creep_limit', limit)}: "
        f"{'; '.join(there)}. The paper lumps the contraction of the belt over the arc that is "
        "left, the solver adds it up along the arc."
        + (" The customary limit was set with the paper's." if limit == CREEP_LIMIT else "")
        for limit, there in places.items()
    )
    return replace(told, sentences=(*said, *told.sentences))


def input_sheet(drive: Drive) -> Sheet:
    """Return what was read of a drive, and what there is to remark on it before it is solved."""
    of = Sources()
    inputs = input_tables(drive_inputs(drive), of)
    tables = (*conveyor_tables(drive, of), *inputs)
    return read_sheet(drive, tables, of)


def read_sheet(of: Drive | Train, inputs: Sequence[Table], sources: Sources) -> Sheet:
    """Return what was read, below what needs no solving to be judged."""
    cases = of.load_cases if isinstance(of, Drive) else of.cases
    counted = f"{len(of.pulleys)} {'pulley' if len(of.pulleys) == 1 else 'pulleys'}, "
    counted += f"{len(cases)} load {'case' if len(cases) == 1 else 'cases'}."
    judged = before(of)
    own = Verdict(Level.OK, f"Drive file valid: {counted}", (), str(Level.OK), name="check")
    implausible = sum(c.name == "usual_sizes" and c.missed for c in judged.checks)
    if implausible:
        inputs_ = "1 input" if implausible == 1 else f"{implausible} inputs"
        own = replace(own, level=Level.ATTENTION, text=f"Drive file valid, {inputs_} implausible.")
    told = under(own, format_verdict(judged, judged.full, stated_action(judged)))
    told = replace(told, checks_at=Verdict.checks_at)
    found = check_table(judged, sources, "Checks before solving")
    title = of.title or ("Drive" if isinstance(of, Drive) else "Train")
    about = "" if isinstance(of, Drive) else of.description
    return Sheet(title, about, told, (found, *inputs), judged.remarks, sources.listed(), kept=())


def arc_sheet(result: ArcResult) -> Sheet:
    """Return what there is to show of one arc without its drive."""
    tables = [answer_table((result,)), creep_table((result,))]
    capacity = capacity_table(result)
    tables += [capacity] if capacity else []
    return Sheet(
        title=belongs(result) if result.arc.pulley else "Wrap arc",
        subtitle=str(result.status),
        tables=tuple(tables),
    )


def arc_tables(result: DriveResult, results: Results, of: Sources) -> dict[str, Table]:
    """Return every table of an arc, by name.

    Parameters
    ----------
    result
        The drive.
    results
        The arc by one method or by several; the first is told in full.
    of
        Takes up the sources.
    """
    first, drive = results[0], result.drive
    case = drive.load_case(first.arc.load_case)
    lagging = drive.pulley(first.arc.pulley).lagging_in(case.condition)
    solved = tuple(other for other in results if other.status.solved)
    carried = first.status.solved
    found = {
        "answer": answer_table(solved) if solved else None,
        "creep": creep_table(solved) if solved else None,
        "capacity": capacity_table(first),
        "margins": margins_table(result, first),
        "comparison": comparison_table(first, lagging, of),
        "energy": energy_table(first) if carried else None,
        "loads": loads_table(DriveResult(drive, (first,))),
        "wear": wear_table(first, lagging) if carried else None,
        "life": life_table(first, lagging, of) if carried else None,
        "inputs": input_table(drive, first.arc, of),
    }
    return {key: table for key, table in found.items() if table is not None}


def summary_table(results: Sequence[DriveResult], whole: "DriveResult | TrainResult") -> Table:
    """One line for each arc and method; units stand in the heads, to keep the lines short.

    `whole` is what the pulleys of the first result are of, a drive or a train: it is judged.
    """
    # the slack side is at T1 where a pulley brakes
    brakes = any(arc.arc.side < 0.0 for result in results for arc in result)
    heads = (
        headed("T1", "force"),
        headed("T2", "force"),
        "T1/T2",
        headed("creep", "length"),
        "of limit",
        headed("min. T1" if brakes else "min. T2", "force"),
        "",
    )
    rows = []
    for result, of in zip(results, (whole, *results[1:]), strict=True):
        for arc in result:
            title = _title_of(arc, several=len(results) > 1)
            values = (*_summary_values(result, arc), short(of, arc))
            rows.append(Row(title, values, level=level_of(of, arc)))
    return Table("All load cases and pulleys", tuple(rows), heads, name="cases")


def figures_table(results: Sequence[DriveResult]) -> Table:
    """One line for each arc and method: the key figures that the line on its load case lacks."""
    names = [figure.name for figure in key_figures("arcs")]
    heads = tuple(headed(term(name).title, term(name).dimension) for name in names)
    rows = [
        Row(
            _title_of(arc, several=len(results) > 1),
            tuple(number(name, figure_of(arc, name)) for name in names),
        )
        for result in results
        for arc in result
    ]
    return Table("Key figures", tuple(rows), heads, name="figures")


def _title_of(arc: ArcResult, *, several: bool) -> str:
    """Return load case and pulley of an arc, and the method where there are several."""
    method = f", {METHOD_TITLES[arc.method]}" if several else ""
    return f"{arc.arc.load_case}: {arc.arc.pulley}{method}"


def loads_of(drive: Drive, of: WrapArc) -> Resultant:
    """Return what the belt does to a pulley and bears there."""
    strength, mass = drive.belt.breaking_strength, drive.pulley(of.pulley).mass
    known = (math.nan if strength is None else strength * of.width), mass or math.nan
    return resultant(of.entry_tension, of.exit_tension, of.wrap_angle, *known)


def loads_table(result: DriveResult) -> Table:
    """One line for each pulley and load case: its resultant, and the safety of the belt there."""
    drive, belt, rows = result.drive, result.drive.belt, []
    weighed = [
        f"{p.name} {quantity(p.mass, 'mass', GIVEN_DIGITS)}" for p in drive.pulleys if p.mass
    ]
    strength = math.nan if belt.breaking_strength is None else belt.breaking_strength
    for arc in result:
        of = loads_of(drive, arc.arc)
        cells = (
            named("resultant_force", of.resultant_force),
            named("resultant_angle", of.resultant_angle),
            named("belt_safety", of.belt_safety),
            named("most_shaft_load", of.most_shaft_load),
            named("least_shaft_load", of.least_shaft_load),
        )
        rows.append(Row(f"{arc.arc.load_case}: {arc.arc.pulley}", cells[: 5 if weighed else 3]))
    note = (
        "Resultant of the belt tensions for shaft and bearings, from the line of T1 towards that "
        "of T2, the weight of the pulley left out. "
    )
    if weighed:
        note += (
            f"With the weight ({', '.join(weighed)}): maximum for a resultant straight down, "
            "minimum for one straight up; for a level one the root of the sum of both squares. "
        )
    if belt.breaking_strength is None:
        note += "Safety factor of the belt: strength missing."
    else:
        given = quantity(strength, "force_per_width", GIVEN_DIGITS)
        note += f"Safety factor: strength {given} over the larger tension; see the checks."
    heads = ("resultant", "direction", "belt", "with weight, most", "least")
    shown = heads[: 5 if weighed else 3]
    return Table("Loads of pulleys and belt", tuple(rows), shown, note, "loads")


def _summary_values(of: DriveResult, result: ArcResult) -> tuple[str, ...]:
    arc = result.arc
    return (
        number("entry_tension", arc.entry_tension),
        number("exit_tension", arc.exit_tension),
        number("tension_ratio", arc.entry_tension / arc.exit_tension),
        number("exit_creep", result.exit_creep),
        percent(result.share_of_limit),
        _least(of, result),
    )


def _least(of: DriveResult, result: ArcResult) -> str:
    """Return the least slack-side tension of an arc; that of a train is not one of its pulleys'."""
    if len(of.drive.pulleys) > 1:
        return NONE
    found = least_tension(alone_of(of, result))
    if found is None:
        return NONE
    if math.isinf(found.tension):
        return "none"
    return Cell(found.tension, "force", RESULT_DIGITS, "bare up", name="tension")


def method_remarks(results: Sequence[DriveResult]) -> Iterator[str]:
    """Yield what to know of results by further methods."""
    for other in results[1:]:
        for arc in other:
            if not arc.status.solved:
                yield f"{belongs(arc)}, by the {METHOD_TITLES[arc.method]}: {arc.status}"
    if any(result.arcs[0].method == "paper" for result in results):
        yield (
            "The paper's integration lumps the shrinkage of the belt over the whole wrap and "
            "overstates the creep of soft belts; it has no capacities."
        )
        if any(arc.arc.offset > 0.0 or arc.arc.centrifugal > 0.0 for arc in results[0]):
            yield (
                "The paper's integration takes the belt as a string on the lagging surface: "
                "thickness, "
                "cover and mass of the belt are not counted in it."
            )
