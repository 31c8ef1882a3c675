"""Claims of section 2, elastic energies in three dimensions and the energy well."""

from checks.claim import Check, Claim, Mutant

_BULK = "checks.verify.elasticity"

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="eqn:threedenergy",
        section="2",
        where="equation (eqn:threedenergy), line 139",
        kind="equation",
        statement=(
            r"$\mathcal I[\tilde y] = \int_{\mathcal B} \|\partial_i\tilde y\cdot\partial_j\tilde "
            r"y - G_{ij}\|^2\,dV$ measures the strain relative to $(\mathcal B, \mathbf G)$: its "
            r"density is $0$ exactly where $\nabla\tilde y^T\nabla\tilde y = \mathbf G$."
        ),
        labels=("eqn:threedenergy",),
        hypotheses=(r"$\mathbf G$ is symmetric and positive definite",),
        checks=(
            Check(
                name="vanishes-on-isometries",
                run=f"{_BULK}:metric_energy",
                routes=("printed density", "rotations by quaternions times a root of G"),
                mutants=(
                    Mutant(name="metric-doubled", given={"metric_factor": "2"}),
                    Mutant(name="left-cauchy-green", given={"swapped": True}),
                ),
            ),
        ),
    ),
    Claim(
        id="2.threed-energy-coordinates",
        section="2",
        where="before equation (eqn:threedenergy), line 137",
        kind="sentence",
        statement=(
            r"The energy is one of the Riemannian manifold $(\mathcal B,\mathbf G)$: its density "
            r"$\|\nabla\tilde y^T\nabla\tilde y - \mathbf G\|^2$ does not depend on the "
            r"coordinates."
        ),
        hypotheses=(
            (
                r"(used, not stated) $\|D\|^2 = \operatorname{tr}(\mathbf G^{-1}D\mathbf "
                r"G^{-1}D)$, the norm of $2$-tensors in $\mathbf G$, and $dV = \sqrt{\det\mathbf "
                r"G}\,dx$: with the sum of the squared components a stretch by $1+e$ along $x$ has "
                r"the density $(2e+e^2)^2$, and $p^4$ times that in the coordinate $x/p$"
            ),
        ),
        rests_on=("eqn:threedenergy",),
        checks=(
            Check(
                name="two-charts",
                run=f"{_BULK}:coordinate_independence",
                routes=("density in one chart", "density in a sheared and stretched chart"),
                mutants=(
                    Mutant(name="one-index-raised", given={"norm": "one index"}),
                    Mutant(name="sum-of-components", given={"norm": "entries"}),
                ),
            ),
        ),
    ),
    Claim(
        id="2.folded-structures",
        section="2",
        where="after equation (eqn:threedenergy), line 142",
        kind="sentence",
        statement=(
            r"(eqn:threedenergy) admits orientation-reversing folds of any fineness that cost "
            r"nothing, though the average of their gradients has positive energy: it is not lower "
            r"semicontinuous, as a variational problem needs."
        ),
        rests_on=("eqn:threedenergy",),
        checks=(
            Check(
                name="mirror-image",
                run=f"{_BULK}:folded_structures",
                routes=("printed density on both sides of the fold", "rank of their difference"),
                mutants=(
                    Mutant(name="half-turn", given={"second": "half turn"}),
                    Mutant(name="stretch", given={"second": "stretch"}),
                ),
            ),
        ),
    ),
    Claim(
        id="2.polar-root",
        section="2",
        where="definition of the energy well, line 145",
        kind="definition",
        statement=(
            r"$A = \sqrt{\mathbf G}$ denotes the one root of $\mathbf G$ that is symmetric with "
            r"positive eigenvalues."
        ),
        hypotheses=(
            r"checked for the $2\times2$ block $g$ of a plate, outside which $\mathbf G$ is $1$",
        ),
        checks=(
            Check(
                name="cayley-hamilton",
                run=f"{_BULK}:polar_root",
                routes=("Cayley-Hamilton root", "Cholesky factors of the metric"),
                mutants=(
                    Mutant(name="negative-root", given={"root": "negative"}),
                    Mutant(name="cholesky-factor", given={"root": "triangular"}),
                ),
            ),
        ),
    ),
    Claim(
        id="2.energy-well",
        section="2",
        where="definition of the energy well, lines 143-147",
        kind="definition",
        statement=(
            r"$\mathcal F(x) = \{RA(x) : R \in SO(3)\}$ is the set of linear isometries of "
            r"$T_x\mathcal B$ into $\mathbb R^3$ that keep the orientation."
        ),
        rests_on=("2.polar-root",),
        checks=(
            Check(
                name="both-inclusions",
                tier="full",
                run=f"{_BULK}:energy_well_contents",
                routes=("quaternion rotations times the root", "orthogonality of F A^-1"),
                mutants=(
                    Mutant(name="root-first", given={"order": "AR"}),
                    Mutant(name="metric-for-root", given={"order": "RAA"}),
                    Mutant(name="orientation-dropped", given={"orientation": "any"}),
                ),
            ),
        ),
    ),
    Claim(
        id="eq:hyperelastic",
        section="2",
        where="equation (eq:hyperelastic), line 148",
        kind="equation",
        statement=(
            r"$I[\tilde y] = \int_{\mathcal B}\operatorname{dist}^2(\nabla\tilde y(x),\mathcal "
            r"F(x))\,dx$ measures the deviation from the energy well: $0$ on the well, positive on "
            r"mirror images of it, and the well admits no folds."
        ),
        labels=("eq:hyperelastic",),
        hypotheses=(r"(used, not stated) $\operatorname{dist}$ is that of the Frobenius norm",),
        rests_on=("2.energy-well",),
        checks=(
            Check(
                name="distance-to-the-well",
                run=f"{_BULK}:well_distance",
                part="distance",
                routes=("largest eigenvalue of the alignment form", "principal stretches"),
                mutants=(Mutant(name="orthogonal-group", given={"group": "O"}),),
            ),
            Check(
                name="no-rank-one-connections",
                run=f"{_BULK}:no_folds",
                part="folds",
                routes=("principal minors of R - 1", "quaternion of R"),
                mutants=(Mutant(name="orthogonal-group", given={"group": "O"}),),
            ),
        ),
    ),
    Claim(
        id="2.plate-metric",
        section="2",
        where="unlabelled display after (eq:hyperelastic), line 153",
        kind="equation",
        statement=(
            r"A plate is $\mathcal B = \Omega\times(-\frac h2,\frac h2)$ with $G_{ij}$ made of the "
            r"block $g$ and $G_{33}=1$, $G_{13}=G_{23}=0$: fibres have unit speed and are normal "
            r"to $\Omega$."
        ),
        checks=(
            Check(
                name="extension-of-a-graph",
                run=f"{_BULK}:plate_metric",
                routes=("printed matrix", "Gram matrix of r + t N at t = 0"),
                mutants=(
                    Mutant(name="fibres-stretched", given={"across": "2"}),
                    Mutant(name="fibres-oblique", given={"shear": "1"}),
                ),
            ),
        ),
    ),
)
