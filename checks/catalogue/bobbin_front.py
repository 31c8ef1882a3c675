"""Claims of section 3.1, Minding's bobbin: the front, its normals and Lelieuvre equations."""

from checks.claim import Check, Claim, Erratum, Mutant

_TURNING = "checks.verify.bobbin_turning:"
_FRONT = "checks.verify.bobbin_front:"
_FLOW = "theory.bobbin:bobbin_flow"
_LINES = "theory.pseudospherical_revolution:asymptotic_tangents"
_KAPPA = r"$\kappa>0$"
_MOVING = r"$s'\neq0$"
_ORBIT_HYPOTHESIS = (
    r"(used, not stated) $s(\xi)$ is not constant and is $C^2$, that is, it obeys $s''=-V'(s)$"
)
_EXCHANGE = (
    r"With $\theta=\kappa(u-v)/\sqrt{\kappa^2+1}$ and $z'\ge0$ the $u$-curves have torsion $+1$ "
    r"and the $v$-curves $-1$, against item (B); exchanging $u$ and $v$ here mends (eq:NFront), "
    r"the direction of the normal and the Lelieuvre equations at once."
)

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="eq:bobbin_psfront",
        section="3.1",
        where="equation (eq:bobbin_psfront), line 431",
        kind="equation",
        labels=("eq:bobbin_psfront",),
        statement=r"$r(u,v)=(\rho\cos\theta,\rho\sin\theta,z)$ with $\rho,z$ at $u+v$ and "
        r"$\theta=\kappa(u-v)/\sqrt{\kappa^2+1}$ is the bobbin in asymptotic coordinates of unit "
        r"speed, with torsions $-1$ along $u$ and $+1$ along $v$.",
        hypotheses=(_KAPPA, r"$z'\ge0$", _ORBIT_HYPOTHESIS, r"item (B): the torsions' signs"),
        rests_on=("3.1.bobbin-alpha", "3.1.bobbin-zprime-root", "eq:econs"),
        checks=(
            Check(
                name="surface",
                tier="full",
                run=_FRONT + "front_surface",
                part="surface",
                routes=("printed map", "theory.pseudospherical_revolution:meridian_normal"),
                mutants=(
                    Mutant(name="kappa^2 + 2", given={"shift": 2}),
                    Mutant(name="speed squared 2", given={"speed": 2}),
                ),
            ),
            Check(
                name="surface, u and v exchanged",
                tier="full",
                run=_FRONT + "front_surface",
                form="corrected",
                given={"sense": -1},
                part="surface",
                routes=("corrected map", "theory.pseudospherical_revolution:meridian_normal"),
                mutants=(Mutant(name="kappa^2 + 2", given={"shift": 2}),),
            ),
            Check(
                name="torsions",
                tier="full",
                run=_FRONT + "front_torsions",
                part="torsions",
                routes=("printed map", "theory.pseudospherical_revolution:torsion"),
                mutants=(Mutant(name="torsion -2", given={"first": -2}),),
            ),
            Check(
                name="torsions, u and v exchanged",
                tier="full",
                run=_FRONT + "front_torsions",
                form="corrected",
                given={"sense": -1},
                part="torsions",
                routes=("corrected map", "theory.pseudospherical_revolution:torsion"),
                mutants=(
                    Mutant(name="printed sense", given={"sense": 1}),
                    Mutant(name="torsions exchanged", given={"first": 1}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"$\cos\left(\frac{\kappa(u-v)}{\sqrt{\kappa^2+1}}\right)$, "
            r"$\sin\left(\frac{\kappa(u-v)}{\sqrt{\kappa^2+1}}\right)$",
            corrected=r"$\cos\left(\frac{\kappa(v-u)}{\sqrt{\kappa^2+1}}\right)$, "
            r"$\sin\left(\frac{\kappa(v-u)}{\sqrt{\kappa^2+1}}\right)$",
            kind="misprint",
            witness=r"Throat, $s'>0$, $\theta=0$, $\kappa=1$: $r_u=(0,1,1)/\sqrt2$, $N=-e_1$, "
            r"$N_u=(0,-1,1)/\sqrt2=-N\times r_u$: torsion $+1$ along $u$ (for $-1$ it would be "
            r"$+N\times r_u$, item (C)).",
            conclusion_survives=True,
            remark=_EXCHANGE,
        ),
    ),
    Claim(
        id="3.1.bobbin-not-immersed",
        section="3.1",
        where="after equation (eq:bobbin_psfront), line 434",
        kind="sentence",
        statement=r"$r$ has rank 1 on the circles $u+v=\xi_c$, and rank 2 elsewhere.",
        hypotheses=(_KAPPA,),
        rests_on=("eq:bobbin_psfront", "3.1.bobbin-turning-points"),
        checks=(
            Check(
                name="area element",
                run=_FRONT + "not_immersed",
                routes=("printed map", _FLOW),
                mutants=(Mutant(name="at the throat", given={"at": "throat"}),),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-cuspidal",
        section="3.1",
        where="after equation (eq:bobbin_psfront), line 434",
        kind="sentence",
        statement=r"The singularities on $u+v=\xi_c$ are cuspidal: the meridian $(\rho,z)(\xi)$ "
        r"has an ordinary cusp there.",
        hypotheses=(_KAPPA,),
        rests_on=("3.1.bobbin-not-immersed", "3.1.bobbin-turning-expansion"),
        checks=(
            Check(
                name="ordinary cusp",
                run=_TURNING + "cusp",
                routes=("cusp criterion", _FLOW),
                mutants=(
                    Mutant(name="at the throat", given={"at": "throat"}),
                    Mutant(name="orders 2, 4", given={"third": 4}),
                ),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-smooth-asymptotic-curves",
        section="3.1",
        where="after equation (eq:bobbin_psfront), line 434",
        kind="sentence",
        statement=r"The curves $u\mapsto r(u,v_0)$ and $v\mapsto r(u_0,v)$ are smooth and of unit "
        r"speed, also across the edges.",
        hypotheses=(_KAPPA, _ORBIT_HYPOTHESIS),
        rests_on=("eq:bobbin_psfront",),
        checks=(
            Check(
                name="speed",
                run=_FRONT + "smooth_curves",
                routes=("printed map", _FLOW),
                mutants=(Mutant(name="speed squared 2", given={"speed": 2}),),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-normal-direction",
        section="3.1",
        where="display before equation (eq:NFront), line 438",
        kind="equation",
        statement=r"$r_u\times r_v$ is a positive multiple of $s'\bigl(-\frac{dz}{ds}\cos\theta,"
        r"-\frac{dz}{ds}\sin\theta,\kappa^{-1}\sinh s\bigr)$.",
        hypotheses=(_KAPPA, _MOVING, r"$\theta=\kappa(u-v)/\sqrt{\kappa^2+1}$"),
        rests_on=("eq:bobbin_psfront",),
        checks=(
            Check(
                name="printed",
                run=_FRONT + "normal_direction",
                routes=("printed vector", "cross product on the printed map"),
                mutants=(Mutant(name="height reversed", given={"height": -1}),),
            ),
            Check(
                name="u and v exchanged",
                run=_FRONT + "normal_direction",
                form="corrected",
                given={"sense": -1},
                routes=("printed vector", "cross product on the corrected map"),
                mutants=(
                    Mutant(name="printed sense", given={"sense": 1}),
                    Mutant(name="height reversed", given={"height": -1}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"$N(u,v)\propto s'\left(-\frac{dz}{ds}\cos\theta,-\frac{dz}{ds}\sin\theta,"
            r"\frac{\sinh s}\kappa\right)$ with a positive factor",
            corrected=r"the same with $\theta=\kappa(v-u)/\sqrt{\kappa^2+1}$, the constant being "
            r"$2\alpha\rho$; with the printed $\theta$ it is $-2\alpha\rho$",
            kind="misprint",
            witness=r"Throat, $s'>0$, $\theta=0$, $\kappa=1$: $r_u=(0,1,1)/\sqrt2$, "
            r"$r_v=(0,-1,1)/\sqrt2$, $r_u\times r_v=(1,0,0)$; the printed vector is "
            r"$\frac1{\sqrt2}(-1,0,0)$.",
            conclusion_survives=True,
            remark=_EXCHANGE,
        ),
    ),
    Claim(
        id="3.1.bobbin-normal-flips",
        section="3.1",
        where="before equation (eq:NFront), line 440",
        kind="sentence",
        statement=r"$\frac{dz}{ds}=0$ at turning points, and the unit vector along $r_u\times r_v$ "
        r"jumps between $\pm\mathbf e_3$ at each of them.",
        hypotheses=(_KAPPA, _ORBIT_HYPOTHESIS),
        rests_on=("3.1.bobbin-normal-direction",),
        checks=(
            Check(
                name="one-sided limits",
                run=_FRONT + "flips",
                routes=(_LINES, "limits on the four quarter periods"),
                mutants=(Mutant(name="times sgn s'", given={"factor": "sgn s'"}),),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-normal-continuous",
        section="3.1",
        where="before equation (eq:NFront), line 440",
        kind="sentence",
        statement=r"$N^\omega=\sigma\,r_u\times r_v/\|r_u\times r_v\|$ with "
        r"$\sigma=\operatorname{sgn}s'$ extends to a $C^{1M}$ map, in fact an analytic one.",
        hypotheses=(_KAPPA, _ORBIT_HYPOTHESIS),
        rests_on=("3.1.bobbin-normal-flips", "eq:Nfront"),
        checks=(
            Check(
                name="one map on all quarters",
                tier="full",
                run=_FRONT + "continuous_normal",
                routes=(_LINES, "theory.pseudospherical_revolution:meridian_normal"),
                mutants=(Mutant(name="without sigma", given={"factor": "1"}),),
            ),
        ),
    ),
    Claim(
        id="3.1.bobbin-slope-sign",
        section="3.1",
        where="before equation (eq:NFront), line 442",
        kind="sentence",
        statement=r"$\frac{dz}{ds}=\sigma\bigl|\frac{dz}{ds}\bigr|$ with "
        r"$\sigma=\operatorname{sgn}s'$, and $\bigl|\frac{dz}{ds}\bigr|=\sqrt{1-N_z^2}$.",
        hypotheses=(_KAPPA, r"$z'\ge0$", _MOVING),
        rests_on=("3.1.bobbin-zprime-root", "eq:econs"),
        checks=(
            Check(
                name="four quarters",
                run=_FRONT + "slope_sign",
                routes=("printed sign", _FLOW),
                mutants=(Mutant(name="without sigma", given={"factor": "1"}),),
            ),
        ),
    ),
    Claim(
        id="eq:NFront",
        section="3.1",
        where="equation (eq:NFront), line 444",
        kind="equation",
        labels=("eq:NFront",),
        statement=r"$N_z=\kappa^{-1}\sinh s$ and $N^\omega=\bigl(-\sigma\sqrt{1-N_z^2}\cos\theta,"
        r"-\sigma\sqrt{1-N_z^2}\sin\theta,N_z\bigr)$, $\theta=\kappa(\kappa^2+1)^{-1/2}(u-v)$.",
        hypotheses=(_KAPPA, r"$\sigma=\operatorname{sgn}s'$", r"$r$ is (eq:bobbin_psfront)"),
        rests_on=("3.1.bobbin-normal-continuous", "3.1.bobbin-slope-sign"),
        checks=(
            Check(
                name="printed",
                run=_FRONT + "front_normal",
                routes=("printed normal", "cross product on the printed map"),
                mutants=(Mutant(name="outward", given={"radial": 1}),),
            ),
            Check(
                name="u and v exchanged",
                tier="full",
                run=_FRONT + "front_normal",
                form="corrected",
                given={"sense": -1},
                routes=("corrected normal", "cross product on the corrected map"),
                mutants=(
                    Mutant(name="printed sense", given={"sense": 1}),
                    Mutant(name="outward", given={"radial": 1}),
                    Mutant(name="fourth power", given={"power": 4}),
                    Mutant(name="tanh", given={"function": "tanh"}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"$\theta=\kappa(\kappa^2+1)^{-1/2}(u-v)$",
            corrected=r"$\theta=\kappa(\kappa^2+1)^{-1/2}(v-u)$, here and in (eq:bobbin_psfront)",
            kind="misprint",
            witness=r"Throat, $\sigma=1$, $\theta=0$, $\kappa=1$: $\sigma r_u\times "
            r"r_v=(1,0,0)$, the printed $N^\omega$ is $(-1,0,0)$.",
            conclusion_survives=True,
            remark=_EXCHANGE,
        ),
    ),
    Claim(
        id="3.1.bobbin-lelieuvre",
        section="3.1",
        where="after equation (eq:NFront), line 448",
        kind="sentence",
        statement=r"(eq:NFront) and (eq:bobbin_psfront) satisfy the Lelieuvre equations "
        r"$r_u=N_u\times N$, $r_v=-N_v\times N$.",
        hypotheses=(_KAPPA, r"$\sigma=\operatorname{sgn}s'$"),
        rests_on=("eq:NFront", "eq:bobbin_psfront", "eq:lelieuvre"),
        checks=(
            Check(
                name="printed",
                run=_FRONT + "lelieuvre",
                routes=("printed map", "printed normal"),
                mutants=(Mutant(name="outward", given={"radial": 1}),),
            ),
            Check(
                name="u and v exchanged",
                tier="full",
                run=_FRONT + "lelieuvre",
                form="corrected",
                given={"sense": -1},
                routes=("corrected map", "corrected normal"),
                mutants=(
                    Mutant(name="printed sense", given={"sense": 1}),
                    Mutant(name="outward", given={"radial": 1}),
                    Mutant(name="u and v exchanged again", given={"orientation": -1}),
                ),
            ),
        ),
        erratum=Erratum(
            printed=r"Lelieuvre equations for $N^\omega$ (eq:NFront) and $r$ (eq:bobbin_psfront)",
            corrected=r"it does once $\theta=\kappa(v-u)/\sqrt{\kappa^2+1}$ in both; as printed "
            r"$r_u=-N_u\times N$ and $r_v=N_v\times N$",
            kind="false",
            witness=r"Throat, $s'>0$, $\theta=0$, $\kappa=1$: $r_u=(0,1,1)/\sqrt2$, "
            r"$N=(-1,0,0)$, $N_u=(0,-1,1)/\sqrt2$, $N_u\times N=(0,-1,-1)/\sqrt2=-r_u$.",
            conclusion_survives=True,
            remark=_EXCHANGE + r" Replacing $N$ by $-N$ changes nothing.",
        ),
    ),
)
