"""Claims of appendix A, the regimes of (eqa5)."""

from checks.claim import Check, Claim, Erratum, Mutant

_LINEAR = "checks.verify.linearised_painleve:"
_LINES = "checks.verify.matched_asymptotics:"
_UNIFORM = "checks.verify.uniform_asymptotics:"
_CERTIFIED = "theory.painleve (balls)"
_REFERENCE = "theory.painleve_reference (mpmath)"
_MATCHING = "theory.painleve_matching (separatrix and friction)"

CLAIMS: tuple[Claim, ...] = (
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
                    Mutant(name="1 % more", given={"factor": "101/100"}, near=True),
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
                    Mutant(name="amplitude 1 % more", given={"share": "101/100"}, near=True),
                    Mutant(name="amplitude 1 % less", given={"share": "99/100"}, near=True),
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
)
