"""Selection in words: what a design is, why one was rejected, what the next dearer one buys."""

import math
from collections.abc import Iterator

import numpy as np

from wraparc.answer.sheet import named, percent, quantity
from wraparc.checks.check import Check
from wraparc.checks.of_arc import DESIGN_STANDARD
from wraparc.checks.of_drive import PULLEY_DIAMETER
from wraparc.choose.across import EDGE
from wraparc.choose.ranking import SAME
from wraparc.choose.search import Search
from wraparc.choose.selection import Selection, own_slack
from wraparc.errors import format_list
from wraparc.schema.problems import place_text
from wraparc.units import RESULT_DIGITS, Cell


def money(value: float, currency: str) -> str:
    """Return an amount: whole units of the currency, thousands apart as in every count."""
    return "-" if math.isnan(value) else f"{value:,.0f} {currency}"


def slack_words(search: Search) -> str:
    """Return the name of the tension of a design: T2, or that of the take-up elsewhere."""
    return "take-up" if search.drive.take_up_place else "T2"


def _slack_noun(search: Search) -> str:
    """Return the same as the subject of a sentence."""
    return "the take-up" if search.drive.take_up_place else "T2"


def design_name(selection: Selection, design: int, *, slack: bool = True) -> str:
    """Return what sets a design apart: only candidates of which there are several.

    Its slack-side tension too, unless that is said beside it.
    """
    search, grid = selection.search, selection.grid
    shape = search.shape
    places = grid.places[:, design]
    parts = [search.laggings[places[0]].name]
    if shape[1] > 1:
        parts.append(named("lagging_thickness", float(grid.thickness[design])))
    if shape[2] > 1:
        parts.append(search.belts[places[2]].name)
    if shape[3] > 1:
        parts.append("D " + named("diameter", float(grid.diameter[design])))
    if shape[4] > 1:
        parts.append("wrap " + named("wrap_angle", float(grid.wrap_angle[design])))
    if slack and shape[5] > 1:
        held = named("tension", float(grid.slack[design]))
        parts.append(f"{slack_words(search)} {held}")
    return ", ".join(parts)


def reason(selection: Selection, design: int, name: str) -> str:
    """Return how a design stands to a check it misses, with by how much."""
    standing = selection.standings[name]
    rule, excess = standing.rule, float(standing.excess[design])
    value, limit = float(standing.value[design]), float(standing.limit[design])
    if rule is DESIGN_STANDARD and not math.isfinite(limit):
        text = f"{rule.what} cannot be applied"
    elif rule is EDGE and not math.isfinite(value):
        text = "a strip of the belt goes slack, or the uneven pulley cannot transmit Te"
    else:
        check = Check(
            name=name, title=rule.what, level=rule.missed, value=value, limit=limit,
            dimension=rule.dimension, at_most=rule.at_most,
        )  # fmt: skip
        by = f"{percent(excess, 2)} {'over' if rule.at_most else 'under'}"
        text = f"{rule.what}: {check.texts()[0]}, {check.bound()} ({by})"
    places = _places(selection, design, name)
    return f"{text} [{', '.join(places)}]" if places else text


def _places(selection: Selection, design: int, name: str) -> list[str]:
    """Return where a design stands worst to a check: pulley and condition if there are several."""
    standing, search = selection.standings[name], selection.search
    pulley, case, condition = selection.place(int(standing.where[design]))
    if standing.rule is PULLEY_DIAMETER:
        return []
    places = [pulley] if len(search.drive.pulleys) > 1 else []
    several = len(search.conditions) > 1 and standing.rule.result
    return [*places, case, condition] if several else [*places, case]


def closest_words(selection: Selection, design: int) -> str:
    """Return a design with its worst miss: ``full-ceramic, creep 7.1 of 6.35 mm (design)``."""
    missed = selection.broken(design)
    name = max(missed, key=lambda n: float(selection.standings[n].excess[design]))
    standing = selection.standings[name]
    rule, value = standing.rule, float(standing.value[design])
    own = (c.noun for c in selection.judged(design).checks if c.name == name and c.noun)
    check = Check(
        name=name, title=rule.what, level=rule.missed, value=value,
        limit=float(standing.limit[design]), dimension=rule.dimension, at_most=rule.at_most,
    )  # fmt: skip
    if not check.measured:
        return f"{design_name(selection, design)}, {reason(selection, design, name)}"
    places = _places(selection, design, name)
    where = f" ({', '.join(places)})" if places else ""
    return f"{design_name(selection, design)}, {next(own, rule.what)} {check.measured}{where}"


def reasons(selection: Selection, design: int) -> str:
    """Return every check that a design misses and must not, in one line."""
    return "; ".join(reason(selection, design, n) for n in selection.broken(design))


def missing_prices(search: Search) -> str:
    """Return which laggings have no price in the currency; empty where all have one."""
    unpriced = search.unpriced
    if not unpriced:
        return ""
    currency = search.costing.currency
    others = [other for other in dict.fromkeys(unpriced.values()) if other]
    known = f", only in {' and '.join(others)}" if others else ""
    return f"No {currency} price of {format_list([*unpriced], 3)}{known}."


def missing_price_keys(search: Search) -> str:
    """Return what to write for the prices that are missing."""
    keys = [place_text(("cost", "lagging", name)) for name in search.unpriced]
    return f"Give {format_list(keys, 3)}: material, installation, area, life_years."


def unpriced_words(selection: Selection) -> Iterator[str]:
    """Yield what wrap or tension beyond that of the first design would save, and at what price."""
    ranking, total = selection.ranking, selection.costs.total
    best, least = int(ranking[0]), int(ranking[np.argmin(total[ranking])])
    saved = float(total[best] - total[least])
    if saved <= SAME * total[best]:
        return
    why = "what more wrap or tension costs (snub pulley, take-up, belt) is not in it"
    if selection.standings[DESIGN_STANDARD.name].missed[least]:
        why = "it is below the design standard"
    yield (
        f"{design_name(selection, least)} would save "
        f"{money(saved, selection.search.costing.currency)}; {why}{_but(selection, least)}."
    )


def saving_words(selection: Selection) -> Iterator[str]:
    """Yield what the least take-up tension saves against that of the drive file.

    Said of the cheapest design, where least tensions were asked for: the slack side, the largest
    tension with what belt rating it takes, and the mass of a gravity take-up.
    """
    search = selection.search
    if not search.least_slack or not len(selection.ranking):
        return
    best, width = int(selection.ranking[0]), search.drive.belt.width
    now, then = own_slack(search), float(selection.slack_tension[best])
    tight_now = max(
        max(t.entry, t.exit) for case in search.drive.load_cases for t in case.tensions.values()
    )
    tight = float(selection.tight_tension[best])
    where = "" if search.drive.take_up_place else " next to the pulley"
    words = "less" if then <= now else "more"
    parts = f"{named('tension', abs(now - then))} {words}"
    yield (
        f"Against the take-up of the drive file, {named('tension', now)}, "
        f"{_slack_noun(search)} is {parts}; the mass of a gravity take-up{where}, of sheave ratio "
        f"{search.drive.criteria.take_up.sheave_ratio:g}, goes from {_mass(search, now)} "
        f"to {_mass(search, then)}."
    )
    per_width = [quantity(t / width, "force_per_width") for t in (tight_now, tight)]
    rating = search.belts[selection.grid.places[2, best]].rating
    share = "" if not rating else f", {percent(tight / width / rating, 3)} of the belt's rating"
    yield (
        f"The maximum tension goes from {per_width[0]} to {per_width[1]}{share}: what a belt must "
        "be rated for; wraparc choose --lightest-belt looks for one."
    )


def _mass(search: Search, tension: float) -> str:
    weight = search.drive.criteria.take_up.counterweight(tension)
    return Cell(weight, "mass", RESULT_DIGITS, "up")


def next_cost_words(selection: Selection) -> Iterator[str]:
    """Yield what the next dearer lagging would buy."""
    if not len(selection.ranking) or selection.search.unpriced:
        return
    best, other = int(selection.ranking[0]), selection.next_dearer()
    currency = selection.search.costing.currency
    if other is None:
        if len(selection.search.laggings) > 1:
            names = [lagging.name for lagging in selection.search.laggings]
            ranking, total = selection.ranking, selection.costs.total
            own, cheapest = (
                names[selection.grid.places[0, i]]
                for i in (best, int(ranking[np.argmin(total[ranking])]))
            )
            also = ", which also has the lowest life cost" if own == cheapest else ""
            yield f"No feasible candidate has a more expensive lagging than {own}{also}."
        return
    more = selection.costs.total[other] - selection.costs.total[best]
    changes = [
        f"the creep goes from {named('exit_creep', float(selection.creep[best]))} to "
        f"{named('exit_creep', float(selection.creep[other]))}",
        f"{_slack_noun(selection.search)} from "
        f"{named('tension', float(selection.slack_tension[best]))} to "
        f"{named('tension', float(selection.slack_tension[other]))}",
    ]
    years = selection.search.costing.years
    yield (
        f"The next more expensive lagging, {design_name(selection, other)}, costs "
        f"{money(more, currency)} more over {years:g} years; for it {' and '.join(changes)}"
        f"{_but(selection, other)}."
    )


def _but(selection: Selection, design: int) -> str:
    """Return what a design misses that is spoken of beside the recommended one; else nothing."""
    worst = selection.judged(design).governing
    return "" if worst is None or not worst.missed else f"; {worst.level}: {worst.label}"
