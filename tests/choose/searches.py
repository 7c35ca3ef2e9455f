"""Searches for the tests, small enough to be solved one by one."""

from dataclasses import replace

from wraparc import Belt, Drive, LoadCase, Pulley, Tensions, load_lagging
from wraparc.choose.cost import BeltPrice, Costing, Price
from wraparc.choose.search import Limits, Search
from wraparc.drive import Cost
from wraparc.drive.conditions import Condition
from wraparc.provenance import Provenance

RUBBER, CERAMIC = load_lagging("diamond-rubber"), load_lagging("full-ceramic")
FABRIC = Belt(name="fabric", width=1.2, modulus=12.96e6, rating=175e3, speed=3.0)
CORD = Belt(
    name="cord", width=1.2, modulus=72e6, rating=150e3, speed=3.0, least_pulley_diameter=0.8
)


def drive(entry: float = 130e3, leaving: float = 55e3) -> Drive:
    pulley = Pulley(name="head", diameter=0.8, wrap_angle=3.2, lagging=RUBBER)
    return Drive(
        title="head drive",
        belt=FABRIC,
        pulleys=(pulley,),
        load_cases=(
            LoadCase(name="full", tensions={"head": Tensions(entry=entry, exit=leaving)}),
            LoadCase(name="brake", tensions={"head": Tensions(entry=leaving - 15e3, exit=leaving)}),
        ),
    )


def price(material: float, life: float) -> Price:
    cost = Cost(
        material=material, installation=4000, currency="EUR", area=6.0, life_years=(life, life)
    )
    return Price(cost=cost, source=Provenance())


def search(**changes: object) -> Search:
    costing = Costing(
        currency="EUR",
        years=10.0,
        laggings={RUBBER.name: price(600, 2.0), CERAMIC.name: price(4600, 10.0)},
        belts={
            "fabric": BeltPrice(price=50e3, life_years=10),
            "cord": BeltPrice(price=90e3, life_years=15),
        },
        tariff=0.2,
        hours={"full": 5000.0},
    )
    base = Search(
        drive=drive(),
        pulley="head",
        laggings=(RUBBER, CERAMIC),
        belts=(FABRIC, CORD),
        diameters=(0.7, 0.9),
        wrap_angles=(3.2,),
        slack_tensions=(45e3, 60e3),
        conditions=(Condition(name="dry"), Condition(name="wet", factor=0.85)),
        limits=Limits(),
        costing=costing,
    )
    return replace(base, **changes)  # type: ignore[arg-type]
