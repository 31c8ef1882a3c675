"""Claims of section 3.5, the sine-Gordon equation with branch points."""

from checks.claim import Check, Claim, Erratum, Mutant

_V = "checks.verify.branched_sine_gordon:"
_BALANCE = "checks.verify.balanced_curvature:"

_THEOREM: tuple[Claim, ...] = (
    Claim(
        id="thm:sg-branched",
        section="3.5",
        where="theorem (thm:sg-branched), line 973",
        kind="theorem",
        statement=(
            r"For a branched pseudospherical immersion $r : (\Omega,g) \to \mathbb R^3$ and every "
            r"domain $\Gamma$ bounded by a Hamburger polygon, the alternating sum of $\varphi$ "
            r"over the vertices is the area less $(m_i-2)\pi$ for each branch point $p_i \in "
            r"\Gamma$, as (sg-global) states."
        ),
        labels=("thm:sg-branched",),
        hypotheses=(
            (
                r"$r$ is a branched pseudospherical immersion with finitely many branch points "
                r"$p_1, \ldots, p_k$"
            ),
            r"$\Gamma \subset \Omega$ has compact closure in $\Omega$",
            (
                r"$\gamma = \partial\Gamma$ is a Hamburger polygon with vertices $q_0, \ldots, "
                r"q_{2j-1}$"
            ),
            r"$q_0$ is the initial vertex of a $u$-arc with respect to the orientation $\omega$",
        ),
        rests_on=(
            "eq:hazzidakis",
            "lem:m-star",
            "3.5.decomposition",
            "3.5.additivity",
            "3.5.angle-in-the-theorem",
            "def:branched_immersion",
        ),
        checks=(
            Check(
                name="all Hamburger polygons",
                run=_V + "theorem",
                tier="full",
                routes=(
                    "exact ranks of the relations between angles on random tilings",
                    "the printed rule",
                ),
                mutants=(Mutant(name="m - 3 for m - 2", given={"regular": 3}, near=True),),
            ),
            Check(
                name="no branch point on the polygon, no corner on their curves",
                run=_V + "theorem",
                form="corrected",
                given={"on_boundary": False, "only_off_rays": True},
                tier="full",
                routes=(
                    "exact ranks of the relations between angles on random tilings",
                    "the printed rule",
                ),
                mutants=(
                    Mutant(name="m - 3 for m - 2", given={"regular": 3}, near=True),
                    Mutant(name="opposite charge", given={"sign": 1}),
                    Mutant(name="curvature of the rays not matched", given={"matched": False}),
                    Mutant(name="branch points on the polygon", given={"on_boundary": True}),
                    Mutant(name="corners on the curves", given={"only_off_rays": False}),
                ),
            ),
            Check(
                name="limit from the middle quadrant",
                run=_V + "limits_on_rays",
                form="support",
                tier="full",
                routes=(
                    "exact ranks of the relations between angles on random tilings",
                    "the printed rule",
                ),
                mutants=(
                    Mutant(name="limit from the first quadrant", given={"choice": "first"}),
                    Mutant(name="m - 3 for m - 2", given={"regular": 3}, near=True),
                ),
            ),
        ),
        erratum=Erratum(
            printed=(
                r"(sg-global) for every domain with compact closure whose boundary is a Hamburger "
                "polygon"
            ),
            corrected=(
                r"no branch point lies on the boundary, and no vertex with three quadrants inside "
                r"$\Gamma$ on an asymptotic curve that leaves a branch point in $\Gamma$; else "
                r"$\varphi(q_n)$ is the limit from the middle one of the three quadrants"
            ),
            kind="hypothesis",
            witness=(
                r"four of the six sectors of a small star with $m = 3$, equal angles: the branch "
                r"point is on the boundary, between two $u$-arcs, and the six vertices give "
                r"$-\frac\pi3 + \frac\pi3 - \frac{2\pi}3 + \frac\pi3 - \frac{2\pi}3 + \frac{2\pi}3 "
                r"= -\frac\pi3$, neither $0$ nor $-\pi$. With an inner vertex on a curve from the "
                r"branch point $\varphi$ has two limits there, $\frac\pi3$ and $\frac{2\pi}3$"
            ),
            conclusion_survives=True,
            remark=(
                "the hypotheses are generic: a small change of the polygon restores them; vertices "
                "with one quadrant inside may lie anywhere"
            ),
        ),
    ),
    Claim(
        id="sg-global",
        section="3.5",
        where="equation (sg-global), line 976",
        kind="equation",
        statement=(
            r"$\Delta_\Gamma \equiv \sum_{n=0}^{2j-1} (-1)^n\varphi(q_n) = A(\Gamma) - "
            r"\sum_{p_i\in\Gamma} (m_i-2)\pi$."
        ),
        labels=("sg-global",),
        hypotheses=(
            (
                r"the vertices $q_n$ follow each other along $\gamma$ in the orientation induced "
                r"by $\omega$, starting at the initial vertex of a $u$-arc"
            ),
            (
                r"(used, not stated) no branch point lies on $\gamma$, and none of the $q_n$ with "
                r"three quadrants in $\Gamma$ lies on a curve from a branch point in $\Gamma$"
            ),
        ),
        rests_on=("thm:sg-branched",),
        checks=(
            Check(
                name="random tilings",
                run=_V + "sum_rule",
                tier="full",
                routes=(
                    "exact ranks of the relations between angles on random tilings",
                    "the printed rule",
                ),
                mutants=(
                    Mutant(name="m - 3 for m - 2", given={"regular": 3}, near=True),
                    Mutant(name="opposite charge", given={"sign": 1}),
                    Mutant(name="area times 1.01", given={"area_percent": 101}, near=True),
                    Mutant(name="curvature of the rays not matched", given={"matched": False}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.5.angle-in-the-theorem",
        section="3.5",
        where="theorem (thm:sg-branched), line 978",
        kind="definition",
        statement=(
            r"$\sigma = \mathrm{sign}(\omega(\partial_u r,\partial_v r))$, $\varphi \in (0,\pi)$, "
            r"$\sin\varphi = \|\partial_u r\times\partial_v r\|$, $\cos\varphi = "
            r"\sigma\,\partial_u r\cdot\partial_v r$ determine one angle, that of (eq:def_phi), "
            r"which does not change under $u \to -u$ or $v \to -v$."
        ),
        hypotheses=(r"(used, not stated) $\|\partial_u r\| = \|\partial_v r\| = 1$",),
        rests_on=("eq:def_phi",),
        checks=(
            Check(
                name="one angle",
                run=_V + "one_angle",
                routes=(
                    "Gauss-Weingarten and explicit surfaces",
                    "the printed conditions",
                ),
                mutants=(Mutant(name="no sigma in the cosine", given={"cosine_power": 0}),),
            ),
        ),
    ),
    Claim(
        id="3.5.decomposition",
        section="3.5",
        where="proof of theorem (thm:sg-branched), line 981",
        kind="sentence",
        statement=(
            r"$\Gamma = \bigcup_{j=1}^N \Gamma_j$ is a finite union of $m$-stars, each around one "
            r"branch point, and asymptotic quadrilaterals; each piece is bounded by a Hamburger "
            r"polygon."
        ),
        hypotheses=(
            r"$\overline\Gamma$ is compact and contains finitely many branch points",
            r"(used, not stated) no branch point lies on $\partial\Gamma$",
        ),
        rests_on=(
            "defn:quad",
            "def:m-star",
            "3.5.stars-are-hamburger-polygons",
        ),
        checks=(
            Check(
                name="random tilings",
                run=_V + "decomposition",
                tier="full",
                routes=(
                    "stars round the branch points",
                    "single rectangles",
                ),
                mutants=(
                    Mutant(name="no refinement", given={"refine": False}),
                    Mutant(name="stars of m rectangles", given={"per_order": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.5.additivity",
        section="3.5",
        where="proof of theorem (thm:sg-branched), line 981",
        kind="equation",
        statement=(
            r"$\Delta_\Gamma = \sum_{j=1}^M \Delta_{\Gamma_j}$ over the $N$ pieces, since $\omega$ "
            r"orients an edge common to two pieces in opposite ways; and $A(\Gamma) = \sum_j "
            r"A(\Gamma_j)$."
        ),
        hypotheses=(
            "(a misprint) $M$ is $N$, the number of pieces",
            (
                r"(used, not stated) $\oint\alpha$ along an edge common to two pieces takes the "
                r"same value from both sides, also across a jump of $\varphi$"
            ),
            (
                r"(used, not stated) pieces may meet at a vertex of one in the middle of a side of "
                r"another"
            ),
        ),
        rests_on=(
            "3.5.decomposition",
            "3.5.vertex-signs",
            "3.5.angle-derivatives-match",
        ),
        checks=(
            Check(
                name="random tilings",
                run=_V + "additivity",
                tier="full",
                routes=(
                    "sums over the pieces",
                    "sum over the boundary",
                ),
                mutants=(
                    Mutant(name="curvature of the rays not matched", given={"matched": False}),
                    Mutant(name="one piece left out", given={"left_out": 1}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="rmk:distributed",
        section="3.5",
        where="remark (rmk:distributed), line 984",
        kind="remark",
        statement=(
            r"Since $\varphi \equiv \frac\pi2$ is impossible, low energy needs branch points "
            r"distributed over $\Omega$ so that $A(\Gamma)$ and $\sum_{p_i\in\Gamma} (m_i-2)\pi$ "
            r"nearly cancel for every Hamburger polygon that is not small."
        ),
        labels=("rmk:distributed",),
        hypotheses=(r"the energy is the Willmore or the $W^{2,\infty}$ energy",),
        rests_on=(
            "sg-global",
            "3.5.right-angle-optimal",
            "3.5.right-angle-impossible",
            "3.5.one-branch-point-per-area-pi",
        ),
        waits_for=("5",),
        checks=(
            Check(
                name="bound by the angle",
                run=_BALANCE + "near_cancellation",
                routes=(
                    "signs at the vertices of random tilings",
                    "sine-Gordon equation",
                ),
                mutants=(
                    Mutant(name="half of delta a vertex", given={"per_vertex": 50}),
                    Mutant(name="0.99 delta a vertex", given={"per_vertex": 99}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="3.5.principal-curvatures",
        section="3.5",
        where="remark (rmk:distributed), line 985",
        kind="equation",
        statement=(
            r"The principal curvatures are $\kappa_1 = \tan\frac\varphi2$ and $\kappa_2 = "
            r"-\cot\frac\varphi2$."
        ),
        hypotheses=(
            r"$0 < \varphi < \pi$, for both signs of $\sigma$",
            (
                r"(used, not stated) they are the eigenvalues of $dN^\omega$, as $h = "
                r"dN^\omega \cdot dr$ suggests; those of $-dN^\omega$ are $-\tan\frac\varphi2$ and "
                r"$\cot\frac\varphi2$, for both signs of $\sigma$"
            ),
        ),
        rests_on=("eq:metrics",),
        checks=(
            Check(
                name="shape operator",
                run=_BALANCE + "principal_curvatures",
                routes=(
                    "fundamental forms of nets and explicit surfaces",
                    "the printed formulas",
                ),
                mutants=(
                    Mutant(name="both positive", given={"second": 1}),
                    Mutant(name="-dN for dN", given={"shape": "-dN"}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.5.curvature-product",
        section="3.5",
        where="remark (rmk:distributed), line 985",
        kind="equation",
        statement=r"$\kappa_1\kappa_2 = -1$.",
        hypotheses=(r"$0 < \varphi < \pi$",),
        rests_on=("3.5.principal-curvatures",),
        checks=(
            Check(
                name="product",
                run=_BALANCE + "curvature_product",
                routes=(
                    "the printed formulas",
                    "-1",
                ),
                mutants=(
                    Mutant(name="both positive", given={"second": 1}),
                    Mutant(name="cot phi", given={"halves": 2}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.5.willmore-density",
        section="3.5",
        where="remark (rmk:distributed), line 985",
        kind="definition",
        statement=(
            r"The Willmore energy has the density $\kappa_1^2 + \kappa_2^2 = \tan^2\frac\varphi2 + "
            r"\cot^2\frac\varphi2$."
        ),
        rests_on=("3.5.principal-curvatures",),
        checks=(
            Check(
                name="instance and near-miss",
                run=_BALANCE + "willmore_density",
                routes=(
                    "4 H^2 - 2 K from the forms",
                    "the printed density",
                ),
                mutants=(Mutant(name="sum of the curvatures", given={"power": 1}),),
            ),
        ),
    ),
    Claim(
        id="3.5.max-curvature-energy",
        section="3.5",
        where="remark (rmk:distributed), line 985",
        kind="definition",
        statement=(
            r"The $W^{2,\infty}$ energy is $\sup_{x\in\Omega}\max(|\kappa_1(x)|,|\kappa_2(x)|) = "
            r"\sup_\Omega\max(\tan\frac\varphi2,\cot\frac\varphi2)$."
        ),
        hypotheses=(r"(used, not stated) the supremum is essential: $r$ is $C^{1,1}$ only",),
        rests_on=("3.5.principal-curvatures",),
        checks=(
            Check(
                name="instance and near-miss",
                run=_BALANCE + "largest_curvature",
                routes=(
                    "the larger of tan and cot",
                    "the printed maximum",
                ),
                mutants=(Mutant(name="no absolute values", given={"absolute": False}),),
            ),
        ),
    ),
    Claim(
        id="3.5.right-angle-optimal",
        section="3.5",
        where="remark (rmk:distributed), line 985",
        kind="sentence",
        statement=(
            r"Both $\kappa_1^2+\kappa_2^2$ and $\max(|\kappa_1|,|\kappa_2|)$ are least at $\varphi "
            r"= \frac\pi2$ and only there, so both energies ask for $\varphi \approx \frac\pi2$ "
            r"everywhere."
        ),
        hypotheses=(r"$0 < \varphi < \pi$",),
        rests_on=(
            "3.5.willmore-density",
            "3.5.max-curvature-energy",
        ),
        checks=(
            Check(
                name="both energies",
                run=_BALANCE + "right_angle_optimal",
                routes=(
                    "differences of the energies",
                    "their sign",
                ),
                mutants=(
                    Mutant(name="tan(phi/2) = 2", given={"best": 2}),
                    Mutant(name="sum of the curvatures", given={"power": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.5.right-angle-sum-vanishes",
        section="3.5",
        where="remark (rmk:distributed), line 987",
        kind="sentence",
        statement=(
            r"If $\varphi \equiv \frac\pi2$, the left side of (sg-global) is zero, a Hamburger "
            r"polygon having as many vertices of sign $+$ as of sign $-$."
        ),
        hypotheses=(r"$\varphi = \frac\pi2$ at every vertex",),
        rests_on=(
            "sg-global",
            "3.5.hamburger-polygon",
        ),
        checks=(
            Check(
                name="signs",
                run=_BALANCE + "right_angle_sum",
                routes=(
                    "polygons of a grid",
                    "boundaries of random tilings",
                ),
                mutants=(Mutant(name="one more vertex", given={"extra": 1}, near=True),),
            ),
        ),
    ),
    Claim(
        id="3.5.right-side-of-two-signs",
        section="3.5",
        where="remark (rmk:distributed), line 987",
        kind="sentence",
        statement=(
            r"The right side of (sg-global) is the difference of two positive quantities, "
            r"$A(\Gamma)$, which varies continuously with $\Gamma$, and $\sum_{p_i\in\Gamma} "
            r"(m_i-2)\pi$, a multiple of $\pi$."
        ),
        hypotheses=(
            (
                r"(used, not stated) $\Gamma$ contains a branch point; otherwise the second "
                r"quantity is $0$"
            ),
        ),
        rests_on=("sg-global",),
        checks=(
            Check(
                name="stars of order 3",
                run=_BALANCE + "two_quantities",
                routes=(
                    "certified PIII at the corners",
                    "multiples of pi",
                ),
                mutants=(
                    Mutant(name="order 2", given={"order": 2}, near=True),
                    Mutant(name="1.01 pi", given={"percent": 101}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="3.5.right-angle-impossible",
        section="3.5",
        where="remark (rmk:distributed), line 987",
        kind="sentence",
        statement=(
            r"No branched pseudospherical immersion has $\varphi \equiv \frac\pi2$ on an open set."
        ),
        hypotheses=(r"finitely many branch points, isolated",),
        rests_on=(
            "3.5.right-angle-sum-vanishes",
            "3.5.right-side-of-two-signs",
        ),
        checks=(
            Check(
                name="constant angle",
                run=_BALANCE + "right_angle_impossible",
                routes=(
                    "derivatives of a constant",
                    "sine-Gordon equation of either sigma",
                ),
                mutants=(Mutant(name="phi = pi", given={"halves": 2}),),
            ),
        ),
    ),
    Claim(
        id="3.5.one-branch-point-per-area-pi",
        section="3.5",
        where="remark (rmk:distributed), line 987",
        kind="number",
        statement=(
            r"Cancellation in (sg-global) asks for one branch point with $m = 3$ per area $\pi$ on "
            r"average: $A(\Gamma) = \sum_{p_i\in\Gamma} (m_i-2)\pi$."
        ),
        hypotheses=(
            r"all branch points have $m = 3$",
            r"$\varphi \approx \frac\pi2$ at the vertices",
        ),
        rests_on=("sg-global",),
        checks=(
            Check(
                name="cancellation",
                run=_BALANCE + "area_per_branch_point",
                routes=(
                    "alternating sum of the angles at the centre",
                    "the printed area",
                ),
                mutants=(
                    Mutant(name="order 4", given={"order": 4}, near=True),
                    Mutant(name="1.01 pi", given={"percent": 101}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="3.5.extra-undulation",
        section="3.5",
        where="remark (rmk:distributed), line 987",
        kind="sentence",
        statement=(
            r"Each branch point with $m = 3$ adds one undulation to the surface, which persists "
            r"from the branch point to the boundary."
        ),
        hypotheses=(r"$m = 3$: the excess over a regular saddle is $m-2 = 1$",),
        rests_on=("def:m-saddle",),
        checks=(
            Check(
                name="sectors at the point",
                run=_BALANCE + "sectors_added",
                part="point",
                routes=(
                    "signs of star saddles",
                    "one more above and below",
                ),
                mutants=(
                    Mutant(name="order 4", given={"order": 4}, near=True),
                    Mutant(name="two more", given={"added": 2}, near=True),
                ),
            ),
            Check(
                name="corners of the boundary",
                run=_V + "undulations",
                part="boundary",
                tier="full",
                routes=(
                    "degrees on the boundary of random tilings",
                    "charges inside",
                ),
                mutants=(Mutant(name="one corner", given={"per_charge": 1}, near=True),),
            ),
        ),
    ),
)

CLAIMS: tuple[Claim, ...] = _THEOREM
