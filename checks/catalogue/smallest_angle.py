"""Claims of section 5.1, all sectors: the smallest angle and the energy bound."""

from checks.claim import Check, Claim, Erratum, Mutant

_ANGLE = "checks.verify.smallest_angle:"
_FLOOR = "checks.verify.angle_floor:"
_ASSUME = "the bound observed on all nodes holds for all $R$"

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="5.1.smallest-angle",
        section="5.1",
        where="section 5.1, displayed formula, line 1580",
        kind="equation",
        statement=(
            r"$(\alpha^*)^2 = "
            r"\frac{1}{4R}\left[I_0^{-1}\left(\frac{\phi^*}{\phi_{\min}}\right)\right]^2$ gives "
            r"$\phi_{\min} = \frac{\phi^*}{I_0(2\alpha^*\sqrt{R})}$."
        ),
        hypotheses=(r"(used, not stated) $\phi_{\min} \leq \phi^*$",),
        rests_on=("eq:cut-coordinates", "5.1.alpha-star"),
        checks=(
            Check(
                name="solved",
                run=_ANGLE + "solved",
                routes=("printed phi_min", "printed equation, solved"),
                mutants=(
                    Mutant(name="alpha* sqrt R", given={"factor": "1"}),
                    Mutant(name="2.02 alpha* sqrt R", given={"factor": "101/50"}, near=True),
                ),
            ),
            Check(
                name="inverted",
                run=_ANGLE + "inverted",
                routes=("printed phi_min", "inverse of I_0 by interval Newton"),
                mutants=(Mutant(name="2.02 alpha* sqrt R", given={"factor": "101/50"}, near=True),),
            ),
        ),
    ),
    Claim(
        id="5.1.smallest-angle-decay",
        section="5.1",
        where="section 5.1, displayed formula, line 1580",
        kind="equation",
        statement=r"$\phi_{\min} \sim \exp(-\alpha^*\sqrt{2R})$ as $R$ grows.",
        hypotheses=(
            (
                r"(used, not stated) $\sim$ compares the rate in the exponent, apart from powers "
                "of $R$"
            ),
        ),
        rests_on=("5.1.smallest-angle",),
        checks=(
            Check(
                name="as printed",
                run=_ANGLE + "decay",
                routes=("printed exponent", "bounds of I_0(y) sqrt(y) e^-y, and I_0 by balls"),
                mutants=(Mutant(name="exp(-alpha* sqrt R)", given={"under": 1}),),
            ),
            Check(
                name="2 alpha* sqrt R",
                run=_ANGLE + "decay",
                form="corrected",
                given={"factor": "2", "under": 1, "power": "1/4"},
                routes=(
                    "R^(1/4) exp(-2 alpha* sqrt R)",
                    "bounds of I_0(y) sqrt(y) e^-y, and I_0 by balls",
                ),
                mutants=(
                    Mutant(name="2.02 alpha*", given={"factor": "101/50"}, near=True),
                    Mutant(name="R^(7/20)", given={"power": "7/20"}, near=True),
                    Mutant(name="no power of R", given={"power": "0"}),
                    Mutant(name="as printed", given={"factor": "1", "under": 2, "power": "0"}),
                ),
            ),
            Check(
                name="rate, whatever power of R",
                run=_ANGLE + "rate",
                form="support",
                given={"factor": "2", "under": 1},
                routes=("2 alpha*", "-log(phi_min/phi*)/sqrt R by balls"),
                mutants=(
                    Mutant(name="sqrt(2) alpha*", given={"factor": "1", "under": 2}),
                    Mutant(name="2.05 alpha*", given={"factor": "41/20"}, near=True),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"$\frac{\phi^*}{I_0(2\alpha^*\sqrt{R})} \sim \exp(-\alpha^*\sqrt{2R})$",
            corrected=(
                r"$\frac{\phi^*}{I_0(2\alpha^*\sqrt{R})} \sim R^{1/4}\exp(-2\alpha^*\sqrt{R})$: "
                r"the rate in $\sqrt{R}$ is $2\alpha^* = 2.342$, not $\sqrt2\alpha^* = 1.656$"
            ),
            kind="constant",
            witness=(
                r"$-\log(\phi_{\min}/\phi^*)/\sqrt{R}$ is $2.306$ for $R = 10^4$ and $2.337$ for "
                r"$R = 10^6$; for $R = 10^4$, $\phi_{\min}/\phi^* = 7.3 \cdot 10^{-101}$ and "
                r"$\exp(-\alpha^*\sqrt{2R}) = 1.2 \cdot 10^{-72}$"
            ),
            conclusion_survives=True,
            remark=(
                r"No power of $R$ repairs it. (ebs) needs only $-\log\phi_{\min} \sim \sqrt{R}$, "
                "which holds."
            ),
        ),
    ),
    Claim(
        id="5.1.no-smaller-angle",
        section="5.1",
        where="section 5.1, line 1582",
        kind="sentence",
        statement=(
            r"As $s_n < R$, $\phi_{n+1}/\phi_n \geq (\alpha_n/\alpha^*)^2 \geq 1$ whenever "
            r"$\phi_n \leq \phi_{\min}$; so no angle falls below $\phi_{\min}$."
        ),
        hypotheses=(
            _ASSUME,
            (
                r"(used, not stated) from $\phi_n > \phi_{\min}$ no single cut leads below: true "
                r"when $R$ is so large that $\phi_{\min}$ is a small part of $\phi^*$"
            ),
            r"(used, not stated) $\phi_0 \geq \phi_{\min}$",
        ),
        rests_on=("5.1.pseudo-amsler-nodes", "5.1.amsler-nodes", "5.1.smallest-angle"),
        checks=(
            Check(
                name="growth below phi_min",
                run=_FLOOR + "growth_below",
                part="growth",
                routes=("printed alpha_n^2", "printed phi_min"),
                mutants=(Mutant(name="s_n < 2 R", given={"room": 2}),),
            ),
            Check(
                name="as printed, every R",
                run=_FLOOR + "floor",
                part="floor",
                routes=("printed phi_min", "lowest angle after one cut (theory.angle_floor)"),
                mutants=(Mutant(name="R >= 1", given={"least": "1"}),),
            ),
            Check(
                name="R at least 33/16",
                run=_FLOOR + "floor",
                part="floor",
                form="corrected",
                given={"least": "33/16"},
                routes=("printed phi_min", "lowest angle after one cut (theory.angle_floor)"),
                mutants=(
                    Mutant(name="R >= 41/20", given={"least": "41/20"}, near=True),
                    Mutant(name="a quarter kept", given={"drop": 4}),
                ),
            ),
            Check(
                name="least radius",
                run=_FLOOR + "least_radius",
                form="support",
                routes=("interval Newton on the series", "mpmath on I_0(Y) = 3 I_0(Y/sqrt 3)"),
                mutants=(Mutant(name="2.08", given={"value": "2.08"}, near=True),),
            ),
            Check(
                name="on a grid of angles",
                run=_FLOOR + "lowest_on_grid",
                form="support",
                routes=("bounds observed, at 400 angles", "phi_min (mpmath)"),
                mutants=(Mutant(name="R = 41/20", given={"radii": "41/20"}, near=True),),
            ),
            Check(
                name="small disks",
                run=_FLOOR + "daughters_below",
                form="support",
                routes=("printed phi_min", "daughters have at most phi*/3"),
                mutants=(Mutant(name="R = 1.04", given={"radius": "26/25"}, near=True),),
            ),
        ),
        erratum=Erratum(
            printed=r"no angle falls below $\phi_{\min}$",
            corrected=(
                r"so for $R \geq R_0 = 2.05699491638609$, where $I_0(Y) = 3 I_0(Y/\sqrt3)$ with "
                r"$Y = 2\alpha^*\sqrt{R_0}$; for smaller $R$ one cut from above $\phi_{\min}$ may "
                "lead below"
            ),
            kind="hypothesis",
            witness=(
                r"$R = 1$: $\phi_{\min} = 0.342\phi^*$, while a daughter has at most $\phi^*/3$; "
                r"with $\phi_0 = \pi/2$, $\phi^* = 1.6$ the disk of radius $1$ has daughters, as "
                r"$\varphi$ exceeds $1.6$ at $u = v = 1/4$"
            ),
            conclusion_survives=True,
            remark=(
                r"The growth of the angles at most $\phi_{\min}$ holds for every $R$; what is left "
                r"out is the cut from above $\phi_{\min}$. $R_0$ does not depend on $\phi^*$."
            ),
        ),
    ),
    Claim(
        id="5.1.energy-bound-follows",
        section="5.1",
        where="section 5.1, line 1582",
        kind="sentence",
        statement=r"$\phi_{n,k} \geq \phi_{\min}$ for all branch points and (ebound) give (ebs).",
        hypotheses=(
            _ASSUME,
            (
                "(used, not stated) only the upper bound of (ebs) follows: nothing is said "
                "against still lower energies"
            ),
        ),
        rests_on=("5.1.no-smaller-angle", "5.1.smallest-angle-decay", "ebound"),
        checks=(
            Check(
                name="as printed, both sides",
                run=_ANGLE + "energy_bound",
                routes=("printed phi_min and (ebound)", "angles that stay at phi*/3"),
                mutants=(Mutant(name="rate 2.3", given={"rate": "23/10"}, near=True),),
            ),
            Check(
                name="upper bound",
                run=_ANGLE + "energy_bound",
                form="corrected",
                given={"side": "upper"},
                routes=("printed phi_min and (ebound)", "cot(x/2) <= 2/x and I_0(y) <= e^y"),
                mutants=(
                    Mutant(name="rate 2.3", given={"rate": "23/10"}, near=True),
                    Mutant(name="both sides", given={"side": "both"}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"$\log\inf\mathcal{E}_\infty \sim \sqrt{R}$ follows",
            corrected=(
                r"$\log\inf\mathcal{E}_\infty \leq 3\sqrt{R}$ for $R \geq 3$ follows (the rate "
                r"tends to $2\alpha^* = 2.342$); the opposite bound does not"
            ),
            kind="hypothesis",
            witness=(
                r"both premises hold if all angles stay at $\phi^*/3$, where $\mathcal{E}_\infty$ "
                r"does not depend on $R$: $\phi^* = \pi/2$ gives $\log\cot(\pi/12) = 1.317$"
            ),
            conclusion_survives=True,
            remark=(
                r"A lower bound on angles bounds $\mathcal{E}_\infty$ of one construction from "
                r"above. That no branched immersion does better than $\exp(c\sqrt{R})$ is not "
                "argued for."
            ),
        ),
    ),
)
