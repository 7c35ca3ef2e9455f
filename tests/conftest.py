"""Settings that every test shares."""

import os

from hypothesis import settings

# No wall clock in a test; in CI the same examples every time, at a desk new ones.
settings.register_profile("wraparc", deadline=None, derandomize="CI" in os.environ)
settings.load_profile("wraparc")
