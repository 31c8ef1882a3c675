"""Claims of section 3.5 on Hamburger polygons."""

from checks.claim import Check, Claim, Mutant

_HAZZIDAKIS = "checks.verify.hazzidakis:"
_POLYGONS = "checks.verify.hamburger_polygons:"

CLAIMS: tuple[Claim, ...] = (
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
                run=_POLYGONS + "hamburger_polygon",
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
                run=_POLYGONS + "hamburger_sum",
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
                run=_POLYGONS + "hamburger_by_quadrature",
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
                run=_POLYGONS + "vertex_signs",
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
                run=_POLYGONS + "stars_are_hamburger",
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
        hypotheses=(
            r"$R$ is a $C^2$ asymptotic quadrilateral, with either sign of $\sigma$",
            (
                r"(eq:hazzidakis) is read as its erratum corrects it, with $\sigma A(R)$; as "
                r"printed it agrees where $\sigma = +1$"
            ),
        ),
        rests_on=(
            "eq:hazzidakis",
            "eq:sg-hamburger",
        ),
        checks=(
            Check(
                name="signs of both",
                run=_POLYGONS + "agreement",
                routes=(
                    "signs by the orientation omega",
                    "signs by the coordinates",
                ),
                mutants=(
                    Mutant(name="no sigma in (eq:hazzidakis)", given={"sigma_power": 0}),
                    Mutant(name="square of sigma", given={"sigma_power": 2}),
                ),
            ),
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
                run=_POLYGONS + "not_smooth",
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
                run=_HAZZIDAKIS + "continuous_angle",
                routes=(
                    "sum over the cells cut off by the kinks",
                    "sum over the rectangle",
                ),
                mutants=(Mutant(name="phi jumps by varying amounts", given={"jump": True}),),
            ),
        ),
    ),
)
