"""Three-dimensional energies of section 2: metric defect, energy well, folds."""

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.printed import elasticity as printed
from theory import energy_well, plate_energy
from theory.curvature import first_form
from theory.vectors import triple

QUATERNION = sp.symbols("q0:4", real=True)
ROOT = sp.Matrix([[2, 1, 0], [1, 3, 1], [0, 1, 2]])
FOLD = sp.diag(1, 1, -1)


def metric_energy(setting: Setting, *, metric_factor: str = "1", swapped: bool = False) -> Evidence:
    """Whether the density of (eqn:threedenergy) vanishes at R A and A, not at a stretch of it."""

    def defect(gradient: sp.Matrix) -> sp.Matrix:
        return printed.metric_defect(
            gradient, ROOT * ROOT, metric_factor=metric_factor, swapped=swapped
        )

    turned = energy_well.rotation(QUATERNION) * ROOT
    near = printed.squared_norm(defect(sp.Rational(101, 100) * ROOT), ROOT * ROOT)
    shown = "the defect is 0 at every rotated root of G, and not after a stretch by one percent"
    return combined(
        {
            "rotated root": identities(setting, {"defect": defect(turned)}, shown=shown),
            "stretched root": statement(near > 0, shown=shown, witness="a stretch costs nothing"),
        },
        shown=shown,
    )


def coordinate_independence(setting: Setting, *, norm: str = "metric") -> Evidence:
    """Whether the density of (eqn:threedenergy) is the same in two systems of coordinates."""
    p = sp.Symbol("p", positive=True)
    e, f, q = sp.symbols("e f q", real=True)
    gradient = sp.Matrix([[1 + e, f, 0], [0, 1, 0], [0, 0, 1]])
    change = sp.Matrix([[p, q, 0], [0, 1, 0], [0, 0, 1]])
    metric = sp.eye(3)

    def density(f_: sp.Matrix, g: sp.Matrix) -> sp.Expr:
        return printed.squared_norm(printed.metric_defect(f_, g), g, norm=norm)

    moved = density(gradient * change, change.T * metric * change)
    return identities(
        setting,
        {"energy density in the new coordinates minus that in the old": moved
         - density(gradient, metric)},
        shown="the density of a stretch and shear is unchanged by x = P xi, P upper triangular",
    )  # fmt: skip


def polar_root(setting: Setting, *, root: str = "positive") -> Evidence:
    """Whether A = sqrt(G) is symmetric with A^2 = G and positive; root: another square root."""
    a, c = sp.symbols("a c", positive=True)
    b = sp.Symbol("b", real=True)
    # L L^T with positive diagonal is the general positive definite matrix (Cholesky).
    lower = sp.Matrix([[a, 0], [b, c]])
    g = lower * lower.T
    candidates = {
        "positive": energy_well.symmetric_root(g),
        "negative": -energy_well.symmetric_root(g),
        "triangular": lower.T,
    }
    found = candidates[root]
    shown = "a 2x2 metric has the root (g + sqrt(det g)) / sqrt(tr g + 2 sqrt(det g)), positive"
    square = identities(
        setting, {"A^2 - g": found * found - g, "A - A^T": found - found.T}, shown=shown
    )
    at = found.subs({a: 2, b: 1, c: 1})
    positive = bool(at[0, 0] > 0) and bool(at.det() > 0)
    return combined(
        {
            "root": square,
            "positive": statement(
                positive, shown=shown, witness=f"not positive definite: A[0, 0] = {at[0, 0]}"
            ),
        },
        shown=shown,
    )


def energy_well_contents(
    setting: Setting, *, order: str = "RA", orientation: str = "preserved"
) -> Evidence:
    """Whether the well is exactly the set of isometric maps F, F^T F = A^2, of this orientation."""
    inside = printed.well_element(energy_well.rotation(QUATERNION), ROOT, order=order)
    # Conversely R = F A^-1 has R^T R = A^-1 (A A) A^-1, and A^-1 A = 1 for every symmetric root.
    entries = sp.symbols("a0:6", real=True)
    root = sp.Matrix(
        [
            [entries[0], entries[1], entries[2]],
            [entries[1], entries[3], entries[4]],
            [entries[2], entries[4], entries[5]],
        ]
    )
    back = root.adjugate() * root - root.det() * sp.eye(3)
    shown = "(R A)^T R A = A^2 with det > 0; and F A^-1 is orthogonal, of the sign of det F"
    isometric = identities(
        setting,
        {
            "isometry of R A": inside.T * inside - ROOT * ROOT,
            "det R A - det A": triple(*(tuple(inside[:, n]) for n in range(3))) - ROOT.det(),
            "orthogonality of F A^-1": back,
        },
        shown=shown,
    )
    signs = {"preserved": (ROOT,), "any": (ROOT, FOLD * ROOT)}[orientation]
    outside = [f for f in signs if energy_well.distance_squared(f, ROOT) != 0]
    return combined(
        {
            "maps in the well": isometric,
            "isometric maps outside": statement(
                not outside,
                shown=shown,
                witness=f"the isometric map {outside[0].tolist() if outside else ''} is not in it",
            ),
        },
        shown=shown,
    )


def folded_structures(setting: Setting, *, second: str = "reflection") -> Evidence:
    """Whether (eqn:threedenergy) admits folds that cost nothing and whose average costs energy.

    second: the gradient on the other side of the fold, the first being the root of the metric.
    """
    turns = {"reflection": FOLD, "half turn": sp.diag(1, -1, -1), "stretch": sp.diag(1, 1, 2)}
    metric = sp.diag(4, 9, 1)
    sides = [sp.diag(2, 3, 1), turns[second] * sp.diag(2, 3, 1)]
    average = (sides[0] + sides[1]) / 2
    shown = (
        "A and its mirror image across a plane have energy 0 and rank-one difference, so they fold "
        "as finely as one likes; the average of their gradients has energy density 1"
    )
    defects = {f"side {n}": printed.metric_defect(s, metric) for n, s in enumerate(sides)}
    free = identities(setting, defects, shown=shown)
    rank = (sides[1] - sides[0]).rank()
    cost = printed.squared_norm(printed.metric_defect(average, metric), metric)
    return combined(
        {
            "both sides": free,
            "compatibility": statement(
                rank == 1, shown=shown, witness=f"the gradients differ by a matrix of rank {rank}"
            ),
            "average": statement(cost == 1, shown=shown, witness=f"the average costs {cost}"),
        },
        shown=shown,
    )


def well_distance(setting: Setting, *, group: str = "SO") -> Evidence:
    """Whether dist^2 of (eq:hyperelastic) vanishes on the well only; group: SO(3), or O(3)."""
    turn = energy_well.rotation((1, 2, 3, 4))
    mirrors = {"SO": (sp.eye(3),), "O": (sp.eye(3), FOLD)}[group]

    def distance(f: sp.Matrix) -> sp.Expr:
        return min(energy_well.distance_squared(m * f, ROOT) for m in mirrors)

    s, a = sp.symbols("s1:4", positive=True), sp.symbols("a1:4", positive=True)
    stretched = printed.deviation(sp.diag(*s), printed.well_element(sp.eye(3), sp.diag(*a)))
    shown = (
        "dist^2 is 0 at R A, 4 at the mirror image of A (four times the least eigenvalue of G), "
        "positive after a stretch, and sum (s_i - a_i)^2 between stretches along common axes"
    )
    values = {
        "rotated root": (distance(turn * ROOT), sp.Integer(0)),
        "mirror image": (distance(turn * FOLD * ROOT), sp.Integer(4)),
        "parallel stretches": (energy_well.distance_squared(sp.diag(*s), sp.diag(*a)), stretched),
    }
    return identities(setting, {k: x - y for k, (x, y) in values.items()}, shown=shown)


def no_folds(setting: Setting, *, group: str = "SO") -> Evidence:
    """Whether no two elements of the well differ by a matrix of rank one, as a fold needs."""
    trace, minors = energy_well.rotation_defect_invariants(QUATERNION)
    axis = sum(c**2 for c in QUATERNION[1:]) / sum(c**2 for c in QUATERNION)
    shown = (
        "the principal 2x2 minors of R - 1 add up to 4 |q1 q2 q3|^2 / |q|^2, which is 0 only for "
        "R = 1: two rotations never differ by rank one"
    )
    farthest = {"SO": sp.diag(1, -1, -1), "O": FOLD}[group]
    rank = (farthest - sp.eye(3)).rank()
    return combined(
        {
            "minors": identities(
                setting, {"minors": minors - 4 * axis, "trace": trace + 4 * axis}, shown=shown
            ),
            "involutions": statement(
                rank != 1, shown=shown, witness=f"{farthest.tolist()} - 1 has rank {rank}"
            ),
        },
        shown=shown,
    )


def plate_metric(setting: Setting, *, across: str = "1", shear: str = "0") -> Evidence:
    """Whether the printed G is the metric of the Kirchhoff-Love extension on the centre surface."""
    x, y, t = sp.symbols("x y t", real=True)
    r = (x, y, sp.Function("w")(x, y))
    extended = plate_energy.kirchhoff_love_gram(r, (x, y), t)
    metric = printed.plate_metric(first_form(r, (x, y)), across=across, shear=shear)
    return identities(
        setting,
        {"Gram matrix at t = 0": extended.subs(t, 0) - metric},
        shown="on the centre surface of a graph the extension r + t N has the metric (g, 1)",
    )
