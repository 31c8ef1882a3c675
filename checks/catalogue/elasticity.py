"""Claims of section 2, elastic energies in three dimensions and of plates."""

from checks.claim import Check, Claim, Erratum, Mutant

_BULK = "checks.verify.elasticity"
_PLATES = "checks.verify.plates"

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
        rests_on=("eqn:threedenergy",),
        checks=(
            Check(
                name="two-charts",
                run=f"{_BULK}:coordinate_independence",
                routes=("density in one chart", "density in a sheared and stretched chart"),
                mutants=(Mutant(name="one-index-raised", given={"norm": "one index"}),),
            ),
            Check(
                name="two-charts-metric-norm",
                run=f"{_BULK}:coordinate_independence",
                form="corrected",
                given={"norm": "metric"},
                routes=("density in one chart", "density in a sheared and stretched chart"),
                mutants=(
                    Mutant(name="one-index-raised", given={"norm": "one index"}),
                    Mutant(name="sum-of-entries", given={"norm": "entries"}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"$\|\partial_i\tilde y\cdot\partial_j\tilde y - G_{ij}\|^2$, the norm unsaid",
            corrected=(
                r"$\|D\|^2 = \operatorname{tr}(\mathbf G^{-1}D\mathbf G^{-1}D)$, the norm of "
                r"$2$-tensors in $\mathbf G$, with $dV = \sqrt{\det\mathbf G}\,dx$"
            ),
            kind="ambiguous",
            witness=(
                r"read as the sum of the squared components, a stretch by $1+e$ along $x$ has the "
                r"density $(2e+e^2)^2$, and $p^4$ times that in the coordinate $x/p$"
            ),
            conclusion_survives=True,
            remark="the two readings agree in orthonormal frames, the only place the paper uses it",
        ),
    ),
    Claim(
        id="2.folded-structures",
        section="2",
        where="after equation (eqn:threedenergy), line 142",
        kind="sentence",
        statement=(
            r"(eqn:threedenergy) admits orientation-reversing folds of any fineness that cost "
            r"nothing, and so no minimisers: the average of their gradients has positive energy."
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
            r"$A = \sqrt{\mathbf G}$ is the symmetric, positive definite root of $\mathbf G$."
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
            r"$\mathcal F(x) = \{RA(x) : R \in SO(3)\}$ holds all orientation preserving isometric "
            r"linear maps of $T_x\mathcal B$ into $\mathbb R^3$, and no others."
        ),
        rests_on=("2.polar-root",),
        checks=(
            Check(
                name="both-inclusions",
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
    Claim(
        id="2.fvk-displacement-scaling",
        section="2",
        where="before equation (FvK), line 156",
        kind="sentence",
        statement=(
            r"In-plane displacements $O(\sqrt h)$ and out-of-plane displacements $O(h)$ are the "
            r"scaling that leads to the energy (FvK)."
        ),
        hypotheses=(r"(used, not stated) both terms of (FvK) and both of the strain are kept",),
        rests_on=("FvK",),
        checks=(
            Check(
                name="strains-balance",
                run=f"{_PLATES}:displacement_scaling",
                part="strain",
                routes=("printed exponents", "Gram matrix of a displaced plane"),
                mutants=(Mutant(name="out-of-plane-square-root", given={"out_of_plane": "1/2"}),),
            ),
            Check(
                name="strains-balance-corrected",
                run=f"{_PLATES}:displacement_scaling",
                form="corrected",
                part="strain",
                given={"in_plane": "2"},
                routes=("corrected exponents", "Gram matrix of a displaced plane"),
                mutants=(
                    Mutant(name="in-plane-linear", given={"in_plane": "1"}),
                    Mutant(name="out-of-plane-square-root", given={"out_of_plane": "1/2"}),
                ),
            ),
            Check(
                name="energies-balance-corrected",
                run=f"{_PLATES}:displacement_scaling",
                form="corrected",
                part="energy",
                given={"in_plane": "2", "terms": "energy"},
                routes=("corrected exponents", "orders of stretching and bending"),
                mutants=(
                    Mutant(
                        name="exchanged-exponents", given={"in_plane": "1", "out_of_plane": "1/2"}
                    ),
                    Mutant(name="as-printed", given={"in_plane": "1/2"}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"in plane $O(\sqrt h)$, out of plane $O(h)$",
            corrected=r"in plane $O(h^2)$, out of plane $O(h)$",
            kind="false",
            witness=(
                r"the strain $\frac12(\nabla u+\nabla u^T+\nabla w\otimes\nabla w)$ has the orders "
                r"$h^{1/2}$ and $h^2$ as printed, so that $w$ drops out of the stretching energy"
            ),
            conclusion_survives=True,
            remark=(
                r"exchanging the two exponents, in plane $O(h)$ and out of plane $O(\sqrt h)$, "
                r"balances the strains, but stretching then costs $h^3$ and bending $h^4$"
            ),
        ),
    ),
    Claim(
        id="FvK",
        section="2",
        where="equation (FvK), line 157; after (eqn:finitethicknessenergy), line 170",
        kind="equation",
        statement=(
            r"$\mathcal E^h = h\,\mathcal E_{\mathrm{stretching}} + h^3\,\mathcal "
            r"E_{\mathrm{bending}}$ is the energy of the Kirchhoff-Love extension."
        ),
        labels=("FvK",),
        hypotheses=(
            (
                r"(used, not stated) terms of order $h^5$, and terms of order $h^3$ that vanish "
                r"with the metric defect, are left out"
            ),
        ),
        rests_on=("2.kirchhoff-love-extension",),
        checks=(
            Check(
                name="powers-of-thickness",
                run=f"{_PLATES}:fvk_powers",
                routes=("printed powers", "energy of the extension integrated over the thickness"),
                mutants=(
                    Mutant(name="bending-squared", given={"bending_power": 2}),
                    Mutant(name="bending-fourth", given={"bending_power": 4}),
                    Mutant(name="stretching-squared", given={"stretching_power": 2}),
                ),
            ),
        ),
    ),
    Claim(
        id="2.fvk-equations",
        section="2",
        where="after equation (FvK), line 160",
        kind="sentence",
        statement=(
            r"The equilibrium conditions of (FvK) are coupled partial differential equations for "
            r"the displacements in and out of the plane."
        ),
        hypotheses=(
            (
                r"(used, not stated) the strain is $\frac12(\nabla u+\nabla u^T+\nabla "
                r"w\otimes\nabla w)$ and the bending strain $\nabla^2 w$, for $g$ Euclidean and "
                r"$\nu = 0$"
            ),
        ),
        rests_on=("FvK",),
        checks=(
            Check(
                name="euler-lagrange",
                run=f"{_PLATES}:fvk_equations",
                routes=("Euler-Lagrange equations of the energy", "divergence form"),
                mutants=(Mutant(name="linear-strain", given={"geometric": 0}),),
            ),
        ),
    ),
    Claim(
        id="eqn:finitethicknessenergy",
        section="2",
        where="equation (eqn:finitethicknessenergy), line 162",
        kind="equation",
        statement=(
            r"$\mathcal E^h = \frac{Yh}{2}\int_\Omega\|dy\cdot dy-g\|^2\,dA + "
            r"\frac{Yh^3}{24}\int_\Omega(4H^2-2K)\,dA$ for the modulus $Y$ and Poisson ratio $\nu "
            r"= 0$."
        ),
        labels=("eqn:finitethicknessenergy",),
        hypotheses=(
            r"$\nu = 0$",
            r"(used, not stated) $\|\cdot\|$ is the norm of $2$-tensors in $g$",
            (
                r"(used, not stated) $Y$ is Young's modulus: a strip pulled by the strain $e$ "
                r"stores $Ye^2/2$ per volume"
            ),
        ),
        rests_on=("FvK", "2.bending-density"),
        checks=(
            Check(
                name="stretching",
                run=f"{_PLATES}:stretching_coefficient",
                part="stretching",
                routes=("energy of the extension", "uniaxial test that defines Young's modulus"),
                mutants=(Mutant(name="quarter", given={"stretching_factor": "1/4"}),),
            ),
            Check(
                name="bending",
                run=f"{_PLATES}:bending_coefficient",
                part="bending",
                routes=("printed bending term", "energy of the extension of an isometry"),
                mutants=(
                    Mutant(name="twelfth", given={"bending_factor": "1/12"}),
                    Mutant(name="one-percent", given={"bending_factor": "101/2400"}, near=True),
                ),
            ),
            Check(
                name="stretching-corrected",
                run=f"{_PLATES}:stretching_coefficient",
                form="corrected",
                part="stretching",
                given={"stretching_factor": "1/8"},
                routes=("energy of the extension", "uniaxial test that defines Young's modulus"),
                mutants=(
                    Mutant(name="as-printed", given={"stretching_factor": "1/2"}),
                    Mutant(name="one-percent", given={"stretching_factor": "101/800"}, near=True),
                ),
            ),
            Check(
                name="bending-kept",
                run=f"{_PLATES}:bending_coefficient",
                form="corrected",
                part="bending",
                routes=("printed bending term", "energy of the extension of an isometry"),
                mutants=(Mutant(name="twelfth", given={"bending_factor": "1/12"}),),
            ),
        ),
        erratum=Erratum(
            printed=r"$\frac{Yh}{2}\int\|dy\cdot dy-g\|^2\,dA$",
            corrected=(
                r"$\frac{Yh}{8}\int\|dy\cdot dy-g\|^2\,dA$, or "
                r"$\frac{Yh}{2}\int\|\varepsilon\|^2\,dA$ with the strain $\varepsilon = "
                r"\frac12(dy\cdot dy-g)$"
            ),
            kind="constant",
            witness=(
                r"a strip pulled by the strain $e$ stores $\frac{Yh}{2}e^2$ per area; as printed, "
                r"$dy\cdot dy-g = 2e+e^2$ gives $2Yhe^2$. The ratio of the two coefficients, "
                r"printed $12:1$, is $3:1$ for every isotropic density with $\nu=0$"
            ),
            conclusion_survives=True,
            remark="the bending term, the only one that isometries feel, is right",
        ),
    ),
    Claim(
        id="2.stretching-term",
        section="2",
        where="after equation (eqn:finitethicknessenergy), line 167",
        kind="sentence",
        statement=(
            r"$\int\|dy\cdot dy-g\|^2\,dA$ measures the deviation of the induced from the "
            r"reference metric: it is $0$ only where the two agree."
        ),
        hypotheses=(r"(used, not stated) $\|\cdot\|$ is the norm of $2$-tensors in $g$",),
        checks=(
            Check(
                name="sum-of-squares",
                run=f"{_PLATES}:stretching_measures_defect",
                routes=("trace with the inverse metric", "entries in an orthonormal frame"),
                mutants=(Mutant(name="squared-trace", given={"form": "trace"}),),
            ),
        ),
    ),
    Claim(
        id="2.willmore-functional",
        section="2",
        where="after equation (eqn:finitethicknessenergy), line 167",
        kind="sentence",
        statement=(
            r"$\int(4H^2-2K)\,dA$ is the Willmore functional, as a functional of isometries of "
            r"$g$: four times $\int H^2\,dA$ minus a number that $g$ determines."
        ),
        hypotheses=(
            (
                r"(used, not stated) $dy\cdot dy = g$: between surfaces of different metrics $\int "
                r"K\,dA$ varies"
            ),
        ),
        rests_on=("2.gauss-curvature", "2.mean-curvature"),
        checks=(
            Check(
                name="up-to-the-metric",
                run=f"{_PLATES}:willmore",
                routes=("shape operator of a graph", "curvature of its metric"),
                mutants=(
                    Mutant(name="three-for-four", given={"of_mean": "3"}),
                    Mutant(name="one-for-two", given={"of_gauss": "-1"}),
                ),
            ),
        ),
    ),
    Claim(
        id="2.mean-curvature",
        section="2",
        where="after equation (eqn:finitethicknessenergy), line 167",
        kind="definition",
        statement=r"$H = \frac{\kappa_1+\kappa_2}{2}$ is the mean curvature.",
        checks=(
            Check(
                name="half-trace",
                run=f"{_PLATES}:mean_curvature",
                routes=("roots of det(h - k g)", "trace of the shape operator; a sphere"),
                mutants=(
                    Mutant(name="sum", given={"factor": "1"}),
                    Mutant(name="one-percent", given={"factor": "101/200"}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="2.gauss-curvature",
        section="2",
        where="after equation (eqn:finitethicknessenergy), line 167",
        kind="definition",
        statement=r"$K = \kappa_1\kappa_2$ is the Gauss curvature, that of the induced metric.",
        checks=(
            Check(
                name="theorema-egregium",
                run=f"{_PLATES}:gauss_curvature",
                routes=("roots of det(h - k g)", "Riemann tensor of the metric of a graph"),
                mutants=(Mutant(name="opposite-sign", given={"sign": -1}),),
            ),
        ),
    ),
    Claim(
        id="2.bending-density",
        section="2",
        where="equations (eqn:finitethicknessenergy) and (eqn:gammalimit), lines 164 and 174",
        kind="equation",
        statement=r"$4H^2-2K = \kappa_1^2+\kappa_2^2$: both bending energies have this integrand.",
        rests_on=("2.gauss-curvature", "2.mean-curvature"),
        checks=(
            Check(
                name="sum-of-squares",
                run=f"{_PLATES}:sum_of_squares",
                routes=("principal curvatures", "squared norm of the second form"),
                mutants=(
                    Mutant(name="plus-two-K", given={"of_gauss": "2"}),
                    Mutant(name="two-for-four", given={"of_mean": "2"}),
                ),
            ),
        ),
    ),
    Claim(
        id="2.isometries-cost-h-cubed",
        section="2",
        where="after equation (eqn:finitethicknessenergy), line 168",
        kind="sentence",
        statement=r"$\mathcal E^h \sim h^3$ if $y$ is an isometry of a metric with $K = -1$.",
        hypotheses=(
            r"$K = -1$, so that $\kappa_1^2+\kappa_2^2 \ge 2$",
            r"(used, not stated) $\int(\kappa_1^2+\kappa_2^2)\,dA$ is finite",
        ),
        rests_on=("eqn:finitethicknessenergy",),
        checks=(
            Check(
                name="limit-over-h-cubed",
                run=f"{_PLATES}:isometries_cost_h_cubed",
                routes=("printed plate energy", "extension in the energy (eq:hyperelastic)"),
                mutants=(
                    Mutant(name="squared", given={"power": 2}),
                    Mutant(name="fourth", given={"power": 4}),
                    Mutant(name="no-isometry", given={"stretch": "101/100"}),
                ),
            ),
        ),
    ),
    Claim(
        id="2.kirchhoff-love-extension",
        section="2",
        where="after equation (eqn:finitethicknessenergy), line 170",
        kind="definition",
        statement=(
            r"The Kirchhoff-Love extension maps fibres orthogonal to $\Omega$ to fibres orthogonal "
            r"to $y(\Omega)$, isometrically for $\nu = 0$."
        ),
        checks=(
            Check(
                name="gram-matrix",
                run=f"{_PLATES}:kirchhoff_love",
                routes=("derivatives of r + t N", "metric of parallel surfaces, g (1 - t S)^2"),
                mutants=(
                    Mutant(name="doubled-fibres", given={"lift": 2}),
                    Mutant(name="reversed-fibres", given={"lift": -1}),
                ),
            ),
        ),
    ),
    Claim(
        id="2.isometric-fibres",
        section="2",
        where="after equation (eqn:finitethicknessenergy), line 170",
        kind="sentence",
        statement=r"For $\nu = 0$ the extension of least energy maps the fibres isometrically.",
        hypotheses=(r"(used, not stated) the density is isotropic and quadratic in the strain",),
        rests_on=("2.kirchhoff-love-extension",),
        checks=(
            Check(
                name="normal-strain",
                run=f"{_PLATES}:isometric_fibres",
                routes=("minimum over the normal strain", "moduli from the uniaxial test"),
                mutants=(
                    Mutant(name="third", given={"poisson": "1/3"}),
                    Mutant(name="one-percent", given={"poisson": "1/100"}, near=True),
                ),
            ),
        ),
    ),
)
