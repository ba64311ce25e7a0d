"""explore_lite: a robot goes where nobody has looked yet, until all is seen."""
