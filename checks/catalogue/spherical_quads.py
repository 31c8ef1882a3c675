"""Claims of section 4 on one quad of the normal field and on its discrete Goursat problem."""

from checks.claim import Claim

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
            r"$N_{12}$ is given by (eq:householder)",
            r"(used, not stated) $N_1 + N_2 \neq 0$",
        ),
        rests_on=(
            "eq:householder",
            "eq:d_chebyshev",
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
            (
                r"(used, not stated) $\nu \neq 0$, that is, $\delta \neq \frac\pi2$; at $\nu = 0$ "
                r"the conclusion needs another argument"
            ),
        ),
        rests_on=(
            "4.rhombus-sum",
            "4.rhombus-difference",
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
            r"(used, not stated) no quad met on the way has $N_1 + N_2 = 0$",
            r"(used, not stated) the two sides are one $u$- and one $v$-side with a common corner",
        ),
        rests_on=("eq:householder",),
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
    ),
)
