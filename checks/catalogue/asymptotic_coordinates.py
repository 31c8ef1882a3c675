"""Claims of section 3.1, items (A) and (B): asymptotic coordinates, unit speed, torsions."""

from checks.claim import Check, Citation, Claim, Erratum, Mutant

_RUN = "checks.verify.asymptotic_coordinates:"
_SURFACE = r"$r$ is a $C^2$ immersion with $K = -1$"
_ASYMPTOTIC = (
    r"$K = -1$, $(u, v)$ asymptotic coordinates, $r_u \times r_v \neq 0$",
    r"(used, not stated) $r$ is of class $C^3$ in $(u, v)$",
)

_COORDINATES = (
    Claim(
        id="3.1.A-asymptotic-coordinates",
        section="3.1",
        where="section 3.1, item (A), line 247",
        kind="item",
        statement=r"Near each point there are coordinates $(u, v)$ with $r_u \times r_v \neq 0$ "
        r"whose lines are asymptotic: the second fundamental form vanishes on $r_u$ and on $r_v$.",
        hypotheses=(_SURFACE,),
        checks=(
            Check(
                name="asymptotic directions",
                tier="full",
                run=_RUN + "asymptotic_directions",
                form="support",
                routes=(
                    "discriminant of the second form of any graph",
                    "Brioschi's formula for the Gauss curvature of its metric",
                    "explicit surfaces in asymptotic coordinates",
                ),
                mutants=(Mutant(name="positive curvature", given={"sign": 1}),),
            ),
        ),
        citation=Citation(
            source="P. Hartman and A. Wintner, On the asymptotic curves of a surface, American "
            "Journal of Mathematics 73 (1951) 149-172",
            reason="on a surface that is only C^2 the two direction fields are only continuous: "
            "that their integral curves form coordinates is analysis, not computation; checked "
            "are the two directions on every C^2 graph with K < 0 and explicit coordinates",
        ),
    ),
    Claim(
        id="3.1.A-second-derivatives",
        section="3.1",
        where="section 3.1, item (A), line 247",
        kind="sentence",
        statement=r"For each $C^2$ immersion with $K = -1$ the derivatives $r_{uu}$ and $r_{vv}$ "
        r"in the condition $N \cdot r_{uu} = N \cdot r_{vv} = 0$ exist.",
        hypotheses=(_SURFACE,),
        rests_on=("3.1.A-asymptotic-coordinates",),
        checks=(
            Check(
                name="second derivatives",
                run=_RUN + "asymptotic_condition",
                routes=(
                    "Taylor series of the Goursat problem on either side of u = 0",
                    "the condition as printed",
                ),
                mutants=(Mutant(name="N_uu", given={"quantity": "N_uu"}),),
            ),
            Check(
                name="derivatives of the normal",
                run=_RUN + "asymptotic_condition",
                form="corrected",
                given={"quantity": "N_u"},
                routes=(
                    "Taylor series of the Goursat problem on either side of u = 0",
                    "the condition without second derivatives",
                ),
                mutants=(
                    Mutant(name="r_uu", given={"quantity": "r_uu"}),
                    Mutant(name="N_uu", given={"quantity": "N_uu"}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"N \cdot r_{uu} = N \cdot r_{vv} = 0 for every C^2 immersion with K = -1",
            corrected=r"N_u \cdot r_u = N_v \cdot r_v = 0; the printed condition for immersions "
            r"of class C^3",
            kind="hypothesis",
            witness=r"Goursat data $\varphi(u, 0) = \pi/2 + |u|$, $\varphi(0, v) = \pi/2$ with "
            r"$r_u = e_1$, $r_v = e_2$, $N = e_3$ at the origin: $r_u$, $r_v$, $N$, $N_u = N "
            r"\times r_u$ and $N_v = -N \times r_v$ are continuous, so the surface is $C^2$, but "
            r"$r_{uu} = \kappa^u N \times r_u = -\varphi_u N \times r_u$ tends to $-e_2$ from $u > "
            r"0$ and to $e_2$ from $u < 0$.",
            conclusion_survives=True,
            remark=r"Read as coefficients of the second fundamental form, which a $C^2$ surface "
            r"has, the condition is right; that $r_{uu}$ exists is used from item (B) on. "
            r"That Lipschitz Goursat data have a $C^{1M}$ solution is classical; the check "
            r"computes both sides to order 6 in $v$. No other choice of asymptotic coordinates "
            r"helps: the unit tangent itself has a kink. The class $C^{1M}$ that the section "
            r"introduces later allows for this, the curvatures $\kappa^u, \kappa^v$ of (eq:frames) "
            r"do not.",
        ),
    ),
    Claim(
        id="3.1.A-normal-sign",
        section="3.1",
        where="section 3.1, item (A), lines 247-248",
        kind="sentence",
        statement=r"Both $N = \pm r_u \times r_v / \|r_u \times r_v\|$ are unit normals that "
        r"satisfy the asymptotic condition, and where $r_u \times r_v$ never vanishes one choice "
        r"of sign serves throughout.",
        hypotheses=(
            *_ASYMPTOTIC,
            r"(used, not stated) the domain is connected",
        ),
        checks=(
            Check(
                name="either sign",
                tier="full",
                run=_RUN + "either_normal",
                part="condition",
                routes=("printed normal", "pseudosphere and Dini surface, differentiated directly"),
                mutants=(
                    Mutant(name="r_vu for r_vv", given={"second": "u"}),
                    Mutant(name="sum for cross product", given={"perpendicular": False}),
                ),
            ),
            Check(
                name="one side of the edge",
                run=_RUN + "normal_across",
                part="choice",
                routes=("r_u x r_v of two explicit fronts", "their normal, smooth across the edge"),
                mutants=(Mutant(name="across the edge", given={"crosses_edge": True}),),
            ),
        ),
    ),
)

_SPEED_AND_TORSION = (
    Claim(
        id="3.1.B-unit-speed",
        section="3.1",
        where="section 3.1, item (B), line 249",
        kind="sentence",
        statement=r"Both families of asymptotic lines have unit speed in suitable asymptotic "
        r"coordinates: $r_u \cdot r_u = r_v \cdot r_v = 1$.",
        hypotheses=_ASYMPTOTIC,
        checks=(
            Check(
                name="Codazzi equations",
                tier="full",
                run=_RUN + "unit_speed",
                routes=("normal parts of r_uuv - r_uvu and r_vvu - r_vuv by Gauss-Weingarten",),
                mutants=(
                    Mutant(name="variable curvature", given={"constant_curvature": False}),
                    Mutant(name="u-lines not asymptotic", given={"asymptotic": False}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.B-torsions",
        section="3.1",
        where="section 3.1, item (B), line 249",
        kind="sentence",
        statement=r"Beltrami-Enneper: the asymptotic lines of a surface with $K = -1$ have torsion "
        r"$\pm 1$, with opposite signs for the two families.",
        hypotheses=(
            *_ASYMPTOTIC,
            (
                r"(used, not stated) torsion is positive for right-handed helices, "
                r"$\mathbf{b}' = -\tau \mathbf{n}$"
            ),
            (
                r"(used, not stated) the line is not straight where the torsion is that of a "
                r"space curve; on a straight line it is read as that of $(T, N \times T, N)$"
            ),
        ),
        checks=(
            Check(
                name="space curves",
                run=_RUN + "torsions",
                routes=(
                    "three derivatives of r by Gauss-Weingarten, any speed, against K",
                    "three derivatives of the pseudosphere and of Dini's surface",
                ),
                mutants=(
                    Mutant(name="torsion 2", given={"magnitude": 2}),
                    Mutant(name="equal signs", given={"opposite": False}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.B-labelling",
        section="3.1",
        where="section 3.1, item (B), line 250",
        kind="sentence",
        statement=r"The names $u$ and $v$ can be given such that the $u$-lines have torsion $-1$ "
        r"and the $v$-lines $+1$.",
        hypotheses=_ASYMPTOTIC,
        rests_on=("3.1.B-torsions",),
        checks=(
            Check(
                name="exchange of names",
                run=_RUN + "labelling",
                routes=("torsions by Gauss-Weingarten before and after",),
                mutants=(
                    Mutant(name="names kept", given={"exchange": False}),
                    Mutant(name="u reversed instead", given={"exchange": False, "flip": True}),
                ),
            ),
        ),
    ),
)

CLAIMS: tuple[Claim, ...] = (*_COORDINATES, *_SPEED_AND_TORSION)
