"""Claims of section 3.3, bounded curvature: the normal map as a map of bounded distortion."""

from checks.claim import Claim

_MAXIMAL = (
    (
        r"$k_{\max} < \infty$, $0 < \delta < \eta(k_{\max})$, $y : B_{3\delta} \to \mathbb{R}^3$ a "
        r"$C^2$ pseudospherical immersion"
    ),
    r"$\max(|\kappa_1(x)|, |\kappa_2(x)|) \le k_{\max}$ for $x \in \overline{B_{2\delta}}$",
)
_BOUND_ON_3 = (
    (
        r"(used, not stated) $\max(|\kappa_1(x)|, |\kappa_2(x)|) \le k_{\max}$ on $B_{3\delta}$, "
        r"not on $\overline{B_{2\delta}}$ alone"
    ),
)
_FORMS = (
    r"$\varphi \in (0, \pi)$, $\sigma \in \{-1, 1\}$",
    (
        r"$g = du^2 + 2\sigma\cos\varphi\,du\,dv + dv^2$, $G = du^2 - 2\sigma\cos\varphi\,du\,dv + "
        r"dv^2$"
    ),
)
_ANGLE_BOUND = (
    *_FORMS,
    r"$2\arctan k_{\max}^{-1} \le \varphi \le \pi - 2\arctan k_{\max}^{-1}$",
)
_BLD = (
    r"$G \subseteq \mathbb{R}^n$ open, $f : G \to \mathbb{R}^n$ an $L$-BLD immersion, $L > 1$",
    r"$B_r(x) \subseteq G$, $w, z \in B_{r/L^2}(x)$",
    r"(used, not stated) an immersion is a local homeomorphism, and balls are Euclidean",
)

_LEMMA = (
    Claim(
        id="3.3.uniform-radius",
        section="3.3",
        where="line 701",
        kind="sentence",
        statement=r"The radius $\epsilon$ in the computation of $J_p$ is limited by the maximal "
        r"curvature alone, uniformly along a minimising sequence of $\mathcal{E}_\infty$ made of "
        r"$C^2$ immersions.",
        hypotheses=(
            r"$C^2$ pseudospherical immersions $y_n$ with $\mathcal{E}_\infty[y_n]$ bounded",
            r"(used, not stated) all $y_n$ are defined on a ball around $p$ of fixed radius",
        ),
        rests_on=("lem:maximal", "def:Jp"),
    ),
    Claim(
        id="lem:maximal",
        section="3.3",
        where="lemma (lem:maximal), lines 703-708",
        kind="lemma",
        statement=r"For every $k_{\max} < \infty$ there is $\eta(k_{\max}) > 0$ such that for "
        r"$0 < \delta < \eta$ the normal map of every $C^2$ pseudospherical immersion of "
        r"$B_{3\delta}$ with curvatures at most $k_{\max}$ on $\overline{B_{2\delta}}$ has the "
        r"properties 1 and 2.",
        labels=("lem:maximal",),
        hypotheses=_MAXIMAL,
        rests_on=("3.3.maximal-injective", "3.3.maximal-collar"),
    ),
    Claim(
        id="3.3.maximal-injective",
        section="3.3",
        where="lemma (lem:maximal), item 1, line 705",
        kind="item",
        statement=r"$N : B_{2\delta} \to S^2$ is one-to-one.",
        hypotheses=_MAXIMAL,
        rests_on=("3.3.quasi-isometry", "3.3.john-applies"),
    ),
    Claim(
        id="3.3.maximal-collar",
        section="3.3",
        where="lemma (lem:maximal), item 2, line 706",
        kind="item",
        statement=r"$\|N(x) - N_0\| \ge c(k_{\max})\,\delta$ for $x \in B_{2\delta} \setminus "
        r"\overline{B_\delta}$, with $c(k_{\max}) > 0$ and $N_0$ the normal at the centre.",
        hypotheses=_MAXIMAL,
        rests_on=("3.3.quasi-isometry", "3.3.john-applies"),
    ),
)

_FORMS_OF_THE_SURFACE = (
    Claim(
        id="3.3.global-asymptotic-coordinates",
        section="3.3",
        where="proof of (lem:maximal), line 711",
        kind="sentence",
        statement=r"For a $C^2$ immersion of $B_{3\delta}$ there are global asymptotic coordinates "
        r"$u, v$ and an angle $\varphi : B_{2\delta} \to (0, \pi)$ on $B_{2\delta}$, with $g = "
        r"du^2 + 2\sigma\cos\varphi\,du\,dv + dv^2$.",
        hypotheses=(*_MAXIMAL[:1], r"(used, not stated) $\sigma$ is constant on the ball"),
        rests_on=("eq:metrics",),
    ),
    Claim(
        id="3.3.spherical-metric",
        section="3.3",
        where="proof of (lem:maximal), line 711",
        kind="equation",
        statement=r"The normal map pulls the metric of the sphere back to $G = du^2 + dv^2 - "
        r"2\sigma\cos\varphi\,du\,dv$.",
        hypotheses=_MAXIMAL[:1],
        rests_on=("eq:def_phi", "eq:lelieuvre"),
    ),
    Claim(
        id="3.3.larger-curvature",
        section="3.3",
        where="proof of (lem:maximal), line 711",
        kind="equation",
        statement=r"The larger principal curvature, in absolute value, is $\max(\tan"
        r"\frac{\varphi}{2}, \cot\frac{\varphi}{2})$.",
        hypotheses=(r"$\varphi \in (0, \pi)$",),
        rests_on=("eq:metrics",),
    ),
    Claim(
        id="3.3.angle-bound",
        section="3.3",
        where="proof of (lem:maximal), line 711",
        kind="equation",
        statement=r"$2\arctan\frac{1}{k_{\max}} \le \varphi \le \pi - 2\arctan\frac{1}{k_{\max}}$.",
        hypotheses=(r"$\max(\tan\frac{\varphi}{2}, \cot\frac{\varphi}{2}) \le k_{\max}$",),
        rests_on=("3.3.larger-curvature",),
    ),
    Claim(
        id="3.3.k-max-at-least-one",
        section="3.3",
        where="proof of (lem:maximal), line 711",
        kind="sentence",
        statement=r"$\kappa_1 \kappa_2 = -1$, so $k_{\max} \ge 1$.",
        hypotheses=(r"$\max(|\kappa_1|, |\kappa_2|) \le k_{\max}$",),
        rests_on=("eq:metrics",),
    ),
    Claim(
        id="eq:BLD",
        section="3.3",
        where="equation (eq:BLD), line 716, inner inequalities",
        kind="equation",
        statement=r"$\frac{1 - |\cos\varphi|}{1 + |\cos\varphi|} \le "
        r"\sqrt{G(\mathbf{w}, \mathbf{w}) / g(\mathbf{w}, \mathbf{w})} \le "
        r"\frac{1 + |\cos\varphi|}{1 - |\cos\varphi|}$.",
        labels=("eq:BLD",),
        hypotheses=(
            *_FORMS,
            r"$\mathbf{w} \ne 0$ tangent, in the span of $\partial_u, \partial_v$",
        ),
        rests_on=("3.3.global-asymptotic-coordinates", "3.3.spherical-metric"),
    ),
    Claim(
        id="3.3.bld-lower-constant",
        section="3.3",
        where="equation (eq:BLD), line 716, first inequality",
        kind="equation",
        statement=r"$k_{\max}^{-2} \le \frac{1 - |\cos\varphi|}{1 + |\cos\varphi|}$.",
        hypotheses=_ANGLE_BOUND,
        rests_on=("3.3.angle-bound",),
    ),
    Claim(
        id="3.3.bld-upper-constant",
        section="3.3",
        where="equation (eq:BLD), line 716, last inequality",
        kind="equation",
        statement=r"$\frac{1 + |\cos\varphi|}{1 - |\cos\varphi|} \le k_{\max}^2$.",
        hypotheses=_ANGLE_BOUND,
        rests_on=("3.3.angle-bound",),
    ),
)

_PROJECTED_NORMAL = (
    Claim(
        id="3.3.eta",
        section="3.3",
        where="proof of (lem:maximal), line 719",
        kind="equation",
        statement=r"With $\eta = \frac{\pi}{6} k_{\max}^{-1}$ the spherical arc from $N_0$ to "
        r"$N(x)$ is shorter than $\frac{\pi}{2}$.",
        hypotheses=(
            *_MAXIMAL,
            *_BOUND_ON_3,
            (
                r"(used, not stated) $\sqrt{G/g} \le k_{\max}$, sharper than the bound "
                r"$k_{\max}^2$ of (eq:BLD)"
            ),
        ),
        rests_on=("eq:BLD", "3.3.larger-curvature"),
    ),
    Claim(
        id="3.3.hemisphere",
        section="3.3",
        where="proof of (lem:maximal), line 719",
        kind="sentence",
        statement=r"$N(x) \cdot N_0 > 0$ for $x \in B_{3\delta}$: the image of $B_{3\delta}$ lies "
        "in an open hemisphere.",
        hypotheses=(*_MAXIMAL, *_BOUND_ON_3),
        rests_on=("3.3.eta",),
    ),
    Claim(
        id="3.3.projected-normal",
        section="3.3",
        where="proof of (lem:maximal), line 721",
        kind="equation",
        statement=r"$\overline{N}^\perp(x + iy) = N(x - iy) - \langle N(x - iy), N_0 \rangle N_0$ "
        r"is a map from $B_{3\delta}$, a subset of the Poincare disk, to $N_0^\perp$, identified "
        r"with $\mathbb{R}^2$.",
        hypotheses=_MAXIMAL,
        rests_on=("def:H2",),
    ),
    Claim(
        id="3.3.projected-in-disk",
        section="3.3",
        where="proof of (lem:maximal), property 1, line 725",
        kind="item",
        statement=r"$\overline{N}^\perp$ takes its values in the unit disk.",
        hypotheses=_MAXIMAL,
        rests_on=("3.3.projected-normal",),
    ),
    Claim(
        id="3.3.projected-c1",
        section="3.3",
        where="proof of (lem:maximal), property 2, line 726",
        kind="item",
        statement=r"$N$ is $C^1$, and hence $\overline{N}^\perp$ is $C^1$.",
        hypotheses=_MAXIMAL,
        rests_on=("3.3.projected-normal",),
    ),
    Claim(
        id="3.3.projected-orientation",
        section="3.3",
        where="proof of (lem:maximal), property 3, line 727",
        kind="item",
        statement=r"$\overline{N}^\perp$ preserves orientation: conjugation and $N$ reverse it, "
        r"and the projection preserves it.",
        hypotheses=(
            *_MAXIMAL,
            r"(used, not stated) $N(x) \cdot N_0 > 0$, and $N_0^\perp$ is oriented by $N_0$",
        ),
        rests_on=("3.3.projected-normal", "3.3.hemisphere", "3.3.normal-cross-product"),
    ),
    Claim(
        id="3.3.projected-distortion",
        section="3.3",
        where="proof of (lem:maximal), property 4, line 728",
        kind="item",
        statement=r"On $B_{2\delta}$ the local distortion of lengths by $\overline{N}^\perp$ lies "
        r"between two positive constants that depend on $k_{\max}$ alone.",
        hypotheses=_MAXIMAL,
        rests_on=("eq:BLD", "3.3.projected-normal", "3.3.eta", "def:H2"),
    ),
    Claim(
        id="3.3.quasi-isometry",
        section="3.3",
        where="proof of (lem:maximal), line 731",
        kind="sentence",
        statement=r"$\overline{N}^\perp : B_{2\delta} \to \mathbb{R}^2$ is a regular "
        "quasi-isometry, a local homeomorphism of bounded length distortion.",
        hypotheses=_MAXIMAL,
        rests_on=(
            "3.3.projected-in-disk",
            "3.3.projected-c1",
            "3.3.projected-orientation",
            "3.3.projected-distortion",
            "3.3.bld-mapping",
        ),
    ),
    Claim(
        id="3.3.john-applies",
        section="3.3",
        where="proof of (lem:maximal), line 731",
        kind="sentence",
        statement=r"The two properties of (lem:maximal) restate the theorem of John for "
        r"$\overline{N}^\perp$ on $B_{2\delta}$.",
        hypotheses=(
            *_MAXIMAL,
            (
                r"(used, not stated) the distortion is bounded on a ball $L^2$ times as large as "
                r"that on which $N$ is to be one-to-one"
            ),
        ),
        rests_on=("3.3.quasi-isometry", "3.3.john"),
    ),
)

_JOHN = (
    Claim(
        id="3.3.bld-mapping",
        section="3.3",
        where="definition (BLD mapping, Martio and Vaisala), lines 736-738",
        kind="definition",
        statement=r"A Lipschitz map $f : G \subseteq \mathbb{R}^n \to \mathbb{R}^n$ is $L$-BLD, "
        r"$L > 1$, if for almost every $x$ (i) $|h|/L \le |f'(x)h| \le L|h|$ for all $h$ and "
        r"(ii) $\det Df(x) > 0$.",
        hypotheses=(r"(used, not stated) $G$ is open",),
    ),
    Claim(
        id="3.3.john",
        section="3.3",
        where="theorem (Thm. III, John), lines 734 and 740-741",
        kind="theorem",
        statement=r"$\|f(w) - f(z)\|/L \le \|w - z\| \le L\,\|f(w) - f(z)\|$ for all $w, z \in "
        r"B_{r/L^2}(x)$.",
        hypotheses=_BLD,
        rests_on=("3.3.bld-mapping",),
    ),
)

CLAIMS: tuple[Claim, ...] = _LEMMA + _FORMS_OF_THE_SURFACE + _PROJECTED_NORMAL + _JOHN
