"""Claims of the introduction: metrics of growing sheets, perimeters of hyperbolic surfaces."""

from checks.claim import Check, Claim, Mutant

_PLANE = "checks.verify.hyperbolic_plane:"

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="1.not-flat",
        section="1",
        where="section 1, line 95",
        kind="sentence",
        statement=(
            "The metrics of leaves and torn sheets, of negative curvature, are not "
            "those of any flat shape."
        ),
        checks=(
            Check(
                name="conformal maps to the plane",
                run=_PLANE + "no_flat_map",
                routes=(
                    "curvature of the metric of a holomorphic map",
                    "the Cauchy-Riemann equations",
                ),
                mutants=(Mutant(name="a metric of curvature 0", given={"curvature": 0}),),
            ),
        ),
    ),
    Claim(
        id="1.swelling-centre",
        section="1",
        where="section 1, line 97",
        kind="sentence",
        statement=(
            "A disk that swells more near its centre gets positive total curvature "
            "inside every concentric circle."
        ),
        hypotheses=(
            ("(used, not stated) the swelling is isotropic and depends on the radius alone"),
        ),
        checks=(
            Check(
                name="total curvature",
                run=_PLANE + "swelling",
                routes=(
                    "curvature of a conformal metric",
                    "integral over a disk",
                ),
                mutants=(
                    Mutant(name="negative curvature", given={"curvature": -1}),
                    Mutant(name="swelling at the margin", given={"where": "margin"}),
                ),
            ),
        ),
    ),
    Claim(
        id="1.swelling-margin",
        section="1",
        where="section 1, line 97",
        kind="sentence",
        statement=(
            "A disk that swells more near its margin gets negative total curvature "
            "inside every concentric circle."
        ),
        hypotheses=(
            ("(used, not stated) the swelling is isotropic and depends on the radius alone"),
        ),
        checks=(
            Check(
                name="total curvature",
                run=_PLANE + "swelling_at_margin",
                routes=(
                    "curvature of a conformal metric",
                    "integral over a disk",
                ),
                mutants=(
                    Mutant(name="positive curvature", given={"curvature": 1}),
                    Mutant(name="swelling at the centre", given={"where": "centre"}),
                ),
            ),
        ),
    ),
    Claim(
        id="1.crochet-perimeter",
        section="1",
        where="section 1, line 100",
        kind="sentence",
        statement=(
            r"In $\mathbb{H}^2$, as in hyperbolic crochet, the perimeter of a disk grows"
            " exponentially with its radius."
        ),
        rests_on=("def:H2",),
        checks=(
            Check(
                name="perimeter",
                run=_PLANE + "perimeter_growth",
                routes=(
                    "Jacobi equation",
                    "circles on the hyperboloid",
                ),
                mutants=(
                    Mutant(name="flat plane", given={"curvature": 0}),
                    Mutant(name="sphere", given={"curvature": 1}),
                    Mutant(name="rate 2", given={"rate": 2}),
                ),
            ),
            Check(
                name="area",
                run=_PLANE + "disk_area",
                form="support",
                routes=(
                    "integral of the area element of the disk model",
                    "closed form",
                ),
                mutants=(Mutant(name="shift 2", given={"shift": 2}),),
            ),
        ),
    ),
    Claim(
        id="1.hyperbolic-perimeter",
        section="1",
        where="section 1, line 104",
        kind="sentence",
        statement=(
            "On a hyperbolic surface the length of a circle of radius $r$ is exponential in $r$."
        ),
        hypotheses=(
            (
                r"(used, not stated) $K \le -\delta^2 < 0$: $ds^2 = dr^2 + (r + r^3)^2 "
                r"d\theta^2$ has $K = -6/(1 + r^2) < 0$ and perimeters $2\pi(r + r^3)$"
            ),
        ),
        checks=(
            Check(
                name="curvature bounded away from 0",
                tier="full",
                run=_PLANE + "negative_curvature_growth",
                routes=(
                    "Wronskian against constant curvature",
                    "rate of growth of the perimeters of four rotationally symmetric planes",
                ),
                mutants=(
                    Mutant(name="curvature only negative", given={"bounded_away": False}),
                    Mutant(name="no exponential growth", given={"opposite": True}),
                ),
            ),
        ),
    ),
)
