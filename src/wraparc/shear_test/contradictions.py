"""What a machine file says of its test against the plan: used where the plan is silent."""

from dataclasses import replace

from wraparc.shear_test.misfit import Sentence
from wraparc.shear_test.plan import PlannedTest, TestPlan
from wraparc.shear_test.record import MachineRecord
from wraparc.shear_test.speeds import measured_speed
from wraparc.shear_test.stated import Stated, stated_text

# Largest difference that is none, as a share; of temperature [K]. Ours.
_SAME = {"pressure": 0.05, "normal force": 0.05, "area": 0.05, "speed": 0.2}
_SAME_TEMPERATURE = 5.0
# Speed by time and travel may differ by more: it is that of the middle of the test. Ours.
_SAME_MEASURED = 0.5


def with_stated(test: PlannedTest, record: MachineRecord) -> PlannedTest:
    """Return a test with what its file says of it and the plan does not.

    Parameters
    ----------
    test, record
        The test as planned, and as read.
    """
    said = {item.of: item for item in record.stated}
    if test.temperature is None and "temperature" in said:
        test = replace(test, temperature=said["temperature"].value)
    silent = test.pressure is None and test.normal_force is None and record.normal_force is None
    if silent and "pressure" in said:
        return replace(test, pressure=said["pressure"].value)
    if silent and "normal force" in said:
        return replace(test, normal_force=said["normal force"].value)
    return test


def contradictions(plan: TestPlan, test: PlannedTest, record: MachineRecord) -> list[Sentence]:
    """Return a sentence for each value of the plan that its file says otherwise.

    Parameters
    ----------
    plan, test, record
        The plan, a test of it, and its record.
    """
    force = plan.set_force(test)
    planned = {
        "pressure": None if force is None else force / plan.rig.area,
        "normal force": force,
        "temperature": test.temperature,
        "speed": test.speed,
        "area": plan.rig.area,
    }
    if record.normal_force is not None:  # that is held against the plan by itself
        planned |= {"normal force": None}
    found = []
    for item in record.stated:
        own = planned.get(item.of)
        if item.of == "condition":
            other = test.condition if test.condition in {"dry", "wet"} else item.word
            if other != item.word:
                found.append(_contradiction(item, other))
        elif own is not None and not _is_same(item.of, item.value, own):
            found.append(_contradiction(item, stated_text(item.of, own)))
        elif item.of == "speed" and own is None and item.place.startswith("its column"):
            measured = measured_speed(record)
            if measured and abs(item.value / measured - 1.0) > _SAME_MEASURED:
                found.append(_own_speed(item, stated_text("speed", measured)))
    return found


def _is_same(of: str, value: float, own: float) -> bool:
    if of == "temperature":
        return abs(value - own) <= _SAME_TEMPERATURE
    return abs(value / own - 1.0) <= _SAME[of]


def _contradiction(item: Stated, own: str) -> Sentence:
    text = f"{item.place} says {item.of} {item.text}, the plan {own}: one of them is wrong"
    return Sentence(
        f"stated {item.of}",
        text,
        f"the file says {item.text}, the plan {own}",
        f"Correct the {item.of} in the plan, or in the file.",
    )


def _own_speed(item: Stated, measured: str) -> Sentence:
    text = (
        f"{item.place} says speed {item.text}, its time and travel {measured}: one of their units "
        "may be wrong"
    )
    head = f"the file says {item.text}, its travel and time {measured}"
    return Sentence("stated speed", text, head, "Check the units of time and travel.")
