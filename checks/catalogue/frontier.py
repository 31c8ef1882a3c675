"""Claims of section 5.1, all sectors: the curves of the scatter plots, the bounds observed."""

from checks.claim import Check, Claim, Erratum, Mutant

_CUTS = "checks.verify.cut_coordinates:"
_QUADRATIC = "checks.verify.supporting_quadratic:"
_CERTIFIED = "theory.bessel (balls)"
_REFERENCE = "theory.bessel_reference (mpmath)"
_RUN = "measured on runs of the greedy algorithm"

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="fig:frontier",
        section="5.1",
        where="figure (fig:frontier), lines 1551 and 1556-1577",
        kind="figure",
        statement=(
            r"$\phi_{n+1}/\phi_n$ against $\alpha_n^2$ at each cut, with $f_1$ and $f_2$: (a) $R "
            r"= 8$, $\phi_0 = \pi/6$, $\phi^* = 4\pi/5$; (b) $R = 8$, $\phi_0 = \pi/2$, $\phi^* "
            r"= 3\pi/4$; (c) $R = 10$, $\phi_0 = \pi/4$, $\phi^* = 4\pi/5$."
        ),
        labels=(
            "fig:frontier",
            "fig:frontierR8phi016",
            "fig:frontierR8phi012",
            "fig:frontierR10phi014",
        ),
        hypotheses=(r"(used, not stated) $\Delta$ is not given",),
        checks=(
            Check(
                name="panels",
                run="checks.verify.greedy_frontier:figure",
                tier="full",
                routes=("runs on three edge lengths", "printed curves"),
                mutants=(
                    Mutant(name="f_1 1 % more", given={"share": "101/300"}, near=True),
                    Mutant(name="f_2 a quarter more", given={"factor": "5/4"}),
                ),
            ),
        ),
        rests_on=("alg:greedy-cuts", "eq:cut-coordinates", "5.1.alpha-star"),
    ),
    Claim(
        id="5.1.alpha-star",
        section="5.1",
        where="section 5.1, line 1551",
        kind="definition",
        statement=(
            r"$f_1(\alpha) = \frac13 I_0(2\alpha^2)$ and $\alpha^* = \sup_{w \geq "
            r"0}\frac{w}{\sqrt{f_1(w)}}$."
        ),
        checks=(
            Check(
                name="largest quotient",
                run=_QUADRATIC + "largest_quotient",
                routes=("printed quotient, by subdivision of [0, 8]", _CERTIFIED),
                mutants=(
                    Mutant(name="I_0(2.02 w^2)", given={"inside": "101/50"}, near=True),
                    Mutant(name="I_0(2 w^3)", given={"power": 3}),
                ),
            ),
            Check(
                name="where it is taken",
                run=_QUADRATIC + "taken",
                form="support",
                routes=(_CERTIFIED, _REFERENCE),
                mutants=(
                    Mutant(name="I_0(w^2)", given={"inside": "1"}),
                    Mutant(name="I_0(2.02 w^2)", given={"inside": "101/50"}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="5.1.supporting-quadratic",
        section="5.1",
        where="section 5.1, line 1551",
        kind="equation",
        statement=(
            r"$f_2(\alpha) = (\alpha/\alpha^*)^2$ supports $f_1$: $f_2 \leq f_1$ everywhere, "
            r"with equality at some $\alpha > 0$."
        ),
        rests_on=("5.1.alpha-star",),
        checks=(
            Check(
                name="tangent",
                run=_QUADRATIC + "supports",
                routes=("printed f_2", "value, slope and convexity of f_1 in alpha^2"),
                mutants=(
                    Mutant(name="1 % more", given={"factor": "101/100"}, near=True),
                    Mutant(name="1 % less", given={"factor": "99/100"}, near=True),
                    Mutant(name="cubic", given={"power": 3}),
                ),
            ),
            Check(
                name="below, cell by cell",
                run=_QUADRATIC + "below",
                tier="full",
                form="support",
                routes=("printed f_2", "enclosures of f_1 on cells of [0, 4]"),
                mutants=(
                    Mutant(name="1 % more", given={"factor": "101/100"}, near=True),
                    Mutant(name="a tenth more", given={"factor": "11/10"}),
                ),
            ),
        ),
    ),
    Claim(
        id="5.1.supporting-constant",
        section="5.1",
        where="caption of figure (fig:frontier), line 1575",
        kind="number",
        statement=r"$f_2(\alpha) \approx 0.73\,\alpha^2$, that is $(\alpha^*)^{-2} \approx 0.73$.",
        rests_on=("5.1.supporting-quadratic",),
        checks=(
            Check(
                name="two places",
                run=_QUADRATIC + "constant",
                routes=(_CERTIFIED, _REFERENCE),
                mutants=(
                    Mutant(name="0.74", given={"value": "0.74"}, near=True),
                    Mutant(name="0.72", given={"value": "0.72"}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="5.1.infimum-is-alpha-star",
        section="5.1",
        where="section 5.1, observation 2, line 1554",
        kind="equation",
        statement=r"$\inf_{w > 0}\frac{I_0(2w^2)}{3w^2} = (\alpha^*)^{-2}$.",
        rests_on=("5.1.alpha-star",),
        checks=(
            Check(
                name="quotients",
                run=_QUADRATIC + "infimum",
                routes=("printed quotient", "power -2 of the quotient of alpha*"),
                mutants=(
                    Mutant(name="2 w^2 below", given={"under": 2}),
                    Mutant(name="I_0(w^2)", given={"inside": "1"}),
                    Mutant(name="w below", given={"power": 1}),
                ),
            ),
            Check(
                name="least value",
                run=_QUADRATIC + "least_value",
                form="support",
                routes=("printed quotient, by subdivision of [1/4, 4]", _CERTIFIED),
                mutants=(
                    Mutant(name="I_0(2.02 w^2)", given={"inside": "101/50"}, near=True),
                    Mutant(name="4 w^2 below", given={"under": 4}),
                ),
            ),
        ),
    ),
    Claim(
        id="5.1.plots-agree",
        section="5.1",
        where="section 5.1, observation 1, line 1553",
        kind="sentence",
        statement=(
            r"The plots do not depend on $\phi_0$, $\phi^*$ and $R$ once there are enough branch "
            "points."
        ),
        hypotheses=(
            (
                "(read so) enough: a thousand branch points; the same: medians at "
                "pseudo-Amsler nodes "
                r"within a quarter in every bin of $\alpha_n^2$"
            ),
            r"$\pi/6 \leq \phi_0 < \phi^* \leq 4\pi/5$, $R \geq 6$",
            _RUN,
        ),
        rests_on=("fig:frontier",),
        checks=(
            Check(
                name="medians of the pseudo-Amsler nodes",
                run="checks.verify.greedy_frontier:plots_agree",
                tier="full",
                routes=(
                    "runs with a thousand branch points or more",
                    "medians in bins of alpha_n^2",
                ),
                mutants=(
                    Mutant(name="panel (c) a tenth more", given={"shifted": "11/10"}, near=True),
                    Mutant(name="panel (c) a quarter more", given={"shifted": "5/4"}),
                ),
            ),
            Check(
                name="cutoffs from 3 pi/5 on",
                run="checks.verify.greedy_frontier:plots_agree",
                tier="full",
                form="corrected",
                given={"cutoffs": "large"},
                routes=(
                    "runs with a thousand branch points or more",
                    "medians in bins of alpha_n^2",
                ),
                mutants=(
                    Mutant(
                        name="panel (c) a tenth more",
                        given={"cutoffs": "large", "shifted": "11/10"},
                        near=True,
                    ),
                    Mutant(
                        name="panel (c) a quarter more",
                        given={"cutoffs": "large", "shifted": "5/4"},
                    ),
                    Mutant(name="pi/2 too", given={"cutoffs": "all"}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=(
                r"the plots are essentially the same for $\pi/6 \leq \phi_0 < \phi^* \leq "
                r"4\pi/5$"
            ),
            corrected=r"so for $3\pi/5 \leq \phi^* \leq 4\pi/5$",
            kind="hypothesis",
            witness=(
                r"$R = 8$, $\phi_0 = \pi/6$, $\phi^* = \pi/2$, $3085$ branch points: for $3/4 \leq "
                r"\alpha_n^2 < 1$ the median of $\phi_{n+1}/\phi_n$ at pseudo-Amsler nodes is "
                r"$0.71$, "
                "in panels (a) to (c) 0.86, 0.90, 0.95"
            ),
            conclusion_survives=True,
            remark=r"Another run with the cutoff $\pi/2$ agrees with the panels within a quarter.",
        ),
    ),
    Claim(
        id="5.1.two-families",
        section="5.1",
        where="section 5.1, observation 2, line 1554",
        kind="sentence",
        statement=(
            "The points fall into two families, those of Amsler and of pseudo-Amsler sectors."
        ),
        hypotheses=(
            _RUN,
            (
                r"(read so) two: apart for $\alpha_n^2 \geq 5/4$, where every Amsler node is above "
                r"all others relative to $f_1$; for smaller $\alpha_n$ they overlap"
            ),
        ),
        rests_on=("fig:frontier", "5.1.most-sectors-pseudo-amsler"),
        checks=(
            Check(
                name="families apart",
                run="checks.verify.greedy_frontier:two_families",
                tier="full",
                routes=("sides of the sectors", "quotient by the printed f_1"),
                mutants=(
                    Mutant(name="from alpha_n^2 = 1 on", given={"least": "1"}, near=True),
                    Mutant(name="Amsler only on the diagonals", given={"marked": "diagonals"}),
                ),
            ),
        ),
    ),
    Claim(
        id="5.1.amsler-nodes",
        section="5.1",
        where="section 5.1, observation 2, line 1554",
        kind="equation",
        statement=r"At Amsler nodes $\frac{\phi_{n+1}}{\phi_n} \geq \frac13 I_0(2\alpha_n^2)$.",
        hypotheses=(
            _RUN,
            (
                r"(used, not stated) the branch point sits on the contours of $\varphi$ itself, "
                "not where the lemma puts it"
            ),
        ),
        checks=(
            Check(
                name="counted",
                run="checks.verify.greedy_frontier:amsler_nodes",
                tier="full",
                routes=("runs", "printed bound"),
                mutants=(
                    Mutant(name="1 % more", given={"share": "101/300"}, near=True),
                    Mutant(name="other nodes", given={"family": "pseudo"}),
                ),
            ),
        ),
        rests_on=("5.1.two-families", "rem:amsler_scaling"),
    ),
    Claim(
        id="5.1.best-possible-bound",
        section="5.1",
        where="section 5.1, observation 2, line 1554",
        kind="sentence",
        statement=(
            r"$\frac13 I_0(2\alpha_n^2)$ is the best bound that the lemma could give, that with "
            r"$C(\phi^*) = 1$."
        ),
        hypotheses=(
            (
                r"(used, not stated) $\zeta_n = 2\alpha_n^2$, by the intuition for $\alpha_n$; so "
                r"it is for the sectors at the centre. Elsewhere $\zeta_n < 2\alpha_n^2$, against "
                "(5.1.distance-against-axes), and the printed bound is more than the lemma gives"
            ),
        ),
        rests_on=("lem:amsler_recursion", "5.1.zeta-against-alpha"),
        checks=(
            Check(
                name="axes of length s_n",
                run=_CUTS + "best_bound",
                routes=("printed bound", "corner of the cut (theory.cut_corner)"),
                mutants=(
                    Mutant(name="C = 9/10", given={"constant": "9/10"}),
                    Mutant(name="I_0(alpha_n^2)", given={"inside": "1"}),
                    Mutant(name="any axes", given={"axes": "any"}),
                ),
            ),
            Check(
                name="larger than the lemma's",
                run=_CUTS + "lemma_bound_below",
                form="support",
                routes=("printed bound", "corner of the cut (theory.cut_corner)"),
                mutants=(Mutant(name="I_0(alpha_n^2)", given={"inside": "1"}),),
            ),
        ),
    ),
    Claim(
        id="5.1.pseudo-amsler-violate",
        section="5.1",
        where="section 5.1, observation 2, line 1554",
        kind="sentence",
        statement=(
            r"Pseudo-Amsler nodes do not satisfy $\frac{\phi_{n+1}}{\phi_n} \geq \frac13 "
            r"I_0(2\alpha_n^2)$."
        ),
        hypotheses=(_RUN, r"(read so) some of them in every run; about half do not for $R \geq 8$"),
        rests_on=("5.1.two-families",),
        checks=(
            Check(
                name="counted",
                run="checks.verify.greedy_frontier:violations",
                tier="full",
                routes=("runs", "printed bound"),
                mutants=(
                    Mutant(name="Amsler nodes", given={"family": "amsler"}),
                    Mutant(name="half of the nodes at least", given={"least": "1/2"}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="5.1.pseudo-amsler-nodes",
        section="5.1",
        where="section 5.1, observation 2, line 1554",
        kind="equation",
        statement=(
            r"At pseudo-Amsler nodes $\frac{\phi_{n+1}}{\phi_n} \geq \max\left(\frac13, "
            r"\left(\frac{\alpha_n}{\alpha^*}\right)^2\right)$."
        ),
        hypotheses=(_RUN,),
        checks=(
            Check(
                name="counted",
                run="checks.verify.greedy_frontier:pseudo_amsler_nodes",
                tier="full",
                routes=("runs", "printed bound"),
                mutants=(
                    Mutant(name="f_2 a quarter more", given={"factor": "5/4"}),
                    Mutant(name="1/2 kept", given={"drop": 2}, near=True),
                ),
            ),
        ),
        rests_on=("5.1.two-families", "5.1.infimum-is-alpha-star"),
    ),
)
