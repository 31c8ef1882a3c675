"""Checkers of stored certificates: they import neither theory nor discrete."""
