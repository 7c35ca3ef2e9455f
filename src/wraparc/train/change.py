"""What becomes of the shares when something happens to one drum and the speeds stay as they are."""

from __future__ import annotations

from dataclasses import replace

from wraparc.arc import Distributed
from wraparc.drive import Lagging
from wraparc.errors import input_error, name_remedy, shown
from wraparc.train.result import CaseResult, TrainResult
from wraparc.train.solve import solve_case
from wraparc.train.walk import held
from wraparc.units import display


def what_if(
    result: TrainResult,
    case: str = "",
    *,
    pulley: str,
    wear: float = 0.0,
    lagging: Lagging | None = None,
    method: Distributed | None = None,
) -> CaseResult:
    """Return a load case after a change on one drum, all drums turning as fast as before.

    Drives on motors follow their motors.

    Parameters
    ----------
    result, case
        The solved train, and the load case (the first one without a name).
    pulley
        The drum.
    wear
        Depth worn off its lagging [m]: the diameter shrinks by twice as much, and the lagging that
        is left is thinner.
    lagging
        What is on it instead: another lagging, or the same one wet.
    method
        `Distributed()` without capacities unless given.

    Raises
    ------
    InputError
        If there is no such pulley, or no so much lagging.
    """
    train, _ = held(result, case)
    names = [p.name for p in train.pulleys]
    if pulley not in names:
        remedy = name_remedy(pulley, names)
        raise input_error(
            key="pulley", value=shown(pulley), message="no such pulley", remedy=remedy
        )
    index = names.index(pulley)
    old = train.pulleys[index]
    new = lagging or old.lagging
    if not 0.0 <= wear <= new.thickness:
        message = f"must be between 0 and the thickness {display(new.thickness, 'length')}"
        raise input_error(key="wear", value=display(wear, "length"), message=message)
    changed = replace(
        old,
        diameter=old.diameter - 2.0 * wear,
        lagging=new.with_thickness(new.thickness - wear),
    )
    pulleys = (*train.pulleys[:index], changed, *train.pulleys[index + 1 :])
    train = replace(train, pulleys=pulleys, nominal_diameters=train.nominal)
    return solve_case(train, train.cases[0], method or Distributed(capacities=False))
