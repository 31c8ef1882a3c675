"""The claims of the paper, how each one is checked, what came out, and the command line."""
