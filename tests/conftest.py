"""One Hypothesis profile for every test: fixed seeds, no deadline on a shared machine."""

import signal

from hypothesis import settings

settings.register_profile("fixed", derandomize=True, deadline=None, max_examples=60)
settings.load_profile("fixed")

# A shell that runs the tests in the background has them ignore SIGINT, and the processes that they
# start and interrupt would inherit that.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)
