"""Claims of section 3.1 on Amsler sectors and the reduction to Painleve III."""

from checks.claim import Check, Claim, Erratum, Mutant

_V = "checks.verify.amsler:"
_E = "checks.verify.amsler_edges:"
_CORNER = r"(used, not stated) $0 < \phi_0 < \pi$"
_SIGMA = r"(used, not stated) $\sigma = +1$ on the sector"

_DEFINITIONS = (
    Claim(
        id="def:amsler-sector",
        section="3.1",
        where="definition (def:amsler-sector), first sentence, lines 450-453",
        kind="definition",
        statement=(
            r"Amsler sectors are the PS-fronts on the quadrant $[0, \infty)^2$ with both edges "
            r"$r(\cdot, 0)$, $r(0, \cdot)$ straight (geodesics of $\mathbb{R}^3$)."
        ),
        labels=("def:amsler-sector",),
        hypotheses=(
            (
                r"(used, not stated) beyond the first zero of $\sin\varphi$ the front "
                r"goes on without "
                "being an immersion: no sector is immersed on the whole quadrant"
            ),
        ),
        rests_on=("eq:lelieuvre", "3.1.front-existence"),
        checks=(
            Check(
                name="edges",
                run=_V + "amsler_sector",
                routes=("Goursat data of four sectors", "Christoffel symbols of their metric"),
                mutants=(
                    Mutant(name="one straight edge enough", given={"straight_edges": 1}),
                    Mutant(name="no straight edge needed", given={"straight_edges": 0}),
                ),
            ),
            Check(
                name="edge from its normal",
                run=_E + "edge_by_normal",
                routes=("Lelieuvre integral of a circle of the sphere", "second derivative"),
                mutants=(Mutant(name="small circle", given={"height": 3}),),
            ),
        ),
    ),
    Claim(
        id="3.1.amsler-pseudo-sector",
        section="3.1",
        where="definition (def:amsler-sector), second sentence, lines 450-453",
        kind="definition",
        statement=(
            r"Pseudo-Amsler sectors are the PS-fronts on $[0, u_0) \times [0, v_0)$ with one edge, "
            r"$r(\cdot, 0)$ or $r(0, \cdot)$, straight."
        ),
        hypotheses=(r"(used, not stated) one edge at least: a part of an Amsler sector counts",),
        rests_on=("eq:lelieuvre", "3.1.front-existence"),
        checks=(
            Check(
                name="edges",
                run=_V + "pseudo_amsler_sector",
                routes=("Goursat data of four sectors", "Christoffel symbols of their metric"),
                mutants=(
                    Mutant(name="both edges straight", given={"straight_edges": 2}),
                    Mutant(name="no straight edge needed", given={"straight_edges": 0}),
                ),
            ),
        ),
    ),
)

_REDUCTION = (
    Claim(
        id="3.1.amsler-construction",
        section="3.1",
        where="section 3.1, line 455",
        kind="sentence",
        statement=(
            r"The solution of $\varphi_{uv} = \sin\varphi$ on $u, v \ge 0$ with $\varphi(u, 0) = "
            r"\varphi(0, v) = \phi_0$ gives an Amsler sector."
        ),
        hypotheses=(_CORNER, _SIGMA),
        rests_on=("def:amsler-sector", "eq:sg", "eq:metrics"),
        checks=(
            Check(
                name="curvature and edges",
                run=_V + "construction",
                routes=("Riemann tensor of the metric", "Christoffel symbols on the axes"),
                mutants=(
                    Mutant(name="opposite sign", given={"sign": -1}),
                    Mutant(name="angle not constant on the u-axis", given={"tilt_u": 1}),
                    Mutant(name="angle not constant on the v-axis", given={"tilt_v": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.amsler-self-similar",
        section="3.1",
        where="section 3.1, line 455",
        kind="sentence",
        statement=r"These solutions have the form $\varphi(u, v) = \varphi(z)$, $z = 2\sqrt{uv}$.",
        hypotheses=(
            (
                r"(used, not stated) the Goursat problem has one solution, so that it shares the "
                r"symmetry $(u, v) \mapsto (cu, v/c)$ of its data"
            ),
        ),
        rests_on=("3.1.amsler-construction",),
        checks=(
            Check(
                name="symmetry and series",
                run=_V + "self_similar",
                routes=("double Taylor series by Picard iteration", "the scaling symmetry of z"),
                mutants=(
                    Mutant(name="u v^2 for u v", given={"power_v": 2}),
                    Mutant(name="u + v for u v", given={"combination": "sum"}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.amsler-operator",
        section="3.1",
        where="section 3.1, line 456",
        kind="equation",
        statement=(
            r"On functions of $z = 2\sqrt{uv}$: $\partial_{uv} = \frac{1}{z}\partial_z + "
            r"\partial_z^2$."
        ),
        hypotheses=(r"$u, v > 0$",),
        checks=(
            Check(
                name="chain rule",
                run=_V + "operator",
                routes=("the printed operator", "chain rule on an unknown function"),
                mutants=(
                    Mutant(name="2/z for 1/z", given={"first": 2}),
                    Mutant(name="two second derivatives", given={"second": 2}),
                    Mutant(name="z = sqrt(u v)", given={"scale": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="PIII",
        section="3.1",
        where="equation (PIII), lines 457-460",
        kind="equation",
        statement=(
            r"On functions of $z$, $\varphi_{uv} = \sin\varphi$ becomes $\varphi''(z) + "
            r"\varphi'(z)/z - \sin\varphi(z) = 0$."
        ),
        labels=("PIII",),
        hypotheses=(_SIGMA, r"$\varphi$ is a function of $z = 2\sqrt{uv}$ alone"),
        rests_on=("3.1.amsler-self-similar", "3.1.amsler-operator"),
        checks=(
            Check(
                name="chain rule",
                run=_V + "reduction",
                routes=("the printed equation", "chain rule on the sine-Gordon equation"),
                mutants=(
                    Mutant(name="2/z for 1/z", given={"damping": 2}),
                    Mutant(name="sign of the sine", given={"sine": 1}),
                ),
            ),
            Check(
                name="Goursat series",
                tier="full",
                run=_V + "painleve_series",
                routes=("the printed equation", "double Taylor series found without the ansatz"),
                mutants=(
                    Mutant(name="2/z for 1/z", given={"damping": 2}),
                    Mutant(name="sign of the sine", given={"sine": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.amsler-painleve-three",
        section="3.1",
        where="section 3.1, line 461",
        kind="sentence",
        statement=(
            r"(PIII) is Painlev\'e III in trigonometric form: $w = e^{i\varphi/2}$ "
            r"satisfies $w'' = "
            r"w'^2/w - w'/z + (\alpha w^2 + \beta)/z + \gamma w^3 + \delta/w$ with constants "
            r"$\alpha, \beta, \gamma, \delta$."
        ),
        hypotheses=(
            (
                r"(used, not stated) the substitution $w = e^{i\varphi/2}$; "
                r"$e^{i\varphi}$ does not "
                "lead to the normal form in the variable $z$"
            ),
        ),
        rests_on=("PIII",),
        checks=(
            Check(
                name="normal form",
                run=_V + "painleve_normal_form",
                routes=("logarithmic derivative of w", "normal form with unknown constants"),
                mutants=(
                    Mutant(name="w = exp(i phi)", given={"halves": 2}),
                    Mutant(name="2/z for 1/z", given={"damping": 2}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.amsler-preimage",
        section="3.1",
        where="section 3.1, line 461",
        kind="sentence",
        statement=r"$z = 0$ exactly where $u = 0$ or $v = 0$.",
        rests_on=("3.1.amsler-self-similar",),
        checks=(
            Check(
                name="factors",
                run=_V + "preimage",
                routes=("the printed variable", "factorisation over the rationals"),
                mutants=(Mutant(name="u + v for u v", given={"combination": "sum"}),),
            ),
        ),
    ),
    Claim(
        id="3.1.amsler-constant-on-axes",
        section="3.1",
        where="section 3.1, line 461",
        kind="sentence",
        statement=r"On each axis $\varphi$ keeps the value $\varphi(0)$.",
        rests_on=("3.1.amsler-preimage",),
        checks=(
            Check(
                name="z on the axes",
                run=_V + "constant_on_axes",
                routes=("the printed variable", "substitution"),
                mutants=(Mutant(name="u + v for u v", given={"combination": "sum"}),),
            ),
        ),
    ),
    Claim(
        id="3.1.amsler-neighbourhood",
        section="3.1",
        where="section 3.1, line 461",
        kind="sentence",
        statement=(
            r"The axes have an unbounded open neighbourhood on which $\varphi$ stays away from $0$ "
            r"and $\pi$ and the front is an immersion."
        ),
        hypotheses=(
            _CORNER,
            (
                r"(used, not stated) the neighbourhood narrows along the axes: $uv < \pi - \phi_0$ "
                "will do, no strip will"
            ),
        ),
        rests_on=("PIII", "3.1.amsler-constant-on-axes", "eq:def_phi"),
        checks=(
            Check(
                name="bounds of the angle",
                run=_V + "neighbourhood",
                routes=("chain rule on F(u v)", "theory.amsler:edge_of_regularity"),
                mutants=(
                    Mutant(name="a strip about the axes", given={"shape": "strip"}),
                    Mutant(name="corner angle pi", given={"corner": "pi"}),
                    Mutant(name="corner angle 0", given={"corner": "0"}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.amsler-bobbin-contrast",
        section="3.1",
        where="section 3.1, line 461",
        kind="sentence",
        statement=(
            r"On Minding's bobbin each asymptotic curve, of either family, comes to the cuspidal "
            "edge after a finite length."
        ),
        hypotheses=(r"$\kappa > 0$",),
        rests_on=("ex:bobbin", "eq:bobbin_psfront", "3.1.bobbin-periodic-orbits"),
        checks=(
            Check(
                name="length to the edge",
                run=_V + "bobbin_reaches_edge",
                routes=(
                    "asymptotic directions of the second form",
                    "bound of an integral",
                ),
                mutants=(Mutant(name="kappa^2 for kappa^2 + 1", given={"constant": 0}),),
            ),
            Check(
                name="turning rate",
                run="checks.verify.bobbin_orbit:finite_parameter",
                routes=("bound on the inclination's rate", "theory.bobbin:bobbin_flow"),
                mutants=(Mutant(name="pseudosphere", given={"surface": "pseudosphere"}),),
            ),
        ),
    ),
)

_EDGES = (
    Claim(
        id="3.1.amsler-edge-curvature",
        section="3.1",
        where="section 3.1, line 463",
        kind="equation",
        statement=r"By (eq:sg), $\kappa^u = \partial_u \varphi$, for the curve $u = 0$.",
        rests_on=("eq:sg", "eq:def_phi"),
        checks=(
            Check(
                name="printed",
                run=_E + "edge_curvature_formula",
                routes=("Christoffel symbols of the metric", "the printed formula"),
                mutants=(Mutant(name="twice the derivative", given={"sign": 2}),),
            ),
            Check(
                name="the v-curve u = 0",
                run=_E + "edge_curvature_formula",
                form="corrected",
                given={"along": "v"},
                routes=("Christoffel symbols of the metric", "the corrected formula"),
                mutants=(
                    Mutant(name="opposite sign", given={"sign": -1}),
                    Mutant(name="the other family", given={"along": "u"}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"$\kappa^u = \partial_u \phi$ along $u = 0$, by (eq:sg)",
            corrected=(
                r"$\kappa^v = \partial_v \varphi$ along $u = 0$; for the other edge (eq:sg) gives "
                r"$\kappa^u = -\partial_u \varphi$"
            ),
            kind="misprint",
            witness=(
                r"$u = 0$ is a $v$-curve; and in $du^2 + 2\sigma\cos\varphi\,du\,dv + dv^2$ the "
                r"$u$-lines have $\kappa^u = -\varphi_u$, as (eq:sg) says"
            ),
            conclusion_survives=True,
            remark=r"$\phi$ is printed for $\varphi$ as well; reading $v = 0$ for $u = 0$ in the "
            r"sentence would do too, with $\kappa^u = -\partial_u \varphi$",
        ),
    ),
    Claim(
        id="3.1.amsler-edge-derivative",
        section="3.1",
        where="section 3.1, line 463",
        kind="equation",
        statement=r"$\partial_u \varphi = 0$ along $u = 0$.",
        hypotheses=(_CORNER,),
        rests_on=("3.1.amsler-self-similar",),
        checks=(
            Check(
                name="printed",
                run=_E + "edge_derivative",
                routes=("double Taylor series by Picard iteration", "restriction to the edge"),
                mutants=(Mutant(name="v-edge, v-derivative", given={"along": "v", "edge": "v=0"}),),
            ),
            Check(
                name="derivative along the edge",
                run=_E + "edge_derivative",
                form="corrected",
                given={"along": "v"},
                routes=("double Taylor series by Picard iteration", "restriction to the edge"),
                mutants=(Mutant(name="derivative across the edge", given={"along": "u"}),),
            ),
        ),
        erratum=Erratum(
            printed=r"$\partial_u \phi = 0$ along $u = 0$",
            corrected=r"$\partial_v \varphi = 0$ along $u = 0$",
            kind="misprint",
            witness=(
                r"$\varphi = F(uv)$ with $F'(0) = \sin\phi_0$, so that "
                r"$\partial_u\varphi(0, v) = v "
                r"\sin\phi_0 \ne 0$ for $v > 0$"
            ),
            conclusion_survives=True,
        ),
    ),
    Claim(
        id="3.1.amsler-edge-acceleration",
        section="3.1",
        where="section 3.1, line 463",
        kind="equation",
        statement=r"By (eq:frames), $\partial_u r_u = 0$ along $u = 0$.",
        hypotheses=(_CORNER,),
        rests_on=("eq:frames", "3.1.amsler-edge-derivative"),
        checks=(
            Check(
                name="printed",
                run=_E + "edge_acceleration",
                routes=("Christoffel symbols of the metric", "double Taylor series of the angle"),
                mutants=(Mutant(name="v-edge, v-curves", given={"along": "v", "edge": "v=0"}),),
            ),
            Check(
                name="acceleration along the edge",
                run=_E + "edge_acceleration",
                form="corrected",
                given={"along": "v"},
                routes=("Christoffel symbols of the metric", "double Taylor series of the angle"),
                mutants=(Mutant(name="acceleration across the edge", given={"along": "u"}),),
            ),
        ),
        erratum=Erratum(
            printed=r"$\partial_u r_u = 0$ along $u = 0$",
            corrected=r"$\partial_v r_v = 0$ along $u = 0$",
            kind="misprint",
            witness=(
                r"$r_{uu} = \kappa^u N \times r_u$ with $\kappa^u(0, v) = -v\sin\phi_0$: the "
                r"$u$-curves are bent where they leave the edge, except at the corner"
            ),
            conclusion_survives=True,
        ),
    ),
    Claim(
        id="3.1.amsler-edge-straight",
        section="3.1",
        where="section 3.1, line 463",
        kind="sentence",
        statement=r"The asymptotic curve $u = 0$ of an Amsler sector is a straight line.",
        hypotheses=(_CORNER,),
        rests_on=("3.1.amsler-construction",),
        checks=(
            Check(
                name="edge u = 0",
                run=_E + "straight_edge",
                routes=(
                    "Christoffel symbols of the metric",
                    "Lelieuvre integral along a circle",
                ),
                mutants=(Mutant(name="u-curves for the edge", given={"along": "u"}),),
            ),
        ),
    ),
    Claim(
        id="3.1.amsler-other-edge-straight",
        section="3.1",
        where="section 3.1, line 463",
        kind="sentence",
        statement=r"By a similar argument the asymptotic curve $v = 0$ is a straight line.",
        hypotheses=(_CORNER,),
        rests_on=("3.1.amsler-construction",),
        checks=(
            Check(
                name="edge v = 0",
                run=_E + "other_edge",
                routes=(
                    "Christoffel symbols of the metric",
                    "Lelieuvre integral along a circle",
                ),
                mutants=(Mutant(name="v-curves for the edge", given={"along": "v"}),),
            ),
        ),
    ),
)

CLAIMS: tuple[Claim, ...] = (*_DEFINITIONS, *_REDUCTION, *_EDGES)
