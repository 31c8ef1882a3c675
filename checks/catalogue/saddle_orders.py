"""Claims of section 3.2, m-saddles: definition, crossings of the tangent plane, the order m_p."""

from checks.claim import Check, Claim, Mutant

_ORDERS = "checks.verify.saddle_orders:"
_SURFACES = "checks.verify.assembled_surfaces:"

_ASSEMBLY = (
    (
        r"$2m \ge 4$ even, $L < \infty$, $\kappa_i : [0, L) \to \mathbb{R}$ smooth, "
        r"$i = 1, \dots, 2m$"
    ),
    r"$\alpha_i \in (0, \pi)$, $\sum_{i=1}^{2m} \alpha_i = 2\pi$",
    r"(used, not stated) $L > 0$ and indices are cyclic modulo $2m$",
)

_SADDLES = (
    Claim(
        id="def:m-saddle",
        section="3.2",
        where="definition (def:m-saddle), lines 557-560",
        kind="definition",
        statement=r"An $m$-saddle is a $C^{1,1}$ map $r : T(\{\alpha_i\}, \{l_i\}) \to "
        r"\mathbb{R}^3$ from an $m$-star whose restriction $r_i = r|_{S_i}$ is a PS-front: "
        r"$r_i(u_i, v_i)$ and $N_i(u_i, v_i)$ are $C^{1M}$, and $N_i$ is weakly regular and "
        r"Lorentz harmonic.",
        labels=("def:m-saddle",),
        hypotheses=(
            r"(used, not stated) $r$ is an immersion, with a normal continuous on $T$",
            (
                r"(used, not stated) $C^{1,1}$ refers to the surface as a graph over its tangent "
                r"planes, not to the plane of the star $T$: see the proof of (prop:assembly)"
            ),
        ),
        rests_on=("def:m-star", "eq:sector-coords", "eq:lelieuvre", "eq:lorentz_harmonic"),
        checks=(
            Check(
                name="instances and near-misses",
                run=_ORDERS + "definition",
                tier="full",
                routes=(
                    "printed conditions",
                    "angle theta_uv = sin theta and a carried frame, as series",
                    (
                        "Frenet-Serret on both edges, vector Moutard equation, Lelieuvre "
                        "formulae, as series"
                    ),
                ),
                mutants=(
                    Mutant(name="r may jump", given={"position": False}),
                    Mutant(name="N may jump", given={"normal": False}),
                    Mutant(name="N need not be harmonic", given={"harmonic": False}),
                    Mutant(name="N need not be regular", given={"regular": False}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.2.order-of-saddleness",
        section="3.2",
        where="definition (def:m-saddle), line 558",
        kind="definition",
        statement=r"The order of saddleness of an $m$-saddle at the point $u_i = v_i = 0$ is $m$.",
        rests_on=("def:m-saddle",),
        checks=(
            Check(
                name="sides of the tangent plane",
                run=_ORDERS + "order_of_saddleness",
                routes=(
                    "half the number of sectors",
                    "signs of the quadratic saddle over a star",
                ),
                mutants=(
                    Mutant(name="the number of sectors", given={"per_order": 1}),
                    Mutant(name="m + 1", given={"offset": 1}),
                ),
            ),
        ),
    ),
)

_SADDLENESS = (
    Claim(
        id="3.2.tangent-plane-crossings",
        section="3.2",
        where="line 576",
        kind="sentence",
        statement=r"The order of saddleness $m_p$ is the number of times that a circuit in a small "
        r"deleted neighbourhood of $p$ crosses the tangent plane at $p$ from below to above.",
        hypotheses=(
            (
                "(used, not stated) the surface is an immersed $m$-saddle, and only crossings in "
                r"one direction are counted"
            ),
        ),
        rests_on=("3.2.order-of-saddleness", "eq:def_phi"),
        checks=(
            Check(
                name="leading form",
                run=_ORDERS + "leading_form",
                routes=(
                    "quadratic saddle over a star",
                    "assembled sectors, as series",
                ),
                mutants=(
                    Mutant(name="sigma sin(alpha) u v", given={"sign": 1}),
                    Mutant(name="twice", given={"factor": 2}),
                ),
                part="small circuits",
            ),
            Check(
                name="signs over stars",
                run=_ORDERS + "order_of_saddleness",
                routes=(
                    "half the number of sectors",
                    "signs of the quadratic saddle over a star",
                ),
                mutants=(
                    Mutant(name="the number of sectors", given={"per_order": 1}),
                    Mutant(name="m + 1", given={"offset": 1}),
                ),
                part="small circuits",
            ),
            Check(
                name="circuits on bent stars",
                run=_SURFACES + "crossings",
                routes=(
                    "order m",
                    "heights of surfaces integrated to second order",
                ),
                mutants=(
                    Mutant(name="crossings both ways", given={"directions": 2}),
                    Mutant(name="m + 1", given={"offset": 1}, near=True),
                ),
                part="small circuits",
                tier="full",
            ),
        ),
    ),
    Claim(
        id="3.2.undulations-persist",
        section="3.2",
        where="line 576",
        kind="sentence",
        statement=r"The $m_p - 2$ undulations in excess of a regular saddle persist to the "
        "boundary, so the buckling wavelength can shorten there while the surface stays isometric.",
        hypotheses=(
            "(used, not stated) the surface is a pseudospherical immersion as far as the boundary",
        ),
        rests_on=("3.2.tangent-plane-crossings",),
        checks=(
            Check(
                name="sign of the height on Amsler sectors",
                run=_ORDERS + "height_keeps_its_sign",
                routes=(
                    "Gauss-Weingarten for an unknown angle",
                    "angle and carried frame, as series",
                ),
                mutants=(
                    Mutant(name="height convex the other way", given={"sign": 1}),
                    Mutant(name="bent edges", given={"bend": 1}),
                ),
                part="straight rays",
            ),
            Check(
                name="boundary of bent stars",
                run=_SURFACES + "undulations",
                routes=(
                    "m - 2",
                    "heights of surfaces integrated to second order",
                ),
                mutants=(
                    Mutant(name="m - 3", given={"regular": 3}, near=True),
                    Mutant(name="two sectors left out", given={"away": 2}),
                ),
                part="bent rays",
                tier="full",
            ),
        ),
    ),
    Claim(
        id="3.2.assembled-order",
        section="3.2",
        where="line 578",
        kind="sentence",
        statement=r"At the common point of the sectors of an assembled surface $m_p = m$, half the "
        "number of sectors.",
        hypotheses=_ASSEMBLY,
        rests_on=("prop:assembly", "3.2.order-of-saddleness"),
        checks=(
            Check(
                name="leading forms",
                run=_ORDERS + "assembled_order",
                routes=(
                    "quadratic saddle over a star",
                    "assembled sectors, as series",
                ),
                mutants=(
                    Mutant(name="leading form reversed", given={"sign": 1}),
                    Mutant(name="m + 1", given={"offset": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.2.dupin",
        section="3.2",
        where="line 578",
        kind="sentence",
        statement=r"The asymptotic directions at $p$ are those of the intersection of the surface "
        r"with its tangent plane at $p$.",
        hypotheses=("(used, not stated) negative curvature, near $p$",),
        rests_on=("eq:metrics", "prop:assembly"),
        checks=(
            Check(
                name="second form",
                run=_ORDERS + "dupin",
                routes=(
                    "Gauss-Weingarten for an unknown angle",
                    "assembled sectors, as series",
                ),
                mutants=(
                    Mutant(name="sin^2", given={"power": 2}),
                    Mutant(name="reversed", given={"sign": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.2.directions-and-order",
        section="3.2",
        where="line 578",
        kind="sentence",
        statement=r"For every surface of the kind considered, the number of asymptotic directions "
        r"that leave $p$ is the number of sectors, $2 m_p$.",
        rests_on=("3.2.dupin", "3.2.tangent-plane-crossings"),
        checks=(
            Check(
                name="zeros and signs",
                run=_ORDERS + "directions_and_order",
                routes=(
                    "zeros of the quadratic saddle over a star",
                    "its signs",
                ),
                mutants=(
                    Mutant(name="m_p directions", given={"per_order": 1}),
                    Mutant(name="opposite directions as one", given={"doubled": True}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.2.order-elsewhere",
        section="3.2",
        where="line 578, on the figures (fig:saddle) and (fig:mkysaddle)",
        kind="sentence",
        statement=r"Every point of the smooth saddle has $m_p = 2$; the monkey saddle has one "
        r"point with $m_p = 3$, and $m_p = 2$ at all others, also on the rays.",
        rests_on=("3.2.assembled-order",),
        checks=(
            Check(
                name="centre, rays and interior",
                run=_ORDERS + "order_elsewhere",
                tier="full",
                routes=(
                    "stars of the asymptotic angles at the point",
                    "normal on a ray from both sides, as series",
                ),
                mutants=(
                    Mutant(name="order 3 everywhere", given={"expected": 3}),
                    Mutant(name="rays that end", given={"through": False}),
                ),
            ),
        ),
    ),
    Claim(
        id="fig:winding_number_normalfield",
        section="3.2",
        where="figure (fig:winding_number_normalfield), lines 580-607",
        kind="figure",
        statement=r"At the centre $m_p = 2$, $J_p = -1$ for the saddle and $m_p = 3$, $J_p = -2$ "
        "for the monkey saddle.",
        labels=(
            "fig:saddle",
            "fig:nrmlsaddle",
            "fig:mkysaddle",
            "fig:nrmlmkysaddle",
            "fig:winding_number_normalfield",
        ),
        rests_on=("def:Jp", "3.2.assembled-order"),
        checks=(
            Check(
                name="turns of the gradient",
                run=_ORDERS + "windings",
                routes=(
                    "1 - m",
                    "turns over the quadratic saddle",
                ),
                mutants=(
                    Mutant(name="2 - m", given={"offset": 1}),
                    Mutant(name="m - 1", given={"sense": -1}),
                ),
            ),
            Check(
                name="order at the centre",
                run=_ORDERS + "order_of_saddleness",
                routes=(
                    "half the number of sectors",
                    "signs of the quadratic saddle over a star",
                ),
                mutants=(
                    Mutant(name="the number of sectors", given={"per_order": 1}),
                    Mutant(name="m + 1", given={"offset": 1}),
                ),
                part="order",
            ),
            Check(
                name="turns of the normal of bent stars",
                run=_SURFACES + "normal_turns",
                routes=(
                    "1 - m",
                    "normals of surfaces integrated to second order",
                ),
                mutants=(
                    Mutant(name="2 - m", given={"offset": 1}, near=True),
                    Mutant(name="clockwise", given={"sense": -1}),
                ),
                tier="full",
            ),
        ),
    ),
)

CLAIMS: tuple[Claim, ...] = _SADDLES + _SADDLENESS
