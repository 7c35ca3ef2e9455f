"""The batch kernel: many arcs in, columns out.

Two settings, one physics. The precise one runs the scalar kernel of :mod:`wraparc.arc` for every
arc. The engineering one marches blocks of arcs side by side in the lanes of the processor and
leaves to the scalar kernel what its lanes are not made for. Both are compiled with numba where it
is installed, and run as plain Python and NumPy where it is not.
"""

from wraparc.batch.result import STATUSES, BatchResult
from wraparc.batch.solve import Setting, solve_arcs, solve_batch

__all__ = ["STATUSES", "BatchResult", "Setting", "solve_arcs", "solve_batch"]
