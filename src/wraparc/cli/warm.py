"""``wraparc warm``: everything that is compiled, compiled now, so that no first answer waits."""

import math
import sys
import time
from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING, Any, NamedTuple

import click

from wraparc.cli.pipe import say
from wraparc.errors import InputError, MissingExtraError, Problem

if TYPE_CHECKING:
    from wraparc.batch.arcs import Arcs

_ROWS = 48  # of each lagging: more than are left to the interpreter


class Part(NamedTuple):
    """What is compiled together: what it serves, and a use of it."""

    name: str
    use: Callable[[], object]


@click.command()
def warm() -> int:
    """Compile what batches, studies and the server need, once for this machine.

    Without it the first of each compiles its part, and whoever asked waits for it. Run it after an
    installation or an update; what is compiled already is only loaded.
    """
    from wraparc.batch.native import available, kept_in

    if not available():
        raise MissingExtraError("numba", "fast")
    folder = kept_in()
    if folder is None:
        problem = Problem(
            key="cache folder",
            message="no folder for compiled code can be made, or it cannot be written",
            remedy="Name one that can be written in the environment variable WRAPARC_CACHE_DIR.",
        )
        raise InputError(problem)
    whole = time.perf_counter()
    for i, part in enumerate(PARTS, 1):
        _tell(f"{i} of {len(PARTS)}  {part.name} ...")
        begun = time.perf_counter()
        part.use()
        _tell(f"{i} of {len(PARTS)}  {part.name}: {time.perf_counter() - begun:.1f} s\n")
    say(f"Ready after {time.perf_counter() - whole:.0f} s. Compiled code is kept in {folder}.")
    return 0


def _tell(line: str) -> None:
    """A line of progress; on a terminal the one that ends a part takes the place of its start."""
    terminal = sys.stderr.isatty()
    if terminal or line.endswith("\n"):
        click.echo(("\r" if terminal else "") + line, nl=False, err=True)


def _arcs() -> "Arcs":
    """Driving and braking arcs under a law of every kind."""
    import numpy as np

    from wraparc.batch.arcs import arcs_of_table
    from wraparc.files import load_lagging
    from wraparc.friction import Constant, MeasuredTable

    rubber = load_lagging("diamond-rubber")
    table = MeasuredTable(
        slip=(0.0, 1e-3, 8e-3), pressure=(1e5, 4e5), values=((0.0, 0.4, 0.8), (0.0, 0.3, 0.6))
    )
    laws = [
        rubber,
        load_lagging("full-ceramic"),
        replace(rubber, name="a table", law=table),
        replace(rubber, name="constant friction", law=Constant(friction_coefficient=0.35)),
    ]
    n = _ROWS * len(laws)
    entry, ratio = np.linspace(60e3, 250e3, n), np.linspace(1.2, 2.0, n)
    brakes = np.arange(n) % 3 == 0
    exit_tension = entry / ratio
    columns: dict[str, Any] = {
        "lagging": np.arange(n) % len(laws),
        "entry_tension": np.where(brakes, exit_tension, entry),
        "exit_tension": np.where(brakes, entry, exit_tension),
        "diameter": 0.8,
        "wrap_angle": math.pi,
        "belt_width": 1.2,
        "belt_modulus": 15e6,
    }
    return arcs_of_table(columns, laws)


def _engineering(*, capacities: bool) -> None:
    from wraparc.batch import Setting, solve_arcs

    solve_arcs(_arcs(), setting=Setting.ENGINEERING, capacities=capacities, threads=1)


def _precise(*, capacities: bool) -> None:
    from wraparc.batch import Setting, solve_arcs

    solve_arcs(_arcs(), setting=Setting.PRECISE, capacities=capacities, threads=1)


def _checks() -> None:
    import numpy as np

    from wraparc.batch.pull_factors import pull_factors

    arcs = _arcs()
    ones = np.ones(len(arcs))
    pull_factors(arcs, ones, 2.0 * ones, (0.5 * arcs.entry_tension, 0.0 * ones))


def _one_by_one() -> None:
    from wraparc.checks.compiled import prepare

    prepare()


def _trains() -> None:
    from wraparc.train.compiled import prepare

    prepare()


def _across() -> None:
    from wraparc.across.compiled import prepare

    prepare()


PARTS = (
    Part("server: one drive at a time", _one_by_one),
    Part("batches and studies: operating points", lambda: _engineering(capacities=False)),
    Part("batches and studies: capacities", lambda: _engineering(capacities=True)),
    Part("studies: checks", _checks),
    Part("precise batches: operating points", lambda: _precise(capacities=False)),
    Part("precise batches: capacities", lambda: _precise(capacities=True)),
    Part("drives on one belt", _trains),
    Part("uneven across the width", _across),
)
