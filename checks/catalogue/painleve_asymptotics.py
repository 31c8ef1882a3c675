"""Claims of appendix A, asymptotics of Painleve III."""

from checks.claim import Claim

_REG = r"$\varphi(0) = \varphi_0$, $\varphi'(0) = 0$"
_MATCH = r"$z \gg 1$, $\delta \ll 1$"

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
    ),
    Claim(
        id="A.bessel-solution",
        section="A",
        where="appendix A, line 1626",
        kind="equation",
        statement=r"Its solution is $\varphi(z) = \varphi_0 I_0(z)$.",
        hypotheses=(_REG,),
        rests_on=("A.linearised",),
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
    ),
    Claim(
        id="A.substitution-2",
        section="A",
        where="appendix A, displayed formula, line 1651",
        kind="equation",
        statement=r"$\cos\varphi \approx -1 + \frac{(\pi - \varphi)^2}{2}$ in the preceding line.",
        hypotheses=(r"$\varphi \approx \pi$",),
        rests_on=("A.substitution-1",),
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
    ),
    Claim(
        id="A.amplitude",
        section="A",
        where="appendix A, displayed formula, line 1655",
        kind="equation",
        statement=r"$A \approx 2\sqrt{1 + \frac{\delta^4}{48}}$.",
        hypotheses=(r"$A' \approx 0$", "(used, not stated) $A > 0$"),
        rests_on=("A.substitution-4", "A.amplitude-varies-slowly"),
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
    ),
    Claim(
        id="A.regime-1",
        section="A",
        where="formula (eqa5), first line, line 1667",
        kind="equation",
        statement=r"$\varphi(z) \approx \varphi_0\left(1 + \frac{z^2}{4}\right)$.",
        hypotheses=(r"$z \ll 1$, $\varphi_0 \lesssim \varphi \ll \pi$",),
        rests_on=("A.inner",),
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
    ),
    Claim(
        id="A.better-than-the-bounds",
        section="A",
        where="appendix A, line 1622",
        kind="sentence",
        statement=(
            r"The asymptotic formulas are closer to $\varphi$ than the bounds $\phi_n I_0(Cz) "
            r"\leq \varphi \leq \phi_n I_0(z)$."
        ),
        hypotheses=("(used, not stated) each formula on its own range",),
        rests_on=("eqa5", "boundCphi*"),
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
    ),
)
