"""Claims of the opening of section 5, the branched surfaces of the greedy algorithm."""

from checks.claim import Check, Citation, Claim, Mutant

_SCALING = "checks.verify.energy_scaling:"
_LARGE = (
    r"(used, not stated) $R \geq R_0 > 0$: as $R \to 0$ the infimum tends to $1$ and its "
    "logarithm is of order $R^2$ at most"
)

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="fig:energywithradius",
        section="5",
        where="figure (fig:energywithradius), lines 1436, 1450, 1460",
        kind="figure",
        statement=(
            r"$\mathcal{E}_\infty$ against $R$ for Minding's bobbins, periodic Amsler surfaces "
            "and branched surfaces of the greedy algorithm."
        ),
        labels=("fig:energywithradius",),
        hypotheses=(
            r"(used, not stated) $m$, $\phi^*$ and $\Delta$ of the branched surfaces are not given",
        ),
        rests_on=("eq:c2energy", "5.periodic-amsler-one-branch-point", "alg:greedy-cuts"),
        checks=(
            Check(
                name="below the bobbins",
                run="checks.verify.energy_figure:below",
                part="bobbins",
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
                name="below one branch point",
                run="checks.verify.energy_figure:below_amsler",
                tier="full",
                part="one branch point",
                routes=(
                    "finest stored nets and the limit of edge length 0",
                    "theory.periodic_amsler (balls)",
                ),
                mutants=(
                    Mutant(name="from R = 4 on", given={"lowest": "4"}, near=True),
                    Mutant(name="runs twice as much", given={"factor": "2"}),
                ),
            ),
        ),
    ),
    Claim(
        id="fig:cutdepthwithradius",
        section="5",
        where="figure (fig:cutdepthwithradius), lines 1442, 1450, 1460",
        kind="figure",
        statement="The largest depth $n$ of the recursion as a function of $R$ grows linearly.",
        labels=("fig:cutdepthwithradius",),
        hypotheses=(r"(used, not stated) $m$, $\phi^*$ and $\Delta$ are not given",),
        rests_on=("alg:greedy-cuts",),
        checks=(
            Check(
                name="a line, within rounding",
                run="checks.verify.cut_depth:law",
                tier="full",
                routes=(
                    "radii of the generations by bisection on nets",
                    "depth in the limit of edge length 0",
                ),
                mutants=(
                    Mutant(name="from the first generation on", given={"lowest": 1}, near=True),
                    Mutant(name="root of R", given={"power": "1/2"}),
                    Mutant(name="R^2", given={"power": "2"}),
                ),
            ),
        ),
    ),
    Claim(
        id="fig:numerical_crochet",
        section="5",
        where="figure (fig:numerical_crochet), lines 1448, 1450, 1461",
        kind="figure",
        statement=(
            "A surface with distributed branch points that the greedy algorithm makes on the "
            "disk of radius $R = 3$."
        ),
        labels=("fig:numerical_crochet",),
        hypotheses=(r"(used, not stated) $m$, $\phi^*$ and $\Delta$ are not given",),
        rests_on=("alg:greedy-cuts",),
        checks=(
            Check(
                name="surface in space",
                run="checks.verify.comparison_nets:crochet",
                tier="full",
                routes=("K-surface in space", "net in H^2"),
                mutants=(
                    Mutant(name="R = 5/2", given={"radius": "5/2"}, near=True),
                    Mutant(name="edges 1 % longer", given={"percent": 101}, near=True),
                    Mutant(name="nine branch points", given={"fewest": 9}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="ebs",
        section="5",
        where="equation (ebs), line 1455",
        kind="equation",
        statement=r"$\log\inf_{r \in C^{1,1}}\mathcal{E}_\infty[r] \sim \sqrt{R}$.",
        labels=("ebs",),
        hypotheses=(
            "the infimum is over $C^{1,1}$ isometric immersions of the disk of radius $R$",
            "conjectured",
            _LARGE,
        ),
        rests_on=("5.scaling-symbol", "ebound", "alg:greedy-cuts"),
        citation=Citation(
            source="conjecture of the paper",
            reason=(
                "an infimum over all branched immersions, for which no bound from below is "
                "known; on "
                "the runs the best power of R in the logarithm falls from 0.7 on 3 <= R <= 16 "
                "to 0.5 "
                "on 8 <= R <= 16, see (5.branched-exponential-root)"
            ),
        ),
        checks=(
            Check(
                name="runs grow by less",
                run="checks.verify.greedy_growth:sub_exponential",
                tier="full",
                form="support",
                routes=("energies in the limit of edge length 0", "interval of the best power"),
                mutants=(
                    Mutant(name="power 3/4", given={"rival": "3/4"}, near=True),
                    Mutant(name="power 1/2", given={"rival": "1/2"}),
                ),
            ),
            Check(
                name="below the bobbins",
                run="checks.verify.energy_figure:below",
                form="support",
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
                name="below one branch point",
                run="checks.verify.energy_figure:below_amsler",
                tier="full",
                form="support",
                routes=(
                    "finest stored nets and the limit of edge length 0",
                    "theory.periodic_amsler (balls)",
                ),
                mutants=(
                    Mutant(name="from R = 4 on", given={"lowest": "4"}, near=True),
                    Mutant(name="runs twice as much", given={"factor": "2"}),
                ),
            ),
        ),
    ),
    Claim(
        id="5.energy-separation",
        section="5",
        where="section 5, line 1458",
        kind="sentence",
        statement=(
            r"The quotient of the least $\mathcal{E}_\infty$ of smooth and of branched "
            "isometries grows without bound with $R$."
        ),
        hypotheses=("(e2) and (ebs)",),
        checks=(
            Check(
                name="quotient of the two scalings",
                run=_SCALING + "separation",
                routes=("printed exponents", "limit for any two constants"),
                mutants=(
                    Mutant(name="equal powers", given={"power": "1"}),
                    Mutant(name="R^(11/10)", given={"power": "11/10"}, near=True),
                ),
            ),
        ),
        rests_on=("e2", "ebs"),
    ),
    Claim(
        id="5.cut-depth-linear",
        section="5",
        where="section 5, line 1458",
        kind="sentence",
        statement=(
            "The cut depth, the number of generations of branch points, grows linearly with $R$."
        ),
        hypotheses=(
            (
                r"(read so) a line within half a generation on $3 \leq R \leq 10$, what rounding "
                "makes; the slope increases slowly, see (5.1.cut-depth-observed)"
            ),
            r"greedy algorithm, $m$ and $\phi^*$ fixed",
        ),
        rests_on=("fig:cutdepthwithradius",),
        checks=(
            Check(
                name="a line, within rounding",
                run="checks.verify.cut_depth:law",
                tier="full",
                routes=(
                    "radii of the generations by bisection on nets",
                    "depth in the limit of edge length 0",
                ),
                mutants=(
                    Mutant(name="from the first generation on", given={"lowest": 1}, near=True),
                    Mutant(name="root of R", given={"power": "1/2"}),
                    Mutant(name="R^2", given={"power": "2"}),
                ),
            ),
        ),
    ),
    Claim(
        id="5.evidence-to-radius-10",
        section="5",
        where="section 5, line 1460",
        kind="sentence",
        statement=(
            "Runs of the greedy algorithm on disks of radius up to $10$ agree with the scaling "
            "of energy and cut depth."
        ),
        hypotheses=(r"(used, not stated) $m$, $\phi^*$ and $\Delta$ of the runs",),
        rests_on=("ebs", "5.cut-depth-linear", "alg:greedy-cuts"),
        checks=(
            Check(
                name="energy",
                run="checks.verify.greedy_growth:energy_law",
                tier="full",
                part="energy",
                routes=("energies in the limit", "AIC of the laws"),
                mutants=(
                    Mutant(name="R^(2/5)", given={"power": "2/5"}, near=True),
                    Mutant(name="R^(1/10)", given={"power": "1/10"}),
                ),
            ),
            Check(
                name="cut depth",
                run="checks.verify.cut_depth:law",
                tier="full",
                part="cut depth",
                routes=(
                    "radii of the generations by bisection on nets",
                    "depth in the limit of edge length 0",
                ),
                mutants=(
                    Mutant(name="from the first generation on", given={"lowest": 1}, near=True),
                    Mutant(name="root of R", given={"power": "1/2"}),
                    Mutant(name="R^2", given={"power": "2"}),
                ),
            ),
        ),
    ),
    Claim(
        id="5.branched-exponential-root",
        section="5",
        where="section 5, line 1460",
        kind="sentence",
        statement=(
            r"With distributed branch points the energy seems to scale like $\exp(c\sqrt{R})$."
        ),
        hypotheses=(r"$R \leq 10$",),
        checks=(
            Check(
                name="R <= 10",
                run="checks.verify.greedy_growth:energy_law",
                tier="full",
                routes=("energies in the limit", "AIC of the laws"),
                mutants=(
                    Mutant(name="R^(2/5)", given={"power": "2/5"}, near=True),
                    Mutant(name="R^(1/10)", given={"power": "1/10"}),
                ),
            ),
        ),
        rests_on=("fig:energywithradius", "ebs"),
    ),
)
