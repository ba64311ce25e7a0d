"""Interfaces: poses and velocities in the plane."""
