"""Claims of section 3.1, Minding's bobbin: the Lemma, its solution and its proof."""

from checks.claim import Check, Claim, Erratum, Mutant

_ORBIT = "checks.verify.bobbin_orbit:"
_FLOW = "theory.bobbin:bobbin_flow"
_LINES = "theory.pseudospherical_revolution:asymptotic_tangents"
_KAPPA = r"$\kappa>0$"
_SOLUTION = r"$s(\xi)$ solves (eq:econs), $\kappa>0$, $\sigma\in\{-1,1\}$"
_MOVING = r"$s'\neq0$"
_SIGNED = Mutant(name="sign dropped", given={"signed": False})
_WRONG_SIDE = r"$s'<0$, e.g. $\kappa=6/7$, $s=5/9$, "
_INHERITED = r"The step from (eq:bobbin) is right: the sign is that of (eq:bobbin) where $s'<0$."

CLAIMS: tuple[Claim, ...] = (
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
)
