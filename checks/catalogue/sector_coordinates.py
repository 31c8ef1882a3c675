"""Claims of section 3.2, m-stars: coordinates of a sector, asymptotic coordinates."""

from checks.claim import Check, Claim, Mutant

_RUN = "checks.verify.dual_vectors:"
_FUNCTIONS = "checks.verify.star_functions:"
_PAIRS = "checks.verify.star_combinations:"

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
        id="3.2.dual-coordinates",
        section="3.2",
        where="display, line 487",
        kind="equation",
        statement=r"On the sector $S_i$, $(\xi_i, \eta_i) = (\mathbf{s}^*_{i+1} \cdot "
        r"\mathbf{s}_i)^{-1} (\mathbf{s}^*_{i+1} \cdot \mathbf{x},\, -\mathbf{s}^*_i \cdot "
        r"\mathbf{x})$.",
        hypotheses=(*_STAR, _NUMBERING, r"$\mathbf{s}^*_j = \mathbf{e}_3 \times \mathbf{s}_j$"),
        rests_on=("3.2.star-coordinates", "3.2.dual-vectors"),
        checks=(
            Check(
                name="coefficients of s_i and s_(i+1)",
                run=_RUN + "dual_coordinates",
                routes=(
                    "printed formula",
                    "combination of an arbitrary ray and its neighbours",
                ),
                mutants=(
                    Mutant(name="numbered as in (def:sectors)", given={"ahead": 0}),
                    Mutant(name="plus sign", given={"sign": 1}),
                    Mutant(name="exchanged", given={"exchanged": True}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.2.closure-lipschitz",
        section="3.2",
        where="line 489",
        kind="sentence",
        statement=r"The formulae with dual vectors extend $\xi_i, \eta_i$ to $\overline{S_i}$ as "
        r"Lipschitz functions.",
        hypotheses=(*_STAR, _NUMBERING),
        rests_on=("3.2.dual-coordinates",),
        checks=(
            Check(
                name="on the closed sector",
                run=_RUN + "closure",
                routes=(
                    "printed formula",
                    "combination of an arbitrary ray and its neighbours",
                ),
                mutants=(
                    Mutant(name="numbered as in (def:sectors)", given={"ahead": 0}),
                    Mutant(name="twice the squared gradient", given={"constant": 2}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.2.origin-coordinates",
        section="3.2",
        where="line 489",
        kind="sentence",
        statement=r"$\mathbf{x} = 0$ if and only if $(\xi_i, \eta_i) = (0, 0)$.",
        hypotheses=_STAR,
        rests_on=("3.2.dual-coordinates",),
        checks=(
            Check(
                name="both ways",
                run=_RUN + "origin",
                routes=(
                    "printed formula",
                    "Cramer's rule in the plane of an arbitrary ray and its neighbours",
                ),
                mutants=(Mutant(name="eta = 1 at the origin", given={"offset": 1}),),
            ),
        ),
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
        hypotheses=(
            *_STAR,
            _NUMBERING,
            (
                r"(used, not stated) read with (def:sectors) throughout, $v_i = \eta_i \le 0$ for "
                r"even $i$, and $\xi_{i-1} = -\eta_i$ is meant, as lines 494 and 503 show"
            ),
        ),
        rests_on=("3.2.star-coordinates",),
        checks=(
            Check(
                name="along the even and the odd ray",
                run=_RUN + "sector_coordinates",
                routes=(
                    "printed formula",
                    "coefficients along the even and the odd ray of the sector",
                ),
                mutants=(
                    Mutant(name="numbered as in (def:sectors)", given={"ahead": 0}),
                    Mutant(name="odd for even", given={"even": 1}),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="arbitrary angles",
                run=_PAIRS + "ray_coordinates",
                routes=("stated values", "Cramer's rule in the plane of two rays"),
                mutants=(
                    Mutant(name="along v", given={"along": "v"}),
                    Mutant(name="odd rays", given={"parity": 1}),
                    Mutant(name="families exchanged", given={"even": 1}),
                    Mutant(name="ray i + 1", given={"ahead": 1}),
                ),
            ),
            Check(
                name="on even rays",
                run=_FUNCTIONS + "ray_coordinates",
                routes=(
                    "stated values",
                    "coefficients by cross products, rational stars",
                ),
                mutants=(
                    Mutant(name="along v", given={"along": "v"}),
                    Mutant(name="odd rays", given={"parity": 1}),
                    Mutant(name="families exchanged", given={"even": 1}),
                    Mutant(name="ray i + 1", given={"ahead": 1}, near=True),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="arbitrary angles",
                run=_PAIRS + "odd_ray_coordinates",
                routes=("stated values", "Cramer's rule in the plane of two rays"),
                mutants=(
                    Mutant(name="along u", given={"along": "u"}),
                    Mutant(name="even rays", given={"parity": 0}),
                    Mutant(name="families exchanged", given={"even": 1}),
                    Mutant(name="ray i + 1", given={"ahead": 1}),
                ),
            ),
            Check(
                name="on odd rays",
                run=_FUNCTIONS + "odd_ray_coordinates",
                routes=(
                    "stated values",
                    "coefficients by cross products, rational stars",
                ),
                mutants=(
                    Mutant(name="along u", given={"along": "u"}),
                    Mutant(name="even rays", given={"parity": 0}),
                    Mutant(name="families exchanged", given={"even": 1}),
                    Mutant(name="ray i + 1", given={"ahead": 1}, near=True),
                ),
            ),
        ),
    ),
)

CLAIMS: tuple[Claim, ...] = _COORDINATES + _ASYMPTOTIC_COORDINATES
