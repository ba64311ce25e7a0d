"""Settings of all tests: property tests have no time limit of their own, a busy computer is no failure."""

from hypothesis import settings

settings.register_profile("coursekit", deadline=None)
settings.load_profile("coursekit")
