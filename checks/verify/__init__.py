"""The checks: printed formulas against derived ones."""
