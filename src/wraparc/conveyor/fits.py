"""What of a conveyor with flights does not fit together."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

from wraparc.conveyor.description import ConveyorData
from wraparc.conveyor.flight import LOADED_WORDS, NONE, ConveyorCase
from wraparc.conveyor.local import PulleyResistance, TiltResistance
from wraparc.errors import Problem, format_names, name_remedy, shown
from wraparc.units import display

#: By how much of the whole length the flights may miss length and lift [-].
CLOSING = 0.001
#: Load cases that a conveyor has without being asked.
RESERVED = ("full", "empty", "inclines", "declines", "start", "stop")


def flight_misfits(of: ConveyorData) -> Iterator[Problem]:
    """Yield what of a conveyor and its flights does not fit together."""
    if len(of.flights) > 0:
        yield from _closing(of)
    for i, flight in enumerate(of.flights):
        for problem in flight.misfits():
            yield replace(problem, key=f"flight[{i + 1}].{problem.key}")
    names = [flight.name for flight in of.course_flights]
    yield from _repeated("flight", names)
    yield from _repeated("loading", [point.name for point in of.loadings])
    yield from _repeated("load_case", [case.name for case in of.cases])
    yield from _repeated("drive", [drive.pulley for drive in of.drives])
    yield from _loadings(of, names)
    for i, case in enumerate(of.cases):
        yield from _case(of, case, f"load_case[{i + 1}]", names)
    yield from _drives(of)
    yield from _locals(of)
    for key, stated in (("length_coefficient", of.length_coefficient is not None),
                        ("secondary_resistance", of.secondary_resistance is not None)):  # fmt: skip
        if stated and of.itemised:
            message = "contradicts [[conveyor.resistance]], which gives them one by one"
            yield Problem(key=key, message=message, remedy="Leave one of them out.")


def _closing(of: ConveyorData) -> Iterator[Problem]:
    """Yield where the flights do not make the whole conveyor."""
    long, high = sum(f.length for f in of.flights), sum(f.rise for f in of.flights)
    for key, given, made in (("length", of.length, long), ("lift", of.lift, high)):
        if abs(given - made) > CLOSING * of.length:
            message = f"the flights make {display(made, 'length')}"
            remedy = "Correct a flight, or leave it out."
            value = display(given, "length")
            yield Problem(key=key, value=value, message=message, remedy=remedy)


def _repeated(key: str, names: Sequence[str]) -> Iterator[Problem]:
    for i, name in enumerate(names):
        if name in names[:i]:
            remedy = "Give each its own name."
            yield Problem(key=f"{key}[{i + 1}]", value=name, message="used twice", remedy=remedy)


def _beyond(of: ConveyorData, key: str, position: float | None) -> Iterator[Problem]:
    """Yield a position behind the end of the conveyor."""
    if position is not None and position > of.length * (1.0 + 1e-9):
        message = f"is on no flight, the conveyor is {display(of.length, 'length')} long"
        given = display(position, "length")
        yield Problem(key=f"{key}.position", value=given, message=message)


def _loadings(of: ConveyorData, names: Sequence[str]) -> Iterator[Problem]:
    for i, point in enumerate(of.loadings):
        key = f"loading[{i + 1}]"
        if point.flight and point.flight not in names:
            value, remedy = shown(point.flight), name_remedy(point.flight, names)
            message = "no such flight"
            yield Problem(key=f"{key}.flight", value=value, message=message, remedy=remedy)
        yield from _beyond(of, key, point.position)
        if point.capacity is not None and of.speed is None:
            remedy = 'Write speed = "3 m/s" in [belt].'
            yield Problem(key=f"{key}.capacity", message="needs the belt speed", remedy=remedy)
    if of.itemised and of.speed is None:
        remedy = 'Write speed = "3 m/s" in [belt].'
        yield Problem(key="resistance", message="needs the belt speed", remedy=remedy)


def _case(
    of: ConveyorData, case: ConveyorCase, key: str, names: Sequence[str]
) -> Iterator[Problem]:
    if case.name in RESERVED:
        message = "is a load case of every conveyor"
        remedy = "Give it another name."
        yield Problem(key=f"{key}.name", value=shown(case.name), message=message, remedy=remedy)
    listed = () if isinstance(case.loaded, str) else case.loaded
    if isinstance(case.loaded, str) and case.loaded not in LOADED_WORDS:
        remedy = f"Write one of {format_names(LOADED_WORDS)}, or an array of flights."
        message = "must say which flights have material"
        yield Problem(key=f"{key}.loaded", value=shown(case.loaded), message=message, remedy=remedy)
        return
    yield from _unknown(f"{key}.loaded", listed, names)
    yield from _unknown(f"{key}.factor", case.factor, names)
    loads = [case.factor_of(flight) for flight in of.course_flights]
    if case.loaded != NONE and max(loads) <= 0.0 and all(name in names for name in listed):
        message = "loads no flight"
        remedy = 'Name flights, or write loaded = "none" for the empty belt.'
        yield Problem(key=f"{key}.loaded", message=message, remedy=remedy)
    for kind, keys in (("starting", "start_time"), ("braking", "stop_time")):
        known = of.stop_time if kind == "braking" else (of.start_time or of.start_factor)
        if case.kind == kind and known is None:
            remedy = f'Write {keys} = "20 s".'
            message = f"needs {keys} of [conveyor]"
            yield Problem(key=f"{key}.kind", value=kind, message=message, remedy=remedy)


def _unknown(key: str, given: Iterable[str], names: Sequence[str]) -> Iterator[Problem]:
    for name in given:
        if name not in names:
            remedy = name_remedy(name, names)
            yield Problem(key=key, value=shown(name), message="no such flight", remedy=remedy)


def _drives(of: ConveyorData) -> Iterator[Problem]:
    """Yield drives that stand on no flight, or not in the order of the belt."""
    for i, drive in enumerate(of.drives):
        yield from _beyond(of, f"drive[{i + 1}]", drive.position)
    pulleys = [drive.pulley for drive in of.drives]
    if of.take_up_after and of.take_up_after not in pulleys:
        remedy = name_remedy(of.take_up_after, pulleys)
        value = shown(of.take_up_after)
        yield Problem(key="take_up.after", value=value, message="no such pulley", remedy=remedy)
    if of.take_up_after and of.take_up_distance > 0.0:
        message = "is a second take-up, besides that after a pulley of [take_up]"
        value = display(of.take_up_distance, "length")
        remedy = "A belt has one take-up: leave one of them out."
        yield Problem(key="take_up_distance", value=value, message=message, remedy=remedy)
    along = [of.along(drive) for drive in of.drives]
    turns = sum(
        along[(i + 1) % len(along)] < along[i] - 1e-9 * of.length for i in range(len(along))
    )
    if turns > 1:
        message = "the pulleys are not in belt order"
        remedy = "List [[pulley]] as the belt meets them: from the tail up, back along the return."
        yield Problem(key="drive", message=message, remedy=remedy)
    shares = [d.brake_share for d in of.drives if d.brake_share is not None]
    if len(shares) > 0 and abs(sum(shares) - 1.0) > 1e-6:
        message = f"the brake shares sum to {sum(shares):.6g}, not to 1"
        remedy = "Give fractions like 0.5 or 50 %."
        yield Problem(key="drive", message=message, remedy=remedy)


def _locals(of: ConveyorData) -> Iterator[Problem]:
    bends = False
    for i, local in enumerate(of.locals):
        if not isinstance(local, TiltResistance):
            yield from _beyond(of, f"resistance[{i + 1}]", local.position)
        bends = bends or isinstance(local, PulleyResistance)
    if bends and of.thickness is None:
        message = "needs the thickness of the belt"
        remedy = 'Write thickness = "15 mm" in [belt].'
        yield Problem(key="resistance", message=message, remedy=remedy)
