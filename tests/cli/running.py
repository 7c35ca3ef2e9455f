"""Running the command line in tests: exit code, standard output, error output."""

import io
import json
import os
import subprocess
import sys
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from typing import Any, NamedTuple

from wraparc.cli import run

DRIVE = """
format = 1
title = "Head drive"
[belt]
preset = "Plylon Plus 1000/4"
width = "1200 mm"
speed = "3 m/s"
[[pulley]]
name = "head"
diameter = "800 mm"
wrap_angle = "180 deg"
lagging = "diamond-rubber"
entry_tension = "150 kN"
exit_tension = "60 kN"
[[load_case]]
name = "empty"
pulley.head.entry_tension = "82 kN"
"""

# A law that softens past its peak: its largest tension ratio has a finite creep.
SOFTENING = (
    DRIVE.replace('lagging = "diamond-rubber"', 'lagging = "slick"')
    + """
[lagging.slick]
surface = "ceramic"
thickness = "12 mm"
shear_modulus = "2.3 MPa"
[lagging.slick.law]
kind = "integral-log"
tested_slip = "10 mm"

[[lagging.slick.law.knots]]
pressure = "50 kPa"
peak_friction = 0.30
peak_slip = "4 mm"
post_peak_slope = "-0.02 1/mm"
residual_friction = 0.15

[[lagging.slick.law.knots]]
pressure = "500 kPa"
peak_friction = 0.25
peak_slip = "5 mm"
post_peak_slope = "-0.02 1/mm"
residual_friction = 0.12
"""
)


class Ran(NamedTuple):
    """What a run of the command line left."""

    code: int
    out: str
    err: str

    @property
    def json(self) -> Any:
        """Standard output as strict JSON."""

        def refuse(constant: str) -> None:
            raise AssertionError(f"{constant} is not JSON")

        return json.loads(self.out, parse_constant=refuse)

    @property
    def words(self) -> str:
        """Standard output with every run of blanks and line ends made one blank."""
        return " ".join(self.out.split())


def wraparc(*arguments: object) -> Ran:
    """Run the command line in this process."""
    out, err = (io.TextIOWrapper(io.BytesIO(), "utf-8", write_through=True) for _ in range(2))
    with redirect_stdout(out), redirect_stderr(err):
        code = run([str(argument) for argument in arguments])
    texts = []
    for stream in (out, err):
        stream.seek(0)
        texts.append(stream.read())
    return Ran(code, *texts)


def wraparc_unread(*arguments: object) -> tuple[int, str]:
    """Run the command line with nobody reading; return exit code and error output."""
    reader, writer = os.pipe()
    os.close(reader)
    err = io.StringIO()
    # every line leaves at once, and finds the pipe closed
    out = os.fdopen(writer, "w", buffering=1, encoding="utf-8")
    with out, redirect_stdout(out), redirect_stderr(err):
        code = run([str(argument) for argument in arguments])
    return code, err.getvalue()


def wraparc_process(
    *arguments: object, env: dict[str, str] | None = None, code: str = ""
) -> "subprocess.CompletedProcess[bytes]":
    """Run the command line in a process of its own, after some Python code."""
    return subprocess.run(_command(arguments, code), capture_output=True, check=False, env=env)


def wraparc_started(*arguments: object, code: str = "") -> "subprocess.Popen[str]":
    """Start the command line in a process of its own, after some Python code; go on at once."""
    pipe = subprocess.PIPE
    return subprocess.Popen(_command(arguments, code), stdout=pipe, stderr=pipe, text=True)


def _command(arguments: tuple[object, ...], code: str) -> list[str]:
    script = f"{code}\nfrom wraparc.cli import main\nmain({[str(a) for a in arguments]!r})"
    return [sys.executable, "-W", "error", "-c", script]


def drive_file(folder: Path, text: str = DRIVE, name: str = "drive.toml") -> Path:
    """Write a drive file."""
    path = folder / name
    path.write_text(text, "utf-8")
    return path
