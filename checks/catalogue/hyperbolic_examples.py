"""Claims of section 4.1, the Amsler net in the disk, its reversals and its first cuts."""

from checks.claim import Claim

_FINE = r"(used, not stated) $\Delta$ is small; no value is printed"
_EXAMPLE = r"$\varphi_0 = \pi/2$, $R = 3$, $\phi^* = 3\pi/4$"

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="4.1.amsler-axes-geodesic",
        section="4.1",
        where="section 4.1, line 1198",
        kind="sentence",
        statement=(
            "The straight asymptotic lines of an Amsler surface are geodesics of "
            r"$\mathbb{R}^3$, hence the curves that correspond to them in the disk are geodesics "
            r"of $\mathbb{H}^2$."
        ),
        rests_on=("def:amsler-sector", "4.1.deformation-composite"),
    ),
    Claim(
        id="4.1.amsler-data",
        section="4.1",
        where="section 4.1, line 1198",
        kind="equation",
        statement=(
            r"The boundary data of the Amsler net with $\varphi = \pi/2$ are $\zeta_{j,0} = "
            r"\tanh\frac{j\Delta}{2}$, $\zeta_{0,k} = i\tanh\frac{k\Delta}{2}$, and "
            r"(poincare-ddg) gives all other $\zeta_{j,k}$."
        ),
        hypotheses=(
            r"the rhombi have sides $\Delta$",
            r"the two straight lines meet at $z = 0$ at the angle $\pi/2$",
        ),
        rests_on=("geodesics", "poincare-ddg", "4.1.amsler-axes-geodesic"),
    ),
    Claim(
        id="fig:geodesicballs",
        section="4.1",
        where="figure (fig:geodesicballs) and lines 1188, 1205",
        kind="figure",
        statement=(
            r"The Amsler net with $\varphi_0 = \pi/2$ up to the contour $\varphi = \pi$, "
            r"coloured by $\varphi$ with circles of constant distance from the origin: by the "
            "caption (a) over the asymptotic coordinates and (b) in the disk, by the text (a) "
            "in the disk and (b) over the indices."
        ),
        labels=("fig:geodesicballs", "fig:poincaregeodesics", "fig:amslergeodesics"),
        hypotheses=(_FINE,),
        rests_on=("4.1.amsler-data", "eq:angle", "eq:hyp_radius"),
    ),
    Claim(
        id="4.1.disk-radius-1",
        section="4.1",
        where="section 4.1, line 1205",
        kind="number",
        statement=(
            r"The Amsler surface with angle $\pi/2$ contains a smoothly immersed geodesic disk "
            "of radius $1$."
        ),
        hypotheses=(
            (
                "(used, not stated) the disk is centred where the straight lines meet, and all "
                r"four sectors have the angle $\pi/2$"
            ),
        ),
        rests_on=("PIII", "eq:metrics", "4.1.geodesic-radii"),
    ),
    Claim(
        id="4.1.disk-radius-1.5",
        section="4.1",
        where="section 4.1, line 1205",
        kind="number",
        statement=(
            r"The Amsler surface with angle $\pi/2$ contains no smoothly immersed geodesic disk "
            "of radius $1.5$."
        ),
        hypotheses=("(used, not stated) the disk is centred where the straight lines meet",),
        rests_on=("PIII", "eq:metrics", "4.1.geodesic-radii"),
    ),
    Claim(
        id="4.1.geodesic-radii",
        section="4.1",
        where="section 4.1, line 1205",
        kind="sentence",
        statement=(
            "The distance of a node of the surface from the origin is "
            r"$2\operatorname{artanh}|\zeta_{j,k}|$, with no arc length to integrate and no "
            "eikonal equation to solve."
        ),
        hypotheses=(
            (
                "(used, not stated) the geodesic from the origin to the node stays in the part "
                "of the disk that the net covers without a fold"
            ),
        ),
        rests_on=("eq:hyp_radius", "4.1.deformation-composite"),
    ),
    Claim(
        id="fig:amslerspace",
        section="4.1",
        where="figure (fig:amslerspace), lines 1205-1211",
        kind="figure",
        statement=(
            r"The $K$-surface of the Amsler net with $\varphi_0 = \pi/2$, continued beyond its "
            "first singular edge."
        ),
        labels=("fig:amslerspace",),
        hypotheses=(_FINE, "(used, not stated) the extent of the net is not given"),
        rests_on=("4.1.amsler-data", "4.1.planar-stars"),
    ),
    Claim(
        id="4.1.several-singular-edges",
        section="4.1",
        where="section 4.1, line 1205",
        kind="sentence",
        statement=(
            r"The Amsler surface with $\varphi_0 = \pi/2$ has several singular edges, each of "
            "them a cuspidal edge."
        ),
        hypotheses=(
            (
                r"(used, not stated) the continuation reaches far enough: $\varphi(z)$ crosses "
                r"$\pi$ again and again"
            ),
        ),
        rests_on=("PIII", "fig:amslerspace"),
    ),
    Claim(
        id="4.1.three-reversals",
        section="4.1",
        where="section 4.1, line 1221",
        kind="number",
        statement=(
            "The net of the Amsler surface shown has three reversals: a diagonal of the quadrant "
            "meets three curves of reversals."
        ),
        hypotheses=(
            (
                "(used, not stated) the extent of the net, which is not given: the number of "
                r"crossings of $\pi$ grows with it"
            ),
            _FINE,
        ),
        rests_on=("reversal", "fig:amslerspace"),
    ),
    Claim(
        id="fig:poincaresurgery",
        section="4.1",
        where="figure (fig:poincaresurgery), lines 1242-1246",
        kind="figure",
        statement=(
            r"Surgery in the disk: (a) the Amsler net with angle $\pi/2$ continued beyond the "
            "singular edge, (b) the net cropped, (c) the glued net with one branch point per "
            "quadrant, of class $C^{1,1}$."
        ),
        labels=(
            "fig:poincaresurgery",
            "fig:poincaresmooth",
            "fig:poincarecropped",
            "fig:poincareglued",
        ),
        hypotheses=(r"(used, not stated) extent, $R$ and $\phi^*$ are not given in the caption",),
        rests_on=("4.1.amsler-data", "eq:poincare-surgery"),
    ),
    Claim(
        id="4.1.net-folds-back",
        section="4.1",
        where="section 4.1, lines 1242 and 1246",
        kind="sentence",
        statement=(
            r"Beyond the singular edge the Amsler net with angle $\pi/2$ folds back on itself: "
            "points of the disk near the edge are covered more than once, and nowhere before "
            "the edge."
        ),
        hypotheses=(_FINE,),
        rests_on=("fig:poincaresurgery", "4.1.reversal-singular-edge"),
    ),
    Claim(
        id="fig:shapeprocedure2",
        section="4.1",
        where="figure (fig:shapeprocedure2), lines 1250-1275",
        kind="figure",
        statement=(
            "The steps of a cut for $R = 3$: (a) complex of stage $n$ with Amsler data on the "
            "axes, (b) filled net with the first cut location $(u^*, v^*)$, (c) complex of stage "
            "$n + 1$ with two new curves from the branch point, (d) a filled sector whose angle "
            "varies along the $v$-axis; circles of constant radius at steps of $0.5$."
        ),
        labels=(
            "fig:shapeprocedure2",
            "fig:TCD_schematic_stage1",
            "fig:amslercutschematic",
            "fig:TCD_schematic_stage2",
            "fig:pseudoamslercutschematic",
        ),
        hypotheses=(_EXAMPLE, _FINE),
        rests_on=("alg:greedy-cuts", "4.1.amsler-data"),
    ),
    Claim(
        id="4.1.pseudo-amsler-axis",
        section="4.1",
        where="caption of figure (fig:shapeprocedure2), line 1273",
        kind="sentence",
        statement=(
            r"In the sector of panel (d) the angle $\varphi$ is not constant along the $v$-axis: "
            "that axis is not a geodesic."
        ),
        hypotheses=(_EXAMPLE,),
        rests_on=("fig:shapeprocedure2", "def:amsler-sector"),
    ),
    Claim(
        id="4.1.cut-location",
        section="4.1",
        where="section 4.1, line 1277",
        kind="sentence",
        statement=(
            r"The region $u \geq u^*$, $v \geq v^*$ is cut out, where the contour $\varphi(u, v) "
            r"= \phi^*$ meets the circle of radius $R$ at $u = u^*$ and at $v = v^*$."
        ),
        hypotheses=(
            _EXAMPLE,
            (
                "(used, not stated) contour and circle meet twice in the quadrant: $u^*$ is the "
                "smaller $u$ and $v^*$ the smaller $v$"
            ),
        ),
        rests_on=("4.1.amsler-data", "eq:angle"),
    ),
    Claim(
        id="4.1.cut-angle",
        section="4.1",
        where="section 4.1, line 1277",
        kind="sentence",
        statement=r"At the cut location $\varphi(u^*, v^*) < \phi^* < \pi$.",
        hypotheses=(_EXAMPLE,),
        rests_on=("4.1.cut-location",),
    ),
    Claim(
        id="4.1.cut-radius",
        section="4.1",
        where="section 4.1, line 1277",
        kind="number",
        statement=(
            "The cut location is at distance less than $0.5$ from the origin: much nearer than "
            "the singular edge of the uncut surface."
        ),
        hypotheses=(_EXAMPLE,),
        rests_on=("4.1.cut-location", "eq:hyp_radius"),
    ),
    Claim(
        id="4.1.two-new-curves",
        section="4.1",
        where="section 4.1, line 1279",
        kind="sentence",
        statement=(
            "Three sectors in place of the one removed need two more asymptotic curves through "
            r"the branch point, with free data: any choice of nodes at distance $\Delta$ gives a "
            "net."
        ),
        hypotheses=(
            (
                "(used, not stated) the two new curves start inside the removed angle, which "
                r"they divide in three parts below $\pi$"
            ),
        ),
        rests_on=("eq:poincare-surgery", "4.1.inherited-topology"),
    ),
    Claim(
        id="4.1.three-equal-angles",
        section="4.1",
        where="section 4.1, line 1279",
        kind="sentence",
        statement=(
            "The three new sectors have at the branch point the same angle, a third of the angle "
            "of the sector removed."
        ),
        rests_on=("eq:trisect", "eq:poincare-surgery", "eq:angle"),
    ),
    Claim(
        id="4.1.four-branch-points",
        section="4.1",
        where="section 4.1, lines 1289-1290",
        kind="number",
        statement=(
            "A cut in each of the four quadrants of the Amsler net gives a Chebyshev net with "
            "just four branch points, one to a quadrant, each of degree $6$."
        ),
        hypotheses=(
            r"four sectors of angle $\pi/2$",
            "(used, not stated) one cut per quadrant: second generation not yet added",
        ),
        rests_on=("4.1.cut-location", "eq:poincare-surgery", "4.1.branch-point-degree"),
    ),
    Claim(
        id="4.1.surgery-in-disk",
        section="4.1",
        where="section 4.1, line 1291",
        kind="sentence",
        statement=(
            "The cut with (eq:trisect) and (eq:poincare-surgery) is the surgery of section 3.4: "
            "the resulting complex is that of the surgery lemma."
        ),
        hypotheses=(
            (
                "(used, not stated) section 3.4 trisects only approximately: the combinatorics "
                "agree, the new directions differ"
            ),
        ),
        rests_on=("lem:surgery", "4.1.four-branch-points"),
    ),
    Claim(
        id="4.1.second-generation-meets-circle",
        section="4.1",
        where="section 4.1, line 1297",
        kind="sentence",
        statement=(
            "In a sector of the second generation at $(u^*, v^*)$ the singular edge comes again "
            "within the circle $R = 3$, so that a further cut is needed."
        ),
        hypotheses=(
            _EXAMPLE,
            (
                "(used, not stated) the sector is one of the two beside the middle one, as in "
                "panel (d)"
            ),
        ),
        rests_on=("4.1.cut-location", "eq:poincare-surgery"),
    ),
    Claim(
        id="4.1.second-cut-radius",
        section="4.1",
        where="section 4.1, line 1297",
        kind="number",
        statement=(
            "The branch point of the second generation is at distance about $1.5$ from the origin."
        ),
        hypotheses=(
            _EXAMPLE,
            "(used, not stated) the sector is that of panel (d), beside the middle one",
            _FINE,
        ),
        rests_on=("4.1.second-generation-meets-circle", "eq:hyp_radius"),
    ),
    Claim(
        id="4.1.two-generations-cover-more",
        section="4.1",
        where="section 4.1, line 1297",
        kind="sentence",
        statement=(
            r"The sectors of the first two generations together cover more of the disk $R \leq "
            r"3$ than those of the first, with $\varphi \leq \phi^*$ on all of them."
        ),
        hypotheses=(_EXAMPLE, "(used, not stated) after the second cuts have been made"),
        rests_on=("4.1.second-cut-radius", "4.1.cut-angle"),
    ),
)
