"""The tables of one solved arc, by one method or by several side by side."""

import math
from collections.abc import Callable

from wraparc.answer.key_figures import figure_of, further_figures
from wraparc.answer.sheet import Row, Table, between, named, percent, row_of, term
from wraparc.arc import ArcResult
from wraparc.checks import Level
from wraparc.friction import Constant, FrictionLaw, PressurePower

Results = tuple[ArcResult, ...]

#: What a method is called in headings.
METHOD_TITLES = {"distributed": "distributed", "paper": "paper's integration"}


def heads(results: Results) -> tuple[str, ...]:
    """Return the headings of value columns; one method alone, if the main one, needs none."""
    if len(results) == 1 and results[0].method == "distributed":
        return ("",)
    return tuple(METHOD_TITLES.get(r.method, r.method) for r in results)


def belongs(result: ArcResult) -> str:
    """Return where a result belongs, ``pulley head, load case full``."""
    return f"pulley {result.arc.pulley}, load case {result.arc.load_case}"


def independent_of_slip(law: FrictionLaw) -> bool:
    """Return whether friction is the same at any slip: the whole wrap then can slip for good."""
    return isinstance(law, Constant | PressurePower)


def _values(results: Results, of: Callable[[ArcResult], str]) -> tuple[str, ...]:
    return tuple(of(result) for result in results)


def answer_table(results: Results) -> Table:
    """Creep, slip, shear and pressure of one arc."""

    def row(name: str, note: str = "", level: Level | None = None) -> Row:
        values = (getattr(result, name) for result in results)
        return row_of(name, *values, note=note, level=level)

    first = results[0]
    share = f"{percent(first.share_of_limit)} of the limit"
    notes = [f"{share}, {named('creep_limit', first.arc.creep_limit)}"]
    notes += ["negative: with the belt"] if first.exit_creep < 0.0 else []
    notes += [told] if (told := creep_interval_text(first)) else []
    level, sides = _creep_level(first), {r.within_creep_limit for r in results if r.status.solved}
    if len(sides) > 1:
        notes.append("the methods differ in whether it passes")
        level = Level.ATTENTION if level is Level.OK else level
    where = f"at {named('peak_shear_position', first.peak_shear_position)} from the entry"
    pressure = Row(
        "Wrap pressure, entry to exit",
        _values(results, _pressures),
        "p",
        name="wrap_pressures",
    )
    rows = [
        row(
            "exit_creep",
            "; ".join(notes),
            level,
        ),
        row("exit_slip"),
        row("peak_shear_angle", where),
        row("peak_shear_stress"),
        pressure,
        row("mean_friction", "equivalent constant friction over the whole wrap"),
        row("active_arc", "exit part over which 99 % of the tension change takes place"),
        *(
            [row("k_factor", "belt modulus x width / active arc (equation 7 of the paper)")]
            if not math.isnan(first.k_factor)
            else []
        ),
    ]
    if any(result.sticks for result in results):
        rows.append(row("stuck_arc", "entry part where the belt does not slip"))
    if not all(math.isnan(result.outside_tested_share) for result in results):
        rows.append(_outside_row(results))
    note = "belt slower than the lagging surface, entry to exit"
    if first.exit_creep_ratio < 0.0:
        note = "negative: belt faster than the lagging surface, entry to exit"
    rows.append(Row("Creep ratio", _values(results, _creep_ratios), "g", note, "creep_ratio"))
    rows += [_key_row(results, figure.name) for figure in further_figures()]
    return Table(f"Result: {belongs(first)}", tuple(rows), heads(results), name="result")


def creep_interval_text(result: ArcResult) -> str:
    """Return the interval of the creep by its law, ``95 % by the law: 6.6 to 8.3 mm``."""
    low, high = result.creep_interval
    if math.isnan(low):
        return ""
    if math.isinf(high) or math.isinf(low):
        end = low if math.isinf(high) else high
        return f"95 % by the law: from {named('exit_creep', end)} to gross slip"
    return f"95 % by the law: {between('exit_creep', low, high)}"


def _creep_ratios(result: ArcResult) -> str:
    return f"{percent(result.entry_creep_ratio)} to {percent(result.exit_creep_ratio)}"


def _key_row(results: Results, name: str) -> Row:
    return row_of(name, *(figure_of(result, name) for result in results))


def _pressures(result: ArcResult) -> str:
    arc = result.arc
    first, last = arc.wrap_pressure(result.entry_tension), arc.wrap_pressure(result.exit_tension)
    return between("wrap_pressure", first, last)


def _creep_level(result: ArcResult) -> Level | None:
    if not result.status.solved:
        return None
    return Level.OK if result.within_creep_limit else Level.ATTENTION


def _outside_row(results: Results) -> Row:
    texts = _values(results, lambda r: f"{percent(r.outside_tested_share)} of the wrap")
    outside = any(result.extrapolates for result in results)
    note = "the friction law is an extrapolation there" if outside else ""
    level = Level.ATTENTION if outside else None
    title = row_of("outside_tested_share", 0.0).title
    return Row(title, texts, "", note, "outside_tested_share", level)


def creep_table(results: Results) -> Table:
    """Where the creep at the exit comes from."""
    rows = []
    for name, note in (
        ("creep_shrinkage", "the belt sheds tension and shortens"),
        ("creep_compression", "the lagging is compressed at the entry and recovers"),
        (
            "creep_global",
            "the whole belt slips back: what the friction needs in addition to the first two",
        ),
    ):
        texts = _values(results, lambda r, name=name: creep_part(r, name))  # type: ignore[misc]
        row = row_of(name, 0.0)
        rows.append(Row(row.title, texts, row.symbol, note, name))
    rows.append(row_of("exit_creep", *(r.exit_creep for r in results)))
    return Table("Creep by source", tuple(rows), heads(results), name="creep")


def creep_part(result: ArcResult, name: str) -> str:
    """Return a part of the creep at the exit with its share of the whole."""
    part = getattr(result, name)
    # parts that cancel, as on an idle pulley, are no shares of their sum, nor of none
    parts = (result.creep_shrinkage, result.creep_compression, result.creep_global)
    if result.exit_creep == 0.0 or sum(map(abs, parts)) > 1.05 * abs(result.exit_creep):
        return named(name, part)
    return f"{named(name, part)} ({percent(part / result.exit_creep, 2)})"


def capacity_table(result: ArcResult) -> Table | None:
    """How much more the pulley could carry; None where the method does not say."""
    c, arc = result.capacities, result.arc
    if math.isnan(c.gross_slip_capacity) and math.isnan(c.creep_limit_capacity):
        return None
    tight, slack = ("T1", "T2") if arc.side > 0.0 else ("T2", "T1")
    held = named("tension", max(arc.entry_tension, arc.exit_tension))
    ratio_now = arc.entry_tension / arc.exit_tension
    actual = max(ratio_now, 1.0 / ratio_now)

    def row(name: str, value: float, note: str) -> Row:
        return Row(term(name).title, (named(name, value),), term(name).symbol, note, name)

    def ratio(name: str, value: float, margin: float, note: str) -> Row:
        shown = "" if math.isnan(margin) else f"margin {named('tension_ratio', margin)}; "
        return row(name, value, f"{shown}{note}")

    rows = [
        ratio(
            "creep_limit_capacity", c.creep_limit_capacity, c.creep_limit_margin,
            "the design number",
        ),
        row("equivalent_friction", c.equivalent_friction, "compare with design values"),
    ]  # fmt: skip
    if arc.law.tested is not None:
        slip = named("slip", arc.law.tested.slip_max)
        note = f"slip at the maximum tested, {slip}"
        rows.append(
            ratio("tested_slip_capacity", c.tested_slip_capacity, c.tested_slip_margin, note)
        )
    gross = _gross_note(independent_of_slip(arc.law), c.gross_slip_creep)
    rows.append(row("gross_slip_capacity", c.gross_slip_capacity, gross))
    note = (
        f"Ratios {tight}/{slack} at constant {tight} of {held}; margin is the capacity over the "
        f"actual ratio, {named('tension_ratio', actual)}."
    )
    return Table("Capacity", tuple(rows), note=note, name="capacity")


def _gross_note(plain: bool, creep: float) -> str:
    if plain:
        return "the whole wrap slips"
    if math.isinf(creep):
        return "extrapolated, approached as creep grows to infinity"
    return f"extrapolated, at {named('gross_slip_creep', creep)} of creep"


def energy_table(result: ArcResult) -> Table:
    """Power, losses and wear."""
    e = result.energy
    rows = [
        row_of(name, getattr(e, name))
        for name in ("transmitted_power", "sliding_power", "shear_loss", "power_loss")
        if not math.isnan(getattr(e, name))
    ]
    if not math.isnan(e.efficiency):
        entry = row_of("efficiency", 0.0)
        rows.append(Row(entry.title, (percent(e.efficiency, 4),), entry.symbol, "", "efficiency"))
    note = "what wears lagging and belt"
    rows.append(row_of("frictional_energy", e.frictional_energy, note=note))
    if not math.isnan(e.wear_rate):
        rows.append(row_of("wear_rate", e.wear_rate))
    needs = "" if result.arc.belt_speed else "Give the belt speed to see powers."
    return Table("Energy and wear", tuple(rows), note=needs, name="energy")
