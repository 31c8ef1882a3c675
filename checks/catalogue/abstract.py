"""Claims of the abstract."""

from checks.claim import Check, Claim, Mutant

_V = "checks.verify.abstract:"
_INTRO = "checks.verify.introduction:"

_CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="abstract.index",
        section="abstract",
        where="abstract, line 59",
        kind="abstract",
        statement="To each branch point belongs an integer that is topological, its index.",
        rests_on=(
            "def:Jp",
            "lem:covering-number",
        ),
        checks=(
            Check(
                name="index of star saddles",
                run=_INTRO + "index",
                routes=(
                    "gradient of the quadratic saddle on the rays",
                    "order of the star",
                ),
                mutants=(
                    Mutant(name="2 - m", given={"offset": 2}),
                    Mutant(name="1 + m", given={"slope": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="abstract.robust",
        section="abstract",
        where="abstract, line 59",
        kind="abstract",
        statement=(
            "The index makes branch points robust: they are topological defects of "
            "hyperbolic sheets."
        ),
        rests_on=(
            "abstract.index",
            "thm:branched",
        ),
        checks=(
            Check(
                name="disturbed normals",
                run="checks.verify.robust_index:disturbed",
                tier="full",
                routes=(
                    "normals of Lelieuvre's surfaces, disturbed",
                    "order of the vertex in the complex",
                ),
                mutants=(
                    Mutant(
                        name="1 % beyond the distance from N(p)", given={"percent": 101}, near=True
                    ),
                    Mutant(name="half as far again", given={"percent": 150}),
                ),
            ),
        ),
    ),
    Claim(
        id="abstract.no-concentration",
        section="abstract",
        where="abstract, line 59",
        kind="abstract",
        statement="Branch points do not concentrate energy.",
        hypotheses=("(used, not stated) the sectors are smooth up to the branch point",),
        rests_on=("def:m-saddle",),
        checks=(
            Check(
                name="energy near the branch point",
                run=_V + "no_concentration",
                routes=(
                    "principal curvatures at the corners of the sectors",
                    "integral over a small disk",
                ),
                mutants=(Mutant(name="a cone", given={"degree": 1}),),
            ),
        ),
    ),
    Claim(
        id="abstract.sub-exponential",
        section="abstract",
        where="abstract, line 59",
        kind="abstract",
        statement=(
            "The least maximum curvature of branched immersions of a disk of radius $R$"
            r" is $O(e^{c\sqrt{R}})$."
        ),
        hypotheses=(
            (
                "(used, not stated) the least over all such surfaces: the monkey saddle of six "
                r"Amsler sectors of angle $\pi/3$ reaches its singular edge within the radius 4"
            ),
        ),
        rests_on=("ebs",),
        checks=(
            Check(
                name="one monkey saddle",
                run=_V + "one_branched_surface",
                form="support",
                routes=(
                    "bounds of the Amsler angle from above and below",
                    "distances along asymptotic lines",
                ),
                mutants=(Mutant(name="within the radius 1", given={"radius": 1}),),
            ),
        ),
        waits_for=("5",),
    ),
    Claim(
        id="abstract.root-is-sub-exponential",
        section="abstract",
        where="abstract, line 59",
        kind="abstract",
        statement=r"$O(e^{c\sqrt{R}})$ is sub-exponential, in contrast to $e^{c'R}$.",
        checks=(
            Check(
                name="exponents",
                run=_V + "sub_exponential",
                routes=(
                    "the two printed exponents",
                    "limit of their ratio",
                ),
                mutants=(
                    Mutant(name="R for its root", given={"tenths": 10}),
                    Mutant(name="power 1.1", given={"tenths": 11}),
                ),
            ),
        ),
    ),
    Claim(
        id="abstract.smooth-exponential",
        section="abstract",
        where="abstract, line 59",
        kind="abstract",
        statement=(
            "The least maximum curvature of immersions of a disk of radius $R$ without "
            "branch points is $O(e^{c'R})$."
        ),
        hypotheses=("(used, not stated) the least over all such surfaces, not each one",),
        rests_on=("1.incomplete-surfaces",),
        checks=(
            Check(
                name="bobbins",
                run=_V + "smooth_bound",
                routes=(
                    "principal curvatures of the bobbin",
                    "disks in its cover",
                ),
                mutants=(
                    Mutant(name="exponent R/2", given={"halves": 1}),
                    Mutant(name="throat curvature cosh(R/2)", given={"throat": "half"}),
                ),
            ),
        ),
    ),
    Claim(
        id="abstract.contrast",
        section="abstract",
        where="abstract, line 59",
        kind="abstract",
        statement=(
            "Without branch points the growth is exponential, in contrast to that with "
            "branch points."
        ),
        hypotheses=(
            (
                "(used, not stated) a bound from below, $e^{c'R}$ up to a constant: "
                r"$O(e^{c'R})$ alone is a bound from above and holds for $e^{c\sqrt{R}}$ too"
            ),
        ),
        rests_on=(
            "e2",
            "abstract.root-is-sub-exponential",
        ),
        waits_for=("5",),
    ),
    Claim(
        id="abstract.preferred",
        section="abstract",
        where="abstract, line 59",
        kind="abstract",
        statement=(
            "On large disks the optimum of the curvature energies is reached with many "
            "branch points, spread over the disk."
        ),
        hypotheses=(
            (
                "(used, not stated) the energy is the maximal curvature: the Willmore energy "
                "grows like $e^R$ at least, branched or not, see 1.energy-scaling"
            ),
        ),
        rests_on=(
            "ebs",
            "e2",
        ),
        waits_for=("5",),
    ),
    Claim(
        id="abstract.fractal",
        section="abstract",
        where="abstract, line 59",
        kind="abstract",
        statement=(
            "The optimal positions of branch points make the undulations repeat "
            "themselves on smaller and smaller scales."
        ),
        rests_on=(
            "alg:greedy-cuts",
            "fig:branch-tree",
        ),
        waits_for=(
            "4.1",
            "5.1",
        ),
    ),
)

CLAIMS: tuple[Claim, ...] = (*_CLAIMS,)
