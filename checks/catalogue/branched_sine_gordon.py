"""Claims of section 3.5, the sine-Gordon equation with branch points."""

from checks.claim import Claim

_THEOREM: tuple[Claim, ...] = (
    Claim(
        id="thm:sg-branched",
        section="3.5",
        where="theorem (thm:sg-branched), line 973",
        kind="theorem",
        statement=(
            r"For a branched pseudospherical immersion $r : (\Omega,g) \to \mathbb R^3$ and every "
            r"domain $\Gamma$ bounded by a Hamburger polygon, the alternating sum of $\varphi$ "
            r"over the vertices is the area less $(m_i-2)\pi$ for each branch point $p_i \in "
            r"\Gamma$, as (sg-global) states."
        ),
        labels=("thm:sg-branched",),
        hypotheses=(
            (
                r"$r$ is a branched pseudospherical immersion with finitely many branch points "
                r"$p_1, \ldots, p_k$"
            ),
            r"$\Gamma \subset \Omega$ has compact closure in $\Omega$",
            (
                r"$\gamma = \partial\Gamma$ is a Hamburger polygon with vertices $q_0, \ldots, "
                r"q_{2j-1}$"
            ),
            r"$q_0$ is the initial vertex of a $u$-arc with respect to the orientation $\omega$",
            r"(used, not stated) no branch point lies on $\gamma$",
            (
                r"(used, not stated) no vertex $q_n$ lies on an asymptotic curve incident on a "
                r"branch point, or $\varphi(q_n)$ is the limit from within $\Gamma$"
            ),
        ),
        rests_on=(
            "eq:hazzidakis",
            "lem:m-star",
            "3.5.decomposition",
            "3.5.additivity",
            "3.5.angle-in-the-theorem",
            "def:branched_immersion",
        ),
    ),
    Claim(
        id="sg-global",
        section="3.5",
        where="equation (sg-global), line 976",
        kind="equation",
        statement=(
            r"$\Delta_\Gamma \equiv \sum_{n=0}^{2j-1} (-1)^n\varphi(q_n) = A(\Gamma) - "
            r"\sum_{p_i\in\Gamma} (m_i-2)\pi$."
        ),
        labels=("sg-global",),
        hypotheses=(
            (
                r"the vertices $q_n$ follow each other along $\gamma$ in the orientation induced "
                r"by $\omega$, starting at the initial vertex of a $u$-arc"
            ),
            (
                r"(used, not stated) no branch point lies on $\gamma$, and $\varphi$ is defined at "
                r"each $q_n$"
            ),
        ),
        rests_on=("thm:sg-branched",),
    ),
    Claim(
        id="3.5.angle-in-the-theorem",
        section="3.5",
        where="theorem (thm:sg-branched), line 978",
        kind="definition",
        statement=(
            r"$\sigma = \mathrm{sign}(\omega(\partial_u r,\partial_v r))$, $\varphi \in (0,\pi)$, "
            r"$\sin\varphi = \|\partial_u r\times\partial_v r\|$, $\cos\varphi = "
            r"\sigma\,\partial_u r\cdot\partial_v r$ determine one angle, that of (eq:def_phi), "
            r"which does not change under $u \to -u$ or $v \to -v$."
        ),
        hypotheses=(r"(used, not stated) $\|\partial_u r\| = \|\partial_v r\| = 1$",),
        rests_on=("eq:def_phi",),
    ),
    Claim(
        id="3.5.decomposition",
        section="3.5",
        where="proof of theorem (thm:sg-branched), line 981",
        kind="sentence",
        statement=(
            r"$\Gamma = \bigcup_{j=1}^N \Gamma_j$ is a finite union of $m$-stars, each around one "
            r"branch point, and asymptotic quadrilaterals; each piece is bounded by a Hamburger "
            r"polygon."
        ),
        hypotheses=(
            r"$\overline\Gamma$ is compact and contains finitely many branch points",
            r"(used, not stated) no branch point lies on $\partial\Gamma$",
        ),
        rests_on=(
            "defn:quad",
            "def:m-star",
            "3.5.stars-are-hamburger-polygons",
        ),
    ),
    Claim(
        id="3.5.additivity",
        section="3.5",
        where="proof of theorem (thm:sg-branched), line 981",
        kind="equation",
        statement=(
            r"$\Delta_\Gamma = \sum_{j=1}^M \Delta_{\Gamma_j}$ over the $N$ pieces, since $\omega$ "
            r"orients an edge common to two pieces in opposite ways; and $A(\Gamma) = \sum_j "
            r"A(\Gamma_j)$."
        ),
        hypotheses=(
            (
                r"(used, not stated) $\oint\alpha$ along an edge common to two pieces takes the "
                r"same value from both sides, also across a jump of $\varphi$"
            ),
            (
                r"(used, not stated) pieces may meet at a vertex of one in the middle of a side of "
                r"another"
            ),
        ),
        rests_on=(
            "3.5.decomposition",
            "3.5.vertex-signs",
            "3.5.angle-derivatives-match",
        ),
    ),
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
        waits_for=("5",),
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
                r"(used, not stated) the sign convention of the second fundamental form with "
                r"respect to $N^\omega$: the other one gives $\cot\frac\varphi2$ and "
                r"$-\tan\frac\varphi2$"
            ),
        ),
        rests_on=("eq:metrics",),
    ),
    Claim(
        id="3.5.curvature-product",
        section="3.5",
        where="remark (rmk:distributed), line 985",
        kind="equation",
        statement=r"$\kappa_1\kappa_2 = -1$.",
        hypotheses=(r"$0 < \varphi < \pi$",),
        rests_on=("3.5.principal-curvatures",),
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
    ),
)

CLAIMS: tuple[Claim, ...] = _THEOREM
