"""Claims of section 3.1, item (F): the normal that agrees with an orientation of the surface."""

from checks.claim import Check, Claim, Mutant

_RUN = "checks.verify.oriented_normal:"
_IMMERSED = (
    r"$\omega$ is a 2-form on the surface that vanishes nowhere",
    r"(used, not stated) $r_u \times r_v \neq 0$",
)
_UNSIGNED = Mutant(name="sign of omega dropped", given={"oriented": False})
_PLANE = "tangent plane of a graph with any gradient"

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="3.1.F-flipped-coordinates",
        section="3.1",
        where="section 3.1, item (F), line 282",
        kind="sentence",
        statement=r"If $(u, v)$ are asymptotic coordinates of unit speed, so are $(-u, v)$ and "
        r"$(u, -v)$.",
        hypotheses=(r"$K = -1$, $(u, v)$ asymptotic coordinates of unit speed",),
        rests_on=("3.1.B-unit-speed",),
        checks=(
            Check(
                name="conditions after the flip",
                tier="full",
                run="checks.verify.symmetries:flipped_coordinates",
                routes=(
                    "chain rule on Gauss-Weingarten for an unknown angle, and on explicit surfaces",
                    "pseudosphere with the flip substituted, differentiated directly",
                ),
                mutants=(
                    Mutant(name="v replaced by u + v", given={"changes": "shear"}),
                    Mutant(name="2u for u", given={"changes": "double"}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.F-global-coordinates",
        section="3.1",
        where="section 3.1, item (F), line 282",
        kind="sentence",
        statement=r"With smooth asymptotic coordinates on all of an immersed surface the normal "
        r"$r_u \times r_v / \|r_u \times r_v\|$ is continuous: $\sigma$ is constant.",
        hypotheses=(
            r"$(u, v)$ are global smooth asymptotic coordinates",
            r"(used, not stated) the surface is connected and $r_u \times r_v \neq 0$",
        ),
        rests_on=("3.1.A-normal-sign",),
        checks=(
            Check(
                name="one side of the edge",
                run="checks.verify.asymptotic_coordinates:normal_across",
                routes=("r_u x r_v of two explicit fronts", "their normal, smooth across the edge"),
                mutants=(Mutant(name="across the edge", given={"crosses_edge": True}),),
            ),
        ),
    ),
    Claim(
        id="3.1.F-graph-orientation",
        section="3.1",
        where="section 3.1, item (F), line 284",
        kind="sentence",
        statement=r"$\omega = dx_1 \wedge dx_2$ is an orientation of every graph $(x_1, x_2, "
        r"w(x_1, x_2))$: it vanishes nowhere.",
        hypotheses=(r"$w$ is $C^1$",),
        checks=(
            Check(
                name="value on tangent vectors",
                run=_RUN + "graph_orientation",
                routes=("printed 2-form", "determinant of the components"),
                mutants=(Mutant(name="dx_1 ^ dx_3", given={"second": 3}),),
            ),
        ),
    ),
    Claim(
        id="3.1.F-compatible-normal",
        section="3.1",
        where="section 3.1, item (F), lines 284-286",
        kind="definition",
        statement=r"$N$ is the unit normal for which $\omega(X, Y) = \beta\, (X \times Y) \cdot N$ "
        r"for all tangent $X, Y$ with a function $\beta > 0$.",
        hypotheses=_IMMERSED[:1],
        rests_on=("3.1.F-graph-orientation",),
        checks=(
            Check(
                name="upward normal of a graph",
                run=_RUN + "compatible_normal",
                routes=("printed relation", _PLANE),
                mutants=(Mutant(name="downward normal", given={"side": -1}),),
            ),
        ),
    ),
    Claim(
        id="eq:Nfront",
        section="3.1",
        where="equation (eq:Nfront), item (F), lines 286-291",
        kind="equation",
        statement=r"That normal is $N^\omega = \sigma\, r_u \times r_v / \|r_u \times r_v\|$ with "
        r"$\sigma = \operatorname{sign}(\omega(r_u, r_v))$.",
        labels=("eq:Nfront",),
        hypotheses=_IMMERSED,
        rests_on=("3.1.F-compatible-normal",),
        checks=(
            Check(
                name="both orientations",
                run=_RUN + "oriented_normal",
                routes=("printed formula", "the definition with omega on any tangent vectors"),
                mutants=(_UNSIGNED, Mutant(name="opposite normal", given={"sign": -1})),
            ),
        ),
    ),
    Claim(
        id="3.1.F-flip-insensitive",
        section="3.1",
        where="section 3.1, item (F), line 291",
        kind="sentence",
        statement=r"$N^\omega$ is the same after $u \to -u$ and after $v \to -v$.",
        hypotheses=_IMMERSED,
        rests_on=("eq:Nfront",),
        checks=(
            Check(
                name="flips",
                run=_RUN + "flip_insensitive",
                routes=("printed formula before and after", _PLANE),
                mutants=(
                    _UNSIGNED,
                    Mutant(name="tangents exchanged, omega not", given={"flips": "exchange"}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.F-continuous",
        section="3.1",
        where="section 3.1, item (F), line 284",
        kind="sentence",
        statement=r"On a $C^1$ surface $N^\omega$ is continuous, whatever the asymptotic "
        r"parametrisations of its pieces.",
        hypotheses=(
            *_IMMERSED,
            r"(used, not stated) $\omega$ is continuous",
        ),
        rests_on=("eq:Nfront", "3.1.F-flip-insensitive"),
        checks=(
            Check(
                name="any basis of the tangent plane",
                run=_RUN + "continuous",
                routes=("printed formula in any basis", "unit normal from the gradient of w"),
                mutants=(_UNSIGNED,),
            ),
        ),
    ),
)
