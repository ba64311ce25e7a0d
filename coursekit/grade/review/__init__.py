"""Marking by hand in the browser: the class's pages with fields for points and comments."""
