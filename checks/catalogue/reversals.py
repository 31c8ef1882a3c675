"""Claims of section 4.1, reversals of hyperbolic nets and ramification of their surfaces."""

from checks.claim import Check, Claim, Erratum, Mutant

_REV = "checks.verify.reversals:"
_FOLDS = "checks.verify.amsler_folds:"
_RAM = "checks.verify.net_ramification:"

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
        checks=(
            Check(
                name="least stretch",
                run=_REV + "singular_locus",
                routes=(
                    "Gram matrix of the metric",
                    "inverse function theorem on its least eigenvalue",
                ),
                mutants=(
                    Mutant(name="twice the cosine", given={"weight": 2}),
                    Mutant(name="stretch 2 - |cos|", given={"floor": "2 - |cos|"}),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="instances",
                run=_REV + "definition",
                part="criterion",
                routes=(
                    "product of orientations in the disk (rationals)",
                    "determinants of triples of the hyperboloid (rationals)",
                ),
                mutants=(
                    Mutant(name="strict inequality", given={"strict": True}),
                    Mutant(name="three quads", given={"quads": 3}),
                    Mutant(name="differences as they are", given={"moved": False}),
                    Mutant(name="sum for product", given={"form": "sum"}),
                ),
            ),
            Check(
                name="folds, as printed",
                run=_REV + "detects_folds",
                part="captures folds",
                routes=(
                    "product of orientations in the disk (rationals)",
                    "determinants of triples of the hyperboloid (rationals)",
                ),
                mutants=(Mutant(name="sum for product", given={"form": "sum"}),),
            ),
            Check(
                name="folds, quads not all alike",
                run=_REV + "detects_folds",
                tier="full",
                form="corrected",
                given={"form": "unequal"},
                part="captures folds",
                routes=(
                    "product of orientations in the disk (rationals)",
                    "determinants of triples of the hyperboloid (rationals)",
                ),
                mutants=(
                    Mutant(name="as printed", given={"form": "product"}),
                    Mutant(name="sum for product", given={"form": "sum"}),
                ),
            ),
            Check(
                name="folds, one quad against three",
                run=_REV + "detects_folds",
                tier="full",
                form="support",
                given={"against": "one"},
                part="captures folds",
                routes=(
                    "product of orientations in the disk (rationals)",
                    "determinants of triples of the hyperboloid (rationals)",
                ),
                mutants=(Mutant(name="all folds", given={"against": "any"}),),
            ),
            Check(
                name="net folded along a line",
                run=_REV + "folded_along_line",
                form="support",
                part="captures folds",
                routes=(
                    "exact net by half-turns",
                    "(reversal) at its nodes",
                ),
                mutants=(
                    Mutant(name="left strip below", given={"left": "below"}),
                    Mutant(name="quads not all alike", given={"form": "unequal"}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=(
                "The condition that the product of the four orientations be at most $0$ "
                "captures the folds of a net."
            ),
            corrected=(
                "A net folds at a regular node when its four quads are not all oriented as the "
                "net is: two may be flipped against two, and then the product is positive."
            ),
            kind="hypothesis",
            witness=(
                r"At the node $0$ with $u$-neighbours $\frac12\cdot\frac{-12 + 5i}{13}$, "
                r"$\frac12\cdot\frac{12 + 5i}{13}$ and $v$-neighbours $\pm\frac12$ all four "
                "quads lie above the $v$-line, those to the left on those to the right; the "
                r"factors are $-\frac5{52}, \frac5{52}, -\frac5{52}, \frac5{52}$ and their "
                "product is positive."
            ),
            conclusion_survives=True,
            remark=(
                "This is a fold along a v-line which the u-lines touch from one side; the same "
                "happens along a u-line. Where the edge crosses both families, as it does on "
                "Amsler nets, some nodes on either side of it have one quad against three, so "
                "that a reversal is seen there."
            ),
        ),
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
        checks=(
            Check(
                name="images turn alike",
                run=_REV + "moebius_invariance",
                tier="full",
                routes=(
                    "printed maps over the rational functions of the points",
                    "one factor for all neighbours",
                ),
                mutants=(
                    Mutant(name="differences as they are", given={"moved": False}),
                    Mutant(name="no conjugate below", given={"conjugated": False}),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="signs cancel",
                run=_REV + "both_orientations",
                routes=(
                    "printed product",
                    "the same with the other area form",
                ),
                mutants=(Mutant(name="three quads", given={"quads": 3}),),
            ),
        ),
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
        checks=(
            Check(
                name="as printed",
                run=_REV + "one_against_three",
                routes=(
                    "product of orientations in the disk (rationals)",
                    "determinants of triples of the hyperboloid (rationals)",
                ),
                mutants=(Mutant(name="three quads", given={"strict": True, "quads": 3}),),
            ),
            Check(
                name="product below 0",
                run=_REV + "one_against_three",
                tier="full",
                form="corrected",
                given={"strict": True},
                routes=(
                    "product of orientations in the disk (rationals)",
                    "determinants of triples of the hyperboloid (rationals)",
                ),
                mutants=(
                    Mutant(name="as printed", given={"strict": False}),
                    Mutant(name="three quads", given={"quads": 3}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=(
                "Where the product is at most $0$, one of the four quads is flipped against the "
                "three others."
            ),
            corrected=(
                "Where the product is less than $0$; where it is $0$ a quad has collapsed, and "
                "the others may be oriented in any way."
            ),
            kind="hypothesis",
            witness=(
                r"Node $0$ with the $u$-neighbours $\pm\frac12$ and the $v$-neighbours "
                r"$-\frac12$, $-\frac i2$: the product is $0$, two quads have collapsed to "
                "segments and the two others are oriented alike."
            ),
            conclusion_survives=True,
        ),
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
        checks=(
            Check(
                name="as printed",
                run=_REV + "collinear",
                routes=(
                    "product of orientations in the disk (rationals)",
                    "determinants of triples of the hyperboloid (rationals)",
                ),
                mutants=(
                    Mutant(
                        name="nodes without a reversal", given={"moved": True, "reversal": False}
                    ),
                ),
            ),
            Check(
                name="moved to the origin",
                run=_REV + "collinear",
                tier="full",
                form="corrected",
                given={"moved": True},
                routes=(
                    "product of orientations in the disk (rationals)",
                    "determinants of triples of the hyperboloid (rationals)",
                ),
                mutants=(
                    Mutant(name="differences as they are", given={"moved": False}),
                    Mutant(name="nodes without a reversal", given={"reversal": False}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=(
                r"At a reversal the differences $\zeta_{j+1,k} - \zeta_{j,k}$, $\zeta_{j,k+1} - "
                r"\zeta_{j,k}$ have passed through a common line."
            ),
            corrected=(
                r"Their images under $f(\cdot; -\zeta_{j,k})$ have; chords of the disk between "
                "points of one geodesic are collinear only if it passes through $0$."
            ),
            kind="ambiguous",
            witness=(
                r"Node $\frac12 + \frac i5$ with the $u$-neighbours $(\frac{5677}{18241}, "
                r"-\frac{200}{18241})$, $(\frac{560}{1049}, \frac{437}{1049})$ and the "
                r"$v$-neighbours $(\frac{137}{629}, \frac{140}{629})$, $(\frac{23020}{35461}, "
                r"\frac{11977}{35461})$, all at the distance $2\operatorname{artanh}\frac13$: "
                "(reversal) holds, yet the four products of the plain differences have the "
                "signs of a net without a fold."
            ),
            conclusion_survives=True,
            remark=(
                "Both readings agree in the limit of short edges, up to the choice of a "
                "neighbouring node."
            ),
        ),
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
        checks=(
            Check(
                name="reversals of Amsler nets",
                run=_FOLDS + "reversals_at_edges",
                tier="full",
                routes=(
                    "(reversal) on nets by (poincare-ddg)",
                    "zeros of phi - pi by the equation of Painleve",
                ),
                mutants=(
                    Mutant(name="edges moved by 1/5", given={"shift": "1/5"}),
                    Mutant(name="within a quarter of an edge", given={"width": "1/4"}),
                    Mutant(
                        name="edges moved by 1 %",
                        given={"shift": "3/100", "width": "1/2"},
                        near=True,
                    ),
                ),
            ),
        ),
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
            (
                "(used, not stated) every quad has the orientation of the net: it does not fold, "
                "which is more than that there be no reversal"
            ),
        ),
        rests_on=("4.1.discrete-conformal", "4.1.hyperbolic-chebyshev-net", "eq:unramified"),
        checks=(
            Check(
                name="stars, as printed",
                run=_RAM + "single_sheet",
                tier="full",
                part="condition",
                routes=(
                    "angles of triples",
                    "directions counted in the disk",
                ),
                mutants=(
                    Mutant(name="three quads", given={"folds": "excluded", "quads": 3}, near=True),
                ),
            ),
            Check(
                name="stars without folds",
                run=_RAM + "single_sheet",
                tier="full",
                form="corrected",
                given={"folds": "excluded"},
                part="condition",
                routes=(
                    "angles of triples",
                    "directions counted in the disk",
                ),
                mutants=(
                    Mutant(name="as printed", given={"folds": "allowed"}),
                    Mutant(name="three quads", given={"quads": 3}, near=True),
                ),
            ),
            Check(
                name="K-surfaces",
                run=_RAM + "surfaces",
                part="surfaces",
                routes=(
                    "Lelieuvre formulas from nets of normals",
                    "angles of the hyperbolic net",
                ),
                mutants=(
                    Mutant(name="sum 3 pi", given={"turns": 3}),
                    Mutant(name="surface stretched by 1 %", given={"stretch": "1/100"}, near=True),
                ),
            ),
        ),
        erratum=Erratum(
            printed=(
                r"Angle sums of $2\pi$ at interior nodes and less at boundary nodes leave no "
                "ramification."
            ),
            corrected=(
                "They do where all quads have the orientation of the net, so that it does not fold."
            ),
            kind="hypothesis",
            witness=(
                r"At the node $0$ with $u$-neighbours $\frac12\cdot\frac{\mp 12 + 5i}{13}$ and "
                r"$v$-neighbours $\pm\frac12$ the four angles are $\beta, \pi - \beta, \beta, "
                r"\pi - \beta$, of sum $2\pi$, yet every direction above the real axis lies in "
                "two of the quads and none below it in any."
            ),
            conclusion_survives=True,
            remark=(
                "Such a net satisfies (poincare-ddg) on all its quads and has no node with "
                "(reversal). Nets of the greedy algorithm have angles below pi in sectors of "
                "one orientation, so the conclusion drawn for them is not touched."
            ),
        ),
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
        checks=(
            Check(
                name="angle sums",
                run="checks.verify.printed_surface:angle_sums",
                routes=("angles in space", "2 pi inside and less at the rim"),
                mutants=(
                    Mutant(name="1.01 times 2 pi", given={"turn": "101/100"}, near=True),
                    Mutant(
                        name="at most 0.9 times 2 pi at the rim",
                        given={"boundary": "9/10"},
                        near=True,
                    ),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="winding of the normals",
                run=_RAM + "normals",
                routes=(
                    "normals of K-surfaces of regular stars",
                    "index of the smooth star",
                ),
                mutants=(
                    Mutant(name="m times", given={"shift": 0}, near=True),
                    Mutant(name="plain saddle too", given={"orders": "all"}),
                ),
            ),
        ),
    ),
)
