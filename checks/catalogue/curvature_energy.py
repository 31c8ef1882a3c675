"""Claims of the opening of section 5, energies of the classes of immersions."""

from checks.claim import Claim

_EINF = (
    r"(used, not stated) $\mathcal{E}_\infty$ is the least upper bound of $|\kappa_1|, "
    r"|\kappa_2|$ on the disk $B_R$"
)
_LARGE = (
    r"(used, not stated) $R \geq R_0 > 0$: as $R \to 0$ the infimum tends to $1$ and its "
    "logarithm is of order $R^2$ at most"
)

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="5.principal-curvatures",
        section="5",
        where="section 5, line 1422",
        kind="equation",
        statement=(
            r"The principal curvatures are $\kappa_1 = \pm\tan\frac{\varphi}{2}$ and $\kappa_2 = "
            r"\mp\cot\frac{\varphi}{2}$."
        ),
        hypotheses=(r"$0 < \varphi < \pi$ is the angle between the asymptotic directions",),
        rests_on=("eq:metrics",),
    ),
    Claim(
        id="5.max-curvature-diverges",
        section="5",
        where="section 5, line 1422",
        kind="sentence",
        statement=(
            r"The $W^{2,\infty}$ energy is infinite when a singular edge, $\varphi = 0$ or "
            r"$\varphi = \pi$, comes into $\Omega$."
        ),
        rests_on=("5.principal-curvatures",),
    ),
    Claim(
        id="5.willmore-diverges",
        section="5",
        where="section 5, line 1422",
        kind="sentence",
        statement=(
            r"The $W^{2,2}$ energy is infinite when a singular edge, $\varphi = 0$ or $\varphi = "
            r"\pi$, comes into $\Omega$."
        ),
        hypotheses=(
            (
                r"(used, not stated) $\varphi$ reaches the edge at least linearly in $(u, v)$, "
                "as where its gradient is bounded"
            ),
            "(used, not stated) the edge is met along a curve of positive length",
        ),
        rests_on=("5.principal-curvatures", "eq:metrics"),
    ),
    Claim(
        id="5.distance-from-singular",
        section="5",
        where="section 5, line 1422",
        kind="definition",
        statement=(
            r"$\delta(\Omega) > 0$ measures how far an immersion of $\Omega$ stays from being "
            r"singular: $0 < \delta \leq \varphi \leq \pi - \delta < \pi$."
        ),
        hypotheses=(
            r"(used, not stated) $\delta$ is the largest such number, so $\delta \leq \pi/2$",
        ),
        rests_on=("eq:def_phi",),
    ),
    Claim(
        id="5.energy-of-delta",
        section="5",
        where="section 5, line 1422",
        kind="equation",
        statement=r"$\mathcal{E}_\infty = \cot\delta$.",
        hypotheses=(
            r"$\delta$ as just defined",
            r"(used, not stated) $\delta$ is the largest such number",
            _EINF,
        ),
        rests_on=("5.distance-from-singular", "5.principal-curvatures"),
    ),
    Claim(
        id="5.scaling-symbol",
        section="5",
        where="section 5, line 1429",
        kind="definition",
        statement=(
            r"$a \sim b$ says that there is a constant $1 < C < \infty$ with $C^{-1} b \leq a "
            r"\leq C b$ for all $R$."
        ),
        hypotheses=(
            (
                "(used, not stated) $a$ and $b$ are positive functions of the radius; near $R = "
                "0$ the bound is not meant"
            ),
        ),
    ),
    Claim(
        id="5.bobbin-optimal",
        section="5",
        where="section 5, line 1424",
        kind="sentence",
        statement=(
            "Among the $C^2$ pseudospherical immersions of a geodesic disk the least maximal "
            "curvature is that of a piece of the universal cover of a Minding's bobbin."
        ),
        hypotheses=("put as a suggestion of earlier work", _EINF),
        rests_on=("ex:bobbin", "eq:c2energy"),
    ),
    Claim(
        id="5.bobbin-scaling",
        section="5",
        where="section 5, line 1424",
        kind="sentence",
        statement=r"The best bobbin gives $\log\mathcal{E}_\infty \sim R$.",
        hypotheses=(
            (
                r"(used, not stated) the disk is centred on the throat and $\kappa$ is chosen "
                "best for $R$"
            ),
            r"(used, not stated) $R \geq R_0 > 0$",
        ),
        rests_on=("eq:c2energy", "5.scaling-symbol"),
    ),
    Claim(
        id="e2",
        section="5",
        where="equation (e2), line 1426",
        kind="equation",
        statement=r"$\log\inf_{r \in C^2}\mathcal{E}_\infty[r] \sim R$.",
        labels=("e2",),
        hypotheses=(
            "the infimum is over $C^2$ isometric immersions of the disk of radius $R$",
            "conjectured",
            _LARGE,
        ),
        rests_on=("5.scaling-symbol", "5.bobbin-optimal", "5.bobbin-scaling"),
    ),
    Claim(
        id="5.periodic-amsler-one-branch-point",
        section="5",
        where="section 5, line 1429",
        kind="sentence",
        statement=(
            "A periodic Amsler surface is a $C^{1,1}$ immersion of the disk with a single branch "
            "point, at the origin."
        ),
        hypotheses=("more than four sectors",),
        rests_on=("def:amsler-sector", "prop:assembly"),
    ),
    Claim(
        id="5.half-radius-disk",
        section="5",
        where="section 5, line 1429",
        kind="sentence",
        statement=(
            "The disk of radius $R$ with its centre as only branch point contains disks of "
            "radius $R/2$ free of branch points."
        ),
        hypotheses=("(used, not stated) the disks are open",),
        rests_on=("5.periodic-amsler-one-branch-point",),
    ),
    Claim(
        id="5.half-radius-approximable",
        section="5",
        where="section 5, line 1429",
        kind="sentence",
        statement=(
            "On such a disk of radius $R/2$ the periodic Amsler surface is smooth or a limit of "
            "smooth isometries."
        ),
        hypotheses=(
            "(used, not stated) the limit keeps the bound on the curvature",
            (
                "(used, not stated) the disk may straddle asymptotic lines from the origin, "
                "where second derivatives jump"
            ),
        ),
        rests_on=("5.half-radius-disk", "rem:approximable"),
    ),
    Claim(
        id="5.periodic-amsler-scaling",
        section="5",
        where="section 5, line 1429",
        kind="sentence",
        statement=(
            r"Hence $\log\mathcal{E}_\infty \sim R$ for the periodic Amsler surfaces as well."
        ),
        hypotheses=(
            r"(used, not stated) $R \geq R_0 > 0$",
            "(used, not stated) the number of sectors is chosen best for $R$",
            _EINF,
        ),
        rests_on=("e2", "5.half-radius-approximable", "5.scaling-symbol"),
    ),
    Claim(
        id="fig:energywithradius",
        section="5",
        where="figure (fig:energywithradius), lines 1436, 1450, 1460",
        kind="figure",
        statement=(
            r"$\mathcal{E}_\infty$ against $R$ for Minding's bobbins, periodic Amsler surfaces "
            "and branched surfaces of the greedy algorithm."
        ),
        labels=("fig:energywithradius",),
        hypotheses=(
            r"(used, not stated) $m$, $\phi^*$ and $\Delta$ of the branched surfaces are not given",
        ),
        rests_on=("eq:c2energy", "5.periodic-amsler-one-branch-point", "alg:greedy-cuts"),
    ),
    Claim(
        id="fig:cutdepthwithradius",
        section="5",
        where="figure (fig:cutdepthwithradius), lines 1442, 1450, 1460",
        kind="figure",
        statement="The largest depth $n$ of the recursion as a function of $R$ grows linearly.",
        labels=("fig:cutdepthwithradius",),
        hypotheses=(r"(used, not stated) $m$, $\phi^*$ and $\Delta$ are not given",),
        rests_on=("alg:greedy-cuts",),
    ),
    Claim(
        id="fig:numerical_crochet",
        section="5",
        where="figure (fig:numerical_crochet), lines 1448, 1450, 1461",
        kind="figure",
        statement=(
            "A surface with distributed branch points that the greedy algorithm makes on the "
            "disk of radius $R = 3$."
        ),
        labels=("fig:numerical_crochet",),
        hypotheses=(r"(used, not stated) $m$, $\phi^*$ and $\Delta$ are not given",),
        rests_on=("alg:greedy-cuts",),
    ),
    Claim(
        id="ebs",
        section="5",
        where="equation (ebs), line 1455",
        kind="equation",
        statement=r"$\log\inf_{r \in C^{1,1}}\mathcal{E}_\infty[r] \sim \sqrt{R}$.",
        labels=("ebs",),
        hypotheses=(
            "the infimum is over $C^{1,1}$ isometric immersions of the disk of radius $R$",
            "conjectured",
            _LARGE,
        ),
        rests_on=("5.scaling-symbol", "ebound", "alg:greedy-cuts"),
    ),
    Claim(
        id="5.energy-separation",
        section="5",
        where="section 5, line 1458",
        kind="sentence",
        statement=(
            r"The quotient of the least $\mathcal{E}_\infty$ of smooth and of branched "
            "isometries grows without bound with $R$."
        ),
        hypotheses=("(e2) and (ebs)",),
        rests_on=("e2", "ebs"),
    ),
    Claim(
        id="5.cut-depth-linear",
        section="5",
        where="section 5, line 1458",
        kind="sentence",
        statement=(
            "The cut depth, the number of generations of branch points, grows linearly with $R$."
        ),
        hypotheses=(r"greedy algorithm, $m$ and $\phi^*$ fixed",),
        rests_on=("fig:cutdepthwithradius",),
    ),
    Claim(
        id="5.evidence-to-radius-10",
        section="5",
        where="section 5, line 1460",
        kind="sentence",
        statement=(
            "Runs of the greedy algorithm on disks of radius up to $10$ agree with the scaling "
            "of energy and cut depth."
        ),
        hypotheses=(r"(used, not stated) $m$, $\phi^*$ and $\Delta$ of the runs",),
        rests_on=("ebs", "5.cut-depth-linear", "alg:greedy-cuts"),
    ),
    Claim(
        id="5.periodic-amsler-exponential",
        section="5",
        where="section 5, line 1460",
        kind="sentence",
        statement=(
            r"$\mathcal{E}_\infty$ of the periodic Amsler surfaces scales like $\exp(R)$, as for "
            "the bobbins, with a smaller constant."
        ),
        hypotheses=(
            (
                "(used, not stated) scales means equal up to a constant factor, not up to a "
                "power of $R$"
            ),
        ),
        rests_on=("fig:energywithradius", "PIII"),
    ),
    Claim(
        id="5.branched-exponential-root",
        section="5",
        where="section 5, line 1460",
        kind="sentence",
        statement=(
            r"With distributed branch points the energy seems to scale like $\exp(c\sqrt{R})$."
        ),
        hypotheses=(r"$R \leq 10$",),
        rests_on=("fig:energywithradius", "ebs"),
    ),
)
