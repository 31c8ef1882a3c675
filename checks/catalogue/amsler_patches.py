"""Claims of section 3.2, Amsler sectors patched around a point: the monkey saddle."""

from checks.claim import Claim

_DATA = (
    (
        r"$\mathbf{n}$, $\mathbf{e}_u$, $\mathbf{e}_v$ unit vectors, $\mathbf{e}_u \perp "
        r"\mathbf{n}$, $\mathbf{e}_v \perp \mathbf{n}$, and $\mathbf{z} \in \mathbb{R}^3$"
    ),
)
_PATCH = (
    (
        r"$\mathbf{z} = 0$, $\mathbf{n} = \mathbf{e}_3$; $\mathbf{e}_u = \mathbf{s}_i$, "
        r"$\mathbf{e}_v = \mathbf{s}_{i-1}$ for even $i$, exchanged for odd $i$"
    ),
    r"$\alpha_i \in (0, \pi)$, $\sum_{i=1}^{2m} \alpha_i = 2\pi$, $2m \ge 4$",
    r"(used, not stated) indices are cyclic modulo $2m$",
)

_BOUNDARY = (
    Claim(
        id="amsler-frame",
        section="3.2",
        where="equation (amsler-frame), lines 496-497, the normal",
        kind="equation",
        statement=r"An Amsler sector has $N(u, 0) = \cos u\,\mathbf{n} + \sin u\,\mathbf{n} \times "
        r"\mathbf{e}_u$ and $N(0, v) = \cos v\,\mathbf{n} - \sin v\,\mathbf{n} \times "
        r"\mathbf{e}_v$ on its bounding curves.",
        labels=("amsler-frame",),
        hypotheses=_DATA,
    ),
    Claim(
        id="3.2.amsler-boundary-lines",
        section="3.2",
        where="equation (amsler-frame), line 498, the position",
        kind="equation",
        statement=r"The bounding curves of an Amsler sector are straight: $r(u, 0) = \mathbf{z} + "
        r"u\,\mathbf{e}_u$ and, with the argument as printed, $r(v, 0) = \mathbf{z} + v\,"
        r"\mathbf{e}_v$.",
        hypotheses=_DATA,
        rests_on=("amsler-frame",),
    ),
    Claim(
        id="3.2.amsler-frame-solves-u",
        section="3.2",
        where="line 501",
        kind="sentence",
        statement=r"The data on $v = 0$ solve the first Frenet system of (eq:frames), with "
        r"$\kappa^u = 0$.",
        hypotheses=_DATA,
        rests_on=("amsler-frame", "3.2.amsler-boundary-lines", "eq:frames"),
    ),
    Claim(
        id="3.2.amsler-frame-solves-v",
        section="3.2",
        where="line 501",
        kind="sentence",
        statement=r"The data on $u = 0$ solve the second Frenet system of (eq:frames), with "
        r"$\kappa^v = 0$.",
        hypotheses=_DATA,
        rests_on=("amsler-frame", "3.2.amsler-boundary-lines", "eq:frames"),
    ),
    Claim(
        id="3.2.goursat",
        section="3.2",
        where="line 501",
        kind="sentence",
        statement=r"The Goursat problem of the Moutard equation $N_{uv} = -(N_u \cdot N_v) N$ with "
        r"these data has a solution $N(u, v) \in S^2$, smooth inside the sector and continuous "
        r"up to its boundary.",
        hypotheses=(
            *_DATA,
            (
                r"(used, not stated) the solution keeps $\|N\| = \|N_u\| = \|N_v\| = 1$ and exists "
                r"on the whole rectangle of the data"
            ),
        ),
        rests_on=("amsler-frame", "eq:moutard"),
    ),
    Claim(
        id="3.2.goursat-boundary",
        section="3.2",
        where="line 501",
        kind="sentence",
        statement=r"The solution of the Goursat problem takes the prescribed values $N(u, 0)$ on "
        r"$v = 0$ and $N(0, v)$ on $u = 0$.",
        hypotheses=(*_DATA, r"(used, not stated) the data agree at $u = v = 0$"),
        rests_on=("3.2.goursat", "amsler-frame"),
    ),
)

_PATCHING = (
    Claim(
        id="3.2.patch-directions",
        section="3.2",
        where="line 503",
        kind="definition",
        statement=r"On $S_i$ take $\mathbf{z} = 0$, $\mathbf{n} = \mathbf{e}_3$, and "
        r"$(\mathbf{e}_u, \mathbf{e}_v) = (\mathbf{s}_i, \mathbf{s}_{i-1})$ for even $i$, "
        r"$(\mathbf{s}_{i-1}, \mathbf{s}_i)$ for odd $i$.",
        hypotheses=_PATCH,
        rests_on=("def:m-star", "amsler-frame"),
    ),
    Claim(
        id="3.2.rays-consistent",
        section="3.2",
        where="line 503",
        kind="sentence",
        statement=r"On the ray that two sectors share, $u$ or $v$ vanishes, and $N$ and $r$ "
        r"do not depend on the sector by which they are defined.",
        hypotheses=_PATCH,
        rests_on=("3.2.patch-directions", "3.2.amsler-boundary-lines", "eq:sector-coords"),
    ),
    Claim(
        id="3.2.origin-consistent",
        section="3.2",
        where="line 503",
        kind="sentence",
        statement=r"$r_i(0, 0) = 0$ and $N_i(0, 0) = \mathbf{e}_3$ for every $i$.",
        hypotheses=_PATCH,
        rests_on=("3.2.patch-directions",),
    ),
    Claim(
        id="3.2.patch-front",
        section="3.2",
        where="line 505",
        kind="sentence",
        statement=r"The solution $N_i$ is weakly harmonic inside $S_i$ and determines a PS-front "
        r"$r_i : S_i \to \mathbb{R}^3$ by the Lelieuvre equations, with $r_i(0, 0) = 0$ and normal "
        r"$N_i$.",
        hypotheses=_PATCH,
        rests_on=("3.2.goursat", "eq:lelieuvre"),
    ),
    Claim(
        id="3.2.corner-limit",
        section="3.2",
        where="line 505",
        kind="equation",
        statement=r"$\lim_{(u, v) \to (0, 0)} N_u \times N_v = \pm\,\mathbf{s}^*_{i-1} \cdot "
        r"\mathbf{s}_i \ne 0$ on $S_i$, a vector equal to a scalar as printed.",
        hypotheses=_PATCH,
        rests_on=("3.2.patch-directions", "3.2.goursat-boundary", "3.2.dual-vectors"),
    ),
    Claim(
        id="3.2.regular-rectangle",
        section="3.2",
        where="line 505",
        kind="sentence",
        statement=r"There are $c_i, d_i > 0$ such that $N_u \times N_v \ne 0$ on $J_i = \{0 < u_i "
        r"< c_i,\ 0 < v_i < d_i\} \subset S_i$.",
        hypotheses=(*_PATCH, r"(used, not stated) $d_i > 0$ is claimed along with $c_i$"),
        rests_on=("3.2.corner-limit",),
    ),
    Claim(
        id="3.2.patch-extends",
        section="3.2",
        where="line 505",
        kind="sentence",
        statement=r"$r_i \in C^\infty(J_i) \cap C(\overline{J_i})$.",
        hypotheses=_PATCH,
        rests_on=("3.2.regular-rectangle", "3.2.patch-front"),
    ),
    Claim(
        id="3.2.patched-saddle",
        section="3.2",
        where="line 505",
        kind="sentence",
        statement=r"After $c_i, d_i$ are made smaller if necessary, $T = \bigcup_i J_i$ is an "
        r"$m$-star and $r = r_i$ on $J_i$ is an $m$-saddle, a piecewise smooth PS-front on $T$.",
        hypotheses=(
            *_PATCH,
            r"(used, not stated) $J_i$ contains its two rays and the origin",
            (
                r"(used, not stated) neighbours have the same length on their common ray: $c_i = "
                r"c_{i+1}$ for even $i$, $d_i = d_{i+1}$ for odd $i$"
            ),
        ),
        rests_on=("3.2.patch-extends", "3.2.rays-consistent", "def:m-star", "def:m-saddle"),
    ),
)

_MONKEY_SADDLE = (
    Claim(
        id="fig:monkeysaddleconstruction",
        section="3.2",
        where="figure (fig:monkeysaddleconstruction), lines 507-548",
        kind="figure",
        statement=r"Six smooth sectors make a $3$-saddle with $K = -1$ of geodesic radius 1, and "
        "the normal is continuous across their common rays.",
        labels=(
            "fig:monkey_saddle_construction_withnormal_stage1",
            "fig:monkey_saddle_construction_withnormal_stage2",
            "fig:monkey_saddle_construction_withnormal_stage3",
            "fig:monkey_saddle_construction_withnormal_stage4",
            "fig:monkey_saddle_construction_withnormal_stage5",
            "fig:monkey_saddle_construction_withnormal_stage6",
            "fig:monkeysaddleconstruction",
        ),
        hypotheses=(r"$2m = 6$, $\alpha_k = \pi/3$, Amsler sectors",),
        rests_on=("3.2.patched-saddle", "PIII"),
    ),
    Claim(
        id="3.2.monkey-saddle-angles",
        section="3.2",
        where="line 550",
        kind="number",
        statement=r"$2m = 6$ and $\alpha_k = \pi/3$, $k = 1, \dots, 6$, are admissible data of a "
        r"$3$-star: each is in $(0, \pi)$ and the sum is $2\pi$.",
        rests_on=("def:m-star",),
    ),
    Claim(
        id="3.2.normal-lipschitz",
        section="3.2",
        where="line 550",
        kind="sentence",
        statement="A continuous, piecewise smooth normal field on the star is globally Lipschitz.",
        hypotheses=(
            "finitely many sectors, on each of which the normal is smooth",
            "(used, not stated) first derivatives are bounded up to the boundary of each sector",
        ),
        rests_on=("3.2.patched-saddle",),
    ),
    Claim(
        id="3.2.immersion-c11",
        section="3.2",
        where="line 550",
        kind="sentence",
        statement=r"The patched immersion is $C^{1,1}$.",
        hypotheses=(
            *_PATCH,
            (
                r"(used, not stated) $C^{1,1}$ refers to a smooth structure of the surface, such "
                r"as that of $\mathbb{H}^2$ or of the tangent plane, not to the sector coordinates"
            ),
        ),
        rests_on=("3.2.normal-lipschitz", "3.2.patched-saddle"),
    ),
    Claim(
        id="3.2.sectors-are-amsler",
        section="3.2",
        where="line 550",
        kind="sentence",
        statement="The restriction of the patched immersion to each sector is an Amsler sector.",
        hypotheses=(
            *_PATCH,
            (
                r"(used, not stated) a restriction of an Amsler sector to a bounded rectangle "
                r"counts as one, or the front extends to $[0, \infty)^2$"
            ),
        ),
        rests_on=("3.2.patched-saddle", "def:amsler-sector"),
    ),
    Claim(
        id="3.2.not-coordinates-across-rays",
        section="3.2",
        where="remark, line 553",
        kind="remark",
        statement=r"The functions $u, v$, without the index of the sector, are not one-to-one on "
        r"any open set that meets the boundary between two sectors.",
        rests_on=("eq:sector-coords", "3.2.ray-coordinates-even"),
    ),
    Claim(
        id="3.2.patching-principle",
        section="3.2",
        where="remark, line 553",
        kind="remark",
        statement=r"If $u$, $v$, $r(u, v)$ and $N(u, v)$ agree on all $S_i \cap S_j$, then they "
        r"are continuous functions on the $m$-star $\bigcup_{i=1}^{2m} S_i$.",
        hypotheses=(
            "each function is continuous on each sector",
            r"(used, not stated) each $S_i$ is closed in the star",
        ),
        rests_on=("3.2.ray-coordinates-even", "3.2.ray-coordinates-odd", "def:m-star"),
    ),
)

CLAIMS: tuple[Claim, ...] = _BOUNDARY + _PATCHING + _MONKEY_SADDLE
