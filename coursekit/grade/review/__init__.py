"""Marking by hand in the browser: the pages of the class with fields for points and comments."""
