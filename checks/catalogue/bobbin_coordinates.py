"""Claims of section 3.1, Minding's bobbin: its asymptotic coordinates."""

from checks.claim import Check, Claim, Erratum, Mutant

_COORDINATES = "checks.verify.bobbin_coordinates:"
_FRONT = "checks.verify.bobbin_front:"
_FLOW = "theory.bobbin:bobbin_flow"
_ANY_FLOW = "theory.pseudospherical_revolution:pseudospherical_flow"
_LINES = "theory.pseudospherical_revolution:asymptotic_tangents"
_KAPPA = r"$\kappa>0$"
_CLIMBING = r"(used, not stated) $u, v$ so oriented that the reflection takes $r_u$ to $r_v$"
_UNITS = r"(used, not stated) $u$ and $v$ are arc lengths"
_SIGNED = Mutant(name="sign dropped", given={"signed": False})
_WRONG_SIDE = r"$s'<0$, e.g. $\kappa=6/7$, $s=5/9$, "

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="fig:bobbin",
        section="3.1",
        where="figure (fig:bobbin), line 363",
        kind="figure",
        labels=("fig:bobbin",),
        statement=r"On Minding's bobbin the asymptotic curves are smooth, the singular edges are "
        r"cuspidal, and $N^\omega$ is defined along an asymptotic curve through them.",
        hypotheses=(_KAPPA,),
        rests_on=("ex:bobbin",),
        checks=(
            Check(
                name="caption",
                tier="full",
                run=_FRONT + "figure",
                routes=("caption", _FLOW, "theory.pseudospherical_revolution:meridian_normal"),
                mutants=(
                    Mutant(name="normal without sign", given={"factor": "1"}),
                    Mutant(name="cusp of orders 2, 4", given={"third": 4}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-reflection",
        section="3.1",
        where="after equation (eq:c2energy), line 377",
        kind="sentence",
        statement=r"The mirror in the plane of two opposite meridians, on any surface of "
        r"revolution with $K=-1$, keeps $s$, takes $u$-asymptotic curves to $v$-asymptotic curves "
        r"of the opposite torsion and back, and reverses $\partial_\theta$.",
        hypotheses=(r"$K=-1$", _UNITS),
        checks=(
            Check(
                name="mirror image",
                tier="full",
                run=_COORDINATES + "reflection",
                routes=(_ANY_FLOW, _LINES, "theory.pseudospherical_revolution:torsions"),
                mutants=(
                    Mutant(name="horizontal mirror", given={"mirror": "horizontal"}),
                    Mutant(name="equal torsions", given={"torsion": 1}),
                    Mutant(name="azimuth kept", given={"angular": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-parallel-fields",
        section="3.1",
        where="after equation (eq:c2energy), line 377",
        kind="sentence",
        statement=r"$\partial_s\parallel\partial_u+\partial_v$ and "
        r"$\partial_\theta\parallel\partial_u-\partial_v$.",
        hypotheses=(r"$K=-1$", _UNITS, _CLIMBING),
        rests_on=("3.1.bobbin-reflection",),
        checks=(
            Check(
                name="sum and difference",
                run=_COORDINATES + "parallel_fields",
                routes=(_LINES, "theory.surface_of_revolution:tangents"),
                mutants=(Mutant(name="v reversed", given={"sign": -1}),),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-azimuth-proportional",
        section="3.1",
        where="after equation (eq:c2energy), line 377",
        kind="sentence",
        statement=r"Two asymptotic curves of one family keep the same difference in $\theta$ at "
        r"every height, and $\theta\propto u-v$, on every pseudospherical surface of revolution.",
        hypotheses=(r"$K=-1$", _UNITS, _CLIMBING),
        rests_on=("3.1.bobbin-parallel-fields",),
        checks=(
            Check(
                name="constant rate",
                run=_COORDINATES + "proportional_azimuth",
                routes=(
                    "theory.surface_of_revolution:asymptotic_rates",
                    "derivative along a generic meridian",
                ),
                mutants=(Mutant(name="rho'' = rho^3", given={"power": 3}),),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-normalised-coordinates",
        section="3.1",
        where="after equation (eq:c2energy), line 377",
        kind="sentence",
        statement=r"There are asymptotic coordinates with $r_u\cdot r_u=r_v\cdot r_v=1$, "
        r"$s=s(u+v)$ and $\theta=\alpha u-\alpha v$, $\alpha$ constant.",
        hypotheses=(r"$K=-1$", r"either sign of $\alpha$; see (eq:bobbin_psfront)"),
        rests_on=("3.1.bobbin-azimuth-proportional",),
        checks=(
            Check(
                name="built tangents",
                run=_COORDINATES + "normalised",
                routes=("printed normalisation", _LINES),
                mutants=(Mutant(name="alpha (u + v)", given={"weight": 1}),),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-elliptic",
        section="3.1",
        where="after equation (eq:c2energy), line 379",
        kind="sentence",
        statement=r"On the bobbin $s(u+v)$ is expressed by elliptic functions (no formula is "
        r"printed): $\sinh s=\kappa\,\mathrm{cn}(u+v\mid m)$, $m=\kappa^2/(\kappa^2+1)$.",
        hypotheses=(_KAPPA, r"$\xi=0$ at a turning point $s=L$"),
        rests_on=("3.1.bobbin-normalised-coordinates", "eq:econs"),
        checks=(
            Check(
                name="Jacobi amplitude",
                run=_COORDINATES + "elliptic",
                routes=("definition of Jacobi's amplitude", _FLOW),
                mutants=(
                    Mutant(name="complementary parameter", given={"modulus": "complement"}),
                    Mutant(name="sn", given={"function": "sn"}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-killing-field",
        section="3.1",
        where="before equation (eq:bobbin), line 381",
        kind="sentence",
        statement=r"$\partial_\theta=\frac1{2\alpha}(\partial_u-\partial_v)$ is the Killing field "
        r"of the rotations.",
        hypotheses=(r"$\theta=\alpha u-\alpha v$, $s=s(u+v)$",),
        rests_on=("3.1.bobbin-normalised-coordinates",),
        checks=(
            Check(
                name="Lie derivative",
                run=_COORDINATES + "killing",
                routes=("printed field", _ANY_FLOW),
                mutants=(
                    Mutant(name="1/alpha", given={"factor": "1"}),
                    Mutant(name="sum", given={"sign": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-invariant-scalars",
        section="3.1",
        where="before equation (eq:bobbin), line 381",
        kind="sentence",
        statement=r"A scalar invariant under the rotations, such as $s,\varphi,\sigma$, is a "
        r"function of $u+v$.",
        hypotheses=(r"(used, not stated) orbits $u+v=\text{const}$ are connected in the domain",),
        rests_on=("3.1.bobbin-killing-field",),
        checks=(
            Check(
                name="one variable",
                run=_COORDINATES + "invariant_scalars",
                routes=("chain rule for a generic scalar", _FLOW),
                mutants=(Mutant(name="sum", given={"sign": 1}),),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-metric-cases",
        section="3.1",
        where="display before equation (eq:bobbin), line 384",
        kind="equation",
        statement=r"$g=du^2+2\sigma\cos\varphi\,du\,dv+dv^2$ is $\cos^2\frac\varphi2(du+dv)^2+"
        r"\sin^2\frac\varphi2(du-dv)^2$ for $\sigma=1$ and the same with sine and cosine "
        r"exchanged for $\sigma=-1$.",
        hypotheses=(r"$\cos\varphi=\sigma r_u\cdot r_v$",),
        rests_on=("eq:metrics",),
        checks=(
            Check(
                name="both cases",
                tier="full",
                run=_COORDINATES + "half_angles",
                routes=("printed cases", "induced metric of theory.bobbin"),
                mutants=(
                    Mutant(name="factor 1", given={"factor": 1}),
                    Mutant(name="cases exchanged", given={"exchanged": True}),
                ),
            ),
        ),
    ),
    Claim(
        id="eq:bobbin",
        section="3.1",
        where="equation (eq:bobbin), line 387",
        kind="equation",
        labels=("eq:bobbin",),
        statement=r"$\frac{ds}{d\xi}=\frac{1+\sigma}2\cos\frac\varphi2+\frac{1-\sigma}2"
        r"\sin\frac\varphi2$ and $\frac\alpha\kappa\cosh s=\frac{1+\sigma}2\sin\frac\varphi2+"
        r"\frac{1-\sigma}2\cos\frac\varphi2$.",
        hypotheses=(
            r"$\sigma=\pm1$, $\varphi\in[0,\pi]$, $\cos\varphi=\sigma r_u\cdot r_v$",
            r"(used, not stated) $\alpha>0$",
        ),
        rests_on=("3.1.bobbin-metric-cases", "eq:def_phi"),
        checks=(
            Check(
                name="printed",
                run=_COORDINATES + "first_order",
                routes=("printed right sides", _LINES),
                mutants=(Mutant(name="azimuthal sign", given={"about": -1}),),
            ),
            Check(
                name="with the sign of s'",
                run=_COORDINATES + "first_order",
                form="corrected",
                given={"signed": True},
                routes=("corrected right sides", _LINES),
                mutants=(_SIGNED, Mutant(name="azimuthal sign", given={"about": -1})),
            ),
        ),
        erratum=Erratum(
            printed=r"$\frac{ds}{d\xi}=\frac{1+\sigma}2\cos\frac\varphi2+\frac{1-\sigma}2\sin"
            r"\frac\varphi2$",
            corrected=r"the same where $s'\ge0$; in general the right side carries the factor "
            r"$\operatorname{sgn}s'$",
            kind="hypothesis",
            witness=_WRONG_SIDE + r"either $\sigma$: $s'=-0.475\ldots$, the right side is "
            r"$+0.475\ldots$",
            conclusion_survives=True,
            remark=r"Comparing metrics gives the square of each equation only. With "
            r"$\sigma=\operatorname{sgn}s'$, as it is set before (eq:NFront), the right side is "
            r"$\frac{1+\sigma}2\cos\frac\varphi2-\frac{1-\sigma}2\sin\frac\varphi2$.",
        ),
    ),
    Claim(
        id="3.1.bobbin-alpha",
        section="3.1",
        where="after equation (eq:bobbin), line 392",
        kind="sentence",
        statement=r"$\frac\alpha\kappa\cosh s\to1$ at the singular edge, from either side, "
        r"requires $\alpha=\kappa/\sqrt{\kappa^2+1}$, and this is the rate on the bobbin.",
        hypotheses=(_KAPPA, r"(used, not stated) $\alpha>0$"),
        rests_on=("eq:bobbin", "3.1.bobbin-singular-edge"),
        checks=(
            Check(
                name="edge and lines",
                run=_COORDINATES + "alpha_from_edge",
                routes=("printed alpha", _FLOW),
                mutants=(Mutant(name="kappa^2 + 2", given={"shift": 2}),),
            ),
        ),
    ),
)
