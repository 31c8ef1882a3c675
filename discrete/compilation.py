"""What the compiled kernels share: bodies made known to numba, and code kept between processes.

A kernel calls the same plain functions as the generic body. numba keeps compiled code beside the
file that defines the kernel and looks at that file alone: a stamp made of the sources of all bodies
goes into the kernel, so that a change in any of them gives new code.
"""

import inspect
from collections.abc import Callable
from functools import cache
from typing import Any

Kernel = Callable[..., Any]


@cache
def _known_to_numba(body: Callable[..., Any]) -> str:
    """Let kernels call a plain function; gives its source."""
    from numba.extending import register_jitable

    register_jitable(error_model="numpy")(body)
    return inspect.getsource(body)


def stamp_of(*bodies: Callable[..., Any]) -> str:
    """Sources of functions that a kernel calls, each of them made known to numba."""
    return "".join(_known_to_numba(body) for body in bodies)


def compiled(kernel: Kernel, *, nogil: bool = False) -> Kernel:
    """Compiled form of a kernel whose closure holds its stamp; numba is imported here.

    Division by zero gives inf or NaN, as in arrays; no reordering, no contraction. nogil: whether
    other threads run meanwhile.
    """
    from numba import njit

    found: Kernel = njit(cache=True, error_model="numpy", nogil=nogil)(kernel)
    return found
