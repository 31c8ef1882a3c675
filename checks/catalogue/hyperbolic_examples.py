"""Claims of section 4.1, the Amsler net in the disk, its reversals and its first cuts."""

from checks.claim import Check, Claim, Erratum, Mutant

_FINE = r"(used, not stated) $\Delta$ is small; no value is printed"
_EXAMPLE = r"$\varphi_0 = \pi/2$, $R = 3$, $\phi^* = 3\pi/4$"

_BALLS = "checks.verify.amsler_balls:"
_FOLDS = "checks.verify.amsler_folds:"
_CUTS = "checks.verify.amsler_cuts:"
_SECOND = "checks.verify.second_generation:"
_SURGERY = "checks.verify.disk_surgery:"

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
        checks=(
            Check(
                name="straight axes",
                run=_BALLS + "axes",
                routes=(
                    "Christoffel symbols of the metric",
                    "geodesic curvature of the metric",
                ),
                mutants=(Mutant(name="angle not constant on the axes", given={"on_axis": "any"}),),
            ),
        ),
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
        checks=(
            Check(
                name="printed data",
                run=_FOLDS + "boundary",
                routes=(
                    "printed nodes of the axes",
                    "products of triples and half-turns",
                ),
                mutants=(
                    Mutant(name="rate 1 for 1/2", given={"rate": "1"}),
                    Mutant(name="rate 1 % larger", given={"rate": "101/200"}, near=True),
                    Mutant(name="second axis opposite to the first", given={"quarter_turns": 2}),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="panels, as printed",
                run=_BALLS + "panels",
                part="panels",
                routes=(
                    "caption",
                    "text that cites the panels",
                ),
                mutants=(Mutant(name="none of the panels", given={"caption": "none"}),),
            ),
            Check(
                name="panels exchanged",
                run=_BALLS + "panels",
                form="corrected",
                given={"caption": "exchanged"},
                part="panels",
                routes=(
                    "caption",
                    "text that cites the panels",
                ),
                mutants=(Mutant(name="as printed", given={"caption": "as printed"}),),
            ),
            Check(
                name="contour of the net",
                run=_FOLDS + "edge_on_mirror",
                part="contour",
                routes=(
                    "printed net in the disk",
                    "equation of Painleve",
                ),
                mutants=(
                    Mutant(name="first order", given={"expected": 1}),
                    Mutant(name="contour 99/100 pi", given={"level": "99/100"}, near=True),
                ),
            ),
        ),
        erratum=Erratum(
            printed=("Caption: (a) in asymptotic coordinates, (b) in the disk."),
            corrected=(
                "(a) in the disk, (b) in asymptotic coordinates, as the text (line 1205) and "
                "the labels of the panels have it; or the panels are exchanged."
            ),
            kind="misprint",
            witness=(
                "Panel (a) is labelled poincaregeodesics, and line 1205 says that it shows the "
                "nodes of the net in the disk; the caption says that it shows asymptotic "
                "coordinates."
            ),
            conclusion_survives=True,
        ),
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
        checks=(
            Check(
                name="disk inside the edge",
                run=_BALLS + "smooth_disk",
                routes=(
                    "certified values of PIII and comparison of lengths",
                    "reference values of PIII (mpmath)",
                ),
                mutants=(
                    Mutant(name="radius 1.27", given={"radius": "127/100"}, near=True),
                    Mutant(name="radius 1.5", given={"radius": "3/2"}),
                ),
            ),
        ),
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
        hypotheses=("the disk may be centred at any point",),
        rests_on=("PIII", "eq:metrics", "4.1.geodesic-radii"),
        checks=(
            Check(
                name="disk past the edge",
                run=_BALLS + "smooth_disk_refused",
                routes=(
                    "certified values of PIII and comparison of lengths",
                    "reference values of PIII (mpmath)",
                ),
                mutants=(
                    Mutant(name="radius 1.26", given={"radius": "126/100"}, near=True),
                    Mutant(name="radius 1", given={"radius": "1"}),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="against arc length",
                run=_FOLDS + "radii",
                tier="full",
                routes=(
                    "printed distance of nodes",
                    "geodesics of the surface by Runge-Kutta",
                ),
                mutants=(
                    Mutant(name="first order", given={"expected": 1}),
                    Mutant(name="factor 2.02", given={"factor": "101/50"}, near=True),
                ),
            ),
            Check(
                name="edge seen from the crossing",
                run=_FOLDS + "visible",
                tier="full",
                form="support",
                routes=(
                    "bearings by frames",
                    "place of the edge by PIII",
                ),
                mutants=(Mutant(name="second edge", given={"edge": 2}, near=True),),
            ),
        ),
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
        checks=(
            Check(
                name="two K-surfaces",
                run=_FOLDS + "two_surfaces",
                tier="full",
                part="surface",
                routes=(
                    "Lelieuvre formulas from normals",
                    "planar stars from the hyperbolic net",
                ),
                mutants=(
                    Mutant(name="corner 1 % larger", given={"swap": True}, near=True),
                    Mutant(name="ends before the third edge", given={"extent": "4"}),
                ),
            ),
            Check(
                name="against the front",
                run=_FOLDS + "surface",
                tier="full",
                part="continuation",
                routes=(
                    "K-surface",
                    "Moutard equation and Lelieuvre integrals (theory)",
                ),
                mutants=(
                    Mutant(name="first order", given={"expected": 1}),
                    Mutant(name="axes 1/100 off a right angle", given={"tilt": "1/100"}, near=True),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="changes of sign",
                run=_BALLS + "singular_edges",
                part="number",
                routes=(
                    "certified angles of PIII",
                    "the level pi",
                ),
                mutants=(
                    Mutant(name="level 2 pi", given={"level": "2"}),
                    Mutant(name="level 1.4 pi", given={"level": "7/5"}),
                ),
            ),
            Check(
                name="cuspidal",
                run=_BALLS + "cuspidal",
                part="cuspidal",
                routes=(
                    "Gauss-Weingarten equations",
                    "criterion of Kokubu, Rossman, Saji, Umehara, Yamada",
                ),
                mutants=(
                    Mutant(name="twice the rate", given={"rate": 2}),
                    Mutant(name="other direction", given={"direction": -1}),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="count against extent",
                run=_FOLDS + "three_curves",
                tier="full",
                routes=(
                    "(reversal) on printed nets",
                    "zeros of phi - pi",
                ),
                mutants=(
                    Mutant(name="one curve", given={"count": 1}),
                    Mutant(name="edges 2 % farther", given={"spacing": "102/100"}, near=True),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="panel (a)",
                run=_FOLDS + "folds_back",
                tier="full",
                part="a",
                routes=(
                    "quads of the net in the Klein model",
                    "edge by PIII",
                ),
                mutants=(
                    Mutant(name="twice as far before the edge", given={"before": "2"}),
                    Mutant(name="net ends at the edge", given={"past": False}),
                    Mutant(name="three sheets", given={"sheets": 3}, near=True),
                ),
            ),
            Check(
                name="panels (b) and (c)",
                run=_SURGERY + "branch_points",
                tier="full",
                part="c",
                routes=(
                    "complex of the cut net",
                    "surgery on a grid of squares (theory)",
                ),
                mutants=(
                    Mutant(name="three cuts", given={"cuts": 3}, near=True),
                    Mutant(name="degree 8", given={"degree": 8}),
                ),
            ),
            Check(
                name="class of the glued surface",
                run=_SECOND + "bounded_curvature",
                tier="full",
                part="class",
                routes=(
                    "angles of the sectors on three nets",
                    "fit of the K-surface along the seams",
                ),
                mutants=(
                    Mutant(name="as far as the edge", given={"reach": "2"}),
                    Mutant(name="no growth at all", given={"growth": "1/100000"}, near=True),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="quads over points",
                run=_FOLDS + "folds_back",
                tier="full",
                routes=(
                    "quads of the net in the Klein model",
                    "edge by PIII",
                ),
                mutants=(
                    Mutant(name="twice as far before the edge", given={"before": "2"}),
                    Mutant(name="net ends at the edge", given={"past": False}),
                    Mutant(name="three sheets", given={"sheets": 3}, near=True),
                ),
            ),
            Check(
                name="edge seen from the crossing",
                run=_FOLDS + "visible",
                tier="full",
                form="support",
                routes=(
                    "bearings by frames",
                    "place of the edge by PIII",
                ),
                mutants=(Mutant(name="second edge", given={"edge": 2}, near=True),),
            ),
        ),
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
        checks=(
            Check(
                name="first cut of panel (b)",
                run=_CUTS + "location_by_net",
                tier="full",
                part="b",
                routes=(
                    "net by angles and frames",
                    "continuum on the hyperboloid",
                ),
                mutants=(
                    Mutant(name="first order", given={"expected": 1}),
                    Mutant(name="level 0.74 pi", given={"level": "37/50"}, near=True),
                ),
            ),
            Check(
                name="complex of panel (c)",
                run=_SURGERY + "surgery_lemma",
                tier="full",
                part="c",
                routes=(
                    "complex of the cut net",
                    "rectangles attached at a corner",
                ),
                mutants=(
                    Mutant(name="four new rays", given={"rays": 4}),
                    Mutant(name="rays one edge longer", given={"length": 4}, near=True),
                ),
            ),
            Check(
                name="sector of panel (d)",
                run=_SECOND + "pseudo_axis",
                part="d",
                routes=(
                    "slope on the shared edge by Gauss-Weingarten",
                    "PIII in balls",
                ),
                mutants=(
                    Mutant(name="angle half as large again", given={"start": "3/2"}),
                    Mutant(name="slope of the other sign", given={"orientation": -1}),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="slope on the shared axis",
                run=_SECOND + "pseudo_axis",
                routes=(
                    "slope on the shared edge by Gauss-Weingarten",
                    "PIII in balls",
                ),
                mutants=(
                    Mutant(name="angle half as large again", given={"start": "3/2"}),
                    Mutant(name="slope of the other sign", given={"orientation": -1}),
                ),
            ),
            Check(
                name="by the net",
                run=_SECOND + "pseudo_axis_by_net",
                tier="full",
                form="support",
                routes=(
                    "angles of the net",
                    "PIII in float64",
                ),
                mutants=(
                    Mutant(name="the other axis", given={"axis": "new"}),
                    Mutant(name="2 % more", given={"factor": "102/100"}, near=True),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="contour meets circle",
                run=_CUTS + "location",
                part="where",
                routes=(
                    "certified PIII",
                    "bounds of the distance by paths",
                ),
                mutants=(
                    Mutant(name="R = 1.08", given={"radius": "27/25"}, near=True),
                    Mutant(name="R = 1", given={"radius": "1"}),
                ),
            ),
            Check(
                name="rest of the disk",
                run=_CUTS + "kept_below",
                tier="full",
                part="what is left",
                routes=(
                    "rim of the continuum",
                    "contour by PIII",
                ),
                mutants=(
                    Mutant(name="cut 1 % nearer", given={"share": "99/100"}, near=True),
                    Mutant(name="cut 10 % farther", given={"share": "11/10"}),
                ),
            ),
            Check(
                name="by the net",
                run=_CUTS + "location_by_net",
                tier="full",
                form="support",
                part="where",
                routes=(
                    "net by angles and frames",
                    "continuum on the hyperboloid",
                ),
                mutants=(
                    Mutant(name="first order", given={"expected": 1}),
                    Mutant(name="level 0.74 pi", given={"level": "37/50"}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="4.1.cut-angle",
        section="4.1",
        where="section 4.1, line 1277",
        kind="sentence",
        statement=r"At the cut location $\varphi(u^*, v^*) < \phi^* < \pi$.",
        hypotheses=(_EXAMPLE,),
        rests_on=("4.1.cut-location",),
        checks=(
            Check(
                name="angle at the cut",
                run=_CUTS + "angle_at_cut",
                routes=(
                    "certified PIII",
                    "bound of u* by distances",
                ),
                mutants=(
                    Mutant(name="phi* = pi/2", given={"level": "1/2"}),
                    Mutant(name="phi* below 0.7 pi", given={"lower": "7/10"}),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="distance of the cut",
                run=_CUTS + "radius_at_cut",
                routes=(
                    "certified PIII",
                    "bound of u* by distances",
                ),
                mutants=(
                    Mutant(name="below 0.42", given={"bound": "42/100"}),
                    Mutant(name="R = 2", given={"radius": "2"}),
                    Mutant(name="a quarter of the edge", given={"inside": "1/4"}),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="random curves",
                run=_SURGERY + "free_curves",
                routes=(
                    "sectors by advance of angles",
                    "(poincare-ddg) and places along the seams",
                ),
                mutants=(
                    Mutant(name="one new curve", given={"rays": 1}, near=True),
                    Mutant(name="edges 1 % longer", given={"stretch": "101/100"}, near=True),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="as printed",
                run=_SURGERY + "three_equal",
                routes=(
                    "printed directions",
                    "thirds of the angle",
                ),
                mutants=(Mutant(name="halves", given={"divisor": 2}),),
            ),
            Check(
                name="sums of arguments",
                run=_SURGERY + "three_equal",
                form="corrected",
                given={"principal": False},
                routes=(
                    "printed directions",
                    "thirds of the angle",
                ),
                mutants=(
                    Mutant(name="principal values", given={"principal": True}),
                    Mutant(name="halves", given={"divisor": 2}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=(
                r"The directions $\frac13\arg(w_2 w_1^2)$, $\frac13\arg(w_2^2 w_1)$ trisect the "
                "removed angle."
            ),
            corrected=(
                r"They do if $\arg$ of a product stands for the sum of the arguments, $2\beta_1 "
                r"+ \beta_2$ and $\beta_1 + 2\beta_2$, not for a value in $(-\pi, \pi]$."
            ),
            kind="ambiguous",
            witness=(
                r"In the example the removed angle is $0.5224\pi$, centred at $\pi/4$: then "
                r"$\arg(w_2^2 w_1)$ is $1.0112\pi$, whose principal value is $-0.9888\pi$, and a "
                r"third of it points $2\pi/3$ away. With $\beta_1 = -\frac{\pi}{100}$, $\beta_2 "
                r"= \frac{51\pi}{100}$ the second direction comes out as $-\frac{33\pi}{100}$ "
                r"instead of $\frac{101\pi}{300}$."
            ),
            conclusion_survives=True,
        ),
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
        checks=(
            Check(
                name="degrees and angle sums",
                run=_SURGERY + "branch_points",
                tier="full",
                routes=(
                    "complex of the cut net",
                    "surgery on a grid of squares (theory)",
                ),
                mutants=(
                    Mutant(name="three cuts", given={"cuts": 3}, near=True),
                    Mutant(name="degree 8", given={"degree": 8}),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="shells about the branch point",
                run=_SURGERY + "surgery_lemma",
                tier="full",
                routes=(
                    "complex of the cut net",
                    "rectangles attached at a corner",
                ),
                mutants=(
                    Mutant(name="four new rays", given={"rays": 4}),
                    Mutant(name="rays one edge longer", given={"length": 4}, near=True),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="edge of the daughter",
                run=_SECOND + "second_meets_circle",
                tier="full",
                routes=(
                    "angles of the daughter",
                    "distances by frames",
                ),
                mutants=(Mutant(name="R = 1.4", given={"radius": "7/5"}, near=True),),
            ),
            Check(
                name="outer sector by two routes",
                run=_SECOND + "two_ways",
                tier="full",
                form="support",
                routes=(
                    "printed formulas in the disk",
                    "advance of angles and frames",
                ),
                mutants=(
                    Mutant(name="principal values in the trisection", given={"principal": True}),
                    Mutant(name="halves", given={"divisor": 2}),
                    Mutant(name="weights 1, 1", given={"weight": 1}, near=True),
                ),
            ),
        ),
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
            "(used, not stated) about: both digits printed are meant, so within 0.05",
            _FINE,
        ),
        rests_on=("4.1.second-generation-meets-circle", "eq:hyp_radius"),
        checks=(
            Check(
                name="second cut",
                run=_SECOND + "second_radius",
                tier="full",
                routes=(
                    "nets by angles and frames",
                    "contour and circle by splines",
                ),
                mutants=(Mutant(name="about 1.4", given={"value": "7/5"}, near=True),),
            ),
            Check(
                name="about 1.6",
                run=_SECOND + "second_radius",
                form="corrected",
                given={"value": "8/5"},
                tier="full",
                routes=(
                    "nets by angles and frames",
                    "contour and circle by splines",
                ),
                mutants=(
                    Mutant(name="middle sector", given={"sector": "middle"}),
                    Mutant(name="about 1.7", given={"value": "17/10"}, near=True),
                    Mutant(name="about 1.5", given={"value": "3/2"}, near=True),
                ),
            ),
            Check(
                name="outer sector by two routes",
                run=_SECOND + "two_ways",
                tier="full",
                form="support",
                routes=(
                    "printed formulas in the disk",
                    "advance of angles and frames",
                ),
                mutants=(
                    Mutant(name="principal values in the trisection", given={"principal": True}),
                    Mutant(name="halves", given={"divisor": 2}),
                    Mutant(name="weights 1, 1", given={"weight": 1}, near=True),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"$R \approx 1.5$",
            corrected=r"$R \approx 1.6$",
            kind="constant",
            witness=(
                "the second cut of the sector beside the middle one lies at $1.6220$ in the limit "
                "$\\Delta \\to 0$, by nets and by the limit (theory.greedy_limit: $1.62203138$)"
            ),
            conclusion_survives=True,
            remark="Of the circles of the figure, 0.5 apart, that of radius 1.5 is the nearest.",
        ),
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
        checks=(
            Check(
                name="areas and angles",
                run=_SECOND + "covered",
                tier="full",
                routes=(
                    "areas of quads by angle defects",
                    "area of the disk",
                ),
                mutants=(
                    Mutant(name="first generation only", given={"generations": 1}),
                    Mutant(name="angles below 2 pi/3", given={"level": "2/3"}),
                    Mutant(name="angles below 0.73 pi", given={"level": "73/100"}, near=True),
                ),
            ),
        ),
    ),
)
