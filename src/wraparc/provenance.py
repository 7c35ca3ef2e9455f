"""Where a number came from. It travels with the number into every report."""

from dataclasses import dataclass
from enum import StrEnum

from wraparc.errors import input_error


class Kind(StrEnum):
    """How a number came to be, from the strongest ground to the weakest."""

    MEASURED = "measured"
    PUBLISHED = "published"
    CALIBRATED = "calibrated"
    ILLUSTRATIVE = "illustrative"
    GIVEN = "given"


@dataclass(frozen=True)
class Provenance:
    """The origin of a number or of a set of numbers.

    Parameters
    ----------
    kind
        ``MEASURED`` in a test, ``PUBLISHED`` by somebody, ``CALIBRATED`` so that a
        model meets a known result, ``ILLUSTRATIVE`` (plausible, for no real product),
        or ``GIVEN`` by the user without a source.
    source
        Citation: author or maker, title, year, page or table. A published number must
        have one.
    date
        When it was measured, published or retrieved, as written there.
    note
        What a reader must know before using it.

    Raises
    ------
    InputError
        If `kind` is ``PUBLISHED`` and `source` is empty.
    """

    kind: Kind = Kind.GIVEN
    source: str = ""
    date: str = ""
    note: str = ""

    def __post_init__(self) -> None:
        if self.kind is Kind.PUBLISHED and not self.source.strip():
            raise input_error(
                message="a published number without a source",
                remedy="Name the publication, or call the number given or illustrative.",
            )

    @property
    def kind_text(self) -> str:
        """The kind in words; a number without a source is an input."""
        return "input" if self.kind is Kind.GIVEN else str(self.kind)

    def __str__(self) -> str:
        origin = ", ".join(part for part in (self.source, self.date) if part)
        stated = f"{self.kind_text}: {origin}" if origin else self.kind_text
        return f"{stated} ({self.note})" if self.note else stated
