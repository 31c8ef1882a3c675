"""Claims of section 4.1, the greedy algorithm: its cuts, steps 11 to 25."""

from checks.claim import Check, Claim, Erratum, Mutant

_SIGN = (
    r"(used, not stated) $\varphi$ is measured without sign: (eq:angle) as printed is negative "
    r"in the sectors $\Omega_{M+2}$, whose $v$-axis lies clockwise of the $u$-axis"
)

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="4.1.algorithm-11-choose",
        section="4.1",
        where="algorithm (alg:greedy-cuts), step 11, line 1314",
        kind="algorithm",
        statement=(
            r"A sector $\Omega_n$ with some $\varphi^n_{j,k} > \phi^*$ is chosen; which one does "
            "not matter for the result."
        ),
        hypotheses=("(used, not stated) sectors of one parent do not influence each other", _SIGN),
        checks=(
            Check(
                name="three orders",
                run="checks.verify.printed_cuts:order_of_choice",
                routes=("first, last and random choice", "paths and cuts of the sectors"),
                mutants=(Mutant(name="7 cuts at most", given={"most": 7}, near=True),),
            ),
        ),
        rests_on=("4.1.algorithm-08-angles",),
    ),
    Claim(
        id="4.1.algorithm-12-cut-column",
        section="4.1",
        where="algorithm (alg:greedy-cuts), step 12, line 1315",
        kind="algorithm",
        statement=(
            r"$j^* = \max\{j : \varphi_{\ell,k} \leq \phi^* \text{ for all } \zeta_{\ell,k} \in "
            r"\Omega_n \text{ with } \ell \leq j\}$."
        ),
        hypotheses=(
            r"(used, not stated) the set is not empty: $\varphi \leq \phi^*$ on the $v$-axis",
            _SIGN,
        ),
        checks=(
            Check(
                name="cuts of discrete.greedy",
                run="checks.verify.printed_cuts:cut_place",
                routes=(
                    "the algorithm in the disk",
                    "angles carried intrinsically (discrete.greedy)",
                ),
                mutants=(
                    Mutant(name="one more", given={"shift": 1}, near=True),
                    Mutant(name="0.96 phi*", given={"level": "24/25"}, near=True),
                ),
            ),
        ),
        rests_on=("4.1.algorithm-11-choose",),
    ),
    Claim(
        id="4.1.algorithm-13-cut-row",
        section="4.1",
        where="algorithm (alg:greedy-cuts), step 13, line 1316",
        kind="algorithm",
        statement=(
            r"$k^* = \max\{k : \varphi_{j,\ell} \leq \phi^* \text{ for all } \zeta_{j,\ell} \in "
            r"\Omega_n \text{ with } \ell \leq k\}$."
        ),
        hypotheses=(
            r"(used, not stated) the set is not empty: $\varphi \leq \phi^*$ on the $u$-axis",
            _SIGN,
        ),
        checks=(
            Check(
                name="cuts of discrete.greedy",
                run="checks.verify.printed_cuts:cut_row",
                routes=(
                    "the algorithm in the disk",
                    "angles carried intrinsically (discrete.greedy)",
                ),
                mutants=(
                    Mutant(name="one more", given={"shift": 1}, near=True),
                    Mutant(name="0.96 phi*", given={"level": "24/25"}, near=True),
                ),
            ),
        ),
        rests_on=("4.1.algorithm-11-choose",),
    ),
    Claim(
        id="4.1.algorithm-14-excise",
        section="4.1",
        where="algorithm (alg:greedy-cuts), step 14, line 1317",
        kind="algorithm",
        statement=(
            r"The nodes with $j > j^*$ and $k > k^*$ are taken out of $\Omega_n$; on what is "
            r"left $\varphi \leq \phi^*$."
        ),
        checks=(
            Check(
                name="nodes that are left",
                run="checks.verify.printed_cuts:excision",
                routes=("the algorithm in the disk", "largest angle"),
                mutants=(
                    Mutant(name="one row more", given={"keep_rows": 1}, near=True),
                    Mutant(name="0.96 phi*", given={"level": "24/25"}, near=True),
                ),
            ),
        ),
        rests_on=("4.1.algorithm-12-cut-column", "4.1.algorithm-13-cut-row"),
    ),
    Claim(
        id="4.1.algorithm-15-add-sectors",
        section="4.1",
        where="algorithm (alg:greedy-cuts), step 15, line 1318",
        kind="algorithm",
        statement=(
            r"Three sectors $\Omega_{M+1}, \Omega_{M+2}, \Omega_{M+3}$ are added to the list."
        ),
        hypotheses=("$M$ is the number of sectors so far",),
        checks=(
            Check(
                name="list after each cut",
                run="checks.verify.printed_cuts:bookkeeping",
                routes=("the algorithm in the disk", "parents of the sectors"),
                mutants=(Mutant(name="two", given={"added": 2}, near=True),),
            ),
        ),
        rests_on=("4.1.algorithm-14-excise",),
    ),
    Claim(
        id="4.1.algorithm-16-middle-axes",
        section="4.1",
        where="algorithm (alg:greedy-cuts), step 16, line 1319",
        kind="algorithm",
        statement=(
            r"Both axes of $\Omega_{M+2}$, $0 \leq j, k \leq N$, are given by (eq:trisect) and "
            r"(eq:poincare-surgery) at $\zeta_0 = \zeta^n_{j^*,k^*}$."
        ),
        hypotheses=(
            (
                r"(used, not stated) $w_1, w_2$ are the images of $\zeta^n_{j^*+1,k^*}$ and "
                r"$\zeta^n_{j^*,k^*+1}$, which are in $\Omega_n$"
            ),
        ),
        checks=(
            Check(
                name="principal arguments",
                run="checks.verify.printed_daughters:middle_axes",
                routes=("(eq:trisect), (eq:poincare-surgery)", "angles at the cut"),
                mutants=(
                    Mutant(
                        name="0.335 of the angle",
                        given={"variant": "argument", "part": "67/200"},
                        near=True,
                    ),
                ),
            ),
            Check(
                name="arguments from w_1 on",
                run="checks.verify.printed_daughters:middle_axes",
                form="corrected",
                given={"variant": "meant"},
                routes=("(eq:trisect), (eq:poincare-surgery)", "angles at the cut"),
                mutants=(
                    Mutant(name="0.335", given={"part": "67/200"}, near=True),
                    Mutant(name="principal arguments", given={"variant": "argument"}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=(
                "$\\varphi_1 = \\mathrm{arg}(w_2 w_1^2)/3$, $\\varphi_2 = \\mathrm{arg}(w_2^2 "
                "w_1)/3$"
            ),
            corrected=(
                "$\\varphi_1 = \\arg w_1 + \\frac13 \\arg(w_2/w_1)$, $\\varphi_2 = \\arg w_1 + "
                "\\frac23 \\arg(w_2/w_1)$"
            ),
            kind="ambiguous",
            witness=(
                "$R = 3$, $\\Delta = 1/10$, $m = 2$: at the cut of the sector $\\Omega_2$ the "
                "side sectors take $-0.49\\pi$ and $0.84\\pi$ of $0.52\\pi$, since $w_2 w_1^2$ "
                "has an argument beyond $\\pi$"
            ),
            conclusion_survives=True,
            remark=(
                "With principal values the two directions can be off by a third of a turn, each "
                "by itself."
            ),
        ),
        rests_on=("4.1.algorithm-15-add-sectors", "eq:trisect", "eq:poincare-surgery"),
    ),
    Claim(
        id="4.1.algorithm-17-side-axes",
        section="4.1",
        where="algorithm (alg:greedy-cuts), step 17, line 1320",
        kind="algorithm",
        statement=(
            r"The side sectors take one axis from the parent, $\zeta^{M+1}_{j,0} = "
            r"\zeta^n_{j+j^*,k^*}$ and $\zeta^{M+3}_{0,k} = \zeta^n_{j^*,k+k^*}$, and one from "
            r"the middle sector, $\zeta^{M+1}_{0,k} = \zeta^{M+2}_{0,k}$ and $\zeta^{M+3}_{j,0} "
            r"= \zeta^{M+2}_{j,0}$."
        ),
        hypotheses=(
            (
                "(used, not stated) as far as the parent reaches: its line ends at $N - j^*$, or "
                "earlier where nodes were discarded"
            ),
        ),
        checks=(
            Check(
                name="nodes of both lines",
                run="checks.verify.printed_daughters:side_axes",
                routes=(
                    "the algorithm in the disk",
                    "nodes of the parent and of the middle sector",
                ),
                mutants=(Mutant(name="from the next node on", given={"shift": 1}, near=True),),
            ),
        ),
        rests_on=("4.1.algorithm-16-middle-axes",),
    ),
    Claim(
        id="4.1.algorithm-18-each-daughter",
        section="4.1",
        where="algorithm (alg:greedy-cuts), step 18, line 1321",
        kind="algorithm",
        statement="Steps 19 to 22 are done for the three new sectors, $p = 1, 2, 3$.",
        checks=(
            Check(
                name="points around the cut",
                run="checks.verify.printed_result:around_branch_points",
                routes=("the algorithm in the disk", "random points"),
                mutants=(
                    Mutant(name="without the middle one", given={"left_out": "A"}, near=True),
                    Mutant(name="without the first", given={"left_out": "u"}),
                ),
            ),
        ),
        rests_on=("4.1.algorithm-17-side-axes",),
    ),
    Claim(
        id="4.1.algorithm-19-fill-daughter",
        section="4.1",
        where="algorithm (alg:greedy-cuts), step 19, line 1322",
        kind="algorithm",
        statement=r"The nodes $\zeta^{M+p}_{j,k}$ follow from (poincare-ddg) one by one.",
        hypotheses=("(used, not stated) for $j, k$ up to the ends of the two axes",),
        checks=(
            Check(
                name="sides of the rhombi",
                run="checks.verify.printed_daughters:rhombi",
                routes=("(poincare-ddg)", "distances"),
                mutants=(
                    Mutant(name="minus", given={"sign": -1}),
                    Mutant(name="1.01", given={"weight": "101/100"}, near=True),
                ),
            ),
        ),
        rests_on=("poincare-ddg", "4.1.algorithm-18-each-daughter"),
    ),
    Claim(
        id="4.1.algorithm-20-discard-daughter",
        section="4.1",
        where="algorithm (alg:greedy-cuts), step 20, line 1323",
        kind="algorithm",
        statement=(
            r"A node $\zeta^{M+p}_{j,k}$ is discarded when $\zeta^{M+p}_{j-1,k}$ and "
            r"$\zeta^{M+p}_{j,k-1}$ are both outside the disk of radius $R$; no node inside the "
            "disk is lost."
        ),
        hypotheses=("(used, not stated) as in step 6",),
        checks=(
            Check(
                name="nodes in the disk",
                run="checks.verify.printed_nodes:lost_nodes",
                routes=("the algorithm in the disk", "nodes reached before a fold"),
                mutants=(
                    Mutant(name="a disk of 0.95 R", given={"radius": "19/20"}, near=True),
                    Mutant(name="a disk of 0.9 R", given={"radius": "9/10"}),
                ),
            ),
            Check(
                name="points of the disk",
                run="checks.verify.printed_nodes:rim_quads",
                form="support",
                given={"short": "1"},
                routes=("the algorithm in the disk", "random points"),
                mutants=(Mutant(name="up to the rim", given={"short": "0"}, near=True),),
            ),
        ),
        rests_on=("4.1.algorithm-19-fill-daughter", "eq:hyp_radius"),
    ),
    Claim(
        id="4.1.algorithm-21-daughter",
        section="4.1",
        where="algorithm (alg:greedy-cuts), step 21, line 1324",
        kind="algorithm",
        statement=(
            r"$\Omega_{M+p}$ is the set of all $\zeta^{M+p}_{j,k}$, $j, k \leq N$, that were not "
            "discarded."
        ),
        checks=(
            Check(
                name="pieces and Euler characteristic",
                run="checks.verify.printed_nodes:staircase",
                routes=("the algorithm in the disk", "V - E + F of the kept quads"),
                mutants=(
                    Mutant(name="an inner node dropped", given={"dropped": 1}, near=True),
                    Mutant(name="discards by place", given={"variant": "discard"}),
                ),
            ),
        ),
        rests_on=("4.1.algorithm-20-discard-daughter",),
    ),
    Claim(
        id="4.1.algorithm-22-daughter-angles",
        section="4.1",
        where="algorithm (alg:greedy-cuts), step 22, line 1325",
        kind="algorithm",
        statement=(
            r"$\varphi^{M+p}_{j,k}$ is computed by (eq:angle) at the nodes of which "
            r"$\zeta^{M+p}_{j+1,k}$ and $\zeta^{M+p}_{j,k+1}$ are in $\Omega_{M+p}$; it is the "
            r"angle of the daughter sector, between $0$ and $\pi$."
        ),
        hypotheses=(
            (
                "(used, not stated) $p = 1, 3$, or a sign is added: for $p = 2$ the value of "
                "(eq:angle) is negative"
            ),
        ),
        checks=(
            Check(
                name="with its sign",
                run="checks.verify.printed_daughters:daughter_angles",
                routes=("(eq:angle)", "the interval from 0 to phi*"),
                mutants=(Mutant(name="0.96 phi*", given={"most": "24/25"}, near=True),),
            ),
            Check(
                name="without a sign",
                run="checks.verify.printed_daughters:daughter_angles",
                form="corrected",
                given={"variant": "meant"},
                routes=("(eq:angle)", "the interval from 0 to phi*"),
                mutants=(
                    Mutant(name="0.96 phi*", given={"most": "24/25"}, near=True),
                    Mutant(name="with its sign", given={"variant": "sign"}),
                ),
            ),
        ),
        erratum=Erratum(
            printed="$\\varphi_{j,k} = \\mathrm{arg}(w_2w_1^*)$ in all three daughters",
            corrected="$\\varphi_{j,k} = |\\mathrm{arg}(w_2w_1^*)|$",
            kind="misprint",
            witness=(
                "$R = 3$, $\\Delta = 1/10$, $m = 2$: in $\\Omega_{M+2}$ at the first cut "
                "$\\varphi$ runs from $-0.17\\pi$ downwards, since step 16 puts its $u$-axis "
                "next to the $v$-line of the parent"
            ),
            conclusion_survives=True,
        ),
        rests_on=("4.1.algorithm-21-daughter", "eq:angle"),
    ),
    Claim(
        id="4.1.algorithm-24-count",
        section="4.1",
        where="algorithm (alg:greedy-cuts), step 24, line 1327",
        kind="algorithm",
        statement="$M$ grows by $3$, and is the number of sectors in the list.",
        checks=(
            Check(
                name="list after each cut",
                run="checks.verify.printed_cuts:bookkeeping",
                routes=("the algorithm in the disk", "parents of the sectors"),
                mutants=(Mutant(name="two", given={"added": 2}, near=True),),
            ),
        ),
        rests_on=("4.1.algorithm-15-add-sectors",),
    ),
    Claim(
        id="4.1.algorithm-25-stop",
        section="4.1",
        where="algorithm (alg:greedy-cuts), step 25, line 1328",
        kind="algorithm",
        statement=(
            r"Steps 11 to 24 are repeated until no sector contains a node with $\varphi_{j,k} > "
            r"\phi^*$; then $\varphi \leq \phi^*$ at all nodes of the net."
        ),
        hypotheses=(_SIGN,),
        checks=(
            Check(
                name="with the sign",
                run="checks.verify.printed_cuts:stops",
                routes=("the algorithm in the disk", "largest angle at the end"),
                mutants=(Mutant(name="7 cuts at most", given={"most": 7}, near=True),),
            ),
            Check(
                name="without it",
                run="checks.verify.printed_cuts:stops",
                form="corrected",
                given={"variant": "meant"},
                routes=("the algorithm in the disk", "largest angle at the end"),
                mutants=(
                    Mutant(name="7 cuts at most", given={"most": 7}, near=True),
                    Mutant(name="0.95 phi*", given={"level": "19/20"}, near=True),
                    Mutant(name="with the sign", given={"variant": "sign"}),
                ),
            ),
        ),
        erratum=Erratum(
            printed="until no sector contains points with $\\varphi_{j,k} > \\phi^*$",
            corrected=(
                "until no sector contains points of the disk with $|\\varphi_{j,k}| > \\phi^*$"
            ),
            kind="misprint",
            witness=(
                "$R = 3$, $\\Delta = 1/10$, $m = 2$, $\\phi^* = 3\\pi/4$: the run ends with an "
                "angle of $-0.99\\pi$ in a middle sector, next to its singular edge"
            ),
            conclusion_survives=True,
        ),
        rests_on=("4.1.algorithm-14-excise", "4.1.algorithm-22-daughter-angles"),
    ),
    Claim(
        id="4.1.greedy-is-local",
        section="4.1",
        where="section 4.1, line 1299",
        kind="sentence",
        statement=(
            "The cut of a sector depends on that sector alone: $j^*$ and $k^*$ are the largest "
            "that its own angles allow."
        ),
        checks=(
            Check(
                name="each sector by itself",
                run="checks.verify.printed_cuts:local_cut",
                routes=("the cuts of a run", "the sector filled again from its axes"),
                mutants=(Mutant(name="one line more", given={"more": 1}, near=True),),
            ),
        ),
        rests_on=("4.1.algorithm-12-cut-column", "4.1.algorithm-13-cut-row"),
    ),
)
