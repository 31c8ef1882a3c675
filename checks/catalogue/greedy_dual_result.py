"""Claims of section 4.1, the dual of the greedy algorithm: its result, item 6, and termination."""

from checks.catalogue.greedy_dual import NEEDED
from checks.claim import Check, Claim, Erratum, Mutant

_ORDER = "checks.verify.greedy_dual_saddle_order:"
_GENERATIONS = "checks.verify.greedy_dual_generations:"
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
        id="4.1.dual-6-same-result",
        section="4.1",
        where="section 4.1, dual interpretation, item (6), line 1415",
        kind="item",
        statement=(
            "The greedy algorithm and the dual, which starts from the periodic Amsler surface on "
            "the disk of radius $R$ and moves branch points outward, have the same result."
        ),
        hypotheses=(_MONO, NEEDED),
        rests_on=("4.1.dual-5-monotone", "4.1.dual-2-same-cut"),
        checks=(
            Check(
                name="number of branch points",
                run="checks.verify.greedy_dual_result:branch_points",
                tier="full",
                routes=("runs of discrete.greedy", "m_0 by the mirror line (mpmath)"),
                mutants=(
                    Mutant(name="g - 1", given={"shift": -1}, near=True),
                    Mutant(name="m_0 for phi < pi", given={"by": "edge"}),
                ),
            ),
            Check(
                name="n in place of g",
                run="checks.verify.greedy_dual_result:branch_points",
                tier="full",
                form="corrected",
                given={"by": "n"},
                routes=("runs of discrete.greedy", "m_0 by the mirror line (mpmath)"),
                mutants=(
                    Mutant(name="n - 1", given={"shift": -1}, near=True),
                    Mutant(name="g", given={"by": "cutoff"}),
                ),
            ),
        ),
        erratum=Erratum(
            printed="from the periodic Amsler surface of order $3^g m$, $g$ fixed by $m_0$",
            corrected=(
                "from the order $3^n m$, $n$ the number of generations of the greedy algorithm"
            ),
            kind="false",
            witness=(
                "$R = 5$, $m = 6$, $\\phi^* = \\pi/2$, edges of $1/50$: $m_0 = 61$ keeps $\\varphi "
                "\\leq \\phi^*$, so that $g = 3$ and no more than $m(3^g - 1) = 156$ branch points "
                "can be moved out of the origin, while the greedy algorithm makes 168 beside it"
            ),
            conclusion_survives=False,
        ),
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
        checks=(
            Check(
                name="any move of the corner",
                run="checks.verify.greedy_dual_stages:moves_outward",
                tier="full",
                routes=(
                    "nets before and after the corner moves",
                    "distances by SL(2, R) frames",
                ),
                mutants=(
                    Mutant(name="by half an edge at least", given={"least": "1/2"}, near=True),
                ),
            ),
            Check(
                name="both coordinates grow",
                run="checks.verify.greedy_dual_stages:moves_outward",
                tier="full",
                form="corrected",
                given={"both": True},
                routes=(
                    "nets before and after the corner moves",
                    "distances by SL(2, R) frames",
                ),
                mutants=(
                    Mutant(name="inward", given={"both": True, "direction": -1}),
                    Mutant(
                        name="by one and a half edges",
                        given={"both": True, "least": "3/2"},
                        near=True,
                    ),
                    Mutant(name="any move", given={"both": False}),
                ),
            ),
        ),
        erratum=Erratum(
            printed="no branch point enters the disk as their parents move outward",
            corrected=(
                "none does while both coordinates of the parents grow; where one grows alone, far "
                "off the mirror line, later branch points can come nearer to the origin"
            ),
            kind="hypothesis",
            witness=(
                "$m = 6$, edges of $1/20$: when the corner moves from vertex $(14, 3)$ to "
                "$(14, 4)$ of its sector, some points of the daughters come nearer to the origin, "
                "by $0.004$"
            ),
            conclusion_survives=True,
            remark="Points at one place of their sector were followed, where $\\varphi < \\pi/2$.",
        ),
        rests_on=("4.1.dual-5-monotone",),
    ),
    Claim(
        id="4.1.dual-6-termination",
        section="4.1",
        where="section 4.1, dual interpretation, item (6), line 1415",
        kind="item",
        statement="The greedy algorithm ends after finitely many steps.",
        hypotheses=(
            "(read so) on the radii looked at, up to 7: a proof for all is not known",
            _MONO,
            _SIGN,
            _SMALL,
        ),
        checks=(
            Check(
                name="runs",
                run="checks.verify.greedy_dual_result:ends",
                tier="full",
                routes=("runs of discrete.greedy", "area of the disk in closed form"),
                mutants=(
                    Mutant(name="1300 cuts", given={"most": 1300}, near=True),
                    Mutant(name="500 cuts", given={"most": 500}),
                ),
            ),
        ),
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
            NEEDED,
            (
                "(used, not stated) only sectors that were never cut are counted: the count $M$ "
                "of step 24 keeps those that were cut"
            ),
        ),
        rests_on=("4.1.dual-6-termination", "4.1.algorithm-24-count", "4.1.dual-1-generations"),
        checks=(
            Check(
                name="sectors never cut",
                run="checks.verify.greedy_dual_result:sectors",
                tier="full",
                routes=("runs of discrete.greedy", "m_0 by the mirror line (mpmath)"),
                mutants=(
                    Mutant(name="g - 1", given={"shift": -1}, near=True),
                    Mutant(name="M of step 24", given={"count": "all"}),
                    Mutant(name="m_0 for phi < pi", given={"by": "edge"}),
                ),
            ),
            Check(
                name="sectors never cut, n in place of g",
                run="checks.verify.greedy_dual_result:sectors",
                tier="full",
                form="corrected",
                given={"by": "n"},
                routes=("runs of discrete.greedy", "m_0 by the mirror line (mpmath)"),
                mutants=(
                    Mutant(name="n - 1", given={"shift": -1}, near=True),
                    Mutant(name="all sectors", given={"count": "all"}),
                    Mutant(name="g", given={"by": "cutoff"}),
                ),
            ),
        ),
        erratum=Erratum(
            printed="$M \\leq 2 \\cdot 3^g m$",
            corrected=(
                "at most $2 \\cdot 3^n m$ sectors were never cut, $n$ the number of generations; "
                "$M \\leq (3^{n+1} - 1) m$ in all"
            ),
            kind="false",
            witness=(
                "$R = 7$, $m = 6$, $\\phi^* = \\pi/2$, edges of $1/50$ or $1/100$: $g = 4$, also "
                "where $m_0$ only keeps $\\varphi < \\pi$, and $2 \\cdot 3^g m = 972$, while the "
                "greedy algorithm ends with $M = 3576$ sectors, 2388 of which were never cut"
            ),
            conclusion_survives=False,
        ),
    ),
    Claim(
        id="4.1.dual-6-six-m0",
        section="4.1",
        where="section 4.1, dual interpretation, item (6), line 1415",
        kind="equation",
        statement=r"$2 \cdot 3^g m < 6 m_0$.",
        hypotheses=("$3^{g-1} m < m_0$",),
        rests_on=("4.1.dual-1-generations",),
        checks=(
            Check(
                name="all m and m_0",
                run=_GENERATIONS + "six",
                routes=("printed bound", "printed condition on g, all m_0 up to 900"),
                mutants=(
                    Mutant(name="5.99 m_0", given={"times": "599/100"}, near=True),
                    Mutant(name="5 m_0", given={"times": "5"}),
                    Mutant(name="> 6 m_0", given={"strict": False}),
                ),
            ),
        ),
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
            NEEDED,
            (
                "(read so) on the radii looked at, up to 7: the reason given, at most $g$ "
                r"generations, fails at $R = 4$, $\phi^* = 2\pi/5$ already"
            ),
        ),
        rests_on=("4.1.dual-6-termination", "5.1.monotone"),
        checks=(
            Check(
                name="runs",
                run="checks.verify.greedy_dual_result:least_angle",
                tier="full",
                routes=("runs of discrete.greedy", "m_0 by the mirror line (mpmath)"),
                mutants=(
                    Mutant(name="g - 1", given={"shift": -1}, near=True),
                    Mutant(name="m_0 for phi < pi", given={"by": "edge"}),
                ),
            ),
            Check(
                name="n in place of g",
                run="checks.verify.greedy_dual_result:least_angle",
                tier="full",
                form="support",
                given={"by": "n"},
                routes=("runs of discrete.greedy", "3^-n pi/m, n by the tree of the run"),
                mutants=(
                    Mutant(name="n - 1", given={"shift": -1}, near=True),
                    Mutant(name="m_0 for phi < pi", given={"by": "edge"}),
                ),
            ),
        ),
    ),
    Claim(
        id="4.1.dual-6-energy-in-generations",
        section="4.1",
        where="section 4.1, dual interpretation, item (6), line 1415",
        kind="item",
        statement=r"$\mathcal{E}_\infty < C\, 3^g m$ with a constant $C$ independent of $R$.",
        hypotheses=(
            _MONO,
            _DUAL,
            r"(used, not stated) $C$ may depend on $\phi^*$",
            (
                r"(used, not stated) $g$ by the $m_0$ that keeps $\varphi < \pi$: by $\varphi \leq "
                r"\phi^*$ it is not smaller, and the bound holds all the more"
            ),
            "(read so) on the radii looked at, up to 7",
        ),
        rests_on=("4.1.dual-6-smallest-angle", "ebound"),
        checks=(
            Check(
                name="runs, C = 1.1",
                run="checks.verify.greedy_dual_result:energy",
                tier="full",
                routes=("runs of discrete.greedy", "m_0 by the mirror line (mpmath)"),
                mutants=(Mutant(name="C = 1", given={"constant": "1"}, near=True),),
            ),
            Check(
                name="from the bound on the angles",
                form="support",
                run=_GENERATIONS + "energy",
                routes=("printed bound, C = 0.637 > 2/pi", "(ebound)"),
                mutants=(
                    Mutant(name="C = 0.63", given={"constant": "63/100"}, near=True),
                    Mutant(name="m from 1 on", given={"least_index": 1}),
                ),
            ),
        ),
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
        hypotheses=(
            _MONO,
            _DUAL,
            r"$m_0 \sim C e^R$",
            (
                r"(used, not stated) $m_0$ keeps $\varphi \leq \pi/2$ in the disk, or only "
                r"$\varphi < \pi$; for $\phi^* < \pi/2$, $C'$ depends on $\phi^*$"
            ),
        ),
        rests_on=("4.1.dual-6-energy-in-generations", "4.1.dual-saddle-order"),
        checks=(
            Check(
                name="with C' = 4.2",
                run=_ORDER + "energy",
                tier="full",
                routes=(
                    "theory.periodic_amsler_bounds",
                    "m_0 by the mirror line up to phi = pi/2 (mpmath)",
                ),
                mutants=(
                    Mutant(name="e^(9R/10)", given={"rate": "9/10"}, near=True),
                    Mutant(name="C' = 0.1", given={"most": "1/10"}),
                ),
            ),
        ),
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
            Check(
                name="in balls, R = 3 and 5",
                run="checks.verify.greedy_certificates:made_anew",
                tier="full",
                routes=(
                    "discrete.certified_greedy (angles and heights carried in balls)",
                    "checks.certificates.greedy (points of the hyperboloid by half-turns)",
                ),
                mutants=(
                    Mutant(name="one column more", given={"alter": "column"}, near=True),
                    Mutant(name="0.99 phi*", given={"alter": "cutoff"}, near=True),
                    Mutant(name="one branch point more", given={"alter": "branch points"}),
                    Mutant(name="the angle at a cut in its tenth digit", given={"alter": "angle"}),
                    Mutant(name="an area in its tenth digit", given={"alter": "area"}),
                ),
            ),
            Check(
                name="stored certificates, R = 6",
                run="checks.verify.greedy_certificates:stored",
                tier="full",
                routes=(
                    "stored run in balls",
                    "checks.certificates.greedy (points of the hyperboloid by half-turns)",
                ),
                mutants=(
                    Mutant(name="one column more", given={"alter": "column"}, near=True),
                    Mutant(name="the angle at a cut in its tenth digit", given={"alter": "angle"}),
                    Mutant(name="an area in its tenth digit", given={"alter": "area"}),
                ),
            ),
        ),
        rests_on=("alg:greedy-cuts",),
    ),
)
