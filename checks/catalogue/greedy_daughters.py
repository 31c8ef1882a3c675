"""Claims of section 4.1, the greedy algorithm: the sectors at a cut, steps 16 to 22."""

from checks.claim import Check, Claim, Erratum, Mutant

CLAIMS: tuple[Claim, ...] = (
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
                tier="full",
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
                tier="full",
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
                tier="full",
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
                tier="full",
                routes=("the algorithm in the disk", "nodes reached before a fold"),
                mutants=(
                    Mutant(name="a disk of 0.95 R", given={"radius": "19/20"}, near=True),
                    Mutant(name="a disk of 0.9 R", given={"radius": "9/10"}),
                ),
            ),
            Check(
                name="points of the disk",
                run="checks.verify.printed_nodes:rim_quads",
                tier="full",
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
                tier="full",
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
                tier="full",
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
)
