"""Turtles and their frames, under the names of turtle_tf2_py."""
