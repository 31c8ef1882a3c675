"""The continuum: derivations (sympy), reference values (mpmath), enclosures (ball arithmetic)."""
