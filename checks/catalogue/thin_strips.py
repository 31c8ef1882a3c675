"""Claims of section 3.5 on thin rectangles about the rays of a branch point."""

from checks.claim import Check, Claim, Mutant

_STRIPS = "checks.verify.thin_strips:"

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="3.5.thin-rectangle",
        section="3.5",
        where="proof of lemma (lem:m-star), unlabelled formula, line 953",
        kind="equation",
        statement=(
            r"$\Delta_{R_\varepsilon} = \varphi(r_\varepsilon^+) - \varphi(r_\varepsilon^-) + "
            r"\varphi(q_\varepsilon^-) - \varphi(q_\varepsilon^+)$ for the thin rectangle."
        ),
        hypotheses=(
            r"the rectangle straddles a $u$-curve incident on $p_i$",
            (
                r"(used, not stated) the order $q^-, r^-, r^+, q^+$ is the orientation induced by "
                r"$\omega$; along a $v$-curve all signs change"
            ),
        ),
        rests_on=("3.5.vertex-signs",),
        checks=(
            Check(
                name="signs",
                run=_STRIPS + "strip_formula",
                routes=(
                    "signs where u-arcs begin",
                    "the printed formula",
                ),
                mutants=(
                    Mutant(name="signs of the q exchanged", given={"sign": -1}),
                    Mutant(name="about a v-curve", given={"rays": "v"}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.5.thin-rectangle-differences",
        section="3.5",
        where="proof of lemma (lem:m-star), line 955",
        kind="equation",
        statement=(
            r"$\varphi(r_\varepsilon^\pm) - \varphi(q_\varepsilon^\pm) = "
            r"\int\partial_u\varphi^\pm\,du + O(\varepsilon)$, the integral being along the "
            r"$u$-curve, with the limits $\varphi^\pm$ of the angle from its two sides."
        ),
        hypotheses=(
            r"the rectangle straddles a $u$-curve incident on $p_i$",
            r"each of the two integrals stays in one sector",
            r"(used, not stated) $\varphi$ is Lipschitz up to the curve from either side",
            (
                r"(used, not stated) the ends of the rectangle differ by $O(\varepsilon)$ from "
                r"those of the integral"
            ),
        ),
        checks=(
            Check(
                name="area between",
                run=_STRIPS + "strip_differences",
                routes=(
                    "integrated sine-Gordon equation",
                    "Taylor series of a Goursat problem",
                ),
                mutants=(
                    Mutant(name="O(eps^2)", given={"least": 2}, near=True),
                    Mutant(name="curvature of the rays not matched", given={"matched": False}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.5.angle-derivatives-match",
        section="3.5",
        where="proof of lemma (lem:m-star), line 955",
        kind="equation",
        statement=(
            r"$\partial_u\varphi^+ = \partial_u\varphi^- = -\kappa^u$ along a $u$-curve common to "
            r"two sectors, although $\varphi^+ \neq \varphi^-$; both are fixed by the geodesic "
            r"curvature of that curve."
        ),
        hypotheses=(
            (
                r"(used, not stated) both sectors have the same coordinate $u$ along the curve and "
                r"the same normal $N^\omega$; $\sigma$ differs between them"
            ),
        ),
        rests_on=(
            "eq:sg",
            "eq:frames",
            "eq:def_phi",
        ),
        checks=(
            Check(
                name="geodesic curvature",
                run=_STRIPS + "curvatures_match",
                routes=(
                    "moving frame",
                    "metric of asymptotic lines",
                ),
                mutants=(
                    Mutant(name="opposite sign", given={"sign": -1}),
                    Mutant(name="a normal for each sector", given={"one_normal": False}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.5.thin-rectangle-vanishes",
        section="3.5",
        where="proof of lemma (lem:m-star), line 955",
        kind="sentence",
        statement=(
            r"$\Delta_{R_\varepsilon} = O(\varepsilon)$ for a thin rectangle along a $u$-curve."
        ),
        hypotheses=(
            r"the ends of the rectangle keep away from $p_i$ or approach it with $\varepsilon$",
        ),
        rests_on=(
            "3.5.thin-rectangle",
            "3.5.thin-rectangle-differences",
            "3.5.angle-derivatives-match",
        ),
        checks=(
            Check(
                name="area of the strip",
                run=_STRIPS + "strips_vanish",
                routes=(
                    "integrated sine-Gordon equation",
                    "Taylor series of a Goursat problem",
                ),
                mutants=(
                    Mutant(name="O(eps^2)", given={"least": 2}, near=True),
                    Mutant(name="curvature of the rays not matched", given={"matched": False}),
                    Mutant(name="area times 1.01", given={"percent": 101}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="3.5.thin-rectangle-along-v-curve",
        section="3.5",
        where="proof of lemma (lem:m-star), line 955",
        kind="sentence",
        statement=(
            r"The same holds along $v$-curves: $\partial_v\varphi^+ = \partial_v\varphi^- = "
            r"\kappa^v$, and $\Delta_{R_\varepsilon} = O(\varepsilon)$."
        ),
        hypotheses=(r"the rectangle straddles a $v$-curve incident on $p_i$",),
        rests_on=(
            "eq:sg",
            "3.5.vertex-signs",
        ),
        checks=(
            Check(
                name="geodesic curvature",
                run=_STRIPS + "v_curvatures_match",
                part="curvature",
                routes=(
                    "moving frame",
                    "metric of asymptotic lines",
                ),
                mutants=(
                    Mutant(name="opposite sign", given={"sign": -1}),
                    Mutant(name="a normal for each sector", given={"one_normal": False}),
                ),
            ),
            Check(
                name="area of the strip",
                run=_STRIPS + "v_strips_vanish",
                part="strip",
                routes=(
                    "integrated sine-Gordon equation",
                    "Taylor series of a Goursat problem",
                ),
                mutants=(
                    Mutant(name="O(eps^2)", given={"least": 2}, near=True),
                    Mutant(name="curvature of the rays not matched", given={"matched": False}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.5.no-concentration-on-curves",
        section="3.5",
        where="proof of lemma (lem:m-star), line 955",
        kind="sentence",
        statement=(
            r"$\Delta$ does not concentrate along the asymptotic curves incident on a branch point."
        ),
        hypotheses=(r"the immersion is a $C^2$ PS-front on each closed sector",),
        rests_on=(
            "3.5.thin-rectangle-vanishes",
            "3.5.thin-rectangle-along-v-curve",
        ),
        checks=(
            Check(
                name="strips about all rays",
                run=_STRIPS + "all_strips_vanish",
                routes=(
                    "integrated sine-Gordon equation",
                    "Taylor series of a Goursat problem",
                ),
                mutants=(
                    Mutant(name="O(eps^2)", given={"least": 2}, near=True),
                    Mutant(name="curvature of the rays not matched", given={"matched": False}),
                ),
            ),
        ),
    ),
)
