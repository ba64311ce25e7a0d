"""Interfaces: the simulated clock."""
