"""Claims of section 3.3, which surfaces smooth isometries approximate; the energy gap."""

from checks.claim import Check, Citation, Claim, Erratum, Mutant

_UNSMOOTH = (
    r"$m = 2$, $\alpha_1 + \alpha_2 \ne \pi$, $\alpha_2 + \alpha_3 \ne \pi$",
    r"$\alpha_i \in (0, \pi)$, $\sum_{i=1}^{4} \alpha_i = 2\pi$",
)

_CHECKS = "checks.verify.approximability:"
_SMOOTHED = "checks.verify.smoothed_saddle:"

_CONSEQUENCES = (
    Claim(
        id="3.3.monkey-saddle-not-approximable",
        section="3.3",
        where="line 775",
        kind="sentence",
        statement=r"The monkey saddle, with $J_p = -2$, is not a limit in $W^{2,2}_{\mathrm{loc}}$ "
        r"of $C^2$ pseudospherical immersions with $\mathcal{E}_\infty(y_n) \le k_{\max} < "
        r"\infty$.",
        rests_on=("thm:branched", "fig:winding_number_normalfield"),
        checks=(
            Check(
                name="index and jumps",
                run=_CHECKS + "not_approximable",
                routes=(
                    "quadratic saddle over a star (theory.star_saddle)",
                    "index -1 required by (thm:branched)",
                ),
                mutants=(
                    Mutant(name="ordinary saddle", given={"orders": "2"}),
                    Mutant(name="both", given={"orders": "2,3"}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.3.sobolev-inclusion",
        section="3.3",
        where="line 775",
        kind="sentence",
        statement=r"Convergence in $W^{2,\infty}_{\mathrm{loc}}$ implies convergence in "
        r"$W^{2,2}_{\mathrm{loc}}$.",
        hypotheses=("(used, not stated) compact subsets have finite area",),
        checks=(
            Check(
                name="norms",
                run=_CHECKS + "area_bound",
                routes=("L^2 norm of three values", "area times the largest square"),
                mutants=(Mutant(name="no area", given={"power": 0}),),
            ),
        ),
    ),
    Claim(
        id="3.3.curvature-blow-up",
        section="3.3",
        where="line 775",
        kind="sentence",
        statement=r"Smooth pseudospherical immersions that converge to the monkey saddle in "
        r"$W^{2,2}_{\mathrm{loc}}$ have unbounded principal curvatures on every neighbourhood of "
        r"the branch point, and do not converge in $W^{2,\infty}_{\mathrm{loc}}$.",
        rests_on=("3.3.monkey-saddle-not-approximable", "3.3.sobolev-inclusion"),
        checks=(
            Check(
                name="index and jumps",
                run=_CHECKS + "not_approximable",
                routes=(
                    "quadratic saddle over a star (theory.star_saddle)",
                    "index -1 required by (thm:branched)",
                ),
                mutants=(
                    Mutant(name="ordinary saddle", given={"orders": "2"}),
                    Mutant(name="both", given={"orders": "2,3"}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.3.energy-gap",
        section="3.3",
        where="lines 777 and 779, supported there by computed nets",
        kind="sentence",
        statement=r"The infimum of $\mathcal{E}_\infty$ over $C^{1,1}$ branched isometries can be "
        r"strictly smaller than that over $C^2$ isometries.",
        hypotheses=(
            r"(used, not stated) of the same disk $B_R$, for suitable $R$",
            (
                r"(used, not stated) $C^2$ isometries of a disk have asymptotic coordinates, with "
                r"(eq:hazzidakis) on rectangles"
            ),
        ),
        rests_on=("thm:branched", "5.periodic-amsler-one-branch-point", "eq:hazzidakis"),
        checks=(
            Check(
                name="one branch point against all smooth isometries",
                run="checks.verify.energy_gap:energy_gap",
                routes=(
                    "theory.periodic_amsler (balls)",
                    "alternating sum of phi over an inscribed square (theory.inscribed_square)",
                ),
                mutants=(
                    Mutant(name="lower by 1 %", given={"share": "99/100"}, near=True),
                    Mutant(name="square 1 % larger", given={"stretch": "101/100"}, near=True),
                    Mutant(name="four sectors", given={"sectors": 4}),
                    Mutant(name="ten sectors", given={"sectors": 10}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.3.branch-set-condition",
        section="3.3",
        where="line 777",
        kind="equation",
        statement=r"The branch points of an isometry are the $p_i$ with $J(p_i) \ge 2$.",
        rests_on=("3.3.branch-point-index", "3.3.index-negative"),
        checks=(
            Check(
                name="as printed",
                run=_CHECKS + "branch_condition",
                routes=("printed condition", "quadratic saddle over a star (theory.star_saddle)"),
                mutants=(
                    Mutant(name="J >= 1", given={"least": 1}),
                    Mutant(name="J >= 3", given={"least": 3}),
                ),
            ),
            Check(
                name="J <= -2",
                run=_CHECKS + "branch_condition",
                form="corrected",
                given={"factor": -1},
                routes=(
                    "condition with the sign of J",
                    "quadratic saddle over a star (theory.star_saddle)",
                ),
                mutants=(
                    Mutant(name="J <= -1", given={"factor": -1, "least": 1}),
                    Mutant(name="J <= -3", given={"factor": -1, "least": 3}),
                    Mutant(name="J >= 2", given={"factor": 1}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"$J(p_i) \ge 2$",
            corrected=r"$J(p_i) \le -2$, that is $|J(p_i)| \ge 2$",
            kind="misprint",
            witness=r"$m = 3$: the gradient of the monkey saddle turns twice clockwise, $J = 1 - m "
            r"= -2$; no point has $J > 0$",
            conclusion_survives=True,
        ),
    ),
    Claim(
        id="3.3.branched-not-approximable",
        section="3.3",
        where="line 777",
        kind="sentence",
        statement=r"An isometry with a branch point is no limit in $W^{2,2}_{\mathrm{loc}}$, still "
        r"less in $W^{2,\infty}_{\mathrm{loc}}$, of smooth isometries with locally uniformly "
        "bounded curvatures.",
        rests_on=("thm:branched", "3.3.sobolev-inclusion"),
        checks=(
            Check(
                name="orders 3 to 6",
                run=_CHECKS + "all_orders",
                tier="full",
                routes=(
                    "quadratic saddle over a star (theory.star_saddle)",
                    "index -1 required by (thm:branched)",
                ),
                mutants=(Mutant(name="with order 2", given={"orders": "2,3"}),),
            ),
        ),
    ),
    Claim(
        id="3.3.smooth-mappings-approximate",
        section="3.3",
        where="line 777",
        kind="sentence",
        statement="Branched isometries are limits of smooth mappings.",
        hypotheses=(
            (
                r"(used, not stated) mappings that need not be isometric, and convergence in "
                r"$W^{2,2}_{\mathrm{loc}}$"
            ),
        ),
        rests_on=("def:branched_immersion",),
        checks=(
            Check(
                name="averages",
                run=_CHECKS + "mollified",
                routes=(
                    "quadratic saddle over a star (theory.star_saddle)",
                    "averages over windows",
                ),
                mutants=(Mutant(name="in W^{2,infinity}", given={"exponent": "oo"}),),
            ),
        ),
    ),
    Claim(
        id="3.3.flat-and-elliptic-w22",
        section="3.3",
        where="line 777",
        kind="sentence",
        statement=r"$W^{2,2}$ isometries of flat and of elliptic surfaces are limits in "
        r"$W^{2,2}_{\mathrm{loc}}$ of smooth isometries.",
        hypotheses=("(used, not stated) a smooth metric, and for flat ones a convex domain",),
        citation=Citation(
            source="M. R. Pakzad, On the Sobolev space of isometric immersions, J. Differential "
            "Geom. 66 (2004) 47-69; P. Hornung, Approximation of flat W^{2,2} isometric immersions "
            "by smooth ones, Arch. Ration. Mech. Anal. 199 (2011) 1015-1067; P. Hornung and I. "
            "Velcic, Regularity of intrinsically convex W^{2,2} surfaces and a derivation of a "
            "homogenized bending theory of convex shells, J. Math. Pures Appl. 115 (2018) 1-23",
            reason="Density in a space of all isometries; no computation runs over them.",
        ),
    ),
    Claim(
        id="3.3.flat-and-elliptic-c11",
        section="3.3",
        where="line 777",
        kind="sentence",
        statement=r"$C^{1,1}$ isometries of flat and of elliptic surfaces are limits in "
        r"$W^{2,\infty}_{\mathrm{loc}}$ of smooth isometries.",
        hypotheses=("(used, not stated) a smooth metric, and for flat ones a convex domain",),
        checks=(
            Check(
                name="as printed",
                run=_CHECKS + "flat_limit",
                routes=("plane joined to a cylinder", "continuous second forms in L^oo"),
                mutants=(
                    Mutant(name="cylinder of radius 1/2", given={"curvature": "2"}),
                    Mutant(name="cylinder of radius 2", given={"curvature": "1/2"}),
                ),
            ),
            Check(
                name="on the joined cylinder, in L^2",
                run=_CHECKS + "flat_limit",
                form="corrected",
                given={"exponent": "2"},
                routes=("plane joined to a cylinder", "ramps in L^2"),
                mutants=(
                    Mutant(name="in L^oo", given={"exponent": "oo"}),
                    Mutant(name="in L^oo, radius 2", given={"exponent": "oo", "curvature": "1/2"}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"$C^{1,1}$ isometries of flat surfaces are limits of smooth ones in "
            r"$W^{2,\infty}_{\mathrm{loc}}$",
            corrected=r"A $C^{1,1}$ isometry is a limit of $C^2$ ones in "
            r"$W^{2,\infty}_{\mathrm{loc}}$ only if it is $C^2$; the plane joined to a cylinder is "
            r"one in $W^{2,2}_{\mathrm{loc}}$ with bounded curvatures",
            kind="ambiguous",
            witness=r"the strip $(x(s), t, z(s))$ with $(x', z') = (\cos a, \sin a)$, $a = 0$ for "
            r"$s < 0$ and $a = s$ for $s > 0$: its second form jumps by $1$, and a continuous one "
            r"is at least $\frac12$ away",
            conclusion_survives=True,
            remark="Where `respectively' pairs the elliptic surfaces, not both kinds, with "
            r"$C^{1,1}$ and $W^{2,\infty}_{\mathrm{loc}}$, the sentence is right: with a smooth "
            "metric their isometries are smooth, by the cited theorem on intrinsically convex "
            r"surfaces. $W^{2,\infty}$ is meant in norm: the paper uses that it implies "
            r"convergence in $W^{2,2}$, which bounded weak-* convergence does not. The contrast "
            r"that it draws is one of convergence in $W^{2,2}$, with curvatures that stay bounded.",
        ),
    ),
    Claim(
        id="3.3.lavrentiev",
        section="3.3",
        where="line 779",
        kind="sentence",
        statement="The energy gap, for the maximal curvature and for the Willmore functional "
        "restricted to isometries, is an instance of the Lavrentiev phenomenon.",
        hypotheses=("(used, not stated) the gap exists, for both functionals",),
        rests_on=("3.3.energy-gap",),
        citation=Citation(
            source=(
                "Lavrentieff, Ann. Mat. Pura Appl. 4 (1927) 7-28; Ball and Mizel, Arch. "
                "Ration. Mech. "
                "Anal. 90 (1985) 325-388; Cesari, Optimization (1983), section 18.5"
            ),
            reason=(
                "a name given to the gap: for the maximal curvature the gap is proved on some "
                "disks, "
                "for the Willmore functional over all smooth isometries none is known"
            ),
        ),
        checks=(
            Check(
                name="one branch point against all smooth isometries",
                run="checks.verify.energy_gap:energy_gap",
                form="support",
                routes=(
                    "theory.periodic_amsler (balls)",
                    "alternating sum of phi over an inscribed square (theory.inscribed_square)",
                ),
                mutants=(
                    Mutant(name="lower by 1 %", given={"share": "99/100"}, near=True),
                    Mutant(name="square 1 % larger", given={"stretch": "101/100"}, near=True),
                    Mutant(name="four sectors", given={"sectors": 4}),
                    Mutant(name="ten sectors", given={"sectors": 10}),
                ),
            ),
        ),
    ),
)

_APPROXIMABLE = (
    Claim(
        id="rem:approximable",
        section="3.3",
        where="remark (rem:approximable), line 783, first sentence",
        kind="remark",
        statement=r"A $W^{2,2}_{\mathrm{loc}}$ limit of $C^2$ pseudospherical immersions, of local "
        r"degree $-1$ everywhere, need not be $C^2$.",
        labels=("rem:approximable",),
        hypotheses=(
            (
                r"$y_n : \Omega \to \mathbb{R}^3$ $C^2$ pseudospherical immersions, $y_n \to y$ in "
                r"$W^{2,2}_{\mathrm{loc}}$, $\mathcal{E}_\infty[y_n] \le k_{\max}$ for all $n$"
            ),
        ),
        rests_on=("thm:branched", "3.3.unsmooth-2-saddle", "3.3.smoothed-surfaces-converge"),
        checks=(
            Check(
                name="limit that is not C^2",
                run=_CHECKS + "unsmooth",
                part="limit",
                routes=("quadratic saddle over a star (theory.star_saddle)", "four sectors"),
                mutants=(
                    Mutant(name="alpha_1 + alpha_2 = pi", given={"second": "2/3"}),
                    Mutant(name="alpha_2 + alpha_3 = pi", given={"second": "1/3"}),
                ),
            ),
            Check(
                name="smoothed nets",
                tier="full",
                run=_SMOOTHED + "convergence",
                part="convergence",
                routes=(
                    "half-turn nets of smoothed curves",
                    "half-turn nets of curves with corners",
                ),
                mutants=(
                    Mutant(name="order 2", given={"order": 2}, near=True),
                    Mutant(name="L^2 order 1", given={"power": 2}, near=True),
                    Mutant(name="angles above 1.01 pi/3", given={"floor_percent": 101}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="3.3.unsmooth-2-saddle",
        section="3.3",
        where="remark (rem:approximable), line 783, second sentence",
        kind="remark",
        statement=r"Four sectors with $\alpha_1 + \alpha_2 \ne \pi$ and $\alpha_2 + \alpha_3 \ne "
        r"\pi$ make a piecewise smooth surface that is not $C^2$ in any neighbourhood of $p$.",
        hypotheses=_UNSMOOTH,
        rests_on=("def:sectors", "3.2.patched-saddle", "3.3.curves-with-corners"),
        checks=(
            Check(
                name="jumps of the second form",
                run=_CHECKS + "unsmooth",
                routes=("quadratic saddle over a star (theory.star_saddle)", "four sectors"),
                mutants=(
                    Mutant(name="alpha_1 + alpha_2 = pi", given={"second": "2/3"}),
                    Mutant(name="alpha_2 + alpha_3 = pi", given={"second": "1/3"}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.3.curves-with-corners",
        section="3.3",
        where="remark (rem:approximable), line 783, second sentence",
        kind="remark",
        statement=r"The $u$- and the $v$-asymptotic curve $\gamma_u$, $\gamma_v$ through $p$ are "
        r"not differentiable at $p$.",
        hypotheses=_UNSMOOTH,
        rests_on=("def:sectors",),
        checks=(
            Check(
                name="turning at p",
                run=_CHECKS + "corners",
                routes=("tangents from the angles of the sectors", "sums of angles"),
                mutants=(Mutant(name="angles that make 0", given={"add": "1"}),),
            ),
        ),
    ),
    Claim(
        id="3.3.smoothed-curves",
        section="3.3",
        where="remark (rem:approximable), line 783, third sentence",
        kind="remark",
        statement=r"$\gamma_u$ and $\gamma_v$ are uniform limits of smooth solutions of "
        r"(eq:frames), found by smoothing their distributional geodesic curvatures $\kappa^u$ and "
        r"$\kappa^v$; these intersect and serve as initial curves.",
        hypotheses=(
            *_UNSMOOTH,
            r"(used, not stated) the smoothed angle $\varphi$ stays in $(0, \pi)$",
        ),
        rests_on=("3.3.curves-with-corners", "eq:frames"),
        checks=(
            Check(
                name="angle",
                run=_CHECKS + "smoothed_angle",
                part="angle",
                routes=("phi = beta - alpha", "mean of the angles at p"),
                mutants=(Mutant(name="sign of a share", given={"mixed": -1}),),
            ),
            Check(
                name="curves",
                run=_CHECKS + "smoothed_curves",
                part="curves",
                routes=("matrix exponentials with the turning spread", "with the corner"),
                mutants=(
                    Mutant(name="order 2", given={"order": 2}, near=True),
                    Mutant(name="turning 1 % more", given={"percent": 101}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="3.3.smoothed-surfaces-converge",
        section="3.3",
        where="remark (rem:approximable), line 783, fourth sentence",
        kind="remark",
        statement=r"The Lelieuvre equations with these initial curves give smooth pseudospherical "
        r"surfaces that converge to a $C^{1,1}$ immersion with $J = -1$ everywhere.",
        hypotheses=(
            *_UNSMOOTH,
            r"(used, not stated) convergence in $W^{2,2}_{\mathrm{loc}}$, with bounded curvatures",
        ),
        rests_on=("3.3.smoothed-curves", "eq:lelieuvre", "eq:moutard"),
        checks=(
            Check(
                name="smoothed nets",
                tier="full",
                run=_SMOOTHED + "convergence",
                part="convergence",
                routes=(
                    "half-turn nets of smoothed curves",
                    "half-turn nets of curves with corners",
                ),
                mutants=(
                    Mutant(name="order 2", given={"order": 2}, near=True),
                    Mutant(name="L^2 order 1", given={"power": 2}, near=True),
                    Mutant(name="angles above 1.01 pi/3", given={"floor_percent": 101}, near=True),
                ),
            ),
            Check(
                name="index of the limit",
                run=_CHECKS + "unsmooth",
                part="index",
                routes=("quadratic saddle over a star (theory.star_saddle)", "four sectors"),
                mutants=(Mutant(name="alpha_1 + alpha_2 = pi", given={"second": "2/3"}),),
            ),
        ),
    ),
    Claim(
        id="3.3.c1m-approximable",
        section="3.3",
        where="remark (rem:approximable), line 783, last sentence",
        kind="remark",
        statement=r"$C^{1M}$ pseudospherical surfaces are limits of smooth isometries by the same "
        r"argument.",
        rests_on=("3.3.smoothed-surfaces-converge",),
        checks=(
            Check(
                name="curves with continuous tangents",
                tier="full",
                run=_SMOOTHED + "continuous_angles",
                routes=("half-turn nets of smoothed curves", "half-turn nets of the curves"),
                mutants=(
                    Mutant(name="curves with corners", given={"profile": "corner"}),
                    Mutant(name="order 2", given={"order": 2}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="3.3.c1m-index",
        section="3.3",
        where="remark (rem:approximable), line 783, last sentence",
        kind="remark",
        statement=r"$C^{1M}$ pseudospherical surfaces have $J = -1$ everywhere.",
        hypotheses=(r"(used, not stated) immersed, in coordinates $(u, v)$ global near the point",),
        rests_on=("def:Jp", "eq:lorentz_harmonic"),
        checks=(
            Check(
                name="orientation",
                run=_CHECKS + "normal_reverses",
                routes=("Lelieuvre equations", "orientation"),
                mutants=(Mutant(name="N_v = N x r_v", given={"second_sign": 1}),),
            ),
        ),
    ),
)

CLAIMS: tuple[Claim, ...] = _CONSEQUENCES + _APPROXIMABLE
