"""Claims of section 4.1, the greedy algorithm: its cuts, steps 11 to 15, and its end."""

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
                tier="full",
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
                tier="full",
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
                tier="full",
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
                tier="full",
                routes=("the algorithm in the disk", "largest angle at the end"),
                mutants=(Mutant(name="7 cuts at most", given={"most": 7}, near=True),),
            ),
            Check(
                name="without it",
                run="checks.verify.printed_cuts:stops",
                tier="full",
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
                tier="full",
                routes=("the cuts of a run", "the sector filled again from its axes"),
                mutants=(Mutant(name="one line more", given={"more": 1}, near=True),),
            ),
        ),
        rests_on=("4.1.algorithm-12-cut-column", "4.1.algorithm-13-cut-row"),
    ),
)
