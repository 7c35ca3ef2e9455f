"""Kernels of the pages: forked from one process that has imported what most pages import.

A kernel of its own for every page, so that no page sees names of another; started anew, each would
import IPython, NumPy and Matplotlib for itself, which takes longer than most pages run.
"""

import os
from multiprocessing import get_context
from typing import Any

from jupyter_client.provisioning import local_provisioner
from sphinx.application import Sphinx

FORKED = get_context("forkserver")
IMPORTED = [
    "debugpy.server.api", "ipykernel.ipkernel", "ipykernel.kernelapp",
    "jupyter_client.provisioning", "matplotlib.figure", "matplotlib_inline.config",
    "psutil", "scipy.optimize", "sphinx.application", "wraparc.batch", "wraparc.cli.solve",
    "wraparc.plot.drive", "wraparc.study",
]  # fmt: skip


class Kernel:
    """A kernel with what Jupyter asks of a `subprocess.Popen`."""

    stdin = stdout = stderr = None

    def __init__(self, command: list[str], *, env: dict[str, str], cwd: str, **_: Any) -> None:
        alone = FORKED.Event()
        file = command[command.index("-f") + 1]
        self._process = FORKED.Process(target=_run, args=(file, env, cwd, alone))
        self._process.start()
        alone.wait()  # its group is ended with it, which must not be that of the build
        self.pid = self._process.pid

    def poll(self) -> int | None:
        """Return the exit code, if it has ended."""
        return self._process.exitcode

    def wait(self) -> int | None:
        """Wait for its end."""
        self._process.join()
        return self._process.exitcode


def _run(file: str, env: dict[str, str], cwd: str, alone: Any) -> None:
    from ipykernel.kernelapp import IPKernelApp

    os.setsid()
    alone.set()
    os.chdir(cwd)
    os.environ.clear()
    os.environ.update(env)
    IPKernelApp.launch_instance(["-f", file, f"--IPKernelApp.parent_handle={os.getppid()}"])


def setup(app: Sphinx) -> dict[str, Any]:
    """Have the kernels forked."""
    os.environ.setdefault("PYDEVD_DISABLE_FILE_VALIDATION", "1")  # nobody debugs a page
    FORKED.set_forkserver_preload(IMPORTED)
    launcher: Any = local_provisioner
    launcher.launch_kernel = Kernel
    return {"parallel_read_safe": True}
