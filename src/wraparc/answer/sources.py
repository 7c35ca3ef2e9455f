"""Where the numbers of a sheet came from: numbered, each named once."""

from wraparc.provenance import Kind, Provenance


class Sources:
    """Sources in the order in which a sheet refers to them."""

    def __init__(self) -> None:
        self._numbers: dict[str, int] = {}

    def note(self, provenance: Provenance) -> str:
        """Return what stands beside a number: ``published [1], rated tension``.

        Nothing stands beside what was just given.
        """
        origin = ", ".join(part for part in (provenance.source, provenance.date) if part)
        if not origin:
            kind = "" if provenance.kind is Kind.GIVEN else str(provenance.kind)
        else:
            number = self._numbers.setdefault(origin, len(self._numbers) + 1)
            kind = f"{provenance.kind_text} [{number}]"
        return ", ".join(part for part in (kind, provenance.note) if part)

    def number(self, text: str) -> str:
        """Return the number of a source told as a text, ``[2]``; nothing for no text."""
        return f"[{self._numbers.setdefault(text, len(self._numbers) + 1)}]" if text else ""

    def listed(self) -> tuple[str, ...]:
        """Return every source, the first being number 1."""
        return tuple(self._numbers)
