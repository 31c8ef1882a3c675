"""Claims of section 3.1, items (B) and (C): frames of the asymptotic lines, Lelieuvre formulae."""

from checks.claim import Check, Claim, Erratum, Mutant

_RUN = "checks.verify.asymptotic_frames:"
_NET = (
    (
        r"$K = -1$, $(u, v)$ asymptotic coordinates of unit speed, torsion $-1$ along $u$ and $+1$ "
        r"along $v$"
    ),
    r"(used, not stated) $r_{uu}$ and $r_{vv}$ exist",
)
_ROUTES = (
    "printed formula",
    "Gauss-Weingarten for an unknown angle and either sigma",
    "pseudosphere and Dini's surface differentiated, on both sides of their edges",
)

_FRAMES = (
    Claim(
        id="3.1.B-frames-orthonormal",
        section="3.1",
        where="section 3.1, item (B), line 250",
        kind="sentence",
        statement=r"$(r_u, N \times r_u, N)$ and $(r_v, N \times r_v, N)$ are orthonormal and "
        r"right-handed.",
        hypotheses=_NET,
        rests_on=("3.1.B-unit-speed", "3.1.A-normal-sign"),
        checks=(
            Check(
                name="Gram matrices",
                run=_RUN + "orthonormal",
                routes=_ROUTES,
                mutants=(
                    Mutant(name="the other tangent turned", given={"turned": "other"}),
                    Mutant(name="speed 2", given={"speed": 2}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.B-frenet-frames",
        section="3.1",
        where="section 3.1, item (B), line 250",
        kind="sentence",
        statement=r"$(r_u, N \times r_u, N)$ and $(r_v, N \times r_v, N)$ are the Frenet frames of "
        r"the $u$- and the $v$-lines: $N \times r_u$ and $N \times r_v$ are their principal "
        r"normals.",
        hypotheses=_NET,
        rests_on=("3.1.B-frames-orthonormal",),
        checks=(
            Check(
                name="curvature not negative",
                run=_RUN + "principal_normal",
                routes=("printed frame", "second derivatives of the pseudosphere, u reversed"),
                mutants=(Mutant(name="towards N", given={"towards": "normal"}),),
            ),
            Check(
                name="signed curvature",
                tier="full",
                run=_RUN + "principal_normal",
                form="corrected",
                given={"signed": True},
                routes=("printed frame", "second derivatives of the pseudosphere"),
                mutants=(
                    Mutant(name="curvature not negative", given={"signed": False}),
                    Mutant(name="towards N", given={"towards": "normal"}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"(r_u, N \times r_u, N) is a Frenet frame of the u-lines; Frenet-Serret "
            r"formulae for it and for (r_v, N \times r_v, N)",
            corrected=r"it is the frame that the surface gives to the line (Darboux), and the "
            r"Frenet frame with a curvature that may be negative or 0",
            kind="ambiguous",
            witness=r"Pseudosphere $r = (\operatorname{sech}\chi \cos\theta, "
            r"\operatorname{sech}\chi \sin\theta, \chi - \tanh\chi)$, $\chi = v - u$, $\theta = u "
            r"+ v$, $N = -(\tanh\chi \cos\theta, \tanh\chi \sin\theta, \operatorname{sech}\chi)$: "
            r"$r_{uu} = -2 \operatorname{sech}\chi\, N \times r_u$ and $r_{vv} = -2 "
            r"\operatorname{sech}\chi\, N \times r_v$, so the principal normals are $-N \times "
            r"r_u$ and $-N \times r_v$. On the straight edges of an Amsler sector $r_{uu} = 0$: no "
            r"Frenet frame exists.",
            conclusion_survives=True,
            remark=r"(eq:frames) holds with the signed geodesic curvatures, as item (E) and "
            r"(eq:sg) use them.",
        ),
    ),
    Claim(
        id="eq:frames",
        section="3.1",
        where="equation (eq:frames), item (B), lines 251-268",
        kind="equation",
        statement=r"$\partial_u (r_u, N \times r_u, N)^T = \left(\begin{smallmatrix} 0 & \kappa^u "
        r"& 0 \\ -\kappa^u & 0 & -1 \\ 0 & 1 & 0 \end{smallmatrix}\right) (r_u, N \times r_u, "
        r"N)^T$ and $\partial_v (r_v, N \times r_v, N)^T = \left(\begin{smallmatrix} 0 & \kappa^v "
        r"& 0 \\ -\kappa^v & 0 & 1 \\ 0 & -1 & 0 \end{smallmatrix}\right) (r_v, N \times r_v, "
        r"N)^T$.",
        labels=("eq:frames",),
        hypotheses=_NET,
        rests_on=("3.1.B-labelling", "3.1.B-frames-orthonormal"),
        checks=(
            Check(
                name="u-lines",
                tier="full",
                run=_RUN + "frenet_u",
                part="u-lines",
                routes=_ROUTES,
                mutants=(
                    Mutant(name="torsion +1", given={"torsion": 1}),
                    Mutant(name="last row reversed", given={"back": -1}),
                    Mutant(name="torsion +1, matrix skew", given={"torsion": 1, "back": -1}),
                    Mutant(name="curvature reversed", given={"curvature_sign": -1}),
                ),
            ),
            Check(
                name="v-lines",
                run=_RUN + "frenet_v",
                part="v-lines",
                routes=_ROUTES,
                mutants=(
                    Mutant(name="torsion -1", given={"torsion": -1}),
                    Mutant(name="last row reversed", given={"back": 1}),
                    Mutant(name="torsion -1, matrix skew", given={"torsion": -1, "back": 1}),
                    Mutant(name="curvature reversed", given={"curvature_sign": -1}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.B-geodesic-curvatures",
        section="3.1",
        where="section 3.1, item (B), line 269",
        kind="sentence",
        statement=r"$\kappa^u$ and $\kappa^v$ in (eq:frames) are the geodesic curvatures of the "
        r"$u$- and $v$-lines in the metric, oriented by $N$; they are the whole curvature.",
        hypotheses=_NET,
        rests_on=("eq:frames",),
        checks=(
            Check(
                name="from the metric",
                tier="full",
                run=_RUN + "geodesic_curvatures",
                routes=("r_uu.(N x r_u) and r_vv.(N x r_v)", "covariant derivative in the metric"),
                mutants=(
                    Mutant(name="kappa^u reversed", given={"sign_u": -1}),
                    Mutant(name="kappa^v reversed", given={"sign_v": -1}),
                    Mutant(name="kappa squared", given={"power": 2}),
                ),
            ),
        ),
    ),
)

_LELIEUVRE = (
    Claim(
        id="3.1.C-normal-derivative",
        section="3.1",
        where="section 3.1, item (C), line 270",
        kind="equation",
        statement=r"$N_u = N \times r_u$.",
        hypotheses=_NET,
        rests_on=("eq:frames",),
        checks=(
            Check(
                name="last row",
                run=_RUN + "normal_derivative",
                routes=_ROUTES,
                mutants=(Mutant(name="reversed", given={"sign": -1}),),
            ),
        ),
    ),
    Claim(
        id="3.1.C-right-handed-frames",
        section="3.1",
        where="section 3.1, item (C), line 270",
        kind="sentence",
        statement=r"$(r_u, N_u, N)$ and $(r_v, -N_v, N)$ are right-handed orthonormal frames.",
        hypotheses=_NET,
        rests_on=("3.1.C-normal-derivative", "eq:frames"),
        checks=(
            Check(
                name="Gram matrices and handedness",
                run=_RUN + "right_handed",
                routes=_ROUTES,
                mutants=(
                    Mutant(name="-N_u", given={"sign_u": -1}),
                    Mutant(name="+N_v", given={"sign_v": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="eq:lelieuvre",
        section="3.1",
        where="equation (eq:lelieuvre), item (C), lines 271-275",
        kind="equation",
        statement=r"$r_u = N_u \times N$ and $r_v = -N_v \times N$.",
        labels=("eq:lelieuvre",),
        hypotheses=_NET,
        rests_on=("3.1.C-right-handed-frames",),
        checks=(
            Check(
                name="u-lines",
                run=_RUN + "lelieuvre_u",
                part="u-lines",
                routes=_ROUTES,
                mutants=(
                    Mutant(name="N x N_u", given={"sign": -1}),
                    Mutant(name="N_v for N_u", given={"along": "v"}),
                ),
            ),
            Check(
                name="v-lines",
                run=_RUN + "lelieuvre_v",
                part="v-lines",
                routes=_ROUTES,
                mutants=(
                    Mutant(name="N_v x N", given={"sign": 1}),
                    Mutant(name="N_u for N_v", given={"along": "u"}),
                ),
            ),
        ),
    ),
)

CLAIMS: tuple[Claim, ...] = (*_FRAMES, *_LELIEUVRE)
