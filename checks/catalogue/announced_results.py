"""Claims of the introduction: branch points and theorems announced there."""

from checks.claim import Check, Citation, Claim, Erratum, Mutant

_V = "checks.verify.introduction:"

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="1.branch-point-definition",
        section="1",
        where="section 1, line 113",
        kind="sentence",
        statement="(def:m-star) defines branch points: its centre has $2m > 4$ sectors.",
        rests_on=("def:m-star",),
        checks=(
            Check(
                name="printed",
                run=_V + "star_centres",
                routes=(
                    "orders that the definition admits",
                    "sectors of quadratic saddles",
                ),
                mutants=(Mutant(name="m sectors", given={"per_order": 1}),),
            ),
            Check(
                name="order 3 or more",
                run=_V + "star_centres",
                form="corrected",
                given={"smallest": 3},
                routes=(
                    "orders that the definition admits",
                    "sectors of quadratic saddles",
                ),
                mutants=(
                    Mutant(name="order 2 too", given={"smallest": 2}),
                    Mutant(name="m sectors", given={"per_order": 1}),
                ),
            ),
        ),
        erratum=Erratum(
            printed="branch points are defined in (def:m-star)",
            corrected=(
                "after (def:branched_immersion), by $m_p > 2$; (def:m-star) defines the"
                " domain and admits $m = 2$"
            ),
            kind="misprint",
            witness=(
                "the star of four right angles satisfies (def:m-star) and carries a "
                "regular saddle of 4 sectors"
            ),
            conclusion_survives=True,
        ),
    ),
    Claim(
        id="1.regular-sectors",
        section="1",
        where="section 1, line 113",
        kind="sentence",
        statement=(
            "Round a regular point of negative curvature there are 4 sectors: the surface "
            "lies over its tangent plane in two of them, under it in the others."
        ),
        checks=(
            Check(
                name="quadratic forms",
                run=_V + "regular_sectors",
                routes=(
                    "null directions of the form",
                    "sign of the form between them",
                ),
                mutants=(
                    Mutant(name="six sectors", given={"per_order": 3}),
                    Mutant(name="positive curvature", given={"curvature": 1}),
                    Mutant(name="curvature 0", given={"curvature": 0}),
                ),
            ),
        ),
    ),
    Claim(
        id="1.branch-sectors",
        section="1",
        where="section 1, line 113",
        kind="sentence",
        statement="Round a branch point of order $m$ there are $2m$ sectors, more than 4.",
        rests_on=("def:m-saddle",),
        checks=(
            Check(
                name="quadratic saddles",
                run=_V + "branch_sectors",
                routes=(
                    "quadratic saddles over regular stars",
                    "sign on the bisectors",
                ),
                mutants=(
                    Mutant(name="m sectors", given={"per_order": 1}),
                    Mutant(name="order 2 too", given={"smallest": 2}),
                ),
            ),
        ),
    ),
    Claim(
        id="1.assembly",
        section="1",
        where="informal proposition (prop:assembly), lines 115-116",
        kind="proposition",
        statement=(
            r"$2m \ge 4$ smooth curves from $p$, tangent to a common plane there, with "
            r"torsions $\pm 1$ alternating, lie near $p$ on a branched pseudospherical "
            "surface of bounded principal curvatures."
        ),
        hypotheses=(
            (
                "the curves start at $p$, tangent to a common plane, with alternating "
                "torsions $1$ and $-1$"
            ),
        ),
        rests_on=("prop:assembly",),
        checks=(
            Check(
                name="printed",
                run=_V + "assembly",
                routes=(
                    "normal curvatures that the curves prescribe",
                    "heights of the sectors of curvature -1",
                ),
                mutants=(Mutant(name="tangents in order", given={"cyclic": True}),),
            ),
            Check(
                name="asymptotic curves in order",
                run=_V + "assembly",
                form="corrected",
                given={"osculating": True, "cyclic": True},
                routes=(
                    "quadratic saddle with the tangents as rays",
                    "Frenet frames in the Lelieuvre formulae",
                ),
                mutants=(
                    Mutant(name="osculating planes left free", given={"osculating": False}),
                    Mutant(name="tangents in a half-plane", given={"cyclic": False}),
                    Mutant(name="torsions all -1", given={"alternating": False}),
                ),
            ),
        ),
        erratum=Erratum(
            printed="any smooth curves tangent to a common plane, with alternating torsions",
            corrected=(
                "if moreover the common plane is their osculating plane at $p$ and "
                r"their tangents follow each other round $p$ with gaps in $(0, \pi)$"
            ),
            kind="hypothesis",
            witness=(
                "four curves of curvature 2 and torsions $1, -1, 1, -1$, tangents at "
                r"$0, \pi/2, \pi, 3\pi/2$, osculating planes normal to the common plane,"
                " bending up, down, up, down: a sector that holds a normal curvature "
                r"$k$ has an angle of at least $2\arctan|k|$, and $8\arctan 2 > 2\pi$"
            ),
            conclusion_survives=True,
            remark=(
                "the introduction calls itself informal, and (prop:assembly) has these "
                "hypotheses. What is checked here is that the data of the corrected form fit "
                "at $p$; that they have a solution is (prop:assembly). With $2m = 4$ no branch "
                "point need result"
            ),
        ),
        waits_for=("3.2",),
    ),
    Claim(
        id="1.topological-charge",
        section="1",
        where="section 1, line 118",
        kind="sentence",
        statement=(
            "(def:Jp) gives the quantity that measures the topological charge of a branch point."
        ),
        rests_on=(
            "def:Jp",
            "1.charge",
        ),
        checks=(
            Check(
                name="index of star saddles",
                run=_V + "index",
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
        id="1.branched-theorem",
        section="1",
        where="informal theorem (thm:branched), line 120",
        kind="theorem",
        statement=(
            r"A pseudospherical surface that is a limit in $W^{2,2}_{\mathrm{loc}}$ of unbranched "
            "surfaces, their curvatures bounded, is itself unbranched."
        ),
        hypotheses=(
            (
                "(used, not stated) the approximating surfaces are $C^2$ and "
                "pseudospherical themselves"
            ),
            "(used, not stated) one bound holds for the curvatures of all of them",
            ("(used, not stated) the limit is a $C^{1,1}$ immersion of a simply connected domain"),
        ),
        rests_on=("thm:branched",),
        citation=Citation(
            source="as (thm:branched), in the form of 3.3.degree-stable",
            reason="a statement about all sequences: that the degree stays in the limit is "
            "analysis; what follows for stars of any order is decided by computer",
            search="search for a smooth saddle near the monkey saddle",
        ),
        checks=(
            Check(
                name="order of the limit",
                form="support",
                run="checks.verify.robust_index:unbranched_limit",
                tier="full",
                routes=(
                    "indices of stars and of smooth surfaces",
                    "bound of the normals on a collar",
                ),
                mutants=(
                    Mutant(name="smooth surfaces of any curvature", given={"isometric": False}),
                    Mutant(name="a limit of order 3", given={"order": 3}, near=True),
                    Mutant(
                        name="the bound on the collar 1 % above s",
                        given={"share": "101/100"},
                        near=True,
                    ),
                ),
            ),
            Check(
                name="search for a smooth saddle near the monkey saddle",
                run="checks.verify.branch_searches:smooth_near_star_search",
                tier="full",
                form="support",
                routes=(
                    "cells of a Chebyshev net, minimised",
                    "inversion of the net on polar grids",
                ),
                mutants=(
                    Mutant(name="a kinked star of order 2", given={"target": "kinked"}),
                    Mutant(name="1 % farther", given={"bound_percent": 116}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="1.surgery",
        section="1",
        where="section 1, line 122",
        kind="sentence",
        statement="Surgery adds branch points to a surface.",
        rests_on=("lem:surgery",),
        checks=(
            Check(
                name="surgeries on nets",
                run="checks.verify.announced_nets:surgery_adds",
                tier="full",
                routes=(
                    "degrees of the glued complex",
                    "winding of the normal of Lelieuvre's surface",
                ),
                mutants=(
                    Mutant(name="two branch points each", given={"gained": 2}, near=True),
                    Mutant(name="none", given={"gained": 0}, near=True),
                    Mutant(name="the rest of the surface moves", given={"kept": False}),
                ),
            ),
        ),
    ),
)
