"""Claims of appendix A, the linearised equation and its expansions."""

from checks.claim import Check, Claim, Mutant

_REG = r"$\varphi(0) = \varphi_0$, $\varphi'(0) = 0$"
_LINEAR = "checks.verify.linearised_painleve:"
_REFERENCE = "theory.painleve_reference (mpmath)"

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
)
