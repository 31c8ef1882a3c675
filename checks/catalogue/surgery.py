"""Claims of section 3.4, surgery."""

from checks.claim import Claim

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
            r"(used, not stated) $u, v$ are arc lengths of the asymptotic curves",
            r"(used, not stated) $\partial_u r_0 \times \partial_v r_0 \neq 0$ at $(u^*,v^*)$",
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
        hypotheses=(r"(used, not stated) $\|\mathbf t_u\| = \|\mathbf t_v\| = 1$",),
        rests_on=("eq:lelieuvre",),
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
                r"(used, not stated) the next point lies in the interior of a face or on an edge, "
                r"and the sector cut out extends to the boundary of the complex"
            ),
        ),
        rests_on=(
            "lem:surgery",
            "3.4.six-rays",
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
    ),
)

CLAIMS: tuple[Claim, ...] = _DOMAINS + _ASSEMBLED
