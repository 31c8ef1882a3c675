"""Claims opening section 3: saddles, branch points and where a surface is only C^{1,1}."""

from checks.claim import Check, Citation, Claim, Mutant

_V = "checks.verify.branched_surfaces:"
_INTRO = "checks.verify.introduction:"
_AMSLER = "checks.verify.amsler:"

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="3.frilly-costs-less",
        section="3",
        where="section 3, line 234",
        kind="sentence",
        statement=(
            "Of two surfaces with the same metric, one that buckles on many scales can cost less "
            "bending energy than a smooth saddle."
        ),
        hypotheses=(
            "(used, not stated) the disk is large",
            "(used, not stated) the smooth saddle is a bobbin, the disk centred on its throat",
        ),
        rests_on=(
            "ebs",
            "e2",
        ),
        checks=(
            Check(
                name="bending energy",
                run="checks.verify.energy_figure:frilly_bends_less",
                part="bending",
                routes=("finest stored nets", "least integral over bobbins"),
                mutants=(
                    Mutant(name="from R = 2 on", given={"lowest": "2"}, near=True),
                    Mutant(name="runs half as much again", given={"factor": "3/2"}),
                ),
            ),
            Check(
                name="largest curvature",
                run="checks.verify.energy_figure:below",
                part="largest curvature",
                routes=(
                    "finest stored nets and the limit of edge length 0",
                    "theory.bobbin_values (balls)",
                ),
                mutants=(
                    Mutant(name="from R = 5/2 on", given={"lowest": "5/2"}, near=True),
                    Mutant(name="runs a quarter more", given={"factor": "5/4"}),
                ),
            ),
            Check(
                name="one branch point against all smooth isometries",
                run="checks.verify.energy_gap:energy_gap",
                form="support",
                routes=(
                    "theory.periodic_amsler (balls)",
                    "alternating sum of phi over an inscribed square (theory.inscribed_square)",
                ),
                mutants=(
                    Mutant(name="lower by 1 %", given={"share": "99/100"}, near=True),
                    Mutant(name="square 1 % larger", given={"stretch": "101/100"}, near=True),
                    Mutant(name="four sectors", given={"sectors": 4}),
                    Mutant(name="ten sectors", given={"sectors": 10}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.c2-saddle",
        section="3",
        where="section 3, line 234",
        kind="sentence",
        statement=(
            "Near each of its points a hyperbolic surface of class $C^2$ looks like a saddle."
        ),
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
        id="3.winding-number",
        section="3",
        where="section 3, line 234",
        kind="sentence",
        statement=(
            "How often the normal winds round its value at a point tells surfaces with"
            " further undulations there from saddles."
        ),
        rests_on=(
            "lem:covering-number",
            "fig:winding_number_normalfield",
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
        id="3.branched-only-c11",
        section="3",
        where="section 3, line 234",
        kind="sentence",
        statement=(
            "With branch points the surface is of class $C^{1,1}$ and no better, as the"
            " monkey saddle is."
        ),
        rests_on=(
            "3.c2-saddle",
            "3.2.immersion-c11",
        ),
        checks=(
            Check(
                name="quadratic saddle",
                run=_V + "only_c11",
                routes=(
                    "gradients across a ray between arbitrary angles",
                    "Hessians across the rays of the regular star",
                ),
                mutants=(Mutant(name="a star of order 2", given={"order": 2}),),
            ),
        ),
    ),
    Claim(
        id="3.refining-lowers-energy",
        section="3",
        where="section 3, line 234",
        kind="sentence",
        statement=(
            "Branch points let the undulations of a surface multiply, and its energy fall; a "
            "smooth saddle has no such means."
        ),
        rests_on=(
            "ebs",
            "e2",
            "lem:surgery",
            "3.3.branched-not-approximable",
        ),
        checks=(
            Check(
                name="stars without cuts",
                run="checks.verify.energy_figure:cuts_help",
                tier="full",
                part="energy",
                routes=("finest stored nets", "theory.periodic_amsler (balls)"),
                mutants=(Mutant(name="from R = 5/2 on", given={"lowest": "5/2"}, near=True),),
            ),
            Check(
                name="three daughters each",
                run="checks.verify.branch_point_scales:recursion",
                tier="full",
                part="undulations",
                routes=("branch points of runs", "powers of three"),
                mutants=(
                    Mutant(name="two", given={"daughters": 2}, near=True),
                    Mutant(name="five generations", given={"until": 5}, near=True),
                ),
            ),
            Check(
                name="index of a limit of smooth saddles",
                run="checks.verify.approximability:all_orders",
                part="smooth",
                tier="full",
                routes=(
                    "quadratic saddle over a star (theory.star_saddle)",
                    "index -1 required by (thm:branched)",
                ),
                mutants=(Mutant(name="with order 2", given={"orders": "2,3"}),),
            ),
        ),
    ),
    Claim(
        id="3.branched-paraboloid",
        section="3",
        where="section 3, line 237",
        kind="example",
        statement=(
            "The branched hyperbolic paraboloid is a hyperbolic surface of class $C^{1,1}$."
        ),
        checks=(
            Check(
                name="quadratic saddle of order 3",
                run=_V + "branched_paraboloid",
                routes=(
                    "form that vanishes on both rays of a sector",
                    "determinants and gradients",
                ),
                mutants=(
                    Mutant(name="positive determinant", given={"determinant": 1}),
                    Mutant(name="a star of order 2", given={"order": 2}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.rozendorn-complete",
        section="3",
        where="section 3, line 237",
        kind="sentence",
        statement=(
            r"There are $C^{1,1}$ immersions in $\mathbb{R}^3$ of complete surfaces with"
            r" $K \le -\delta < 0$ with finitely many points where they are not smooth."
        ),
        rests_on=("3.branched-paraboloid",),
        citation=Citation(
            source=(
                r"E. R. Rozendorn, On complete surfaces of negative curvature $K \le -1$"
                " in the Euclidean spaces $E_3$ and $E_4$, Mat. Sb. 58 (1962) 453-478; "
                "Weakly irregular surfaces of negative curvature, Uspehi Mat. Nauk 21 "
                "(1966) 59-116"
            ),
            reason=(
                "an explicit surface put together from infinite pieces, of which the "
                "paper gives no formula to compute with; its model at a branch point is"
                " checked in 3.branched-paraboloid"
            ),
        ),
    ),
    Claim(
        id="3.exact-metric",
        section="3",
        where="section 3, line 237",
        kind="sentence",
        statement=(
            "Surfaces glued of Amsler sectors have the prescribed metric, $K = -1$, exactly."
        ),
        rests_on=("3.1.amsler-construction",),
        checks=(
            Check(
                name="curvature of an Amsler sector",
                run=_AMSLER + "construction",
                routes=(
                    "Riemann tensor of the metric",
                    "Christoffel symbols on the axes",
                ),
                mutants=(
                    Mutant(name="opposite sign", given={"sign": -1}),
                    Mutant(name="angle not constant on the u-axis", given={"tilt_u": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.larger-singular-set",
        section="3",
        where="section 3, line 237",
        kind="sentence",
        statement=(
            "At prescribed $K = -1$ the set where the surface is only $C^{1,1}$ is "
            "larger than the finite one of Rozendorn."
        ),
        hypotheses=(
            (
                "(used, not stated) there is a branch point, and the sectors at it are "
                "$C^2$ up to their edges"
            ),
        ),
        rests_on=("3.branched-only-c11",),
        checks=(
            Check(
                name="jumps across the rays",
                run=_V + "singular_set",
                routes=(
                    "Hessians of the quadratic saddle",
                    "cotangents of neighbouring angles",
                ),
                mutants=(
                    Mutant(name="branch point isolated", given={"isolated": True}),
                    Mutant(name="a star of order 2", given={"order": 2}),
                ),
            ),
        ),
    ),
)
