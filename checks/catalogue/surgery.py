"""Claims of section 3.4, surgery."""

from checks.claim import Check, Claim, Erratum, Mutant

_GLUING = "checks.verify.surgery_gluing:"
_LEMMA = "checks.verify.surgery_lemma:"
_FRONTS = "checks.verify.surgery_fronts:"
_CONVERGENCE = "checks.verify.surgery_convergence:"
_QUOTIENT = "theory.glued_rectangles (quotient by the maps)"
_DISK = "theory.quad_complex (links, Euler characteristic, families)"
_GRID_SURGERY = "theory.quad_surgery (a sector of a grid replaced)"
_GRIDS = "theory.goursat_float (Moutard equation, Lelieuvre sums)"
_ANGLES = "sine-Gordon equation for the angle; closed form of the pseudosphere"

_DOMAINS: tuple[Claim, ...] = (
    Claim(
        id="fig:asymptoticcoordinatepatches",
        section="3.4",
        where="figure (fig:asymptoticcoordinatepatches), line 811",
        kind="figure",
        statement=(
            r"The three stages of surgery in the coordinate plane: (a) the rectangle $\Omega$, (b) "
            r"the rectangle without its far quadrant, $\Omega^*$, (c) $\Omega^* \cup \Omega_1$, "
            r"where $\Omega_1$ takes its normals along the $u$-line from those of $\Omega^*$."
        ),
        labels=(
            "fig:asymptoticcoordinatepatches",
            "fig:patching1",
            "fig:patching2",
            "fig:patching3",
        ),
        hypotheses=(r"(used, not stated) $\Omega$ of the figure is the $\Omega_0$ of the lemma",),
        rests_on=(
            "3.4.domains",
            "eq:attaching",
        ),
        checks=(
            Check(
                name="stages",
                run=_GLUING + "stages",
                routes=(
                    "attaching maps as printed",
                    _QUOTIENT,
                ),
                mutants=(
                    Mutant(name="glued along the v-line", given={"line": "v"}),
                    Mutant(
                        name="Omega^* without its edges at the point", given={"keeps_point": False}
                    ),
                    Mutant(name="five faces", given={"faces": 5}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.4.domains",
        section="3.4",
        where="lemma (lem:surgery), its domains, lines 814 and 825",
        kind="definition",
        statement=(
            r"$\Omega_0 = [0,u_{\max}] \times [0,v_{\max}]$ loses the quadrant of $(u^*,v^*)$: "
            r"$\Omega^* = \Omega_0 \setminus [u^*,u_{\max}] \times [v^*,v_{\max}]$; the new "
            r"rectangles are $\Omega_1 = [0,u_{\max}-u^*] \times [0,\tilde v]$, $\Omega_2 = "
            r"[0,\tilde u] \times [0,\tilde v]$ and $\Omega_3 = [0,\tilde u] \times "
            r"[0,v_{\max}-v^*]$; $(u^*,v^*)$ and the two edges to which the new rectangles are "
            r"attached lie in $\Omega^*$."
        ),
        hypotheses=(
            r"$0 < u^* < u_{\max}$, $0 < v^* < v_{\max}$",
            r"$\tilde u, \tilde v > 0$",
            (
                r"(used, not stated) $\Omega^*$, an L-shaped set, is divided into rectangles, "
                r"since the faces of an asymptotic complex are rectangles"
            ),
        ),
        rests_on=("def:A-complex",),
        checks=(
            Check(
                name="as printed",
                run=_GLUING + "domains",
                routes=(
                    "printed set",
                    "three closed rectangles",
                ),
                mutants=(Mutant(name="nothing taken away", given={"cut": False}),),
            ),
            Check(
                name="edges kept",
                run=_GLUING + "domains",
                form="corrected",
                given={"closed": False},
                routes=(
                    "printed set, the quadrant without its two edges",
                    "three closed rectangles",
                ),
                mutants=(
                    Mutant(name="edges taken away", given={"closed": True}),
                    Mutant(name="(u*, v*) on the edge of Omega_0", given={"interior": False}),
                    Mutant(name="nothing taken away", given={"cut": False}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"$\Omega^* = [0,u_{\max}] \times [0,v_{\max}] \setminus [u^*,u_{\max}] \times "
            r"[v^*,v_{\max}]$",
            corrected=r"its closure: $[0,u_{\max}] \times [0,v_{\max}] \setminus (u^*,u_{\max}] "
            r"\times (v^*,v_{\max}]$",
            kind="misprint",
            witness=r"$(u^*,v^*) \in [u^*,u_{\max}] \times [v^*,v_{\max}]$ is taken away, but the "
            r"lemma places the branch point at $(u^*,v^*) \in \Omega^*$, and $\chi_1(0,0) = "
            r"(u^*,v^*)$, $\chi_3(0,v) = (u^*,v^*+v)$ are to lie in $\Omega^*$.",
            conclusion_survives=True,
            remark=r"As a face of a complex must be a rectangle, $\Omega^*$ counts as three faces.",
        ),
    ),
    Claim(
        id="lem:surgery",
        section="3.4",
        where="lemma (lem:surgery), line 813",
        kind="lemma",
        statement=(
            r"For a $C^{1M}$ PS-front $r_0$ on $\Omega_0$ and an interior point $(u^*,v^*)$ there "
            r"are PS-fronts $r_1, r_2, r_3$ on $\Omega_1, \Omega_2, \Omega_3$ and attaching maps "
            r"$\chi_j$ that glue them to $r_0|_{\Omega^*}$ into one branched PS-front with a "
            r"branch point at $(u^*,v^*)$."
        ),
        labels=("lem:surgery",),
        hypotheses=(
            r"$r_0$ is a $C^{1M}$ PS-front on the closed rectangle $\Omega_0$",
            r"$(u^*,v^*)$ lies in the interior of $\Omega_0$",
            r"$\tilde u, \tilde v > 0$ are arbitrary",
            (
                r"(for the index of the normal at the branch point, not for the branched front) "
                r"$\partial_u r_0 \times \partial_v r_0 \neq 0$ at $(u^*,v^*)$"
            ),
        ),
        rests_on=(
            "3.4.domains",
            "eq:attaching",
            "3.4.middle-sector",
            "3.4.side-sector",
            "3.4.opposite-side-sector",
            "3.4.assembled-front",
            "3.4.six-rays",
            "defn:quad",
        ),
        checks=(
            Check(
                name="complex, fronts and edges",
                run=_LEMMA + "lemma",
                part="gluing",
                tier="full",
                routes=(
                    _QUOTIENT,
                    "Taylor series of the sectors",
                    _GRID_SURGERY,
                ),
                mutants=(
                    Mutant(name="chi_4 lands in Omega_3", given={"fourth": 3}),
                    Mutant(name="one new sector", given={"sectors": 1}),
                    Mutant(name="five new sectors", given={"sectors": 5}),
                    Mutant(name="order 2", given={"order": 2}),
                    Mutant(name="point on the edge of Omega_0", given={"interior": False}),
                    Mutant(name="N_uv not parallel to N", given={"harmonic": False}),
                    Mutant(name="new rays of length 0", given={"ray": "0"}),
                ),
            ),
            Check(
                name="whole surgery on grids",
                run=_CONVERGENCE + "whole_surgery",
                part="solution",
                tier="full",
                routes=(
                    _GRIDS,
                    _ANGLES,
                ),
                mutants=(
                    Mutant(name="sine-Gordon equation 1 % off", given={"rate": "0.99"}, near=True),
                    Mutant(name="v-axis of Omega_1 from Omega_3", given={"fourth": 3}),
                    Mutant(name="e_u and e_v exchanged", given={"swapped": True}),
                    Mutant(name="order 3", given={"expected": 3}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="3.4.data-at-the-point",
        section="3.4",
        where="proof of lemma (lem:surgery), line 818",
        kind="definition",
        statement=(
            r"$\mathbf z_1 = r_0(u^*,v^*)$, $\mathbf n_1 = N_0(u^*,v^*)$, $\mathbf t_u = "
            r"\partial_u r_0(u^*,v^*)$, $\mathbf t_v = \partial_v r_0(u^*,v^*)$, so that $\mathbf "
            r"t_u$ and $\mathbf t_v$ are perpendicular to the unit vector $\mathbf n_1$."
        ),
        rests_on=("eq:lelieuvre",),
        checks=(
            Check(
                name="every normal",
                run=_FRONTS + "data_at_the_point",
                routes=(
                    "Lelieuvre equations",
                    "any unit normal in polar angles",
                ),
                mutants=(
                    Mutant(name="normal at a point nearby", given={"shift": True}),
                    Mutant(name="mixed derivative for t_v", given={"second": "uv"}),
                ),
            ),
        ),
    ),
    Claim(
        id="eq:attaching",
        section="3.4",
        where="equation (eq:attaching), line 822",
        kind="equation",
        statement=(
            r"Attaching maps of the complex: $\chi_1 : (u,0) \in \Omega_1 \mapsto (u^*+u,v^*) \in "
            r"\Omega^*$, $\chi_2 : (u,0) \in \Omega_3 \mapsto (u,0) \in \Omega_2$, $\chi_3 : (0,v) "
            r"\in \Omega_3 \mapsto (u^*,v^*+v) \in \Omega^*$, $\chi_4 : (0,v) \in \Omega_1 \mapsto "
            r"(0,v) \in \Omega_3$; each is a bijection between whole edges of the same family, and "
            r"each of the four edges is attached once."
        ),
        labels=("eq:attaching",),
        hypotheses=(
            (
                r"$0 \le u \le u_{\max}-u^*$ in $\chi_1$, $0 \le u \le \tilde u$ in $\chi_2$, $0 "
                r"\le v \le v_{\max}-v^*$ in $\chi_3$, $0 \le v \le \tilde v$ in $\chi_4$"
            ),
            r"(used, not stated) the closed edges from $(u^*,v^*)$ belong to $\Omega^*$",
        ),
        rests_on=(
            "3.4.domains",
            "def:A-complex",
        ),
        checks=(
            Check(
                name="as printed",
                run=_GLUING + "attaching",
                routes=(
                    "printed maps, values at the ends of edges",
                    _DISK,
                ),
                mutants=(
                    Mutant(name="chi_2 lands in Omega_1", given={"second": 1}),
                    Mutant(name="chi_3 does not add v*", given={"shifts": "u"}),
                    Mutant(name="chi_1 does not add u*", given={"shifts": "v"}),
                    Mutant(name="chi_1 runs backwards", given={"reverse": True}),
                ),
            ),
            Check(
                name="chi_4 into Omega_2",
                run=_GLUING + "attaching",
                form="corrected",
                given={"fourth": 2},
                routes=(
                    "printed maps but for chi_4",
                    _DISK,
                ),
                mutants=(
                    Mutant(name="chi_4 lands in Omega_3", given={"fourth": 3}),
                    Mutant(name="chi_4 lands in Omega_1", given={"fourth": 1}),
                    Mutant(name="chi_2 lands in Omega_1", given={"second": 1}),
                    Mutant(name="chi_3 does not add v*", given={"shifts": "u"}),
                    Mutant(name="chi_1 does not add u*", given={"shifts": "v"}),
                    Mutant(name="chi_1 runs backwards", given={"reverse": True}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"$\chi_4 : (0,v) \in \Omega_1 \mapsto (0,v) \in \Omega_3$",
            corrected=r"$\chi_4 : (0,v) \in \Omega_1 \mapsto (0,v) \in \Omega_2$",
            kind="misprint",
            witness=r"$\chi_3$ attaches the edge $u = 0$ of $\Omega_3$ to $\Omega^*$ already; with "
            r"$\chi_4$ three faces meet there, and the edge $u = 0$ of $\Omega_2$ is attached to "
            r"nothing. For $v_{\max} - v^* = 1$, $\tilde v = 2$ the map even leaves $\Omega_3 = "
            r"[0, \tilde u] \times [0,1]$.",
            conclusion_survives=True,
            remark=r"Line 878 reads it as corrected: $N_1(0,v) = N_2(\chi_4(0,v))$ needs values in "
            r"$\Omega_2$.",
        ),
    ),
)

_ASSEMBLED: tuple[Claim, ...] = (
    Claim(
        id="3.4.assembled-front",
        section="3.4",
        where="proof of lemma (lem:surgery), line 900",
        kind="sentence",
        statement=(
            r"$r_0, r_1, r_2, r_3$ assemble into a branched PS-front $\psi : A \to \mathbb R^3$ "
            r"that agrees with $r_0$ on $\Omega^*$."
        ),
        hypotheses=(r"$A$ is the complex given by the attaching maps",),
        rests_on=(
            "3.4.fronts-agree-along-all-edges",
            "defn:quad",
            "def:A-complex",
        ),
        checks=(
            Check(
                name="complex and edges",
                run=_LEMMA + "assembled",
                routes=(
                    _QUOTIENT,
                    "Taylor series of the sectors; any normal along an edge",
                ),
                mutants=(
                    Mutant(name="chi_4 lands in Omega_3", given={"fourth": 3}),
                    Mutant(name="chi_2 lands in Omega_1", given={"second": 1}),
                    Mutant(name="r_3 starts elsewhere", given={"start": False}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.4.immersed-subdomain",
        section="3.4",
        where="proof of lemma (lem:surgery), line 900",
        kind="sentence",
        statement=(
            r"On a subdomain where $N_u \times N_v$ does not vanish, the assembled front is a "
            r"$C^{1,1}$ isometric immersion with $K = -1$."
        ),
        hypotheses=(
            r"$N_u \times N_v \neq 0$ on each closed face",
            r"(used, not stated) $\mathbf t_u$ and $\mathbf t_v$ are not parallel",
            (
                r"(used, not stated) the orientations of neighbouring sectors match, so that "
                r"sectors at the branch point do not overlap"
            ),
        ),
        rests_on=(
            "3.4.assembled-front",
            "def:branched_immersion",
        ),
        checks=(
            Check(
                name="curvature and sectors",
                run=_FRONTS + "immersed",
                tier="full",
                routes=(
                    "N_u x N_v against r_u x r_v for any unit normal",
                    "printed rays, by their half-angle",
                ),
                mutants=(
                    Mutant(name="e_u before e_v", given={"order": "u,u,v,v"}),
                    Mutant(name="t_u parallel to t_v", given={"transversal": False}),
                    Mutant(name="K = 1", given={"sign": 1}),
                    Mutant(name="edge past a zero of N_u x N_v", given={"edge_end": "1/2"}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.4.six-rays",
        section="3.4",
        where="proof of lemma (lem:surgery), line 901",
        kind="number",
        statement=(
            r"Six asymptotic rays leave $(u^*,v^*)$ in the assembled complex, so $2m = 6$: a "
            r"monkey saddle."
        ),
        hypotheses=(r"$(u^*,v^*)$ was a regular interior point, with $2m = 4$",),
        rests_on=(
            "3.4.domains",
            "eq:attaching",
            "def:m-saddle",
        ),
        checks=(
            Check(
                name="edges at the point",
                run=_GLUING + "rays",
                routes=(
                    _QUOTIENT,
                    _GRID_SURGERY,
                ),
                mutants=(
                    Mutant(name="five", given={"number": 5}, near=True),
                    Mutant(name="four, as before", given={"number": 4}),
                    Mutant(name="one new sector", given={"sectors": 1}),
                    Mutant(name="five new sectors", given={"sectors": 5}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.4.one-sector-replaced-by-three",
        section="3.4",
        where="after lemma (lem:surgery), line 903",
        kind="sentence",
        statement=(
            r"Surgery can be repeated: cutting one sector from a point and putting three in its "
            r"place takes $2m$ to $2m+2$ there and leaves every other interior point as it was."
        ),
        hypotheses=(
            (
                r"(used, not stated) the sector cut out is a rectangle without branch points "
                r"inside that extends to the boundary of the complex"
            ),
        ),
        rests_on=(
            "lem:surgery",
            "3.4.six-rays",
        ),
        checks=(
            Check(
                name="four surgeries",
                run=_GLUING + "repeated",
                routes=(
                    _GRID_SURGERY,
                    _DISK,
                ),
                mutants=(
                    Mutant(name="two new sectors", given={"sectors": 2}),
                    Mutant(name="five new sectors", given={"sectors": 5}),
                    Mutant(name="2m grows by 3", given={"gain": 3}, near=True),
                    Mutant(name="the sector ends inside the complex", given={"to_the_rim": False}),
                ),
            ),
        ),
    ),
    Claim(
        id="fig:branchpointintroduction",
        section="3.4",
        where="figure (fig:branchpointintroduction), line 868",
        kind="figure",
        statement=(
            r"Five stages of surgery on a smooth pseudospherical surface at a point away from the "
            r"origin; the edges that the side sectors inherit from $r_0$ are curved in $\mathbb "
            r"R^3$."
        ),
        labels=(
            "fig:branchpointintroduction",
            "fig:introduce_branch_point_stage0",
            "fig:introduce_branch_point_stage1",
            "fig:introduce_branch_point_stage2",
            "fig:introduce_branch_point_stage3",
            "fig:introduce_branch_point_stage4",
        ),
        hypotheses=(
            (
                r"(used, not stated) the geodesic curvatures of the asymptotic curves of $r_0$ "
                r"through the point do not vanish; the edges shared with the middle sector are "
                r"straight"
            ),
        ),
        rests_on=("lem:surgery",),
        checks=(
            Check(
                name="curvature of the edges",
                run=_FRONTS + "inherited_edges",
                routes=(
                    "Gauss-Weingarten for any angle",
                    "similarity solution of the sine-Gordon equation",
                ),
                mutants=(
                    Mutant(name="point on an axis", given={"on_axis": True}),
                    Mutant(name="new edges for inherited ones", given={"edge": "new"}),
                ),
            ),
        ),
    ),
    Claim(
        id="fig:recursiveconstruction",
        section="3.4",
        where="figure (fig:recursiveconstruction), lines 897 and 903",
        kind="figure",
        statement=(
            r"Surgery applied recursively to an initially smooth surface gives surfaces with a "
            r"second generation of branch points."
        ),
        labels=(
            "fig:recursiveconstruction",
            "fig:introduce_branch_point_stage5",
            "fig:introduce_branch_point_stage6",
        ),
        rests_on=("3.4.one-sector-replaced-by-three",),
        checks=(
            Check(
                name="second generation",
                run=_GLUING + "generations",
                routes=(
                    _GRID_SURGERY,
                    _DISK,
                ),
                mutants=(
                    Mutant(name="no second generation", given={"second": 0}),
                    Mutant(name="two new sectors", given={"sectors": 2}),
                    Mutant(name="five new sectors", given={"sectors": 5}),
                ),
            ),
        ),
    ),
)

CLAIMS: tuple[Claim, ...] = _DOMAINS + _ASSEMBLED
