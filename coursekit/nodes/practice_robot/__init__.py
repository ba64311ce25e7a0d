"""A robot to practise with, on the wall clock like a real one: what its computer runs."""
