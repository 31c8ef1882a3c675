"""Claims of the remark (rmk:distributed) on curvatures and where branch points are needed."""

from checks.claim import Check, Claim, Mutant

_BALANCE = "checks.verify.balanced_curvature:"
_TILINGS = "checks.verify.branched_sine_gordon:"

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="rmk:distributed",
        section="3.5",
        where="remark (rmk:distributed), line 984",
        kind="remark",
        statement=(
            r"Since $\varphi \equiv \frac\pi2$ is impossible, low energy needs branch points "
            r"distributed over $\Omega$ so that $A(\Gamma)$ and $\sum_{p_i\in\Gamma} (m_i-2)\pi$ "
            r"nearly cancel for every Hamburger polygon that is not small."
        ),
        labels=("rmk:distributed",),
        hypotheses=(r"the energy is the Willmore or the $W^{2,\infty}$ energy",),
        rests_on=(
            "sg-global",
            "3.5.right-angle-optimal",
            "3.5.right-angle-impossible",
            "3.5.one-branch-point-per-area-pi",
        ),
        checks=(
            Check(
                name="bound by the angle",
                run=_BALANCE + "near_cancellation",
                routes=(
                    "signs at the vertices of random tilings",
                    "sine-Gordon equation",
                ),
                mutants=(
                    Mutant(name="half of delta a vertex", given={"per_vertex": 50}),
                    Mutant(name="0.99 delta a vertex", given={"per_vertex": 99}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="3.5.principal-curvatures",
        section="3.5",
        where="remark (rmk:distributed), line 985",
        kind="equation",
        statement=(
            r"The principal curvatures are $\kappa_1 = \tan\frac\varphi2$ and $\kappa_2 = "
            r"-\cot\frac\varphi2$."
        ),
        hypotheses=(
            r"$0 < \varphi < \pi$, for both signs of $\sigma$",
            (
                r"(used, not stated) they are the eigenvalues of $dN^\omega$, as $h = "
                r"dN^\omega \cdot dr$ suggests; those of $-dN^\omega$ are $-\tan\frac\varphi2$ and "
                r"$\cot\frac\varphi2$, for both signs of $\sigma$"
            ),
        ),
        rests_on=("eq:metrics",),
        checks=(
            Check(
                name="shape operator",
                run=_BALANCE + "principal_curvatures",
                routes=(
                    "fundamental forms of nets and explicit surfaces",
                    "the printed formulas",
                ),
                mutants=(
                    Mutant(name="both positive", given={"second": 1}),
                    Mutant(name="-dN for dN", given={"shape": "-dN"}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.5.curvature-product",
        section="3.5",
        where="remark (rmk:distributed), line 985",
        kind="equation",
        statement=r"$\kappa_1\kappa_2 = -1$.",
        hypotheses=(r"$0 < \varphi < \pi$",),
        rests_on=("3.5.principal-curvatures",),
        checks=(
            Check(
                name="product",
                run=_BALANCE + "curvature_product",
                routes=(
                    "the printed formulas",
                    "-1",
                ),
                mutants=(
                    Mutant(name="both positive", given={"second": 1}),
                    Mutant(name="cot phi", given={"halves": 2}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.5.willmore-density",
        section="3.5",
        where="remark (rmk:distributed), line 985",
        kind="definition",
        statement=(
            r"The Willmore energy has the density $\kappa_1^2 + \kappa_2^2 = \tan^2\frac\varphi2 + "
            r"\cot^2\frac\varphi2$."
        ),
        rests_on=("3.5.principal-curvatures",),
        checks=(
            Check(
                name="instance and near-miss",
                run=_BALANCE + "willmore_density",
                routes=(
                    "4 H^2 - 2 K from the forms",
                    "the printed density",
                ),
                mutants=(Mutant(name="sum of the curvatures", given={"power": 1}),),
            ),
        ),
    ),
    Claim(
        id="3.5.max-curvature-energy",
        section="3.5",
        where="remark (rmk:distributed), line 985",
        kind="definition",
        statement=(
            r"The $W^{2,\infty}$ energy is $\sup_{x\in\Omega}\max(|\kappa_1(x)|,|\kappa_2(x)|) = "
            r"\sup_\Omega\max(\tan\frac\varphi2,\cot\frac\varphi2)$."
        ),
        hypotheses=(r"(used, not stated) the supremum is essential: $r$ is $C^{1,1}$ only",),
        rests_on=("3.5.principal-curvatures",),
        checks=(
            Check(
                name="instance and near-miss",
                run=_BALANCE + "largest_curvature",
                routes=(
                    "the larger of tan and cot",
                    "the printed maximum",
                ),
                mutants=(Mutant(name="no absolute values", given={"absolute": False}),),
            ),
        ),
    ),
    Claim(
        id="3.5.right-angle-optimal",
        section="3.5",
        where="remark (rmk:distributed), line 985",
        kind="sentence",
        statement=(
            r"Both $\kappa_1^2+\kappa_2^2$ and $\max(|\kappa_1|,|\kappa_2|)$ are least at $\varphi "
            r"= \frac\pi2$ and only there, so both energies ask for $\varphi \approx \frac\pi2$ "
            r"everywhere."
        ),
        hypotheses=(r"$0 < \varphi < \pi$",),
        rests_on=(
            "3.5.willmore-density",
            "3.5.max-curvature-energy",
        ),
        checks=(
            Check(
                name="both energies",
                run=_BALANCE + "right_angle_optimal",
                routes=(
                    "differences of the energies",
                    "their sign",
                ),
                mutants=(
                    Mutant(name="tan(phi/2) = 2", given={"best": 2}),
                    Mutant(name="sum of the curvatures", given={"power": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.5.right-angle-sum-vanishes",
        section="3.5",
        where="remark (rmk:distributed), line 987",
        kind="sentence",
        statement=(
            r"If $\varphi \equiv \frac\pi2$, the left side of (sg-global) is zero, a Hamburger "
            r"polygon having as many vertices of sign $+$ as of sign $-$."
        ),
        hypotheses=(r"$\varphi = \frac\pi2$ at every vertex",),
        rests_on=(
            "sg-global",
            "3.5.hamburger-polygon",
        ),
        checks=(
            Check(
                name="signs",
                run=_BALANCE + "right_angle_sum",
                routes=(
                    "polygons of a grid",
                    "boundaries of random tilings",
                ),
                mutants=(Mutant(name="one more vertex", given={"extra": 1}, near=True),),
            ),
        ),
    ),
    Claim(
        id="3.5.right-side-of-two-signs",
        section="3.5",
        where="remark (rmk:distributed), line 987",
        kind="sentence",
        statement=(
            r"The right side of (sg-global) is the difference of two positive quantities, "
            r"$A(\Gamma)$, which varies continuously with $\Gamma$, and $\sum_{p_i\in\Gamma} "
            r"(m_i-2)\pi$, a multiple of $\pi$."
        ),
        hypotheses=(
            (
                r"(used, not stated) $\Gamma$ contains a branch point; otherwise the second "
                r"quantity is $0$"
            ),
        ),
        rests_on=("sg-global",),
        checks=(
            Check(
                name="stars of order 3",
                run=_BALANCE + "two_quantities",
                routes=(
                    "certified PIII at the corners",
                    "multiples of pi",
                ),
                mutants=(
                    Mutant(name="order 2", given={"order": 2}, near=True),
                    Mutant(name="1.01 pi", given={"percent": 101}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="3.5.right-angle-impossible",
        section="3.5",
        where="remark (rmk:distributed), line 987",
        kind="sentence",
        statement=(
            r"No branched pseudospherical immersion has $\varphi \equiv \frac\pi2$ on an open set."
        ),
        hypotheses=(r"finitely many branch points, isolated",),
        rests_on=(
            "3.5.right-angle-sum-vanishes",
            "3.5.right-side-of-two-signs",
        ),
        checks=(
            Check(
                name="constant angle",
                run=_BALANCE + "right_angle_impossible",
                routes=(
                    "derivatives of a constant",
                    "sine-Gordon equation of either sigma",
                ),
                mutants=(Mutant(name="phi = pi", given={"halves": 2}),),
            ),
        ),
    ),
    Claim(
        id="3.5.one-branch-point-per-area-pi",
        section="3.5",
        where="remark (rmk:distributed), line 987",
        kind="number",
        statement=(
            r"Cancellation in (sg-global) asks for one branch point with $m = 3$ per area $\pi$ on "
            r"average: $A(\Gamma) = \sum_{p_i\in\Gamma} (m_i-2)\pi$."
        ),
        hypotheses=(
            r"all branch points have $m = 3$",
            r"$\varphi \approx \frac\pi2$ at the vertices",
        ),
        rests_on=("sg-global",),
        checks=(
            Check(
                name="cancellation",
                run=_BALANCE + "area_per_branch_point",
                routes=(
                    "alternating sum of the angles at the centre",
                    "the printed area",
                ),
                mutants=(
                    Mutant(name="order 4", given={"order": 4}, near=True),
                    Mutant(name="1.01 pi", given={"percent": 101}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="3.5.extra-undulation",
        section="3.5",
        where="remark (rmk:distributed), line 987",
        kind="sentence",
        statement=(
            r"Each branch point with $m = 3$ adds one undulation to the surface, which persists "
            r"from the branch point to the boundary."
        ),
        hypotheses=(r"$m = 3$: the excess over a regular saddle is $m-2 = 1$",),
        rests_on=("def:m-saddle",),
        checks=(
            Check(
                name="sectors at the point",
                run=_BALANCE + "sectors_added",
                part="point",
                routes=(
                    "signs of star saddles",
                    "one more above and below",
                ),
                mutants=(
                    Mutant(name="order 4", given={"order": 4}, near=True),
                    Mutant(name="two more", given={"added": 2}, near=True),
                ),
            ),
            Check(
                name="corners of the boundary",
                run=_TILINGS + "undulations",
                part="boundary",
                tier="full",
                routes=(
                    "degrees on the boundary of random tilings",
                    "charges inside",
                ),
                mutants=(Mutant(name="one corner", given={"per_charge": 1}, near=True),),
            ),
        ),
    ),
)
