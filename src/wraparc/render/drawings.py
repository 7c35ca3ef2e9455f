"""The pictures of a note: drawn as everywhere, told in words for who cannot see them."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import partial

from wraparc.across import AcrossResult
from wraparc.alike import place_of_largest
from wraparc.answer.arc_tables import METHOD_TITLES, belongs, creep_part
from wraparc.answer.reserve_words import flips_by_input, nearest_text
from wraparc.answer.sheet import named, started
from wraparc.arc import ArcResult
from wraparc.glossary import GLOSSARY
from wraparc.plot.across import plot_across
from wraparc.plot.drive import plot_budget, plot_profiles, plot_pulley
from wraparc.plot.picture import Picture
from wraparc.plot.reserve import Bars, plot_reserve
from wraparc.reserve import find_reserve
from wraparc.train.whole import Whole, by_pulley
from wraparc.units import System, in_units


@dataclass(frozen=True)
class Drawing:
    """A picture of a document.

    Attributes
    ----------
    draw
        Draws it in the system of units that `shown` settles; what is read as text alone needs no
        picture.
    caption
        What stands below it.
    alt
        What it shows, in words, for who cannot see it.
    width
        How much of the width of the page it takes.
    """

    draw: Callable[..., Picture]
    caption: str
    alt: str
    width: float = 1.0

    def shown(self, system: System) -> "Drawing":
        """Return it in a system of units."""
        caption, alt = in_units(self.caption, system), in_units(self.alt, system)
        return replace(self, draw=partial(self.draw, system), caption=caption, alt=alt)


def pulley_drawing(result: ArcResult) -> Drawing:
    """Return the pulley of an arc, its wrap coloured by shear stress."""
    arc = result.arc
    stress, place = result.peak_shear_stress, result.peak_shear_position
    tensions = (named("tension", t) for t in (arc.entry_tension, arc.exit_tension))
    alt = (
        f"Pulley {arc.pulley}, {arc.duty}: belt wrapped over "
        f"{named('wrap_angle', arc.wrap_angle)}, tension {' to '.join(tensions)}."
    )
    caption = f"{started(belongs(result))}: the whole wrap slips, and no stress is drawn."
    if result.status.solved:
        alt += (
            " The lagging is coloured by shear stress, which peaks at "
            f"{named('peak_shear_stress', stress)}, "
            f"{named('peak_shear_position', place)} from the entry nip."
        )
        caption = f"{started(belongs(result))}: shear stress of the lagging."
    return Drawing(partial(plot_pulley, result), caption, alt, 0.5)


def budget_drawing(results: Sequence[ArcResult]) -> Drawing:
    """Return the creep at the exit by source, a bar for each method."""
    words = " ".join(_budget_words(result) for result in results)
    limit = named("creep_limit", results[0].arc.creep_limit)
    title = f"{GLOSSARY['exit_creep'].title} by source"
    alt, caption = (
        f"{title}. {words} The creep limit is {limit}.",
        f"{title}, {belongs(results[0])}.",
    )
    return Drawing(partial(plot_budget, results), caption, alt, 0.45)


def _budget_words(result: ArcResult) -> str:
    parts = ", ".join(
        f"{words} {creep_part(result, name)}"
        for name, words in (
            ("creep_shrinkage", "belt shrinkage"),
            ("creep_compression", "lagging compression"),
            ("creep_global", "global"),
        )
    )
    return f"{started(METHOD_TITLES.get(result.method, result.method))}: {parts}."


def profile_drawing(results: Sequence[ArcResult]) -> Drawing:
    """Return the four profiles along the wrap of an arc, by one method or two."""
    first = results[0]

    def ends(name: str) -> str:
        column = getattr(first.profile, name)
        at = [named(name, float(column[i])) for i in (0, -1)]
        return f"from {at[0]} at the entry to {at[1]} at the exit"

    alt = (
        f"Four profiles along the wrap of {belongs(first)}. Belt tension runs {ends('tension')}, "
        f"creep {ends('creep')}, slip {ends('slip')}, friction used {ends('friction_used')}, "
        f"shear stress {ends('shear_stress')}."
    )
    caption = f"Along the wrap, {belongs(first)}."
    if len(results) > 1:
        caption += " Thin and black: the paper's integration."
    return Drawing(partial(plot_profiles, results), caption, alt)


def reserve_drawing(result: Whole) -> Drawing | None:
    """Return the smallest changes of inputs that change the verdict; None where there are none."""
    bars = [Bars(name, flips) for name, flips in flips_by_input(result).items()]
    if not bars:
        return None
    text = nearest_text(find_reserve(result), by_pulley(result).drive)
    alt = "A bar from each input to where the verdict changes, its uncertainty as a band behind it."
    alt += f" The nearest: {text}"
    caption = "Change of one input at which the verdict is another, and its uncertainty (band)."
    return Drawing(partial(plot_reserve, bars), caption, alt, 0.75)


def across_drawing(result: AcrossResult) -> Drawing:
    """Return the map of the shear stress over wrap and width, lagging and tension beside."""
    arc, y = result.wide.arc, result.position
    worst = named("across_position", float(y[place_of_largest(result.frictional_energy)]))
    tight = named("across_position", float(y[place_of_largest(result.entry_tension)]))
    alt = (
        f"Map of the shear stress of pulley {arc.pulley} over wrap angle and width, the profile of "
        f"the pulley and the tension over the width beside it. The entry tension peaks at "
        f"{tight} from the middle, {result.entry_unevenness:.3g} of its mean; the lagging wears "
        f"fastest at {worst}, {result.energy_unevenness:.3g} of its mean."
    )
    caption = f"Across the width, pulley {arc.pulley}, load case {arc.load_case}."
    return Drawing(partial(plot_across, result), caption, alt)
