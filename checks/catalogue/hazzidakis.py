"""Claims of section 3.5 up to the Hazzidakis formula."""

from checks.claim import Check, Claim, Erratum, Mutant

_HAZZIDAKIS = "checks.verify.hazzidakis:"

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
                run=_HAZZIDAKIS + "one_form",
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
                run=_HAZZIDAKIS + "area_form",
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
                run=_HAZZIDAKIS + "sine_gordon_in_forms",
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
                run=_HAZZIDAKIS + "hazzidakis",
                routes=(
                    "mixed derivative by the last corner",
                    "sine-Gordon equation of either sigma",
                ),
                mutants=(Mutant(name="sums for differences", given={"sign": 1}),),
            ),
            Check(
                name="with sigma",
                run=_HAZZIDAKIS + "hazzidakis",
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
                run=_HAZZIDAKIS + "hazzidakis_on_pseudosphere",
                routes=(
                    "closed form of the angle",
                    "rigorous quadrature of the area",
                ),
                mutants=(Mutant(name="area times 1.01", given={"percent": 101}, near=True),),
            ),
            Check(
                name="pseudosphere, with sigma",
                run=_HAZZIDAKIS + "hazzidakis_on_pseudosphere",
                form="corrected",
                given={"sigma_power": 1},
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
                run=_HAZZIDAKIS + "path_lengths",
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
                run=_HAZZIDAKIS + "area_bound",
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
                run=_HAZZIDAKIS + "continuous_angle",
                part="kinks",
                routes=(
                    "sum over the cells cut off by the kinks",
                    "sum over the rectangle",
                ),
                mutants=(Mutant(name="phi jumps by varying amounts", given={"jump": True}),),
            ),
            Check(
                name="nowhere differentiable on the edges",
                run=_HAZZIDAKIS + "rough_angle",
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
)
