"""Claims of section 6, the discussion: its list of results."""

from checks.claim import Check, Citation, Claim, Erratum, Mutant

CLAIMS: tuple[Claim, ...] = (
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
        checks=(
            Check(
                name="below the bobbins",
                run="checks.verify.energy_figure:below",
                routes=(
                    "finest stored nets and the limit of edge length 0",
                    "theory.bobbin_values (balls)",
                ),
                mutants=(
                    Mutant(name="from R = 5/2 on", given={"lowest": "5/2"}, near=True),
                    Mutant(name="runs a quarter more", given={"factor": "5/4"}),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="gap to the bobbins",
                run="checks.verify.energy_figure:below",
                part="gap",
                routes=(
                    "finest stored nets and the limit of edge length 0",
                    "theory.bobbin_values (balls)",
                ),
                mutants=(
                    Mutant(name="from R = 5/2 on", given={"lowest": "5/2"}, near=True),
                    Mutant(name="runs a quarter more", given={"factor": "5/4"}),
                ),
            ),
            Check(
                name="one branch point against all smooth isometries",
                run="checks.verify.energy_gap:energy_gap",
                form="support",
                routes=(
                    "theory.periodic_amsler (balls)",
                    "alternating sum of phi over an inscribed square (theory.inscribed_square)",
                ),
                mutants=(
                    Mutant(name="lower by 1 %", given={"share": "99/100"}, near=True),
                    Mutant(name="square 1 % larger", given={"stretch": "101/100"}, near=True),
                    Mutant(name="four sectors", given={"sectors": 4}),
                    Mutant(name="ten sectors", given={"sectors": 10}),
                ),
            ),
            Check(
                name="three daughters each",
                run="checks.verify.branch_point_scales:recursion",
                tier="full",
                part="recursive",
                routes=("branch points of runs", "powers of three"),
                mutants=(
                    Mutant(name="two", given={"daughters": 2}, near=True),
                    Mutant(name="five generations", given={"until": 5}, near=True),
                ),
            ),
            Check(
                name="on the surface",
                run="checks.verify.branch_point_scales:smaller_scales",
                tier="full",
                part="self-similar",
                routes=("distances on the hyperboloid", "order of the generations"),
                mutants=(
                    Mutant(name="from the first generation on", given={"first": 1}, near=True),
                    Mutant(name="to nine tenths", given={"most": "9/10"}, near=True),
                ),
            ),
            Check(
                name="in the Poincare disk",
                run="checks.verify.branch_point_scales:smaller_scales",
                tier="full",
                form="corrected",
                given={"metric": "disk"},
                part="self-similar",
                routes=("distances in the disk", "order of the generations"),
                mutants=(
                    Mutant(
                        name="from the first generation on",
                        given={"metric": "disk", "first": 1},
                        near=True,
                    ),
                    Mutant(
                        name="to nine tenths", given={"metric": "disk", "most": "9/10"}, near=True
                    ),
                    Mutant(name="on the surface", given={"metric": "surface"}),
                ),
            ),
        ),
        erratum=Erratum(
            printed="the pattern repeats itself on smaller and smaller scales",
            corrected="so in the Poincare disk, not on the surface itself",
            kind="ambiguous",
            witness="as in (abstract.fractal)",
            conclusion_survives=True,
        ),
    ),
)
