"""Claims of section 3.1, item (J): the zero-curvature condition and the sine-Gordon equation."""

from checks.claim import Check, Claim, Mutant

_RUN = "checks.verify.zero_curvature:"
_NET = (
    (
        r"$K = -1$, $(u, v)$ asymptotic coordinates of unit speed, torsion $-1$ along $u$ and $+1$ "
        r"along $v$"
    ),
    (
        r"$N = N^\omega$, $\sigma = \operatorname{sign}(\omega(r_u, r_v))$ constant, "
        r"$r_u \times r_v \neq 0$"
    ),
)
_SMOOTH = (
    r"(used, not stated) $\varphi$ has the derivatives $\varphi_u, \varphi_v, \varphi_{uv}$",
)
_ROUTES = (
    "printed formula",
    "Gauss-Weingarten for an unknown angle and either sigma",
    "pseudosphere and Dini's surface differentiated, on both sides of their edges",
)
_NO_SIGMA = Mutant(name="sigma dropped", given={"sigma_power": 2})

_SYSTEMS = (
    Claim(
        id="3.1.J-u-frame",
        section="3.1",
        where="section 3.1, item (J), display in lines 321-329",
        kind="equation",
        statement=r"$\partial_v (r_u, N \times r_u, N)^T = \sigma \left(\begin{smallmatrix} 0 & 0 "
        r"& -\sin\varphi \\ 0 & 0 & \cos\varphi \\ \sin\varphi & -\cos\varphi & 0 "
        r"\end{smallmatrix}\right) (r_u, N \times r_u, N)^T$.",
        hypotheses=_NET,
        rests_on=("eq:def_phi", "eq:moutard", "3.1.C-normal-derivative"),
        checks=(
            Check(
                name="row by row",
                tier="full",
                run=_RUN + "cross_derivative_u",
                routes=_ROUTES,
                mutants=(
                    _NO_SIGMA,
                    Mutant(name="first row", given={"upper_sine": 1}),
                    Mutant(name="second row", given={"upper_cosine": -1}),
                    Mutant(name="last row, sine", given={"lower_sine": -1}),
                    Mutant(name="last row, cosine", given={"lower_cosine": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.J-v-frame",
        section="3.1",
        where="section 3.1, item (J), lines 330-331",
        kind="equation",
        statement=r"The corresponding system, which is not displayed, is $\partial_u (r_v, N "
        r"\times r_v, N)^T = \sigma \left(\begin{smallmatrix} 0 & 0 & -\sin\varphi \\ 0 & 0 & "
        r"-\cos\varphi \\ \sin\varphi & \cos\varphi & 0 \end{smallmatrix}\right) (r_v, N \times "
        r"r_v, N)^T$.",
        hypotheses=_NET,
        rests_on=("eq:def_phi", "eq:moutard"),
        checks=(
            Check(
                name="row by row",
                run=_RUN + "cross_derivative_v",
                routes=_ROUTES,
                mutants=(
                    _NO_SIGMA,
                    Mutant(name="sines reversed", given={"upper_sine": 1}),
                    Mutant(name="cosines as for the u-lines", given={"upper_cosine": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.J-zero-curvature",
        section="3.1",
        where="section 3.1, item (J), line 330",
        kind="equation",
        statement=r"If $F_u = A F$ and $F_v = B F$ with $F$ invertible, then $F_{uv} = F_{vu}$ is "
        r"equivalent to $A_v - B_u + [A, B] = 0$.",
        hypotheses=(r"(used, not stated) $[A, B] = AB - BA$",),
        checks=(
            Check(
                name="product rule",
                tier="full",
                run=_RUN + "zero_curvature",
                routes=("printed condition", "mixed derivatives of a frame of unknown functions"),
                mutants=(
                    Mutant(name="+B_u", given={"derivative": 1}),
                    Mutant(name="[B, A]", given={"commutator": -1}),
                ),
            ),
        ),
    ),
)

_SINE_GORDON = (
    Claim(
        id="3.1.J-curvatures",
        section="3.1",
        where="equation (eq:sg), first line, item (J), line 333",
        kind="equation",
        statement=r"$\kappa^u = -\varphi_u$ and $\kappa^v = \varphi_v$: the zero-curvature "
        r"conditions force them, and with them only one entry of each condition is left.",
        hypotheses=(*_NET, *_SMOOTH),
        rests_on=("eq:frames", "3.1.J-u-frame", "3.1.J-v-frame", "3.1.J-zero-curvature"),
        checks=(
            Check(
                name="both frames",
                tier="full",
                run=_RUN + "curvatures",
                routes=("zero curvature with an unknown kappa", *_ROUTES),
                mutants=(
                    Mutant(name="kappa^u reversed", given={"sign_u": 1}),
                    Mutant(name="kappa^v reversed", given={"sign_v": -1}),
                ),
            ),
        ),
    ),
    Claim(
        id="eq:sg",
        section="3.1",
        where="equation (eq:sg), item (J), lines 332-335",
        kind="equation",
        statement=r"$-\partial_v \kappa^u = \partial_u \kappa^v = \varphi_{uv} = \sigma "
        r"\sin\varphi$; together with the first line this is equivalent to the zero-curvature "
        r"condition of either frame.",
        labels=("eq:sg",),
        hypotheses=(*_NET, *_SMOOTH),
        rests_on=("3.1.J-curvatures",),
        checks=(
            Check(
                name="equivalent conditions",
                tier="full",
                run=_RUN + "sine_gordon",
                part="equivalence",
                routes=(
                    "zero curvature of both frames",
                    "r_uuv - r_uvu by Gauss-Weingarten",
                    "Gauss curvature of the metric by Brioschi's formula",
                ),
                mutants=(
                    _NO_SIGMA,
                    Mutant(name="sign", given={"sign": -1}),
                    Mutant(name="cosine for sine", given={"swapped": True}),
                ),
            ),
            Check(
                name="explicit surfaces",
                tier="full",
                run=_RUN + "sine_gordon_on_surfaces",
                part="surfaces",
                routes=(
                    "printed formula",
                    "geodesic curvatures and angle of the pseudosphere, Dini's and Kuen's surface",
                ),
                mutants=(
                    _NO_SIGMA,
                    Mutant(name="sign", given={"sign": -1}),
                    Mutant(name="cosine for sine", given={"swapped": True}),
                    Mutant(name="+kappa^u_v", given={"sign_u": 1}),
                    Mutant(name="-kappa^v_u", given={"sign_v": -1}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.J-constant-sigma",
        section="3.1",
        where="section 3.1, item (J), line 336",
        kind="sentence",
        statement=r"(eq:sg) needs a constant $\sigma = \operatorname{sign}(\omega(r_u, r_v))$; "
        r"integrated over a rectangle of which the edge of the pseudosphere cuts off one "
        r"corner it is off by $\pi$.",
        hypotheses=(*_NET[:1], r"$N = N^\omega$ continuous, $0 \le \varphi \le \pi$"),
        rests_on=("eq:sg",),
        checks=(
            Check(
                name="integrated over rectangles",
                run=_RUN + "constant_sigma",
                routes=("corner difference of the angle", "integral of sigma sin phi"),
                mutants=(Mutant(name="rectangle across the edge", given={"first": -2}),),
            ),
        ),
    ),
)

CLAIMS: tuple[Claim, ...] = (*_SYSTEMS, *_SINE_GORDON)
