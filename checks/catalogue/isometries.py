"""Claims of section 2, bounds between the energies of isometries, and singular edges."""

from checks.claim import Check, Citation, Claim, Erratum, Mutant

_ISOMETRIES = "checks.verify.isometries"
_THEOREMS = "checks.verify.immersion_theorems"

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="2.max-curvature-energy",
        section="2",
        where="after equation (eqn:gammalimit), line 180",
        kind="definition",
        statement=(
            r"$\mathcal E_\infty[y] = \max_\Omega(|\kappa_1|,|\kappa_2|)$ for $y \in W^{2,\infty}$ "
            r"with $dy\cdot dy \equiv g$, and $+\infty$ otherwise: the largest normal curvature of "
            r"the surface."
        ),
        hypotheses=(
            (
                r"(used, not stated) the maximum is an essential supremum: the curvatures of a "
                r"$W^{2,\infty}$ surface are defined almost everywhere"
            ),
        ),
        checks=(
            Check(
                name="largest-normal-curvature",
                run=f"{_ISOMETRIES}:max_curvature",
                routes=("printed maximum", "norm of the shape operator of an asymptotic net"),
                mutants=(Mutant(name="signed", given={"absolute": False}),),
            ),
        ),
    ),
    Claim(
        id="2.willmore-bounded-by-max",
        section="2",
        where="after equation (eqn:gammalimit), line 180",
        kind="sentence",
        statement=(
            r"For every bounded domain $\mathcal E_2 \le \mathcal E_\infty^2$ between the energies "
            r"$\mathcal E_2 = \int(\kappa_1^2+\kappa_2^2)\,dA$ and $\mathcal E_\infty$."
        ),
        hypotheses=(r"read literally: bounded without a factor that depends on the domain",),
        rests_on=("2.max-curvature-energy", "eqn:gammalimit"),
        checks=(
            Check(
                name="without-the-area",
                run=f"{_ISOMETRIES}:willmore_bound",
                routes=("energies of a strip of the bobbin in closed form", "printed bound"),
                mutants=(Mutant(name="twice", given={"factor": "2"}),),
            ),
            Check(
                name="with-the-area",
                run=f"{_ISOMETRIES}:willmore_bound",
                form="corrected",
                given={"factor": "2", "area_power": 1},
                routes=("polynomial inequality at a point", "strip of the bobbin in closed form"),
                mutants=(
                    Mutant(name="once-the-area", given={"factor": "1"}),
                    Mutant(name="one-percent", given={"factor": "99/50"}, near=True),
                    Mutant(name="without-the-area", given={"area_power": 0}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"$\mathcal E_2$ is bounded by $\mathcal E_\infty^2$",
            corrected=(
                r"$\mathcal E_2 \le 2|\Omega|\,\mathcal E_\infty^2$, where the $2$ cannot be "
                r"lowered"
            ),
            kind="ambiguous",
            witness=(
                r"once around the bobbin $\kappa = 1$, $|\sinh s| < \frac12$: the area is $2\pi$, "
                r"so $\mathcal E_2 \ge 2|\Omega| = 4\pi$, but $\mathcal E_\infty^2 = \frac53$"
            ),
            conclusion_survives=True,
            remark=(
                r"the sentence is right if a factor that depends on the domain is understood, as "
                r"its restriction to bounded domains suggests; for $K=-1$ even $\mathcal E_2 \le "
                r"|\Omega|(\mathcal E_\infty^2+\mathcal E_\infty^{-2})$"
            ),
        ),
    ),
    Claim(
        id="2.finite-max-suffices",
        section="2",
        where="after equation (eqn:gammalimit), line 180",
        kind="sentence",
        statement=(
            r"An isometry with $\mathcal E_\infty$ finite has finite Willmore energy $\mathcal "
            r"E_2$."
        ),
        hypotheses=(r"the domain is bounded, so that its area is finite",),
        rests_on=("2.willmore-bounded-by-max",),
        checks=(
            Check(
                name="strips-of-the-bobbin",
                run=f"{_ISOMETRIES}:finite_willmore",
                routes=("Willmore energy in closed form", "corrected bound by the max curvature"),
                mutants=(Mutant(name="infinite-strip", given={"area": "infinite"}),),
            ),
        ),
    ),
    Claim(
        id="2.curvature-product",
        section="2",
        where="after equation (eqn:gammalimit), line 180",
        kind="sentence",
        statement=r"$\kappa_1\kappa_2 = -1$ a.e. on $C^{1,1}$ surfaces with $K = -1$.",
        hypotheses=(
            (
                r"$K$ is the curvature of the metric, in the sense of distributions where the "
                r"surface is only $C^{1,1}$"
            ),
            r"the low regularity is tested at small slopes, where $K$ is $\det D^2w$",
        ),
        rests_on=("2.gauss-curvature",),
        checks=(
            Check(
                name="very-weak-determinant",
                tier="full",
                run=f"{_ISOMETRIES}:curvature_product",
                routes=(
                    "second derivatives in each sector",
                    "curvature of the metric, of a graph and in the very weak sense",
                ),
                mutants=(
                    Mutant(name="crease", given={"surface": "crease"}),
                    Mutant(name="plus-one", given={"product": "1"}),
                    Mutant(name="one-percent", given={"product": "-101/100"}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="2.curvature-inequality",
        section="2",
        where="unlabelled display after (eqn:gammalimit), line 182",
        kind="equation",
        statement=(
            r"$2|H| = |\kappa_1+\kappa_2| \le \max(|\kappa_1|,|\kappa_2|) \le 2|H|+1$ at every "
            r"point."
        ),
        hypotheses=(r"$\kappa_1\kappa_2 = -1$",),
        rests_on=("2.curvature-product", "2.mean-curvature"),
        checks=(
            Check(
                name="polynomials-in-the-excess",
                run=f"{_ISOMETRIES}:curvature_inequality",
                routes=("printed bounds", "signs of polynomial coefficients in max - 1"),
                mutants=(
                    Mutant(name="lower-bound-raised", given={"scale": "101/100"}, near=True),
                    Mutant(name="upper-bound-lowered", given={"offset": "99/100"}, near=True),
                    Mutant(name="curvature-minus-four", given={"product": "-4"}),
                    Mutant(name="curvature-plus-one", given={"product": "1"}),
                ),
            ),
        ),
    ),
    Claim(
        id="2.max-mean-equivalent",
        section="2",
        where="after the display, line 184",
        kind="sentence",
        statement=(
            r"$\mathcal E_\infty$ is essentially the same as $m = \max_\Omega|H|$ for surfaces of "
            r"curvature $-1$: $\mathcal E_\infty = m+\sqrt{m^2+1}$ grows with $m$, so that both "
            r"have the same minimisers, and $0 \le \mathcal E_\infty - 2m \le 1$."
        ),
        hypotheses=(
            r"$K = -1$",
            (
                r"(used, not stated) essentially the same means up to a growing function, near "
                r"twice the identity: at $\kappa = 10, -\frac1{10}$ the two are $10$ and "
                r"$\frac{99}{20}$"
            ),
        ),
        rests_on=("2.curvature-inequality",),
        checks=(
            Check(
                name="growing-function",
                run=f"{_ISOMETRIES}:max_mean_equivalent",
                routes=("mean of the curvatures m and -1/m", "closed form |H| + sqrt(H^2 + 1)"),
                mutants=(
                    Mutant(name="curvature-plus-one", given={"product": "1"}),
                    Mutant(name="four-for-one", given={"product": "-4"}),
                    Mutant(name="mean-not-doubled", given={"factor": "1"}),
                    Mutant(name="one-percent", given={"factor": "101/50"}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="2.cuspidal-edge",
        section="2",
        where="singular edges, line 186",
        kind="sentence",
        statement=r"The singular edges of the bobbin and the pseudosphere are cuspidal edges.",
        checks=(
            Check(
                name="criterion-for-fronts",
                run=f"{_ISOMETRIES}:cuspidal_edge",
                routes=("signed area density along the null direction", "turning of the normal"),
                mutants=(
                    Mutant(name="throat", given={"point": "throat"}),
                    Mutant(name="cone-point", given={"point": "cone"}),
                ),
            ),
        ),
    ),
    Claim(
        id="2.singular-edge-generic",
        section="2",
        where="singular edges, line 186",
        kind="sentence",
        statement=(
            r"Generic immersions of $\mathbb H^2$ into $\mathbb R^3$ as a surface of that metric "
            r"have singular edges, and these are cuspidal."
        ),
        hypotheses=(
            (
                r"(used, not stated) generic: cuspidal off isolated points, where swallowtails may "
                r"occur"
            ),
        ),
        rests_on=("2.cuspidal-edge",),
        citation=Citation(
            source=(
                "Amsler, Math. Ann. 130 (1955) 234-256; Ishikawa and Machida, Internat. J. Math. "
                "17 (2006) 269-293"
            ),
            reason=(
                "that every maximal extension meets an edge, and which singularities are generic, "
                "are statements about all immersions and about jets in general position"
            ),
        ),
        checks=(
            Check(
                name="edge-of-an-asymptotic-net",
                run=f"{_THEOREMS}:generic_edge",
                form="support",
                routes=("criterion for fronts at the angle pi", "forms of an asymptotic net"),
                mutants=(Mutant(name="other-diagonal", given={"null_sign": -1}),),
            ),
        ),
    ),
    Claim(
        id="2.singular-edge-curvature",
        section="2",
        where="singular edges, line 186",
        kind="sentence",
        statement=(
            r"Exactly one principal curvature is unbounded at a singular edge, so that $\mathcal "
            r"E_\infty = \infty$ near it."
        ),
        checks=(
            Check(
                name="bobbin-and-net",
                run=f"{_ISOMETRIES}:edge_curvatures",
                routes=("second form of the bobbin", "shape operator of an asymptotic net"),
                mutants=(
                    Mutant(name="both-diverge", given={"diverging": 2}),
                    Mutant(name="none-diverges", given={"diverging": 0}),
                    Mutant(name="throat", given={"where": "throat"}),
                ),
            ),
        ),
    ),
    Claim(
        id="2.singular-edge-willmore",
        section="2",
        where="singular edges, line 187",
        kind="sentence",
        statement=(
            r"$\int(\kappa_1^2+\kappa_2^2)\,dA = \infty$ over every neighbourhood of any point "
            r"of a singular edge."
        ),
        hypotheses=(
            (
                r"(used, not stated) the angle $\varphi$ is Lipschitz up to the edge, where it is "
                r"$0$ or $\pi$"
            ),
        ),
        rests_on=("2.singular-edge-curvature",),
        checks=(
            Check(
                name="rate-at-the-edge",
                run=f"{_ISOMETRIES}:edge_willmore",
                routes=("rate of the bobbin's bending density", "primitive in the angle of a net"),
                mutants=(
                    Mutant(name="first-power", given={"power": "1"}),
                    Mutant(name="tenth-less", given={"power": "19/10"}, near=True),
                ),
            ),
        ),
    ),
)
