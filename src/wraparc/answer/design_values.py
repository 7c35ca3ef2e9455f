"""A result beside constant friction: Euler and Eytelwein, CEMA, DIN 22101, practice."""

import math

from wraparc.answer.least_tension import at_least
from wraparc.answer.sheet import Row, Table, between, named, quantity
from wraparc.answer.sources import Sources
from wraparc.arc import ArcResult, ClassicalDrive, classical_drives
from wraparc.checks import Level
from wraparc.drive import Lagging
from wraparc.units import Cell


def comparison_table(result: ArcResult, lagging: Lagging, of: Sources) -> Table:
    """Set the arc beside what constant friction asks for."""
    arc, c = result.arc, result.capacities
    given = min(arc.entry_tension, arc.exit_tension)
    ratio = max(arc.entry_tension, arc.exit_tension) / given
    mean = math.log(ratio) / arc.wrap_angle
    asked = _texts(mean, ratio, given, arc.wrap_angle if mean else 0.0)
    rows = [Row("This load, whole wrap slipping", asked, name="load")]
    if not math.isnan(c.equivalent_friction):
        limit = _texts(
            c.equivalent_friction,
            c.creep_limit_capacity,
            c.least_exit_tension,
            math.nan,
        )
        rows.append(Row("At the creep limit, as computed", limit, name="at_creep_limit"))
    rows += [_design_row(classical, result, of) for classical in known(result, lagging)]
    if lagging.surface:
        note = (
            "T2: Cw (T1 - T2) with Cw = 1/(exp(mu phi) - 1). Slipping arc: "
            "ln(T1/T2)/mu. Design values are constant and take no account of creep."
        )
    else:
        note = "Surface of the lagging missing: no design values apply."
    ratio_head = "T1/T2 up to" if arc.side > 0.0 else "T2/T1 up to"
    heads = ("friction", ratio_head, "T2", "slipping arc")
    return Table("Compared with constant friction", tuple(rows), heads, note, "constant")


def known(result: ArcResult, lagging: Lagging) -> tuple[ClassicalDrive, ...]:
    """Return the design values of the lagging's surface."""
    return classical_drives(result.arc, lagging)


def _texts(mu: float, ratio: float, slack: float, arc: float) -> tuple[str, ...]:
    return (
        quantity(mu, "number"),
        named("tension_ratio", ratio),
        named("tension", slack),
        named("active_arc", arc),
    )


def _design_row(drive: ClassicalDrive, result: ArcResult, of: Sources) -> Row:
    design, arc = drive.design, result.arc
    standard = design.standard[0].upper() + design.standard[1:]
    slips = drive.slipping_arc[0] > arc.wrap_angle
    low, high = design.friction
    values = (
        Cell(high, "number", form="-", other=low),
        _pair("tension_ratio", drive.ratio),
        _at_least(*drive.slack_tension),
        "gross slip" if slips else _pair("active_arc", drive.slipping_arc),
    )
    note = of.note(design.provenance)
    title = ", ".join(part for part in (standard, design.surface, design.condition) if part)
    level = Level.ATTENTION if slips else None
    return Row(title, values, note=note, name="design_value", level=level)


def _at_least(low: float, high: float) -> str:
    """Return the tensions that are needed, the higher rounded up as every minimum is."""
    return at_least(high) if high - low <= 1e-9 * high else between("tension", low, high, "to up")


def _pair(name: str, ends: tuple[float, float]) -> str:
    return between(name, *ends, form="-")
