"""Claims of section 4.1, the dual of the greedy algorithm: its stages, items 2 to 4."""

from checks.catalogue.greedy_dual import NEEDED
from checks.claim import Check, Claim, Erratum, Mutant

_GENERATIONS = "checks.verify.greedy_dual_generations:"
_FIRST = "checks.verify.greedy_dual_first_cut:"
_DUAL = "$m$ as in the algorithm, $g$ as in item (1)"

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="4.1.dual-2-first-step",
        section="4.1",
        where="section 4.1, dual interpretation, item (2), line 1410",
        kind="item",
        statement=(
            "In the first step $2m$ daughters, each of degree $3^g$, move out of the origin in "
            "their sectors, and a branch point of index $m$ is left there."
        ),
        hypotheses=(
            _DUAL,
            (
                "(used, not stated) degree is the number of sectors that a daughter carries "
                "outward: its degree as a vertex is $3^g + 3$"
            ),
        ),
        rests_on=("4.1.dual-1-generations", "4.1.branch-point-degree"),
        checks=(
            Check(
                name="degree of the vertex, as printed",
                run=_GENERATIONS + "first_step",
                routes=("printed number and degree", "sum of the charges of the vertices"),
                mutants=(
                    Mutant(name="3^(g+1)", given={"degree_shift": 1}, near=True),
                    Mutant(name="m daughters", given={"daughters": 1}),
                ),
            ),
            Check(
                name="three sectors more",
                run=_GENERATIONS + "first_step",
                form="corrected",
                given={"added": 3},
                routes=("2m vertices of degree 3^g + 3", "sum of the charges of the vertices"),
                mutants=(
                    Mutant(name="two sectors more", given={"added": 2}, near=True),
                    Mutant(name="3^(g-1)", given={"degree_shift": -1}, near=True),
                    Mutant(name="m daughters", given={"daughters": 1}),
                ),
            ),
        ),
        erratum=Erratum(
            printed="daughters of degree $3^g$",
            corrected=(
                "daughters of degree $3^g + 3$: each carries $3^g$ sectors outward, and has three "
                "corners of the sector that it is moved into beside them"
            ),
            kind="ambiguous",
            witness=(
                "$g = 1$: $3$ is odd, while interior vertices have even degrees; $m = 2$, $g = 1$: "
                "four vertices of degree $6$ and a regular origin have the charge $4$ of the "
                "vertex of degree $12$ that they come from"
            ),
            conclusion_survives=True,
            remark=(
                "The paper has no other meaning of degree. Read as the number of sectors carried "
                "outward, $3^g$ is right here, and item (3) then contradicts it."
            ),
        ),
    ),
    Claim(
        id="4.1.dual-2-stop-at-cutoff",
        section="4.1",
        where="section 4.1, dual interpretation, item (2), line 1410",
        kind="item",
        statement=(
            r"The daughters move until the largest $\varphi$ over each sector that grows at the "
            r"origin equals $\phi^*$."
        ),
        hypotheses=(
            _DUAL,
            (
                "(used, not stated) the largest angle increases continuously with the position "
                "of the daughter"
            ),
        ),
        rests_on=("4.1.dual-2-first-step",),
        checks=(
            Check(
                name="angle over the arms",
                run=_FIRST + "reaches_cutoff",
                tier="full",
                routes=(
                    "nets by advanced angles, SL(2, R) frames",
                    "v-lines on the hyperboloid, theory.painleve_float",
                ),
                mutants=(
                    Mutant(name="one edge before", given={"shift": -1}, near=True),
                    Mutant(name="two edges farther", given={"shift": 2}),
                ),
            ),
        ),
    ),
    Claim(
        id="4.1.dual-2-same-cut",
        section="4.1",
        where="section 4.1, dual interpretation, item (2), line 1411",
        kind="sentence",
        statement=(
            "The first generation of the dual has the places $(j^*, k^*)$ of steps 12 and 13 in "
            "each of the $2m$ initial sectors."
        ),
        hypotheses=(
            _DUAL,
            (
                "(used, not stated) a daughter has two coordinates, so that one condition on the "
                "largest angle does not fix its place"
            ),
        ),
        rests_on=(
            "4.1.dual-2-stop-at-cutoff",
            "4.1.algorithm-12-cut-column",
            "4.1.algorithm-13-cut-row",
        ),
        checks=(
            Check(
                name="as printed",
                run=_FIRST + "same_cut",
                tier="full",
                routes=("stop at one largest angle", "steps 12 and 13 as they stand"),
                mutants=(Mutant(name="j* + 1", given={"shift": 1}, near=True),),
            ),
            Check(
                name="each arm",
                run=_FIRST + "same_cut",
                form="corrected",
                given={"rule": "each"},
                tier="full",
                routes=("stop of either coordinate", "steps 12 and 13 as they stand"),
                mutants=(
                    Mutant(name="as printed", given={"rule": "one"}),
                    Mutant(name="j* + 1", given={"shift": 1}, near=True),
                    Mutant(name="j* - 1", given={"shift": -1}, near=True),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"until the largest $\varphi$ over the growing sector equals $\phi^*$",
            corrected=(
                r"until the largest $\varphi$ over either arm, $[0, u_{\max}] \times [0, v]$ and "
                r"$[0, u] \times [0, v_{\max}]$, equals $\phi^*$"
            ),
            kind="ambiguous",
            witness=(
                r"$m = 2$, $\phi^* = 3\pi/4$, $R = 3$, edges of $1/24$: the largest $\varphi$ "
                "reaches the cutoff at nine vertices, $(5, k)$ and $(j, 5)$ with $j, k \\leq 5$, "
                "of which $(5, 5)$ alone is $(j^*, k^*)$"
            ),
            conclusion_survives=True,
            remark=(
                "A daughter on the mirror line, moved along it, stops at the same place under both "
                "readings; later sectors have no mirror line."
            ),
        ),
    ),
    Claim(
        id="4.1.dual-3-stage",
        section="4.1",
        where="section 4.1, dual interpretation, item (3), line 1412",
        kind="item",
        statement=(
            r"At stage $k$ there are $2 \cdot 3^{k-1} m$ daughters to move out, each of degree "
            "$3^{g-k}$."
        ),
        hypotheses=(
            _DUAL,
            r"$1 \leq k \leq g$",
            "(used, not stated) degree is meant as in item (2); stage $1$ is the first step",
        ),
        rests_on=("4.1.dual-2-first-step",),
        checks=(
            Check(
                name="charges, as printed",
                run=_GENERATIONS + "stage",
                part="degree of the vertex",
                routes=("printed number and degree", "sum of the charges of the vertices"),
                mutants=(
                    Mutant(name="3^(g-k+1)", given={"degree_shift": 1}, near=True),
                    Mutant(name="2 3^k m daughters", given={"number_shift": 1}, near=True),
                ),
            ),
            Check(
                name="sectors carried, as printed",
                run=_GENERATIONS + "carried",
                part="sectors carried",
                routes=("printed stage 1", "printed first step, number of all sectors"),
                mutants=(
                    Mutant(name="3^(g-k-1)", given={"degree_shift": -1}, near=True),
                    Mutant(name="2 3^k m daughters", given={"number_shift": 1}, near=True),
                ),
            ),
            Check(
                name="charges, 3^(g-k+1) + 3",
                run=_GENERATIONS + "stage",
                form="corrected",
                part="degree of the vertex",
                given={"degree_shift": 1, "added": 3},
                routes=("2 3^(k-1) m vertices", "sum of the charges of the vertices"),
                mutants=(
                    Mutant(name="two sectors more", given={"added": 2}, near=True),
                    Mutant(name="3^(g-k) + 3", given={"degree_shift": 0}, near=True),
                    Mutant(name="2 3^k m daughters", given={"number_shift": 1}, near=True),
                ),
            ),
            Check(
                name="sectors carried, 3^(g-k+1)",
                run=_GENERATIONS + "carried",
                form="corrected",
                part="sectors carried",
                given={"degree_shift": 1},
                routes=("stage 1", "printed first step, number of all sectors"),
                mutants=(
                    Mutant(name="as printed", given={"degree_shift": 0}, near=True),
                    Mutant(name="2 3^k m daughters", given={"number_shift": 1}, near=True),
                    Mutant(name="first step with 3^(g+1)", given={"first_shift": 1}, near=True),
                ),
            ),
        ),
        erratum=Erratum(
            printed="daughters of degree $3^{g-k}$ at stage $k$",
            corrected="$3^{g-k+1}$ sectors carried by each, of the degree $3^{g-k+1} + 3$",
            kind="misprint",
            witness=(
                "$k = 1$ is the first step, whose daughters item (2) gives $3^g$: printed is "
                "$3^{g-1}$; with it the daughters of any stage carry $2 \\cdot 3^{g-1} m$ of the "
                "$2 \\cdot 3^g m$ sectors"
            ),
            conclusion_survives=True,
            remark="The exponents of item (6) do not come from this one.",
        ),
    ),
    Claim(
        id="4.1.dual-3-stop-at-cutoff",
        section="4.1",
        where="section 4.1, dual interpretation, item (3), line 1412",
        kind="item",
        statement=(
            r"At stage $k$ the daughters move until the largest $\varphi$ in the sectors at the "
            r"branch points of generation $k - 1$ equals $\phi^*$."
        ),
        hypotheses=(_DUAL, r"$1 \leq k \leq g$"),
        checks=(
            Check(
                name="largest angles kept at the cuts",
                run="checks.verify.greedy_stop:stops_at_cutoff",
                routes=("runs of discrete.greedy", "order 1 in the edge length"),
                mutants=(
                    Mutant(name="1.01 phi*", given={"level": "101/100"}, near=True),
                    Mutant(name="0.99 phi*", given={"level": "99/100"}, near=True),
                ),
            ),
        ),
        rests_on=("4.1.dual-3-stage",),
    ),
    Claim(
        id="4.1.dual-4-cover",
        section="4.1",
        where="section 4.1, dual interpretation, item (4), line 1413",
        kind="item",
        statement="At every stage the sectors together cover the whole disk.",
        hypotheses=(
            _DUAL,
            NEEDED,
            "(used, not stated) no sector develops a singular edge inside the disk on the way",
        ),
        checks=(
            Check(
                name="first stage, R = 5",
                run="checks.verify.greedy_dual_stages:stage_one",
                tier="full",
                routes=(
                    "angles of nets of two edge lengths",
                    "distances by SL(2, R) frames",
                ),
                mutants=(Mutant(name="phi* = 2 pi/5", given={"cutoff": "2/5"}, near=True),),
            ),
            Check(
                name="first stage, R = 4",
                run="checks.verify.greedy_dual_stages:stage_one",
                tier="full",
                form="corrected",
                given={"radius": "4"},
                routes=(
                    "angles of nets of two edge lengths",
                    "distances by SL(2, R) frames",
                ),
                mutants=(
                    Mutant(name="R = 5", given={"radius": "5"}, near=True),
                    Mutant(name="m_0 for phi < pi", given={"by": "edge"}),
                    Mutant(name="phi < 3 pi/5", given={"level": "3/5"}),
                ),
            ),
        ),
        erratum=Erratum(
            printed="the sectors cover the disk at every stage",
            corrected=(
                "they do while none of them has a singular edge inside the disk, as for $m = 6$, "
                "$R = 4$ where $m_0$ keeps $\\varphi \\leq \\phi^*$; the sectors beside the lines "
                "of the parent may have one at the first stage already"
            ),
            kind="hypothesis",
            witness=(
                r"$R = 5$, $m = 6$, $\phi^* = \pi/2$, $g = 3$: in the outer sectors of the first "
                r"generation $\varphi$ passes $\pi$ at the distance $4.5$ from the origin; where "
                r"$m_0$ keeps only $\varphi < \pi$, already at $R = 4$, $g = 1$, at $3.8$"
            ),
            conclusion_survives=False,
            remark="$m_0$ makes the central sectors narrow enough, not those beside curved lines.",
        ),
        rests_on=("4.1.dual-3-stage", "4.1.periodic-amsler"),
    ),
)
