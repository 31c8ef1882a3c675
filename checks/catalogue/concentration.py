"""Claims of section 3.5 on jumps and thin rectangles, and the lemma (lem:m-star)."""

from checks.claim import Check, Claim, Erratum, Mutant

_AMSLER = "checks.verify.amsler_stars:"
_RAYS = "checks.verify.star_rays:"
_STAR = "checks.verify.concentration:"

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
                run=_RAYS + "jumps",
                routes=(
                    "angles of seven stars",
                    "sums of neighbouring angles",
                ),
                mutants=(Mutant(name="order 2 too", given={"smallest": 2}),),
            ),
            Check(
                name="all but two rays",
                run=_RAYS + "jumps",
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
                run=_STAR + "figure",
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
                run=_RAYS + "sector_angle_by_parity",
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
                run=_STAR + "star_lemma",
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
                run=_AMSLER + "star_by_quadrature",
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
                run=_AMSLER + "shrinking_stars",
                routes=(
                    "certified PIII at the corners",
                    "limit with its error bound",
                ),
                mutants=(
                    Mutant(name="m - 1 for m - 2", given={"regular": 1}, near=True),
                    Mutant(name="1.01 pi", given={"percent": 101}, near=True),
                ),
            ),
            Check(
                name="corners of nets in the hyperbolic plane",
                run=_AMSLER + "corners_of_nets",
                form="support",
                routes=(
                    "half-turns on the hyperboloid",
                    "midpoint rule on the Taylor series of the angle",
                ),
                mutants=(
                    Mutant(name="m - 3 for m - 2", given={"regular": 3}, near=True),
                    Mutant(name="opposite sign of the corners", given={"sign": -1}),
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
                run=_STAR + "star_boundary",
                routes=(
                    "families of the arcs between corners",
                    "2m sides",
                ),
                mutants=(Mutant(name="m sides", given={"per_order": 1}),),
            ),
        ),
    ),
)
