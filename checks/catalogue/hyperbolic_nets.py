"""Claims of section 4.1, Chebyshev nets in the Poincare disk."""

from checks.claim import Claim

_SPACING = r"(used, not stated) $\Delta$ is the distance of neighbouring nodes, as in item (C)"
_RHOMB = r"$d(\zeta_0, \zeta_1) = d(\zeta_0, \zeta_2)$: the two known sides are equal"

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="4.1.deformation-composite",
        section="4.1",
        where="section 4.1, lines 1141 and 1196",
        kind="sentence",
        statement=(
            r"The deformation from material to laboratory frame is $y = r \circ \zeta^{-1}$, "
            r"where $r$ and $\zeta$ give the place in $\mathbb{R}^3$ and in $\Omega \subset "
            r"\mathbb{H}^2$ of a point of the asymptotic complex; it is isometric."
        ),
        hypotheses=(
            r"$\zeta$ and $r$ are built on the same complex $Q^\epsilon$",
            r"(used, not stated) $\zeta$ is injective, so the net has no reversal",
            (
                "(used, not stated) in the discrete setting isometric means: equal angles at "
                "vertices, edges equal up to one factor common to all"
            ),
        ),
        rests_on=("4.1.planar-stars",),
    ),
    Claim(
        id="4.1.poincare-metric",
        section="4.1",
        where="section 4.1, line 1143",
        kind="equation",
        statement=(
            r"The unit disk $|z| < 1$ with $g = \frac{4\,dz\,d\bar z}{1 - |z|^2}$ is a model of "
            r"$\mathbb{H}^2$: its Gauss curvature is $-1$."
        ),
        hypotheses=("$|z| < 1$",),
        rests_on=("def:H2",),
    ),
    Claim(
        id="4.1.A-distance",
        section="4.1",
        where="section 4.1, item (A), displayed formula, line 1147",
        kind="equation",
        statement=(
            r"$d(z_1, z_2) = \operatorname{arccosh}\left(1 + \frac{2|z_1 - z_2|^2}{(1 - "
            r"|z_1|^2)(1 - |z_2|^2)}\right)$."
        ),
        hypotheses=(
            "$|z_1| < 1$, $|z_2| < 1$",
            (
                r"(used, not stated) the metric is that of the definition of $\mathbb{H}^2$, "
                "with $(1 - |z|^2)^2$ below the line"
            ),
        ),
        rests_on=("def:H2",),
    ),
    Claim(
        id="eq:hyp_radius",
        section="4.1",
        where="equation (eq:hyp_radius), item (A), line 1152",
        kind="equation",
        statement=r"$d(0, z) = 2 \operatorname{artanh} |z|$.",
        labels=("eq:hyp_radius",),
        hypotheses=("$|z| < 1$",),
        rests_on=("4.1.A-distance",),
    ),
    Claim(
        id="eq:mobius",
        section="4.1",
        where="equation (eq:mobius), item (B), line 1157",
        kind="equation",
        statement=(
            r"The orientation preserving isometries of $\mathbb{H}^2$ are exactly the maps $f(z; "
            r"z_0, \theta) = e^{i\theta}\frac{z + z_0}{1 + z \bar z_0}$."
        ),
        labels=("eq:mobius",),
        hypotheses=(r"$|z_0| < 1$, $\theta \in [0, 2\pi)$",),
        rests_on=("4.1.A-distance",),
    ),
    Claim(
        id="4.1.B-no-rotation",
        section="4.1",
        where="section 4.1, item (B), line 1159",
        kind="sentence",
        statement=(
            r"The maps $f(\cdot; z_0)$ with $\theta = 0$ are enough for the construction: $f(0; "
            "z_0) = z_0$, so one of them brings any vertex to the origin and another brings it "
            "back."
        ),
        hypotheses=(
            "$|z_0| < 1$",
            (
                r"(used, not stated) composites of such maps, which in general have $\theta \neq "
                "0$, are not needed"
            ),
        ),
        rests_on=("eq:mobius",),
    ),
    Claim(
        id="4.1.B-derivative",
        section="4.1",
        where="section 4.1, item (B), line 1159",
        kind="equation",
        statement="$f'(0; z_0) = 1 - |z_0|^2$, which is real and positive.",
        hypotheses=("$|z_0| < 1$",),
        rests_on=("eq:mobius",),
    ),
    Claim(
        id="4.1.B-inverse",
        section="4.1",
        where="section 4.1, item (B), line 1159",
        kind="equation",
        statement=r"$f^{-1}(w; z_0) = f(w; -z_0) = \frac{w - z_0}{1 - w \bar z_0}$.",
        hypotheses=("$|z_0| < 1$, $|w| < 1$",),
        rests_on=("eq:mobius",),
    ),
    Claim(
        id="geodesics",
        section="4.1",
        where="section 4.1, item (C) (geodesics), line 1160",
        kind="item",
        statement=(
            r"The points $\gamma_\beta(n) = e^{i\beta} \tanh\frac{n\Delta}{2}$ lie on a geodesic "
            r"through $0$, neighbours at distance $\Delta$."
        ),
        labels=("geodesics",),
        hypotheses=(r"$\Delta > 0$, $n$ an integer",),
        rests_on=("eq:hyp_radius", "4.1.A-distance"),
    ),
    Claim(
        id="4.1.C-geodesics-elsewhere",
        section="4.1",
        where="section 4.1, item (C), line 1160",
        kind="equation",
        statement=(
            r"The points $z_n = f(\gamma_\beta(n); z_0)$ lie on a geodesic through $z_0$, "
            r"neighbours at distance $\Delta$; every geodesic through $z_0$ arises so."
        ),
        hypotheses=(r"$|z_0| < 1$, $\Delta > 0$",),
        rests_on=("geodesics", "eq:mobius"),
    ),
    Claim(
        id="4.1.chebyshev-equivalence",
        section="4.1",
        where="section 4.1, line 1163",
        kind="sentence",
        statement=(
            "A discrete geometry of surfaces with $K = -1$ is the same as a discrete Chebyshev "
            "net, that is, a net of rhombi, in the space that fits: $S^2$ for the normal, "
            r"$\mathbb{H}^2$ for the material position."
        ),
        hypotheses=(
            "(used, not stated) all edges have one length, as in the rest of the section",
            (
                r"(used, not stated) the edge $\Delta$ in $\mathbb{H}^2$ and the angle $\delta$ "
                r"between neighbouring normals belong together: $\cos\delta \cosh\Delta = 1$"
            ),
        ),
        rests_on=("poincare-ddg", "lem:Chebyshev", "eq:householder"),
    ),
    Claim(
        id="4.1.edge-length",
        section="4.1",
        where="section 4.1, line 1163",
        kind="equation",
        statement=(
            r"The known sides of the rhombus have the length $d(\zeta_0, \zeta_1) = d(\zeta_0, "
            r"\zeta_2) = 2\tanh\frac{\Delta}{2}$, for the $w_j$ of the following display."
        ),
        hypotheses=(_SPACING,),
        rests_on=("eq:hyp_radius",),
    ),
    Claim(
        id="4.1.normalised-neighbours",
        section="4.1",
        where="section 4.1, displayed formula, line 1165",
        kind="equation",
        statement=(
            r"$w_j = f(\zeta_j; -\zeta_0)$ gives $w_0 = 0$, $w_1 = \frac{\Delta}{2} "
            r"e^{i\beta_1}$, $w_2 = \frac{\Delta}{2} e^{i\beta_2}$."
        ),
        hypotheses=(
            r"$d(\zeta_0, \zeta_1) = d(\zeta_0, \zeta_2)$, the side of the rhombus",
            _SPACING,
        ),
        rests_on=("eq:mobius", "eq:hyp_radius"),
    ),
    Claim(
        id="4.1.closing-lengths",
        section="4.1",
        where="section 4.1, line 1167",
        kind="sentence",
        statement=(
            "The fourth vertex $w_{12}$ is determined by $d(w_{12}, w_1) = d(w_{12}, w_2) = "
            r"2\tanh\frac{\Delta}{2}$."
        ),
        hypotheses=(
            _RHOMB,
            _SPACING,
            r"(used, not stated) $w_1 \neq \pm w_2$",
            r"(used, not stated) $w_{12} \neq w_0$: the origin solves the same two equations",
        ),
        rests_on=("4.1.normalised-neighbours", "4.1.A-distance"),
    ),
    Claim(
        id="poincare-ddg",
        section="4.1",
        where="equation (poincare-ddg), line 1172",
        kind="equation",
        statement=(
            r"With $w_j = f(\zeta_j; -\zeta_0)$, the vertex that closes the rhombus is "
            r"$\zeta_{12} = f(w_{12}; \zeta_0)$, $w_{12} = \frac{w_1 + w_2}{1 + |w_1 w_2|}$."
        ),
        labels=("poincare-ddg",),
        hypotheses=(
            r"$|\zeta_j| < 1$ for $j = 0, 1, 2$",
            (
                r"$d(\zeta_0, \zeta_1) = d(\zeta_0, \zeta_2)$: the two known sides are equal, so "
                "$|w_1| = |w_2|$"
            ),
            r"(used, not stated) $w_1 \neq -w_2$, else $\zeta_{12} = \zeta_0$",
            r"(used, not stated) $w_1 \neq w_2$, else the rhombus has collapsed onto a geodesic",
        ),
        rests_on=("eq:mobius", "4.1.B-inverse", "4.1.A-distance"),
    ),
    Claim(
        id="4.1.net-either-diagonal",
        section="4.1",
        where="section 4.1, line 1196",
        kind="sentence",
        statement=(
            r"On a quad that satisfies (poincare-ddg) with $\zeta_0, \zeta_{12}$ opposite, it "
            r"holds for every choice of the vertex called $\zeta_0$ and of the neighbour called "
            r"$\zeta_1$."
        ),
        hypotheses=(_RHOMB, r"(used, not stated) the quad is not degenerate: $w_1 \neq \pm w_2$"),
        rests_on=("poincare-ddg",),
    ),
    Claim(
        id="4.1.hyperbolic-chebyshev-net",
        section="4.1",
        where="section 4.1, lines 1195-1196",
        kind="definition",
        statement=(
            r"A net is a hyperbolic Chebyshev net when it is a quadgraph in $\mathbb{H}^2$ with "
            "its edges marked $u$ or $v$, alternately around each quad, and (poincare-ddg) on "
            "each quad."
        ),
        hypotheses=(
            r"(used, not stated) all edges have the same length $\Delta$",
            (
                "(used, not stated) the quads around a vertex are laid out in the disk without "
                r"overlap: angles add up to $2\pi$ inside"
            ),
        ),
        rests_on=("poincare-ddg", "4.1.net-either-diagonal", "def:A-complex"),
    ),
    Claim(
        id="4.1.branch-point-degree",
        section="4.1",
        where="section 4.1, line 1196",
        kind="definition",
        statement=r"A branch point of the net is an interior vertex of degree $2m \geq 6$.",
        hypotheses=(
            (
                "(used, not stated) the degree of an interior vertex is even, as in an "
                "asymptotic complex"
            ),
            "(used, not stated) degree $2$ is excluded",
        ),
        rests_on=("4.1.hyperbolic-chebyshev-net", "def:A-complex"),
    ),
    Claim(
        id="4.1.inherited-topology",
        section="4.1",
        where="section 4.1, lines 1192-1194",
        kind="sentence",
        statement=(
            r"For a given asymptotic complex there are Chebyshev nets in $\mathbb{H}^2$, "
            "branched where the complex is, with the same combinatorics; they follow from "
            "equally spaced boundary data, quad by quad."
        ),
        hypotheses=(
            "the complex is simply connected",
            r"(used, not stated) angles of the boundary data at a branch point add up to $2\pi$",
            "(used, not stated) no quad degenerates and there is no reversal",
        ),
        rests_on=("4.1.hyperbolic-chebyshev-net", "poincare-ddg", "def:A-complex"),
    ),
    Claim(
        id="4.1.planar-stars",
        section="4.1",
        where="section 4.1, line 1196",
        kind="sentence",
        statement=(
            r"A hyperbolic Chebyshev net determines a discrete $K$-surface in $\mathbb{R}^3$: "
            "each vertex star is planar, with the edge lengths and the angles that the net has "
            "at that vertex."
        ),
        hypotheses=(
            r"the angles at an interior vertex of the net add up to $2\pi$",
            (
                "(used, not stated) up to a rigid motion and the choice of the side on which the "
                "torsion is positive"
            ),
            (
                "(used, not stated) lengths are meant up to one factor common to all edges: "
                r"with unit normals an edge is $\tanh\Delta$, not $\Delta$"
            ),
            "(used, not stated) the complex is simply connected",
        ),
        rests_on=("4.1.hyperbolic-chebyshev-net", "eq:d_lelieuvre", "def:K-surf"),
    ),
    Claim(
        id="4.1.discrete-conformal",
        section="4.1",
        where="section 4.1, line 1196",
        kind="sentence",
        statement=(
            "The map from the net in the disk to the $K$-surface is discretely conformal: at "
            "each vertex the angles between neighbouring edges are the same in both."
        ),
        hypotheses=(
            (
                r"(used, not stated) angles in the disk are those of the images under $f(\cdot; "
                r"-\zeta_{j,k})$, not those of chords in the disk"
            ),
        ),
        rests_on=("4.1.planar-stars", "eq:angle"),
    ),
    Claim(
        id="eq:angle",
        section="4.1",
        where="equation (eq:angle), line 1200",
        kind="equation",
        statement=(
            r"The angle between the asymptotic lines at node $(j, k)$ is $\varphi_{j,k} = "
            r"\arg(w_2 \bar w_1)$, with $w_1, w_2$ the images of $\zeta_{j+1,k}, \zeta_{j,k+1}$ "
            r"under $f(\cdot; -\zeta_{j,k})$."
        ),
        labels=("eq:angle",),
        hypotheses=(
            r"$w_1, w_2$ as in (poincare-ddg) for the quad whose first vertex is $\zeta_{j,k}$",
            r"(used, not stated) the principal value of $\arg$",
            (
                "(used, not stated) the turn from the $u$-edge to the $v$-edge is "
                "counter-clockwise; in a sector of the other orientation the value is "
                r"$-\varphi$"
            ),
        ),
        rests_on=("poincare-ddg", "eq:def_phi"),
    ),
    Claim(
        id="eq:trisect",
        section="4.1",
        where="equation (eq:trisect), line 1281",
        kind="equation",
        statement=(
            r"The directions $\varphi_1 = \frac13\arg(w_2 w_1^2)$ and $\varphi_2 = "
            r"\frac13\arg(w_2^2 w_1)$ divide the angle from $w_1$ to $w_2$ in three equal parts."
        ),
        labels=("eq:trisect",),
        hypotheses=(
            "$w_1, w_2$ are the edges of the removed sector, moved to the origin",
            (
                r"(used, not stated) the branches of $\arg$ are $2\beta_1 + \beta_2$ and "
                r"$\beta_1 + 2\beta_2$, where $\beta_1 \leq \beta_2 < \beta_1 + \pi$ are "
                r"arguments of $w_1, w_2$: the principal value may be off by $2\pi$"
            ),
        ),
        rests_on=("poincare-ddg",),
    ),
    Claim(
        id="eq:poincare-surgery",
        section="4.1",
        where="equation (eq:poincare-surgery), line 1286",
        kind="equation",
        statement=(
            r"The new curves are $\zeta_{0,k} = f(e^{i\varphi_1}\tanh\frac{k\Delta}{2}; "
            r"\zeta_0)$ and $\zeta_{j,0} = f(e^{i\varphi_2}\tanh\frac{j\Delta}{2}; \zeta_0)$: "
            r"geodesics through $\zeta_0 = \zeta(u^*, v^*)$ in the trisecting directions, with "
            r"nodes at distance $\Delta$."
        ),
        labels=("eq:poincare-surgery",),
        hypotheses=(
            r"$\varphi_1, \varphi_2$ from (eq:trisect)",
            (
                r"(used, not stated) $u$- and $v$-curves alternate around $\zeta_0$: the "
                "$v$-curve is next to the $u$-edge $w_1$, so the middle sector is oriented the "
                "other way"
            ),
        ),
        rests_on=("eq:trisect", "4.1.C-geodesics-elsewhere"),
    ),
)
