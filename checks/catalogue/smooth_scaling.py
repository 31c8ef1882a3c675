"""Claims of the opening of section 5, the symbol ~ and the smooth immersions."""

from checks.claim import Check, Citation, Claim, Erratum, Mutant

_SCALING = "checks.verify.energy_scaling:"
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
        id="5.scaling-symbol",
        section="5",
        where="section 5, line 1429",
        kind="definition",
        statement=(
            r"$a \sim b$ says that there is a constant $1 < C < \infty$ with $C^{-1} b \leq a "
            r"\leq C b$ for all $R$."
        ),
        hypotheses=("(used, not stated) $a$ and $b$ are positive and continuous for $R > 0$",),
        checks=(
            Check(
                name="as printed, for all R",
                run=_SCALING + "scaling_symbol",
                routes=("printed bounds at the ends of the range", "pairs sorted beforehand"),
                mutants=(Mutant(name="bound from below only", given={"side": "lower"}),),
            ),
            Check(
                name="for R at least 1",
                run=_SCALING + "scaling_symbol",
                form="corrected",
                given={"least_radius": "1"},
                routes=("bounds on the radii from 1 on", "pairs sorted beforehand"),
                mutants=(
                    Mutant(name="bound from above only", given={"side": "upper"}),
                    Mutant(name="bound from below only", given={"side": "lower"}),
                    Mutant(name="for all R", given={"least_radius": "0"}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"$C^{-1}b \leq a \leq Cb$ for all $R$",
            corrected=r"$C^{-1}b \leq a \leq Cb$ for all $R \geq R_0$, some $R_0 > 0$",
            kind="hypothesis",
            witness=(
                r"the bobbins, $a = \log\cosh R$ and $b = R$: at $R = 1/C$, $\log\cosh R < "
                r"R^2/2 = R/(2C) < C^{-1}R$, whatever $C > 1$"
            ),
            conclusion_survives=True,
            remark=(
                r"as printed the symbol excludes the energy that it is made for, and makes (e2) "
                r"false: $0 \leq \log\inf\mathcal{E}_\infty \leq \log\cosh R$. Large $R$ is what "
                "the section is about"
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
        citation=Citation(
            source="Gemmer and Venkataramani, Physica D 240 (2011) 1536-1552",
            reason=(
                "a statement about all smooth immersions of a disk, put as a suggestion: proved "
                "here for surfaces with a one-parameter group of motions, and to leading order as "
                r"$R \to 0$ for all"
            ),
            search="search among smooth disks",
        ),
        checks=(
            Check(
                name="surfaces with a group of motions",
                run=_SCALING + "helicoidal_rivals",
                form="support",
                routes=("theory.helicoidal_net (Killing fields)", "theory.bobbin:largest_on_disk"),
                mutants=(
                    Mutant(name="1 % more than cosh R", given={"factor": "101/100"}, near=True),
                    Mutant(name="negative pitch", given={"twist": -1}),
                ),
            ),
            Check(
                name="search among smooth disks",
                run="checks.verify.smooth_disk_search:smooth_disk_search",
                tier="full",
                form="support",
                routes=(
                    "checks.searches.smooth_disks (nets in H^2)",
                    "geodesic rays in a solution on a grid",
                ),
                mutants=(
                    Mutant(name="1 % above the bobbin", given={"bound_percent": 101}, near=True),
                    Mutant(name="a tenth above", given={"bound_percent": 110}),
                ),
            ),
            Check(
                name="small disks",
                run=_SCALING + "small_disks",
                form="support",
                routes=("alternating sum over an inscribed square", "cosh R"),
                mutants=(
                    Mutant(name="circumscribed square", given={"area": "4"}),
                    Mutant(name="area 1 % more", given={"area": "101/50"}, near=True),
                ),
            ),
        ),
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
        checks=(
            Check(
                name="bounds by R",
                run=_SCALING + "bobbin_scaling",
                routes=("printed R", "theory.bobbin:largest_on_disk"),
                mutants=(
                    Mutant(name="root of R", given={"power": "1/2"}),
                    Mutant(name="R^(11/10)", given={"power": "11/10"}, near=True),
                    Mutant(name="kappa = exp R", given={"throat": "exp"}),
                ),
            ),
        ),
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
        citation=Citation(
            source="conjecture of the paper, after Gemmer and Venkataramani, Physica D 240 (2011)",
            reason=(
                "the bound from below speaks of all smooth immersions: proved here is only "
                r"$R^2/\pi - 1 \leq \inf\mathcal{E}_\infty \leq \cosh R$"
            ),
        ),
        checks=(
            Check(
                name="from above, by the bobbins",
                run=_SCALING + "bobbin_scaling",
                form="support",
                routes=("printed R", "theory.bobbin:largest_on_disk"),
                mutants=(
                    Mutant(name="root of R", given={"power": "1/2"}),
                    Mutant(name="R^(11/10)", given={"power": "11/10"}, near=True),
                    Mutant(name="kappa = exp R", given={"throat": "exp"}),
                ),
            ),
            Check(
                name="from below, by a square",
                run=_SCALING + "rectangle_bound",
                form="support",
                routes=("alternating sum over a square", "distance along asymptotic lines"),
                mutants=(
                    Mutant(name="square 2 % larger", given={"half": "51/100"}, near=True),
                    Mutant(name="twice the bound", given={"factor": "2"}),
                ),
            ),
        ),
    ),
)
