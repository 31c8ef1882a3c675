"""Claims of appendix A, asymptotics of Painleve III."""

from checks.claim import Check, Claim, Erratum, Mutant

_REG = r"$\varphi(0) = \varphi_0$, $\varphi'(0) = 0$"
_MATCH = r"$z \gg 1$, $\delta \ll 1$"
_LINEAR = "checks.verify.linearised_painleve:"
_PENDULUM = "checks.verify.pendulum_matching:"
_AMPLITUDE = "checks.verify.pendulum_amplitude:"
_LINES = "checks.verify.matched_asymptotics:"
_CROSSING = "checks.verify.crossing_estimate:"
_UNIFORM = "checks.verify.uniform_asymptotics:"
_BOUNDS = "checks.verify.asymptotics_and_bounds:"
_CERTIFIED = "theory.painleve (balls)"
_REFERENCE = "theory.painleve_reference (mpmath)"
_MATCHING = "theory.painleve_matching (separatrix and friction)"

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="A.linearised",
        section="A",
        where="appendix A, displayed formula, line 1624",
        kind="equation",
        statement=(
            r"For $\varphi \ll 1$ equation (PIII) becomes $\varphi'' + \frac{\varphi'}{z} - "
            r"\varphi = 0$, $\varphi(0) = \varphi_0$, $\varphi'(0) = 0$."
        ),
        hypotheses=(
            r"$\varphi \ll 1$",
            r"(used, not stated) $\varphi(0) = \varphi_0$, $\varphi'(0) = 0$",
        ),
        rests_on=("PIII",),
        checks=(
            Check(
                name="variation",
                run=_LINEAR + "linearised",
                routes=(
                    "printed operator",
                    "first variation of PIII (sympy)",
                ),
                mutants=(
                    Mutant(name="damping 2/z", given={"damping": 2}),
                    Mutant(name="plus phi", given={"linear": 1}),
                    Mutant(name="slope 1 at 0", given={"slope": "1"}),
                ),
            ),
            Check(
                name="order in phi0",
                run=_LINEAR + "linearisation_order",
                routes=(
                    "series of I_0",
                    _REFERENCE,
                ),
                mutants=(
                    Mutant(name="I_0(1.01 z)", given={"rate": "101/100"}, near=True),
                    Mutant(name="order 3", given={"order": 3}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="A.bessel-solution",
        section="A",
        where="appendix A, line 1626",
        kind="equation",
        statement=r"Its solution is $\varphi(z) = \varphi_0 I_0(z)$.",
        hypotheses=(_REG,),
        rests_on=("A.linearised",),
        checks=(
            Check(
                name="series",
                run=_LINEAR + "bessel_solution",
                routes=(
                    "series of I_0, index a symbol",
                    "theory.bessel_expansions:origin_coefficients",
                ),
                mutants=(
                    Mutant(name="I_1", given={"order": 1}),
                    Mutant(name="J_0", given={"sign": -1}),
                    Mutant(name="I_0(2 z)", given={"rate": "2"}),
                    Mutant(name="I_0(1.01 z)", given={"rate": "101/100"}, near=True),
                ),
            ),
            Check(
                name="integral",
                run=_LINEAR + "bessel_integral",
                routes=(
                    "printed operator",
                    "theory.bessel_expansions:kernel",
                ),
                mutants=(
                    Mutant(name="damping 2/z", given={"damping": 2}),
                    Mutant(name="plus phi", given={"linear": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="A.inner",
        section="A",
        where="appendix A, displayed formula, line 1629",
        kind="equation",
        statement=(
            r"$\varphi_{\mathrm{inner}}(z) = \varphi_0\left(1 + \frac{z^2}{4} + O(z^4)\right)$."
        ),
        hypotheses=(r"$z \ll 1$", r"(used, not stated) $\varphi_0 \ll 1$"),
        rests_on=("A.bessel-solution",),
        checks=(
            Check(
                name="coefficients",
                run=_LINEAR + "inner_series",
                routes=(
                    "printed terms",
                    "theory.bessel_expansions:origin_coefficients",
                ),
                mutants=(
                    Mutant(name="z^2/2", given={"coefficient": "1/2"}),
                    Mutant(name="z^3/4", given={"power": 3}),
                    Mutant(name="error O(z^5)", given={"order": 5}),
                ),
            ),
            Check(
                name="error term",
                run=_LINEAR + "inner_error",
                routes=(
                    "printed terms",
                    "I_0 in balls",
                ),
                mutants=(
                    Mutant(name="1 % more z^2", given={"coefficient": "101/400"}, near=True),
                    Mutant(name="O(z^5)", given={"order": 5}, near=True),
                ),
            ),
            Check(
                name="observed order",
                run=_LINEAR + "inner_order",
                routes=(
                    "printed terms",
                    "theory.bessel_reference:i0",
                ),
                mutants=(
                    Mutant(name="1 % more z^2", given={"coefficient": "101/400"}, near=True),
                    Mutant(name="order 3", given={"order": 3}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="A.outer",
        section="A",
        where="appendix A, displayed formula, line 1630",
        kind="equation",
        statement=(
            r"$\varphi_{\mathrm{outer}}(z) = \varphi_0\frac{e^z}{\sqrt{2\pi z}}\left(1 + "
            r"\frac{1}{8z} + O\left(\frac{1}{z^2}\right)\right)$."
        ),
        hypotheses=(
            r"$z \gg 1$",
            r"(used, not stated) $\varphi \ll 1$ still: $\varphi_0 e^z \ll \sqrt{z}$",
        ),
        rests_on=("A.bessel-solution",),
        checks=(
            Check(
                name="coefficients",
                run=_LINEAR + "outer_series",
                routes=(
                    "printed terms",
                    "theory.bessel_expansions:watson_coefficients",
                ),
                mutants=(
                    Mutant(name="sqrt(pi z)", given={"under": "1"}),
                    Mutant(name="-1/(8 z)", given={"correction": "-1/8"}),
                    Mutant(name="1 % more", given={"factor": "101/100"}, near=True),
                ),
            ),
            Check(
                name="error term",
                run=_LINEAR + "outer_error",
                routes=(
                    "printed terms",
                    "I_0 in balls",
                ),
                mutants=(
                    Mutant(name="O(z^-3)", given={"power": 3}, near=True),
                    Mutant(name="1 % more 1/z", given={"correction": "101/800"}, near=True),
                ),
            ),
            Check(
                name="observed order",
                run=_LINEAR + "outer_order",
                routes=(
                    "printed terms",
                    "theory.bessel_reference:i0",
                ),
                mutants=(
                    Mutant(name="1 % more 1/z", given={"correction": "101/800"}, near=True),
                    Mutant(name="order -3", given={"order": -3}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="A.damped-pendulum",
        section="A",
        where="appendix A, displayed formula, line 1634",
        kind="equation",
        statement=r"$\varphi'' - \sin\varphi = -\frac{\varphi'}{z} \approx 0$.",
        hypotheses=(
            r"$z \gg 1$, $\varphi \approx \pi$",
            r"(used, not stated) $\varphi'$ is bounded",
        ),
        rests_on=("PIII",),
        checks=(
            Check(
                name="rearranged",
                run=_PENDULUM + "damped_pendulum",
                routes=(
                    "printed sides",
                    "PIII (sympy)",
                ),
                mutants=(
                    Mutant(name="driven", given={"damping": 1}),
                    Mutant(name="sine changed in sign", given={"sine": 1}),
                ),
            ),
            Check(
                name="size of the friction",
                run=_PENDULUM + "dropped_friction",
                routes=(
                    "bound 2/z",
                    _CERTIFIED,
                ),
                mutants=(
                    Mutant(name="1/z^2", given={"power": 2}),
                    Mutant(name="slope below 1", given={"most": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="A.pendulum-solution",
        section="A",
        where="appendix A, displayed formula, line 1638",
        kind="equation",
        statement=(
            r"$\varphi_{\mathrm{pend}}(z) \approx \pi - A\sin(z^* - z)$, with $A$ slowly "
            "varying."
        ),
        hypotheses=(
            r"$z \gg 1$, $\varphi \approx \pi$",
            (
                r"(used, not stated) $|\pi - \varphi| \ll 1$, that is $|z^* - z| \ll 1$ when $A$ "
                "is near $2$"
            ),
        ),
        rests_on=("A.damped-pendulum",),
        checks=(
            Check(
                name="linearised",
                run=_PENDULUM + "pendulum_solution",
                routes=(
                    "printed form",
                    "linearisation of sin (sympy)",
                ),
                mutants=(
                    Mutant(name="about 0", given={"centre": "0"}),
                    Mutant(name="sin 2 (z* - z)", given={"rate": "2"}),
                ),
            ),
            Check(
                name="observed order",
                tier="full",
                run=_PENDULUM + "pendulum_order",
                routes=(
                    "printed form",
                    _REFERENCE,
                ),
                mutants=(
                    Mutant(name="A 1 % more", given={"factor": "101/100"}, near=True),
                    Mutant(name="period 1 % less", given={"rate": "101/100"}, near=True),
                    Mutant(name="order 3", given={"order": 3}, near=True),
                ),
            ),
            Check(
                name="separatrix",
                run=_PENDULUM + "swing_of_the_separatrix",
                form="support",
                routes=("printed form, A = 2", _MATCHING),
                mutants=(
                    Mutant(name="A = 1", given={"amplitude": 1}),
                    Mutant(name="tau^5/16", given={"coefficient": "1/16"}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="A.amplitude-varies-slowly",
        section="A",
        where="appendix A, line 1640",
        kind="sentence",
        statement=(
            "$A$ changes over many periods of the pendulum, and can be taken constant up to the "
            r"first crossing $\varphi(z^*) = \pi$."
        ),
        hypotheses=(r"$z \gg 1$",),
        rests_on=("A.pendulum-solution",),
        checks=(
            Check(
                name="figure",
                run=_PENDULUM + "slow_amplitude",
                routes=(
                    "energy of the solution",
                    _CERTIFIED,
                ),
                mutants=(
                    Mutant(name="times z*", given={"power": 1}),
                    Mutant(name="phi0 = 1e-6", given={"initial": "1e-6"}),
                ),
            ),
            Check(
                name="small angle",
                tier="full",
                run=_PENDULUM + "slow_amplitude",
                form="corrected",
                given={"initial": "1e-12"},
                routes=(
                    "energy of the solution",
                    _CERTIFIED,
                ),
                mutants=(
                    Mutant(name="times z*", given={"power": 1}),
                    Mutant(name="phi0 = 1e-6", given={"initial": "1e-6"}),
                ),
            ),
            Check(
                name="law",
                run=_PENDULUM + "slow_law",
                form="support",
                routes=(
                    "amplitude z^(-1/2)",
                    "equation linearised about pi (sympy)",
                ),
                mutants=(
                    Mutant(name="A like 1/z", given={"power": "1"}),
                    Mutant(name="A constant", given={"power": "0"}),
                    Mutant(name="A like z^(-0.6)", given={"power": "3/5"}, near=True),
                ),
            ),
        ),
        erratum=Erratum(
            printed=(
                r"for $z \gg 1$ the amplitude changes over many periods only, so that it "
                r"can be taken constant up to $z^*$; applied to $\varphi_0 = \pi/100$"
            ),
            corrected=(
                r"$A$ falls by about $\pi/z$ of itself in a period, and by $1/z^*$ up to "
                r"the first crossing: both tend to $0$ as $\varphi_0 \to 0$, like "
                r"$1/\log(1/\varphi_0)$ (read as: less than a tenth, from $\varphi_0 = "
                "10^{-12}$)"
            ),
            kind="hypothesis",
            witness=(
                r"$\varphi_0 = \pi/100$: $A = \sqrt{2(E + 1)}$ falls from $1.6748$ at "
                r"$z^* = 6.754$ to $1.2639$ at $z^* + 2\pi$, by $24.5\,\%$; for "
                r"$10^{-6}$ by $12.2\,\%$"
            ),
            conclusion_survives=True,
            remark=(
                "The word slowly is given no measure in the paper; a tenth is ours. The change "
                r"up to $z^*$ is larger than the correction $\delta^4/48$ that is kept."
            ),
        ),
    ),
    Claim(
        id="A.matching-data",
        section="A",
        where="appendix A, displayed formula, line 1642",
        kind="equation",
        statement=(
            r"$(\varphi_{\mathrm{pend}}(0), \varphi_{\mathrm{pend}}'(0)) \approx (\delta, "
            r"\delta)$ with $\delta = \frac{\varphi_0 e^z}{\sqrt{2\pi z}}$."
        ),
        hypotheses=(
            _MATCH,
            "(used, not stated) the argument $0$ is the matching point $z$",
            "(used, not stated) terms of relative order $1/z$ are dropped",
        ),
        rests_on=("A.outer",),
        checks=(
            Check(
                name="at 0",
                run=_PENDULUM + "matching_data",
                routes=(
                    "printed delta",
                    _CERTIFIED,
                ),
                mutants=(
                    Mutant(name="2 delta", given={"factor": "2"}),
                    Mutant(name="sqrt(pi z)", given={"under": "1"}),
                ),
            ),
            Check(
                name="at z",
                run=_PENDULUM + "matching_data",
                form="corrected",
                given={"argument": "z"},
                routes=(
                    "printed delta",
                    _CERTIFIED,
                ),
                mutants=(
                    Mutant(name="5/4 delta", given={"factor": "5/4"}),
                    Mutant(name="sqrt(pi z)", given={"under": "1"}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=(
                r"$(\varphi_{\mathrm{pend}}(0), \varphi_{\mathrm{pend}}'(0)) \approx "
                r"(\delta, \delta)$"
            ),
            corrected=(
                r"$(\varphi(z), \varphi'(z)) \approx (\delta, \delta)$ at the matching "
                r"point $z$, to a relative error of $\frac{1}{2z} + \delta^2$"
            ),
            kind="ambiguous",
            witness=(
                r"at argument $0$ the solution has angle $\varphi_0$ and slope $0$; for "
                r"$\varphi_0 = 10^{-4}$, $z = 6$: $\delta = 0.00657$"
            ),
            conclusion_survives=True,
            remark=(
                "The argument $0$ is meant as a new origin at the matching point; "
                r"$\varphi_{\mathrm{pend}}$ was introduced as a function of the $z$ of "
                "(PIII)."
            ),
        ),
    ),
    Claim(
        id="A.energy",
        section="A",
        where="appendix A, displayed formula, line 1646",
        kind="equation",
        statement=r"$E = \frac{\varphi'^2}{2} + \cos\varphi \approx 1 + \frac{\delta^4}{24}$.",
        hypotheses=(
            _MATCH,
            r"$(\varphi, \varphi') = (\delta, \delta)$",
            (
                r"(used, not stated) the dropped terms, of order $\delta^2/z$, are small against "
                r"$\delta^4$"
            ),
        ),
        rests_on=("A.matching-data", "A.damped-pendulum"),
        checks=(
            Check(
                name="expansion",
                run=_PENDULUM + "data_expansion",
                part="expansion",
                routes=(
                    "printed terms",
                    "energy of the data (sympy)",
                ),
                mutants=(
                    Mutant(name="delta^4/6", given={"coefficient": "1/6"}),
                    Mutant(name="delta^3", given={"power": 3}),
                    Mutant(name="level 0", given={"level": 0}),
                ),
            ),
            Check(
                name="energy of the solution",
                run=_PENDULUM + "energy_correction",
                part="solution",
                routes=(
                    "printed correction",
                    _CERTIFIED,
                ),
                mutants=(
                    Mutant(name="delta^2/24", given={"power": 2}),
                    Mutant(name="delta^5/24", given={"power": 5}, near=True),
                ),
            ),
            Check(
                name="friction",
                run=_PENDULUM + "energy_correction",
                form="corrected",
                given={"correction": "friction"},
                part="solution",
                routes=(
                    "-delta^2/(2 z)",
                    _CERTIFIED,
                ),
                mutants=(
                    Mutant(name="gain", given={"factor": "1/2"}),
                    Mutant(name="twice", given={"factor": "-1"}),
                    Mutant(name="ten per cent more", given={"factor": "-11/20"}),
                ),
            ),
            Check(
                name="separatrix",
                run=_PENDULUM + "separatrix_data",
                form="support",
                routes=(
                    "energy of slope 2 sin(phi/2)",
                    _MATCHING,
                ),
                mutants=(Mutant(name="delta^4/24", given={"coefficient": "1/24"}),),
            ),
        ),
        erratum=Erratum(
            printed=(r"$E \approx 1 + \frac{\delta^4}{24}$"),
            corrected=(r"$E \approx 1 - \frac{\delta^2}{2z}$"),
            kind="false",
            witness=(
                r"$\varphi_0 = 10^{-4}$, $z = 8$: $\delta = 0.0420$, $E - 1 = "
                r"-1.15\cdot10^{-4}$, $\delta^4/24 = +1.3\cdot10^{-7}$"
            ),
            conclusion_survives=True,
            remark=(
                r"$\delta^2/2 + \cos\delta$ is expanded correctly, but the data "
                r"$(\delta, \delta)$ are not good to that order: the solution of the "
                r"undamped equation that tends to $0$ has slope $2\sin(\delta/2) = "
                r"\delta - \delta^3/24$ and $E = 1$ exactly, and friction, $dE/dz = "
                r"-\varphi'^2/z$, makes $E < 1$. The limit $E = 1$ survives."
            ),
        ),
    ),
    Claim(
        id="A.energy-is-conserved",
        section="A",
        where="appendix A, lines 1640 and 1648",
        kind="sentence",
        statement=(
            r"$E = \frac{\varphi'^2}{2} + \cos\varphi$ is constant along $\varphi'' = "
            r"\sin\varphi$, with $\cos\varphi$ the potential."
        ),
        rests_on=("A.damped-pendulum",),
        checks=(
            Check(
                name="rate",
                run=_PENDULUM + "conserved",
                routes=(
                    "printed energy",
                    "chain rule (sympy)",
                ),
                mutants=(
                    Mutant(name="potential -cos", given={"potential": -1}),
                    Mutant(name="kinetic term doubled", given={"kinetic": "1"}),
                    Mutant(name="kinetic term 1 % more", given={"kinetic": "101/200"}, near=True),
                ),
            ),
            Check(
                name="with friction",
                run=_PENDULUM + "dissipated",
                form="support",
                routes=(
                    "rate -phi'^2/z",
                    "PIII (sympy)",
                ),
                mutants=(
                    Mutant(name="energy gained", given={"factor": 1}),
                    Mutant(name="twice the loss", given={"factor": -2}),
                ),
            ),
        ),
    ),
    Claim(
        id="A.substitution-1",
        section="A",
        where="appendix A, displayed formula, line 1650",
        kind="equation",
        statement=(
            r"$1 + \frac{\delta^4}{24} \approx \frac12(A'\sin(z^* - z) + A\cos(z^* - z))^2 + "
            r"\cos\varphi$."
        ),
        hypotheses=(r"$\varphi = \pi - A\sin(z^* - z)$, $A = A(z)$",),
        rests_on=("A.energy", "A.pendulum-solution"),
        checks=(
            Check(
                name="chain rule",
                run=_AMPLITUDE + "first_line",
                routes=(
                    "printed bracket",
                    "energy of pi - A sin (sympy)",
                ),
                mutants=(
                    Mutant(name="A' dropped", given={"rate_sign": 0}),
                    Mutant(name="-2 A'", given={"rate_sign": -2}),
                ),
            ),
            Check(
                name="minus sign",
                run=_AMPLITUDE + "first_line",
                form="corrected",
                given={"rate_sign": -1},
                routes=(
                    "printed bracket",
                    "energy of pi - A sin (sympy)",
                ),
                mutants=(
                    Mutant(name="plus sign", given={"rate_sign": 1}),
                    Mutant(name="A' dropped", given={"rate_sign": 0}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=(r"$\frac12(A'\sin(z^* - z) + A\cos(z^* - z))^2 + \cos\varphi$"),
            corrected=(r"$\frac12(-A'\sin(z^* - z) + A\cos(z^* - z))^2 + \cos\varphi$"),
            kind="misprint",
            witness=(
                r"$A = z$ at $z^* - z = \pi/4$: $\varphi' = (z - 1)/\sqrt2$, the bracket "
                r"gives $(z + 1)/\sqrt2$"
            ),
            conclusion_survives=True,
            remark=(
                "The same sign in the second and third line; the fourth line has the "
                "mixed term of the correct one. Nothing remains of it once $A'$ is "
                "dropped."
            ),
        ),
    ),
    Claim(
        id="A.substitution-2",
        section="A",
        where="appendix A, displayed formula, line 1651",
        kind="equation",
        statement=r"$\cos\varphi \approx -1 + \frac{(\pi - \varphi)^2}{2}$ in the preceding line.",
        hypotheses=(r"$\varphi \approx \pi$",),
        rests_on=("A.substitution-1",),
        checks=(
            Check(
                name="Taylor at pi",
                run=_AMPLITUDE + "second_line",
                routes=(
                    "printed potential",
                    "cosine at pi (sympy)",
                ),
                mutants=(
                    Mutant(name="(pi - phi)^2", given={"coefficient": "1"}),
                    Mutant(name="level 1", given={"level": 1}),
                    Mutant(name="1 % more", given={"coefficient": "101/200"}, near=True),
                    Mutant(name="order 5", given={"order": 5}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="A.substitution-3",
        section="A",
        where="appendix A, displayed formula, line 1652",
        kind="equation",
        statement=(
            r"$\frac{(\pi - \varphi)^2}{2} = \frac12 A^2\sin^2(z^* - z)$ in the preceding line."
        ),
        hypotheses=(r"$\varphi = \pi - A\sin(z^* - z)$",),
        rests_on=("A.substitution-2",),
        checks=(
            Check(
                name="in the form",
                run=_AMPLITUDE + "third_line",
                routes=(
                    "printed term",
                    "(pi - phi)^2/2 (sympy)",
                ),
                mutants=(
                    Mutant(name="A^2 sin^2", given={"coefficient": "1"}),
                    Mutant(name="cubed", given={"power": 3}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="A.substitution-4",
        section="A",
        where="appendix A, displayed formula, line 1653",
        kind="equation",
        statement=(
            r"The right side equals $-1\,\frac12[A'^2\sin^2(z^* - z) - 2A'A\sin(z^* - z)\cos(z^* "
            "- z) + A^2]$, as printed without a sign after $-1$."
        ),
        rests_on=("A.substitution-3",),
        checks=(
            Check(
                name="expanded",
                run=_AMPLITUDE + "fourth_line",
                routes=(
                    "printed third line",
                    "printed fourth line",
                ),
                mutants=(
                    Mutant(name="plus added only", given={"joined": "sum"}),
                    Mutant(name="signs of A' only", given={"rate_sign": -1}),
                ),
            ),
            Check(
                name="both mended",
                run=_AMPLITUDE + "fourth_line",
                form="corrected",
                given={"joined": "sum", "rate_sign": -1},
                routes=(
                    "third line with -A'",
                    "fourth line with a plus",
                ),
                mutants=(
                    Mutant(name="no plus", given={"joined": "product"}),
                    Mutant(name="sign of A'", given={"rate_sign": 1}),
                    Mutant(name="mixed term once", given={"mixed": -1}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=(r"$\approx -1\,\frac12[A'^2\sin^2 - 2A'A\sin\cos + A^2]$"),
            corrected=(
                r"$= -1 + \frac12[A'^2\sin^2 - 2A'A\sin\cos + A^2]$, with $-A'$ in the "
                "three lines before"
            ),
            kind="misprint",
            witness=(
                "$A$ constant: the printed line is $-A^2/2$, the line before it is $-1 + A^2/2$"
            ),
            conclusion_survives=True,
            remark=(
                "With the plus sign alone, the mixed term still has the sign opposite "
                "to that of the printed third line."
            ),
        ),
    ),
    Claim(
        id="A.amplitude",
        section="A",
        where="appendix A, displayed formula, line 1655",
        kind="equation",
        statement=r"$A \approx 2\sqrt{1 + \frac{\delta^4}{48}}$.",
        hypotheses=(r"$A' \approx 0$", "(used, not stated) $A > 0$"),
        rests_on=("A.substitution-4", "A.amplitude-varies-slowly"),
        checks=(
            Check(
                name="algebra",
                run=_AMPLITUDE + "amplitude_algebra",
                part="algebra",
                routes=(
                    "printed amplitude",
                    "energies equated (sympy)",
                ),
                mutants=(
                    Mutant(name="delta^4/24", given={"coefficient": "1/24"}),
                    Mutant(name="delta^3", given={"power": 3}),
                ),
            ),
            Check(
                name="slope at the crossing",
                run=_AMPLITUDE + "amplitude_value",
                part="value",
                routes=(
                    "printed amplitude, delta = 1/10",
                    _CERTIFIED,
                ),
                mutants=(Mutant(name="delta^4/24", given={"coefficient": "1/24"}),),
            ),
            Check(
                name="friction",
                run=_AMPLITUDE + "amplitude_value",
                form="corrected",
                given={"form": "friction"},
                part="value",
                routes=(
                    _MATCHING,
                    _CERTIFIED,
                ),
                mutants=(
                    Mutant(name="gain", given={"factor": "-1"}),
                    Mutant(name="half as much again", given={"factor": "3/2"}),
                ),
            ),
            Check(
                name="first order",
                run=_AMPLITUDE + "amplitude_derivation",
                form="support",
                routes=(
                    _MATCHING,
                    "equation and energy balance (sympy)",
                ),
                mutants=(
                    Mutant(name="gain", given={"factor": "-1"}),
                    Mutant(name="1 % more", given={"factor": "101/100"}, near=True),
                ),
            ),
            Check(
                name="observed order",
                tier="full",
                run=_AMPLITUDE + "amplitude_order",
                form="support",
                routes=(
                    "limit 2",
                    _REFERENCE,
                ),
                mutants=(
                    Mutant(name="limit 2.02", given={"constant": "101/50"}, near=True),
                    Mutant(name="order -2", given={"order": -2}, near=True),
                ),
            ),
        ),
        erratum=Erratum(
            printed=(r"$A \approx 2\sqrt{1 + \frac{\delta^4}{48}}$"),
            corrected=(
                r"$A = \varphi'(z^*) = 2 - \frac{2}{z^*} + "
                r"O\left(\frac{1}{z^{*2}}\right)$"
            ),
            kind="false",
            witness=(
                r"$\varphi_0 = \pi/100$: $\varphi'(z^*) = 1.67475 < 2$; $\varphi_0 = "
                r"10^{-12}$: $1.93580$; always $\varphi'(z^*) < 2\cos(\varphi_0/2)$, as "
                r"the energy falls from $\cos\varphi_0$"
            ),
            conclusion_survives=True,
            remark=(
                "The correction has the wrong sign and misses the leading one, by "
                r"friction; the limit $A \to 2$ as $\varphi_0 \to 0$ survives. With the "
                "printed energy the algebra is right."
            ),
        ),
    ),
    Claim(
        id="fig:painleveasymptotics",
        section="A",
        where="figure (fig:painleveasymptotics), lines 1657-1662 and 1673",
        kind="figure",
        statement=(
            "The Bessel and pendulum approximations against the numerical solution of (PIII) "
            r"for $\varphi_0 = \pi/100$: each agrees on its own range."
        ),
        labels=("fig:painleveasymptotics",),
        hypotheses=(r"$\varphi_0 = \pi/100$",),
        rests_on=("PIII", "eqa5"),
        checks=(
            Check(
                name="lines as printed",
                run=_LINES + "figure",
                routes=(
                    "three printed lines",
                    _CERTIFIED,
                ),
                mutants=(
                    Mutant(name="phi0^4 at the running z", given={"amplitude": "with phi0^4"}),
                    Mutant(name="z^2/2", given={"coefficient": "1/2"}),
                ),
            ),
            Check(
                name="third line mended",
                run=_LINES + "figure",
                form="corrected",
                given={"amplitude": "2 - 2/z*"},
                routes=(
                    "lines 1 and 2, pi - (2 - 2/z*) sin(z* - z)",
                    _CERTIFIED,
                ),
                mutants=(
                    Mutant(name="phi0^4 at the running z", given={"amplitude": "with phi0^4"}),
                    Mutant(name="amplitude 2", given={"amplitude": "2"}),
                    Mutant(name="z^2/2", given={"coefficient": "1/2"}),
                    Mutant(name="no 1/(8 z)", given={"correction": "0"}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=(
                r"the relations of (eqa5) describe the numerical solution for $\varphi_0 "
                r"= \pi/100$"
            ),
            corrected=(
                r"with $\pi - (2 - \frac{2}{z^*})\sin(z^* - z)$ for the third line each "
                r"line is within $5\,\%$ on its range: $z \leq 1$; $z \geq 2$, $\varphi "
                r"\leq 1$; $\pi - \varphi \leq 1$"
            ),
            kind="misprint",
            witness=(
                r"at $z = z^* - \frac18 = 6.629$ the error of the third line as printed is "
                r"$169$ times $\varphi$"
            ),
            conclusion_survives=True,
            remark=(
                "The picture itself is not in the source; what was drawn cannot be the "
                r"third line as printed. Ranges and the $5\,\%$ are ours."
            ),
        ),
    ),
    Claim(
        id="A.crossing-of-the-figure",
        section="A",
        where="caption of figure (fig:painleveasymptotics), line 1660",
        kind="number",
        statement=(
            r"For $\varphi_0 = \pi/100$ the first solution of $\varphi(z) = \pi$ is $z^* \approx "
            "9$."
        ),
        hypotheses=(_REG, r"$\varphi_0 = \pi/100$"),
        rests_on=("PIII",),
        checks=(
            Check(
                name="9",
                run=_CROSSING + "crossing_number",
                routes=(
                    _CERTIFIED,
                    _REFERENCE,
                ),
                mutants=(
                    Mutant(name="9.09", given={"value": "9.09"}, near=True),
                    Mutant(name="pi/100 to 0.01", given={"initial": "0.01"}),
                ),
            ),
            Check(
                name="6.754",
                run=_CROSSING + "crossing_number",
                form="corrected",
                given={"value": "6.754"},
                routes=(
                    _CERTIFIED,
                    _REFERENCE,
                ),
                mutants=(
                    Mutant(name="6.755", given={"value": "6.755"}, near=True),
                    Mutant(name="1 % more", given={"value": "6.822"}, near=True),
                    Mutant(name="phi0 = 0.0314", given={"initial": "0.0314"}),
                ),
            ),
            Check(
                name="angle with crossing 9",
                run=_CROSSING + "angle_of_crossing",
                form="support",
                routes=(_CERTIFIED,),
                mutants=(
                    Mutant(name="crossing 8.99", given={"z": "8.99"}, near=True),
                    Mutant(
                        name="angle 1 % more",
                        given={"low": "0.00382865", "high": "0.00382866"},
                        near=True,
                    ),
                ),
            ),
        ),
        erratum=Erratum(
            printed=(r"$z^* \approx 9$ for $\varphi_0 = \pi/100$"),
            corrected=("$z^* = 6.754$"),
            kind="constant",
            witness=(
                r"$z^*(\pi/100) = 6.75417466723$ (certified); $z^* = 9$ belongs to "
                r"$\varphi_0 = 0.0037907 = \pi/829$"
            ),
            conclusion_survives=True,
            remark=(
                r"The first maximum of $\varphi$ for $\varphi_0 = \pi/100$ is at $z = "
                r"8.579$, where $\varphi = 4.83$."
            ),
        ),
    ),
    Claim(
        id="eqa5",
        section="A",
        where="formula (eqa5), lines 1665-1672",
        kind="equation",
        statement=(
            r"The three formulas for $z \ll 1$, for $z \gg 1$ with $\varphi_0 \ll \varphi "
            r"\lesssim \pi$ and for $\varphi \approx \pi$ together describe the solution of "
            "(PIII) on $[0, z^*]$."
        ),
        labels=("eqa5",),
        hypotheses=(
            r"(used, not stated) $\varphi_0 \ll 1$",
            r"(used, not stated) $\varphi(0) = \varphi_0$, $\varphi'(0) = 0$",
        ),
        rests_on=("A.regime-1", "A.regime-2", "A.regime-3"),
        checks=(
            Check(
                name="as printed",
                run=_LINES + "coverage",
                routes=(
                    "three printed lines",
                    _CERTIFIED,
                ),
                mutants=(
                    Mutant(name="phi0^4 at the running z", given={"amplitude": "with phi0^4"}),
                    Mutant(name="phi0 = 1e-4", given={"initial": "1e-4"}),
                ),
            ),
            Check(
                name="pi/100",
                tier="full",
                run=_LINES + "coverage",
                form="corrected",
                given={"amplitude": "2 - 2/z*"},
                routes=(
                    "lines 1 and 2, pi - (2 - 2/z*) sin(z* - z)",
                    _CERTIFIED,
                ),
                mutants=(
                    Mutant(name="phi0^4 at the running z", given={"amplitude": "with phi0^4"}),
                    Mutant(name="5 %", given={"most": "1/20"}),
                ),
            ),
            Check(
                name="1e-12",
                run=_LINES + "coverage",
                form="corrected",
                given={"amplitude": "2 - 2/z*", "initial": "1e-12"},
                tier="full",
                routes=(
                    "lines 1 and 2, pi - (2 - 2/z*) sin(z* - z)",
                    _CERTIFIED,
                ),
                mutants=(
                    Mutant(name="phi0^4 at the running z", given={"amplitude": "with phi0^4"}),
                    Mutant(name="4 %", given={"most": "1/25"}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=(
                r"third line with $2\sqrt{1 + \frac{e^{4z}}{192\pi^2z^2}}\,\sin(z^* - "
                "z)$"
            ),
            corrected=(
                r"third line $\pi - \left(2 - \frac{2}{z^*}\right)\sin(z^* - z)$; then "
                r"at every $z$ in $[0, z^*]$ one of the lines is within $10\,\%$ of "
                r"$\varphi$"
            ),
            kind="false",
            witness=(
                r"$\varphi_0 = \pi/100$, $z = 6.75$: the three lines are off by "
                r"$88\,\%$, $34\,\%$ and $660\,\%$"
            ),
            conclusion_survives=True,
            remark=(
                r"Even with the missing $\varphi_0^4$ the third line is off near $z^*$ "
                r"if $z$ under the root is the running one, as $\delta(z^*) \approx 4$. "
                r"The $10\,\%$ are ours; about $7\,\%$ is reached for $\pi/100$, where "
                r"$\varphi \approx 1.6$."
            ),
        ),
    ),
    Claim(
        id="A.complete-description",
        section="A",
        where="appendix A, sentence before formula (eqa5), line 1663",
        kind="sentence",
        statement=(
            r"The three regimes describe the solution for a small $\varphi_0$ completely: at every "
            r"$z$ in $[0, z^*]$ the relative error of one of the formulas tends to $0$ with "
            r"$\varphi_0$."
        ),
        hypotheses=(r"(used, not stated) $\varphi_0 \to 0$",),
        rests_on=("eqa5",),
        checks=(
            Check(
                name="three lines",
                run=_UNIFORM + "complete",
                routes=("three printed lines", _CERTIFIED),
                mutants=(
                    Mutant(name="only the third line mended", given={"lines": "2 - 2/z*"}),
                    Mutant(name="error 1/z*^2", given={"power": 2}),
                ),
            ),
            Check(
                name="I_0 and separatrix",
                tier="full",
                run=_UNIFORM + "complete",
                form="corrected",
                given={"lines": "matched"},
                routes=(_MATCHING, _CERTIFIED),
                mutants=(
                    Mutant(name="no friction", given={"lines": "undamped"}),
                    Mutant(name="only the third line mended", given={"lines": "2 - 2/z*"}),
                    Mutant(name="error 1/z*^2", given={"power": 2}, near=True),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"(eqa5) describes the solution completely as $\varphi_0 \to 0$",
            corrected=(
                r"$\varphi_0I_0(z)$ for $\varphi \lesssim 1/2$, and with $t = z - z^*$ beyond that "
                r"$4\arctan e^t - \frac{1}{z^*}\operatorname{sech} t\left(t + \frac{e^{2t} - 1}{2}"
                r"\right)$: relative error at most $\frac{1}{6z^*}$"
            ),
            kind="false",
            witness=(
                r"at $z = 9/8$ the first two lines are off by $1.9\,\%$ and $4.1\,\%$ for "
                r"every small $\varphi_0$; at $\varphi = 1.4$ the last two, the third with "
                r"$A = 2$, by $4.3\,\%$ and $3.6\,\%$ in the limit"
            ),
            conclusion_survives=False,
            remark=(
                "Within a fixed tolerance of a tenth the description is complete once its third "
                "line is mended (eqa5)."
            ),
        ),
    ),
    Claim(
        id="A.regime-1",
        section="A",
        where="formula (eqa5), first line, line 1667",
        kind="equation",
        statement=r"$\varphi(z) \approx \varphi_0\left(1 + \frac{z^2}{4}\right)$.",
        hypotheses=(r"$z \ll 1$, $\varphi_0 \lesssim \varphi \ll \pi$",),
        rests_on=("A.inner",),
        checks=(
            Check(
                name="error bound",
                run=_LINEAR + "regime_1",
                routes=(
                    "printed line",
                    _CERTIFIED,
                ),
                mutants=(
                    Mutant(name="z^2/2", given={"coefficient": "1/2"}),
                    Mutant(name="1 % more z^2", given={"coefficient": "101/400"}, near=True),
                    Mutant(name="z^3/4", given={"power": 3}),
                ),
            ),
            Check(
                name="observed order",
                run=_LINEAR + "regime_1_order",
                routes=(
                    "printed line",
                    _REFERENCE,
                ),
                mutants=(
                    Mutant(name="1 % more z^2", given={"coefficient": "101/400"}, near=True),
                    Mutant(name="order 3", given={"order": 3}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="A.regime-2",
        section="A",
        where="formula (eqa5), second line, line 1668",
        kind="equation",
        statement=(
            r"$\varphi(z) \approx \varphi_0\frac{e^z}{\sqrt{2\pi z}}\left(1 + "
            r"\frac{1}{8z}\right)$."
        ),
        hypotheses=(
            r"$z \gg 1$, $\varphi_0 \ll \varphi \lesssim \pi$",
            (
                r"(used, not stated) $\varphi \ll 1$: near $\pi$ the linearised equation does "
                "not apply"
            ),
        ),
        rests_on=("A.outer",),
        checks=(
            Check(
                name="up to pi",
                run=_LINEAR + "regime_2",
                routes=(
                    "printed line",
                    _CERTIFIED,
                ),
                mutants=(
                    Mutant(name="sqrt(pi z)", given={"under": "1"}),
                    Mutant(name="twice", given={"factor": "2"}),
                ),
            ),
            Check(
                name="up to 1",
                run=_LINEAR + "regime_2",
                form="corrected",
                given={"reach": "1"},
                routes=(
                    "printed line",
                    _CERTIFIED,
                ),
                mutants=(
                    Mutant(name="up to 2", given={"reach": "2"}),
                    Mutant(name="no 1/(8 z)", given={"correction": "0"}),
                    Mutant(name="sqrt(pi z)", given={"under": "1"}),
                ),
            ),
            Check(
                name="order in phi",
                tier="full",
                run=_LINEAR + "regime_2_order",
                form="support",
                routes=(
                    "printed line",
                    _REFERENCE,
                ),
                mutants=(
                    Mutant(name="1 % more", given={"factor": "101/100"}, near=True),
                    Mutant(name="order 3", given={"order": 3}, near=True),
                ),
            ),
        ),
        erratum=Erratum(
            printed=(r"range $z \gg 1$, $\varphi_0 \ll \varphi \lesssim \pi$"),
            corrected=(
                r"range $z \gg 1$, $\varphi \ll 1$: the relative error is about "
                r"$\varphi^2/48$, below $3\,\%$ for $z \geq 3$ and $\varphi \leq 1$"
            ),
            kind="hypothesis",
            witness=(
                r"at $z^*$, where $\varphi = \pi$, the line is $31\,\%$ too large for "
                r"$\varphi_0 = 10^{-3}$, and tends to $4$, $27\,\%$ too large, as $\varphi_0 "
                r"\to 0$"
            ),
            conclusion_survives=True,
        ),
    ),
    Claim(
        id="A.regime-3",
        section="A",
        where="formula (eqa5), third line, line 1669",
        kind="equation",
        statement=(
            r"$\varphi(z) \approx \pi - 2\sqrt{1 + \frac{e^{4z}}{192\pi^2 z^2}}\,\sin(z^* - z)$."
        ),
        hypotheses=(
            r"$\varphi \approx \pi$, $z \lesssim z^*$",
            (
                r"(used, not stated) the $z$ under the root is the matching point, where $\delta "
                r"\ll 1$"
            ),
        ),
        rests_on=("A.pendulum-solution", "A.amplitude", "A.matching-data"),
        checks=(
            Check(
                name="algebra as printed",
                run=_LINES + "third_algebra",
                part="algebra",
                routes=(
                    "printed root",
                    "printed delta and A",
                ),
                mutants=(
                    Mutant(name="phi0^2", given={"phi0_power": 2}),
                    Mutant(name="1/48", given={"coefficient": "1/48"}),
                ),
            ),
            Check(
                name="algebra with phi0^4",
                run=_LINES + "third_algebra",
                form="corrected",
                given={"phi0_power": 4},
                part="algebra",
                routes=(
                    "root with phi0^4",
                    "printed delta and A",
                ),
                mutants=(
                    Mutant(name="phi0^3", given={"phi0_power": 3}, near=True),
                    Mutant(name="1/96", given={"coefficient": "1/96"}),
                    Mutant(name="sqrt(pi z)", given={"under": "1"}),
                ),
            ),
            Check(
                name="value as printed",
                run=_LINES + "third_line",
                part="value",
                routes=(
                    "printed line",
                    _CERTIFIED,
                ),
                mutants=(
                    Mutant(name="phi0^4 at the running z", given={"amplitude": "with phi0^4"}),
                ),
            ),
            Check(
                name="value with friction",
                run=_LINES + "third_line",
                form="corrected",
                given={"amplitude": "2 - 2/z*"},
                part="value",
                routes=(
                    _MATCHING,
                    _CERTIFIED,
                ),
                mutants=(
                    Mutant(name="amplitude 2", given={"amplitude": "2"}),
                    Mutant(name="phi0^4 at the running z", given={"amplitude": "with phi0^4"}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=(r"$\pi - 2\sqrt{1 + \frac{e^{4z}}{192\pi^2z^2}}\,\sin(z^* - z)$"),
            corrected=(
                r"$\pi - 2\sqrt{1 + \frac{\varphi_0^4e^{4z}}{192\pi^2z^2}}\,\sin(z^* - "
                "z)$ by the derivation, with $z$ under the root the matching point, so "
                r"that the root is nearly $1$; nearer to the solution: $\pi - (2 - "
                r"\frac{2}{z^*})\sin(z^* - z)$"
            ),
            kind="misprint",
            witness=(
                r"$\delta^4/48 = \varphi_0^4e^{4z}/(192\pi^2z^2)$; for $\varphi_0 = "
                r"\pi/100$, $z = z^* - \frac1{16}$ the printed $\pi - \varphi$ is $2650$ "
                "times too large, for $10^{-12}$ some $10^{24}$ times"
            ),
            conclusion_survives=True,
            remark=(
                r"With $\varphi_0^4$ and the running $z$, $\pi - \varphi$ is still "
                r"$187\,\%$ too large there, since $\delta(z^*) \approx 4$; with "
                r"amplitude $2$ it is $19\,\%$ too large, with $2 - 2/z^*$ it is within "
                r"$2\,\%$."
            ),
        ),
    ),
    Claim(
        id="A.crossing-estimate",
        section="A",
        where="formula (eqa5), third line, line 1669",
        kind="equation",
        statement=r"$z^* \approx -\log\varphi_0$.",
        hypotheses=(
            (
                r"(used, not stated) $\varphi_0 \to 0$, with terms of order "
                r"$\log\log(1/\varphi_0)$ dropped"
            ),
        ),
        rests_on=("PIII",),
        checks=(
            Check(
                name="as printed",
                run=_CROSSING + "estimate",
                part="value",
                routes=(
                    "printed estimate",
                    _CERTIFIED,
                ),
                mutants=(
                    Mutant(name="log 4 added", given={"constant": "4"}),
                    Mutant(name="log(2 pi z*)/2 added", given={"slow": "1/2"}),
                ),
            ),
            Check(
                name="with the slow terms",
                run=_CROSSING + "estimate",
                form="corrected",
                given={"slow": "1/2", "constant": "4", "inverse": "1/8"},
                part="value",
                routes=(
                    _MATCHING,
                    _CERTIFIED,
                ),
                mutants=(
                    Mutant(
                        name="constant 1 % more",
                        given={"slow": "1/2", "constant": "101/25"},
                        near=True,
                    ),
                    Mutant(name="0.6 of the logarithm", given={"slow": "3/5"}, near=True),
                    Mutant(name="no 1/(8 z*)", given={"inverse": "0"}),
                ),
            ),
            Check(
                name="matched",
                run=_CROSSING + "derivation",
                form="corrected",
                given={"slow": "1/2", "constant": "4", "inverse": "1/8"},
                part="derivation",
                routes=(
                    "estimate with the slow terms",
                    _MATCHING,
                ),
                mutants=(
                    Mutant(name="log 2", given={"constant": "2"}),
                    Mutant(name="-1/(8 z*)", given={"inverse": "-1/8"}),
                    Mutant(name="no 1/(8 z*)", given={"inverse": "0"}),
                ),
            ),
            Check(
                name="observed order",
                tier="full",
                run=_CROSSING + "estimate_order",
                form="support",
                routes=(
                    "-log phi0 + log(2 pi z*)/2 + log 4",
                    _REFERENCE,
                ),
                mutants=(
                    Mutant(name="constant 1 % more", given={"constant": "101/25"}, near=True),
                    Mutant(name="0.6 of the logarithm", given={"slow": "3/5"}, near=True),
                    Mutant(name="order -2", given={"order": -2}, near=True),
                ),
            ),
            Check(
                name="growing excess",
                run=_CROSSING + "excess",
                form="support",
                routes=(
                    "-log phi0",
                    _CERTIFIED,
                ),
                mutants=(Mutant(name="4 for pi/100", given={"constant": "4"}),),
            ),
            Check(
                name="ratio",
                run=_CROSSING + "ratio",
                form="support",
                routes=(
                    "-log phi0",
                    _CERTIFIED,
                ),
                mutants=(Mutant(name="phi0 = 1e-12", given={"initial": "1e-12"}),),
            ),
            Check(
                name="two routes",
                run=_CROSSING + "reference_agrees",
                form="support",
                routes=(
                    _CERTIFIED,
                    _REFERENCE,
                ),
                mutants=(Mutant(name="shift 1e-18", given={"shift": "1e-18"}),),
            ),
        ),
        erratum=Erratum(
            printed=(r"$z^* \approx -\log\varphi_0$"),
            corrected=(
                r"$z^* = -\log\varphi_0 + \frac12\log(2\pi z^*) + \log 4 + "
                r"\frac{1}{8z^*} + O(z^{*-2})$, hence $z^* = -\log\varphi_0 + "
                r"\frac12\log(-\log\varphi_0) + \frac12\log(32\pi) + o(1)$"
            ),
            kind="false",
            witness=(
                r"$z^* + \log\varphi_0$ is $3.29$ for $\pi/100$, $3.59$ for $10^{-4}$, "
                "$4.04$ for $10^{-12}$, and grows without bound"
            ),
            conclusion_survives=False,
            remark=(
                r"The quotient $z^*/(-\log\varphi_0)$ does tend to $1$, slowly: $1.95$ "
                r"for $\pi/100$, $1.146$ for $10^{-12}$, $1.022$ for $10^{-100}$. As a "
                r"place in $\sin(z^* - z)$ the estimate is of no use: there $\varphi$ is "
                r"$0.224$ for $\pi/100$ and $0.076$ for $10^{-12}$, not $\pi$."
            ),
        ),
    ),
    Claim(
        id="A.better-than-the-bounds",
        section="A",
        where="appendix A, line 1622",
        kind="sentence",
        statement=(
            r"The asymptotic formulas estimate $\varphi$ better than the bounds $\phi_n I_0(Cz) "
            r"\leq \varphi \leq \phi_n I_0(z)$ do: each errs by less than the gap between them."
        ),
        hypotheses=("(used, not stated) each formula on its own range",),
        rests_on=("eqa5", "boundCphi*"),
        checks=(
            Check(
                name="as printed",
                run=_BOUNDS + "better_than_bounds",
                routes=(
                    "three printed lines",
                    _CERTIFIED,
                ),
                mutants=(
                    Mutant(name="a tenth of the gap", given={"share": "1/10"}),
                    Mutant(
                        name="phi0^4 at the running z",
                        given={"amplitude": "with phi0^4", "share": "1/50"},
                    ),
                ),
            ),
            Check(
                name="third line mended",
                tier="full",
                run=_BOUNDS + "better_than_bounds",
                form="corrected",
                given={"amplitude": "2 - 2/z*"},
                routes=(
                    "lines 1 and 2, pi - (2 - 2/z*) sin(z* - z)",
                    _CERTIFIED,
                ),
                mutants=(
                    Mutant(name="a fiftieth of the gap", given={"share": "1/50"}),
                    Mutant(name="third line as printed", given={"amplitude": "printed"}),
                ),
            ),
            Check(
                name="line 1 against the upper bound",
                run=_BOUNDS + "upper_bound_nearer",
                form="support",
                routes=(
                    "phi0 I_0(z)",
                    _CERTIFIED,
                ),
                mutants=(Mutant(name="line 3", given={"line": 3}),),
            ),
        ),
        erratum=Erratum(
            printed=(r"(eqa5) estimates $\varphi$ better than the bounds do"),
            corrected=(
                "with the third line mended each line errs, on its range, by less than "
                r"half the gap between the two bounds (tested with $\phi^* = 3$)"
            ),
            kind="false",
            witness=(
                r"$\varphi_0 = \pi/100$, $z = 6.057$ where $\varphi = 2$: the third line "
                "as printed errs by $407$ times the gap"
            ),
            conclusion_survives=True,
            remark=(
                r"The upper bound alone, $\varphi_0I_0(z)$, is nearer to $\varphi$ than "
                r"line 1 at $z = 1$ and than line 2 at $z = 3$: for $\varphi \ll 1$ "
                "nothing is gained over it."
            ),
        ),
    ),
    Claim(
        id="A.optimal-constant",
        section="A",
        where="appendix A, line 1673",
        kind="sentence",
        statement=(
            "With (eqa5) in place of (boundCphi*) the lemma on Amsler sectors holds with the "
            r"best constant $C(\phi^*) = 1$."
        ),
        hypotheses=(
            (
                r"(used, not stated) asymptotically as $\phi_n \to 0$: for $z > 0$ the bound "
                r"$\varphi(z) < \phi_n I_0(z)$ is strict"
            ),
        ),
        rests_on=("eqa5", "lem:amsler_recursion", "boundCphi*"),
        checks=(
            Check(
                name="C = 1",
                run=_BOUNDS + "optimal_constant",
                routes=(
                    "bound of the lemma",
                    _CERTIFIED,
                ),
                mutants=(
                    Mutant(name="C = 1 + 1/(4 z_n)", given={"lag": "-1/4"}),
                    Mutant(name="phi* = 2", given={"level": "2"}),
                ),
            ),
            Check(
                name="C tends to 1",
                run=_BOUNDS + "optimal_constant",
                form="corrected",
                given={"lag": "1/4"},
                routes=(
                    "C = 1 - 1/(4 z_n)",
                    _CERTIFIED,
                ),
                mutants=(
                    Mutant(name="C = 1", given={"lag": "0"}),
                    Mutant(name="C = 1 - 1/(20 z_n)", given={"lag": "1/20"}),
                    Mutant(name="phi_n = 2", given={"initials": "2"}),
                ),
            ),
            Check(
                name="strict upper bound",
                run=_BOUNDS + "strict_upper_bound",
                form="support",
                routes=(
                    "phi_n I_0(z)",
                    _CERTIFIED,
                ),
                mutants=(
                    Mutant(name="I_0(0.9 z)", given={"constant": "9/10"}),
                    Mutant(name="I_0(0.99 z)", given={"constant": "99/100"}, near=True),
                ),
            ),
            Check(
                name="no uniform C near 1",
                run=_BOUNDS + "uniform_constant",
                form="support",
                routes=(
                    "phi_n I_0(C z)",
                    _CERTIFIED,
                ),
                mutants=(Mutant(name="C = 3/5", given={"constant": "3/5"}),),
            ),
        ),
        erratum=Erratum(
            printed=(r"$C(\phi^*) = 1$ in the lemma"),
            corrected=(
                r"$C = 1 - \frac{1}{4z_n}$ for $\phi^* = 9/4$, where $\varphi(z_n) = "
                r"\phi^*$: it depends on $\phi_n$ and tends to $1$ as $\phi_n \to 0$"
            ),
            kind="false",
            witness=(
                r"$\phi_n = 0.01$, $z = 6$: $\varphi = 0.66503 < \phi_nI_0(6) = "
                r"0.67234$; for every $z > 0$ the bound $\varphi(z) < \phi_nI_0(z)$ is "
                "strict"
            ),
            conclusion_survives=False,
            remark=(
                r"The lemma asks for a $C$ that depends on $\phi^*$ alone: $\phi_n = 2$, "
                r"$\phi^* = 9/4$ refute already $C = 0.7$. The lemma itself has $C < 1$ "
                "as a hypothesis."
            ),
        ),
    ),
)
