"""Claims of section 3.2, m-stars: sectors, coordinates, transitions, asymptotic coordinates."""

from checks.claim import Claim

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
    ),
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
    ),
    Claim(
        id="3.2.patch-overlap",
        section="3.2",
        where="line 485",
        kind="sentence",
        statement=r"The patches of $(\xi_i, \eta_i)$ and $(\xi_{i+1}, \eta_{i+1})$ overlap in the "
        r"interior of the sector printed $S^i$, read as $S_i$.",
        hypotheses=_STAR,
        rests_on=("3.2.coordinate-patch",),
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
    ),
    Claim(
        id="3.2.dual-coordinates",
        section="3.2",
        where="display, line 487",
        kind="equation",
        statement=r"On the sector $S_i$, $(\xi_i, \eta_i) = (\mathbf{s}^*_{i+1} \cdot "
        r"\mathbf{s}_i)^{-1} (\mathbf{s}^*_{i+1} \cdot \mathbf{x},\, -\mathbf{s}^*_i \cdot "
        r"\mathbf{x})$.",
        hypotheses=(*_STAR, r"$\mathbf{s}^*_j = \mathbf{e}_3 \times \mathbf{s}_j$"),
        rests_on=("3.2.star-coordinates", "3.2.dual-vectors"),
    ),
    Claim(
        id="3.2.dual-vectors",
        section="3.2",
        where="line 489",
        kind="definition",
        statement=r"The dual vectors are $\mathbf{s}^*_j = \mathbf{e}_3 \times \mathbf{s}_j$, "
        r"with $\mathbf{s}^*_j \cdot \mathbf{s}_j = 0$.",
        hypotheses=_ANGLES,
        rests_on=("3.2.directions",),
    ),
    Claim(
        id="3.2.dual-product",
        section="3.2",
        where="line 489",
        kind="equation",
        statement=r"$\mathbf{s}^*_{i+1} \cdot \mathbf{s}_i = \sin(\beta_{i+1} - \beta_i)$.",
        hypotheses=_ANGLES,
        rests_on=("3.2.dual-vectors",),
    ),
    Claim(
        id="3.2.dual-product-angle",
        section="3.2",
        where="line 489",
        kind="equation",
        statement=r"$\sin(\beta_{i+1} - \beta_i) = \sin\alpha_i$.",
        hypotheses=_ANGLES,
        rests_on=("3.2.directions",),
    ),
    Claim(
        id="3.2.dual-product-positive",
        section="3.2",
        where="line 489",
        kind="sentence",
        statement=r"$\mathbf{s}^*_{i+1} \cdot \mathbf{s}_i > 0$, so the quotient that gives "
        r"$(\xi_i, \eta_i)$ is defined.",
        hypotheses=_ANGLES,
        rests_on=("3.2.dual-product", "3.2.dual-product-angle"),
    ),
    Claim(
        id="3.2.closure-lipschitz",
        section="3.2",
        where="line 489",
        kind="sentence",
        statement=r"The formulae with dual vectors extend $\xi_i, \eta_i$ to $\overline{S_i}$ as "
        r"Lipschitz functions.",
        hypotheses=_STAR,
        rests_on=("3.2.dual-coordinates",),
    ),
    Claim(
        id="3.2.origin-coordinates",
        section="3.2",
        where="line 489",
        kind="sentence",
        statement=r"$\mathbf{x} = 0$ if and only if $(\xi_i, \eta_i) = (0, 0)$.",
        hypotheses=_STAR,
        rests_on=("3.2.dual-coordinates",),
    ),
)

_ASYMPTOTIC_COORDINATES = (
    Claim(
        id="eq:sector-coords",
        section="3.2",
        where="equation (eq:sector-coords), line 491",
        kind="equation",
        statement=r"The asymptotic coordinates of the sector $S_i$ are $(u_i, v_i) = (\xi_i, "
        r"\eta_i)$ for even $i$ and $(u_i, v_i) = (\eta_i, \xi_i)$ for odd $i$.",
        labels=("eq:sector-coords",),
        hypotheses=_STAR,
        rests_on=("3.2.star-coordinates",),
    ),
    Claim(
        id="3.2.ray-coordinates-even",
        section="3.2",
        where="line 494",
        kind="equation",
        statement=r"For even $i$, $0 \le u_i = u_{i+1} < l_i$ and $v_i = v_{i+1} = 0$ on "
        r"$S_i \cap S_{i+1}$.",
        hypotheses=(*_STAR, "$i$ even"),
        rests_on=("eq:sector-coords", "3.2.star-neighbourhood"),
    ),
    Claim(
        id="3.2.ray-coordinates-odd",
        section="3.2",
        where="line 494",
        kind="equation",
        statement=r"For odd $i$, $u_i = u_{i+1} = 0$ and $0 \le v_i = v_{i+1} < l_i$ on "
        r"$S_i \cap S_{i+1}$.",
        hypotheses=(*_STAR, "$i$ odd"),
        rests_on=("eq:sector-coords", "3.2.star-neighbourhood"),
    ),
)

CLAIMS: tuple[Claim, ...] = _STARS + _COORDINATES + _ASYMPTOTIC_COORDINATES
