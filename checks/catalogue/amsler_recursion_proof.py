"""Claims of section 5.1, the proof of the lemma on the recursion of Amsler sectors."""

from checks.claim import Check, Claim, Erratum, Mutant

_ANGLE = "checks.verify.recursion_angle:"
_LEMMA = "checks.verify.recursion_lemma:"
_BOUNDS = "checks.verify.amsler_lemma_range:"
_RANGE = "checks.verify.amsler_bounds:"
_CERTIFIED = "theory.painleve (balls)"
_BESSEL = "theory.bessel (balls)"
_BELOW = r"(used, not stated) $\phi_n < \phi^*$"

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="eq:integral",
        section="5.1",
        where="equation (eq:integral), line 1519",
        kind="equation",
        statement=(
            r"$\varphi(z) = \phi_n + \int_0^z\int_0^w "
            r"\sin(\varphi(\xi))\,\xi\,d\xi\,\frac{dw}{w}$ is equivalent to (PIII)."
        ),
        labels=("eq:integral",),
        hypotheses=(
            r"$\varphi(0) = \phi_n$",
            r"(used, not stated) $\varphi'(0) = 0$, the solution regular at $0$",
        ),
        rests_on=("PIII",),
        checks=(
            Check(
                name="both directions",
                run=_ANGLE + "integral_equation",
                routes=("printed integral", "derivatives of an unknown function"),
                mutants=(
                    Mutant(name="weight xi^2", given={"weight": 2}),
                    Mutant(name="sign of the integral", given={"sign": -1}),
                ),
            ),
            Check(
                name="series",
                run=_ANGLE + "integral_series",
                routes=("printed integral", "recursion of the coefficients (theory.amsler)"),
                mutants=(
                    Mutant(name="weight xi^2", given={"weight": 2}),
                    Mutant(name="no 1/w", given={"outer": 0}),
                ),
            ),
        ),
    ),
    Claim(
        id="5.1.monotone-to-threshold",
        section="5.1",
        where="proof of (lem:amsler_recursion), line 1522",
        kind="sentence",
        statement=(
            r"$\varphi$ increases on $[0, z^*]$, where $z^*$ is the smallest solution of "
            r"$\varphi(z) = \phi^*$."
        ),
        hypotheses=(
            r"$0 < \phi_n$, $\phi^* < \pi$",
            _BELOW,
            (
                "(used, not stated) such a solution exists: it does, at most at $z = "
                r"2\sqrt{(\phi^* - \phi_n)/\min(\sin\phi_n, \sin\phi^*)}$"
            ),
        ),
        rests_on=("eq:integral",),
        checks=(
            Check(
                name="sign of the rate",
                run=_ANGLE + "rises_to_threshold",
                routes=("derivative of z phi' by PIII", "sine by the tangent of the half-angle"),
                mutants=(
                    Mutant(name="sign of the sine", given={"force": -1}),
                    Mutant(name="z^2 phi'", given={"damping": 2}),
                ),
            ),
            Check(
                name="slopes and bound",
                run=_ANGLE + "threshold_samples",
                routes=("bound on z*", _CERTIFIED),
                mutants=(
                    Mutant(name="bound on z* 1 % less", given={"factor": "99/50"}, near=True),
                    Mutant(name="up to 1.5 z*", given={"late": "3/2"}),
                    Mutant(name="up to 2 z*", given={"late": "2"}),
                ),
            ),
        ),
    ),
    Claim(
        id="eq:defC",
        section="5.1",
        where="inequality (eq:defC), line 1524",
        kind="equation",
        statement=(
            r"$C^2\varphi \leq \sin\varphi \leq \varphi$ with $C = C(\phi^*) = "
            r"\sqrt{\sin\phi^*/\phi^*} < 1$."
        ),
        labels=("eq:defC",),
        hypotheses=(
            r"$0 < \phi_n \leq \varphi \leq \phi^*$",
            r"$\phi^* < \pi$; dropped, $C^2 \leq 0$ from $\phi^* = \pi$ on",
        ),
        checks=(
            Check(
                name="sin t/t falls",
                run=_ANGLE + "sine_quotient",
                routes=("derivative of sin t/t", "signs by the tangent of the half-angle"),
                mutants=(
                    Mutant(name="C^2 1 % larger", given={"scale": "101/100"}, near=True),
                    Mutant(name="no root", given={"root": False}),
                ),
            ),
            Check(
                name="samples",
                run=_ANGLE + "sine_samples",
                routes=("printed constant", "sines of balls"),
                mutants=(
                    Mutant(name="C^2 1 % larger", given={"scale": "101/100"}, near=True),
                    Mutant(name="sin phi <= 0.99 phi", given={"upper": "99/100"}, near=True),
                    Mutant(name="phi up to 1.1 phi*", given={"below": "11/10"}),
                    Mutant(name="phi* = 7/2", given={"levels": "7/2"}),
                ),
            ),
        ),
    ),
    Claim(
        id="5.1.linear-solution",
        section="5.1",
        where="proof of (lem:amsler_recursion), line 1527",
        kind="equation",
        statement=(
            r"$\phi_n I_0(Cz)$ solves $\varphi'' + z^{-1}\varphi' = C^2\varphi$, $\varphi(0) = "
            r"\phi_n$, $\varphi'(0) = 0$."
        ),
        checks=(
            Check(
                name="series",
                run=_ANGLE + "linear_solution",
                routes=("printed equation", "coefficients of I_0 for every index"),
                mutants=(
                    Mutant(name="2/z for 1/z", given={"damping": 2}),
                    Mutant(name="C for C^2", given={"power": 1}),
                    Mutant(name="I_1", given={"order": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="boundCphi*",
        section="5.1",
        where="inequality (boundCphi*), line 1529",
        kind="equation",
        statement=r"$I_0(C(\phi^*) z) \leq \frac{\varphi(z)}{\phi_n} \leq I_0(z)$.",
        labels=("boundCphi*",),
        hypotheses=(r"$0 \leq z \leq z^*$", r"$\phi_n > 0$, $\phi^* < \pi$", _BELOW),
        rests_on=("eq:integral", "eq:defC", "5.1.linear-solution", "5.1.monotone-to-threshold"),
        checks=(
            Check(
                name="comparison",
                run=_ANGLE + "wronskian",
                tier="full",
                routes=(
                    "rate of z (U' V - U V') by both equations",
                    "kernel and iterates of the double integral",
                ),
                mutants=(
                    Mutant(name="C for C^2", given={"power": 1}),
                    Mutant(name="0.99 for 1 above", given={"upper": "99/100"}, near=True),
                    Mutant(name="sign of the sine", given={"sine": -1}),
                ),
            ),
            Check(
                name="samples",
                run=_ANGLE + "bound_samples",
                routes=("Bessel functions of balls", _CERTIFIED),
                mutants=(
                    Mutant(name="C 1 % larger", given={"scale": "10201/10000"}, near=True),
                    Mutant(name="I_0(0.99 z) above", given={"upper": "99/100"}, near=True),
                    Mutant(name="C = sin phi*", given={"scale": "3"}),
                ),
            ),
            Check(
                name="every threshold at once",
                run=_ANGLE + "pointwise_bound",
                routes=("Bessel functions of balls", _CERTIFIED),
                mutants=(
                    Mutant(name="C 1 % larger", given={"scale": "10201/10000"}, near=True),
                    Mutant(name="C twice as large", given={"scale": "4"}),
                ),
            ),
            Check(
                name="whole range",
                run=_RANGE + "certificate",
                tier="full",
                routes=(
                    "stored run: Cauchy's bounds on complex disks, Bessel's kernel over cells",
                    "interval Taylor steps of the integral equation (checks.certificates)",
                ),
                mutants=(
                    Mutant(name="C 0.1 % larger", given={"lower": "1001/1000"}, near=True),
                    Mutant(name="I_0(0.99 z) above", given={"upper": "99/100"}, near=True),
                    Mutant(name="C at phi_n", given={"constant": "at phi_n"}),
                    Mutant(name="phi_n from 1e-7 on", given={"beginning": "1e-7"}),
                ),
            ),
            Check(
                name="gaps",
                run="checks.verify.amsler_bound_identities:gap_identities",
                form="support",
                routes=("equations of the gaps", "equations of U and of Bessel functions"),
                mutants=(
                    Mutant(name="x^2 q U", given={"source_power": 2}),
                    Mutant(name="s^2 K_2 for 2 s^2 K_2", given={"by_parts": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="5.1.lemma-cut",
        section="5.1",
        where="proof of (lem:amsler_recursion), line 1532",
        kind="equation",
        statement=(
            r"$u_n^* = \frac{1}{4 "
            r"v_{\max}}\left(I_0^{-1}\left(\frac{\phi^*}{\phi_n}\right)\right)^2$ and $v_n^* = "
            r"\frac{1}{4 u_{\max}}\left(I_0^{-1}\left(\frac{\phi^*}{\phi_n}\right)\right)^2$: "
            r"the far corners of $\Omega^*$ have $2\sqrt{uv} = I_0^{-1}(\phi^*/\phi_n) \leq "
            "z^*$."
        ),
        hypotheses=(_BELOW, r"(used, not stated) $I_0^{-1}$ is the inverse on $[0, \infty)$"),
        rests_on=("boundCphi*",),
        checks=(
            Check(
                name="corners",
                run=_LEMMA + "cut_corners",
                part="corners",
                routes=("printed cut", "similarity variable on the rectangles"),
                mutants=(
                    Mutant(name="2 for 4", given={"factor": "2"}),
                    Mutant(name="3.96 for 4", given={"factor": "99/25"}, near=True),
                    Mutant(name="u_max and v_max exchanged", given={"swapped": True}),
                    Mutant(name="first power", given={"power": 1}),
                ),
            ),
            Check(
                name="before the threshold",
                run=_LEMMA + "corner_before_threshold",
                part="threshold",
                routes=(_BESSEL, _CERTIFIED),
                mutants=(
                    Mutant(name="X 1 % larger", given={"grown": "101/100"}, near=True),
                    Mutant(name="X twice as large", given={"grown": "2"}),
                ),
            ),
            Check(
                name="from the bounds",
                run=_BOUNDS + "cut_before_threshold",
                part="threshold",
                routes=("place of the cut", "upper bound of (boundCphi*) as I_0 grows"),
                mutants=(
                    Mutant(name="X 1 % larger", given={"grown": "101/100"}, near=True),
                    Mutant(name="J_0 for I_0", given={"sign": -1}),
                ),
            ),
        ),
    ),
    Claim(
        id="5.1.lemma-lower-bound",
        section="5.1",
        where="proof of (lem:amsler_recursion), line 1532",
        kind="equation",
        statement=r"$\varphi(u_n^*, v_n^*) \geq \phi_n I_0(2 C(\phi^*)\sqrt{u_n^* v_n^*})$.",
        hypotheses=(
            _BELOW,
            (
                r"(used, not stated) $2\sqrt{u_n^* v_n^*} \leq z^*$, as where $u_n^* \leq "
                r"u_{\max}$ and $v_n^* \leq v_{\max}$"
            ),
        ),
        rests_on=("5.1.lemma-cut", "boundCphi*"),
        checks=(
            Check(
                name="as printed",
                run=_LEMMA + "lower_bound",
                routes=("Bessel functions of balls", _CERTIFIED),
                mutants=(
                    Mutant(name="C 1 % larger", given={"scale": "10201/10000"}, near=True),
                    Mutant(name="C twice as large", given={"scale": "4"}),
                ),
            ),
            Check(
                name="corner in the rectangle",
                run=_LEMMA + "lower_bound",
                form="corrected",
                given={"meets": True},
                routes=("Bessel functions of balls", _CERTIFIED),
                mutants=(
                    Mutant(
                        name="C 1 % larger",
                        given={"meets": True, "scale": "10201/10000"},
                        near=True,
                    ),
                    Mutant(name="C twice as large", given={"meets": True, "scale": "4"}),
                    Mutant(name="every rectangle", given={"meets": False}),
                ),
            ),
            Check(
                name="from the bounds",
                run=_BOUNDS + "lower_bound_at_corner",
                form="corrected",
                routes=("cut of the proof", "sides of the rectangle and (boundCphi*)"),
                mutants=(
                    Mutant(name="X up to 1 % larger", given={"share": "101/100"}, near=True),
                    Mutant(name="2 for 4", given={"factor": "2"}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=(
                r"$\varphi(u_n^*, v_n^*) \geq \phi_n I_0(2 C(\phi^*)\sqrt{u_n^* v_n^*})$ whatever "
                r"$u_{\max}$ and $v_{\max}$ are"
            ),
            corrected=(
                r"the same if $I_0^{-1}(\phi^*/\phi_n) \leq 2\sqrt{u_{\max} v_{\max}}$, so that "
                r"$2\sqrt{u_n^* v_n^*} \leq I_0^{-1}(\phi^*/\phi_n) \leq z^*$"
            ),
            kind="hypothesis",
            witness=(
                r"$\phi_n = 1/10$, $\phi^* = 9/4$, $u_{\max} = v_{\max} = 1/2$: $2\sqrt{u_n^* "
                r"v_n^*} = 22.9 > z^*$; there $\varphi = 2.94$, the bound is above $7700$"
            ),
            conclusion_survives=True,
            remark="The fault of lem:amsler_recursion, where (boundCphi*) is used beyond $z^*$.",
        ),
    ),
)
