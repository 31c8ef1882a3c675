"""Claims of section 4 on discrete surgery."""

from checks.claim import Check, Claim, Erratum, Mutant

_ANGLES = "checks.verify.surgery_angles"
_SURGERY = "checks.verify.discrete_surgery"

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="4.discrete-surgery",
        section="4",
        where="lemma on discrete surgery, line 1126",
        kind="lemma",
        statement=(
            r"Given a spherical Chebyshev net $N : Q \to S^2$, a corner $q$ of $Q$ and $l_1, l_2 "
            r"\in \mathbb N$, three rectangles $J_1, J_2, J_3$ can be attached to $Q$ so that $N$ "
            r"extends to a spherical Chebyshev net $N' : Q' \to S^2$, $Q' \supset Q$, $q \notin "
            r"\partial Q'$, and the $K$-surface of $N'$ is unramified."
        ),
        hypotheses=(
            r"all vertices of $Q$ satisfy (eq:unramified)",
            r"$q$ is a corner vertex",
            (
                r"(used, not stated) $l_1, l_2$ and the segments $\gamma_u, \gamma_v$ are so short "
                r"that every new rhombus keeps the reversed orientation"
            ),
            (
                r"(used, not stated) at the far ends of $\gamma_u$ and $\gamma_v$ the new angle "
                r"leaves the sum within the range of (eq:unramified)"
            ),
        ),
        rests_on=(
            "def:sphchebnet",
            "eq:unramified",
            "4.surgery-outer-curves",
            "4.surgery-directions",
            "4.surgery-geodesics",
            "4.surgery-closes-corner",
            "4.surgery-changes-nothing-else",
            "4.assembly-data",
        ),
        checks=(
            Check(
                name="any-corner",
                run=f"{_SURGERY}:surgery",
                tier="full",
                routes=(
                    "surgery in balls",
                    "necessary angles at the far ends",
                ),
                mutants=(
                    Mutant(
                        name="one-percent-longer-edges", near=True, given={"stretch": "101/100"}
                    ),
                ),
            ),
            Check(
                name="free-far-ends",
                run=f"{_SURGERY}:surgery",
                form="corrected",
                given={"far_ends": "free"},
                routes=(
                    "surgery in balls",
                    "(eq:unramified), sides, closing of the surface",
                ),
                mutants=(
                    Mutant(name="any-corner", given={"far_ends": "any"}),
                    Mutant(
                        name="one-percent-longer-edges", near=True, given={"stretch": "101/100"}
                    ),
                    Mutant(name="angles-below-minus-pi", given={"least": "-3/2"}),
                ),
                tier="full",
            ),
        ),
        erratum=Erratum(
            printed=(
                r"for every corner $q$ and all $l_1, l_2$ the net extends to a spherical Chebyshev "
                r"net on $Q'$ with an unramified surface"
            ),
            corrected=(
                r"it does if all new rhombi reverse the orientation and, at the far ends of "
                r"$\gamma_u$ and $\gamma_v$, the angles of the surface with that of the new "
                r"rhombus still add up to less than $2\pi$"
            ),
            kind="hypothesis",
            witness=(
                r"five rhombi with $\cos\delta = \frac{99}{101}$: one at $q$, of angle about "
                r"$0.7\pi$, and two more at each of its neighbours, where the surface's angles add "
                r"up to about $1.895\pi$. A new rhombus has $\tan\frac A2\tan\frac B2 = "
                r"\cos\delta$ for its angles at $q$ and at the neighbour, so $B < 0.106\pi$ needs "
                r"$A > 0.89\pi$ on both sides, but only $1.3\pi$ are missing at $q$. Both segments "
                r"at $q$ have one edge, so no choice of $l_1, l_2$, of the three angles or of the "
                r"curves helps"
            ),
            conclusion_survives=True,
            remark=(
                r"only the far ends are counted here; that long curves turn rhombi over is the "
                r"slip of lemma (lem:discrete_assembly). It fails where a far end is a concave "
                r"corner; for equal angles, as in the proof, three rhombi of angle $0.6\pi$ around "
                r"a vertex are enough: surgery at a neighbour $q$ adds about $0.46\pi$ to the "
                r"$1.8\pi$ there"
            ),
        ),
    ),
    Claim(
        id="4.surgery-outer-curves",
        section="4",
        where="proof on discrete surgery, line 1128",
        kind="definition",
        statement=(
            r"$\gamma_0 = \gamma_u$ and $\gamma_3 = \gamma_v$ are the maximal boundary segments of "
            r"the corner $q$, so that $J_1, J_2, J_3$ lie between $\gamma_0, \gamma_1, \gamma_2, "
            r"\gamma_3$ and the two families alternate."
        ),
        hypotheses=(
            (
                r"(used, not stated) the exterior of $Q$ at $q$ is met counterclockwise from the "
                r"$u$- to the $v$-segment; at the other corners $\gamma_u$ and $\gamma_v$ change "
                r"places"
            ),
        ),
        rests_on=("lem:segments",),
        checks=(
            Check(
                name="between-the-segments",
                run=f"{_SURGERY}:outer_curves",
                routes=(
                    "three turns by the printed angle",
                    "direction of the other segment",
                ),
                mutants=(Mutant(name="always-from-u", given={"always_u": True}),),
            ),
        ),
    ),
    Claim(
        id="4.surgery-deficit",
        section="4",
        where="proof on discrete surgery, line 1128",
        kind="number",
        statement=(
            r"(eq:unramified) at $q$ defines the angle that is missing, $\delta = (3-d_q)\pi - "
            r"\sum_{q \in F_k}\alpha_k$, and $\delta \in (0,3\pi)$."
        ),
        hypotheses=(
            r"$q$ is a boundary vertex of degree $d_q$ that satisfies (eq:unramified)",
            r"(used, not stated) this $\delta$ is another one than the angle $\delta$ of an edge",
            (
                r"(used, not stated) the formula for $\delta$ follows from $3\alpha + \sum\alpha_k "
                r"= -d_q\pi$"
            ),
        ),
        rests_on=("eq:unramified",),
        checks=(
            Check(
                name="ends-of-the-range",
                run=f"{_ANGLES}:deficit",
                routes=(
                    "printed range of the sum",
                    "three angles that close",
                ),
                mutants=(
                    Mutant(name="two-for-three", given={"high": "2"}, near=True),
                    Mutant(name="below-three-halves", given={"most": "3/2"}),
                ),
            ),
        ),
    ),
    Claim(
        id="4.corner-degree-even",
        section="4",
        where="proof on discrete surgery, line 1128",
        kind="sentence",
        statement=r"A corner vertex has even degree $d_q \ge 2$.",
        hypotheses=(r"(used, not stated) the edges at $q$ alternate between the two families",),
        rests_on=(
            "def:corner",
            "def:A-complex",
        ),
        checks=(
            Check(
                name="fans",
                run=f"{_ANGLES}:even_degree",
                routes=(
                    "families of the edges in order",
                    "shipped corners and degrees",
                ),
                mutants=(Mutant(name="odd", given={"swapped": True}, near=True),),
            ),
        ),
    ),
    Claim(
        id="4.surgery-angle",
        section="4",
        where="proof on discrete surgery, line 1128",
        kind="equation",
        statement=r"$\alpha = -\pi + \delta/3 \in (-\pi,0)$.",
        hypotheses=(r"$\delta$ is the missing angle at $q$",),
        rests_on=("4.surgery-deficit",),
        checks=(
            Check(
                name="range-and-closing",
                run=f"{_ANGLES}:angle",
                routes=(
                    "printed angle",
                    "printed interior sum of the new degree",
                ),
                mutants=(
                    Mutant(name="halves", given={"parts": "2"}, near=True),
                    Mutant(name="sign", given={"shift": "1"}),
                ),
            ),
        ),
    ),
    Claim(
        id="4.surgery-directions",
        section="4",
        where="proof on discrete surgery, line 1128",
        kind="sentence",
        statement=(
            r"$\angle\gamma_0(1)N(q)\gamma_1(1) = \alpha$ and $\angle\gamma_1(1)N(q)\gamma_2(1) = "
            r"\alpha$ determine $\gamma_1(1)$ and $\gamma_2(1)$; then "
            r"$\angle\gamma_2(1)N(q)\gamma_3(1) = \alpha$ too."
        ),
        hypotheses=(
            r"(used, not stated) $\gamma_1(1)$ and $\gamma_2(1)$ are at the edge angle from $N(q)$",
            r"(used, not stated) angles are signed by the outer normal of $S^2$",
        ),
        rests_on=(
            "4.surgery-angle",
            "4.surgery-outer-curves",
        ),
        checks=(
            Check(
                name="third-angle",
                run=f"{_SURGERY}:directions",
                routes=(
                    "three turns by the printed angle",
                    "direction of the other segment",
                ),
                mutants=(Mutant(name="halves", given={"parts": 2}, near=True),),
            ),
        ),
    ),
    Claim(
        id="4.surgery-geodesics",
        section="4",
        where="proof on discrete surgery, unlabelled formula, line 1128",
        kind="equation",
        statement=(
            r"$\gamma_i(k) = N(q)\cos(k\delta) + "
            r"\frac{\gamma_i(1)-\cos\delta\,N(q)}{\sin\delta}\sin(k\delta)$, $k = 1,2,\ldots,l_i$, "
            r"are equally spaced points on a great circle through $N(q)$ and $\gamma_i(1)$, at "
            r"steps of angle $\delta$."
        ),
        hypotheses=(
            r"$i = 1, 2$",
            (
                r"(used, not stated) $\delta$ is the edge angle, $\langle N(q),\gamma_i(1)\rangle "
                r"= \cos\delta$, and not the missing angle that the same proof calls $\delta$"
            ),
            r"(used, not stated) $0 < \delta < \pi$",
        ),
        rests_on=(
            "4.surgery-directions",
            "4.edge-angle",
        ),
        checks=(
            Check(
                name="any-step",
                run=f"{_ANGLES}:geodesics",
                routes=(
                    "printed points for any k",
                    "shipped geodesic, inner products",
                ),
                mutants=(
                    Mutant(name="nothing-subtracted", given={"subtracted": 0}, near=True),
                    Mutant(name="missing-angle", given={"angle": "missing"}),
                ),
            ),
        ),
    ),
    Claim(
        id="4.surgery-closes-corner",
        section="4",
        where="proof on discrete surgery, line 1130",
        kind="sentence",
        statement=(
            r"With three new sectors of angle $\alpha$ the vertex $q$ is an interior vertex of "
            r"degree $d_q+2$ that satisfies (eq:unramified)."
        ),
        rests_on=(
            "eq:unramified",
            "4.surgery-angle",
            "4.surgery-directions",
            "4.corner-degree-even",
        ),
        checks=(
            Check(
                name="degree-and-sum",
                run=f"{_SURGERY}:closes_corner",
                tier="full",
                routes=(
                    "surgery in balls",
                    "printed interior sum of the new degree",
                ),
                mutants=(
                    Mutant(name="halves", given={"parts": 2}, near=True),
                    Mutant(name="degree-plus-4", given={"added": 4}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="4.surgery-changes-nothing-else",
        section="4",
        where="proof on discrete surgery, line 1130",
        kind="sentence",
        statement=(
            r"Discrete surgery makes no branch point other than $q$ and leaves the net at existing "
            r"branch points as it was."
        ),
        hypotheses=(
            (
                r"(used, not stated) every boundary vertex inside $\gamma_u$ or $\gamma_v$ has "
                r"degree $3$; one of higher odd degree becomes a branch point"
            ),
        ),
        rests_on=("4.surgery-closes-corner",),
        checks=(
            Check(
                name="any-corner",
                run=f"{_SURGERY}:changes_nothing_else",
                routes=(
                    "branch points after surgery",
                    "branch points before",
                ),
                mutants=(Mutant(name="corner-too", given={"corner_too": True}),),
            ),
            Check(
                name="inner-vertices-of-degree-3",
                run=f"{_SURGERY}:changes_nothing_else",
                form="corrected",
                given={"inner_degree": "3"},
                routes=(
                    "branch points after surgery",
                    "branch points before",
                ),
                mutants=(
                    Mutant(name="any-corner", given={"inner_degree": "any"}),
                    Mutant(name="corner-too", given={"corner_too": True}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"no further branch points are introduced",
            corrected=r"none are, if every vertex inside $\gamma_u$ and $\gamma_v$ has degree $3$",
            kind="hypothesis",
            witness=(
                r"four of the six sectors of a star of order $3$ with two edges on each ray: its "
                r"centre has degree $5$ and lies inside the boundary segment of two $u$-rays. "
                r"Surgery at the end of that segment makes the centre an interior vertex of degree "
                r"$6$, $m = 3$"
            ),
            conclusion_survives=True,
            remark=(
                r"the new net meets (eq:unramified) nevertheless. Branch points are interior, as "
                r"in definition (def:branched_immersion); if boundary vertices of degree above $4$ "
                r"counted too, the centre would be an old one, but then surgery makes one of every "
                r"far end of degree $4$: five rhombi, of angle $0.5\pi$ at $q$ and two of $0.4\pi$ "
                r"more at each neighbour, have two such ends, and the new net meets (eq:unramified)"
            ),
        ),
    ),
)
