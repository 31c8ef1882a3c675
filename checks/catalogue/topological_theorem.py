"""Claims of section 3.3, branch points cannot be smoothed away: the theorem and its lemma."""

from checks.claim import Claim

_BRANCHED = (
    (
        r"$\Omega \subset \mathbb{H}^2$ a proper open subset, $y : \Omega \to \mathbb{R}^3$ a "
        r"branched pseudospherical immersion, $p \in \Omega$"
    ),
)
_SEQUENCE = (
    (
        r"$\Omega \subseteq \mathbb{H}^2$ open and simply connected, $y : \Omega \to \mathbb{R}^3$ "
        r"a $C^{1,1}$ immersion, possibly with branch points"
    ),
    (
        r"$y_n : \Omega \to \mathbb{R}^3$ $C^2$ pseudospherical immersions, $y_n \to y$ in "
        r"$W^{2,2}_{\mathrm{loc}}$, $\mathcal{E}_\infty[y_n] \le k_{\max}$ for all $n$"
    ),
    r"(used, not stated) $y$ is a branched pseudospherical immersion",
)
_BALL = (r"$B_{3\epsilon}(p) \subseteq \Omega$, $0 < \epsilon < \min(\eta(k_{\max}), \delta(p))$",)

_INJECTIVE = (
    Claim(
        id="lem:injective",
        section="3.3",
        where="lemma (lem:injective), lines 745-751",
        kind="lemma",
        statement=r"For each $p \in \Omega$ there are $\delta > 0$ and $d_0 > 0$ for which the "
        "normal map has the properties 1 and 2.",
        labels=("lem:injective",),
        hypotheses=(*_BRANCHED, r"(used, not stated) $B_{3\delta}(p) \subset \Omega$"),
        rests_on=("3.3.punctured-ball", "3.3.collar-distance"),
    ),
    Claim(
        id="3.3.punctured-ball",
        section="3.3",
        where="lemma (lem:injective), item 1, line 747",
        kind="item",
        statement=r"$N(x) \ne N(p)$ for every $x \in B_{2\delta}(p) \setminus \{p\}$.",
        hypotheses=_BRANCHED,
        rests_on=("3.3.smooth-punctured-ball", "3.3.sector-extension", "3.3.minimal-radius"),
    ),
    Claim(
        id="3.3.collar-distance",
        section="3.3",
        where="lemma (lem:injective), item 2, line 748",
        kind="item",
        statement=r"$\|N(x) - N(p)\| \ge d_0$ for every $x \in B_{2\delta}(p) \setminus "
        r"\overline{B_\delta(p)}$.",
        hypotheses=_BRANCHED,
        rests_on=("3.3.punctured-ball", "3.3.collar-compact"),
    ),
    Claim(
        id="3.3.weaker-hypotheses",
        section="3.3",
        where="line 743",
        kind="sentence",
        statement=r"(lem:injective) asks less than (lem:maximal): globally $C^{1,1}$ and piecewise "
        r"$C^2$ immersions, no bound on the curvature; and it concludes less.",
        rests_on=("lem:injective", "lem:maximal", "def:branched_immersion"),
    ),
    Claim(
        id="3.3.smooth-punctured-ball",
        section="3.3",
        where="proof of (lem:injective), line 754",
        kind="sentence",
        statement=r"If $y$ is $C^2$, then $N$ is an immersion at $p$, hence one-to-one near $p$, "
        r"and $N(x) \ne N(p)$ on $B_{3\delta}(p) \setminus \{p\}$ for some $\delta > 0$.",
        hypotheses=(r"$y$ a $C^2$ pseudospherical immersion",),
        rests_on=("3.3.normal-cross-product",),
    ),
    Claim(
        id="3.3.collar-compact",
        section="3.3",
        where="proof of (lem:injective), line 754",
        kind="sentence",
        statement=r"$\overline{B_{2\delta}(p)} \setminus B_\delta(p)$ is a compact subset of "
        r"$B_{3\delta}(p) \setminus \{p\}$, so $\|N(x) - N(p)\|$ has a positive minimum on it.",
        hypotheses=(
            r"$N$ continuous, $N(x) \ne N(p)$ on $B_{3\delta}(p) \setminus \{p\}$",
            r"(used, not stated) $\overline{B_{2\delta}(p)} \subset \Omega$",
        ),
        rests_on=("3.3.smooth-punctured-ball",),
    ),
    Claim(
        id="3.3.not-injective-at-branch-point",
        section="3.3",
        where="proof of (lem:injective), line 756",
        kind="sentence",
        statement=r"The normal map is not one-to-one on any neighbourhood of a branch point.",
        hypotheses=(*_BRANCHED, r"$m_p > 2$"),
        rests_on=("def:Jp", "lem:covering-number"),
    ),
    Claim(
        id="3.3.sector-extension",
        section="3.3",
        where="proof of (lem:injective), line 756",
        kind="sentence",
        statement=r"The asymptotic curves that bound a sector $S_i$ at $p$ extend smoothly as "
        r"solutions of (eq:frames), and there is a $C^2$ immersion $\tilde{y}_i$ near $p$ equal to "
        r"$y$ on $S_i$.",
        hypotheses=(
            *_BRANCHED,
            (
                r"(used, not stated) $\kappa^u$ and $\kappa^v$ are continuous up to $p$ on the "
                "bounding curves"
            ),
        ),
        rests_on=("prop:assembly", "eq:frames"),
    ),
    Claim(
        id="3.3.minimal-radius",
        section="3.3",
        where="proof of (lem:injective), line 756",
        kind="equation",
        statement=r"There are $\delta_i > 0$ with $N(x) \ne N(p)$ on $S_i \cap B_{3\delta_i}(p)$, "
        r"and $\delta = \min(\delta_0, \delta_1, \dots, \delta_{2m_p - 1}) > 0$ serves all sectors "
        r"at $p$.",
        hypotheses=(
            *_BRANCHED,
            r"(used, not stated) $x \ne p$",
            (
                r"(used, not stated) the $2m_p$ sectors, here numbered from 0, cover a "
                r"neighbourhood of $p$"
            ),
        ),
        rests_on=("3.3.sector-extension", "3.3.smooth-punctured-ball"),
    ),
)

_THEOREM = (
    Claim(
        id="thm:branched",
        section="3.3",
        where="theorem (thm:branched), lines 759-765",
        kind="theorem",
        statement=r"If $C^2$ pseudospherical immersions $y_n$ satisfy 1. $y_n \to y$ in "
        r"$W^{2,2}_{\mathrm{loc}}$ and 2. $\mathcal{E}_\infty[y_n] \le k_{\max}$ for all $n$, then "
        r"$m_p[y] = 2$ at every $p \in \Omega$.",
        labels=("thm:branched",),
        hypotheses=_SEQUENCE,
        rests_on=(
            "3.3.common-radius",
            "3.3.common-distance",
            "3.3.smooth-index",
            "3.3.normals-converge",
            "3.3.degree-stable",
            "lem:covering-number",
        ),
    ),
    Claim(
        id="3.3.common-radius",
        section="3.3",
        where="proof of (thm:branched), line 768",
        kind="sentence",
        statement=r"For every $p$ there is $\epsilon > 0$ with $B_{3\epsilon}(p) \subseteq \Omega$ "
        r"and $\epsilon < \min(\eta(k_{\max}), \delta(p))$, the same for $y$ and all $y_n$.",
        hypotheses=_SEQUENCE,
        rests_on=("lem:maximal", "lem:injective"),
    ),
    Claim(
        id="3.3.common-distance",
        section="3.3",
        where="proof of (thm:branched), line 768, the limit",
        kind="equation",
        statement=r"$\|N(x) - N(p)\| \ge \rho_0(p) = \min(c(k_{\max})\epsilon, d_0(p)) > 0$ for "
        r"$x \in \overline{B_{2\epsilon}(p)} \setminus B_\epsilon(p)$.",
        hypotheses=(
            *_SEQUENCE,
            *_BALL,
            (
                r"(used, not stated) $d_0$ belongs to the radius $\epsilon$, not to $\delta(p) > "
                r"\epsilon$"
            ),
        ),
        rests_on=("lem:injective", "3.3.common-radius"),
    ),
    Claim(
        id="3.3.common-distance-sequence",
        section="3.3",
        where="proof of (thm:branched), line 768, the sequence",
        kind="equation",
        statement=r"$\|N_n(x) - N_n(p)\| \ge \rho_0(p)$ for $x \in \overline{B_{2\epsilon}(p)} "
        r"\setminus B_\epsilon(p)$ and all $n$.",
        hypotheses=(*_SEQUENCE, *_BALL),
        rests_on=("lem:maximal", "3.3.common-radius"),
    ),
    Claim(
        id="3.3.winding-on-common-circle",
        section="3.3",
        where="proof of (thm:branched), line 770",
        kind="sentence",
        statement=r"The boundary of $B_\epsilon(p)$ computes the winding number of every $N_n$ and "
        r"of $N$ at $p$.",
        hypotheses=(*_SEQUENCE, *_BALL),
        rests_on=("3.3.common-distance", "3.3.common-distance-sequence", "3.3.index-well-defined"),
    ),
    Claim(
        id="3.3.smooth-index",
        section="3.3",
        where="proof of (thm:branched), line 772",
        kind="sentence",
        statement=r"$N_n$ is locally one-to-one and $J^{(n)}_p = -1$ for a $C^2$ pseudospherical "
        "immersion $y_n$.",
        hypotheses=_SEQUENCE,
        rests_on=("3.3.smooth-punctured-ball", "3.3.normal-cross-product", "def:Jp"),
    ),
    Claim(
        id="3.3.normals-converge",
        section="3.3",
        where="proof of (thm:branched), line 772",
        kind="sentence",
        statement=r"$y_n \to y$ in $W^{2,2}_{\mathrm{loc}}$ implies $N_n \to N$ in "
        r"$W^{1,2}(\overline{B_{2\epsilon}(p)})$.",
        hypotheses=(
            *_SEQUENCE,
            (
                r"(used, not stated) all $y_n$ induce the same metric, so their gradients are "
                r"bounded and the area factor is fixed"
            ),
        ),
        rests_on=("thmegrg",),
    ),
    Claim(
        id="3.3.bmo-convergence",
        section="3.3",
        where="proof of (thm:branched), line 772",
        kind="sentence",
        statement=r"In two dimensions convergence in $W^{1,2}(\overline{B_{2\epsilon}(p)})$ "
        r"implies convergence in BMO and in $L^1$.",
        rests_on=("3.3.normals-converge",),
    ),
    Claim(
        id="3.3.degree-stable",
        section="3.3",
        where="proof of (thm:branched), line 772",
        kind="sentence",
        statement=r"The $N_n$ meet the hypotheses under which the degree is stable in BMO, so "
        r"$J_p = \lim J^{(n)}_p = -1$.",
        hypotheses=(*_SEQUENCE, *_BALL),
        rests_on=("3.3.bmo-convergence", "3.3.common-distance-sequence", "3.3.smooth-index"),
    ),
)

CLAIMS: tuple[Claim, ...] = _INJECTIVE + _THEOREM
