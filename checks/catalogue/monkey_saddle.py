"""Claims of section 3.2, the monkey saddle: its regularity, remarks on patched coordinates."""

from checks.claim import Check, Claim, Mutant

_RUN = "checks.verify.patched_sectors:"
_STAR_RUN = "checks.verify.star_functions:"

_PATCH = (
    (
        r"$\mathbf{z} = 0$, $\mathbf{n} = \mathbf{e}_3$; $\mathbf{e}_u = \mathbf{s}_i$, "
        r"$\mathbf{e}_v = \mathbf{s}_{i-1}$ for even $i$, exchanged for odd $i$"
    ),
    r"$\alpha_i \in (0, \pi)$, $\sum_{i=1}^{2m} \alpha_i = 2\pi$, $2m \ge 4$",
    r"(used, not stated) indices are cyclic modulo $2m$",
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
        checks=(
            Check(
                name="disk of radius 1",
                run=_RUN + "monkey_saddle",
                tier="full",
                routes=(
                    "layout in the hyperboloid, Painleve III integrated",
                    "area of a disk of curvature -1",
                ),
                mutants=(
                    Mutant(name="radius 1.01", given={"radius": "101/100"}, near=True),
                    Mutant(name="K = -1.01", given={"curvature": "-101/100"}, near=True),
                    Mutant(name="angle pi/4", given={"sectors_number": 8}),
                ),
                part="radius",
            ),
            Check(
                name="normal on the rays",
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
                part="normal",
            ),
        ),
    ),
    Claim(
        id="3.2.monkey-saddle-angles",
        section="3.2",
        where="line 550",
        kind="number",
        statement=r"$2m = 6$ and $\alpha_k = \pi/3$, $k = 1, \dots, 6$, are admissible data of a "
        r"$3$-star: each is in $(0, \pi)$ and the sum is $2\pi$.",
        rests_on=("def:m-star",),
        checks=(
            Check(
                name="sum and range",
                run=_RUN + "star_angles",
                routes=(
                    "printed conditions",
                    "exact sum",
                ),
                mutants=(
                    Mutant(name="eight angles", given={"sectors_number": 8}),
                    Mutant(name="angles pi/4", given={"third": 4}),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="quotients on stars",
                run=_STAR_RUN + "lipschitz",
                routes=(
                    "bound by the length of a path in the star",
                    "values at rational points",
                ),
                mutants=(
                    Mutant(name="functions that jump by 1 on the rays", given={"jump": "1"}),
                    Mutant(name="functions that jump by 1/100", given={"jump": "1/100"}, near=True),
                    Mutant(name="derivative not bounded", given={"bounded": False}),
                ),
            ),
        ),
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
                r"$C^{1,1}$ in the plane of the star, where $\mathbf{x} = u\,\mathbf{e}_u + "
                r"v\,\mathbf{e}_v$ on each sector (the rays being straight lines of the surface)"
            ),
        ),
        rests_on=("3.2.normal-lipschitz", "3.2.patched-saddle"),
        checks=(
            Check(
                name="derivative on the rays",
                run=_RUN + "continuous_derivative",
                routes=(
                    "angle on the edges, by its equation",
                    "star's vectors by Cramer's rule",
                ),
                mutants=(
                    Mutant(name="rays of curvature 1", given={"bend": 1}),
                    Mutant(name="angles exchanged", given={"exchanged": True}),
                ),
                part="derivative",
            ),
            Check(
                name="Lipschitz",
                run=_STAR_RUN + "lipschitz",
                routes=(
                    "bound by the length of a path in the star",
                    "values at rational points",
                ),
                mutants=(
                    Mutant(name="functions that jump by 1 on the rays", given={"jump": "1"}),
                    Mutant(name="functions that jump by 1/100", given={"jump": "1/100"}, near=True),
                    Mutant(name="derivative not bounded", given={"bounded": False}),
                ),
                part="Lipschitz",
            ),
        ),
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
        checks=(
            Check(
                name="straight edges",
                run=_RUN + "amsler_sectors",
                routes=(
                    "printed definition",
                    "angle and carried frame, as series",
                ),
                mutants=(
                    Mutant(name="u-edge bent", given={"bend_u": 1}),
                    Mutant(name="v-edge bent", given={"bend_v": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.2.not-coordinates-across-rays",
        section="3.2",
        where="remark, line 553",
        kind="remark",
        statement=r"The functions $u, v$, without the index of the sector, are not one-to-one on "
        r"any open set that meets the boundary between two sectors.",
        rests_on=("eq:sector-coords", "3.2.ray-coordinates-even"),
        checks=(
            Check(
                name="two points with the same (u, v)",
                run=_STAR_RUN + "not_one_to_one",
                routes=(
                    "points on either side of a ray",
                    "coefficients by cross products",
                ),
                mutants=(
                    Mutant(
                        name="sign of the coordinate across the ray kept", given={"signed": True}
                    ),
                    Mutant(name="towards ray i + 2", given={"ahead": 2}, near=True),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="pasting",
                run=_STAR_RUN + "pasting",
                routes=(
                    "sectors closed in the star",
                    "piecewise linear functions near the rays",
                ),
                mutants=(
                    Mutant(name="sectors without one ray", given={"closed": False}),
                    Mutant(
                        name="slopes that differ by 1/100", given={"differ": "1/100"}, near=True
                    ),
                ),
            ),
        ),
    ),
)

CLAIMS: tuple[Claim, ...] = _MONKEY_SADDLE
