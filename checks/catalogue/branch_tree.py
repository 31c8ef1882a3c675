"""Claims of section 5.1, the tree of branch points: its shape, size and depth."""

from checks.claim import Check, Claim, Erratum, Mutant

_COUNT = "checks.verify.branch_count:"

_TREE = r"$R = 4$, $\phi_0 = \pi/2$, $\phi^* = 3\pi/4$"

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="5.1.runs-to-radius-10",
        section="5.1",
        where="section 5.1, line 1466",
        kind="sentence",
        statement=(
            r"The greedy algorithm runs to the end on disks of radius $R \leq 10$ for several "
            r"initial angles $\phi_0$ and cutoffs $\phi^*$."
        ),
        hypotheses=(r"(used, not stated) $\phi_0 = \pi/m$; the values are not listed",),
        checks=(
            Check(
                name="stored runs",
                run="checks.verify.greedy_tree_shape:runs_to_ten",
                routes=("stored runs", "area of the disk in closed form"),
                mutants=(
                    Mutant(name="1 % more area", given={"covered": "101/100"}, near=True),
                    Mutant(name="0.99 phi*", given={"level": "99/100"}, near=True),
                    Mutant(name="100 cuts", given={"cuts": 100}),
                ),
            ),
        ),
        rests_on=("alg:greedy-cuts",),
    ),
    Claim(
        id="fig:branch-tree",
        section="5.1",
        where="figure (fig:branch-tree), lines 1466-1473 and 1490",
        kind="figure",
        statement=(
            "The branch points in a disk of radius $4$, with lines from parents to daughters: "
            "four generations."
        ),
        labels=("fig:branch-tree",),
        hypotheses=(_TREE, r"(used, not stated) $\Delta$ is not given"),
        checks=(
            Check(
                name="generations of branch points",
                run="checks.verify.greedy_tree_shape:generations",
                routes=(
                    "nets of four edge lengths",
                    "limit of edge length 0 (theory.greedy_limit)",
                ),
                mutants=(Mutant(name="five", given={"number": 5}, near=True),),
            ),
            Check(
                name="with the centre",
                run="checks.verify.greedy_tree_shape:generations",
                form="corrected",
                given={"origin": True},
                routes=(
                    "nets of four edge lengths",
                    "limit of edge length 0 (theory.greedy_limit)",
                ),
                mutants=(
                    Mutant(name="five", given={"number": 5}, near=True),
                    Mutant(name="R = 9/2", given={"radius": "9/2"}),
                ),
            ),
        ),
        erratum=Erratum(
            printed="4 generations of branch points in the disk of radius 4",
            corrected=(
                "4 generations with the centre, which is no branch point for $m = 2$; 3 "
                "generations of $4 + 12 + 24$ branch points"
            ),
            kind="ambiguous",
            witness=(
                "$4 + 12 + 24$ branch points in $3$ generations for the edge lengths $1/25, "
                "1/50, 1/100, 1/200$ and in the limit $0$"
            ),
            conclusion_survives=True,
            remark="A fourth generation needs a larger disk, such as that of radius $9/2$.",
        ),
        rests_on=("alg:greedy-cuts",),
    ),
    Claim(
        id="5.1.unique-parent",
        section="5.1",
        where="section 5.1, line 1466",
        kind="sentence",
        statement="Each branch point has one parent, so that the branch points form a tree.",
        hypotheses=(
            "(used, not stated) rooted at the origin, which is no branch point when $m = 2$",
        ),
        checks=(
            Check(
                name="paths and places",
                run="checks.verify.greedy_tree_shape:one_parent",
                routes=("paths of the tree", "places on the hyperboloid"),
                mutants=(
                    Mutant(name="edge length 1/3", given={"step": "1/3"}),
                    Mutant(name="grandparent", given={"dropped": 2}, near=True),
                ),
            ),
        ),
        rests_on=("alg:greedy-cuts",),
    ),
    Claim(
        id="5.1.at-most-three-daughters",
        section="5.1",
        where="section 5.1, lines 1466 and 1585",
        kind="sentence",
        statement="No branch point but the origin has more than three daughters.",
        hypotheses=("(used, not stated) a sector is cut at most once",),
        checks=(
            Check(
                name="counted",
                run="checks.verify.greedy_tree_shape:daughters",
                routes=("branch points of whole disks", "three sectors at a cut"),
                mutants=(
                    Mutant(name="two", given={"most": 2}, near=True),
                    Mutant(name="the centre too", given={"origin": True}),
                ),
            ),
        ),
        rests_on=("5.1.unique-parent", "4.1.algorithm-14-excise"),
    ),
    Claim(
        id="5.1.leaves-at-different-depths",
        section="5.1",
        where="section 5.1, line 1466",
        kind="sentence",
        statement="Not all leaves of the tree belong to one generation.",
        hypotheses=(_TREE,),
        checks=(
            Check(
                name="R = 4",
                run="checks.verify.greedy_tree_shape:leaves",
                routes=(
                    "nets of four edge lengths",
                    "limit of edge length 0 (theory.greedy_limit)",
                ),
                mutants=(
                    Mutant(name="R = 3", given={"radius": "3"}, near=True),
                    Mutant(name="R = 2", given={"radius": "2"}),
                ),
            ),
            Check(
                name="R = 5",
                run="checks.verify.greedy_tree_shape:leaves",
                form="corrected",
                given={"radius": "5"},
                routes=(
                    "nets of four edge lengths",
                    "limit of edge length 0 (theory.greedy_limit)",
                ),
                mutants=(
                    Mutant(name="R = 9/2", given={"radius": "9/2"}, near=True),
                    Mutant(name="R = 2", given={"radius": "2"}),
                ),
            ),
        ),
        erratum=Erratum(
            printed="the leaves of the tree of radius 4 are at different depths",
            corrected=(
                "so for $R = 5$; for $R = 4$ all $24$ leaves are in the third generation, for "
                "$R = 9/2$ all are in the fourth"
            ),
            kind="hypothesis",
            witness=(
                "$R = 4$, $\\phi_0 = \\pi/2$, $\\phi^* = 3\\pi/4$: each of the $4 + 12$ branch "
                "points of the first two generations has daughters, none of the $24$ of the "
                "third has, for four edge lengths and in the limit"
            ),
            conclusion_survives=True,
            remark="",
        ),
        rests_on=("fig:branch-tree",),
    ),
    Claim(
        id="5.1.amsler-nodes-farther",
        section="5.1",
        where="section 5.1, line 1466",
        kind="sentence",
        statement=(
            "Successive Amsler nodes, on the diagonals, are typically farther apart than "
            "successive pseudo-Amsler nodes."
        ),
        hypotheses=(
            _TREE,
            "(used, not stated) typically is not made precise: read as a comparison of means",
        ),
        checks=(
            Check(
                name="with the way from the centre",
                run="checks.verify.greedy_tree_shape:amsler_nodes",
                routes=("distances on the hyperboloid", "four edge lengths"),
                mutants=(Mutant(name="1 % less", given={"share": "99/100"}, near=True),),
            ),
            Check(
                name="without it",
                run="checks.verify.greedy_tree_shape:amsler_nodes",
                form="corrected",
                given={"origin": False},
                routes=("distances on the hyperboloid", "four edge lengths"),
                mutants=(
                    Mutant(name="1 % less", given={"share": "99/100"}, near=True),
                    Mutant(name="nine tenths", given={"share": "9/10"}),
                ),
            ),
        ),
        erratum=Erratum(
            printed="successive Amsler nodes are farther apart than pseudo-Amsler nodes",
            corrected="so in the mean if the way from the centre to the first node is left out",
            kind="ambiguous",
            witness=(
                "$R = 4$, $\\phi_0 = \\pi/2$, $\\phi^* = 3\\pi/4$: the ways from the centre are so "
                "short that with them the means are in the other order"
            ),
            conclusion_survives=True,
            remark="The margin without them is about one per cent on the coarsest net.",
        ),
        rests_on=("fig:branch-tree", "def:amsler-sector"),
    ),
    Claim(
        id="5.1.branch-free-region",
        section="5.1",
        where="section 5.1, line 1584",
        kind="sentence",
        statement=(
            "From (ebs), and (e2) on parts without branch points, no disk of radius about "
            r"$\sqrt{R}$ is free of branch points."
        ),
        hypotheses=(
            r"(used, not stated) about: a large enough constant times $\sqrt{R}$",
            "(used, not stated) the immersion attains the order of the infimum in (ebs)",
        ),
        rests_on=("e2", "ebs"),
        checks=(
            Check(
                name="contradiction",
                run=_COUNT + "free_region",
                routes=("(e2) on the part, from below", "(ebs) on the whole, from above"),
                mutants=(
                    Mutant(name="size R^(2/5)", given={"power": "2/5"}, near=True),
                    Mutant(name="(e2) with sqrt R", given={"patch": "1/2"}),
                    Mutant(name="(ebs) with R", given={"branched": "1"}),
                    Mutant(name="no constants", given={"constants": "dropped"}),
                ),
            ),
        ),
    ),
    Claim(
        id="5.1.area-of-disk",
        section="5.1",
        where="section 5.1, line 1585",
        kind="sentence",
        statement=r"The area of a disk of radius $R$ scales like $\exp(R)$.",
        hypotheses=(r"(used, not stated) as $R \to \infty$",),
        rests_on=("def:H2",),
        checks=(
            Check(
                name="limit",
                run=_COUNT + "disk_area",
                tier="full",
                routes=("printed law", "integral of the area element of the disk model"),
                mutants=(
                    Mutant(name="exp(2 R)", given={"rate": "2"}),
                    Mutant(name="exp(1.1 R)", given={"rate": "11/10"}, near=True),
                    Mutant(name="exp(R/2)", given={"rate": "1/2"}),
                ),
            ),
        ),
    ),
    Claim(
        id="5.1.area-free-of-branch-points",
        section="5.1",
        where="section 5.1, line 1585",
        kind="sentence",
        statement=(
            r"The largest part free of branch points has area at most of order $\exp(\sqrt{R})$."
        ),
        hypotheses=(
            "(used, not stated) the part is a disk",
            r"(used, not stated) the constant in front of $\sqrt{R}$ is $1$",
        ),
        rests_on=("5.1.branch-free-region", "5.1.area-of-disk"),
        checks=(
            Check(
                name="logarithms",
                run=_COUNT + "free_area",
                routes=("printed exponent", "area of a disk of radius k sqrt R"),
                mutants=(
                    Mutant(name="exp(R^(2/5))", given={"power": "2/5"}, near=True),
                    Mutant(name="exp(R)", given={"power": "1"}),
                ),
            ),
            Check(
                name="constant 1",
                run=_COUNT + "free_area_order",
                form="support",
                routes=("printed exponent", "area of a disk of radius sqrt R"),
                mutants=(Mutant(name="radius 2 sqrt R", given={"constant": 2}),),
            ),
        ),
    ),
    Claim(
        id="5.1.number-of-branch-points",
        section="5.1",
        where="section 5.1, line 1585",
        kind="sentence",
        statement=r"The number of branch points scales like $\exp(R - \sqrt{R})$.",
        hypotheses=(
            (
                "(used, not stated) branch points are spread evenly, one for each part of the "
                "largest size"
            ),
            "(used, not stated) no part is smaller than the largest by more than a constant factor",
        ),
        rests_on=("5.1.area-free-of-branch-points", "5.1.area-of-disk"),
        checks=(
            Check(
                name="numbers of the runs",
                run="checks.verify.greedy_growth:number_law",
                tier="full",
                part="runs",
                routes=("branch points of stored runs", "printed law"),
                mutants=(
                    Mutant(name="R^(2/5) for the root", given={"power": "2/5"}, near=True),
                    Mutant(name="twice the root", given={"factor": "2"}),
                ),
            ),
            Check(
                name="exp R",
                run="checks.verify.greedy_growth:number_law",
                tier="full",
                form="corrected",
                given={"factor": "0"},
                part="runs",
                routes=("branch points of stored runs", "law without the root"),
                mutants=(
                    Mutant(name="exp(11/10 R)", given={"factor": "0", "rate": "11/10"}, near=True),
                    Mutant(name="exp(19/20 R)", given={"factor": "0", "rate": "19/20"}, near=True),
                    Mutant(name="a quarter of the root", given={"factor": "1/4"}, near=True),
                    Mutant(name="as printed", given={"factor": "1"}),
                ),
            ),
            Check(
                name="quotient of areas",
                run=_COUNT + "number",
                tier="full",
                routes=("printed law", "areas of disks of radius R and sqrt R"),
                mutants=(
                    Mutant(name="exp(R - 2 sqrt R)", given={"factor": "2"}),
                    Mutant(name="exp(R - R^(2/5))", given={"power": "2/5"}, near=True),
                    Mutant(name="not spread evenly", given={"spread": "none"}),
                ),
            ),
            Check(
                name="what free disks alone enforce",
                run=_COUNT + "fewest_number",
                form="support",
                routes=("exp(R - 2 sqrt R)", "cover of the disk of radius R - sqrt R"),
                mutants=(Mutant(name="exp(R - sqrt R)", given={"factor": "1"}),),
            ),
        ),
        erratum=Erratum(
            printed=r"$\exp(R - \sqrt{R})$ branch points",
            corrected=(
                "between $0.8$ and $1.1$ times $e^R$ on the surfaces of the greedy algorithm; what "
                r"small free disks enforce by themselves is $\exp(R - 2\sqrt{R})$, up to constants"
            ),
            kind="false",
            witness=(
                r"$\phi_0 = \pi/2$, $\phi^* = 3\pi/4$: $2584$ branch points for $R = 8$, $368660$ "
                r"for $R = 13$; $e^{R - \sqrt{R}}$ is $176$ and $12021$, the quotient grows from "
                "$14.7$ to $30.7$"
            ),
            conclusion_survives=True,
            remark=(
                r"One branch point for each area of about $\pi$, as (rmk:distributed) asks, is "
                r"$e^R$ too. The cut depth stays linear to leading order. Measured for $8 \leq R "
                r"\leq 13$."
            ),
        ),
    ),
    Claim(
        id="5.1.exponential-in-generations",
        section="5.1",
        where="section 5.1, line 1585",
        kind="sentence",
        statement=(
            "With at most three daughters each, the number of branch points grows about "
            "exponentially with the number of generations."
        ),
        hypotheses=("(used, not stated) most branch points have more than one daughter",),
        rests_on=("5.1.at-most-three-daughters",),
        checks=(
            Check(
                name="trees of two and three daughters",
                run=_COUNT + "generations",
                routes=("printed base", "sums over the generations"),
                mutants=(
                    Mutant(name="base 2", given={"most": 2}, near=True),
                    Mutant(name="base 4", given={"most": 4}, near=True),
                    Mutant(name="one daughter each", given={"fewest": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="5.1.cut-depth",
        section="5.1",
        where="section 5.1, displayed formula, line 1587",
        kind="equation",
        statement=r"The cut depth scales like $n \sim \max(R - \sqrt{R}, 0)$.",
        hypotheses=(r"the number of branch points scales like $\exp(R - \sqrt{R})$",),
        rests_on=(
            "5.1.number-of-branch-points",
            "5.1.exponential-in-generations",
            "5.scaling-symbol",
        ),
        checks=(
            Check(
                name="depth of a full tree",
                run=_COUNT + "depth",
                routes=("printed depth", "generations of a tree of exp(R - sqrt R) nodes"),
                mutants=(
                    Mutant(name="R - 2 sqrt R", given={"factor": "2"}),
                    Mutant(name="R - sqrt(R)/2", given={"factor": "1/2"}),
                    Mutant(name="R - R^(2/5)", given={"power": "2/5"}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="5.1.slope-of-cut-depth",
        section="5.1",
        where="section 5.1, line 1589",
        kind="sentence",
        statement=r"$R - \sqrt{R}$ is nearly linear, and its slope increases slowly.",
        hypotheses=("$R > 1$",),
        rests_on=("5.1.cut-depth",),
        checks=(
            Check(
                name="derivatives",
                run=_COUNT + "slope",
                routes=("printed depth", "derivatives and their limits"),
                mutants=(
                    Mutant(name="R + sqrt R", given={"factor": "-1"}),
                    Mutant(name="R - R", given={"power": "1"}),
                    Mutant(name="R - 3 sqrt R", given={"factor": "3"}),
                ),
            ),
        ),
    ),
    Claim(
        id="5.1.cut-depth-observed",
        section="5.1",
        where="section 5.1, line 1589",
        kind="sentence",
        statement=(
            r"The cut depth measured against $R$ follows $R - \sqrt{R}$, with a slowly "
            "increasing slope."
        ),
        hypotheses=(r"$R \leq 10$", "(used, not stated) up to a factor and an additive constant"),
        rests_on=("5.1.cut-depth", "fig:cutdepthwithradius"),
        checks=(
            Check(
                name="R - sqrt R, within rounding",
                run="checks.verify.cut_depth:root_law",
                tier="full",
                part="law",
                routes=(
                    "radii of the generations by bisection on nets",
                    "depth in the limit of edge length 0",
                ),
                mutants=(
                    Mutant(name="a line", given={"less": "0"}, near=True),
                    Mutant(name="half of the root", given={"less": "1/2"}, near=True),
                    Mutant(name="R^(9/10)", given={"power": "9/10"}, near=True),
                    Mutant(name="three times the root", given={"less": "3"}),
                ),
            ),
            Check(
                name="slope",
                run="checks.verify.cut_depth:slope_grows",
                tier="full",
                part="slope",
                routes=("radii of the generations by bisection on nets", "term in R^2 of a fit"),
                mutants=(
                    Mutant(name="decreasing", given={"sense": -1}),
                    Mutant(name="term in R^2 less 0.05", given={"bend": "1/20"}, near=True),
                ),
            ),
        ),
    ),
)
