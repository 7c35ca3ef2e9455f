"""The resistances of a conveyor and the tensions that follow: a table, and plain data."""

from typing import Any

from wraparc.answer.sheet import Row, Table, headed, number
from wraparc.answer.sources import Sources
from wraparc.conveyor import Conveyor, Resistance, State
from wraparc.conveyor.resistance import GIVEN
from wraparc.drive import Drive

_TITLES = {
    "main": ("Main resistance", "F_H"),
    "secondary": ("Secondary resistances", "F_N"),
    "slope": ("Slope resistance", "F_St"),
    "special": ("Special resistances", "F_S"),
    "inertia": ("Acceleration", "F_a"),
}
_NOTE = (
    "Resistances of both strands; negative ones drive the belt. The take-up tension is the "
    "same while starting, stopping and running."
)


def conveyor_tables(drive: Drive, of: Sources) -> list[Table]:
    """Return the resistances and tensions of the load cases that a conveyor gives, if it does."""
    states = _states(drive)
    if not states or drive.conveyor is None:
        return []
    heads = tuple(headed(state.name, "force") for state in states)

    def row(title: str, symbol: str, values: list[float], note: str = "") -> Row:
        return Row(title, tuple(number("tension", v) for v in values), symbol, note)

    rows = []
    for together in zip(*(state.resistances for state in states), strict=True):
        first: Resistance = together[0]
        if any(resistance.total for resistance in together):
            note = "input" if first.source == GIVEN else of.number(first.source)
            rows.append(row(*_TITLES[first.name], [r.total for r in together], note))
    rows.append(row("Effective tension", "T1 - T2", [s.pull for s in states], "their sum"))
    rows.append(row("Entry tension", "T1", [s.entry for s in states]))
    rows.append(row("Exit tension", "T2", [s.exit for s in states]))
    rows.append(row(*_far_end(drive.conveyor, states)))
    return [Table("Conveyor: resistances and tensions", tuple(rows), heads, _NOTE, "conveyor")]


def conveyor_data(drive: Drive) -> dict[str, Any] | None:
    """Return the same for JSON [N], or None where the tensions are given."""
    states = _states(drive)
    if not states or drive.conveyor is None:
        return None
    conveyor = drive.conveyor
    return {
        "length_coefficient": conveyor.coefficient,
        "material_mass": conveyor.material,
        "take_up_tension": conveyor.take_up,
        "load_cases": [_state_data(state) for state in states],
    }


def _state_data(state: State) -> dict[str, Any]:
    return {
        "name": state.name,
        "kind": state.kind,
        "resistances": {
            r.name: {"carrying": r.carrying, "return": r.returning, "source": r.source}
            for r in state.resistances
        },
        "effective_tension": state.pull,
        "entry_tension": state.entry,
        "exit_tension": state.exit,
        "head_tension": state.head,
        "tail_tension": state.tail,
    }


def _far_end(conveyor: Conveyor, states: tuple[State, ...]) -> tuple[str, str, list[float]]:
    if conveyor.drive_at == "head":
        return "Tension at the tail", "", [state.tail for state in states]
    return "Tension at the head", "", [state.head for state in states]


def _states(drive: Drive) -> tuple[State, ...]:
    """Return the load cases that still are what the conveyor gave."""
    if drive.conveyor is None or len(drive.pulleys) != 1:
        return ()
    name = drive.pulleys[0].name
    given = {
        case.name.removesuffix(f", {case.condition}"): case.tensions[name]
        for case in drive.load_cases  # once for each of several conditions
    }
    return tuple(
        state
        for state in drive.conveyor.states()
        if state.name in given
        and (given[state.name].entry, given[state.name].exit) == (state.entry, state.exit)
    )
