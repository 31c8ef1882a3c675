"""The numbers in the witnesses of sections 3.3 to 3.5, computed anew from first principles."""

from fractions import Fraction
from math import atan, exp, sin

from checks.registry import registry

ERRATA = {claim.id: claim.erratum for claim in registry().claims if claim.erratum}


def test_the_difference_on_the_pseudosphere():
    def phi(u: float, v: float) -> float:
        return 4 * atan(exp(u + v))

    left = phi(-2, -1) - phi(-2, 0) + phi(-1, 0) - phi(-1, -1)
    n = 200
    at = [(k + 0.5) / n for k in range(n)]
    area = sum(sin(phi(-2 + s, -1 + t)) for s in at for t in at) / n**2
    assert abs(left - area) < 1e-5
    assert f"{left:.6f}"[:7] == "0.53289"
    witness = ERRATA["eq:hazzidakis"].witness
    assert "0.53289" in witness
    assert "-0.53289" in witness


def test_four_of_six_equal_sectors():
    # Units of pi. Even sectors have phi = alpha, odd ones pi - alpha; the polygon starts at the end
    # of ray 0, where a u-arc ends, and passes the far corners of the sectors to the end of ray 4.
    sectors = [Fraction(1, 3) if j % 2 == 0 else Fraction(2, 3) for j in range(4)]
    corners = [sectors[0], *sectors, sectors[3]]
    terms = [phi if n % 2 else -phi for n, phi in enumerate(corners)]
    assert sum(terms) == -Fraction(1, 3)
    assert [str(abs(term)) for term in terms] == ["1/3", "1/3", "2/3", "1/3", "2/3", "2/3"]
    assert r"-\frac\pi3 + \frac\pi3 - \frac{2\pi}3 + \frac\pi3 - \frac{2\pi}3 + \frac{2\pi}3" in (
        ERRATA["thm:sg-branched"].witness
    )


def test_six_equal_sectors():
    sectors = [Fraction(1, 3) if j % 2 == 0 else Fraction(2, 3) for j in range(6)]
    assert sum(sectors) == 3
    assert sum((-1) ** j * phi for j, phi in enumerate(sectors)) == -1
    assert r"\pm3\pi" in ERRATA["3.5.star-sum"].witness


def test_rays_without_a_jump_after_surgery():
    angles = [Fraction(1, 6)] * 3 + [Fraction(1, 2)] * 3
    assert sum(angles) == 2
    smooth = [j for j in range(6) if angles[j] + angles[j - 1] == 1]
    assert smooth == [4, 5]
    for j in smooth:
        before, after = (angles[k] if k % 2 == 0 else 1 - angles[k] for k in (j - 1, j))
        assert before == after == Fraction(1, 2)
    assert r"\frac\pi6, \frac\pi6, \frac\pi6" in ERRATA["3.5.angle-jumps"].witness


def test_the_ring_of_six_faces():
    ring = [(0, 0), (1, 0), (2, 0), (2, 1), (1, 1), (0, 1)]
    steps = list(zip(ring, ring[1:] + ring[:1], strict=True))
    assert sum(a[0] != b[0] for a, b in steps) == 4
    assert sum(a[1] != b[1] for a, b in steps) == 2
    assert "four" in ERRATA["3.3.dual-cycles-equal"].witness


def test_the_upward_normal_is_opposite_to_the_gradient():
    # w = (x^2 - y^2)/2 at (1, 0): tangent vectors (1, 0, 1) and (0, 1, 0).
    (a, b, c), (d, e, f) = (1, 0, 1), (0, 1, 0)
    assert (b * f - c * e, c * d - a * f, a * e - b * d) == (-1, 0, 1)
    assert "(-1, 0, 1)" in ERRATA["3.3.graph-normal"].witness


def test_the_witnesses_of_surgery():
    u, v, u_max, height, v_room, v_new = 2, 2, 3, 1, 1, 2
    assert not any(0 <= u + s <= u_max - u and 0 <= v <= height for s in (0, 0.5, 1))
    assert v_new > v_room  # chi_4 leaves Omega_3 = [0, u~] x [0, v_max - v*]
    assert "2+u, 2" in ERRATA["3.4.fronts-agree-along-u-edge"].witness
    assert r"v_{\max} - v^* = 1$, $\tilde v = 2$" in ERRATA["eq:attaching"].witness


def test_withdrawn_errata_stay_withdrawn():
    assert "3.3.index-well-defined" not in ERRATA
    assert "3.5.hamburger-agrees-with-hazzidakis" not in ERRATA
