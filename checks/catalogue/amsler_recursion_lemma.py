"""Claims of section 5.1, the lemma on the recursion of Amsler sectors."""

from checks.claim import Check, Claim, Erratum, Mutant

_LEMMA = "checks.verify.recursion_lemma:"
_BOUNDS = "checks.verify.amsler_lemma_range:"
_CERTIFIED = "theory.painleve (balls)"
_BESSEL = "theory.bessel (balls)"
_BELOW = r"(used, not stated) $\phi_n < \phi^*$"
_MEET = (
    r"(used, not stated) $I_0^{-1}(\phi^*/\phi_n) \leq 2\sqrt{u_{\max} v_{\max}}$, so that "
    r"$u_n^* \leq u_{\max}$ and $v_n^* \leq v_{\max}$"
)
_WITNESS = (
    r"$\phi_n = 1/10$, $\phi^* = 9/4$, $u_{\max} = v_{\max} = 1/2$: $\zeta_n = 22.9$ and $\phi_n "
    r"I_0(C\zeta_n) > 7700$, while $\varphi \leq 0.127$ on the rectangle and $\varphi < 2\pi$ "
    "wherever (PIII) is continued"
)
_NEAR_C = Mutant(name="C 1 % larger", given={"meets": True, "scale": "10201/10000"}, near=True)

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="lem:amsler_recursion",
        section="5.1",
        where="lemma (lem:amsler_recursion), lines 1504-1514",
        kind="lemma",
        statement=(
            r"There are $u_n^*, v_n^* > 0$ with $\varphi \leq \phi^*$ on $\Omega^* = [0, "
            r"u_{\max}] \times [0, v_n^*] \cup [0, u_n^*] \times [0, v_{\max}]$ and "
            r"$\varphi(u_n^*, v_n^*) \geq \phi_n I_0(C(\phi^*)\zeta_n)$, where $0 < C(\phi^*) < "
            "1$."
        ),
        labels=("lem:amsler_recursion",),
        hypotheses=(
            (
                r"$\varphi$ solves (PIII) with $\varphi(0) = \phi_n > 0$, taken at $z = "
                r"2\sqrt{uv}$; with the other sign of the sine $\varphi$ falls and part 2 fails"
            ),
            (
                r"$\phi^* < \pi$; dropped, no $C > 0$ serves: $C^2 \leq \sin\phi_n/\phi_n$ for "
                r"$\phi_n$ near $\phi^*$"
            ),
            r"$u_{\max}, v_{\max} > 0$; dropped, $\zeta_n$ is not defined",
            (
                _BELOW + r"; dropped, $\varphi(0, 0) = \phi_n > \phi^*$, and $\phi_n = \phi^*$ "
                r"leaves $u_n^* = v_n^* = 0$"
            ),
            _MEET + "; dropped, part 2 asks for more than any angle",
        ),
        rests_on=("5.1.lemma-part-1", "5.1.lemma-part-2"),
        checks=(
            Check(
                name="as printed",
                run=_LEMMA + "lemma",
                routes=(_BESSEL, _CERTIFIED),
                mutants=(
                    Mutant(name="C = 1", given={"best": True}),
                    Mutant(name="phi_n = 2 > phi* = 1", given={"initial": "2", "level": "1"}),
                ),
            ),
            Check(
                name="rectangles that the contour can meet",
                run=_LEMMA + "lemma",
                tier="full",
                form="corrected",
                given={"meets": True},
                routes=(_BESSEL, _CERTIFIED),
                mutants=(
                    Mutant(name="C = 1", given={"meets": True, "best": True}),
                    Mutant(
                        name="corner 1 % farther out",
                        given={"meets": True, "grown": "101/100"},
                        near=True,
                    ),
                    Mutant(
                        name="phi_n = 2 > phi* = 1",
                        given={"meets": True, "initial": "2", "level": "1"},
                    ),
                    Mutant(name="every rectangle", given={"meets": False}),
                ),
            ),
            Check(
                name="whole range",
                run=_BOUNDS + "whole_range",
                form="corrected",
                tier="full",
                routes=(
                    "cut of the proof and sides of the rectangle",
                    "certificate of (boundCphi*) (checks.certificates)",
                ),
                mutants=(
                    Mutant(name="C 0.1 % larger", given={"lower": "1001/1000"}, near=True),
                    Mutant(name="I_0(0.99 z) above", given={"upper": "99/100"}, near=True),
                    Mutant(name="X up to 1 % larger", given={"share": "101/100"}, near=True),
                    Mutant(name="X up to twice as large", given={"share": "2"}),
                ),
            ),
            Check(
                name="phi* = pi",
                run=_LEMMA + "no_constant_at_pi",
                form="support",
                routes=(_BESSEL, _CERTIFIED),
                mutants=(
                    Mutant(name="phi_n = 2", given={"initial": "2"}),
                    Mutant(
                        name="C = 1/100, phi_n = 3.1412",
                        given={"constants": "1/100", "initial": "3.1412"},
                        near=True,
                    ),
                ),
            ),
            Check(
                name="phi_n = phi*",
                run=_LEMMA + "threshold_at_start",
                form="support",
                routes=("phi* = phi_n", _CERTIFIED),
                mutants=(Mutant(name="phi* 1 % above", given={"level": "101/100"}, near=True),),
            ),
            Check(
                name="no angle beyond 2 pi",
                run=_LEMMA + "never_beyond",
                form="support",
                routes=("energy by PIII", "its rate"),
                mutants=(Mutant(name="friction doubled", given={"damping": 2}),),
            ),
        ),
        erratum=Erratum(
            printed=(
                r"for given $u_{\max}, v_{\max}$ and $\phi^* < \pi$ there are $u_n^*, v_n^* > 0$ "
                r"with $\varphi(u_n^*, v_n^*) \geq \phi_n I_0(C\zeta_n)$"
            ),
            corrected=(
                r"the same if $\phi_n < \phi^*$ and $I_0^{-1}(\phi^*/\phi_n) \leq 2\sqrt{u_{\max} "
                r"v_{\max}}$"
            ),
            kind="hypothesis",
            witness=_WITNESS,
            conclusion_survives=True,
            remark=(
                r"Where a branch point is needed, $\varphi = \phi^*$ somewhere on the rectangle, "
                r"hence $\phi^* \leq \phi_n I_0(2\sqrt{u_{\max} v_{\max}})$: the recursion meets "
                "the hypothesis. It says that the cut of the proof lies in the rectangle."
            ),
        ),
    ),
    Claim(
        id="5.1.lemma-part-1",
        section="5.1",
        where="lemma (lem:amsler_recursion), part 1, line 1507",
        kind="lemma",
        statement=(
            r"With the $u_n^*, v_n^*$ of the proof, $\varphi(u, v) \leq \phi^*$ for all $(u, v) "
            r"\in \Omega^*$."
        ),
        hypotheses=(
            r"$\varphi(0) = \phi_n > 0$, $\phi^* < \pi$",
            _BELOW,
            (
                r"(used, not stated) where $u_n^* > u_{\max}$ or $v_n^* > v_{\max}$, $\varphi$ "
                "is continued beyond the rectangle"
            ),
        ),
        rests_on=("5.1.lemma-cut", "boundCphi*"),
        checks=(
            Check(
                name="corners",
                run=_LEMMA + "cut_corners",
                routes=("printed cut", "similarity variable on the rectangles"),
                part="largest z",
                mutants=(
                    Mutant(name="2 for 4", given={"factor": "2"}),
                    Mutant(name="u_max and v_max exchanged", given={"swapped": True}),
                ),
            ),
            Check(
                name="angle at the corners",
                run=_LEMMA + "part_1",
                routes=(_BESSEL, _CERTIFIED),
                part="angle",
                mutants=(
                    Mutant(name="corner 1 % farther out", given={"grown": "101/100"}, near=True),
                    Mutant(name="2 for 4", given={"factor": "2"}),
                    Mutant(name="phi_n = 2 > phi* = 1", given={"initial": "2", "level": "1"}),
                ),
            ),
            Check(
                name="from the bounds",
                run=_BOUNDS + "angle_on_cut",
                routes=("printed cut", "upper bound of (boundCphi*) as I_0 grows"),
                part="angle",
                mutants=(
                    Mutant(name="3.96 for 4", given={"factor": "99/25"}, near=True),
                    Mutant(name="u_max and v_max exchanged", given={"swapped": True}),
                    Mutant(name="J_0 for I_0", given={"sign": -1}),
                ),
            ),
        ),
    ),
    Claim(
        id="5.1.lemma-part-2",
        section="5.1",
        where="lemma (lem:amsler_recursion), part 2, line 1508",
        kind="lemma",
        statement=r"$\varphi(u_n^*, v_n^*) \geq \phi_n I_0(C(\phi^*)\zeta_n)$.",
        hypotheses=(
            r"$\varphi(0) = \phi_n > 0$, $\phi^* < \pi$",
            _BELOW,
            _MEET,
            r"(read so) the point $(u^*, v^*)$ of the printed formula is $(u_n^*, v_n^*)$",
        ),
        rests_on=("5.1.lemma-lower-bound", "5.1.zeta"),
        checks=(
            Check(
                name="as printed",
                run=_LEMMA + "part_2",
                routes=(_BESSEL, _CERTIFIED),
                mutants=(
                    Mutant(name="C = 1", given={"best": True}),
                    Mutant(name="C 1 % larger", given={"scale": "10201/10000"}, near=True),
                ),
            ),
            Check(
                name="rectangles that the contour can meet",
                run=_LEMMA + "part_2",
                form="corrected",
                given={"meets": True},
                routes=(_BESSEL, _CERTIFIED),
                mutants=(
                    _NEAR_C,
                    Mutant(name="C = 1", given={"meets": True, "best": True}),
                    Mutant(name="zeta_n twice as large", given={"meets": True, "factor": "1"}),
                    Mutant(name="every rectangle", given={"meets": False}),
                ),
            ),
            Check(
                name="from the bounds",
                run=_BOUNDS + "lower_bound_at_corner",
                form="corrected",
                routes=("cut of the proof", "sides of the rectangle and (boundCphi*)"),
                mutants=(
                    Mutant(name="X up to twice as large", given={"share": "2"}),
                    Mutant(name="X up to 1 % larger", given={"share": "101/100"}, near=True),
                    Mutant(name="2 for 4", given={"factor": "2"}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=(r"$\varphi(u^*, v^*) \geq \phi_n I_0(C(\phi^*)\zeta_n)$, no more assumed"),
            corrected=(
                r"$\varphi(u_n^*, v_n^*) \geq \phi_n I_0(C(\phi^*)\zeta_n)$ if "
                r"$I_0^{-1}(\phi^*/\phi_n) \leq 2\sqrt{u_{\max} v_{\max}}$"
            ),
            kind="hypothesis",
            witness=_WITNESS,
            conclusion_survives=True,
            remark="The fault of lem:amsler_recursion: its part 1 needs no such hypothesis.",
        ),
    ),
    Claim(
        id="5.1.zeta",
        section="5.1",
        where="lemma (lem:amsler_recursion), displayed formula, line 1510",
        kind="equation",
        statement=(
            r"$\zeta_n = \frac{1}{2\sqrt{u_{\max} "
            r"v_{\max}}}\left(I_0^{-1}\left(\frac{\phi^*}{\phi_n}\right)\right)^2$, which equals "
            r"$2\sqrt{u_n^* v_n^*}$ for the cut of the proof."
        ),
        hypotheses=(_BELOW,),
        rests_on=("5.1.lemma-cut",),
        checks=(
            Check(
                name="product of the cut",
                run=_LEMMA + "zeta_of_cut",
                routes=("displayed formula", "cut of the proof"),
                mutants=(
                    Mutant(name="1 for 2", given={"factor": "1"}),
                    Mutant(name="2.02 for 2", given={"factor": "101/50"}, near=True),
                    Mutant(name="first power", given={"power": 1}),
                ),
            ),
        ),
    ),
)
