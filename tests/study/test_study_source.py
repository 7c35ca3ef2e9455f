"""Fields of a drive file by column, beside the drive that the file makes of them one by one."""

import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from study.studies import EXAMPLES, FOLDER, SAMPLING, study_of
from wraparc.arc import Distributed, WrapArc
from wraparc.arrays import Array
from wraparc.batch import Setting
from wraparc.drive import Fit, Lagging, with_peaks
from wraparc.files import drive_from_document, load_lagging, save_lagging
from wraparc.friction import IntegralLog, PressureKnots
from wraparc.schema.source import parse, read_text
from wraparc.study.parameter_study import Study
from wraparc.study.source import DriveSource

RICH = """
format = 1
[belt]
width = "1200 mm"
modulus = "12960 kN/m"
speed = "3 m/s"
pulley_cover = "4 mm"
carry_cover = "8 mm"
carcass = "6 mm"
mass = "25 kg/m"
[lagging.worn]
preset = "diamond-rubber"
shear_modulus = "2 MPa"
[lagging.plain]
thickness = "10 mm"
shear_modulus = "2 MPa"
compression_modulus = "9 MPa"
law = { kind = "constant", friction = 0.5, slip_includes = [] }
[lagging.stiff]
preset = "full-ceramic"
compression_modulus = "30 MPa"
[[pulley]]
name = "first"
diameter = "800 mm"
wrap_angle = "180 deg"
lagging = "worn"
overrun = "0.02 mm"
entry_tension = "180 kN"
power = "150 kW"
[[pulley]]
name = "second"
diameter = "900 mm"
wrap_angle = "200 deg"
lagging = "plain"
torque = "20 kN m"
[[load_case]]
name = "start"
pulley.first.power = "200 kW"
[[load_case]]
name = "braked"
pulley.second = { entry_tension = "60 kN", exit_tension = "80 kN" }
"""


def quantity(low: float, high: float, unit: str, field: str) -> dict[str, Any]:
    ends = {"from": f"{low} {unit}", "to": f"{high} {unit}"}
    return {"field": field, "distribution": "uniform", **ends}


DIAMETER, WIDTH = "pulley.first.diameter", "belt.width"
AXES = [
    [quantity(700, 900, "mm", DIAMETER), quantity(120, 180, "kW", "pulley.first.power")],
    [quantity(2, 4, "m/s", "belt.speed"), quantity(160, 220, "kN", "pulley[1].entry_tension")],
    [quantity(150, 210, "kW", "load_case.start.pulley.first.power")],
    [quantity(1, 2, "m", WIDTH), quantity(8000, 30000, "kN/m", "belt.modulus")],
    [quantity(0, 0.1, "mm", "pulley.first.overrun"), quantity(3, 9, "mm", "creep_limit")],
    [quantity(3, 9, "mm", "pulley.first.creep_limit"), quantity(170, 200, "deg", "pulley[1].wrap")],
    [quantity(8, 20, "mm", "pulley.first.lagging.thickness")],
    [quantity(8, 20, "mm", "lagging.worn.thickness")],
    [quantity(1, 3, "MPa", "lagging.worn.shear_modulus")],
    [quantity(5, 30, "MPa", "pulley.first.lagging.compression_modulus")],
    [
        quantity(1, 3, "MPa", "pulley.first.lagging.shear_modulus"),
        quantity(5, 30, "MPa", "pulley.first.lagging.compression_modulus"),
    ],
    [  # a modulus of compression in the place of that of the blocks, which shear on
        {"field": "pulley.first.lagging", "values": ["worn", "stiff", "plain"]},
        quantity(1, 3, "MPa", "pulley.first.lagging.shear_modulus"),
    ],
    [quantity(10, 60, "kg/m", "belt.mass"), quantity(2, 6, "m/s", "belt.speed")],
    [
        {"field": "pulley.first.lagging", "values": ["worn", "full-ceramic", "medium-ceramic"]},
        {"field": "pulley.first.recovery", "values": [True, False]},
        quantity(1, 2, "m", WIDTH),
    ],
]
SECOND = [
    [
        quantity(15, 25, "kN m", "pulley.second.torque"),
        quantity(800, 1000, "mm", "pulley.second.diameter"),
    ],
    [quantity(140, 160, "kW", "pulley.first.power"), quantity(2, 4, "m/s", "belt.speed")],
    [{"field": "lagging.plain.law.friction", "distribution": "uniform", "from": 0.4, "to": 0.7}],
    [
        quantity(2, 6, "mm", "belt.pulley_cover"),
        quantity(4, 9, "mm", "belt.carcass"),
        quantity(0.8, 1.5, "MPa", "belt.cover_shear_modulus"),
        {"field": "pulley.second.side", "values": ["pulley", "carry"]},
    ],
    [quantity(50, 70, "kN", "load_case.braked.pulley.second.entry_tension")],
]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    made = tmp_path_factory.mktemp("drives")
    (made / "rich.toml").write_text(RICH, "utf-8")
    return made


def in_file(study: Study, values: dict[str, Array], row: int) -> dict[str, Any]:
    """Values of a design as a drive file has them."""
    given: dict[str, Any] = {}
    units = {
        "length": "m",
        "force": "N",
        "force_per_width": "N/m",
        "pressure": "Pa",
        "angle": "rad",
    }
    units |= {"mass_per_length": "kg/m", "speed": "m/s", "power": "W", "torque": "N m"}
    words = {axis.field: axis.values for axis in study.plan.levels if not axis.numeric}
    for name, column in values.items():
        dimension = study.source.unit_of(name)
        if name in words:
            given[name] = words[name][int(column[row])]
        elif dimension == "number":
            given[name] = float(column[row])
        else:
            given[name] = f"{float(column[row])!r} {units[str(dimension)]}"
    return given


@pytest.mark.parametrize(
    ("pulley", "axes"),
    [("first", axes) for axes in AXES] + [("second", axes) for axes in SECOND],
    ids=lambda x: "+".join(a["field"] for a in x) if isinstance(x, list) else x,
)
def test_columns_are_what_the_drive_file_makes(
    folder: Path, pulley: str, axes: list[dict[str, Any]]
) -> None:
    """Independent: the drive built from the file with the values put over it, and its `WrapArc`."""
    document = parse(read_text(folder / "rich.toml"), "")
    cases = {"first": ["design", "start"], "second": ["design", "braked"]}[pulley]
    single = [a for a in axes if a["field"].startswith("load_case.")]
    cases = [single[0]["field"].split(".")[1]] if single else cases
    drawn = any("distribution" in axis for axis in axes)
    more: dict[str, Any] = {"sampling": {"samples": 5, "seed": 1}} if drawn else {}
    asked = study_of(
        *axes, **more, drive=str(folder / "rich.toml"), pulley=pulley, load_cases=cases
    )
    study = asked.study
    values = study.plan.values(0, len(study.plan))
    for load in cases:
        rows = study.source.rows(values, len(study.plan), load)
        assert rows.valid.all()
        for i in range(len(study.plan)):
            over = in_file(study, values, i)
            drive = drive_from_document(document, overrides=over)
            case = next(c for c in drive.load_cases if c.name == load)
            arc = WrapArc.of(drive, drive.pulley(pulley), case)
            told = {
                "entry_tension": arc.entry_tension,
                "exit_tension": arc.exit_tension,
                "diameter": arc.diameter,
                "wrap_angle": arc.wrap_angle,
                "belt_width": arc.width,
                "axial_stiffness": arc.axial_stiffness,
                "lagging_thickness": arc.thickness,
                "shear_modulus": arc.shear_modulus,
                "compression_modulus": arc.compression_modulus,
                "overrun": math.nan if arc.overrun is None else arc.overrun,
                "recovery": float(arc.recovery),
                "creep_limit": arc.creep_limit,
                "belt_speed": arc.belt_speed,
            }
            for name, value in told.items():
                found = float(getattr(rows.arcs, name)[i])
                assert found == pytest.approx(value, rel=1e-12, nan_ok=True), (name, over)
            law = rows.arcs.laws.compact(int(rows.arcs.law[i]))
            compact = arc.law.compact()
            np.testing.assert_array_equal(law[2], compact.coefficients)


def test_a_shear_modulus_beside_another_compression_modulus(tmp_path: Path) -> None:
    """Source: G of the rubber times 0.8, the part of the area that blocks of the preset cover."""
    stiff = '{ preset = "full-ceramic", compression_modulus = "30 MPa" }'
    path = tmp_path / "stiff.toml"
    path.write_text(RICH.replace('lagging = "worn"', f"lagging = {stiff}"), "utf-8")
    axis = quantity(1, 3, "MPa", "pulley.first.lagging.shear_modulus")
    study = study_of(
        axis, drive=str(path), pulley="first", sampling={"samples": 4, "seed": 1}
    ).study
    assert isinstance(study.source, DriveSource)
    assert not study.source.slow  # a column that differs from the file is none
    values = study.plan.values(0, 4)
    rows = study.source.rows(values, 4, "design")
    (given,) = values.values()
    assert rows.arcs.shear_modulus == pytest.approx(0.8 * given, rel=1e-12)
    for i in range(4):
        over = in_file(study, values, i)
        drive = drive_from_document(parse(path.read_text("utf-8"), ""), overrides=over)
        told = drive.pulley("first").lagging.shear_modulus
        assert rows.arcs.shear_modulus[i] == pytest.approx(told, rel=1e-12)


def test_factors_scale_the_law_as_a_law_of_its_own_would() -> None:
    """Independent: `solve` of one arc under a law that really is scaled."""
    axes = [
        {"field": f"pulley.head.lagging.{key}", "distribution": "uniform", "from": 0.6, "to": 1.2}
        for key in ("friction_factor", "slip_factor")
    ]
    wet = {"name": "wet", "friction_factor": 0.9}
    study = study_of(
        *axes, sampling={"samples": 4, "seed": 1}, setting="precise", condition=[wet]
    ).study
    found = study.solve(0, 4)
    values = study.plan.values(0, 4)
    drive = drive_from_document(parse(read_text(Path(FOLDER) / "head-drive.toml"), ""))
    base = WrapArc.of(drive, drive.pulleys[0], drive.load_case())
    for i in range(4):
        f, s = (float(column[i]) for column in values.values())
        arc = replace(base, law=base.law.scaled(0.9 * f, s))
        told = Distributed().solve(arc).scalars()
        for name in study.outputs:
            # one arc takes the tension as straight between 180 points for its active arc
            within = 5e-4 if name == "active_arc" else 1e-6
            assert found[name][i] == pytest.approx(told[name], rel=within, nan_ok=True), name
        assert found["friction_factor"][i] == pytest.approx(0.9 * f)


def fitted(folder: Path) -> tuple[Path, Lagging]:
    """A lagging file with statistics of a fit, made up: 6 % and 4 %, correlated."""
    base = load_lagging("diamond-rubber")
    assert isinstance(base.law, IntegralLog)
    knots = base.law.coefficients
    assert isinstance(knots, PressureKnots)
    n = len(knots.pressure)
    names = tuple(f"knots[{k + 1}].{q}" for q in ("peak_slip", "peak_friction") for k in range(n))
    values = (*knots.peak_slip, *knots.peak_friction)
    spread = np.array([0.06] * n + [0.04] * n)
    nearness = np.exp(-0.3 * np.abs(np.subtract.outer(np.arange(n), np.arange(n))))
    correlation = np.block([[nearness, 0.5 * nearness], [0.5 * nearness, nearness]])
    logs = correlation * np.outer(spread, spread)
    matrix = logs * np.outer(values, values)
    fit = Fit(parameters=names, values=values, covariance=tuple(map(tuple, matrix.tolist())))
    lagging = replace(base, name="mine", fit=fit)
    save_lagging([lagging], folder / "mine.toml")
    return folder / "mine.toml", lagging


def test_laws_are_drawn_with_the_covariance_of_the_fit(tmp_path: Path) -> None:
    """The logarithms of 4,000 draws have the covariance of the file; the arcs have their laws."""
    path, lagging = fitted(tmp_path)
    axis = {"field": "pulley.head.lagging", "distribution": "fit"}
    study = study_of(
        axis, sampling={"samples": 4000, "seed": 3}, set=[f"pulley.head.lagging={path}"]
    ).study
    values = study.plan.values(0, 4000)
    assert lagging.fit is not None
    logs = np.log(np.stack(list(values.values()), axis=1) / np.array(lagging.fit.values))
    of_file = np.array(lagging.fit.covariance) / np.outer(lagging.fit.values, lagging.fit.values)
    n = len(of_file)
    error = np.sqrt((np.outer(np.diag(of_file), np.diag(of_file)) + of_file**2) / 4000)
    assert np.all(np.abs(np.cov(logs.T) - of_file) < 4.5 * error)
    assert np.all(np.abs(logs.mean(0)) < 4.5 * np.sqrt(np.diag(of_file) / 4000))
    few = {name: column[:3] for name, column in values.items()}
    rows = study.source.rows(few, 3, "design")
    for i in range(3):
        drawn = [few[f"pulley.head.lagging.{p}"][i] for p in lagging.fit.parameters]
        peaks = dict(zip(lagging.fit.knots, drawn, strict=True))
        told = with_peaks(lagging.law, peaks).compact()
        np.testing.assert_array_equal(rows.arcs.laws.compact(i)[2], told.coefficients)
    assert n == 20
    whole, part = study.plan.values(0, 50), study.plan.values(17, 18)
    assert all(part[name][0] == column[17] for name, column in whole.items())


def test_the_precise_setting_is_that_of_solve() -> None:
    study = study_of(
        {"field": "pulley.head.exit_tension", "values": ["45 kN", "60 kN"]},
        setting="precise",
        outputs=["exit_creep", "peak_shear_stress", "power_loss", "equivalent_friction"],
    ).study
    assert study.setting is Setting.PRECISE
    found = study.solve(0, 2)
    document = parse(read_text(EXAMPLES / "studies" / "head-drive.toml"), "")
    for i, tension in enumerate(("45 kN", "60 kN")):
        over = {"pulley.head.exit_tension": tension}
        drive = drive_from_document(document, overrides=over)
        arc = WrapArc.of(drive, drive.pulleys[0], drive.load_cases[0])
        told = Distributed().solve(arc).scalars()
        for name in study.outputs:
            assert found[name][i] == pytest.approx(told[name], rel=1e-6), name


def test_a_design_that_is_no_drive_has_a_status(tmp_path: Path) -> None:
    """A pull larger than the entry tension leaves nothing at the exit."""
    pull = quantity(40, 115, "kN", "pulley.head.effective_tension")
    entry = quantity(80, 150, "kN", "pulley.head.entry_tension")
    study = study_of(pull, entry, sampling=SAMPLING, drive=_with_entry(tmp_path)).study
    found = study.solve(0, 100)
    left = found["pulley.head.entry_tension"] - found["pulley.head.effective_tension"]
    assert 5 < np.sum(left <= 0.0) < 50
    assert np.array_equal(found["status"] == 4, left <= 0.0)
    assert np.all(np.isnan(found["exit_creep"][left <= 0.0]))
    assert not found["within_creep_limit"][left <= 0.0].any()


def _with_entry(folder: Path) -> str:
    text = read_text(EXAMPLES / "studies" / "head-drive.toml")
    changed = text.replace('exit_tension = "60 kN"', 'entry_tension = "120 kN"')
    changed = changed.partition("[[load_case]]")[0]
    (folder / "entry.toml").write_text(changed, "utf-8")
    return str(folder / "entry.toml")
