"""Claims of section 5.1, the angle in the recursion: trisected, monotone, and its curvatures."""

from checks.claim import Check, Claim, Erratum, Mutant

_SECTORS = "checks.verify.recursion_sectors:"
_AMSLER = "checks.verify.amsler:"
_RISE = r"(used, not stated) $\varphi$ does not decrease along the two axes"

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="5.1.trisection",
        section="5.1",
        where="section 5.1, line 1495",
        kind="equation",
        statement=r"$\phi_{n+1} = \frac13\varphi(u_n^*, v_n^*)$.",
        hypotheses=("(used, not stated) the removed angle is trisected exactly",),
        rests_on=("eq:trisect", "5.1.cut-from-L-region"),
        checks=(
            Check(
                name="daughters",
                run=_SECTORS + "daughters",
                routes=("printed third", "alternating families (theory.daughter_sectors)"),
                mutants=(
                    Mutant(name="half", given={"divisor": "2"}),
                    Mutant(name="two daughters", given={"divisor": "2", "number": 2}),
                    Mutant(name="divisor 3.03", given={"divisor": "303/100"}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="5.1.monotone",
        section="5.1",
        where="section 5.1, line 1495",
        kind="sentence",
        statement=(
            r"$\varphi$ increases in $u$ and in $v$, because $\varphi_{uv} = \sin\varphi > 0$."
        ),
        hypotheses=(
            r"$0 < \varphi < \pi$",
            _RISE,
            r"(used, not stated) $\sigma = +1$ in the sector",
        ),
        rests_on=("eq:sg",),
        checks=(
            Check(
                name="as printed",
                run=_SECTORS + "monotone",
                routes=("exact solutions (theory.kink)", "sine-Gordon equation"),
                mutants=(
                    Mutant(name="sigma = -1", given={"sign": -1}),
                    Mutant(name="nearer to pi", given={"shift": 4}),
                ),
            ),
            Check(
                name="rising data",
                run=_SECTORS + "monotone",
                form="corrected",
                given={"data": "rising"},
                routes=("exact solutions (theory.kink)", "sine-Gordon equation"),
                mutants=(
                    Mutant(name="any data", given={"data": "any"}),
                    Mutant(name="sigma = -1", given={"data": "rising", "sign": -1}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=(r"$\varphi_{uv} = \sin\varphi > 0$, hence $\varphi$ increases in $u$ and $v$"),
            corrected=(
                r"$\varphi_{uv} = \sin\varphi > 0$, $\varphi_u(u, 0) \geq 0$ and $\varphi_v(0, v) "
                r"\geq 0$, hence $\varphi_u > 0$ for $v > 0$ and $\varphi_v > 0$ for $u > 0$"
            ),
            kind="hypothesis",
            witness=(
                r"$\varphi = 4\arctan\frac{e^{-(u + v)}}{8}$ solves $\varphi_{uv} = \sin\varphi$, "
                r"$0 < \varphi < \pi$ for $u, v \geq 0$, and falls in $u$ and in $v$"
            ),
            conclusion_survives=True,
            remark=(
                "The sectors of the algorithm meet the hypothesis: along a new axis, a geodesic, "
                r"$\varphi$ is constant, and along an axis taken from the parent its slope is the "
                "parent's (5.1.only-trisection-decreases)."
            ),
        ),
    ),
    Claim(
        id="5.1.only-trisection-decreases",
        section="5.1",
        where="section 5.1, line 1495",
        kind="sentence",
        statement=r"Nothing but the trisection at a branch point makes $\varphi$ smaller.",
        hypotheses=(
            "the sectors of the first generation are Amsler sectors, new axes are geodesics",
            (
                "(used, not stated) the number of daughters is odd, so that the daughters at the "
                "sides have the parent's orientation"
            ),
        ),
        rests_on=("5.1.monotone", "5.1.trisection"),
        checks=(
            Check(
                name="shared axes",
                run=_SECTORS + "shared_axes",
                part="along axes",
                routes=("Christoffel symbols of both nets", "families of the rays in turn"),
                mutants=(
                    Mutant(name="side daughters reversed", given={"reversed_side": True}),
                    Mutant(name="two daughters", given={"number": 2}),
                ),
            ),
            Check(
                name="inside sectors",
                run=_SECTORS + "rises_inside",
                part="inside",
                routes=("exact solutions (theory.kink)", "sine-Gordon equation"),
                mutants=(
                    Mutant(name="falling data", given={"data": "any"}),
                    Mutant(name="sigma = -1", given={"sign": -1}),
                ),
            ),
        ),
    ),
    Claim(
        id="ebound",
        section="5.1",
        where="equation (ebound), line 1497",
        kind="equation",
        statement=(
            r"$\mathcal{E}_\infty = \max_{n,k}\left(\cot\frac{\phi_{n,k}}{2}, "
            r"\tan\frac{\phi^*}{2}\right)$, with $\phi_{n,k}$ the angle at branch point $k$ of "
            "generation $n$."
        ),
        labels=("ebound",),
        hypotheses=(
            "net or surface made by the greedy algorithm",
            r"(used, not stated) the origin counts as generation $0$ with angle $\phi_0$",
            r"(used, not stated) $\varphi$ reaches $\phi^*$ somewhere: otherwise only $\leq$ holds",
            _RISE,
        ),
        rests_on=(
            "5.principal-curvatures",
            "5.1.monotone",
            "5.1.only-trisection-decreases",
            "alg:greedy-cuts",
        ),
        checks=(
            Check(
                name="as printed",
                run=_SECTORS + "energy_bound",
                routes=("printed maximum", "eigenvalues of II against I on disks without a cut"),
                mutants=(
                    Mutant(name="tan and cot exchanged", given={"exchanged": True}),
                    Mutant(name="phi* 1 % less", given={"share": "99/100"}, near=True),
                ),
            ),
            Check(
                name="phi reaches phi*",
                run=_SECTORS + "energy_bound",
                form="corrected",
                given={"level": "rim"},
                routes=("printed maximum", "eigenvalues of II against I, phi* the largest angle"),
                mutants=(
                    Mutant(name="tan and cot exchanged", given={"level": "rim", "exchanged": True}),
                    Mutant(
                        name="phi* 1 % less", given={"level": "rim", "share": "99/100"}, near=True
                    ),
                    Mutant(name="phi* out of reach", given={"level": "9/4"}),
                ),
            ),
            Check(
                name="an upper bound",
                run=_SECTORS + "energy_bound",
                form="corrected",
                given={"relation": "at most", "level": "11/5"},
                routes=("printed maximum", "eigenvalues of II against I on disks without a cut"),
                mutants=(
                    Mutant(
                        name="phi* 1 % less",
                        given={"relation": "at most", "level": "11/5", "share": "99/100"},
                        near=True,
                    ),
                    Mutant(name="equality", given={"relation": "equal", "level": "11/5"}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=(
                r"$\mathcal{E}_\infty = \max_{n,k}(\cot\frac{\phi_{n,k}}{2}, "
                r"\tan\frac{\phi^*}{2})$"
            ),
            corrected=(
                r"$\mathcal{E}_\infty \leq \max_{n,k}(\cot\frac{\phi_{n,k}}{2}, "
                r"\tan\frac{\phi^*}{2})$, with equality where $\varphi$ reaches $\phi^*$, as "
                "where there is a cut"
            ),
            kind="hypothesis",
            witness=(
                r"$R = 1$, six sectors, $\phi^* = 9/4$: no cut, $\mathcal{E}_\infty = "
                r"\cot\frac{\pi}{6} = 1.732$, while $\tan\frac{9}{8} = 2.093$"
            ),
            conclusion_survives=True,
        ),
    ),
    Claim(
        id="5.1.amsler-self-similar",
        section="5.1",
        where="section 5.1, line 1502",
        kind="sentence",
        statement=(
            r"In a sector bounded by geodesics $\varphi(u, v) = \varphi(2\sqrt{uv})$ with "
            r"$\varphi(z)$ a solution of (PIII)."
        ),
        hypotheses=(r"(used, not stated) $\varphi(0) = \phi_n$, $\varphi'(0) = 0$",),
        rests_on=("PIII", "def:amsler-sector"),
        checks=(
            Check(
                name="symmetry and series",
                run=_AMSLER + "self_similar",
                part="self-similar",
                routes=("double Taylor series by Picard iteration", "the scaling symmetry of z"),
                mutants=(
                    Mutant(name="u v^2 for u v", given={"power_v": 2}),
                    Mutant(name="u + v for u v", given={"combination": "sum"}),
                ),
            ),
            Check(
                name="chain rule",
                run=_AMSLER + "reduction",
                part="PIII",
                routes=("the printed equation", "chain rule on the sine-Gordon equation"),
                mutants=(
                    Mutant(name="2/z for 1/z", given={"damping": 2}),
                    Mutant(name="sign of the sine", given={"sine": 1}),
                ),
            ),
        ),
    ),
)
