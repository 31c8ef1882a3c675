"""The catalogue: what the paper states, a file for each section or part of one."""
