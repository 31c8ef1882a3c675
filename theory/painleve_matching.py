"""Solution of PIII for small phi0 near its first crossing of pi, by matched expansions.

With t = z - z*, x = e^t: phi = Phi(t) + phi_1(t)/z* + O(1/z*^2), Phi the separatrix of the pendulum
phi'' = sin phi through pi at t = 0, and phi_1'' - cos(Phi) phi_1 = -Phi', phi_1(0) = 0, without a
part that grows as t -> -infinity. There it meets phi0 I_0(z) (appendix A). Expressions are in x
and t, taken as independent: d/dt = x d/dx + d/dt.
"""

import sympy as sp

from theory.bessel_expansions import watson_coefficients

X = sp.Symbol("x", positive=True)
T = sp.Symbol("t", real=True)
#: 1/z*
EPSILON = sp.Symbol("epsilon", positive=True)


def rate(expr: sp.Expr) -> sp.Expr:
    """Differentiate by t an expression in x = e^t and t."""
    return X * sp.diff(expr, X) + sp.diff(expr, T)


def separatrix() -> sp.Expr:
    """Angle Phi = 4 arctan x of the separatrix, from 0 to 2 pi."""
    return 4 * sp.atan(X)


def separatrix_functions() -> tuple[sp.Expr, sp.Expr]:
    """Rational functions sin Phi and cos Phi of x = tan(Phi/4)."""
    sine, cosine = 2 * X / (1 + X**2), (1 - X**2) / (1 + X**2)
    double = (2 * sine * cosine, cosine**2 - sine**2)
    return sp.factor(double[0]), sp.factor(double[1])


def energy_lost() -> sp.Expr:
    """Integral of Phi'^2 up to t: the energy lost to friction by then, times z*."""
    s = sp.Symbol("s", positive=True)
    return sp.integrate(sp.cancel(rate(separatrix()) ** 2 / X).subs(X, s), (s, 0, X))


def damped_correction() -> sp.Expr:
    """First correction phi_1 = Phi' w, with (Phi'^2 w')' = -Phi'^2 and w(0) = 0."""
    s = sp.Symbol("s", positive=True)
    slope = rate(separatrix())
    per_x = sp.expand(sp.cancel(-energy_lost() / slope**2 / X))
    w = sp.integrate(per_x.subs(X, s), (s, 1, X)).subs(sp.log(X), T)
    return sp.factor(slope) * sp.expand(w)


def crossing_slope() -> sp.Expr:
    """Slope phi'(z*) = 2 - 2 epsilon + O(epsilon^2)."""
    slope = rate(separatrix()) + EPSILON * rate(damped_correction())
    return sp.expand(sp.simplify(slope.subs({X: 1, T: 0})))


def tail() -> sp.Expr:
    """Factor of e^t in the pendulum's solution as t -> -infinity, to first order in epsilon."""
    leading = sp.limit(separatrix() / X, X, 0)
    first = sp.cancel(damped_correction() / X).subs(X, 0)
    return sp.expand(leading + EPSILON * first)


def bessel_tail() -> sp.Expr:
    """Factor of phi0 e^(z* + t)/sqrt(2 pi z*) in phi0 I_0(z* + t), to first order in epsilon."""
    b = watson_coefficients(2)
    exact = (1 + EPSILON * T) ** sp.Rational(-1, 2) * (1 + b[1] / b[0] * EPSILON)
    return sp.expand(sp.series(exact, EPSILON, 0, 2).removeO())


def scale_at_crossing() -> sp.Expr:
    """Scale phi0 e^z*/sqrt(2 pi z*) = 4 + epsilon/2 + O(epsilon^2), by matching the two tails."""
    ratio = sp.series(tail() / bessel_tail(), EPSILON, 0, 2).removeO()
    return sp.expand(sp.simplify(ratio))


def crossing_terms() -> tuple[sp.Expr, sp.Expr]:
    """Terms of z* + log phi0 - log(2 pi z*)/2: log 4, and the coefficient 1/8 of 1/z*."""
    expansion = sp.series(sp.log(scale_at_crossing()), EPSILON, 0, 2).removeO()
    return expansion.coeff(EPSILON, 0), sp.simplify(expansion.coeff(EPSILON, 1))
