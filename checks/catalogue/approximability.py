"""Claims of section 3.3, which surfaces smooth isometries approximate; the energy gap."""

from checks.claim import Claim

_UNSMOOTH = (
    r"$m = 2$, $\alpha_1 + \alpha_2 \ne \pi$, $\alpha_2 + \alpha_3 \ne \pi$",
    r"$\alpha_i \in (0, \pi)$, $\sum_{i=1}^{4} \alpha_i = 2\pi$",
)

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
    ),
    Claim(
        id="3.3.sobolev-inclusion",
        section="3.3",
        where="line 775",
        kind="sentence",
        statement=r"Convergence in $W^{2,\infty}_{\mathrm{loc}}$ implies convergence in "
        r"$W^{2,2}_{\mathrm{loc}}$.",
        hypotheses=("(used, not stated) compact subsets have finite area",),
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
    ),
    Claim(
        id="3.3.energy-gap",
        section="3.3",
        where="lines 777 and 779, supported there by computed nets",
        kind="sentence",
        statement=r"The infimum of $\mathcal{E}_\infty$ over $C^{1,1}$ branched isometries can be "
        r"strictly smaller than that over $C^2$ isometries.",
        hypotheses=(r"(used, not stated) of the same disk $B_R$, for suitable $R$",),
        rests_on=("thm:branched", "fig:energywithradius"),
        waits_for=("5",),
    ),
    Claim(
        id="3.3.branch-set-condition",
        section="3.3",
        where="line 777",
        kind="equation",
        statement=r"The branch points of an isometry are the $p_i$ with $J(p_i) \ge 2$.",
        rests_on=("3.3.branch-point-index", "3.3.index-negative"),
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
    ),
    Claim(
        id="3.3.flat-and-elliptic-w22",
        section="3.3",
        where="line 777",
        kind="sentence",
        statement=r"$W^{2,2}$ isometries of flat and of elliptic surfaces are limits in "
        r"$W^{2,2}_{\mathrm{loc}}$ of smooth isometries.",
        hypotheses=("(used, not stated) a smooth metric, and for flat ones a convex domain",),
    ),
    Claim(
        id="3.3.flat-and-elliptic-c11",
        section="3.3",
        where="line 777",
        kind="sentence",
        statement=r"$C^{1,1}$ isometries of flat and of elliptic surfaces are limits in "
        r"$W^{2,\infty}_{\mathrm{loc}}$ of smooth isometries.",
        hypotheses=("(used, not stated) a smooth metric, and for flat ones a convex domain",),
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
        waits_for=("5",),
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
    ),
    Claim(
        id="3.3.c1m-approximable",
        section="3.3",
        where="remark (rem:approximable), line 783, last sentence",
        kind="remark",
        statement=r"$C^{1M}$ pseudospherical surfaces are limits of smooth isometries by the same "
        r"argument.",
        rests_on=("3.3.smoothed-surfaces-converge",),
    ),
    Claim(
        id="3.3.c1m-index",
        section="3.3",
        where="remark (rem:approximable), line 783, last sentence",
        kind="remark",
        statement=r"$C^{1M}$ pseudospherical surfaces have $J = -1$ everywhere.",
        hypotheses=(r"(used, not stated) immersed, in coordinates $(u, v)$ global near the point",),
        rests_on=("def:Jp", "eq:lorentz_harmonic"),
    ),
)

CLAIMS: tuple[Claim, ...] = _CONSEQUENCES + _APPROXIMABLE
