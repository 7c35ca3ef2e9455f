"""Curves read off a figure. Expected values: the known law behind the points."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from wraparc.answer.shear_test_budget import budget_table
from wraparc.answer.shear_test_tables import plan_sheet, verdict
from wraparc.answer.sheet import shown
from wraparc.errors import InputError
from wraparc.files import load_lagging
from wraparc.files.write import lagging_text
from wraparc.friction import ab_from_peak
from wraparc.provenance import Kind
from wraparc.shear_test import fit_plan
from wraparc.shear_test.digitised import read_points
from wraparc.shear_test.plan_file import load_plan

PRESSURES = np.array([34.0, 69.0, 138.0, 276.0, 414.0, 690.0])  # kPa
SLIP = 9.0 * (PRESSURES / 34.0) ** 0.15  # mm
FRICTION = 1.25 * (PRESSURES / 34.0) ** -0.3


def curve(k: int, points: int = 30, end: float = 12.0) -> list[list[float]]:
    """Points of a curve in whole pixels: 800 for 12 mm and 500 for 1.4."""
    x = np.linspace(0.1, end, points)
    r = np.minimum(x / SLIP[k], 1.0)
    y = FRICTION[k] * r * (1.0 - np.log(r))
    drawn: list[list[float]] = np.stack(
        [np.round(x / 12 * 800) / 800 * 12, np.round(y / 1.4 * 500) / 500 * 1.4]
    ).T.tolist()
    return drawn


def names(unit: str = "kPa") -> list[str]:
    return [f"{p:g} {unit}" for p in PRESSURES]


def project() -> str:
    """As the project of a digitiser: values beside places in the image."""
    sets = [
        {"name": name, "axesName": "XY", "metadataKeys": [],
         "data": [{"x": 7.0, "y": 9.0, "dataPointIndex": 1, "value": v} for v in curve(k)]}
        for k, name in enumerate(names())
    ]  # fmt: skip
    return json.dumps({"version": [4, 2], "axesColl": [{"name": "XY"}], "datasetColl": sets})


def series() -> str:
    """Another kind: lists of pairs."""
    return json.dumps(
        {"wpd": {"dataSeries": [{"name": n, "data": curve(k)} for k, n in enumerate(names())]}}
    )


def in_pairs() -> str:
    """Two columns a curve under its name."""
    rows = [",".join(f"{n}," for n in names()), ",".join(["X", "Y"] * 6)]
    sets = zip(*(curve(k, 30 + k) for k in range(6)), strict=False)
    rows += [",".join(f"{x:.5f},{y:.5f}" for x, y in points) for points in sets]
    return "\n".join(rows)


def one_x() -> str:
    """One x, a column a curve."""
    rows = ["x," + ",".join(names())]
    for points in zip(*(curve(k) for k in range(6)), strict=True):
        rows += [f"{points[0][0]:.5f}," + ",".join(f"{y:.5f}" for _, y in points)]
    return "\n".join(rows)


HEAD = """format = 1
[lagging]
name = "figured"
surface = "rubber"
[digitised]
source = "A. Author, A paper, 2020"
figure = "Figures 3 to 5"
"""


def fitted(folder: Path, text: str, file: str = "figure.json", head: str = HEAD) -> Any:
    (folder / file).write_text(text)
    (folder / "plan.toml").write_text(f'{head}[[test]]\nfile = "{file}"\n')
    return fit_plan(load_plan(folder / "plan.toml"))


NAMES = names()[:3]
#: Points of three curves of different length, as text.
TEXTS = [[[f"{x:.5f}", f"{y:.5f}"] for x, y in curve(k, 14 + 3 * k)] for k in range(3)]


def beside(first: str, second: str, between: str = "", sep: str = ",") -> str:
    """Pairs of columns under two lines of names, perhaps with an empty column between."""
    rows = [[t[k] if k < len(t) else ["", ""] for t in TEXTS] for k in range(20)]
    cells = [first, *([second] if second else [])]
    return "\n".join([*cells, *((sep + between).join(sep.join(p) for p in row) for row in rows)])


def under(*head: str, sep: str = ",", end: str = "\n") -> str:
    """A table for each curve, one under the other."""
    parts = []
    for name, text in zip(NAMES, TEXTS, strict=True):
        parts += [line.format(name) for line in head] + [sep.join(p) for p in text]
        parts += [end.strip("\n")] if end else []
    return "\n".join(parts)


def long(head: str, place: int, own: list[str]) -> str:
    """A row for each point with the name of its curve."""
    rows = [
        ",".join([*p[:place], name, *p[place:]])
        for name, t in zip(own, TEXTS, strict=True)
        for p in t
    ]
    return "\n".join([head, *rows])


FIRST, LETTERED = "34 kPa,,69 kPa,,138 kPa,", ",".join(f"{n} x,{n} y" for n in NAMES)
FORMATS = {
    "pairs": (beside(FIRST, "X,Y,X,Y,X,Y"), NAMES),
    "pairs without letters": (beside(FIRST, ""), NAMES),
    "pairs, letters in the names": (beside(LETTERED, ""), NAMES),
    "pairs by number": (beside("x1,y1,x2,y2,x3,y3", ""), ["1", "2", "3"]),
    "pairs with a column between": (
        beside("34 kPa,,,69 kPa,,,138 kPa,", "x,y,,x,y,,x,y", ","), NAMES
    ),
    "under each other": (under("x,{}"), NAMES),
    "under each other, tab": (under("x\t{}", sep="\t"), NAMES),
    "under titles": (under("{}", "x,y"), NAMES),
    "under titles, no line between": (under("{}", "x,y", end=""), NAMES),
    "comma decimals": (under("x;{}", sep=";").replace(".", ","), NAMES),
    "a name a row": (long("Dataset,x,y", 0, NAMES), NAMES),
    "a name a row, at the end": (long("x,y,Series", 2, NAMES), NAMES),
    "a number a row": (long("Curve,x,y", 0, ["1", "2", "3"]), ["1", "2", "3"]),
    "mask beside the points": (
        json.dumps([
            {"name": n, "data": [{"x": 1.0, "y": 2.0, "value": v} for v in t],
             "autoDetectionData": {"mask": [[1, 2], [5, 6]]}}
            for n, t in zip(NAMES, TEXTS, strict=True)
        ]),
        NAMES,
    ),
    "lists of x and y": (
        json.dumps([{"name": n, "x": [p[0] for p in t], "y": [p[1] for p in t]}
                    for n, t in zip(NAMES, TEXTS, strict=True)]),
        NAMES,
    ),
}  # fmt: skip


@pytest.mark.parametrize("shape", FORMATS)
def test_files_of_digitisers(shape: str) -> None:
    """Of tables under each other the longest alone was read; of others x was taken for friction."""
    text, called = FORMATS[shape]
    found = read_points(text.encode(), "x")
    assert [c.name for c in found] == called
    for one, points in zip(found, TEXTS, strict=True):
        np.testing.assert_allclose(np.stack([one.x, one.y]).T, np.array(points, dtype=float))


def test_x_is_found_by_its_name() -> None:
    """Friction may stand first, and a column may count the points."""
    rows = [f"{k},{y},{x}" for k, (x, y) in enumerate(TEXTS[0], start=1)]
    (found,) = read_points("\n".join(["No,Friction,Slip [mm]", *rows]).encode(), "x")
    np.testing.assert_allclose(np.stack([found.x, found.y]).T, np.array(TEXTS[0], dtype=float))


@pytest.mark.parametrize("text", [project, series, in_pairs, one_x])
def test_friction_comes_back_within_two_percent(tmp_path: Path, text: Any) -> None:
    result = fitted(tmp_path, text())
    law = result.laggings[0].law
    for k, p in enumerate(PRESSURES):
        r = np.array([0.2, 0.5, 0.9])
        slip = r * min(SLIP[k], 12.0) * 1e-3
        true = FRICTION[k] * (ratio := slip * 1e3 / SLIP[k]) * (1.0 - np.log(ratio))
        found = [float(law.friction(x, p * 1e3)) for x in slip]
        np.testing.assert_allclose(found, true, rtol=0.02)
    assert shown(verdict(result), "si").level.name == "OK"


def test_the_figure_is_the_source_wherever_the_law_shows(tmp_path: Path) -> None:
    result = fitted(tmp_path, project())
    said = "digitised from A. Author, A paper, 2020, Figures 3 to 5"
    assert result.laggings[0].provenance.source == said
    assert result.laggings[0].provenance.kind is Kind.PUBLISHED
    (tmp_path / "figured.toml").write_text(lagging_text(result.laggings))
    assert load_lagging(tmp_path / "figured.toml").provenance.source == said
    sheet = shown(plan_sheet(result), "si")
    assert any(said in source for source in sheet.sources)
    rows = {row.title: row.values for table in sheet.tables for row in table.rows}
    assert rows["Curves"] == (said,)
    assert rows["Error of a point"] == ("read off to 1 % of full scale",)


@pytest.mark.parametrize(("said", "share"), [("", 0.01), ('error = "3 %"\n', 0.03)])
def test_the_error_of_a_point_is_in_the_budget(tmp_path: Path, said: str, share: float) -> None:
    """A share of the largest friction, over the peak, over the root of 3."""
    result = fitted(tmp_path, project(), head=HEAD + said)
    condition = result.conditions[0]
    budget = condition.fit.budget(condition.found.points)
    largest = max(y for k in range(6) for _, y in curve(k))
    peaks = np.exp(condition.fit.peaks(PRESSURES * 1e3))[:, 1]
    np.testing.assert_allclose(
        budget.parts["friction off the figure"][:, 1], share * largest / peaks / np.sqrt(3.0)
    )
    table = shown(budget_table(condition, ""), "si")
    assert table is not None
    assert "friction off the figure" in {row.title for row in table.rows}


AB = HEAD + 'quantity = "coefficients"\nslip_unit = "mm"\npressure_unit = "kPa"\n'


def coefficients() -> str:
    ab = [ab_from_peak(m, x) for m, x in zip(FRICTION, SLIP, strict=True)]
    return "p,A,b\n" + "\n".join(
        f"{p},{a:.5f},{b:.5f}" for p, (a, b) in zip(PRESSURES, ab, strict=True)
    )


def test_a_and_b_over_pressure_give_their_peaks(tmp_path: Path) -> None:
    result = fitted(tmp_path, coefficients(), "ab.csv", AB)
    condition = result.conditions[0]
    slip, friction, _ = condition.peaks_at(PRESSURES * 1e3)
    np.testing.assert_allclose(friction, FRICTION, rtol=0.02)
    np.testing.assert_allclose(slip, 1e-3 * SLIP, rtol=0.02)
    budget = condition.fit.budget(condition.found.points)
    assert budget.parts["A off the figure"].all()
    # b alone: d ln mu_pk = d ln x_pk = db/A, by x_pk = exp(b/A - 1), mu_pk = -A x_pk
    a, _ = np.array([ab_from_peak(m, x) for m, x in zip(friction, slip * 1e3, strict=True)]).T
    told = budget.parts["b off the figure"]
    largest = max(abs(ab_from_peak(m, x)[1]) for m, x in zip(FRICTION, SLIP, strict=True))
    np.testing.assert_allclose(told[:, 0], 0.01 * largest / np.abs(a) / np.sqrt(3.0), rtol=1e-4)
    np.testing.assert_allclose(told[:, 0], told[:, 1])


def test_another_unit_of_x_is_taken(tmp_path: Path) -> None:
    inches = json.dumps([
        {"name": n, "data": [[x / 25.4, y] for x, y in curve(k)]} for k, n in enumerate(names())
    ])  # fmt: skip
    result = fitted(tmp_path, inches, head=HEAD + 'slip_unit = "in"\n')
    slip = result.conditions[0].peaks_at(np.array([138e3]))[0]
    assert slip[0] == pytest.approx(1e-3 * SLIP[2], rel=0.03)


def named(curves: list[Any], own: list[str] | None = None) -> str:
    return json.dumps([{"name": n, "data": c} for n, c in zip(own or names(), curves, strict=True)])


CURVES = [curve(k) for k in range(6)]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        # twice the error of a point, 1 % of 12 mm, is 0.24
        (named([[[-0.3, 0.0], *curve(0)], *CURVES[1:]]), "f.json: 34 kPa: its slip goes down to"),
        (named([[[0.1, -0.1], *curve(0)], *CURVES[1:]]), "its friction goes down to -0.1"),
        (named([[[x / 25.4, y] for x, y in c] for c in CURVES]), "the slip would end at 0.472 mm"),
        (named(CURVES, ["34 kPa", *names()[:-1]]), "two curves of the file have this name"),
        (named([CURVES[0], *CURVES[:-1]]), 'has the same points as "f.json: 34 kPa"'),
        (named(CURVES, [*names()[:-1], "1,034 kPa"]), "1,034 kPa: the pressure of this curve is"),
        (named(CURVES, [*names()[:-1], "414 to 690 kPa"]), "414 to 690 kPa: the pressure of"),
        (named(CURVES, [*names()[:-1], "414-690 kPa"]), "414-690 kPa: the pressure of"),
        (named(CURVES, [*names()[:-1], "690 kPa wet"]), 'is named "wet", its test "dry"'),
        (named(CURVES, ["0 kPa", *names()[1:]]), "its pressure is 0 kPa"),
        (named(CURVES, [f"{p:g} N/mm2" for p in PRESSURES]), "6 problems"),
    ],
)
def test_curves_that_cannot_be_are_refused(tmp_path: Path, text: str, said: str) -> None:
    with pytest.raises(InputError, match=said):
        fitted(tmp_path, text, "f.json")


@pytest.mark.parametrize("text", [
    named([[[-0.02, -0.001], *c] for c in CURVES]),  # within the error of a click
    named(CURVES, [f"{p / 100:.2f}".replace(".", ",") + " bar" for p in PRESSURES]),
    named(CURVES, [f"{p / 6.894757:.4f} psig" for p in PRESSURES]),
])  # fmt: skip
def test_curves_that_can_be_are_taken(tmp_path: Path, text: str) -> None:
    peaks = fitted(tmp_path, text).conditions[0].peaks_at(PRESSURES * 1e3)
    np.testing.assert_allclose(peaks[1], FRICTION, rtol=0.02)


def test_a_unit_of_slip_that_is_said_is_not_asked_for(tmp_path: Path) -> None:
    text = named([[[x / 25.4, y] for x, y in c] for c in CURVES])
    assert fitted(tmp_path, text, head=HEAD + 'slip_unit = "mm"\n').conditions


def test_one_pressure_is_not_that_of_all_curves_of_a_file(tmp_path: Path) -> None:
    (tmp_path / "f.json").write_text(project())
    tests = '[[test]]\nfile = "f.json"\npressure = "34 kPa"\n'
    (tmp_path / "plan.toml").write_text(HEAD + tests)
    with pytest.raises(InputError, match="one pressure for 6 curves"):
        fit_plan(load_plan(tmp_path / "plan.toml"))


def test_two_curves_of_a_are_told(tmp_path: Path) -> None:
    text = json.dumps([{"name": n, "data": [[1, -1], [2, -1]]} for n in "AAb"])
    with pytest.raises(InputError, match="two curves are named A"):
        fitted(tmp_path, text, head=AB)


def test_a_and_b_without_their_units_are_asked_for(tmp_path: Path) -> None:
    with pytest.raises(InputError) as told:
        fitted(tmp_path, coefficients(), "ab.csv", HEAD + 'quantity = "coefficients"\n')
    assert {p.key for p in told.value.problems} == {
        "digitised.slip_unit",
        "digitised.pressure_unit",
    }


@pytest.mark.parametrize(
    ("a", "b", "said"),
    [
        (PRESSURES, PRESSURES[2:4], "A is read at 34, b only from 138 to 276"),
        (np.array([0.0, *PRESSURES[1:]]), np.array([0.0, *PRESSURES[1:]]), "its pressure is 0 kPa"),
    ],
)
def test_a_and_b_at_other_pressures_are_told(tmp_path: Path, a: Any, b: Any, said: str) -> None:
    values = [[ab_from_peak(FRICTION[k], SLIP[k])[n] for k in range(6)] for n in (0, 1)]
    sets = [
        {"name": name, "data": [[p, values[n][k]] for k, p in enumerate(at)]}
        for n, (name, at) in enumerate((("A", a), ("b", b)))
    ]
    with pytest.raises(InputError, match=said):
        fitted(tmp_path, json.dumps(sets), head=AB)


def test_a_slip_far_beyond_the_peak_is_cut_there(tmp_path: Path) -> None:
    result = fitted(tmp_path, coefficients(), "ab.csv", AB + 'slip_max = "12 in"\n')
    friction = result.conditions[0].peaks_at(PRESSURES * 1e3)[1]
    np.testing.assert_allclose(friction, FRICTION, rtol=0.02)


def test_whether_the_slip_of_a_figure_includes_shear_is_asked(tmp_path: Path) -> None:
    """With thickness and G of the sample: taken off or left in, the law is another."""
    sample = 'thickness = "12 mm"\nshear_modulus = "2.3 MPa"\n'
    head = HEAD.replace("[digitised]", f"{sample}[digitised]")
    with pytest.raises(InputError, match="Write true if the slip of the figure includes"):
        fitted(tmp_path, project(), head=head)
    peaks = [
        fitted(tmp_path, project(), head=f"{head}[fit]\nremove_shear = {said}\n")
        .conditions[0]
        .peaks_at(PRESSURES[-1:] * 1e3)[0][0]
        for said in ("true", "false")
    ]
    assert peaks[1] == pytest.approx(1e-3 * SLIP[-1], rel=0.02)
    # what the plan says of the modulus whose shear it takes off counts, as for tests
    head = f'{head}[fit]\nremove_shear = true\n[uncertainty]\nshear_modulus = "5 %"\n'
    table = shown(budget_table(fitted(tmp_path, project(), head=head).conditions[0], ""), "si")
    assert table is not None
    notes = {row.title: row.note for row in table.rows}
    assert notes["modulus of the sample"] == "at most 5 %, as stated"
    assert peaks[0] < 0.95 * peaks[1]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("{", "is no valid JSON"),
        ('{"version": 4}', "contains no digitised curve"),
        (json.dumps([{"name": "no pressure", "data": curve(0)}]), "pressure of this curve is not"),
        (json.dumps([{"name": "34 kPa", "data": curve(0, 5)}]), "the curve has 5 points only"),
    ],
)
def test_what_is_no_figure_is_told(tmp_path: Path, text: str, said: str) -> None:
    with pytest.raises(InputError, match=said):
        fitted(tmp_path, text)


def test_a_curve_is_chosen_by_its_name(tmp_path: Path) -> None:
    (tmp_path / "f.json").write_text(project())
    tests = "".join(f'[[test]]\nfile = "f.json"\ncurve = "{n}"\n' for n in names()[:3])
    (tmp_path / "plan.toml").write_text(HEAD + tests)
    assert len(fit_plan(load_plan(tmp_path / "plan.toml")).conditions[0].tests) == 3
    (tmp_path / "plan.toml").write_text(HEAD + '[[test]]\nfile = "f.json"\ncurve = "9 kPa"\n')
    with pytest.raises(InputError, match='no such curve, got "9 kPa"'):
        fit_plan(load_plan(tmp_path / "plan.toml"))


def test_coefficients_without_b_are_told(tmp_path: Path) -> None:
    with pytest.raises(InputError, match='lacks A or b, and has "A"'):
        fitted(tmp_path, "p,A\n1,-1\n2,-1\n3,-1\n", "ab.csv", AB)


def test_places_in_the_image_are_no_values() -> None:
    (first, *_) = read_points(project().encode(), "x")
    assert first.name == "34 kPa"
    np.testing.assert_allclose(np.stack([first.x, first.y]).T, curve(0))
