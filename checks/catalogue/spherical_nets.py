"""Claims of section 4, discrete K-surfaces and spherical Chebyshev nets."""

from checks.claim import Check, Claim, Mutant

_ANGLES = "checks.verify.vertex_angles"
_PATCHES = "checks.verify.hyperboloid_patches"
_LIMIT = "checks.verify.continuum_limit"
_GRIDS = "checks.verify.discrete_grids"
_RHOMBI = "checks.verify.spherical_rhombi"
_SURFACES = "checks.verify.discrete_k_surfaces"

_NETS: tuple[Claim, ...] = (
    Claim(
        id="def:sphchebnet",
        section="4",
        where="definition (def:sphchebnet), line 1087",
        kind="definition",
        statement=(
            r"$N : Q \to S^2$, a branched embedding of an asymptotic complex, is called a "
            r"spherical Chebyshev net if (i) the image of each quad is a spherical rhombus, (ii) "
            r"orientation is reversed, (iii) (eq:unramified) holds."
        ),
        labels=("def:sphchebnet",),
        hypotheses=(
            r"a branched embedding is read as what (i) to (iii) describe",
            r"$Q \subset \mathbb R^2$ is an asymptotic complex",
            r"(used, not stated) all rhombi have one edge angle $\delta$, $0 < \delta < \pi$",
            r"(used, not stated) the rhombi are not degenerate",
        ),
        rests_on=(
            "def:A-complex",
            "eq:unramified",
        ),
        checks=(
            Check(
                name="instances-and-near-misses",
                run=f"{_ANGLES}:net_definition",
                tier="full",
                routes=(
                    "rational stars by the shipped assembly",
                    "the three conditions as printed",
                ),
                mutants=(
                    Mutant(name="mirror-image", given={"spoiled": "mirrored"}),
                    Mutant(name="winding-once-less", given={"spoiled": "winding"}, near=True),
                    Mutant(name="one-side-longer", given={"spoiled": "side"}, near=True),
                    Mutant(name="accepts-what-is-one", given={"refused": "none"}),
                ),
            ),
        ),
    ),
    Claim(
        id="eq:unramified",
        section="4",
        where="equation (eq:unramified), line 1084",
        kind="equation",
        statement=(
            r"$\sum_{p\in F_k}\alpha_k = 2\pi(1-m_p)$ at an interior vertex $p$ of degree $2m_p$, "
            r"and $\sum_{p\in F_k}\alpha_k \in ((1-d_p)\pi,\min((3-d_p)\pi,0))$ at a boundary "
            r"vertex of degree $d_p$: the angles of the surface add up to $2\pi$ and to less than "
            r"$2\pi$."
        ),
        labels=("eq:unramified",),
        hypotheses=(
            r"the sums are over the faces $F_k$ incident on $p$",
            r"$\alpha_k \in (-\pi,0)$ is the angle of $N(F_k)$ at $p$",
            r"(used, not stated) the degree counts edges: a boundary vertex has $d_p-1$ faces",
            r"(used, not stated) the angle of the surface in the face $F_k$ is $\pi + \alpha_k$",
        ),
        rests_on=("eq:d_lelieuvre",),
        checks=(
            Check(
                name="angles-of-the-surface",
                run=f"{_ANGLES}:unramified",
                routes=(
                    "printed ranges",
                    "angles between the printed edges; rational stars",
                ),
                mutants=(
                    Mutant(name="first-2", given={"first": "2"}, near=True),
                    Mutant(name="half-of-it", given={"factor": "1"}),
                    Mutant(name="low-2", given={"low": "2"}, near=True),
                    Mutant(name="high-4", given={"high": "4"}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="4.condition-of-covering-number",
        section="4",
        where="after definition (def:sphchebnet), line 1089",
        kind="sentence",
        statement=(
            r"(eq:unramified) at interior vertices is what Lemma (lem:covering-number) has: the "
            r"image of the star of $p$ winds $J_p = 1-m_p$ times around $N(p)$."
        ),
        hypotheses=(
            r"(used, not stated) it is the conclusion of that lemma which the condition imposes",
        ),
        rests_on=(
            "eq:unramified",
            "lem:covering-number",
        ),
        checks=(
            Check(
                name="winding-of-stars",
                run=f"{_ANGLES}:covering_number",
                routes=(
                    "sum of the angles in balls",
                    "shipped winding number, order of saddleness",
                ),
                mutants=(Mutant(name="winding-once-less", given={"winding": "2-m"}, near=True),),
            ),
        ),
    ),
    Claim(
        id="4.boundary-degree-parity",
        section="4",
        where="after definition (def:sphchebnet), line 1089",
        kind="sentence",
        statement=(
            r"A boundary vertex has odd degree $d_p$ if its two boundary edges are of one family "
            r"(an edge vertex) and even degree if they are not (a corner vertex)."
        ),
        hypotheses=(r"(used, not stated) the families alternate around $p$",),
        rests_on=(
            "def:A-complex",
            "def:corner",
        ),
        checks=(
            Check(
                name="fans",
                run=f"{_ANGLES}:degree_parity",
                routes=(
                    "families of the edges in order",
                    "shipped corners and degrees",
                ),
                mutants=(Mutant(name="swapped", given={"swapped": True}),),
            ),
        ),
    ),
    Claim(
        id="4.edge-vertex-closes-with-two",
        section="4",
        where="after definition (def:sphchebnet), line 1089",
        kind="number",
        statement=(
            r"(eq:unramified) at an edge vertex, $d_p$ odd, allows one to make it an interior "
            r"vertex by adding $2$ sectors with angles in $(-\pi,0)$."
        ),
        hypotheses=(r"$d_p$ is odd and $p$ satisfies (eq:unramified)",),
        rests_on=(
            "eq:unramified",
            "4.boundary-degree-parity",
        ),
        checks=(
            Check(
                name="two-sectors",
                run=f"{_ANGLES}:edge_vertex_closes",
                routes=(
                    "printed boundary range",
                    "printed interior sum of the new degree",
                ),
                mutants=(
                    Mutant(name="one-sector", given={"sectors": 1}, near=True),
                    Mutant(name="three-sectors", given={"sectors": 3}, near=True),
                    Mutant(name="wider-range", given={"high": 4}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="4.corner-vertex-closes-with-three",
        section="4",
        where="after definition (def:sphchebnet), line 1089",
        kind="number",
        statement=(
            r"(eq:unramified) at a corner vertex, $d_p$ even, allows one to make it an interior "
            r"vertex by adding $3$ sectors with angles in $(-\pi,0)$."
        ),
        hypotheses=(r"$d_p$ is even and $p$ satisfies (eq:unramified)",),
        rests_on=(
            "eq:unramified",
            "4.boundary-degree-parity",
        ),
        checks=(
            Check(
                name="three-sectors",
                run=f"{_ANGLES}:corner_vertex_closes",
                routes=(
                    "printed boundary range",
                    "printed interior sum of the new degree",
                ),
                mutants=(
                    Mutant(name="one-sector", given={"sectors": 1}),
                    Mutant(name="two-sectors", given={"sectors": 2}, near=True),
                    Mutant(name="wider-range", given={"high": 4}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="lem:construct",
        section="4",
        where="lemma (lem:construct), line 1092",
        kind="lemma",
        statement=(
            r"For every spherical Chebyshev net $N : Q^\epsilon \to S^2$ the equations "
            r"(eq:d_lelieuvre) are compatible and generate generalised $K$-surfaces $r : "
            r"Q^\epsilon \to \mathbb R^3$."
        ),
        labels=("lem:construct",),
        hypotheses=(
            r"$Q^\epsilon$ is a simply connected, checkerboard colorable quadgraph",
            (
                r"(used, not stated) every edge has the same angle $\delta$ and the rhombi are not "
                r"degenerate: $N_0 \neq N_{12}$, $N_1 \neq N_2$"
            ),
            r"(used, not stated) the edges are labelled $u$ and $v$, alternating around each quad",
        ),
        rests_on=(
            "def:sphchebnet",
            "4.sums-parallel",
            "eq:d_compatible",
            "4.integration-along-paths",
        ),
        checks=(
            Check(
                name="sums-along-two-trees",
                run=f"{_SURFACES}:construction",
                routes=(
                    "points summed breadth first",
                    "points summed depth first from another vertex",
                ),
                mutants=(
                    Mutant(name="normal-turned", given={"spoiled": "normal"}),
                    Mutant(name="families-exchanged", given={"spoiled": "family"}),
                    Mutant(name="ring", given={"ring": True}),
                ),
            ),
            Check(
                name="degenerate-rhombi-excluded",
                run=f"{_RHOMBI}:sums_parallel",
                part="quads",
                routes=(
                    "Gram determinant of four vectors in space",
                    "printed condition on coordinates",
                ),
                mutants=(
                    Mutant(name="degenerate", given={"degenerate": True}),
                    Mutant(name="three-equal-sides", given={"longer": True}),
                ),
            ),
        ),
    ),
    Claim(
        id="4.colorable-quadgraph",
        section="4",
        where="lemma (lem:construct), line 1091",
        kind="sentence",
        statement=(
            r"An asymptotic complex is the same as a simply connected, checkerboard colorable "
            r"quadgraph: the colouring of the faces and the division of the edges into $u$- and "
            r"$v$-edges that alternate around every quad determine each other, up to exchanging "
            r"the two names."
        ),
        hypotheses=(
            r"the quadgraph is simply connected",
            r"(used, not stated) edge lengths can be chosen alike on opposite edges of each face",
        ),
        rests_on=(
            "def:A-complex",
            "remark:simply_connected",
        ),
        checks=(
            Check(
                name="colourings-and-divisions",
                run=f"{_GRIDS}:colorable",
                routes=(
                    "two-colourings of the dual graph",
                    "divisions of the edges, carried from face to face",
                ),
                mutants=(Mutant(name="ring", given={"ring": True}),),
            ),
        ),
    ),
    Claim(
        id="4.diagonal-orthogonal-to-total",
        section="4",
        where="proof of lemma (lem:construct), line 1095",
        kind="equation",
        statement=(
            r"$\langle N_0-N_{12},N_0+N_1+N_2+N_{12}\rangle = |N_0|^2 - |N_{12}|^2 + \langle "
            r"N_0,N_1+N_2\rangle - \langle N_{12},N_1+N_2\rangle = 0$."
        ),
        hypotheses=(r"$N_0N_1N_{12}N_2$ is a spherical rhombus",),
        rests_on=(
            "def:sphchebnet",
            "4.edge-angle",
        ),
        checks=(
            Check(
                name="gram",
                run=f"{_RHOMBI}:orthogonal_to_total",
                routes=(
                    "printed expansion",
                    "inner products of unit vectors known by them alone",
                ),
                mutants=(
                    Mutant(name="sign", given={"last": 1}),
                    Mutant(name="three-equal-sides", given={"longer": True}),
                ),
            ),
        ),
    ),
    Claim(
        id="4.sums-orthogonal-to-first-diagonal",
        section="4",
        where="proof of lemma (lem:construct), line 1095",
        kind="sentence",
        statement=r"$N_0+N_{12}$ and $N_1+N_2$ are both perpendicular to $N_0-N_{12}$.",
        hypotheses=(
            r"$N_0N_1N_{12}N_2$ is a spherical rhombus",
            r"(used, not stated) the two terms of the sum before it vanish one by one",
        ),
        rests_on=("4.diagonal-orthogonal-to-total",),
        checks=(
            Check(
                name="gram",
                run=f"{_RHOMBI}:sums_and_first_diagonal",
                routes=(
                    "inner products of four vectors known by them alone",
                    "zero",
                ),
                mutants=(
                    Mutant(name="not-unit-vectors", given={"unit": False}),
                    Mutant(name="three-equal-sides", given={"longer": True}),
                ),
            ),
        ),
    ),
    Claim(
        id="4.sums-orthogonal-to-second-diagonal",
        section="4",
        where="proof of lemma (lem:construct), line 1095",
        kind="sentence",
        statement=r"$N_0+N_{12}$ and $N_1+N_2$ are both perpendicular to $N_1-N_2$.",
        hypotheses=(r"$N_0N_1N_{12}N_2$ is a spherical rhombus",),
        rests_on=(
            "def:sphchebnet",
            "4.edge-angle",
        ),
        checks=(
            Check(
                name="gram",
                run=f"{_RHOMBI}:sums_and_second_diagonal",
                routes=(
                    "inner products of four vectors known by them alone",
                    "zero",
                ),
                mutants=(
                    Mutant(name="not-unit-vectors", given={"unit": False}),
                    Mutant(name="three-equal-sides", given={"longer": True}),
                ),
            ),
        ),
    ),
    Claim(
        id="4.diagonals-orthogonal",
        section="4",
        where="proof of lemma (lem:construct), line 1097",
        kind="equation",
        statement=(
            r"$\langle N_0-N_{12},N_1-N_2\rangle = \cos\delta - \cos\delta - \cos\delta + "
            r"\cos\delta = 0$, so the diagonals $N_1-N_2$ and $N_0-N_{12}$ are not parallel, "
            r"neither being zero."
        ),
        hypotheses=(
            r"$N_0N_1N_{12}N_2$ is a spherical rhombus",
            r"(used, not stated) $N_0 \neq N_{12}$ and $N_1 \neq N_2$",
        ),
        rests_on=(
            "def:sphchebnet",
            "4.edge-angle",
        ),
        checks=(
            Check(
                name="gram",
                run=f"{_RHOMBI}:diagonals",
                routes=(
                    "inner products of four vectors known by them alone",
                    "Gram determinant of the diagonals",
                ),
                mutants=(
                    Mutant(name="three-equal-sides", given={"longer": True}),
                    Mutant(name="degenerate", given={"degenerate": True}),
                ),
            ),
        ),
    ),
    Claim(
        id="4.sums-parallel",
        section="4",
        where="proof of lemma (lem:construct), line 1097",
        kind="sentence",
        statement=r"$N_0+N_{12}$ and $N_1+N_2$ are parallel and so satisfy (eq:d_compatible).",
        hypotheses=(r"$N_0N_1N_{12}N_2$ is a spherical rhombus that is not degenerate",),
        rests_on=(
            "4.sums-orthogonal-to-first-diagonal",
            "4.sums-orthogonal-to-second-diagonal",
            "4.diagonals-orthogonal",
            "eq:d_compatible",
        ),
        checks=(
            Check(
                name="gram-determinant",
                run=f"{_RHOMBI}:sums_parallel",
                routes=(
                    "Gram determinant of four vectors in space",
                    "printed condition on coordinates",
                ),
                mutants=(
                    Mutant(name="degenerate", given={"degenerate": True}),
                    Mutant(name="three-equal-sides", given={"longer": True}),
                    Mutant(name="another-vertex", given={"third": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="4.integration-along-paths",
        section="4",
        where="proof of lemma (lem:construct), line 1097",
        kind="sentence",
        statement=(
            r"Summing (eq:d_lelieuvre) along paths from an origin $o$ gives $r$ at every vertex, "
            r"independently of the path, $Q^\epsilon$ being simply connected."
        ),
        hypotheses=(
            r"$Q^\epsilon$ is simply connected",
            r"(used, not stated) $Q^\epsilon$ is connected",
        ),
        rests_on=(
            "4.sums-parallel",
            "eq:d_lelieuvre",
            "4.quad-labelling",
        ),
        checks=(
            Check(
                name="sums-along-two-trees",
                run=f"{_SURFACES}:construction",
                routes=(
                    "points summed breadth first",
                    "points summed depth first from another vertex",
                ),
                mutants=(
                    Mutant(name="normal-turned", given={"spoiled": "normal"}),
                    Mutant(name="ring", given={"ring": True}),
                ),
            ),
        ),
    ),
    Claim(
        id="4.three-parameter-family",
        section="4",
        where="proof of lemma (lem:construct), line 1097",
        kind="number",
        statement=(
            r"The $K$-surfaces of one net $N$ form a family with $3$ parameters, the position "
            r"$r(o) \in \mathbb R^3$."
        ),
        rests_on=("4.integration-along-paths",),
        checks=(
            Check(
                name="rank-of-the-differences",
                run=f"{_SURFACES}:three_parameters",
                routes=(
                    "exact rank of the incidence matrix",
                    "printed number",
                ),
                mutants=(
                    Mutant(name="two", given={"parameters": 2}, near=True),
                    Mutant(name="two-pieces", given={"pieces": 2}),
                ),
            ),
        ),
    ),
    Claim(
        id="4.not-multi-sheeted",
        section="4",
        where="proof of lemma (lem:construct), line 1099",
        kind="sentence",
        statement=(
            r"Without (eq:unramified) $r$ can be ramified; with it $r$ is not multi-sheeted at any "
            r"vertex, the angles of the surface there having the sum $2\pi$, whereas $N$ winds "
            r"$|1-m_p|$ times."
        ),
        hypotheses=(
            (
                r"(used, not stated) single-sheeted near each vertex; nothing is said of "
                r"self-intersections at a distance"
            ),
        ),
        rests_on=(
            "eq:unramified",
            "4.planar-vertex-stars",
            "lem:construct",
        ),
        checks=(
            Check(
                name="angles-in-space",
                run=f"{_ANGLES}:not_multi_sheeted",
                routes=(
                    "angles of the points in space, in balls",
                    "printed condition on the normals",
                ),
                mutants=(Mutant(name="winding-once-less", given={"winding": "2-m"}, near=True),),
            ),
        ),
    ),
    Claim(
        id="4.angle-sum-is-the-degree",
        section="4",
        where="proof of lemma (lem:construct), line 1099",
        kind="equation",
        statement=r"$\sum\alpha_k = 2\pi J_p = 2\pi(1-m_p)$ at every interior vertex.",
        hypotheses=(r"$N$ satisfies (eq:unramified)",),
        rests_on=(
            "eq:unramified",
            "lem:covering-number",
        ),
        checks=(
            Check(
                name="winding-of-stars",
                run=f"{_ANGLES}:covering_number",
                routes=(
                    "sum of the angles in balls",
                    "shipped winding number, order of saddleness",
                ),
                mutants=(Mutant(name="winding-once-less", given={"winding": "2-m"}, near=True),),
            ),
        ),
    ),
    Claim(
        id="4.reduction-to-nets",
        section="4",
        where="after lemma (lem:construct), line 1102",
        kind="sentence",
        statement=(
            r"To construct discrete PS-fronts is to construct spherical Chebyshev nets on "
            r"asymptotic complexes."
        ),
        hypotheses=(r"(used, not stated) only nets with all edges equal are wanted",),
        rests_on=(
            "lem:construct",
            "def:K-surf",
        ),
        checks=(
            Check(
                name="there-and-back",
                run=f"{_SURFACES}:reduction",
                routes=(
                    "normals that the points were summed from",
                    "normals of the planes of the stars",
                ),
                mutants=(
                    Mutant(name="mirror-image", given={"sign": -1}),
                    Mutant(name="stretched", given={"rule": "stretched"}, near=True),
                ),
            ),
        ),
    ),
)

_REMARKS: tuple[Claim, ...] = (
    Claim(
        id="4.continuum-limit",
        section="4",
        where="remark at the end of the section's opening, line 1134",
        kind="remark",
        statement=(
            r"With finitely many isolated branch points the discrete surfaces converge, under "
            r"refinement of $Q^\epsilon$, to the continuous ones, one asymptotic rectangle at a "
            r"time."
        ),
        hypotheses=(
            r"finitely many, isolated branch points",
            (
                r"(used, not stated) the limit normal field is smooth enough on each closed "
                r"rectangle, and no singular edge is met"
            ),
        ),
        rests_on=(
            "eq:householder",
            "eq:d_lelieuvre",
            "eq:moutard",
            "eq:lelieuvre",
        ),
        checks=(
            Check(
                name="orders-of-refinement",
                run=f"{_LIMIT}:continuum_limit",
                tier="full",
                routes=(
                    "shipped fill and summation from two sides",
                    "explicit surfaces; Painleve III",
                ),
                mutants=(
                    Mutant(name="order-1.9", given={"order": "19/10"}, near=True),
                    Mutant(name="order-2.1", given={"order": "21/10"}, near=True),
                    Mutant(name="sign-of-the-v-steps", given={"sign_v": 1}),
                    Mutant(name="one-percent-faster", given={"speed": "101/100"}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="4.hyperboloid-patches",
        section="4",
        where="remark at the end of the section's opening, line 1134",
        kind="remark",
        statement=(
            r"Since the quadgraphs are checkerboard colorable, the discrete branched surface can "
            r"also be extended by patches of hyperboloids, one on each quad."
        ),
        hypotheses=(
            r"(used, not stated) every interior vertex has even degree and vertex stars are planar",
        ),
        rests_on=(
            "def:A-complex",
            "4.planar-vertex-stars",
        ),
        checks=(
            Check(
                name="equal-tangent-planes",
                run=f"{_PATCHES}:hyperboloid_patches",
                routes=(
                    "weights carried along a spanning tree of the quads",
                    "tangent planes on both sides of every edge",
                ),
                mutants=(
                    Mutant(name="five-quads-around-a-vertex", given={"sectors": 5}, near=True),
                    Mutant(name="star-not-planar", given={"lifted": True}, near=True),
                    Mutant(
                        name="one-weight-one-percent-larger", given={"first": "101/100"}, near=True
                    ),
                ),
                tier="full",
            ),
        ),
    ),
)

CLAIMS: tuple[Claim, ...] = _NETS + _REMARKS
