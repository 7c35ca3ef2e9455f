"""The stiffness of a belt as makers state it: its elongation at a share of its strength."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Any, NamedTuple

from wraparc.errors import InputError
from wraparc.schema.kinds import Kind
from wraparc.schema.problems import NOTHING, Place, Report
from wraparc.units import parse_quantity

_TEXT = re.compile(r"(.+?)%\s*(?:at|@|bei|a|à|/)\s*(.+?)%(?:.*strength)?", re.IGNORECASE)
#: Elongations that belts have at their shares of the strength [-].
MOST_STRAIN, MOST_SHARE = 0.2, 1.0


class ElongationAt(NamedTuple):
    """An elongation at a share of the breaking strength [-]."""

    strain: float
    share: float

    def __str__(self) -> str:
        """Return it as it is written."""
        return f"{100.0 * self.strain:.4g} % at {100.0 * self.share:.4g} %"


@dataclass(eq=False, repr=False)
class Elongation(Kind):
    """An elongation at a share of the breaking strength, ``1.5 % at 10 %``."""

    def read(self, raw: object, place: Place, report: Report) -> Any:
        """Return both."""
        found = _TEXT.fullmatch(raw.strip().replace(",", ".")) if isinstance(raw, str) else None
        remedy = 'Write for example "1.5 % at 10 %".'
        if found is None:
            report.add(place, "must be an elongation at a share of the strength", remedy, raw)
            return NOTHING
        try:
            of = ElongationAt(*(parse_quantity(f"{found[n]} %", "number") for n in (1, 2)))
        except InputError:
            report.add(place, "must be an elongation at a share of the strength", remedy, raw)
            return NOTHING
        if not (0.0 < of.strain <= MOST_STRAIN and 0.0 < of.share <= MOST_SHARE):
            message = f"must be above 0 %, at most {100.0 * MOST_STRAIN:g} % at 100 %"
            report.add(place, message, remedy, raw)
            return NOTHING
        return of

    def schema(self) -> dict[str, Any]:
        """Text of two shares."""
        return {"type": "string", "examples": ["1.5 % at 10 %"]}
