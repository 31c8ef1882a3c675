"""Claims of section 2, theorems on isometric immersions and their regularity."""

from checks.claim import Check, Citation, Claim, Mutant

_THEOREMS = "checks.verify.immersion_theorems"
_SEARCHES = "checks.verify.stored_searches"

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="2.hilbert",
        section="2",
        where="history of isometric immersions, line 190",
        kind="theorem",
        statement=(
            r"No geodesically complete surface of constant negative curvature is immersed "
            r"analytically in $\mathbb R^3$."
        ),
        hypotheses=(r"the curvature is constant and negative", r"the surface is complete"),
        citation=Citation(
            source="Hilbert, Trans. Amer. Math. Soc. 2 (1901) 87-99",
            reason=(
                "a statement about all complete surfaces; the search covers asymptotic "
                "quadrilaterals, whose area a complete surface would make as large as one likes"
            ),
            search="stored-search",
        ),
        checks=(
            Check(
                name="stored-search",
                tier="full",
                run=f"{_SEARCHES}:hilbert_search",
                form="support",
                routes=("marching on a grid, optimised", "Picard iteration on finer grids"),
                mutants=(
                    Mutant(name="bound-one-percent-less", given={"bound_percent": 99}, near=True),
                    Mutant(name="singular-edges-admitted", given={"domain": "whole"}),
                ),
            ),
        ),
    ),
    Claim(
        id="2.efimov",
        section="2",
        where="theorem of Efimov, lines 191-193",
        kind="theorem",
        statement=(
            r"An immersed $C^2$ surface in $\mathbb R^3$ with $K \le -\delta < 0$ is never "
            r"complete in the metric that it inherits."
        ),
        hypotheses=(
            r"$K \le -\delta < 0$",
            r"the immersion is $C^2$",
            r"the induced metric is complete",
        ),
        citation=Citation(
            source=(
                "Efimov, Mat. Sb. 64 (1964) 286-320; Tilla Klotz Milnor, Adv. Math. 8 (1972) "
                "474-543"
            ),
            reason=(
                "a statement about all complete surfaces; the search covers those with a screw "
                "symmetry, whose meridians would have to be infinite both ways"
            ),
            search="stored-search",
        ),
        checks=(
            Check(
                name="stored-search",
                tier="full",
                run=f"{_SEARCHES}:efimov_search",
                form="support",
                routes=("exact steps in floats, optimised", "the same data in ball arithmetic"),
                mutants=(
                    Mutant(name="bound-one-percent-less", given={"bound_percent": 99}, near=True),
                    Mutant(name="curvature-not-bounded-away", given={"profile": "catenoid"}),
                ),
            ),
        ),
    ),
    Claim(
        id="2.nash-kuiper",
        section="2",
        where="theorem of Nash and Kuiper, lines 195-205",
        kind="theorem",
        statement=(
            r"For a short immersion (embedding) $f$ of an $m$-dimensional Riemannian manifold in "
            r"$\mathbb R^n$, $n \ge m+1$, and every $\epsilon > 0$ there is a $C^1$ isometric "
            r"immersion (embedding) $f_\varepsilon$ that is $\varepsilon$-close to $f$."
        ),
        hypotheses=(
            r"$n \ge m+1$",
            (
                r"$f$ is short; (used, not stated) strictly so: $g - f^*\langle\cdot,\cdot\rangle$ "
                r"is positive definite"
            ),
            (
                r"(used, not stated) the sentence before it, that every metric has such an "
                r"immersion, even an embedding, asks for a short one to start from"
            ),
        ),
        rests_on=("2.nash-kuiper-isometry", "2.nash-kuiper-closeness"),
        citation=Citation(
            source=(
                "Nash, Ann. of Math. 60 (1954) 383-396; Kuiper, Indag. Math. 17 (1955) 545-556 and "
                "683-689"
            ),
            reason=(
                "an existence theorem proved by infinitely many corrugations; the search covers "
                "the first two of them, over linear short maps of the plane"
            ),
            search="stored-search",
        ),
        checks=(
            Check(
                name="stored-search",
                tier="full",
                run=f"{_SEARCHES}:nash_kuiper_search",
                form="support",
                routes=("rate of the second corrugation in closed form", "differences of the map"),
                mutants=(
                    Mutant(name="order-off-by-a-tenth", given={"order_percent": 110}, near=True),
                    Mutant(name="codimension-zero", given={"codimension": 0}),
                    Mutant(name="epsilon-a-tenth", given={"closeness": 10}),
                ),
            ),
        ),
    ),
    Claim(
        id="2.nash-kuiper-isometry",
        section="2",
        where="theorem of Nash and Kuiper, first display, line 199",
        kind="definition",
        statement=(
            r"$f_\varepsilon$ is isometric: $g(v,w) = \langle df_\varepsilon(v), "
            r"df_\varepsilon(w)\rangle$ for all tangent vectors $v, w$."
        ),
        checks=(
            Check(
                name="bobbin",
                run=f"{_THEOREMS}:isometry_equation",
                routes=("metric of curvature -1 about a geodesic", "tangents of the bobbin"),
                mutants=(
                    Mutant(name="half", given={"factor": "1/2"}),
                    Mutant(name="one-percent", given={"metric_factor": "101/100"}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="2.nash-kuiper-closeness",
        section="2",
        where="theorem of Nash and Kuiper, second display, line 203",
        kind="definition",
        statement=(
            r"$f_\varepsilon$ is $\varepsilon$-close to $f$: $\|f(x)-f_\varepsilon(x)\| < "
            r"\varepsilon$ for all $x$. An isometric $C^1$ map can be so close to a short one, its "
            r"derivative not."
        ),
        checks=(
            Check(
                name="arcs-along-a-line",
                run=f"{_THEOREMS}:uniform_closeness",
                routes=("distance at the farthest point", "bound along the whole curve"),
                mutants=(
                    Mutant(name="derivatives", given={"derivatives": 1}),
                    Mutant(name="wide-arcs", given={"radius": "1"}),
                ),
            ),
        ),
    ),
    Claim(
        id="2.holder-flexible",
        section="2",
        where="after the theorem of Nash and Kuiper, line 206",
        kind="number",
        statement=(
            r"Isometric immersions of surfaces in $\mathbb R^3$ of class $C^{1,\alpha}$ are "
            r"flexible for $\alpha < 1/5$."
        ),
        hypotheses=(r"(used, not stated) the surface is a disk with a smooth ($C^2$) metric",),
        rests_on=("2.nash-kuiper",),
        citation=Citation(
            source="De Lellis, Inauen and Szekelyhidi, Rev. Mat. Iberoam. 34 (2018) 1119-1152",
            reason="an existence theorem by convex integration; only its exponent is recomputed",
        ),
        checks=(
            Check(
                name="exponent",
                run=f"{_THEOREMS}:holder_exponent",
                form="support",
                routes=(
                    "interpolation between steps of a stage",
                    "squares in conformal coordinates",
                ),
                mutants=(
                    Mutant(name="three-corrugations", given={"primitives": 3}),
                    Mutant(name="seventh", given={"exponent": "1/7"}),
                ),
            ),
        ),
    ),
    Claim(
        id="2.holder-rigid",
        section="2",
        where="after the theorem of Nash and Kuiper, line 206",
        kind="number",
        statement=(
            r"Isometric immersions of surfaces in $\mathbb R^3$ of class $C^{1,\alpha}$ are rigid "
            r"for $\alpha > 2/3$."
        ),
        hypotheses=(
            (
                r"(used, not stated) $K > 0$, or $K = 0$ where rigid means developable: metrics "
                r"with $K < 0$ have families of smooth isometric immersions, as the bobbins show"
            ),
        ),
        citation=Citation(
            source=(
                "Borisov, Vestnik Leningrad Univ. 14 (1959); Conti, De Lellis and Szekelyhidi, "
                "Nonlinear PDE, Abel Symposia 7 (2012) 83-116; De Lellis and Pakzad for K = 0"
            ),
            reason="a statement about all immersions of a regularity below C^2",
        ),
        checks=(
            Check(
                name="negative-curvature-bends",
                run=f"{_THEOREMS}:many_isometries",
                form="support",
                routes=("metric of each bobbin", "bending density at the throats"),
                mutants=(
                    Mutant(name="one-bobbin", given={"second": "1"}),
                    Mutant(name="not-unrolled", given={"unrolled": False}),
                ),
            ),
        ),
    ),
    Claim(
        id="2.w22-bending-energy",
        section="2",
        where="after the theorem of Nash and Kuiper, line 206",
        kind="sentence",
        statement=(
            r"$W^{2,2}$ is the regularity at which the bending energy is meaningful: $4H^2-2K$ is "
            r"the squared norm of the second derivatives of an isometric immersion."
        ),
        hypotheses=(r"(used, not stated) $g$ is smooth, and second derivatives are covariant",),
        rests_on=("2.bending-density",),
        checks=(
            Check(
                name="covariant-hessian",
                tier="full",
                run=f"{_THEOREMS}:hessian_energy",
                routes=("shape operator of a graph", "covariant Hessian of the map"),
                mutants=(
                    Mutant(name="mean-curvature-alone", given={"of_gauss": "0"}),
                    Mutant(name="plus-two-K", given={"of_gauss": "2"}),
                ),
            ),
        ),
    ),
    Claim(
        id="2.energy-selection",
        section="2",
        where="after the theorem of Nash and Kuiper, line 206",
        kind="sentence",
        statement=(
            r"The isometric immersions of a metric may be many, and the bending energy "
            r"distinguishes them: the observed one is the minimiser."
        ),
        hypotheses=(r"the space of $W^{2,2}$ isometric immersions is not empty",),
        rests_on=("eqn:gammalimit",),
        checks=(
            Check(
                name="two-bobbins",
                run=f"{_THEOREMS}:many_isometries",
                routes=("metric of each bobbin", "bending density at the throats"),
                mutants=(
                    Mutant(name="one-bobbin", given={"second": "1"}),
                    Mutant(name="not-unrolled", given={"unrolled": False}),
                ),
            ),
        ),
    ),
    Claim(
        id="2.bella-kohn",
        section="2",
        where="remark on wrinkling, line 209",
        kind="remark",
        statement=(
            r"With conditions that restrict the deformations, wrinkles of a sheet of thickness $h "
            r"> 0$ arise from the competition of stretching and bending: the least energy is of "
            r"order $h^{4/3}$ per thickness."
        ),
        citation=Citation(
            source="Bella and Kohn, J. Nonlinear Sci. 24 (2014) 1147-1176, theorem 1",
            reason=(
                "upper and lower bounds for all deformations of a class; the paper quotes the "
                "result and no formula of it"
            ),
        ),
    ),
    Claim(
        id="2.bella-kohn-unbounded",
        section="2",
        where="remark on wrinkling, line 209",
        kind="remark",
        statement=(
            r"There the $W^{2,2}$ energy of the minimisers does not stay bounded as $h \to 0$, and "
            r"the limiting isometries are not in $W^{2,2}$."
        ),
        hypotheses=(
            (
                r"(used, not stated) the least energy per thickness is at least $ch^{4/3}$, where "
                r"stretching counts without $h$ and bending with $h^2$"
            ),
        ),
        rests_on=("2.bella-kohn",),
        checks=(
            Check(
                name="exponents",
                run=f"{_THEOREMS}:wrinkling_rate",
                routes=("quoted exponent", "energy of an isometry of finite bending energy"),
                mutants=(
                    Mutant(name="squared", given={"exponent": "2"}),
                    Mutant(name="above", given={"exponent": "5/2"}),
                ),
            ),
        ),
    ),
    Claim(
        id="2.free-boundary-conditions",
        section="2",
        where="remark on wrinkling, line 211",
        kind="remark",
        statement=(
            r"The boundary conditions of isometric immersions of free sheets are zero net forces "
            r"and moments."
        ),
        citation=Citation(
            source="Guven, Mueller and Vazquez-Montejo, Math. Mech. Solids 24 (2019) 4051-4077",
            reason=(
                "the conditions at a free edge under the constraint of isometry are derived there; "
                "the paper prints no formula of them"
            ),
        ),
        checks=(
            Check(
                name="rigid-motions",
                tier="full",
                run=f"{_THEOREMS}:rigid_motions",
                form="support",
                routes=("bending energy of a graph", "that of its image under a rigid motion"),
                mutants=(Mutant(name="dilation", given={"motion": "dilation"}),),
            ),
        ),
    ),
    Claim(
        id="2.test-functions",
        section="2",
        where="remark on wrinkling, line 211",
        kind="remark",
        statement=(
            r"Candidates for the least energy are isometries of finite energy; they need not "
            r"satisfy the Euler-Lagrange equations nor the boundary conditions of equilibria."
        ),
        rests_on=("2.energy-selection",),
        checks=(
            Check(
                name="strip-of-the-bobbin",
                run=f"{_THEOREMS}:no_equilibrium",
                routes=("family of isometric bobbins", "rate of the bending energy in closed form"),
                mutants=(Mutant(name="rotation", given={"variation": "rotation"}),),
            ),
        ),
    ),
)
