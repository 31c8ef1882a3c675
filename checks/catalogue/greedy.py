"""Claims of section 4.1, the greedy algorithm: its result, termination and covering."""

from checks.claim import Check, Citation, Claim, Erratum, Mutant

_SMALL = (
    r"(used, not stated) $\Delta$ is small against the distance of the cut from the axes, so "
    r"that $j^*, k^* \geq 1$"
)

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="alg:greedy-cuts",
        section="4.1",
        where="algorithm (alg:greedy-cuts), lines 1300-1333",
        kind="algorithm",
        statement=(
            r"From $R$, $m$, $\phi^*$ and $\Delta$ the greedy algorithm makes a branched "
            r"hyperbolic Chebyshev net that covers the disk of radius $R$, with $\varphi \leq "
            r"\phi^*$ at every node, and its $K$-surface."
        ),
        labels=("alg:greedy-cuts", "algorithm1"),
        hypotheses=(
            r"$M = 2m \geq 4$, $\phi^* \in (\pi/m, \pi)$",
            (
                r"(used, not stated) $\varphi$ is measured without sign: (eq:angle) as printed "
                r"is negative in the sectors $\Omega_{M+2}$, whose $v$-axis lies clockwise of "
                "the $u$-axis"
            ),
            _SMALL,
            "(used, not stated) the repetition ends",
        ),
        checks=(
            Check(
                name="to the letter",
                run="checks.verify.printed_result:covers",
                routes=("the algorithm in the disk", "random points of the disk"),
                mutants=(Mutant(name="as meant but step 5", given={"variant": "fill"}, near=True),),
            ),
            Check(
                name="as meant, up to an edge from the rim",
                run="checks.verify.printed_result:covers",
                tier="full",
                form="corrected",
                given={"variant": "meant", "short": "1"},
                routes=("the algorithm in the disk", "random points of the disk"),
                mutants=(
                    Mutant(name="up to the rim", given={"short": "0"}, near=True),
                    Mutant(name="0.95 phi*", given={"level": "19/20"}, near=True),
                    Mutant(name="the sign of (eq:angle)", given={"variant": "sign"}),
                    Mutant(name="principal arguments", given={"variant": "argument"}),
                    Mutant(name="discards by place", given={"variant": "discard"}),
                ),
            ),
            Check(
                name="as discrete.greedy runs it, edges of length 0.01",
                run="checks.verify.greedy_cover:disk_cover",
                form="support",
                tier="full",
                routes=(
                    "kept quads of discrete.greedy",
                    "area of the disk in closed form",
                    "random points",
                ),
                mutants=(
                    Mutant(
                        name="0.1 % more area",
                        given={"share": "1001/1000", "points": 1000},
                        near=True,
                    ),
                    Mutant(name="20 cuts at most", given={"most": 20, "points": 1000}),
                ),
            ),
        ),
        erratum=Erratum(
            printed="steps 5, 8, 16 and 22 as they stand, for the disk of radius $R$",
            corrected=(
                "$1 \\leq j, k \\leq N$ in step 5; $|\\varphi|$ in steps 8 to 25; $\\varphi_1 = "
                "\\arg w_1 + \\frac13 \\arg(w_2/w_1)$ and $\\varphi_2 = \\arg w_1 + \\frac23 "
                "\\arg(w_2/w_1)$ in step 16; discarded predecessors count as outside in steps 6 "
                "and 20; the disk of radius $R - \\Delta$ is covered"
            ),
            kind="misprint",
            witness=(
                "$R = 3$, $\\Delta = 1/10$, $m = 2$, $\\phi^* = 3\\pi/4$: to the letter no angle "
                "exceeds $\\phi^*$ and more than 99 % of the disk lie in no quad; with step 5 "
                "mended the sign lets an angle of $0.99\\pi$ pass, the principal arguments leave "
                "65 % uncovered, the discards by place never come to an end"
            ),
            conclusion_survives=True,
            remark=(
                "With all lines mended the cuts are those of discrete.greedy, number for number, "
                "which also keeps the quads that the rim crosses."
            ),
        ),
        rests_on=(
            "4.1.algorithm-27-k-surface",
            "poincare-ddg",
            "eq:angle",
            "eq:trisect",
            "eq:poincare-surgery",
        ),
    ),
    Claim(
        id="4.1.algorithm-26-quadgraph",
        section="4.1",
        where="algorithm (alg:greedy-cuts), step 26, line 1329",
        kind="algorithm",
        statement=(
            "$Q$ is the quadgraph of the hyperbolic Chebyshev net formed by all "
            r"$\zeta^n_{j,k}$, nodes on common axes being one node."
        ),
        hypotheses=("(used, not stated) nodes are taken without those excised or discarded",),
        checks=(
            Check(
                name="V - E + F and degrees",
                run="checks.verify.printed_result:quadgraph",
                tier="full",
                routes=("the algorithm in the disk", "Euler characteristic and degrees"),
                mutants=(
                    Mutant(name="axes not shared", given={"share": False}, near=True),
                    Mutant(name="degree 8", given={"degree": 8}),
                    Mutant(name="discards by place", given={"variant": "discard"}),
                ),
            ),
        ),
        rests_on=("4.1.algorithm-07-sector", "4.1.hyperbolic-chebyshev-net"),
    ),
    Claim(
        id="4.1.algorithm-27-k-surface",
        section="4.1",
        where="algorithm (alg:greedy-cuts), step 27, line 1330",
        kind="algorithm",
        statement=(
            r"A $K$-surface $r : Q \to \mathbb{R}^3$ is built from the side lengths and angles "
            "of the net."
        ),
        checks=(
            Check(
                name="stars",
                run="checks.verify.printed_surface:surface",
                routes=("K-surface of discrete.greedy_net", "lengths and angles in the disk"),
                mutants=(
                    Mutant(
                        name="a vertex lifted by 1 % of an edge", given={"lift": "1/100"}, near=True
                    ),
                    Mutant(name="angles 1 % larger", given={"scale": "101/100"}, near=True),
                ),
            ),
        ),
        rests_on=("4.1.algorithm-26-quadgraph", "4.1.planar-stars"),
    ),
    Claim(
        id="4.1.arbitrarily-large-disks",
        section="4.1",
        where="section 4.1, line 1299",
        kind="sentence",
        statement=(
            "Repeated surgery gives branched isometric immersions of geodesic disks of every "
            "radius."
        ),
        hypotheses=(
            "(read so) on the radii looked at, up to 10: a proof for all is not known",
            "(used, not stated) for every $R$ the algorithm ends",
        ),
        checks=(
            Check(
                name="stored runs",
                run="checks.verify.greedy_tree_shape:runs_to_ten",
                routes=("stored runs", "area of the disk in closed form"),
                mutants=(
                    Mutant(name="1 % more area", given={"covered": "101/100"}, near=True),
                    Mutant(name="100 cuts", given={"cuts": 100}),
                ),
            ),
        ),
        rests_on=("alg:greedy-cuts",),
    ),
    Claim(
        id="fig:surgery",
        section="4.1",
        where="figure (fig:surgery), lines 1334-1359",
        kind="figure",
        statement=(
            "The last step in pictures: rhombi of the net in the disk go to skew rhombi of "
            r"$\mathbb{R}^3$, which make up the discrete surface."
        ),
        labels=("fig:surgery",),
        checks=(
            Check(
                name="rhombi in space",
                run="checks.verify.printed_surface:surface",
                routes=("K-surface of discrete.greedy_net", "lengths and angles in the disk"),
                mutants=(
                    Mutant(
                        name="a vertex lifted by 1 % of an edge", given={"lift": "1/100"}, near=True
                    ),
                    Mutant(name="angles 1 % larger", given={"scale": "101/100"}, near=True),
                ),
            ),
        ),
        rests_on=("4.1.algorithm-27-k-surface",),
    ),
    Claim(
        id="4.1.branch-point-neighbourhood",
        section="4.1",
        where="section 4.1, line 1361",
        kind="sentence",
        statement=(
            "Each branch point lies in the interior of the union of four sectors: the one that "
            "was cut and the three attached there."
        ),
        hypotheses=(
            "the branch point is not the origin",
            _SMALL,
            (
                "(used, not stated) the sectors are numbered by the branch point, which is not "
                "the numbering of the algorithm"
            ),
        ),
        checks=(
            Check(
                name="points around each branch point",
                run="checks.verify.printed_result:around_branch_points",
                tier="full",
                routes=("the algorithm in the disk", "random points"),
                mutants=(
                    Mutant(name="without the parent", given={"left_out": "parent"}),
                    Mutant(name="without one daughter", given={"left_out": "v"}, near=True),
                ),
            ),
        ),
        rests_on=("alg:greedy-cuts",),
    ),
    Claim(
        id="4.1.finite-if-covered",
        section="4.1",
        where="section 4.1, line 1361",
        kind="sentence",
        statement=(
            "If the sectors cover the closed disk, there are finitely many branch points, "
            "because the disk is compact."
        ),
        hypotheses=(
            (
                "(used, not stated) finitely many sectors cover, or branch points do not "
                "accumulate on the common boundary of sectors"
            ),
        ),
        citation=Citation(
            source="compactness of the closed disk (Heine and Borel)",
            reason=(
                "an argument about all coverings; as printed it has a gap, which the hypothesis "
                "names: the open sets around the branch points need not cover the disk"
            ),
        ),
        rests_on=("4.1.branch-point-neighbourhood",),
    ),
)
