"""Claims of section 4.1, the dual of the greedy algorithm: the comparison principle, item 5."""

from checks.claim import Check, Claim, Erratum, Mutant

_COMPARISON = "checks.verify.greedy_dual_comparison:"
_MONOTONE = "checks.verify.greedy_dual_monotone:"

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="4.1.dual-5-comparison",
        section="4.1",
        where="section 4.1, dual interpretation, item (5), line 1414",
        kind="proposition",
        statement=(
            r"Let $\varphi_1, \varphi_2$ solve $\partial_{uv}\varphi = \sin\varphi$ on $J = [0, "
            r"u_0] \times [0, v_0]$ with $\varphi_1(u, 0) \leq \varphi_2(u, 0)$ and "
            r"$\varphi_1(0, v) \leq \varphi_2(0, v)$. Then $\varphi_1 \leq \varphi_2$ on $J$."
        ),
        hypotheses=(
            r"$0 < \varphi_i < \pi/2$ on $J$, $i = 1, 2$",
            r"$0 \leq u \leq u_0$, $0 \leq v \leq v_0$ in the two inequalities",
            (
                r"(used, not stated) the difference $\varphi_2(u, 0) + \varphi_2(0, v) - "
                r"\varphi_2(0, 0)$ minus the same for $\varphi_1$ is not negative on $J$: for "
                "example both differences on the axes increase from the corner"
            ),
        ),
        rests_on=("eq:hazzidakis",),
        checks=(
            Check(
                name="as printed",
                run=_COMPARISON + "linear_data",
                routes=("ordered data on the axes", "series of the difference, exact bound"),
                mutants=(
                    Mutant(name="up to 1 % of the corner", given={"allowance": "1/100"}, near=True),
                    Mutant(name="up to half of the corner", given={"allowance": "1/2"}),
                ),
            ),
            Check(
                name="ordered mixed sums",
                run=_COMPARISON + "linear_data",
                form="corrected",
                given={"needs": "mixed sum"},
                routes=("mixed sum of the data", "series of the difference, exact bound"),
                mutants=(
                    Mutant(name="as printed", given={"needs": "axes"}),
                    Mutant(name="but for 1 %", given={"slack": "1/100"}, near=True),
                ),
            ),
            Check(
                name="proof",
                run=_COMPARISON + "kernel",
                form="corrected",
                part="proof",
                given={"limit": "1/2"},
                routes=("rate by mean and difference", "sin phi_2 - sin phi_1"),
                mutants=(
                    Mutant(name="phi < 0.505 pi", given={"limit": "101/200"}, near=True),
                    Mutant(name="phi < pi", given={"limit": "1"}),
                ),
            ),
            Check(
                name="random data",
                run=_COMPARISON + "solved",
                form="support",
                routes=("mixed sum of the data", "theory.goursat_float:sine_gordon"),
                mutants=(
                    Mutant(name="ordered axes", given={"needs": "axes"}),
                    Mutant(name="but for 1 %", given={"slack": "1/100"}, near=True),
                ),
            ),
        ),
        erratum=Erratum(
            printed=(
                r"$\varphi_1(u, 0) \leq \varphi_2(u, 0)$ and $\varphi_1(0, v) \leq "
                r"\varphi_2(0, v)$ "
                r"give $\varphi_1 \leq \varphi_2$"
            ),
            corrected=(
                r"$w(u, 0) + w(0, v) - w(0, 0) \geq 0$ on $J$ for $w = \varphi_2 - \varphi_1$ "
                "gives "
                "it, and nothing less does on small rectangles"
            ),
            kind="hypothesis",
            witness=(
                r"$u_0 = v_0 = \frac{1}{10}$, $\varphi_1 = 1$ on both axes, $\varphi_2(u, 0) = 1 + "
                r"\frac{1}{10}(1 - 10u)$, $\varphi_2(0, v) = 1 + \frac{1}{10}(1 - 10v)$: at "
                "the far "
                r"corner $\varphi_2 - \varphi_1 \leq -\frac{1}{10} + \frac{1}{990} < -0.098$"
            ),
            conclusion_survives=True,
            remark=(
                "The dual compares data that are constant on one axis and increase on the other, "
                "where the corrected form applies (4.1.dual-5-monotone)."
            ),
        ),
    ),
    Claim(
        id="4.1.dual-5-monotone",
        section="4.1",
        where="section 4.1, dual interpretation, item (5), line 1414",
        kind="sentence",
        statement=(
            "By the comparison principle the dual process is monotone: moving a branch point "
            r"outward does not decrease $\varphi$ in the sectors that it changes."
        ),
        hypotheses=(
            r"$\phi^* \leq \pi/2$",
            (
                "(used, not stated) the data on the axes before and after are ordered as the "
                "comparison principle needs"
            ),
        ),
        rests_on=("4.1.dual-5-comparison", "4.1.dual-3-stage"),
        checks=(
            Check(
                name="data of the daughters",
                run=_MONOTONE + "ordered_data",
                routes=("rates of the data in the place of the cut", "phi_uv = sin phi, convexity"),
                mutants=(
                    Mutant(name="phi < 0.505 pi", given={"limit": "101/200"}, near=True),
                    Mutant(name="lines turn the other way", given={"carried": "-1"}),
                    Mutant(name="lines turn 1 % less", given={"carried": "99/100"}, near=True),
                ),
            ),
            Check(
                name="moved cuts",
                run=_MONOTONE + "outward",
                routes=("sectors before the move", "sectors after it"),
                mutants=(
                    Mutant(name="inward", given={"direction": -1}),
                    Mutant(name="1 % less at the corner", given={"parts": "303/100"}, near=True),
                ),
            ),
        ),
    ),
)
