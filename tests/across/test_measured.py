"""Measured profiles: text and Excel, inches, from an edge, thicknesses and diameters."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import xlsxwriter

from cli.running import wraparc
from wraparc import InputError
from wraparc.across import read_profile, within
from wraparc.files import drive_from_text

PLAIN = """
format = 1
[belt]
preset = "Plylon Plus 1000/4"
width = "48 in"
[[pulley]]
name = "head"
diameter = "800 mm"
wrap_angle = "180 deg"
lagging = "diamond-rubber"
entry_tension = "150 kN"
exit_tension = "60 kN"
"""
Y = np.linspace(-22.0, 22.0, 12)  # inches


def _worn(y: np.ndarray) -> np.ndarray:
    """A parabola, 0.1 in deep in the middle [in]."""
    return np.asarray(0.1 * (1.0 - (y / 22.0) ** 2))


def _write(path: Path, head: str, columns: tuple[np.ndarray, ...], sign: str = ";") -> Path:
    rows = [sign.join(f"{v:.4f}" for v in row) for row in zip(*columns, strict=True)]
    path.write_text("\n".join([head, *rows]) + "\n", "utf-8")
    return path


def test_a_gauge_in_inches_is_smoothed_with_its_uncertainty(tmp_path: Path) -> None:
    """Source: the parabola that the readings scatter about."""
    rng = np.random.default_rng(3)
    noise = 0.004 * rng.standard_normal(len(Y))
    left = 0.472 - _worn(Y) + noise
    file = _write(tmp_path / "gauge.csv", "Position [in];Thickness [in]", (Y, left))
    found = read_profile(file, new=0.472 * 0.0254 + 0.3e-3)
    assert found.key == "worn_depth"
    assert found.order == 2
    assert found.scatter == pytest.approx(0.0254 * float(np.std(noise)), rel=0.4)
    assert found.profile.uncertainty == pytest.approx(found.scatter * np.sqrt(3 / 12), abs=1e-7)
    y = np.array(found.profile.position)
    expected = 0.0254 * _worn(y / 0.0254) + 0.3e-3
    assert np.array(found.profile.value) == pytest.approx(expected, abs=0.15e-3)


def test_diameters_from_one_edge(tmp_path: Path) -> None:
    """Positions that are never negative count from the edge; diameters become radii."""
    x = np.linspace(0.0, 1200.0, 9)
    diameter = 800.0 + 2.0 * np.cos(np.pi * x / 1200.0)
    file = _write(tmp_path / "tape.txt", "width (mm)\tdiameter (mm)", (x, diameter), "\t")
    found = read_profile(file)
    assert found.key == "shell_profile"
    assert found.profile.position[0] == pytest.approx(-0.6)
    assert found.profile.value[0] == pytest.approx(1e-3, abs=0.02e-3)
    assert found.profile.value[-1] == pytest.approx(-1e-3, abs=0.02e-3)
    narrow = within(found, 1.0)
    assert narrow.position[0] == pytest.approx(-0.5)


def test_an_excel_workbook(tmp_path: Path) -> None:
    path = tmp_path / "wear.xlsx"
    with xlsxwriter.Workbook(str(path)) as book:
        sheet = book.add_worksheet()
        for i, row in enumerate([("position [mm]", "worn depth [mm]"), (-500, 0.5), (0, 2.0),
                                 (500, 0.4)]):  # fmt: skip
            sheet.write_row(i, 0, row)
    found = read_profile(path)
    assert found.order == 0  # too few to be smoothed
    assert found.profile.value == pytest.approx((0.5e-3, 2e-3, 0.4e-3))


@pytest.mark.parametrize(
    ("head", "y", "says"),
    [
        ("place;colour [mm]", Y, "no column of position, or none of depth, thickness, diameter"),
        ("position;depth", Y, "has no unit"),
        ("position [in];depth [in]", np.zeros(12), "or one measured twice"),
    ],
)
def test_what_cannot_be_told_is_asked_for(
    tmp_path: Path, head: str, y: np.ndarray, says: str
) -> None:
    file = _write(tmp_path / "gauge.csv", head, (y, np.abs(Y)))
    with pytest.raises(InputError) as error:
        read_profile(file)
    assert says in str(error.value)


def test_a_new_lagging_thinner_than_a_reading(tmp_path: Path) -> None:
    file = _write(tmp_path / "g.csv", "position [mm];thickness [mm]", (Y, 12.0 - _worn(Y)))
    with pytest.raises(InputError, match="must be at least the reading"):
        read_profile(file, new=10e-3)


def test_the_command_prints_rows_for_a_drive_file(tmp_path: Path) -> None:
    file = _write(tmp_path / "g.csv", "position;depth", (Y, _worn(Y)))
    ran = wraparc("profile", file, "--unit", "in", "--width", "40 in")
    assert ran.code == 0, ran.err
    assert "smoothed by a polynomial of order" in ran.out
    drive = drive_from_text(f"{PLAIN}\n{ran.out}")
    across = drive.pulleys[0].across
    assert across is not None
    assert across.worn_depth is not None
    assert across.worn_depth.value[12] == pytest.approx(0.1 * 0.0254, rel=0.02)
