"""Profiles measured over the face of a pulley: tables of calipers and gauges, smoothed."""

from __future__ import annotations

import os
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from wraparc.arrays import Array
from wraparc.drive import WidthProfile
from wraparc.errors import input_error, shown
from wraparc.machine_tables import (
    NamedColumn,
    find_column,
    find_tables,
    plain_name,
    read_bytes,
)
from wraparc.units import unit_factor

Reading = Literal["depth", "thickness", "diameter", "radius"]
#: What may have been measured: worn depth, thickness left, diameter, radius.
READINGS: tuple[Reading, ...] = ("depth", "thickness", "diameter", "radius")

_WORDS = {
    "position": ("position", "y", "width", "across", "lage", "place", "offset", "distance", "x"),
    "depth": ("depth", "worn", "wear", "verschleiss"),
    "thickness": ("thickness", "gauge", "dicke", "height"),
    "diameter": ("diameter", "durchmesser", "dia", "od"),
    "radius": ("radius", "halbmesser"),
}
_EXPORT = "Give two columns: position and what was measured there."
#: Fewest readings that are smoothed, and the highest polynomial.
_FEWEST, _HIGHEST = 5, 8
#: Rows of a smoothed profile.
_ROWS = 25


@dataclass(frozen=True, kw_only=True)
class MeasuredProfile:
    """A profile that was measured.

    Attributes
    ----------
    profile
        Smoothed: depth worn off, or deviation of the radius [m], with its uncertainty.
    reading
        What was measured.
    position, value
        The readings, as depth or deviation of the radius, shape (n,) [m].
    order
        Order of the polynomial that smooths them; 0 where they are taken as they are.
    scatter
        Standard deviation of the readings about it [m]; nan where they are taken as they are.
    """

    profile: WidthProfile
    reading: Reading
    position: Array
    value: Array
    order: int
    scatter: float

    @property
    def key(self) -> str:
        """Key of ``[pulley.across]`` that it belongs under."""
        return "worn_depth" if self.reading in ("depth", "thickness") else "shell_profile"


def read_profile(
    path: str | os.PathLike[str],
    *,
    new: float | None = None,
    unit: str = "",
    columns: tuple[str | int, str | int] | None = None,
    centred: bool | None = None,
) -> MeasuredProfile:
    """Read a profile measured over the face of a pulley: text with any delimiter, or Excel.

    Parameters
    ----------
    path
        A table with a column of positions and one of depths, thicknesses, diameters or radii.
    new
        Thickness of the lagging when new [m]; of thicknesses alone. The thickest reading if left
        out.
    unit
        Unit of both columns where the file has none, ``"in"``.
    columns
        Position and reading, by name or number, where the names do not tell.
    centred
        Whether positions count from the middle of the face. Positions that are never negative
        count from one edge unless said; the face then lies between the outermost readings.

    Returns
    -------
    MeasuredProfile
        Smoothed by the polynomial that predicts left-out readings best, with what remains as its
        uncertainty; fewer than 5 readings are taken as they are.

    Raises
    ------
    InputError
        With what cannot be told, and what to give to tell it.
    """
    file = os.fspath(path)
    data = read_bytes(file, _EXPORT)
    return profile_of(data, file, new=new, unit=unit, columns=columns, centred=centred)


def profile_of(
    data: bytes,
    file: str,
    *,
    new: float | None = None,
    unit: str = "",
    columns: tuple[str | int, str | int] | None = None,
    centred: bool | None = None,
) -> MeasuredProfile:
    """Return the profile that a file of a name holds; everything else as `read_profile`."""
    tables = find_tables(data, file).tables
    if not tables:
        raise input_error(file=file, message="contains no table of numbers", remedy=_EXPORT)
    table = max(tables, key=lambda t: t.rows)
    named, _ = table.named(lambda name: any(_is(name, key) for key in _WORDS))
    where, what, reading = _columns(named, columns, file)
    style = table.found_style(file)
    y = table.numbers(where.index, style) * _factor(where, unit, file)
    value = table.numbers(what.index, style) * _factor(what, unit, file)
    good = np.isfinite(y) & np.isfinite(value)
    y, value = y[good], value[good]
    order = np.argsort(y, kind="stable")
    y, value = y[order], value[order]
    if len(y) < 2 or np.any(np.diff(y) <= 0.0):
        message = "fewer than two positions, or one measured twice"
        raise input_error(file=file, message=message, remedy=_EXPORT)
    if centred is False or (centred is None and float(np.min(y)) >= 0.0):
        y = y - 0.5 * (y[0] + y[-1])
    return _smoothed(y, _deviation(value, reading, new), reading)


def _is(name: str, key: str) -> bool:
    return any(word in plain_name(name).split() for word in _WORDS[key])


def _columns(
    named: list[NamedColumn], chosen: tuple[str | int, str | int] | None, file: str
) -> tuple[NamedColumn, NamedColumn, Reading]:
    """Return the columns of position and reading, and what was read."""
    where = what = None
    if chosen is not None:
        where, what = (find_column(named, one) for one in chosen)
    else:
        where = next((c for c in named if _is(c.name, "position")), None)
        what = next((c for c in named if any(_is(c.name, r) for r in READINGS)), None)
    found = [r for r in READINGS if what is not None and _is(what.name, r)]
    if where is None or what is None or not found:
        raise input_error(
            file=file,
            message="no column of position, or none of depth, thickness, diameter or radius",
            remedy="Name the columns so, with units.",
        )
    return where, what, found[0]


def _factor(column: NamedColumn, unit: str, file: str) -> float:
    text = column.unit or unit
    if text:
        return unit_factor(text, "length")
    raise input_error(
        file=file,
        message=f"column {shown(column.label)} has no unit",
        remedy='Write it behind the name, "thickness [mm]", or give the unit.',
    )


def _deviation(value: Array, reading: Reading, new: float | None) -> Array:
    """Depth worn off, or deviation of the radius [m]."""
    if reading == "depth":
        return value
    if reading == "thickness":
        whole = float(np.max(value)) if new is None else new
        if float(np.max(value)) > whole * (1.0 + 1e-9):
            raise input_error(
                key="new",
                value=f"{1e3 * whole:g} mm",
                message=f"must be at least the reading {1e3 * float(np.max(value)):g} mm",
                remedy="Give the thickness of the new lagging.",
            )
        return whole - value
    return (value - float(np.mean(value))) * (0.5 if reading == "diameter" else 1.0)


def _smoothed(y: Array, value: Array, reading: Reading) -> MeasuredProfile:
    if len(y) < _FEWEST:
        profile = WidthProfile(position=tuple(y.tolist()), value=tuple(value.tolist()))
        return MeasuredProfile(
            profile=profile, reading=reading, position=y, value=value, order=0, scatter=float("nan")
        )
    scaled = 2.0 * (y - y[0]) / (y[-1] - y[0]) - 1.0
    best, order = np.inf, 1
    for k in range(1, min(_HIGHEST, len(y) - 3) + 1):
        fitted, leverage = _fit(scaled, value, k)
        left_out = float(np.mean(((value - fitted) / (1.0 - leverage)) ** 2))
        if left_out < 0.8 * best:  # a higher order must be worth it
            best, order = left_out, k
    fitted, leverage = _fit(scaled, value, order)
    scatter = float(np.sqrt(np.sum((value - fitted) ** 2) / (len(y) - order - 1)))
    basis = np.polynomial.legendre.legvander(scaled, order)
    coefficients = np.linalg.lstsq(basis, value, rcond=None)[0]
    grid = np.linspace(-1.0, 1.0, _ROWS)
    smooth = np.polynomial.legendre.legval(grid, coefficients)
    if reading in ("depth", "thickness"):
        smooth = np.maximum(smooth, 0.0)
    places = y[0] + 0.5 * (grid + 1.0) * (y[-1] - y[0])
    profile = WidthProfile(
        position=_rounded(places),
        value=_rounded(smooth),
        uncertainty=round(scatter * float(np.sqrt(np.mean(leverage))), 7),
    )
    return MeasuredProfile(
        profile=profile, reading=reading, position=y, value=value, order=order, scatter=scatter
    )


def _fit(scaled: Array, value: Array, order: int) -> tuple[Array, Array]:
    """Values of the best polynomial at the readings, and the leverage of each."""
    q, _ = np.linalg.qr(np.polynomial.legendre.legvander(scaled, order))
    return np.asarray(q @ (q.T @ value)), np.asarray(np.sum(q * q, axis=1))


def within(measured: MeasuredProfile, width: float) -> WidthProfile:
    """Return the part of a measured profile under a belt of a width [m]."""
    y = np.array(measured.profile.position)
    edges = np.clip([y[0], y[-1]], -0.5 * width, 0.5 * width)
    places = np.linspace(edges[0], edges[1], len(y))
    value = measured.profile.at(places, width)
    return replace(measured.profile, position=_rounded(places), value=_rounded(value))


def _rounded(values: Array) -> tuple[float, ...]:
    """Values to a micrometre [m]."""
    return tuple(round(v, 6) for v in values.tolist())
