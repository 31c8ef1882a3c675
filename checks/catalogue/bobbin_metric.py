"""Claims of section 3.1, Minding's bobbin: metric, curvature, the largest disk."""

from checks.claim import Check, Claim, Erratum, Mutant

_METRIC = "checks.verify.bobbin_metric:"
_DISK = "checks.verify.bobbin_disk:"
_ONE_BOBBIN = r"$\kappa>0$ and $|s|<L=\operatorname{arcsinh}\kappa$"
_SUP = (
    r"$\mathcal E_\infty$ of a disk is the supremum over that disk of the absolute principal "
    r"curvatures (section 2)"
)

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="ex:bobbin",
        section="3.1",
        where="Example (ex:bobbin), line 358",
        kind="example",
        labels=("ex:bobbin",),
        statement=r"The surface of revolution with $\rho(s)=\kappa^{-1}\cosh s$, $z(0)=0$, "
        r"$z'^2+\rho'^2=1$ is Minding's bobbin: its meridians have arc length $s$, its throat is "
        r"a circle of curvature $\kappa$, and it is pseudospherical.",
        hypotheses=(_ONE_BOBBIN,),
        checks=(
            Check(
                name="radius",
                run=_METRIC + "profile",
                routes=(
                    "printed radius",
                    "theory.bobbin:radius",
                    "theory.surface_of_revolution:gauss_curvature",
                ),
                mutants=(
                    Mutant(name="cosh 2s", given={"rate": 2}),
                    Mutant(name="speed squared 2", given={"total": 2}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-throat-curvature",
        section="3.1",
        where="Example (ex:bobbin), line 358",
        kind="sentence",
        statement=r"The equator $s=0$, a circle, has curvature $\kappa$ in $\mathbb R^3$.",
        hypotheses=(r"$\kappa>0$",),
        rests_on=("ex:bobbin",),
        checks=(
            Check(
                name="circle",
                run=_METRIC + "throat",
                routes=("printed kappa", "theory.surface_of_revolution:curvature_of_parallel"),
                mutants=(Mutant(name="twice", given={"factor": 2}),),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-induced-metric",
        section="3.1",
        where="Example (ex:bobbin), line 358",
        kind="sentence",
        statement=r"In $\mathbb R^3$ it has the first form $g=ds^2+\rho^2\,d\theta^2$.",
        hypotheses=(_ONE_BOBBIN,),
        rests_on=("ex:bobbin",),
        checks=(
            Check(
                name="first form",
                run=_METRIC + "metric",
                routes=("printed coefficients", "theory.surface_of_revolution:first_form"),
                mutants=(Mutant(name="rho to the first power", given={"power": 1}),),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-gauss-curvature",
        section="3.1",
        where="Example (ex:bobbin), line 358",
        kind="sentence",
        statement=r"$K=-\rho''/\rho$, and this is $-1$.",
        hypotheses=(_ONE_BOBBIN,),
        rests_on=("ex:bobbin", "3.1.bobbin-induced-metric"),
        checks=(
            Check(
                name="both forms",
                run=_METRIC + "gauss",
                routes=("printed quotient", "theory.surface_of_revolution:gauss_curvature"),
                mutants=(
                    Mutant(name="sign of the quotient", given={"sign": 1}),
                    Mutant(name="value +1", given={"value": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-singular-edge",
        section="3.1",
        where="Example (ex:bobbin), line 358",
        kind="sentence",
        statement=r"The bobbin ends at $s=\pm L$, $L=\operatorname{arcsinh}\kappa<\infty$, where "
        r"$\rho'=\pm1$ and $z'=0$, and has no smooth continuation beyond.",
        hypotheses=(
            r"$\kappa>0$",
            r"(used, not stated) smooth means immersed: as a front the surface does continue",
        ),
        rests_on=("ex:bobbin",),
        checks=(
            Check(
                name="slopes and curvature",
                run=_METRIC + "singular_edge",
                routes=("printed L", "theory.bobbin:bobbin", "theory.bobbin:squared_curvatures"),
                mutants=(
                    Mutant(name="arccosh kappa", given={"inverse": "acosh"}),
                    Mutant(name="arctanh kappa", given={"inverse": "atanh"}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-cylinder",
        section="3.1",
        where="Example (ex:bobbin), line 359",
        kind="sentence",
        statement=r"The bobbin is a cylinder $S^1\times(-L,L)$.",
        hypotheses=(r"(used, not stated) the singular edges are left out",),
        rests_on=("ex:bobbin", "3.1.bobbin-singular-edge"),
        checks=(
            Check(
                name="embedding",
                run=_METRIC + "cylinder",
                routes=("theory.bobbin:radius", "theory.surface_of_revolution:first_form"),
                mutants=(
                    Mutant(name="period pi", given={"turn": "1"}),
                    Mutant(name="conical surface sinh", given={"ring": "cone"}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-universal-cover",
        section="3.1",
        where="Example (ex:bobbin), line 359",
        kind="sentence",
        statement=r"The universal cover of the bobbin is the strip $\mathbb R\times(-L,L)$: "
        r"isometrically, the points of $\mathbb H^2$ at distance less than $L$ from a geodesic.",
        hypotheses=(_ONE_BOBBIN,),
        rests_on=("3.1.bobbin-cylinder", "3.1.bobbin-induced-metric"),
        checks=(
            Check(
                name="Fermi coordinates",
                run=_METRIC + "universal_cover",
                routes=(
                    "theory.equidistant_strip:point",
                    "theory.surface_of_revolution:first_form",
                ),
                mutants=(Mutant(name="tau twice as long", given={"stretch": 2}),),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-disk-diameter",
        section="3.1",
        where="Example (ex:bobbin), line 359",
        kind="sentence",
        statement=r"Geodesic disks in the universal cover have diameter at most "
        r"$2\operatorname{arcsinh}\kappa$; the bound is attained by the open disk about a point "
        r"of the equator.",
        hypotheses=(r"$\kappa>0$",),
        rests_on=("3.1.bobbin-universal-cover",),
        checks=(
            Check(
                name="heights of a disk",
                run=_DISK + "largest_disk",
                routes=("printed bound", "theory.equidistant_strip:geodesic"),
                mutants=(
                    Mutant(name="radius for diameter", given={"factor": 1}),
                    Mutant(name="factor 3", given={"factor": 3}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-curvature-bound",
        section="3.1",
        where="after Example (ex:bobbin), line 369",
        kind="sentence",
        statement=r"A disk of radius $R$ in a bobbin forces $\mathcal E_\infty>\kappa>\sinh R$.",
        hypotheses=(
            _SUP,
            r"(used, not stated) $\mathcal E_\infty<\infty$: the closed disk avoids the edges",
        ),
        rests_on=("3.1.bobbin-disk-diameter", "3.1.bobbin-longitudinal-curvature"),
        checks=(
            Check(
                name="printed chain",
                run=_DISK + "curvature_chain",
                routes=("printed inequalities", "theory.bobbin:largest_on_disk"),
                mutants=(Mutant(name="cosh R", given={"lower": "cosh"}),),
            ),
            Check(
                name="weak, through the throat",
                run=_DISK + "curvature_chain",
                form="corrected",
                given={"strict": False, "meets_throat": True},
                routes=("corrected inequalities", "theory.bobbin:largest_on_disk"),
                mutants=(
                    Mutant(name="strict", given={"strict": True}),
                    Mutant(name="any disk", given={"meets_throat": False}),
                    Mutant(name="cosh R", given={"lower": "cosh"}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"$\mathcal{E}_\infty > \kappa > \sinh(R)$",
            corrected=r"$\mathcal E_\infty\ge\kappa>\sinh R$ for disks that meet the throat; on "
            r"the disk centred there, equality exactly where $\kappa\ge\cosh R$",
            kind="false",
            witness=r"$R=\log 2$ ($\sinh R=3/4$), $\kappa=2$, disk centred on the equator: the "
            r"largest azimuthal curvature is 2, the largest longitudinal one "
            r"$\sqrt{5/11}$, so $\mathcal E_\infty=2=\kappa$. Centred at height $\log 4$ in the "
            r"bobbin $\kappa=10$: $\mathcal E_\infty=\sqrt{1591}/5<8<\kappa$.",
            conclusion_survives=True,
            remark=r"Equality holds at the optimum of (eq:c2energy), $\kappa=\cosh R$. What is "
            r"used, $\mathcal E_\infty>\sinh R$, is true of every disk: $\mathcal "
            r"E_\infty\ge\cosh R$.",
        ),
    ),
    Claim(
        id="3.1.bobbin-bound-from-throat",
        section="3.1",
        where="after Example (ex:bobbin), line 369",
        kind="sentence",
        statement=r"The bound $\kappa$ is the azimuthal curvature at the throat, where that "
        r"curvature is largest; it is no effect of the singular edge.",
        hypotheses=(_ONE_BOBBIN,),
        rests_on=("3.1.bobbin-throat-curvature",),
        checks=(
            Check(
                name="azimuthal curvature",
                run=_METRIC + "azimuthal_bound",
                routes=("printed kappa", "theory.bobbin:squared_curvatures"),
                mutants=(
                    Mutant(name="at the edge", given={"at": "edge"}),
                    Mutant(name="half-way", given={"at": "half-way"}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-longitudinal-curvature",
        section="3.1",
        where="before equation (eq:c2energy), line 370",
        kind="sentence",
        statement=r"The longitudinal curvature is $\frac{d}{ds}\arcsin\rho'(s)="
        r"\cosh s\,(\kappa^2-\sinh^2 s)^{-1/2}$.",
        hypotheses=(_ONE_BOBBIN, r"(used, not stated) up to the side of the normal"),
        rests_on=("ex:bobbin",),
        checks=(
            Check(
                name="turning and second form",
                run=_METRIC + "longitudinal",
                routes=("printed quotient", "theory.surface_of_revolution:principal_curvatures"),
                mutants=(
                    Mutant(name="sinh above", given={"numerator": "sinh"}),
                    Mutant(name="power -1", given={"power": "-1"}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-divergence-rate",
        section="3.1",
        where="before equation (eq:c2energy), line 370",
        kind="sentence",
        statement=r"At the small distance $t$ from the edge the longitudinal curvature is of order "
        r"$t^{-1/2}$; in fact $\sim(2t\tanh L)^{-1/2}$.",
        hypotheses=(r"$\kappa>0$",),
        rests_on=("3.1.bobbin-longitudinal-curvature", "3.1.bobbin-singular-edge"),
        checks=(
            Check(
                name="order of the zero",
                run=_METRIC + "divergence",
                routes=("printed power", "theory.bobbin:squared_curvatures"),
                mutants=(
                    Mutant(name="power -1", given={"power": "-1"}),
                    Mutant(name="power -3/5", given={"power": "-3/5"}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-willmore-divergence",
        section="3.1",
        where="before equation (eq:c2energy), line 370",
        kind="sentence",
        statement=r"The Willmore energy $\int(\kappa_1^2+\kappa_2^2)\,dA$ diverges "
        r"logarithmically on every neighbourhood of a point of the edge.",
        hypotheses=(
            r"$\kappa>0$",
            r"(used, not stated) logarithmic in the distance $t$ to the edge at which one stops",
        ),
        rests_on=("3.1.bobbin-divergence-rate",),
        checks=(
            Check(
                name="pole of the density",
                run=_METRIC + "willmore",
                routes=("printed growth", "theory.bobbin:bending_density"),
                mutants=(
                    Mutant(name="a power", given={"growth": "power"}),
                    Mutant(name="first power of the curvatures", given={"power": 1}),
                    Mutant(name="fourth power of the curvatures", given={"power": 4}),
                ),
            ),
        ),
    ),
    Claim(
        id="eq:c2energy",
        section="3.1",
        where="equation (eq:c2energy), line 372",
        kind="equation",
        labels=("eq:c2energy",),
        statement=r"Among bobbins that contain a disk of radius $R$, $\inf\mathcal "
        r"E_\infty\ge\inf_{\kappa\ge\sinh R}\max\bigl(\kappa,\ \cosh R\,(\kappa^2-\sinh^2 "
        r"R)^{-1/2}\bigr)$; both sides are $\cosh R$.",
        hypotheses=(r"$R>0$", _SUP),
        rests_on=("3.1.bobbin-disk-diameter", "3.1.bobbin-longitudinal-curvature"),
        checks=(
            Check(
                name="both infima",
                tier="full",
                run=_DISK + "c2_bound",
                routes=("printed maximum", "theory.bobbin:largest_on_disk"),
                mutants=(
                    Mutant(name="twice the throat's", given={"throat": "2"}),
                    Mutant(name="throat 1% more", given={"throat": "101/100"}, near=True),
                    Mutant(name="sinh R above", given={"numerator": "sinh"}),
                    Mutant(name="power -1", given={"power": "-1"}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-global-balance",
        section="3.1",
        where="after equation (eq:c2energy), line 375",
        kind="sentence",
        statement=r"At the optimum the azimuthal curvature at the throat equals the longitudinal "
        r"curvature nearest the edge; this happens at $\kappa=\cosh R$ only.",
        hypotheses=(r"$R>0$", r"(used, not stated) the disk is centred on the throat"),
        rests_on=("eq:c2energy",),
        checks=(
            Check(
                name="crossing",
                run=_DISK + "balance",
                routes=("balance of the two curvatures", "theory.bobbin:largest_on_disk"),
                mutants=(
                    Mutant(name="exp R", given={"function": "exp"}),
                    Mutant(name="kappa 1% more", given={"factor": "101/100"}, near=True),
                ),
            ),
        ),
    ),
)
