"""Interfaces: sensors, sound and tasks of the TurtleBot3."""
