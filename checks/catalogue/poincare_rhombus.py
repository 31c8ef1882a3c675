"""Claims of section 4.1, the rhombus in the Poincare disk."""

from checks.claim import Check, Claim, Erratum, Mutant

_NETS = "checks.verify.poincare_nets:"
_SPACING = r"(used, not stated) $\Delta$ is the distance of neighbouring nodes, as in item (C)"
_RHOMB = r"$d(\zeta_0, \zeta_1) = d(\zeta_0, \zeta_2)$: the two known sides are equal"

CLAIMS: tuple[Claim, ...] = (
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
        checks=(
            Check(
                name="as worded",
                run="checks.verify.net_correspondence:equivalence",
                routes=(
                    "angles of rhombi of S^2 and H^2 (half-turns)",
                    "edges N_1 x N_0, -N_2 x N_0 in space",
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
        checks=(
            Check(
                name="as printed",
                run=_NETS + "first_node",
                part="first node",
                routes=(
                    "printed formula",
                    "(eq:hyp_radius) at the first node of an axis",
                ),
                mutants=(Mutant(name="tanh(Delta)", given={"side": "tanh(Delta)"}),),
            ),
            Check(
                name="corrected",
                run=_NETS + "first_node",
                form="corrected",
                given={"side": "Delta"},
                part="first node",
                routes=(
                    "printed formula",
                    "(eq:hyp_radius) at the first node of an axis",
                ),
                mutants=(
                    Mutant(name="tanh(Delta)", given={"side": "tanh(Delta)"}),
                    Mutant(name="1.01 Delta", given={"side": "101/100 Delta"}, near=True),
                ),
            ),
            Check(
                name="with the printed w_j",
                run=_NETS + "known_sides",
                part="beside w_j",
                routes=(
                    "printed formula",
                    "(eq:hyp_radius)",
                ),
                mutants=(Mutant(name="tanh(Delta)", given={"side": "tanh(Delta)"}),),
            ),
            Check(
                name="with the corrected w_j",
                run=_NETS + "known_sides",
                form="corrected",
                given={"side": "Delta", "modulus": "tanh(Delta/2)"},
                part="beside w_j",
                routes=(
                    "printed formula",
                    "(eq:hyp_radius)",
                ),
                mutants=(
                    Mutant(
                        name="1.01 Delta",
                        given={"side": "101/100 Delta", "modulus": "tanh(Delta/2)"},
                        near=True,
                    ),
                    Mutant(name="w_j as printed", given={"side": "Delta", "modulus": "Delta/2"}),
                ),
            ),
            Check(
                name="artanh for tanh",
                run=_NETS + "known_sides",
                form="support",
                given={"side": "2 artanh(Delta/2)"},
                routes=(
                    "printed formula",
                    "(eq:hyp_radius)",
                ),
                mutants=(
                    Mutant(name="tanh(Delta)", given={"side": "tanh(Delta)"}),
                    Mutant(name="1.01 Delta", given={"side": "101/100 Delta"}, near=True),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"$d(\zeta_0, \zeta_1) = d(\zeta_0, \zeta_2) = 2\tanh\frac{\Delta}{2}$",
            corrected=(
                r"$d(\zeta_0, \zeta_1) = d(\zeta_0, \zeta_2) = \Delta$, with $|w_1| = |w_2| = "
                r"\tanh\frac{\Delta}{2}$"
            ),
            kind="misprint",
            witness=(
                r"for $\Delta = 1$ the nodes $0$ and $\tanh\frac12$ of an axis are at the "
                r"distance $2\operatorname{artanh}\tanh\frac12 = 1$, not $2\tanh\frac12 = 0.924$; "
                r"and $|w_1| = \frac12$ means the distance $\log 3 = 1.099$"
            ),
            conclusion_survives=True,
            remark=(
                "One slip at three places, the sides known and sought and the display of the "
                "$w_j$: each counts. "
                r"With artanh for tanh the side would fit $|w_j| = \frac{\Delta}{2}$, but "
                r"$\Delta$ would then not be the spacing of item (C) and of the boundary data "
                r"$\tanh\frac{j\Delta}{2}$. The formula for $w_{12}$ holds whatever the common "
                r"length. All readings agree to first order in $\Delta$."
            ),
        ),
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
        checks=(
            Check(
                name="as printed",
                run=_NETS + "normalised",
                routes=(
                    "printed formula",
                    "(eq:mobius) applied to item (C)",
                ),
                mutants=(Mutant(name="tanh(Delta)", given={"modulus": "tanh(Delta)"}),),
            ),
            Check(
                name="corrected",
                run=_NETS + "normalised",
                tier="full",
                form="corrected",
                given={"modulus": "tanh(Delta/2)"},
                routes=(
                    "printed formula",
                    "(eq:mobius) applied to item (C)",
                ),
                mutants=(
                    Mutant(name="tanh(Delta)", given={"modulus": "tanh(Delta)"}),
                    Mutant(
                        name="1.01 tanh(Delta/2)",
                        given={"modulus": "101/100 tanh(Delta/2)"},
                        near=True,
                    ),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"$w_1 = \frac{\Delta}{2} e^{i\beta_1}$, $w_2 = \frac{\Delta}{2} e^{i\beta_2}$",
            corrected=r"$w_j = \tanh\frac{\Delta}{2}\, e^{i\beta_j}$",
            kind="misprint",
            witness=(
                r"$\zeta_0 = 0$, $\zeta_1 = \tanh\frac{\Delta}{2}$, the first nodes of the "
                r"example, give $w_1 = \tanh\frac{\Delta}{2}$: $0.462$ for $\Delta = 1$, not "
                r"$\frac12$; for $\Delta = 2$ the printed $w_1$ is not in the disk"
            ),
            conclusion_survives=True,
            remark=(
                "The slip that counts at the known sides and at the fourth vertex as well. "
                r"Equal to first order in $\Delta$. Read with $\frac{\Delta}{2}$ as Euclidean "
                r"length this display is right with the side $2\operatorname{artanh}"
                r"\frac{\Delta}{2}$, see the claim on the sides; but the paper calls $\Delta$ the "
                "side-length of the rhombi."
            ),
        ),
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
        checks=(
            Check(
                name="as printed",
                run=_NETS + "closing_lengths",
                routes=(
                    "printed formula",
                    "item (A) at the fourth vertex",
                ),
                mutants=(Mutant(name="tanh(Delta)", given={"side": "tanh(Delta)"}),),
            ),
            Check(
                name="corrected",
                run=_NETS + "closing_lengths",
                form="corrected",
                given={"side": "Delta", "modulus": "tanh(Delta/2)"},
                routes=(
                    "printed formula",
                    "item (A) at the fourth vertex",
                ),
                mutants=(
                    Mutant(
                        name="1.01 Delta",
                        given={"side": "101/100 Delta", "modulus": "tanh(Delta/2)"},
                        near=True,
                    ),
                    Mutant(
                        name="1 - |w_1 w_2|",
                        given={"side": "Delta", "modulus": "tanh(Delta/2)", "sign": -1},
                    ),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"$d(w_{12}, w_1) = d(w_{12}, w_2) = 2\tanh\frac{\Delta}{2}$",
            corrected=(
                r"$d(w_{12}, w_1) = d(w_{12}, w_2) = \Delta = d(0, w_1)$, and $w_{12} \neq 0$"
            ),
            kind="misprint",
            witness=(
                r"$\Delta = 1$, $w_1 = \frac12$, $w_2 = \frac{i}{2}$ as printed: $w_{12} = "
                r"\frac{2(1+i)}{5}$ of (poincare-ddg) has $\cosh d(w_{12}, w_1) = \frac53$, $d = "
                r"\log 3 = 1.099$, not $2\tanh\frac12 = 0.924$"
            ),
            conclusion_survives=True,
            remark=(
                "The slip that counts at the known sides and at the $w_j$ as well: what fixes the "
                "fourth vertex is that all four sides are equal."
            ),
        ),
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
        checks=(
            Check(
                name="as printed",
                run=_NETS + "rule",
                tier="full",
                routes=(
                    "printed formula",
                    "discrete.quad_rule (half-turn of the hyperboloid)",
                ),
                mutants=(
                    Mutant(name="1 - |w1 w2|", given={"sign": -1}),
                    Mutant(name="1 + 1.01 |w1 w2|", given={"weight": "101/100"}, near=True),
                    Mutant(name="back by f(.; -zeta_0)", given={"back": -1}),
                    Mutant(name="unequal sides", given={"rhombus": False}),
                ),
            ),
            Check(
                name="shipped half-turn",
                run="checks.verify.quad_rule:closes",
                form="support",
                routes=(
                    "discrete.quad_rule.close_quad on symbols",
                    "products of opposite sides",
                ),
                mutants=(
                    Mutant(name="plus p", given={"rule": "plus p"}),
                    Mutant(name="factor 1", given={"rule": "no factor 2"}),
                    Mutant(name="factor 2.02", given={"rule": "factor 101/50"}, near=True),
                    Mutant(name="plain midpoint", given={"rule": "plain midpoint"}),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="as printed",
                run=_NETS + "either_diagonal",
                tier="full",
                routes=(
                    "rule from zeta_0",
                    "rule from the other vertices",
                ),
                mutants=(
                    Mutant(name="1 - |w1 w2|", given={"sign": -1}),
                    Mutant(name="a side for a diagonal", given={"swapped": True}),
                ),
            ),
        ),
    ),
)
