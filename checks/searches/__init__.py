"""Searches for counterexamples: each file finds the worst admissible datum it can.

A search is a module with `SOURCES`, the paths whose change makes its result stale, and a function
`search(*, seed, progress)` that returns a dictionary with the keys `evaluations`, `margin` and what
a re-analysis needs.
"""
