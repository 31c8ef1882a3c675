"""Claims opening section 3: the isometry problem, its exterior system, bounded surfaces."""

from checks.claim import Check, Citation, Claim, Erratum, Mutant

_V = "checks.verify.branched_surfaces:"
_PIECES = "checks.verify.finite_pieces:"

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="W22isometry",
        section="3",
        where="equation (W22isometry), lines 217-220",
        kind="definition",
        statement=(
            r"An isometry of class $W^{2,2}$ of $(\Omega, g)$: $y \in "
            r"W^{2,2}_{\mathrm{loc}}(\Omega, \mathbb{R}^3)$ with $dy \cdot dy = g$ "
            "almost everywhere."
        ),
        labels=("W22isometry",),
        checks=(
            Check(
                name="instances and near-misses",
                run=_V + "isometry_problem",
                routes=(
                    "induced metrics and jumps of four maps",
                    "membership known by hand",
                ),
                mutants=(
                    Mutant(name="no isometry asked", given={"isometric": False}),
                    Mutant(name="no second derivatives asked", given={"sobolev": False}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.gauss-map",
        section="3",
        where="section 3, line 221",
        kind="equation",
        statement=(
            r"The Gauss normal map of a $C^1$ map $y$ is $N = \partial_1 y \times "
            r"\partial_2 y/\|\partial_1 y \times \partial_2 y\|$ in arbitrary "
            "coordinates $(x^1, x^2)$."
        ),
        hypotheses=(
            (
                r"(used, not stated) $y$ is an immersion: $\partial_1 y \times \partial_2 y "
                r"\ne 0$"
            ),
            (
                "(used, not stated) the coordinates are of one orientation, that of $dA$ in "
                "(thmegrg): exchanging $x^1$ and $x^2$ turns $N$ into $-N$"
            ),
        ),
        checks=(
            Check(
                name="coordinates of one orientation",
                run=_V + "gauss_map",
                routes=(
                    "the formula in one coordinate system",
                    "the formula after linear changes of coordinates",
                ),
                mutants=(
                    Mutant(name="twice the vector", given={"order": 2}),
                    Mutant(
                        name="orientation reversed too", given={"orientation_preserving": False}
                    ),
                ),
            ),
        ),
    ),
    Claim(
        id="3.normal-c1",
        section="3",
        where="section 3, line 221",
        kind="sentence",
        statement="If $y$ and $g$ are $C^2$ then $N$ is $C^1$.",
        hypotheses=("(used, not stated) $y$ is an immersion",),
        rests_on=("3.gauss-map",),
        checks=(
            Check(
                name="graph with a limited number of derivatives",
                run=_V + "normal_is_c1",
                routes=(
                    "normal as a function of the gradient",
                    "orders of the derivatives at the kink",
                ),
                mutants=(
                    Mutant(name="a graph of class C^{1,1}", given={"halves": 4}),
                    Mutant(name="a graph of class C^{1,1/2}", given={"halves": 3}),
                ),
            ),
        ),
    ),
    Claim(
        id="thmegrg",
        section="3",
        where="equation (thmegrg), lines 221-226",
        kind="equation",
        statement=(
            "For $y$, $g$ of class $C^2$ the isometry problem (W22isometry) is "
            r"equivalent to $N \cdot dy = 0$, $N^*(d\Omega) = \kappa\,dA$, $\kappa$ and "
            "$dA$ being those of $g$."
        ),
        labels=("thmegrg",),
        hypotheses=("(used, not stated) $N$ is the normal of the orientation of $dA$",),
        rests_on=(
            "W22isometry",
            "3.gauss-map",
            "3.normal-c1",
        ),
        checks=(
            Check(
                name="printed",
                run=_V + "exterior_system",
                routes=(
                    "Riemann tensor of the metric of an unknown graph",
                    "pull-back by its normal",
                ),
                mutants=(Mutant(name="opposite sign", given={"sign": -1}),),
            ),
            Check(
                name="isometries solve the system",
                tier="full",
                run=_V + "exterior_system",
                form="corrected",
                given={"converse": False},
                routes=(
                    "Riemann tensor of the metric of an unknown graph",
                    "pull-back by its normal",
                ),
                mutants=(
                    Mutant(name="opposite sign", given={"sign": -1}),
                    Mutant(name="dA squared", given={"area_power": 2}),
                    Mutant(name="converse claimed", given={"converse": True}),
                ),
            ),
        ),
        erratum=Erratum(
            printed="(W22isometry) is equivalent to (thmegrg)",
            corrected=r"(W22isometry) implies (thmegrg); the converse needs $dy \cdot dy = g$",
            kind="false",
            witness=(
                "with $y$ an isometry, $2y$ has the same $N$, so it solves (thmegrg) "
                r"with the $\kappa\,dA$ of $g$; its metric is $4g$"
            ),
            conclusion_survives=True,
            remark=(
                r"the system prescribes only $\kappa\,dA$: where $\kappa$ is constant, $y \circ f$ "
                "with $f$ preserving the area solves it too. With $dA$ read as the area of $y$ "
                r"itself, solutions with constant $\kappa$ are isometries of $g$ up to a local "
                "change of coordinates, which is how the paper uses it"
            ),
        ),
    ),
    Claim(
        id="3.smooth-solutions-saddle",
        section="3",
        where="section 3, line 228",
        kind="sentence",
        statement=(
            r"Where $\kappa < 0$ a smooth solution of (thmegrg) is a hyperbolic surface "
            "and looks like a saddle."
        ),
        rests_on=("thmegrg",),
        checks=(
            Check(
                name="second form",
                run=_V + "locally_saddle",
                routes=(
                    "second form of an unknown graph",
                    "Riemann tensor of its metric",
                ),
                mutants=(
                    Mutant(name="positive curvature", given={"curvature": 1}),
                    Mutant(name="curvature 0", given={"curvature": 0}),
                    Mutant(name="three sectors above", given={"above": 3}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.metric-extends",
        section="3",
        where="section 3, line 232",
        kind="sentence",
        statement=(
            r"A smooth metric of negative curvature on a bounded domain $\Omega \subset "
            r"\mathbb{R}^2$ with smooth boundary extends to a smooth metric on "
            r"$\mathbb{R}^2$ of negative curvature, decaying at infinity as rapidly as "
            "desired."
        ),
        hypotheses=(r"$\Omega$ is bounded with smooth boundary",),
        checks=(
            Check(
                name="printed",
                run=_PIECES + "metric_extension",
                routes=(
                    "Jacobi equation of the outer collar",
                    "Gauss-Bonnet on a disk that fills a hole",
                ),
                mutants=(Mutant(name="K no more negative than before", given={"stiffness": 1}),),
            ),
            Check(
                name="simply connected domains",
                run=_PIECES + "metric_extension",
                form="corrected",
                given={"simply_connected": True, "up_to_boundary": True},
                routes=(
                    "Jacobi equation of the outer collar",
                    "comparison of solutions in exponentials",
                ),
                mutants=(
                    Mutant(name="holes admitted", given={"simply_connected": False}),
                    Mutant(
                        name="metrics that grow at the boundary", given={"up_to_boundary": False}
                    ),
                    Mutant(name="curvature -4 C^2 on the collar", given={"stiffness": 2}),
                    Mutant(name="curvature -C^2 on the collar", given={"stiffness": 1}),
                ),
            ),
        ),
        erratum=Erratum(
            printed="every such metric on a bounded domain with smooth boundary extends",
            corrected=r"if $\Omega$ is simply connected and the metric smooth on its closure",
            kind="hypothesis",
            witness=(
                r"the annulus $|s| < 1$ of the bobbin with $\kappa = 2$: its throat is a "
                "closed geodesic, and a disk filling it would have "
                r"$\iint K\,dA = 2\pi$ by Gauss-Bonnet. And, if $g$ need be smooth inside "
                r"only, the Poincar\'e metric on the unit disk, which is complete"
            ),
            conclusion_survives=True,
            remark=(
                "the corrected form is proved by Fermi coordinates along the one boundary curve"
            ),
        ),
    ),
    Claim(
        id="3.hong-realisation",
        section="3",
        where="section 3, line 232",
        kind="sentence",
        statement=(
            r"Smooth metrics on $\mathbb{R}^2$ whose negative curvature decays have "
            r"smooth isometric immersions in $\mathbb{R}^3$."
        ),
        hypotheses=(
            (
                "(used, not stated) the metric is complete, and the curvature decays at the"
                " rate, and as regularly, as the theorem of Hong asks"
            ),
        ),
        citation=Citation(
            source=(
                r"J. X. Hong, Realization in $\mathbb{R}^3$ of complete Riemannian "
                "manifolds with negative curvature, Comm. Anal. Geom. 1 (1993) 487-514"
            ),
            reason=(
                "global existence for a nonlinear hyperbolic system, by a priori "
                "estimates on the whole plane: no computation of ours decides it. That "
                "metrics on disks extend to such metrics is checked in 3.metric-extends"
            ),
        ),
    ),
    Claim(
        id="3.bounded-embeds",
        section="3",
        where="section 3, line 232",
        kind="sentence",
        statement=(
            "Bounded smooth hyperbolic surfaces have smooth isometric embeddings in "
            r"$\mathbb{R}^3$."
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
            printed="bounded smooth hyperbolic surfaces are embedded",
            corrected=(
                r"simply connected bounded domains are: embedded if $K = -1$, immersed by "
                "the theorem of Hong for variable curvature"
            ),
            kind="ambiguous",
            witness=(
                "the closed surface of genus 2 and curvature $-1$ has finite diameter; "
                r"in $\mathbb{R}^3$ it would have $K > 0$ where it is farthest from the "
                "origin"
            ),
            conclusion_survives=True,
            remark=(
                r"the context, domains of $\mathbb{R}^2$, excludes closed surfaces; but annuli, "
                "whose metric need not extend, and the step from immersions to embeddings are "
                "not covered by the argument given"
            ),
        ),
    ),
    Claim(
        id="3.c2-cannot-refine",
        section="3",
        where="section 3, line 232",
        kind="sentence",
        statement=(
            "On a hyperbolic surface of class $C^2$ the undulations cannot become more "
            "numerous towards the boundary."
        ),
        hypotheses=("(used, not stated) refining means points with more than four sectors",),
        rests_on=(
            "3.c2-saddle",
            "lem:covering-number",
            "3.2.undulations-persist",
        ),
        checks=(
            Check(
                name="four sectors",
                run="checks.verify.smooth_sectors:cannot_refine",
                routes=(
                    "null lines of quadratic forms, with a remainder",
                    "saddles over stars",
                ),
                mutants=(
                    Mutant(name="six sectors", given={"sectors": 6}),
                    Mutant(name="positive curvature", given={"curvature": 1}),
                    Mutant(name="not of class C^2", given={"smooth": False}),
                ),
            ),
        ),
    ),
)
