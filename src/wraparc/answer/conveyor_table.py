"""The resistances of a conveyor and the tensions that follow: tables, and plain data."""

from collections.abc import Sequence
from typing import Any

from wraparc.answer.conveyor_parts import (
    curves_table,
    flights_table,
    parts_data,
    sag_table,
    standstill_table,
    take_up_table,
    tension_table,
)
from wraparc.answer.sheet import NONE, Row, Table, headed, named, number, quantity
from wraparc.answer.sources import Sources
from wraparc.conveyor import Conveyor, Resistance, State, cema_pull
from wraparc.conveyor.consequences import CEMA_SOURCE
from wraparc.conveyor.resistance import GIVEN
from wraparc.drive import Drive
from wraparc.train import Train, TrainResult, states_of
from wraparc.units import GIVEN_DIGITS, RESULT_DIGITS, bare

_TITLES = {
    "main": ("Main resistance", "F_H"),
    "secondary": ("Secondary resistances", "F_N"),
    "loading": ("Loading of the material", "F_bA + F_f"),
    "wrap": ("Belt bending at pulleys", "F_l"),
    "bearing": ("Pulley bearings", "F_t"),
    "cleaner": ("Belt cleaners", "F_r"),
    "slope": ("Slope resistance", "F_St"),
    "special": ("Special resistances", "F_S"),
    "skirt": ("Skirts", "F_gL"),
    "tilt": ("Idler toe-in", "F_eps"),
    "inertia": ("Acceleration", "F_a"),
}
_NOTE = (
    "Resistances of both strands; negative ones drive the belt. The take-up tension is the "
    "same while starting, stopping and running."
)


def conveyor_tables(
    of: Drive | Train, sources: Sources, result: TrainResult | None = None
) -> list[Table]:
    """Return the resistances and tensions of the load cases that a conveyor gives, if it does.

    Parameters
    ----------
    of
        A drive or a train.
    sources
        Takes the sources.
    result
        The train as it was solved: its drives share as they were found to.
    """
    states, conveyor = states_of(of, result), of.conveyor
    if not states or conveyor is None:
        return []
    tables = [_forces_table(conveyor, states, sources)]
    if conveyor.flights or len(conveyor.drives) > 1 or conveyor.itemised:
        tables.append(tension_table(conveyor, states))
        tables.append(flights_table(conveyor, states))
    tables += sag_table(conveyor, states, sources)
    tables += curves_table(conveyor, states, sources)
    if conveyor.flights:
        tables.append(take_up_table(conveyor, states, of.belt, sources))
        tables.append(standstill_table(conveyor, states, of.pulleys))
    return tables


def _forces_table(conveyor: Conveyor, states: Sequence[State], of: Sources) -> Table:
    """Return what resists, and the tensions at the drives and at the far end."""
    heads = tuple(headed(state.name, "force") for state in states)

    def row(title: str, symbol: str, values: Sequence[float], note: str = "") -> Row:
        return Row(title, tuple(number("tension", v) for v in values), symbol, note)

    rows = []
    by_name = [{r.name: r for r in state.resistances} for state in states]
    for name, titles in _TITLES.items():
        together: list[Resistance] = [one[name] for one in by_name if name in one]
        if any(resistance.total for resistance in together):
            first = together[0]
            note = "input" if first.source == GIVEN else of.number(first.source)
            values = [one[name].total if name in one else 0.0 for one in by_name]
            rows.append(row(*titles, values, note))
    rows.append(row("Effective tension", "T1 - T2", [s.pull for s in states], "their sum"))
    by_cema = [cema_pull(conveyor, state) for state in states]
    if conveyor.cema is not None and None not in by_cema:
        cells = tuple(
            NONE if value is None or state.kind != "running" else number("tension", value)
            for value, state in zip(by_cema, states, strict=True)
        )
        rows.append(Row("The same by CEMA", cells, "Te", of.number(CEMA_SOURCE)))
    if len(conveyor.drives) > 1:
        for i, drive in enumerate(conveyor.drives):
            entries = [state.drives[i].entry for state in states]
            exits = [state.drives[i].exit for state in states]
            rows.append(row(f"Entry tension, {drive.pulley}", "T1", entries))
            rows.append(row(f"Exit tension, {drive.pulley}", "T2", exits))
    else:
        rows.append(row("Entry tension", "T1", [s.entry for s in states]))
        rows.append(row("Exit tension", "T2", [s.exit for s in states]))
        rows.append(row(*_far_end(conveyor, states)))
    title = "Conveyor: resistances and tensions"
    short = _short_table(conveyor, states)
    return Table(title, tuple(rows), heads, _NOTE, "conveyor", short)


def _short_table(conveyor: Conveyor, states: Sequence[State]) -> Table:
    """Return what the first screen shows: Te, power, and the ends of the tension by load case."""
    heads = tuple(
        headed(words, dimension)  # type: ignore[arg-type]
        for words, dimension in (
            ("Te", "force"), ("power", "power"), ("highest", "force"), ("lowest", "force"),
        )
    )  # fmt: skip
    rows = tuple(
        Row(
            state.name,
            (
                number("tension", state.pull),
                NONE
                if conveyor.speed is None or state.acceleration != 0.0
                else bare(state.pull * conveyor.speed, "power", RESULT_DIGITS),
                number("tension", state.highest),
                number("tension", state.lowest),
            ),
        )
        for state in states
    )
    weight = quantity(conveyor.weight, "mass", GIVEN_DIGITS)
    note = f"Take-up tension {named('tension', conveyor.take_up)}, counterweight {weight}."
    return Table("Conveyor", rows, heads, note, "conveyor")


def conveyor_data(of: Drive | Train, result: TrainResult | None = None) -> dict[str, Any] | None:
    """Return the same for JSON [N], or None where the tensions are given."""
    states, conveyor = states_of(of, result), of.conveyor
    if not states or conveyor is None:
        return None
    return {
        "length": conveyor.length,
        "lift": conveyor.lift,
        "length_coefficient": conveyor.coefficient,
        "material_mass": conveyor.material,
        "take_up_tension": conveyor.take_up,
        "counterweight": conveyor.weight,
        "load_cases": [_state_data(conveyor, state) for state in states],
        **parts_data(conveyor, states, of.belt.axial_stiffness),
    }


def _state_data(conveyor: Conveyor, state: State) -> dict[str, Any]:
    speed, rest = conveyor.speed, state.standstill
    return {
        "name": state.name,
        "kind": state.kind,
        "resistances": {
            r.name: {"carrying": r.carrying, "return": r.returning, "source": r.source}
            for r in state.resistances
        },
        "effective_tension": state.pull,
        "power": None if speed is None else state.pull * speed,
        "acceleration": state.acceleration,
        "entry_tension": state.entry,
        "exit_tension": state.exit,
        "head_tension": state.head,
        "tail_tension": state.tail,
        "highest_tension": state.highest,
        "lowest_tension": state.lowest,
        "cema_effective_tension": cema_pull(conveyor, state),
        "drives": [
            {
                "pulley": drive.pulley, "share": drive.share, "entry_tension": drive.entry,
                "exit_tension": drive.exit,
            }
            for drive in state.drives
            if drive.pulley
        ],
        "points": [
            {
                "strand": p.strand, "position": p.position, "name": p.name, "kind": p.kind,
                "tension_before": p.before, "tension_after": p.after,
            }
            for p in state.points
        ],
        "flights": [
            {
                "flight": s.flight, "strand": s.strand, "start_tension": s.start,
                "end_tension": s.end, "lowest_tension": s.least, "mass": s.mass,
                "resistances": dict(s.forces), "driven": s.driven,
            }
            for s in state.stretches
        ],
        "standstill": None
        if rest is None
        else {
            "slope_force": rest.slope,
            "main_resistance": rest.friction,
            "holding_force": rest.holding(conveyor.rest_friction),
        },
    }  # fmt: skip


def _far_end(conveyor: Conveyor, states: Sequence[State]) -> tuple[str, str, list[float]]:
    if conveyor.course_drives[0].at == "head":
        return "Tension at the tail", "", [state.tail for state in states]
    return "Tension at the head", "", [state.head for state in states]
