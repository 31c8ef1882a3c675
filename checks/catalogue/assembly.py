"""Claims of section 3.2, assembly of m-saddles from curves: the proposition and its proof."""

from checks.claim import Check, Claim, Mutant

_RUN = "checks.verify.assembly:"
_PROOF = "checks.verify.assembly_proof:"
_SURFACES = "checks.verify.assembled_surfaces:"
_EDGES = "checks.verify.edge_frames:"

_ASSEMBLY = (
    (
        r"$2m \ge 4$ even, $L < \infty$, $\kappa_i : [0, L) \to \mathbb{R}$ smooth, "
        r"$i = 1, \dots, 2m$"
    ),
    r"$\alpha_i \in (0, \pi)$, $\sum_{i=1}^{2m} \alpha_i = 2\pi$",
    r"(used, not stated) $L > 0$ and indices are cyclic modulo $2m$",
)
_READING = (
    r"(used, not stated) $F_i$ is the frame of $r$ along ray $i$",
    r"(used, not stated) $C^{1,1}$ refers to the surface as a graph over its tangent planes",
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
        hypotheses=(
            *_ASSEMBLY,
            *_READING,
            (
                "exact are identities for arbitrary functions (systems on the edges, closed "
                "forms, commuting equations) and series of finite degree with arbitrary angles and "
                "quadratic curvatures; existence and smoothness of the solutions are textbook "
                "(Picard, Goursat), the lengths are bounded by hand and sampled, and the whole "
                "surface is integrated on one star: the weakest part decides the grade"
            ),
        ),
        rests_on=(
            "3.2.assembly-origin",
            "3.2.assembly-frames",
            "3.2.assembly-goursat",
            "3.2.assembly-glue",
            "3.2.assembly-regular",
            "def:m-saddle",
        ),
        checks=(
            Check(
                name="arbitrary angles and curvatures",
                run=_PROOF + "proposition",
                routes=(
                    "angle theta_uv = sin theta and a carried frame, as series",
                    (
                        "Frenet-Serret on both edges, vector Moutard equation, Lelieuvre "
                        "formulae, as series"
                    ),
                    "Picard's iteration",
                ),
                mutants=(
                    Mutant(name="curvatures differ on the two sides of a ray", given={"extra": 1}),
                    Mutant(name="torsion -1 on all rays", given={"torsion_v": -1}),
                    Mutant(name="angles that leave a gap", given={"turned": 1}),
                    Mutant(name="an angle pi", given={"straight_angle": True}),
                ),
                part="sectors",
                tier="full",
            ),
            Check(
                name="explicit lengths",
                run=_PROOF + "lengths",
                routes=("bound by |theta_uv| <= 1", "angle integrated to second order"),
                mutants=(
                    Mutant(name="three times the room", given={"share": "3"}),
                    Mutant(name="99 % of the bound", given={"rise": "99/100"}, near=True),
                ),
                part="lengths",
            ),
            Check(
                name="six sectors integrated",
                run=_SURFACES + "example",
                routes=(
                    "Moutard equation to second order",
                    "Frenet-Serret and the angle's integral",
                ),
                mutants=(
                    Mutant(name="torsion -1 on all rays", given={"torsion_odd": -1}),
                    Mutant(name="five sectors", given={"count": 5}),
                    Mutant(
                        name="sum of the angles 2 pi + pi/100", given={"widened": "0.01"}, near=True
                    ),
                    Mutant(
                        name="curvatures differ by 1 % on the two sides",
                        given={"jump": "0.01"},
                        near=True,
                    ),
                    Mutant(
                        name="geodesic curvature 1 % larger", given={"factor": "1.01"}, near=True
                    ),
                ),
                part="surface",
                tier="full",
            ),
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
        checks=(
            Check(
                name="corner of both orientations",
                run=_RUN + "origin",
                routes=(
                    "printed values",
                    "angle and carried frame, as series",
                ),
                mutants=(
                    Mutant(name="first derivative", given={"degree": 1}),
                    Mutant(name="N = -e_3", given={"sign": -1}),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="lines of any angle",
                run=_EDGES + "edge_frames",
                routes=("printed systems", "frame turned by an unknown angle"),
                mutants=(
                    Mutant(name="torsion -1 on v-lines", given={"torsion_v": -1}),
                    Mutant(name="curvatures reversed", given={"curvature_sign": -1}),
                ),
            ),
            Check(
                name="frames of the surface on both edges",
                run=_RUN + "assembly_frames",
                tier="full",
                routes=(
                    "printed systems",
                    "angle theta_uv = sin theta and a carried frame, as series",
                    (
                        "Frenet-Serret on both edges, vector Moutard equation, Lelieuvre "
                        "formulae, as series"
                    ),
                ),
                mutants=(
                    Mutant(name="torsion -1 on odd rays", given={"torsion_v": -1}),
                    Mutant(name="curvatures reversed", given={"curvature_sign": -1}),
                    Mutant(name="N(0) = -e_3", given={"start": -1}),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="skew systems",
                run=_RUN + "frenet_frames_exist",
                routes=(
                    "printed systems",
                    "products of the series of a frame",
                    "Picard's iteration",
                ),
                mutants=(
                    Mutant(name="last row reversed", given={"back": -1}),
                    Mutant(name="torsion +1", given={"torsion": 1}),
                    Mutant(name="not orthonormal at the start", given={"orthonormal": False}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.2.assembly-boundary-normal",
        section="3.2",
        where="proof of (prop:assembly), line 573",
        kind="sentence",
        statement=r"The angles and the curvatures determine $N$ on the boundary of every sector.",
        hypotheses=_ASSEMBLY,
        rests_on=("3.2.assembly-frenet-exists", "3.2.assembly-frames"),
        checks=(
            Check(
                name="binormals of the edges",
                run=_RUN + "boundary_normal",
                tier="full",
                routes=(
                    "Frenet-Serret on one edge, as series",
                    "angle and carried frame, as series",
                ),
                mutants=(
                    Mutant(name="torsion -1 on odd rays", given={"torsion_v": -1}),
                    Mutant(name="curvatures exchanged", given={"other": True}),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="two routes to a sector",
                run=_RUN + "goursat",
                routes=(
                    "angle theta_uv = sin theta and a carried frame, as series",
                    (
                        "Frenet-Serret on both edges, vector Moutard equation, Lelieuvre "
                        "formulae, as series"
                    ),
                    "identities for any solution",
                ),
                mutants=(
                    Mutant(name="N_uv = +(N_u.N_v) N", given={"sign": 1}),
                    Mutant(name="torsion -1 on odd rays", given={"torsion_v": -1}),
                ),
                tier="full",
            ),
        ),
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
        checks=(
            Check(
                name="fundamental forms on the rays",
                run=_PROOF + "forms_on_rays",
                tier="full",
                routes=("stated forms", "sectors of either orientation, as series"),
                mutants=(
                    Mutant(name="second form reversed", given={"sign": -1}),
                    Mutant(name="K = +1", given={"curved": 1}),
                ),
            ),
            Check(
                name="ray from both sides",
                run=_RUN + "glue",
                tier="full",
                routes=(
                    "sector on one side, as series",
                    "sector on the other side, as series",
                ),
                mutants=(
                    Mutant(name="curvatures differ", given={"extra": 1}),
                    Mutant(name="torsion +1 on the u-ray of one side", given={"torsion": 1}),
                    Mutant(name="torsion -1 on the v-ray of one side", given={"torsion": -1}),
                    Mutant(name="tangents differ", given={"turned": 1}),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="norm at the corner",
                run=_RUN + "corner_limit",
                routes=(
                    "printed value",
                    "angle and carried frame, as series",
                ),
                mutants=(
                    Mutant(name="s*_(i-1).s_(i+1)", given={"ahead": 1}),
                    Mutant(name="squared", given={"power": 2}),
                    Mutant(name="an angle pi", given={"straight_angle": True}),
                ),
            ),
        ),
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
                r"(read) $C^{1,1}$ is said of the surface, a graph over its tangent plane at $0$: "
                r"(def:m-star) gives $T$ a topology and no smooth structure, and "
                r"(def:branched_immersion) uses $T$ up to homeomorphisms"
            ),
            (
                r"not as a map of $T \subset \mathbb{R}^2$, where $r$ is Lipschitz, and $C^{1,1}$ "
                r"if all $\kappa_i = 0$: with six angles $\pi/3$ and $\kappa_2 = 1$, "
                r"$\mathbf{s}_1 = \mathbf{s}_2 - \mathbf{s}_3$, but $|r_u - dr(\mathbf{s}_3)| = "
                r"2 \sin\frac{\pi/3 - t}{2} < 1$ for $t > 0$"
            ),
        ),
        rests_on=("3.2.assembly-glue", "3.2.assembly-corner-limit"),
        checks=(
            Check(
                name="as a graph",
                run=_PROOF + "smooth_across",
                tier="full",
                routes=(
                    "projection of both sectors",
                    "series of N and r on the ray from both sides",
                ),
                mutants=(
                    Mutant(name="in the plane of the star", given={"chart": "star"}),
                    Mutant(name="curvatures differ", given={"extra": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.2.assembly-generalises",
        section="3.2",
        where="line 556",
        kind="sentence",
        statement=r"The patching of Amsler sectors is the case $\kappa_i = 0$ of assembly.",
        hypotheses=_ASSEMBLY,
        rests_on=("prop:assembly", "3.2.patched-saddle"),
        checks=(
            Check(
                name="curvatures 0",
                run=_RUN + "generalises",
                routes=(
                    "printed boundary data (amsler-frame)",
                    "angle and carried frame, as series",
                ),
                mutants=(
                    Mutant(name="curvatures 1", given={"bend": 1}),
                    Mutant(name="N(0, v) turns like N(u, 0)", given={"sign_v": 1}),
                ),
            ),
        ),
    ),
)

CLAIMS: tuple[Claim, ...] = _PROPOSITION
