"""Names for the arrays that every room computes with."""

from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
Integers = NDArray[np.int64]
Codes = NDArray[np.int8]
Flags = NDArray[np.bool_]
#: A number, or a column of them.
Number = TypeVar("Number", float, Array)
