"""Claims of section 3.5 up to Hamburger polygons: the Hazzidakis formula and its extension."""

from checks.claim import Check, Claim, Erratum, Mutant

_V = "checks.verify.hazzidakis:"

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="3.5.one-form",
        section="3.5",
        where="opening of the subsection, line 908",
        kind="definition",
        statement=(
            r"$\alpha = \frac12 (\varphi_v\,dv - \varphi_u\,du)$, whose differential is $d\alpha = "
            r"\varphi_{uv}\,du \wedge dv$."
        ),
        hypotheses=(
            r"$f : \Omega \to \mathbb R^3$ is a smooth pseudospherical immersion",
            r"(used, not stated) $\varphi_{uv} = \varphi_{vu}$",
        ),
        rests_on=("eq:def_phi",),
        checks=(
            Check(
                name="differential",
                run=_V + "one_form",
                routes=(
                    "exterior derivative for an unknown angle",
                    "the printed form",
                ),
                mutants=(
                    Mutant(name="factor 1 for 1/2", given={"denominator": 1}),
                    Mutant(name="sum for difference", given={"sign_u": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.5.area-form",
        section="3.5",
        where="opening of the subsection, line 908",
        kind="sentence",
        statement=(
            r"$\beta = \sqrt{\det(g_{ij})}\,du \wedge dv$ with $g = du^2 + "
            r"2\sigma\cos\varphi\,du\,dv + dv^2$, the sign of the root being such that $\beta$ and "
            r"$\omega$ (equivalently $N^\omega$) induce the same orientation, equals "
            r"$\sigma\sin\varphi\,du\wedge dv$."
        ),
        hypotheses=(
            r"$\sigma = \pm 1$",
            r"$0 < \varphi < \pi$",
        ),
        rests_on=(
            "eq:metrics",
            "eq:Nfront",
            "eq:def_phi",
        ),
        checks=(
            Check(
                name="oriented area",
                run=_V + "area_form",
                routes=(
                    "(r_u x r_v).N by Gauss-Weingarten and on explicit surfaces",
                    "the printed metric and form",
                ),
                mutants=(
                    Mutant(name="no sigma in beta", given={"sigma_power": 0}),
                    Mutant(name="no sigma in g", given={"metric_power": 0}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.5.sine-gordon-in-forms",
        section="3.5",
        where="opening of the subsection, line 908",
        kind="sentence",
        statement=(
            r"Where $\sigma$ is constant, $\varphi_{uv} = \sigma\sin\varphi$ is equivalent to "
            r"$d\alpha - \beta = 0$."
        ),
        hypotheses=(r"$\sigma$ does not change sign on the domain",),
        rests_on=(
            "eq:sg",
            "3.5.one-form",
            "3.5.area-form",
        ),
        checks=(
            Check(
                name="equivalence",
                run=_V + "sine_gordon_in_forms",
                routes=(
                    "Riemann tensor of the metric of asymptotic lines",
                    "exterior derivative of the printed form",
                ),
                mutants=(
                    Mutant(name="no sigma in beta", given={"sigma_power": 0}),
                    Mutant(name="sum for difference", given={"sign_u": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="eq:hazzidakis",
        section="3.5",
        where="equation (eq:hazzidakis), line 911",
        kind="equation",
        statement=(
            r"$\Delta_R\varphi \equiv \varphi(u_0,v_0) - \varphi(u_0,v_1) + \varphi(u_1,v_1) - "
            r"\varphi(u_1,v_0) = A(R)$ for the asymptotic quadrilateral $R = [u_0,u_1] \times "
            r"[v_0,v_1]$."
        ),
        labels=("eq:hazzidakis",),
        hypotheses=(
            r"$u_0 \le u_1$, $v_0 \le v_1$",
            r"$\sigma$ is constant on $R$",
            r"$\varphi$ is twice differentiable on $R$ (removed later in the text)",
            (
                r"$A(R)$ is the area of the immersed quadrilateral, a positive number, for either "
                r"sign of $\sigma$"
            ),
        ),
        rests_on=(
            "3.5.sine-gordon-in-forms",
            "eq:sg",
        ),
        checks=(
            Check(
                name="printed",
                run=_V + "hazzidakis",
                routes=(
                    "mixed derivative by the last corner",
                    "sine-Gordon equation of either sigma",
                ),
                mutants=(Mutant(name="sums for differences", given={"sign": 1}),),
            ),
            Check(
                name="with sigma",
                run=_V + "hazzidakis",
                form="corrected",
                given={"sigma_power": 1},
                routes=(
                    "mixed derivative by the last corner",
                    "sine-Gordon equation of either sigma",
                ),
                mutants=(
                    Mutant(name="sums for differences", given={"sign": 1}),
                    Mutant(name="area times 1.01", given={"percent": 101}, near=True),
                    Mutant(name="no sigma", given={"sigma_power": 0}),
                ),
            ),
            Check(
                name="pseudosphere, printed",
                run=_V + "hazzidakis_on_pseudosphere",
                part="pseudosphere",
                routes=(
                    "closed form of the angle",
                    "rigorous quadrature of the area",
                ),
                mutants=(Mutant(name="area times 1.01", given={"percent": 101}, near=True),),
            ),
            Check(
                name="pseudosphere, with sigma",
                run=_V + "hazzidakis_on_pseudosphere",
                form="corrected",
                given={"sigma_power": 1},
                part="pseudosphere",
                routes=(
                    "closed form of the angle",
                    "rigorous quadrature of the area",
                ),
                mutants=(
                    Mutant(name="area times 1.01", given={"percent": 101}, near=True),
                    Mutant(name="no sigma", given={"sigma_power": 0}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=(
                r"$\varphi(u_0,v_0) - \varphi(u_0,v_1) + \varphi(u_1,v_1) - \varphi(u_1,v_0) = "
                r"A(R)$, $A$ the area of the quadrilateral"
            ),
            corrected=(
                r"the left side is $\sigma A(R)$: the formula needs $\sigma = +1$, or the signs of "
                r"(eq:sg-hamburger), which follow the orientation $\omega$"
            ),
            kind="hypothesis",
            witness=(
                r"The pseudosphere with $\varphi = 4\arctan e^{u+v}$, $\sigma = +1$, has on $R = "
                r"[-2,-1]\times[-1,0]$ the left side $0.53289\ldots = A(R)$. With $\omega$ "
                r"reversed, $\sigma = -1$ and $\varphi$ becomes $\pi - \varphi$: the left side is "
                r"$-0.53289\ldots$, the area the same"
            ),
            conclusion_survives=True,
            remark=(
                r"half of the sectors at a branch point have $\sigma = -1$; (eq:sg-hamburger) and "
                "the theorem have the right signs for both"
            ),
        ),
    ),
    Claim(
        id="3.5.sign-by-path-length",
        section="3.5",
        where="after equation (eq:hazzidakis), line 913",
        kind="sentence",
        statement=(
            r"$\Delta_R\varphi = \sum_i (-1)^{\ell_i}\varphi_i$ over the vertices, where $\ell_i$, "
            r"the length modulo 2 of a path of edges from $(u_0,v_0)$ to vertex $i$, does not "
            r"depend on the path."
        ),
        hypotheses=(r"(used, not stated) each side of the quadrilateral counts as one edge",),
        rests_on=("eq:hazzidakis",),
        checks=(
            Check(
                name="walks on the sides",
                run=_V + "path_lengths",
                routes=(
                    "all walks of up to 7 steps",
                    "the printed signs",
                ),
                mutants=(
                    Mutant(name="a diagonal counts as a side", given={"diagonal": True}),
                    Mutant(name="lengths from a neighbouring corner", given={"shift": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.5.angle-range-of-an-immersion",
        section="3.5",
        where="after equation (eq:hazzidakis), line 913",
        kind="sentence",
        statement=r"$R$ is immersed only if $0 < \varphi(u,v) < \pi$ on $R$.",
        hypotheses=(r"$\varphi$ is the angle of (eq:def_phi), with values in $[0,\pi]$",),
        rests_on=("eq:def_phi",),
        checks=(
            Check(
                name="independent tangents",
                run="checks.verify.invariant_angle:immersion",
                routes=(
                    "Lagrange's identity",
                    "zeros of the sine",
                ),
                mutants=(
                    Mutant(name="sum in the identity", given={"sign": 1}),
                    Mutant(name="zeros of the cosine", given={"function": "cos"}),
                    Mutant(name="speed not 1", given={"unit": False}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.5.quadrilateral-area-bound",
        section="3.5",
        where="after equation (eq:hazzidakis), line 913",
        kind="number",
        statement=r"$A(R) < 2\pi$ for every immersed asymptotic quadrilateral $R$.",
        hypotheses=(r"$0 < \varphi < \pi$ on the closed quadrilateral $R$",),
        rests_on=(
            "eq:hazzidakis",
            "3.5.angle-range-of-an-immersion",
        ),
        checks=(
            Check(
                name="corners in (0, pi)",
                run=_V + "area_bound",
                routes=(
                    "corner angles anywhere in (0, pi)",
                    "rhombi of Minding's bobbin by the pendulum",
                ),
                mutants=(
                    Mutant(name="bound pi", given={"hundredths": 100}),
                    Mutant(name="bound 1.98 pi", given={"hundredths": 198}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="3.5.hazzidakis-for-continuous-angle",
        section="3.5",
        where="after equation (eq:hazzidakis), line 913",
        kind="sentence",
        statement=(
            r"(eq:hazzidakis) holds also where $\varphi$ is not differentiable: for $C^{1M}$ "
            r"PS-fronts, whose $\varphi$ need only be $C^0$, with the sine-Gordon equation read as "
            r"an equation between distributions."
        ),
        hypotheses=(
            r"$r$ is a $C^{1M}$ PS-front",
            (
                r"(used, not stated) $\sigma$ is constant, or $A$ is the signed area "
                r"$\int\sigma\sin\varphi\,du\,dv$, where the front has singular edges"
            ),
        ),
        rests_on=("eq:hazzidakis",),
        checks=(
            Check(
                name="kinks along asymptotic lines",
                run=_V + "continuous_angle",
                part="kinks",
                routes=(
                    "sum over the cells cut off by the kinks",
                    "sum over the rectangle",
                ),
                mutants=(Mutant(name="phi jumps by varying amounts", given={"jump": True}),),
            ),
            Check(
                name="nowhere differentiable on the edges",
                run=_V + "rough_angle",
                part="nowhere differentiable",
                routes=(
                    "Moutard equation by half-turns on the sphere",
                    "trapezoidal rule for the area",
                ),
                mutants=(
                    Mutant(name="area times 1.01", given={"percent": 101}, near=True),
                    Mutant(name="sums for differences", given={"sign": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.5.hamburger-polygon",
        section="3.5",
        where="definition of Hamburger polygons, line 915",
        kind="definition",
        statement=(
            r"A Hamburger polygon is a piecewise $C^1$ Jordan curve $\gamma = \partial\Gamma$ made "
            r"of finitely many arcs, each along a $u$- or a $v$-asymptotic curve."
        ),
        hypotheses=(
            (
                r"(used, not stated) finitely many arcs; $u$- and $v$-arcs alternate, so that the "
                r"number of vertices is even"
            ),
        ),
        rests_on=("defn:quad",),
        checks=(
            Check(
                name="instances and near-misses",
                run=_V + "hamburger_polygon",
                routes=(
                    "families of the sides, points passed twice",
                    "the printed definition",
                ),
                mutants=(
                    Mutant(name="any arcs", given={"mixed": True}),
                    Mutant(name="curves that cross themselves", given={"crossing": True}),
                ),
            ),
        ),
    ),
    Claim(
        id="eq:sg-hamburger",
        section="3.5",
        where="equation (eq:sg-hamburger), line 920",
        kind="equation",
        statement=(
            r"$\Delta_\Gamma\varphi \equiv \sum_i (-1)^{\ell_i}\varphi_i = \oint_\gamma\alpha = "
            r"\int_\Gamma\beta = A(\Gamma)$ for a Hamburger polygon $\gamma = \partial\Gamma$."
        ),
        labels=("eq:sg-hamburger",),
        hypotheses=(
            r"$r$ is $C^2$ on a domain that contains $\Gamma$ and its boundary",
            r"$\gamma$ has the orientation induced by $\omega$",
            (
                r"(used, not stated) $r$ is an immersion there, so that $\sigma$ is constant on "
                r"$\Gamma$"
            ),
        ),
        rests_on=(
            "3.5.sine-gordon-in-forms",
            "3.5.hamburger-polygon",
            "3.5.vertex-signs",
        ),
        checks=(
            Check(
                name="polygons of a grid",
                run=_V + "hamburger_sum",
                routes=(
                    "signs at the vertices",
                    "Hazzidakis' formula cell by cell",
                ),
                mutants=(
                    Mutant(name="+ where v-arcs begin", given={"initial": "v"}),
                    Mutant(
                        name="oriented by the coordinates", given={"orientation": "coordinates"}
                    ),
                    Mutant(name="area times 1.01", given={"percent": 101}, near=True),
                ),
            ),
            Check(
                name="spiral in an Amsler sector",
                run=_V + "hamburger_by_quadrature",
                routes=(
                    "certified PIII at the vertices",
                    "midpoint rule on the Taylor series of the angle",
                ),
                mutants=(
                    Mutant(name="+ where v-arcs begin", given={"initial": "v"}),
                    Mutant(name="area times 1.01", given={"percent": 101}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="3.5.vertex-signs",
        section="3.5",
        where="after equation (eq:sg-hamburger), line 922",
        kind="sentence",
        statement=(
            r"$\ell_i = 0$ at the initial vertex of each $u$-arc, which is the terminal vertex of "
            r"a $v$-arc, and $\ell_i = 1$ at the terminal vertex of each $u$-arc, the initial "
            r"vertex of a $v$-arc; with these signs $\oint_\gamma\alpha = \sum_i "
            r"(-1)^{\ell_i}\varphi_i$, for either sign of $\sigma$."
        ),
        hypotheses=(
            r"$\gamma$ has the orientation induced by $\omega$",
            r"(used, not stated) $u$- and $v$-arcs alternate along $\gamma$",
            r"(used, not stated) $\varphi$ is continuous along each arc",
        ),
        rests_on=(
            "3.5.one-form",
            "3.5.hamburger-polygon",
        ),
        checks=(
            Check(
                name="boundary integral",
                run=_V + "vertex_signs",
                routes=(
                    "integral of alpha arc by arc",
                    "the printed signs",
                ),
                mutants=(
                    Mutant(name="+ where v-arcs begin", given={"initial": "v"}),
                    Mutant(name="sum for difference in alpha", given={"sign_u": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.5.stars-are-hamburger-polygons",
        section="3.5",
        where="after equation (eq:sg-hamburger), line 924",
        kind="sentence",
        statement=r"Asymptotic quadrilaterals and $m$-stars are bounded by Hamburger polygons.",
        hypotheses=(
            (
                r"(used, not stated) the arc of one family that crosses a ray of the star counts "
                r"as one arc, although its direction may jump on the ray"
            ),
        ),
        rests_on=(
            "defn:quad",
            "def:m-star",
            "3.5.hamburger-polygon",
        ),
        checks=(
            Check(
                name="arcs of the boundary",
                run=_V + "stars_are_hamburger",
                routes=(
                    "families of the arcs between corners",
                    "the printed definition",
                ),
                mutants=(
                    Mutant(name="different lengths along a ray", given={"equal_lengths": False}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.5.hamburger-agrees-with-hazzidakis",
        section="3.5",
        where="after equation (eq:sg-hamburger), line 924",
        kind="sentence",
        statement=(
            r"On a $C^2$ asymptotic quadrilateral (eq:sg-hamburger) and (eq:hazzidakis) are the "
            r"same statement."
        ),
        hypotheses=(r"$R$ is a $C^2$ asymptotic quadrilateral, with either sign of $\sigma$",),
        rests_on=(
            "eq:hazzidakis",
            "eq:sg-hamburger",
        ),
        checks=(
            Check(
                name="printed",
                run=_V + "agreement",
                routes=(
                    "signs by the orientation omega",
                    "signs by the coordinates",
                ),
                mutants=(Mutant(name="square of sigma", given={"sigma_power": 2}),),
            ),
            Check(
                name="with sigma",
                run=_V + "agreement",
                form="corrected",
                given={"sigma_power": 1},
                routes=(
                    "signs by the orientation omega",
                    "signs by the coordinates",
                ),
                mutants=(Mutant(name="no sigma", given={"sigma_power": 0}),),
            ),
        ),
        erratum=Erratum(
            printed=(
                "(eq:sg-hamburger) agrees with the Hazzidakis formula on asymptotic quadrilaterals"
            ),
            corrected=(
                r"it agrees where $\sigma = +1$; where $\sigma = -1$ their left sides have "
                "opposite signs, and (eq:sg-hamburger) is right"
            ),
            kind="hypothesis",
            witness=(
                r"for $\sigma = -1$ the orientation $\omega$ passes the corners in the order "
                r"$(u_1,v_0), (u_0,v_0), (u_0,v_1), (u_1,v_1)$, the first arc along $u$: the "
                r"sum is $\varphi(u_1,v_0) - \varphi(u_0,v_0) + \varphi(u_0,v_1) - "
                r"\varphi(u_1,v_1)$, minus that of (eq:hazzidakis)"
            ),
            conclusion_survives=True,
        ),
    ),
    Claim(
        id="3.5.branch-point-not-smooth",
        section="3.5",
        where="after equation (eq:sg-hamburger), line 924",
        kind="sentence",
        statement=(
            r"If $m > 2$, the centre of an $m$-star is a branch point, and the immersion is not "
            r"$C^2$ there."
        ),
        hypotheses=(r"the immersion restricts to a PS-front on each sector",),
        rests_on=(
            "def:m-star",
            "def:m-saddle",
        ),
        checks=(
            Check(
                name="rays of a star",
                run=_V + "not_smooth",
                routes=(
                    "quadratic forms that vanish on three lines",
                    "jump of the second derivatives of star saddles",
                ),
                mutants=(
                    Mutant(name="order 2", given={"orders": "2"}),
                    Mutant(name="two lines", given={"directions": 2}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.5.no-concentration-for-continuous-angle",
        section="3.5",
        where="after equation (eq:sg-hamburger), line 924",
        kind="sentence",
        statement=(
            r"For $C^{1M}$ surfaces with continuous $\varphi$, $\Delta_\Gamma = "
            r"\oint_{\partial\Gamma}\alpha \to 0$ as $A(\Gamma) \to 0$: nothing concentrates on "
            r"sets of vanishing area."
        ),
        hypotheses=(
            r"$\varphi$ is continuous",
            r"(used, not stated) $\sigma$ is constant",
            (
                r"(used, not stated) where $\varphi$ is not differentiable, $\oint\alpha$ is "
                r"defined by the alternating sum"
            ),
        ),
        rests_on=(
            "eq:sg-hamburger",
            "3.5.hazzidakis-for-continuous-angle",
        ),
        checks=(
            Check(
                name="kinks along asymptotic lines",
                run=_V + "continuous_angle",
                routes=(
                    "sum over the cells cut off by the kinks",
                    "sum over the rectangle",
                ),
                mutants=(Mutant(name="phi jumps by varying amounts", given={"jump": True}),),
            ),
        ),
    ),
)
