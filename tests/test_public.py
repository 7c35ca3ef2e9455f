"""The public surface: what ``import wraparc`` offers, declared here name by name."""

import ast
import importlib
import inspect
from pathlib import Path

import pytest

import wraparc

PUBLIC = [
    "Across",
    "AcrossResult",
    "ArcResult",
    "BatchResult",
    "Belt",
    "BreakawayError",
    "Capacities",
    "ClassicalDrive",
    "CoefficientPieces",
    "Constant",
    "ConvergenceError",
    "Distributed",
    "Drive",
    "DriveResult",
    "ElasticPlastic",
    "Energy",
    "Event",
    "FrictionLaw",
    "GrippingPulley",
    "InputError",
    "IntegralLog",
    "Kind",
    "Lagging",
    "LoadCase",
    "MeasuredTable",
    "MissingExtraError",
    "PaperMarch",
    "Piece",
    "PressureKnots",
    "PressurePower",
    "Problem",
    "Profile",
    "Provenance",
    "Pulley",
    "RunResult",
    "Setting",
    "SlackBeltError",
    "StabilityResult",
    "Station",
    "Status",
    "Tensions",
    "TestedRange",
    "Train",
    "TrainBatchResult",
    "TrainResult",
    "Transition",
    "Trend",
    "WidthProfile",
    "WrapArc",
    "WraparcError",
    "__version__",
    "load_drive",
    "load_lagging",
    "load_motion",
    "load_train",
    "simulate",
    "solve",
    "solve_across",
    "solve_batch",
    "solve_train",
    "solve_train_batch",
    "stability",
]


def test_the_public_names_are_these() -> None:
    assert wraparc.__all__ == PUBLIC
    assert sorted(PUBLIC) == PUBLIC


def test_nothing_else_shows() -> None:
    assert dir(wraparc) == PUBLIC
    visible = {
        name
        for name, value in vars(wraparc).items()
        if not name.startswith("_") and not inspect.ismodule(value)
    }
    assert visible <= set(PUBLIC)
    with pytest.raises(AttributeError, match="no attribute 'creep'"):
        getattr(wraparc, "creep")  # noqa: B009 - mypy knows that there is none


def test_every_public_name_is_documented() -> None:
    for name in PUBLIC:
        member = getattr(wraparc, name)
        if callable(member):
            assert inspect.getdoc(member), name
            assert member.__module__.startswith("wraparc."), name


def test_the_names_that_checkers_see_are_those_that_are_imported() -> None:
    """The lists for type checkers and for the interpreter are two; they must say the same."""
    tree = ast.parse(Path(wraparc.__file__).read_text("utf-8"))
    block = next(node for node in tree.body if isinstance(node, ast.If))
    seen = {
        alias.name: node.module
        for node in block.body
        if isinstance(node, ast.ImportFrom)
        for alias in node.names
    }
    assert sorted(seen) == sorted(PUBLIC)
    for name, module in seen.items():
        assert getattr(importlib.import_module(str(module)), name) is getattr(wraparc, name)
