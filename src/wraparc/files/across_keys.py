"""The keys of ``[pulley.across]``: what is uneven across the width, read and written."""

from __future__ import annotations

from typing import Any

from wraparc.drive import Across, GrippingPulley, Transition, WidthProfile
from wraparc.drive.across import DEPTHS, FEWEST_STRIPS, MOST_STRIPS
from wraparc.errors import InputError
from wraparc.schema.kinds import Choice, Count, Kind, Quantity, Rows, TextOr, WordOr
from wraparc.schema.limits import Limit
from wraparc.schema.problems import NOTHING, Place, Report
from wraparc.schema.quantity_text import quantity_text
from wraparc.schema.tables import Entry, Record, Table, Variant, need
from wraparc.units import Dimension, display

#: Largest deviation of a radius [m]: beyond it a whole radius or diameter was more likely given.
_LARGEST = 0.1
_FAR = "far"


class _Pair(Kind):
    """A place across the belt and the value there, ``["-600 mm", "1.5 mm"]``."""

    def __init__(self, dimension: Dimension) -> None:
        self.kinds = (Quantity("length"), Quantity(dimension))

    def read(self, raw: object, place: Place, report: Report) -> Any:
        if not isinstance(raw, list) or len(raw) != 2:
            report.add(place, "must be a pair, position and value", value=raw)
            return NOTHING
        pair = [
            kind.read(item, (*place, what), report)
            for kind, item, what in zip(self.kinds, raw, ("position", "value"), strict=True)
        ]
        return NOTHING if NOTHING in pair else tuple(pair)

    def written(self, value: Any) -> Any:
        return [kind.written(item) for kind, item in zip(self.kinds, value, strict=True)]

    def schema(self) -> dict[str, Any]:
        return {"type": "array", "prefixItems": [k.schema() for k in self.kinds],
                "minItems": 2, "maxItems": 2}  # fmt: skip


class Profile(Kind):
    """A profile over the width: rows, or a table of rows, a crown and an uncertainty.

    Parameters
    ----------
    dimension
        Of the values.
    diameters
        Whether they may be stated on diameter, or be whole diameters.
    """

    #: How it is written, in a few words.
    words = "rows, or a table"

    def __init__(self, dimension: Dimension, *, diameters: bool = False) -> None:
        self.dimension, self.diameters = dimension, diameters
        self.rows = Rows(_Pair(dimension), 0, 500)
        entries = [
            Entry("rows", "Pairs of position, 0 in the middle of the belt, and value.", self.rows),
            Entry("crown", "Height of a parabola in the middle over the edges of the belt.",
                  Quantity(dimension)),
            Entry("factor", "Factor on all values: how much of the profile there is.",
                  Quantity("number", Limit("number", most=100.0))),
            Entry("uncertainty", "Standard uncertainty of the values.",
                  Quantity(dimension, Limit(dimension))),
        ]  # fmt: skip
        if diameters:
            words = "Whether the values are on radius (if left out) or on diameter."
            entries.append(Entry("on", words, Choice(("radius", "diameter"))))
        self.within = TextOr(self.rows, Table("Profile", *entries, on_one_line=True))

    def read(self, raw: object, place: Place, report: Report) -> Any:
        """Return a `WidthProfile`, on radius; None for no rows at all."""
        found = len(report.problems)
        read = self.within.read(raw, place, report)
        if read is NOTHING or len(report.problems) > found:
            return NOTHING
        table = read if isinstance(read, Record) else {"rows": read}
        rows, on = table.get("rows", []), table.get("on", "radius")
        if not rows and "crown" not in table:
            return None
        half, factor = 0.5 if on == "diameter" else 1.0, table.get("factor", 1.0)
        values = [half * value for _, value in rows]
        if on == "diameter" and values and min(values) > _LARGEST:  # whole diameters
            mean = sum(values) / len(values)
            values = [value - mean for value in values]
        crown = factor * half * table.get("crown", 0.0)
        values = [factor * value for value in values]
        heights = [*values, crown]
        if self.diameters and not self._deviations(heights, half, place, report):
            return NOTHING
        built = report.tried(
            lambda: WidthProfile(
                position=tuple(y for y, _ in rows),
                value=tuple(values),
                crown=crown,
                uncertainty=factor * half * table["uncertainty"]
                if "uncertainty" in table
                else None,
            ),
            place,
        )
        return NOTHING if built is None else built

    def _deviations(self, values: list[float], half: float, place: Place, report: Report) -> bool:
        """Whether values are deviations of a radius; reported if not."""
        worst = max(values, key=abs, default=0.0)
        if abs(worst) <= _LARGEST:
            return True
        report.add(
            place,
            f"must be a deviation of radius up to {display(_LARGEST, 'length')}",
            'Correct it, or write on = "diameter".',
            quantity_text(worst / half, "length"),
        )
        return False

    def written(self, value: Any) -> Any:
        """Return rows, or a table where there is more to say."""
        rows = self.rows.written(zip(value.position, value.value, strict=True))
        table = {
            "crown": quantity_text(value.crown, self.dimension) if value.crown else None,
            "rows": rows or None,
            "uncertainty": None
            if value.uncertainty is None
            else quantity_text(value.uncertainty, self.dimension),
        }
        table = {key: item for key, item in table.items() if item is not None}
        return rows if list(table) == ["rows"] else table

    def schema(self) -> dict[str, Any]:
        """Rows, or a table."""
        return self.within.schema()


PULLEY_END = Table(
    "pulley",
    need("distance", "Length of the span from tangent to tangent."),
    of=GrippingPulley,
    on_one_line=True,
)
TRANSITION = Table(
    "transition",
    need("length", "From the last full trough to the pulley.", example='length = "2.9 m"'),
    need("trough_angle", "Of the wing rolls.", example='trough_angle = "35 deg"'),
    need("centre_roll", "Width of belt on the centre roll.", example='centre_roll = "465 mm"'),
    Entry("depth", "Full: the pulley level with the centre roll; half: raised by half the trough.",
          Choice(DEPTHS)),
    of=Transition,
    on_one_line=True,
)  # fmt: skip
BEFORE = Variant("kind", "What the span before the pulley comes from.", PULLEY_END, TRANSITION)
AFTER = Variant("kind", "Where the span after the pulley goes to.", PULLEY_END)

ACROSS = Table(
    "Across the width",
    Entry("shell_profile", "Radius of the shell over its mean: crown, out of true.",
          Profile("length", diameters=True)),
    Entry("worn_depth", "Depth worn off the lagging, on radius.",
          Profile("length", diameters=True)),
    Entry("build_up", "Material stuck to the pulley, on radius.",
          Profile("length", diameters=True)),
    Entry("misalignment", "Skew of the pulley in the plane of the bisector of its wrap, as slope."),
    Entry("deflection", "How far the middle of the face is drawn in, relative to its edges."),
    Entry("entry_profile", "Deviation of the belt tension far before the pulley.",
          Profile("force_per_width")),
    Entry("before", "What the span before comes from; far if left out.", WordOr(_FAR, BEFORE)),
    Entry("after", "Where the span after goes to; far if left out.", WordOr(_FAR, AFTER)),
    Entry("strips", "Strips that the belt is cut into; 32 if left out.",
          Count(FEWEST_STRIPS, MOST_STRIPS)),
    of=Across,
)  # fmt: skip


def build_across(record: Any, report: Report) -> Across | None:
    """Return what a ``[pulley.across]`` table says; None if there is none, or after reporting."""
    if not isinstance(record, Record):
        return None
    ends = {
        key: kind.built(record[key], report)
        for key, kind in (("before", BEFORE), ("after", AFTER))
        if isinstance(record.get(key), Record)
    }
    built: Across | None = ACROSS.built(record, report, **ends)
    return built


def check_width(pulleys: list[Record], belt: Any, report: Report) -> None:
    """Report what of the pulleys lies beyond the edges of the belt."""
    if not isinstance(belt, Record) or "width" not in belt:
        return
    for pulley in pulleys:
        across = pulley.get("across")
        if not isinstance(across, Record):
            continue
        for key, profile in across.items():
            if isinstance(profile, WidthProfile):
                for problem in profile.problems("", belt["width"]):
                    report.take(InputError(problem), (*across.place, key))
