"""One Hypothesis profile for every test: fixed seeds, no deadline on a shared machine."""

from hypothesis import settings

settings.register_profile("fixed", derandomize=True, deadline=None, max_examples=60)
settings.load_profile("fixed")
