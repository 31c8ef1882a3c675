"""Claims of section 3.1, item (D): when the Lelieuvre equations can be integrated."""

from checks.claim import Check, Claim, Mutant

_RUN = "checks.verify.lelieuvre_consistency:"
_SMOOTH = (
    r"(used, not stated) $N$ has continuous mixed derivatives $N_{uv} = N_{vu}$",
    r"(used, not stated) the domain is simply connected",
)

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="3.1.D-consistency",
        section="3.1",
        where="section 3.1, item (D), line 276",
        kind="sentence",
        statement=r"For a given $N$ the equations (eq:lelieuvre) have a solution $r$ if and only "
        r"if their right sides satisfy $\partial_v (r_u) = \partial_u (r_v)$.",
        hypotheses=_SMOOTH,
        rests_on=("eq:lelieuvre",),
        checks=(
            Check(
                name="integral along segments",
                run=_RUN + "integrability",
                routes=("integral of the one-form", "printed right sides, differentiated"),
                mutants=(Mutant(name="opposite derivatives", given={"relation": -1}),),
            ),
        ),
    ),
    Claim(
        id="eq:lorentz_harmonic",
        section="3.1",
        where="equation (eq:lorentz_harmonic), item (D), lines 276-279",
        kind="equation",
        statement=r"$\partial_v (r_u) = \partial_u (r_v)$ in (eq:lelieuvre) is equivalent to $N "
        r"\times N_{uv} = 0$ (Lorentz harmonic), and this holds on the surface.",
        labels=("eq:lorentz_harmonic",),
        hypotheses=_SMOOTH,
        rests_on=("3.1.D-consistency",),
        checks=(
            Check(
                name="equivalence",
                run=_RUN + "lorentz_harmonic",
                part="equivalence",
                routes=("printed condition", "printed right sides, differentiated, for any N"),
                mutants=(
                    Mutant(name="N_uu for N_uv", given={"by": "u"}),
                    Mutant(name="second equation reversed", given={"sign_v": 1}),
                ),
            ),
            Check(
                name="on surfaces",
                run=_RUN + "lorentz_harmonic_on_surfaces",
                part="surfaces",
                routes=(
                    "printed condition",
                    "Gauss-Weingarten for an unknown angle and either sigma",
                    "explicit surfaces, differentiated directly",
                ),
                mutants=(Mutant(name="N_uu for N_uv", given={"by": "u"}),),
            ),
        ),
    ),
    Claim(
        id="3.1.D-mixed-derivative",
        section="3.1",
        where="section 3.1, item (D), line 280",
        kind="equation",
        statement=r"$r_{uv} = N_u \times N_v$ wherever (eq:lelieuvre) and (eq:lorentz_harmonic) "
        r"hold.",
        hypotheses=_SMOOTH,
        rests_on=("eq:lelieuvre", "eq:lorentz_harmonic"),
        checks=(
            Check(
                name="from the two equations",
                run=_RUN + "mixed_derivative",
                part="consequence",
                routes=("printed formula", "printed right sides, differentiated, for any N"),
                mutants=(Mutant(name="N_v x N_u", given={"sign": -1}),),
            ),
            Check(
                name="on surfaces",
                run=_RUN + "mixed_derivative_on_surfaces",
                part="surfaces",
                routes=(
                    "printed formula",
                    "Gauss-Weingarten for an unknown angle and either sigma",
                    "explicit surfaces, differentiated directly",
                ),
                mutants=(Mutant(name="N_v x N_u", given={"sign": -1}),),
            ),
        ),
    ),
)
