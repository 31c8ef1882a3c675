"""Claims of section 4.1, the Poincare disk: metric, distance, isometries, geodesics."""

from checks.claim import Check, Claim, Erratum, Mutant

_DISK = "checks.verify.poincare_disk:"

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
        checks=(
            Check(
                name="vertex by vertex",
                run="checks.verify.net_deformation:composite",
                tier="full",
                routes=(
                    "half-turns of triples of H^2",
                    "discrete.lelieuvre on half-turns of S^2",
                ),
                mutants=(
                    Mutant(name="a net with reversals", given={"folded": True}),
                    Mutant(name="angles 1 % larger", given={"percent": 101}, near=True),
                ),
            ),
            Check(
                name="in the limit",
                run="checks.verify.net_deformation:limit",
                tier="full",
                form="support",
                routes=(
                    "half-turns of triples of H^2",
                    "discrete.lelieuvre on half-turns of S^2",
                ),
                mutants=(Mutant(name="order 1", given={"order": 1}, near=True),),
            ),
        ),
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
        checks=(
            Check(
                name="as printed",
                run=_DISK + "metric",
                routes=(
                    "printed formula",
                    "theory.hyperbolic_plane (hyperboloid seen from (-1, 0, 0))",
                ),
                mutants=(
                    Mutant(name="cube below", given={"power": 3}),
                    Mutant(name="8 above", given={"numerator": 8}),
                ),
            ),
            Check(
                name="with the square",
                run=_DISK + "metric",
                form="corrected",
                given={"power": 2},
                routes=(
                    "printed formula",
                    "theory.hyperbolic_plane (hyperboloid seen from (-1, 0, 0))",
                ),
                mutants=(
                    Mutant(name="cube below", given={"power": 3}),
                    Mutant(name="2 above", given={"numerator": 2, "power": 2}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"$g = \frac{4\,dz\,d\bar z}{1 - |z|^2}$",
            corrected=r"$g = \frac{4\,dz\,d\bar z}{(1 - |z|^2)^2}$",
            kind="misprint",
            witness=(
                r"the printed metric has $K = -\frac{1}{2(1 - |z|^2)}$, which is $-\frac12$ at $z "
                r"= 0$, and its radii have the finite length $\pi$"
            ),
            conclusion_survives=True,
            remark=(
                "The definition of the hyperbolic plane in section 3 has the square, and items "
                "(A) to (C) are those of the metric with the square."
            ),
        ),
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
        checks=(
            Check(
                name="as printed",
                run=_DISK + "distance",
                routes=(
                    "printed formula",
                    "theory.hyperbolic_plane (hyperboloid seen from (-1, 0, 0))",
                ),
                mutants=(
                    Mutant(name="no factor 2", given={"factor": 1}),
                    Mutant(name="plus below", given={"sign": 1}),
                    Mutant(name="factor 3", given={"factor": 3}, near=True),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="as printed",
                run=_DISK + "radius",
                routes=(
                    "printed formula",
                    "arc length of a radius",
                ),
                mutants=(
                    Mutant(name="no factor 2", given={"factor": "1"}),
                    Mutant(name="factor 2.02", given={"factor": "101/50"}, near=True),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="as printed",
                run=_DISK + "isometry",
                tier="full",
                routes=(
                    "printed formula",
                    "metric of the disk, unit vectors",
                ),
                mutants=(
                    Mutant(name="minus below", given={"denominator": -1}),
                    Mutant(name="z0 not conjugated", given={"conjugated": False}),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="as printed",
                run=_DISK + "no_rotation",
                routes=(
                    "printed formula",
                    "rhombus rule after a rotation",
                ),
                mutants=(
                    Mutant(name="minus below", given={"denominator": -1}),
                    Mutant(name="f(0) = -z0", given={"sign": -1}),
                ),
            ),
        ),
    ),
    Claim(
        id="4.1.B-derivative",
        section="4.1",
        where="section 4.1, item (B), line 1159",
        kind="equation",
        statement="$f'(0; z_0) = 1 - |z_0|^2$, which is real and positive.",
        hypotheses=("$|z_0| < 1$",),
        rests_on=("eq:mobius",),
        checks=(
            Check(
                name="as printed",
                run=_DISK + "derivative",
                routes=(
                    "printed formula",
                    "derivative of (eq:mobius)",
                ),
                mutants=(
                    Mutant(name="plus", given={"coefficient": 1}),
                    Mutant(name="2 |z0|^2", given={"coefficient": -2}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="4.1.B-inverse",
        section="4.1",
        where="section 4.1, item (B), line 1159",
        kind="equation",
        statement=r"$f^{-1}(w; z_0) = f(w; -z_0) = \frac{w - z_0}{1 - w \bar z_0}$.",
        hypotheses=("$|z_0| < 1$, $|w| < 1$",),
        rests_on=("eq:mobius",),
        checks=(
            Check(
                name="as printed",
                run=_DISK + "inverse",
                routes=(
                    "printed formula",
                    "composition with (eq:mobius)",
                ),
                mutants=(
                    Mutant(name="plus above", given={"shift": 1}),
                    Mutant(name="plus below", given={"denominator": 1}),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="as printed",
                run=_DISK + "equally_spaced",
                routes=(
                    "printed formula",
                    "discrete.geodesics (hyperboloid, viewed in the disk)",
                ),
                mutants=(
                    Mutant(name="tanh(n Delta)", given={"rate": "1"}),
                    Mutant(name="rate 0.505", given={"rate": "101/200"}, near=True),
                ),
            ),
        ),
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
                    Mutant(name="tanh(n Delta/4)", given={"rate": "1/4"}),
                    Mutant(name="minus below", given={"denominator": -1}),
                    Mutant(name="rate 0.505", given={"rate": "101/200"}, near=True),
                ),
            ),
        ),
    ),
)
