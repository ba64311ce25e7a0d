"""The nodes of a practice robot, which run on the wall clock as on a real robot."""
