"""The profiles of a result as a table for a spreadsheet."""

import csv
import io
from collections.abc import Iterable

from wraparc.arc import ArcResult
from wraparc.glossary import GLOSSARY
from wraparc.units import System, display_unit

#: Opens a text for Excel, which otherwise takes UTF-8 for the code page of the machine.
BYTE_ORDER_MARK = "\ufeff"
_PLACE = ("load_case", "pulley", "method")
# A spreadsheet runs a cell that begins with one of these.
_FORMULA = ("=", "+", "-", "@", "\t", "\r")


def profile_csv(
    arcs: Iterable[ArcResult], system: System = "si", *, decimal_comma: bool = False
) -> str:
    """Return the profiles of arcs, one under the other, one line for each point.

    The first columns say which load case, pulley and method a line belongs to; the others are
    the columns of `wraparc.arc.Profile` with their unit, ``wrap_pressure [kPa]``.

    Parameters
    ----------
    arcs
        The results.
    system
        Units of the columns.
    decimal_comma
        Decimal commas, and semicolons between columns, for a spreadsheet that is set to them.
    """
    stream = io.StringIO()
    writer = csv.writer(stream, delimiter=";" if decimal_comma else ",", lineterminator="\r\n")
    for first, result in enumerate(arcs):
        columns = dict(result.profile.columns())
        if not first:
            writer.writerow([*_PLACE, *(_head(name, system) for name in columns)])
        place = tuple(map(no_formula, (result.arc.load_case, result.arc.pulley, result.method)))
        scaled = [
            (values / display_unit(GLOSSARY[name].dimension, system)[1]).tolist()
            for name, values in columns.items()
        ]
        for numbers in zip(*scaled, strict=True):
            texts = (f"{number + 0.0:.10g}" for number in numbers)
            writer.writerow([*place, *(t.replace(".", ",") if decimal_comma else t for t in texts)])
    return BYTE_ORDER_MARK + stream.getvalue()


def _head(name: str, system: System) -> str:
    unit, _ = display_unit(GLOSSARY[name].dimension, system)
    return f"{name} [{unit}]" if unit else name


def no_formula(name: str) -> str:
    """Return a text so that a spreadsheet does not take it for a formula."""
    return f"'{name}" if name.startswith(_FORMULA) else name
