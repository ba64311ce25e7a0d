"""Interfaces: maps, paths, odometry."""
