"""Packages whose names are imported when they are first used."""

import importlib
import sys
from collections.abc import Callable, Mapping


def offer(
    package: str, modules: Mapping[str, str]
) -> tuple[list[str], Callable[[str], object], Callable[[], list[str]]]:
    """Return ``__all__``, ``__getattr__`` and ``__dir__`` of a package.

    Parameters
    ----------
    package
        Its name.
    modules
        Names to offer, with blanks between, by the module below the package that has them.
    """
    module_of = {name: module for module, names in modules.items() for name in names.split()}
    offered = sorted(module_of)

    def attribute(name: str) -> object:
        if name not in module_of:
            raise AttributeError(f"module {package!r} has no attribute {name!r}")
        value: object = getattr(importlib.import_module(f"{package}.{module_of[name]}"), name)
        setattr(sys.modules[package], name, value)
        return value

    return offered, attribute, lambda: list(offered)
