"""Claims of section 3.2, m-stars: rays, sectors, the star they make."""

from checks.claim import Check, Claim, Mutant

_RUN = "checks.verify.m_stars:"
_SETS = "checks.verify.star_sectors:"
_FUNCTIONS = "checks.verify.star_functions:"

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

_STARS = (
    Claim(
        id="3.2.asymptotic-rays",
        section="3.2",
        where="number of asymptotic rays, line 467",
        kind="sentence",
        statement=r"The even number $2m \ge 4$ counts the asymptotic rays that leave the origin.",
        hypotheses=(
            r"$2m \ge 4$ even",
            r"(used, not stated) rays of the $u$- and of the $v$-family alternate, $m$ of each",
        ),
        rests_on=("def:m-star", "eq:sector-coords"),
        checks=(
            Check(
                name="families of rays",
                run=_FUNCTIONS + "rays",
                routes=(
                    "count of the indices by parity",
                    "directions of random stars",
                ),
                mutants=(
                    Mutant(name="odd number of sectors", given={"odd_count": True}, near=True),
                    Mutant(name="three families", given={"families": 3}),
                ),
            ),
        ),
    ),
    Claim(
        id="def:m-star",
        section="3.2",
        where="definition (def:m-star), lines 469-478",
        kind="definition",
        statement=r"The $m$-star with angles $\alpha_i$ and lengths $l_i$ is the union "
        r"$T = \bigcup_{i=1}^{2m} S_i \subset \mathbb{R}^2$ of its $2m$ sectors, with the subspace "
        r"topology.",
        labels=("def:m-star",),
        hypotheses=_STAR,
        rests_on=("def:sectors",),
        checks=(
            Check(
                name="instances",
                run=_RUN + "definition",
                routes=(
                    "printed conditions",
                    "list of stars and of near-misses",
                ),
                mutants=(
                    Mutant(name="sum left out", given={"whole_turn": False}),
                    Mutant(name="angles up to pi", given={"below_pi": False}),
                    Mutant(name="lengths not positive", given={"positive": False}),
                    Mutant(name="odd number of rays", given={"even": False}),
                ),
            ),
            Check(
                name="a neighbourhood of the origin",
                run=_SETS + "neighbourhood",
                tier="full",
                routes=(
                    "printed combination of two rays",
                    "strips and cones cut out by cross products, rational stars",
                ),
                mutants=(
                    Mutant(name="a sector missing", given={"missing": 1}, near=True),
                    Mutant(name="closed sectors", given={"closed": True}),
                ),
            ),
        ),
    ),
    Claim(
        id="def:sectors",
        section="3.2",
        where="equation (def:sectors) in definition (def:m-star), line 473",
        kind="equation",
        statement=r"$S_i = \{c\,\mathbf{s}_{i-1} + d\,\mathbf{s}_i : 0 \le c < l_{i-1},\ "
        r"0 \le d < l_i\}$ for $i = 1, \dots, 2m$.",
        labels=("def:sectors",),
        hypotheses=_STAR,
        rests_on=("3.2.directions",),
        checks=(
            Check(
                name="cone of the angle alpha_i",
                run=_RUN + "cone",
                routes=(
                    "printed combination",
                    "cross products with the rays, symbolic",
                ),
                mutants=(
                    Mutant(name="rays i, i + 1", given={"first": 0, "second": 1}),
                    Mutant(name="rays i - 1, i + 1", given={"second": 1}),
                    Mutant(name="rays exchanged", given={"first": 0, "second": -1}),
                ),
            ),
            Check(
                name="half-open parallelogram",
                run=_SETS + "sectors",
                routes=(
                    "printed combination of two rays",
                    "strips and cones cut out by cross products, rational stars",
                ),
                mutants=(
                    Mutant(
                        name="rays and lengths i, i + 1", given={"first": 0, "second": 1}, near=True
                    ),
                    Mutant(name="outer sides included", given={"closed": True}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.2.directions",
        section="3.2",
        where="definition (def:m-star), lines 470-471",
        kind="definition",
        statement=r"$\beta_0 = 0$, $\beta_i = \beta_{i-1} + \alpha_i$, and $\mathbf{s}_i = "
        r"\cos\beta_i\,\mathbf{e}_1 + \sin\beta_i\,\mathbf{e}_2$ are unit vectors, which close up: "
        r"$\beta_{2m} = 2\pi$.",
        hypotheses=_ANGLES,
        checks=(
            Check(
                name="units that close up",
                run=_RUN + "directions",
                routes=(
                    "printed recursion and directions",
                    "normal form for 4, 6, 8 arbitrary angles",
                ),
                mutants=(
                    Mutant(name="beta_0 = 1", given={"start": 1}),
                    Mutant(name="alpha_(i-1) for alpha_i", given={"lag": 1}),
                    Mutant(name="a quarter turn ahead", given={"quarter_turns": 1}),
                    Mutant(name="sum 2 pi + 1", given={"extra": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.2.star-neighbourhood",
        section="3.2",
        where="definition (def:m-star), line 476",
        kind="sentence",
        statement=r"$T$ is an open neighbourhood of the origin in $\mathbb{R}^2$; sectors have "
        r"disjoint interiors, $S_i \cap S_{i+1} = \{t\,\mathbf{s}_i : 0 \le t < l_i\}$, and "
        r"sectors that are not neighbours meet in the origin alone.",
        hypotheses=_STAR,
        rests_on=("def:m-star",),
        checks=(
            Check(
                name="polar angles of a sector",
                run=_RUN + "cone",
                routes=("printed combination", "cross products with the rays, symbolic"),
                mutants=(
                    Mutant(name="rays i, i + 1", given={"first": 0, "second": 1}),
                    Mutant(name="rays i - 1, i + 1", given={"second": 1}),
                ),
                part="cones",
            ),
            Check(
                name="open, with common rays",
                run=_SETS + "neighbourhood",
                tier="full",
                routes=(
                    "printed combination of two rays",
                    "strips and cones cut out by cross products, rational stars",
                ),
                mutants=(
                    Mutant(name="closed sectors", given={"closed": True}),
                    Mutant(
                        name="next but one sector shares the ray", given={"apart": 2}, near=True
                    ),
                    Mutant(name="a sector missing", given={"missing": 1}, near=True),
                ),
                part="open",
            ),
        ),
    ),
)

CLAIMS: tuple[Claim, ...] = _STARS
