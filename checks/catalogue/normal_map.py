"""Claims of section 3.3, the ramification index of the normal map, and the order of saddleness."""

from checks.claim import Claim

_IMMERSION = (
    r"$y : \Omega \to \mathbb{R}^3$ a $C^{1,1}$ pseudospherical immersion, $p \in \Omega$",
    r"(used, not stated) $y$ is an $m_p$-saddle near $p$, as in (def:branched_immersion)",
)
_SADDLE = (
    r"$y(p) = 0$, $N(p) = \mathbf{e}_3$, $y$ a saddle of order $m$ at $p$",
    r"$0 < \beta_{i+1} - \beta_i < \pi$, $\beta_0 = 0$, $\beta_{2m} = 2\pi$",
    (
        r"(used, not stated) even $i$ belong to $u$-curves and odd $i$ to $v$-curves, and "
        r"coordinates grow away from $p$"
    ),
)
_GRAPH = (
    (
        r"$w \in C^{1,1}$, $w(0) = 0$, $\nabla w(0) = 0$, the normal upward as for $\omega = dx_1 "
        r"\wedge dx_2$"
    ),
    r"(used, not stated) $\nabla w \ne 0$ in a punctured neighbourhood of 0",
)

_INDEX = (
    Claim(
        id="def:Jp",
        section="3.3",
        where="definition (def:Jp), lines 663-668",
        kind="definition",
        statement=r"The ramification index $J_p$ of the normal map is the degree of $\pi \circ N "
        r"\circ \gamma : S^1 \to U \to S^2 \setminus \{\pm N(p)\} \to S^1$.",
        labels=("def:Jp",),
        hypotheses=(
            r"$V \subseteq \Omega$ open, $p \in V$, $U = V \setminus \{p\}$",
            r"$N : \Omega \to S^2$ continuous, $N(U) \subseteq S^2 \setminus \{\pm N(p)\}$",
            r"$\gamma$ a simple closed curve in $U$",
            (
                r"(used, not stated) $\gamma$ goes around $p$ once, counterclockwise, and bounds a "
                r"disk in $V$"
            ),
            r"(used, not stated) the circle in $N(p)^\perp$ is oriented by $N(p)$",
        ),
        rests_on=("3.3.equator-retraction",),
    ),
    Claim(
        id="3.3.equator-retraction",
        section="3.3",
        where="definition (def:Jp), line 666",
        kind="equation",
        statement=r"$x_\perp = x - \langle N(p), x \rangle N(p)$ and $\pi(x) = x_\perp / "
        r"\|x_\perp\|$ define a retraction of $S^2 \setminus \{\pm N(p)\}$ to its equator $S^1$.",
    ),
    Claim(
        id="3.3.index-well-defined",
        section="3.3",
        where="definition (def:Jp), lines 663-666",
        kind="sentence",
        statement=r"$J_p$ does not depend on the simple closed curve $\gamma$ in $U$, nor on $V$.",
        hypotheses=(
            r"$\gamma$ a simple closed curve in $U$, $N(U) \subseteq S^2 \setminus \{\pm N(p)\}$",
        ),
        rests_on=("def:Jp",),
    ),
    Claim(
        id="3.3.index-negative",
        section="3.3",
        where="line 670",
        kind="sentence",
        statement=r"$J_p < 0$ at every point of a surface with negative extrinsic curvature: $N$ "
        r"goes clockwise as the point goes counterclockwise around $p$.",
        hypotheses=_IMMERSION,
        rests_on=("def:Jp", "eq:def_phi"),
    ),
    Claim(
        id="3.3.index-minus-one",
        section="3.3",
        where="line 671",
        kind="sentence",
        statement=r"If $J_p = -1$, then the normal map is a homeomorphism near $p$.",
        hypotheses=_IMMERSION,
        rests_on=("def:Jp",),
    ),
    Claim(
        id="3.3.branched-covering",
        section="3.3",
        where="line 671",
        kind="sentence",
        statement=r"If $J_p < -1$, then near $p$ the map $N$ covers a neighbourhood of $N(p)$ in "
        r"several sheets, and $N(p)$ is a branch point of the inverse map.",
        hypotheses=_IMMERSION,
        rests_on=("def:Jp", "3.3.normal-winds"),
    ),
    Claim(
        id="3.3.branch-point-index",
        section="3.3",
        where="line 671",
        kind="definition",
        statement=r"$p$ is a branch point if and only if $|J_p| > 1$, in agreement with "
        r"$m_p \ne 2$.",
        hypotheses=_IMMERSION,
        rests_on=("def:Jp", "3.3.branch-points", "lem:covering-number"),
    ),
)

_GRAPHS = (
    Claim(
        id="3.3.graph-normal",
        section="3.3",
        where="line 673",
        kind="equation",
        statement=r"Near $p$ an immersion is a graph $(x_1, x_2, w(x_1, x_2))$ over its tangent "
        r"plane at $p$, and $\pi \circ N = \nabla w / \|\nabla w\|$.",
        hypotheses=_GRAPH,
        rests_on=("3.3.equator-retraction", "eq:Nfront"),
    ),
    Claim(
        id="3.3.graph-index",
        section="3.3",
        where="display, lines 675-677",
        kind="equation",
        statement=r"$J_p$ is the degree of $(x_1, x_2) \mapsto \nabla w(\epsilon x_1, \epsilon "
        r"x_2) / \|\nabla w(\epsilon x_1, \epsilon x_2)\|$ on the circle $x_1^2 + x_2^2 = 1$, for "
        r"every small $\epsilon > 0$.",
        hypotheses=_GRAPH,
        rests_on=("3.3.graph-normal", "def:Jp"),
    ),
)

_COVERING = (
    Claim(
        id="lem:covering-number",
        section="3.3",
        where="lemma (lem:covering-number), lines 681-684",
        kind="lemma",
        statement=r"$J_p = 1 - m_p$.",
        labels=("lem:covering-number",),
        hypotheses=(
            *_IMMERSION,
            (
                r"(used, not stated) $N$ is $C^1$ up to the boundary of each sector with $N_u "
                r"\times N_v \ne 0$ at $p$, so that $\pi \circ N$ makes no further turn inside a "
                r"sector"
            ),
        ),
        rests_on=("def:Jp", "3.2.order-of-saddleness", "3.3.normal-well-defined", "3.3.theta-sum"),
    ),
    Claim(
        id="3.3.normal-well-defined",
        section="3.3",
        where="proof of (lem:covering-number), lines 686-687",
        kind="sentence",
        statement=r"$N$ is Lipschitz for a $C^{1,1}$ immersion, so $m_p$ and $J_p$ are defined.",
        hypotheses=_IMMERSION,
        rests_on=("def:Jp",),
    ),
    Claim(
        id="3.3.index-motion-invariant",
        section="3.3",
        where="proof of (lem:covering-number), line 689",
        kind="sentence",
        statement=r"$m_p$ and $J_p$ are invariant under Euclidean motions, so one may take $y(p) = "
        r"0$ and $N(p) = \mathbf{e}_3$.",
        hypotheses=(*_IMMERSION, "(used, not stated) motions that keep the orientation, for $J_p$"),
        rests_on=("def:Jp",),
    ),
    Claim(
        id="3.3.normal-derivatives",
        section="3.3",
        where="proof of (lem:covering-number), line 691",
        kind="equation",
        statement=r"$N_u = N \times r_u$ and $N_v = -N \times r_v$.",
        hypotheses=(r"(used, not stated) $r_u, r_v \perp N$ and $\|N\| = 1$",),
        rests_on=("eq:lelieuvre",),
    ),
    Claim(
        id="3.3.lifted-tangents",
        section="3.3",
        where="proof of (lem:covering-number), lines 689-691",
        kind="equation",
        statement=r"The images of the asymptotic curves under $N$ leave $\mathbf{e}_3$ along "
        r"$\mathbf{t}_i = \cos\theta_i\,\mathbf{e}_1 + \sin\theta_i\,\mathbf{e}_2$ if the curves "
        r"leave $p$ along $\mathbf{s}_i = \cos\beta_i\,\mathbf{e}_1 + \sin\beta_i\,\mathbf{e}_2$.",
        hypotheses=_SADDLE,
        rests_on=("3.3.normal-derivatives", "def:m-saddle", "3.2.directions"),
    ),
    Claim(
        id="3.3.theta-mod",
        section="3.3",
        where="proof of (lem:covering-number), line 691",
        kind="equation",
        statement=r"$\theta_i = \beta_i + \frac{\pi}{2} \bmod 2\pi$ for even $i$ and $\theta_i = "
        r"\beta_i - \frac{\pi}{2} \bmod 2\pi$ for odd $i$.",
        hypotheses=_SADDLE,
        rests_on=("3.3.lifted-tangents",),
    ),
    Claim(
        id="3.3.normal-cross-product",
        section="3.3",
        where="proof of (lem:covering-number), line 691",
        kind="equation",
        statement=r"$N_u \times N_v = -r_u \times r_v$.",
        rests_on=("3.3.normal-derivatives",),
    ),
    Claim(
        id="3.3.theta-lift",
        section="3.3",
        where="proof of (lem:covering-number), line 691",
        kind="sentence",
        statement=r"$N_u \times N_v = -r_u \times r_v$ requires, and allows, values of $\theta_i$ "
        r"with $0 < \theta_i - \theta_{i+1} < \pi$.",
        hypotheses=_SADDLE,
        rests_on=("3.3.theta-mod", "3.3.normal-cross-product"),
    ),
    Claim(
        id="3.3.theta-two-steps",
        section="3.3",
        where="proof of (lem:covering-number), line 691",
        kind="equation",
        statement=r"$\theta_{i+2} - \theta_i = \beta_{i+2} - \beta_i - 2\pi$.",
        hypotheses=_SADDLE,
        rests_on=("3.3.theta-lift",),
    ),
    Claim(
        id="3.3.theta-sum",
        section="3.3",
        where="proof of (lem:covering-number), display, line 693",
        kind="equation",
        statement=r"$\sum_{i=1}^{2m} [\theta_i - \theta_{i-1}] = \sum_{k=1}^{m} [\theta_{2k} - "
        r"\theta_{2k-2}] = \beta_{2m} - \beta_0 - 2m\pi = 2(1 - m)\pi$.",
        hypotheses=_SADDLE,
        rests_on=("3.3.theta-two-steps",),
    ),
    Claim(
        id="3.3.winding-jump",
        section="3.3",
        where="line 698",
        kind="sentence",
        statement="The winding numbers of the normal at the centre are 1 for the saddle and 2 for "
        "the monkey saddle, up to sign, and no continuous change leads from one to the other.",
        rests_on=("fig:winding_number_normalfield", "lem:covering-number"),
    ),
)

CLAIMS: tuple[Claim, ...] = _INDEX + _GRAPHS + _COVERING
