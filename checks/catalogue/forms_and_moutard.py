"""Claims of section 3.1, items (H) and (I): the fundamental forms, the Moutard equation."""

from checks.claim import Check, Claim, Erratum, Mutant

_RUN = "checks.verify.fundamental_forms:"
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
    "pseudosphere and Dini's surface differentiated, on both sides of their edges",
)
_NO_SIGMA = Mutant(name="sigma dropped", given={"sigma_power": 2})

_FORMS = (
    Claim(
        id="3.1.H-first-form",
        section="3.1",
        where="equation (eq:metrics), first line, item (H), line 310",
        kind="equation",
        statement=r"$g = dr \cdot dr = du^2 + 2 \sigma \cos\varphi\, du\, dv + dv^2$.",
        hypotheses=_NET,
        rests_on=("3.1.G-cosine",),
        checks=(
            Check(
                name="dr.dr",
                run=_RUN + "first_fundamental_form",
                routes=_ROUTES,
                mutants=(
                    _NO_SIGMA,
                    Mutant(name="factor 1", given={"factor": 1}),
                    Mutant(name="sine for cosine", given={"swapped": True}),
                ),
            ),
        ),
    ),
    Claim(
        id="eq:metrics",
        section="3.1",
        where="equation (eq:metrics), second line, item (H), lines 311-312",
        kind="equation",
        statement=r"The second fundamental form is $h = dN^\omega \cdot dr = -2 \sigma "
        r"\sin\varphi\, du\, dv$ (the first line of the display is claim 3.1.H-first-form).",
        labels=("eq:metrics",),
        hypotheses=_NET,
        rests_on=("3.1.G-sine", "eq:def_phi", "3.1.H-first-form"),
        checks=(
            Check(
                name="dN.dr",
                run=_RUN + "second_fundamental_form",
                routes=_ROUTES,
                mutants=(
                    _NO_SIGMA,
                    Mutant(name="factor -1", given={"factor": -1}),
                ),
            ),
            Check(
                name="-dN.dr",
                run=_RUN + "second_fundamental_form",
                form="corrected",
                given={"differential_sign": -1},
                routes=_ROUTES,
                mutants=(
                    _NO_SIGMA,
                    Mutant(name="factor -1", given={"factor": -1}),
                    Mutant(name="printed sign", given={"differential_sign": 1}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"h = dN^\omega \cdot dr = -2 \sigma \sin\varphi\, du\, dv",
            corrected=r"h = -dN^\omega \cdot dr = -2 \sigma \sin\varphi\, du\, dv",
            kind="misprint",
            witness=r"At a point with $r_u = e_1$, $r_v = e_2$, $N = e_3$ ($\sigma = 1$, $\varphi "
            r"= \pi/2$): $N_u = N \times r_u = e_2$ and $N_v = -N \times r_v = e_1$, so $dN \cdot "
            r"dr = (N_u \cdot r_v + N_v \cdot r_u)\, du\, dv = +2\, du\, dv$; and $N \cdot "
            r"r_{uv} = N \cdot (N_u \times N_v) = -1$.",
            conclusion_survives=True,
            remark=r"Item (G) has $N \cdot r_{uv} = -\sigma \sin\varphi$, which agrees with the "
            r"last member; the sign belongs before $dN^\omega \cdot dr$.",
        ),
    ),
)

_MOUTARD = (
    Claim(
        id="3.1.I-tangent-plane",
        section="3.1",
        where="section 3.1, item (I), line 314",
        kind="sentence",
        statement=r"$N_u = N \times r_u$ and $N_v = -N \times r_v$ are perpendicular to $N$ and in "
        r"the span of $r_u$ and $r_v$.",
        hypotheses=_NET,
        rests_on=("3.1.C-right-handed-frames",),
        checks=(
            Check(
                name="tangential derivatives",
                run=_RUN + "tangential",
                routes=_ROUTES,
                mutants=(
                    Mutant(name="N_u reversed", given={"sign_u": -1}),
                    Mutant(name="N_v reversed", given={"sign_v": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="item:moutard",
        section="3.1",
        where="section 3.1, item (I) (item:moutard), line 314",
        kind="item",
        statement=r"$N_u$ is $r_u$ turned by $\pi/2$ about $N$, and $N_v$ is $r_v$ turned by "
        r"$-\pi/2$.",
        labels=("item:moutard",),
        hypotheses=_NET,
        rests_on=("3.1.I-tangent-plane",),
        checks=(
            Check(
                name="rotations",
                run=_RUN + "rotations",
                routes=_ROUTES,
                mutants=(
                    Mutant(name="r_u turned backwards", given={"quarters_u": -1}),
                    Mutant(name="r_v turned forwards", given={"quarters_v": 1}),
                    Mutant(name="r_u turned by pi", given={"quarters_u": 2}),
                ),
            ),
        ),
    ),
    Claim(
        id="eq:moutard",
        section="3.1",
        where="equation (eq:moutard), item (I), lines 315-319",
        kind="equation",
        statement=r"$N_{uv} = N_v \times r_u = -(N \times r_v) \times r_u = N (r_u \cdot r_v) - "
        r"r_v (r_u \cdot N) = \sigma \cos\varphi\, N = -(N_u \cdot N_v) N$.",
        labels=("eq:moutard",),
        hypotheses=_NET,
        rests_on=("3.1.I-tangent-plane", "eq:def_phi", "3.1.G-cosine"),
        checks=(
            Check(
                name="five equalities",
                tier="full",
                run=_RUN + "moutard",
                routes=_ROUTES,
                mutants=(
                    Mutant(name="r_u x N_v", given={"first": -1}),
                    Mutant(name="(N x r_v) x r_u", given={"second": 1}),
                    Mutant(name="plus before r_v", given={"third": 1}),
                    Mutant(name="-sigma cos phi N", given={"fourth": -1}),
                    Mutant(name="+(N_u.N_v) N", given={"fifth": 1}),
                    Mutant(name="sine for cosine", given={"swapped": True}),
                ),
            ),
        ),
    ),
)

CLAIMS: tuple[Claim, ...] = (*_FORMS, *_MOUTARD)
