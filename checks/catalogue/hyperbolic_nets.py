"""Claims of section 4.1, Chebyshev nets in the Poincare disk."""

from checks.claim import Check, Claim, Erratum, Mutant

_DISK = "checks.verify.poincare_disk:"
_ANGLES = "checks.verify.poincare_angles:"
_STARS = "checks.verify.planar_stars:"
_TOPOLOGY = "checks.verify.net_topology:"

CLAIMS: tuple[Claim, ...] = (
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
        checks=(
            Check(
                name="as defined",
                run="checks.verify.hyperbolic_nets:definition",
                routes=("printed definition", "half-turns of the hyperboloid"),
                mutants=(
                    Mutant(name="without the marks", given={"alternating": False}),
                    Mutant(name="without the rule", given={"rule": False}),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="as defined",
                run=_TOPOLOGY + "branch_points",
                tier="full",
                routes=(
                    "printed condition on the degree",
                    "winding of the normal of Lelieuvre's surface",
                ),
                mutants=(
                    Mutant(name="degree 4", given={"least": 4}, near=True),
                    Mutant(name="degree 8", given={"least": 8}, near=True),
                    Mutant(name="vertices of the boundary too", given={"interior": False}),
                ),
            ),
        ),
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
            (
                "(used, not stated) the complex is a star of rectangles, or comes from one by "
                "surgeries in its sectors, as those of sections 3.4 and 5: no other is tried"
            ),
        ),
        rests_on=("4.1.hyperbolic-chebyshev-net", "poincare-ddg", "def:A-complex"),
        checks=(
            Check(
                name="nets on given complexes",
                run=_TOPOLOGY + "inherited",
                tier="full",
                routes=(
                    "combinatorial surgery and (poincare-ddg)",
                    "half-turns of triples between equally spaced geodesics",
                ),
                mutants=(
                    Mutant(name="last edge 1 % longer", given={"last_edge": 101}, near=True),
                    Mutant(name="1 + 1.01 |w_1 w_2|", given={"weight": "101/100"}, near=True),
                    Mutant(name="1 - |w_1 w_2|", given={"weight": "-1"}),
                    Mutant(name="a complex without branch points", given={"branched": False}),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="quad by quad",
                run=_STARS + "quad",
                part="quad",
                tier="full",
                routes=(
                    "discrete.lelieuvre on half-turns of S^2, in a field of fractions",
                    "discrete.geodesics on half-turns of H^2",
                ),
                mutants=(
                    Mutant(name="tan(s/2) 1 % larger", given={"scale": "101/100"}, near=True),
                    Mutant(name="normals to the left of v-edges", given={"v_sign": 1}),
                    Mutant(name="normals in parallelograms of R^3", given={"half_turn": False}),
                ),
            ),
            Check(
                name="across sectors",
                run=_STARS + "whole",
                part="net",
                routes=(
                    "discrete.planar_stars with the angles of the net",
                    "angles between half-turns of triples of H^2",
                ),
                mutants=(
                    Mutant(name="angles of sum 2 pi + 0.01", given={"gap": "1/100"}, near=True),
                    Mutant(name="edges 1 % longer", given={"percent": 101}, near=True),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="quad by quad",
                run="checks.verify.net_correspondence:equivalence",
                routes=(
                    "edges N_1 x N_0, -N_2 x N_0 in space",
                    "discrete.geodesics on the rhombus of H^2",
                ),
                mutants=(
                    Mutant(name="tan(delta/2) 1 % larger", given={"scale": "101/100"}, near=True),
                    Mutant(name="same sign on v-edges", given={"v_sign": 1}),
                ),
                tier="full",
            ),
        ),
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
        checks=(
            Check(
                name="as printed",
                run=_ANGLES + "intrinsic",
                routes=(
                    "printed formula",
                    "discrete.geodesics (hyperboloid)",
                ),
                mutants=(
                    Mutant(name="w_1 not conjugated", given={"conjugated": False}),
                    Mutant(name="turned by 0.01", given={"turn": "1/100"}, near=True),
                ),
            ),
            Check(
                name="other orientation",
                run=_ANGLES + "clockwise",
                form="support",
                routes=(
                    "printed formula",
                    "angle between the axes",
                ),
                mutants=(Mutant(name="plus", given={"sign": 1}),),
            ),
            Check(
                name="order at the node",
                run=_ANGLES + "order",
                form="support",
                routes=(
                    "(eq:angle) on the net of (poincare-ddg)",
                    "theory.painleve_float",
                ),
                mutants=(Mutant(name="order 2", given={"order": 2}, near=True),),
            ),
            Check(
                name="order backwards at the node",
                run=_ANGLES + "order",
                form="support",
                given={"place": "backwards, at its node"},
                routes=(
                    "(eq:angle) on the net of (poincare-ddg)",
                    "theory.painleve_float",
                ),
                mutants=(
                    Mutant(
                        name="order 2",
                        given={"place": "backwards, at its node", "order": 2},
                        near=True,
                    ),
                ),
            ),
            Check(
                name="order at the centre",
                run=_ANGLES + "order",
                form="support",
                given={"place": "at the centre of its quad", "order": 2},
                routes=(
                    "(eq:angle) on the net of (poincare-ddg)",
                    "theory.painleve_float",
                ),
                mutants=(
                    Mutant(
                        name="order 1",
                        given={"place": "at the centre of its quad", "order": 1},
                        near=True,
                    ),
                    Mutant(
                        name="0.1 steps off",
                        given={"place": "at the centre of its quad", "order": 2, "shift": "1/10"},
                        near=True,
                    ),
                ),
            ),
            Check(
                name="order of the mean",
                run=_ANGLES + "order",
                tier="full",
                form="support",
                given={"place": "mean of four, at the node", "order": 2},
                routes=(
                    "(eq:angle) on the net of (poincare-ddg)",
                    "theory.painleve_float",
                ),
                mutants=(
                    Mutant(
                        name="order 1",
                        given={"place": "mean of four, at the node", "order": 1},
                        near=True,
                    ),
                    Mutant(
                        name="0.1 steps off",
                        given={"place": "mean of four, at the node", "order": 2, "shift": "1/10"},
                        near=True,
                    ),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="as printed",
                run=_ANGLES + "thirds",
                routes=(
                    "printed formula",
                    "equal thirds of the angle",
                ),
                mutants=(
                    Mutant(name="w_2 w_1", given={"weight": 1}),
                    Mutant(name="a quarter", given={"divisor": 4}, near=True),
                ),
            ),
            Check(
                name="quadrants of the example",
                run=_ANGLES + "quadrants_off",
                form="support",
                routes=(
                    "printed formula, principal values",
                    "equal thirds of the angle",
                ),
                mutants=(
                    Mutant(name="sums of the arguments", given={"principal": False}),
                    Mutant(name="angles below pi/2", given={"least": 1}, near=True),
                ),
            ),
            Check(
                name="sum of the arguments",
                run=_ANGLES + "thirds",
                form="corrected",
                given={"principal": False},
                routes=(
                    "printed formula",
                    "equal thirds of the angle",
                ),
                mutants=(
                    Mutant(name="w_2 w_1", given={"principal": False, "weight": 1}),
                    Mutant(name="a quarter", given={"principal": False, "divisor": 4}, near=True),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"$\varphi_1 = \frac13\arg(w_2 w_1^2)$, $\varphi_2 = \frac13\arg(w_2^2 w_1)$",
            corrected=(
                r"$\varphi_1 = \beta_1 + \frac13\arg(w_2 \bar w_1)$, $\varphi_2 = \beta_1 + "
                r"\frac23\arg(w_2 \bar w_1)$ with $\beta_1 = \arg w_1$ and $0 < \arg(w_2 \bar "
                r"w_1) < \pi$"
            ),
            kind="ambiguous",
            witness=(
                r"$w_1 \parallel i$, $w_2 \parallel e^{5\pi i/6}$: $\arg(w_2 w_1^2) = \arg "
                r"e^{11\pi i/6} = -\frac{\pi}{6}$ gives $\varphi_1 = -\frac{\pi}{18}$; the third "
                r"of the angle lies at $\frac{11\pi}{18}$"
            ),
            conclusion_survives=True,
            remark=(
                r"With the principal value the directions may be off by $\frac{2\pi}{3}$ or "
                r"$\frac{4\pi}{3}$, outside the removed sector. So it happens to six of the eight "
                r"new curves of the example, to one at least in each quadrant: there the angle at "
                r"the cut is above $\frac{\pi}{2}$ and its bisector is the diagonal. The sums "
                r"$2\beta_1 + \beta_2$, $\beta_1 + 2\beta_2$ of continuous arguments are right, "
                "and the words of the paper, a trisection, leave no other choice."
            ),
        ),
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
        checks=(
            Check(
                name="as printed",
                run=_DISK + "equally_spaced_elsewhere",
                tier="full",
                routes=(
                    "printed formula",
                    "discrete.geodesics and item (A)",
                ),
                mutants=(
                    Mutant(name="tanh(k Delta/4)", given={"rate": "1/4"}),
                    Mutant(name="minus below", given={"denominator": -1}),
                    Mutant(name="rate 0.505", given={"rate": "101/200"}, near=True),
                ),
            ),
        ),
    ),
)
