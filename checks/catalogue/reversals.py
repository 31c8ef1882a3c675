"""Claims of section 4.1, reversals of hyperbolic nets and ramification of their surfaces."""

from checks.claim import Claim

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="4.1.singular-locus",
        section="4.1",
        where="section 4.1, line 1215",
        kind="sentence",
        statement=(
            "A pseudospherical parametrization $r(u, v)$ fails to be locally injective only "
            r"where $\partial_u r \times \partial_v r = 0$."
        ),
        hypotheses=("$r$ is a smooth pseudospherical front in asymptotic coordinates",),
        rests_on=("eq:def_phi",),
    ),
    Claim(
        id="reversal",
        section="4.1",
        where="inequality (reversal), line 1217",
        kind="definition",
        statement=(
            r"There is a reversal at a regular node when $\prod_{p, q = \pm 1} "
            r"\omega(f(\zeta_{j+p,k}; -\zeta_{j,k}), f(\zeta_{j,k+q}; -\zeta_{j,k})) \leq 0$."
        ),
        labels=("reversal",),
        hypotheses=(
            r"$\zeta_{j,k}$ is regular: four quads meet there",
            r"$\omega$ is an orientation of $\mathbb{H}^2$",
            "(used, not stated) the four neighbours of the node are in the net",
        ),
        rests_on=("eq:mobius", "4.1.hyperbolic-chebyshev-net"),
    ),
    Claim(
        id="4.1.reversal-mobius",
        section="4.1",
        where="section 4.1, line 1220",
        kind="sentence",
        statement=(
            r"Whether there is a reversal at a node does not change under the maps $f(\cdot; "
            r"z_0, \theta)$."
        ),
        hypotheses=("all nodes are moved by the same map",),
        rests_on=("reversal", "eq:mobius"),
    ),
    Claim(
        id="4.1.reversal-orientation",
        section="4.1",
        where="section 4.1, line 1220",
        kind="sentence",
        statement=(
            r"The product of four terms in (reversal) is the same for $\omega$ and $-\omega$."
        ),
        rests_on=("reversal",),
    ),
    Claim(
        id="4.1.reversal-one-flipped",
        section="4.1",
        where="section 4.1, lines 1220-1221",
        kind="sentence",
        statement=(
            "At a reversal exactly one of the four quads at the node is flipped against the "
            "other three, so that the net folds over itself there."
        ),
        hypotheses=(
            "(reversal) holds at the node",
            "(used, not stated) the product is not $0$",
            (
                r"(used, not stated) flipped is not against $\omega$ but against the others: one "
                "against three"
            ),
            (
                "(used, not stated) a fold never flips exactly two of the four quads, for which "
                "the product is positive"
            ),
        ),
        rests_on=("reversal",),
    ),
    Claim(
        id="4.1.reversal-collinear",
        section="4.1",
        where="section 4.1, line 1247",
        kind="sentence",
        statement=(
            r"At a reversal the differences $\zeta_{j+1,k} - \zeta_{j,k}$ and $\zeta_{j,k+1} - "
            r"\zeta_{j,k}$ have passed through a common line."
        ),
        hypotheses=(
            (
                r"(used, not stated) collinear is meant for their images under $f(\cdot; "
                r"-\zeta_{j,k})$: chords of the disk are collinear elsewhere when $\Delta > 0$"
            ),
        ),
        rests_on=("reversal",),
    ),
    Claim(
        id="4.1.reversal-singular-edge",
        section="4.1",
        where="section 4.1, line 1247",
        kind="sentence",
        statement=(
            r"A reversal says that the angle $\varphi$ of the surface has become $0$ or $\pi$: a "
            "singular edge passes there."
        ),
        hypotheses=(
            "(used, not stated) up to the mesh width: the edge lies within a quad of the node",
        ),
        rests_on=("4.1.reversal-collinear", "eq:angle", "4.1.discrete-conformal"),
    ),
    Claim(
        id="remark:ramification",
        section="4.1",
        where="remark on ramification, lines 1293-1295",
        kind="remark",
        statement=(
            "The $K$-surface of a hyperbolic Chebyshev net is unramified when the angles add up "
            r"to $2\pi$ at each interior node and to less than $2\pi$ at each boundary node; no "
            "further condition such as (eq:unramified) is needed."
        ),
        labels=("remark:ramification",),
        hypotheses=(
            "(used, not stated) every quad has the orientation of the net: there is no reversal",
        ),
        rests_on=("4.1.discrete-conformal", "4.1.hyperbolic-chebyshev-net", "eq:unramified"),
    ),
    Claim(
        id="4.1.no-ramification-by-algorithm",
        section="4.1",
        where="remark on ramification, line 1293",
        kind="remark",
        statement=(
            r"The net that the greedy algorithm returns has angle sum $2\pi$ at interior nodes "
            r"and less than $2\pi$ at boundary nodes, so its $K$-surface is unramified."
        ),
        hypotheses=("(used, not stated) the angle of a sector is measured without sign",),
        rests_on=("remark:ramification", "alg:greedy-cuts"),
    ),
    Claim(
        id="4.1.normal-map-ramified",
        section="4.1",
        where="remark on ramification, line 1293",
        kind="remark",
        statement=(
            "At a branch point of the net the normal map of the $K$-surface is ramified: the "
            r"normals of the star wind $m - 1 \geq 2$ times."
        ),
        hypotheses=(r"the vertex has degree $2m \geq 6$",),
        rests_on=("remark:ramification", "lem:covering-number", "4.1.branch-point-degree"),
    ),
)
