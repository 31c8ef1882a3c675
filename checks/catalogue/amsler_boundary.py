"""Claims of section 3.2, Amsler sectors: boundary data, the Goursat problem (amsler-frame)."""

from checks.claim import Check, Claim, Erratum, Mutant

_DATA_RUN = "checks.verify.amsler_patches:"

_DATA = (
    (
        r"$\mathbf{n}$, $\mathbf{e}_u$, $\mathbf{e}_v$ unit vectors, $\mathbf{e}_u \perp "
        r"\mathbf{n}$, $\mathbf{e}_v \perp \mathbf{n}$, and $\mathbf{z} \in \mathbb{R}^3$"
    ),
)

_BOUNDARY = (
    Claim(
        id="amsler-frame",
        section="3.2",
        where="equation (amsler-frame), lines 496-497, the normal",
        kind="equation",
        statement=r"An Amsler sector has $N(u, 0) = \cos u\,\mathbf{n} + \sin u\,\mathbf{n} \times "
        r"\mathbf{e}_u$ and $N(0, v) = \cos v\,\mathbf{n} - \sin v\,\mathbf{n} \times "
        r"\mathbf{e}_v$ on its bounding curves.",
        labels=("amsler-frame",),
        hypotheses=_DATA,
        checks=(
            Check(
                name="turns about the tangents",
                run=_DATA_RUN + "boundary_normals",
                routes=(
                    "printed normals",
                    "linear equations of a straight line of torsion -1, +1",
                    "frame carried into a sector, as series",
                ),
                mutants=(
                    Mutant(name="N(u, 0) turns back", given={"sign_u": -1}),
                    Mutant(name="N(0, v) turns like N(u, 0)", given={"sign_v": 1}),
                    Mutant(name="twice the rate", given={"rate": 2}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.2.amsler-boundary-lines",
        section="3.2",
        where="equation (amsler-frame), line 498, the position",
        kind="equation",
        statement=r"The bounding curves of an Amsler sector are straight: $r(u, 0) = \mathbf{z} + "
        r"u\,\mathbf{e}_u$ and, with the argument as printed, $r(v, 0) = \mathbf{z} + v\,"
        r"\mathbf{e}_v$.",
        hypotheses=_DATA,
        rests_on=("amsler-frame",),
        checks=(
            Check(
                name="as printed",
                run=_DATA_RUN + "boundary_lines",
                routes=(
                    "printed lines",
                    "Lelieuvre formulae integrated",
                ),
                mutants=(
                    Mutant(name="against e_v", given={"direction": -1}),
                    Mutant(name="r_v = N_v x N", given={"sign_v": 1}),
                ),
            ),
            Check(
                name="r(0, v)",
                run=_DATA_RUN + "boundary_lines",
                routes=(
                    "printed lines",
                    "Lelieuvre formulae integrated",
                ),
                mutants=(
                    Mutant(name="r(v, 0)", given={"argument": "first"}),
                    Mutant(name="against e_v", given={"argument": "second", "direction": -1}),
                    Mutant(name="r_v = N_v x N", given={"argument": "second", "sign_v": 1}),
                ),
                form="corrected",
                given={"argument": "second"},
            ),
        ),
        erratum=Erratum(
            printed=r"$r(u,0)=\mathbf z+u\,\mathbf e_u$, $r(v,0)=\mathbf z+v\,\mathbf e_v$",
            corrected=r"$r(u,0)=\mathbf z+u\,\mathbf e_u$, $r(0,v)=\mathbf z+v\,\mathbf e_v$",
            kind="misprint",
            witness=(
                r"$u=v=1$ in the two formulae: $r(1,0)=\mathbf z+\mathbf e_u$ and "
                r"$r(1,0)=\mathbf z+\mathbf e_v$, so $\mathbf e_u=\mathbf e_v$ and no "
                "sector"
            ),
            conclusion_survives=True,
        ),
    ),
    Claim(
        id="3.2.amsler-frame-solves-u",
        section="3.2",
        where="line 501",
        kind="sentence",
        statement=r"The data on $v = 0$ solve the first Frenet system of (eq:frames), with "
        r"$\kappa^u = 0$.",
        hypotheses=_DATA,
        rests_on=("amsler-frame", "3.2.amsler-boundary-lines", "eq:frames"),
        checks=(
            Check(
                name="rows of the system",
                run=_DATA_RUN + "solves_u",
                routes=(
                    "printed system",
                    "derivatives of the printed data",
                ),
                mutants=(
                    Mutant(name="torsion +1", given={"torsion": 1}),
                    Mutant(name="last row reversed", given={"back": -1}),
                    Mutant(name="curvature 1", given={"kappa": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.2.amsler-frame-solves-v",
        section="3.2",
        where="line 501",
        kind="sentence",
        statement=r"The data on $u = 0$ solve the second Frenet system of (eq:frames), with "
        r"$\kappa^v = 0$.",
        hypotheses=_DATA,
        rests_on=("amsler-frame", "3.2.amsler-boundary-lines", "eq:frames"),
        checks=(
            Check(
                name="rows of the system",
                run=_DATA_RUN + "solves_v",
                routes=(
                    "printed system",
                    "derivatives of the printed data",
                ),
                mutants=(
                    Mutant(name="torsion -1", given={"torsion": -1}),
                    Mutant(name="last row reversed", given={"back": 1}),
                    Mutant(name="curvature 1", given={"kappa": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.2.goursat",
        section="3.2",
        where="line 501",
        kind="sentence",
        statement=r"The Goursat problem of the Moutard equation $N_{uv} = -(N_u \cdot N_v) N$ with "
        r"these data has a solution $N(u, v) \in S^2$, smooth inside the sector and continuous "
        r"up to its boundary.",
        hypotheses=(
            *_DATA,
            (
                r"(used, not stated) the solution keeps $\|N\| = \|N_u\| = \|N_v\| = 1$ and exists "
                r"on the whole rectangle of the data"
            ),
        ),
        rests_on=("amsler-frame", "eq:moutard"),
        checks=(
            Check(
                name="existence and the sphere",
                run=_DATA_RUN + "goursat",
                routes=(
                    "angle theta_uv = sin theta and a carried frame, as series",
                    "vector Moutard equation with Frenet data, as series",
                    "identities for any solution",
                ),
                mutants=(
                    Mutant(name="N_uv = +(N_u.N_v) N", given={"sign": 1}),
                    Mutant(name="torsion -1 on both edges", given={"torsion_v": -1}),
                ),
                tier="full",
            ),
        ),
    ),
    Claim(
        id="3.2.goursat-boundary",
        section="3.2",
        where="line 501",
        kind="sentence",
        statement=r"The solution of the Goursat problem takes the prescribed values $N(u, 0)$ on "
        r"$v = 0$ and $N(0, v)$ on $u = 0$.",
        hypotheses=(*_DATA, r"(used, not stated) the data agree at $u = v = 0$"),
        rests_on=("3.2.goursat", "amsler-frame"),
        checks=(
            Check(
                name="edges of the carried frame",
                run=_DATA_RUN + "goursat_boundary",
                routes=(
                    "printed data",
                    "frame carried along v-lines, as series",
                ),
                mutants=(
                    Mutant(name="N(u, 0) turns back", given={"sign_u": -1}),
                    Mutant(name="N(0, v) turns like N(u, 0)", given={"sign_v": 1}),
                    Mutant(name="data meet at u = 1", given={"corner": 1}),
                ),
            ),
        ),
    ),
)

CLAIMS: tuple[Claim, ...] = _BOUNDARY
