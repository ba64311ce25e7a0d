"""Interfaces: points, poses, velocities, forces."""
