"""Time of one arc in plain Python beside the general way: python benchmarks/arc.py [drives].

Random driving arcs of the shipped laggings; times are processor time, best of three, median over
the drives. The general way is SciPy's solve_ivp (RK45, 1e-6, a root for the slip at every
evaluation) inside brentq, at an accuracy of about 1e-5. Ratios hold, times drift with the machine.
"""

from __future__ import annotations

import math
import sys
import time
from collections.abc import Callable
from functools import partial
from statistics import median

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from wraparc import load_lagging
from wraparc.arc import Distributed, WrapArc
from wraparc.arc.answer import operating_point


def random_arc(lagging: str, rng: np.random.Generator) -> WrapArc:
    part = load_lagging(lagging)
    diameter, width = float(rng.uniform(0.6, 1.2)), float(rng.uniform(0.8, 1.6))
    entry = float(rng.uniform(150e3, 450e3)) * width * diameter / 2.0
    return WrapArc(
        law=part.law,
        entry_tension=entry,
        exit_tension=entry / float(rng.uniform(1.3, 3.0)),
        diameter=diameter,
        wrap_angle=float(rng.uniform(2.9, 3.7)),
        width=width,
        axial_stiffness=float(np.exp(rng.uniform(math.log(8e6), math.log(2e8)))) * width,
        thickness=part.thickness,
        shear_modulus=part.shear_modulus,
        compression_modulus=part.compression_modulus,
    )


def generally(arc: WrapArc) -> float:
    """Exit creep by solve_ivp and brentq [m]."""

    def end(g: float) -> NDArray[np.float64]:
        def rates(s: float, y: NDArray[np.float64]) -> list[float]:
            tension = arc.entry_tension * math.exp(y[0])
            p = arc.wrap_pressure(tension)

            def gap(x: float) -> float:
                return x + arc.shear_compliance * float(arc.law.friction(x, p)) * p - float(y[1])

            x = brentq(gap, 0.0, float(y[1]), xtol=1e-12) if y[1] > 0.0 else 0.0
            mu = float(arc.law.friction(x, p))
            return [-mu / arc.radius, g + (arc.entry_tension - tension) * arc.compliance]

        start = [0.0, arc.entry_overrun]
        path = solve_ivp(rates, (0.0, arc.length), start, rtol=1e-6, atol=1e-9)
        return np.asarray(path.y[:, -1])

    goal = math.log(arc.exit_tension / arc.entry_tension)
    g = brentq(lambda g: float(end(g)[0]) - goal, 1e-7, 0.05, xtol=1e-9)
    return float(end(g)[1])


def best(work: Callable[[], object], runs: int = 3) -> float:
    times = []
    for _ in range(runs):
        start = time.process_time()
        work()
        times.append(time.process_time() - start)
    return 1e3 * min(times)


def main() -> None:
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 20
    print("lagging          solve [ms]   with profile   complete   solve_ivp + brentq   ratio")
    for lagging in ("diamond-rubber", "medium-ceramic", "full-ceramic"):
        rng = np.random.default_rng(1)
        arcs = [random_arc(lagging, rng) for _ in range(count)]
        rows = []
        for arc in arcs:
            law, geometry = arc.law.compact(), arc.geometry()
            tensions = (arc.entry_tension, arc.exit_tension)
            rows.append(
                (
                    best(partial(operating_point, law, geometry, *tensions)),
                    best(partial(Distributed(capacities=False).solve, arc)),
                    best(partial(Distributed().solve, arc)),
                )
            )
        slow = best(partial(generally, arcs[0]), 1)
        fast, profile, complete = (median(column) for column in zip(*rows, strict=True))
        print(
            f"{lagging:15s} {fast:10.2f} {profile:14.2f} {complete:10.2f} {slow:17.0f} "
            f"{slow / rows[0][0]:10.0f}"
        )


if __name__ == "__main__":
    main()
