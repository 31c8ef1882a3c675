"""Claims of section 3.4 on the three sectors that surgery inserts."""

from checks.claim import Claim

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
        hypotheses=(
            r"(used, not stated) $\|\mathbf t_u\| = \|\mathbf t_v\| = 1$",
            r"(used, not stated) $\mathbf t_u$ and $\mathbf t_v$ are not parallel",
        ),
        rests_on=(
            "3.4.data-at-the-point",
            "amsler-frame",
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
                r"(used, not stated) the angle is not near $\pi$: the error relative to a third of "
                r"the angle $\theta$ is $O(\theta^2)$, and the outer parts shrink to $0$ as "
                r"$\theta \to \pi$"
            ),
        ),
        rests_on=("3.4.trisection-vectors",),
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
    ),
    Claim(
        id="3.4.normal-along-u-axis",
        section="3.4",
        where="proof of lemma (lem:surgery), unlabelled equation, line 874",
        kind="equation",
        statement=r"$N_1(u,0) = N_0(\chi_1(u,0))$ for $u \in [0, u_{\max}-u^*]$.",
        hypotheses=(r"$\chi_1$ is that of (eq:attaching)",),
        rests_on=("eq:attaching",),
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
            r"(used, not stated) the data have unit speed on $S^2$, so that $N_u, N_v \neq 0$",
        ),
        rests_on=(
            "3.4.data-on-two-axes-suffice",
            "3.4.normal-along-u-axis",
            "3.4.normal-along-v-axis",
            "3.4.normal-along-v-axis-value",
            "eq:moutard",
            "eq:lelieuvre",
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
    ),
)
