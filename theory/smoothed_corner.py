r"""Asymptotic curves with a corner, and with the corner's turning spread over a short arc.

The frame T, N x T, N of a curve of normal curvature 0 and torsion tau turns by
T' = k (N x T), (N x T)' = -k T + tau N, N' = -tau (N x T), and r' = T; with constant k all is one
matrix exponential. A corner of turning angle w is the limit k = w/h over a length h -> 0.
"""

from typing import Any

from mpmath import mp


def _generator(curvature: Any, torsion: int) -> Any:
    """Matrix of the linear system for the rows T, N x T, N, r."""
    return mp.matrix(
        [[0, curvature, 0, 0], [-curvature, 0, torsion, 0], [0, -torsion, 0, 0], [1, 0, 0, 0]]
    )


def _start() -> Any:
    return mp.matrix([[1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, 0]])


def cornered(turning: Any, half: Any, *, torsion: int) -> tuple[Any, Any]:
    """State after the corner at length `half`, and at the end 2 * half, as 4x3 matrices."""
    piece = mp.expm(half * _generator(mp.mpf(0), torsion))
    c, s = mp.cos(turning), mp.sin(turning)
    corner = mp.matrix([[c, s, 0, 0], [-s, c, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
    after = corner * piece * _start()
    return after, piece * after


def smoothed(turning: Any, half: Any, window: Any, *, torsion: int) -> tuple[Any, Any]:
    """The same two states with the turning spread over `window`, in the middle of the curve."""
    straight = _generator(mp.mpf(0), torsion)
    first = mp.expm((half - window / 2) * straight)
    bend = mp.expm(window * _generator(turning / window, torsion))
    after = bend * first * _start()
    return after, first * after
