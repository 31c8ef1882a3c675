"""Claims of section 5.1, the cut of a sector in the recursion."""

from checks.claim import Check, Claim, Mutant

_SECTORS = "checks.verify.recursion_sectors:"
_DISK = "checks.verify.recursion_disk:"
_CERTIFIED = "theory.painleve (balls)"
_LAYOUT = "theory.amsler_disk (layout in H^2, float64)"
_RISE = r"(used, not stated) $\varphi$ does not decrease along the two axes"

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="fig:cutsketch",
        section="5.1",
        where="figure (fig:cutsketch), lines 1475-1493",
        kind="figure",
        statement=(
            "A cut from generation $n$ to $n + 1$: an $L$-shaped region along the axes, the "
            r"contours $z = z^*$ and $z = 2\sqrt{u_n^* v_n^*}$, and the circle $\partial\Omega$ "
            r"that meets the axes at $u_{\max}$ and $v_{\max}$."
        ),
        labels=("fig:cutsketch",),
        hypotheses=(
            "(used, not stated) the contours are those of an Amsler sector",
            "the sketch has no scale: tested are the incidences, on five sectors about the centre",
        ),
        rests_on=("5.1.cut-from-L-region",),
        checks=(
            Check(
                name="incidences",
                run=_DISK + "sketch",
                tier="full",
                routes=(_LAYOUT, "theory.painleve_float (contours)"),
                mutants=(
                    Mutant(name="u_n* 1 % farther out", given={"share": "101/100"}, near=True),
                    Mutant(name="node beyond half of z*", given={"lowered": "1/2"}),
                ),
            ),
        ),
    ),
    Claim(
        id="5.1.new-generation",
        section="5.1",
        where="section 5.1, line 1493",
        kind="sentence",
        statement=(
            r"A branch point of generation $n + 1$ is needed where the locus $\varphi(u, v) = "
            r"\phi^*$ meets the boundary of the domain."
        ),
        hypotheses=(
            r"$\phi^* < \pi$",
            (
                "(used, not stated) the locus meets the domain: in a sector that it enters it "
                "also meets the boundary"
            ),
            "Amsler sectors about the centre of the disk",
        ),
        rests_on=("PIII",),
        checks=(
            Check(
                name="contour and rim",
                run=_SECTORS + "contour_and_rim",
                routes=(
                    "distance of the contour: theory.painleve_reference (mpmath)",
                    "largest angle of the disk: theory.periodic_amsler (balls)",
                ),
                mutants=(
                    Mutant(name="contour 1 % farther", given={"stretched": "101/100"}, near=True),
                    Mutant(name="contour twice as far", given={"stretched": "2"}),
                ),
            ),
        ),
    ),
    Claim(
        id="5.1.cut-from-L-region",
        section="5.1",
        where="section 5.1, line 1493",
        kind="sentence",
        statement=(
            r"The place $(u_n^*, v_n^*)$ of the new branch point is determined by $\varphi \leq "
            r"\phi^*$ on $[0, u_{\max}] \times [0, v_n^*] \cup [0, u_n^*] \times [0, v_{\max}]$."
        ),
        hypotheses=(
            "(used, not stated) $u_n^*$ and $v_n^*$ are the largest with this property",
            (
                r"(read so) the region is $\Omega \cap \{u \leq u_n^* \text{ or } v \leq v_n^*\}$, "
                "as the algorithm of section 4.1 has it. With the lengths of the axes for "
                r"$u_{\max}$, $v_{\max}$ and whole rectangles the place is another: $\phi_n = "
                r"\pi/2$, $\phi^* = 3\pi/4$, $R = 3$: the line $u = u_n^*$ leaves the disk at $v > "
                r"3$, where $\varphi = 2.374 > 2.356$; the two places are 2 % apart"
            ),
        ),
        rests_on=("5.1.new-generation", "alg:greedy-cuts"),
        checks=(
            Check(
                name="strips of the domain",
                run=_DISK + "strip_of_disk",
                tier="full",
                routes=("intersection of the circle and the contour", _LAYOUT),
                mutants=(
                    Mutant(name="1 % farther out", given={"share": "101/100"}, near=True),
                    Mutant(
                        name="1 % nearer: not the largest", given={"share": "99/100"}, near=True
                    ),
                    Mutant(name="whole rectangles", given={"domain": "rectangles"}),
                ),
            ),
            Check(
                name="disk beyond the rectangle of its axes",
                run=_DISK + "beyond_the_rectangle",
                form="support",
                routes=(_CERTIFIED, "coordinates of the point"),
                mutants=(
                    Mutant(name="opening pi/3", given={"halves": 3}),
                    Mutant(name="u = 1.25", given={"along": "5/4"}, near=True),
                ),
            ),
        ),
    ),
    Claim(
        id="5.1.L-region-safe",
        section="5.1",
        where="section 5.1, line 1493",
        kind="sentence",
        statement=(
            r"On the $L$-shaped region the angle stays away from the singular edge: $\phi_n \leq "
            r"\varphi \leq \phi^* < \pi$."
        ),
        hypotheses=(r"$\phi^* < \pi$", _RISE),
        rests_on=("5.1.cut-from-L-region", "5.1.monotone"),
        checks=(
            Check(
                name="Amsler sectors",
                run=_SECTORS + "l_shaped_region",
                routes=("place of the contour: interval Newton", "angle at the corners: balls"),
                mutants=(
                    Mutant(name="region 1 % larger", given={"grown": "101/100"}, near=True),
                    Mutant(name="1.01 phi_n below", given={"least": "101/100"}, near=True),
                    Mutant(name="region twice as large", given={"grown": "2"}),
                ),
            ),
            Check(
                name="rising data",
                run=_SECTORS + "rises_inside",
                form="support",
                routes=("exact solutions (theory.kink)", "sine-Gordon equation"),
                mutants=(
                    Mutant(name="falling data", given={"data": "any"}),
                    Mutant(name="sigma = -1", given={"sign": -1}),
                ),
            ),
        ),
    ),
)
