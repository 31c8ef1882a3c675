"""The solution of PIII by mpmath.odefun, started by its series at z = 1: a route for comparison."""

from mpmath import mp


def state_at_one(phi0):
    """Angle and slope at z = 1 (x = 1/4), from (k + 1)^2 f_{k+1} = [x^k] sin F, to mp.prec."""
    f, sine, cosine = [phi0], [mp.sin(phi0)], [mp.cos(phi0)]
    x = mp.mpf(1) / 4
    for k in range(1, mp.prec):
        f.append(sine[k - 1] / k**2)
        sine.append(mp.fsum(j * f[j] * cosine[k - j] for j in range(1, k + 1)) / k)
        cosine.append(-mp.fsum(j * f[j] * sine[k - j] for j in range(1, k + 1)) / k)
        if k > 4 and abs(f[k] * x**k) + abs(f[k - 1] * x ** (k - 1)) < mp.eps * phi0 / 16:
            break
    angle = mp.polyval(f[::-1], x)
    slope = mp.polyval([k * c for k, c in enumerate(f)][:0:-1], x) / 2
    return angle, slope


def fresh_odefun(phi0):
    """Return z -> [phi(z), phi'(z)] for z >= 1, to mp.prec; it remembers what it computed."""
    return mp.odefun(lambda z, y: [y[1], mp.sin(y[0]) - y[1] / z], mp.one, list(state_at_one(phi0)))
