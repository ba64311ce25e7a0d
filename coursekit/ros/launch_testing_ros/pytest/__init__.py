"""Launch tests of nodes in pytest."""
