"""Claims of the introduction."""

from checks.claim import Check, Claim, Erratum, Mutant

_V = "checks.verify.introduction:"
_PLANE = "checks.verify.hyperbolic_plane:"
_PIECES = "checks.verify.finite_pieces:"

_METRICS: tuple[Claim, ...] = (
    Claim(
        id="1.not-flat",
        section="1",
        where="section 1, line 95",
        kind="sentence",
        statement=(
            "The metrics of leaves and torn sheets, of negative curvature, are not "
            "those of any flat shape."
        ),
        checks=(
            Check(
                name="conformal maps to the plane",
                run=_PLANE + "no_flat_map",
                routes=(
                    "curvature of the metric of a holomorphic map",
                    "the Cauchy-Riemann equations",
                ),
                mutants=(Mutant(name="a metric of curvature 0", given={"curvature": 0}),),
            ),
        ),
    ),
    Claim(
        id="1.swelling-centre",
        section="1",
        where="section 1, line 97",
        kind="sentence",
        statement=(
            "A disk that swells more near its centre gets positive total curvature "
            "inside every concentric circle."
        ),
        hypotheses=(
            ("(used, not stated) the swelling is isotropic and depends on the radius alone"),
        ),
        checks=(
            Check(
                name="total curvature",
                run=_PLANE + "swelling",
                routes=(
                    "curvature of a conformal metric",
                    "integral over a disk",
                ),
                mutants=(
                    Mutant(name="negative curvature", given={"curvature": -1}),
                    Mutant(name="swelling at the margin", given={"where": "margin"}),
                ),
            ),
        ),
    ),
    Claim(
        id="1.swelling-margin",
        section="1",
        where="section 1, line 97",
        kind="sentence",
        statement=(
            "A disk that swells more near its margin gets negative total curvature "
            "inside every concentric circle."
        ),
        hypotheses=(
            ("(used, not stated) the swelling is isotropic and depends on the radius alone"),
        ),
        checks=(
            Check(
                name="total curvature",
                run=_PLANE + "swelling_at_margin",
                routes=(
                    "curvature of a conformal metric",
                    "integral over a disk",
                ),
                mutants=(
                    Mutant(name="positive curvature", given={"curvature": 1}),
                    Mutant(name="swelling at the centre", given={"where": "centre"}),
                ),
            ),
        ),
    ),
    Claim(
        id="1.crochet-perimeter",
        section="1",
        where="section 1, line 100",
        kind="sentence",
        statement=(
            r"In $\mathbb{H}^2$, as in hyperbolic crochet, the perimeter of a disk grows"
            " exponentially with its radius."
        ),
        rests_on=("def:H2",),
        checks=(
            Check(
                name="perimeter",
                run=_PLANE + "perimeter_growth",
                routes=(
                    "Jacobi equation",
                    "circles on the hyperboloid",
                ),
                mutants=(
                    Mutant(name="flat plane", given={"curvature": 0}),
                    Mutant(name="sphere", given={"curvature": 1}),
                    Mutant(name="rate 2", given={"rate": 2}),
                ),
            ),
            Check(
                name="area",
                run=_PLANE + "disk_area",
                form="support",
                routes=(
                    "integral of the area element of the disk model",
                    "closed form",
                ),
                mutants=(Mutant(name="shift 2", given={"shift": 2}),),
            ),
        ),
    ),
    Claim(
        id="1.hyperbolic-perimeter",
        section="1",
        where="section 1, line 104",
        kind="sentence",
        statement=(
            "Hyperbolic surfaces are those whose perimeter grows exponentially with the radius."
        ),
        hypotheses=(
            (
                r"(used, not stated) $K \le -\delta^2 < 0$: $ds^2 = dr^2 + (r + r^3)^2 "
                r"d\theta^2$ has $K = -6/(1 + r^2) < 0$ and perimeters $2\pi(r + r^3)$"
            ),
        ),
        checks=(
            Check(
                name="curvature bounded away from 0",
                run=_PLANE + "negative_curvature_growth",
                routes=(
                    "Wronskian against constant curvature",
                    "rate of growth of the perimeters of four rotationally symmetric planes",
                ),
                mutants=(
                    Mutant(name="curvature only negative", given={"bounded_away": False}),
                    Mutant(name="no exponential growth", given={"opposite": True}),
                ),
            ),
        ),
    ),
)

_EXISTENCE: tuple[Claim, ...] = (
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
        statement=(
            "$C^{1,1}$ immersions have uniformly bounded curvatures that need not be continuous."
        ),
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
            "$C^{1,1}$ isometries with branch points can have substantially smaller "
            "elastic energy than $C^2$ ones."
        ),
        rests_on=(
            "ebs",
            "e2",
        ),
        waits_for=("5",),
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
        waits_for=(
            "3.5",
            "4.1",
            "5.1",
        ),
    ),
)

_RESULTS: tuple[Claim, ...] = (
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
            "At a regular point a surface of negative curvature has 4 sectors, two "
            "above and two below the tangent plane."
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
        statement="At a branch point of order $m$ the surface has $2m > 4$ sectors.",
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
            r"If a pseudospherical surface is a limit in $W^{2,2}_{\mathrm{loc}}$ of "
            "surfaces with bounded curvature and no branch points, it has no branch "
            "points."
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
        waits_for=("3.3",),
    ),
    Claim(
        id="1.surgery",
        section="1",
        where="section 1, line 122",
        kind="sentence",
        statement="Surgery adds branch points to a surface.",
        rests_on=("lem:surgery",),
        waits_for=("3.4",),
    ),
    Claim(
        id="1.sine-gordon",
        section="1",
        where="section 1, line 122",
        kind="equation",
        statement=(
            "On smooth pseudospherical surfaces the angle of the asymptotic directions "
            r"satisfies $\partial_{uv}\varphi = \sin\varphi$."
        ),
        hypotheses=(
            (
                r"(used, not stated) $\varphi$ is the angle from $r_u$ to $r_v$, $\sigma = "
                r"+1$; with the angle of (eq:def_phi) the right side is $\sigma\sin\varphi$"
            ),
        ),
        rests_on=("eq:sg",),
        checks=(
            Check(
                name="Gauss curvature",
                run=_V + "sine_gordon",
                routes=(
                    "Riemann tensor of the metric of asymptotic lines",
                    "the printed equation",
                ),
                mutants=(
                    Mutant(name="opposite sign", given={"sign": -1}),
                    Mutant(name="factor 2", given={"factor": 2}),
                    Mutant(name="opposite orientation", given={"sigma": -1}),
                ),
            ),
        ),
    ),
    Claim(
        id="1.branched-sine-gordon",
        section="1",
        where="informal theorem (thm:sg-branched), lines 124-128",
        kind="theorem",
        statement=(
            r"$\oint_{\partial\Gamma} \frac12(\partial_v\varphi\,dv - "
            r"\partial_u\varphi\,du) = \iint_\Gamma \sin\varphi\,du\,dv - \pi\sum_{p_i "
            r"\in \Gamma}(m_i - 2)$ for domains $\Gamma$ bounded by asymptotic curves."
        ),
        hypotheses=(
            (
                r"(used, not stated) $\Gamma$ has compact closure and no branch point on its"
                " boundary"
            ),
            (
                r"(used, not stated) $\partial\Gamma$ has the orientation of the surface, and "
                r"$\sin\varphi\,du\,dv$ is its area: in sectors with $\sigma = -1$ that is not "
                r"the orientation of $(u, v)$"
            ),
        ),
        rests_on=(
            "thm:sg-branched",
            "lem:m-star",
            "eq:sg",
        ),
        checks=(
            Check(
                name="no branch point",
                run=_V + "branched_smooth",
                part="smooth",
                routes=(
                    "Riemann tensor of the metric of asymptotic lines",
                    "Stokes",
                ),
                mutants=(
                    Mutant(name="factor 1 for 1/2", given={"denominator": 1}),
                    Mutant(name="sum for difference", given={"sign_u": 1}),
                    Mutant(
                        name="oriented by the coordinates", given={"orientation": "coordinates"}
                    ),
                ),
            ),
            Check(
                name="printed, one branch point",
                run=_V + "branched_star",
                part="branch point",
                routes=(
                    "angles of the sectors of four stars",
                    "the printed correction",
                ),
                mutants=(Mutant(name="opposite correction", given={"sign": 1}),),
            ),
            Check(
                name="jumps included",
                run=_V + "branched_star",
                form="corrected",
                given={"jumps": True},
                part="branch point",
                routes=(
                    "angles of the sectors of four stars",
                    "the printed correction",
                ),
                mutants=(
                    Mutant(name="opposite correction", given={"sign": 1}),
                    Mutant(name="m - 3 for m - 2", given={"regular": 3}),
                    Mutant(name="factor 1 for 1/2", given={"denominator": 1}),
                    Mutant(name="jumps left out", given={"jumps": False}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=(
                r"$\oint_{\partial\Gamma}\frac12(\varphi_v\,dv - \varphi_u\,du) = "
                r"\iint_\Gamma\sin\varphi\,du\,dv - \pi\sum(m_i - 2)$"
            ),
            corrected=(
                r"with the jumps of $\varphi$ where $\partial\Gamma$ crosses an asymptotic curve "
                r"through a branch point included on the left, which makes it $\Delta_\Gamma$"
            ),
            kind="ambiguous",
            witness=(
                "round the centre of a small star with $m = 3$ the derivatives of "
                r"$\varphi$ contribute next to nothing, while the right side tends to $-\pi$"
            ),
            conclusion_survives=True,
            remark=(
                "the theorem is announced with an appropriate definition of the angle, and "
                "(sg-global), in terms of its values at the vertices, is free of the ambiguity"
            ),
        ),
    ),
    Claim(
        id="1.charge",
        section="1",
        where="section 1, line 128",
        kind="sentence",
        statement=(
            r"The correction is $\pi$ times the sum of the topological charges, which "
            "(def:Jp) measures."
        ),
        hypotheses=(
            (
                "(used, not stated) the charge of $p$ is $m_p - 2 = -(1 + J_p)$, not $J_p$ "
                "itself, and the correction is subtracted"
            ),
        ),
        rests_on=(
            "def:Jp",
            "lem:covering-number",
        ),
        checks=(
            Check(
                name="charge -(1 + J_p)",
                run=_V + "charge",
                routes=(
                    "winding number of the gradient of quadratic saddles",
                    "the printed correction",
                ),
                mutants=(
                    Mutant(name="m - 3 for m - 2", given={"regular": 3}),
                    Mutant(name="charge J_p", given={"reading": "index"}),
                ),
            ),
        ),
    ),
    Claim(
        id="1.intrinsic-nets",
        section="1",
        where="section 1, line 130",
        kind="sentence",
        statement=(
            "The nets of section 4.1 represent the second fundamental form in intrinsic"
            " coordinates and admit branch points."
        ),
        rests_on=(
            "poincare-ddg",
            "eq:angle",
        ),
        waits_for=("4.1",),
    ),
    Claim(
        id="1.greedy",
        section="1",
        where="section 1, line 130",
        kind="sentence",
        statement=(
            "(alg:greedy-cuts) distributes branch points greedily so as to lower the "
            "elastic energy."
        ),
        rests_on=("alg:greedy-cuts",),
        waits_for=("4.1",),
    ),
    Claim(
        id="1.min-max",
        section="1",
        where="section 1, line 130",
        kind="sentence",
        statement=(
            r"Optimising the elastic energy is the problem of finding $\arg\min_r "
            r"\operatorname{ess\,sup}_x |H(x)|$, $H$ the mean curvature."
        ),
        hypotheses=(
            (
                "(used, not stated) the elastic energy is the maximal principal curvature "
                r"$\mathcal{E}_\infty$"
            ),
            "$K = -1$",
        ),
        checks=(
            Check(
                name="monotone dependence",
                run=_V + "mean_against_maximum",
                routes=(
                    "mean curvature from one principal curvature",
                    "sign of its derivative",
                ),
                mutants=(
                    Mutant(name="Gauss curvature for H", given={"quantity": "gauss"}),
                    Mutant(name="H for |H|", given={"absolute": False}),
                ),
            ),
        ),
    ),
    Claim(
        id="1.energy-scaling",
        section="1",
        where="section 1, line 132",
        kind="sentence",
        statement=(
            r"For disks of radius $R$, $\log\inf\mathcal{E} \sim R$ for smooth and $\sim"
            r" \sqrt{R}$ for branched immersions."
        ),
        hypotheses=(
            (
                r"(used, not stated) $\mathcal{E}$ is the maximal curvature $\mathcal{E}_\infty$,"
                r" as in (e2) and (ebs). For the bending energy $\mathcal{E}_2$, branched or not, "
                r"$\log\inf\mathcal{E}_2 \sim R$: $\kappa_1^2 + \kappa_2^2 \ge "
                r"2|\kappa_1\kappa_2| = 2$, so that $\mathcal{E}_2 \ge 2A = 4\pi(\cosh R - 1)$"
            ),
            "$R$ is large",
        ),
        rests_on=(
            "e2",
            "ebs",
        ),
        checks=(
            Check(
                name="the bending energy grows exponentially",
                run=_V + "bending_growth",
                form="support",
                given={"growth": "linear"},
                routes=(
                    "area of the disk by integration",
                    "principal curvatures of the bobbin",
                ),
                mutants=(
                    Mutant(name="root for R", given={"growth": "root"}),
                    Mutant(name="square for R", given={"growth": "square"}),
                ),
            ),
        ),
        waits_for=("5",),
    ),
    Claim(
        id="1.number-of-wrinkles",
        section="1",
        where="section 1, line 132",
        kind="sentence",
        statement=(
            "The estimates of section 5 give the number of wrinkles of nearly optimal immersions."
        ),
        rests_on=(
            "5.1.cut-depth",
            "5.1.number-of-branch-points",
        ),
        waits_for=("5.1",),
    ),
)

CLAIMS: tuple[Claim, ...] = (
    *_METRICS,
    *_EXISTENCE,
    *_RESULTS,
)
