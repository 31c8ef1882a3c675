"""Claims of the introduction: existence and regularity of isometric immersions."""

from checks.claim import Check, Claim, Erratum, Mutant

_V = "checks.verify.introduction:"
_PIECES = "checks.verify.finite_pieces:"

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="1.complete-unbounded",
        section="1",
        where="section 1, line 107",
        kind="sentence",
        statement=(
            "The theorems of Hilbert and Efimov are about complete surfaces, which are "
            "necessarily unbounded."
        ),
        hypotheses=(
            (
                r"(used, not stated) the surfaces lie in $\mathbb{R}^3$: the closed surface of "
                "genus 2 and curvature $-1$ is complete, of diameter at most "
                r"$2\operatorname{arcosh}(3 + 2\sqrt{2})$, and has no $C^2$ immersion there"
            ),
        ),
        checks=(
            Check(
                name="surfaces in space",
                run=_PIECES + "complete_is_unbounded",
                routes=(
                    "pole of the factor of the disk",
                    "curvature at the point farthest from the origin",
                ),
                mutants=(
                    Mutant(name="closed surfaces too", given={"in_space": False}),
                    Mutant(name="incomplete disk", given={"power": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="1.incomplete-surfaces",
        section="1",
        where="section 1, line 107",
        kind="sentence",
        statement=(
            "The theorems say nothing of surfaces that are not complete: there are "
            "smooth ones with $K = -1$, containing disks of any radius."
        ),
        checks=(
            Check(
                name="disks in bobbins",
                run=_PIECES + "disk_in_bobbin",
                routes=(
                    "first form and Gauss curvature of the bobbin",
                    "Fermi coordinates of H^2",
                ),
                mutants=(
                    Mutant(name="throat curvature sinh R", given={"throat": "sinh"}),
                    Mutant(name="throat curvature cosh(R/2)", given={"throat": "half"}),
                    Mutant(name="curvature 1", given={"curvature": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="1.finite-piece-embeds",
        section="1",
        where="section 1, line 107",
        kind="sentence",
        statement=(
            "Bounded parts of smooth hyperbolic surfaces always have smooth isometric "
            r"embeddings in $\mathbb{R}^3$."
        ),
        rests_on=(
            "3.metric-extends",
            "3.hong-realisation",
        ),
        checks=(
            Check(
                name="printed",
                run=_PIECES + "finite_piece",
                routes=(
                    "first form of Dini's surfaces",
                    "closed surface of genus 2 from a regular octagon",
                ),
                mutants=(Mutant(name="strip too narrow", given={"slack": -1}),),
            ),
            Check(
                name="disks of curvature -1",
                tier="full",
                run=_PIECES + "finite_piece",
                form="corrected",
                given={"closed": False},
                routes=(
                    "first form of Dini's surfaces",
                    "strips of H^2 along a geodesic",
                ),
                mutants=(
                    Mutant(name="closed surfaces too", given={"closed": True}),
                    Mutant(name="strip narrower than the disk", given={"slack": -1}),
                    Mutant(name="surface of revolution", given={"pitch": 0}),
                ),
            ),
        ),
        erratum=Erratum(
            printed="any finite piece is embedded",
            corrected=(
                r"any bounded piece of $\mathbb{H}^2$ is embedded, any bounded simply connected "
                "piece of variable curvature is immersed (Hong)"
            ),
            kind="hypothesis",
            witness=(
                "the closed surface of genus 2 and curvature $-1$, or all of it but one point "
                r"$p$: in $\mathbb{R}^3$ it would have $K > 0$ where it is farthest from the "
                "origin, or from the place of $p$"
            ),
            conclusion_survives=True,
            remark=(
                r"Dini's surface of pitch $1/\cosh w$ embeds a strip of $\mathbb{H}^2$ of width "
                "$w$ along a geodesic, and so disks of any radius: embedded is right at $K = -1$"
            ),
        ),
    ),
    Claim(
        id="1.c11-class",
        section="1",
        where="section 1, line 109",
        kind="sentence",
        statement=("The principal curvatures of a $C^{1,1}$ immersion are bounded, but may jump."),
        checks=(
            Check(
                name="monkey saddle",
                run=_V + "bounded_discontinuous",
                routes=(
                    "Hessians of the quadratic saddle across its rays",
                    "scaling at the centre",
                ),
                mutants=(
                    Mutant(name="a star of order 2", given={"order": 2}),
                    Mutant(name="a cone", given={"degree": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="1.flexible-rigid",
        section="1",
        where="section 1, line 109",
        kind="sentence",
        statement="$C^{1,1}$ isometric immersions are flexible, $C^2$ ones are rigid.",
        hypotheses=(
            (
                "(used, not stated) rigid means that the number of sectors at a point is fixed, "
                "flexible that it is not. In the established sense, that the metric determines "
                r"the surface up to motions, $C^2$ immersions are not rigid: the bobbins of all "
                r"$\kappa > \sinh R$ contain the same disk of radius $R$, their metric being "
                r"$ds^2 + \cosh^2 s\,d\tau^2$, $\theta = \kappa\tau$, the curvature of the "
                r"throat $\kappa$"
            ),
        ),
        rests_on=(
            "thm:branched",
            "lem:surgery",
        ),
        checks=(
            Check(
                name="number of sectors",
                run=_V + "rigidity",
                routes=(
                    "quadratic forms of negative determinant",
                    "quadratic saddles over stars",
                ),
                mutants=(
                    Mutant(name="determined by the metric", given={"reading": "unique"}),
                    Mutant(name="six sectors on C^2 surfaces", given={"smooth_sectors": 6}),
                ),
            ),
        ),
    ),
    Claim(
        id="1.smaller-energy",
        section="1",
        where="section 1, line 109",
        kind="sentence",
        statement=(
            "The elastic energy of some $C^{1,1}$ isometries with branch points is far below "
            "that of all $C^2$ ones."
        ),
        hypotheses=(
            (
                r"(read so) the energy is $\mathcal{E}_\infty$, far: by more than a tenth, on one "
                "disk, of radius $8/5$; that the quotient grows without bound is "
                "(5.energy-separation)"
            ),
        ),
        rests_on=("3.3.energy-gap",),
        checks=(
            Check(
                name="a tenth below all smooth isometries",
                run="checks.verify.energy_gap:substantially_below",
                routes=(
                    "theory.periodic_amsler (balls)",
                    "alternating sum of phi over an inscribed square (theory.inscribed_square)",
                ),
                mutants=(
                    Mutant(name="0.86 of it", given={"share": "43/50"}, near=True),
                    Mutant(name="R = 3/2", given={"radius": "3/2"}, near=True),
                    Mutant(name="eight sectors", given={"sectors": 8}),
                ),
            ),
        ),
    ),
    Claim(
        id="1.local-balance",
        section="1",
        where="section 1, line 109",
        kind="sentence",
        statement=(
            "Where the energy is least the two principal curvatures are of about the "
            "same size at each point."
        ),
        checks=(
            Check(
                name="pointwise minimum",
                run=_V + "balance",
                routes=(
                    "both energies as functions of one principal curvature",
                    "the sine-Gordon equation at pi/2",
                ),
                mutants=(
                    Mutant(name="ratio 2", given={"ratio": 2}),
                    Mutant(name="one curvature counted twice", given={"weight": 2}),
                ),
            ),
        ),
    ),
    Claim(
        id="1.balance-gives-fractals",
        section="1",
        where="section 1, line 109",
        kind="sentence",
        statement="This balance makes the pattern of undulations look like a fractal.",
        rests_on=(
            "1.local-balance",
            "rmk:distributed",
            "alg:greedy-cuts",
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
            corrected="so in the Poincare disk, not on the surface itself",
            kind="ambiguous",
            witness="as in (abstract.fractal)",
            conclusion_survives=True,
        ),
    ),
)
