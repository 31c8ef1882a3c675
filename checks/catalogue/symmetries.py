"""Claims of section 3.1, item (E): what reversing u, v or N preserves and what it reverses."""

from checks.claim import Check, Claim, Mutant

_RUN = "checks.verify.symmetries:"
_NET = (
    (
        r"$K = -1$, $(u, v)$ asymptotic coordinates of unit speed, torsion $-1$ along $u$ and $+1$ "
        r"along $v$"
    ),
    r"(used, not stated) $r_{uu}$ and $r_{vv}$ exist",
)
_ROUTES = (
    "printed equations",
    "chain rule on Gauss-Weingarten for an unknown angle, and on explicit surfaces",
    "pseudosphere with the change substituted, differentiated directly",
)
_EXCHANGE = Mutant(name="u and v exchanged", given={"changes": "exchange"})
_SHEAR = Mutant(name="v replaced by u + v", given={"changes": "shear"})

_INVARIANCE = Claim(
    id="item:symmetries",
    section="3.1",
    where="section 3.1, item (E) (item:symmetries), line 281",
    kind="item",
    statement=r"Each of $N \to -N$, $u \to -u$ and $v \to -v$ preserves (eq:lelieuvre), "
    r"(eq:lorentz_harmonic) and the torsions $-1$ and $+1$ of (eq:frames).",
    labels=("item:symmetries",),
    hypotheses=_NET,
    rests_on=("eq:frames", "eq:lelieuvre", "eq:lorentz_harmonic"),
    checks=(
        Check(
            name="Lelieuvre formulae",
            tier="full",
            run=_RUN + "lelieuvre_symmetries",
            part="Lelieuvre",
            routes=_ROUTES,
            mutants=(_EXCHANGE, _SHEAR),
        ),
        Check(
            name="Lorentz harmonic normal",
            tier="full",
            run=_RUN + "lorentz_symmetries",
            part="Lorentz harmonic",
            routes=_ROUTES,
            mutants=(_SHEAR,),
        ),
        Check(
            name="torsions",
            tier="full",
            run=_RUN + "torsion_symmetries",
            part="torsions",
            routes=_ROUTES,
            mutants=(_EXCHANGE, _SHEAR),
        ),
    ),
)


def _reversal(name: str, function: str, formula: str, mutants: tuple[Mutant, ...]) -> Claim:
    """One of the three sentences on the signs of the geodesic curvatures."""
    return Claim(
        id=f"3.1.E-reverse-{name}",
        section="3.1",
        where="section 3.1, item (E) (item:symmetries), line 281",
        kind="sentence",
        statement=formula,
        hypotheses=_NET,
        rests_on=("eq:frames", "3.1.B-geodesic-curvatures"),
        checks=(
            Check(
                name="curvatures before and after",
                run=_RUN + function,
                routes=(
                    "printed factors",
                    "chain rule on Gauss-Weingarten for an unknown angle, and on explicit surfaces",
                ),
                mutants=mutants,
            ),
        ),
    )


_REVERSALS = (
    _reversal(
        "u",
        "flip_u",
        r"$u \to -u$ reverses the sign of $\kappa^u$ and keeps $\kappa^v$.",
        (
            Mutant(name="v reversed", given={"change": "v"}),
            Mutant(name="kappa^u kept", given={"factor_u": 1}),
            Mutant(name="kappa^v reversed too", given={"factor_v": -1}),
        ),
    ),
    _reversal(
        "v",
        "flip_v",
        r"$v \to -v$ reverses the sign of $\kappa^v$ and keeps $\kappa^u$.",
        (
            Mutant(name="N reversed", given={"change": "N"}),
            Mutant(name="kappa^v kept", given={"factor_v": 1}),
            Mutant(name="kappa^u reversed too", given={"factor_u": -1}),
        ),
    ),
    _reversal(
        "normal",
        "flip_normal",
        r"$N \to -N$ reverses the signs of both $\kappa^u$ and $\kappa^v$.",
        (
            Mutant(name="u reversed", given={"change": "u"}),
            Mutant(name="kappa^u kept", given={"factor_u": 1}),
            Mutant(name="kappa^v kept", given={"factor_v": 1}),
        ),
    ),
)

CLAIMS: tuple[Claim, ...] = (_INVARIANCE, *_REVERSALS)
