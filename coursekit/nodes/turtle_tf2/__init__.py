"""turtle_tf2_py: turtles that tell where they are, and one that follows another."""
