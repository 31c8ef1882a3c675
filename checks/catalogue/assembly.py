"""Claims of section 3.2, m-saddles, their assembly from curves, the order of saddleness."""

from checks.claim import Claim

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
            r"(used, not stated) the smooth structure of $T$ to which $C^{1,1}$ refers",
        ),
        rests_on=("def:m-star", "eq:sector-coords", "eq:lelieuvre", "eq:lorentz_harmonic"),
    ),
    Claim(
        id="3.2.order-of-saddleness",
        section="3.2",
        where="definition (def:m-saddle), line 558",
        kind="definition",
        statement=r"The order of saddleness of an $m$-saddle at the point $u_i = v_i = 0$ is $m$.",
        rests_on=("def:m-saddle",),
    ),
)

_PROPOSITION = (
    Claim(
        id="prop:assembly",
        section="3.2",
        where="proposition (prop:assembly), lines 564-571",
        kind="proposition",
        statement=r"Given smooth $\kappa_i$ on $[0, L)$ and angles $\alpha_i$, there are lengths "
        r"$l_i \in (0, L)$, $2m$ unit-speed Frenet frames $F_i : [0, l_i) \to M_{3 \times 3}$ and "
        r"an $m$-saddle $r : T(\{\alpha_i\}, \{l_i\}) \to \mathbb{R}^3$ with the properties 1 "
        r"and 2.",
        labels=("prop:assembly",),
        hypotheses=_ASSEMBLY,
        rests_on=(
            "3.2.assembly-origin",
            "3.2.assembly-frames",
            "3.2.assembly-goursat",
            "3.2.assembly-glue",
            "3.2.assembly-regular",
            "def:m-saddle",
        ),
    ),
    Claim(
        id="3.2.assembly-origin",
        section="3.2",
        where="proposition (prop:assembly), item 1, line 566",
        kind="item",
        statement=r"$r(0, 0) = 0$ and $N(0, 0) = \mathbf{e}_3$.",
        hypotheses=_ASSEMBLY,
        rests_on=("def:m-saddle",),
    ),
    Claim(
        id="3.2.assembly-frames",
        section="3.2",
        where="proposition (prop:assembly), item 2, line 567",
        kind="item",
        statement=r"For even (odd) $i$ the frame $F_i$ solves the first (second) system of "
        r"(eq:frames) with $\kappa^u = \kappa_i$ ($\kappa^v = \kappa_i$), $r_u(0) = \mathbf{s}_i$ "
        r"($r_v(0) = \mathbf{s}_i$) and $N(0) = \mathbf{e}_3$.",
        hypotheses=_ASSEMBLY,
        rests_on=("eq:frames", "def:m-star"),
    ),
    Claim(
        id="3.2.assembly-frenet-exists",
        section="3.2",
        where="proof of (prop:assembly), line 573",
        kind="sentence",
        statement=r"Each Frenet frame $F_i$ exists, is unique, and stays orthonormal on "
        r"$[0, L)$.",
        hypotheses=_ASSEMBLY,
        rests_on=("eq:frames",),
    ),
    Claim(
        id="3.2.assembly-boundary-normal",
        section="3.2",
        where="proof of (prop:assembly), line 573",
        kind="sentence",
        statement=r"The angles and the curvatures determine $N$ on the boundary of every sector.",
        hypotheses=_ASSEMBLY,
        rests_on=("3.2.assembly-frenet-exists", "3.2.assembly-frames"),
    ),
    Claim(
        id="3.2.assembly-goursat",
        section="3.2",
        where="proof of (prop:assembly), line 573",
        kind="sentence",
        statement=r"With these boundary values the Moutard equation has a solution $N_i(u, v)$ in "
        r"each sector; it is weakly harmonic, so the Lelieuvre formulae give $r_i$.",
        hypotheses=_ASSEMBLY,
        rests_on=("3.2.assembly-boundary-normal", "eq:moutard", "eq:lelieuvre"),
    ),
    Claim(
        id="3.2.assembly-glue",
        section="3.2",
        where="proof of (prop:assembly), line 573",
        kind="sentence",
        statement=r"On $S_i \cap S_{i+1}$ both solutions reduce to the curve $t \mapsto "
        r"r(t\,\mathbf{s}_i)$, $0 \le t < l_i$, with the normal of $F_i$.",
        hypotheses=_ASSEMBLY,
        rests_on=("3.2.assembly-goursat", "3.2.star-neighbourhood"),
    ),
    Claim(
        id="3.2.assembly-corner-limit",
        section="3.2",
        where="proof of (prop:assembly), line 573",
        kind="equation",
        statement=r"$\lim_{(u, v) \to (0, 0)} \|N_u \times N_v\| = |\mathbf{s}^*_{i-1} \cdot "
        r"\mathbf{s}_i| > 0$ on $S_i$.",
        hypotheses=_ASSEMBLY,
        rests_on=("3.2.assembly-goursat", "3.2.dual-vectors"),
    ),
    Claim(
        id="3.2.assembly-regular",
        section="3.2",
        where="proof of (prop:assembly), line 573",
        kind="sentence",
        statement=r"For small $l_i$ the patched normal is piecewise smooth and globally Lipschitz, "
        r"and $r : T \to \mathbb{R}^3$ is a $C^{1,1}$ immersion.",
        hypotheses=(
            *_ASSEMBLY,
            (
                r"(used, not stated) $C^{1,1}$ refers to a smooth structure of the surface: in the "
                r"sector coordinates of $T$ the derivative jumps across a curved ray"
            ),
        ),
        rests_on=("3.2.assembly-glue", "3.2.assembly-corner-limit"),
    ),
    Claim(
        id="3.2.assembly-generalises",
        section="3.2",
        where="line 556",
        kind="sentence",
        statement=r"The patching of Amsler sectors is the case $\kappa_i = 0$ of assembly.",
        hypotheses=_ASSEMBLY,
        rests_on=("prop:assembly", "3.2.patched-saddle"),
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
    ),
    Claim(
        id="3.2.directions-and-order",
        section="3.2",
        where="line 578",
        kind="sentence",
        statement=r"For every surface of the kind considered, the number of asymptotic directions "
        r"that leave $p$ is the number of sectors, $2 m_p$.",
        rests_on=("3.2.dupin", "3.2.tangent-plane-crossings"),
    ),
    Claim(
        id="3.2.order-elsewhere",
        section="3.2",
        where="line 578, on the figures (fig:saddle) and (fig:mkysaddle)",
        kind="sentence",
        statement=r"Every point of the smooth saddle has $m_p = 2$; the monkey saddle has one "
        r"point with $m_p = 3$, and $m_p = 2$ at all others, also on the rays.",
        rests_on=("3.2.assembled-order",),
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
    ),
)

CLAIMS: tuple[Claim, ...] = _SADDLES + _PROPOSITION + _SADDLENESS
