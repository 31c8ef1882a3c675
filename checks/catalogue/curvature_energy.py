"""Claims of the opening of section 5, the curvatures by the angle and the margin delta."""

from checks.claim import Check, Claim, Erratum, Mutant

_ENERGY = "checks.verify.curvature_energy:"
_EDGE = "checks.verify.edge_energy:"
_EINF = (
    r"(used, not stated) $\mathcal{E}_\infty$ is the least upper bound of $|\kappa_1|, "
    r"|\kappa_2|$ on the disk $B_R$"
)

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="5.principal-curvatures",
        section="5",
        where="section 5, line 1422",
        kind="equation",
        statement=(
            r"The principal curvatures are $\kappa_1 = \pm\tan\frac{\varphi}{2}$ and $\kappa_2 = "
            r"\mp\cot\frac{\varphi}{2}$."
        ),
        hypotheses=(r"$0 < \varphi < \pi$ is the angle between the asymptotic directions",),
        rests_on=("eq:metrics",),
        checks=(
            Check(
                name="shape operator",
                run=_ENERGY + "principal_curvatures",
                routes=("printed pair", "theory.forms (Gauss-Weingarten)"),
                mutants=(
                    Mutant(name="whole angle", given={"half": "1"}),
                    Mutant(name="0.51 of the angle", given={"half": "51/100"}, near=True),
                    Mutant(name="two tangents", given={"second": "tan"}),
                    Mutant(name="equal signs", given={"opposite": False}),
                ),
            ),
        ),
    ),
    Claim(
        id="5.max-curvature-diverges",
        section="5",
        where="section 5, line 1422",
        kind="sentence",
        statement=(
            r"The $W^{2,\infty}$ energy is infinite when a singular edge, $\varphi = 0$ or "
            r"$\varphi = \pi$, comes into $\Omega$."
        ),
        rests_on=("5.principal-curvatures",),
        checks=(
            Check(
                name="limits at the edges",
                run=_ENERGY + "max_curvature",
                routes=("printed pair", "limits of (1 + |cos phi|)/sin phi"),
                mutants=(
                    Mutant(name="right angle", given={"ends": "middle"}),
                    Mutant(name="smaller curvature", given={"of": "smaller"}),
                ),
            ),
        ),
    ),
    Claim(
        id="5.willmore-diverges",
        section="5",
        where="section 5, line 1422",
        kind="sentence",
        statement=(
            r"The $W^{2,2}$ energy is infinite when a singular edge, $\varphi = 0$ or $\varphi = "
            r"\pi$, comes into $\Omega$."
        ),
        hypotheses=(
            (
                r"(used, not stated) the edge comes into the interior of $\Omega$. On a disk whose "
                r"rim is tangent to the edge $\mathcal{E}_\infty$ is infinite, but the $W^{2,2}$ "
                "energy is finite"
            ),
            (
                r"(used, not stated) $\varphi$ is Lipschitz in $(u, v)$ where the edge is a curve, "
                r"and of class $C^{1,1}$ where $\varphi$ takes the value $0$ or $\pi$ at one point "
                "only: at a corner of its graph the energy is finite"
            ),
        ),
        rests_on=("5.principal-curvatures", "eq:metrics"),
        checks=(
            Check(
                name="edges that are crossed or touched",
                run=_EDGE + "willmore",
                routes=(
                    "theory.edge_energy (angle of a net)",
                    "theory.bobbin:bending_density",
                ),
                mutants=(
                    Mutant(name="first power of the curvatures", given={"power": 1}),
                    Mutant(
                        name="rim tangent to the edge",
                        given={"curve": "rim tangent to the edge"},
                    ),
                    Mutant(name="corner at one point", given={"point": "point, corner"}),
                ),
            ),
            Check(
                name="Amsler sectors cross theirs",
                run=_EDGE + "amsler_crosses",
                form="support",
                routes=("rate of a crossing", "theory.painleve (balls)"),
                mutants=(
                    Mutant(name="a quarter of the way", given={"level": "1/4", "least": "1"}),
                    Mutant(name="rate 2", given={"least": "2"}),
                    Mutant(name="3/40", given={"least": "3/40"}, near=True),
                ),
            ),
            Check(
                name="logarithmic growth in an Amsler sector",
                tier="full",
                run=_EDGE + "amsler_growth",
                form="support",
                routes=("2 z*/phi'(z*) log(1/e)", "theory.edge_energy_float (quadrature)"),
                mutants=(
                    Mutant(name="1 % more", given={"factor": "101/100"}, near=True),
                    Mutant(name="order 2", given={"order": 2}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="5.distance-from-singular",
        section="5",
        where="section 5, line 1422",
        kind="definition",
        statement=(
            r"$\delta(\Omega) > 0$ measures how far an immersion of $\Omega$ stays from being "
            r"singular: $0 < \delta \leq \varphi \leq \pi - \delta < \pi$."
        ),
        hypotheses=(
            r"(used, not stated) $\delta$ is the largest such number, so $\delta \leq \pi/2$",
        ),
        rests_on=("eq:def_phi",),
        checks=(
            Check(
                name="ranges and near-misses",
                run=_ENERGY + "margin",
                routes=("printed inequalities", "min(least phi, pi - greatest phi)"),
                mutants=(Mutant(name="bound from below only", given={"side": "below"}),),
            ),
        ),
    ),
    Claim(
        id="5.energy-of-delta",
        section="5",
        where="section 5, line 1422",
        kind="equation",
        statement=r"$\mathcal{E}_\infty = \cot\delta$.",
        hypotheses=(
            r"$\delta$ as just defined",
            r"(used, not stated) $\delta$ is the largest such number",
            _EINF,
        ),
        rests_on=("5.distance-from-singular", "5.principal-curvatures"),
        checks=(
            Check(
                name="as printed",
                run=_ENERGY + "energy_of_margin",
                routes=("printed cot", "theory.curvature:principal_curvatures"),
                mutants=(
                    Mutant(name="cot(delta/4)", given={"half": "1/4"}),
                    Mutant(name="cot(2 delta)", given={"half": "2"}),
                ),
            ),
            Check(
                name="half of delta",
                run=_ENERGY + "energy_of_margin",
                form="corrected",
                given={"half": "1/2"},
                routes=("cot(delta/2)", "theory.curvature:principal_curvatures"),
                mutants=(
                    Mutant(name="0.51 delta", given={"half": "51/100"}, near=True),
                    Mutant(name="cot(delta)", given={"half": "1"}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"$\mathcal{E}_\infty = \cot\delta$",
            corrected=r"$\mathcal{E}_\infty = \cot\frac{\delta}{2}$",
            kind="constant",
            witness=(
                r"$\varphi = \delta = \pi/2$: the principal curvatures are $1$ and $-1$, so "
                r"$\mathcal{E}_\infty = 1$, but $\cot\delta = 0$"
            ),
            conclusion_survives=True,
            remark=(
                r"$\kappa_2 = \mp\cot\frac{\varphi}{2}$ at $\varphi = \delta$, and $\kappa_1$ at "
                r"$\varphi = \pi - \delta$; always $\mathcal{E}_\infty \geq 1$, while $\cot\delta$ "
                r"is less than $1$ for $\delta > \pi/4$. On the best disk of the bobbin "
                r"$\cot\frac\delta2 = \cosh R$. For small $\delta$ the printed value is about "
                r"half the right one, which no statement on $\log\mathcal{E}_\infty$ notices. "
                r"(ebound) has the right form"
            ),
        ),
    ),
)
