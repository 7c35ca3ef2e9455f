"""The tandems of the examples, put into motion in different ways."""

from wraparc import load_train
from wraparc.motion import Control, Drum, Station

INERTIA = {"fabric": 2200.0, "steel-cord": 6000.0}
#: 2.3 MPa over the gross area, for which the theory was computed: of blocks on 85 % of it.
RUBBER = {f"pulley.{d}.lagging.shear_modulus": f"{2300 / 0.85} kPa" for d in ("first", "second")}
TRAINS = {name: load_train(f"examples/tandem-{name}.toml", overrides=RUBBER) for name in INERTIA}


def station(name: str, first: Control, second: Control, **more: object) -> Station:
    """A tandem whose outer tensions are held, unless a mass is given."""
    drums = tuple(Drum(inertia=INERTIA[name], control=c) for c in (first, second))
    return Station(train=TRAINS[name], drums=drums, **more)  # type: ignore[arg-type]


def moving(name: str, first: Control, second: Control, **more: object) -> Station:
    """A tandem with a conveyor of 100 t."""
    return station(name, first, second, conveyor_mass=100e3, **more)
