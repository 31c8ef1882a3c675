"""Claims of section 4 up to the compatibility condition: grids and discrete K-surfaces."""

from checks.claim import Check, Claim, Erratum, Mutant

_GRIDS = "checks.verify.discrete_grids"
_LELIEUVRE = "checks.verify.discrete_lelieuvre"
_LIMIT = "checks.verify.lelieuvre_limit"
_SURFACES = "checks.verify.discrete_k_surfaces"

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="4.grid-in-a-face",
        section="4",
        where="opening of the section, line 994",
        kind="definition",
        statement=(
            r"The grid $M_k = \{0,\epsilon,2\epsilon,\ldots,i_k\epsilon\} \times "
            r"\{\epsilon,2\epsilon,\ldots,j_k\epsilon\} \subset \epsilon\mathbb Z^2$ is included "
            r"in the face $F_k$ by $\lambda_k : M_k \to F_k$, the inverse of $\psi_k : F_k \to "
            r"[0,u_k] \times [0,v_k]$; it contains the discrete curves defined with it, so it "
            r"reaches all four sides of the rectangle."
        ),
        hypotheses=(
            r"$i_k\epsilon = u_k$, $j_k\epsilon = v_k$",
            r"$\epsilon > 0$",
        ),
        rests_on=("def:A-complex",),
        checks=(
            Check(
                name="second-index-from-one",
                run=f"{_GRIDS}:grid_in_a_face",
                routes=(
                    "printed index ranges",
                    "cells of the shipped rectangle",
                ),
                mutants=(Mutant(name="first-index-too", near=True, given={"first_u": 1}),),
            ),
            Check(
                name="second-index-from-zero",
                run=f"{_GRIDS}:grid_in_a_face",
                form="corrected",
                given={"first_v": 0},
                routes=(
                    "index ranges from 0",
                    "cells of the shipped rectangle",
                ),
                mutants=(
                    Mutant(name="second-from-one", given={"first_v": 1}, near=True),
                    Mutant(name="first-from-one", given={"first_u": 1}, near=True),
                ),
            ),
        ),
        erratum=Erratum(
            printed=(
                r"$\{0,\epsilon,\ldots,i_k\epsilon\}\times"
                r"\{\epsilon,2\epsilon,\ldots,j_k\epsilon\}$"
            ),
            corrected=r"$\{0,\epsilon,\ldots,i_k\epsilon\}\times\{0,\epsilon,\ldots,j_k\epsilon\}$",
            kind="misprint",
            witness=(
                r"$i_k = j_k = 1$: the printed set has the two nodes $(0,\epsilon)$ and "
                r"$(\epsilon,\epsilon)$, no quad and no node on the side $v = 0$, but the discrete "
                r"$v$-curves, $0 \le j \le j_k$, start there"
            ),
            conclusion_survives=True,
            remark=r"a slip of the pen: the curves of the next line and the gluing use $j = 0$",
        ),
    ),
    Claim(
        id="4.commensurable-sides",
        section="4",
        where="opening of the section, line 994",
        kind="sentence",
        statement=(
            r"All sides $u_k, v_k$ become multiples of one $\epsilon$ after arbitrarily small "
            r"perturbations."
        ),
        hypotheses=(
            r"(used, not stated) finitely many faces",
            (
                r"(used, not stated) opposite sides of a face, and a side shared by two faces, are "
                r"perturbed alike"
            ),
        ),
        rests_on=("def:A-complex",),
        checks=(
            Check(
                name="rounded-ribbons",
                run=f"{_GRIDS}:commensurable",
                routes=(
                    "sides rounded to the nearest multiple",
                    "ribbons of opposite and shared sides",
                ),
                mutants=(
                    Mutant(name="rounded-differently", given={"alike": False}),
                    Mutant(name="closer", given={"bound": "2/5"}, near=True),
                    Mutant(name="sides-shorter-than-the-mesh", given={"infinite": True}),
                ),
            ),
        ),
    ),
    Claim(
        id="4.discrete-asymptotic-curves",
        section="4",
        where="opening of the section, line 994",
        kind="definition",
        statement=(
            r"The discrete $u$-curves are $\{(i\epsilon,j_0\epsilon) : 0 \le i \le i_k\}$ and the "
            r"discrete $v$-curves $\{(i_0\epsilon,j\epsilon) : 0 \le j \le j_k\}$."
        ),
        hypotheses=(r"$0 \le i_0 \le i_k$, $0 \le j_0 \le j_k$",),
        rests_on=("4.grid-in-a-face",),
        checks=(
            Check(
                name="lines-of-a-grid",
                run=f"{_GRIDS}:asymptotic_curves",
                routes=(
                    "printed index sets",
                    "edges by family of the shipped rectangle",
                ),
                mutants=(
                    Mutant(name="from-one", given={"first": 1}, near=True),
                    Mutant(name="families-exchanged", given={"exchanged": True}),
                ),
            ),
        ),
    ),
    Claim(
        id="4.grid-is-a-quadgraph",
        section="4",
        where="opening of the section, line 997",
        kind="sentence",
        statement=(
            r"A rectangular subset of $\epsilon\mathbb Z^2$ is a quadgraph with faces "
            r"$[i\epsilon,(i+1)\epsilon] \times [j\epsilon,(j+1)\epsilon]$, attached as subsets of "
            r"$\mathbb R^2$."
        ),
        rests_on=("def:A-complex",),
        checks=(
            Check(
                name="unit-squares",
                run=f"{_GRIDS}:grid_is_a_quadgraph",
                routes=(
                    "printed unit squares",
                    "shipped rectangle and its tests of strong regularity",
                ),
                mutants=(Mutant(name="overlapping-squares", given={"width": 2}, near=True),),
            ),
        ),
    ),
    Claim(
        id="4.quadgraph-of-a-complex",
        section="4",
        where="opening of the section, line 997",
        kind="sentence",
        statement=(
            r"The grids of the faces, attached by the $\lambda_k$ as the faces of $A$ are, form "
            r"one quadgraph $Q^\epsilon$ with $u$- and $v$-edges."
        ),
        hypotheses=(
            r"(used, not stated) one $\epsilon$ divides all sides of the faces",
            r"(used, not stated) each grid contains the nodes on the whole boundary of its face",
        ),
        rests_on=(
            "4.grid-is-a-quadgraph",
            "4.grid-in-a-face",
            "4.commensurable-sides",
        ),
        checks=(
            Check(
                name="divided-complexes",
                run=f"{_GRIDS}:quadgraph_of_a_complex",
                routes=(
                    "grids joined node by node",
                    "topology of the complex before division",
                ),
                mutants=(
                    Mutant(name="grids-without-two-sides", given={"first": 1}, near=True),
                    Mutant(name="shared-side-divided-unlike", given={"common": False}),
                ),
            ),
        ),
    ),
    Claim(
        id="4.normal-before-position",
        section="4",
        where="opening of the section, line 999",
        kind="algorithm",
        statement=(
            r"First a discrete Lorentz-harmonic normal field $N^\epsilon : Q^\epsilon \to S^2$, "
            r"then the immersion $r^\epsilon : Q^\epsilon \to \mathbb R^3$ from it by discrete "
            r"Lelieuvre equations."
        ),
        rests_on=(
            "eq:d_lelieuvre",
            "eq:d_compatible",
            "eq:lelieuvre",
        ),
        checks=(
            Check(
                name="two-steps",
                run=f"{_LELIEUVRE}:normal_before_position",
                routes=(
                    "shipped fill and summation in rational numbers",
                    "printed steps and condition",
                ),
                mutants=(Mutant(name="mirror-image", given={"rule": "reflection"}),),
            ),
        ),
    ),
    Claim(
        id="4.face-reduces-to-moutard",
        section="4",
        where="opening of the section, line 1001",
        kind="sentence",
        statement=(
            r"Within a face, generating a PS-front reduces to solving the Moutard equation $N_{uv} "
            r"= -(N_u\cdot N_v)N$."
        ),
        hypotheses=(
            (
                r"(used, not stated) $\|N\| = 1$ and $N_u, N_v \neq 0$ on two adjacent sides of "
                r"the face"
            ),
        ),
        rests_on=(
            "eq:moutard",
            "eq:lelieuvre",
            "eq:lorentz_harmonic",
        ),
        checks=(
            Check(
                name="unknown-unit-normal",
                run=f"{_LIMIT}:face_reduces_to_moutard",
                routes=(
                    "printed Lelieuvre formulae on an unknown normal",
                    "fundamental forms by differentiation",
                ),
                mutants=(
                    Mutant(name="sign", given={"sign": 1}),
                    Mutant(name="not-a-unit-normal", given={"unit": False}),
                ),
                tier="full",
            ),
        ),
    ),
    Claim(
        id="4.shift-notation",
        section="4",
        where="unlabelled equation, line 1006",
        kind="definition",
        statement=(
            r"$f_{i,j} = f_0$, $f_{i+1,j} = f_1$, $f_{i,j+1} = f_2$, $f_{i+1,j+1} = f_{12}$ on an "
            r"elementary quad: shift $1$ is along $u$, shift $2$ along $v$."
        ),
        checks=(
            Check(
                name="corners-of-a-quad",
                run=f"{_GRIDS}:shift_notation",
                routes=(
                    "printed shifts",
                    "corners p, p_u, p_v, p_uv of the shipped faces",
                ),
                mutants=(Mutant(name="shifts-exchanged", given={"exchanged": True}),),
            ),
        ),
    ),
    Claim(
        id="def:K-surf",
        section="4",
        where="definition (def:K-surf), line 1009",
        kind="definition",
        statement=(
            r"$r : J \subseteq \mathbb Z^2 \to \mathbb R^3$ is a discrete $K$-surface if and only "
            r"if there is $N : J \to S^2$ such that (eq:d_lelieuvre) holds on every quad."
        ),
        labels=("def:K-surf",),
        rests_on=(
            "eq:d_lelieuvre",
            "4.shift-notation",
        ),
        checks=(
            Check(
                name="recognised-from-its-points",
                run=f"{_SURFACES}:k_surface_definition",
                routes=(
                    "normals that the points were summed from",
                    "normals of the planes of the stars",
                ),
                mutants=(
                    Mutant(name="vertex-lifted", given={"moved": "vertex"}, near=True),
                    Mutant(
                        name="vertex-moved-in-its-plane", given={"moved": "sideways"}, near=True
                    ),
                    Mutant(name="scaled", given={"moved": "scaled"}),
                    Mutant(name="accepts-what-is-one", given={"refused": ""}),
                ),
            ),
        ),
    ),
    Claim(
        id="eq:d_lelieuvre",
        section="4",
        where="equation (eq:d_lelieuvre), line 1013",
        kind="equation",
        statement=r"$r_1 = r_0 + N_1 \times N_0$, $r_2 = r_0 - N_2 \times N_0$ on every quad.",
        labels=("eq:d_lelieuvre",),
        hypotheses=(
            r"$\|N\| = 1$",
            (
                r"(used, not stated) the equations hold along all four edges of a quad, also from "
                r"$r_1$ and $r_2$ to $r_{12}$"
            ),
        ),
        rests_on=("4.shift-notation",),
        checks=(
            Check(
                name="shipped-surface",
                run=f"{_LELIEUVRE}:steps_of_a_surface",
                routes=(
                    "printed steps along all edges",
                    "shipped summation along a column and the rows",
                ),
                mutants=(
                    Mutant(name="sign-u", given={"sign_u": -1}),
                    Mutant(name="sign-v", given={"sign_v": 1}),
                ),
            ),
            Check(
                name="turning-normals",
                run=f"{_LELIEUVRE}:steps_in_a_moved_frame",
                routes=(
                    "printed steps",
                    "planar stars and normals turned about the edges",
                ),
                mutants=(
                    Mutant(name="sign-u", given={"sign_u": -1}),
                    Mutant(name="sign-v", given={"sign_v": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="4.lelieuvre-discretised",
        section="4",
        where="after definition (def:K-surf), line 1016",
        kind="sentence",
        statement=(
            r"(eq:d_lelieuvre) discretises $r_u = N_u \times N$, $r_v = -N_v \times N$: the steps "
            r"over $h$ agree with the derivatives up to $O(h)$ at the vertex and $O(h^2)$ at the "
            r"middle of the edge."
        ),
        hypotheses=(r"(used, not stated) $N$ is smooth along the edge",),
        rests_on=(
            "eq:d_lelieuvre",
            "eq:lelieuvre",
        ),
        checks=(
            Check(
                name="orders",
                run=f"{_LIMIT}:lelieuvre_discretised",
                routes=(
                    "printed discrete steps on a Taylor polynomial",
                    "printed differential formulae",
                ),
                mutants=(
                    Mutant(name="second-order-at-the-vertex", given={"vertex_order": 2}, near=True),
                    Mutant(name="third-order-in-the-middle", given={"middle_order": 3}, near=True),
                    Mutant(name="first-order-in-the-middle", given={"middle_order": 1}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="4.edges-orthogonal-to-normal",
        section="4",
        where="after definition (def:K-surf), line 1016",
        kind="sentence",
        statement=(
            r"$r_{i\pm1,j} - r_{i,j}$ and $r_{i,j\pm1} - r_{i,j}$ are orthogonal to $N_{i,j}$ for "
            r"every solution of (eq:d_lelieuvre)."
        ),
        rests_on=("eq:d_lelieuvre",),
        checks=(
            Check(
                name="four-neighbours",
                run=f"{_LELIEUVRE}:orthogonal",
                routes=(
                    "printed steps for arbitrary normals",
                    "shipped surface in rational numbers",
                ),
                mutants=(
                    Mutant(name="normal-of-the-neighbour", given={"swapped": True}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="4.planar-vertex-stars",
        section="4",
        where="after definition (def:K-surf), line 1016",
        kind="sentence",
        statement=(
            r"The vertex stars of a discrete $K$-surface are planar: a vertex and all its "
            r"neighbours lie in one plane, also at a vertex of degree $2m$."
        ),
        rests_on=("4.edges-orthogonal-to-normal",),
        checks=(
            Check(
                name="stars-of-degree-4-and-6",
                run=f"{_SURFACES}:planar_stars",
                routes=(
                    "points summed along a spanning tree",
                    "normals of the net",
                ),
                mutants=(
                    Mutant(name="vertex-lifted", given={"lifted": True}, near=True),
                    Mutant(name="normal-of-the-next-vertex", given={"longer": True}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="4.quad-labelling",
        section="4",
        where="before equation (eq:d_compatible), line 1018",
        kind="sentence",
        statement=(
            r"$K$-surfaces are defined on asymptotic complexes by (eq:d_lelieuvre) on each quad, "
            r"with any vertex labelled $0$, its neighbour along a $u$-edge $1$, that along a "
            r"$v$-edge $2$, the opposite vertex $12$: the choice of vertex $0$ does not matter, "
            r"nor does the quad from which an edge is seen."
        ),
        hypotheses=(r"$u$- and $v$-edges alternate around every quad",),
        rests_on=(
            "def:K-surf",
            "eq:d_lelieuvre",
            "def:A-complex",
        ),
        checks=(
            Check(
                name="four-choices-of-the-vertex-0",
                run=f"{_LELIEUVRE}:labellings",
                routes=(
                    "printed steps from each vertex",
                    "printed steps from one vertex, reversed",
                ),
                mutants=(
                    Mutant(name="families-exchanged", given={"families": "exchanged"}),
                    Mutant(name="symmetric-step", given={"sign": -1}),
                ),
            ),
        ),
    ),
    Claim(
        id="4.two-paths",
        section="4",
        where="before equation (eq:d_compatible), line 1018",
        kind="sentence",
        statement=(
            r"$r_{12}$ is defined twice, along $0 \to 1 \to 12$ as $r_0 + N_1\times N_0 - "
            r"N_{12}\times N_1$ and along $0 \to 2 \to 12$ as $r_0 - N_2\times N_0 + N_{12}\times "
            r"N_2$."
        ),
        rests_on=("eq:d_lelieuvre",),
        checks=(
            Check(
                name="stepping",
                run=f"{_LELIEUVRE}:two_paths",
                routes=(
                    "printed sums",
                    "printed steps one after the other",
                ),
                mutants=(
                    Mutant(name="sign-by-1", given={"second": 1}),
                    Mutant(name="sign-by-2", given={"last": -1}),
                ),
            ),
        ),
    ),
    Claim(
        id="eq:d_compatible",
        section="4",
        where="equation (eq:d_compatible), line 1021",
        kind="equation",
        statement=(
            r"The two values of $r_{12}$ agree if and only if $N_1\times N_0 - N_{12}\times N_1 - "
            r"(-N_2\times N_0 + N_{12}\times N_2) = (N_1+N_2)\times(N_0+N_{12}) = 0$."
        ),
        labels=("eq:d_compatible",),
        rests_on=("4.two-paths",),
        checks=(
            Check(
                name="both-equalities",
                run=f"{_LELIEUVRE}:compatible",
                routes=(
                    "printed sums and product",
                    "gap of the two paths by printed steps",
                ),
                mutants=(
                    Mutant(name="sign-in-the-bracket", given={"last": -1}),
                    Mutant(name="difference-of-normals", given={"sign": -1}),
                ),
            ),
        ),
    ),
    Claim(
        id="4.condition-discretised",
        section="4",
        where="equation (eqn:discreteconstantcurvaturepde), first line, line 1025",
        kind="equation",
        statement=(
            r"$N_{uv}\times N = 0$ is discretised by $0 = "
            r"\left(N_{12}+N_0-(N_1+N_2)\right)\times\frac{N_0+N_1+N_2+N_{12}}{4}$, which is "
            r"$h^2\,N_{uv}\times N$ at the centre of the quad up to higher order."
        ),
        hypotheses=(r"(used, not stated) the mesh size $h$, a common factor $h^2$, is left out",),
        rests_on=("eq:lorentz_harmonic",),
        checks=(
            Check(
                name="order-at-the-centre",
                run=f"{_LIMIT}:condition_discretised",
                routes=(
                    "printed first line on a Taylor polynomial",
                    "N_uv x N from its coefficients",
                ),
                mutants=(
                    Mutant(name="power-1", given={"power": 1}, near=True),
                    Mutant(name="next-power-5", given={"next_power": 5}, near=True),
                    Mutant(name="next-power-3", given={"next_power": 3}, near=True),
                    Mutant(name="sum-for-difference", given={"difference": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="4.condition-expanded",
        section="4",
        where="equation (eqn:discreteconstantcurvaturepde), second line, line 1026",
        kind="equation",
        statement=(
            r"$\left(N_{12}+N_0-(N_1+N_2)\right)\times\frac{N_0+N_1+N_2+N_{12}}{4} = "
            r"\frac24\left(N_0\times N_1 - N_1\times N_{12} + N_{12}\times N_2 - N_2\times "
            r"N_0\right)$."
        ),
        rests_on=("4.condition-discretised",),
        checks=(
            Check(
                name="first-and-second-line",
                run=f"{_LELIEUVRE}:condition_expanded",
                routes=(
                    "printed first line",
                    "printed second line",
                ),
                mutants=(
                    Mutant(name="half-of-it", given={"half": "1/4"}),
                    Mutant(name="sign", given={"last": 1}),
                    Mutant(name="one-percent", given={"half": "101/200"}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="eqn:discreteconstantcurvaturepde",
        section="4",
        where="equation (eqn:discreteconstantcurvaturepde), third line, line 1027",
        kind="equation",
        statement=(
            r"$\frac24\left(N_0\times N_1 - N_1\times N_{12} + N_{12}\times N_2 - N_2\times "
            r"N_0\right) = \frac12(N_0+N_{12})\times(N_1+N_2)$, and the discretised condition is "
            r"that this vanishes."
        ),
        labels=("eqn:discreteconstantcurvaturepde",),
        rests_on=("4.condition-expanded",),
        checks=(
            Check(
                name="three-lines",
                run=f"{_LELIEUVRE}:condition_factored",
                routes=(
                    "printed third line",
                    "printed first and second lines",
                ),
                mutants=(
                    Mutant(name="half-of-it", given={"half": "1/4"}),
                    Mutant(name="sign", given={"sign": -1}),
                    Mutant(name="one-percent", given={"half": "101/200"}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="4.same-compatibility",
        section="4",
        where="after equation (eqn:discreteconstantcurvaturepde), line 1029",
        kind="sentence",
        statement=(
            r"(eqn:discreteconstantcurvaturepde) and (eq:d_compatible) are the same condition, "
            r"exactly and at every mesh size: discretising the compatibility condition and taking "
            r"the compatibility condition of the discrete equations commute."
        ),
        hypotheses=(
            r"(used, not stated) the left sides agree up to the constant factor $-\frac12$",
        ),
        rests_on=(
            "eqn:discreteconstantcurvaturepde",
            "eq:d_compatible",
        ),
        checks=(
            Check(
                name="constant-multiple",
                run=f"{_LELIEUVRE}:same_condition",
                routes=(
                    "printed discretised condition",
                    "printed gap of the discrete equations",
                ),
                mutants=(
                    Mutant(name="sign", given={"factor": "1/2"}),
                    Mutant(name="one-percent", given={"factor": "-101/200"}, near=True),
                ),
            ),
        ),
    ),
)
