"""Claims of section 5.1, the recursion on Amsler sectors."""

from checks.claim import Claim

_RISE = r"(used, not stated) $\varphi$ does not decrease along the two axes"
_BELOW = r"(used, not stated) $\phi_n < \phi^*$"
_MEET = (
    r"(used, not stated) $I_0^{-1}(\phi^*/\phi_n) \leq 2\sqrt{u_{\max} v_{\max}}$, so that "
    r"$u_n^* \leq u_{\max}$ and $v_n^* \leq v_{\max}$"
)

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="fig:cutsketch",
        section="5.1",
        where="figure (fig:cutsketch), lines 1475-1493",
        kind="figure",
        statement=(
            "A cut from generation $n$ to $n + 1$: an $L$-shaped region along the axes, the "
            r"contours $z = z^*$ and $z = 2\sqrt{u_n^* v_n^*}$, and the circle $\partial\Omega$ "
            r"that meets the axes at $u_{\max}$ and $v_{\max}$."
        ),
        labels=("fig:cutsketch",),
        hypotheses=("(used, not stated) the contours are those of an Amsler sector",),
        rests_on=("5.1.cut-from-L-region",),
    ),
    Claim(
        id="5.1.new-generation",
        section="5.1",
        where="section 5.1, line 1493",
        kind="sentence",
        statement=(
            r"A branch point of generation $n + 1$ is needed where the locus $\varphi(u, v) = "
            r"\phi^*$ meets the boundary of the domain."
        ),
        hypotheses=(
            r"$\phi^* < \pi$",
            (
                "(used, not stated) the locus meets the domain: in a sector that it enters it "
                "also meets the boundary"
            ),
        ),
        rests_on=("PIII",),
    ),
    Claim(
        id="5.1.cut-from-L-region",
        section="5.1",
        where="section 5.1, line 1493",
        kind="sentence",
        statement=(
            r"The place $(u_n^*, v_n^*)$ of the new branch point is determined by $\varphi \leq "
            r"\phi^*$ on $[0, u_{\max}] \times [0, v_n^*] \cup [0, u_n^*] \times [0, v_{\max}]$."
        ),
        hypotheses=(
            "(used, not stated) $u_n^*$ and $v_n^*$ are the largest with this property",
            (
                r"(used, not stated) $\varphi$ is asked for inside $\Omega$ only, not on the "
                "whole of the two rectangles"
            ),
        ),
        rests_on=("5.1.new-generation", "alg:greedy-cuts"),
    ),
    Claim(
        id="5.1.L-region-safe",
        section="5.1",
        where="section 5.1, line 1493",
        kind="sentence",
        statement=(
            r"On the $L$-shaped region the angle stays away from the singular edge: $\phi_n \leq "
            r"\varphi \leq \phi^* < \pi$."
        ),
        hypotheses=(r"$\phi^* < \pi$", _RISE),
        rests_on=("5.1.cut-from-L-region", "5.1.monotone"),
    ),
    Claim(
        id="5.1.trisection",
        section="5.1",
        where="section 5.1, line 1495",
        kind="equation",
        statement=r"$\phi_{n+1} = \frac13\varphi(u_n^*, v_n^*)$.",
        hypotheses=("(used, not stated) the removed angle is trisected exactly",),
        rests_on=("eq:trisect", "5.1.cut-from-L-region"),
    ),
    Claim(
        id="5.1.monotone",
        section="5.1",
        where="section 5.1, line 1495",
        kind="sentence",
        statement=(
            r"$\varphi$ increases in $u$ and in $v$, because $\varphi_{uv} = \sin\varphi > 0$."
        ),
        hypotheses=(
            r"$0 < \varphi < \pi$",
            _RISE,
            r"(used, not stated) $\sigma = +1$ in the sector",
        ),
        rests_on=("eq:sg",),
    ),
    Claim(
        id="5.1.only-trisection-decreases",
        section="5.1",
        where="section 5.1, line 1495",
        kind="sentence",
        statement=r"Nothing but the trisection at a branch point makes $\varphi$ smaller.",
        hypotheses=(
            (
                "(used, not stated) along an axis that a daughter takes from its parent "
                r"$\varphi$ does not decrease"
            ),
        ),
        rests_on=("5.1.monotone", "5.1.trisection"),
    ),
    Claim(
        id="ebound",
        section="5.1",
        where="equation (ebound), line 1497",
        kind="equation",
        statement=(
            r"$\mathcal{E}_\infty = \max_{n,k}\left(\cot\frac{\phi_{n,k}}{2}, "
            r"\tan\frac{\phi^*}{2}\right)$, with $\phi_{n,k}$ the angle at branch point $k$ of "
            "generation $n$."
        ),
        labels=("ebound",),
        hypotheses=(
            "net or surface made by the greedy algorithm",
            r"(used, not stated) the origin counts as generation $0$ with angle $\phi_0$",
            r"(used, not stated) $\varphi$ reaches $\phi^*$ somewhere: otherwise only $\leq$ holds",
            _RISE,
        ),
        rests_on=(
            "5.principal-curvatures",
            "5.1.monotone",
            "5.1.only-trisection-decreases",
            "alg:greedy-cuts",
        ),
    ),
    Claim(
        id="5.1.amsler-self-similar",
        section="5.1",
        where="section 5.1, line 1502",
        kind="sentence",
        statement=(
            r"In a sector bounded by geodesics $\varphi(u, v) = \varphi(2\sqrt{uv})$ with "
            r"$\varphi(z)$ a solution of (PIII)."
        ),
        hypotheses=(r"(used, not stated) $\varphi(0) = \phi_n$, $\varphi'(0) = 0$",),
        rests_on=("PIII", "def:amsler-sector"),
    ),
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
            r"$\varphi$ solves (PIII) with $\varphi(0) = \phi_n > 0$, taken at $z = 2\sqrt{uv}$",
            r"$u_{\max}, v_{\max} > 0$, $\phi^* < \pi$",
            _BELOW,
            _MEET,
        ),
        rests_on=("5.1.lemma-part-1", "5.1.lemma-part-2"),
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
    ),
    Claim(
        id="5.1.lemma-part-2",
        section="5.1",
        where="lemma (lem:amsler_recursion), part 2, line 1508",
        kind="lemma",
        statement=r"$\varphi(u_n^*, v_n^*) \geq \phi_n I_0(C(\phi^*)\zeta_n)$.",
        hypotheses=(r"$\varphi(0) = \phi_n > 0$, $\phi^* < \pi$", _BELOW, _MEET),
        rests_on=("5.1.lemma-lower-bound", "5.1.zeta"),
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
    ),
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
            "(used, not stated) such a solution exists",
        ),
        rests_on=("eq:integral",),
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
        hypotheses=(r"$0 < \phi_n \leq \varphi \leq \phi^*$", r"$\phi^* < \pi$"),
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
    ),
    Claim(
        id="rem:amsler_scaling",
        section="5.1",
        where="remark (rem:amsler_scaling), displayed formula, line 1537",
        kind="remark",
        statement=(
            r"$\phi_{n+1} \geq \frac{\phi_n}{3} I_0\left(\frac{C(\phi^*)}{2\sqrt{u_{\max} "
            r"v_{\max}}} X^2\right) \geq \frac{\phi_n}{3} I_0\left(\frac{C(\phi^*)}{2R} "
            r"X^2\right)$ with $X = I_0^{-1}(\phi^*/\phi_n)$."
        ),
        labels=("rem:amsler_scaling",),
        hypotheses=(
            "Amsler sector",
            r"$u_{\max} \leq R$, $v_{\max} \leq R$",
            _BELOW,
            _MEET,
            (
                "(used, not stated) the branch point sits where the lemma puts it, or farther "
                "out along the contour of the corner"
            ),
        ),
        rests_on=("lem:amsler_recursion", "5.1.trisection"),
    ),
    Claim(
        id="5.1.axes-below-radius",
        section="5.1",
        where="remark (rem:amsler_scaling), line 1539",
        kind="sentence",
        statement=(
            r"The axes of an Amsler sector have lengths $u_{\max} \leq R$ and $v_{\max} \leq R$ "
            "inside the disk of radius $R$."
        ),
        hypotheses=(
            (
                "(used, not stated) the axes leave the branch point outward, at no acute angle "
                "with the direction to the origin"
            ),
        ),
        rests_on=("eq:hyp_radius",),
    ),
    Claim(
        id="5.1.small-angles-grow",
        section="5.1",
        where="remark (rem:amsler_scaling), line 1539",
        kind="sentence",
        statement=r"$\phi_{n+1}/\phi_n \geq 1$ when $\phi_n$ is small enough.",
        hypotheses=(
            "Amsler sector",
            r"(used, not stated) small enough depends on $R$ and $\phi^*$",
        ),
        rests_on=("rem:amsler_scaling",),
    ),
    Claim(
        id="5.1.smallest-angle-amsler",
        section="5.1",
        where="remark (rem:amsler_scaling), line 1539",
        kind="remark",
        statement=(
            r"With a constant $C'(\phi^*)$ independent of $R$ and $\phi_{\min} = "
            r"\phi^*/I_0(C'(\phi^*)\sqrt{R})$: if $\phi_0 \geq \phi_{\min}$ then $\phi_n \geq "
            r"\phi_{\min}$ for all $n$."
        ),
        hypotheses=(
            "every sector is an Amsler sector",
            (
                r"(used, not stated) $R \geq R_0(\phi^*)$: for small $R$, $\phi_{\min}$ is near "
                r"$\phi^*$ and one trisection falls below it"
            ),
        ),
        rests_on=("rem:amsler_scaling", "5.1.small-angles-grow"),
    ),
    Claim(
        id="5.1.cutoff-dependence",
        section="5.1",
        where="remark (rem:amsler_scaling), line 1539",
        kind="sentence",
        statement=(
            r"For $\phi^*$ in a compact subset of $(0, \pi)$ the constants can be chosen "
            r"independent of $\phi^*$."
        ),
        rests_on=("5.1.smallest-angle-amsler", "eq:defC"),
    ),
)
