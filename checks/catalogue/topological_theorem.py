"""Claims of section 3.3, branch points cannot be smoothed away: the theorem and its lemma."""

from checks.claim import Check, Citation, Claim, Erratum, Mutant

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
_NOT_NEEDED = (
    (
        r"(stated, not needed; by hand) the bound $k_{\max}$: on almost every circle around $p$ a "
        r"subsequence of $N_n$ converges uniformly. Let $N(\partial B)$ avoid a disk $D$ around "
        r"$N(p)$, and let the smaller circle $\partial B'$ go into $D$ under $N$. Over $D$ the "
        r"local homeomorphism $N_n$ of $B$ is proper, so a covering, whose sheets are disks; "
        r"$\partial B'$ and so $B'$ lies in one of them, $N_n$ is one-to-one on $B'$, and the "
        r"degree on $\partial B'$ is 0 or $\pm 1$, while it is $1 - m_p \le -2$ at a branch point"
    ),
)
_WIDER = (
    (
        r"(used, not stated) $B_{4\epsilon\sqrt{1 + k_{\max}^2}}(p) \subseteq \Omega$: "
        r"$B_{3\epsilon}(p) \subseteq \Omega$ is not enough, as (lem:maximal) is false as printed"
    ),
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
        citation=Citation(
            source="the proof of the lemma; with constants, the bound that theory.normal_bounds "
            "derives by hand",
            reason="a statement about all branched immersions, proved by analysis: the speeds of N "
            "and the positivity of the bound are decided by computer, the step from them to "
            "|N - N(p)|, by integrals of unit vectors in a cone, is not",
            search="search for a returning normal",
        ),
        checks=(
            Check(
                name="bound of |N - N(p)|",
                run="checks.verify.normal_separation:separation",
                tier="full",
                form="support",
                routes=(
                    "Gauss-Weingarten equations and a cone of directions",
                    "positivity of t s - t^2/2 - t^3/8",
                ),
                mutants=(
                    Mutant(name="up to t = 3 s", given={"reach": "3"}),
                    Mutant(name="d_0 = s delta", given={"share": "1"}),
                    Mutant(name="|N_uv| = cos^2 phi", given={"mixed": 2}),
                ),
            ),
            Check(
                name="search for a returning normal",
                run="checks.verify.branch_searches:star_normals_search",
                form="support",
                routes=(
                    "half-turn rule on a grid, maximised",
                    "Picard iteration of the Moutard equation",
                ),
                mutants=(
                    Mutant(name="excess below 5 %", given={"bound_percent": 5}),
                    Mutant(name="the cone 1 % wider", given={"cone_percent": 101}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="3.3.punctured-ball",
        section="3.3",
        where="lemma (lem:injective), item 1, line 747",
        kind="item",
        statement=r"$N(x) \ne N(p)$ for every $x \in B_{2\delta}(p) \setminus \{p\}$.",
        hypotheses=_BRANCHED,
        rests_on=("3.3.smooth-punctured-ball", "3.3.sector-extension", "3.3.minimal-radius"),
        checks=(
            Check(
                name="no return near p",
                run="checks.verify.normal_separation:punctured_ball",
                part="speeds and bound",
                routes=(
                    "Gauss-Weingarten equations and a cone of directions",
                    "positivity of t s - t^2/2 - t^3/8",
                ),
                mutants=(
                    Mutant(name="up to t = 3 s", given={"reach": "3"}),
                    Mutant(name="|N_uv| = cos^2 phi", given={"mixed": 2}),
                ),
            ),
            Check(
                name="sampled sectors",
                run="checks.verify.branch_searches:star_normals_search",
                part="sectors",
                routes=(
                    "half-turn rule on a grid, maximised",
                    "Picard iteration of the Moutard equation",
                ),
                mutants=(
                    Mutant(name="excess below 5 %", given={"bound_percent": 5}),
                    Mutant(name="the cone 1 % wider", given={"cone_percent": 101}, near=True),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="distance on the collar",
                run="checks.verify.normal_separation:collar_distance",
                part="speeds and bound",
                routes=(
                    "Gauss-Weingarten equations and a cone of directions",
                    "positivity of t s - t^2/2 - t^3/8",
                ),
                mutants=(
                    Mutant(name="d_0 = s delta", given={"share": "1"}),
                    Mutant(name="|N_uv| = cos^2 phi", given={"mixed": 2}),
                ),
            ),
            Check(
                name="sampled sectors",
                run="checks.verify.branch_searches:star_normals_search",
                part="sectors",
                routes=(
                    "half-turn rule on a grid, maximised",
                    "Picard iteration of the Moutard equation",
                ),
                mutants=(
                    Mutant(name="excess below 5 %", given={"bound_percent": 5}),
                    Mutant(name="the cone 1 % wider", given={"cone_percent": 101}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="3.3.weaker-hypotheses",
        section="3.3",
        where="line 743",
        kind="sentence",
        statement=r"(lem:injective) asks less than (lem:maximal): globally $C^{1,1}$ and piecewise "
        r"$C^2$ immersions, no bound on the curvature; and it concludes less.",
        rests_on=("lem:injective", "lem:maximal", "def:branched_immersion"),
        checks=(
            Check(
                name="the monkey saddle",
                run="checks.verify.normal_separation:weaker_hypotheses",
                routes=(
                    "Hessians of the quadratic saddle",
                    "preimages under the tangent map of N",
                ),
                mutants=(Mutant(name="a smooth saddle", given={"order": 2}),),
            ),
        ),
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
        checks=(
            Check(
                name="Jacobian of the normal",
                run="checks.verify.normal_separation:smooth_jacobian",
                routes=(
                    "derivatives of N from the fundamental forms (Weingarten)",
                    "r_u x r_v and sin phi",
                ),
                mutants=(
                    Mutant(name="Jacobian +1", given={"jacobian": 1}),
                    Mutant(name="Jacobian 0", given={"jacobian": 0}),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="least distance",
                run="checks.verify.normal_separation:collar_minimum",
                routes=(
                    "|N - N(p)| of graphs as a function of r",
                    "its value at the inner radius",
                ),
                mutants=(Mutant(name="the punctured ball, not compact", given={"inner": "0"}),),
            ),
        ),
    ),
    Claim(
        id="3.3.not-injective-at-branch-point",
        section="3.3",
        where="proof of (lem:injective), line 756",
        kind="sentence",
        statement=r"The normal map is not one-to-one on any neighbourhood of a branch point.",
        hypotheses=(*_BRANCHED, r"$m_p > 2$"),
        rests_on=("def:Jp", "lem:covering-number"),
        checks=(
            Check(
                name="two preimages",
                run="checks.verify.normal_turning:several_sheets",
                routes=(
                    "preimages under the tangent map of N, with exact signs",
                    "m_p - 1",
                ),
                mutants=(
                    Mutant(name="a regular point", given={"only": 2}),
                    Mutant(name="m_p preimages", given={"shift": 0}, near=True),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="extension of a sector",
                run="checks.verify.normal_separation:sector_extension",
                tier="full",
                routes=(
                    "Goursat series from two curves",
                    "stars of angles alpha, pi - alpha, alpha, pi - alpha",
                ),
                mutants=(
                    Mutant(name="the curve continued at an angle", given={"bend": "1/9"}),
                    Mutant(name="torsion -1 of the v-curve", given={"torsion": -1}),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="least radius",
                run="checks.verify.normal_separation:minimal_radius",
                routes=(
                    "least of the radii of all sectors",
                    "period of the normal along rays of constant curvature",
                ),
                mutants=(
                    Mutant(name="largest radius", given={"rule": "max"}),
                    Mutant(name="2m - 1 sectors", given={"offset": -1}),
                ),
            ),
        ),
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
        hypotheses=(*_SEQUENCE, *_NOT_NEEDED),
        rests_on=(
            "3.3.common-radius",
            "3.3.common-distance",
            "3.3.smooth-index",
            "3.3.normals-converge",
            "3.3.degree-stable",
            "lem:covering-number",
        ),
        citation=Citation(
            source="the proof of the theorem, in the simpler form of 3.3.degree-stable: equal "
            "Lipschitz constants for BMO; H. Brezis and L. Nirenberg, Degree theory and BMO "
            "II, Selecta Math. 2 (1996) 309-368, for the form in the paper",
            reason="a statement about all sequences: that small differences of the normals in L^1 "
            "are uniformly small, and that the degree then stays, is analysis; the indices and the "
            "positivity of the distance kept are decided by computer",
            search="search for a smooth saddle near the monkey saddle",
        ),
        checks=(
            Check(
                name="order of the limit",
                run="checks.verify.branched_limits:branched_limit",
                tier="full",
                form="support",
                routes=(
                    "degrees of stars and of smooth saddles",
                    "distance of the normals in L^1 by a bound on the collar",
                ),
                mutants=(
                    Mutant(name="m_p = 3", given={"order": 3}),
                    Mutant(name="smooth graphs that are not isometric", given={"isometric": False}),
                    Mutant(name="the bound on the collar 1 % above s", given={"share": "101/100"}),
                ),
            ),
            Check(
                name="search for a smooth saddle near the monkey saddle",
                run="checks.verify.branch_searches:smooth_near_star_search",
                tier="full",
                form="support",
                routes=(
                    "cells of a Chebyshev net, minimised",
                    "inversion of the net on polar grids",
                ),
                mutants=(
                    Mutant(name="a kinked star of order 2", given={"target": "kinked"}),
                    Mutant(name="1 % farther", given={"bound_percent": 116}, near=True),
                ),
            ),
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
        checks=(
            Check(
                name="one radius for all n",
                run="checks.verify.branched_limits:common_radius",
                routes=(
                    "eta as a function of the bound",
                    "limit for n to infinity",
                ),
                mutants=(Mutant(name="curvatures that grow", given={"growth": 1}),),
            ),
        ),
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
            *_WIDER,
            (
                r"(used, not stated) $c(k_{\max})$ serves $y$ too, sector by sector: $d_0$ alone, "
                r"which belongs to $\delta(p) > \epsilon$, is no bound on the collar of $\epsilon$"
            ),
        ),
        rests_on=("lem:injective", "3.3.common-radius"),
        checks=(
            Check(
                name="bound for the limit",
                run="checks.verify.branched_limits:common_distance",
                routes=(
                    "a cone of directions on each sector",
                    "positivity of the bound on the collar",
                ),
                mutants=(
                    Mutant(name="c = 1/sqrt(1 + k^2)", given={"share": "1"}),
                    Mutant(name="d_0 of a larger radius alone", given={"rule": "d_0"}),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="as printed",
                run="checks.verify.normal_map_lemma:lemma",
                routes=(
                    "surfaces near a folded corner (theory.folded_corner_surface, balls)",
                    "item 2 of (lem:maximal) for y_1",
                ),
                mutants=(
                    Mutant(name="disk of radius 4 epsilon", given={"reach": "4"}),
                    Mutant(name="disk of radius 3 k_max^(1/2) epsilon", given={"power": "1/2"}),
                ),
            ),
            Check(
                name="disk of radius 3 k_max^2 epsilon",
                run="checks.verify.normal_map_lemma:lemma",
                form="corrected",
                given={"power": "2"},
                routes=(
                    "theorem of John with the distortion in balls (theory.normal_distortion)",
                    "surfaces near a folded corner (theory.folded_corner_surface, balls)",
                ),
                mutants=(
                    Mutant(name="power 0", given={"power": "0"}),
                    Mutant(name="power 1/2", given={"power": "1/2"}),
                ),
            ),
            Check(
                name="bound for all n",
                run="checks.verify.branched_limits:common_distance",
                form="corrected",
                routes=(
                    "a cone of directions on each sector",
                    "positivity of the bound on the collar",
                ),
                mutants=(
                    Mutant(name="c = 1/sqrt(1 + k^2)", given={"share": "1"}),
                    Mutant(name="c 1 % above", given={"share": "101/100"}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"$\|N_n(x) - N_n(p)\| \ge \rho_0(p)$ for all $n$, where $B_{3\epsilon}(p) "
            r"\subseteq \Omega$, $\epsilon < \min(\eta(k_{\max}), \delta(p))$",
            corrected=r"It is so where $B_{4\epsilon\sqrt{1 + k_{\max}^2}}(p) \subseteq \Omega$, "
            r"$\epsilon < \frac{1}{8(1 + k_{\max}^2)}$",
            kind="hypothesis",
            witness=r"$k_{\max} = 20$, $\Omega = B_{3\epsilon}(p)$, $y_1$ the surface that refutes "
            r"(lem:maximal), $y_n = y$ a saddle for $n \ge 2$: $N_1(x) = N_1(p)$ at a point $x$ of "
            "the collar",
            conclusion_survives=True,
            remark=r"Not a slip of its own: it is that of (lem:maximal), used here. The proof may "
            r"take $\epsilon$ smaller. That $\partial B_\epsilon(p)$ gives the winding number of "
            "every $N_n$ needs the larger ball too.",
        ),
    ),
    Claim(
        id="3.3.winding-on-common-circle",
        section="3.3",
        where="proof of (thm:branched), line 770",
        kind="sentence",
        statement=r"The boundary of $B_\epsilon(p)$ computes the winding number of every $N_n$ and "
        r"of $N$ at $p$.",
        hypotheses=(*_SEQUENCE, *_BALL, *_WIDER),
        rests_on=("3.3.common-distance", "3.3.common-distance-sequence", "3.3.index-well-defined"),
        checks=(
            Check(
                name="circles of several radii",
                run="checks.verify.branched_limits:common_circle",
                tier="full",
                routes=(
                    "bound of |N - N(p)|",
                    "degrees along circles, in balls",
                ),
                mutants=(
                    Mutant(name="a circle across the edges", given={"largest": "3"}),
                    Mutant(
                        name="a circle across an edge of one front",
                        given={"largest": "3/2"},
                        near=True,
                    ),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="index of smooth immersions",
                run="checks.verify.branched_limits:smooth_index",
                tier="full",
                routes=(
                    "degrees along circles on fronts, in balls",
                    "stars of C^2 saddles",
                ),
                mutants=(
                    Mutant(name="J_p = -2", given={"index": -2}, near=True),
                    Mutant(name="J_p = 1", given={"index": 1}),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="difference of the normals",
                run="checks.verify.branched_limits:normals_converge",
                routes=(
                    "quotient of cross products",
                    "products of differences and bounded factors",
                ),
                mutants=(Mutant(name="different metrics", given={"same_metric": False}),),
            ),
        ),
    ),
    Claim(
        id="3.3.bmo-convergence",
        section="3.3",
        where="proof of (thm:branched), line 772",
        kind="sentence",
        statement=r"In two dimensions convergence in $W^{1,2}(\overline{B_{2\epsilon}(p)})$ "
        r"implies convergence in BMO and in $L^1$.",
        rests_on=("3.3.normals-converge",),
        checks=(
            Check(
                name="mean oscillation",
                run="checks.verify.branched_limits:oscillation",
                routes=(
                    "mean square of a mode on a cube of any side",
                    "its Dirichlet integral",
                ),
                mutants=(Mutant(name="dimension 3", given={"dimension": 3}),),
            ),
        ),
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
        checks=(
            Check(
                name="near loops",
                run="checks.verify.branched_limits:degree_stable",
                routes=(
                    "degree of the disturbed loop, arc by arc in balls",
                    "degree of the loop itself",
                ),
                mutants=(
                    Mutant(name="differences 1 % too large", given={"percent": 101}, near=True),
                    Mutant(name="differences half as large again", given={"percent": 150}),
                ),
            ),
        ),
    ),
)

CLAIMS: tuple[Claim, ...] = _INJECTIVE + _THEOREM
