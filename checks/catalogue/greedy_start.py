"""Claims of section 4.1, the greedy algorithm: its start, steps 1 to 8."""

from checks.claim import Check, Claim, Erratum, Mutant

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="4.1.algorithm-01-sectors",
        section="4.1",
        where="algorithm (alg:greedy-cuts), step 1, line 1304",
        kind="algorithm",
        statement=r"The number of initial sectors is $M = 2m \geq 4$.",
        hypotheses=(
            "(used, not stated) $M$ is also the running number of sectors, from step 24 on",
        ),
        checks=(
            Check(
                name="marks and cutoffs",
                run="checks.verify.printed_start:sector_number",
                routes=("marks of the axes around the origin", "interval of the cutoff"),
                mutants=(
                    Mutant(name="odd", given={"start": 5}, near=True),
                    Mutant(name="M = 2", given={"start": 2}),
                ),
            ),
        ),
    ),
    Claim(
        id="4.1.algorithm-01-cutoff",
        section="4.1",
        where="algorithm (alg:greedy-cuts), step 1, line 1304",
        kind="algorithm",
        statement=(
            r"The cutoff angle is $\phi^* \in (\pi/m, \pi)$, so that the initial sectors start "
            "below it."
        ),
        hypotheses=(r"the initial sectors have the angle $\pi/m$",),
        checks=(
            Check(
                name="corner and widest angle",
                run="checks.verify.printed_start:cutoff_range",
                routes=("the algorithm in the disk", "angles at the corner and before the fold"),
                mutants=(
                    Mutant(name="0.99 pi/m", given={"low": "99/100"}, near=True),
                    Mutant(name="pi", given={"high": "1"}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="4.1.algorithm-01-nodes",
        section="4.1",
        where="algorithm (alg:greedy-cuts), step 1, line 1304",
        kind="algorithm",
        statement=(
            r"$N = \lceil 2R/\Delta \rceil$ nodes along each axis are enough for every sector to "
            "reach the circle of radius $R$."
        ),
        hypotheses=(
            r"$\Delta$ is the spacing of the nodes",
            (
                "(used, not stated) every $u$- and $v$-line of a sector leaves the disk within "
                "the length $2R$, also where it is not a geodesic"
            ),
        ),
        checks=(
            Check(
                name="lines of all sectors",
                run="checks.verify.printed_start:enough_nodes",
                tier="full",
                routes=("the algorithm in the disk", "(eq:hyp_radius)"),
                mutants=(Mutant(name="N = R/Delta", given={"factor": "1"}, near=True),),
            ),
        ),
        rests_on=("eq:hyp_radius",),
    ),
    Claim(
        id="4.1.algorithm-02-empty-sectors",
        section="4.1",
        where="algorithm (alg:greedy-cuts), step 2, line 1305",
        kind="algorithm",
        statement=r"The list of sectors starts as $\Omega_1, \ldots, \Omega_M$, each empty.",
        checks=(
            Check(
                name="list",
                run="checks.verify.printed_start:list_of_sectors",
                routes=("the algorithm in the disk", "numbers 1 to M"),
                mutants=(Mutant(name="one more", given={"extra": 1}, near=True),),
            ),
        ),
        rests_on=("4.1.algorithm-01-sectors",),
    ),
    Claim(
        id="4.1.algorithm-03-each-sector",
        section="4.1",
        where="algorithm (alg:greedy-cuts), step 3, line 1306",
        kind="algorithm",
        statement=r"Steps 4 to 8 are done for each initial sector $n = 1, \ldots, M$.",
        checks=(
            Check(
                name="disk of radius 1/2",
                run="checks.verify.printed_start:each_sector",
                routes=("the algorithm in the disk", "random points"),
                mutants=(Mutant(name="without the last sector", given={"last": 1}, near=True),),
            ),
        ),
        rests_on=("4.1.algorithm-02-empty-sectors",),
    ),
    Claim(
        id="4.1.algorithm-04-axes",
        section="4.1",
        where="algorithm (alg:greedy-cuts), step 4, line 1307",
        kind="algorithm",
        statement=(
            r"The axes of sector $n$ are $\zeta^n_{j,0} = e^{i\pi(n-1)/m}\tanh\frac{j\Delta}{2}$ "
            r"and $\zeta^n_{0,k} = e^{i\pi n/m}\tanh\frac{k\Delta}{2}$, $0 \leq j, k \leq N$: "
            r"$2m$ geodesics from the origin at equal angles $\pi/m$."
        ),
        hypotheses=(
            (
                "(used, not stated) between neighbouring sectors the marks $u$ and $v$ are "
                "exchanged, else their common ray is a $v$-line of one and a $u$-line of the "
                "other"
            ),
        ),
        checks=(
            Check(
                name="geodesics of the hyperboloid",
                run="checks.verify.printed_start:axes",
                routes=("(geodesics)", "discrete.geodesics on the hyperboloid"),
                mutants=(
                    Mutant(name="tanh(j Delta)", given={"rate": "1"}),
                    Mutant(name="1 % longer", given={"rate": "101/200"}, near=True),
                    Mutant(name="1 % of a sector off", given={"number": "1/100"}, near=True),
                ),
            ),
        ),
        rests_on=("geodesics",),
    ),
    Claim(
        id="4.1.algorithm-05-fill",
        section="4.1",
        where="algorithm (alg:greedy-cuts), step 5, line 1308",
        kind="algorithm",
        statement=(
            r"The nodes $\zeta^n_{j,k}$ with $1 \leq j, k \leq n$ follow from (poincare-ddg) one "
            "by one, where $n$ is the number of the sector."
        ),
        hypotheses=(r"(used, not stated) the range is $1 \leq j, k \leq N$",),
        checks=(
            Check(
                name="as printed",
                run="checks.verify.printed_start:initial_cover",
                routes=("the algorithm in the disk", "random points"),
                mutants=(Mutant(name="step 5 alone", given={"variant": "fill"}, near=True),),
            ),
            Check(
                name="up to N",
                run="checks.verify.printed_start:initial_cover",
                form="corrected",
                given={"variant": "meant"},
                routes=("the algorithm in the disk", "random points"),
                mutants=(
                    Mutant(name="without the last sector", given={"last": 1}, near=True),
                    Mutant(name="n", given={"variant": "fill"}),
                ),
            ),
        ),
        erratum=Erratum(
            printed="$1 \\leq j, k \\leq n$",
            corrected="$1 \\leq j, k \\leq N$",
            kind="misprint",
            witness=(
                "sector 1 gets a single quad, sector 2 four: most points within 1/2 of the "
                "origin lie in no quad"
            ),
            conclusion_survives=True,
        ),
        rests_on=("poincare-ddg", "4.1.algorithm-04-axes"),
    ),
    Claim(
        id="4.1.algorithm-06-discard",
        section="4.1",
        where="algorithm (alg:greedy-cuts), step 6, line 1309",
        kind="algorithm",
        statement=(
            r"A node $\zeta^n_{j,k}$ is discarded when $\zeta^n_{j-1,k}$ and $\zeta^n_{j,k-1}$ "
            "are both outside the disk of radius $R$; no node inside the disk is lost."
        ),
        hypotheses=(
            r"(used, not stated) $j, k \geq 1$: on an axis only one of the two predecessors exists",
            "(used, not stated) a discarded predecessor counts as outside",
            "(used, not stated) radii increase along the lines that leave the disk",
        ),
        checks=(
            Check(
                name="nodes in the disk",
                run="checks.verify.printed_nodes:lost_nodes",
                tier="full",
                routes=("the algorithm in the disk", "nodes reached before a fold"),
                mutants=(
                    Mutant(name="a disk of 0.95 R", given={"radius": "19/20"}, near=True),
                    Mutant(name="a disk of 0.9 R", given={"radius": "9/10"}),
                ),
            ),
            Check(
                name="points of the disk",
                run="checks.verify.printed_nodes:rim_quads",
                tier="full",
                form="support",
                given={"short": "1"},
                routes=("the algorithm in the disk", "random points"),
                mutants=(Mutant(name="up to the rim", given={"short": "0"}, near=True),),
            ),
        ),
        rests_on=("4.1.algorithm-05-fill", "eq:hyp_radius"),
    ),
    Claim(
        id="4.1.algorithm-07-sector",
        section="4.1",
        where="algorithm (alg:greedy-cuts), step 7, line 1310",
        kind="algorithm",
        statement=(
            r"$\Omega_n$ is the set of all $\zeta^n_{j,k}$, $j, k \leq N$, that were not "
            "discarded."
        ),
        checks=(
            Check(
                name="pieces and Euler characteristic",
                run="checks.verify.printed_nodes:staircase",
                tier="full",
                routes=("the algorithm in the disk", "V - E + F of the kept quads"),
                mutants=(
                    Mutant(name="an inner node dropped", given={"dropped": 1}, near=True),
                    Mutant(name="discards by place", given={"variant": "discard"}),
                ),
            ),
        ),
        rests_on=("4.1.algorithm-06-discard",),
    ),
    Claim(
        id="4.1.algorithm-08-angles",
        section="4.1",
        where="algorithm (alg:greedy-cuts), step 8, line 1311",
        kind="algorithm",
        statement=(
            r"$\varphi^n_{j,k}$ is computed by (eq:angle) at the nodes of which "
            r"$\zeta^n_{j+1,k}$ and $\zeta^n_{j,k+1}$ are in $\Omega_n$."
        ),
        checks=(
            Check(
                name="law of cosines",
                run="checks.verify.printed_nodes:angles_at_nodes",
                tier="full",
                routes=("(eq:angle)", "three distances"),
                mutants=(
                    Mutant(name="without the conjugate", given={"conjugated": False}),
                    Mutant(name="1.01 Delta", given={"spacing": "101/100"}, near=True),
                ),
            ),
        ),
        rests_on=("4.1.algorithm-07-sector", "eq:angle"),
    ),
)
