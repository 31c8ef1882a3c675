"""Claims of section 4 on corners, boundary segments and discrete assembly."""

from checks.claim import Check, Claim, Erratum, Mutant

_ASSEMBLY = "checks.verify.discrete_assembly"
_DOMAINS = "checks.verify.assembly_domains"
_SEGMENTS = "checks.verify.boundary_segments"

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="def:corner",
        section="4",
        where="definition (def:corner), line 1105",
        kind="definition",
        statement=(
            r"A vertex $q$ of $Q^\epsilon$ is a corner if a $u$-edge and a $v$-edge incident on "
            r"$q$ lie in $\partial Q^\epsilon$."
        ),
        labels=("def:corner",),
        rests_on=("def:A-complex",),
        checks=(
            Check(
                name="edge-by-edge",
                run=f"{_SEGMENTS}:corner_definition",
                routes=(
                    "definition read off the edges",
                    "shipped corners",
                ),
                mutants=(
                    Mutant(name="anywhere-in-the-complex", given={"where": "anywhere"}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="4.boundary-segment",
        section="4",
        where="definition of boundary segments, line 1108",
        kind="definition",
        statement=(
            r"$\gamma = E_1 \cup \cdots \cup E_m \subset \partial Q^\epsilon$ with $E_i \cap "
            r"E_{i+1} \neq \emptyset$ is called a boundary segment if all $E_i$ are of one family."
        ),
        hypotheses=(r"(used, not stated) the edges $E_i$ are distinct",),
        rests_on=("def:A-complex",),
        checks=(
            Check(
                name="chains-and-near-misses",
                run=f"{_SEGMENTS}:segment_definition",
                routes=(
                    "definition read off the edges",
                    "shipped maximal segments",
                ),
                mutants=(
                    Mutant(name="two-families", given={"families": 2}, near=True),
                    Mutant(name="no-family", given={"families": 0}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="lem:segments",
        section="4",
        where="lemma (lem:segments), line 1113",
        kind="lemma",
        statement=(
            r"A corner $q$ lies on a boundary segment $\gamma$ if and only if $q \in "
            r"\partial\gamma$; and every corner determines two maximal boundary segments, "
            r"$\gamma_u$ of $u$-edges and $\gamma_v$ of $v$-edges."
        ),
        labels=("lem:segments",),
        hypotheses=(
            r"$Q^\epsilon$ is simply connected",
            r"(used, not stated) $Q^\epsilon$ is a closed disk, without cut vertices",
        ),
        rests_on=(
            "def:corner",
            "4.boundary-segment",
            "4.boundary-is-a-jordan-curve",
            "4.two-boundary-edges-at-a-corner",
        ),
        checks=(
            Check(
                name="all-segments",
                run=f"{_SEGMENTS}:segments",
                routes=(
                    "every run of boundary edges of one family",
                    "shipped corners and maximal segments",
                ),
                mutants=(Mutant(name="corners-inside", given={"inside": True}),),
            ),
        ),
    ),
    Claim(
        id="4.boundary-is-a-jordan-curve",
        section="4",
        where="proof of lemma (lem:segments), line 1116",
        kind="sentence",
        statement=(
            r"$\partial Q^\epsilon$ is a Jordan curve of $u$- and $v$-segments, $Q^\epsilon$ being "
            r"simply connected and embeddable in $\mathbb R^2$."
        ),
        hypotheses=(
            (
                r"(used, not stated) $Q^\epsilon$ is finite and a surface with boundary: two faces "
                r"with only a vertex in common are not joined there alone"
            ),
        ),
        rests_on=("remark:simply_connected",),
        checks=(
            Check(
                name="one-closed-path",
                run=f"{_SEGMENTS}:jordan_curve",
                routes=(
                    "path traced along the boundary",
                    "shipped boundary vertices",
                ),
                mutants=(Mutant(name="ring", given={"ring": True}),),
            ),
        ),
    ),
    Claim(
        id="4.two-boundary-edges-at-a-corner",
        section="4",
        where="proof of lemma (lem:segments), line 1116",
        kind="sentence",
        statement=(
            r"A corner lies on exactly two edges of the boundary, one $u$-edge and one $v$-edge."
        ),
        rests_on=(
            "def:corner",
            "4.boundary-is-a-jordan-curve",
        ),
        checks=(
            Check(
                name="counted",
                run=f"{_SEGMENTS}:two_edges_at_a_corner",
                routes=(
                    "boundary edges at each corner",
                    "printed number",
                ),
                mutants=(Mutant(name="three", given={"number": 3}, near=True),),
            ),
        ),
    ),
    Claim(
        id="lem:discrete_assembly",
        section="4",
        where="lemma (lem:discrete_assembly), line 1119",
        kind="lemma",
        statement=(
            r"Let $2m \ge 4$ and $\gamma_i : \{0,\ldots,l_i\} \to S^2$, $i = 1,\ldots,2m$, have "
            r"(i) $\gamma_i(0) = (0,0,1)$, (ii) $\alpha_i = "
            r"\angle\gamma_{i-1}(1)\gamma(0)\gamma_i(1) \in (-\pi,0)$, $\sum_{i=1}^{2m}\alpha_i = "
            r"2\pi(1-m)$, $\gamma_0 = \gamma_{2m}$, (iii) $\langle\gamma_i(k),\gamma_i(k+1)\rangle "
            r"= \cos\delta$. Then they determine an asymptotic complex $Q$ with a spherical "
            r"Chebyshev net $N$ and an unramified $K$-surface $r$ on it."
        ),
        labels=("lem:discrete_assembly",),
        hypotheses=(
            r"(i), (ii) and (iii) hold, for all admissible $i$ and $k$",
            r"(used, not stated) $l_i \ge 1$, $0 < \delta < \pi$",
            r"(used, not stated) angles at $(0,0,1)$ are signed by the outer normal of $S^2$",
            (
                r"(used, not stated) the $\gamma_i$ do not fold back and the $l_i$ are so small "
                r"that every rhombus keeps the reversed orientation; otherwise $N$ is no spherical "
                r"Chebyshev net"
            ),
        ),
        rests_on=(
            "4.assembly-domains",
            "4.assembly-attaching",
            "4.assembly-data",
            "4.assembly-agreement",
            "4.assembly-families",
            "lem:construct",
        ),
        checks=(
            Check(
                name="any-curves",
                run=f"{_ASSEMBLY}:assembly",
                routes=(
                    "shipped assembly of rational curves",
                    "the three conditions as printed",
                ),
                mutants=(
                    Mutant(name="winding-once-less", given={"winding": 1}, near=True),
                    Mutant(name="longer-edges", given={"longer": True}),
                ),
            ),
            Check(
                name="reversing-curves",
                run=f"{_ASSEMBLY}:assembly",
                form="corrected",
                given={"data": "reversing"},
                routes=(
                    "shipped assembly of rational curves",
                    "the three conditions as printed, sums along a tree",
                ),
                mutants=(
                    Mutant(name="any-curves", given={"data": "any"}),
                    Mutant(name="winding-once-less", given={"winding": 1}, near=True),
                    Mutant(name="longer-edges", given={"longer": True}, near=True),
                    Mutant(name="angles-below-minus-pi", given={"least": "-3/2"}),
                ),
                tier="full",
            ),
        ),
        erratum=Erratum(
            printed=r"(i), (ii), (iii) determine a spherical Chebyshev net",
            corrected=(
                r"they do if every rhombus that (eq:householder), with its factor $2$, makes of "
                r"the curves reverses the orientation, as for short curves that do not fold back"
            ),
            kind="hypothesis",
            witness=(
                r"four geodesics from $N = (1,0,0)$ at right angles, $\cos\delta = \frac35$, $l_i "
                r"= 2$: the normals $\frac1{17}(1,12,-12)$, $\frac1{1765}(-1341,712,-900)$, "
                r"$\frac1{1765}(-1341,900,-712)$ are three corners of the rhombus farthest from "
                r"$N$, and it keeps the orientation: the determinant with the middle vertex first "
                r"is $\frac{373744}{3115225} > 0$, but $-\frac{16}{25}$ for the rhombus at $N$"
            ),
            conclusion_survives=True,
            remark=(
                r"for small $\delta$ it is a matter of length: with $\cos\delta = \frac{99}{101}$ "
                r"the same geodesics need $l_i = 8$. The witness leaves a net on a smaller "
                r"complex, but $\gamma_i(2) = \gamma_i(0)$, which (iii) allows, leaves none that "
                r"contains the curves: the rhombi at their second edges keep the orientation"
            ),
        ),
    ),
    Claim(
        id="4.assembly-unique",
        section="4",
        where="lemma (lem:discrete_assembly), line 1119",
        kind="sentence",
        statement=(
            r"The complex $Q$ of discrete assembly is maximal and it, $N$ and $r$ are uniquely "
            r"determined by the $\gamma_i$."
        ),
        hypotheses=(
            r"(used, not stated) $r$ is unique up to a translation",
            (
                r"(used, not stated) maximal among the complexes on which every normal is "
                r"determined by the data, which are the full rectangles $J_i$"
            ),
        ),
        rests_on=(
            "lem:discrete_assembly",
            "eq:householder",
        ),
        checks=(
            Check(
                name="closure-under-the-rule",
                run=f"{_ASSEMBLY}:unique",
                routes=(
                    "vertices that quads with one unknown give",
                    "shipped star, roots of the quadratic",
                ),
                mutants=(
                    Mutant(name="one-vertex-missing", given={"missing": 1}, near=True),
                    Mutant(name="one-edge-larger", given={"larger": True}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="4.assembly-domains",
        section="4",
        where="proof of lemma (lem:discrete_assembly), line 1123",
        kind="definition",
        statement=(
            r"$J_i = \{0,\ldots,l_{i-1}\} \times \{0,\ldots,l_i\}$, $i = 1,\ldots,2m$, with $l_0 = "
            r"l_{2m}$ and $J_0 = J_{2m}$."
        ),
        checks=(
            Check(
                name="sizes",
                run=f"{_DOMAINS}:domains",
                routes=(
                    "printed rectangles",
                    "shipped star",
                ),
                mutants=(Mutant(name="index-off-by-one", given={"back": 2}, near=True),),
            ),
        ),
    ),
    Claim(
        id="4.assembly-attaching",
        section="4",
        where="proof of lemma (lem:discrete_assembly), line 1123",
        kind="equation",
        statement=(
            r"The attaching maps $\chi_i : (k,0) \in J_i \mapsto (l_{i-1},k) \in J_{i-1}$ identify "
            r"whole sides of neighbouring rectangles and make an asymptotic complex around one "
            r"interior vertex of degree $2m$."
        ),
        hypotheses=(r"$0 \le k \le l_{i-1}$, $i = 1,\ldots,2m$",),
        rests_on=(
            "4.assembly-domains",
            "def:A-complex",
        ),
        checks=(
            Check(
                name="onto-the-far-side",
                run=f"{_DOMAINS}:attaching",
                routes=(
                    "rectangles glued by the printed maps",
                    "shipped star",
                ),
                mutants=(Mutant(name="one-in", given={"onto": "1"}, near=True),),
            ),
            Check(
                name="onto-the-near-side",
                run=f"{_DOMAINS}:attaching",
                form="corrected",
                given={"onto": "0"},
                routes=(
                    "rectangles glued by the maps onto (0, k)",
                    "shipped star",
                ),
                mutants=(
                    Mutant(name="one-in", given={"onto": "1"}, near=True),
                    Mutant(name="far-side", given={"onto": "previous"}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"$\chi_i : (k,0) \in J_i \mapsto (l_{i-1},k) \in J_{i-1}$",
            corrected=r"$\chi_i : (k,0) \in J_i \mapsto (0,k) \in J_{i-1}$",
            kind="misprint",
            witness=(
                r"all $l_i = 1$: $\chi_i(0,0) = (1,0)$, where $N_{i-1} = \gamma_{i-2}(1)$, but "
                r"$N_i(0,0) = (0,0,1)$; for $l = (3,2,4,1)$ the point $\chi_2(0,0) = (3,0)$ lies "
                r"outside of $J_1 = \{0,1\}\times\{0,1,2,3\}$"
            ),
            conclusion_survives=True,
            remark=(
                r"the proof's next sentence, $N_i(k,0) = \gamma_{i-1}(k) = N_{i-1}(0,k)$, uses the "
                r"corrected map"
            ),
        ),
    ),
    Claim(
        id="4.assembly-data",
        section="4",
        where="proof of lemma (lem:discrete_assembly), line 1123",
        kind="equation",
        statement=(
            r"$N_i(k,0) = \gamma_{i-1}(k)$ and $N_i(0,l) = \gamma_i(l)$ on two sides of $J_i$, "
            r"extended to $J_i$ by (eq:householder)."
        ),
        hypotheses=(r"(used, not stated) no quad met on the way has $N_1 + N_2 = 0$",),
        rests_on=(
            "4.assembly-domains",
            "eq:householder",
            "4.goursat-solution",
        ),
        checks=(
            Check(
                name="sides-and-extension",
                run=f"{_ASSEMBLY}:assembly_data",
                routes=(
                    "printed data extended by the printed root",
                    "shipped assembly",
                ),
                mutants=(Mutant(name="curves-exchanged", given={"exchanged": True}),),
            ),
        ),
    ),
    Claim(
        id="4.assembly-agreement",
        section="4",
        where="proof of lemma (lem:discrete_assembly), line 1123",
        kind="sentence",
        statement=r"$N_i$ and $N_{i-1} \circ \chi_i$ agree on the side attached by $\chi_i$.",
        rests_on=(
            "4.assembly-attaching",
            "4.assembly-data",
        ),
        checks=(
            Check(
                name="on-the-attached-side",
                run=f"{_ASSEMBLY}:agreement",
                routes=(
                    "N_i on its side",
                    "N_(i-1) on the side attached",
                ),
                mutants=(
                    Mutant(name="one-in", given={"onto": "1"}, near=True),
                    Mutant(name="far-side", given={"onto": "previous"}),
                ),
            ),
        ),
    ),
    Claim(
        id="4.assembly-families",
        section="4",
        where="proof of lemma (lem:discrete_assembly), line 1123",
        kind="sentence",
        statement=(
            r"Taking the edges of $\gamma_i$ as $u$-edges for $i$ even and as $v$-edges for $i$ "
            r"odd is consistent and extends to every $J_i$."
        ),
        hypotheses=(r"the number $2m$ of curves is even",),
        rests_on=(
            "4.assembly-domains",
            "4.assembly-attaching",
        ),
        checks=(
            Check(
                name="parity",
                run=f"{_DOMAINS}:families",
                routes=(
                    "parity of the curves",
                    "shipped star",
                ),
                mutants=(Mutant(name="odd-number-of-curves", given={"odd": True}, near=True),),
            ),
        ),
    ),
)
