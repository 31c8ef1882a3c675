"""Claims of section 3.3, branched immersions, quad-graphs, asymptotic complexes, sectors."""

from checks.claim import Claim

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
        rests_on=("def:m-star", "def:m-saddle", "def:H2"),
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
    ),
    Claim(
        id="3.3.strongly-regular-faces",
        section="3.3",
        where="line 619, item (i)",
        kind="item",
        statement="In a strongly regular cell decomposition the edges and the vertices of each "
        "face are pairwise distinct.",
    ),
    Claim(
        id="3.3.strongly-regular-intersections",
        section="3.3",
        where="line 619, item (ii)",
        kind="item",
        statement="In a strongly regular cell decomposition two faces meet in nothing, in one "
        "vertex, or in one closed edge.",
        hypotheses=("two different faces",),
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
    ),
    Claim(
        id="3.3.edges-alternate",
        section="3.3",
        where="proof of the lemma, lines 626-627",
        kind="sentence",
        statement=r"Around every vertex $u$- and $v$-edges alternate.",
        hypotheses=(*_COMPLEX, "(used, not stated) at a boundary vertex, in the order of its fan"),
        rests_on=("3.3.complex-edges",),
    ),
    Claim(
        id="3.3.dual-cycles-equal",
        section="3.3",
        where="proof of the lemma, line 627",
        kind="sentence",
        statement=r"Every cycle of the dual graph crosses as many $u$-edges as $v$-edges.",
        hypotheses=_COMPLEX,
        rests_on=("3.3.edges-alternate",),
    ),
    Claim(
        id="3.3.dual-cycles-even",
        section="3.3",
        where="proof of the lemma, line 627",
        kind="sentence",
        statement="Every cycle of the dual graph has even length.",
        hypotheses=_COMPLEX,
        rests_on=("3.3.dual-cycles-equal",),
    ),
    Claim(
        id="3.3.bipartite",
        section="3.3",
        where="proof of the lemma, line 627",
        kind="sentence",
        statement="A graph all of whose cycles are even is bipartite; if it is the dual graph, the "
        "complex has a checkerboard colouring.",
        hypotheses=("(used, not stated) the complex is locally finite",),
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
            "(used, not stated) finitely many faces; the sphere has to be excluded",
        ),
        rests_on=("def:A-complex", "3.3.even-degree", "3.3.strongly-regular-intersections"),
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
    ),
    Claim(
        id="3.3.sector-angle-sum",
        section="3.3",
        where="line 661",
        kind="number",
        statement=r"There are $m_p$ angles of sectors at $p$, and their sum is $2\pi$.",
        hypotheses=(*_BRANCHED, r"$p \in \Omega$"),
        rests_on=("def:sector", "def:m-star"),
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
    ),
)

CLAIMS: tuple[Claim, ...] = _IMMERSIONS + _QUAD_GRAPHS + _COLOURING + _FRONTS
