"""Claims of section 4 on one quad of the normal field and on its discrete Goursat problem."""

from checks.claim import Check, Claim, Erratum, Mutant

_GOURSAT = "checks.verify.discrete_goursat"
_HOUSEHOLDER = "checks.verify.householder"
_RHOMBI = "checks.verify.spherical_rhombi"

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="4.moutard-net",
        section="4",
        where="unlabelled equation, line 1033",
        kind="equation",
        statement=(
            r"(eqn:discreteconstantcurvaturepde) requires $N_{12} = \nu(N_1+N_2) - N_0$ for some "
            r"$\nu \in \mathbb R$, as for a Moutard net."
        ),
        hypotheses=(r"(used, not stated) $N_1 + N_2 \neq 0$",),
        rests_on=("eqn:discreteconstantcurvaturepde",),
        checks=(
            Check(
                name="triple-product",
                run=f"{_HOUSEHOLDER}:moutard_net",
                routes=(
                    "printed condition, multiplied by N_1 + N_2",
                    "printed form of N_12",
                ),
                mutants=(
                    Mutant(name="sign", given={"sign": 1}),
                    Mutant(name="antipodal-neighbours", given={"antipodal": True}),
                ),
            ),
        ),
    ),
    Claim(
        id="4.norm-of-fourth-normal",
        section="4",
        where="unlabelled equation, first line, line 1037",
        kind="equation",
        statement=(
            r"$\langle N_{12},N_{12}\rangle = \nu^2\langle N_1+N_2,N_1+N_2\rangle - 2\nu\langle "
            r"N_1+N_2,N_0\rangle + \langle N_0,N_0\rangle$."
        ),
        rests_on=("4.moutard-net",),
        checks=(
            Check(
                name="expansion",
                run=f"{_HOUSEHOLDER}:norm_of_fourth",
                routes=(
                    "printed square",
                    "square of the printed N_12",
                ),
                mutants=(
                    Mutant(name="middle-1", given={"middle": -1}),
                    Mutant(name="sign", given={"middle": 2}),
                    Mutant(name="power-1", given={"power": 1}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="4.norm-of-fourth-normal-unit",
        section="4",
        where="unlabelled equation, second line, line 1038",
        kind="equation",
        statement=(
            r"With $\|N_0\| = 1$ the same is $\nu^2\|N_1+N_2\|^2 - 2\nu\langle N_1+N_2,N_0\rangle "
            r"+ 1$."
        ),
        hypotheses=(r"$\|N_0\| = 1$",),
        rests_on=("4.norm-of-fourth-normal",),
        checks=(
            Check(
                name="unit-vector",
                run=f"{_HOUSEHOLDER}:norm_of_fourth_unit",
                routes=(
                    "printed square",
                    "square of the printed N_12",
                ),
                mutants=(
                    Mutant(name="sign", given={"middle": 2}),
                    Mutant(name="constant-0", given={"constant": 0}, near=True),
                    Mutant(name="not-a-unit-vector", given={"unit": False}),
                ),
            ),
        ),
    ),
    Claim(
        id="4.quadratic-for-nu",
        section="4",
        where="unlabelled equation, third line, line 1040",
        kind="equation",
        statement=(
            r"$\|N_{12}\| = 1$ if and only if $0 = \nu\left(\nu\|N_1+N_2\|^2 - 2\langle "
            r"N_1+N_2,N_0\rangle\right)$."
        ),
        hypotheses=(r"$\|N_0\| = 1$",),
        rests_on=("4.norm-of-fourth-normal-unit",),
        checks=(
            Check(
                name="norm-minus-one",
                run=f"{_HOUSEHOLDER}:quadratic",
                routes=(
                    "printed quadratic form",
                    "square of the printed N_12, minus 1",
                ),
                mutants=(
                    Mutant(name="middle-1", given={"middle": -1}),
                    Mutant(name="not-a-unit-vector", given={"unit": False}),
                ),
            ),
        ),
    ),
    Claim(
        id="4.roots-for-nu",
        section="4",
        where="before equation (eq:householder), line 1042",
        kind="equation",
        statement=(
            r"The roots are $\nu = 0$, with $N_{12} = -N_0$, and $\nu = 2\frac{\langle "
            r"N_1+N_2,N_0\rangle}{\langle N_1+N_2,N_1+N_2\rangle}$."
        ),
        hypotheses=(r"(used, not stated) $N_1 + N_2 \neq 0$",),
        rests_on=("4.quadratic-for-nu",),
        checks=(
            Check(
                name="factored",
                run=f"{_HOUSEHOLDER}:roots",
                routes=(
                    "printed quadratic form",
                    "product over the printed roots",
                ),
                mutants=(
                    Mutant(name="without-the-2", given={"factor": "1"}),
                    Mutant(name="one-percent", given={"factor": "101/50"}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="eq:householder",
        section="4",
        where="equation (eq:householder), line 1045",
        kind="equation",
        statement=(
            r"The root $\nu \neq 0$ gives the unit vector $N_{12} = "
            r"\left[\frac{(N_1+N_2)(N_1+N_2)^T}{\langle N_1+N_2,N_1+N_2\rangle} - \mathbb "
            r"I\right]N_0$."
        ),
        labels=("eq:householder",),
        hypotheses=(
            r"$N_0, N_1, N_2$ are unit vectors",
            r"(used, not stated) $N_1 + N_2 \neq 0$",
        ),
        rests_on=(
            "4.roots-for-nu",
            "4.moutard-net",
        ),
        checks=(
            Check(
                name="without-the-2",
                run=f"{_HOUSEHOLDER}:householder",
                routes=(
                    "printed matrix",
                    "printed root, shipped half-turn",
                ),
                mutants=(Mutant(name="three", given={"factor": "3"}),),
            ),
            Check(
                name="with-the-2",
                run=f"{_HOUSEHOLDER}:householder",
                form="corrected",
                given={"factor": "2"},
                routes=(
                    "printed matrix with the factor 2",
                    "printed root, shipped half-turn",
                ),
                mutants=(
                    Mutant(name="without-the-2", given={"factor": "1"}),
                    Mutant(name="one-percent", given={"factor": "99/50"}, near=True),
                    Mutant(name="sign-of-identity", given={"identity": 1}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=(
                r"$N_{12} = \left[\frac{(N_1+N_2)(N_1+N_2)^T}{\langle "
                r"N_1+N_2,N_1+N_2\rangle}-\mathbb I\right]N_0$"
            ),
            corrected=(
                r"$N_{12} = \left[2\,\frac{(N_1+N_2)(N_1+N_2)^T}{\langle "
                r"N_1+N_2,N_1+N_2\rangle}-\mathbb I\right]N_0$"
            ),
            kind="constant",
            witness=(
                r"$N_0 = (1,0,0)$, $N_1 = \frac15(3,4,0)$, $N_2 = \frac15(3,0,4)$: the printed "
                r"right side is $\frac1{17}(-8,6,6)$, of squared length $\frac8{17}$; with the $2$ "
                r"it is $\frac1{17}(1,12,12)$"
            ),
            conclusion_survives=True,
            remark=r"the root $\nu$ two lines above has the factor $2$",
        ),
    ),
    Claim(
        id="4.desired-root",
        section="4",
        where="after equation (eq:householder), line 1047",
        kind="sentence",
        statement=(
            r"The root $\nu = 0$ is the point antipodal to $N_0$; (eq:householder) is the other "
            r"one, which tends to $N_0$ when $N_1$ and $N_2$ do."
        ),
        rests_on=(
            "4.roots-for-nu",
            "eq:householder",
        ),
        checks=(
            Check(
                name="limit",
                run=f"{_HOUSEHOLDER}:desired_root",
                routes=(
                    "printed root along N_0 + t a, N_0 + t b",
                    "N_0 itself",
                ),
                mutants=(Mutant(name="first-root", given={"chosen": "first"}),),
            ),
        ),
    ),
    Claim(
        id="4.reflection-in-plane",
        section="4",
        where="after equation (eq:householder), line 1047",
        kind="sentence",
        statement=(
            r"$N_{12}$ is the Householder reflection of $N_0$ in the plane spanned by $N_1$ and "
            r"$N_2$."
        ),
        hypotheses=(
            r"(used, not stated) $N_1$ and $N_2$ are linearly independent",
            (
                r"(used, not stated) $\langle N_0,N_1\rangle = \langle N_0,N_2\rangle$: the map is "
                r"the half-turn about $N_1+N_2$, which agrees with the reflection only then"
            ),
        ),
        rests_on=("eq:householder",),
        checks=(
            Check(
                name="any-edges",
                run=f"{_HOUSEHOLDER}:reflection_in_plane",
                routes=(
                    "printed root",
                    "shipped reflection in the plane",
                ),
                mutants=(Mutant(name="plane-between", given={"mirror": "bisector"}),),
            ),
            Check(
                name="equal-edges",
                run=f"{_HOUSEHOLDER}:reflection_in_plane",
                form="corrected",
                given={"equal_edges": True},
                routes=(
                    "printed root",
                    "shipped reflection in the plane and half-turn",
                ),
                mutants=(
                    Mutant(name="any-edges", given={"equal_edges": False}),
                    Mutant(name="plane-between", given={"mirror": "bisector"}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=(
                r"$N_{12}$ is the reflection of $N_0$ through the plane generated by $N_1$ and "
                r"$N_2$"
            ),
            corrected=(
                r"$N_{12}$ is $N_0$ after the half-turn about $N_1+N_2$; it is the reflection in "
                r"that plane if $\langle N_0,N_1\rangle = \langle N_0,N_2\rangle$"
            ),
            kind="hypothesis",
            witness=(
                r"$N_0 = (1,0,0)$, $N_1 = \frac15(3,4,0)$, $N_2 = (0,0,1)$: the reflection moves "
                r"$N_0$ to $\frac1{25}(-7,24,0)$, but (eq:householder), with its factor $2$, gives "
                r"$\frac1{25}(-16,12,15)$"
            ),
            conclusion_survives=True,
            remark=(
                r"the nets that follow have edges of one length, where both agree; minus the "
                r"matrix is the reflection in the plane orthogonal to $N_1+N_2$"
            ),
        ),
    ),
    Claim(
        id="4.any-three-corners",
        section="4",
        where="after equation (eq:householder), line 1047",
        kind="sentence",
        statement=(
            r"The normals at any three corners of a quad determine that at the fourth, by the same "
            r"formula with the corners relabelled."
        ),
        hypotheses=(
            r"(used, not stated) the two given corners next to the unknown one are not antipodal",
            r"(used, not stated) the root $\nu = 0$ is excluded",
        ),
        rests_on=(
            "eq:householder",
            "eq:d_compatible",
        ),
        checks=(
            Check(
                name="relabelled",
                run=f"{_HOUSEHOLDER}:determination",
                routes=(
                    "printed root with other corners",
                    "the corners that N_12 was made of",
                ),
                mutants=(
                    Mutant(name="opposite-for-neighbour", given={"shared": "opposite"}),
                    Mutant(name="antipodal-neighbours", given={"antipodal": True}),
                ),
                tier="full",
            ),
        ),
    ),
    Claim(
        id="lem:Chebyshev",
        section="4",
        where="lemma (lem:Chebyshev), line 1049",
        kind="lemma",
        statement=(
            r"If $\|N_0-N_1\| = \|N_0-N_2\|$ and $N_{12}$ is given by (eq:householder), then "
            r"$N_0N_1N_{12}N_2$ is a spherical rhombus."
        ),
        labels=("lem:Chebyshev",),
        hypotheses=(
            r"$\|N_0-N_1\| = \|N_0-N_2\|$",
            r"$N_{12}$ is given by (eq:householder), with its factor $2$ restored",
            r"(used, not stated) $N_1 + N_2 \neq 0$",
        ),
        rests_on=(
            "eq:householder",
            "eq:d_chebyshev",
        ),
        checks=(
            Check(
                name="four-sides",
                run=f"{_RHOMBI}:spherical_rhombus",
                routes=(
                    "printed root and shipped half-turn",
                    "inner products of the four sides",
                ),
                mutants=(
                    Mutant(name="unequal-edges", given={"equal": False}),
                    Mutant(name="without-the-2", given={"factor": "1"}),
                    Mutant(name="one-percent", given={"factor": "99/50"}, near=True),
                    Mutant(name="antipodal-root", given={"root": "first"}),
                ),
            ),
        ),
    ),
    Claim(
        id="4.edge-angle",
        section="4",
        where="proof of lemma (lem:Chebyshev), line 1052",
        kind="equation",
        statement=r"$\langle N_0,N_1\rangle = \langle N_0,N_2\rangle = \cos\delta$.",
        hypotheses=(
            r"$\|N_0-N_1\| = \|N_0-N_2\|$",
            r"$\delta \in [0,\pi]$ is the angle between $N_0$ and $N_1$",
        ),
        checks=(
            Check(
                name="chords",
                run=f"{_RHOMBI}:edge_angle",
                routes=(
                    "squared chords",
                    "inner products, of unit vectors known by them alone",
                ),
                mutants=(Mutant(name="not-unit-vectors", given={"unit": False}),),
            ),
        ),
    ),
    Claim(
        id="4.rhombus-sum",
        section="4",
        where="proof of lemma (lem:Chebyshev), first line, line 1054",
        kind="equation",
        statement=(
            r"$0 = \langle N_{12}-N_0,N_{12}+N_0\rangle = \nu(\langle N_{12},N_1+N_2\rangle - "
            r"2\cos\delta)$."
        ),
        hypotheses=(r"$N_{12} + N_0 = \nu(N_1+N_2)$ and $\|N_{12}\| = \|N_0\|$",),
        rests_on=(
            "4.moutard-net",
            "4.edge-angle",
        ),
        checks=(
            Check(
                name="both-roots",
                run=f"{_RHOMBI}:rhombus_sum",
                routes=(
                    "printed right side",
                    "product of sum and difference",
                ),
                mutants=(
                    Mutant(name="unequal-edges", given={"equal": False}),
                    Mutant(name="one-percent", given={"twice": "99/50"}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="4.rhombus-difference",
        section="4",
        where="proof of lemma (lem:Chebyshev), second line, line 1055",
        kind="equation",
        statement=r"$0 = \nu\langle N_1+N_2,N_1-N_2\rangle = \nu\langle N_{12},N_1-N_2\rangle$.",
        hypotheses=(
            r"$N_{12} + N_0 = \nu(N_1+N_2)$",
            r"$\langle N_0,N_1-N_2\rangle = 0$",
        ),
        rests_on=(
            "4.moutard-net",
            "4.edge-angle",
        ),
        checks=(
            Check(
                name="both-roots",
                run=f"{_RHOMBI}:rhombus_difference",
                routes=(
                    "printed products",
                    "zero",
                ),
                mutants=(
                    Mutant(name="unequal-edges", given={"equal": False}),
                    Mutant(name="sign", given={"sign": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="eq:d_chebyshev",
        section="4",
        where="equation (eq:d_chebyshev), line 1057",
        kind="equation",
        statement=(
            r"The two lines before it imply $\cos\delta = \langle N_{12},N_1\rangle = \langle "
            r"N_{12},N_2\rangle$."
        ),
        labels=("eq:d_chebyshev",),
        hypotheses=(
            r"$N_{12}$ is the unit vector of (eq:householder), with its factor $2$ restored",
            (
                r"(used, not stated) $\nu \neq 0$, that is, $\delta \neq \frac\pi2$, for the "
                r"implication; at $\nu = 0$ both lines are empty, and the conclusion holds because "
                r"$N_{12} = -N_0$ and $\cos\delta = 0$"
            ),
        ),
        rests_on=(
            "4.rhombus-sum",
            "4.rhombus-difference",
        ),
        checks=(
            Check(
                name="implication-and-conclusion",
                run=f"{_RHOMBI}:d_chebyshev",
                routes=(
                    "linear equations of the two lines",
                    "inner products of the printed fourth normal",
                ),
                mutants=(
                    Mutant(name="antipodal-root", given={"root": "first"}),
                    Mutant(name="unequal-edges", given={"equal": False}),
                    Mutant(name="without-the-2", given={"factor": "1"}),
                ),
            ),
        ),
    ),
    Claim(
        id="4.goursat-solution",
        section="4",
        where="after lemma (lem:Chebyshev), line 1061",
        kind="sentence",
        statement=(
            r"Applied recursively, (eq:householder) gives the normals on a whole asymptotic "
            r"quadrilateral from those on two adjacent sides, so also on the other two sides."
        ),
        hypotheses=(
            r"(used, not stated) (eq:householder) with its factor $2$ restored",
            r"(used, not stated) no quad met on the way has $N_1 + N_2 = 0$",
            r"(used, not stated) the two sides are one $u$- and one $v$-side with a common corner",
        ),
        rests_on=("eq:householder",),
        checks=(
            Check(
                name="by-columns-and-by-rows",
                run=f"{_GOURSAT}:goursat_solution",
                routes=(
                    "printed root by columns",
                    "shipped fill by rows",
                ),
                mutants=(
                    Mutant(name="without-the-2", given={"factor": "1"}),
                    Mutant(name="one-percent", given={"factor": "99/50"}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="4.equal-steps-on-sides",
        section="4",
        where="after lemma (lem:Chebyshev), line 1061",
        kind="sentence",
        statement=(
            r"Since the asymptotic curves have constant torsion, the two sides can be discretised "
            r"with $\langle N_{i,0},N_{i+1,0}\rangle = \langle N_{0,j},N_{0,j+1}\rangle = "
            r"\cos\delta$, one $\delta$ for both families."
        ),
        hypotheses=(
            r"torsions $\mp1$: $\|N_u\| = \|N_v\| = 1$ in arc length coordinates",
            (
                r"(used, not stated) $\delta$ is small; the last point may miss the end of the "
                r"curve by less than one step"
            ),
        ),
        rests_on=("eq:frames",),
        checks=(
            Check(
                name="chord-of-the-arc",
                run=f"{_GOURSAT}:equal_steps_on_sides",
                routes=(
                    "normals of explicit surfaces in balls",
                    "unit speed from the torsion",
                ),
                mutants=(
                    Mutant(name="twice-the-speed", given={"speed_u": "2"}),
                    Mutant(name="one-percent-faster", given={"speed_v": "101/100"}, near=True),
                    Mutant(name="one-percent-slower", given={"speed_u": "99/100"}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="4.equal-steps-everywhere",
        section="4",
        where="after lemma (lem:Chebyshev), line 1061",
        kind="equation",
        statement=(
            r"$\langle N_{i,j},N_{i+1,j}\rangle = \langle N_{i,j},N_{i,j+1}\rangle = \cos\delta$ "
            r"for all $i,j$."
        ),
        hypotheses=(r"the steps on the two given sides have that property",),
        rests_on=(
            "eq:d_chebyshev",
            "4.goursat-solution",
            "4.equal-steps-on-sides",
        ),
        checks=(
            Check(
                name="opposite-sides",
                run=f"{_GOURSAT}:equal_steps",
                routes=(
                    "shipped half-turn for any edges",
                    "rational net by the printed root",
                ),
                mutants=(
                    Mutant(name="v-edges-longer", given={"odd_edge": "1/9"}),
                    Mutant(name="one-percent", given={"odd_edge": "101/1000"}, near=True),
                    Mutant(name="adjacent-sides", given={"opposite": False}),
                ),
            ),
        ),
    ),
    Claim(
        id="4.edge-length",
        section="4",
        where="after lemma (lem:Chebyshev), line 1061",
        kind="number",
        statement=r"$\|r_{i+1,j}-r_{i,j}\| = \|r_{i,j+1}-r_{i,j}\| = \sin\delta$ for all $i,j$.",
        hypotheses=(r"$0 < \delta < \pi$",),
        rests_on=(
            "4.equal-steps-everywhere",
            "eq:d_lelieuvre",
        ),
        checks=(
            Check(
                name="cross-product",
                run=f"{_GOURSAT}:edge_length",
                routes=(
                    "printed length",
                    "squared steps, for any delta and on a rational surface",
                ),
                mutants=(
                    Mutant(name="chord", given={"length": "chord"}),
                    Mutant(name="one-percent", given={"factor": "99/100"}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="4.chebyshev-nets",
        section="4",
        where="after lemma (lem:Chebyshev), line 1061",
        kind="sentence",
        statement=(
            r"$r_{i,j}$ is a discrete Chebyshev net in $\mathbb R^3$ and $N_{i,j}$ one in $S^2$: "
            r"opposite edges of every quad are equal."
        ),
        rests_on=(
            "4.edge-length",
            "4.equal-steps-everywhere",
        ),
        checks=(
            Check(
                name="opposite-edges",
                run=f"{_GOURSAT}:chebyshev_nets",
                routes=(
                    "normals by the printed root",
                    "points by the shipped summation",
                ),
                mutants=(Mutant(name="one-antipodal-root", given={"rule": "antipode"}),),
            ),
        ),
    ),
    Claim(
        id="fig:scri",
        section="4",
        where="figure (fig:scri), line 1078",
        kind="figure",
        statement=(
            r"(a) One quad of the Chebyshev net on $S^2$: three corners determine the fourth. (b) "
            r"The discrete Goursat problem on $\Omega$: data on two adjacent sides, all other "
            r"nodes solved for by (eqn:discreteconstantcurvaturepde), each once."
        ),
        labels=(
            "fig:scri",
            "fig:chebyshevstwo",
            "fig:goursat",
        ),
        rests_on=(
            "4.any-three-corners",
            "4.goursat-solution",
        ),
        checks=(
            Check(
                name="one-node-to-a-quad",
                run=f"{_GOURSAT}:figure",
                routes=(
                    "printed formula with other corners",
                    "order in which quads have one unknown",
                ),
                mutants=(
                    Mutant(name="opposite-sides", given={"sides": "opposite"}),
                    Mutant(name="one-node-missing", given={"missing": 1}, near=True),
                ),
                tier="full",
            ),
        ),
    ),
)
