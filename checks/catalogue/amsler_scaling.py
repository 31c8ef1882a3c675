"""Claims of section 5.1, the remark on the scaling of the recursion of Amsler sectors."""

from checks.claim import Check, Claim, Mutant

_SMALLEST = "checks.verify.recursion_smallest_angle:"
_SCALING = "checks.verify.recursion_scaling:"
_DISK = "checks.verify.recursion_disk:"
_BOUNDS = "checks.verify.amsler_lemma_range:"
_CERTIFIED = "theory.painleve (balls)"
_BESSEL = "theory.bessel (balls)"
_GROWTH = "theory.bessel_growth (balls on whole ranges)"

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="rem:amsler_scaling",
        section="5.1",
        where="remark (rem:amsler_scaling), displayed formula, line 1537",
        kind="remark",
        statement=(
            r"$\phi_{n+1} \geq \frac{\phi_n}{3} I_0\left(\frac{C(\phi^*)}{2\sqrt{u_{\max} "
            r"v_{\max}}} X^2\right) \geq \frac{\phi_n}{3} I_0\left(\frac{C(\phi^*)}{2R} "
            r"X^2\right)$ with $X = I_0^{-1}(\phi^*/\phi_n)$."
        ),
        labels=("rem:amsler_scaling",),
        hypotheses=(
            "Amsler sector",
            r"$u_{\max} \leq R$, $v_{\max} \leq R$",
            (
                r"there is a generation $n + 1$: $\phi_n < \phi^*$ and $\varphi$ reaches $\phi^*$, "
                r"so that $I_0^{-1}(\phi^*/\phi_n) \leq 2\sqrt{u_{\max} v_{\max}}$; dropped, the "
                "bound exceeds every angle"
            ),
            (
                "(used, not stated) the branch point sits where the lemma puts it, or farther "
                "out, as on the contour of $\\varphi$ itself"
            ),
        ),
        rests_on=("lem:amsler_recursion", "5.1.trisection"),
        checks=(
            Check(
                name="first inequality",
                run=_SCALING + "recursion_bound",
                part="first",
                routes=(_BESSEL, _CERTIFIED),
                mutants=(
                    Mutant(name="1/2 for 1/3", given={"daughters": "2"}),
                    Mutant(name="1/2.97 for 1/3", given={"daughters": "297/100"}, near=True),
                    Mutant(name="C 1 % larger", given={"scale": "10201/10000"}, near=True),
                    Mutant(name="1 for 2 in the argument", given={"factor": "1"}),
                    Mutant(name="every rectangle", given={"meets": False}),
                ),
            ),
            Check(
                name="from the lemma",
                run=_BOUNDS + "first_inequality",
                part="first",
                routes=("printed bound", "bound of the lemma and the trisection"),
                mutants=(
                    Mutant(name="1/2 for 1/3", given={"daughters": "2"}),
                    Mutant(
                        name="2.02 for 2 in the argument", given={"factor": "101/50"}, near=True
                    ),
                    Mutant(name="X for X^2", given={"power": 1}, near=True),
                ),
            ),
            Check(
                name="second inequality",
                run=_SCALING + "axes_for_radius",
                part="second",
                routes=("argument with sqrt(u_max v_max)", "argument with R"),
                mutants=(
                    Mutant(name="R/2 for R", given={"factor": "1"}),
                    Mutant(name="axes up to 2 R", given={"longest": "2"}),
                ),
            ),
            Check(
                name="geodesic disks",
                run=_DISK + "nodes_of_disks",
                tier="full",
                form="support",
                routes=("place of the lemma", "theory.amsler_disk (circle and contour, float64)"),
                mutants=(
                    Mutant(name="1/2 for 1/3", given={"daughters": "2"}),
                    Mutant(name="1/2.97 for 1/3", given={"daughters": "297/100"}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="5.1.axes-below-radius",
        section="5.1",
        where="remark (rem:amsler_scaling), line 1539",
        kind="sentence",
        statement=(
            r"The axes of an Amsler sector have lengths $u_{\max} \leq R$ and $v_{\max} \leq R$ "
            "inside the disk of radius $R$."
        ),
        hypotheses=(
            (
                "(used, not stated) the axes leave the branch point outward: their angle to the "
                r"direction away from the origin has a cosine of at least $-\tanh\frac{d}{2}/\tanh "
                "R$, $d$ the distance of the branch point from the origin, as every right or "
                "acute angle has; dropped, an axis through the origin has the length $R + d$"
            ),
        ),
        rests_on=("eq:hyp_radius",),
        checks=(
            Check(
                name="length of a ray",
                run=_SCALING + "axes_below_radius",
                routes=("geodesic of the hyperboloid", "circle about its centre"),
                mutants=(
                    Mutant(name="any direction", given={"cosine": "-1"}),
                    Mutant(name="cosine 1 % below", given={"share": "101/100"}, near=True),
                    Mutant(name="opposite sign", given={"share": "-1"}),
                ),
            ),
        ),
    ),
    Claim(
        id="5.1.small-angles-grow",
        section="5.1",
        where="remark (rem:amsler_scaling), line 1539",
        kind="sentence",
        statement=r"$\phi_{n+1}/\phi_n \geq 1$ when $\phi_n$ is small enough.",
        hypotheses=(
            "Amsler sector",
            (
                r"(used, not stated) small enough depends on $R$ and $\phi^*$: $\phi_n \leq "
                r"\phi^*/I_0(\sqrt{2 R x_0/C(\phi^*)})$, $I_0(x_0) = 3$"
            ),
            (
                r"there is a generation $n + 1$, $I_0^{-1}(\phi^*/\phi_n) \leq 2R$: none is so "
                r"small if $R < x_0/(2C(\phi^*))$"
            ),
        ),
        rests_on=("rem:amsler_scaling",),
        checks=(
            Check(
                name="bound of the remark",
                run=_SCALING + "growth_of_small_angles",
                routes=("printed bound", "I_0^{-1}(3) by interval Newton"),
                mutants=(
                    Mutant(name="x_0 1 % less", given={"share": "99/100"}, near=True),
                    Mutant(name="1/3.03 for 1/3", given={"daughters": "303/100"}, near=True),
                    Mutant(name="4 R for 2 R", given={"factor": "4"}),
                ),
            ),
            Check(
                name="angles themselves",
                run=_SCALING + "growth_of_angles",
                routes=(_BESSEL, _CERTIFIED),
                mutants=(
                    Mutant(name="1/3.03 for 1/3", given={"daughters": "303/100"}, near=True),
                    Mutant(name="1/9 for 1/3", given={"daughters": "9"}),
                    Mutant(name="phi_n 20 times as large", given={"larger": "20"}),
                ),
            ),
        ),
    ),
    Claim(
        id="5.1.smallest-angle-amsler",
        section="5.1",
        where="remark (rem:amsler_scaling), line 1539",
        kind="remark",
        statement=(
            r"With a constant $C'(\phi^*)$ independent of $R$ and $\phi_{\min} = "
            r"\phi^*/I_0(C'(\phi^*)\sqrt{R})$: if $\phi_0 \geq \phi_{\min}$ then $\phi_n \geq "
            r"\phi_{\min}$ for all $n$."
        ),
        hypotheses=(
            "every sector is an Amsler sector, its axes no longer than $R$",
            (
                r"(used, not stated) $R \geq R_0$: tested with $C' = \sqrt{2x_0/C(\phi^*)}$, "
                r"$I_0(x_0) = 3$, for $R \geq 4C(\phi^*)$, and $R \geq 4$ is enough for every "
                r"$\phi^*$. For smaller $R$ a larger $C'$ serves down to any $R_0 > 0$: $I_0(C'"
                r"\sqrt{R_0}) \geq 3I_0(8C)$ is enough, as $I_0^{-1}(\phi^*/\phi_n) \leq 2R$ "
                "wherever there is a cut"
            ),
            (
                r"(used, not stated) $\phi_0 = \pi/m$, as in the algorithm, if $R$ is to be "
                r"arbitrary: $\phi_0$ then stays away from $\phi^*$ and small disks have no cut. "
                r"For $\phi_0$ arbitrarily near $\phi^*$ none serves: $R = C'^{-2}$ has "
                r"$\phi_{\min} = 0.79\phi^*$, but $\phi_1 \leq \phi^*/3$"
            ),
        ),
        rests_on=("rem:amsler_scaling", "5.1.small-angles-grow"),
        checks=(
            Check(
                name="R >= 4 C",
                run=_SMALLEST + "smallest_angle",
                routes=("bound of the remark", _GROWTH),
                mutants=(
                    Mutant(name="C' 1 % less", given={"scale": "99/100"}, near=True),
                    Mutant(name="C' 10 % less", given={"scale": "9/10"}),
                    Mutant(name="R >= 3.5 C", given={"quotient": "7/2"}, near=True),
                    Mutant(name="R >= C", given={"quotient": "1"}),
                    Mutant(name="every R > 0, any phi_0", given={"quotient": "0"}),
                    Mutant(name="R for 2 R in the bound", given={"factor": "1"}),
                    Mutant(name="2.02 R in the bound", given={"factor": "101/50"}, near=True),
                ),
            ),
            Check(
                name="a third of it for every R",
                run=_SMALLEST + "smallest_angle",
                form="support",
                given={"divisor": "3"},
                routes=("bound of the remark", _GROWTH),
                mutants=(
                    Mutant(name="divisor 2.97", given={"divisor": "297/100"}, near=True),
                    Mutant(name="divisor 2", given={"divisor": "2"}),
                    Mutant(name="C' 10 % less", given={"divisor": "3", "scale": "9/10"}),
                ),
            ),
            Check(
                name="down to any R_0 > 0",
                run=_SMALLEST + "down_to_radius",
                form="support",
                routes=("printed phi_min", "third of the least phi_n that is cut"),
                mutants=(
                    Mutant(name="2.97 I_0(8 C)", given={"times": "297/100"}, near=True),
                    Mutant(name="I_0(8 C)", given={"times": "1"}),
                ),
            ),
            Check(
                name="larger R",
                run=_SMALLEST + "growth_rate",
                form="support",
                routes=("derivative of x I_1/I_0", "sign by I_1 < I_0"),
                mutants=(
                    Mutant(name="1.01 (I_1/I_0)^2", given={"share": "101/100"}, near=True),
                    Mutant(name="opposite sign", given={"share": "-1"}),
                ),
            ),
            Check(
                name="rate of the quotient",
                run=_SMALLEST + "rate_of_quotient",
                form="support",
                routes=("derivative of the printed bound by I_0' = I_1", _GROWTH),
                mutants=(
                    Mutant(name="rate 1 % larger", given={"share": "101/100"}, near=True),
                    Mutant(name="R for 2 R in the bound", given={"factor": "1"}),
                ),
            ),
            Check(
                name="twelve generations",
                run=_SMALLEST + "recursion_run",
                tier="full",
                form="support",
                routes=("phi_min with C' = sqrt(2 x_0/C)", _CERTIFIED),
                mutants=(
                    Mutant(name="C' 1 % less", given={"scale": "99/100"}, near=True),
                    Mutant(name="half of C'", given={"scale": "1/2"}),
                    Mutant(name="a quarter of C'", given={"scale": "1/4"}),
                ),
            ),
        ),
    ),
    Claim(
        id="5.1.cutoff-dependence",
        section="5.1",
        where="remark (rem:amsler_scaling), line 1539",
        kind="sentence",
        statement=(
            r"For $\phi^*$ in a compact subset of $(0, \pi)$ the constants can be chosen "
            r"independent of $\phi^*$."
        ),
        hypotheses=(
            r"not on all of $(0, \pi)$: $C(\phi^*)$ tends to $0$ as $\phi^*$ tends to $\pi$",
            r"(used, not stated) a larger $C'$ serves as well",
        ),
        rests_on=("5.1.smallest-angle-amsler", "eq:defC"),
        checks=(
            Check(
                name="monotone constant",
                run="checks.verify.recursion_angle:sine_quotient",
                part="C",
                routes=("derivative of sin t/t", "signs by the tangent of the half-angle"),
                mutants=(
                    Mutant(name="C^2 1 % larger", given={"scale": "101/100"}, near=True),
                    Mutant(name="no root", given={"root": False}),
                ),
            ),
            Check(
                name="constants on [1/100, 3]",
                run=_SMALLEST + "cutoff_dependence",
                part="C' and phi_min",
                routes=("constants for phi* = 3", "constants for each phi*"),
                mutants=(
                    Mutant(name="phi* = 3.03", given={"levels": "303/100"}, near=True),
                    Mutant(name="phi* = 3.14", given={"levels": "157/50"}),
                    Mutant(name="phi* = 1/1000", given={"levels": "1/1000"}),
                ),
            ),
        ),
    ),
)
