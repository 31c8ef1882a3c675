"""Claims of the abstract."""

from checks.claim import Check, Citation, Claim, Erratum, Mutant

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
                name="runs grow by less",
                run="checks.verify.greedy_growth:sub_exponential",
                tier="full",
                form="support",
                routes=("energies in the limit of edge length 0", "interval of the best power"),
                mutants=(
                    Mutant(name="power 3/4", given={"rival": "3/4"}, near=True),
                    Mutant(name="power 1/2", given={"rival": "1/2"}),
                ),
            ),
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
        citation=Citation(
            source="conjecture of the paper",
            reason=(
                "the least over all branched immersions; measured is that the surfaces of the "
                "greedy "
                "algorithm grow by less than exp(c R) up to R = 16"
            ),
        ),
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
        citation=Citation(
            source="conjecture of the paper, after Gemmer and Venkataramani, Physica D 240 (2011)",
            reason=(
                "the bound from below speaks of all smooth immersions, see (e2): proved is "
                "only that "
                r"it is at least $R^2/\pi - 1$"
            ),
        ),
        checks=(
            Check(
                name="from above, by the bobbins",
                run="checks.verify.energy_scaling:bobbin_scaling",
                form="support",
                routes=("printed R", "theory.bobbin:largest_on_disk"),
                mutants=(
                    Mutant(name="root of R", given={"power": "1/2"}),
                    Mutant(name="R^(11/10)", given={"power": "11/10"}, near=True),
                ),
            ),
            Check(
                name="from below, by a square",
                run="checks.verify.energy_scaling:rectangle_bound",
                form="support",
                routes=("alternating sum over a square", "distance along asymptotic lines"),
                mutants=(Mutant(name="square 2 % larger", given={"half": "51/100"}, near=True),),
            ),
        ),
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
            "(used, not stated) (e2) and (ebs), which are conjectures",
            (
                "(used, not stated) the energy is the maximal curvature: the Willmore energy "
                "grows like $e^R$ at least, branched or not, see 1.energy-scaling"
            ),
        ),
        rests_on=(
            "5.1.branch-free-region",
            "ebs",
            "e2",
        ),
        checks=(
            Check(
                name="less energy",
                run="checks.verify.energy_scaling:separation",
                routes=("printed exponents", "limit for any two constants"),
                mutants=(
                    Mutant(name="equal powers", given={"power": "1"}),
                    Mutant(name="R^(11/10)", given={"power": "11/10"}, near=True),
                ),
            ),
            Check(
                name="spread over the disk",
                run="checks.verify.branch_count:free_region",
                part="spread",
                routes=("(e2) on the part, from below", "(ebs) on the whole, from above"),
                mutants=(
                    Mutant(name="size R^(2/5)", given={"power": "2/5"}, near=True),
                    Mutant(name="(e2) with sqrt R", given={"patch": "1/2"}),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="on the surface",
                run="checks.verify.branch_point_scales:smaller_scales",
                tier="full",
                routes=("distances on the hyperboloid", "order of the generations"),
                mutants=(
                    Mutant(name="from the first generation on", given={"first": 1}, near=True),
                    Mutant(name="to nine tenths", given={"most": "9/10"}, near=True),
                ),
            ),
            Check(
                name="in the Poincare disk",
                run="checks.verify.branch_point_scales:smaller_scales",
                tier="full",
                form="corrected",
                given={"metric": "disk"},
                routes=("distances in the disk", "order of the generations"),
                mutants=(
                    Mutant(
                        name="from the first generation on",
                        given={"metric": "disk", "first": 1},
                        near=True,
                    ),
                    Mutant(
                        name="to nine tenths", given={"metric": "disk", "most": "9/10"}, near=True
                    ),
                    Mutant(name="on the surface", given={"metric": "surface"}),
                ),
            ),
            Check(
                name="three daughters each",
                run="checks.verify.branch_point_scales:recursion",
                tier="full",
                form="support",
                routes=("branch points of runs", "powers of three"),
                mutants=(
                    Mutant(name="two", given={"daughters": 2}, near=True),
                    Mutant(name="five generations", given={"until": 5}, near=True),
                ),
            ),
        ),
        erratum=Erratum(
            printed="the pattern repeats itself on smaller and smaller scales",
            corrected=(
                "so in the Poincare disk, where circles about the centre have one size; on the "
                "surface itself sister branch points are farther apart in the third generation of "
                "parents than in the second, and later about as far"
            ),
            kind="ambiguous",
            witness=(
                "$R = 10$, $\\phi_0 = \\pi/4$, $\\phi^* = 4\\pi/5$: median distances of sisters on "
                "the surface 0.81, 1.22, 1.73, 1.92, 1.97 for parents of generations 2 to 6; in "
                "the disk each is less than the last, by a factor of 0.26 to 0.50 at first"
            ),
            conclusion_survives=True,
            remark="Measured on runs of the greedy algorithm; that they are optimal is not known.",
        ),
    ),
)

CLAIMS: tuple[Claim, ...] = (*_CLAIMS,)
