"""Claims of section 3.5 on the concentration of the alternating sum at branch points."""

from checks.claim import Check, Claim, Erratum, Mutant

_V = "checks.verify.concentration:"

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="3.5.angle-jumps",
        section="3.5",
        where="before figure (fig:concentrations), line 926",
        kind="sentence",
        statement=(
            r"On a branched surface $\varphi$ is discontinuous along the rays of a branch point: "
            r"across each of its $2m$ rays, $m \ge 3$, the limits from the two sides differ."
        ),
        hypotheses=(r"the point has order of saddleness $m \ge 3$",),
        rests_on=(
            "3.5.sector-angle",
            "3.5.angles-sum-to-two-pi",
            "def:branched_immersion",
        ),
        checks=(
            Check(
                name="every ray",
                run=_V + "jumps",
                routes=(
                    "angles of seven stars",
                    "sums of neighbouring angles",
                ),
                mutants=(Mutant(name="order 2 too", given={"smallest": 2}),),
            ),
            Check(
                name="all but two rays",
                run=_V + "jumps",
                form="corrected",
                given={"continuous_rays": 2},
                routes=(
                    "angles of seven stars",
                    "sums of neighbouring angles",
                ),
                mutants=(
                    Mutant(name="all but one", given={"continuous_rays": 1}, near=True),
                    Mutant(name="order 2 too", given={"smallest": 2}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=(
                r"$\varphi$ necessarily has jumps across the asymptotic curves incident on a "
                "branch point"
            ),
            corrected=(
                r"across at least $2m-2$ of the $2m$ curves, namely all where the two sector "
                r"angles beside them do not add up to $\pi$"
            ),
            kind="ambiguous",
            witness=(
                r"surgery at a smooth point with four right angles, one of them cut into three: "
                r"the sector angles are $\frac\pi6, \frac\pi6, \frac\pi6, \frac\pi2, \frac\pi2, "
                r"\frac\pi2$, and $\varphi = \frac\pi2$ on both sides of the two curves between "
                "right angles"
            ),
            conclusion_survives=True,
            remark=(
                "some curves of every branch point do carry jumps; the surgery of the paper always "
                "leaves two that do not, opposite continuations of the edges of the cut"
            ),
        ),
    ),
    Claim(
        id="fig:concentrations",
        section="3.5",
        where="figure (fig:concentrations), line 943",
        kind="figure",
        statement=(
            r"(a) The Hamburger polygon $T_\varepsilon$ around a branch point and the thin "
            r"rectangle $R_\varepsilon = [q_\varepsilon^- r_\varepsilon^- r_\varepsilon^+ "
            r"q_\varepsilon^+]$ along an incident asymptotic curve measure the concentrations of "
            r"$\Delta$ there; (b) $T_\varepsilon$ enlarged: $\varphi$ is constant up to "
            r"$O(\varepsilon)$ on each sector."
        ),
        labels=(
            "fig:concentrations",
            "fig:sinegordonepsrectangle",
            "fig:sinegordonepsstar",
        ),
        hypotheses=(r"(used, not stated) the corners of the rectangle are met in the order given",),
        rests_on=(
            "3.5.thin-rectangle",
            "3.5.angle-at-far-corner",
        ),
        checks=(
            Check(
                name="polygons of the figure",
                run=_V + "figure",
                routes=(
                    "general angle on a star",
                    "Taylor series of a Goursat problem",
                ),
                mutants=(
                    Mutant(name="signs of the q exchanged", given={"sign": -1}),
                    Mutant(name="O(eps^2)", given={"least": 2}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="3.5.sector-angles-by-parity",
        section="3.5",
        where="figure (fig:concentrations), part (b) of the caption, line 942",
        kind="sentence",
        statement=(
            r"With $\alpha_j$ the angle at the point between the two rays that bound sector $j$, "
            r"$\varphi$ is $\alpha_{2i}$ on sectors of even number and $\pi - \alpha_{2i+1}$ on "
            r"those of odd number."
        ),
        hypotheses=(
            r"sectors are numbered $0, \ldots, 2m-1$ counterclockwise",
            (
                r"(used, not stated) even sectors are those where $r_u$ turns into $r_v$ "
                r"counterclockwise; in the numbering $1, \ldots, 2m$ of (def:m-star) and "
                r"(eq:sector-coords), whose even rays are $u$-rays, those are the odd ones"
            ),
        ),
        rests_on=(
            "3.5.sector-angle",
            "def:m-star",
            "eq:sector-coords",
        ),
        checks=(
            Check(
                name="seven stars",
                run=_V + "sector_angle_by_parity",
                routes=(
                    "cos phi = sigma r_u . r_v on the rays",
                    "the caption",
                ),
                mutants=(Mutant(name="numbered from 1", given={"even": 1}, near=True),),
            ),
        ),
    ),
    Claim(
        id="lem:m-star",
        section="3.5",
        where="lemma (lem:m-star), line 947",
        kind="lemma",
        statement=(
            r"$\Delta_{T_i} = A(T_i) - (m_i-2)\pi$ for an $m_i$-star $T_i$ of $2m_i$ asymptotic "
            r"quadrilaterals incident on $p_i$."
        ),
        labels=("lem:m-star",),
        hypotheses=(
            r"the immersion is a $C^2$ PS-front on each closed sector",
            r"(used, not stated) $m_i \ge 2$, sector angles in $(0,\pi)$ with sum $2\pi$",
            r"(used, not stated) the signs of the vertices are those of (eq:sg-hamburger)",
            r"(used, not stated) $\sigma$ is constant on each sector and alternates around $p_i$",
        ),
        rests_on=(
            "eq:hazzidakis",
            "3.5.star-boundary",
            "3.5.no-concentration-on-curves",
            "3.5.star-sum-value",
            "3.5.star-decomposition",
        ),
        checks=(
            Check(
                name="unknown surfaces",
                run=_V + "star_lemma",
                routes=(
                    "integrated sine-Gordon equation on each sector",
                    "the printed formula",
                ),
                mutants=(
                    Mutant(name="m - 3 for m - 2", given={"regular": 3}, near=True),
                    Mutant(name="opposite concentration", given={"sign": 1}),
                    Mutant(name="area subtracted", given={"area_sign": -1}),
                    Mutant(name="1.01 pi", given={"percent": 101}, near=True),
                    Mutant(name="curvature of the rays not matched", given={"matched": False}),
                    Mutant(name="sigma constant", given={"alternating": False}),
                    Mutant(name="angles of sum 4 pi", given={"turns": 2}),
                ),
            ),
            Check(
                name="Amsler stars by quadrature",
                run=_V + "star_by_quadrature",
                routes=(
                    "certified PIII at the corners",
                    "midpoint rule on the Taylor series of the angle",
                ),
                mutants=(
                    Mutant(name="m - 3 for m - 2", given={"regular": 3}, near=True),
                    Mutant(name="area times 1.01", given={"percent": 101}, near=True),
                ),
            ),
            Check(
                name="shrinking Amsler stars",
                run=_V + "shrinking_stars",
                routes=(
                    "certified PIII at the corners",
                    "limit with its error bound",
                ),
                mutants=(
                    Mutant(name="m - 1 for m - 2", given={"regular": 1}, near=True),
                    Mutant(name="1.01 pi", given={"percent": 101}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="3.5.star-boundary",
        section="3.5",
        where="proof of lemma (lem:m-star), line 951",
        kind="number",
        statement=(
            r"$\partial T_i$ is a Hamburger polygon with $2m_i$ sides: each ray is crossed by one "
            r"side, and the $2m_i$ vertices are the corners opposite $p_i$ in the quadrilaterals."
        ),
        hypotheses=(
            r"(used, not stated) the two quadrilaterals at a ray have the same length along it",
        ),
        rests_on=(
            "def:m-star",
            "3.5.hamburger-polygon",
            "3.5.stars-are-hamburger-polygons",
        ),
        checks=(
            Check(
                name="arcs and corners",
                run=_V + "star_boundary",
                routes=(
                    "families of the arcs between corners",
                    "2m sides",
                ),
                mutants=(Mutant(name="m sides", given={"per_order": 1}),),
            ),
        ),
    ),
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
                run=_V + "strip_formula",
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
                run=_V + "strip_differences",
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
                run=_V + "curvatures_match",
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
                run=_V + "strips_vanish",
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
                run=_V + "v_curvatures_match",
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
                run=_V + "v_strips_vanish",
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
                run=_V + "all_strips_vanish",
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
        id="3.5.alternating-rays",
        section="3.5",
        where="proof of lemma (lem:m-star), line 957",
        kind="sentence",
        statement=(
            r"$m_i$ $u$-curves and $m_i$ $v$-curves leave $p_i$, alternately and with well defined "
            r"tangents; they bound the $2m_i$ rhombi $R_0, \ldots, R_{2m_i-1}$ of the small star "
            r"$T_\varepsilon$."
        ),
        hypotheses=(r"$p_i$ has order of saddleness $m_i$",),
        rests_on=(
            "prop:assembly",
            "def:m-saddle",
        ),
        checks=(
            Check(
                name="torsions of the rays",
                run=_V + "alternating_rays",
                routes=(
                    "turning of the normal of star saddles",
                    "m curves of either family",
                ),
                mutants=(
                    Mutant(name="pairs of equal torsion", given={"shift": 2}),
                    Mutant(name="m + 1 curves", given={"per_family": 1}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="3.5.angles-sum-to-two-pi",
        section="3.5",
        where="proof of lemma (lem:m-star), line 958",
        kind="equation",
        statement=(
            r"$\sum_{j=0}^{2m_i-1}\alpha_j = 2\pi$ for the angles $\alpha_j$ of the rhombi $R_j$ "
            r"at $p_i$."
        ),
        hypotheses=(
            r"angles are measured with respect to the orientation given by $N(p_i)$",
            r"(used, not stated) the surface is an immersion at $p_i$, each $\alpha_j \in (0,\pi)$",
        ),
        rests_on=("def:m-star",),
        checks=(
            Check(
                name="tangents of the rays",
                run=_V + "angles_at_centre",
                routes=(
                    "inner products of neighbouring tangents",
                    "2 pi",
                ),
                mutants=(
                    Mutant(name="two turns", given={"turns": 2}),
                    Mutant(name="1.01 times 2 pi", given={"percent": 101}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="3.5.sector-angle",
        section="3.5",
        where="proof of lemma (lem:m-star), unlabelled equation, line 960",
        kind="equation",
        statement=(
            r"$\varphi_j = \alpha_j$ if $r_u$ turns into $r_v$ counterclockwise on sector $j$, and "
            r"$\varphi_j = \pi - \alpha_j$ otherwise."
        ),
        hypotheses=(
            r"$r_u$ and $r_v$ are directed away from $p_i$",
            r"counterclockwise is meant with respect to $\omega$",
        ),
        rests_on=("eq:def_phi",),
        checks=(
            Check(
                name="both senses",
                run=_V + "sector_angle",
                routes=(
                    "cos phi = sigma r_u . r_v, sin phi = |r_u x r_v|",
                    "the printed rule",
                ),
                mutants=(
                    Mutant(name="senses exchanged", given={"swapped": True}),
                    Mutant(name="2 pi - alpha", given={"whole": 2}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.5.angle-at-far-corner",
        section="3.5",
        where="proof of lemma (lem:m-star), line 963",
        kind="sentence",
        statement=(
            r"$\varphi(q_j) = \varphi_j + O(\varepsilon)$ at the corner $q_j$ of $R_j$ opposite "
            r"$p_i$."
        ),
        hypotheses=(
            r"$\varphi$ is the continuous extension from the interior of $R_j$",
            r"(used, not stated) $\varphi$ is Lipschitz on $R_j$; continuity alone gives $o(1)$",
        ),
        rests_on=("3.5.sector-angle",),
        checks=(
            Check(
                name="Taylor series",
                run=_V + "far_corner",
                routes=(
                    "Goursat problem with smooth data",
                    "order in eps",
                ),
                mutants=(
                    Mutant(name="O(eps^2)", given={"least": 2}, near=True),
                    Mutant(name="phi not Lipschitz on an edge", given={"lipschitz": False}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.5.star-sum",
        section="3.5",
        where="proof of lemma (lem:m-star), unlabelled equation, first equality, line 965",
        kind="equation",
        statement=(
            r"$\Delta_{T_\varepsilon} = \sum_j (-1)^i\varphi_j + O(\varepsilon)$ over the $2m_p$ "
            r"sectors."
        ),
        hypotheses=(
            r"(used, not stated) sector $0$ is one where $r_u$ turns into $r_v$ counterclockwise",
        ),
        rests_on=(
            "3.5.vertex-signs",
            "3.5.angle-at-far-corner",
            "3.5.star-boundary",
        ),
        checks=(
            Check(
                name="printed exponent",
                run=_V + "star_sum",
                routes=(
                    "integrated sine-Gordon equation",
                    "the printed sum",
                ),
                mutants=(
                    Mutant(name="twice the index of the branch point", given={"exponent": "2i"}),
                ),
            ),
            Check(
                name="exponent j",
                run=_V + "star_sum",
                form="corrected",
                given={"exponent": "j"},
                routes=(
                    "integrated sine-Gordon equation",
                    "the printed sum",
                ),
                mutants=(
                    Mutant(name="the printed exponent", given={"exponent": "i"}),
                    Mutant(name="j + 1", given={"exponent": "j+1"}, near=True),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"$\Delta_{T_\varepsilon} = \sum_j (-1)^i\varphi_j + O(\epsilon)$",
            corrected=r"$\Delta_{T_\varepsilon} = \sum_j (-1)^j\varphi_j + O(\varepsilon)$",
            kind="misprint",
            witness=(
                r"six equal sectors: $\varphi_j$ is $\frac\pi3$ and $\frac{2\pi}3$ in turn, so "
                r"that $\sum_j(-1)^i\varphi_j = \pm3\pi$, while $\Delta_{T_\varepsilon} \to -\pi$"
            ),
            conclusion_survives=True,
            remark="$i$ numbers the branch points; the second equality is for the exponent $j$",
        ),
    ),
    Claim(
        id="3.5.star-sum-value",
        section="3.5",
        where="proof of lemma (lem:m-star), unlabelled equation, second equality, line 965",
        kind="equation",
        statement=(
            r"The alternating sum of the $\varphi_j$ around $p$ is $-(m_p-2)\pi$, so "
            r"$\Delta_{T_\varepsilon} = -(m_p-2)\pi + O(\varepsilon)$."
        ),
        hypotheses=(
            r"$\sum_j\alpha_j = 2\pi$",
            r"counterclockwise and clockwise sectors alternate",
        ),
        rests_on=(
            "3.5.star-sum",
            "3.5.sector-angle",
            "3.5.angles-sum-to-two-pi",
            "3.5.alternating-rays",
        ),
        checks=(
            Check(
                name="arbitrary angles",
                run=_V + "star_sum_value",
                routes=(
                    "angles of sum 2 pi",
                    "the printed value",
                ),
                mutants=(
                    Mutant(name="m - 3 for m - 2", given={"regular": 3}, near=True),
                    Mutant(name="1.01 pi", given={"percent": 101}, near=True),
                    Mutant(name="angles of sum 4 pi", given={"turns": 2}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.5.star-decomposition",
        section="3.5",
        where="proof of lemma (lem:m-star), line 967",
        kind="sentence",
        statement=(
            r"$T_i$ is the union of $T_\varepsilon$, one thin rectangle along each ray, and one "
            r"quadrilateral in each sector, to which (eq:hazzidakis) applies; their $\Delta$ add "
            r"up to $\Delta_{T_i} = A(T_i) - (m_i-2)\pi$ as $\varepsilon \to 0$."
        ),
        hypotheses=(
            (
                r"(used, not stated) $\varepsilon$ is less than the lengths of the rays; then no "
                "corner of a piece lies on a ray"
            ),
        ),
        rests_on=(
            "eq:hazzidakis",
            "3.5.star-sum-value",
            "3.5.no-concentration-on-curves",
        ),
        checks=(
            Check(
                name="pieces",
                run=_V + "star_pieces",
                routes=(
                    "sums over the pieces",
                    "sum over the star",
                ),
                mutants=(
                    Mutant(name="no strips along v-rays", given={"strips": "u"}),
                    Mutant(name="m - 3 for m - 2", given={"regular": 3}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="3.5.two-saddle",
        section="3.5",
        where="after lemma (lem:m-star), line 970",
        kind="sentence",
        statement=(
            r"The argument applies where $m_p = 2$ also, and gives $\Delta_T = A(T)$ there, "
            r"whether or not the surface is $C^2$ at the point."
        ),
        hypotheses=(r"$m_p = 2$",),
        rests_on=("lem:m-star",),
        checks=(
            Check(
                name="order 2",
                run=_V + "two_saddle",
                routes=(
                    "integrated sine-Gordon equation on four sectors",
                    "area",
                ),
                mutants=(Mutant(name="order 3", given={"order": 3}, near=True),),
            ),
        ),
    ),
    Claim(
        id="3.5.concentration-sign",
        section="3.5",
        where="after lemma (lem:m-star), line 970",
        kind="sentence",
        statement=(
            r"The concentration of $\Delta$ at $p$ is $-(m_p-2)\pi$: negative at every branch "
            r"point, zero where the surface is locally a $2$-saddle."
        ),
        hypotheses=(r"$m_p \ge 2$",),
        rests_on=("lem:m-star",),
        checks=(
            Check(
                name="orders 2 to 8",
                run=_V + "concentration_sign",
                routes=(
                    "alternating sum of the angles at the centre",
                    "the printed value",
                ),
                mutants=(
                    Mutant(name="m - 3 for m - 2", given={"regular": 3}, near=True),
                    Mutant(name="opposite sign", given={"sign": 1}),
                ),
            ),
        ),
    ),
)
