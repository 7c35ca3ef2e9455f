"""Many arcs in, columns out.

The collocation of :mod:`wraparc.arc` over columns (NumPy), to the accuracy of a setting; what it
does not serve is left to the scalar solver, row by row.
"""

from wraparc.batch.result import STATUSES, BatchResult
from wraparc.batch.setting import Setting
from wraparc.batch.sliding import slides_of
from wraparc.batch.solve import solve_arcs, solve_batch

__all__ = ["STATUSES", "BatchResult", "Setting", "slides_of", "solve_arcs", "solve_batch"]
