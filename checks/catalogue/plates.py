"""Claims of section 2, reduced energies of plates of small thickness."""

from checks.claim import Check, Claim, Erratum, Mutant

_PLATES = "checks.verify.plates"

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="2.fvk-displacement-scaling",
        section="2",
        where="before equation (FvK), line 155",
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
            Check(
                name="energies-balance-over-root-lengths",
                run=f"{_PLATES}:displacement_scaling",
                form="corrected",
                part="energy",
                given={"in_plane": "3/2", "length": "1/2", "terms": "energy"},
                routes=("corrected exponents", "orders of stretching and bending"),
                mutants=(
                    Mutant(name="lengths-of-order-one", given={"length": "0"}),
                    Mutant(name="out-of-plane-square-root", given={"out_of_plane": "1/2"}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"displacements in plane $O(\sqrt h)$, out of plane $O(h)$",
            corrected=(
                r"out of plane $O(h)$, in plane $O(h^2)$; or over in-plane lengths $O(\sqrt h)$, "
                r"in plane $O(h^{3/2})$"
            ),
            kind="false",
            witness=(
                r"the strain $\frac12(\nabla u+\nabla u^T+\nabla w\otimes\nabla w)$ has the orders "
                r"$h^{1/2}$ and $h^2$ as printed, so that $w$ drops out of the stretching energy"
            ),
            conclusion_survives=True,
            remark=(
                r"the exponents are right for in-plane lengths $O(\sqrt h)$ and out-of-plane "
                r"displacements $O(h)$, where both energies are $h^3$ per area. Exchanged, in "
                r"plane $O(h)$ and out of plane $O(\sqrt h)$, balances the strains, but stretching "
                r"then costs $h^3$ and bending $h^4$"
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
            remark=(
                r"the bending term, the only one that isometries feel, is right. The paper defines "
                r"no norm: one of half the usual length would absorb the factor"
            ),
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
        statement=r"The mean curvature is $H = \frac{\kappa_1+\kappa_2}{2}$.",
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
            r"The Kirchhoff-Love extension takes the normal fibre at a point of $\Omega$ to the "
            r"normal of $y(\Omega)$ at its image, for $\nu = 0$ at unit speed."
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
