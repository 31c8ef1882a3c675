"""Claims of section 3.2, m-stars: dual vectors of the rays."""

from checks.claim import Check, Claim, Erratum, Mutant

_RUN = "checks.verify.dual_vectors:"

_ANGLES = (
    r"$m \ge 2$ an integer, $\alpha_i \in (0, \pi)$ for $i = 1, \dots, 2m$",
    r"$\sum_{i=1}^{2m} \alpha_i = 2\pi$",
)

_NUMBERING = (
    r"(read) as in line 480, $S_i$ is here the sector between $\mathbf{s}_i$ and "
    r"$\mathbf{s}_{i+1}$, to which (def:sectors) gives the number $i + 1$, and $\alpha_i$ its "
    "angle: one slip of numbering, told once in the erratum of line 480"
)

_DUAL_VECTORS = (
    Claim(
        id="3.2.dual-vectors",
        section="3.2",
        where="line 489",
        kind="definition",
        statement=r"The dual vectors are $\mathbf{s}^*_j = \mathbf{e}_3 \times \mathbf{s}_j$, "
        r"with $\mathbf{s}^*_j \cdot \mathbf{s}_j = 0$.",
        hypotheses=_ANGLES,
        rests_on=("3.2.directions",),
        checks=(
            Check(
                name="a quarter turn",
                run=_RUN + "dual_vectors",
                routes=(
                    "printed cross product",
                    "inner and cross products",
                ),
                mutants=(
                    Mutant(name="s x e_3", given={"sense": -1}),
                    Mutant(name="of the next ray", given={"of": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.2.dual-product",
        section="3.2",
        where="line 489",
        kind="equation",
        statement=r"$\mathbf{s}^*_{i+1} \cdot \mathbf{s}_i = \sin(\beta_{i+1} - \beta_i)$.",
        hypotheses=_ANGLES,
        rests_on=("3.2.dual-vectors",),
        checks=(
            Check(
                name="as printed",
                run=_RUN + "dual_product",
                routes=(
                    "printed value",
                    "dual vector by components",
                ),
                mutants=(Mutant(name="twice the sine", given={"sign": 2}),),
            ),
            Check(
                name="with the minus sign",
                run=_RUN + "dual_product",
                routes=(
                    "corrected value",
                    "dual vector by components",
                ),
                mutants=(
                    Mutant(name="plus sign", given={"sign": 1}),
                    Mutant(name="twice", given={"sign": -2}),
                ),
                form="corrected",
                given={"sign": -1},
            ),
        ),
        erratum=Erratum(
            printed=r"$\mathbf s^*_{i+1}\cdot\mathbf s_i=\sin(\beta_{i+1}-\beta_i)$",
            corrected=(
                r"$\mathbf s^*_{i+1}\cdot\mathbf s_i=-\sin(\beta_{i+1}-\beta_i)$, or, leaving "
                r"this, $\mathbf s^*_j=\mathbf s_j\times\mathbf e_3$"
            ),
            kind="misprint",
            witness=(
                r"$\beta_i=0$, $\beta_{i+1}=\pi/2$: $\mathbf s^*_{i+1}=\mathbf "
                r"e_3\times\mathbf e_2=-\mathbf e_1$, $\mathbf s_i=\mathbf e_1$, product "
                "$-1$, not $1$."
            ),
            conclusion_survives=True,
            remark=(
                "One sign, here or in the dual vectors: nothing else depends on it, neither the "
                r"display for $(\xi_i,\eta_i)$, a quotient, nor the $\pm$ and the modulus of "
                r"$\mathbf s^*_{i-1}\cdot\mathbf s_i$ further on."
            ),
        ),
    ),
    Claim(
        id="3.2.dual-product-angle",
        section="3.2",
        where="line 489",
        kind="equation",
        statement=r"$\sin(\beta_{i+1} - \beta_i) = \sin\alpha_i$.",
        hypotheses=(*_ANGLES, _NUMBERING),
        rests_on=("3.2.directions",),
        checks=(
            Check(
                name="angle of the sector",
                run=_RUN + "dual_product_angle",
                routes=("printed angle of the sector", "recursion for beta"),
                mutants=(
                    Mutant(name="numbered as in (def:sectors)", given={"ahead": 0}),
                    Mutant(name="the next angle", given={"ahead": 2}),
                    Mutant(name="half the angle", given={"half": True}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.2.dual-product-positive",
        section="3.2",
        where="line 489",
        kind="sentence",
        statement=r"$\sin\alpha_i > 0$, the last relation of the chain, so that the quotient "
        r"that gives $(\xi_i, \eta_i)$ is defined.",
        hypotheses=(
            *_ANGLES,
            _NUMBERING,
            (
                r"the sign of $\mathbf{s}^*_{i+1} \cdot \mathbf{s}_i$ itself belongs to the first "
                "relation of the chain, an erratum of its own; its square is used here"
            ),
        ),
        rests_on=("3.2.dual-product", "3.2.dual-product-angle"),
        checks=(
            Check(
                name="sine and square of the product",
                run=_RUN + "dual_product_sign",
                routes=("printed product", "half-angle"),
                mutants=(
                    Mutant(name="angle 0 allowed", given={"nonzero_angle": False}),
                    Mutant(name="angles beyond pi", given={"beyond": 2}),
                ),
            ),
        ),
    ),
)

CLAIMS: tuple[Claim, ...] = _DUAL_VECTORS
