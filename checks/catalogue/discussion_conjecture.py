"""Claims of section 6, the discussion: the conjecture and what follows from it."""

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
                tier="full",
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
