"""Claims of appendix A, the energy and the amplitude of the pendulum."""

from checks.claim import Check, Claim, Erratum, Mutant

_MATCH = r"$z \gg 1$, $\delta \ll 1$"
_PENDULUM = "checks.verify.pendulum_matching:"
_AMPLITUDE = "checks.verify.pendulum_amplitude:"
_CERTIFIED = "theory.painleve (balls)"
_REFERENCE = "theory.painleve_reference (mpmath)"
_MATCHING = "theory.painleve_matching (separatrix and friction)"

CLAIMS: tuple[Claim, ...] = (
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
                    Mutant(name="1 % more", given={"factor": "-101/200"}, near=True),
                    Mutant(name="1 % less", given={"factor": "-99/200"}, near=True),
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
                tier="full",
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
                    Mutant(name="1 % more", given={"factor": "101/100"}, near=True),
                    Mutant(name="1 % less", given={"factor": "99/100"}, near=True),
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
)
