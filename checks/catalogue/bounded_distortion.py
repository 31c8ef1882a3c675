"""Claims of section 3.3, bounded curvature: the normal map as a map of bounded distortion."""

from checks.claim import Check, Citation, Claim, Erratum, Mutant

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

_LEMMA_CHECKS = "checks.verify.normal_map_lemma:"
_FORMS_CHECKS = "checks.verify.bounded_distortion:"
_SEARCHES = "checks.verify.translation_net_searches:"
_WITNESS = (
    r"$k_{\max} = 20$, in the limit $\delta \to 0$ (then $r = A(u) + B(v)$, $N = N_0 + i(A - B)$ "
    r"with plane curves $A$, $B$): with $\theta = \arctan 19.9875$, $\gamma = 3\theta - \pi$, "
    r"$\sin\theta = l\sin\gamma$ let $A$ have the direction $-\theta$ for $u < 0$, $\gamma$ for $0 "
    r"< u < l$, $\theta - \frac{\pi}{2}$ beyond, and $B$ be its mirror image. All angles are in "
    r"$[\pi - 2\theta, 2\theta]$ where $u < 0$ or $v > 0$, and $(-1, -l)$ and $(l, 1)$, $0.40$ "
    r"apart, have one normal; the disk of radius $0.99$ about the first lies in that region. "
    r"Surfaces of curvature $-1$ of every size below $1.5 \cdot 10^{-5}$, with their two normals "
    r"equal, are certified near it"
)
_REMARK = (
    "One slip, the radius $r/L^2$ of John taken for $r$; it counts at (lem:maximal), at both of "
    "its items and at the sentence of its proof that applies John's theorem. "
    r"No $\eta(k_{\max})$ helps, for the surfaces are of every small size, and their curvatures "
    r"are bounded on all of $B_{3\delta}$. In translation nets the search finds item 1 false from "
    r"$k_{\max} = 4.33$ on and item 2 from $11.9$ on, and nothing below; with the bound on "
    r"$B_{3\delta}$ both are true for $k_{\max} \le 1.22$, and with the bound on a disk "
    r"$k_{\max}^2$ times as large for every $k_{\max}$, by John's theorem. The order is "
    r"$k_{\max}$: from $B_{14 k_{\max}\delta}$ both follow, by the cone of (lem:injective); from "
    r"$B_{3 k_{\max}\delta/16}$ they do not. (thm:branched) takes "
    r"$\epsilon$ smaller and survives."
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
        checks=(
            Check(
                name="with the corrected lemma",
                run=_LEMMA_CHECKS + "uniform_radius",
                routes=(
                    "theorem of John with the distortion in balls (theory.normal_distortion)",
                    "surfaces near a folded corner (theory.folded_corner_surface, balls)",
                ),
                mutants=(
                    Mutant(name="radius that does not depend on k_max", given={"power": "0"}),
                    Mutant(name="power 1/2", given={"power": "1/2"}),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="as printed",
                run=_LEMMA_CHECKS + "lemma",
                routes=(
                    "surfaces near a folded corner (theory.folded_corner_surface, balls)",
                    "statement of the lemma",
                ),
                mutants=(
                    Mutant(name="disk of radius 4 delta", given={"reach": "4"}),
                    Mutant(name="disk of radius 3 k_max^(1/2) delta", given={"power": "1/2"}),
                ),
            ),
            Check(
                name="disk of radius 3 k_max^2 delta",
                run=_LEMMA_CHECKS + "lemma",
                form="corrected",
                given={"power": "2"},
                routes=(
                    "theorem of John with the distortion in balls (theory.normal_distortion)",
                    "surfaces near a folded corner (theory.folded_corner_surface, balls)",
                ),
                mutants=(
                    Mutant(name="power 0", given={"power": "0"}),
                    Mutant(name="power 1/2", given={"power": "1/2"}),
                    Mutant(name="10 delta", given={"power": "0", "reach": "10"}),
                ),
            ),
            Check(
                name="folded corner",
                run=_LEMMA_CHECKS + "corner",
                form="support",
                routes=("translation net, exact", "Taylor remainders in balls"),
                mutants=(
                    Mutant(name="k_max = 19.9", given={"k_max": "199/10"}, near=True),
                    Mutant(name="disk of radius 4 delta", given={"reach": "4"}),
                    Mutant(name="at least 8/5 delta", given={"least": "8/5"}),
                    Mutant(name="twice the angle", given={"t": "1/20"}),
                ),
            ),
            Check(
                name="constants",
                run=_LEMMA_CHECKS + "constants",
                form="support",
                routes=("distortion in balls, every k_max >= 1", "theorem of John"),
                mutants=(
                    Mutant(name="L/k_max 1 % less", given={"distortion": "113/100"}, near=True),
                    Mutant(name="R = 2.62 k_max^2 delta", given={"needed": "131/50"}, near=True),
                    Mutant(name="c = 0.88/k_max", given={"collar": "22/25"}, near=True),
                ),
            ),
            Check(
                name="radius of order k_max",
                run="checks.verify.normal_cone:linear_radius",
                form="support",
                routes=(
                    "cone of directions (theory.normal_bounds)",
                    "surfaces near a folded corner (theory.folded_corner_surface, balls)",
                ),
                mutants=(
                    Mutant(name="from 13.3 k_max delta", given={"reach": "133/10"}, near=True),
                    Mutant(name="false on k_max delta/4", given={"below": "1/4"}),
                    Mutant(name="c = 1/sqrt(1 + k_max^2)", given={"share": "1"}),
                ),
            ),
            Check(
                name="nets",
                run="checks.verify.double_point:on_nets",
                tier="full",
                form="support",
                routes=("half-turn nets in S^2 and H^2, Newton's method", "certified bounds"),
                mutants=(
                    Mutant(name="distance 1 % more", given={"wider": "101/100"}, near=True),
                    Mutant(name="first point 1 % off", given={"longer": "101/100"}, near=True),
                ),
            ),
            Check(
                name="small curvatures",
                run=_LEMMA_CHECKS + "small_curvatures",
                form="support",
                routes=("distortion in balls", "radius r/L^2 of John"),
                mutants=(
                    Mutant(name="k_max 1 % more", given={"k_max": "123/100"}, near=True),
                    Mutant(name="disk of radius 2.9 delta", given={"reach": "29/10"}),
                ),
            ),
            Check(
                name="remainders",
                run="checks.verify.corner_remainders:remainders",
                form="support",
                routes=("half-turn nets in S^2 and H^2", "bounds of the Taylor remainders"),
                mutants=(Mutant(name="bounds 1 % less", given={"percent": 99}, near=True),),
            ),
        ),
        erratum=Erratum(
            printed=r"The normal map has the properties 1 and 2, for immersions of $B_{3\delta}$ "
            r"with curvatures at most $k_{\max}$",
            corrected=r"It has them, for immersions of $B_{3 k_{\max}^2 \delta}$ with curvatures "
            r"at most $k_{\max}$ there, $0 < \delta < k_{\max}^{-3}/6$",
            kind="false",
            witness=_WITNESS,
            conclusion_survives=True,
            remark=_REMARK,
        ),
    ),
    Claim(
        id="3.3.maximal-injective",
        section="3.3",
        where="lemma (lem:maximal), item 1, line 705",
        kind="item",
        statement=r"$N : B_{2\delta} \to S^2$ is one-to-one.",
        hypotheses=_MAXIMAL,
        rests_on=("3.3.quasi-isometry", "3.3.john-applies"),
        checks=(
            Check(
                name="as printed",
                run=_LEMMA_CHECKS + "lemma",
                routes=(
                    "surfaces near a folded corner (theory.folded_corner_surface, balls)",
                    "statement of the lemma",
                ),
                mutants=(
                    Mutant(name="disk of radius 4 delta", given={"reach": "4"}),
                    Mutant(name="disk of radius 3 k_max^(1/2) delta", given={"power": "1/2"}),
                ),
            ),
            Check(
                name="disk of radius 3 k_max^2 delta",
                run=_LEMMA_CHECKS + "lemma",
                form="corrected",
                given={"power": "2"},
                routes=(
                    "theorem of John with the distortion in balls (theory.normal_distortion)",
                    "surfaces near a folded corner (theory.folded_corner_surface, balls)",
                ),
                mutants=(
                    Mutant(name="power 0", given={"power": "0"}),
                    Mutant(name="power 1/2", given={"power": "1/2"}),
                    Mutant(name="10 delta", given={"power": "0", "reach": "10"}),
                ),
            ),
            Check(
                name="search over translation nets",
                run=_SEARCHES + "threshold",
                tier="full",
                form="support",
                given={"item": "one-to-one", "k_max": "4.33", "below": "4.31"},
                routes=("optimiser (checks.searches.normal_map)", "rays from the centre"),
                mutants=(
                    Mutant(
                        name="k_max 1 % less",
                        given={"item": "one-to-one", "k_max": "4.28", "below": "4.2"},
                        near=True,
                    ),
                    Mutant(
                        name="both points in 3/5 of the disk",
                        given={
                            "item": "one-to-one",
                            "k_max": "4.33",
                            "below": "4.31",
                            "share": "3/5",
                        },
                    ),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"$N$ is one-to-one on $B_{2\delta}$, for immersions of $B_{3\delta}$ with "
            r"curvatures at most $k_{\max}$",
            corrected=r"It is, for immersions of $B_{3 k_{\max}^2 \delta}$ with curvatures at most "
            r"$k_{\max}$ there, $0 < \delta < k_{\max}^{-3}/6$",
            kind="false",
            witness=_WITNESS,
            conclusion_survives=True,
            remark=_REMARK,
        ),
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
        checks=(
            Check(
                name="as printed",
                run=_LEMMA_CHECKS + "lemma",
                routes=(
                    "surfaces near a folded corner (theory.folded_corner_surface, balls)",
                    "statement of the lemma",
                ),
                mutants=(
                    Mutant(name="disk of radius 4 delta", given={"reach": "4"}),
                    Mutant(name="disk of radius 3 k_max^(1/2) delta", given={"power": "1/2"}),
                ),
            ),
            Check(
                name="disk of radius 3 k_max^2 delta",
                run=_LEMMA_CHECKS + "lemma",
                form="corrected",
                given={"power": "2"},
                routes=(
                    "theorem of John with the distortion in balls (theory.normal_distortion)",
                    "surfaces near a folded corner (theory.folded_corner_surface, balls)",
                ),
                mutants=(
                    Mutant(name="power 0", given={"power": "0"}),
                    Mutant(name="power 1/2", given={"power": "1/2"}),
                    Mutant(name="10 delta", given={"power": "0", "reach": "10"}),
                ),
            ),
            Check(
                name="search over translation nets",
                run=_SEARCHES + "threshold",
                tier="full",
                form="support",
                given={"item": "collar", "k_max": "11.9", "below": "11.8"},
                routes=("optimiser (checks.searches.normal_map)", "rays from the centre"),
                mutants=(
                    Mutant(
                        name="k_max 1 % less",
                        given={"item": "collar", "k_max": "11.75", "below": "11.6"},
                        near=True,
                    ),
                    Mutant(
                        name="both points in 3/5 of the disk",
                        given={"item": "collar", "k_max": "11.9", "below": "11.8", "share": "3/5"},
                    ),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"$\|N(x) - N_0\| \ge c\,\delta$ on the collar of $B_{2\delta}$, for "
            r"immersions of $B_{3\delta}$ with curvatures at most $k_{\max}$",
            corrected=r"It is, for immersions of $B_{3 k_{\max}^2 \delta}$ with curvatures at most "
            r"$k_{\max}$ there, $0 < \delta < k_{\max}^{-3}/6$, with $c = 7/(8 k_{\max})$",
            kind="false",
            witness=_WITNESS,
            conclusion_survives=True,
            remark=_REMARK,
        ),
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
        hypotheses=(
            *_MAXIMAL[:1],
            r"(used, not stated) $\sigma$ is constant on the ball",
            r"(read as) $u$, $v$ are functions on the ball with $du \wedge dv \neq 0$",
            r"(used, not stated) class $C^3$; for $C^2$ the cited theorem of Hartman and Wintner",
        ),
        rests_on=("eq:metrics",),
        checks=(
            Check(
                name="closed coframe",
                run=_FORMS_CHECKS + "coframe",
                routes=("principal coframe and the equations of Codazzi", "printed metric"),
                mutants=(
                    Mutant(name="curvature -2", given={"product": -2}),
                    Mutant(name="curvature 1", given={"product": 1}),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="third form",
                run=_FORMS_CHECKS + "spherical_metric",
                routes=("printed G", "Gauss-Weingarten (theory.asymptotic_net)"),
                mutants=(Mutant(name="sign of the mixed term", given={"mixed": 1}),),
            ),
        ),
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
        checks=(
            Check(
                name="squares of both",
                run=_FORMS_CHECKS + "larger_curvature",
                routes=("printed curvatures", "Gauss-Weingarten (theory.asymptotic_net)"),
                mutants=(Mutant(name="a third of the angle", given={"part": "1/3"}),),
            ),
        ),
    ),
    Claim(
        id="3.3.angle-bound",
        section="3.3",
        where="proof of (lem:maximal), line 711",
        kind="equation",
        statement=r"$2\arctan\frac{1}{k_{\max}} \le \varphi \le \pi - 2\arctan\frac{1}{k_{\max}}$.",
        hypotheses=(r"$\max(\tan\frac{\varphi}{2}, \cot\frac{\varphi}{2}) \le k_{\max}$",),
        rests_on=("3.3.larger-curvature",),
        checks=(
            Check(
                name="ends and monotonicity",
                run=_FORMS_CHECKS + "angle_range",
                routes=("printed ends", "tan and cot"),
                mutants=(Mutant(name="no factor 2", given={"factor": "1"}),),
            ),
        ),
    ),
    Claim(
        id="3.3.k-max-at-least-one",
        section="3.3",
        where="proof of (lem:maximal), line 711",
        kind="sentence",
        statement=r"$\kappa_1 \kappa_2 = -1$, so $k_{\max} \ge 1$.",
        hypotheses=(r"$\max(|\kappa_1|, |\kappa_2|) \le k_{\max}$",),
        rests_on=("eq:metrics",),
        checks=(
            Check(
                name="product",
                run=_FORMS_CHECKS + "least_bound",
                routes=("K = -1", "Gauss-Weingarten (theory.asymptotic_net)"),
                mutants=(Mutant(name="product -2", given={"product": -2}),),
            ),
        ),
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
        checks=(
            Check(
                name="inner inequalities",
                run=_FORMS_CHECKS + "inner_bounds",
                routes=("printed bound", "quadratic forms"),
                mutants=(Mutant(name="bound 1", given={"power": 0}),),
            ),
            Check(
                name="sharp constants",
                run=_FORMS_CHECKS + "sharp_distortion",
                form="support",
                routes=("square root of the printed bound", "quadratic forms"),
                mutants=(Mutant(name="printed bound attained", given={"half_power": 2}),),
            ),
        ),
    ),
    Claim(
        id="3.3.bld-lower-constant",
        section="3.3",
        where="equation (eq:BLD), line 716, first inequality",
        kind="equation",
        statement=r"$k_{\max}^{-2} \le \frac{1 - |\cos\varphi|}{1 + |\cos\varphi|}$.",
        hypotheses=_ANGLE_BOUND,
        rests_on=("3.3.angle-bound",),
        checks=(
            Check(
                name="range of angles",
                run=_FORMS_CHECKS + "outer_bound",
                routes=("k_max^-2", "printed bound by the cosine"),
                mutants=(Mutant(name="k_max^-1", given={"power": 1}),),
            ),
            Check(
                name="attained",
                run=_FORMS_CHECKS + "outer_bound_attained",
                form="support",
                routes=("k_max^-2", "printed bound by the cosine"),
                mutants=(Mutant(name="k_max^-3", given={"power": 3}),),
            ),
        ),
    ),
    Claim(
        id="3.3.bld-upper-constant",
        section="3.3",
        where="equation (eq:BLD), line 716, last inequality",
        kind="equation",
        statement=r"$\frac{1 + |\cos\varphi|}{1 - |\cos\varphi|} \le k_{\max}^2$.",
        hypotheses=_ANGLE_BOUND,
        rests_on=("3.3.angle-bound",),
        checks=(
            Check(
                name="range of angles",
                run=_FORMS_CHECKS + "outer_bound",
                routes=("inverse of k_max^2", "inverse of the printed bound by the cosine"),
                mutants=(Mutant(name="k_max", given={"power": 1}),),
            ),
            Check(
                name="attained",
                run=_FORMS_CHECKS + "outer_bound_attained",
                form="support",
                routes=("inverse of k_max^2", "inverse of the printed bound by the cosine"),
                mutants=(Mutant(name="k_max^3", given={"power": 3}),),
            ),
        ),
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
        checks=(
            Check(
                name="length of the arc",
                run=_FORMS_CHECKS + "arc",
                routes=("printed eta", "sqrt(G/g) <= k_max"),
                mutants=(
                    Mutant(name="by the bound k_max^2 of (eq:BLD)", given={"power": 2}),
                    Mutant(name="eta = pi/(3 k_max)", given={"share": "1/3"}),
                    Mutant(name="ball of radius 6 delta", given={"radius": 6}),
                ),
            ),
            Check(
                name="largest eta",
                run=_FORMS_CHECKS + "arc_at_one",
                form="support",
                routes=("printed eta", "pi/2"),
                mutants=(Mutant(name="eta = pi/(5 k_max)", given={"share": "1/5"}),),
            ),
        ),
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
        checks=(
            Check(
                name="cosine of the arc",
                run=_FORMS_CHECKS + "hemisphere",
                routes=("printed eta", "cosine"),
                mutants=(
                    Mutant(name="by the bound k_max^2", given={"power": 2}),
                    Mutant(name="eta = pi/(3 k_max)", given={"share": "1/3"}),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="orthogonal to N_0",
                run=_FORMS_CHECKS + "projection",
                routes=("printed projection", "unit vectors"),
                mutants=(Mutant(name="twice the projection", given={"factor": 2}),),
            ),
        ),
    ),
    Claim(
        id="3.3.projected-in-disk",
        section="3.3",
        where="proof of (lem:maximal), property 1, line 725",
        kind="item",
        statement=r"$\overline{N}^\perp$ takes its values in the unit disk.",
        hypotheses=_MAXIMAL,
        rests_on=("3.3.projected-normal",),
        checks=(
            Check(
                name="length",
                run=_FORMS_CHECKS + "in_disk",
                routes=("printed projection", "unit vectors"),
                mutants=(
                    Mutant(name="no projection", given={"factor": 0}),
                    Mutant(name="three times the projection", given={"factor": 3}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.3.projected-c1",
        section="3.3",
        where="proof of (lem:maximal), property 2, line 726",
        kind="item",
        statement=r"$N$ is $C^1$, and hence $\overline{N}^\perp$ is $C^1$.",
        hypotheses=_MAXIMAL,
        rests_on=("3.3.projected-normal",),
        checks=(
            Check(
                name="one derivative of the normal",
                run=_FORMS_CHECKS + "one_derivative",
                routes=("printed projection", "normal of a C^2 surface that is not C^3"),
                mutants=(Mutant(name="C^{1,1} surface", given={"power": 2}),),
            ),
        ),
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
        checks=(
            Check(
                name="areas",
                run=_FORMS_CHECKS + "orientation",
                routes=("printed projection", "Gauss-Weingarten (theory.asymptotic_net)"),
                mutants=(Mutant(name="no conjugation", given={"conjugated": False}),),
            ),
        ),
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
        checks=(
            Check(
                name="both bounds",
                run=_LEMMA_CHECKS + "projected_distortion",
                routes=("distortion in balls, every k_max >= 1", "eta as printed"),
                mutants=(
                    Mutant(name="on B_{3 delta}", given={"radius": "3"}),
                    Mutant(
                        name="on B_{2.1 delta}, bound 2.05",
                        given={"radius": "21/10", "bound": "41/20"},
                        near=True,
                    ),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="distortion",
                run=_LEMMA_CHECKS + "projected_distortion",
                part="distortion",
                routes=("distortion in balls, every k_max >= 1", "eta as printed"),
                mutants=(Mutant(name="on B_{3 delta}", given={"radius": "3"}),),
            ),
            Check(
                name="orientation",
                run=_FORMS_CHECKS + "orientation",
                part="orientation",
                routes=("printed projection", "Gauss-Weingarten (theory.asymptotic_net)"),
                mutants=(Mutant(name="no conjugation", given={"conjugated": False}),),
            ),
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
        checks=(
            Check(
                name="as printed",
                run=_LEMMA_CHECKS + "inclusion",
                routes=("radius r/L^2 of John", "L >= k_max"),
                mutants=(
                    Mutant(name="on B_{4 delta}", given={"reach": "4"}),
                    Mutant(name="on B_{3 k_max delta}", given={"power": "1"}),
                ),
            ),
            Check(
                name="on B_{3 k_max^2 delta}",
                run=_LEMMA_CHECKS + "inclusion",
                form="corrected",
                given={"power": "2"},
                routes=("radius r/L^2 of John", "distortion in balls, every k_max >= 1"),
                mutants=(
                    Mutant(name="on B_{3 delta}", given={"power": "0"}),
                    Mutant(name="on B_{3 k_max delta}", given={"power": "1"}),
                    Mutant(
                        name="on B_{1.98 k_max^2 delta}", given={"reach": "99/50", "power": "2"}
                    ),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"The properties on $B_{2\delta}$ restate John's theorem",
            corrected=r"John's theorem gives them on $B_{2\delta}$ if the curvatures are bounded "
            r"on $B_{3 k_{\max}^2 \delta}$, $3 k_{\max}^2 \delta < \frac{1}{2 k_{\max}}$",
            kind="false",
            witness=r"$k_{\max} = 2$: $L \ge 2$ and $r = 3\delta$, so $r/L^2 \le \frac34\delta < "
            r"2\delta$",
            conclusion_survives=True,
            remark="The gap cannot be closed: (lem:maximal) is false as printed. It is the slip "
            "that counts at (lem:maximal) and at both of its items as well.",
        ),
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
        checks=(
            Check(
                name="instance and near-misses",
                run=_FORMS_CHECKS + "definition",
                routes=("printed definition", "singular values and determinant"),
                mutants=(
                    Mutant(name="L = 1.9", given={"constant": "19/10"}),
                    Mutant(name="L = 2.01", given={"constant": "201/100"}, near=True),
                    Mutant(name="orientation dropped", given={"oriented": False}),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="search over translation nets",
                run=_SEARCHES + "john_search",
                tier="full",
                form="support",
                routes=("optimiser (checks.searches.john)", "rays from the centre"),
                mutants=(
                    Mutant(name="radius r", given={"power": "0"}),
                    Mutant(name="half of |w - z|/L", given={"broken_percent": 50}),
                    Mutant(name="disk 1 % larger", given={"disk_percent": 101}, near=True),
                ),
            ),
        ),
        citation=Citation(
            source="F. John, On quasi-isometric mappings I, Comm. Pure Appl. Math. 21 (1968), Thm. "
            "III; O. Martio and J. Vaisala, Elliptic equations and maps of bounded length "
            "distortion, Math. Ann. 282 (1988), Lemma 4.3",
            reason="A statement on all maps of bounded length distortion, proved by lifting "
            "segments from the image; no computation runs over all of them.",
            search="search over translation nets",
        ),
    ),
)

CLAIMS: tuple[Claim, ...] = _LEMMA + _FORMS_OF_THE_SURFACE + _PROJECTED_NORMAL + _JOHN
