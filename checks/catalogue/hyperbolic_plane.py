"""Claims opening section 3: the hyperbolic plane."""

from checks.claim import Check, Claim, Mutant

_PLANE = "checks.verify.hyperbolic_plane:"

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="def:H2",
        section="3",
        where="definition (def:H2), lines 239-241",
        kind="definition",
        statement=(
            r"$\mathbb{H}^2$ is the simply connected surface of constant curvature $-1$ with the "
            "largest symmetry group; a model is the disk $x^2 + y^2 < 1$ with $g = "
            "4(dx^2 + dy^2)/(1 - (x^2 + y^2))^2$."
        ),
        labels=("def:H2",),
        checks=(
            Check(
                name="metric",
                run=_PLANE + "metric",
                part="metric",
                routes=(
                    "metric of the hyperboloid in its disk",
                    "the printed factor",
                ),
                mutants=(
                    Mutant(name="factor 1 for 4", given={"numerator": 1}),
                    Mutant(name="power 1 for 2", given={"power": 1}),
                ),
            ),
            Check(
                name="curvature",
                run=_PLANE + "curvature",
                part="curvature",
                routes=(
                    "Laplacian of the logarithm of the factor",
                    "the value -1",
                ),
                mutants=(
                    Mutant(name="factor 1 for 4", given={"numerator": 1}),
                    Mutant(name="power 1 for 2", given={"power": 1}),
                    Mutant(name="curvature 1", given={"value": 1}),
                ),
            ),
            Check(
                name="Killing fields",
                run=_PLANE + "symmetry",
                part="symmetry",
                routes=(
                    "Killing's equation on polynomials",
                    "the largest dimension 3",
                ),
                mutants=(
                    Mutant(name="power 1 for 2", given={"power": 1}),
                    Mutant(name="power 3 for 2", given={"power": 3}),
                ),
            ),
            Check(
                name="length of the radii",
                run=_PLANE + "completeness",
                part="completeness",
                routes=(
                    "pole of the factor at the boundary",
                    "convexity of the disk",
                ),
                mutants=(Mutant(name="power 1 for 2", given={"power": 1}),),
            ),
        ),
    ),
)
