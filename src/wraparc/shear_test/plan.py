"""A test plan as data: what was tested, in what rig, under what load, in which files.

Plans are read from TOML by `wraparc.files`; everything here is in SI units.
"""

import math
from dataclasses import dataclass, field

from wraparc.friction import SLIP_INCLUDES
from wraparc.provenance import Kind, Provenance
from wraparc.shear_test.budget import Uncertainty
from wraparc.shear_test.circumstances import LoadCell, ReportHead
from wraparc.shear_test.curve_held import FREE, Held
from wraparc.shear_test.pressure_choice import PressureOptions
from wraparc.shear_test.record import Choices

#: Lash that a rig may have, where the plan does not say [m].
LARGEST_LASH = 3e-3
#: Friction that a test may reach, where the plan does not say [-]; beyond, a unit or a column is
#: more likely wrong than the lagging odd. Ours.
LEAST_FRICTION, MOST_FRICTION = 0.02, 3.0
#: What curves of a figure show: mu over slip, or A and b over pressure.
QUANTITIES = ("friction", "coefficients")
#: Share of full scale by which a point read off a figure may be wrong, where the plan does not say.
USUAL_ERROR = 0.01


@dataclass(frozen=True, kw_only=True)
class Rig:
    """The rig.

    Parameters
    ----------
    area
        Of one face of the sample [m2].
    faces
        Faces that slide.
    compliance
        Travel per pulling force that is the rig's own [m/N].
    largest_lash
        Lash it can have [m]; a curve that asks for more does not follow the law.
    least_friction, most_friction
        Limits of the friction that a test reaches [-]; a test outside them is left out.
    name, machine
        What it is, and the machine it stands in.
    operator
        Who tests with it.
    force_cell, normal_force_cell
        What measures the pulling and the normal force.
    """

    area: float
    faces: int = 2
    compliance: float = 0.0
    largest_lash: float = LARGEST_LASH
    least_friction: float = LEAST_FRICTION
    most_friction: float = MOST_FRICTION
    name: str = ""
    machine: str = ""
    operator: str = ""
    force_cell: LoadCell = field(default_factory=LoadCell)
    normal_force_cell: LoadCell = field(default_factory=LoadCell)


@dataclass(frozen=True, kw_only=True)
class Digitised:
    """The figure that the curves of a plan were read off.

    Parameters
    ----------
    source, figure
        Who published it, and which figures.
    quantity
        ``"friction"``, mu over slip, or ``"coefficients"``, A and b over pressure.
    slip_unit
        SI value of the unit of slip, mm if None; A and b are per this unit, and need it [m].
    pressure_unit
        SI value of the unit of pressure under A and b, which need it [Pa].
    error
        Largest error of a point, as a share of full scale [-].
    slip_max
        Slip up to which A and b hold [m]; None for the peak.
    """

    source: str
    figure: str = ""
    quantity: str = "friction"
    slip_unit: float | None = None
    pressure_unit: float | None = None
    error: float = USUAL_ERROR
    slip_max: float | None = None

    @property
    def metres(self) -> float:
        """The unit of slip [m]."""
        return self.slip_unit or 1e-3

    def provenance(self, given: Provenance | None) -> Provenance:
        """Where the numbers come from; the kind is that of the plan, else published."""
        where = ", ".join(part for part in (self.source, self.figure) if part)
        note = f"read off to {100 * self.error:.2g} % of full scale"
        kind = Kind.PUBLISHED if given is None else given.kind
        return Provenance(kind, source=f"digitised from {where}", note=note)


@dataclass(frozen=True, kw_only=True)
class PlannedTest:
    """One test.

    Parameters
    ----------
    file
        Its file, relative to the plan.
    place
        What to call it in messages, for example ``test[3]``.
    pressure
        Set pressure on the sample [Pa], or None.
    normal_force
        Set normal force [N], or None.
    choices
        Columns, units and the like, where the file does not tell.
    condition
        ``dry``, ``wet`` ...: each becomes a law.
    repeat
        Tests with the same text here are repeats of each other; by default those of one
        condition and one set pressure are.
    temperature
        [K], or None.
    humidity
        Relative humidity of the air [-], or None.
    speed
        Of the crosshead [m/s], or None.
    date
        When it was done.
    order
        Its place in the order in which the tests were done, counted from 1, or None.
    curve
        Which curve of a digitised file; empty for all.
    sample, lot
        Which sample, and of which lot.
    stroke, stick_slip
        Which pull of a record, and which part of stick-slip, is fitted; empty for the middle of
        its swings, and stick-slip asked about.
    belt_cover, conditioning
        What it slid on, and how sample and belt were kept and prepared before.
    operator
        Who tested, if not the operator of the rig.
    use, reason
        Whether the test counts; if it does not, why.
    """

    file: str
    place: str
    pressure: float | None = None
    normal_force: float | None = None
    choices: Choices = field(default_factory=Choices)
    condition: str = "dry"
    repeat: str = ""
    temperature: float | None = None
    humidity: float | None = None
    speed: float | None = None
    date: str = ""
    order: int | None = None
    curve: str = ""
    sample: str = ""
    stroke: str = "first"
    stick_slip: str = ""
    lot: str = ""
    belt_cover: str = ""
    conditioning: str = ""
    operator: str = ""
    use: bool = True
    reason: str = ""

    @property
    def label(self) -> str:
        """What to call it beside others of the same file: the file, and sheet, table or block."""
        of = self.choices
        said = (("sheet", of.sheet), ("table", of.table), ("block", of.block))
        return ", ".join([self.file, *(f"{what} {value}" for what, value in said if value)])


@dataclass(frozen=True, kw_only=True)
class TestPlan:
    """All tests of one lagging.

    Parameters
    ----------
    name, title, description, surface
        Of the lagging, as in a lagging file.
    rig
        The rig.
    tests
        The tests.
    thickness
        Of the lagging [m], or None.
    shear_modulus, elastic_modulus, compression_modulus
        G, E, E_c [Pa], or None; G is E/3 and E_c is E where only E is given.
    roughness
        Of lagging and belt together, for the saturation estimate [m], or None.
    remove_shear
        Whether the sample's own shear is taken off the travel; None to do so if thickness
        and shear modulus are known.
    cover_thickness, cover_shear_modulus
        Cover of the test belt between a sliding face and the carcass [m] and its G [Pa], to take
        its shear off the travel; None leaves it in. A thickness of 0 is no cover.
    options
        How to look for the pressure dependence.
    held
        Parameters of the curves that are given, not fitted.
    provenance
        Of the law.
    head
        Title block and signatures of the report.
    uncertainty
        Largest errors of what was measured with, common to all tests; None adds none.
    digitised
        The figure that the curves were read off, instead of tests.
    file, folder
        Name of the plan's file, and the folder its files are relative to.
    """

    __test__ = False  # not a test class, whatever its name suggests to a test collector

    name: str
    rig: Rig
    tests: tuple[PlannedTest, ...]
    title: str = ""
    description: str = ""
    surface: str = ""
    thickness: float | None = None
    shear_modulus: float | None = None
    elastic_modulus: float | None = None
    compression_modulus: float | None = None
    roughness: float | None = None
    remove_shear: bool | None = None
    cover_thickness: float | None = None
    cover_shear_modulus: float | None = None
    options: PressureOptions = field(default_factory=PressureOptions)
    held: Held = FREE
    provenance: Provenance = field(default_factory=lambda: Provenance(Kind.MEASURED))
    head: ReportHead = field(default_factory=ReportHead)
    uncertainty: Uncertainty | None = None
    digitised: Digitised | None = None
    file: str = ""
    folder: str = ""

    @property
    def used_tests(self) -> tuple[PlannedTest, ...]:
        """The tests that count."""
        return tuple(test for test in self.tests if test.use)

    @property
    def unused_tests(self) -> tuple[PlannedTest, ...]:
        """The tests that the plan itself leaves out."""
        return tuple(test for test in self.tests if not test.use)

    def set_force(self, test: PlannedTest) -> float | None:
        """Normal force that was set in a test [N]; None where it was only measured."""
        if test.normal_force is None and test.pressure is not None:
            return test.pressure * self.rig.area
        return test.normal_force

    @property
    def shear_modulus_used(self) -> float | None:
        """G, or E/3 of an incompressible rubber [Pa]."""
        if self.shear_modulus is None and self.elastic_modulus is not None:
            return self.elastic_modulus / 3.0
        return self.shear_modulus

    @property
    def shear_compliance(self) -> float:
        """h/G of the sample, 0 if it is not known [m/Pa]."""
        if self.thickness is None or self.shear_modulus_used is None:
            return 0.0
        return self.thickness / self.shear_modulus_used

    @property
    def removes_shear(self) -> bool:
        """Whether the sample's own shear is taken off."""
        return self.shear_compliance > 0.0 and self.remove_shear is not False

    @property
    def sample_compliance(self) -> float:
        """h/G of the sample as far as its shear is taken off [m/Pa]."""
        return self.shear_compliance if self.removes_shear else 0.0

    @property
    def cover_compliance(self) -> float:
        """h/G of the test belt's cover, 0 if there is none or it is not known [m/Pa]."""
        return (self.cover_thickness or 0.0) / (self.cover_shear_modulus or math.inf)

    @property
    def slip_includes(self) -> tuple[str, ...] | None:
        """What the slip of the law holds besides the sliding; None where a figure tells not."""
        if self.digitised is not None and self.cover_thickness is None:
            return None
        in_slip = (not self.removes_shear, self.cover_thickness is None)
        return tuple(part for part, there in zip(SLIP_INCLUDES, in_slip, strict=True) if there)

    @property
    def saturation_pressure(self) -> float | None:
        """E * roughness / thickness [Pa]; None if one of them is not given."""
        if self.elastic_modulus is None or self.roughness is None or self.thickness is None:
            return None
        return self.elastic_modulus * self.roughness / self.thickness
