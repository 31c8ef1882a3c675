"""Claims of section 4.1, one branch point of high index and the start of the dual."""

from checks.claim import Check, Claim, Erratum, Mutant

_ORDER = "checks.verify.greedy_dual_saddle_order:"
_GENERATIONS = "checks.verify.greedy_dual_generations:"

#: How m_0 is read from item (1) on: the reading in which most of what is said of g holds.
NEEDED = (
    r"(read so) $m_0$ is the least order that keeps $\varphi \leq \phi^*$ in the disk, as the "
    r"algorithm does; where it only keeps $\varphi < \pi$, $g$ is at most as large, and the bounds "
    "by $g$ fail from smaller $R$ on"
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
        checks=(
            Check(
                name="enough sectors",
                run=_ORDER + "exists",
                tier="full",
                routes=(
                    "length of the mirror line up to phi = pi (mpmath)",
                    "theory.periodic_amsler (balls)",
                ),
                mutants=(Mutant(name="m_0 - 1", given={"offset": -1}, near=True),),
            ),
        ),
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
                r"$\pi/m$ cover the disk of radius $R$ without a singular edge; the same holds of "
                r"the least for which $\varphi \leq \phi^*$ there, tried for $\phi^* = \pi/2$"
            ),
            (
                r"(used, not stated) $\sim$ means that the quotient tends to $1$ or at least "
                r"stays between constants as $R \to \infty$"
            ),
        ),
        rests_on=("4.1.periodic-amsler", "PIII"),
        checks=(
            Check(
                name="as printed",
                run=_ORDER + "scale",
                routes=("printed e^R", "length of the mirror line up to phi = pi (mpmath)"),
                mutants=(
                    Mutant(name="R^(1/10) e^R", given={"power": "1/10"}, near=True),
                    Mutant(name="R^(1/2) e^R", given={"power": "1/2"}),
                ),
            ),
            Check(
                name="with 1/sqrt(R)",
                run=_ORDER + "scale",
                form="corrected",
                given={"power": "-1/2"},
                routes=("R^(-1/2) e^R", "length of the mirror line up to phi = pi (mpmath)"),
                mutants=(
                    Mutant(name="R^(-2/5)", given={"power": "-2/5"}, near=True),
                    Mutant(name="R^(-3/5)", given={"power": "-3/5"}, near=True),
                    Mutant(name="as printed", given={"power": "0"}),
                ),
            ),
            Check(
                name="with 1/sqrt(R), phi <= pi/2 in the disk",
                run=_ORDER + "scale",
                form="corrected",
                given={"power": "-1/2", "level": "1/2"},
                routes=("R^(-1/2) e^R", "length of the mirror line up to phi = pi/2 (mpmath)"),
                mutants=(
                    Mutant(name="R^(-2/5)", given={"power": "-2/5"}, near=True),
                    Mutant(name="as printed", given={"power": "0"}),
                ),
            ),
            Check(
                name="constant",
                run=_ORDER + "constant",
                form="support",
                routes=("(pi/2) I_0(R)", "length of the mirror line up to phi = pi (mpmath)"),
                mutants=(
                    Mutant(name="1 % less", given={"factor": "99/100"}, near=True),
                    Mutant(name="I_0(R)", given={"factor": "7/11"}),
                ),
            ),
            Check(
                name="bound from above",
                run=_ORDER + "bound_above",
                form="support",
                tier="full",
                routes=(
                    "theory.periodic_amsler_bounds",
                    "length of the mirror line up to phi = pi (mpmath)",
                ),
                mutants=(
                    Mutant(name="0.62, below the limit by 1 %", given={"most": "31/50"}, near=True),
                    Mutant(name="1/2", given={"most": "1/2"}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"$m_0 \sim C e^R$",
            corrected=r"$m_0 \sim \sqrt{\pi/8}\, R^{-1/2} e^R$, the same as $\frac{\pi}{2} I_0(R)$",
            kind="false",
            witness=(
                r"$m_0 e^{-R} = 0.1809, 0.1351, 0.0988, 0.0712, 0.0509$ at $R = 12, 22, 40, 77, "
                r"151$ falls like $R^{-1/2}$, and $m_0 \leq 2.15\, R^{-1/2} e^R$ for all $R \geq "
                "1$"
            ),
            conclusion_survives=True,
            remark=(
                "Read as a bound from above, $m_0 = O(e^R)$ is all that items (1) and (6) use: "
                r"$g \sim R/\log 3$ and $\mathcal{E}_\infty < C' e^R$ stay. Where $m_0$ is to keep "
                r"$\varphi \leq \phi^*$, $\sqrt{\pi/8}$ gives way to another constant."
            ),
        ),
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
        checks=(
            Check(
                name="one g for every m and m_0",
                run=_GENERATIONS + "generations",
                routes=("printed condition, all g from -3 to 8", "m_0 <= m' < 3 m_0"),
                mutants=(
                    Mutant(name="<= on both sides", given={"closed": True}),
                    Mutant(name="g + 1", given={"shift": 1}, near=True),
                    Mutant(name="2^g m", given={"base": 2}),
                ),
            ),
        ),
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
        hypotheses=(NEEDED,),
        rests_on=("4.1.dual-1-generations",),
        checks=(
            Check(
                name="runs",
                run="checks.verify.greedy_dual_result:depth",
                tier="full",
                routes=("runs of discrete.greedy", "m_0 by the mirror line (mpmath)"),
                mutants=(
                    Mutant(name="g + 1", given={"more": 1}, near=True),
                    Mutant(name="m_0 for phi < pi", given={"by": "edge"}),
                ),
            ),
            Check(
                name="at least g",
                run="checks.verify.greedy_dual_result:depth",
                tier="full",
                form="corrected",
                given={"exactly": False},
                routes=("runs of discrete.greedy", "m_0 by the mirror line (mpmath)"),
                mutants=(
                    Mutant(name="at least g + 1", given={"more": 1}, near=True),
                    Mutant(name="exactly g", given={"exactly": True}),
                ),
            ),
            Check(
                name="growth of g",
                run=_ORDER + "depth_growth",
                form="support",
                routes=("printed R/log 3", "length of the mirror line up to phi = pi (mpmath)"),
                mutants=(
                    Mutant(name="1 % more", given={"rate": "101/100"}, near=True),
                    Mutant(name="2 R", given={"rate": "2"}),
                ),
            ),
        ),
        erratum=Erratum(
            printed="$g$ is the number of generations",
            corrected=(
                "the greedy algorithm has at least $g$ generations of branch points, and more as "
                "$R$ grows"
            ),
            kind="false",
            witness=(
                "$m = 6$, $\\phi^* = \\pi/2$, edges of $1/50$ or $1/100$: at $R = 5$ the order "
                "$m_0 = 61$ keeps $\\varphi \\leq \\phi^*$, so that $g = 3$, while the greedy "
                "algorithm has 4 generations; at $R = 7$, $g = 4$, also where $m_0$ only keeps "
                "$\\varphi < \\pi$, and there are 6 generations"
            ),
            conclusion_survives=False,
        ),
    ),
)
