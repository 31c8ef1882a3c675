"""Claims of section 3.3, the ramification index of the normal map, and the order of saddleness."""

from checks.claim import Check, Claim, Erratum, Mutant

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
        checks=(
            Check(
                name="degree on graphs",
                run="checks.verify.normal_index:ramification_index",
                routes=(
                    "degree of pi(N) along a circle, arc by arc in balls",
                    "zeros of the gradient inside the circle",
                ),
                mutants=(
                    Mutant(name="twice around", given={"turns": 2}, near=True),
                    Mutant(name="clockwise", given={"turns": -1}),
                    Mutant(
                        name="a saddle in place of the cylinder to be refused",
                        given={"refused": "x**2 - y**2"},
                    ),
                ),
            ),
        ),
    ),
    Claim(
        id="3.3.equator-retraction",
        section="3.3",
        where="definition (def:Jp), line 666",
        kind="equation",
        statement=r"$x_\perp = x - \langle N(p), x \rangle N(p)$ and $\pi(x) = x_\perp / "
        r"\|x_\perp\|$ define a retraction of $S^2 \setminus \{\pm N(p)\}$ to its equator $S^1$.",
        checks=(
            Check(
                name="retraction",
                run="checks.verify.normal_index:equator_retraction",
                tier="full",
                routes=(
                    "pi of a point at a given height over the equator",
                    "the point itself",
                ),
                mutants=(
                    Mutant(name="x_perp = x + <N, x> N", given={"sign": 1}),
                    Mutant(name="not normalised", given={"power": 0}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.3.index-well-defined",
        section="3.3",
        where="definition (def:Jp), lines 663-666",
        kind="sentence",
        statement=r"$J_p$ does not depend on the simple closed curve $\gamma$ in $U$, nor on $V$.",
        hypotheses=(
            r"$\gamma$ a simple closed curve in $U$, $N(U) \subseteq S^2 \setminus \{\pm N(p)\}$",
            (
                r"(not said in the definition, but of all curves that the paper takes: line 670, a "
                r"counterclockwise circuit around $p$; lines 677 and 701, small circles) $\gamma$ "
                r"bounds a disk in $V$ that contains $p$ and goes around it counterclockwise. Read "
                r"without, the circle of centre $(3/2, 0)$ and radius 1 has the degree 0 for $w = "
                r"(x_1^2 - x_2^2)/2$, $p = 0$"
            ),
        ),
        rests_on=("def:Jp",),
        checks=(
            Check(
                name="circles about p",
                run="checks.verify.normal_index:well_defined",
                routes=(
                    "zeros of the gradient inside circles of several centres",
                    "the degree of a small circle",
                ),
                mutants=(
                    Mutant(name="either sense", given={"sense": 0}),
                    Mutant(name="curves that leave p outside", given={"around": False}),
                    Mutant(name="V with a hole", given={"hole": True}, near=True),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="sense of the normal",
                run="checks.verify.normal_index:negative_curvature",
                routes=(
                    "rate of turning from the determinant of the Hessian",
                    "degrees along circles, in balls, on graphs, fronts and stars",
                ),
                mutants=(
                    Mutant(name="positive curvature", given={"curvature": 1}),
                    Mutant(name="counter-clockwise", given={"sense": 1}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="3.3.index-minus-one",
        section="3.3",
        where="line 671",
        kind="sentence",
        statement=r"If $J_p = -1$, then the normal map is a homeomorphism near $p$.",
        hypotheses=_IMMERSION,
        rests_on=("def:Jp",),
        checks=(
            Check(
                name="one preimage",
                run="checks.verify.normal_turning:sheets_of_order_two",
                routes=(
                    "preimages under the tangent map of N, with exact signs",
                    "the number 1 of a homeomorphism",
                ),
                mutants=(
                    Mutant(name="a branch point of order 3", given={"only": 3}),
                    Mutant(name="no preimage", given={"shift": -2}),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="number of sheets",
                run="checks.verify.normal_turning:sheets",
                routes=(
                    "preimages under the tangent map of N, with exact signs",
                    "|J_p| = m_p - 1",
                ),
                mutants=(
                    Mutant(name="m_p sheets", given={"shift": 0}, near=True),
                    Mutant(name="m_p - 2 sheets", given={"shift": -2}),
                    Mutant(name="order 2", given={"only": 2, "least": 2}),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="threshold",
                run="checks.verify.normal_index:branch_index",
                routes=(
                    "J_p of stars by the winding of the gradient",
                    "m_p, half the number of sectors",
                ),
                mutants=(
                    Mutant(name="|J_p| > 2", given={"threshold": 2}),
                    Mutant(name="|J_p| > 0", given={"threshold": 0}),
                    Mutant(name="J_p > 1", given={"absolute": False}),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="direction of pi(N)",
                run="checks.verify.normal_graphs:graph_normal",
                routes=(
                    "upward normal of a graph, retracted",
                    "the gradient",
                ),
                mutants=(Mutant(name="the gradient doubled", given={"sign": 2}),),
            ),
            Check(
                name="opposite to the gradient",
                run="checks.verify.normal_graphs:graph_normal",
                form="corrected",
                given={"sign": -1},
                routes=(
                    "upward normal of a graph, retracted",
                    "the gradient",
                ),
                mutants=(Mutant(name="along the gradient", given={"sign": 1}),),
            ),
        ),
        erratum=Erratum(
            printed=r"$\pi \circ N = \nabla w / \|\nabla w\|$",
            corrected=r"$\pi \circ N = -\nabla w / \|\nabla w\|$",
            kind="misprint",
            witness=r"$w = (x_1^2 - x_2^2)/2$ at $(1, 0)$: the normal of $\omega = dx_1 \wedge "
            r"dx_2$, (eq:Nfront), is $(-1, 0, 1)/\sqrt{2}$, so $\pi(N) = (-1, 0)$; "
            r"$\nabla w = (1, 0)$.",
            conclusion_survives=True,
            remark="The two directions are opposite, and turning all vectors by pi changes no "
            "degree: the display on lines 675-677 is right. With the downward normal the printed "
            "sign is right, but the paper takes the upward one.",
        ),
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
        checks=(
            Check(
                name="degree of the gradient",
                run="checks.verify.normal_graphs:graph_index",
                routes=(
                    "degree of pi(N) by definition, arc by arc in balls",
                    "zeros of the gradient inside the circle",
                ),
                mutants=(
                    Mutant(name="the second derivative reversed", given={"conjugate": -1}),
                    Mutant(name="a circle that is not small", given={"radius": "10"}, near=True),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="index of stars",
                run="checks.verify.normal_turning:covering_number",
                tier="full",
                routes=(
                    "lifts of the angles and preimages, from Lelieuvre",
                    "winding number of the gradient of the quadratic saddle",
                ),
                mutants=(
                    Mutant(name="J_p = 2 - m_p", given={"offset": 2}),
                    Mutant(name="J_p = 1 + m_p", given={"slope": 1}),
                    Mutant(name="J_p = m_p - 1", given={"offset": -1, "slope": 1}),
                ),
            ),
            Check(
                name="loops of finite size",
                run="checks.verify.star_loops:winding_of_stars",
                tier="full",
                form="support",
                routes=("normals of stars by Picard iteration", "1 - m_p"),
                mutants=(
                    Mutant(name="J_p = 2 - m_p", given={"offset": 2}, near=True),
                    Mutant(name="N reflected on odd sectors", given={"swapped": True}),
                ),
            ),
            Check(
                name="no further turn near p",
                run="checks.verify.normal_separation:separation",
                form="support",
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
        id="3.3.normal-well-defined",
        section="3.3",
        where="proof of (lem:covering-number), lines 686-687",
        kind="sentence",
        statement=r"$N$ is Lipschitz for a $C^{1,1}$ immersion, so $m_p$ and $J_p$ are defined.",
        hypotheses=(
            *_IMMERSION,
            (
                r"(used, not stated) $N(x) \ne N(p)$ near $p$, which continuity does not give but "
                r"the curvature $-1$ does"
            ),
        ),
        rests_on=("def:Jp",),
        checks=(
            Check(
                name="Lipschitz, with an inverse",
                run="checks.verify.normal_separation:normal_defined",
                routes=(
                    "stretch of N by the principal curvatures",
                    "bound of |N - N(p)| on sectors",
                ),
                mutants=(Mutant(name="curvature 0", given={"curvature": 0}),),
            ),
        ),
    ),
    Claim(
        id="3.3.index-motion-invariant",
        section="3.3",
        where="proof of (lem:covering-number), line 689",
        kind="sentence",
        statement=r"$m_p$ and $J_p$ are invariant under Euclidean motions, so one may take $y(p) = "
        r"0$ and $N(p) = \mathbf{e}_3$.",
        hypotheses=(
            *_IMMERSION,
            (
                r"(used, not stated) $N$ is given by the orientation of $\Omega$, so that it "
                "changes sign besides where the motion is a reflection"
            ),
        ),
        rests_on=("def:Jp",),
        checks=(
            Check(
                name="motions",
                run="checks.verify.normal_index:motion_invariant",
                tier="full",
                routes=(
                    "N of the moved surface, by cross products",
                    "retraction before the motion",
                ),
                mutants=(
                    Mutant(
                        name="the normal carried by a reflection unchanged",
                        given={"reflected_normal": 1},
                    ),
                ),
            ),
        ),
    ),
    Claim(
        id="3.3.normal-derivatives",
        section="3.3",
        where="proof of (lem:covering-number), line 691",
        kind="equation",
        statement=r"$N_u = N \times r_u$ and $N_v = -N \times r_v$.",
        hypotheses=(r"(used, not stated) $r_u, r_v \perp N$ and $\|N\| = 1$",),
        rests_on=("eq:lelieuvre",),
        checks=(
            Check(
                name="from Lelieuvre",
                run="checks.verify.normal_turning:normal_derivatives",
                routes=(
                    "derivatives of an arbitrary unit normal",
                    "cross products with r_u and r_v",
                ),
                mutants=(
                    Mutant(name="N_u reversed", given={"u_sign": -1}),
                    Mutant(name="N_v reversed", given={"v_sign": 1}),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="tangents at e_3",
                run="checks.verify.normal_turning:lifted_tangents",
                routes=(
                    "e_3 x s_i and -e_3 x s_i",
                    "unit vectors at the printed angles",
                ),
                mutants=(
                    Mutant(name="even rays turned back", given={"even": -1}),
                    Mutant(name="odd rays turned forward", given={"odd": 1}),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="angles of the images",
                run="checks.verify.normal_turning:lifted_tangents",
                routes=(
                    "e_3 x s_i and -e_3 x s_i",
                    "unit vectors at the printed angles",
                ),
                mutants=(
                    Mutant(name="parities exchanged", given={"even": -1, "odd": 1}),
                    Mutant(name="both turned forward", given={"odd": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.3.normal-cross-product",
        section="3.3",
        where="proof of (lem:covering-number), line 691",
        kind="equation",
        statement=r"$N_u \times N_v = -r_u \times r_v$.",
        rests_on=("3.3.normal-derivatives",),
        checks=(
            Check(
                name="product of the derivatives",
                run="checks.verify.normal_turning:normal_cross_product",
                routes=(
                    "derivatives of N from the fundamental forms (Weingarten)",
                    "r_u x r_v",
                ),
                mutants=(Mutant(name="sign +", given={"sign": 1}),),
            ),
        ),
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
        checks=(
            Check(
                name="lift in (0, pi)",
                run="checks.verify.normal_turning:theta_lift",
                routes=(
                    "printed angles modulo 2 pi",
                    "cross products of the images",
                ),
                mutants=(
                    Mutant(name="theta_{i+1} - theta_i", given={"sense": -1}),
                    Mutant(name="parities exchanged", given={"shift": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.3.theta-two-steps",
        section="3.3",
        where="proof of (lem:covering-number), line 691",
        kind="equation",
        statement=r"$\theta_{i+2} - \theta_i = \beta_{i+2} - \beta_i - 2\pi$.",
        hypotheses=_SADDLE,
        rests_on=("3.3.theta-lift",),
        checks=(
            Check(
                name="two lifts",
                run="checks.verify.normal_turning:theta_two_steps",
                routes=(
                    "two steps of alpha - pi",
                    "printed difference",
                ),
                mutants=(
                    Mutant(name="+ 2 pi", given={"turns": 2}),
                    Mutant(name="- pi", given={"turns": -1}),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="sum over a circuit",
                run="checks.verify.normal_turning:theta_sum",
                routes=(
                    "sum of alpha_i - pi over free angles",
                    "printed total",
                ),
                mutants=(
                    Mutant(name="2 (2 - m) pi", given={"offset": 2}),
                    Mutant(name="2 (1 + m) pi", given={"slope": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.3.winding-jump",
        section="3.3",
        where="line 698",
        kind="sentence",
        statement="The winding numbers of the normal at the centre are 1 for the saddle and 2 for "
        "the monkey saddle, up to sign, and no continuous change leads from one to the other.",
        rests_on=("fig:winding_number_normalfield", "lem:covering-number"),
        checks=(
            Check(
                name="path between the saddles",
                run="checks.verify.normal_graphs:winding_jump",
                routes=(
                    "zeros of the gradient inside the unit circle",
                    "where the gradient vanishes on the circle",
                ),
                mutants=(
                    Mutant(name="a saddle of order 4", given={"second": 4}, near=True),
                    Mutant(name="from the monkey saddle", given={"first": 3}),
                ),
            ),
        ),
    ),
)

CLAIMS: tuple[Claim, ...] = _INDEX + _GRAPHS + _COVERING
