"""Claims of section 4.1, the greedy algorithm: its cuts, steps 11 to 25."""

from checks.claim import Claim

_SIGN = (
    r"(used, not stated) $\varphi$ is measured without sign: (eq:angle) as printed is negative "
    r"in the sectors $\Omega_{M+2}$, whose $v$-axis lies clockwise of the $u$-axis"
)

CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="4.1.algorithm-11-choose",
        section="4.1",
        where="algorithm (alg:greedy-cuts), step 11, line 1314",
        kind="algorithm",
        statement=(
            r"A sector $\Omega_n$ with some $\varphi^n_{j,k} > \phi^*$ is chosen; which one does "
            "not matter for the result."
        ),
        hypotheses=("(used, not stated) sectors of one parent do not influence each other", _SIGN),
        rests_on=("4.1.algorithm-08-angles",),
    ),
    Claim(
        id="4.1.algorithm-12-cut-column",
        section="4.1",
        where="algorithm (alg:greedy-cuts), step 12, line 1315",
        kind="algorithm",
        statement=(
            r"$j^* = \max\{j : \varphi_{\ell,k} \leq \phi^* \text{ for all } \zeta_{\ell,k} \in "
            r"\Omega_n \text{ with } \ell \leq j\}$."
        ),
        hypotheses=(
            r"(used, not stated) the set is not empty: $\varphi \leq \phi^*$ on the $v$-axis",
            _SIGN,
        ),
        rests_on=("4.1.algorithm-11-choose",),
    ),
    Claim(
        id="4.1.algorithm-13-cut-row",
        section="4.1",
        where="algorithm (alg:greedy-cuts), step 13, line 1316",
        kind="algorithm",
        statement=(
            r"$k^* = \max\{k : \varphi_{j,\ell} \leq \phi^* \text{ for all } \zeta_{j,\ell} \in "
            r"\Omega_n \text{ with } \ell \leq k\}$."
        ),
        hypotheses=(
            r"(used, not stated) the set is not empty: $\varphi \leq \phi^*$ on the $u$-axis",
            _SIGN,
        ),
        rests_on=("4.1.algorithm-11-choose",),
    ),
    Claim(
        id="4.1.algorithm-14-excise",
        section="4.1",
        where="algorithm (alg:greedy-cuts), step 14, line 1317",
        kind="algorithm",
        statement=(
            r"The nodes with $j > j^*$ and $k > k^*$ are taken out of $\Omega_n$; on what is "
            r"left $\varphi \leq \phi^*$."
        ),
        rests_on=("4.1.algorithm-12-cut-column", "4.1.algorithm-13-cut-row"),
    ),
    Claim(
        id="4.1.algorithm-15-add-sectors",
        section="4.1",
        where="algorithm (alg:greedy-cuts), step 15, line 1318",
        kind="algorithm",
        statement=(
            r"Three sectors $\Omega_{M+1}, \Omega_{M+2}, \Omega_{M+3}$ are added to the list."
        ),
        hypotheses=("$M$ is the number of sectors so far",),
        rests_on=("4.1.algorithm-14-excise",),
    ),
    Claim(
        id="4.1.algorithm-16-middle-axes",
        section="4.1",
        where="algorithm (alg:greedy-cuts), step 16, line 1319",
        kind="algorithm",
        statement=(
            r"Both axes of $\Omega_{M+2}$, $0 \leq j, k \leq N$, are given by (eq:trisect) and "
            r"(eq:poincare-surgery) at $\zeta_0 = \zeta^n_{j^*,k^*}$."
        ),
        hypotheses=(
            (
                r"(used, not stated) $w_1, w_2$ are the images of $\zeta^n_{j^*+1,k^*}$ and "
                r"$\zeta^n_{j^*,k^*+1}$, which are in $\Omega_n$"
            ),
        ),
        rests_on=("4.1.algorithm-15-add-sectors", "eq:trisect", "eq:poincare-surgery"),
    ),
    Claim(
        id="4.1.algorithm-17-side-axes",
        section="4.1",
        where="algorithm (alg:greedy-cuts), step 17, line 1320",
        kind="algorithm",
        statement=(
            r"The side sectors take one axis from the parent, $\zeta^{M+1}_{j,0} = "
            r"\zeta^n_{j+j^*,k^*}$ and $\zeta^{M+3}_{0,k} = \zeta^n_{j^*,k+k^*}$, and one from "
            r"the middle sector, $\zeta^{M+1}_{0,k} = \zeta^{M+2}_{0,k}$ and $\zeta^{M+3}_{j,0} "
            r"= \zeta^{M+2}_{j,0}$."
        ),
        hypotheses=(
            (
                "(used, not stated) as far as the parent reaches: its line ends at $N - j^*$, or "
                "earlier where nodes were discarded"
            ),
        ),
        rests_on=("4.1.algorithm-16-middle-axes",),
    ),
    Claim(
        id="4.1.algorithm-18-each-daughter",
        section="4.1",
        where="algorithm (alg:greedy-cuts), step 18, line 1321",
        kind="algorithm",
        statement="Steps 19 to 22 are done for the three new sectors, $p = 1, 2, 3$.",
        rests_on=("4.1.algorithm-17-side-axes",),
    ),
    Claim(
        id="4.1.algorithm-19-fill-daughter",
        section="4.1",
        where="algorithm (alg:greedy-cuts), step 19, line 1322",
        kind="algorithm",
        statement=r"The nodes $\zeta^{M+p}_{j,k}$ follow from (poincare-ddg) one by one.",
        hypotheses=("(used, not stated) for $j, k$ up to the ends of the two axes",),
        rests_on=("poincare-ddg", "4.1.algorithm-18-each-daughter"),
    ),
    Claim(
        id="4.1.algorithm-20-discard-daughter",
        section="4.1",
        where="algorithm (alg:greedy-cuts), step 20, line 1323",
        kind="algorithm",
        statement=(
            r"A node $\zeta^{M+p}_{j,k}$ is discarded when $\zeta^{M+p}_{j-1,k}$ and "
            r"$\zeta^{M+p}_{j,k-1}$ are both outside the disk of radius $R$; no node inside the "
            "disk is lost."
        ),
        hypotheses=("(used, not stated) as in step 6",),
        rests_on=("4.1.algorithm-19-fill-daughter", "eq:hyp_radius"),
    ),
    Claim(
        id="4.1.algorithm-21-daughter",
        section="4.1",
        where="algorithm (alg:greedy-cuts), step 21, line 1324",
        kind="algorithm",
        statement=(
            r"$\Omega_{M+p}$ is the set of all $\zeta^{M+p}_{j,k}$, $j, k \leq N$, that were not "
            "discarded."
        ),
        rests_on=("4.1.algorithm-20-discard-daughter",),
    ),
    Claim(
        id="4.1.algorithm-22-daughter-angles",
        section="4.1",
        where="algorithm (alg:greedy-cuts), step 22, line 1325",
        kind="algorithm",
        statement=(
            r"$\varphi^{M+p}_{j,k}$ is computed by (eq:angle) at the nodes of which "
            r"$\zeta^{M+p}_{j+1,k}$ and $\zeta^{M+p}_{j,k+1}$ are in $\Omega_{M+p}$; it is the "
            r"angle of the daughter sector, between $0$ and $\pi$."
        ),
        hypotheses=(
            (
                "(used, not stated) $p = 1, 3$, or a sign is added: for $p = 2$ the value of "
                "(eq:angle) is negative"
            ),
        ),
        rests_on=("4.1.algorithm-21-daughter", "eq:angle"),
    ),
    Claim(
        id="4.1.algorithm-24-count",
        section="4.1",
        where="algorithm (alg:greedy-cuts), step 24, line 1327",
        kind="algorithm",
        statement="$M$ grows by $3$, and is the number of sectors in the list.",
        rests_on=("4.1.algorithm-15-add-sectors",),
    ),
    Claim(
        id="4.1.algorithm-25-stop",
        section="4.1",
        where="algorithm (alg:greedy-cuts), step 25, line 1328",
        kind="algorithm",
        statement=(
            r"Steps 11 to 24 are repeated until no sector contains a node with $\varphi_{j,k} > "
            r"\phi^*$; then $\varphi \leq \phi^*$ at all nodes of the net."
        ),
        hypotheses=(_SIGN,),
        rests_on=("4.1.algorithm-14-excise", "4.1.algorithm-22-daughter-angles"),
    ),
    Claim(
        id="4.1.greedy-is-local",
        section="4.1",
        where="section 4.1, line 1299",
        kind="sentence",
        statement=(
            "The cut of a sector depends on that sector alone: $j^*$ and $k^*$ are the largest "
            "that its own angles allow."
        ),
        rests_on=("4.1.algorithm-12-cut-column", "4.1.algorithm-13-cut-row"),
    ),
)
