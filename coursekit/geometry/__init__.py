"""Positions and rotations: in the plane (`plane`), in space (`pose`), and angles of quaternions (`rotation`)."""
