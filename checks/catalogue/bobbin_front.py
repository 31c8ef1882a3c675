"""Claims of section 3.1, Minding's bobbin: its asymptotic coordinates, its front and normals."""

from checks.claim import Check, Claim, Erratum, Mutant

_COORDINATES = "checks.verify.bobbin_coordinates:"
_ORBIT = "checks.verify.bobbin_orbit:"
_TURNING = "checks.verify.bobbin_turning:"
_FRONT = "checks.verify.bobbin_front:"

_FLOW = "theory.bobbin:bobbin_flow"
_ANY_FLOW = "theory.pseudospherical_revolution:pseudospherical_flow"
_LINES = "theory.pseudospherical_revolution:asymptotic_tangents"
_KAPPA = r"$\kappa>0$"
_SOLUTION = r"$s(\xi)$ solves (eq:econs), $\kappa>0$, $\sigma\in\{-1,1\}$"
_MOVING = r"$s'\neq0$"
_ORBIT_HYPOTHESIS = (
    r"(used, not stated) $s(\xi)$ is not constant and is $C^2$, that is, it obeys $s''=-V'(s)$"
)
_CLIMBING = r"(used, not stated) $u, v$ so oriented that the reflection takes $r_u$ to $r_v$"
_UNITS = r"(used, not stated) $u$ and $v$ are arc lengths"

_SIGNED = Mutant(name="sign dropped", given={"signed": False})
_WRONG_SIDE = r"$s'<0$, e.g. $\kappa=6/7$, $s=5/9$, "
_INHERITED = r"The step from (eq:bobbin) is right: the sign is that of (eq:bobbin) where $s'<0$."
_PARTICLE = (
    r"the unit mass obeys Newton's law $s''=-V'(s)$; (eq:econs) alone allows it to rest at "
    r"$s=\pm L$ as well"
)
_EXCHANGE = (
    r"With $\theta=\kappa(u-v)/\sqrt{\kappa^2+1}$ and $z'\ge0$ the $u$-curves have torsion $+1$ "
    r"and the $v$-curves $-1$, against item (B); exchanging $u$ and $v$ here mends (eq:NFront), "
    r"the direction of the normal and the Lelieuvre equations at once."
)

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
    Claim(
        id="3.1.bobbin-lemma",
        section="3.1",
        where="unnumbered Lemma, line 394",
        kind="lemma",
        statement=r"If $s$ solves (eq:econs), the angle $\varphi(u,v)$ of (eq:sg-soln) solves "
        r"$\partial_{uv}\varphi=\sigma\sin\varphi$ wherever $s'(u+v)\neq0$.",
        hypotheses=(_SOLUTION, _MOVING),
        rests_on=("eq:econs", "eq:sg-soln", "eq:sg"),
        checks=(
            Check(
                name="chain rule",
                run=_ORBIT + "lemma",
                routes=("printed angle and equation", "differentiation along both signs of s'"),
                mutants=(
                    Mutant(name="equation with kappa^2 + 2", given={"shift": 2}),
                    Mutant(name="angle with kappa^2 + 2", given={"angle_shift": 2}),
                    Mutant(name="arcs exchanged", given={"exchanged": True}),
                    Mutant(name="right side negative", given={"right": -1}),
                ),
            ),
            Check(
                name="measured angle",
                run=_ORBIT + "measured_angle",
                routes=("sine-Gordon equation", _LINES),
                mutants=(Mutant(name="right side negative", given={"right": -1}),),
            ),
        ),
    ),
    Claim(
        id="eq:econs",
        section="3.1",
        where="equation (eq:econs), line 396",
        kind="equation",
        labels=("eq:econs",),
        statement=r"$\bigl(\frac{ds}{d\xi}\bigr)^2+\frac1{\kappa^2+1}\cosh^2s=1$ along the "
        r"asymptotic curves of the bobbin.",
        hypotheses=(_KAPPA,),
        rests_on=("3.1.bobbin-normalised-coordinates",),
        checks=(
            Check(
                name="along the curves",
                run=_ORBIT + "energy_equation",
                routes=("printed equation", _FLOW),
                mutants=(
                    Mutant(name="kappa^2 + 2", given={"shift": 2}),
                    Mutant(name="minus cosh^2", given={"sign": -1}),
                ),
            ),
        ),
    ),
    Claim(
        id="eq:sg-soln",
        section="3.1",
        where="equation (eq:sg-soln), line 401",
        kind="equation",
        labels=("eq:sg-soln",),
        statement=r"$\varphi=(1+\sigma)\arcsin\frac{\cosh s}{\sqrt{\kappa^2+1}}+(1-\sigma)"
        r"\arccos\frac{\cosh s}{\sqrt{\kappa^2+1}}$ is the angle of (eq:def_phi) on the bobbin.",
        hypotheses=(_KAPPA, r"$\sigma=\pm1$, $|s|\le L$"),
        rests_on=("eq:def_phi", "eq:econs"),
        checks=(
            Check(
                name="cosine and sine",
                run=_ORBIT + "angle_formula",
                routes=("printed angle", _LINES),
                mutants=(
                    Mutant(name="kappa^2 + 2", given={"shift": 2}),
                    Mutant(name="arcs exchanged", given={"exchanged": True}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-proof-first-step",
        section="3.1",
        where="proof of the Lemma, line 407",
        kind="sentence",
        statement=r"Every solution of (eq:econs), with $\varphi$ from (eq:sg-soln), satisfies "
        r"(eq:bobbin).",
        hypotheses=(_SOLUTION, r"$\alpha=\kappa/\sqrt{\kappa^2+1}$"),
        rests_on=("eq:bobbin", "eq:econs", "eq:sg-soln"),
        checks=(
            Check(
                name="all signs",
                run=_ORBIT + "proof_first",
                routes=("printed angle and right sides", "printed energy equation"),
                mutants=(Mutant(name="twice the azimuthal one", given={"about": 2}),),
            ),
            Check(
                name="with the sign of s'",
                run=_ORBIT + "proof_first",
                form="corrected",
                given={"signed": True},
                routes=("corrected right sides", "printed energy equation"),
                mutants=(_SIGNED, Mutant(name="twice the azimuthal one", given={"about": 2})),
            ),
        ),
        erratum=Erratum(
            printed=r"any solution of (eq:econs) with (eq:sg-soln) satisfies (eq:bobbin)",
            corrected=r"it does with the factor $\operatorname{sgn}s'$ on the right side of the "
            r"first equation; as printed where $s'\ge0$ only",
            kind="false",
            witness=_WRONG_SIDE + r"either $\sigma$: $s'=-0.475\ldots$, the right side is "
            r"$+0.475\ldots$",
            conclusion_survives=True,
            remark=r"The sign enters the two displays of the proof once each and cancels. Or "
            r"replace $\xi$ by $-\xi$ where $s'<0$: (eq:econs) and $\varphi''$ are unchanged.",
        ),
    ),
    Claim(
        id="3.1.bobbin-proof-smoothness",
        section="3.1",
        where="proof of the Lemma, line 407",
        kind="sentence",
        statement=r"$s$ and $\varphi$ are smooth where $\sigma$ is constant: $\varphi'=2\sigma"
        r"\operatorname{sgn}(s')\sinh s/\sqrt{\kappa^2+1}$.",
        hypotheses=(_SOLUTION, _MOVING + ", the Lemma's domain"),
        rests_on=("eq:econs", "eq:sg-soln"),
        checks=(
            Check(
                name="derivative of the angle",
                run=_ORBIT + "proof_smooth",
                routes=("printed angle", "smooth function of s"),
                mutants=(Mutant(name="through a turning point", given={"through_edge": True}),),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-proof-product",
        section="3.1",
        where="proof of the Lemma, first display, line 409",
        kind="equation",
        statement=r"$\frac d{d\xi}\frac{\sinh s}{\sqrt{\kappa^2+1}}=\frac{\cosh "
        r"s}{\sqrt{\kappa^2+1}}\frac{ds}{d\xi}=\frac12\sin\varphi$.",
        hypotheses=(_SOLUTION,),
        rests_on=("3.1.bobbin-proof-first-step",),
        checks=(
            Check(
                name="all signs",
                run=_ORBIT + "proof_product",
                routes=("printed display", "printed energy equation"),
                mutants=(Mutant(name="sin phi", given={"factor": "1"}),),
            ),
            Check(
                name="with the sign of s'",
                run=_ORBIT + "proof_product",
                form="corrected",
                given={"signed": True},
                routes=("corrected display", "printed energy equation"),
                mutants=(_SIGNED, Mutant(name="sin phi", given={"factor": "1"})),
            ),
        ),
        erratum=Erratum(
            printed=r"$\frac{\cosh(s(\xi))}{\sqrt{\kappa^2+1}}\left(\frac{ds}{d\xi}\right)="
            r"\frac12\sin\varphi$",
            corrected=r"$\frac{\cosh(s(\xi))}{\sqrt{\kappa^2+1}}\left(\frac{ds}{d\xi}\right)="
            r"\frac{\mathrm{sgn}(s')}2\sin\varphi$",
            kind="false",
            witness=_WRONG_SIDE + r"either $\sigma$: left $-0.418\ldots$, right $+0.418\ldots$",
            conclusion_survives=True,
            remark=_INHERITED,
        ),
    ),
    Claim(
        id="3.1.bobbin-proof-quotient",
        section="3.1",
        where="proof of the Lemma, second display, line 413",
        kind="equation",
        statement=r"$\frac{\sinh s}{\sqrt{\kappa^2+1}}$ is the quotient of $\frac{1+\sigma}2\cos"
        r"\frac\varphi2\mp\frac{1-\sigma}2\sin\frac\varphi2$ times $\frac{\varphi'}2$, and equals "
        r"$\sigma\frac{\varphi'}2$.",
        hypotheses=(_SOLUTION, _MOVING, r"$\sigma$ locally constant"),
        rests_on=("3.1.bobbin-proof-first-step",),
        checks=(
            Check(
                name="all signs",
                run=_ORBIT + "proof_quotient",
                routes=("printed display", "printed energy equation"),
                mutants=(Mutant(name="plus above", given={"weight": 1}),),
            ),
            Check(
                name="with the sign of s'",
                run=_ORBIT + "proof_quotient",
                form="corrected",
                given={"signed": True},
                routes=("corrected display", "printed energy equation"),
                mutants=(_SIGNED, Mutant(name="plus above", given={"weight": 1})),
            ),
        ),
        erratum=Erratum(
            printed=r"$\frac{\sinh(s(\xi))}{\sqrt{\kappa^2+1}}=\ldots=\sigma\frac{\varphi'(\xi)}2$",
            corrected=r"$\frac{\sinh(s(\xi))}{\sqrt{\kappa^2+1}}=\ldots=\mathrm{sgn}(s')\,\sigma"
            r"\frac{\varphi'(\xi)}2$",
            kind="false",
            witness=_WRONG_SIDE + r"either $\sigma$: left $+0.443\ldots$, right $-0.443\ldots$",
            conclusion_survives=True,
            remark=_INHERITED,
        ),
    ),
    Claim(
        id="3.1.bobbin-proof-conclusion",
        section="3.1",
        where="proof of the Lemma, line 415",
        kind="sentence",
        statement=r"The two displays of the proof combine to $\partial_{uv}\varphi=\varphi''(u+v)"
        r"=\sigma\sin\varphi$.",
        hypotheses=(r"$\sigma=\pm1$ locally constant",),
        rests_on=("3.1.bobbin-proof-product", "3.1.bobbin-proof-quotient"),
        checks=(
            Check(
                name="elimination",
                run=_ORBIT + "proof_end",
                routes=("the two displays", "sine-Gordon equation"),
                mutants=(Mutant(name="one sign wrong", given={"first": -1}),),
            ),
            Check(
                name="both signs changed",
                run=_ORBIT + "proof_end",
                form="support",
                given={"first": -1, "second": -1},
                routes=("the two corrected displays for s' < 0", "sine-Gordon equation"),
                mutants=(Mutant(name="one sign wrong", given={"second": 1}),),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-energy-conservation",
        section="3.1",
        where="after the proof of the Lemma, line 417",
        kind="sentence",
        statement=r"With $\xi$ as time and $V(s)=\frac1{2(\kappa^2+1)}\cosh^2s$, (eq:econs) says "
        r"that a unit mass has the energy $\frac12$.",
        hypotheses=(_KAPPA,),
        rests_on=("eq:econs",),
        checks=(
            Check(
                name="energy and motion",
                run=_ORBIT + "conservation",
                routes=("printed potential", "printed energy equation", _FLOW),
                mutants=(Mutant(name="twice the potential", given={"factor": "1"}),),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-periodic-orbits",
        section="3.1",
        where="after the proof of the Lemma, line 417",
        kind="sentence",
        statement=r"The orbits $s(\xi)$ of the unit mass with this energy are bounded and "
        r"periodic.",
        hypotheses=(_KAPPA, _PARTICLE),
        rests_on=("eq:econs", "3.1.bobbin-energy-conservation"),
        checks=(
            Check(
                name="orbits of the unit mass",
                run=_ORBIT + "orbits",
                routes=("printed energy equation", _FLOW),
                mutants=(
                    Mutant(name="energy only", given={"law": "energy"}),
                    Mutant(name="potential reversed", given={"sign": -1}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-turning-points",
        section="3.1",
        where="after the proof of the Lemma, line 417",
        kind="sentence",
        statement=r"$s'=0$ exactly where $s=\pm L$.",
        hypotheses=(_KAPPA, r"$s$ solves (eq:econs)"),
        rests_on=("eq:econs", "3.1.bobbin-singular-edge"),
        checks=(
            Check(
                name="zeros of s'^2",
                run=_ORBIT + "turning_at_edge",
                routes=("printed energy equation", "theory.bobbin:half_length"),
                mutants=(Mutant(name="kappa^2 + 2", given={"shift": 2}),),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-turning-force",
        section="3.1",
        where="after the proof of the Lemma, line 417",
        kind="sentence",
        statement=r"Where the mass turns, $s'=0$ and $s''=-V'(s)\neq0$.",
        hypotheses=(_KAPPA, _PARTICLE),
        rests_on=("3.1.bobbin-turning-points", "3.1.bobbin-energy-conservation"),
        checks=(
            Check(
                name="orbits of the unit mass",
                run=_ORBIT + "turning_force",
                routes=("printed potential", _FLOW),
                mutants=(
                    Mutant(name="energy only", given={"law": "energy"}),
                    Mutant(name="twice the potential", given={"factor": "1"}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-global-solutions",
        section="3.1",
        where="after the proof of the Lemma, line 417",
        kind="sentence",
        statement=r"The solutions $s(u+v)$ exist for all $(u,v)\in\mathbb R^2$.",
        hypotheses=(_KAPPA, r"solutions of (eq:econs), continued as far as they can be"),
        rests_on=("eq:econs",),
        checks=(
            Check(
                name="bounds on s and s'",
                run=_ORBIT + "global_solutions",
                routes=("printed energy equation", "bounds by positive coefficients"),
                mutants=(Mutant(name="potential reversed", given={"sign": -1}),),
            ),
        ),
    ),
    Claim(
        id="eq:zprime",
        section="3.1",
        where="equation (eq:zprime), line 420",
        kind="equation",
        labels=("eq:zprime",),
        statement=r"$\bigl(\frac{dz}{d\xi}\bigr)^2=\bigl(1-\frac{\sinh^2s}{\kappa^2}\bigr)"
        r"\bigl(\frac{ds}{d\xi}\bigr)^2=\frac{(\kappa^2-\sinh^2s)^2}{\kappa^2(\kappa^2+1)}$.",
        hypotheses=(_KAPPA, r"$ds^2=d\rho^2+dz^2$"),
        rests_on=("eq:econs", "ex:bobbin"),
        checks=(
            Check(
                name="both equalities",
                run=_TURNING + "height_rate",
                routes=("printed expressions", _FLOW),
                mutants=(Mutant(name="not squared", given={"power": 1}),),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-zprime-vanishing",
        section="3.1",
        where="after equation (eq:zprime), line 423",
        kind="sentence",
        statement=r"The right side of (eq:zprime) vanishes to the second order in $L^2-s^2$, so "
        r"$z'=z''=0$ at turning points.",
        hypotheses=(_KAPPA,),
        rests_on=("eq:zprime", "3.1.bobbin-turning-points"),
        checks=(
            Check(
                name="order",
                run=_TURNING + "vanishing_order",
                routes=("printed right side", _FLOW),
                mutants=(
                    Mutant(name="order 1", given={"order": 1}),
                    Mutant(name="order 3", given={"order": 3}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-zprime-root",
        section="3.1",
        where="after equation (eq:zprime), line 423",
        kind="sentence",
        statement=r"The square root can be taken with $z'(\xi)\ge0$ for all $\xi$.",
        hypotheses=(_KAPPA,),
        rests_on=("eq:zprime",),
        checks=(
            Check(
                name="smooth root",
                run=_TURNING + "rising",
                routes=("printed right side", _FLOW),
                mutants=(Mutant(name="sign of s'", given={"root": "sgn s'"}),),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-turning-expansion",
        section="3.1",
        where="display after equation (eq:zprime), line 425",
        kind="equation",
        statement=r"Near a turning point $\rho=\rho_c-c_1(\xi-\xi_c)^2+O((\xi-\xi_c)^3)$ and "
        r"$z=z_c+c_2(\xi-\xi_c)^3+O((\xi-\xi_c)^4)$ with $\rho_c=\kappa^{-1}\sqrt{\kappa^2+1}$ "
        r"and $c_1,c_2>0$; in fact $c_1=\frac\kappa{2\sqrt{\kappa^2+1}}$, "
        r"$c_2=\frac\kappa{3\sqrt{\kappa^2+1}}$ and the errors are $O(4)$, $O(5)$.",
        hypotheses=(_KAPPA, _ORBIT_HYPOTHESIS),
        rests_on=("3.1.bobbin-zprime-vanishing", "3.1.bobbin-turning-force"),
        checks=(
            Check(
                name="derivatives",
                run=_TURNING + "expansions",
                routes=("printed orders and radius", _FLOW),
                mutants=(
                    Mutant(name="rho to order 3", given={"radius": 3}),
                    Mutant(name="z to order 2", given={"height": 2}),
                    Mutant(name="z to order 4", given={"height": 4}),
                    Mutant(name="kappa^2 + 2", given={"radius_shift": 2}),
                ),
            ),
        ),
    ),
    Claim(
        id="eq:bobbin_psfront",
        section="3.1",
        where="equation (eq:bobbin_psfront), line 431",
        kind="equation",
        labels=("eq:bobbin_psfront",),
        statement=r"$r(u,v)=(\rho\cos\theta,\rho\sin\theta,z)$ with $\rho,z$ at $u+v$ and "
        r"$\theta=\kappa(u-v)/\sqrt{\kappa^2+1}$ is the bobbin in asymptotic coordinates of unit "
        r"speed, with torsions $-1$ along $u$ and $+1$ along $v$.",
        hypotheses=(_KAPPA, r"$z'\ge0$", _ORBIT_HYPOTHESIS, r"item (B): the torsions' signs"),
        rests_on=("3.1.bobbin-alpha", "3.1.bobbin-zprime-root", "eq:econs"),
        checks=(
            Check(
                name="surface",
                tier="full",
                run=_FRONT + "front_surface",
                part="surface",
                routes=("printed map", "theory.pseudospherical_revolution:meridian_normal"),
                mutants=(
                    Mutant(name="kappa^2 + 2", given={"shift": 2}),
                    Mutant(name="speed squared 2", given={"speed": 2}),
                ),
            ),
            Check(
                name="surface, u and v exchanged",
                tier="full",
                run=_FRONT + "front_surface",
                form="corrected",
                given={"sense": -1},
                part="surface",
                routes=("corrected map", "theory.pseudospherical_revolution:meridian_normal"),
                mutants=(Mutant(name="kappa^2 + 2", given={"shift": 2}),),
            ),
            Check(
                name="torsions",
                tier="full",
                run=_FRONT + "front_torsions",
                part="torsions",
                routes=("printed map", "theory.pseudospherical_revolution:torsion"),
                mutants=(Mutant(name="torsion -2", given={"first": -2}),),
            ),
            Check(
                name="torsions, u and v exchanged",
                tier="full",
                run=_FRONT + "front_torsions",
                form="corrected",
                given={"sense": -1},
                part="torsions",
                routes=("corrected map", "theory.pseudospherical_revolution:torsion"),
                mutants=(
                    Mutant(name="printed sense", given={"sense": 1}),
                    Mutant(name="torsions exchanged", given={"first": 1}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"$\cos\left(\frac{\kappa(u-v)}{\sqrt{\kappa^2+1}}\right)$, "
            r"$\sin\left(\frac{\kappa(u-v)}{\sqrt{\kappa^2+1}}\right)$",
            corrected=r"$\cos\left(\frac{\kappa(v-u)}{\sqrt{\kappa^2+1}}\right)$, "
            r"$\sin\left(\frac{\kappa(v-u)}{\sqrt{\kappa^2+1}}\right)$",
            kind="misprint",
            witness=r"Throat, $s'>0$, $\theta=0$, $\kappa=1$: $r_u=(0,1,1)/\sqrt2$, $N=-e_1$, "
            r"$N_u=(0,-1,1)/\sqrt2=-N\times r_u$: torsion $+1$ along $u$ (for $-1$ it would be "
            r"$+N\times r_u$, item (C)).",
            conclusion_survives=True,
            remark=_EXCHANGE,
        ),
    ),
    Claim(
        id="3.1.bobbin-not-immersed",
        section="3.1",
        where="after equation (eq:bobbin_psfront), line 434",
        kind="sentence",
        statement=r"$r$ has rank 1 on the circles $u+v=\xi_c$, and rank 2 elsewhere.",
        hypotheses=(_KAPPA,),
        rests_on=("eq:bobbin_psfront", "3.1.bobbin-turning-points"),
        checks=(
            Check(
                name="area element",
                run=_FRONT + "not_immersed",
                routes=("printed map", _FLOW),
                mutants=(Mutant(name="at the throat", given={"at": "throat"}),),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-cuspidal",
        section="3.1",
        where="after equation (eq:bobbin_psfront), line 434",
        kind="sentence",
        statement=r"The singularities on $u+v=\xi_c$ are cuspidal: the meridian $(\rho,z)(\xi)$ "
        r"has an ordinary cusp there.",
        hypotheses=(_KAPPA,),
        rests_on=("3.1.bobbin-not-immersed", "3.1.bobbin-turning-expansion"),
        checks=(
            Check(
                name="ordinary cusp",
                run=_TURNING + "cusp",
                routes=("cusp criterion", _FLOW),
                mutants=(
                    Mutant(name="at the throat", given={"at": "throat"}),
                    Mutant(name="orders 2, 4", given={"third": 4}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-smooth-asymptotic-curves",
        section="3.1",
        where="after equation (eq:bobbin_psfront), line 434",
        kind="sentence",
        statement=r"The curves $u\mapsto r(u,v_0)$ and $v\mapsto r(u_0,v)$ are smooth and of unit "
        r"speed, also across the edges.",
        hypotheses=(_KAPPA, _ORBIT_HYPOTHESIS),
        rests_on=("eq:bobbin_psfront",),
        checks=(
            Check(
                name="speed",
                run=_FRONT + "smooth_curves",
                routes=("printed map", _FLOW),
                mutants=(Mutant(name="speed squared 2", given={"speed": 2}),),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-normal-direction",
        section="3.1",
        where="display before equation (eq:NFront), line 438",
        kind="equation",
        statement=r"$r_u\times r_v$ is a positive multiple of $s'\bigl(-\frac{dz}{ds}\cos\theta,"
        r"-\frac{dz}{ds}\sin\theta,\kappa^{-1}\sinh s\bigr)$.",
        hypotheses=(_KAPPA, _MOVING, r"$\theta=\kappa(u-v)/\sqrt{\kappa^2+1}$"),
        rests_on=("eq:bobbin_psfront",),
        checks=(
            Check(
                name="printed",
                run=_FRONT + "normal_direction",
                routes=("printed vector", "cross product on the printed map"),
                mutants=(Mutant(name="height reversed", given={"height": -1}),),
            ),
            Check(
                name="u and v exchanged",
                run=_FRONT + "normal_direction",
                form="corrected",
                given={"sense": -1},
                routes=("printed vector", "cross product on the corrected map"),
                mutants=(
                    Mutant(name="printed sense", given={"sense": 1}),
                    Mutant(name="height reversed", given={"height": -1}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"$N(u,v)\propto s'\left(-\frac{dz}{ds}\cos\theta,-\frac{dz}{ds}\sin\theta,"
            r"\frac{\sinh s}\kappa\right)$ with a positive factor",
            corrected=r"the same with $\theta=\kappa(v-u)/\sqrt{\kappa^2+1}$, the constant being "
            r"$2\alpha\rho$; with the printed $\theta$ it is $-2\alpha\rho$",
            kind="misprint",
            witness=r"Throat, $s'>0$, $\theta=0$, $\kappa=1$: $r_u=(0,1,1)/\sqrt2$, "
            r"$r_v=(0,-1,1)/\sqrt2$, $r_u\times r_v=(1,0,0)$; the printed vector is "
            r"$\frac1{\sqrt2}(-1,0,0)$.",
            conclusion_survives=True,
            remark=_EXCHANGE,
        ),
    ),
    Claim(
        id="3.1.bobbin-normal-flips",
        section="3.1",
        where="before equation (eq:NFront), line 440",
        kind="sentence",
        statement=r"$\frac{dz}{ds}=0$ at turning points, and the unit vector along $r_u\times r_v$ "
        r"jumps between $\pm\mathbf e_3$ at each of them.",
        hypotheses=(_KAPPA, _ORBIT_HYPOTHESIS),
        rests_on=("3.1.bobbin-normal-direction",),
        checks=(
            Check(
                name="one-sided limits",
                run=_FRONT + "flips",
                routes=(_LINES, "limits on the four quarter periods"),
                mutants=(Mutant(name="times sgn s'", given={"factor": "sgn s'"}),),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-normal-continuous",
        section="3.1",
        where="before equation (eq:NFront), line 440",
        kind="sentence",
        statement=r"$N^\omega=\sigma\,r_u\times r_v/\|r_u\times r_v\|$ with "
        r"$\sigma=\operatorname{sgn}s'$ extends to a $C^{1M}$ map, in fact an analytic one.",
        hypotheses=(_KAPPA, _ORBIT_HYPOTHESIS),
        rests_on=("3.1.bobbin-normal-flips", "eq:Nfront"),
        checks=(
            Check(
                name="one map on all quarters",
                tier="full",
                run=_FRONT + "continuous_normal",
                routes=(_LINES, "theory.pseudospherical_revolution:meridian_normal"),
                mutants=(Mutant(name="without sigma", given={"factor": "1"}),),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-slope-sign",
        section="3.1",
        where="before equation (eq:NFront), line 442",
        kind="sentence",
        statement=r"$\frac{dz}{ds}=\sigma\bigl|\frac{dz}{ds}\bigr|$ with "
        r"$\sigma=\operatorname{sgn}s'$, and $\bigl|\frac{dz}{ds}\bigr|=\sqrt{1-N_z^2}$.",
        hypotheses=(_KAPPA, r"$z'\ge0$", _MOVING),
        rests_on=("3.1.bobbin-zprime-root", "eq:econs"),
        checks=(
            Check(
                name="four quarters",
                run=_FRONT + "slope_sign",
                routes=("printed sign", _FLOW),
                mutants=(Mutant(name="without sigma", given={"factor": "1"}),),
            ),
        ),
    ),
    Claim(
        id="eq:NFront",
        section="3.1",
        where="equation (eq:NFront), line 444",
        kind="equation",
        labels=("eq:NFront",),
        statement=r"$N_z=\kappa^{-1}\sinh s$ and $N^\omega=\bigl(-\sigma\sqrt{1-N_z^2}\cos\theta,"
        r"-\sigma\sqrt{1-N_z^2}\sin\theta,N_z\bigr)$, $\theta=\kappa(\kappa^2+1)^{-1/2}(u-v)$.",
        hypotheses=(_KAPPA, r"$\sigma=\operatorname{sgn}s'$", r"$r$ is (eq:bobbin_psfront)"),
        rests_on=("3.1.bobbin-normal-continuous", "3.1.bobbin-slope-sign"),
        checks=(
            Check(
                name="printed",
                run=_FRONT + "front_normal",
                routes=("printed normal", "cross product on the printed map"),
                mutants=(Mutant(name="outward", given={"radial": 1}),),
            ),
            Check(
                name="u and v exchanged",
                tier="full",
                run=_FRONT + "front_normal",
                form="corrected",
                given={"sense": -1},
                routes=("corrected normal", "cross product on the corrected map"),
                mutants=(
                    Mutant(name="printed sense", given={"sense": 1}),
                    Mutant(name="outward", given={"radial": 1}),
                    Mutant(name="fourth power", given={"power": 4}),
                    Mutant(name="tanh", given={"function": "tanh"}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"$\theta=\kappa(\kappa^2+1)^{-1/2}(u-v)$",
            corrected=r"$\theta=\kappa(\kappa^2+1)^{-1/2}(v-u)$, here and in (eq:bobbin_psfront)",
            kind="misprint",
            witness=r"Throat, $\sigma=1$, $\theta=0$, $\kappa=1$: $\sigma r_u\times "
            r"r_v=(1,0,0)$, the printed $N^\omega$ is $(-1,0,0)$.",
            conclusion_survives=True,
            remark=_EXCHANGE,
        ),
    ),
    Claim(
        id="3.1.bobbin-lelieuvre",
        section="3.1",
        where="after equation (eq:NFront), line 448",
        kind="sentence",
        statement=r"(eq:NFront) and (eq:bobbin_psfront) satisfy the Lelieuvre equations "
        r"$r_u=N_u\times N$, $r_v=-N_v\times N$.",
        hypotheses=(_KAPPA, r"$\sigma=\operatorname{sgn}s'$"),
        rests_on=("eq:NFront", "eq:bobbin_psfront", "eq:lelieuvre"),
        checks=(
            Check(
                name="printed",
                run=_FRONT + "lelieuvre",
                routes=("printed map", "printed normal"),
                mutants=(Mutant(name="outward", given={"radial": 1}),),
            ),
            Check(
                name="u and v exchanged",
                tier="full",
                run=_FRONT + "lelieuvre",
                form="corrected",
                given={"sense": -1},
                routes=("corrected map", "corrected normal"),
                mutants=(
                    Mutant(name="printed sense", given={"sense": 1}),
                    Mutant(name="outward", given={"radial": 1}),
                    Mutant(name="u and v exchanged again", given={"orientation": -1}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"Lelieuvre equations for $N^\omega$ (eq:NFront) and $r$ (eq:bobbin_psfront)",
            corrected=r"it does once $\theta=\kappa(v-u)/\sqrt{\kappa^2+1}$ in both; as printed "
            r"$r_u=-N_u\times N$ and $r_v=N_v\times N$",
            kind="false",
            witness=r"Throat, $s'>0$, $\theta=0$, $\kappa=1$: $r_u=(0,1,1)/\sqrt2$, "
            r"$N=(-1,0,0)$, $N_u=(0,-1,1)/\sqrt2$, $N_u\times N=(0,-1,-1)/\sqrt2=-r_u$.",
            conclusion_survives=True,
            remark=_EXCHANGE + r" Replacing $N$ by $-N$ changes nothing.",
        ),
    ),
)
