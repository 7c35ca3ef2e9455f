"""The units that wraparc reads, each defined by units defined before it.

The list is closed and free of automatic prefixes, so that a unit text means one thing
only: ``min`` is a minute, ``PIW`` a pound-force per inch of width, and ``mN`` is never
taken for ``MN`` by a typing slip that a prefix rule would accept. Only ``lb`` has two meanings, by
what is measured: a force per width in ``lb/in``, a mass per length in ``lb/ft``, each where the
other cannot stand.
"""

from decimal import Decimal
from typing import Literal, NamedTuple, get_args

Dimension = Literal[
    "length",
    "force",
    "force_per_width",
    "spring_rate",
    "pressure",
    "pressure_per_length",
    "speed",
    "angle",
    "power",
    "torque",
    "area",
    "time",
    "temperature",
    "per_length",
    "wear_coefficient",
    "energy_per_area",
    "power_per_area",
    "rotation_speed",
    "frequency",
    "mass",
    "mass_per_length",
    "mass_flow",
    "density",
    "moment_of_inertia",
    "number",
]

DIMENSIONS: tuple[Dimension, ...] = get_args(Dimension)


class DimensionText(NamedTuple):
    """How a dimension is written: its SI unit, its name in a sentence, an example."""

    si_unit: str
    name: str
    example: str


DIMENSION_TEXT: dict[Dimension, DimensionText] = {
    "length": DimensionText("m", "a length", "1200 mm"),
    "force": DimensionText("N", "a force", "150 kN"),
    "force_per_width": DimensionText("N/m", "a force per width", "12960 kN/m"),
    "spring_rate": DimensionText("N/m", "a spring rate", "12000 kN/m"),
    "pressure": DimensionText("Pa", "a pressure", "200 kPa"),
    "pressure_per_length": DimensionText("Pa/m", "a pressure per length", "190 kPa/mm"),
    "speed": DimensionText("m/s", "a speed", "3 m/s"),
    "angle": DimensionText("rad", "an angle", "180 deg"),
    "power": DimensionText("W", "a power", "250 kW"),
    "torque": DimensionText("N m", "a torque", "40 kN m"),
    "area": DimensionText("m2", "an area", "2500 mm2"),
    "time": DimensionText("s", "a time", "10 s"),
    "temperature": DimensionText("K", "a temperature", "20 degC"),
    "per_length": DimensionText("1/m", "a value per length", "-0.016 1/mm"),
    "wear_coefficient": DimensionText("m3/J", "a wear volume per energy", "0.05 mm3/J"),
    "energy_per_area": DimensionText("J/m2", "an energy per area", "800 J/m2"),
    "power_per_area": DimensionText("W/m2", "a power per area", "1500 W/m2"),
    "rotation_speed": DimensionText("rad/s", "a rotation speed", "71.6 rpm"),
    "frequency": DimensionText("Hz", "a frequency", "1.2 Hz"),
    "mass": DimensionText("kg", "a mass", "500 kg"),
    "mass_per_length": DimensionText("kg/m", "a mass per length", "22 kg/m"),
    "mass_flow": DimensionText("kg/s", "a mass flow", "1500 t/h"),
    "density": DimensionText("kg/m3", "a density", "1600 kg/m3"),
    "moment_of_inertia": DimensionText("kg m2", "a moment of inertia", "2200 kg m2"),
    "number": DimensionText("", "a plain number", "0.35"),
}

#: Dimensions of masses: a pound is one of mass there, of force elsewhere.
OF_MASS: tuple[Dimension, ...] = (
    "mass", "mass_per_length", "mass_flow", "density", "moment_of_inertia",
)  # fmt: skip
#: Tons of which nobody knows which they are: as a mass, and as a force.
TONS = ("ton", "tons", "Ton", "Tons", "TON", "TONS", "tn", "tns")

#: Units that are not built from others.
BASE_UNITS = ("kg", "m", "s", "K", "rad")


class Definition(NamedTuple):
    """One unit: its names, and ``factor`` times ``unit``; 0 of it lies at ``zero``."""

    names: tuple[str, ...]
    factor: Decimal
    unit: str
    zero: Decimal = Decimal(0)


def _define(names: str, factor: str, unit: str, zero: str = "0") -> Definition:
    return Definition(tuple(names.split()), Decimal(factor), unit, Decimal(zero))


# Factors are exact by definition (BIPM SI Brochure, 9th ed. 2019; NIST SP 811, 2008,
# appendix B: inch, pound, standard gravity), save those with pi or 5/9, held to 28 digits.
DEFINITIONS: tuple[Definition, ...] = (
    _define("meter meters metre metres", "1", "m"),
    _define("km", "1000", "m"),
    _define("dm", "0.1", "m"),
    _define("cm", "0.01", "m"),
    _define("mm", "0.001", "m"),
    _define("um micron microns", "1e-6", "m"),
    _define('in inch inches "', "0.0254", "m"),
    _define("ft foot feet", "12", "in"),
    _define("yd", "3", "ft"),
    _define("mi mile miles", "5280", "ft"),
    _define("thou", "0.001", "in"),
    _define("g", "0.001", "kg"),
    _define("t tonne tonnes", "1000", "kg"),
    _define("lbm", "0.45359237", "kg"),
    _define("ston stons", "2000", "lbm"),
    _define("lton ltons", "2240", "lbm"),
    _define("sec second seconds", "1", "s"),
    _define("ms", "0.001", "s"),
    _define("min minute minutes", "60", "s"),
    _define("h hr hour hours", "60", "min"),
    _define("d day days", "24", "h"),
    _define("N newton newtons", "1", "kg m/s2"),
    _define("mN", "0.001", "N"),
    _define("daN", "10", "N"),
    _define("kN", "1000", "N"),
    _define("MN", "1e6", "N"),
    _define("kgf kp", "9.80665", "N"),
    _define("gf", "0.001", "kgf"),
    _define("tf", "1000", "kgf"),
    _define("lbf lb lbs", "4.4482216152605", "N"),
    _define("klbf kip kips", "1000", "lbf"),
    _define("PIW piw PLI pli", "1", "lbf/in"),
    _define("Pa", "1", "N/m2"),
    _define("hPa", "100", "Pa"),
    _define("kPa", "1000", "Pa"),
    _define("MPa", "1e6", "Pa"),
    _define("GPa", "1e9", "Pa"),
    _define("bar", "1e5", "Pa"),
    _define("mbar", "100", "Pa"),
    _define("psi PSI", "1", "lbf/in2"),
    _define("ksi", "1000", "psi"),
    _define("J joule", "1", "N m"),
    _define("mJ", "0.001", "J"),
    _define("kJ", "1000", "J"),
    _define("MJ", "1e6", "J"),
    _define("Nm", "1", "N m"),
    _define("kNm", "1000", "N m"),
    _define("MNm", "1e6", "N m"),
    _define("W watt watts", "1", "J/s"),
    _define("kW", "1000", "W"),
    _define("MW", "1e6", "W"),
    _define("hp HP bhp BHP", "550", "ft lbf/s"),
    _define("PS cv CV hp(metric)", "75", "kgf m/s"),
    _define("fpm FPM", "1", "ft/min"),
    _define("fps", "1", "ft/s"),
    _define("mps", "1", "m/s"),
    _define("kph kmh", "1", "km/h"),
    _define("mph", "1", "mi/h"),
    _define("tph TPH mtph MTPH", "1", "t/h"),
    _define("stph STPH", "1", "ston/h"),
    _define("ltph LTPH", "1", "lton/h"),
    _define("Hz hertz", "1", "1/s"),
    _define("mrad", "0.001", "rad"),
    _define("deg degree degrees °", "0.01745329251994329576923690768", "rad"),
    _define("rev turn turns", "360", "deg"),
    _define("rpm RPM", "1", "rev/min"),
    _define("degC °C", "1", "K", zero="-273.15"),
    _define("degF °F", "0.5555555555555555555555555556", "K", zero="-459.67"),
    _define("% percent", "0.01", ""),
)
