"""Claims of section 3.4 on the three sectors that surgery inserts."""

from checks.claim import Check, Claim, Erratum, Mutant

_SECTORS = "checks.verify.surgery_sectors:"
_FRONTS = "checks.verify.surgery_fronts:"
_TRISECTION = "checks.verify.trisection:"
_CONVERGENCE = "checks.verify.surgery_convergence:"
_SERIES = "theory.surgery_sectors (Moutard equation, Taylor series)"
_FRENET = "Frenet-Serret along the edges"
_ANGLE_SERIES = "theory.surgery_sectors:angle_cosine"
_GRIDS = "theory.goursat_float (Moutard equation, Lelieuvre sums)"
_ANGLES = "sine-Gordon equation for the angle; closed form of the pseudosphere"

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="3.4.middle-sector",
        section="3.4",
        where="proof of lemma (lem:surgery), lines 827 and 831",
        kind="sentence",
        statement=(
            r"$r_2$ is an Amsler patch on $\Omega_2$: the frame (amsler-frame) at $\mathbf z = "
            r"\mathbf z_1$, $\mathbf n = \mathbf n_1$ with directions $\mathbf e_u^{(1)}$, "
            r"$\mathbf e_v^{(1)}$ gives $N_2$ on the axes; the Moutard and Lelieuvre equations "
            r"then give $N_2$ and $r_2$ on $\Omega_2$."
        ),
        hypotheses=(
            (
                r"$\mathbf e_u^{(1)}, \mathbf e_v^{(1)}$ are unit vectors perpendicular to "
                r"$\mathbf n_1$"
            ),
            (
                r"(used, not stated) $\mathbf e_u^{(1)} \times \mathbf e_v^{(1)} \neq 0$, if $r_2$ "
                r"is to be an immersion near the point"
            ),
        ),
        rests_on=(
            "amsler-frame",
            "def:amsler-sector",
            "eq:moutard",
            "eq:lelieuvre",
            "3.4.trisection-vectors",
        ),
        checks=(
            Check(
                name="series",
                run=_SECTORS + "middle_sector",
                part="series",
                routes=(
                    _SERIES,
                    "theory.amsler:similarity_series",
                ),
                mutants=(
                    Mutant(name="other sign along u", given={"sign_u": -1}),
                    Mutant(name="other sign along v", given={"sign_v": 1}),
                    Mutant(name="e_u not perpendicular to n", given={"tilt": 1}),
                    Mutant(name="e_u of length 2", given={"length": 2}),
                    Mutant(name="r_2 starts elsewhere", given={"start": False}),
                ),
            ),
            Check(
                name="whole surgery on grids",
                run=_CONVERGENCE + "whole_surgery",
                part="solution",
                tier="full",
                routes=(
                    _GRIDS,
                    _ANGLES,
                ),
                mutants=(
                    Mutant(name="sine-Gordon equation 1 % off", given={"rate": "0.99"}, near=True),
                    Mutant(name="v-axis of Omega_1 from Omega_3", given={"fourth": 3}),
                    Mutant(name="e_u and e_v exchanged", given={"swapped": True}),
                    Mutant(name="order 3", given={"expected": 3}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="3.4.trisection-vectors",
        section="3.4",
        where="proof of lemma (lem:surgery), unlabelled equation, line 829",
        kind="equation",
        statement=(
            r"$\mathbf z = \mathbf z_1$, $\mathbf n = \mathbf n_1$, $\mathbf e^{(1)}_u = \frac{2 "
            r"\mathbf t_v + \mathbf t_u}{\|2 \mathbf t_v + \mathbf t_u\|}$ and $\mathbf e^{(1)}_v "
            r"= \frac{2 \mathbf t_u + \mathbf t_v}{\|2 \mathbf t_u + \mathbf t_v\|}$ are "
            r"admissible in (amsler-frame): unit vectors perpendicular to $\mathbf n_1$, met in "
            r"the order $\mathbf t_u, \mathbf e_v^{(1)}, \mathbf e_u^{(1)}, \mathbf t_v$ within "
            r"the angle cut out, so that $u$- and $v$-directions alternate."
        ),
        hypotheses=(r"(used, not stated) $\mathbf t_u$ and $\mathbf t_v$ are not parallel",),
        rests_on=(
            "3.4.data-at-the-point",
            "amsler-frame",
        ),
        checks=(
            Check(
                name="unit, tangent, in order",
                run=_TRISECTION + "vectors",
                routes=(
                    "printed vectors",
                    "half-angle of t_v",
                ),
                mutants=(
                    Mutant(name="weight 1", given={"weight": "1"}, near=True),
                    Mutant(name="weight -2", given={"weight": "-2"}),
                    Mutant(name="divided by the square of the norm", given={"by": 2}),
                    Mutant(name="t_u and t_v opposite", given={"parallel": True}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.4.trisection-approximate",
        section="3.4",
        where="proof of lemma (lem:surgery), line 831",
        kind="sentence",
        statement=(
            r"$\mathbf e_v^{(1)}$ and $\mathbf e_u^{(1)}$ divide the angle between $\mathbf t_u$ "
            r"and $\mathbf t_v$ into three parts that are approximately equal."
        ),
        hypotheses=(
            (
                r"(used, not stated) the angle $\theta$ is not near $\pi$: the outer parts are "
                r"$\theta/3 - \theta^3/81 + \dots$ and shrink to $0$ as $\theta \to \pi$"
            ),
            r"(used, not stated) $\|\mathbf t_u\| = \|\mathbf t_v\|$, as for arc lengths $u, v$",
        ),
        rests_on=("3.4.trisection-vectors",),
        checks=(
            Check(
                name="first term, growth, comparability",
                run=_TRISECTION + "approximate",
                tier="full",
                routes=(
                    "arc tangent of the printed vector",
                    "its Taylor series and derivative",
                ),
                mutants=(
                    Mutant(name="weight 3", given={"weight": "3"}),
                    Mutant(name="weight 1.98", given={"weight": "99/50"}, near=True),
                    Mutant(name="error of fourth order", given={"vanishing": 4}, near=True),
                    Mutant(name="angles up to pi", given={"largest": "1"}),
                    Mutant(name="angles up to 101 pi/150", given={"largest": "101/150"}, near=True),
                ),
            ),
            Check(
                name="whole range",
                run=_TRISECTION + "whole_range",
                form="support",
                routes=(
                    "balls through the half-angle",
                    "printed vector",
                ),
                mutants=(
                    Mutant(name="least bound pi 101/300", given={"limit": "101/300"}, near=True),
                    Mutant(name="least bound pi 33/100", given={"limit": "33/100"}, near=True),
                    Mutant(
                        name="outer part atan 0.505 at a right angle",
                        given={"at_right_angle": "101/200"},
                        near=True,
                    ),
                    Mutant(name="weight 3", given={"weight": 3}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.4.data-on-two-axes-suffice",
        section="3.4",
        where="proof of lemma (lem:surgery), line 871",
        kind="sentence",
        statement=(
            r"The Gauss map $N_1 : \Omega_1 \to S^2$ is determined by its values on the axes $v = "
            r"0$ and $u = 0$ (a Goursat problem)."
        ),
        hypotheses=(
            r"$u$ and $v$ are the coordinates of $\Omega_1$, with $(0,0)$ at the branch point",
            r"(used, not stated) the two sets of values agree at $(0,0)$",
            r"(used, not stated) the data are $C^1$ with nowhere vanishing derivative",
        ),
        rests_on=("eq:moutard",),
        checks=(
            Check(
                name="coefficients",
                run=_SECTORS + "two_axes",
                routes=(
                    "symbols in the coefficients of the Moutard equation",
                    "data on the axes",
                ),
                mutants=(
                    Mutant(name="data on the u-axis only", given={"axes": "u"}),
                    Mutant(name="data on the v-axis only", given={"axes": "v"}),
                    Mutant(name="data that disagree in (0, 0)", given={"corner": "other"}),
                ),
            ),
            Check(
                name="difference of two solutions",
                run=_FRONTS + "two_solutions",
                part="class C^1",
                routes=(
                    "Moutard equation of both",
                    "linear equation of the difference",
                ),
                mutants=(
                    Mutant(name="last term dropped", given={"last": False}),
                    Mutant(name="N_uv = (N_u.N_v) N", given={"sign": 1}),
                ),
            ),
            Check(
                name="speeds",
                run=_FRONTS + "conserved_speeds",
                part="harmonic",
                routes=(
                    "any unit normal in polar angles",
                    "any field with N_uv = -(N_u.N_v) N",
                ),
                mutants=(
                    Mutant(name="N_uv not parallel to N", given={"harmonic": False}),
                    Mutant(name="along the same coordinate", given={"crosswise": False}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.4.normal-along-u-axis",
        section="3.4",
        where="proof of lemma (lem:surgery), unlabelled equation, line 874",
        kind="equation",
        statement=r"$N_1(u,0) = N_0(\chi_1(u,0))$ for $u \in [0, u_{\max}-u^*]$.",
        hypotheses=(r"$\chi_1$ is that of (eq:attaching)",),
        rests_on=("eq:attaching",),
        checks=(
            Check(
                name="place and front",
                run=_FRONTS + "normal_along_u",
                routes=(
                    "printed map chi_1",
                    "pseudosphere in closed form",
                ),
                mutants=(
                    Mutant(name="u* not added", given={"shifted": False}),
                    Mutant(name="u up to u_max", given={"runs_to": "u_max"}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.4.normal-along-v-axis",
        section="3.4",
        where="proof of lemma (lem:surgery), unlabelled equation, first equality, line 878",
        kind="equation",
        statement=r"$N_1(0,v) = N_2(\chi_4(0,v))$ for $v \in [0, \tilde v]$.",
        hypotheses=(
            r"$\chi_4$ is that of (eq:attaching), and its values lie where $N_2$ is defined",
        ),
        rests_on=(
            "eq:attaching",
            "3.4.middle-sector",
        ),
        checks=(
            Check(
                name="solution on u = 0",
                run=_SECTORS + "normal_along_v",
                routes=(
                    _SERIES,
                    "great circle along e_v",
                ),
                mutants=(
                    Mutant(name="chi_4 lands in Omega_3", given={"lands_in": 3}),
                    Mutant(name="edge v = 0", given={"edge": "v = 0"}),
                    Mutant(name="ray along -e_v", given={"direction": "-e_v"}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.4.normal-along-v-axis-value",
        section="3.4",
        where="proof of lemma (lem:surgery), unlabelled equation, second equality, line 878",
        kind="equation",
        statement=(
            r"Along the edge $u = 0$ of the middle sector the normal is $\cos(v)\,\mathbf n_1 - "
            r"\sin(v)\,\mathbf n_1 \times \mathbf e_v^{(1)}$, $0 \le v \le \tilde v$."
        ),
        hypotheses=(
            r"that edge is a straight asymptotic $v$-line with direction $\mathbf e_v^{(1)}$",
        ),
        rests_on=(
            "amsler-frame",
            "3.4.middle-sector",
        ),
        checks=(
            Check(
                name="straight line",
                run=_FRONTS + "value_along_v",
                routes=(
                    "printed formula",
                    "Lelieuvre and Frenet-Serret along a straight line",
                ),
                mutants=(
                    Mutant(name="plus sign", given={"sign": 1}),
                    Mutant(name="sine and cosine exchanged", given={"swapped": True}),
                    Mutant(name="edge along e_u", given={"ray": "e_u"}),
                    Mutant(name="e_v not perpendicular to n", given={"tilt": 1}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.4.side-sector",
        section="3.4",
        where="proof of lemma (lem:surgery), line 880",
        kind="sentence",
        statement=(
            r"The solution $N_1$ of the Moutard equation on $\Omega_1$ with these data on the axes "
            r"is weakly harmonic, and integrating the Lelieuvre equations gives a PS-front $r_1$."
        ),
        hypotheses=(
            r"(used, not stated) the integration starts from $r_1(0,0) = \mathbf z_1$",
            (
                r"(used, not stated) the derivatives of the data do not vanish, so that $N_u, N_v "
                r"\neq 0$"
            ),
        ),
        rests_on=(
            "3.4.data-on-two-axes-suffice",
            "3.4.normal-along-u-axis",
            "3.4.normal-along-v-axis",
            "3.4.normal-along-v-axis-value",
            "eq:moutard",
            "eq:lelieuvre",
        ),
        checks=(
            Check(
                name="series",
                run=_SECTORS + "side_sector",
                tier="full",
                part="series",
                routes=(
                    _SERIES,
                    _ANGLE_SERIES,
                ),
                mutants=(
                    Mutant(name="r_v = N_v x N", given={"sign_v": 1}),
                    Mutant(name="normal at rest along v", given={"moves": False}),
                ),
            ),
            Check(
                name="speeds",
                run=_FRONTS + "conserved_speeds",
                part="harmonic",
                routes=(
                    "any unit normal in polar angles",
                    "any field with N_uv = -(N_u.N_v) N",
                ),
                mutants=(
                    Mutant(name="N_uv not parallel to N", given={"harmonic": False}),
                    Mutant(name="along the same coordinate", given={"crosswise": False}),
                ),
            ),
            Check(
                name="edge of class C^1",
                run=_CONVERGENCE + "kinked_edge",
                part="solution",
                tier="full",
                routes=(
                    _GRIDS,
                    "sine-Gordon equation for the angle",
                ),
                mutants=(
                    Mutant(name="sine-Gordon equation 1 % off", given={"rate": "0.99"}, near=True),
                    Mutant(
                        name="another jump of the curvature", given={"jump": "151/100"}, near=True
                    ),
                ),
            ),
        ),
    ),
    Claim(
        id="3.4.opposite-side-sector",
        section="3.4",
        where="proof of lemma (lem:surgery), line 880",
        kind="sentence",
        statement=(
            r"The same procedure gives $N_3$ and $r_3$ on $\Omega_3$: $N_3(u,0) = "
            r"N_2(\chi_2(u,0))$ for $0 \le u \le \tilde u$ and $N_3(0,v) = N_0(\chi_3(0,v))$ for "
            r"$0 \le v \le v_{\max}-v^*$."
        ),
        hypotheses=(r"(used, not stated) the integration starts from $r_3(0,0) = \mathbf z_1$",),
        rests_on=(
            "eq:attaching",
            "3.4.middle-sector",
            "eq:moutard",
            "eq:lelieuvre",
        ),
        checks=(
            Check(
                name="series",
                run=_SECTORS + "opposite_side_sector",
                tier="full",
                part="series",
                routes=(
                    _SERIES,
                    _ANGLE_SERIES,
                ),
                mutants=(
                    Mutant(name="r_v = N_v x N", given={"sign_v": 1}),
                    Mutant(name="normal at rest along v", given={"moves": False}),
                    Mutant(name="chi_2 lands in Omega_1", given={"chart": 1}),
                ),
            ),
            Check(
                name="whole surgery on grids",
                run=_CONVERGENCE + "whole_surgery",
                part="solution",
                tier="full",
                routes=(
                    _GRIDS,
                    _ANGLES,
                ),
                mutants=(
                    Mutant(name="sine-Gordon equation 1 % off", given={"rate": "0.99"}, near=True),
                    Mutant(name="v-axis of Omega_1 from Omega_3", given={"fourth": 3}),
                    Mutant(name="e_u and e_v exchanged", given={"swapped": True}),
                    Mutant(name="order 3", given={"expected": 3}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="3.4.fronts-agree-along-u-edge",
        section="3.4",
        where="proof of lemma (lem:surgery), line 900",
        kind="sentence",
        statement=(
            r"$N_0 = N_1 \circ \chi_1$ implies $r_0 = r_1 \circ \chi_i$ on $\Omega^* \cap "
            r"\Omega_1$."
        ),
        hypotheses=(
            r"(used, not stated) $r_1(0,0) = r_0(u^*,v^*)$",
            r"(used, not stated) $\Omega^* \cap \Omega_1$ is the edge identified by $\chi_1$",
        ),
        rests_on=(
            "3.4.normal-along-u-axis",
            "3.4.side-sector",
            "eq:lelieuvre",
        ),
        checks=(
            Check(
                name="as printed",
                run=_FRONTS + "fronts_agree",
                routes=(
                    "printed map chi_1, its values",
                    "domains of the fronts",
                ),
                mutants=(
                    Mutant(name="chi_2", given={"chart": 2}),
                    Mutant(name="chi_3", given={"chart": 3}),
                ),
            ),
            Check(
                name="r_0 after chi_1",
                run=_FRONTS + "fronts_agree",
                form="corrected",
                given={"outer": 0},
                routes=(
                    "Lelieuvre equation of N_1",
                    "Lelieuvre equation of N_0",
                ),
                mutants=(
                    Mutant(name="r_1 after chi_1", given={"outer": 1}),
                    Mutant(name="chi_2", given={"chart": 2}),
                    Mutant(name="chi_3", given={"chart": 3}),
                    Mutant(name="r_1 starts elsewhere", given={"start": False}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"$N_0 = N_1 \circ \chi_1 \Rightarrow r_0 = r_1 \circ \chi_i$ on "
            r"$\Omega^* \cap \Omega_1$",
            corrected=r"$N_1 = N_0 \circ \chi_1 \Rightarrow r_1 = r_0 \circ \chi_1$ on the edge "
            r"$v = 0$ of $\Omega_1$, with $r_1(0,0) = \mathbf z_1$",
            kind="misprint",
            witness=r"$\chi_1(u,0) = (u^*+u,v^*)$ lies in $\Omega^*$, where $N_1$ and $r_1$ are "
            r"not defined: for $u^* = v^* = 2$, $u_{\max} = 3$ and $\tilde v = 1$ no value "
            r"$(2+u, 2)$ is in $\Omega_1 = [0,1] \times [0,1]$. Line 874 has $N_1(u,0) = "
            r"N_0(\chi_1(u,0))$.",
            conclusion_survives=True,
        ),
    ),
    Claim(
        id="3.4.fronts-agree-along-all-edges",
        section="3.4",
        where="proof of lemma (lem:surgery), line 900",
        kind="sentence",
        statement=(
            r"The normals and the positions of $r_1$ and $r_2$, of $r_2$ and $r_3$, and of $r_3$ "
            r"and $r_0$ agree on the edges along which they are attached."
        ),
        hypotheses=(r"(used, not stated) $r_1, r_2, r_3$ all start from $\mathbf z_1$",),
        rests_on=(
            "3.4.fronts-agree-along-u-edge",
            "3.4.normal-along-v-axis",
            "3.4.opposite-side-sector",
            "eq:lelieuvre",
        ),
        checks=(
            Check(
                name="normals and places",
                run=_SECTORS + "edges_agree",
                part="new edges",
                routes=(
                    _SERIES,
                    _FRENET,
                ),
                mutants=(
                    Mutant(name="chi_4 lands in Omega_3", given={"fourth": 3}),
                    Mutant(name="r_1 starts elsewhere", given={"starts": "2,3"}),
                    Mutant(name="r_2 starts elsewhere", given={"starts": "1,3"}),
                    Mutant(name="r_3 starts elsewhere", given={"starts": "1,2"}),
                ),
            ),
            Check(
                name="inherited edges",
                run=_FRONTS + "fronts_agree",
                form="support",
                given={"outer": 0},
                routes=(
                    "Lelieuvre equation of N_1",
                    "Lelieuvre equation of N_0",
                ),
                mutants=(
                    Mutant(name="r_1 after chi_1", given={"outer": 1}),
                    Mutant(name="r_1 starts elsewhere", given={"start": False}),
                ),
            ),
        ),
    ),
)
