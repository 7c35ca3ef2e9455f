"""What the tags of a drive are called: words of its signals, in the languages of plants."""

from collections.abc import Iterable, Sequence

from wraparc.machine_tables.columns import plain_name

SPEED = ("speed", "drehzahl", "rpm", "vitesse", "velocidad", "n")
BELT = ("belt", "band", "gurt", "tacho", "conveyor", "bandgeschwindigkeit", "gurtgeschwindigkeit")
VELOCITY = ("speed", "geschwindigkeit", "vitesse", "velocidad")
TORQUE = ("torque", "drehmoment", "moment", "couple", "par")
POWER = ("power", "leistung", "puissance", "potencia")
CURRENT = ("current", "strom", "courant", "corriente")
#: Shorter words stand alone; longer ones may end a word, as in German.
_SHORT = 4


def has_word(name: str, words: Sequence[str]) -> bool:
    """Return whether a name has one of some words."""
    own = plain_name(name).split()
    return any(
        w == word or (len(word) > _SHORT and w.endswith(word)) for w in own for word in words
    )


def is_belt_speed(name: str) -> bool:
    """Return whether a name is that of a belt speed."""
    plain = plain_name(name)
    return has_word(name, VELOCITY) and any(word in plain for word in BELT)


def is_motor_speed(name: str) -> bool:
    """Return whether a name is that of a motor speed."""
    return has_word(name, SPEED) and not is_belt_speed(name)


def are_of_drive(names: Iterable[str]) -> bool:
    """Return whether names are those of the log of a drive: a speed, and what it is loaded with."""
    all_names = list(names)
    load = (*TORQUE, *POWER, *CURRENT)
    return any(map(is_motor_speed, all_names)) and any(has_word(name, load) for name in all_names)
