"""Claims of appendix A, the pendulum near pi and its matching data."""

from checks.claim import Check, Claim, Erratum, Mutant

_MATCH = r"$z \gg 1$, $\delta \ll 1$"
_PENDULUM = "checks.verify.pendulum_matching:"
_CERTIFIED = "theory.painleve (balls)"
_REFERENCE = "theory.painleve_reference (mpmath)"
_MATCHING = "theory.painleve_matching (separatrix and friction)"

CLAIMS: tuple[Claim, ...] = (
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
                tier="full",
                routes=(
                    "bound 2/z",
                    _CERTIFIED,
                ),
                mutants=(
                    Mutant(name="1/z^2", given={"power": "2"}),
                    Mutant(name="z^(-1.1)", given={"power": "11/10"}, near=True),
                    Mutant(name="slope below 1", given={"most": "1"}),
                    Mutant(name="1 % less", given={"most": "99/50"}, near=True),
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
                    Mutant(name="times z*", given={"power": "1"}),
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
                    Mutant(name="times z*", given={"power": "1"}),
                    Mutant(
                        name="times z*^0.1",
                        given={"initial": "1e-12", "power": "1/10"},
                        near=True,
                    ),
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
                    Mutant(
                        name="delta 1 % more",
                        given={"argument": "z", "factor": "101/100"},
                        near=True,
                    ),
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
)
