"""The belt that a design could do with: the saving of a lower take-up tension."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from wraparc.choose.selection import Selection, choose
from wraparc.drive import Belt


@dataclass(frozen=True, kw_only=True)
class LighterBelt:
    """A belt, and what a design needs with it.

    Attributes
    ----------
    belt
        The belt.
    slack_tension, tight_tension
        Least slack-side tension with this belt, and the largest tension then [N].
    """

    belt: Belt
    slack_tension: float
    tight_tension: float


def least_belt(selection: Selection, design: int, belts: Sequence[Belt]) -> LighterBelt | None:
    """Lightest belt with which a design keeps every limit at its own least take-up tension.

    It is judged no worse than the design itself.

    Each belt is solved with its own modulus: a lighter belt is softer, creeps more, and so needs
    more slack-side tension than the one it replaces.

    Parameters
    ----------
    selection, design
        The design, by number.
    belts
        Belts to try.

    Returns
    -------
    None if none of them will do.
    """
    search, places = selection.search, selection.grid.places[:, design]
    pull = np.abs(search.pulls()).max()
    one = replace(
        search,
        laggings=(search.laggings[places[0]],),
        thicknesses=(float(selection.grid.thickness[design]),),
        diameters=(float(selection.grid.diameter[design]),),
        wrap_angles=(float(selection.grid.wrap_angle[design]),),
        slack_tensions=(),
        belts=search.belts[:1],
    )
    most_share = max((search.limits.rating or {}).values(), default=1.0)
    for belt in sorted(belts, key=lambda b: (b.rating or 0.0, -b.modulus)):
        least_rating = pull / search.drive.belt.width / max(1.0, most_share)
        if belt.rating is None or belt.rating < least_rating:
            continue  # cannot even bear the pull
        found = choose(replace(one, belts=(belt,)))
        if len(found.ranking) and found.verdict.level.rank <= selection.judged(design).level.rank:
            return LighterBelt(
                belt=belt,
                slack_tension=float(found.slack_tension[0]),
                tight_tension=float(found.tight_tension[0]),
            )
    return None
