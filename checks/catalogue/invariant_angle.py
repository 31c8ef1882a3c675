"""Claims of section 3.1, item (G): the invariant angle between the asymptotic directions."""

from checks.claim import Check, Claim, Mutant

_RUN = "checks.verify.invariant_angle:"
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
_ROUTES = (
    "printed formula",
    "Gauss-Weingarten for an unknown angle and either sigma",
    "soliton angle and derivatives of the pseudosphere and of Dini's surface, both sides",
)
_NO_SIGMA = Mutant(name="sigma dropped", given={"sigma_power": 2})

_INVARIANCE = (
    Claim(
        id="3.1.G-naive-angle",
        section="3.1",
        where="section 3.1, item (G), line 293",
        kind="sentence",
        statement=r"$\cos\varphi = r_u \cdot r_v$ is not invariant under $u \to -u$ nor under $v "
        r"\to -v$: both reverse the sign of $r_u \cdot r_v$.",
        hypotheses=_NET,
        rests_on=("3.1.F-flipped-coordinates",),
        checks=(
            Check(
                name="sign of r_u.r_v",
                run=_RUN + "naive_angle",
                routes=_ROUTES,
                mutants=(
                    Mutant(name="both flips at once", given={"flips": "both"}),
                    Mutant(name="times sigma", given={"sigma": True}),
                ),
            ),
        ),
    ),
    Claim(
        id="item:ruv",
        section="3.1",
        where="section 3.1, item (G) (item:ruv), line 293",
        kind="item",
        statement=r"$\sigma r_u \cdot r_v$, $-\sigma N_u \cdot N_v$ and $\sigma (r_u \times r_v) "
        r"\cdot N$ are invariant under $u \to -u$ and $v \to -v$, so $\varphi$ is.",
        labels=("item:ruv",),
        hypotheses=_NET,
        rests_on=("3.1.F-flip-insensitive", "eq:def_phi"),
        checks=(
            Check(
                name="flips",
                tier="full",
                run=_RUN + "invariant_angle",
                routes=_ROUTES,
                mutants=(
                    Mutant(name="cosine without sigma", given={"cosine_power": 2}),
                    Mutant(name="sine without sigma", given={"sine_power": 2}),
                ),
            ),
        ),
    ),
)

_DEFINITION = (
    Claim(
        id="3.1.G-cosine",
        section="3.1",
        where="equation (eq:def_phi), first line, item (G), lines 295-296",
        kind="equation",
        statement=r"$\cos\varphi = \sigma r_u \cdot r_v = -\sigma N_u \cdot N_v$.",
        hypotheses=_NET,
        rests_on=("eq:Nfront", "3.1.B-unit-speed", "3.1.C-right-handed-frames"),
        checks=(
            Check(
                name="tangents",
                run=_RUN + "angle_cosine",
                part="tangents",
                routes=_ROUTES,
                mutants=(_NO_SIGMA, Mutant(name="sine for cosine", given={"swapped": True})),
            ),
            Check(
                name="normals",
                run=_RUN + "angle_cosine_of_normals",
                part="normals",
                routes=(
                    "printed formula",
                    "derivatives of the normal",
                    "third fundamental form as 2H II - K I",
                ),
                mutants=(_NO_SIGMA, Mutant(name="sign", given={"sign": 1})),
            ),
        ),
    ),
    Claim(
        id="3.1.G-sine",
        section="3.1",
        where="equation (eq:def_phi), second and third line, item (G), lines 297-300",
        kind="equation",
        statement=r"$\sin\varphi = \sigma (r_u \times r_v) \cdot N = \|r_u \times r_v\|$.",
        hypotheses=_NET,
        rests_on=("3.1.G-cosine", "eq:Nfront"),
        checks=(
            Check(
                name="triple product",
                run=_RUN + "angle_sine",
                part="triple product",
                routes=_ROUTES,
                mutants=(_NO_SIGMA, Mutant(name="sign", given={"sign": -1})),
            ),
            Check(
                name="norm, squared",
                run=_RUN + "angle_norm",
                part="norm",
                routes=_ROUTES,
                mutants=(Mutant(name="norm squared for norm", given={"power": 2}),),
            ),
            Check(
                name="norm, its sign",
                run=_RUN + "sine_positive",
                part="sign",
                routes=("printed formula", "pseudosphere on all of both sides of its edge"),
                mutants=(_NO_SIGMA,),
            ),
        ),
    ),
    Claim(
        id="eq:def_phi",
        section="3.1",
        where="equation (eq:def_phi), item (G), lines 294-304",
        kind="equation",
        statement=r"With this angle, $r_{uv} = N_u \times N_v = -\sigma \sin\varphi\, N$.",
        labels=("eq:def_phi",),
        hypotheses=_NET,
        rests_on=("3.1.G-cosine", "3.1.G-sine", "3.1.D-mixed-derivative"),
        checks=(
            Check(
                name="mixed derivative",
                run=_RUN + "mixed_derivative",
                routes=_ROUTES,
                mutants=(
                    _NO_SIGMA,
                    Mutant(name="sign", given={"sign": 1}),
                    Mutant(name="cosine for sine", given={"swapped": True}),
                ),
            ),
        ),
    ),
)

_RANGE = (
    Claim(
        id="3.1.G-range",
        section="3.1",
        where="section 3.1, item (G), line 305",
        kind="sentence",
        statement=r"$\sin\varphi \ge 0$, so $0 \le \varphi \le \pi$.",
        hypotheses=(r"(used, not stated) $\varphi$ is the representative in $(-\pi, \pi]$",),
        rests_on=("3.1.G-sine",),
        checks=(
            Check(
                name="signs of the sine",
                run=_RUN + "angle_range",
                routes=("stated range", "sine as a rational function of tan(phi/2)"),
                mutants=(
                    Mutant(name="cosine", given={"function": "cos"}),
                    Mutant(name="negative sine", given={"function": "-sin"}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.G-immersion",
        section="3.1",
        where="section 3.1, item (G), line 305",
        kind="sentence",
        statement=r"$r$ is an immersion only where $r_u$ and $r_v$ are independent, that is where "
        r"$\varphi$ is neither $0$ nor $\pi$.",
        hypotheses=(r"$0 \le \varphi \le \pi$", r"$r_u \cdot r_u = r_v \cdot r_v = 1$"),
        rests_on=("3.1.G-sine", "3.1.G-range"),
        checks=(
            Check(
                name="Lagrange's identity",
                run=_RUN + "immersion",
                routes=("|r_u x r_v|^2 for any two vectors", "zeros of the sine by tan(phi/2)"),
                mutants=(
                    Mutant(name="plus in Lagrange's identity", given={"sign": 1}),
                    Mutant(name="other speeds", given={"unit": False}),
                    Mutant(name="zeros of the cosine", given={"function": "cos"}),
                ),
            ),
        ),
    ),
)

CLAIMS: tuple[Claim, ...] = (*_INVARIANCE[:1], *_DEFINITION, *_INVARIANCE[1:], *_RANGE)
