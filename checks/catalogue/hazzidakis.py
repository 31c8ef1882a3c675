"""Claims of section 3.5 up to Hamburger polygons: the Hazzidakis formula and its extension."""

from checks.claim import Claim

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
    ),
    Claim(
        id="3.5.angle-range-of-an-immersion",
        section="3.5",
        where="after equation (eq:hazzidakis), line 913",
        kind="sentence",
        statement=r"$R$ is immersed only if $0 < \varphi(u,v) < \pi$ on $R$.",
        hypotheses=(r"$\varphi$ is the angle of (eq:def_phi), with values in $[0,\pi]$",),
        rests_on=("eq:def_phi",),
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
    ),
)
