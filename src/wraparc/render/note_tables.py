"""Tables that a calculation note alone has: all arcs of all load cases, the shares of a train."""

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

from wraparc.answer.arc_tables import belongs, creep_interval_text
from wraparc.answer.sheet import NONE, Row, Table, headed, number, percent
from wraparc.answer.words import level_of, short
from wraparc.arc import ArcResult, DriveResult
from wraparc.glossary import GLOSSARY

if TYPE_CHECKING:
    from wraparc.train import TrainResult


def arcs_table(results: Sequence[DriveResult], whole: "DriveResult | TrainResult") -> Table:
    """One line for each arc; the creep by the other methods beside that of the first.

    `whole` is what the pulleys are of, a drive or a train: it is judged.
    """
    columns = (
        ("entry_tension", "T1"), ("exit_tension", "T2"), ("tension_ratio", "T1/T2"),
        ("exit_creep", "creep"), ("exit_slip", "slip"), ("peak_shear_angle", "shear angle"),
        ("peak_shear_stress", "shear stress"), ("creep_limit_margin", "margin"),
        ("power_loss", "loss"),
    )  # fmt: skip
    others = ["creep, paper"] if len(results) > 1 else []
    heads = [_head(name, words) for name, words in columns]
    heads[4:4] = [_head("exit_creep", words) for words in others]
    rows = []
    for position, arc in enumerate(results[0]):
        values = [_number(arc, name) for name, _ in columns]
        values[4:4] = [_number(r.arcs[position], "exit_creep") for r in results[1:2]]
        title = arc.arc.load_case
        if len(results[0].drive.pulleys) > 1:
            title += f": {arc.arc.pulley}"
        rows.append(Row(title, (*values, short(whole, arc)), level=level_of(whole, arc)))
    note = (
        "Margin: capacity at the creep limit over the actual tension ratio. Shear angle and shear "
        "stress at their peak."
    )
    for arc in results[0]:
        told = creep_interval_text(arc)
        note += f" Creep in {belongs(arc)}: {told}." if told else ""
    return Table("", tuple(rows), (*heads, "answer"), note)


def shares_table(train: "TrainResult") -> Table:
    """One line for each drive of each load case: what it carries, how fast it turns."""
    from wraparc.answer.train_sheet import trim_text

    rows = []
    for case in train:
        for m in case.members:
            values = (
                percent(m.share),
                number("drum_power", m.drum_power),
                NONE if math.isnan(m.speed_ratio) else f"{100.0 * (m.speed_ratio - 1.0):+.4f}",
                trim_text(m.speed_trim),
                percent(m.motor.motor_load) if m.motor else NONE,
            )
            rows.append(Row(f"{case.case.name}: {m.name}", values, level=level_of(train, m.arc)))
    heads = (
        "share", _head("drum_power", "power"), "speed to the first [%]", "speed trim",
        "motor load",
    )  # fmt: skip
    return Table("Shares and speeds", tuple(rows), heads)


def _head(name: str, words: str) -> str:
    return headed(words, GLOSSARY[name].dimension)


def _number(result: ArcResult, name: str) -> str:
    if name in ("entry_tension", "exit_tension", "tension_ratio"):
        arc = result.arc
        ratio = arc.entry_tension / arc.exit_tension
        value = ratio if name == "tension_ratio" else getattr(arc, name)
    elif not result.status.solved and name != "creep_limit_margin":
        return NONE
    else:
        value = result.scalar(name)
    return number(name, value)
