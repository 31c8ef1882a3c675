"""Claims of section 3.2, m-stars: coordinates of two sectors, their smoothness, transitions."""

from checks.claim import Check, Claim, Erratum, Mutant

_RUN = "checks.verify.m_stars:"
_PAIRS = "checks.verify.star_combinations:"
_SETS = "checks.verify.star_sectors:"

_ANGLES = (
    r"$m \ge 2$ an integer, $\alpha_i \in (0, \pi)$ for $i = 1, \dots, 2m$",
    r"$\sum_{i=1}^{2m} \alpha_i = 2\pi$",
)
_LENGTHS = (
    r"lengths $l_i > 0$, $i = 1, \dots, 2m$",
    (
        r"(used, not stated) indices are cyclic modulo $2m$: $l_0 = l_{2m}$, $\mathbf{s}_0 = "
        r"\mathbf{s}_{2m}$, $S_{2m+1} = S_1$"
    ),
)
_STAR = _ANGLES + _LENGTHS
_NUMBERING = (
    r"(read) as in line 480, $S_i$ is here the sector between $\mathbf{s}_i$ and "
    r"$\mathbf{s}_{i+1}$, to which (def:sectors) gives the number $i + 1$, and $\alpha_i$ its "
    "angle: one slip of numbering, told once in the erratum of line 480"
)

_COORDINATES = (
    Claim(
        id="3.2.star-coordinates",
        section="3.2",
        where="coordinates of a pair of sectors, line 480",
        kind="definition",
        statement=r"$\mathbf{x} = \xi_i \mathbf{s}_i + \eta_i \mathbf{s}_{i+1}$ where "
        r"$\eta_i \ge 0$, and $\mathbf{x} = \xi_i \mathbf{s}_i - \eta_i \mathbf{s}_{i-1}$ where "
        r"$\eta_i < 0$, defines coordinates $(\xi_i, \eta_i)$.",
        hypotheses=_STAR,
        rests_on=("def:m-star",),
        checks=(
            Check(
                name="unique and consistent",
                run=_RUN + "pair_coordinates",
                routes=(
                    "printed formula",
                    "Cramer's rule in the plane of an arbitrary ray and its neighbours",
                ),
                mutants=(
                    Mutant(name="plus sign for eta < 0", given={"sign": 1}),
                    Mutant(name="s_(i+1) on both sides", given={"behind": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.2.coordinate-patch",
        section="3.2",
        where="line 480",
        kind="sentence",
        statement=r"The coordinates $(\xi_i, \eta_i)$ identify $(0, l_i) \times (-l_{i-1}, "
        r"l_{i+1})$ with the interior of $S_{i-1} \cup S_i$.",
        hypotheses=_STAR,
        rests_on=("3.2.star-coordinates", "3.2.star-neighbourhood"),
        checks=(
            Check(
                name="as printed",
                run=_SETS + "patch",
                routes=(
                    "printed combination of two rays",
                    "strips and cones cut out by cross products, rational stars",
                ),
                mutants=(Mutant(name="range of eta reversed", given={"range_swapped": True}),),
            ),
            Check(
                name="as printed, arbitrary angles",
                run=_PAIRS + "pair_sectors",
                routes=("printed pair", "printed sectors and their lengths"),
                mutants=(Mutant(name="plus sign for eta < 0", given={"sign": 1}),),
            ),
            Check(
                name="sectors i and i + 1, arbitrary angles",
                run=_PAIRS + "pair_sectors",
                routes=("printed pair", "printed sectors and their lengths"),
                mutants=(
                    Mutant(name="sectors i - 1 and i", given={"shift": 0}),
                    Mutant(name="plus sign for eta < 0", given={"shift": 1, "sign": 1}),
                ),
                form="corrected",
                given={"shift": 1},
            ),
            Check(
                name="sectors i and i + 1",
                run=_SETS + "patch",
                routes=(
                    "printed combination of two rays",
                    "strips and cones cut out by cross products, rational stars",
                ),
                mutants=(
                    Mutant(name="sectors i - 1 and i", given={"shift": 0}, near=True),
                    Mutant(name="sectors i + 1 and i + 2", given={"shift": 2}),
                    Mutant(name="range of eta reversed", given={"shift": 1, "range_swapped": True}),
                ),
                form="corrected",
                given={"shift": 1},
            ),
        ),
        erratum=Erratum(
            printed=r"$(0,l_i)\times(-l_{i-1},l_{i+1})\to(S_{i-1}\bigcup S_i)^0$",
            corrected=r"$(0,l_i)\times(-l_{i-1},l_{i+1})\to(S_i\bigcup S_{i+1})^0$",
            kind="misprint",
            witness=(
                r"Star with $\mathbf s_1=(\frac35,\frac45)$, $\mathbf s_2=(-1,0)$, "
                r"$\mathbf s_3=(0,-1)$, $\mathbf s_4=\mathbf s_0=(1,0)$: "
                r"$(\xi_1,\eta_1)=(\frac12,\frac12)$ is the point $\frac12\mathbf "
                r"s_1+\frac12\mathbf s_2=(-\frac15,\frac25)$ of the second quadrant, "
                "inside $S_2$, not in $S_0=S_4$ or $S_1$."
            ),
            conclusion_survives=True,
            remark=(
                r"One slip of numbering, counted here alone: from here to (eq:sector-coords) the "
                r"sector between $\mathbf s_i$ and $\mathbf s_{i+1}$ is called $S_i$ and its "
                r"angle $\alpha_i$, and so read $S^i$ of line 485, line 487, $\sin\alpha_i$ and "
                r"$\overline{S_i}$ of line 489 and (eq:sector-coords) are right; (def:sectors), "
                "line 494, the boundary data of line 503 and (prop:assembly) number it $i+1$."
            ),
        ),
    ),
    Claim(
        id="3.2.bi-lipschitz",
        section="3.2",
        where="line 480",
        kind="sentence",
        statement=r"The map between $(\xi_i, \eta_i) \in (0, l_i) \times (-l_{i-1}, l_{i+1})$ and "
        r"$\mathbf{x}$ is bi-Lipschitz.",
        hypotheses=(
            *_STAR,
            (
                r"(used, not stated) the angle of the two sectors together is below $2\pi$, "
                r"which $2m \ge 4$ gives; distances are those of $\mathbb{R}^2$"
            ),
        ),
        rests_on=("3.2.star-coordinates", "3.2.coordinate-patch"),
        checks=(
            Check(
                name="both sides add up",
                run=_RUN + "normal_part",
                routes=("printed coordinates", "cross product with the ray"),
                mutants=(
                    Mutant(name="plus sign for eta < 0", given={"sign": 1}),
                    Mutant(name="both points on one side", given={"opposite": True}),
                ),
                part="normal part",
            ),
            Check(
                name="two constants",
                run=_SETS + "bi_lipschitz",
                tier="full",
                routes=(
                    "bound by the part normal to the ray",
                    "squared distances at rational points",
                ),
                mutants=(
                    Mutant(name="both sides by s_(i+1)", given={"folded": True}),
                    Mutant(name="lower constant 50 times better", given={"lower": 50}),
                    Mutant(name="s_(i-2) for s_(i-1)", given={"behind": -2}, near=True),
                ),
                part="constants",
            ),
        ),
    ),
    Claim(
        id="3.2.not-smooth-across-ray",
        section="3.2",
        where="line 480",
        kind="sentence",
        statement=r"In general $(\xi_i, \eta_i)$ are not smooth on an open set that meets "
        r"$\{\eta_i = 0\}$.",
        hypotheses=(*_STAR, r"(used, not stated) $\alpha_i + \alpha_{i+1} \ne \pi$"),
        rests_on=("3.2.star-coordinates",),
        checks=(
            Check(
                name="jump of the derivative",
                run=_RUN + "kink",
                routes=(
                    "printed formula",
                    "Cramer's rule in the plane of an arbitrary ray and its neighbours",
                ),
                mutants=(Mutant(name="no jump", given={"complement": True}),),
            ),
        ),
    ),
    Claim(
        id="smoothness",
        section="3.2",
        where="remark (smoothness), line 482, first part",
        kind="remark",
        statement=r"All coordinate pairs $(\xi_i, \eta_i)$ are smooth only if "
        r"$\mathbf{s}_{i+1} = -\mathbf{s}_{i-1}$ for every $i$.",
        labels=("smoothness",),
        hypotheses=_STAR,
        rests_on=("3.2.star-coordinates",),
        checks=(
            Check(
                name="jump of the derivative",
                run=_RUN + "opposite_rays",
                routes=(
                    "printed formula",
                    "Cramer's rule in the plane of an arbitrary ray and its neighbours",
                ),
                mutants=(Mutant(name="s_(i+1) = s_(i-1)", given={"plus": True}),),
            ),
        ),
    ),
    Claim(
        id="3.2.smooth-stars",
        section="3.2",
        where="remark (smoothness), line 482, second part",
        kind="remark",
        statement=r"$\mathbf{s}_{i+1} = -\mathbf{s}_{i-1}$ for all $i$ forces $m = 2$, "
        r"$\alpha_1 + \alpha_2 = \pi$, $\alpha_1 = \alpha_3$ and $\alpha_2 = \alpha_4$.",
        hypotheses=_ANGLES,
        rests_on=("3.2.directions",),
        checks=(
            Check(
                name="linear equations for the angles",
                run=_RUN + "smooth_stars",
                routes=(
                    "sum of all equations",
                    "linear systems for m = 2 to 6 solved",
                ),
                mutants=(
                    Mutant(name="m = 3", given={"order": 3}),
                    Mutant(name="every other ray only", given={"every_ray": False}),
                    Mutant(name="sum 2 pi/3 of neighbours", given={"twice": 3}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.2.patch-overlap",
        section="3.2",
        where="line 485",
        kind="sentence",
        statement=r"The patches of $(\xi_i, \eta_i)$ and $(\xi_{i+1}, \eta_{i+1})$ overlap in the "
        r"interior of the sector printed $S^i$, read as $S_i$.",
        hypotheses=(*_STAR, _NUMBERING),
        rests_on=("3.2.coordinate-patch",),
        checks=(
            Check(
                name="points of two patches",
                run=_SETS + "overlap",
                routes=(
                    "printed combination of two rays",
                    "strips and cones cut out by cross products, rational stars",
                ),
                mutants=(
                    Mutant(name="numbered as in (def:sectors)", given={"shift": 0}, near=True),
                    Mutant(name="the sector after it", given={"shift": 2}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="3.2.transition",
        section="3.2",
        where="transition functions, line 485",
        kind="equation",
        statement=r"On the overlap of two neighbouring patches $\eta_{i+1} = -\xi_i$ and "
        r"$\xi_{i+1} = \eta_i$.",
        hypotheses=_STAR,
        rests_on=("3.2.star-coordinates", "3.2.patch-overlap"),
        checks=(
            Check(
                name="two expressions of a point",
                run=_RUN + "transition",
                routes=(
                    "printed formula",
                    "Cramer's rule in the plane of an arbitrary ray and its neighbours",
                ),
                mutants=(
                    Mutant(name="eta_(i+1) = xi_i", given={"sign": 1}),
                    Mutant(name="not exchanged", given={"exchanged": False}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.2.transition-smooth",
        section="3.2",
        where="line 485",
        kind="sentence",
        statement="The transition functions between neighbouring patches are Lipschitz, indeed "
        "smooth.",
        hypotheses=_STAR,
        rests_on=("3.2.transition",),
        checks=(
            Check(
                name="a rotation",
                run=_RUN + "transition_smooth",
                routes=(
                    "printed transition",
                    "derivatives",
                ),
                mutants=(
                    Mutant(name="a reflection", given={"sign": 1}),
                    Mutant(name="eta^2", given={"power": 2}),
                ),
            ),
        ),
    ),
)

CLAIMS: tuple[Claim, ...] = _COORDINATES
