"""turtle_tf2_py: turtles that publish their poses, and one that follows another."""
