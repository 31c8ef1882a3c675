"""Claims of section 6, the discussion."""

from checks.claim import Check, Citation, Claim, Erratum, Mutant

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
            corrected=(
                "so in the Poincare disk, where circles about the centre have one size; on the "
                "surface itself sister branch points are farther apart in the third generation of "
                "parents than in the second, and later about as far"
            ),
            kind="ambiguous",
            witness=(
                "$R = 10$, $\\phi_0 = \\pi/4$, $\\phi^* = 4\\pi/5$: median distances of sisters on "
                "the surface 0.81, 1.22, 1.73, 1.92, 1.97 for parents of generations 2 to 6; in "
                "the disk each is less than the last, by a factor of 0.26 to 0.50 at first"
            ),
            conclusion_survives=True,
            remark="Measured on runs of the greedy algorithm; that they are optimal is not known.",
        ),
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
        checks=(
            Check(
                name="printed",
                run="checks.verify.finite_pieces:finite_piece",
                routes=(
                    "first form of Dini's surfaces",
                    "closed surface of genus 2 from a regular octagon",
                ),
                mutants=(Mutant(name="strip too narrow", given={"slack": -1}),),
            ),
            Check(
                name="disks of curvature -1",
                run="checks.verify.finite_pieces:finite_piece",
                tier="full",
                form="corrected",
                given={"closed": False},
                routes=("first form of Dini's surfaces", "strips of H^2 along a geodesic"),
                mutants=(
                    Mutant(name="closed surfaces too", given={"closed": True}),
                    Mutant(name="strip narrower than the disk", given={"slack": -1}),
                    Mutant(name="surface of revolution", given={"pitch": 0}),
                ),
            ),
        ),
        erratum=Erratum(
            printed="every bounded part of a smooth hyperbolic surface is embedded",
            corrected=(
                "simply connected bounded parts are: embedded if $K = -1$, immersed by the theorem "
                "of Hong for variable curvature"
            ),
            kind="ambiguous",
            witness=(
                "the closed surface of genus $2$ and curvature $-1$ is bounded; in three-space it "
                "would have $K > 0$ where it is farthest from the origin"
            ),
            conclusion_survives=True,
            remark="As in (3.bounded-embeds).",
        ),
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
        checks=(
            Check(
                name="crossing",
                run="checks.verify.bobbin_disk:balance",
                part="competition",
                routes=("balance of the two curvatures", "theory.bobbin:largest_on_disk"),
                mutants=(
                    Mutant(name="exp R", given={"function": "exp"}),
                    Mutant(name="kappa 1% more", given={"factor": "101/100"}, near=True),
                ),
            ),
            Check(
                name="no stretching",
                run="checks.verify.bobbin_metric:profile",
                part="isometry",
                routes=("printed radius", "theory.surface_of_revolution:gauss_curvature"),
                mutants=(
                    Mutant(name="cosh 2s", given={"rate": 2}),
                    Mutant(name="speed squared 2", given={"total": 2}),
                ),
            ),
        ),
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
        citation=Citation(
            source="conjecture of the paper",
            reason="(e2) and (ebs): infima over all immersions of a disk",
        ),
        checks=(
            Check(
                name="runs grow by less",
                run="checks.verify.greedy_growth:sub_exponential",
                form="support",
                routes=("energies in the limit of edge length 0", "interval of the best power"),
                mutants=(
                    Mutant(name="power 3/4", given={"rival": "3/4"}, near=True),
                    Mutant(name="power 1/2", given={"rival": "1/2"}),
                ),
            ),
            Check(
                name="smooth immersions from below",
                run="checks.verify.energy_scaling:rectangle_bound",
                form="support",
                routes=("alternating sum over a square", "distance along asymptotic lines"),
                mutants=(Mutant(name="square 2 % larger", given={"half": "51/100"}, near=True),),
            ),
        ),
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
        checks=(
            Check(
                name="smooth line",
                run="checks.verify.energy_scaling:bobbin_scaling",
                part="smooth",
                routes=("printed R", "theory.bobbin:largest_on_disk"),
                mutants=(
                    Mutant(name="root of R", given={"power": "1/2"}),
                    Mutant(name="R^(11/10)", given={"power": "11/10"}, near=True),
                ),
            ),
            Check(
                name="branched line",
                run="checks.verify.greedy_growth:energy_law",
                tier="full",
                part="branched",
                routes=("energies in the limit", "AIC of the laws"),
                mutants=(
                    Mutant(name="R^(2/5)", given={"power": "2/5"}, near=True),
                    Mutant(name="R^(1/10)", given={"power": "1/10"}),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="quotient of the two scalings",
                run="checks.verify.energy_scaling:separation",
                routes=("printed exponents", "limit for any two constants"),
                mutants=(
                    Mutant(name="equal powers", given={"power": "1"}),
                    Mutant(name="R^(11/10)", given={"power": "11/10"}, near=True),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="quotient of the two scalings",
                run="checks.verify.energy_scaling:separation",
                routes=("printed exponents", "limit for any two constants"),
                mutants=(
                    Mutant(name="equal powers", given={"power": "1"}),
                    Mutant(name="R^(11/10)", given={"power": "11/10"}, near=True),
                ),
            ),
        ),
    ),
)
