"""Sheets of what the catalogue holds: laggings and belts."""

import math
from collections.abc import Sequence

import numpy as np

from wraparc import catalogue
from wraparc.answer.input_tables import input_rows
from wraparc.answer.inputs import lagging_inputs
from wraparc.answer.sheet import (
    NONE,
    Row,
    Sheet,
    Table,
    Verdict,
    between,
    named,
    number,
    quantity,
)
from wraparc.answer.sources import Sources
from wraparc.checks import Level
from wraparc.checks.of_data import weak_inputs
from wraparc.checks.verdict import data_line
from wraparc.drive import CREEP_LIMIT, Fit, Lagging
from wraparc.friction import CoefficientPieces, FrictionLaw, IntegralLog, PressureKnots
from wraparc.glossary import GLOSSARY
from wraparc.provenance import Kind
from wraparc.units import (
    Cell,
    Dimension,
    System,
    display,
    display_unit,
    either,
    fixed,
    in_unit,
    unit_of,
)

#: Wrap pressure that one friction tells a lagging by [Pa], 30 psi; the slip is the creep limit.
_AT = 207e3
#: Slips of the friction table [m], in steps that read well in their system.
_SLIPS: dict[System, tuple[float, ...]] = {"si": (0.5e-3, 1e-3, 2e-3, 4e-3, 6e-3, 10e-3, 15e-3),
          "us": tuple(i * 0.0254 for i in (0.02, 0.04, 0.08, 0.16, 0.25, 0.4, 0.6))}  # fmt: skip
_FEW = 8


def laggings_sheet(laggings: Sequence[Lagging]) -> Sheet:
    """List laggings, a row for each condition."""
    of = Sources()
    rows = tuple(
        Row(
            lagging.name,
            (
                lagging.condition,
                lagging.surface or NONE,
                named("lagging_thickness", lagging.thickness),
                fixed(float(lagging.law.friction(CREEP_LIMIT, _AT)), 2),
            ),
            note=of.note(lagging.provenance),
        )
        for lagging in laggings
    )
    pressure, slip = named("wrap_pressure", _AT), named("slip", CREEP_LIMIT)
    heads = ("condition", "surface", "thickness", "friction")
    table = Table("Laggings", rows, heads, f"Friction at {pressure} and a slip of {slip}.")
    remarks = (
        ("An illustrative lagging describes no real product.",)
        if any(lagging.provenance.kind is Kind.ILLUSTRATIVE for lagging in laggings)
        else ()
    )
    return Sheet("Laggings of the catalogue", "", None, (table,), remarks, of.listed())


def lagging_sheet(laggings: Sequence[Lagging]) -> Sheet:
    """Return everything known of one lagging in its conditions."""
    of = Sources()
    first = laggings[0]
    tables = []
    for lagging in laggings:
        of_condition = f" ({lagging.condition})" if len(laggings) > 1 else ""
        rows = input_rows(lagging_inputs(lagging), of)
        tables.append(Table(f"Lagging{of_condition}", rows, name="lagging"))
        tables.append(_friction_table(lagging, of_condition))
        if isinstance(lagging.law, IntegralLog):
            tables.append(_coefficient_table(lagging.law, of_condition))
    design = [d for d in catalogue.design_friction() if d.surface == first.surface]
    tables += [_design_table(first.surface, of)] if design else []
    tables += [_cost_table(first)] if first.cost else []
    remarks = _notes(laggings)
    if first.source_of("law").kind is Kind.ILLUSTRATIVE and not remarks:
        remarks.append("Illustrative: it describes no real product.")
    misfit = [
        f"{lagging.condition}: {m}" if len(laggings) > 1 else m
        for lagging in laggings if lagging.fit for m in _misfit(lagging.fit)
    ]  # fmt: skip
    return Sheet(
        first.title or first.name,
        str(first.provenance),
        _lagging_verdict(laggings),
        tuple(tables),
        (*misfit, *remarks),
        of.listed(),
    )


def _lagging_verdict(laggings: Sequence[Lagging]) -> Verdict:
    """Return what a lagging is and was tested for, under its name, and what its data are worth."""
    first = laggings[0]
    what = f"{named('lagging_thickness', first.thickness)} {first.surface}".rstrip()
    tested = [one.law.tested for one in laggings if one.law.tested is not None]
    ends = "without tests"
    if tested:
        low, high = min(t.pressure_min for t in tested), max(t.pressure_max for t in tested)
        slip = named("slip", max(t.slip_max for t in tested))
        ends = f"tested {between('wrap_pressure', low, high)}, slip to {slip}"
    data = data_line(tuple(item for lagging in laggings for item in weak_inputs(lagging)))
    return Verdict(Level.OK, f"{what}, {ends}.", label=first.name, data=data.text, name="lagging")


def _misfit(fit: Fit) -> list[str]:
    """Where a law does not describe its tests, and why it was written nevertheless."""
    reason = fit.misfit_accepted
    return [*([f"Misfit accepted: {reason}"] if reason else []), *fit.misfit]


def _notes(laggings: Sequence[Lagging]) -> list[str]:
    """Return the notes of all conditions; what is not said of all, with its condition."""
    texts = dict.fromkeys(note for lagging in laggings for note in lagging.notes)
    return [
        text
        if all(text in lagging.notes for lagging in laggings)
        else f"{', '.join(lag.condition for lag in laggings if text in lag.notes)}: {text}"
        for text in texts
    ]


def law_table(lagging: Lagging) -> Table:
    """Return the table that a friction law can be drawn from again: coefficients, or friction."""
    if isinstance(lagging.law, IntegralLog):
        return _coefficient_table(lagging.law, f", {lagging.name}")
    return _friction_table(lagging, f", {lagging.name}")


def _pressures(law: FrictionLaw) -> list[float]:
    """Pressures to tabulate a law at: its knots, thinned, or its tested range in steps."""
    if isinstance(law, IntegralLog):
        knots = law.coefficients.pressure
        if isinstance(law.coefficients, CoefficientPieces):
            knots = tuple(np.unique(np.r_[np.geomspace(knots[0], knots[-1], _FEW), knots]))
        if len(knots) > 1:
            step = -(-len(knots) // 12)
            return [float(p) for p in (*knots[:-1:step], knots[-1])]
    if law.tested is None:
        return [50e3, 100e3, 200e3, 400e3, 700e3]
    return [float(p) for p in np.geomspace(law.tested.pressure_min, law.tested.pressure_max, _FEW)]


def _friction_table(lagging: Lagging, of_condition: str) -> Table:
    slips, factors = _SLIPS.values(), [display_unit("length", system)[1] for system in _SLIPS]
    rows = tuple(
        Row(
            named("wrap_pressure", pressure),
            tuple(
                either(*(f"{float(lagging.law.friction(slip, pressure)):.3f}" for slip in pair))
                for pair in zip(*slips, strict=True)
            ),
        )
        for pressure in _pressures(lagging.law)
    )
    heads = tuple(
        either(*(display(s / f, "number", digits=2) for s, f in zip(pair, factors, strict=True)))
        for pair in zip(*slips, strict=True)
    )
    note = f"Columns: slip [{unit_of('length')}]; rows: wrap pressure."
    if lagging.law.tested is not None:
        most = lagging.law.tested.slip_max
        told = f" Tested up to a slip of {named('slip', most)}."
        note += either(*(told if most < some[-1] * (1 - 1e-9) else "" for some in slips))
    return Table(f"Friction mu(x, p){of_condition}", rows, heads, note, "friction")


def _coefficient_table(law: IntegralLog, of_condition: str) -> Table:
    unit = unit_of("length")
    ends = law.coefficients.pressure
    at = np.array(_pressures(law))
    slip, peak, slope, residual = law.parameters(at)
    rows = []
    for i, pressure in enumerate(at.tolist()):
        values = (
            *(_coefficient(law, pressure, place) for place in (0, 1)),
            number("peak_slip", float(slip[i])),
            fixed(peak[i], 3),
            number("post_peak_slope", float(slope[i])),
            fixed(residual[i], 3),
        )
        rows.append(Row(named("wrap_pressure", pressure), values))
    heads = (
        f"A [1/{unit}]",
        f"b [1/{unit}]",
        f"{GLOSSARY['peak_slip'].symbol} [{unit}]",
        GLOSSARY["peak_friction"].symbol,
        f"{GLOSSARY['post_peak_slope'].symbol} [1/{unit}]",
        GLOSSARY["residual_friction"].symbol,
    )
    kind = "monotone cubics between knots" if isinstance(law.coefficients, PressureKnots) else ""
    if isinstance(law.coefficients, CoefficientPieces):
        met = ", ".join(named("wrap_pressure", p) for p in ends[1:-1]) or "none"
        kind = f"pieces of A(p) and b(p), transition pressures: {met}"
    note = f"mu = A x ln(x) - b x up to its peak, x in {unit}; {kind}."
    title = f"Coefficients of the integral-log law{of_condition}"
    return Table(title, tuple(rows), heads, note, "coefficients")


def _coefficient(law: IntegralLog, pressure: float, place: int) -> str:
    return in_unit("length", lambda mm: f"{law.coefficients_ab(pressure, mm)[place]:.5f}")


def _design_table(surface: str, of: Sources) -> Table:
    rows = []
    for design in catalogue.design_friction():
        if design.surface == surface:
            low, high = design.friction
            text = Cell(high, "number", form="to", other=low)
            title = ", ".join(part for part in (design.standard, design.condition) if part)
            rows.append(Row(title, (text,), note=of.note(design.provenance)))
    return Table(f"Design values of friction, {surface}", tuple(rows), name="constant")


def _cost_table(lagging: Lagging) -> Table:
    cost = lagging.cost
    if cost is None:
        return Table("Cost", ())
    short, long = cost.life_years
    rows = (
        Row("Material", (f"{cost.material:g} {cost.currency}",)),
        Row("Installation", (f"{cost.installation:g} {cost.currency}",)),
        Row("For an area of", (quantity(cost.area, "area"),)),
        Row("Life", (f"{short:g} to {long:g} years" if short != long else f"{short:g} years",)),
    )
    return Table("Cost", rows, name="cost")


def _weight(mass: float | None, si: float, us: float) -> str:
    """Return a mass per area, of what is so thick in each system of units [m]; 1 of a whole."""
    if mass is None:
        return NONE
    return either(f"{mass * si:.3g} kg/m2", f"{mass * us / (0.45359237 / 0.3048**2):.3g} lb/ft2")


#: What a drive file takes besides the belts of the catalogue.
STANDARD_NAMES = (
    "Standard names are read too: EP 630/3, EP 1000/4 6+3 Y, NN 500/4, ST 2000, 330 PIW 3 ply "
    '(wraparc belts "EP 630/3").'
)


def belts_sheet() -> Sheet:
    """List the belts of the catalogue."""
    of = Sources()
    tables = []
    belts = catalogue.belts()
    for kind in dict.fromkeys(belt.kind for belt in belts):
        rows: list[Row] = []
        notes: dict[str, None] = {}
        for belt in belts:
            if belt.kind == kind:
                origins = (belt.provenance, *belt.sources.values())
                notes |= {of.note(origin): None for origin in origins}
                least = belt.least_pulley_diameter
                values = (
                    quantity(belt.rating, "force_per_width"),
                    quantity(belt.modulus, "force_per_width"),
                    belt.modulus_test or "not stated",
                    NONE if least is None else quantity(least, "length"),
                    NONE if belt.carcass is None else quantity(belt.carcass, "length"),
                    _weight(belt.carcass_mass, 1.0, 1.0),
                    _weight(belt.cover_mass, 1e-3, 0.0254 / 32.0),
                )
                rows.append(Row(belt.name, values))
        heads = (
            "rating",
            "modulus M",
            "its test",
            "minimum drive pulley",
            "carcass",
            "its mass",
            either("1 mm of cover", "1/32 in of cover"),
        )
        tables.append(Table(f"Belts, {kind}", tuple(rows), heads, "; ".join(notes)))
    return Sheet("Belts of the catalogue", "", None, tuple(tables), (STANDARD_NAMES,), of.listed())


_ABSENT = "not available"


def belt_sheet(belts: Sequence[catalogue.CatalogueBelt]) -> Sheet:
    """Show belts one by one: every number with where it comes from, and what is not published."""
    of = Sources()
    tables = tuple(_belt_table(belt, of) for belt in belts)
    return Sheet("Belts", "", None, tables, (), of.listed())


def _belt_table(belt: catalogue.CatalogueBelt, of: Sources) -> Table:
    """Return what is known of a belt."""
    rows: list[Row] = []

    def add(title: str, key: str, text: str) -> None:
        origin = belt.sources.get(key, belt.provenance)
        rows.append(Row(title, (text,), note="" if text == _ABSENT else of.note(origin)))

    def sized(title: str, key: str, dimension: Dimension) -> None:
        value = getattr(belt, key)
        unknown = value is None or math.isnan(value)
        add(title, key, _ABSENT if unknown else quantity(value, dimension))

    add("Carcass", "kind", belt.kind)
    sized("Breaking strength", "strength", "force_per_width")
    sized("Rating", "rating", "force_per_width")
    sized("Modulus M", "modulus", "force_per_width")
    if belt.modulus_ends is not None:
        least, most = belt.modulus_ends
        add("Published moduli", "modulus", Cell(most, "force_per_width", form="to", other=least))
    sized("Carrying cover", "carry_cover", "length")
    sized("Pulley cover", "pulley_cover", "length")
    cords = belt.kind == "steel cord"
    sized("Cord diameter" if cords else "Carcass thickness", "carcass", "length")
    if cords:
        sized("Cord pitch", "cord_pitch", "length")
    mass = _weight(belt.carcass_mass, 1.0, 1.0)
    add("Mass of the carcass", "carcass_mass", _ABSENT if mass == NONE else mass)
    cover = _weight(belt.cover_mass, 1e-3, 0.0254 / 32.0)
    title = either("Mass of 1 mm of cover", "Mass of 1/32 in of cover")
    add(title, "cover_mass", _ABSENT if cover == NONE else cover)
    sized("Minimum drive pulley", "least_pulley_diameter", "length")
    return Table(f"Belt {belt.name}", tuple(rows), name="belt")
