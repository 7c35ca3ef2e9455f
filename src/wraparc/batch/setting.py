"""How accurately many arcs are solved."""

from __future__ import annotations

from enum import StrEnum

from wraparc.errors import InputError, Problem, name_remedy, shown


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


def named_setting(name: Setting | str) -> Setting:
    """Return a setting by its name.

    Raises
    ------
    InputError
        If there is none.
    """
    try:
        return Setting(name)
    except ValueError:
        remedy = name_remedy(str(name), [str(setting) for setting in Setting])
        problem = Problem(
            key="setting", value=shown(name), message="no such setting", remedy=remedy
        )
        raise InputError(problem) from None
