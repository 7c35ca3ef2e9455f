"""How accurately many arcs are solved."""

from __future__ import annotations

from enum import StrEnum


class Setting(StrEnum):
    """How accurately a batch is solved."""

    #: exit creep and shear within 1e-4 of the exact ones
    ENGINEERING = "engineering"
    #: within 1e-6
    PRECISE = "precise"

    @property
    def accuracy(self) -> float:
        """Largest relative error [-]."""
        return 1e-4 if self is Setting.ENGINEERING else 1e-6
