"""Claims of section 6, the discussion."""

from checks.claim import Check, Citation, Claim, Mutant

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="6.no-stretching-energy",
        section="6",
        where="section 6, line 1593",
        kind="sentence",
        statement=(
            "Branch points change the shape of a hyperbolic surface of class $C^{1,1}$ without "
            "concentrating stretching energy: the metric is $K = -1$ up to the branch point."
        ),
        rests_on=("prop:assembly", "def:branched_immersion"),
        checks=(
            Check(
                name="strain of a rhombus",
                run="checks.verify.quad_strain:uniform_strain",
                routes=(
                    "diagonals of Lelieuvre's quads, in a field of fractions",
                    "diagonals of half-turns of H^2",
                ),
                mutants=(
                    Mutant(name="cosh^2", given={"cosh_power": 2}),
                    Mutant(name="order 3", given={"order": 3}, near=True),
                    Mutant(name="order 1", given={"order": 1}, near=True),
                ),
            ),
            Check(
                name="strain at branch points",
                run="checks.verify.announced_nets:no_stretching",
                routes=(
                    "diagonals of rhombi of H^2",
                    "diagonals of the quads of Lelieuvre's surface",
                ),
                mutants=(
                    Mutant(name="order 1", given={"order": 1}, near=True),
                    Mutant(name="order 3", given={"order": 3}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="6.1-complex-encodes-topology",
        section="6",
        where="section 6, result 1, line 1597",
        kind="item",
        statement=(
            "The asymptotic complex records how asymptotic lines meet and, in the degree $2m_p$ "
            "of a vertex, how the normal map is ramified: $J_p = 1 - m_p$."
        ),
        rests_on=("def:A-complex", "lem:covering-number"),
        checks=(
            Check(
                name="normal and lines in space",
                run="checks.verify.robust_index:encoded",
                tier="full",
                routes=(
                    "degrees and fans of the complex",
                    "winding of the normal and bearings of the edges of Lelieuvre's surface",
                ),
                mutants=(
                    Mutant(name="J = 2 - m", given={"offset": 2}, near=True),
                    Mutant(name="J = 1 - 2 m", given={"halves": 2}),
                ),
            ),
        ),
    ),
    Claim(
        id="6.2-index-is-robust",
        section="6",
        where="section 6, result 2, line 1598",
        kind="item",
        statement="Branch points carry a topological index that is robust.",
        hypotheses=(
            (
                r"(used, not stated) under $W^{2,2}_{\mathrm{loc}}$ limits of $C^2$ immersions "
                "with bounded curvatures"
            ),
        ),
        rests_on=("thm:branched", "def:Jp"),
        citation=Citation(
            source="(thm:branched), in the form of 3.3.degree-stable",
            reason="that the index stays under all such limits is analysis; the distance that the "
            "normals keep and the indices of stars and smooth saddles are decided by computer",
        ),
        checks=(
            Check(
                name="index of a limit",
                form="support",
                run="checks.verify.robust_index:limit_index",
                routes=(
                    "degrees of loops in balls",
                    "indices of stars and of smooth saddles",
                ),
                mutants=(
                    Mutant(name="loops 1 % farther apart", given={"percent": 101}, near=True),
                    Mutant(
                        name="the bound on the collar 1 % above s",
                        given={"share": "101/100"},
                        near=True,
                    ),
                ),
            ),
        ),
    ),
    Claim(
        id="6.3-generalised-sine-gordon",
        section="6",
        where="section 6, result 3, line 1599",
        kind="item",
        statement="The sine-Gordon equation has a generalisation to surfaces with branch points.",
        rests_on=("thm:sg-branched",),
        checks=(
            Check(
                name="with and without branch points",
                run="checks.verify.discussion:generalised",
                routes=(
                    "printed charges and the limit of small rectangles",
                    "angles at the centre of stars, exact ranks on random tilings",
                ),
                mutants=(
                    Mutant(name="m - 3 for m - 2", given={"regular": 3}, near=True),
                    Mutant(name="opposite charge", given={"sign": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="6.3-distributed-branch-points",
        section="6",
        where="section 6, result 3, line 1599",
        kind="sentence",
        statement=(
            "It shows why branch points are distributed when the bending energy of isometries "
            r"is optimised: $\varphi$ near $\pi/2$ asks for one branch point in an area of about "
            r"$\pi$."
        ),
        hypotheses=("(used, not stated) each branch point has $m = 3$",),
        rests_on=("6.3-generalised-sine-gordon", "rmk:distributed"),
        checks=(
            Check(
                name="one for each area pi",
                run="checks.verify.discussion:distributed",
                routes=(
                    "printed area for each branch point",
                    "angles at the centre of stars, signs on random tilings",
                ),
                mutants=(
                    Mutant(name="order 4", given={"order": 4}, near=True),
                    Mutant(name="area 1.01 pi", given={"percent": 101}, near=True),
                    Mutant(name="0.99 delta a vertex", given={"per_vertex": 99}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="6.4-net-for-the-deformation",
        section="6",
        where="section 6, result 4, line 1600",
        kind="item",
        statement=(
            "The hyperbolic Chebyshev net gives the deformation from material to laboratory "
            "frame and encodes the asymptotic complex with its branch points."
        ),
        rests_on=("4.1.hyperbolic-chebyshev-net", "4.1.deformation-composite"),
        checks=(
            Check(
                name="complex from places",
                run="checks.verify.announced_nets:encodes_complex",
                tier="full",
                part="complex",
                routes=(
                    "places of the quads in the disk",
                    "combinatorial surgery",
                ),
                mutants=(
                    Mutant(name="one surgery fewer", given={"dropped": 1}, near=True),
                    Mutant(name="places to whole numbers", given={"digits": 0}),
                ),
            ),
            Check(
                name="deformation",
                run="checks.verify.net_deformation:composite",
                tier="full",
                part="deformation",
                routes=(
                    "half-turns of triples of H^2",
                    "discrete.lelieuvre on half-turns of S^2",
                ),
                mutants=(
                    Mutant(name="a net with reversals", given={"folded": True}),
                    Mutant(name="angles 1 % larger", given={"percent": 101}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="6.4-distinguishes-classes",
        section="6",
        where="section 6, result 4, line 1600",
        kind="sentence",
        statement=(
            "The net tells $C^{1,1}$ immersions with branch points from $C^2$ immersions: "
            "degrees above $4$ occur exactly in the first."
        ),
        hypotheses=(
            (
                "(used, not stated) a $C^{1,1}$ immersion without branch points is not told "
                "apart by degrees"
            ),
        ),
        rests_on=("6.4-net-for-the-deformation", "4.1.branch-point-degree"),
        checks=(
            Check(
                name="degrees and classes",
                run="checks.verify.announced_nets:distinguishes",
                tier="full",
                routes=(
                    "degree in the complex of the net",
                    "Hessians of saddles over stars",
                ),
                mutants=(
                    Mutant(name="degree 4", given={"least": 4}, near=True),
                    Mutant(name="degree 8", given={"least": 8}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="6.5-slower-growth",
        section="6",
        where="section 6, result 5, line 1601",
        kind="item",
        statement=(
            "On the surfaces of the greedy algorithm the maximal curvature grows more slowly "
            "with the size of the domain than on $C^2$ immersions."
        ),
        hypotheses=("(used, not stated) against the bobbins, the best $C^2$ immersions known",),
        rests_on=("alg:greedy-cuts", "fig:energywithradius"),
        waits_for=("5",),
    ),
    Claim(
        id="item:motivation",
        section="6",
        where="section 6, result 6 (item:motivation), line 1602",
        kind="item",
        statement=(
            "In numerical runs branched surfaces stay below smooth ones in energy by a gap; the "
            "patterns of branch points that it leads to are recursive and self-similar."
        ),
        labels=("item:motivation",),
        hypotheses=(r"$R \leq 10$",),
        rests_on=("fig:energywithradius", "fig:numerical_crochet"),
        waits_for=("5", "5.1"),
    ),
    Claim(
        id="6.bounded-subsets-embed",
        section="6",
        where="section 6, line 1605",
        kind="sentence",
        statement=(
            "Every bounded part of a smooth hyperbolic surface has a smooth isometric embedding "
            r"in $\mathbb{R}^3$."
        ),
        hypotheses=(
            (
                "(used, not stated) the subset is a simply connected surface, such as a disk in "
                "the plane with negative curvature: a closed hyperbolic surface is bounded and "
                "has none"
            ),
        ),
        rests_on=("3.bounded-embeds",),
    ),
    Claim(
        id="6.global-competition",
        section="6",
        where="section 6, line 1605",
        kind="sentence",
        statement=(
            "What shapes a free hyperbolic sheet is one principal curvature against the other "
            "over the whole sheet, not stretching against bending."
        ),
        hypotheses=("as in the example of Minding's bobbin",),
        rests_on=("ex:bobbin", "eq:c2energy"),
    ),
    Claim(
        id="eq:conjecture",
        section="6",
        where="conjecture (eq:conjecture), line 1610",
        kind="equation",
        statement=(
            r"$\log\inf_{y : B_R \to \mathbb{R}^3}\kappa_{\max} \sim R$ over isometries of class "
            r"$C^2$ or smoother, and $\sim \sqrt{R}$ over branched isometries of class "
            "$C^{1,1}$."
        ),
        labels=("eq:conjecture",),
        hypotheses=(
            "$K = -1$, $B_R$ a geodesic disk of radius $R$",
            "conjectured",
            (
                r"(used, not stated) $R \geq R_0 > 0$: as $R \to 0$ the infimum tends to $1$ and "
                "its logarithm is of order $R^2$ at most"
            ),
        ),
        rests_on=("e2", "ebs", "5.scaling-symbol"),
        waits_for=("5", "5.1"),
    ),
    Claim(
        id="6.evidence",
        section="6",
        where="section 6, line 1614",
        kind="sentence",
        statement=(
            "The data of the figure (fig:energywithradius) are evidence for both lines of "
            "(eq:conjecture)."
        ),
        hypotheses=(r"$R \leq 10$",),
        rests_on=("eq:conjecture", "fig:energywithradius"),
        waits_for=("5",),
    ),
    Claim(
        id="6.branched-preferred",
        section="6",
        where="section 6, line 1616",
        kind="sentence",
        statement=(
            "If (eq:conjecture) is true, isometries with distributed branch points have less "
            "energy than smooth ones on all large enough disks."
        ),
        hypotheses=("(eq:conjecture)",),
        rests_on=("eq:conjecture",),
    ),
    Claim(
        id="6.lavrentiev",
        section="6",
        where="section 6, line 1616",
        kind="sentence",
        statement=(
            "The gap in (eq:conjecture) is an instance of the Lavrentiev phenomenon: the infimum "
            "over $C^2$ isometries is strictly above that over $C^{1,1}$ isometries."
        ),
        hypotheses=(
            "(eq:conjecture)",
            "(used, not stated) $R$ is large enough",
            "(used, not stated) each class contains the smoother one",
        ),
        rests_on=("eq:conjecture",),
    ),
)
