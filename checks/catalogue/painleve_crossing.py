"""Claims of appendix A, the crossing and the bounds that it improves."""

from checks.claim import Check, Claim, Erratum, Mutant

_CROSSING = "checks.verify.crossing_estimate:"
_BOUNDS = "checks.verify.asymptotics_and_bounds:"
_CERTIFIED = "theory.painleve (balls)"
_REFERENCE = "theory.painleve_reference (mpmath)"
_MATCHING = "theory.painleve_matching (separatrix and friction)"

CLAIMS: tuple[Claim, ...] = (
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
                mutants=(
                    Mutant(name="4 for pi/100", given={"constant": "4"}),
                    Mutant(name="1 % above 3.29", given={"constant": "33229/10000"}, near=True),
                ),
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
                mutants=(
                    Mutant(name="shift 1e-18", given={"shift": "1e-18"}),
                    Mutant(name="shift 2e-20", given={"shift": "2e-20"}, near=True),
                ),
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
                    Mutant(name="half of that", given={"share": "1/2"}),
                    Mutant(name="phi0^4 at the running z", given={"amplitude": "with phi0^4"}),
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
                    Mutant(name="half of that", given={"share": "1/2"}),
                    Mutant(name="1 % more z^2", given={"coefficient": "101/400"}, near=True),
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
                "with the third line mended each line errs, on its range, by less than a "
                r"fifteenth of the gap between the two bounds (tested with $\phi^* = 3$)"
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
                    Mutant(name="C 1 % larger", given={"scale": "101/100"}, near=True),
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
