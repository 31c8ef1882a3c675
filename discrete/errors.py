"""Errors of the nets: each says which vertex, edge or face is at fault, and what to do."""


class DiscreteError(ValueError):
    """What was given is no net, or not one of the kind that is asked for."""
