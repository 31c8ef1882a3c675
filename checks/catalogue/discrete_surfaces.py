"""Claims of section 4 up to the compatibility condition: grids and discrete K-surfaces."""

from checks.claim import Claim

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
            r"[0,u_k] \times [0,v_k]$; it reaches all four sides of the rectangle."
        ),
        hypotheses=(
            r"$i_k\epsilon = u_k$, $j_k\epsilon = v_k$",
            r"$\epsilon > 0$",
        ),
        rests_on=("def:A-complex",),
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
    ),
)
