"""Two other ways to fill a rectangle by the same rule: NumPy anti-diagonals and a row loop."""

from functools import cache

from discrete.compilation import stamp_of
from discrete.quad_rule import close_quad


def by_antidiagonals(space, nodes):
    """Fill nodes (3, n, m) in place, one NumPy expression for each anti-diagonal."""
    _, height, width = nodes.shape
    flat = nodes.reshape(3, -1)
    stride = width - 1
    for t in range(2, height + width - 1):
        low, high = max(1, t - width + 1), min(height - 1, t - 1)
        first, past = t + low * stride, t + high * stride + 1
        p, p1, p2, target = (
            flat[:, first - back : past - back : stride] for back in (width + 1, 1, width, 0)
        )
        target[0], target[1], target[2] = close_quad(space.dot, p, p1, p2)


@cache
def row_loop(space):
    """Compiled loop row by row over nodes (3, n, m), which it fills in place."""
    from numba import njit

    dot = space.dot
    stamp_of(dot, close_quad)

    def fill(nodes):
        for i in range(1, nodes.shape[1]):
            for j in range(1, nodes.shape[2]):
                p = (nodes[0, i - 1, j - 1], nodes[1, i - 1, j - 1], nodes[2, i - 1, j - 1])
                p1 = (nodes[0, i, j - 1], nodes[1, i, j - 1], nodes[2, i, j - 1])
                p2 = (nodes[0, i - 1, j], nodes[1, i - 1, j], nodes[2, i - 1, j])
                q = close_quad(dot, p, p1, p2)
                nodes[0, i, j] = q[0]
                nodes[1, i, j] = q[1]
                nodes[2, i, j] = q[2]

    return njit(error_model="numpy")(fill)
