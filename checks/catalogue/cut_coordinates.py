"""Claims of section 5.1, all sectors: the cut coordinate and the inequality wanted."""

from checks.claim import Check, Claim, Erratum, Mutant

_CUTS = "checks.verify.cut_coordinates:"
_FLOOR = "checks.verify.angle_floor:"

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="5.1.most-sectors-pseudo-amsler",
        section="5.1",
        where="section 5.1, line 1542",
        kind="sentence",
        statement=(
            "Most sectors of the greedy algorithm are not Amsler sectors: of the three at each "
            "cut one is."
        ),
        hypotheses=("(used, not stated) counted without the initial sectors",),
        checks=(
            Check(
                name="counted",
                run="checks.verify.greedy_tree_shape:amsler_share",
                tier="full",
                routes=("sectors of runs", "one of three"),
                mutants=(
                    Mutant(name="1 % off", given={"share": "101/300"}, near=True),
                    Mutant(name="a half", given={"share": "1/2"}),
                    Mutant(name="less than a third", given={"most": "1/3"}),
                ),
            ),
        ),
        rests_on=("alg:greedy-cuts", "def:amsler-sector"),
    ),
    Claim(
        id="5.1.one-geodesic-axis",
        section="5.1",
        where="section 5.1, line 1542",
        kind="sentence",
        statement=(
            "The other sectors are pseudo-Amsler sectors: exactly one of the bounding curves is "
            "a geodesic."
        ),
        hypotheses=(
            "(used, not stated) the line taken from the parent is not itself an axis of it",
        ),
        checks=(
            Check(
                name="turns of the sides",
                run="checks.verify.greedy_tree_shape:one_geodesic",
                tier="full",
                routes=("sides of the sectors of runs", "number of geodesics as stated"),
                mutants=(
                    Mutant(name="none", given={"sides": 0}, near=True),
                    Mutant(name="both", given={"sides": 2}, near=True),
                ),
            ),
        ),
        rests_on=("5.1.most-sectors-pseudo-amsler",),
    ),
    Claim(
        id="eq:cut-coordinates",
        section="5.1",
        where="equation (eq:cut-coordinates), line 1546",
        kind="definition",
        statement=(
            r"$\alpha_n^2 = \frac{1}{4 "
            r"s_n}\left(I_0^{-1}\left(\frac{\phi^*}{\phi_n}\right)\right)^2$, with $s_n$ the "
            r"distance of the branch point from $\partial\Omega$."
        ),
        labels=("eq:cut-coordinates",),
        hypotheses=(
            r"(used, not stated) $\phi_n < \phi^*$",
            "(used, not stated) for a disk $s_n = R - d(0, p)$",
        ),
        rests_on=("5.1.zeta",),
        checks=(
            Check(
                name="instances",
                run=_CUTS + "instance",
                routes=(
                    "inverse of I_0 by interval Newton, length of geodesics on the hyperboloid",
                    "theory.bessel_reference (mpmath), s_n = R - d",
                ),
                mutants=(
                    Mutant(name="2 s_n", given={"under": "2"}),
                    Mutant(name="1 % more below", given={"under": "101/25"}, near=True),
                    Mutant(name="not squared", given={"power": 1}),
                    Mutant(name="distance to the centre", given={"distance": "to the centre"}),
                ),
            ),
            Check(
                name="refused above phi*",
                run=_CUTS + "refused",
                part="domain",
                routes=("theory.bessel (balls)", "theory.bessel_reference (mpmath)"),
                mutants=(Mutant(name="phi_n just below phi*", given={"ratio": "1000001/1000000"}),),
            ),
        ),
    ),
    Claim(
        id="5.1.distance-against-axes",
        section="5.1",
        where="section 5.1, line 1549",
        kind="equation",
        statement=r"$s_n^2 \geq u_{\max} v_{\max}$.",
        hypotheses=(
            "$s_n$ as in (eq:cut-coordinates)",
            (
                r"(used, not stated) $u_{\max}, v_{\max}$ are the lengths of the axes from the "
                "branch point to the boundary"
            ),
        ),
        rests_on=("eq:cut-coordinates",),
        checks=(
            Check(
                name="as printed, sampled",
                run=_CUTS + "sectors",
                routes=("printed inequality", "lengths of geodesics to the rim (balls)"),
                mutants=(Mutant(name="0.9 s_n^2", given={"share": "9/10"}),),
            ),
            Check(
                name="as printed, in general",
                run=_CUTS + "shortest",
                routes=("printed inequality", "geodesics on the hyperboloid"),
                mutants=(Mutant(name="0.9 s_n^2", given={"share": "9/10"}),),
            ),
            Check(
                name="reversed, sampled",
                run=_CUTS + "sectors",
                form="corrected",
                given={"sense": "at most"},
                routes=("reversed inequality", "lengths of geodesics to the rim (balls)"),
                mutants=(
                    Mutant(name="as printed", given={"sense": "at least"}),
                    Mutant(name="1.01 s_n^2", given={"share": "101/100"}, near=True),
                ),
            ),
            Check(
                name="reversed, in general",
                run=_CUTS + "shortest",
                form="corrected",
                given={"sense": "at most"},
                routes=("reversed inequality", "geodesics on the hyperboloid"),
                mutants=(
                    Mutant(name="as printed", given={"sense": "at least"}),
                    Mutant(name="1.1 s_n^2", given={"share": "11/10"}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"$s_n^2 \geq u_{\max} v_{\max}$",
            corrected=(
                r"$s_n^2 \leq u_{\max} v_{\max}$, with equality for geodesic axes only at the "
                r"centre: $s_n$ is the least length of a way from the branch point to the rim, so "
                r"$u_{\max}, v_{\max} \geq s_n$"
            ),
            kind="false",
            witness=(
                r"$R = 4$, branch point at distance $1$ from the centre: $s_n^2 = 9$. Axes "
                r"perpendicular to the radius end where $\cosh l = \cosh 4/\cosh 1$: $l^2 = "
                r"12.71$; axes at the angle of cosine $4/5$ have $l^2 = 9.55$"
            ),
            conclusion_survives=True,
            remark=(
                r"The inequality is offered as the intuition for $\alpha_n$. Reversed, it gives "
                r"$\zeta_n \leq 2\alpha_n^2$: $\alpha_n$ bounds the argument of the lemma from "
                r"above; from below one needs $u_{\max} v_{\max} \leq Cs_n^2$ as well. What the "
                r"argument for all sectors needs is $s_n \leq R$ alone, which holds."
            ),
        ),
    ),
    Claim(
        id="5.1.zeta-against-alpha",
        section="5.1",
        where="section 5.1, line 1549",
        kind="sentence",
        statement=r"$\zeta_n$ is like $2\alpha_n^2$.",
        hypotheses=(
            (
                r"(read so) like: $\zeta_n$ with $s_n$ for $\sqrt{u_{\max} v_{\max}}$, the same "
                "for the sectors at the centre; put as an intuition"
            ),
            (
                r"elsewhere $\zeta_n < 2\alpha_n^2$, at least $2\alpha_n^2\cos\theta$ for geodesic "
                r"axes within the angle $\theta < \pi/2$ of the outward radius, as at Amsler nodes "
                r"on a diagonal, $\theta = \phi_n/2$. For axes perpendicular to it no constant "
                r"bounds $2\alpha_n^2/\zeta_n$: with $R = 4$, $s_n = 10^{-3}$ it is $44.7$"
            ),
        ),
        rests_on=("5.1.zeta", "eq:cut-coordinates"),
        checks=(
            Check(
                name="s_n for the root of u_max v_max",
                run=_CUTS + "zeta_of_distance",
                routes=("printed alpha_n^2", "corner of the cut (theory.cut_corner)"),
                mutants=(
                    Mutant(name="like alpha_n^2", given={"factor": "1"}),
                    Mutant(name="like 2.02 alpha_n^2", given={"factor": "101/50"}, near=True),
                ),
            ),
            Check(
                name="axes that leave outwards",
                run=_CUTS + "zeta_like",
                form="support",
                routes=("printed alpha_n^2", "lengths of geodesics to the rim (balls)"),
                mutants=(
                    Mutant(name="like alpha_n^2", given={"factor": "1"}),
                    Mutant(name="like 2.02 alpha_n^2", given={"factor": "101/50"}, near=True),
                    Mutant(name="angle 1 % more", given={"steepest": "101/250"}, near=True),
                    Mutant(name="axes perpendicular to the radius", given={"steepest": "1/2"}),
                    Mutant(
                        name="perpendicular, up to a factor of 1000",
                        given={"steepest": "1/2", "bound": "4997/10000"},
                    ),
                ),
            ),
            Check(
                name="slanted axes",
                run=_CUTS + "slanted_axis",
                form="support",
                routes=("geodesics on the hyperboloid", "s_n >= l cos(angle)"),
                mutants=(Mutant(name="s_n >= l", given={"power": 0}),),
            ),
        ),
    ),
    Claim(
        id="5.1.sufficient-inequality",
        section="5.1",
        where="section 5.1, line 1549",
        kind="sentence",
        statement=(
            r"If $\phi_{n+1}/\phi_n \geq f(2C\alpha_n^2)$ with $C > 0$ independent of $R$ and $f "
            r"\geq 1$ for large arguments, then all sectors have $\phi_n \geq "
            r"\phi^*/I_0(C'\sqrt{R})$, as Amsler sectors do."
        ),
        hypotheses=(
            r"(used, not stated) $s_n \leq R$",
            r"(used, not stated) $\phi_{n+1} \geq \phi_n/3$ for every sector",
            "(used, not stated) $R$ and the constant $C'$ are large enough",
        ),
        rests_on=("5.1.smallest-angle-amsler", "eq:cut-coordinates"),
        checks=(
            Check(
                name="floor of the angles",
                run=_FLOOR + "sufficient",
                routes=(
                    "printed alpha_n^2 with s_n <= R",
                    "worst path of the recursion, series of I_0",
                ),
                mutants=(
                    Mutant(name="threshold for A/2", given={"numerator": 1}),
                    Mutant(name="f >= 0.99 only", given={"growth": "99/100"}, near=True),
                    Mutant(name="C' = k", given={"scale": 1}),
                ),
            ),
        ),
    ),
)
