"""Claims of section 2, plates in the limit of vanishing thickness."""

from checks.claim import Check, Citation, Claim, Erratum, Mutant

_LIMITS = "checks.verify.plate_limits"

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="2.gamma-convergence",
        section="2",
        where="after equation (eqn:finitethicknessenergy), line 170",
        kind="definition",
        statement=(
            r"The limit energy $\bar E$ is one such that every allowed $\bar y$ has a sequence "
            r"$\tilde y^h \to \bar y$ with $h^{-\alpha}I[\tilde y^h] \to \bar E[\bar y]$."
        ),
        hypotheses=(
            r"sequences with $h^{-\alpha}I[\tilde y^h] \le C$ converge along a subsequence",
        ),
        checks=(
            Check(
                name="recovery-alone",
                run=f"{_LIMITS}:gamma_limit_determined",
                routes=("exact recovery sequences", "least value of the energy"),
                mutants=(Mutant(name="no-recovery", given={"recovery": False}),),
            ),
            Check(
                name="with-lower-bound",
                run=f"{_LIMITS}:gamma_limit_determined",
                form="corrected",
                given={"lower_bound": True},
                routes=("exact recovery sequences", "least value of the energy"),
                mutants=(
                    Mutant(name="no-lower-bound", given={"lower_bound": False}),
                    Mutant(name="no-recovery", given={"recovery": False}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=(
                r"each $\bar y$ has some $\tilde y^h \to \bar y$ with "
                r"$h^{-\alpha}I[\tilde y^h] \to \bar E[\bar y]$"
            ),
            corrected=(
                r"and $\liminf h^{-\alpha}I[\tilde y^h] \ge \bar E[\bar y]$ for every sequence "
                r"$\tilde y^h \to \bar y$"
            ),
            kind="ambiguous",
            witness=(
                r"$f_h(x) = \cos(x/h)$ recovers every constant $c \in [-1,1]$ along $x_h = "
                r"h(\arccos c + 2\pi\lfloor x/2\pi h\rfloor) \to x$; its $\Gamma$-limit is $-1$"
            ),
            conclusion_survives=True,
            remark=(
                r"as a property of the $\Gamma$-limit, which the paper names and cites, the "
                r"sentence is right; it does not define the limit"
            ),
        ),
    ),
    Claim(
        id="2.gamma-hierarchy",
        section="2",
        where="after equation (eqn:finitethicknessenergy), line 170",
        kind="sentence",
        statement=(
            r"The space of limits and the limit energy can depend on the exponent $\alpha$ in "
            r"$h^{-\alpha}I \le C$."
        ),
        rests_on=("eq:hyperelastic", "2.gamma-convergence"),
        checks=(
            Check(
                name="stretched-sheet",
                run=f"{_LIMITS}:hierarchy",
                routes=("energy of one extension", "lower bound for all maps with the same limit"),
                mutants=(
                    Mutant(name="one-exponent", given={"second": 1}),
                    Mutant(name="both-large", given={"first": 3}),
                ),
            ),
        ),
    ),
    Claim(
        id="2.kirchhoff-regime",
        section="2",
        where="before equation (eqn:gammalimit), line 172",
        kind="sentence",
        statement=(
            r"Isometries of a metric with $K=-1$ and finite $\mathcal E_2$ are in the scaling "
            r"regime $I[\tilde y^h] \le Ch^3$ of Kirchhoff's plate theory, and in none of a higher "
            r"power."
        ),
        rests_on=("eq:hyperelastic", "2.kirchhoff-love-extension"),
        hypotheses=(
            (
                r"(used, not stated) conformal coordinates, or the distance of $\nabla\tilde y "
                r"A^{-1}$ to $SO(3)$: see (eqn:gammalimit)"
            ),
        ),
        checks=(
            Check(
                name="extension",
                run=f"{_LIMITS}:kirchhoff_regime",
                routes=("energy of the extension", "integral over the thickness"),
                mutants=(
                    Mutant(name="fourth-power", given={"power": 4}),
                    Mutant(name="second-power", given={"power": 2}),
                ),
            ),
        ),
    ),
    Claim(
        id="eqn:gammalimit",
        section="2",
        where="equation (eqn:gammalimit), line 173",
        kind="equation",
        statement=(
            r"$\frac{24h^{-3}}{Y}I[y] \to \mathcal E_2[y] = \int(\kappa_1^2+\kappa_2^2)\,dA$ for "
            r"$y \in W^{2,2}$ with $dy\cdot dy \equiv g$, and $+\infty$ otherwise, with $I$ of "
            r"(eq:hyperelastic)."
        ),
        labels=("eqn:gammalimit",),
        hypotheses=(r"the convergence is that of $\Gamma$-limits as $h \to 0$",),
        rests_on=("eq:hyperelastic", "2.gamma-lower-bound", "2.kirchhoff-regime"),
        checks=(
            Check(
                name="prefactor",
                run=f"{_LIMITS}:gamma_limit_prefactor",
                part="prefactor",
                routes=("printed prefactor", "recovery sequence integrated over the thickness"),
                mutants=(
                    Mutant(name="modulus-alone-dropped", given={"modulus_power": 0}),
                    Mutant(name="difference", given={"second_sign": -1}),
                ),
            ),
            Check(
                name="coordinates",
                run=f"{_LIMITS}:gamma_limit_charts",
                part="coordinates",
                routes=("cell problem in a chart", "principal curvatures and area"),
                mutants=(Mutant(name="area-of-the-chart", given={"area": "dx"}),),
            ),
            Check(
                name="cylinder",
                run=f"{_LIMITS}:stretched_chart",
                part="coordinates",
                routes=("gradient of the extension of a cylinder", "curvature and area of it"),
                mutants=(Mutant(name="one-percent", given={"scale": "101/100"}),),
            ),
            Check(
                name="cylinder-unscaled",
                run=f"{_LIMITS}:stretched_chart",
                form="corrected",
                part="coordinates",
                given={"scale": "1"},
                routes=("gradient of the extension of a cylinder", "curvature and area of it"),
                mutants=(
                    Mutant(name="doubled", given={"scale": "2"}),
                    Mutant(name="one-percent", given={"scale": "101/100"}, near=True),
                ),
            ),
            Check(
                name="prefactor-corrected",
                run=f"{_LIMITS}:gamma_limit_prefactor",
                form="corrected",
                part="prefactor",
                given={"prefactor": "12", "modulus_power": 0},
                routes=("corrected prefactor", "recovery sequence integrated over the thickness"),
                mutants=(
                    Mutant(name="as-printed", given={"prefactor": "24"}),
                    Mutant(name="one-percent", given={"prefactor": "303/25"}, near=True),
                    Mutant(name="with-modulus", given={"modulus_power": -1}),
                ),
            ),
            Check(
                name="conformal-coordinates",
                run=f"{_LIMITS}:gamma_limit_charts",
                form="corrected",
                part="coordinates",
                given={"chart": "conformal"},
                routes=("cell problem in a chart", "principal curvatures and area"),
                mutants=(Mutant(name="any-chart", given={"chart": "any"}),),
            ),
            Check(
                name="relative-distance",
                run=f"{_LIMITS}:gamma_limit_charts",
                form="corrected",
                part="coordinates",
                given={"distance": "relative"},
                routes=("cell problem in a chart", "principal curvatures and area"),
                mutants=(Mutant(name="distance-to-well", given={"distance": "to the well"}),),
            ),
        ),
        erratum=Erratum(
            printed=(
                r"$\frac{24h^{-3}}{Y}I \to \int(\kappa_1^2+\kappa_2^2)\,dA$ for $I = "
                r"\int\operatorname{dist}^2(\nabla\tilde y,SO(3)A)\,dx$"
            ),
            corrected=(
                r"$12h^{-3}I \to \int(\kappa_1^2+\kappa_2^2)\,dA$, in conformal coordinates on "
                r"$\Omega$, or for $I = \int\operatorname{dist}^2(\nabla\tilde "
                r"yA^{-1},SO(3))\,dV$; the factor $24/Y$ belongs to $\frac Y2 I$"
            ),
            kind="constant",
            witness=(
                r"$I$ holds no $Y$, and $r+tN$ has $I = "
                r"\frac{h^3}{12}\int(\kappa_1^2+\kappa_2^2)\,dA$. In the coordinates $(x/a,y)$ of "
                r"a plane rolled up to a cylinder, where $g = \operatorname{diag}(a^2,1)$, $I$ is "
                r"$a$ times that"
            ),
            conclusion_survives=True,
            remark=(
                r"$\mathcal E_2$ itself, all that the paper uses, is right; so is the factor "
                r"$24/Y$ on isometries with $\mathcal E^h$ of (eqn:finitethicknessenergy) in place "
                r"of $I$"
            ),
        ),
    ),
    Claim(
        id="2.gamma-lower-bound",
        section="2",
        where="equation (eqn:gammalimit), lines 173-179",
        kind="sentence",
        statement=(
            r"No sequence $\tilde y^h \to y$ has $\liminf h^{-3}I[\tilde y^h]$ below the limit "
            r"energy, which is infinite unless $y \in W^{2,2}$ with $dy\cdot dy \equiv g$; "
            r"sequences of bounded $h^{-3}I$ converge."
        ),
        rests_on=("eq:hyperelastic",),
        citation=Citation(
            source=(
                "Lewicka and Pakzad, ESAIM COCV 17 (2011) 1158-1173 (arXiv:0907.1857), after "
                "Friesecke, James and Mueller, Comm. Pure Appl. Math. 55 (2002) 1461-1506"
            ),
            reason=(
                "compactness and the lower bound rest on the geometric rigidity estimate for all "
                "maps of low energy, an existence argument that no computation decides"
            ),
        ),
        checks=(
            Check(
                name="linear-corrections",
                run=f"{_LIMITS}:cell_problem",
                form="support",
                routes=("least energy over corrections linear in t", "norm of the second form"),
                mutants=(
                    Mutant(name="half", given={"curvature_factor": "1/2"}),
                    Mutant(name="one-percent", given={"curvature_factor": "99/100"}, near=True),
                ),
            ),
        ),
    ),
)
