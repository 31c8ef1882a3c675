"""Runs of the greedy algorithm for a user: parameters from words, results as tables and JSON."""
