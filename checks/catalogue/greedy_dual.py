"""Claims of section 4.1, one branch point of high index and the dual of the greedy algorithm."""

from checks.claim import Check, Claim, Mutant

_DUAL = "$m$ as in the algorithm, $g$ as in item (1)"
_MONO = r"$m \geq 6$, $\phi^* \leq \pi/2$"
_SIGN = (
    r"(used, not stated) $\varphi$ is measured without sign: (eq:angle) as printed is negative "
    r"in the sectors $\Omega_{M+2}$, whose $v$-axis lies clockwise of the $u$-axis"
)
_SMALL = (
    r"(used, not stated) $\Delta$ is small against the distance of the cut from the axes, so "
    r"that $j^*, k^* \geq 1$"
)

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="4.1.periodic-amsler",
        section="4.1",
        where="section 4.1, line 1363",
        kind="sentence",
        statement=(
            "For every $R$ the disk is isometrically immersed by Amsler sectors of angle "
            r"$\pi/m_0$ that meet at one branch point at the origin, $m_0$ so large that their "
            "singular edges are farther than $R$ from it."
        ),
        rests_on=("def:amsler-sector", "PIII", "prop:assembly"),
    ),
    Claim(
        id="fig:branchedpoincareimmersions",
        section="4.1",
        where="figure (fig:branchedpoincareimmersions), lines 1363-1404",
        kind="figure",
        statement=(
            "Nets in the disk for $R = 2, 3, 4$, with distributed branch points (left) and with "
            "one branch point of high index at the origin (right), coloured by the larger "
            "absolute principal curvature."
        ),
        labels=(
            "fig:branchedpoincareimmersions",
            "fig:branchsurfacepoinare2",
            "fig:branchsurfacepoincare3",
            "fig:branchsurfacepoinare4",
            "fig:periodicamslerpoincare2",
            "fig:periodicamslerpoincare3",
            "fig:periodicamslerpoincare4",
        ),
        hypotheses=(r"(used, not stated) $m$, $\phi^*$ and $\Delta$ are not given",),
        rests_on=("alg:greedy-cuts", "4.1.periodic-amsler", "5.principal-curvatures"),
        checks=(
            Check(
                name="both columns",
                run="checks.verify.comparison_nets:figure",
                tier="full",
                routes=("angles of the K-surface in space", "sweep of the greedy algorithm"),
                mutants=(
                    Mutant(name="colours 3 % more", given={"percent": 103}, near=True),
                    Mutant(name="smaller curvature", given={"smaller": True}),
                    Mutant(name="four sectors about the one branch point", given={"sectors": "4"}),
                    Mutant(name="eight initial sectors on the left", given={"distributed": "8"}),
                ),
            ),
        ),
    ),
    Claim(
        id="4.1.energy-comparison",
        section="4.1",
        where="section 4.1, line 1363",
        kind="sentence",
        statement=(
            "Over $R = 2, 3, 4$ the largest principal curvature grows with $R$ for both kinds of "
            "immersion, more slowly with distributed branch points than with one."
        ),
        hypotheses=(
            r"(used, not stated) $m$ and $\phi^*$ of the runs compared, which are not given",
        ),
        rests_on=("fig:branchedpoincareimmersions",),
        checks=(
            Check(
                name="growth from R = 2 to 4",
                run="checks.verify.comparison_nets:slower_growth",
                tier="full",
                routes=("nets with distributed branch points", "nets with the best single one"),
                mutants=(
                    Mutant(name="36 sectors for every R", given={"sectors": "36"}),
                    Mutant(name="three fifths of the growth", given={"share": "3/5"}),
                    Mutant(name="two thirds of the growth", given={"share": "2/3"}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="4.1.dual-saddle-order",
        section="4.1",
        where="section 4.1, line 1406",
        kind="equation",
        statement=(
            r"The order of saddleness that one branch point at the origin needs is $m_0 \sim C "
            "e^R$ with a constant $C$ of order $1$."
        ),
        hypotheses=(
            (
                "(used, not stated) $m_0$ is the least $m$ for which Amsler sectors of angle "
                r"$\pi/m$ cover the disk of radius $R$ without a singular edge"
            ),
            (
                r"(used, not stated) $\sim$ means that the quotient tends to $1$ or at least "
                r"stays between constants as $R \to \infty$"
            ),
        ),
        rests_on=("4.1.periodic-amsler", "PIII"),
    ),
    Claim(
        id="4.1.dual-1-generations",
        section="4.1",
        where="section 4.1, dual interpretation, item (1), line 1409",
        kind="item",
        statement=(
            "The dual starts with one branch point at the origin of index $m' = 3^g m$, where "
            r"$3^{g-1} m < m_0 \leq 3^g m$ fixes $g$."
        ),
        hypotheses=(
            "$m$ is the parameter of the algorithm",
            r"(used, not stated) $m_0 > m/3$, so that $g \geq 0$",
        ),
        rests_on=("4.1.dual-saddle-order",),
    ),
    Claim(
        id="4.1.dual-1-expected-depth",
        section="4.1",
        where="section 4.1, dual interpretation, item (1), line 1409",
        kind="sentence",
        statement=(
            "$g$ is the number of generations of branch points to be expected, the cut depth of "
            r"section 5.1; as $m_0 \sim C e^R$ it grows like $R / \log 3$."
        ),
        rests_on=("4.1.dual-1-generations",),
    ),
    Claim(
        id="4.1.dual-2-first-step",
        section="4.1",
        where="section 4.1, dual interpretation, item (2), line 1410",
        kind="item",
        statement=(
            "In the first step $2m$ daughters, each of degree $3^g$, move out of the origin in "
            "their sectors, and a branch point of index $m$ is left there."
        ),
        hypotheses=(
            _DUAL,
            (
                "(used, not stated) degree is the number of sectors that a daughter carries "
                "outward: its degree as a vertex is $3^g + 3$"
            ),
        ),
        rests_on=("4.1.dual-1-generations", "4.1.branch-point-degree"),
    ),
    Claim(
        id="4.1.dual-2-stop-at-cutoff",
        section="4.1",
        where="section 4.1, dual interpretation, item (2), line 1410",
        kind="item",
        statement=(
            r"The daughters move until the largest $\varphi$ over each sector that grows at the "
            r"origin equals $\phi^*$."
        ),
        hypotheses=(
            _DUAL,
            (
                "(used, not stated) the largest angle increases continuously with the position "
                "of the daughter"
            ),
        ),
        rests_on=("4.1.dual-2-first-step",),
    ),
    Claim(
        id="4.1.dual-2-same-cut",
        section="4.1",
        where="section 4.1, dual interpretation, item (2), line 1411",
        kind="sentence",
        statement=(
            "The first generation of the dual has the places $(j^*, k^*)$ of steps 12 and 13 in "
            "each of the $2m$ initial sectors."
        ),
        hypotheses=(
            _DUAL,
            (
                "(used, not stated) a daughter has two coordinates, so that one condition on the "
                "largest angle does not fix its place"
            ),
        ),
        rests_on=(
            "4.1.dual-2-stop-at-cutoff",
            "4.1.algorithm-12-cut-column",
            "4.1.algorithm-13-cut-row",
        ),
    ),
    Claim(
        id="4.1.dual-3-stage",
        section="4.1",
        where="section 4.1, dual interpretation, item (3), line 1412",
        kind="item",
        statement=(
            r"At stage $k$ there are $2 \cdot 3^{k-1} m$ daughters to move out, each of degree "
            "$3^{g-k}$."
        ),
        hypotheses=(
            _DUAL,
            r"$1 \leq k \leq g$",
            "(used, not stated) degree is meant as in item (2); stage $1$ is the first step",
        ),
        rests_on=("4.1.dual-2-first-step",),
    ),
    Claim(
        id="4.1.dual-3-stop-at-cutoff",
        section="4.1",
        where="section 4.1, dual interpretation, item (3), line 1412",
        kind="item",
        statement=(
            r"At stage $k$ the daughters move until the largest $\varphi$ in the sectors at the "
            r"branch points of generation $k - 1$ equals $\phi^*$."
        ),
        hypotheses=(_DUAL, r"$1 \leq k \leq g$"),
        rests_on=("4.1.dual-3-stage",),
    ),
    Claim(
        id="4.1.dual-4-cover",
        section="4.1",
        where="section 4.1, dual interpretation, item (4), line 1413",
        kind="item",
        statement="At every stage the sectors together cover the whole disk.",
        hypotheses=(
            _DUAL,
            "(used, not stated) no sector develops a singular edge inside the disk on the way",
        ),
        rests_on=("4.1.dual-3-stage", "4.1.periodic-amsler"),
    ),
    Claim(
        id="4.1.dual-5-comparison",
        section="4.1",
        where="section 4.1, dual interpretation, item (5), line 1414",
        kind="proposition",
        statement=(
            r"Let $\varphi_1, \varphi_2$ solve $\partial_{uv}\varphi = \sin\varphi$ on $J = [0, "
            r"u_0] \times [0, v_0]$ with $\varphi_1(u, 0) \leq \varphi_2(u, 0)$ and "
            r"$\varphi_1(0, v) \leq \varphi_2(0, v)$. Then $\varphi_1 \leq \varphi_2$ on $J$."
        ),
        hypotheses=(
            r"$0 < \varphi_i < \pi/2$ on $J$, $i = 1, 2$",
            r"$0 \leq u \leq u_0$, $0 \leq v \leq v_0$ in the two inequalities",
            (
                r"(used, not stated) the difference $\varphi_2(u, 0) + \varphi_2(0, v) - "
                r"\varphi_2(0, 0)$ minus the same for $\varphi_1$ is not negative on $J$: for "
                "example both differences on the axes increase from the corner"
            ),
        ),
        rests_on=("eq:hazzidakis",),
    ),
    Claim(
        id="4.1.dual-5-monotone",
        section="4.1",
        where="section 4.1, dual interpretation, item (5), line 1414",
        kind="sentence",
        statement=(
            "By the comparison principle the dual process is monotone: moving a branch point "
            r"outward does not decrease $\varphi$ in the sectors that it changes."
        ),
        hypotheses=(
            r"$\phi^* \leq \pi/2$",
            (
                "(used, not stated) the data on the axes before and after are ordered as the "
                "comparison principle needs"
            ),
        ),
        rests_on=("4.1.dual-5-comparison", "4.1.dual-3-stage"),
    ),
    Claim(
        id="4.1.dual-6-same-result",
        section="4.1",
        where="section 4.1, dual interpretation, item (6), line 1415",
        kind="item",
        statement=(
            "The greedy algorithm and the dual, which starts from the periodic Amsler surface on "
            "the disk of radius $R$ and moves branch points outward, have the same result."
        ),
        hypotheses=(_MONO,),
        rests_on=("4.1.dual-5-monotone", "4.1.dual-2-same-cut"),
    ),
    Claim(
        id="4.1.dual-6-no-new-branch-points",
        section="4.1",
        where="section 4.1, dual interpretation, item (6), line 1415",
        kind="item",
        statement=(
            "A branch point that reaches the circle can be dropped with all its sectors, and "
            "none ever enters the disk."
        ),
        hypotheses=(_MONO, "(used, not stated) a branch point only moves away from the origin"),
        rests_on=("4.1.dual-5-monotone",),
    ),
    Claim(
        id="4.1.dual-6-termination",
        section="4.1",
        where="section 4.1, dual interpretation, item (6), line 1415",
        kind="item",
        statement="The greedy algorithm ends after finitely many steps.",
        hypotheses=(_MONO, _SIGN, _SMALL),
        rests_on=("4.1.dual-6-same-result", "4.1.dual-6-no-new-branch-points", "alg:greedy-cuts"),
    ),
    Claim(
        id="4.1.dual-6-number-of-sectors",
        section="4.1",
        where="section 4.1, dual interpretation, item (6), line 1415",
        kind="item",
        statement=r"The number of sectors satisfies $M \leq 2 \cdot 3^g m$.",
        hypotheses=(
            _MONO,
            _DUAL,
            (
                "(used, not stated) only sectors that were never cut are counted: the count $M$ "
                "of step 24 keeps those that were cut"
            ),
        ),
        rests_on=("4.1.dual-6-termination", "4.1.algorithm-24-count", "4.1.dual-1-generations"),
    ),
    Claim(
        id="4.1.dual-6-six-m0",
        section="4.1",
        where="section 4.1, dual interpretation, item (6), line 1415",
        kind="equation",
        statement=r"$2 \cdot 3^g m < 6 m_0$.",
        hypotheses=("$3^{g-1} m < m_0$",),
        rests_on=("4.1.dual-1-generations",),
    ),
    Claim(
        id="4.1.dual-6-smallest-angle",
        section="4.1",
        where="section 4.1, dual interpretation, item (6), line 1415",
        kind="item",
        statement=r"The smallest angle satisfies $\varphi \geq 3^{-g}\,\pi/m$.",
        hypotheses=(
            _MONO,
            _DUAL,
            (
                r"(used, not stated) there are at most $g$ generations, and $\varphi$ does not "
                "decrease away from a branch point"
            ),
        ),
        rests_on=("4.1.dual-6-termination", "5.1.monotone"),
    ),
    Claim(
        id="4.1.dual-6-energy-in-generations",
        section="4.1",
        where="section 4.1, dual interpretation, item (6), line 1415",
        kind="item",
        statement=r"$\mathcal{E}_\infty < C\, 3^g m$ with a constant $C$ independent of $R$.",
        hypotheses=(_MONO, _DUAL, r"(used, not stated) $C$ may depend on $\phi^*$"),
        rests_on=("4.1.dual-6-smallest-angle", "ebound"),
    ),
    Claim(
        id="4.1.dual-6-energy-in-radius",
        section="4.1",
        where="section 4.1, dual interpretation, item (6), line 1415",
        kind="item",
        statement=(
            r"$C\, 3^g m < C' e^R$ with a constant $C'$ independent of $R$, hence "
            r"$\mathcal{E}_\infty < C' e^R$."
        ),
        hypotheses=(_MONO, _DUAL, r"$m_0 \sim C e^R$"),
        rests_on=("4.1.dual-6-energy-in-generations", "4.1.dual-saddle-order"),
    ),
    Claim(
        id="4.1.terminates-beyond-right-angle",
        section="4.1",
        where="section 4.1, line 1418",
        kind="sentence",
        statement=r"In numerical runs the algorithm ends also for $\phi^* > \pi/2$.",
        hypotheses=(r"$\pi/2 < \phi^* < \pi$", _SIGN, _SMALL),
        checks=(
            Check(
                name="stored runs",
                run="checks.verify.greedy_tree_shape:runs_beyond_right_angle",
                routes=("stored runs", "area of the disk in closed form"),
                mutants=(
                    Mutant(name="1 % more area", given={"covered": "101/100"}, near=True),
                    Mutant(name="100 cuts", given={"cuts": 100}),
                ),
            ),
        ),
        rests_on=("alg:greedy-cuts",),
    ),
)
