"""Claims of section 3.1, Minding's bobbin: its orbits and turning points."""

from checks.claim import Check, Claim, Mutant

_ORBIT = "checks.verify.bobbin_orbit:"
_TURNING = "checks.verify.bobbin_turning:"
_FLOW = "theory.bobbin:bobbin_flow"
_KAPPA = r"$\kappa>0$"
_ORBIT_HYPOTHESIS = (
    r"(used, not stated) $s(\xi)$ is not constant and is $C^2$, that is, it obeys $s''=-V'(s)$"
)
_PARTICLE = (
    r"the unit mass obeys Newton's law $s''=-V'(s)$; (eq:econs) alone allows it to rest at "
    r"$s=\pm L$ as well"
)

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="3.1.bobbin-energy-conservation",
        section="3.1",
        where="after the proof of the Lemma, line 417",
        kind="sentence",
        statement=r"With $\xi$ as time and $V(s)=\frac1{2(\kappa^2+1)}\cosh^2s$, (eq:econs) says "
        r"that a unit mass has the energy $\frac12$.",
        hypotheses=(_KAPPA,),
        rests_on=("eq:econs",),
        checks=(
            Check(
                name="energy and motion",
                run=_ORBIT + "conservation",
                routes=("printed potential", "printed energy equation", _FLOW),
                mutants=(Mutant(name="twice the potential", given={"factor": "1"}),),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-periodic-orbits",
        section="3.1",
        where="after the proof of the Lemma, line 417",
        kind="sentence",
        statement=r"The orbits $s(\xi)$ of the unit mass with this energy are bounded and "
        r"periodic.",
        hypotheses=(_KAPPA, _PARTICLE),
        rests_on=("eq:econs", "3.1.bobbin-energy-conservation"),
        checks=(
            Check(
                name="orbits of the unit mass",
                run=_ORBIT + "orbits",
                routes=("printed energy equation", _FLOW),
                mutants=(
                    Mutant(name="energy only", given={"law": "energy"}),
                    Mutant(name="potential reversed", given={"sign": -1}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-turning-points",
        section="3.1",
        where="after the proof of the Lemma, line 417",
        kind="sentence",
        statement=r"$s'=0$ exactly where $s=\pm L$.",
        hypotheses=(_KAPPA, r"$s$ solves (eq:econs)"),
        rests_on=("eq:econs", "3.1.bobbin-singular-edge"),
        checks=(
            Check(
                name="zeros of s'^2",
                run=_ORBIT + "turning_at_edge",
                routes=("printed energy equation", "theory.bobbin:half_length"),
                mutants=(Mutant(name="kappa^2 + 2", given={"shift": 2}),),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-turning-force",
        section="3.1",
        where="after the proof of the Lemma, line 417",
        kind="sentence",
        statement=r"Where the mass turns, $s'=0$ and $s''=-V'(s)\neq0$.",
        hypotheses=(_KAPPA, _PARTICLE),
        rests_on=("3.1.bobbin-turning-points", "3.1.bobbin-energy-conservation"),
        checks=(
            Check(
                name="orbits of the unit mass",
                run=_ORBIT + "turning_force",
                routes=("printed potential", _FLOW),
                mutants=(
                    Mutant(name="energy only", given={"law": "energy"}),
                    Mutant(name="twice the potential", given={"factor": "1"}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-global-solutions",
        section="3.1",
        where="after the proof of the Lemma, line 417",
        kind="sentence",
        statement=r"The solutions $s(u+v)$ exist for all $(u,v)\in\mathbb R^2$.",
        hypotheses=(_KAPPA, r"solutions of (eq:econs), continued as far as they can be"),
        rests_on=("eq:econs",),
        checks=(
            Check(
                name="bounds on s and s'",
                run=_ORBIT + "global_solutions",
                routes=("printed energy equation", "bounds by positive coefficients"),
                mutants=(Mutant(name="potential reversed", given={"sign": -1}),),
            ),
        ),
    ),
    Claim(
        id="eq:zprime",
        section="3.1",
        where="equation (eq:zprime), line 420",
        kind="equation",
        labels=("eq:zprime",),
        statement=r"$\bigl(\frac{dz}{d\xi}\bigr)^2=\bigl(1-\frac{\sinh^2s}{\kappa^2}\bigr)"
        r"\bigl(\frac{ds}{d\xi}\bigr)^2=\frac{(\kappa^2-\sinh^2s)^2}{\kappa^2(\kappa^2+1)}$.",
        hypotheses=(_KAPPA, r"$ds^2=d\rho^2+dz^2$"),
        rests_on=("eq:econs", "ex:bobbin"),
        checks=(
            Check(
                name="both equalities",
                run=_TURNING + "height_rate",
                routes=("printed expressions", _FLOW),
                mutants=(Mutant(name="not squared", given={"power": 1}),),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-zprime-vanishing",
        section="3.1",
        where="after equation (eq:zprime), line 423",
        kind="sentence",
        statement=r"The right side of (eq:zprime) vanishes to the second order in $L^2-s^2$, so "
        r"$z'=z''=0$ at turning points.",
        hypotheses=(_KAPPA,),
        rests_on=("eq:zprime", "3.1.bobbin-turning-points"),
        checks=(
            Check(
                name="order",
                run=_TURNING + "vanishing_order",
                routes=("printed right side", _FLOW),
                mutants=(
                    Mutant(name="order 1", given={"order": 1}),
                    Mutant(name="order 3", given={"order": 3}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-zprime-root",
        section="3.1",
        where="after equation (eq:zprime), line 423",
        kind="sentence",
        statement=r"The square root can be taken with $z'(\xi)\ge0$ for all $\xi$.",
        hypotheses=(_KAPPA,),
        rests_on=("eq:zprime",),
        checks=(
            Check(
                name="smooth root",
                run=_TURNING + "rising",
                routes=("printed right side", _FLOW),
                mutants=(Mutant(name="sign of s'", given={"root": "sgn s'"}),),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-turning-expansion",
        section="3.1",
        where="display after equation (eq:zprime), line 425",
        kind="equation",
        statement=r"Near a turning point $\rho=\rho_c-c_1(\xi-\xi_c)^2+O((\xi-\xi_c)^3)$ and "
        r"$z=z_c+c_2(\xi-\xi_c)^3+O((\xi-\xi_c)^4)$ with $\rho_c=\kappa^{-1}\sqrt{\kappa^2+1}$ "
        r"and $c_1,c_2>0$; in fact $c_1=\frac\kappa{2\sqrt{\kappa^2+1}}$, "
        r"$c_2=\frac\kappa{3\sqrt{\kappa^2+1}}$ and the errors are $O(4)$, $O(5)$.",
        hypotheses=(_KAPPA, _ORBIT_HYPOTHESIS),
        rests_on=("3.1.bobbin-zprime-vanishing", "3.1.bobbin-turning-force"),
        checks=(
            Check(
                name="derivatives",
                run=_TURNING + "expansions",
                routes=("printed orders and radius", _FLOW),
                mutants=(
                    Mutant(name="rho to order 3", given={"radius": 3}),
                    Mutant(name="z to order 2", given={"height": 2}),
                    Mutant(name="z to order 4", given={"height": 4}),
                    Mutant(name="kappa^2 + 2", given={"radius_shift": 2}),
                ),
            ),
        ),
    ),
)
