"""Claims of section 3.2, m-stars: coordinates of a sector, asymptotic coordinates."""

from checks.claim import Check, Claim, Erratum, Mutant

_RUN = "checks.verify.dual_vectors:"
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

_COORDINATES = (
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
        checks=(
            Check(
                name="on S_i, as printed",
                run=_RUN + "dual_coordinates",
                routes=(
                    "printed formula",
                    "Cramer's rule in the plane of an arbitrary ray and its neighbours",
                ),
                mutants=(
                    Mutant(name="plus sign", given={"sign": 1}),
                    Mutant(name="exchanged", given={"exchanged": True}),
                ),
            ),
            Check(
                name="on S_(i+1)",
                run=_RUN + "dual_coordinates",
                routes=(
                    "printed formula",
                    "Cramer's rule in the plane of an arbitrary ray and its neighbours",
                ),
                mutants=(
                    Mutant(name="on S_i", given={"shift": 0}),
                    Mutant(name="plus sign", given={"shift": 1, "sign": 1}),
                    Mutant(name="exchanged", given={"shift": 1, "exchanged": True}),
                ),
                form="corrected",
                given={"shift": 1},
            ),
        ),
        erratum=Erratum(
            printed=(
                r"on the sector $S_i$, $(\xi_i,\eta_i)=\frac1{\mathbf "
                r"s^*_{i+1}\cdot\mathbf s_i}(\mathbf s^*_{i+1}\cdot\mathbf x,-\mathbf "
                r"s^*_i\cdot\mathbf x)$"
            ),
            corrected="the same on the sector $S_{i+1}$",
            kind="misprint",
            witness=(
                r"Six angles $\pi/3$: $\mathbf s_0=\mathbf s_1-\mathbf s_2$. At $\mathbf "
                r"x=\frac12\mathbf s_0\in S_1$ the definition gives "
                r"$(\xi_1,\eta_1)=(0,-\frac12)$, the display $(\frac12,-\frac12)$."
            ),
            conclusion_survives=True,
            remark=(
                r"The passage from line 480 to 489 numbers the sector between $\mathbf "
                r"s_i$ and $\mathbf s_{i+1}$ by $i$; (def:sectors), line 494 and the "
                "boundary data of line 503 number it by $i+1$. On $S_i$ the display "
                r"needs $i-1$ for $i+1$ and $\eta_i<0$."
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
        hypotheses=_STAR,
        rests_on=("3.2.dual-coordinates",),
        checks=(
            Check(
                name="on the closure of S_i, as printed",
                run=_RUN + "closure",
                routes=(
                    "printed formula",
                    "Cramer's rule in the plane of an arbitrary ray and its neighbours",
                ),
                mutants=(Mutant(name="half the squared gradient", given={"constant": 2}),),
            ),
            Check(
                name="on the closure of S_(i+1)",
                run=_RUN + "closure",
                routes=(
                    "printed formula",
                    "Cramer's rule in the plane of an arbitrary ray and its neighbours",
                ),
                mutants=(
                    Mutant(name="on S_i", given={"shift": 0}),
                    Mutant(name="twice the squared gradient", given={"shift": 1, "constant": 2}),
                ),
                form="corrected",
                given={"shift": 1},
            ),
        ),
        erratum=Erratum(
            printed=(
                r"these formulae extend the coordinates $\xi_i,\eta_i$ to the closure "
                r"$\overline{S_i}$ as Lipschitz functions"
            ),
            corrected=r"to the closure $\overline{S_{i+1}}$",
            kind="misprint",
            witness=(
                r"Six angles $\pi/3$, $\mathbf x=\frac12\mathbf s_0$ in $S_1$: "
                r"$(\xi_1,\eta_1)=(0,-\frac12)$, the formulae give $(\frac12,-\frac12)$: "
                "Lipschitz, but no extension of the coordinates."
            ),
            conclusion_survives=True,
            remark=(
                r"The passage from line 480 to 489 numbers the sector between $\mathbf "
                r"s_i$ and $\mathbf s_{i+1}$ by $i$; (def:sectors), line 494 and the "
                "boundary data of line 503 number it by $i+1$."
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
        hypotheses=_STAR,
        rests_on=("3.2.star-coordinates",),
        checks=(
            Check(
                name="as printed",
                run=_RUN + "sector_coordinates",
                routes=(
                    "printed formula",
                    "Cramer's rule in the plane of an arbitrary ray and its neighbours",
                ),
                mutants=(Mutant(name="odd for even", given={"even": 1}),),
            ),
            Check(
                name="xi_(i-1) for eta_i",
                run=_RUN + "sector_coordinates",
                routes=(
                    "printed formula",
                    "Cramer's rule in the plane of an arbitrary ray and its neighbours",
                ),
                mutants=(
                    Mutant(name="eta_i", given={"second": "eta"}),
                    Mutant(name="odd for even", given={"second": "xi_before", "even": 1}),
                ),
                form="corrected",
                given={"second": "xi_before"},
            ),
        ),
        erratum=Erratum(
            printed=(
                r"$(u_i,v_i)=(\xi_i,\eta_i)$ if $i$ is even, $(\eta_i,\xi_i)$ if $i$ is "
                "odd"
            ),
            corrected=(
                r"$(u_i,v_i)=(\xi_i,\xi_{i-1})$ if $i$ is even, $(\xi_{i-1},\xi_i)$ if "
                r"$i$ is odd; here $\xi_{i-1}=-\eta_i$ on $S_i$"
            ),
            kind="misprint",
            witness=(
                r"On $S_i$ with its rays $\mathbf s_{i-1},\mathbf s_i$, $\mathbf "
                r"x=\xi_i\mathbf s_i-\eta_i\mathbf s_{i-1}$ with $\eta_i\le0$: as "
                r"printed $v_2=\eta_2=-1$ at $\mathbf x=\mathbf s_1+\mathbf s_2$, "
                r"against $v_i\ge0$ and $\mathbf e_v=\mathbf s_{i-1}$ (line 503)."
            ),
            conclusion_survives=True,
            remark=(
                r"Numbering the sector between $\mathbf s_i$ and $\mathbf s_{i+1}$ by "
                "$i$, as line 480 does, gives the printed form but contradicts "
                r"(def:sectors), $u_i=u_{i+1}$ on $S_i\cap S_{i+1}$ for even $i$ (line "
                r"494) and $\mathbf e_u=\mathbf s_i$, $\mathbf e_v=\mathbf s_{i-1}$ "
                "(line 503)."
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
                    Mutant(name="ray i + 1", given={"ahead": 1}),
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
                    Mutant(name="ray i + 1", given={"ahead": 1}),
                ),
            ),
        ),
    ),
)

CLAIMS: tuple[Claim, ...] = _COORDINATES + _ASYMPTOTIC_COORDINATES
