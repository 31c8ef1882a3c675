"""Claims of section 3.5 on the concentration of the alternating sum at branch points."""

from checks.claim import Check, Claim, Erratum, Mutant

_RAYS = "checks.verify.star_rays:"
_STAR = "checks.verify.concentration:"
_STRIPS = "checks.verify.thin_strips:"

CLAIMS: tuple[Claim, ...] = (
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
                run=_RAYS + "alternating_rays",
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
                run=_RAYS + "angles_at_centre",
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
                run=_RAYS + "sector_angle",
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
                run=_STRIPS + "far_corner",
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
                run=_STAR + "star_sum",
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
                run=_STAR + "star_sum",
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
                run=_STAR + "star_sum_value",
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
                run=_STAR + "star_pieces",
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
                run=_STAR + "two_saddle",
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
                run=_STAR + "concentration_sign",
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
