"""Claims of the introduction: equations, nets and energies announced there."""

from checks.claim import Check, Citation, Claim, Erratum, Mutant

_V = "checks.verify.introduction:"

CLAIMS: tuple[Claim, ...] = (
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
            r"A branch point adds $\pi$ times its topological charge to the correction; (def:Jp) "
            "measures the charge."
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
            "The nets of section 4.1 hold the second fundamental form of a surface, in coordinates"
            " of its own metric, and admit branch points."
        ),
        rests_on=(
            "poincare-ddg",
            "eq:angle",
        ),
        checks=(
            Check(
                name="second form",
                run="checks.verify.intrinsic_second_form:second_form",
                part="second form",
                routes=(
                    "second differences of Lelieuvre's quads, in a field of fractions",
                    "lengths and angle of the quad of H^2",
                ),
                mutants=(
                    Mutant(name="h_uv 1 % larger", given={"factor": "101/100"}, near=True),
                    Mutant(name="cos A for sin A", given={"power": 0}),
                    Mutant(name="opposite sign", given={"sign": -1}),
                ),
            ),
            Check(
                name="branch points",
                run="checks.verify.net_topology:inherited",
                tier="full",
                part="branch points",
                routes=(
                    "combinatorial surgery and (poincare-ddg)",
                    "half-turns of triples between equally spaced geodesics",
                ),
                mutants=(
                    Mutant(name="last edge 1 % longer", given={"last_edge": 101}, near=True),
                    Mutant(name="a complex without branch points", given={"branched": False}),
                ),
            ),
        ),
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
        hypotheses=(
            (
                "(used, not stated) the disk is so large that the initial star reaches its "
                "singular "
                r"edge: on a smaller one a cut can raise the energy, for $R = 5/2$, $m = 6$, "
                r"$\phi^* = "
                r"\pi/2$ from $3.73$ to $6.49$"
            ),
        ),
        rests_on=("alg:greedy-cuts",),
        checks=(
            Check(
                name="stars without cuts",
                run="checks.verify.energy_figure:cuts_help",
                tier="full",
                routes=("finest stored nets", "theory.periodic_amsler (balls)"),
                mutants=(Mutant(name="from R = 5/2 on", given={"lowest": "5/2"}, near=True),),
            ),
        ),
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
        citation=Citation(
            source="conjecture of the paper",
            reason="(e2) and (ebs) in one line, both conjectured: infima over all immersions",
        ),
    ),
    Claim(
        id="1.number-of-wrinkles",
        section="1",
        where="section 1, line 132",
        kind="sentence",
        statement=(
            "The estimates of section 5 say how many wrinkles a nearly optimal immersion has."
        ),
        hypotheses=(
            (
                "(used, not stated) wrinkles are counted by branch points, on the surfaces of the "
                "greedy algorithm"
            ),
        ),
        rests_on=(
            "5.1.cut-depth",
            "5.1.number-of-branch-points",
        ),
        checks=(
            Check(
                name="numbers of the runs",
                run="checks.verify.greedy_growth:number_law",
                tier="full",
                routes=("branch points of stored runs", "printed law"),
                mutants=(
                    Mutant(name="R^(2/5) for the root", given={"power": "2/5"}, near=True),
                    Mutant(name="twice the root", given={"factor": "2"}),
                ),
            ),
            Check(
                name="exp R",
                run="checks.verify.greedy_growth:number_law",
                tier="full",
                form="corrected",
                given={"factor": "0"},
                routes=("branch points of stored runs", "law without the root"),
                mutants=(
                    Mutant(name="exp(11/10 R)", given={"factor": "0", "rate": "11/10"}, near=True),
                    Mutant(name="exp(19/20 R)", given={"factor": "0", "rate": "19/20"}, near=True),
                    Mutant(name="a quarter of the root", given={"factor": "1/4"}, near=True),
                    Mutant(name="as printed", given={"factor": "1"}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"$\exp(R - \sqrt{R})$ branch points",
            corrected=r"about $0.8\,e^R$ on the surfaces of the greedy algorithm",
            kind="false",
            witness="as in (5.1.number-of-branch-points)",
            conclusion_survives=True,
        ),
    ),
)
