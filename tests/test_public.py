"""The public surface: what ``import wraparc`` offers, declared here name by name."""

import inspect

import wraparc

PUBLIC = [
    "BreakawayError",
    "ConvergenceError",
    "InputError",
    "Kind",
    "MissingExtraError",
    "Problem",
    "Provenance",
    "WraparcError",
    "__version__",
]


def test_the_public_names_are_these() -> None:
    assert wraparc.__all__ == PUBLIC
    assert sorted(PUBLIC) == PUBLIC


def test_nothing_else_shows() -> None:
    visible = {
        name
        for name, value in vars(wraparc).items()
        if not name.startswith("_") and not inspect.ismodule(value)
    }
    assert visible == {name for name in PUBLIC if not name.startswith("_")}


def test_every_public_name_is_documented() -> None:
    for name in PUBLIC:
        member = getattr(wraparc, name)
        if callable(member):
            assert inspect.getdoc(member), name
            assert member.__module__.startswith("wraparc."), name
