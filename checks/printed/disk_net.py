"""Net in the Poincare disk between two lines of nodes, filled as printed (poincare-ddg)."""

from types import SimpleNamespace

import numpy as np
import numpy.typing as npt

from checks.printed import poincare_disk

#: Functions of arrays, for checks.printed.poincare_disk.
ARRAYS = SimpleNamespace(
    sqrt=np.sqrt, tanh=np.tanh, cos=np.cos, sin=np.sin, atanh=np.arctanh, atan2=np.arctan2
)


def filled_disk(
    first: npt.NDArray[np.float64], second: npt.NDArray[np.float64]
) -> npt.NDArray[np.float64]:
    """Nodes (2, n + 1, m + 1) of the net in the disk by (poincare-ddg), along anti-diagonals."""
    n, m = first.shape[1] - 1, second.shape[1] - 1
    z = np.empty((2, n + 1, m + 1))
    z[:, :, 0], z[:, 0, :] = first, second
    for total in range(n + m - 1):
        i = np.arange(max(0, total - m + 1), min(total, n - 1) + 1)
        j = total - i
        corners = (tuple(z[:, i, j]), tuple(z[:, i + 1, j]), tuple(z[:, i, j + 1]))
        z[:, i + 1, j + 1] = poincare_disk.closed(*corners, ARRAYS)
    return z
