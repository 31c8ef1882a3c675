"""What the command line says of input that it refuses."""


class BadInput(ValueError):
    """Input that cannot be used; its text is one line: what was expected, and what to do."""


class Interrupted(Exception):
    """The run was stopped from outside; its text says how far it came and what was kept."""
