"""Claims of section 3.3, branched immersions, quad-graphs, asymptotic complexes, sectors."""

from checks.claim import Check, Claim, Erratum, Mutant

_DEFINITIONS = "checks.verify.asymptotic_complexes_definitions:"
_COLOURING_CHECKS = "checks.verify.asymptotic_complexes_colouring:"
_TOPOLOGY = "checks.verify.asymptotic_complexes_topology:"
_SECTORS = "checks.verify.asymptotic_complexes_sectors:"
_FRONT_CHECKS = "checks.verify.asymptotic_complexes_fronts:"

_COMPLEX = (r"$A$ an asymptotic complex with vertices, edges, faces $F_k$",)
_BRANCHED = (r"$\psi : \Omega \to \mathbb{R}^3$ a branched pseudospherical immersion",)

_IMMERSIONS = (
    Claim(
        id="def:branched_immersion",
        section="3.3",
        where="definition (def:branched_immersion), lines 613-615",
        kind="definition",
        statement=r"A branched pseudospherical immersion of $\Omega \subseteq \mathbb{H}^2$ is an "
        r"isometric immersion $\psi : \Omega \to \mathbb{R}^3$, globally $C^{1,1}$ and piecewise "
        r"$C^2$, such that each $p \in \Omega$ has a neighbourhood $O_p$, a homeomorphism "
        r"$\tau_p : O_p \to T_p$ to an $m_p$-star and an $m_p$-saddle $r_p$ with "
        r"$\psi|_{O_p} = r_p \circ \tau_p$.",
        labels=("def:branched_immersion",),
        hypotheses=(
            (
                r"(used, not stated) $\tau_p(p) = 0$, the centre of the star: without it $m_p$ is "
                r"not determined by $p$"
            ),
            r"(used, not stated) $O_p$ is open, so $\Omega$ is open",
        ),
        rests_on=("def:m-star", "def:m-saddle", "def:H2", "3.2.patched-saddle"),
        checks=(
            Check(
                name="patched saddles",
                run="checks.verify.branched_immersion:definition",
                routes=(
                    "half turns about the rays in space",
                    "reflections in the tangent plane and in H^2",
                    "discrete.asymptotic_complex (orders)",
                ),
                mutants=(
                    Mutant(name="sectors fill 9/10 of the turn", given={"share": "9/10"}),
                    Mutant(name="sectors fill two turns", given={"share": "2"}),
                    Mutant(name="reflections for half turns", given={"turn": "mirror"}),
                    Mutant(name="star not centred at p", given={"centred": False}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.3.branch-points",
        section="3.3",
        where="line 616",
        kind="definition",
        statement=r"The branch points $p_1, \dots, p_k \in \Omega$ of $\psi$ are the points, "
        r"finitely many, at which $m_p \ne 2$.",
        hypotheses=_BRANCHED,
        rests_on=("def:branched_immersion",),
        checks=(
            Check(
                name="finite",
                run=_TOPOLOGY + "branch_points",
                routes=(
                    "printed criterion m_p != 2 on refinements",
                    "discrete.asymptotic_complex:AsymptoticComplex",
                ),
                mutants=(
                    Mutant(name="m_p != 3", given={"regular": 3}),
                    Mutant(name="m_p != 1", given={"regular": 1}),
                ),
            ),
        ),
    ),
)

_QUAD_GRAPHS = (
    Claim(
        id="3.3.quad-graph",
        section="3.3",
        where="definition (Quadgraph), lines 617-618",
        kind="definition",
        statement="A quad-graph is a strongly regular polytopal cell decomposition of a surface "
        "whose faces are all quadrilaterals.",
        hypotheses=("(used, not stated) each interior edge is in exactly two faces",),
        rests_on=("3.3.strongly-regular-faces", "3.3.strongly-regular-intersections"),
        checks=(
            Check(
                name="instances and near misses",
                run=_DEFINITIONS + "quad_graphs",
                routes=("printed conditions, face by face", "discrete.quad_graph (arrays)"),
                mutants=(
                    Mutant(name="triangles", given={"corners": 3}),
                    Mutant(name="three faces at an edge", given={"most": 3}),
                    Mutant(name="two fans at a vertex", given={"fans": 2}),
                    Mutant(name="not strongly regular", given={"regular": False}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.3.strongly-regular-faces",
        section="3.3",
        where="line 619, item (i)",
        kind="item",
        statement="In a strongly regular cell decomposition the edges and the vertices of each "
        "face are pairwise distinct.",
        checks=(
            Check(
                name="all quadrilaterals on 4 vertices",
                run=_DEFINITIONS + "regular_face",
                routes=("printed conditions, face by face", "discrete.quad_graph (arrays)"),
                mutants=(Mutant(name="vertices may repeat", given={"vertices": False}),),
            ),
        ),
    ),
    Claim(
        id="3.3.strongly-regular-intersections",
        section="3.3",
        where="line 619, item (ii)",
        kind="item",
        statement="In a strongly regular cell decomposition two faces meet in nothing, in one "
        "vertex, or in one closed edge.",
        hypotheses=("two different faces",),
        checks=(
            Check(
                name="all pairs on 8 vertices",
                run=_DEFINITIONS + "regular_meeting",
                routes=("printed conditions, face by face", "discrete.quad_graph (arrays)"),
                mutants=(
                    Mutant(name="two vertices", given={"most_vertices": 2}),
                    Mutant(name="two edges", given={"most_edges": 2}),
                ),
            ),
        ),
    ),
    Claim(
        id="def:A-complex",
        section="3.3",
        where="definition (def:A-complex), lines 620-622",
        kind="definition",
        statement="An asymptotic complex is a quad-graph with (i) faces that are rectangles, (ii) "
        "edges of two families, (iii) attaching maps that keep the coordinates up to reversal.",
        labels=("def:A-complex",),
        rests_on=(
            "3.3.quad-graph",
            "3.3.complex-faces",
            "3.3.complex-edges",
            "3.3.complex-attaching-u",
            "3.3.complex-attaching-v",
        ),
        checks=(
            Check(
                name="instances and near misses",
                run=_DEFINITIONS + "asymptotic_complex",
                tier="full",
                routes=(
                    "printed conditions, face by face",
                    "discrete.asymptotic_complex, discrete.face_coordinates",
                ),
                mutants=(
                    Mutant(name="not strongly regular", given={"regular": False}),
                    Mutant(name="families not asked for", given={"families": False}),
                    Mutant(name="lengths not asked for", given={"lengths": False}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.3.complex-faces",
        section="3.3",
        where="definition (def:A-complex), item (i), line 620, and line 630",
        kind="item",
        statement=r"Each face has a bijection $\psi_k : F_k \to R_k = [0, u_k] \times [0, v_k]$, "
        r"its asymptotic coordinates.",
        hypotheses=(
            (
                r"(used, not stated) $\psi_k$ is a homeomorphism that takes edges to sides, and "
                r"$u_k, v_k > 0$"
            ),
        ),
        checks=(
            Check(
                name="rectangles",
                run=_DEFINITIONS + "face_coordinates",
                tier="full",
                routes=(
                    "sides of the printed rectangle",
                    "discrete.face_coordinates:FaceCoordinates",
                ),
                mutants=(
                    Mutant(name="sides may be 0", given={"positive": False}),
                    Mutant(name="diagonals for sides", given={"across": 2}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.3.complex-edges",
        section="3.3",
        where="definition (def:A-complex), item (ii), line 620",
        kind="item",
        statement=r"The edges are partitioned into a family $E^u$ and a family $E^v$, and adjacent "
        "edges of a face are in different families.",
        hypotheses=(
            r"(used, not stated) $u$-edges are the sides on which $v$ is constant, under $\psi_k$",
        ),
        rests_on=("3.3.complex-faces",),
        checks=(
            Check(
                name="all labellings",
                run=_DEFINITIONS + "edge_families",
                routes=(
                    "every labelling, by trial",
                    "discrete.asymptotic_complex:AsymptoticComplex",
                ),
                mutants=(Mutant(name="opposite edges differ", given={"step": 2}),),
            ),
        ),
    ),
    Claim(
        id="3.3.complex-attaching-u",
        section="3.3",
        where="definition (def:A-complex), item (iii), line 620",
        kind="item",
        statement=r"If $E^u_j = F_k \cap F_l$ is a $u$-edge, then $u_k = u_l$ and the attaching "
        r"map is $(u, v_a) \mapsto (u, v_b)$ or $(u, v_a) \mapsto (u_k - u, v_b)$, with $v_a \in "
        r"\{0, v_k\}$, $v_b \in \{0, v_l\}$.",
        rests_on=("3.3.complex-faces", "3.3.complex-edges"),
        checks=(
            Check(
                name="on every u-edge",
                run=_DEFINITIONS + "attaching_u",
                routes=("printed attaching maps", "discrete.face_coordinates:FaceCoordinates"),
                mutants=(
                    Mutant(name="no reversal", given={"reversal": False}),
                    Mutant(name="u_k + u", given={"sign": 1}),
                    Mutant(name="u_k/2 - u", given={"share": "1/2"}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.3.complex-attaching-v",
        section="3.3",
        where="definition (def:A-complex), item (iii), last sentence, line 620",
        kind="item",
        statement=r"If $E^v_j = F_k \cap F_l$ is a $v$-edge, then $v_k = v_l$ and the attaching "
        r"map is $(u_a, v) \mapsto (u_b, v)$ or $(u_a, v) \mapsto (u_b, v_k - v)$, with $u_a \in "
        r"\{0, u_k\}$, $u_b \in \{0, u_l\}$.",
        rests_on=("3.3.complex-faces", "3.3.complex-edges"),
        checks=(
            Check(
                name="on every v-edge",
                run=_DEFINITIONS + "attaching_v",
                routes=("printed attaching maps", "discrete.face_coordinates:FaceCoordinates"),
                mutants=(
                    Mutant(name="no reversal", given={"reversal": False}),
                    Mutant(name="v_k + v", given={"sign": 1}),
                    Mutant(name="v_k/2 - v", given={"share": "1/2"}),
                ),
            ),
        ),
    ),
)

_COLOURING = (
    Claim(
        id="3.3.checkerboard",
        section="3.3",
        where="lemma without label, lines 623-624, first sentence",
        kind="lemma",
        statement="The faces of an asymptotic complex can be coloured in two colours so that "
        "faces with a common edge differ.",
        hypotheses=_COMPLEX,
        rests_on=("def:A-complex", "3.3.dual-cycles-even", "3.3.bipartite"),
        checks=(
            Check(
                name="as printed",
                run=_COLOURING_CHECKS + "checkerboard",
                routes=(
                    "discrete.signed_graph (double cover)",
                    "discrete.dual_cycles (lengths of a basis of cycles)",
                ),
                mutants=(Mutant(name="faces with a common vertex", given={"across": "vertex"}),),
            ),
            Check(
                name="simply connected",
                run=_COLOURING_CHECKS + "checkerboard",
                form="corrected",
                given={"simply_connected": True},
                routes=(
                    "discrete.signed_graph (double cover)",
                    "discrete.dual_cycles (lengths of a basis of cycles)",
                ),
                mutants=(
                    Mutant(name="hypothesis dropped", given={"simply_connected": False}),
                    Mutant(
                        name="faces with a common vertex",
                        given={"simply_connected": True, "across": "vertex"},
                    ),
                ),
            ),
            Check(
                name="links span the cycles",
                run=_TOPOLOGY + "links_span",
                form="support",
                routes=(
                    "rank modulo 2 of the links of interior vertices",
                    "number of independent cycles of the dual graph",
                ),
                mutants=(Mutant(name="hypothesis dropped", given={"simply_connected": False}),),
            ),
        ),
        erratum=Erratum(
            printed="every asymptotic complex $A$ is checkerboard colourable",
            corrected="every simply connected asymptotic complex $A$ is checkerboard colourable",
            kind="hypothesis",
            witness=(
                "a cylinder of three rectangles glued along v-edges: a strongly regular "
                "asymptotic complex, any two of its faces neighbours"
            ),
            conclusion_survives=True,
            remark=(
                "The remark after the lemma assumes simple connectedness only from there on. The "
                "second part of the lemma, on degrees, needs no such hypothesis."
            ),
        ),
    ),
    Claim(
        id="3.3.even-degree",
        section="3.3",
        where="lemma without label, lines 623-624, second sentence",
        kind="lemma",
        statement=r"Every interior vertex of an asymptotic complex, not on $\partial A$, has even "
        "degree.",
        hypotheses=_COMPLEX,
        rests_on=("def:A-complex", "3.3.edges-alternate"),
        checks=(
            Check(
                name="any complex",
                run=_COLOURING_CHECKS + "even_degree",
                tier="full",
                routes=("edges at the corners of faces", "degrees counted edge by edge"),
                mutants=(
                    Mutant(name="multiples of 4", given={"modulus": 4}),
                    Mutant(name="boundary vertices too", given={"interior": False}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.3.edges-alternate",
        section="3.3",
        where="proof of the lemma, lines 626-627",
        kind="sentence",
        statement=r"Around every vertex $u$- and $v$-edges alternate.",
        hypotheses=(*_COMPLEX, "(used, not stated) at a boundary vertex, in the order of its fan"),
        rests_on=("3.3.complex-edges",),
        checks=(
            Check(
                name="every fan",
                run=_COLOURING_CHECKS + "edges_alternate",
                tier="full",
                routes=("printed alternation", "discrete.vertex_fan:vertex_fan"),
                mutants=(
                    Mutant(name="edges two apart differ", given={"step": 2}),
                    Mutant(name="fans of boundary vertices closed", given={"cyclic": True}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.3.dual-cycles-equal",
        section="3.3",
        where="proof of the lemma, line 627",
        kind="sentence",
        statement=r"Every cycle of the dual graph crosses as many $u$-edges as $v$-edges.",
        hypotheses=_COMPLEX,
        rests_on=("3.3.edges-alternate",),
        checks=(
            Check(
                name="as printed",
                run=_COLOURING_CHECKS + "dual_cycles_equal",
                routes=(
                    "discrete.dual_cycles (short cycles and a basis)",
                    "discrete.signed_graph (double cover)",
                ),
                mutants=(Mutant(name="equal modulo 4", given={"modulus": 4}),),
            ),
            Check(
                name="of one parity",
                run=_COLOURING_CHECKS + "dual_cycles_equal",
                tier="full",
                form="corrected",
                given={"modulus": 2, "simply_connected": True},
                routes=(
                    "discrete.dual_cycles (short cycles and a basis)",
                    "discrete.signed_graph (double cover)",
                ),
                mutants=(
                    Mutant(name="equal modulo 4", given={"modulus": 4, "simply_connected": True}),
                    Mutant(
                        name="hypothesis dropped", given={"modulus": 2, "simply_connected": False}
                    ),
                    Mutant(name="equal numbers", given={"modulus": 0, "simply_connected": True}),
                ),
            ),
        ),
        erratum=Erratum(
            printed="every cycle of the dual graph crosses equal numbers of $u$- and $v$-edges",
            corrected=(
                "in a simply connected complex the numbers of $u$- and of $v$-edges that a cycle "
                "of the dual graph crosses are both even or both odd"
            ),
            kind="false",
            witness=(
                "a block of 2 by 3 rectangles: the ring of its six faces crosses four edges of "
                "one family and two of the other"
            ),
            conclusion_survives=True,
            remark=(
                "Were only those cycles meant that cross equal numbers, that they are even would "
                "be trivial, and would say nothing of the others, which a colouring needs. "
                "Equality does hold for the links of interior vertices, of which every cycle of a "
                "simply connected complex is a sum modulo 2: enough for even lengths."
            ),
        ),
    ),
    Claim(
        id="3.3.dual-cycles-even",
        section="3.3",
        where="proof of the lemma, line 627",
        kind="sentence",
        statement="Every cycle of the dual graph has even length.",
        hypotheses=_COMPLEX,
        rests_on=("3.3.dual-cycles-equal",),
        checks=(
            Check(
                name="as printed",
                run=_COLOURING_CHECKS + "dual_cycles_even",
                routes=(
                    "discrete.dual_cycles (short cycles and a basis)",
                    "discrete.signed_graph (double cover)",
                ),
                mutants=(Mutant(name="lengths divisible by 4", given={"divisor": 4}),),
            ),
            Check(
                name="simply connected",
                run=_COLOURING_CHECKS + "dual_cycles_even",
                tier="full",
                form="corrected",
                given={"simply_connected": True},
                routes=(
                    "discrete.dual_cycles (short cycles and a basis)",
                    "discrete.signed_graph (double cover)",
                ),
                mutants=(
                    Mutant(
                        name="lengths divisible by 4",
                        given={"divisor": 4, "simply_connected": True},
                    ),
                    Mutant(name="hypothesis dropped", given={"simply_connected": False}),
                ),
            ),
        ),
        erratum=Erratum(
            printed="every cycle of the dual graph of an asymptotic complex is even",
            corrected=(
                "every cycle of the dual graph of a simply connected asymptotic complex is even"
            ),
            kind="hypothesis",
            witness=(
                "the three faces of a cylinder of three rectangles glued along v-edges form a "
                "cycle of length 3"
            ),
            conclusion_survives=True,
        ),
    ),
    Claim(
        id="3.3.bipartite",
        section="3.3",
        where="proof of the lemma, line 627",
        kind="sentence",
        statement="A graph all of whose cycles are even is bipartite; if it is the dual graph, the "
        "complex has a checkerboard colouring.",
        checks=(
            Check(
                name="all graphs on 5 nodes",
                run=_COLOURING_CHECKS + "bipartite",
                routes=("cycles and colourings by trial", "discrete.signed_graph:signs"),
                mutants=(
                    Mutant(name="all cycles odd", given={"parity": 1}),
                    Mutant(name="cycles of length 3 only", given={"longest": 3}),
                    Mutant(name="cycles of length at most 4", given={"longest": 4}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.3.link",
        section="3.3",
        where="proof of the lemma, line 627",
        kind="sentence",
        statement="The faces at an interior vertex form a cycle of the dual graph, as long as the "
        "degree of the vertex.",
        hypotheses=_COMPLEX,
        rests_on=("3.3.quad-graph",),
        checks=(
            Check(
                name="around every interior vertex",
                run=_COLOURING_CHECKS + "link",
                tier="full",
                routes=("discrete.vertex_fan:vertex_fan", "degrees counted edge by edge"),
                mutants=(
                    Mutant(name="one longer", given={"extra": 1}),
                    Mutant(name="boundary vertices too", given={"interior": False}),
                ),
            ),
        ),
    ),
    Claim(
        id="fig:skeleton",
        section="3.3",
        where="figure (fig:skeleton), lines 633-650",
        kind="figure",
        statement="Two asymptotic complexes in the plane, simply connected and with a "
        "checkerboard colouring: one of sectors around a point, one of a grid after surgery.",
        labels=("fig:monkey-tcd", "fig:skew-tcd", "fig:skeleton"),
        rests_on=("def:A-complex", "3.3.checkerboard"),
        checks=(
            Check(
                name="both grids",
                run=_TOPOLOGY + "skeleton",
                routes=("discrete.gluing, discrete.complex_surgery", "homology modulo 2 by ranks"),
                mutants=(
                    Mutant(name="five rays", given={"rays": 5}),
                    Mutant(name="eight rays", given={"rays": 8}),
                    Mutant(name="five sectors for one", given={"inserted": 5}),
                    Mutant(name="centre taken away", given={"hole": True}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.3.grids-equivalent",
        section="3.3",
        where="proof of the lemma, line 628, on the figure (fig:skeleton)",
        kind="sentence",
        statement="The complex of an assembled monkey saddle and that of surgery, a quadrant "
        "replaced by 3 sectors, are equivalent as graphs.",
        hypotheses=("(used, not stated) sectors are divided into equally many faces",),
        rests_on=("fig:skeleton", "3.2.assembled-order"),
        checks=(
            Check(
                name="isomorphism",
                run=_TOPOLOGY + "grids_equivalent",
                routes=("discrete.gluing:star", "discrete.complex_surgery:surgery"),
                mutants=(
                    Mutant(name="five sectors for one", given={"inserted": 5}),
                    Mutant(name="new sectors divided finer", given={"new": 3}),
                    Mutant(name="star of eight", given={"rays": 8}),
                ),
            ),
        ),
    ),
    Claim(
        id="remark:simply_connected",
        section="3.3",
        where="remark (remark:simply_connected), line 630, last sentence",
        kind="remark",
        statement=r"A simply connected asymptotic complex embeds into $\mathbb{R}^2$ and is "
        "homeomorphic to the disk.",
        labels=("remark:simply_connected",),
        hypotheses=(
            *_COMPLEX,
            r"$A$ simply connected",
            (
                "(used, not stated) finitely many faces; a sphere need not be excluded, for "
                "strong regularity and the two families exclude it"
            ),
        ),
        rests_on=("def:A-complex", "3.3.even-degree", "3.3.strongly-regular-intersections"),
        checks=(
            Check(
                name="disk",
                run=_TOPOLOGY + "disk",
                tier="full",
                routes=(
                    "homology modulo 2 by ranks",
                    "orientation, boundary and Euler characteristic",
                ),
                mutants=(
                    Mutant(
                        name="connected for simply connected", given={"simply_connected": False}
                    ),
                    Mutant(name="not strongly regular", given={"regular": False}),
                    Mutant(name="families not asked for", given={"families": False}),
                ),
            ),
        ),
    ),
)

_FRONTS = (
    Claim(
        id="defn:quad",
        section="3.3",
        where="definition (defn:quad), line 652, first sentence",
        kind="definition",
        statement=r"A branched PS-front is a map $r : A \to \mathbb{R}^3$ on an asymptotic complex "
        r"with each $r_k = r|_{F_k}$ continuous on $F_k$ and a $C^{1M}$ PS-front on its interior.",
        labels=("defn:quad",),
        hypotheses=(
            *_COMPLEX,
            "(used, not stated) the normals of neighbouring faces agree on their common edge",
        ),
        rests_on=("def:A-complex", "eq:lelieuvre"),
        checks=(
            Check(
                name="tractrix front on two faces",
                run=_FRONT_CHECKS + "branched_front",
                tier="full",
                routes=("printed Lelieuvre and Moutard equations", "theory.fronts:tractrix_front"),
                mutants=(
                    Mutant(name="second face mirrored", given={"change": "mirrored"}),
                    Mutant(
                        name="families swapped on the second face",
                        given={"change": "families swapped"},
                    ),
                    Mutant(name="second face shifted", given={"change": "shifted"}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.3.quadrilateral-sides",
        section="3.3",
        where="definition (defn:quad), line 652, second sentence, and line 655",
        kind="definition",
        statement=r"An asymptotic quadrilateral, the image $r(F_k)$ of a face, is bounded by two "
        r"$u$- and two $v$-asymptotic curves and has global asymptotic coordinates.",
        hypotheses=(
            r"(used, not stated) $r_k$ is one-to-one, or the coordinates are those of $F_k$",
        ),
        rests_on=("defn:quad", "3.3.complex-faces"),
        checks=(
            Check(
                name="sides and curves",
                run=_FRONT_CHECKS + "quadrilateral",
                tier="full",
                routes=("discrete.asymptotic_complex (sides)", "theory.fronts:tractrix_front"),
                mutants=(
                    Mutant(name="opposite sides of two families", given={"step": 2}),
                    Mutant(name="diagonals for lines", given={"curves": "diagonals"}),
                ),
            ),
        ),
    ),
    Claim(
        id="def:sector",
        section="3.3",
        where="definition (def:sector), line 657",
        kind="definition",
        statement=r"A sector at $p$ is a closed $K \subset \Omega$ with an injection $\tau : K \to "
        r"[0, u_0) \times [0, v_0)$, $\tau \in C(K) \cap C^2(K^0)$, and a PS-front $r$ on "
        r"$(0, u_0) \times (0, v_0)$ with $\psi|_K = r \circ \tau$; $\tau(p) = (0, 0)$, and $K$ "
        r"contains $\gamma_u = \tau^{-1}([0, u_0) \times \{0\})$ and $\gamma_v = "
        r"\tau^{-1}(\{0\} \times [0, v_0))$.",
        labels=("def:sector",),
        hypotheses=(
            *_BRANCHED,
            r"(used, not stated) $r$ extends to the sides $u = 0$ and $v = 0$, and $\tau$ is onto",
        ),
        rests_on=("def:branched_immersion", "eq:lelieuvre"),
        checks=(
            Check(
                name="as printed",
                run=_FRONT_CHECKS + "sector",
                routes=("domain of r as a set", "theory.fronts:tractrix_front"),
                mutants=(Mutant(name="p off the corner", given={"origin": "1/4"}),),
            ),
            Check(
                name="with the two sides",
                run=_FRONT_CHECKS + "sector",
                form="corrected",
                given={"sides": "both"},
                routes=("domain of r as a set", "theory.fronts:tractrix_front"),
                mutants=(
                    Mutant(name="side v = 0 without its ends", given={"sides": "u"}),
                    Mutant(name="p off the corner", given={"sides": "both", "origin": "1/4"}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=(
                r"a PS-front $r : (0, u_0) \times (0, v_0) \times \mathbb{R}^3$ with $\psi|_K = r "
                r"\circ \tau$"
            ),
            corrected=(
                r"$r : [0, u_0) \times [0, v_0) \to \mathbb{R}^3$ continuous, a PS-front on the "
                "interior"
            ),
            kind="misprint",
            witness=(
                r"$p \in K$ has $\tau(p) = (0, 0)$, where $r$ is not defined; nor is it on the "
                r"images of $\gamma_u$ and $\gamma_v$"
            ),
            conclusion_survives=True,
            remark=r"The last sign $\times$ of the domain stands for $\to$.",
        ),
    ),
    Claim(
        id="3.3.sector-no-other-curve",
        section="3.3",
        where="line 660",
        kind="sentence",
        statement=r"A sector at $p$ is bounded on two sides by a $u$- and a $v$-asymptotic curve "
        r"through $p$ and contains no other asymptotic curve through $p$.",
        hypotheses=_BRANCHED,
        rests_on=("def:sector",),
        checks=(
            Check(
                name="every quadrant",
                run=_SECTORS + "no_other_curve",
                routes=(
                    "discrete.complex_surgery:quadrant",
                    "lines followed from vertex to vertex",
                ),
                mutants=(Mutant(name="two sectors together", given={"sectors": 2}),),
            ),
        ),
    ),
    Claim(
        id="3.3.sector-angle-sum",
        section="3.3",
        where="line 661",
        kind="number",
        statement=r"There are $m_p$ angles of sectors at $p$, and their sum is $2\pi$.",
        hypotheses=(*_BRANCHED, r"$p \in \Omega$"),
        rests_on=("def:sector", "def:m-star"),
        checks=(
            Check(
                name="as printed",
                run=_SECTORS + "angle_sum",
                routes=(
                    "theory.star_saddle (regular and random angles)",
                    "discrete.asymptotic_complex (faces at vertices)",
                ),
                mutants=(
                    Mutant(name="3 m_p", given={"per_order": 3}),
                    Mutant(name="m_p + 1", given={"offset": 1}, near=True),
                ),
            ),
            Check(
                name="2 m_p angles",
                run=_SECTORS + "angle_sum",
                form="corrected",
                given={"per_order": 2},
                routes=(
                    "theory.star_saddle (regular and random angles)",
                    "discrete.asymptotic_complex (faces at vertices)",
                ),
                mutants=(
                    Mutant(name="m_p", given={"per_order": 1}),
                    Mutant(name="3 m_p", given={"per_order": 3}),
                    Mutant(name="2 m_p + 1", given={"per_order": 2, "offset": 1}, near=True),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"the sum of the $m_p$ angles of the sectors at $p$ is $2\pi$",
            corrected=r"the sum of the $2 m_p$ angles of the sectors at $p$ is $2\pi$",
            kind="constant",
            witness=(
                r"a smooth saddle, $m_p = 2$, has four sectors; with all angles $\pi/2$, two of "
                r"them add up to $\pi$"
            ),
            conclusion_survives=True,
        ),
    ),
    Claim(
        id="3.3.normal-winds",
        section="3.3",
        where="line 661",
        kind="sentence",
        statement=r"The images of the sectors at $p$ under $N$ can wind around $N(p)$ several "
        r"times: their angles at $N(p)$ can add up to a multiple of $2\pi$.",
        hypotheses=(*_BRANCHED, r"(used, not stated) $N_u \times N_v \ne 0$ at $p$"),
        rests_on=("3.3.sector-angle-sum", "eq:lelieuvre"),
        checks=(
            Check(
                name="stars and graphs",
                run=_SECTORS + "normal_winds",
                routes=(
                    "rays turned by the Lelieuvre equations",
                    "gradients of Re z^m at Gaussian integers",
                ),
                mutants=(
                    Mutant(name="both families turned alike", given={"dual": "same"}),
                    Mutant(name="once less", given={"add": 1}),
                ),
            ),
        ),
    ),
)

CLAIMS: tuple[Claim, ...] = _IMMERSIONS + _QUAD_GRAPHS + _COLOURING + _FRONTS
