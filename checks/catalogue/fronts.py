"""Claims of section 3.1 on the class C^{1M}, weakly harmonic normals and pseudospherical fronts."""

from checks.claim import Check, Claim, Erratum, Mutant

_V = "checks.verify.fronts:"

_SMOOTHNESS: tuple[Claim, ...] = (
    Claim(
        id="3.1.front-c1m",
        section="3.1",
        where="definition of C^{1M}, line 343",
        kind="definition",
        statement=(
            r"A map $f(u, v)$ to $\mathbb{R}^n$ has class $C^{1M}$ when it is $C^1$ and $f_{uv}$, "
            "$f_{vu}$ exist, are continuous and agree."
        ),
        checks=(
            Check(
                name="instances and near-misses",
                run=_V + "c1m",
                routes=(
                    "orders of five functions at their kinks",
                    "membership known by hand",
                ),
                mutants=(
                    Mutant(name="no first derivatives asked", given={"first": False}),
                    Mutant(name="no mixed derivative asked", given={"mixed": False}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.front-c1m-not-c2",
        section="3.1",
        where="section 3.1, line 345",
        kind="sentence",
        statement=(
            "Some functions of class $C^{1M}$ have neither $f_{uu}$ nor $f_{vv}$, so they are not "
            "$C^2$."
        ),
        rests_on=("3.1.front-c1m",),
        checks=(
            Check(
                name="difference quotient",
                run=_V + "c1m_not_c2",
                routes=(
                    "orders of the derivatives at the kinks",
                    "limit of the difference quotient",
                ),
                mutants=(
                    Mutant(name="power 5/2", given={"halves": 5}),
                    Mutant(name="power 2", given={"halves": 4}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.front-reparametrisation",
        section="3.1",
        where="section 3.1, line 345",
        kind="sentence",
        statement=(
            "A smooth change of coordinates $(u, v) = g(r, s)$ can turn a $C^{1M}$ "
            "function into one that is not $C^{1M}$."
        ),
        rests_on=("3.1.front-c1m",),
        checks=(
            Check(
                name="linear change",
                run=_V + "reparametrised",
                routes=(
                    "orders of the derivatives before",
                    "orders of the derivatives after u = r + s, v = r - s",
                ),
                mutants=(
                    Mutant(name="power 5/2", given={"halves": 5}),
                    Mutant(name="change that keeps the axes", given={"mixing": 0}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.front-composite",
        section="3.1",
        where="section 3.1, line 345",
        kind="equation",
        statement=r"The reparametrised function is $h(r, z) = f \circ g(r, s)$.",
        checks=(
            Check(
                name="printed",
                run=_V + "composite_variable",
                routes=(
                    "left side at r, s, z",
                    "right side at r, s, z",
                ),
                mutants=(Mutant(name="h(r, r)", given={"second": "r"}),),
            ),
            Check(
                name="h(r, s)",
                run=_V + "composite_variable",
                form="corrected",
                given={"second": "s"},
                routes=(
                    "left side at r, s, z",
                    "right side at r, s, z",
                ),
                mutants=(
                    Mutant(name="z for s", given={"second": "z"}),
                    Mutant(name="r for s", given={"second": "r"}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"$h(r, z) = f \circ g(r, s)$",
            corrected=r"$h(r, s) = f \circ g(r, s)$",
            kind="misprint",
            witness=(
                "for $f = uv$, $g = (r + s, r - s)$ the right side is $r^2 - s^2$, the "
                "left $r^2 - z^2$"
            ),
            conclusion_survives=True,
        ),
    ),
)

_NORMALS: tuple[Claim, ...] = (
    Claim(
        id="3.1.front-weakly-harmonic",
        section="3.1",
        where="definition of weakly harmonic maps, lines 347-352",
        kind="definition",
        statement=(
            r"A $C^{1M}$ map $N : D \to S^2$, $D \subseteq \mathbb{R}^2$ with "
            "coordinates $(u, v)$, is weakly Lorentz harmonic if it has the properties "
            "1 and 2."
        ),
        hypotheses=(
            (
                "(used, not stated) $D$ is open, or has a boundary up to which the "
                "derivatives are continuous"
            ),
        ),
        rests_on=(
            "3.1.front-c1m",
            "3.1.front-normal-speeds",
            "3.1.front-moutard",
        ),
        checks=(
            Check(
                name="instances and near-misses",
                tier="full",
                run=_V + "weakly_harmonic",
                routes=(
                    "four normals in closed form",
                    "membership known by hand",
                ),
                mutants=(
                    Mutant(name="property 1 dropped", given={"speeds": False}),
                    Mutant(name="property 2 dropped", given={"moutard": False}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.front-normal-speeds",
        section="3.1",
        where="definition of weakly harmonic maps, item 1, line 349",
        kind="item",
        statement=r"$N_u \cdot N_u > 0$ and $N_v \cdot N_v > 0$ on $D$.",
        checks=(
            Check(
                name="instances and near-miss",
                tier="full",
                run=_V + "normal_speeds",
                routes=(
                    "four normals in closed form",
                    "membership known by hand",
                ),
                mutants=(
                    Mutant(name="one of the two", given={"families": 1}),
                    Mutant(name="neither", given={"families": 0}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.front-moutard",
        section="3.1",
        where="definition of weakly harmonic maps, item 2, line 350",
        kind="item",
        statement=(
            r"There is a continuous $\nu : D \to \mathbb{R}$ with $N_{uv} = N_{vu} = \nu"
            r" N$; the one possible value is $-N_u \cdot N_v$."
        ),
        hypotheses=(r"(used, not stated) $|N| = 1$: then the condition is $N \times N_{uv} = 0$",),
        rests_on=(
            "eq:lorentz_harmonic",
            "eq:moutard",
        ),
        checks=(
            Check(
                name="factor",
                run=_V + "moutard",
                routes=(
                    "unit normal in unknown polar angles",
                    "mixed derivatives eliminated by N x N_uv = 0",
                ),
                mutants=(
                    Mutant(name="opposite sign", given={"sign": 1}),
                    Mutant(name="N_uv not parallel to N", given={"harmonic": False}),
                ),
            ),
        ),
    ),
)

_FRONTS: tuple[Claim, ...] = (
    Claim(
        id="3.1.front-generalise",
        section="3.1",
        where="section 3.1, line 354",
        kind="sentence",
        statement=(
            "Weakly harmonic maps give a larger class than the smooth pseudospherical surfaces."
        ),
        hypotheses=("that the normals of smooth surfaces belong to it is (eq:moutard)",),
        rests_on=(
            "3.1.front-weakly-harmonic",
            "eq:moutard",
        ),
        checks=(
            Check(
                name="normals that are not C^2",
                run=_V + "generalises",
                routes=(
                    "Moutard equation for an unknown function f(u)",
                    "orders of the derivatives of f at its kink",
                    "theory.moutard:goursat_series",
                ),
                mutants=(
                    Mutant(name="no kink", given={"straight": True}),
                    Mutant(name="kink of power 2", given={"halves": 4}),
                    Mutant(name="axis of one curvature", given={"curvature": 0}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.front-existence",
        section="3.1",
        where="section 3.1, line 354",
        kind="sentence",
        statement=(
            r"Every weakly harmonic $N$ on a simply connected $D$ has a PS-front: some "
            r"$r : D \to \mathbb{R}^3$ of class $C^{1M}$ solves the Lelieuvre equations."
        ),
        hypotheses=(
            "$D$ is simply connected",
            (
                "(used, not stated) a continuous form that is closed in the sense of its "
                "mixed derivatives is exact on $D$"
            ),
        ),
        rests_on=(
            "3.1.front-weakly-harmonic",
            "eq:lelieuvre",
            "eq:lorentz_harmonic",
        ),
        checks=(
            Check(
                name="closed form",
                tier="full",
                run=_V + "front_exists",
                routes=(
                    "Lelieuvre form of a unit normal in unknown polar angles",
                    "mixed derivatives eliminated by N x N_uv = 0",
                ),
                mutants=(
                    Mutant(name="plus sign in the second equation", given={"sign_v": 1}),
                    Mutant(name="N_uv not parallel to N", given={"harmonic": False}),
                    Mutant(name="cylinder admitted", given={"simply_connected": False}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.front-weak-regularity",
        section="3.1",
        where="section 3.1, line 354",
        kind="sentence",
        statement=(
            r"The front is weakly regular: $r_u \cdot r_u > 0$ and $r_v \cdot r_v > 0$, "
            r"being $N_u \cdot N_u$ and $N_v \cdot N_v$."
        ),
        rests_on=("3.1.front-existence",),
        checks=(
            Check(
                name="speeds",
                run=_V + "weakly_regular",
                routes=(
                    "Lelieuvre equations",
                    "unit normal in unknown polar angles",
                ),
                mutants=(Mutant(name="twice the speed", given={"stretch": 2}),),
            ),
        ),
    ),
    Claim(
        id="3.1.front-pseudosphere",
        section="3.1",
        where="section 3.1, line 354",
        kind="sentence",
        statement=(
            "The pseudosphere with its edge is a PS-front that is not an immersion on the edge."
        ),
        rests_on=("3.1.front-existence",),
        checks=(
            Check(
                name="tractrix",
                run=_V + "pseudosphere",
                routes=(
                    "the tractrix in asymptotic coordinates",
                    "Lelieuvre equations with the smooth normal",
                ),
                mutants=(
                    Mutant(name="plus sign in the second equation", given={"sign_v": 1}),
                    Mutant(name="another circle", given={"at": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.front-bobbin",
        section="3.1",
        where="section 3.1, line 354",
        kind="sentence",
        statement=(
            "Minding's bobbin, continued through its edges, is a PS-front that is not "
            "an immersion there."
        ),
        rests_on=(
            "3.1.front-existence",
            "ex:bobbin",
        ),
        checks=(
            Check(
                name="inclination of the meridian",
                run=_V + "bobbin",
                routes=(
                    "asymptotic lines in the inclination of the meridian",
                    "Lelieuvre equations with the smooth normal",
                ),
                mutants=(
                    Mutant(name="plus sign in the second equation", given={"sign_v": 1}),
                    Mutant(name="another circle", given={"inclination": 3}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.front-immersion",
        section="3.1",
        where="section 3.1, line 356",
        kind="sentence",
        statement=(
            r"$r$ and $N$ are immersions at the same points: $r_u \times r_v = -N_u \times N_v$."
        ),
        rests_on=("eq:lelieuvre",),
        checks=(
            Check(
                name="cross products",
                run=_V + "immersion",
                routes=(
                    "Lelieuvre equations",
                    "unit normal in unknown polar angles",
                ),
                mutants=(
                    Mutant(name="plus sign", given={"sign": 1}),
                    Mutant(name="plus sign in the second equation", given={"sign_v": 1}),
                ),
            ),
        ),
    ),
)

CLAIMS: tuple[Claim, ...] = (
    *_SMOOTHNESS,
    *_NORMALS,
    *_FRONTS,
)
