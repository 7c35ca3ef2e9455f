"""Pictures of drives in time: histories, creep over arc and time, responses, maps of stability."""

from __future__ import annotations

import numpy as np

from wraparc.glossary import GLOSSARY
from wraparc.motion.result import RunResult
from wraparc.motion.vibration import StabilityMap, StabilityResult
from wraparc.plot.picture import BLUE, GREEN, GREY, ORANGE, RED, Picture, ramp, styled
from wraparc.units import System, display_unit

_COLOURS = (BLUE, ORANGE, GREEN, RED, GREY)
_DASHES = ("-", (0, (5, 2)), (0, (1, 1.5)), (0, (5, 1, 1, 1)), (0, (3, 1)))


def plot_run(run: RunResult, units: System = "si") -> Picture:
    """Draw a run: speeds, tensions, pulls and creep against time, creep over arc and time."""
    with styled():
        from matplotlib.figure import Figure

        n = len(run.drums)
        figure = Figure(figsize=(9.0, 7.6 + 1.5 * n), layout="constrained")
        grid = figure.add_gridspec(4 + n, 1, height_ratios=[1.0] * 4 + [0.9] * n)
        axes = [figure.add_subplot(grid[0])]
        axes += [figure.add_subplot(grid[i], sharex=axes[0]) for i in range(1, 4 + n)]
        force, f = display_unit("force", units)
        speed, v = display_unit("speed", units)
        length, x = display_unit("length", units)
        t = run.time
        axes[0].plot(t, run.belt_speed / v, color=GREY)
        axes[0].set_title(f"{run.station.train.title or 'Drive'}: {run.event.name}")
        axes[0].set_ylabel(f"belt [{speed}]")
        first = run.drums[0]
        axes[1].plot(t, first.entry_tension / f, color=GREY, label=f"before {first.name}")
        for i, d in enumerate(run.drums):
            colour, dash = _COLOURS[i % 5], _DASHES[i % 5]
            axes[1].plot(t, d.exit_tension / f, color=colour, ls=dash, label=f"behind {d.name}")
            axes[2].plot(t, d.effective_tension / f, color=colour, ls=dash, label=d.name)
            axes[3].plot(t, d.exit_creep / x, color=colour, ls=dash, label=d.name)
        limit = min(map(run.station.train.creep_limit_of, run.station.train.pulleys)) / x
        if limit < 2.0 * run.peak_creep.value / x:
            axes[3].axhline(limit, color=RED, lw=1.2, ls=(0, (1, 1.5)), label="limit")
        for axis, label in zip(
            axes[1:4],
            (
                f"tension [{force}]",
                f"Te = T1 - T2 [{force}]",
                f"{GLOSSARY['exit_creep'].title} [{length}]",
            ),
            strict=True,
        ):
            axis.set_ylabel(label)
            axis.legend(loc="upper right", ncols=4)
        top = max(float(np.max(np.abs(d.creep))) for d in run.drums) / x or 1.0
        for axis, d in zip(axes[4:], run.drums, strict=True):
            shown = axis.pcolormesh(
                run.picture_time, d.place, d.creep.T / x, cmap="RdBu_r", vmin=-top, vmax=top,
                shading="nearest", rasterized=True,
            )  # fmt: skip
            axis.set_ylabel(f"{d.name}\nentry 0, exit 1")
            axis.grid(visible=False)
        figure.colorbar(shown, ax=axes[4:], label=f"creep over the wrap [{length}]", pad=0.01)
        axes[-1].set_xlabel("time [s]")
        for axis in axes[:-1]:
            axis.tick_params(labelbottom=False)
    return Picture(figure)


def plot_stability(result: StabilityResult, units: System = "si") -> Picture:
    """Draw how pull and creep answer to run-out, and how the controls compare."""
    with styled():
        from matplotlib.figure import Figure

        figure = Figure(figsize=(9.0, 8.4), layout="constrained")
        pull, phase, creep, bars = figure.subplots(4, 1, height_ratios=[1.0, 0.7, 1.0, 1.3])
        length, x = display_unit("length", units)
        shown = [r for r in result.responses if r.kind == "run-out"]
        last = shown[-1]
        names = result.linear.station.names
        for i, name in enumerate(names):
            colour, dash = _COLOURS[i % 5], _DASHES[i % 5]
            share = 100.0 * np.abs(last.pull[:, i]) * result.run_out
            pull.loglog(last.frequency, share, color=colour, ls=dash, label=name)
            angle = np.degrees(np.unwrap(np.angle(last.pull[:, i])))
            phase.semilogx(last.frequency, angle, color=colour, ls=dash)
            size = np.abs(last.creep[:, i]) * result.run_out / x
            creep.loglog(last.frequency, size, color=colour, ls=dash)
        turn = result.linear.duties[-1].speed / (2.0 * np.pi)
        for axis in (pull, phase, creep):
            for order in (1, 2, 3):
                axis.axvline(order * turn, color=GREY, lw=0.8, ls=(0, (1, 2)))
        pull.set_title(f"Run-out of {last.pulley}; dotted: 1, 2 and 3 waves per revolution")
        pull.set_ylabel("Te ripple [%]")
        phase.set_ylabel("phase [deg]")
        creep.set_ylabel(f"{GLOSSARY['exit_creep'].title} [{length}]")
        creep.set_xlabel("frequency [Hz]")
        pull.legend()
        places = np.arange(len(result.controls))
        one = [100.0 * c.pull * result.run_out for c in result.controls]
        three = [100.0 * c.pull_third * result.run_out for c in result.controls]
        bars.barh(places - 0.2, one, 0.38, color=BLUE, label="1 per revolution")
        bars.barh(
            places + 0.2, three, 0.38, color=ORANGE, hatch="///", edgecolor="white", label="3"
        )
        labels = [c.name + ("" if c.stable else " (unstable)") for c in result.controls]
        bars.set_yticks(places, labels)
        bars.invert_yaxis()
        bars.set_xlabel("Te ripple of the worst pulley [%]")
        bars.legend()
    return Picture(figure)


def plot_stability_map(found: StabilityMap) -> Picture:
    """Draw where a station pulsates, over droop (or coupling slip) and inertia."""
    with styled():
        from matplotlib.figure import Figure

        figure = Figure(figsize=(7.0, 5.0), layout="constrained")
        axis = figure.subplots()
        x = 100.0 * found.x
        shown = axis.pcolormesh(
            x, found.inertia, found.pull * 0.05, shading="nearest", cmap=ramp(), rasterized=True
        )
        axis.contourf(
            x, found.inertia, found.growing, levels=[0.5, 100], colors="none", hatches=["xxx"]
        )
        if found.growing.any():
            axis.contour(x, found.inertia, found.growing, levels=[0.5], colors=RED)
        axis.set_xscale("log")
        axis.set_yscale("log")
        axis.set_xlabel(f"{found.what} of the last drive [%]")
        axis.set_ylabel("inertia of the last pulley [kg m2]")
        axis.set_title("Hatched: unstable")
        axis.grid(visible=False)
        figure.colorbar(shown, label="Te ripple for 0.5 mm of run-out, 1 per revolution [%]")
    return Picture(figure)
