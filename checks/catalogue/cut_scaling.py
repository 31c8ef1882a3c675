"""Claims of section 5.1, all sectors: cut coordinates, observed bounds, the smallest angle."""

from checks.claim import Claim

_RUN = "measured on runs of the greedy algorithm"
_ASSUME = "the bound observed on all nodes holds for all $R$"

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="5.1.most-sectors-pseudo-amsler",
        section="5.1",
        where="section 5.1, line 1542",
        kind="sentence",
        statement=(
            "Most sectors of the greedy algorithm are not Amsler sectors: of the three at each "
            "cut one is."
        ),
        hypotheses=("(used, not stated) counted without the initial sectors",),
        rests_on=("alg:greedy-cuts", "def:amsler-sector"),
    ),
    Claim(
        id="5.1.one-geodesic-axis",
        section="5.1",
        where="section 5.1, line 1542",
        kind="sentence",
        statement=(
            "The other sectors are pseudo-Amsler sectors: exactly one of the bounding curves is "
            "a geodesic."
        ),
        hypotheses=(
            "(used, not stated) the line taken from the parent is not itself an axis of it",
        ),
        rests_on=("5.1.most-sectors-pseudo-amsler",),
    ),
    Claim(
        id="eq:cut-coordinates",
        section="5.1",
        where="equation (eq:cut-coordinates), line 1546",
        kind="definition",
        statement=(
            r"$\alpha_n^2 = \frac{1}{4 "
            r"s_n}\left(I_0^{-1}\left(\frac{\phi^*}{\phi_n}\right)\right)^2$, with $s_n$ the "
            r"distance of the branch point from $\partial\Omega$."
        ),
        labels=("eq:cut-coordinates",),
        hypotheses=(
            r"(used, not stated) $\phi_n < \phi^*$",
            "(used, not stated) for a disk $s_n = R - d(0, p)$",
        ),
        rests_on=("5.1.zeta",),
    ),
    Claim(
        id="5.1.distance-against-axes",
        section="5.1",
        where="section 5.1, line 1549",
        kind="equation",
        statement=r"$s_n^2 \geq u_{\max} v_{\max}$.",
        hypotheses=(
            "$s_n$ as in (eq:cut-coordinates)",
            (
                r"(used, not stated) $u_{\max}, v_{\max}$ are the lengths of the axes from the "
                "branch point to the boundary"
            ),
        ),
        rests_on=("eq:cut-coordinates",),
    ),
    Claim(
        id="5.1.zeta-against-alpha",
        section="5.1",
        where="section 5.1, line 1549",
        kind="sentence",
        statement=r"$\zeta_n$ is like $2\alpha_n^2$.",
        hypotheses=(
            (
                r"(used, not stated) equality where $s_n^2 = u_{\max} v_{\max}$, as for the "
                "sectors at the origin"
            ),
        ),
        rests_on=("5.1.zeta", "eq:cut-coordinates"),
    ),
    Claim(
        id="5.1.sufficient-inequality",
        section="5.1",
        where="section 5.1, line 1549",
        kind="sentence",
        statement=(
            r"If $\phi_{n+1}/\phi_n \geq f(2C\alpha_n^2)$ with $C > 0$ independent of $R$ and $f "
            r"\geq 1$ for large arguments, then all sectors have $\phi_n \geq "
            r"\phi^*/I_0(C'\sqrt{R})$, as Amsler sectors do."
        ),
        hypotheses=(
            r"(used, not stated) $s_n \leq R$",
            r"(used, not stated) $\phi_{n+1} \geq \phi_n/3$ for every sector",
            "(used, not stated) $R$ and the constant $C'$ are large enough",
        ),
        rests_on=("5.1.smallest-angle-amsler", "eq:cut-coordinates"),
    ),
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
    ),
    Claim(
        id="5.1.supporting-constant",
        section="5.1",
        where="caption of figure (fig:frontier), line 1575",
        kind="number",
        statement=r"$f_2(\alpha) \approx 0.73\,\alpha^2$, that is $(\alpha^*)^{-2} \approx 0.73$.",
        rests_on=("5.1.supporting-quadratic",),
    ),
    Claim(
        id="5.1.infimum-is-alpha-star",
        section="5.1",
        where="section 5.1, observation 2, line 1554",
        kind="equation",
        statement=r"$\inf_{w > 0}\frac{I_0(2w^2)}{3w^2} = (\alpha^*)^{-2}$.",
        rests_on=("5.1.alpha-star",),
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
        hypotheses=(r"$\pi/6 \leq \phi_0 < \phi^* \leq 4\pi/5$, $R \geq 6$", _RUN),
        rests_on=("fig:frontier",),
    ),
    Claim(
        id="5.1.two-families",
        section="5.1",
        where="section 5.1, observation 2, line 1554",
        kind="sentence",
        statement=(
            "The points fall into two families, those of Amsler and of pseudo-Amsler sectors."
        ),
        hypotheses=(_RUN,),
        rests_on=("fig:frontier", "5.1.most-sectors-pseudo-amsler"),
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
        hypotheses=(r"(used, not stated) $\zeta_n = 2\alpha_n^2$",),
        rests_on=("lem:amsler_recursion", "5.1.zeta-against-alpha"),
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
        hypotheses=(_RUN,),
        rests_on=("5.1.two-families",),
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
        rests_on=("5.1.two-families", "5.1.infimum-is-alpha-star"),
    ),
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
    ),
)
