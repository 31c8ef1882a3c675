"""Claims of section 3.2, Amsler sectors patched around a point."""

from checks.claim import Check, Claim, Erratum, Mutant

_DATA_RUN = "checks.verify.amsler_patches:"
_RUN = "checks.verify.patched_sectors:"

_PATCH = (
    (
        r"$\mathbf{z} = 0$, $\mathbf{n} = \mathbf{e}_3$; $\mathbf{e}_u = \mathbf{s}_i$, "
        r"$\mathbf{e}_v = \mathbf{s}_{i-1}$ for even $i$, exchanged for odd $i$"
    ),
    r"$\alpha_i \in (0, \pi)$, $\sum_{i=1}^{2m} \alpha_i = 2\pi$, $2m \ge 4$",
    r"(used, not stated) indices are cyclic modulo $2m$",
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
        checks=(
            Check(
                name="coordinates of the sector",
                run=_RUN + "directions",
                routes=(
                    "printed directions",
                    "x = u e_u + v e_v on two sectors",
                ),
                mutants=(
                    Mutant(name="even for odd", given={"even": 1}),
                    Mutant(name="not exchanged for odd i", given={"exchanged": False}),
                    Mutant(name="rays i, i + 1", given={"shift": 1}),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="both formulas on a ray",
                run=_RUN + "rays_consistent",
                routes=(
                    "data of sector i",
                    "data of sector i + 1",
                ),
                mutants=(
                    Mutant(name="not exchanged for odd i", given={"exchanged": False}),
                    Mutant(
                        name="same torsion on both families, in one sector", given={"sign_v": 1}
                    ),
                ),
            ),
        ),
    ),
    Claim(
        id="3.2.origin-consistent",
        section="3.2",
        where="line 503",
        kind="sentence",
        statement=r"$r_i(0, 0) = 0$ and $N_i(0, 0) = \mathbf{e}_3$ for every $i$.",
        hypotheses=_PATCH,
        rests_on=("3.2.patch-directions",),
        checks=(
            Check(
                name="both edges of three sectors",
                run=_RUN + "origin_consistent",
                routes=(
                    "printed data",
                    "values at 0",
                ),
                mutants=(Mutant(name="at the distance 1", given={"at_distance": 1}),),
            ),
        ),
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
        checks=(
            Check(
                name="closed form and curvature -1",
                run=_DATA_RUN + "front",
                routes=(
                    "identities of a weakly harmonic normal",
                    "vector Moutard equation with Frenet data, as series",
                ),
                mutants=(
                    Mutant(name="r_v = N_v x N", given={"sign_v": 1}),
                    Mutant(name="N_uv = +(N_u.N_v) N", given={"moutard": 1}),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="as printed",
                run=_RUN + "corner_limit",
                routes=(
                    "printed value",
                    "derivatives of the boundary normals",
                ),
                mutants=(
                    Mutant(name="value 0", given={"sign": 0}),
                    Mutant(name="sector i + 1", given={"next_ray": True}),
                ),
            ),
            Check(
                name="times the normal",
                run=_RUN + "corner_limit",
                routes=(
                    "printed value",
                    "derivatives of the boundary normals",
                ),
                mutants=(
                    Mutant(name="a number", given={"along_normal": False}),
                    Mutant(name="twice", given={"along_normal": True, "sign": 2}),
                    Mutant(
                        name="reversed for both parities", given={"along_normal": True, "sign": -1}
                    ),
                    Mutant(name="sector i + 1", given={"along_normal": True, "next_ray": True}),
                ),
                form="corrected",
                given={"along_normal": True},
            ),
        ),
        erratum=Erratum(
            printed=(
                r"$\lim_{(u,v)\to(0,0)}N_u\times N_v=\pm\,\mathbf s^*_{i-1}\cdot\mathbf "
                "s_i$"
            ),
            corrected=(
                r"$\lim N_u\times N_v=\pm(\mathbf s^*_{i-1}\cdot\mathbf s_i)\,\mathbf "
                "e_3$, with $+$ for even $i$"
            ),
            kind="misprint",
            witness=(
                "The left side is a vector, the right side a number: $i$ odd, "
                r"$\alpha_i=\pi/2$: $N_u=\mathbf e_2$, $N_v=\mathbf e_1$ for $\mathbf "
                r"e_u=\mathbf e_1$, $\mathbf e_v=\mathbf e_2$; $N_u\times N_v=-\mathbf "
                r"e_3$, $\mathbf s^*_{i-1}\cdot\mathbf s_i=1$."
            ),
            conclusion_survives=True,
            remark="In the proof of Prop. prop:assembly the norm is taken, rightly.",
        ),
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
        checks=(
            Check(
                name="angle below pi",
                run=_RUN + "regular_rectangle",
                routes=(
                    "bound alpha + u v by integrating sin theta",
                    "balls of Painleve III",
                ),
                mutants=(
                    Mutant(name="three times the rectangle", given={"share": "3"}),
                    Mutant(name="theta_uv at most 99/100", given={"slope": "99/100"}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="3.2.patch-extends",
        section="3.2",
        where="line 505",
        kind="sentence",
        statement=r"$r_i \in C^\infty(J_i) \cap C(\overline{J_i})$.",
        hypotheses=_PATCH,
        rests_on=("3.2.regular-rectangle", "3.2.patch-front"),
        checks=(
            Check(
                name="unit speeds up to the edges",
                run=_DATA_RUN + "extends",
                routes=(
                    "identities for any solution",
                    "Picard's iteration",
                ),
                mutants=(
                    Mutant(name="N_uv = +(N_u.N_v) N", given={"sign": 1}),
                    Mutant(name="speed 2", given={"stretched": 2}),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="as printed",
                part="star",
                run=_RUN + "patched_star",
                routes=(
                    "printed rectangles",
                    "star of the lesser lengths",
                ),
                mutants=(Mutant(name="lengths not cut", given={"same_lengths": False}),),
            ),
            Check(
                name="rectangles with their rays",
                run=_RUN + "patched_star",
                routes=(
                    "rectangles with rays",
                    "star of the lesser lengths",
                ),
                mutants=(
                    Mutant(
                        name="lengths 1 % longer",
                        given={"rays_included": True, "longer": "101/100"},
                        near=True,
                    ),
                    Mutant(name="open rectangles", given={"rays_included": False}),
                    Mutant(
                        name="lengths not cut", given={"rays_included": True, "same_lengths": False}
                    ),
                ),
                form="corrected",
                given={"rays_included": True},
                part="star",
            ),
            Check(
                name="smooth across the rays",
                run=_RUN + "continuous_derivative",
                routes=(
                    "angle on the edges, by its equation",
                    "star's vectors by Cramer's rule",
                ),
                mutants=(
                    Mutant(name="rays of curvature 1", given={"bend": 1}),
                    Mutant(name="angles exchanged", given={"exchanged": True}),
                ),
                part="m-saddle",
            ),
        ),
        erratum=Erratum(
            printed=r"$J_i=\{0<u_i<c_i,0<v_i<d_i\}$, $T=\bigcup_iJ_i$ is an $m$-star",
            corrected=(r"$J_i=\{0\le u_i<c_i,0\le v_i<d_i\}$, $T=\bigcup_iJ_i$ is an $m$-star"),
            kind="misprint",
            witness=(
                "$u_i>0$ and $v_i>0$ in every $J_i$: the origin and the rays are in no "
                "$J_i$, and the union has $2m$ components"
            ),
            conclusion_survives=True,
            remark=(
                r"Neighbours need the same length on their common ray, $c_i=c_{i+1}$ for even "
                r"and $d_i=d_{i+1}$ for odd $i$: the sentence allows for it (shrinking)."
            ),
        ),
    ),
)

CLAIMS: tuple[Claim, ...] = _PATCHING
