"""Claims of section 3.2, m-stars: dual vectors of the rays."""

from checks.claim import Check, Claim, Erratum, Mutant

_RUN = "checks.verify.dual_vectors:"

_ANGLES = (
    r"$m \ge 2$ an integer, $\alpha_i \in (0, \pi)$ for $i = 1, \dots, 2m$",
    r"$\sum_{i=1}^{2m} \alpha_i = 2\pi$",
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
                r"$\mathbf s^*_{i+1}\cdot\mathbf s_i=-\sin(\beta_{i+1}-\beta_i)$, or "
                r"$\mathbf s^*_i\cdot\mathbf s_{i+1}=\sin(\beta_{i+1}-\beta_i)$"
            ),
            kind="misprint",
            witness=(
                r"$\beta_i=0$, $\beta_{i+1}=\pi/2$: $\mathbf s^*_{i+1}=\mathbf "
                r"e_3\times\mathbf e_2=-\mathbf e_1$, $\mathbf s_i=\mathbf e_1$, product "
                "$-1$, not $1$."
            ),
            conclusion_survives=True,
            remark=(
                r"The display for $(\xi_i,\eta_i)$ is right with this negative "
                "denominator."
            ),
        ),
    ),
    Claim(
        id="3.2.dual-product-angle",
        section="3.2",
        where="line 489",
        kind="equation",
        statement=r"$\sin(\beta_{i+1} - \beta_i) = \sin\alpha_i$.",
        hypotheses=_ANGLES,
        rests_on=("3.2.directions",),
        checks=(
            Check(
                name="as printed",
                run=_RUN + "dual_product_angle",
                routes=(
                    "printed index",
                    "recursion for beta",
                ),
                mutants=(Mutant(name="half the angle", given={"half": True}),),
            ),
            Check(
                name="alpha_(i+1)",
                run=_RUN + "dual_product_angle",
                routes=(
                    "corrected index",
                    "recursion for beta",
                ),
                mutants=(
                    Mutant(name="alpha_i", given={"shift": 0}),
                    Mutant(name="alpha_(i+2)", given={"shift": 2}),
                    Mutant(name="half the angle", given={"shift": 1, "half": True}),
                ),
                form="corrected",
                given={"shift": 1},
            ),
        ),
        erratum=Erratum(
            printed=r"$\sin(\beta_{i+1}-\beta_i)=\sin(\alpha_i)$",
            corrected=r"$\sin(\beta_{i+1}-\beta_i)=\sin(\alpha_{i+1})$",
            kind="misprint",
            witness=(
                r"$\beta_2-\beta_1=\alpha_2$ by definition; $\alpha_1=\pi/2$, "
                r"$\alpha_2=\pi/6$: $\frac12\ne1$."
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
        id="3.2.dual-product-positive",
        section="3.2",
        where="line 489",
        kind="sentence",
        statement=r"$\mathbf{s}^*_{i+1} \cdot \mathbf{s}_i > 0$, so the quotient that gives "
        r"$(\xi_i, \eta_i)$ is defined.",
        hypotheses=_ANGLES,
        rests_on=("3.2.dual-product", "3.2.dual-product-angle"),
        checks=(
            Check(
                name="as printed",
                run=_RUN + "dual_product_sign",
                routes=(
                    "printed product",
                    "half-angle",
                ),
                mutants=(
                    Mutant(
                        name="minus the product, angle 0 allowed",
                        given={"sign": -1, "nonzero_angle": False},
                    ),
                ),
            ),
            Check(
                name="negative",
                run=_RUN + "dual_product_sign",
                routes=(
                    "printed product",
                    "half-angle",
                ),
                mutants=(
                    Mutant(name="positive", given={"sign": 1}),
                    Mutant(name="angle 0 allowed", given={"sign": -1, "nonzero_angle": False}),
                ),
                form="corrected",
                given={"sign": -1},
            ),
        ),
        erratum=Erratum(
            printed=r"$\mathbf s^*_{i+1}\cdot\mathbf s_i>0$",
            corrected=(
                r"$\mathbf s^*_{i+1}\cdot\mathbf s_i=-\sin\alpha_{i+1}<0$, in particular "
                "not $0$"
            ),
            kind="misprint",
            witness=r"$\beta_i=0$, $\beta_{i+1}=\pi/2$: the product is $-1$.",
            conclusion_survives=True,
            remark="What is used, that the quotient is defined, survives.",
        ),
    ),
)

CLAIMS: tuple[Claim, ...] = _DUAL_VECTORS
