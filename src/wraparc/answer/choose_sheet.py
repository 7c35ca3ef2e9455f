"""The sheet of a selection, its JSON and its CSV."""

import csv
import io
import math
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from wraparc.answer.choose_verdict import choose_verdict
from wraparc.answer.choose_words import (
    design_name,
    missing_prices,
    reasons,
)
from wraparc.answer.least_tension import tension_at
from wraparc.answer.reserve_words import flip_data, input_name, percent_text
from wraparc.answer.sheet import Row, Sheet, Table, headed, number, percent, quantity, started
from wraparc.arrays import Array
from wraparc.choose.across import MOST, is_uneven
from wraparc.choose.belt_rating import LighterBelt
from wraparc.choose.search import Search
from wraparc.choose.selection import Selection
from wraparc.drive import Sag
from wraparc.reserve.of_designs import DesignReserve
from wraparc.schema.problems import place_text
from wraparc.units import RESULT_DIGITS, Cell, count, fixed

_MOST_ROWS = 15
_CSV_HEADS = (
    "lagging", "belt", "thickness [m]", "diameter [m]", "wrap angle [rad]", "slack tension [N]",
    "tight tension [N]", "creep [m]", "bond stress [Pa]",
)  # fmt: skip


def choose_sheet(
    selection: Selection,
    lighter: LighterBelt | None = None,
    most: int = _MOST_ROWS,
    by_reserve: Sequence[DesignReserve] = (),
) -> Sheet:
    """Return the answer of a search: the ranking, the fronts, the reasons of rejection.

    Parameters
    ----------
    selection
        The answer.
    lighter
        Lightest belt that the best design could do with, if that was asked.
    most
        Rows of a table.
    by_reserve
        Designs in the order of their reserve, if that was asked.
    """
    search = selection.search
    tables = [_ranking(selection, most, by_reserve), _rejected(selection, most)]
    told = choose_verdict(selection, lighter)
    remarks, sources = tuple(_remarks(selection)), tuple(_sources(selection))
    return Sheet(
        title=search.title or f"Choice for {search.drive.title or 'the drive'}",
        subtitle=f"Pulley {search.pulley} of {search.drive.title or 'the drive'}: "
        f"{_counted(len(selection))}, {len(selection.ranking)} "
        f"{'passes' if len(selection.ranking) == 1 else 'pass'}{_but_edges(selection)}.",
        verdict=told,
        tables=tuple(t for t in tables if t.rows),
        remarks=remarks,
        sources=sources,
        kept=remarks,
    )


def _counted(count: int) -> str:
    return "1 design" if count == 1 else f"{count:,} designs"


def _but_edges(selection: Selection) -> str:
    count = len(selection.unjudged)
    return f", {count} of them not solved across the width" if count else ""


def _heads(selection: Selection) -> tuple[str, ...]:
    money_heads = tuple(
        f"{part} [{selection.search.costing.currency}]" for part in ("total", "lagging", "energy")
    )
    uneven = ("uneven",) if is_uneven(selection.search) else ()
    tensions = (headed("T2", "force"), headed("T1/B", "force_per_width"))
    return (*money_heads, headed("creep", "length"), *uneven, *tensions, "front")


def _ranking(selection: Selection, most: int, by_reserve: Sequence[DesignReserve]) -> Table:
    costs, rows = selection.costs, []
    reserves = {of.design: of for of in by_reserve}
    width = selection.search.drive.belt.width
    on_creep, on_slack = set(selection.creep_front), set(selection.slack_front)
    for i in map(int, [*reserves][:most] or selection.ranking[:most]):
        marks = [w for w, s in (("creep", on_creep), ("T2", on_slack)) if i in s]
        values = (
            *(count(float(v[i])) for v in (costs.total, costs.lagging, costs.energy)),
            number("exit_creep", float(selection.creep[i])),
            *([_uneven(selection, i)] if is_uneven(selection.search) else []),
            Cell(
                float(selection.slack_tension[i]), "force", RESULT_DIGITS, "bare up", name="tension"
            ),
            number("belt_modulus", float(selection.tight_tension[i]) / width),
            " ".join(marks),
            *([_reserve_cell(reserves[i])] if reserves else []),
        )
        rows.append(Row(design_name(selection, i), values))
    more = len(selection.ranking) - len(rows)
    note = "front: no cheaper design has less creep, or needs less slack-side tension T2"
    if max(selection.search.shape[4:]) > 1:
        note += "; of designs that differ in wrap and tension alone the minimum of both comes first"
    if is_uneven(selection.search):
        note += "; uneven: tightest strip at the entry over the mean tension, the worst case"
        note += ", - where not solved across the width" if len(selection.unjudged) else ""
    note += f"; {more} more pass: --csv" if more > 0 else ""
    order = "cheapest first"
    if selection.search.unpriced and not np.any(costs.total > 0.0):
        order = "lowest creep first"
    elif max(selection.search.shape[4:]) > 1:
        order = "as recommended"
    if reserves:
        order = "by reserve"
        note += (
            "; reserve: nearest change of an input that makes the verdict worse, in units of its"
        )
        note += f" uncertainty, of the first {len(reserves)} designs"
    return Table(
        f"Designs that pass, {order}",
        tuple(rows),
        (*_heads(selection), *(["reserve"] if reserves else [])),
        note,
        "ranking",
    )


def _reserve_cell(of: DesignReserve) -> str:
    """Return the nearest change to a worse level: its input, by how much, and the level there."""
    if of.flip is None:
        return "not calculated" if of.reason else "none"
    name = input_name(of.flip.input, of.drive)
    return f"{name} {percent_text(of.flip.change)}: {of.flip.level}"


def _uneven(selection: Selection, i: int) -> str:
    return fixed(float(selection.unevenness[i]) - 1.0, 1, "percent signed")


def _rejected(selection: Selection, most: int) -> Table:
    bad = [int(i) for i in np.flatnonzero(~selection.feasible)]
    if len(bad) > most:
        rows = [
            Row(started(standing.rule.what), (_counted(int(standing.broken.sum())),))
            for standing in selection.standings.values()
            if standing.broken.any()
        ]
        return Table(
            "Rejected designs by missed check",
            tuple(rows),
            note="every design with its missed checks: --csv",
            name="rejected",
        )
    rows = [Row(design_name(selection, i), ("",), note=reasons(selection, i)) for i in bad]
    return Table("Rejected designs with their missed checks", tuple(rows), name="rejected")


def _remarks(selection: Selection) -> Iterator[str]:
    search = selection.search
    if search.unpriced:
        yield f"{missing_prices(search)} The lagging is left out of the cost."
    else:
        yield from _lagging_remarks(search)
    yield from _slack_remarks(selection)
    yield from _edge_remarks(selection)
    if search.costing.tariff is None:
        yield "Energy lost to creep is left out: tariff missing."
    elif len(search.conditions) > 1:
        yield f"Energy is that of condition {search.conditions[0].name}."
    if not search.costing.belts:
        yield "The belt is left out of the cost."
    unrated = [b.name for b in search.belts if b.rating is None]
    if unrated and search.limits.rating is not None:
        yield f"No rating is known of {', '.join(unrated)}: that limit was not applied."
    if search.limits.least_pulley_diameter:
        unknown = [b.name for b in search.belts if b.least_pulley_diameter is None]
        if unknown:
            yield f"No minimum pulley diameter is published of {', '.join(unknown)}."
    if len(search.drive.pulleys) > 1:
        yield (
            f"Only pulley {search.pulley} was varied. The slack-side tension is that behind the "
            "drives, where the take-up is; the Te of every pulley is that of the drive file."
        )


def _lagging_remarks(search: Search) -> Iterator[str]:
    yield (
        "Lagging cost: material and installation, scaled by the lagged area, for as many laggings "
        f"as wear out in {search.costing.years:g} years at the middle of their life; no interest."
    )
    by_wear = [lag.name for lag in search.laggings if lag.wear_coefficient is not None]
    by_vendor = [lag.name for lag in search.laggings if lag.wear_coefficient is None]
    if by_wear:
        yield f"Life by frictional energy and wear coefficient: {', '.join(by_wear)}."
    if by_vendor:
        yield (
            f"The life of {', '.join(by_vendor)} is that of the vendor, the same at every creep: "
            "no wear coefficient is known, which would make it follow the frictional energy."
        )


def _slack_remarks(selection: Selection) -> Iterator[str]:
    search, sag = selection.search, selection.search.limits.sag
    if search.least_slack:
        held = tension_at(search.drive.take_up_place)
        yield f"The {held} is the minimum with which every check that it helps passes."
    sag = sag or search.drive.criteria.sag
    if sag is None:
        yield (
            "Belt sag may need more slack-side tension; it is not checked, because neither "
            "limits.sag nor the drive file gives the idler spacing and the mass of the belt."
        )
        return
    least = quantity(sag.tension, "force")
    yield f"Limited is a belt sag of {percent(sag.share, 2)} of the idler spacing ({least})."


def _edge_remarks(selection: Selection) -> Iterator[str]:
    count = len(selection.unjudged)
    if count:
        yield (
            f"The first {MOST} of the ranking and the designs of the fronts are solved across the "
            f"width. {count} further designs are not: their unevenness and edge tensions are "
            "not known. To judge them too, search fewer."
        )


def _sources(selection: Selection) -> Iterator[str]:
    search = selection.search
    if search.limits.sag is not None:
        yield Sag.SOURCE
    for lagging in search.laggings:
        yield f"{lagging.name}, friction: {lagging.source_of('law')}"
        price = search.costing.laggings.get(lagging.name)
        if price is None or lagging.name in search.unpriced:
            continue
        low, high = price.cost.life_years
        life = f"{low:g} to {high:g}" if low < high else f"{low:g}"
        yield f"{lagging.name}, cost, life {life} years: {price.source}"
    for condition in search.conditions:
        for lagging in search.laggings:
            if lagging.condition != condition.name:
                factor, source = condition.factor_of(lagging)
                yield f"{lagging.name}, {condition.name}: friction factor {factor:.3g}, {source}"


def choose_csv(selection: Selection) -> str:
    """Return every design in SI units, with what it breaks, as CSV."""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    names = list(selection.standings)
    writer.writerow(
        [*_CSV_HEADS]
        + [
            f"{p} [{selection.search.costing.currency}]"
            for p in ("total", "lagging", "belt", "energy")
        ]
        + ["rank", *_uneven_heads(selection), *(f"excess {n}" for n in names)]
    )
    rank = {int(d): k + 1 for k, d in enumerate(selection.ranking)}
    for i in range(len(selection)):
        writer.writerow(
            _csv_row(selection, i, names)
            + [str(rank.get(i, "")), *_uneven_cells(selection, i)]
            + [_plain(float(selection.standings[n].excess[i])) for n in names]
        )
    return out.getvalue()


def _csv_row(selection: Selection, i: int, names: list[str]) -> list[str]:
    s, g, c = selection.search, selection.grid, selection.costs
    numbers = (
        g.thickness, g.diameter, g.wrap_angle, selection.slack_tension, selection.tight_tension,
        selection.creep, selection.bond_stress, c.total, c.lagging, c.belt, c.energy,
    )  # fmt: skip
    named_ = [s.laggings[g.places[0, i]].name, s.belts[g.places[2, i]].name]
    return named_ + [_plain(float(v[i])) for v in numbers]


def _uneven_heads(selection: Selection) -> tuple[str, ...]:
    if not is_uneven(selection.search):
        return ()
    return "across the width", "entry unevenness [-]", "edge tension [N/m]", "edge limit [N/m]"


def _uneven_cells(selection: Selection, i: int) -> list[str]:
    """Say how uneven a design runs; of one not solved across the width, that it was not."""
    if not is_uneven(selection.search):
        return []
    edge = selection.standings["edge_tension"]
    known = math.isfinite(edge.value[i])
    told = "solved" if known else "not solved" if math.isnan(edge.value[i]) else "not transmitted"
    numbers = (selection.unevenness[i], edge.value[i], edge.limit[i])
    return [told, *(_plain(float(v)) if known else "" for v in numbers)]


def _plain(value: float) -> str:
    return "" if math.isnan(value) else f"{value + 0.0:.8g}"  # no -0.0


def choose_document(
    selection: Selection,
    lighter: LighterBelt | None = None,
    by_reserve: Sequence[DesignReserve] = (),
) -> dict[str, Any]:
    """Return the ranking and the rejections as plain data [SI] for JSON; at most 10,000 designs."""
    some = range(min(len(selection), 10_000))
    reserves = [
        {
            "design": of.design,
            "level": of.level.value,
            "reserve": None if of.flip is None else flip_data(of.flip),
            "reason": of.reason or None,
        }
        for of in by_reserve
    ]
    return {
        "format": 3,
        "title": selection.search.title,
        "currency": selection.search.costing.currency,
        "years": selection.search.costing.years,
        "missing_prices": [
            {"lagging": name, "key": place_text(("cost", "lagging", name)), "currency": other}
            for name, other in selection.search.unpriced.items()
        ],
        "designs": [_design_data(selection, i) for i in some],
        "ranking": [int(i) for i in selection.ranking],
        "creep_front": [int(i) for i in selection.creep_front],
        "slack_front": [int(i) for i in selection.slack_front],
        "next_dearer": selection.next_dearer(),
        "lightest_belt": lighter.belt.name if lighter else None,
        **({"by_reserve": reserves} if reserves else {}),
    }


def _lagging_ends(selection: Selection) -> tuple[Array, Array]:
    """Return the least and the largest cost of the lagging of every design, (n,) each."""
    return selection.costs.lagging_least, selection.costs.lagging_most


def _design_data(selection: Selection, i: int) -> dict[str, Any]:
    return {
        "name": design_name(selection, i),
        "creep": float(selection.creep[i]),
        **(
            {
                "entry_unevenness": float(selection.unevenness[i]),
                "solved_across": not math.isnan(selection.unevenness[i]),
            }
            if is_uneven(selection.search)
            else {}
        ),
        "peak_shear_stress": float(selection.bond_stress[i]),
        "slack_tension": float(selection.slack_tension[i]),
        "tight_tension": float(selection.tight_tension[i]),
        "cost": float(selection.costs.total[i]),
        "cost_range": [
            float(selection.costs.belt[i] + selection.costs.energy[i] + part[i])
            for part in map(np.nan_to_num, _lagging_ends(selection))
        ],
        "broken": {
            name: {
                "value": float(standing.value[i]),
                "limit": float(standing.limit[i]),
                "excess": float(standing.excess[i]),
                "where": list(selection.place(int(standing.where[i]))),
            }
            for name in selection.broken(i)
            for standing in (selection.standings[name],)
        },
    }
