"""Claims of section 3.5, the sine-Gordon equation with branch points."""

from checks.claim import Check, Claim, Erratum, Mutant

_TILINGS = "checks.verify.branched_sine_gordon:"
_NETS = "checks.verify.net_balance:"

CLAIMS: tuple[Claim, ...] = (
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
                run=_TILINGS + "theorem",
                tier="full",
                routes=(
                    "exact ranks of the relations between angles on random tilings",
                    "the printed rule",
                ),
                mutants=(Mutant(name="m - 3 for m - 2", given={"regular": 3}, near=True),),
            ),
            Check(
                name="no branch point on the polygon, no corner on their curves",
                run=_TILINGS + "theorem",
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
                run=_TILINGS + "limits_on_rays",
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
            Check(
                name="on nets, all angles",
                run="checks.verify.discrete_charges:balance",
                tier="full",
                form="support",
                routes=(
                    "counts and fractions of pi at the corners, written out",
                    "discrete.charges",
                ),
                mutants=(
                    Mutant(name="m - 3 for m - 2", given={"regular": 3}, near=True),
                    Mutant(name="corners alone", given={"corners": True}),
                    Mutant(name="opposite charge", given={"sign": 1}),
                ),
            ),
            Check(
                name="on hyperbolic nets",
                run=_NETS + "floats",
                tier="full",
                form="support",
                routes=(
                    "angles advanced without coordinates (discrete.branched_net)",
                    "areas of geodesic triangles between half-turns of triples",
                ),
                mutants=(
                    Mutant(name="m - 3 for m - 2", given={"regular": 3}, near=True),
                    Mutant(name="corners alone", given={"corners": True}),
                    Mutant(name="opposite charge", given={"sign": 1}),
                    Mutant(name="area times 1.01", given={"percent": 101}, near=True),
                ),
            ),
            Check(
                name="on hyperbolic nets, in balls",
                run=_NETS + "balls",
                tier="full",
                form="support",
                routes=(
                    "angles advanced without coordinates (discrete.angle_advance)",
                    "areas of geodesic triangles between half-turns of triples",
                ),
                mutants=(
                    Mutant(name="m - 3 for m - 2", given={"regular": 3}, near=True),
                    Mutant(name="corners alone", given={"corners": True}),
                    Mutant(name="opposite charge", given={"sign": 1}),
                    Mutant(name="area times 1.01", given={"percent": 101}, near=True),
                ),
            ),
        ),
        erratum=Erratum(
            printed=(
                r"(sg-global) for every domain with compact closure whose boundary is a Hamburger "
                "polygon"
            ),
            corrected=(
                r"no branch point lies on the boundary, and $\varphi$ is continuous at each vertex "
                r"with three quadrants inside $\Gamma$: none lies on an asymptotic curve that "
                r"leaves a branch point; else $\varphi(q_n)$ is the limit from the middle one of "
                "the three quadrants"
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
                r"three quadrants in $\Gamma$ lies on a curve that leaves a branch point"
            ),
        ),
        rests_on=("thm:sg-branched",),
        checks=(
            Check(
                name="random tilings",
                run=_TILINGS + "sum_rule",
                tier="full",
                routes=(
                    "exact ranks of the relations between angles on random tilings",
                    "the printed rule",
                ),
                mutants=(
                    Mutant(name="phi jumps at reflex corners", given={"continuous": False}),
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
                run=_TILINGS + "one_angle",
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
            (
                r"(used, not stated) the asymptotic curves through branch points and vertices cut "
                r"$\Gamma$ into finitely many rectangles"
            ),
        ),
        rests_on=(
            "defn:quad",
            "def:m-star",
            "3.5.stars-are-hamburger-polygons",
        ),
        checks=(
            Check(
                name="random tilings",
                run=_TILINGS + "decomposition",
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
                run=_TILINGS + "additivity",
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
)
